// SPDX-License-Identifier: MIT
// All formulas of the textbooks together, with what they need to be a ray tracer: no structure but the list.

#include "naive.hpp"
#include "scorecard.hpp"

namespace stress {

namespace {

struct textbook_adapter {
    static surface_answer sphere(glm::vec3 center, float radius, ray r) { return naive::sphere(center, radius, r); }
    static surface_answer plane(glm::vec3 point, glm::vec3 normal, ray r) { return naive::plane(point, normal, r); }
    static surface_answer triangle(glm::vec3 a, glm::vec3 b, glm::vec3 c, ray r) { return naive::triangle(a, b, c, r); }
    static surface_answer rectangle(glm::vec3 corner, glm::vec3 u, glm::vec3 v, ray r) { return naive::rectangle(corner, u, v, r); }
    static surface_answer disk(glm::vec3 c, glm::vec3 n, float radius, ray r) { return naive::disk(c, n, radius, r); }
    static surface_answer box_surface(box b, ray r) { return naive::box_surface(b, r); }
    static surface_answer cylinder(glm::vec3 from, glm::vec3 to, float radius, ray r) { return naive::cylinder(from, to, radius, r); }
    static surface_answer placed_sphere(affine m, glm::vec3 c, float radius, ray r) { return naive::placed_sphere(m, c, radius, r); }
    static bool meets_box(box b, ray r) { return naive::meets_box(b, r); }
    static box box_around_sphere(ball b) { return naive::box_around_sphere(b); }
    static ball ball_around(const std::vector<glm::vec3>& points) { return naive::ball_around(points); }
    static frame basis(glm::vec3 w) { return naive::basis(w); }
    static glm::vec3 leave(hit h, glm::vec3 direction) { return naive::leave(h, direction); }
    static glm::vec3 mirrored(glm::vec3 in, glm::vec3 normal) { return naive::mirrored(in, normal); }
    static std::optional<bent> refracted(glm::vec3 in, glm::vec3 normal, float ratio) { return naive::refracted(in, normal, ratio); }
    static float unit_number(std::uint32_t bits) { return naive::unit_number(bits); }
    static glm::vec2 to_disk(glm::vec2 xi) { return naive::to_disk(xi); }
    static glm::vec3 to_sphere(glm::vec2 xi) { return naive::to_sphere(xi); }
    static glm::vec3 to_cosine_hemisphere(glm::vec2 xi) { return naive::to_cosine_hemisphere(xi); }
    static glm::vec3 to_triangle(glm::vec2 xi) { return naive::to_triangle(xi); }
    static double cone_solid_angle(double half_angle) { return naive::cone_solid_angle(half_angle); }
    static glm::vec3 to_cone(double half_angle, glm::vec2 xi) { return naive::to_cone(half_angle, xi); }
    static ray shoot(view v, glm::vec2 film, glm::vec2 lens) { return naive::shoot(v, film, lens); }
    static float moment(float opens, float closes, float xi) { return naive::moment(opens, closes, xi); }
    static box box_around_moving(ball b, glm::vec3 displacement) { return naive::box_around_moving(b, displacement); }
    static box box_around_turning(ball b, glm::vec3 axis, float angle) { return naive::box_around_turning(b, axis, angle); }
    static total mean(const std::vector<glm::vec3>& samples, std::uint64_t times) { return naive::mean(samples, times); }
    static float to_srgb(float linear) { return naive::to_srgb(linear); }
    static int to_byte(float linear) { return naive::to_byte(linear); }
    static double sphere_solid_angle(glm::vec3 point, ball b) { return naive::sphere_solid_angle(point, b); }
    static float point_irradiance(glm::vec3 at, float intensity, glm::vec3 point) { return naive::point_irradiance(at, intensity, point); }
    static std::pair<glm::vec3, float> sphere_light(ball lamp, glm::vec3 point, glm::vec2 xi) {
        return naive::sphere_light(lamp, point, xi);
    }
    static glm::vec3 perturbed(glm::vec3 reflected, float width, glm::vec2 xi) { return naive::perturbed(reflected, width, xi); }
    static double furnace(float albedo, std::uint32_t paths, std::uint64_t seed) { return naive::furnace(albedo, paths, seed); }
};

}  // namespace

answers textbook() { return answers_of("textbook", textbook_adapter{}); }

}  // namespace stress
