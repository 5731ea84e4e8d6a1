// SPDX-License-Identifier: MIT
#pragma once
// Lab 04: well-placed points in the unit square, and where to carry them. The handout is README.md in this folder.

#include <lantern/todo.hpp>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace lab04 {

/// Given: the largest float below 1. A coordinate (7 + 0.99999994) / 8 is rounded to 1, which is outside: use min.
inline constexpr float almost_one = 0x1.fffffep-1f;

/// Step 1. The sample of cell i in a grid of side × side cells: xi, a point of the unit square, placed in the cell. Cells are
/// counted along x first: cell 1 is right of cell 0. All coordinates are in [0, 1).
[[nodiscard]] inline glm::vec2 jittered(std::uint32_t i, std::uint32_t side, glm::vec2 xi) {
    return lantern::todo("lab04 step 1: a sample in each cell");
}

/// Step 2. The numbers 0 … n-1 in a random order, each of the n! orders equally likely. `random` holds at least n independent
/// numbers in [0, 1).
[[nodiscard]] inline std::vector<std::uint32_t> shuffled(std::uint32_t n, std::span<const float> random) {
    return lantern::todo("lab04 step 2: a fair shuffle");
}

/// Step 3. N-rooks: n samples, one in each of n columns and one in each of n rows. Sample i stands in column i and in row
/// order[i], at the place xi[i] of that cell.
[[nodiscard]] inline std::vector<glm::vec2> n_rooks(std::span<const std::uint32_t> order, std::span<const glm::vec2> xi) {
    return lantern::todo("lab04 step 3: rooks that do not threaten each other");
}

/// Step 4. Multi-jittered: side² samples, one in each of side × side cells, and at the same time one in each of side² narrow
/// columns and in each of side² narrow rows. `xi` holds side² points, `random` 2 side² numbers in [0, 1), for shuffles.
[[nodiscard]] inline std::vector<glm::vec2> multi_jittered(std::uint32_t side, std::span<const glm::vec2> xi,
                                                           std::span<const float> random) {
    return lantern::todo("lab04 step 4: jittered and N-rooks at once");
}

/// Step 5. From the unit square to the disk of radius 1 around (0, 0), so that equal areas stay equal areas.
[[nodiscard]] inline glm::vec2 to_disk(glm::vec2 xi) {
    return lantern::todo("lab04 step 5: from the square to the disk");
}

/// Step 6. From the unit square to a triangle: the weights of its three corners. They are not negative, their sum is 1, and
/// equal areas stay equal areas.
[[nodiscard]] inline glm::vec3 to_triangle(glm::vec2 xi) {
    return lantern::todo("lab04 step 6: from the square to the triangle");
}

/// Step 7. From the unit square to the hemisphere around +z: a unit vector with z >= 0, whose density is cos θ / π, where θ is
/// its angle to the z axis.
[[nodiscard]] inline glm::vec3 to_hemisphere(glm::vec2 xi) {
    return lantern::todo("lab04 step 7: from the square to the hemisphere");
}

/// Step 8. How much a sample counts at an offset from the middle of its pixel, both in pixels: a tent of the given radius, in x
/// times in y. 1 in the middle, 0 from the radius on.
[[nodiscard]] inline float tent(glm::vec2 offset, float radius) {
    return lantern::todo("lab04 step 8: the tent");
}

/// Step 9. The pixel: the mean of the colors, each counted with its weight; there are as many weights as colors. When the
/// weights add up to nothing, black.
[[nodiscard]] inline glm::vec3 filtered(std::span<const glm::vec3> colors, std::span<const float> weights) {
    return lantern::todo("lab04 step 9: the weighted mean");
}

}  // namespace lab04
