// SPDX-License-Identifier: MIT
#pragma once
// Bounding spheres: the smallest one, a quick one, and a test that no ray slips through.

#include <lantern/aabb.hpp>
#include <lantern/hash.hpp>
#include <lantern/hull.hpp>
#include <lantern/interval.hpp>
#include <lantern/precise.hpp>
#include <lantern/ray.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

namespace lantern {

/// All points no farther than `radius` from the center. The default one is empty: `enclose` of it and anything is that
/// thing. Unlike the surface `sphere` it is solid, and a negative radius holds nothing.
struct bounding_sphere {
    glm::vec3 center{0};
    float radius = -1;
};

/// No point lies in it: the radius is negative, or something is NaN. A single point is not empty.
[[nodiscard]] inline bool empty(const bounding_sphere& s) {
    const glm::vec3 c = s.center;
    return !(s.radius >= 0 && c.x == c.x && c.y == c.y && c.z == c.z);
}

[[nodiscard]] inline bool contains(const bounding_sphere& s, const glm::dvec3& p) {
    return glm::length(p - glm::dvec3(s.center)) <= double(s.radius);
}

[[nodiscard]] inline double surface_area(const bounding_sphere& s) {
    return empty(s) ? 0 : 4 * std::numbers::pi * double(s.radius) * double(s.radius);
}

[[nodiscard]] inline aabb bounds(const bounding_sphere& s) {
    return empty(s) ? aabb{} : grown({s.center, s.center}, glm::vec3(s.radius));
}

[[nodiscard]] inline hull hull_of(const bounding_sphere& s) {
    if (empty(s)) return {};
    return {{glm::dvec3(s.center)}, s.radius};
}

namespace precise {

/// `bounding_sphere` before it is rounded.
struct ball {
    glm::dvec3 center{0};
    double radius = -1;
};

/// The smallest ball around both.
[[nodiscard]] inline ball enclose(const ball& a, const ball& b) {
    if (a.radius < 0) return b;
    const glm::dvec3 way = b.center - a.center;
    const double distance = glm::length(way);
    if (distance + b.radius <= a.radius) return a;
    if (distance + a.radius <= b.radius) return b;
    const double radius = (distance + a.radius + b.radius) / 2;
    return {a.center + (radius - a.radius) / distance * way, radius};
}

/// The smallest sphere through one to four points; empty where they do not span one.
[[nodiscard]] inline ball sphere_through(std::span<const glm::dvec3> p) {
    if (p.empty()) return {};
    // The center is p[0] + M x with the other points q = p[i] - p[0] as columns of M, and 2 q·(M x) = q·q for each of them.
    std::array<std::array<double, 4>, 3> rows{};
    const std::size_t n = p.size() - 1;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k < n; ++k) rows[i][k] = 2 * glm::dot(p[i + 1] - p[0], p[k + 1] - p[0]);
        rows[i][3] = rows[i][i] / 2;
    }
    for (std::size_t i = 0; i < n; ++i) {  // Gauss and Jordan; the matrix is symmetric and not negative: no pivots needed
        const double pivot = rows[i][i];
        if (!(pivot > 0x1p-40 * glm::dot(p[i + 1] - p[0], p[i + 1] - p[0]))) return {};
        for (std::size_t k = 0; k < n; ++k) {
            const double factor = k == i ? 0 : rows[k][i] / pivot;
            for (std::size_t c = 0; c < 4; ++c) rows[k][c] -= factor * rows[i][c];
        }
    }
    glm::dvec3 way(0);
    for (std::size_t i = 0; i < n; ++i) way += rows[i][3] / rows[i][i] * (p[i + 1] - p[0]);
    return {p[0] + way, glm::length(way)};
}

/// The smallest ball around `points` that has the first `fixed` of `on` on its boundary. Four levels deep at most.
[[nodiscard]] inline ball smallest_ball(std::span<const glm::dvec3> points, std::array<glm::dvec3, 4>& on, std::size_t fixed) {
    ball best = sphere_through(std::span(on).first(fixed));
    if (fixed == 4) return best;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (best.radius >= 0 && glm::length(points[i] - best.center) <= best.radius * (1 + 0x1p-36)) continue;
        on[fixed] = points[i];
        const ball larger = smallest_ball(points.first(i), on, fixed + 1);
        if (larger.radius >= best.radius) best = larger;  // not so where points in one plane or in line span no sphere
    }
    return best;
}

/// Grown to hold the hull for certain, and rounded outwards.
[[nodiscard]] inline bounding_sphere rounded(const ball& b, const hull& h) {
    if (b.radius < 0) return {};
    const glm::vec3 center(b.center);
    double radius = 0;
    for (const glm::dvec3& p : h.points) radius = std::max(radius, glm::length(p - glm::dvec3(center)));
    return {center, radius == 0 ? round_up({h.radius}) : round_up({(radius + h.radius) * (1 + 0x1p-49)})};
}

}  // namespace precise

