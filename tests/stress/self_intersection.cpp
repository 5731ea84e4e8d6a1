// SPDX-License-Identifier: MIT
// A ray that leaves a surface must not meet it again (acne), nor lose what is next to it (lost contact).

#include "laws.hpp"

#include <functional>
#include <limits>

namespace stress {

namespace {

constexpr std::string_view source_of_step = "Wächter and Binder, Ray Tracing Gems, chapter 6; pbrt 4th ed., section 6.8";

void sphere_leaves(const answers& a, score& s, std::uint32_t i, float scale, float far, std::uint64_t salt) {
    dice d = dice_of(i, salt);
    const glm::vec3 center = scale * (d.in_cube(3) + far * glm::vec3(1, 0.7f, -0.3f));
    const float radius = scale * d.between(0.1, 1);
    for (int k = 0; k < 16; ++k) {
        const glm::dvec3 from = glm::dvec3(center) + 10.0 * double(scale) * d.on_sphere();
        const glm::dvec3 at = glm::dvec3(center) + 0.95 * double(radius) * d.unit() * d.on_sphere();
        const auto h = a.sphere(center, radius, {glm::vec3(from), glm::vec3(at - from)});
        if (!h) continue;  // seen from far away it may lie between two floats
        glm::vec3 away(d.on_sphere());
        if (glm::dot(away, h->normal) < 0) away = -away;
        const std::string where = shown({center, glm::vec3(radius), h->point, away});
        s.check(!a.sphere(center, radius, {a.leave(*h, away), away}), "meets itself again: center, radius, point, direction" + where);
        // Into it, not too flat: the other wall is there.
        if (glm::dot(away, h->normal) > 0.1f)
            s.check(a.sphere(center, radius, {a.leave(*h, -away), -away}).has_value(), "loses the other wall:" + where);
    }
}

void triangle_leaves(const answers& a, score& s, std::uint32_t i, float scale, float far, std::uint64_t salt) {
    dice d = dice_of(i, salt);
    const glm::vec3 center = scale * (d.in_cube(2) + far * glm::vec3(0.6f, -1, 0.8f));
    const auto vertex = [&] { return glm::vec3(glm::dvec3(center) + double(scale) * d.on_sphere()); };
    const glm::vec3 p = vertex(), q = vertex(), r = vertex();
    for (int k = 0; k < 16; ++k) {
        const double u = 0.05 + 0.9 * d.unit(), v = d.unit() * (0.95 - u);
        const glm::dvec3 inside = glm::dvec3(p) + u * (glm::dvec3(q) - glm::dvec3(p)) + v * (glm::dvec3(r) - glm::dvec3(p));
        const glm::dvec3 from = glm::dvec3(center) + double(scale) * 5.0 * d.on_sphere();
        const auto h = a.triangle(p, q, r, {glm::vec3(from), glm::vec3(inside - glm::dvec3(glm::vec3(from)))});
        if (!h) continue;
        const glm::vec3 away(d.on_sphere());
        s.check(!a.triangle(p, q, r, {a.leave(*h, away), away}), "meets itself again:" + shown({p, q, r, h->point, away}));
    }
}

/// Two walls as near to each other as floats allow them to be told apart: what leaves one inwards reaches the other.
void gap_is_crossed(const answers& a, score& s, std::uint32_t i, float scale, std::uint64_t salt) {
    dice d = dice_of(i, salt);
    const float height = scale * d.between(-1, 1), largest = scale;
    const float step = std::nextafter(largest, std::numeric_limits<float>::infinity()) - largest;
    const float gap = step * static_cast<float>(8u << d.below(8));
    const auto wall = [&](float z, ray r) { return a.triangle({-9 * scale, -9 * scale, z}, {9 * scale, -9 * scale, z}, {0, 9 * scale, z}, r); };
    const glm::vec3 from(scale * d.in_cube() * 0.3f);
    for (int k = 0; k < 16; ++k) {
        const auto h = wall(height, {{from.x, from.y, height + 3 * scale}, glm::vec3(scale * d.between(-0.5, 0.5), 0, -3 * scale)});
        if (!h) {
            s.wrong("misses the wall before it can leave it");
            continue;
        }
        glm::vec3 up(d.on_sphere());
        up.z = std::abs(up.z) + 0.2f;
        const glm::vec3 origin = a.leave(*h, up);
        s.check(wall(height + gap, {origin, up}).has_value(), "loses the wall at a distance of" + shown({glm::vec3(gap), h->point, up}));
        s.check(!wall(height, {origin, up}), "meets its own wall again:" + shown({h->point, up}));
    }
}

void placed_leaves(const answers& a, score& s, std::uint32_t i, std::uint64_t salt) {
    dice d = dice_of(i, salt);
    const glm::dvec3 u = d.on_sphere(), v = glm::normalize(glm::cross(u, d.on_sphere())), w = glm::cross(u, v);
    const affine m{{glm::vec3(double(d.magnitude_between(-3, 3)) * u), glm::vec3(double(d.magnitude_between(-3, 3)) * v),
                    glm::vec3(double(d.magnitude_between(-3, 3)) * w)}, d.magnitude_between(-3, 3) * d.in_cube()};
    for (int k = 0; k < 16; ++k) {
        const auto world = [&](glm::dvec3 p) {
            return glm::dvec3(m.translation) + p.x * glm::dvec3(m.columns[0]) + p.y * glm::dvec3(m.columns[1]) + p.z * glm::dvec3(m.columns[2]);
        };
        const glm::vec3 from(world(5.0 * d.on_sphere()));
        const auto h = a.placed_sphere(m, {0, 0, 0}, 1, {from, glm::vec3(world(0.7 * d.on_sphere()) - glm::dvec3(from))});
        if (!h) continue;
        glm::vec3 away(d.on_sphere());
        if (glm::dot(away, h->normal) < 0) away = -away;
        s.check(!a.placed_sphere(m, {0, 0, 0}, 1, {a.leave(*h, away), away}), "meets itself again:" + shown({h->point, h->normal, away}));
    }
}

void grazes(const answers& a, score& s, std::uint32_t i, std::uint64_t salt) {
    dice d = dice_of(i, salt);
    const glm::vec3 center = d.in_cube(3);
    const float radius = d.magnitude_between(-2, 2);
    for (int k = 0; k < 16; ++k) {
        const auto h = a.sphere(center, radius, {center + 3 * radius * glm::vec3(d.on_sphere()), glm::vec3(0, 0, 0)});
        if (h) s.wrong("a ray without a direction hits");
        const glm::dvec3 from = glm::dvec3(center) + 3.0 * double(radius) * d.on_sphere();
        const auto first = a.sphere(center, radius, {glm::vec3(from), glm::vec3(glm::dvec3(center) - from)});
        if (!first) {
            s.wrong("misses a sphere aimed at its center");
            continue;
        }
        const glm::dvec3 n(first->normal), along = glm::normalize(glm::cross(n, d.on_sphere()));
        const glm::vec3 flat(along + double(d.magnitude_between(-6, -3)) * n);  // hardly leaves the tangent plane
        s.check(!a.sphere(center, radius, {a.leave(*first, flat), flat}), "meets itself again:" + shown({center, glm::vec3(radius), first->point, flat}));
    }
}

void plane_leaves(const answers& a, score& s, std::uint32_t i, std::uint64_t salt) {
    dice d = dice_of(i, salt);
    const float scale = d.magnitude_between(-4, 5);
    const glm::vec3 q = scale * d.in_cube(), n(d.on_sphere());
    for (int k = 0; k < 16; ++k) {
        const glm::vec3 from = scale * d.in_cube(3);
        const auto h = a.plane(q, n, {from, glm::vec3(d.on_sphere())});
        if (!h) continue;
        const glm::vec3 away(d.on_sphere());
        s.check(!a.plane(q, n, {a.leave(*h, away), away}), "meets itself again:" + shown({q, n, h->point, away}));
        s.check(a.plane(q, n, {a.leave(*h, away), glm::dot(away, h->normal) < 0 ? h->normal : -h->normal}).has_value(), "loses its own plane");
    }
}

}  // namespace

void add_self_intersection(std::vector<test_case>& cases) {
    const std::string source(source_of_step), margin = "none: exactly no acne and no lost contact";
    const auto with_sphere = [](const answers& a) { return a.sphere && a.leave; };
    const auto with_triangle = [](const answers& a) { return a.triangle && a.leave; };
    const std::vector<std::pair<std::string, float>> scales{{"1e-6", 1e-6f}, {"1e-3", 1e-3f}, {"1", 1.0f}, {"1e6", 1e6f}};
    std::uint64_t salt = 20;
    for (const auto& [name, scale] : scales)
        add(cases, "self-intersection/sphere-scale-" + name, "out of a sphere, and into it to its other wall", source, margin, with_sphere,
            [scale = scale, salt = salt++](const answers& a, score& s, std::uint32_t i) { sphere_leaves(a, s, i, scale, 0, salt); });
    for (const auto& [name, scale] : scales)
        add(cases, "self-intersection/triangle-scale-" + name, "off a triangle, to either side", source, margin, with_triangle,
            [scale = scale, salt = salt++](const answers& a, score& s, std::uint32_t i) { triangle_leaves(a, s, i, scale, 0, salt); });
    for (const auto& [name, scale] : scales)
        add(cases, "self-intersection/gap-scale-" + name, "from one wall to another one 8 to 1024 ulp away", source, margin, with_triangle,
            [scale = scale, salt = salt++](const answers& a, score& s, std::uint32_t i) { gap_is_crossed(a, s, i, scale, salt); });
    add(cases, "self-intersection/sphere-far-away", "off a sphere of size 1, 1e4 from the origin", source, margin, with_sphere,
        [](const answers& a, score& s, std::uint32_t i) { sphere_leaves(a, s, i, 1, 1e4f, 40); });
    add(cases, "self-intersection/triangle-far-away", "off a triangle of size 1, 1e4 from the origin", source, margin, with_triangle,
        [](const answers& a, score& s, std::uint32_t i) { triangle_leaves(a, s, i, 1, 1e4f, 41); });
    add(cases, "self-intersection/grazing", "off a sphere within 1e-6 to 1e-3 of its tangent plane", source, margin, with_sphere,
        [](const answers& a, score& s, std::uint32_t i) { grazes(a, s, i, 42); });
    add(cases, "self-intersection/transformed", "off spheres stretched by up to 1e6", source, margin,
        [](const answers& a) { return a.placed_sphere && a.leave; }, [](const answers& a, score& s, std::uint32_t i) { placed_leaves(a, s, i, 43); });
    add(cases, "self-intersection/plane", "off a plane, at scales 1e-4 to 1e5", source, margin,
        [](const answers& a) { return a.plane && a.leave; }, [](const answers& a, score& s, std::uint32_t i) { plane_leaves(a, s, i, 44); });
}

}  // namespace stress
