// SPDX-License-Identifier: MIT
// The library under stress.

#include "scorecard.hpp"

#include <lantern/any_of.hpp>
#include <lantern/basis.hpp>
#include <lantern/bounding_sphere.hpp>
#include <lantern/box.hpp>
#include <lantern/bvh.hpp>
#include <lantern/camera.hpp>
#include <lantern/closest.hpp>
#include <lantern/cylinder.hpp>
#include <lantern/diffuse.hpp>
#include <lantern/disk.hpp>
#include <lantern/glass.hpp>
#include <lantern/glossy.hpp>
#include <lantern/grid.hpp>
#include <lantern/hash.hpp>
#include <lantern/image.hpp>
#include <lantern/instance.hpp>
#include <lantern/kd_tree.hpp>
#include <lantern/light.hpp>
#include <lantern/mirror.hpp>
#include <lantern/moving.hpp>
#include <lantern/obb.hpp>
#include <lantern/object.hpp>
#include <lantern/octree.hpp>
#include <lantern/path.hpp>
#include <lantern/plane.hpp>
#include <lantern/rectangle.hpp>
#include <lantern/rotating.hpp>
#include <lantern/samples.hpp>
#include <lantern/solid_angle.hpp>
#include <lantern/sphere.hpp>
#include <lantern/sphere_light.hpp>
#include <lantern/srgb.hpp>
#include <lantern/triangle.hpp>
#include <lantern/warp.hpp>
#include <lantern/wide_bvh.hpp>

#include <glm/mat4x4.hpp>

#include <stdexcept>
#include <type_traits>

namespace stress {

namespace {

surface_answer answer(const auto& surface, const ray& r) {
    const auto h = intersect(surface, lantern::ray{r.origin, r.direction}, lantern::interval{});
    if (!h) return std::nullopt;
    return hit{h->t, h->point, h->normal, h->error};
}

box plain(const lantern::aabb& b) { return {b.min, b.max}; }

using shape = lantern::any_of<lantern::sphere, lantern::triangle>;

/// Chosen numbers for the lens.
struct given {
    glm::vec2 lens;
    float time = 0;
    [[nodiscard]] float draw1(lantern::purpose, std::uint32_t = 0) const { return time; }
    [[nodiscard]] glm::vec2 draw2(lantern::purpose, std::uint32_t = 0) const { return lens; }
    [[nodiscard]] given branch(std::uint32_t) const { return *this; }
};

ray shot(const view& v, glm::vec2 film, glm::vec2 lens) {
    const lantern::camera c(lantern::view{v.eye, v.target, v.up, v.vertical_fov, v.aspect},
                            lantern::thin_lens{v.lens_radius, v.focus_distance});
    const lantern::ray r = shoot(c, film, given{lens});
    return {r.origin, r.direction};
}

traced trace_with(const auto& structure, const auto& surfaces, const std::vector<ray>& rays) {
    traced all;
    all.left_out = structure.left_out();
    for (const ray& r : rays) {
        const lantern::ray line{r.origin, r.direction};
        const auto h = [&] {
            if constexpr (std::same_as<std::remove_cvref_t<decltype(structure)>, lantern::wide_bvh>) return closest(structure, line);
            else return closest(structure, surfaces, line);
        }();
        if (h.has_value() != occluded(structure, surfaces, line, {})) throw std::logic_error("closest and occluded differ");
        all.hits.push_back(h ? std::optional(found{h->index, h->t}) : std::nullopt);
    }
    return all;
}

/// A matt wall that shines by itself.
struct oven {
    float albedo = 0;
};
glm::vec3 evaluate(const oven& m, glm::vec3 in, const lantern::hit& h, glm::vec3 out) {
    return evaluate(lantern::diffuse{glm::vec3(m.albedo)}, in, h, out);
}
glm::vec3 emitted(const oven&, glm::vec3, const lantern::hit&) { return glm::vec3(1); }

struct lantern_adapter {
    static surface_answer sphere(glm::vec3 center, float radius, ray r) { return answer(lantern::sphere{center, radius}, r); }
    static surface_answer plane(glm::vec3 point, glm::vec3 normal, ray r) { return answer(lantern::plane{point, normal}, r); }
    static surface_answer triangle(glm::vec3 a, glm::vec3 b, glm::vec3 c, ray r) { return answer(lantern::triangle{a, b, c}, r); }
    static surface_answer rectangle(glm::vec3 corner, glm::vec3 u, glm::vec3 v, ray r) {
        return answer(lantern::rectangle{corner, u, v}, r);
    }
    static surface_answer disk(glm::vec3 center, glm::vec3 normal, float radius, ray r) {
        return answer(lantern::disk{center, normal, radius}, r);
    }
    static surface_answer box_surface(box b, ray r) { return answer(lantern::box{b.min, b.max}, r); }
    static surface_answer cylinder(glm::vec3 from, glm::vec3 to, float radius, ray r) {
        return answer(lantern::cylinder{from, to, radius}, r);
    }
    static surface_answer placed_sphere(affine m, glm::vec3 center, float radius, ray r) {
        const glm::mat4 to_world(glm::vec4(m.columns[0], 0), glm::vec4(m.columns[1], 0), glm::vec4(m.columns[2], 0),
                                 glm::vec4(m.translation, 1));
        return answer(lantern::instance(lantern::sphere{center, radius}, to_world), r);
    }

