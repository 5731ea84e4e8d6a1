// SPDX-License-Identifier: MIT
#pragma once
// Oriented bounding boxes: by principal axes, a tighter one, and a test that no ray slips through.

#include <lantern/aabb.hpp>
#include <lantern/hull.hpp>
#include <lantern/interval.hpp>
#include <lantern/precise.hpp>
#include <lantern/ray.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <span>
#include <vector>

namespace lantern {

/// Three directions perpendicular to each other.
using frame = std::array<glm::dvec3, 3>;

/// All points p with |axis · (p - center)| <= half for each of three axes, which are perpendicular unit vectors as well as
/// float can say it. No proof needs them to be exactly so: this is what the box is. The default one is empty.
struct obb {
    glm::vec3 center{0};
    std::array<glm::vec3, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    glm::vec3 half{-1};
};

/// No point lies in it: an extent is negative, or NaN.
[[nodiscard]] inline bool empty(const obb& b) { return !(b.half.x >= 0 && b.half.y >= 0 && b.half.z >= 0); }

[[nodiscard]] inline bool contains(const obb& b, const glm::dvec3& p) {
    const glm::dvec3 from = p - glm::dvec3(b.center);
    for (int i = 0; i < 3; ++i)
        if (!(std::abs(glm::dot(glm::dvec3(b.axes[std::size_t(i)]), from)) <= double(b.half[i]))) return false;
    return true;
}

[[nodiscard]] inline double surface_area(const obb& b) {
    if (empty(b)) return 0;
    const glm::dvec3 h(b.half);
    return 8 * (h.x * h.y + h.y * h.z + h.z * h.x);
}

/// Its corners, by the inverse of the axes' matrix: they are not quite perpendicular.
[[nodiscard]] inline hull hull_of(const obb& b) {
    hull result;
    if (empty(b)) return result;
    const glm::dvec3 c(b.center), h(b.half);
    const glm::dmat3 to_world = glm::inverse(glm::transpose(glm::dmat3(b.axes[0], b.axes[1], b.axes[2])));
    for (int i = 0; i < 8; ++i)
        result.points.push_back(c + to_world * glm::dvec3(i & 1 ? h.x : -h.x, i & 2 ? h.y : -h.y, i & 4 ? h.z : -h.z));
    result.radius = 0x1p-49 * (precise::size(c) + precise::size(h));
    return result;
}

[[nodiscard]] inline aabb bounds(const obb& b) { return enclose(aabb{}, hull_of(b)); }

/// The smallest box with these axes; rounded outwards.
[[nodiscard]] inline obb box_along(const frame& axes, const hull& h) {
    obb box{.axes = {{glm::vec3(axes[0]), glm::vec3(axes[1]), glm::vec3(axes[2])}}};
    if (h.points.empty()) return box;
    const auto along = [&](const glm::dvec3& v, std::size_t i) { return glm::dot(glm::dvec3(box.axes[i]), v); };
    const glm::dvec3 first = h.points.front();
    glm::dvec3 middle(0);
    for (std::size_t i = 0; i < 3; ++i) {
        double lo = 0, hi = 0;
        for (const glm::dvec3& p : h.points) lo = std::min(lo, along(p - first, i)), hi = std::max(hi, along(p - first, i));
        middle += (lo + hi) / 2 * axes[i];
    }
    box.center = glm::vec3(first + middle);
    for (std::size_t i = 0; i < 3; ++i) {
        double reach = 0, size = h.radius;
        for (const glm::dvec3& p : h.points) {
            const glm::dvec3 from = p - glm::dvec3(box.center);
            reach = std::max(reach, std::abs(along(from, i)));
            size = std::max(size, precise::size(from));
        }
        box.half[int(i)] = round_up({reach + h.radius * glm::length(glm::dvec3(box.axes[i])) + 0x1p-49 * size});
    }
    return box;
}

/// The eigenvectors of the points' covariance, by Jacobi's rotations: in which directions the points spread most and least.
[[nodiscard]] inline frame principal_axes(std::span<const glm::dvec3> points) {
    glm::dvec3 mean(0);
    for (const glm::dvec3& p : points) mean += p / double(points.size());
    glm::dmat3 a(0), v(1);
    for (const glm::dvec3& p : points) a += glm::outerProduct(p - mean, p - mean);
    for (int sweep = 0; sweep < 12; ++sweep)
        for (int p = 0; p < 2; ++p)
            for (int q = p + 1; q < 3; ++q) {
                if (std::abs(a[p][q]) <= 0x1p-60 * (a[p][p] + a[q][q])) continue;
                const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
                const double t = std::copysign(1 / (std::abs(theta) + std::sqrt(theta * theta + 1)), theta);
                const double c = 1 / std::sqrt(t * t + 1), s = t * c;
                glm::dmat3 turn(1);
                turn[p][p] = turn[q][q] = c;
                turn[q][p] = s;
                turn[p][q] = -s;
                a = glm::transpose(turn) * a * turn;
                v = v * turn;
            }
    return {v[0], v[1], v[2]};
}

/// The box along the principal axes. Quick, and good for crowds without a shape; but points that crowd together turn it, and
/// it can be worse than the best one by any factor (Dimitrov et al., "On the bounding boxes obtained by principal component
/// analysis", 2006).
[[nodiscard]] inline obb principal_box(const hull& h) {
    return h.points.empty() ? obb{} : box_along(principal_axes(h.points), h);
}

/// The two points farthest along each of seven directions; for a few dozen points, all of them.
[[nodiscard]] inline std::vector<glm::dvec3> extreme_points(std::span<const glm::dvec3> points) {
    if (points.size() <= 64) return {points.begin(), points.end()};
    std::vector<glm::dvec3> extremes;
    for (const glm::dvec3& n : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1), glm::dvec3(1, 1, 1),
                                glm::dvec3(1, 1, -1), glm::dvec3(1, -1, 1), glm::dvec3(1, -1, -1)}) {
        const auto [lo, hi] = std::minmax_element(points.begin(), points.end(), [&](const glm::dvec3& a, const glm::dvec3& b) {
            return glm::dot(n, a) < glm::dot(n, b);
        });
        extremes.push_back(*lo);
        extremes.push_back(*hi);
    }
    return extremes;
}

