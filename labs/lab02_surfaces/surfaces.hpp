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
    lantern::todo("lab02 step 1: where a ray meets a sphere");
}

/// All points p with normal · (p - point) = 0. The normal may have any length.
struct plane {
    glm::vec3 point{0};
    glm::vec3 normal{0, 1, 0};
};

/// Step 2. A plane is seen from both sides; its normal is the same from both.
[[nodiscard]] inline std::optional<lantern::hit> intersect(const plane& p, const lantern::ray& r, lantern::interval range) {
    lantern::todo("lab02 step 2: where a ray meets a plane");
}

struct triangle {
    glm::vec3 a{0}, b{1, 0, 0}, c{0, 1, 0};
};

/// Step 3. A triangle is seen from both sides. Its normal points to where a, b, c are seen counter-clockwise. A triangle
/// without area is never hit.
[[nodiscard]] inline std::optional<lantern::hit> intersect(const triangle& s, const lantern::ray& r, lantern::interval range) {
    lantern::todo("lab02 step 3: where a ray meets a triangle");
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
    lantern::todo("lab02 step 4: the closest hit");
}

}  // namespace lab02
