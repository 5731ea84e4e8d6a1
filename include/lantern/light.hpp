// SPDX-License-Identifier: MIT
#pragma once
// Lights: what arrives at a point when nothing is in the way.

#include <lantern/ray.hpp>
#include <lantern/surface.hpp>
#include <lantern/validate.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <concepts>

namespace lantern {

/// Light on its way to a point. The shadow ray runs from the point to `position`, t in (0, 1].
struct illumination {
    glm::vec3 position{0};    ///< where it comes from
    glm::vec3 irradiance{0};  ///< what it brings to a surface that faces `position`: power per area
};

// A light says by the number of its arguments what it needs: one without extent illuminates a point at once, one with
// area asks for a point of the unit square, and one that moves asks for the time, which only a `timed_ray` knows.

template <class L>
concept point_like = requires(const L& l, glm::vec3 point) {
    { illuminate(l, point) } -> std::same_as<illumination>;
};

template <class L>
concept sampled_light = requires(const L& l, glm::vec3 point, glm::vec2 xi) {
    { illuminate(l, point, xi) } -> std::same_as<illumination>;
};

template <class L>
concept moving_point_light = requires(const L& l, glm::vec3 point, float time) {
    { illuminate(l, point, time) } -> std::same_as<illumination>;
};

template <class L>
concept moving_sampled_light = requires(const L& l, glm::vec3 point, glm::vec2 xi, float time) {
    { illuminate(l, point, xi, time) } -> std::same_as<illumination>;
};

template <class L>
concept still_light = point_like<L> || sampled_light<L>;

template <class L>
concept moving_light = moving_point_light<L> || moving_sampled_light<L>;

template <class L>
concept light = still_light<L> || moving_light<L>;

/// A light of no size: `intensity` is power per solid angle, the same in all directions.
struct point_light {
    glm::vec3 position{0};
    glm::vec3 intensity{1};
};

inline void validate(const point_light& l) {
    require_finite(l.position, "point_light: position");
    require_not_negative(l.intensity, "point_light: intensity");
}

[[nodiscard]] inline point_light displaced(const point_light& l, glm::vec3 by) { return {l.position + by, l.intensity}; }

/// The inverse-square law, in double: 1e-30 and 1e20 are distances too. At the light itself, where light would come from
/// no direction, there is none.
[[nodiscard]] inline illumination illuminate(const point_light& l, glm::vec3 point) {
    const glm::dvec3 to_light = glm::dvec3(l.position) - glm::dvec3(point);
    const double d2 = glm::dot(to_light, to_light);
    return {l.position, d2 > 0 ? glm::vec3(glm::dvec3(l.intensity) / d2) : glm::vec3(0)};
}

/// Where the shadow ray from `point` to a light's surface ends: not on the surface, which may be part of the scene and
/// would be met at t = 1, but stepped off it. `normal` has unit length and points to the lit side. Four ulp of the largest
/// coordinate of both ends cover all that is rounded on the way: both ends, their difference, and t.
[[nodiscard]] inline glm::vec3 just_off(glm::dvec3 position, glm::dvec3 normal, glm::vec3 point) {
    const glm::vec3 p = glm::max(glm::abs(glm::vec3(position)), glm::abs(point));
    return glm::vec3(position + 4 * double(ulp(std::max({p.x, p.y, p.z}))) * normal);
}

/// For lights that are sampled by area: one of their points stands for the whole light. `area_normal` is the normal
/// there, with the light's area as its length: irradiance L A cos θ / d², nothing behind.
[[nodiscard]] inline illumination illuminate_from(glm::dvec3 position, glm::dvec3 area_normal, glm::vec3 radiance,
                                                  glm::vec3 point) {
    const glm::dvec3 to_point = glm::dvec3(point) - position;
    const double area_cosine = glm::dot(area_normal, to_point);
    if (!(area_cosine > 0)) return {glm::vec3(position), glm::vec3(0)};
    const double d2 = glm::dot(to_point, to_point);
    return {just_off(position, area_normal / glm::length(area_normal), point),
            glm::vec3(glm::dvec3(radiance) * (area_cosine / (d2 * std::sqrt(d2))))};
}

/// The density by solid angle of `illuminate_from` with evenly drawn points, d² / (A cos θ): 0 seen from behind.
[[nodiscard]] inline double density_from(glm::dvec3 position, glm::dvec3 area_normal, glm::vec3 point) {
    const glm::dvec3 to_point = glm::dvec3(point) - position;
    const double area_cosine = glm::dot(area_normal, to_point), d2 = glm::dot(to_point, to_point);
    return area_cosine > 0 ? d2 * std::sqrt(d2) / area_cosine : 0;
}

}  // namespace lantern
