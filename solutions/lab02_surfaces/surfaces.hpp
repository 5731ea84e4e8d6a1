// SPDX-License-Identifier: MIT
#pragma once
// Lab 02: where a ray meets a sphere, a plane, a triangle, and which of many it meets first. The handout is README.md in
// this folder.

#include <lantern/interval.hpp>
#include <lantern/ray.hpp>
#include <lantern/surface.hpp>
#include <lantern/todo.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>

namespace lab02 {

// Every `intersect` returns the first hit whose t lies in the range, or std::nullopt. The direction of the ray may have
// any length. Of lantern::hit fill in t, point and normal (unit length); `error` may stay 0.

struct sphere {
    glm::vec3 center{0};
    float radius = 1;
};

/// Step 1. The normal points away from the centre, also when the ray comes from inside.
[[nodiscard]] inline std::optional<lantern::hit> intersect(const sphere& s, const lantern::ray& r, lantern::interval range) {
    // BEGIN SOLUTION
    const glm::dvec3 direction(r.direction), from_centre = glm::dvec3(r.origin) - glm::dvec3(s.center);
    const double radius = s.radius;
    const double a = glm::dot(direction, direction);
    const double half_b = glm::dot(direction, from_centre);
    const double c = glm::dot(from_centre, from_centre) - radius * radius;
    const double discriminant = half_b * half_b - a * c;
    if (!(discriminant >= 0)) return std::nullopt;
    const double root = std::sqrt(discriminant);
    for (const double t : {(-half_b - root) / a, (-half_b + root) / a}) {
        if (!contains(range, float(t))) continue;
        const glm::dvec3 normal = glm::normalize(from_centre + t * direction);
        return lantern::hit{.t = float(t), .point = glm::vec3(glm::dvec3(s.center) + radius * normal), .normal = glm::vec3(normal)};
    }
    return std::nullopt;
    // END SOLUTION
    // STARTER: lantern::todo("lab02 step 1: where a ray meets a sphere");
}

/// All points p with normal · (p - point) = 0. The normal may have any length.
struct plane {
    glm::vec3 point{0};
    glm::vec3 normal{0, 1, 0};
};

/// Step 2. A plane is seen from both sides; its normal is the same from both.
[[nodiscard]] inline std::optional<lantern::hit> intersect(const plane& p, const lantern::ray& r, lantern::interval range) {
    // BEGIN SOLUTION
    const glm::dvec3 origin(r.origin), direction(r.direction), normal(p.normal);
    const double speed = glm::dot(normal, direction);
    if (speed == 0) return std::nullopt;
    const double t = glm::dot(normal, glm::dvec3(p.point) - origin) / speed;
    if (!contains(range, float(t))) return std::nullopt;
    return lantern::hit{.t = float(t), .point = glm::vec3(origin + t * direction), .normal = glm::vec3(glm::normalize(normal))};
    // END SOLUTION
    // STARTER: lantern::todo("lab02 step 2: where a ray meets a plane");
}

struct triangle {
    glm::vec3 a{0}, b{1, 0, 0}, c{0, 1, 0};
};

/// Step 3. A triangle is seen from both sides. Its normal points to where a, b, c are seen counter-clockwise. A triangle
/// without area is never hit.
[[nodiscard]] inline std::optional<lantern::hit> intersect(const triangle& s, const lantern::ray& r, lantern::interval range) {
    // BEGIN SOLUTION
    const glm::dvec3 direction(r.direction), a(s.a), ab = glm::dvec3(s.b) - a, ac = glm::dvec3(s.c) - a;
    const glm::dvec3 p = glm::cross(direction, ac);
    const double determinant = glm::dot(ab, p);
    if (determinant == 0) return std::nullopt;
    const glm::dvec3 from_a = glm::dvec3(r.origin) - a;
    const double u = glm::dot(from_a, p) / determinant;
    if (!(u >= 0)) return std::nullopt;
    const glm::dvec3 q = glm::cross(from_a, ab);
    const double v = glm::dot(direction, q) / determinant;
    if (!(v >= 0 && u + v <= 1)) return std::nullopt;
    const double t = glm::dot(ac, q) / determinant;
    if (!contains(range, float(t))) return std::nullopt;
    return lantern::hit{.t = float(t), .point = glm::vec3(a + u * ab + v * ac), .normal = glm::vec3(glm::normalize(glm::cross(ab, ac)))};
    // END SOLUTION
    // STARTER: lantern::todo("lab02 step 3: where a ray meets a triangle");
}

/// A hit, and which of the surfaces it is on.
struct nearest {
    lantern::hit at;
    std::uint32_t index = 0;
};

/// Step 4. The first hit of the ray with any of the surfaces within the range, or std::nullopt. Each surface is asked for
/// hits that are not farther than the nearest one found before. Of two at the same t the one with the smaller index counts.
template <lantern::surface Surface>
[[nodiscard]] std::optional<nearest> closest(std::span<const Surface> surfaces, const lantern::ray& r, lantern::interval range) {
    // BEGIN SOLUTION
    std::optional<nearest> best;
    for (std::uint32_t i = 0; i < surfaces.size(); ++i) {
        const auto h = intersect(surfaces[i], r, range);
        if (!h || (best && h->t == best->at.t)) continue;
        best = nearest{*h, i};
        range.max = h->t;
    }
    return best;
    // END SOLUTION
    // STARTER: lantern::todo("lab02 step 4: the closest hit");
}

}  // namespace lab02
