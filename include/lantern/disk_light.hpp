// SPDX-License-Identifier: MIT
#pragma once
// A flat round light.

#include <lantern/basis.hpp>
#include <lantern/disk.hpp>
#include <lantern/light.hpp>
#include <lantern/validate.hpp>
#include <lantern/warp.hpp>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <numbers>

namespace lantern {

/// A disk that shines evenly to the side of its normal, which need not have unit length.
struct disk_light {
    glm::vec3 center{0};
    glm::vec3 normal{0, -1, 0};
    float radius = 1;
    glm::vec3 radiance{1};
};

/// The surface that shines. With the material `emissive{light.radiance}` it makes the light visible.
[[nodiscard]] inline disk surface_of(const disk_light& l) { return {l.center, l.normal, l.radius}; }

inline void validate(const disk_light& l) {
    validate(surface_of(l));
    require_positive(l.radius, "disk_light: radius");
    require_not_negative(l.radiance, "disk_light: radiance");
}

[[nodiscard]] inline disk_light displaced(const disk_light& l, glm::vec3 by) {
    return {l.center + by, l.normal, l.radius, l.radiance};
}

/// A point of the light, uniform in area, by the concentric map: neighbours in the unit square are neighbours on the
/// light. The irradiance is L A cos θ / d², as if the whole light were there.
[[nodiscard]] inline illumination illuminate(const disk_light& l, glm::vec3 point, glm::vec2 xi) {
    const basis b = basis_from(l.normal);
    const glm::dvec2 p = double(l.radius) * glm::dvec2(to_disk(xi));
    const glm::dvec3 position = glm::dvec3(l.center) + p.x * glm::dvec3(b.u) + p.y * glm::dvec3(b.v);
    const double area = std::numbers::pi * double(l.radius) * double(l.radius);
    return illuminate_from(position, area * glm::dvec3(b.w), l.radiance, point);
}

/// How densely `illuminate` draws the direction from `point` to `position`, a point of the light, per solid angle.
[[nodiscard]] inline double density(const disk_light& l, glm::vec3 point, glm::vec3 position) {
    const double area = std::numbers::pi * double(l.radius) * double(l.radius);
    return density_from(glm::dvec3(position), area * glm::normalize(glm::dvec3(l.normal)), point);
}

}  // namespace lantern
