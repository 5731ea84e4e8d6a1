// SPDX-License-Identifier: MIT
#pragma once
// Where a surface lies, more closely than a box can say: what bounding volumes are wrapped around.

#include <lantern/aabb.hpp>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace lantern {

/// All that is within `radius` of the convex hull of the points, which are finite: of a sphere its center and its radius,
/// of a triangle its corners. In double, so that nothing is rounded before the volume is.
struct hull {
    std::vector<glm::dvec3> points;
    double radius = 0;
};

[[nodiscard]] inline hull hull_of(std::span<const glm::vec3> points) { return {{points.begin(), points.end()}, 0}; }

/// The corners of a box.
[[nodiscard]] inline hull hull_of(const aabb& box) {
    hull result;
    if (empty(box)) return result;
    for (int i = 0; i < 8; ++i)
        result.points.emplace_back((i & 1 ? box.max : box.min).x, (i & 2 ? box.max : box.min).y, (i & 4 ? box.max : box.min).z);
    return result;
}

/// A surface that says nothing better than its box. One that can, has a `hull_of` of its own beside it.
template <bounded S>
[[nodiscard]] hull hull_of(const S& s) {
    return hull_of(bounds(s));
}

/// The smallest box around both, rounded outwards.
[[nodiscard]] inline aabb enclose(const aabb& box, const hull& h) {
    if (h.points.empty()) return box;
    glm::dvec3 lo = h.points.front(), hi = lo;
    for (const glm::dvec3& p : h.points) lo = glm::min(lo, p), hi = glm::max(hi, p);
    if (h.radius == 0) return enclose(box, enclosing(lo, hi));
    const glm::dvec3 reach = h.radius + 0x1p-51 * (glm::max(glm::abs(lo), glm::abs(hi)) + h.radius);
    return enclose(box, enclosing(lo - reach, hi + reach));
}

[[nodiscard]] inline aabb enclose(std::span<const aabb> boxes) {
    aabb all;
    for (const aabb& box : boxes) all = enclose(all, box);
    return all;
}

}  // namespace lantern
