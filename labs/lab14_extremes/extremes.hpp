// SPDX-License-Identifier: MIT
#pragma once
// Lab 14: formulas that are right on paper, and right in a computer. The handout is README.md in this folder.

#include <lantern/double_double.hpp>
#include <lantern/ray.hpp>
#include <lantern/todo.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

namespace lab14 {

/// Unit vectors, perpendicular to each other, right-handed: u × v = w.
struct frame {
    glm::vec3 u{1, 0, 0}, v{0, 1, 0}, w{0, 0, 1};
};

/// The formulas of the textbooks, in float, as they are printed. Each is right on paper: you start from here.
namespace textbook {

inline constexpr float infinity = std::numeric_limits<float>::infinity();

/// "Ray Tracing in One Weekend": |o + t d - c|² = R², solved by the school's formula.
[[nodiscard]] inline std::optional<float> hit_sphere(glm::vec3 center, float radius, const lantern::ray& r) {
    const glm::vec3 oc = center - r.origin;
    const float a = glm::dot(r.direction, r.direction), h = glm::dot(r.direction, oc), c = glm::dot(oc, oc) - radius * radius;
    const float discriminant = h * h - a * c;
    if (discriminant < 0) return std::nullopt;
    const float root = std::sqrt(discriminant);
    for (const float t : {(h - root) / a, (h + root) / a})
        if (t > 0 && t < infinity) return t;
    return std::nullopt;
}

/// Möller and Trumbore 1997, with the epsilon that it is always copied with.
[[nodiscard]] inline std::optional<float> hit_triangle(glm::vec3 a, glm::vec3 b, glm::vec3 c, const lantern::ray& r) {
    const glm::vec3 e1 = b - a, e2 = c - a, p = glm::cross(r.direction, e2);
    const float determinant = glm::dot(e1, p);
    if (std::abs(determinant) < 1e-8f) return std::nullopt;
    const glm::vec3 s = r.origin - a, q = glm::cross(s, e1);
    const float u = glm::dot(s, p) / determinant, v = glm::dot(r.direction, q) / determinant;
    if (u < 0 || v < 0 || u + v > 1) return std::nullopt;
    const float t = glm::dot(e2, q) / determinant;
    return t > 0 && t < infinity ? std::optional(t) : std::nullopt;
}

/// "The Next Week": divide, swap, shrink.
[[nodiscard]] inline bool meets_box(glm::vec3 low, glm::vec3 high, const lantern::ray& r) {
    float near = 0, far = infinity;
    for (int i = 0; i < 3; ++i) {
        const float inverse = 1 / r.direction[i];
        float t0 = (low[i] - r.origin[i]) * inverse, t1 = (high[i] - r.origin[i]) * inverse;
        if (t0 > t1) std::swap(t0, t1);
        near = std::max(near, t0);
        far = std::min(far, t1);
        if (far <= near) return false;
    }
    return true;
}

/// A thousandth of a unit, "to avoid acne".
[[nodiscard]] inline glm::vec3 leave(glm::vec3 point, glm::vec3 /*normal*/, glm::vec3 direction) { return point + 1e-3f * direction; }

/// Frisvad 2012, for a w that is believed to have unit length.
[[nodiscard]] inline frame basis_around(glm::vec3 w) {
    if (w.z < -0.9999999f) return {{0, -1, 0}, {-1, 0, 0}, w};
    const float a = 1 / (1 + w.z), b = -w.x * w.y * a;
    return {{1 - w.x * w.x * a, b, -w.x}, {b, 1 - w.y * w.y * a, -w.y}, w};
}

struct accumulator {
    float sum = 0;
    std::uint64_t samples = 0;
};
inline void add(accumulator& a, float sample) { a.sum += sample, ++a.samples; }
[[nodiscard]] inline float mean(const accumulator& a) { return a.sum / static_cast<float>(a.samples); }

/// "Ray Tracing in One Weekend": sin² = 1 - cos². ratio: refractive index on the side that the light comes from, by that beyond.
[[nodiscard]] inline std::optional<glm::vec3> refracted(glm::vec3 in, glm::vec3 normal, float ratio) {
    const glm::vec3 d = glm::normalize(in), n = glm::normalize(normal);
    const float cosine = std::min(-glm::dot(d, n), 1.0f), sine = std::sqrt(1 - cosine * cosine);
    if (ratio * sine > 1) return std::nullopt;
    const glm::vec3 across = ratio * (d + cosine * n);
    return across - std::sqrt(std::abs(1 - glm::dot(across, across))) * n;
}

}  // namespace textbook

/// Step 1. The first t > 0 at which the ray meets the sphere, in units of the length of its direction, which may have any; rounded to float
/// once, at the end. Right for every sphere and ray of finite floats, be the radius 10¹² and the ray a unit above it.
[[nodiscard]] inline std::optional<float> hit_sphere(glm::vec3 center, float radius, const lantern::ray& r) {
    lantern::todo("lab14 step 1: a ray and a sphere");
}

/// Step 2. The t > 0 at which the ray meets the triangle, seen from either side. No ray passes between two triangles that share an edge, or among those around a
/// vertex. Only a triangle that the ray sees as a line or a point is missed.
[[nodiscard]] inline std::optional<float> hit_triangle(glm::vec3 a, glm::vec3 b, glm::vec3 c, const lantern::ray& r) {
    lantern::todo("lab14 step 2: a ray and a triangle");
}

/// Step 3. Whether the ray, t >= 0, meets the box; its faces, edges and corners belong to it, and it may be flat. Never a wrong no. A wrong yes costs only
/// time: it is allowed where a ray passes within a millionth of the box's distance. A box with low > high is empty.
[[nodiscard]] inline bool meets_box(glm::vec3 low, glm::vec3 high, const lantern::ray& r) {
    return lantern::todo("lab14 step 3: a ray and a box");
}

/// Step 4. The point of the sphere that is nearest to origin + t direction, t being rounded: rounded itself, once.
[[nodiscard]] inline glm::vec3 on_sphere(glm::vec3 center, float radius, const lantern::ray& r, float t) {
    return lantern::todo("lab14 step 4: back onto the sphere");
}

/// Step 4. The point of the plane through a, b, c that is nearest to origin + t direction, rounded once.
[[nodiscard]] inline glm::vec3 on_triangle(glm::vec3 a, glm::vec3 b, glm::vec3 c, const lantern::ray& r, float t) {
    return lantern::todo("lab14 step 4: back onto the triangle");
}

/// Step 4. Where a ray begins that leaves the surface at this point in that direction: on the side of the surface to which the
/// direction points, and not farther from it than 8 ulp of the point's largest coordinate. `point` is a point of the surface, rounded; `normal` is the
/// surface's, of unit length; `direction` has any length.
[[nodiscard]] inline glm::vec3 leave(glm::vec3 point, glm::vec3 normal, glm::vec3 direction) {
    return lantern::todo("lab14 step 4: leaving a surface");
}

/// Step 5. A frame whose w points along the given vector, which may have any length; of the zero vector, and of one that is not
/// finite, that of the axes.
[[nodiscard]] inline frame basis_around(glm::vec3 w) {
    return lantern::todo("lab14 step 5: a frame around any vector");
}

/// Step 6. What the samples of a pixel are added to, one by one. What `sum` is, and what else you keep, is for you to say.
struct accumulator {
    float sum = 0;
    std::uint64_t samples = 0;
    std::uint64_t rejected = 0;  ///< samples that were NaN or infinite: counted, never added
};

/// Step 6. Adds a sample.
inline void add(accumulator& a, float sample) {
    lantern::todo("lab14 step 6: a sum of many samples");
}

/// Step 6. The mean of the samples that were added, right to one ulp for 10⁸ of them; 0 when there was none.
[[nodiscard]] inline float mean(const accumulator& a) {
    return lantern::todo("lab14 step 6: a mean of many samples");
}

/// Step 7. The direction, of unit length, in which light goes on beyond a surface: Snell's law. `normal` is on the side that the light comes from;
/// `in` and `normal` have any length; ratio is the refractive index on that side, divided by that beyond. Nothing, when all of the
/// light is reflected: exactly when ratio · sin θ > 1.
[[nodiscard]] inline std::optional<glm::vec3> refracted(glm::vec3 in, glm::vec3 normal, float ratio) {
    lantern::todo("lab14 step 7: total reflection");
}

}  // namespace lab14
