// SPDX-License-Identifier: MIT
#pragma once
// What can be asked of a ray tracer under stress, as plain values: no type of the library's. See README.md beside this file.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace stress {

/// The half-line origin + t direction, t > 0; the direction has any length.
struct ray {
    glm::vec3 origin{0}, direction{0, 0, -1};
};

/// t in units of the direction; the normal has unit length and points outwards, or to where a, b, c are seen counter-clockwise.
/// `error` is for whoever bounds the error of `point` and uses it to leave the surface; others leave it 0.
struct hit {
    float t = 0;
    glm::vec3 point{0}, normal{0};
    float error = 0;
};

/// p -> (columns) p + translation.
struct affine {
    std::array<glm::vec3, 3> columns{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    glm::vec3 translation{0};
};

struct box {
    glm::vec3 min{0}, max{0};
};

struct ball {
    glm::vec3 center{0};
    float radius = 0;
};

struct oriented_box {
    glm::vec3 center{0};
    std::array<glm::vec3, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    glm::vec3 half{0};
};

/// Right-handed, unit vectors: u × v = w.
struct frame {
    glm::vec3 u{0}, v{0}, w{0};
};

struct bent {
    glm::vec3 direction{0};  ///< unit length
    float reflectance = 0;   ///< mean of both polarisations
};

struct view {
    glm::vec3 eye{0}, target{0}, up{0};
    float vertical_fov = 1, aspect = 1, lens_radius = 0, focus_distance = 1;
};

/// Spheres first, triangles after them: so they are numbered.
struct scene {
    std::vector<ball> spheres;
    std::vector<std::array<glm::vec3, 3>> triangles;
};

struct found {
    std::uint32_t index = 0;
    float t = 0;
    bool operator==(const found&) const = default;
};

struct traced {
    std::vector<std::optional<found>> hits;  ///< one for each ray; of two at the same t the smaller index
    std::uint32_t left_out = 0;              ///< surfaces that are not finite: reported, never traced
};

struct total {
    glm::vec3 mean{0};
    std::uint64_t rejected = 0;  ///< samples that were not finite
};

using surface_answer = std::optional<hit>;

/// One function for each thing that can be asked. An empty one says "not here": its cases are n/a.
struct answers {
    std::string name;

    std::function<surface_answer(glm::vec3 center, float radius, ray)> sphere;
    std::function<surface_answer(glm::vec3 point, glm::vec3 normal, ray)> plane;
    std::function<surface_answer(glm::vec3 a, glm::vec3 b, glm::vec3 c, ray)> triangle;
    std::function<surface_answer(glm::vec3 corner, glm::vec3 u, glm::vec3 v, ray)> rectangle;
    std::function<surface_answer(glm::vec3 center, glm::vec3 normal, float radius, ray)> disk;
    std::function<surface_answer(box, ray)> box_surface;
    std::function<surface_answer(glm::vec3 from, glm::vec3 to, float radius, ray)> cylinder;
    std::function<surface_answer(affine, glm::vec3 center, float radius, ray)> placed_sphere;

    /// Whether the half-line may meet what is in it. A wrong yes costs time, a wrong no costs a hit.
    std::function<bool(box, ray)> meets_box;
    std::function<bool(oriented_box, ray)> meets_oriented_box;
    std::function<bool(ball, ray)> meets_ball;
    std::function<box(ball)> box_around_sphere;
    std::function<ball(const std::vector<glm::vec3>&)> ball_around;
    std::function<oriented_box(const std::vector<glm::vec3>&)> oriented_box_around;

    std::function<frame(glm::vec3 w)> basis;
    std::function<glm::vec3(hit, glm::vec3 direction)> leave;  ///< the origin of the ray that goes on in that direction
    std::function<glm::vec3(glm::vec3 in, glm::vec3 normal)> mirrored;
    std::function<std::optional<bent>(glm::vec3 in, glm::vec3 normal, float ratio)> refracted;  ///< the normal faces `in`

    std::function<std::vector<std::string>()> structures;  ///< names for `trace`
    std::function<traced(const std::string& structure, const scene&, const std::vector<ray>&)> trace;

    std::function<float(std::uint32_t bits)> unit_number;  ///< in [0, 1)
    std::function<glm::vec2(glm::vec2 xi)> to_disk;
    std::function<glm::vec3(glm::vec2 xi)> to_sphere;
    std::function<glm::vec3(glm::vec2 xi)> to_cosine_hemisphere;
    std::function<glm::vec3(glm::vec2 xi)> to_triangle;  ///< barycentric coordinates
    std::function<double(double half_angle)> cone_solid_angle;
    std::function<glm::vec3(double half_angle, glm::vec2 xi)> to_cone;  ///< about (0, 0, 1)

