// SPDX-License-Identifier: MIT
#pragma once
// Clear glass: Snell and Fresnel.

#include <lantern/material.hpp>
#include <lantern/mirror.hpp>
#include <lantern/surface.hpp>
#include <lantern/validate.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace lantern {

/// A clear dielectric. `index` is its index of refraction relative to what is outside; `color` is what passes each
/// time a ray crosses the surface.
struct glass {
    float index = 1.5f;
    glm::vec3 color{1};
};

inline void validate(const glass& m) {
    require_positive(m.index, "glass: index");
    require_albedo(m.color, "glass: color");
}

/// What Snell's and Fresnel's laws say of a ray at a boundary.
struct refraction {
    glm::vec3 direction{0};  ///< of the refracted ray; unit length
    float reflectance = 0;   ///< the part that is reflected, mean of both polarisations
};

/// Snell's law with Fresnel's reflectance. `normal` faces the incoming ray; `ratio` is the index on the side the ray
/// comes from over the index on the other. Empty beyond the critical angle: total internal reflection. In double, and
/// with sin² = |n × d|² / |n|²|d|²: 1 - cos² has lost the answer near the normal, and near the critical angle it is wrong
/// about it. Nothing is normalised before the decision. A ratio of exactly 1 lets the ray pass unbent.
[[nodiscard]] inline std::optional<refraction> refracted(glm::vec3 in, glm::vec3 normal, double ratio) {
    if (ratio == 1) return refraction{in, 0};
    const glm::dvec3 d(in), n(normal), across = ratio * glm::cross(n, d);
    const double lengths2 = glm::dot(n, n) * glm::dot(d, d), sine2 = glm::dot(across, across);
    if (!(sine2 < lengths2)) return std::nullopt;
    const double cos_in = std::max(0.0, -glm::dot(n, d) / std::sqrt(lengths2));
    const double cos_out = std::sqrt((lengths2 - sine2) / lengths2);
    const double parallel = (cos_in - ratio * cos_out) / (cos_in + ratio * cos_out);
    const double perpendicular = (ratio * cos_in - cos_out) / (ratio * cos_in + cos_out);
    const double length_n = glm::length(n), length_d = glm::length(d);
    const glm::dvec3 along = glm::cross(across, n) / (length_n * length_n * length_d);  // the surface; |along| = sin
    const glm::dvec3 bent = along - cos_out / length_n * n;
    return refraction{glm::vec3(glm::normalize(bent)),
                      static_cast<float>((parallel * parallel + perpendicular * perpendicular) / 2)};
}

/// One reflected ray and, below the critical angle, one refracted ray. (Radiance also changes by the square of the
/// ratio of indices; that cancels on every path that leaves the glass again, and is left out: lights and eyes are
/// outside.)
[[nodiscard]] inline bounces scatter(const glass& m, glm::vec3 in, const hit& h) {
    const bool entering = glm::dot(in, h.normal) < 0;
    const double ratio = entering ? 1 / double(m.index) : double(m.index);
    const auto bent = refracted(in, facing(h.normal, in), ratio);
    if (!bent) return bounce{mirrored(in, h.normal), glm::vec3(1)};
    const bounce through{bent->direction, (1 - bent->reflectance) * m.color};
    if (bent->reflectance == 0) return through;
    return {bounce{mirrored(in, h.normal), glm::vec3(bent->reflectance)}, through};
}

}  // namespace lantern