    static bool meets_box(box b, ray r) {
        return overlaps(lantern::aabb{b.min, b.max}, lantern::ray{r.origin, r.direction}, lantern::interval{});
    }
    static bool meets_oriented_box(oriented_box b, ray r) {
        return overlaps(lantern::obb{b.center, b.axes, b.half}, lantern::ray{r.origin, r.direction}, lantern::interval{});
    }
    static bool meets_ball(ball b, ray r) {
        return overlaps(lantern::bounding_sphere{b.center, b.radius}, lantern::ray{r.origin, r.direction}, lantern::interval{});
    }
    static box box_around_sphere(ball b) { return plain(bounds(lantern::sphere{b.center, b.radius})); }
    static ball ball_around(const std::vector<glm::vec3>& points) {
        const auto s = lantern::smallest_sphere(lantern::hull_of(points));
        return {s.center, s.radius};
    }
    static oriented_box oriented_box_around(const std::vector<glm::vec3>& points) {
        const auto b = lantern::tight_box(lantern::hull_of(points));
        return {b.center, b.axes, b.half};
    }

    static frame basis(glm::vec3 w) {
        const auto b = lantern::basis_from(w);
        return {b.u, b.v, b.w};
    }
    static glm::vec3 leave(hit h, glm::vec3 direction) { return lantern::leave({h.t, h.point, h.normal, h.error}, direction); }
    static glm::vec3 mirrored(glm::vec3 in, glm::vec3 normal) { return lantern::mirrored(in, normal); }
    static std::optional<bent> refracted(glm::vec3 in, glm::vec3 normal, float ratio) {
        const auto r = lantern::refracted(in, normal, ratio);
        return r ? std::optional(bent{r->direction, r->reflectance}) : std::nullopt;
    }

    static std::vector<std::string> structures() {
        return {"bvh, middle", "bvh, median", "bvh, surface area", "bvh, bottom-up", "bvh of oriented boxes", "bvh of spheres",
                "grid", "octree", "kd-tree", "wide bvh"};
    }
    static traced trace(const std::string& structure, const scene& s, const std::vector<ray>& rays) {
        if (structure == "wide bvh") {  // of triangles alone
            std::vector<lantern::triangle> triangles;
            for (const auto& t : s.triangles) triangles.push_back({t[0], t[1], t[2]});
            traced all = trace_with(lantern::wide_bvh(triangles), triangles, rays);
            for (auto& h : all.hits)
                if (h) h->index += static_cast<std::uint32_t>(s.spheres.size());
            return all;
        }
        std::vector<shape> shapes;
        for (const ball& b : s.spheres) shapes.emplace_back(lantern::sphere{b.center, b.radius});
        for (const auto& t : s.triangles) shapes.emplace_back(lantern::triangle{t[0], t[1], t[2]});
        using lantern::split;
        if (structure == "bvh, middle") return trace_with(lantern::bvh<>(shapes, {.rule = split::middle}), shapes, rays);
        if (structure == "bvh, median") return trace_with(lantern::bvh<>(shapes, {.rule = split::median}), shapes, rays);
        if (structure == "bvh, surface area") return trace_with(lantern::bvh<>(shapes, {.rule = split::surface_area}), shapes, rays);
        if (structure == "bvh, bottom-up") return trace_with(lantern::bvh<>(shapes, {.rule = split::bottom_up}), shapes, rays);
        if (structure == "bvh of oriented boxes") return trace_with(lantern::bvh<lantern::obb>(shapes), shapes, rays);
        if (structure == "bvh of spheres") return trace_with(lantern::bvh<lantern::bounding_sphere>(shapes), shapes, rays);
        if (structure == "grid") return trace_with(lantern::grid(shapes), shapes, rays);
        if (structure == "octree") return trace_with(lantern::octree(shapes), shapes, rays);
        if (structure == "kd-tree") return trace_with(lantern::kd_tree(shapes), shapes, rays);
        throw std::invalid_argument("no structure is called " + structure);
    }

