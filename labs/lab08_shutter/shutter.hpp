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
    return lantern::todo("lab08 step 1: a moment of the exposure");
}

/// Step 2. Where the ray meets the sphere as it stands at the ray's time: the smallest t > 0. Nothing when it misses.
[[nodiscard]] inline std::optional<float> intersect(const moving_sphere& s, const timed_ray& r) {
    lantern::todo("lab08 step 2: a moving sphere");
}

/// Step 3. The lower and the upper corner of the smallest box around all the places that the sphere takes up while the
/// shutter is open. open <= close.
[[nodiscard]] inline std::pair<glm::vec3, glm::vec3> bounds(const moving_sphere& s, float open, float close) {
    return lantern::todo("lab08 step 3: bounds over the whole exposure");
}

/// Step 4. The rays that go on from a point which `r` has met: to a light (its direction leads to the light, at t = 1);
/// reflected; refracted. `normal` has length 1 and is on the side from which r comes; eta is the index of refraction on that
/// side, divided by that of the other. Directions keep the length of r's. Beyond the critical angle there is no refracted ray.
[[nodiscard]] inline timed_ray shadow_ray(const timed_ray& r, glm::vec3 point, glm::vec3 light) {
    return lantern::todo("lab08 step 4: a shadow ray has a time too");
}
[[nodiscard]] inline timed_ray reflected_ray(const timed_ray& r, glm::vec3 point, glm::vec3 normal) {
    return lantern::todo("lab08 step 4: a reflected ray has a time too");
}
[[nodiscard]] inline std::optional<timed_ray> refracted_ray(const timed_ray& r, glm::vec3 point, glm::vec3 normal, float eta) {
    lantern::todo("lab08 step 4: a refracted ray has a time too");
}

/// Step 5. The moments of a pixel's samples. The exposure is divided into as many equal stretches as there are samples;
/// sample i gets a moment within stretch order[i], where xi[i] says. `order` is a permutation of 0, 1, 2 ... that has nothing
/// to do with the samples' places in the pixel. Throws std::invalid_argument unless both have the same size.
[[nodiscard]] inline std::vector<float> times(float open, float close, std::span<const std::uint32_t> order, std::span<const float> xi) {
    return lantern::todo("lab08 step 5: moments in order, but not in this one");
}

/// Step 6. The part of the exposure, 0 to 1, during which a moving disc covers the point. The disc's middle is at `center` at
/// time 0. When the shutter closes as it opens, the answer is 1 or 0.
[[nodiscard]] inline float covered(glm::vec2 point, glm::vec2 center, glm::vec2 velocity, float radius, float open, float close) {
    return lantern::todo("lab08 step 6: the profile of a moving disc");
}

}  // namespace lab08
