// SPDX-License-Identifier: MIT
#pragma once
// Lights: what arrives at a point when nothing is in the way.

#include <lantern/ray.hpp>
#include <lantern/surface.hpp>
#include <lantern/validate.hpp>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <concepts>

namespace lantern {

/// Light on its way to a point. The shadow ray runs from the point to `position`, t in (0, 1].
struct illumination {
    glm::vec3 position{0};    ///< where it comes from
    glm::vec3 irradiance{0};  ///< what it brings to a surface that faces `position`: power per area
};

/// A light without extent says at once how it illuminates a point; one with area needs a point of the unit square, and
/// asks for it by the number of its arguments. `light<L>` is either.
template <class L>
concept point_like = requires(const L& l, glm::vec3 point) {
    { illuminate(l, point) } -> std::same_as<illumination>;
};

template <class L>
concept sampled_light = requires(const L& l, glm::vec3 point, glm::vec2 xi) {
    { illuminate(l, point, xi) } -> std::same_as<illumination>;
};

/// A light that moves asks for the time too, which only a `timed_ray` knows.
template <class L, class Ray>
concept moving_light = requires(const L& l, glm::vec3 point, glm::vec2 xi, const Ray& r) {
    { illuminate(l, point, xi, r.time) } -> std::same_as<illumination>;
};

template <class L>
concept light = point_like<L> || sampled_light<L> || moving_light<L, timed_ray>;

/// A light of no size: `intensity` is power per solid angle, the same in all directions.
struct point_light {
    glm::vec3 position{0};
    glm::vec3 intensity{1};
};

inline void validate(const point_light& l) {
    require_finite(l.position, "point_light: position");
    require_not_negative(l.intensity, "point_light: intensity");
}

/// The inverse-square law, in double: 1e-30 and 1e20 are distances too.
[[nodiscard]] inline illumination illuminate(const point_light& l, glm::vec3 point) {
    const glm::dvec3 to_light = glm::dvec3(l.position) - glm::dvec3(point);
    return {l.position, glm::vec3(glm::dvec3(l.intensity) / glm::dot(to_light, to_light))};
}

/// For lights with area: one of their points stands for the whole light. `area_normal` is the normal there, with the
/// light's area as its length: irradiance L A cos θ / d², nothing behind. The shadow ray ends just off the light, so
/// that the light's own surface, where it is part of the scene, does not shade it.
[[nodiscard]] inline illumination illuminate_from(glm::dvec3 position, glm::dvec3 area_normal, glm::vec3 radiance,
                                                  glm::vec3 point) {
    const glm::dvec3 to_point = glm::dvec3(point) - position;
    const double cosine_area = glm::dot(area_normal, to_point);
    if (!(cosine_area > 0)) return {glm::vec3(position), glm::vec3(0)};
    const double d2 = glm::dot(to_point, to_point);
    const hit here{0, glm::vec3(position), glm::vec3(glm::normalize(area_normal)), 0};
    return {leave(here, glm::vec3(to_point)), glm::vec3(glm::dvec3(radiance) * (cosine_area / (d2 * std::sqrt(d2))))};
}

}  // namespace lantern