    static float unit_number(std::uint32_t bits) { return lantern::to_unit(bits); }
    static glm::vec2 to_disk(glm::vec2 xi) { return lantern::to_disk(xi); }
    static glm::vec3 to_sphere(glm::vec2 xi) { return lantern::to_sphere(xi); }
    static glm::vec3 to_cosine_hemisphere(glm::vec2 xi) { return lantern::to_cosine_hemisphere(xi); }
    static glm::vec3 to_triangle(glm::vec2 xi) { return lantern::to_triangle(xi); }
    static double cone_solid_angle(double half_angle) { return solid_angle(lantern::cone_of(half_angle)); }
    static glm::vec3 to_cone(double half_angle, glm::vec2 xi) { return glm::vec3(lantern::to_cone(lantern::cone_of(half_angle), xi)); }

    static ray shoot(view v, glm::vec2 film, glm::vec2 lens) { return shot(v, film, lens); }
    static float moment(float opens, float closes, float xi) { return lantern::moment(lantern::shutter{opens, closes}, given{{}, xi}); }
    static box box_around_moving(ball b, glm::vec3 displacement) {
        return plain(bounds(lantern::moving{lantern::sphere{b.center, b.radius}, displacement}));
    }
    static box box_around_turning(ball b, glm::vec3 axis, float angle) {
        return plain(bounds(lantern::rotating{lantern::sphere{b.center, b.radius}, glm::vec3(0), axis, angle}));
    }

    static total mean(const std::vector<glm::vec3>& samples, std::uint64_t times) {
        lantern::accumulator sum;
        for (std::uint64_t i = 0; i < times; ++i)
            for (const glm::vec3& s : samples) sum.add(s);
        return {sum.mean(), sum.rejected()};
    }
    static float to_srgb(float linear) { return lantern::to_srgb(linear); }
    static int to_byte(float linear) { return lantern::to_byte(linear); }
    static bool image_size_refused(std::uint32_t width, std::uint32_t height) {
        try {
            (void)lantern::image({width, height});
            return false;
        } catch (const std::invalid_argument&) {
            return true;
        }
    }

    static double sphere_solid_angle(glm::vec3 point, ball b) {
        const auto seen = lantern::sphere_seen_from(point, b.center, b.radius);
        return seen ? solid_angle(*seen) : -1;
    }
    static double rectangle_solid_angle(glm::vec3 point, glm::vec3 corner, glm::vec3 u, glm::vec3 v) {
        return solid_angle(lantern::seen_rectangle(point, corner, u, v));
    }
    static float point_irradiance(glm::vec3 position, float intensity, glm::vec3 point) {
        return illuminate(lantern::point_light{position, glm::vec3(intensity)}, point).irradiance.x;
    }
    static std::pair<glm::vec3, float> sphere_light(ball lamp, glm::vec3 point, glm::vec2 xi) {
        const auto light = illuminate(lantern::sphere_light{lamp.center, lamp.radius, glm::vec3(1)}, point, xi);
        return {light.position, light.irradiance.x};
    }
    static double furnace(float albedo, std::uint32_t paths, std::uint64_t seed) {
        const std::vector things{lantern::object{lantern::sphere{}, oven{albedo}}};
        const std::vector<lantern::point_light> none;
        const lantern::every all{1};
        const lantern::path radiance{all, things, none};
        const lantern::independent numbers{.samples = paths, .seed = seed};
        double sum = 0;
        for (std::uint32_t i = 0; i < paths; ++i) sum += double(radiance(lantern::ray{{0, 0, 0}, {0, -1, 0}}, numbers.at({0, 0}, i)).x);
        return sum / paths;
    }
    static glm::vec3 perturbed(glm::vec3 reflected, float width, glm::vec2 xi) { return lantern::perturbed(reflected, width, xi); }
};

}  // namespace

answers library() { return answers_of("library", lantern_adapter{}); }

}  // namespace stress
