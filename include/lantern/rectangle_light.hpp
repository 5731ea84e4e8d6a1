// SPDX-License-Identifier: MIT
#pragma once
// A flat light: soft shadows.

#include <lantern/light.hpp>
#include <lantern/rectangle.hpp>
#include <lantern/validate.hpp>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace lantern {

/// A parallelogram from `corner` along `edge_u` and `edge_v`, shining evenly to the side of edge_u × edge_v.
struct rectangle_light {
    glm::vec3 corner{0};
    glm::vec3 edge_u{1, 0, 0};
    glm::vec3 edge_v{0, 0, 1};
    glm::vec3 radiance{1};
};

/// The surface that shines. With the material `emissive{light.radiance}` it makes the light visible.
[[nodiscard]] inline rectangle surface_of(const rectangle_light& l) { return {l.corner, l.edge_u, l.edge_v}; }

inline void validate(const rectangle_light& l) {
    validate(surface_of(l));
    require_not_negative(l.radiance, "rectangle_light: radiance");
}

[[nodiscard]] inline rectangle_light displaced(const rectangle_light& l, glm::vec3 by) {
    return {l.corner + by, l.edge_u, l.edge_v, l.radiance};
}

/// A point of the light, uniform in area: xi is carried over linearly, so the part of the unit square that a straight
/// edge leaves visible is cut by a straight line. The irradiance is L A cos θ / d², as if the whole light were there.
[[nodiscard]] inline illumination illuminate(const rectangle_light& l, glm::vec3 point, glm::vec2 xi) {
    const glm::dvec3 u(l.edge_u), v(l.edge_v);
    const glm::dvec3 position = glm::dvec3(l.corner) + double(xi.x) * u + double(xi.y) * v;
    return illuminate_from(position, glm::cross(u, v), l.radiance, point);
}

/// How densely `illuminate` draws the direction from `point` to `position`, a point of the light, per solid angle.
[[nodiscard]] inline double density(const rectangle_light& l, glm::vec3 point, glm::vec3 position) {
    return density_from(glm::dvec3(position), glm::cross(glm::dvec3(l.edge_u), glm::dvec3(l.edge_v)), point);
}

}  // namespace lantern
