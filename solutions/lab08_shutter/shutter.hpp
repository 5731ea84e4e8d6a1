// SPDX-License-Identifier: MIT
#pragma once
// Lab 08: the shutter is open for a while, and things move. The handout is README.md in this folder.

#include <lantern/todo.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

namespace lab08 {

/// A ray that was shot at one moment. t counts in units of the direction, which may have any length but zero.
struct timed_ray {
    glm::vec3 origin;
    glm::vec3 direction;
    float time;
};

/// A sphere that moves evenly along a line: `center` is where it is at time 0, `velocity` the way in one unit of time.
struct moving_sphere {
    glm::vec3 center;
    glm::vec3 velocity;
    float radius;
};

/// Step 1. A moment of the exposure: xi from 0 to 1 runs from the opening of the shutter to its closing.
[[nodiscard]] inline float moment(float open, float close, float xi) {
    // BEGIN SOLUTION
    return float(double(open) + double(xi) * (double(close) - double(open)));  // in double: rounding never leads beyond `close`
    // END SOLUTION
    // STARTER: return lantern::todo("lab08 step 1: a moment of the exposure");
}

/// Step 2. Where the ray meets the sphere as it stands at the ray's time: the smallest t > 0. Nothing when it misses.
[[nodiscard]] inline std::optional<float> intersect(const moving_sphere& s, const timed_ray& r) {
    // BEGIN SOLUTION
    const glm::dvec3 center = glm::dvec3(s.center) + double(r.time) * glm::dvec3(s.velocity);
    const glm::dvec3 d(r.direction), from_center = glm::dvec3(r.origin) - center;
    const double a = glm::dot(d, d), b = glm::dot(from_center, d), c = glm::dot(from_center, from_center) - double(s.radius) * double(s.radius);
    const double discriminant = b * b - a * c;
    if (!(discriminant >= 0)) return std::nullopt;
    const double root = std::sqrt(discriminant);
    if (-b - root > 0) return float((-b - root) / a);
    if (-b + root > 0) return float((-b + root) / a);
    return std::nullopt;
    // END SOLUTION
    // STARTER: lantern::todo("lab08 step 2: a moving sphere");
}

/// Step 3. The lower and the upper corner of the smallest box around all the places that the sphere takes up while the
/// shutter is open. open <= close.
[[nodiscard]] inline std::pair<glm::vec3, glm::vec3> bounds(const moving_sphere& s, float open, float close) {
    // BEGIN SOLUTION
    const glm::vec3 first = s.center + open * s.velocity, last = s.center + close * s.velocity;
    return {glm::min(first, last) - s.radius, glm::max(first, last) + s.radius};
    // END SOLUTION
    // STARTER: return lantern::todo("lab08 step 3: bounds over the whole exposure");
}

/// Step 4. The rays that go on from a point which `r` has met: to a light (its direction leads to the light, at t = 1);
/// reflected; refracted. `normal` has length 1 and is on the side from which r comes; eta is the index of refraction on that
/// side, divided by that of the other. Directions keep the length of r's. Beyond the critical angle there is no refracted ray.
[[nodiscard]] inline timed_ray shadow_ray(const timed_ray& r, glm::vec3 point, glm::vec3 light) {
    // BEGIN SOLUTION
    return {point, light - point, r.time};
    // END SOLUTION
    // STARTER: return lantern::todo("lab08 step 4: a shadow ray has a time too");
}
[[nodiscard]] inline timed_ray reflected_ray(const timed_ray& r, glm::vec3 point, glm::vec3 normal) {
    // BEGIN SOLUTION
    return {point, glm::reflect(r.direction, normal), r.time};
    // END SOLUTION
    // STARTER: return lantern::todo("lab08 step 4: a reflected ray has a time too");
}
[[nodiscard]] inline std::optional<timed_ray> refracted_ray(const timed_ray& r, glm::vec3 point, glm::vec3 normal, float eta) {
    // BEGIN SOLUTION
    const float length = glm::length(r.direction);
    const glm::vec3 direction = glm::refract(r.direction / length, normal, eta);
    if (direction == glm::vec3(0)) return std::nullopt;  // so GLM says: total reflection
    return timed_ray{point, length * direction, r.time};
    // END SOLUTION
    // STARTER: lantern::todo("lab08 step 4: a refracted ray has a time too");
}

/// Step 5. The moments of a pixel's samples. The exposure is divided into as many equal stretches as there are samples;
/// sample i gets a moment within stretch order[i], where xi[i] says. `order` is a permutation of 0, 1, 2 ... that has nothing
/// to do with the samples' places in the pixel. Throws std::invalid_argument unless both have the same size.
[[nodiscard]] inline std::vector<float> times(float open, float close, std::span<const std::uint32_t> order, std::span<const float> xi) {
    // BEGIN SOLUTION
    if (order.size() != xi.size()) throw std::invalid_argument("times: each sample needs a stretch of the exposure and a number");
    std::vector<float> result;
    for (std::size_t i = 0; i < order.size(); ++i)
        result.push_back(moment(open, close, (float(order[i]) + xi[i]) / float(order.size())));
    return result;
    // END SOLUTION
    // STARTER: return lantern::todo("lab08 step 5: moments in order, but not in this one");
}

/// Step 6. The part of the exposure, 0 to 1, during which a moving disc covers the point. The disc's middle is at `center` at
/// time 0. When the shutter closes as it opens, the answer is 1 or 0.
[[nodiscard]] inline float covered(glm::vec2 point, glm::vec2 center, glm::vec2 velocity, float radius, float open, float close) {
    // BEGIN SOLUTION
    // The disc's edge passes the point at the roots of |q - v t|² = R².
    const glm::dvec2 q = glm::dvec2(point) - glm::dvec2(center), v(velocity);
    const auto covers = [&](double t) { return glm::length(q - t * v) <= double(radius); };
    const double a = glm::dot(v, v), b = glm::dot(q, v), c = glm::dot(q, q) - double(radius) * double(radius);
    if (a == 0 || close == open) return covers(open) ? 1.0f : 0.0f;
    const double discriminant = b * b - a * c;
    if (!(discriminant > 0)) return 0;
    const double enters = std::max((b - std::sqrt(discriminant)) / a, double(open));
    const double leaves = std::min((b + std::sqrt(discriminant)) / a, double(close));
    return float(std::max(leaves - enters, 0.0) / (double(close) - double(open)));
    // END SOLUTION
    // STARTER: return lantern::todo("lab08 step 6: the profile of a moving disc");
}

}  // namespace lab08
