// SPDX-License-Identifier: MIT
#pragma once
// The axis-aligned box, as a surface.

#include <lantern/aabb.hpp>
#include <lantern/interval.hpp>
#include <lantern/precise.hpp>
#include <lantern/validate.hpp>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <optional>

namespace lantern {

/// The six faces of min <= p <= max; normals point outwards. A flat box, with min = max along an axis, is a rectangle. An
/// `instance` of a box stands at any angle.
struct box {
    glm::vec3 min{-1};
    glm::vec3 max{1};
};

inline void validate(const box& b) {
    require_finite(b.min, "box: min");
    require_finite(b.max, "box: max");
    if (empty(aabb{b.min, b.max})) refuse("box: min", to_text(b.min), "nowhere greater than max = " + to_text(b.max));
}

[[nodiscard]] inline aabb bounds(const box& b) { return {b.min, b.max}; }

/// Slabs (Kay and Kajiya 1986), closed: a ray along a face, an edge or through a corner hits. Divisions, not products with
/// a reciprocal: they round monotonically, so a ray that meets the box is never lost. A ray within a face's plane gives
/// 0 / 0 there; the NaN fails its comparison and bounds nothing.
[[nodiscard]] inline std::optional<precise::hit> intersect(const box& b, const precise::ray& r, interval range) {
    const glm::dvec3 min(b.min), max(b.max);
    double near = -infinity, far = infinity;
    int near_axis = -1, far_axis = -1;
    for (int i = 0; i < 3; ++i) {
        const double lower = (min[i] - r.origin[i]) / r.direction[i], upper = (max[i] - r.origin[i]) / r.direction[i];
        const bool forward = !std::signbit(r.direction[i]);
        const double enter = forward ? lower : upper, leave = forward ? upper : lower;
        if (enter > near) near = enter, near_axis = i;
        if (leave < far) far = leave, far_axis = i;
        if (!(min[i] <= max[i])) return std::nullopt;
    }
    if (!(near <= far)) return std::nullopt;
    const bool enters = contains(range, near);
    if (!enters && !contains(range, far)) return std::nullopt;
    const double t = enters ? near : far;
    const int axis = enters ? near_axis : far_axis;
    const double side = enters == (r.direction[axis] > 0) ? -1 : 1;

    const glm::dvec3 along = precise::at(r, t);
    if (!precise::fits(precise::size(along))) return std::nullopt;  // NaN, of the ray's own making, too
    precise::hit h{t, glm::clamp(along, min, max), glm::dvec3(0), 0};
    h.point[axis] = side < 0 ? min[axis] : max[axis];  // on the face, exactly
    h.normal[axis] = side;
    return h;
}

}  // namespace lantern
