// SPDX-License-Identifier: MIT
#pragma once
// The cylinder, closed by a disk at either end.

#include <lantern/aabb.hpp>
#include <lantern/interval.hpp>
#include <lantern/precise.hpp>
#include <lantern/validate.hpp>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace lantern {

/// The surface of the solid of all points within |radius| of the segment between the middles of its ends, and between the
/// planes of the ends: a tube with both lids. Normals point outwards.
struct cylinder {
    glm::vec3 from{0};
    glm::vec3 to{0, 1, 0};
    float radius = 1;
};

inline void validate(const cylinder& s) {
    require_finite(s.from, "cylinder: from");
    require_finite(s.to, "cylinder: to");
    if (s.from == s.to) refuse("cylinder: to", to_text(s.to), "different from `from`");
    require_finite(s.radius, "cylinder: radius");
}

/// As for the disk, at both ends. Rounded outwards.
[[nodiscard]] inline aabb bounds(const cylinder& s) {
    const glm::dvec3 from(s.from), to(s.to), a = to - from, aa = a * a;
    const glm::dvec3 reach = std::abs(double(s.radius)) * (1 + 0x1p-48) *
                             glm::sqrt(glm::dvec3(aa.y + aa.z, aa.z + aa.x, aa.x + aa.y) / (aa.x + aa.y + aa.z));
    const glm::dvec3 rounding = 0x1p-51 * (glm::abs(from) + glm::abs(to) + reach);
    return enclosing(glm::min(from, to) - reach - rounding, glm::max(from, to) + reach + rounding);
}

/// The stretch of the ray within the infinite cylinder, cut with its stretch between the two planes. A ray parallel to the
/// axis is within the infinite cylinder for ever, or never.
[[nodiscard]] inline std::optional<precise::hit> intersect(const cylinder& s, const precise::ray& r, interval range) {
    const glm::dvec3 base(s.from), axis = glm::dvec3(s.to) - base, f = r.origin - base;
    const double radius = std::abs(double(s.radius)), axis2 = glm::dot(axis, axis), axis_length = std::sqrt(axis2);

    // Between the planes: 0 <= (f + t d)·axis <= axis².
    const double height = glm::dot(f, axis), climb = glm::dot(r.direction, axis);
    const bool up = !std::signbit(climb);
    const double enter_lid = ((up ? 0 : axis2) - height) / climb, leave_lid = ((up ? axis2 : 0) - height) / climb;
    double near = -infinity, far = infinity;
    if (enter_lid > near) near = enter_lid;  // 0 / 0, within a lid's plane, bounds nothing
    if (leave_lid < far) far = leave_lid;

    // Within the tube: |m + t k|² <= (R |axis|)², all seen along the axis and stretched by its length.
    const glm::dvec3 m = glm::cross(f, axis), k = glm::cross(r.direction, axis);
    const double a = glm::dot(k, k), b = -glm::dot(m, k), rho2 = radius * radius * axis2, c = glm::dot(m, m) - rho2;
    double enter_tube = -infinity, leave_tube = infinity;
    if (a > 0) {
        const glm::dvec3 l = m + (b / a) * k;
        const double gap = rho2 - glm::dot(l, l);
        if (!(gap >= 0)) return std::nullopt;
        const double root = std::sqrt(a * gap), q = b >= 0 ? b + root : b - root;
        enter_tube = b >= 0 ? c / q : q / a;
        leave_tube = b >= 0 ? q / a : c / q;
        if (q == 0) enter_tube = leave_tube = 0;
    } else if (!(c <= 0)) {
        return std::nullopt;
    }
    const bool enters_tube = enter_tube > near, leaves_tube = leave_tube < far;
    near = std::max(near, enter_tube);
    far = std::min(far, leave_tube);
    if (!(near <= far)) return std::nullopt;

    const bool enters = contains(range, near);
    if (!enters && !contains(range, far)) return std::nullopt;
    const double t = enters ? near : far;
    const glm::dvec3 local = f + t * r.direction, unit = axis / axis_length;
    const double size = precise::size(base) + precise::size(axis) + radius, rounding = 0x1p-49 * size;
    if (!precise::fits(size)) return std::nullopt;
    if (enters ? enters_tube : leaves_tube) {
        const double along = std::clamp(glm::dot(local, axis) / axis2, 0.0, 1.0);
        const glm::dvec3 outwards = local - glm::dot(local, unit) * unit;
        const glm::dvec3 normal = outwards / glm::length(outwards);
        return precise::hit{t, base + along * axis + radius * normal, normal, rounding};
    }
    const bool top = enters != up;
    const glm::dvec3 on = local - glm::dot(local, unit) * unit;
    return precise::hit{t, base + (top ? axis : glm::dvec3(0)) + on, top ? unit : -unit, rounding};
}

}  // namespace lantern
