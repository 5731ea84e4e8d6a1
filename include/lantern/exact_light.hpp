// SPDX-License-Identifier: MIT
#pragma once
// Irradiance and solid angle in closed form: the light of polygons, discs and spheres, and of what an edge leaves of
// them.

#include <lantern/exact.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

namespace lantern::exact {

using polygon = std::vector<glm::dvec3>;

[[nodiscard]] inline polygon corners(const parallelogram& p) {
    return {p.corner, p.corner + p.a, p.corner + p.a + p.b, p.corner + p.b};
}

/// The part of a convex polygon where n · (x - origin) > 0 (Sutherland and Hodgman 1974).
[[nodiscard]] inline polygon clipped(std::span<const glm::dvec3> shape, glm::dvec3 origin, glm::dvec3 n) {
    polygon kept;
    for (std::size_t i = 0; i < shape.size(); ++i) {
        const glm::dvec3 from = shape[i], to = shape[(i + 1) % shape.size()];
        const double start = glm::dot(n, from - origin), end = glm::dot(n, to - origin);
        if (start > 0) kept.push_back(from);
        if ((start > 0) != (end > 0)) kept.push_back(from + start / (start - end) * (to - from));
    }
    return kept;
}

/// The part of a convex polygon that is seen from an apex past an edge.
[[nodiscard]] inline polygon seen(glm::dvec3 apex, const edge& past, std::span<const glm::dvec3> shape) {
    return clipped(shape, apex, glm::cross(past.point - apex, past.along));
}

/// The solid angle of a convex polygon: Σγᵢ - (n-2)π, where γᵢ are the angles between the planes through neighbouring
/// sides (Girard 1629), written with the turns π - γᵢ. A small polygon would lose its digits in that difference; it is
/// added up from a fan of triangles instead, by Van Oosterom and Strackee 1983, their triple product taken of
/// differences of corners.
[[nodiscard]] inline double solid_angle(glm::dvec3 point, std::span<const glm::dvec3> shape) {
    double sum = 0;
    for (std::size_t i = 2; i < shape.size(); ++i) {
        const glm::dvec3 a = shape[0] - point, b = shape[i - 1] - point, c = shape[i] - point;
        const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
        const double triple = glm::dot(a, glm::cross(shape[i - 1] - shape[0], shape[i] - shape[0]));
        sum += 2 * std::atan2(std::abs(triple),
                              la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
    }
    if (sum < 1) return sum;

    double turns = 0;
    for (std::size_t i = 0; i < shape.size(); ++i) {
        const glm::dvec3 before = shape[i] - point, at = shape[(i + 1) % shape.size()] - point;
        const glm::dvec3 after = shape[(i + 2) % shape.size()] - point;
        const glm::dvec3 n = glm::cross(before, at), m = glm::cross(at, after);
        turns += std::atan2(glm::length(glm::cross(n, m)), glm::dot(n, m));
    }
    return 2 * std::numbers::pi - turns;
}

/// Irradiance at a point with unit normal n from a convex polygon of radiance 1, both sides shining: Lambert's formula
/// ½ Σ θᵢ n · Γᵢ, where θᵢ is the angle of the i-th side and Γᵢ the unit normal of its plane through the point (Lambert
/// 1760; Arvo 1994), of what is above the horizon. Relative error about 1e-16 / angular size: the sides' terms cancel.
[[nodiscard]] inline double irradiance(glm::dvec3 point, glm::dvec3 n, std::span<const glm::dvec3> shape) {
    const polygon risen = clipped(shape, point, n);
    double sum = 0;
    for (std::size_t i = 0; i < risen.size(); ++i) {
        const glm::dvec3 from = risen[i] - point, to = risen[(i + 1) % risen.size()] - point;
        const glm::dvec3 normal = glm::cross(from, to - from);  // to - from: exact where the corners are close
        const double sine = glm::length(normal);
        if (sine > 0) sum += std::atan2(sine, glm::dot(from, to)) * glm::dot(n, normal) / sine;
    }
    return std::abs(sum) / 2;
}

/// The penumbra: irradiance from what an edge leaves of a light of radiance 1.
[[nodiscard]] inline double penumbra(glm::dvec3 point, glm::dvec3 n, const edge& past, const parallelogram& light) {
    return irradiance(point, n, seen(point, past, corners(light)));
}

/// Irradiance from a disc of radiance 1 and given radius, in a plane parallel to the lit one at the given height, its
/// centre `offset` aside (view factor of a differential element to a parallel disc, Hamilton and Morgan 1952). Coaxial:
/// π r²/(h² + r²).
[[nodiscard]] inline double disc_irradiance(double height, double offset, double radius) {
    const double h2 = height * height, o2 = offset * offset, r2 = radius * radius;
    const double beyond = h2 + o2 - r2;  // positive outside the ball over the disc
    const double root = std::hypot(beyond, 2 * height * radius);
    const double twice_factor = beyond > 0 ? 4 * h2 * r2 / (root * (root + beyond)) : 1 - beyond / root;
    return std::numbers::pi / 2 * twice_factor;
}

/// Irradiance from a sphere of radiance 1, whose centre is at a distance above its radius, in a direction that makes
/// the angle acos(cosine) with the normal. π (r/d)² cosine while it is whole above the horizon; what the horizon leaves
/// of it otherwise (Snyder 1996, as in Lagarde and de Rousiers 2014, section 4.7).
[[nodiscard]] inline double sphere_irradiance(double distance, double radius, double cosine) {
    const double sine_squared = (radius / distance) * (radius / distance);
    if (cosine * cosine > sine_squared) return std::numbers::pi * sine_squared * std::max(cosine, 0.0);
    const double sine = std::sqrt(1 - cosine * cosine);
    const double x = std::sqrt(1 / sine_squared - 1), y = -x * cosine / sine;
    const double s = sine * std::sqrt(std::max(0.0, 1 - y * y));
    return (cosine * std::acos(std::clamp(y, -1.0, 1.0)) - x * s) * sine_squared + std::atan(s / x);
}

}  // namespace lantern::exact
