// SPDX-License-Identifier: MIT
#pragma once
// The flat disk.

#include <lantern/aabb.hpp>
#include <lantern/interval.hpp>
#include <lantern/plane.hpp>
#include <lantern/precise.hpp>
#include <lantern/validate.hpp>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <optional>

namespace lantern {

/// All points of the plane through the center that are no farther from it than |radius|. The normal need not have unit
/// length.
struct disk {
    glm::vec3 center{0};
    glm::vec3 normal{0, 0, 1};
    float radius = 1;

    [[nodiscard]] bool operator==(const disk&) const = default;
};

inline void validate(const disk& s) {
    require_finite(s.center, "disk: center");
    require_finite(s.normal, "disk: normal");
    if (s.normal == glm::vec3(0)) refuse("disk: normal", to_text(s.normal), "different from zero");
    require_finite(s.radius, "disk: radius");
}

/// Along an axis the disk reaches R √(1 - n²), which is the length of the normal's other two components. Rounded outwards.
[[nodiscard]] inline aabb bounds(const disk& s) {
    const glm::dvec3 n(s.normal), c(s.center), nn = n * n;
    const glm::dvec3 reach = std::abs(double(s.radius)) * (1 + 0x1p-48) *
                             glm::sqrt(glm::dvec3(nn.y + nn.z, nn.z + nn.x, nn.x + nn.y) / (nn.x + nn.y + nn.z));
    const glm::dvec3 rounding = 0x1p-51 * (glm::abs(c) + reach);
    return enclosing(c - reach - rounding, c + reach + rounding);
}

[[nodiscard]] inline std::optional<precise::hit> intersect(const disk& s, const precise::ray& r, interval range) {
    const glm::dvec3 c(s.center), n(s.normal);
    const double radius = std::abs(double(s.radius)), t = precise::meet_plane(r, c, n);
    if (!contains(range, t)) return std::nullopt;
    const glm::dvec3 from_center = (r.origin - c) + t * r.direction;
    if (!(glm::dot(from_center, from_center) <= radius * radius && radius < infinity)) return std::nullopt;
    const glm::dvec3 unit = n / glm::length(n), on = from_center - glm::dot(from_center, unit) * unit;
    const double size = precise::size(c) + precise::size(on);
    if (!precise::fits(size)) return std::nullopt;
    return precise::hit{t, c + on, unit, 0x1p-50 * size};
}

}  // namespace lantern
