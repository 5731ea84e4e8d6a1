// SPDX-License-Identifier: MIT
#pragma once
// From the unit square to the disk, polygon, triangle, sphere, hemisphere and cone: evenly spread stays evenly spread.

#include <lantern/validate.hpp>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace lantern {

// Each warp maps [0, 1]², the borders included, and has its density beside it: probability per area, or per solid angle
// for directions. Directions are given about the axis (0, 0, 1). Where a warp could be chosen, neighbours in the square
// stay neighbours, so that a stratified set stays stratified. Computed in double, rounded once.

/// Uniform on the unit disk (Shirley and Chiu, "A low distortion map between disk and square", 1997).
[[nodiscard]] inline glm::vec2 to_disk(glm::vec2 xi) {
    const double a = 2 * double{xi.x} - 1, b = 2 * double{xi.y} - 1;
    if (a == 0 && b == 0) return {0, 0};  // the formula below would divide by zero
    constexpr double quarter = std::numbers::pi / 4;
    const bool wide = std::abs(a) > std::abs(b);
    const double r = wide ? a : b, angle = wide ? quarter * (b / a) : 2 * quarter - quarter * (a / b);
    return {static_cast<float>(r * std::cos(angle)), static_cast<float>(r * std::sin(angle))};
}
[[nodiscard]] constexpr float disk_density() { return std::numbers::inv_pi_v<float>; }

/// Barycentric coordinates, uniform by area (Heitz, "A low-distortion map between triangle and square", 2019).
[[nodiscard]] inline glm::vec3 to_triangle(glm::vec2 xi) {
    const float half = std::min(xi.x, xi.y) / 2;
    const float u = xi.y > xi.x ? half : xi.x - half, v = xi.y > xi.x ? xi.y - half : half;
    return {u, v, std::max(0.0f, 1 - u - v)};
}
/// In the triangle's own units: one over its area.
[[nodiscard]] inline float triangle_density(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    return 2 / glm::length(glm::cross(b - a, c - a));
}

/// Uniform on the regular polygon with corners on the unit circle, the first at angle `rotation` (radians): one sector
/// for each corner, a triangle in it. At least three corners.
[[nodiscard]] inline glm::vec2 to_polygon(glm::vec2 xi, std::uint32_t corners, float rotation = 0) {
    const double scaled = double{xi.x} * corners;
    const double sector = std::min(std::floor(scaled), static_cast<double>(corners) - 1);
    const glm::vec3 weight = to_triangle({static_cast<float>(scaled - sector), xi.y});
    const double step = 2 * std::numbers::pi / corners, angle = rotation + sector * step;
    return {static_cast<float>(weight.x * std::cos(angle) + weight.y * std::cos(angle + step)),
            static_cast<float>(weight.x * std::sin(angle) + weight.y * std::sin(angle + step))};
}
[[nodiscard]] inline float polygon_density(std::uint32_t corners) {
    return static_cast<float>(2 / (corners * std::sin(2 * std::numbers::pi / corners)));
}

/// Uniform on the unit sphere (Archimedes: equal heights, equal areas).
[[nodiscard]] inline glm::vec3 to_sphere(glm::vec2 xi) {
    const double u = xi.x, angle = 2 * std::numbers::pi * xi.y, r = 2 * std::sqrt(u * (1 - u));
    return {static_cast<float>(r * std::cos(angle)), static_cast<float>(r * std::sin(angle)),
            static_cast<float>(1 - 2 * u)};
}
[[nodiscard]] constexpr float sphere_density() { return std::numbers::inv_pi_v<float> / 4; }

/// All directions within an angle of the axis. The height of the cap that they cut from the unit sphere, 1 - cos of the
/// angle, tells it without cancellation, however small. In (0, 2]; 1 is the hemisphere.
struct cone {
    double height = 1;
};

/// From the half angle, in radians: 1 - cos a = 2 sin²(a/2).
[[nodiscard]] inline cone cone_of(double half_angle) {
    if (!(half_angle > 0 && half_angle <= std::numbers::pi))
        refuse("cone: half angle", to_text(half_angle), "above 0 and at most pi (it is in radians)");
    return {2 * std::sin(half_angle / 2) * std::sin(half_angle / 2)};
}

[[nodiscard]] inline double solid_angle(const cone& c) { return 2 * std::numbers::pi * c.height; }
[[nodiscard]] inline double cone_density(const cone& c) { return 1 / solid_angle(c); }

/// Uniform by solid angle: a point of the disk, lifted to the cap by the map that keeps areas (Lambert 1772).
[[nodiscard]] inline glm::dvec3 to_cone(const cone& c, glm::vec2 xi) {
    const glm::dvec2 p(to_disk(xi));
    const double fallen = std::min(1.0, glm::dot(p, p)) * c.height, spread = std::sqrt(c.height * (2 - fallen));
    return {p.x * spread, p.y * spread, 1 - fallen};
}

/// Uniform on the hemisphere about the axis.
[[nodiscard]] inline glm::vec3 to_hemisphere(glm::vec2 xi) { return glm::vec3(to_cone({.height = 1}, xi)); }
[[nodiscard]] constexpr float hemisphere_density() { return std::numbers::inv_pi_v<float> / 2; }

/// Denser towards the axis, as the cosine (Malley: a point of the disk, raised to the hemisphere).
[[nodiscard]] inline glm::vec3 to_cosine_hemisphere(glm::vec2 xi) {
    const glm::vec2 p = to_disk(xi);
    const double r = 2 * std::max(std::abs(xi.x - 0.5), std::abs(xi.y - 0.5));  // exact, and of the rounded p it would not be
    return {p.x, p.y, static_cast<float>(std::sqrt((1 - r) * (1 + r)))};
}
[[nodiscard]] inline float cosine_hemisphere_density(glm::vec3 direction) {
    return std::max(0.0f, direction.z) * std::numbers::inv_pi_v<float>;
}

}  // namespace lantern
