// SPDX-License-Identifier: MIT
#pragma once
// A round light, sampled by the solid angle that it is seen under.

#include <lantern/light.hpp>
#include <lantern/solid_angle.hpp>
#include <lantern/sphere.hpp>
#include <lantern/validate.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

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
/// side, and each brings the same irradiance, radiance times solid angle (Shirley, Wang and Zimmerman 1996). Above the
/// horizon the mean of L Ω cos θ is π L (R/d)² cos θ of the center, exactly.
[[nodiscard]] inline illumination illuminate(const sphere_light& l, glm::vec3 point, glm::vec2 xi) {
    const auto seen = sphere_seen_from(point, l.center, l.radius);
    if (!seen) return {l.center, glm::vec3(0)};
    const glm::dvec3 normal = seen_normal(*seen, xi);
    return {just_off(seen->center + seen->radius * normal, normal, point),
            glm::vec3(solid_angle(*seen) * glm::dvec3(l.radiance))};
}

/// How densely `illuminate` draws the direction from `point` to any point that it sees of the light, per solid angle: 1 / Ω.
[[nodiscard]] inline double density(const sphere_light& l, glm::vec3 point, glm::vec3) {
    const auto seen = sphere_seen_from(point, l.center, l.radius);
    return seen ? 1 / solid_angle(*seen) : 0;
}

}  // namespace lantern