/// The frames of DiTO-14 (Larsson and Källberg, "Fast computation of tight-fitting oriented bounding boxes", 2011): a face or
/// an edge of the best box often lies along the hull. So a large triangle is put between extreme points, and an apex on
/// either side of it; each edge of these seven triangles, with its normal, is a frame.
template <class Visit>
void for_each_ditetrahedral_frame(std::span<const glm::dvec3> extremes, Visit&& visit) {
    const auto farthest = [&](auto&& measure) {
        return *std::max_element(extremes.begin(), extremes.end(),
                                 [&](const glm::dvec3& p, const glm::dvec3& q) { return measure(p) < measure(q); });
    };
    const glm::dvec3 first = extremes.front(), a = farthest([&](const glm::dvec3& p) { return glm::length(p - first); });
    const glm::dvec3 b = farthest([&](const glm::dvec3& p) { return glm::length(p - a); });
    const glm::dvec3 c = farthest([&](const glm::dvec3& p) { return glm::length(glm::cross(p - a, b - a)); });
    const auto visit_triangle = [&](const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r) {
        const glm::dvec3 n = glm::cross(q - p, r - p);
        // Of points in line, and where an apex is a corner, nothing is left but rounding, and that has any direction.
        if (!(glm::length(n) > 0x1p-26 * glm::length(q - p) * glm::length(r - p))) return;
        for (const glm::dvec3& edge : {q - p, r - q, p - r}) {
            const glm::dvec3 u = glm::normalize(edge), w = glm::normalize(n);
            visit(frame{u, glm::cross(w, u), w});
        }
    };
    visit_triangle(a, b, c);
    const glm::dvec3 up = glm::cross(b - a, c - a);
    for (const double side : {-1.0, 1.0}) {
        const glm::dvec3 apex = farthest([&](const glm::dvec3& p) { return side * glm::dot(up, p); });
        visit_triangle(a, b, apex);
        visit_triangle(b, c, apex);
        visit_triangle(c, a, apex);
    }
}

/// The box of the least surface area, which is what a ray sees of it, of three: along the world's axes, along the principal
/// axes, and along that of the 21 frames of DiTO-14 which is best for the extreme points. Never worse than the first
/// two; linear in the number of points.
[[nodiscard]] inline obb tight_box(const hull& h) {
    obb best = box_along({{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, h);
    if (h.points.empty()) return best;
    const hull extremes{extreme_points(h.points), h.radius};
    frame best_frame = principal_axes(h.points);
    const auto consider = [&](const obb& box) {
        if (surface_area(box) < surface_area(best)) best = box;
    };
    consider(box_along(best_frame, h));
    double least = infinity;
    for_each_ditetrahedral_frame(extremes.points, [&](const frame& axes) {
        const double area = surface_area(box_along(axes, extremes));
        if (area < least) least = area, best_frame = axes;
    });
    consider(box_along(best_frame, h));
    return best;
}

/// Around the corners of all.
[[nodiscard]] inline obb enclose(std::span<const obb> boxes) {
    hull corners;
    for (const obb& b : boxes) {
        const hull one = hull_of(b);
        corners.points.insert(corners.points.end(), one.points.begin(), one.points.end());
        corners.radius = std::max(corners.radius, one.radius);
    }
    return tight_box(corners);
}

[[nodiscard]] inline obb enclose(const obb& a, const obb& b) { return enclose(std::span<const obb>(std::array{a, b})); }

[[nodiscard]] inline obb enclose(const obb& b, const hull& h) {
    const obb around = tight_box(h);
    return empty(b) ? around : empty(around) ? b : enclose(b, around);
}

/// Whether the ray may meet what is in the box, within the range: the same three slabs, with the origin *and the direction*
/// measured along the axes. Never no to a ray that meets it; see `overlaps` of `aabb`.
template <class Ray>
    requires std::derived_from<Ray, ray> || std::derived_from<Ray, precise::ray>
[[nodiscard]] bool overlaps(const obb& b, const Ray& r, interval range) {
    const glm::dvec3 origin(r.origin), center(b.center), from = origin - center, d(r.direction);
    precise::ray local;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 axis(b.axes[std::size_t(i)]);
        local.origin[i] = glm::dot(axis, from);
        local.direction[i] = glm::dot(axis, d);
    }
    slab_ray prepared(local);
    prepared.padding += 0x1p-40 * (precise::size(origin) + precise::size(center) + precise::size(glm::dvec3(b.half)));
    return overlaps(aabb{-b.half, b.half}, prepared, range);
}

}  // namespace lantern