/// The smallest sphere, in expected linear time: Welzl, "Smallest enclosing disks (balls and ellipsoids)", 1991, as three
/// nested loops, over the points in a shuffled order. Too large by rounding alone. Equal radii of a hull add to it.
[[nodiscard]] inline bounding_sphere smallest_sphere(const hull& h) {
    std::vector<glm::dvec3> shuffled(h.points);
    for (std::uint32_t i = 0; i < shuffled.size(); ++i)
        shuffled[i] = h.points[permute(i, static_cast<std::uint32_t>(shuffled.size()), 1)];
    std::array<glm::dvec3, 4> on;
    return precise::rounded(precise::smallest_ball(shuffled, on, 0), h);
}

/// Two passes: Ritter, "An efficient bounding sphere", 1990. Larger than the smallest by a few per cent, at worst by about
/// a quarter (1.26 times, of 400,000 random clouds). From two points far apart, then grown by each point that is outside.
[[nodiscard]] inline bounding_sphere quick_sphere(const hull& h) {
    if (h.points.empty()) return {};
    const auto farthest = [&](const glm::dvec3& from) {
        return *std::max_element(h.points.begin(), h.points.end(), [&](const glm::dvec3& a, const glm::dvec3& b) {
            return glm::dot(a - from, a - from) < glm::dot(b - from, b - from);
        });
    };
    const glm::dvec3 a = farthest(h.points.front()), b = farthest(a);
    precise::ball all = precise::enclose({a, 0}, {b, 0});
    for (const glm::dvec3& p : h.points) all = precise::enclose(all, {p, 0});
    return precise::rounded(all, h);
}

/// Around spheres: the smaller one of Ritter's, from the two that reach farthest apart, and the smallest around the centers
/// with the largest radius added, which is the best when all radii are equal.
[[nodiscard]] inline bounding_sphere enclose(std::span<const bounding_sphere> spheres) {
    std::vector<precise::ball> balls;
    hull centers;
    for (const bounding_sphere& s : spheres) {
        if (empty(s)) continue;
        balls.push_back({glm::dvec3(s.center), s.radius});
        centers.points.push_back(balls.back().center);
        centers.radius = std::max(centers.radius, balls.back().radius);
    }
    if (balls.empty()) return {};
    const auto farthest = [&](const precise::ball& from) {
        const auto reach = [&](const precise::ball& b) { return glm::length(b.center - from.center) + b.radius; };
        return *std::max_element(balls.begin(), balls.end(), [&](const auto& a, const auto& b) { return reach(a) < reach(b); });
    };
    const precise::ball a = farthest(balls.front()), b = farthest(a);
    precise::ball all = precise::enclose(a, b);
    for (const precise::ball& s : balls) all = precise::enclose(all, s);
    const glm::vec3 center(all.center);
    double radius = 0;
    for (const precise::ball& s : balls) radius = std::max(radius, glm::length(s.center - glm::dvec3(center)) + s.radius);
    const bounding_sphere grown{center, round_up({radius * (1 + 0x1p-49)})}, even = smallest_sphere(centers);
    return grown.radius < even.radius ? grown : even;
}

[[nodiscard]] inline bounding_sphere enclose(const bounding_sphere& a, const bounding_sphere& b) {
    return enclose(std::span<const bounding_sphere>(std::array{a, b}));
}

[[nodiscard]] inline bounding_sphere enclose(const bounding_sphere& s, const hull& h) {
    const bounding_sphere around = smallest_sphere(h);
    return empty(s) ? around : empty(around) ? s : enclose(s, around);
}

/// Whether the ray may meet what is in the sphere, within the range: whether the point of that stretch nearest to the center
/// is in it. Touching counts. It may say yes to a ray that passes at some 1e-12 of the coordinates, never no to one that
/// meets it; and yes, if anything, to a ray of NaN.
template <class Ray>
    requires std::derived_from<Ray, ray> || std::derived_from<Ray, precise::ray>
[[nodiscard]] bool overlaps(const bounding_sphere& s, const Ray& r, interval range) {
    if (empty(s)) return false;
    const glm::dvec3 origin(r.origin), d(r.direction), c(s.center), to = c - origin;
    const double near = range.min - 0x1p-22 * std::abs(double(range.min));  // a hit's t is rounded to float before it is
    const double far = range.max + 0x1p-22 * std::abs(double(range.max));   // compared
    double t = glm::dot(to, d) / glm::dot(d, d);
    t = t > near ? std::min(t, far) : near;
    const double padding = 0x1p-40 * (precise::size(origin) + precise::size(c) + double(s.radius));
    return near <= far && !(glm::length(t * d - to) > double(s.radius) + padding);
}

}  // namespace lantern
