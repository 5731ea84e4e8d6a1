// SPDX-License-Identifier: MIT
#pragma once
// A round light, sampled by the solid angle that it is seen under.

#include <lantern/basis.hpp>
#include <lantern/light.hpp>
#include <lantern/sphere.hpp>
#include <lantern/validate.hpp>
#include <lantern/warp.hpp>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace lantern {

/// A sphere that shines evenly outwards. Inside it is dark.
struct sphere_light {
    glm::vec3 center{0};
    float radius = 1;
    glm::vec3 radiance{1};
};

/// The surface that shines. With the material `emissive{light.radiance}` it makes the light visible.
[[nodiscard]] inline sphere surface_of(const sphere_light& l) { return {l.center, l.radius}; }

inline void validate(const sphere_light& l) {
    require_finite(l.center, "sphere_light: center");
    require_positive(l.radius, "sphere_light: radius");
    require_not_negative(l.radiance, "sphere_light: radiance");
}

[[nodiscard]] inline sphere_light displaced(const sphere_light& l, glm::vec3 by) { return {l.center + by, l.radius, l.radiance}; }

/// A direction uniform in the cone around the sphere, and the point that it meets first: no sample is spent on the far
/// side, and each brings the same irradiance L Ω (Shirley, Wang and Zimmerman 1996). Above the horizon the mean of
/// L Ω cos θ is π L (R/d)² cos θ of the center, exactly. The solid angle is Ω = 2π h, h = s²/(1 + √(1 - s²)),
/// s = R/d; the usual 2π(1 - √(1 - s²)) has no digit left at s = 1e-8.
[[nodiscard]] inline illumination illuminate(const sphere_light& l, glm::vec3 point, glm::vec2 xi) {
    const glm::dvec3 center(l.center), to_center = center - glm::dvec3(point);
    const double d2 = glm::dot(to_center, to_center), r2 = double(l.radius) * double(l.radius);
    if (!(d2 > r2)) return {l.center, glm::vec3(0)};
    const cone seen{(r2 / d2) / (1 + std::sqrt((d2 - r2) / d2))};

    const double d = std::sqrt(d2);
    const glm::dvec3 axis = to_center / d, local = to_cone(seen, xi);
    const basis b = basis_from(glm::vec3(axis));
    const glm::dvec3 across = local.x * glm::dvec3(b.u) + local.y * glm::dvec3(b.v);

    // From the center to the near one of the two points where the direction meets the sphere, t away from the point. Along
    // the axis t cos θ - d, without the cancellation.
    const double cosine = local.z, sine2 = local.x * local.x + local.y * local.y;
    const double half_chord = std::sqrt(std::max(0.0, r2 - d2 * sine2)), t = d * cosine - half_chord;
    const glm::dvec3 from_center = t * across - (d * sine2 + half_chord * cosine) * axis;
    const glm::dvec3 normal = from_center / glm::length(from_center);
    return {just_off(center + double(l.radius) * normal, normal, point),
            glm::vec3(solid_angle(seen) * glm::dvec3(l.radiance))};
}

}  // namespace lantern