    std::function<ray(view, glm::vec2 film, glm::vec2 lens)> shoot;
    std::function<float(float opens, float closes, float xi)> moment;
    std::function<box(ball, glm::vec3 displacement)> box_around_moving;
    /// A ball on its way around an axis through the origin, while the shutter is open.
    std::function<box(ball, glm::vec3 axis, float angle)> box_around_turning;

    /// The mean of all samples, gone through `times` times.
    std::function<total(const std::vector<glm::vec3>& samples, std::uint64_t times)> mean;
    std::function<float(float linear)> to_srgb;
    std::function<int(float linear)> to_byte;                                  ///< 0 to 255
    std::function<bool(std::uint32_t width, std::uint32_t height)> image_size_refused;

    std::function<double(glm::vec3 point, ball)> sphere_solid_angle;
    std::function<double(glm::vec3 point, glm::vec3 corner, glm::vec3 u, glm::vec3 v)> rectangle_solid_angle;
    std::function<float(glm::vec3 position, float intensity, glm::vec3 point)> point_irradiance;
    /// From a lamp of radiance 1 at a point: one sample of where light comes from, and of the irradiance that it brings.
    std::function<std::pair<glm::vec3, float>(ball lamp, glm::vec3 point, glm::vec2 xi)> sphere_light;
    /// A reflected direction perturbed within a square of side `width` (Cook 1984).
    std::function<glm::vec3(glm::vec3 reflected, float width, glm::vec2 xi)> perturbed;
    /// The mean radiance, over many paths, within a closed sphere of that albedo whose wall emits 1: 1 / (1 - albedo).
    std::function<double(float albedo, std::uint32_t paths, std::uint64_t seed)> furnace;
};

/// The table of a type whose member functions have these names; what it lacks stays empty. The type is copied.
template <class Adapter>
[[nodiscard]] answers answers_of(std::string name, const Adapter& a) {
    answers all;
    all.name = std::move(name);
    const std::vector<glm::vec3> points;
    const std::vector<ray> rays;
    if constexpr (requires { a.sphere(glm::vec3(), 0.0f, ray()); }) all.sphere = [a](auto&&... x) { return a.sphere(x...); };
    if constexpr (requires { a.plane(glm::vec3(), glm::vec3(), ray()); }) all.plane = [a](auto&&... x) { return a.plane(x...); };
    if constexpr (requires { a.triangle(glm::vec3(), glm::vec3(), glm::vec3(), ray()); })
        all.triangle = [a](auto&&... x) { return a.triangle(x...); };
    if constexpr (requires { a.rectangle(glm::vec3(), glm::vec3(), glm::vec3(), ray()); })
        all.rectangle = [a](auto&&... x) { return a.rectangle(x...); };
    if constexpr (requires { a.disk(glm::vec3(), glm::vec3(), 0.0f, ray()); }) all.disk = [a](auto&&... x) { return a.disk(x...); };
    if constexpr (requires { a.box_surface(box(), ray()); }) all.box_surface = [a](auto&&... x) { return a.box_surface(x...); };
    if constexpr (requires { a.cylinder(glm::vec3(), glm::vec3(), 0.0f, ray()); })
        all.cylinder = [a](auto&&... x) { return a.cylinder(x...); };
    if constexpr (requires { a.placed_sphere(affine(), glm::vec3(), 0.0f, ray()); })
        all.placed_sphere = [a](auto&&... x) { return a.placed_sphere(x...); };
    if constexpr (requires { a.meets_box(box(), ray()); }) all.meets_box = [a](auto&&... x) { return a.meets_box(x...); };
    if constexpr (requires { a.meets_oriented_box(oriented_box(), ray()); })
        all.meets_oriented_box = [a](auto&&... x) { return a.meets_oriented_box(x...); };
    if constexpr (requires { a.meets_ball(ball(), ray()); }) all.meets_ball = [a](auto&&... x) { return a.meets_ball(x...); };
    if constexpr (requires { a.box_around_sphere(ball()); }) all.box_around_sphere = [a](auto&&... x) { return a.box_around_sphere(x...); };
    if constexpr (requires { a.ball_around(points); }) all.ball_around = [a](auto&&... x) { return a.ball_around(x...); };
    if constexpr (requires { a.oriented_box_around(points); })
        all.oriented_box_around = [a](auto&&... x) { return a.oriented_box_around(x...); };
    if constexpr (requires { a.basis(glm::vec3()); }) all.basis = [a](auto&&... x) { return a.basis(x...); };
    if constexpr (requires { a.leave(hit(), glm::vec3()); }) all.leave = [a](auto&&... x) { return a.leave(x...); };
    if constexpr (requires { a.mirrored(glm::vec3(), glm::vec3()); }) all.mirrored = [a](auto&&... x) { return a.mirrored(x...); };
    if constexpr (requires { a.refracted(glm::vec3(), glm::vec3(), 0.0f); }) all.refracted = [a](auto&&... x) { return a.refracted(x...); };
    if constexpr (requires { a.structures(); a.trace(std::string(), scene(), rays); }) {
        all.structures = [a] { return a.structures(); };
        all.trace = [a](auto&&... x) { return a.trace(x...); };
    }
    if constexpr (requires { a.unit_number(std::uint32_t()); }) all.unit_number = [a](auto&&... x) { return a.unit_number(x...); };
    if constexpr (requires { a.to_disk(glm::vec2()); }) all.to_disk = [a](auto&&... x) { return a.to_disk(x...); };
    if constexpr (requires { a.to_sphere(glm::vec2()); }) all.to_sphere = [a](auto&&... x) { return a.to_sphere(x...); };
    if constexpr (requires { a.to_cosine_hemisphere(glm::vec2()); })
        all.to_cosine_hemisphere = [a](auto&&... x) { return a.to_cosine_hemisphere(x...); };
    if constexpr (requires { a.to_triangle(glm::vec2()); }) all.to_triangle = [a](auto&&... x) { return a.to_triangle(x...); };
    if constexpr (requires { a.cone_solid_angle(0.0); }) all.cone_solid_angle = [a](auto&&... x) { return a.cone_solid_angle(x...); };
    if constexpr (requires { a.to_cone(0.0, glm::vec2()); }) all.to_cone = [a](auto&&... x) { return a.to_cone(x...); };
    if constexpr (requires { a.shoot(view(), glm::vec2(), glm::vec2()); }) all.shoot = [a](auto&&... x) { return a.shoot(x...); };
    if constexpr (requires { a.moment(0.0f, 0.0f, 0.0f); }) all.moment = [a](auto&&... x) { return a.moment(x...); };
    if constexpr (requires { a.box_around_moving(ball(), glm::vec3()); })
        all.box_around_moving = [a](auto&&... x) { return a.box_around_moving(x...); };
    if constexpr (requires { a.box_around_turning(ball(), glm::vec3(), 0.0f); })
        all.box_around_turning = [a](auto&&... x) { return a.box_around_turning(x...); };
    if constexpr (requires { a.mean(points, std::uint64_t()); }) all.mean = [a](auto&&... x) { return a.mean(x...); };
    if constexpr (requires { a.to_srgb(0.0f); }) all.to_srgb = [a](auto&&... x) { return a.to_srgb(x...); };
    if constexpr (requires { a.to_byte(0.0f); }) all.to_byte = [a](auto&&... x) { return a.to_byte(x...); };
    if constexpr (requires { a.image_size_refused(0u, 0u); })
        all.image_size_refused = [a](auto&&... x) { return a.image_size_refused(x...); };
    if constexpr (requires { a.sphere_solid_angle(glm::vec3(), ball()); })
        all.sphere_solid_angle = [a](auto&&... x) { return a.sphere_solid_angle(x...); };
    if constexpr (requires { a.rectangle_solid_angle(glm::vec3(), glm::vec3(), glm::vec3(), glm::vec3()); })
        all.rectangle_solid_angle = [a](auto&&... x) { return a.rectangle_solid_angle(x...); };
    if constexpr (requires { a.point_irradiance(glm::vec3(), 0.0f, glm::vec3()); })
        all.point_irradiance = [a](auto&&... x) { return a.point_irradiance(x...); };
    if constexpr (requires { a.sphere_light(ball(), glm::vec3(), glm::vec2()); })
        all.sphere_light = [a](auto&&... x) { return a.sphere_light(x...); };
    if constexpr (requires { a.perturbed(glm::vec3(), 0.0f, glm::vec2()); }) all.perturbed = [a](auto&&... x) { return a.perturbed(x...); };
    if constexpr (requires { a.furnace(0.0f, std::uint32_t(), std::uint64_t()); }) all.furnace = [a](auto&&... x) { return a.furnace(x...); };
    return all;
}

}  // namespace stress
