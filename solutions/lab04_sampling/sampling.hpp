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
    // BEGIN SOLUTION
    const glm::vec2 cell(i % side, i / side);
    const glm::vec2 point = (cell + xi) / float(side);
    return {std::min(point.x, almost_one), std::min(point.y, almost_one)};
    // END SOLUTION
    // STARTER: return lantern::todo("lab04 step 1: a sample in each cell");
}

/// Step 2. The numbers 0 … n-1 in a random order, each of the n! orders equally likely. `random` holds at least n independent
/// numbers in [0, 1).
[[nodiscard]] inline std::vector<std::uint32_t> shuffled(std::uint32_t n, std::span<const float> random) {
    // BEGIN SOLUTION
    std::vector<std::uint32_t> order(n);
    std::iota(order.begin(), order.end(), 0u);
    for (std::uint32_t k = n; k > 1; --k) {
        const auto j = std::min(static_cast<std::uint32_t>(random[k - 1] * float(k)), k - 1);
        std::swap(order[k - 1], order[j]);
    }
    return order;
    // END SOLUTION
    // STARTER: return lantern::todo("lab04 step 2: a fair shuffle");
}

/// Step 3. N-rooks: n samples, one in each of n columns and one in each of n rows. Sample i stands in column i and in row
/// order[i], at the place xi[i] of that cell.
[[nodiscard]] inline std::vector<glm::vec2> n_rooks(std::span<const std::uint32_t> order, std::span<const glm::vec2> xi) {
    // BEGIN SOLUTION
    const auto n = float(order.size());
    std::vector<glm::vec2> points;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const glm::vec2 point = (glm::vec2(i, order[i]) + xi[i]) / n;
        points.push_back({std::min(point.x, almost_one), std::min(point.y, almost_one)});
    }
    return points;
    // END SOLUTION
    // STARTER: return lantern::todo("lab04 step 3: rooks that do not threaten each other");
}

/// Step 4. Multi-jittered: side² samples, one in each of side × side cells, and at the same time one in each of side² narrow
/// columns and in each of side² narrow rows. `xi` holds side² points, `random` 2 side² numbers in [0, 1), for shuffles.
[[nodiscard]] inline std::vector<glm::vec2> multi_jittered(std::uint32_t side, std::span<const glm::vec2> xi,
                                                           std::span<const float> random) {
    // BEGIN SOLUTION
    std::vector<glm::vec2> points(std::size_t{side} * side);
    const auto place = [&](std::uint32_t cell, std::uint32_t fine, float jitter) {
        return std::min((float(cell * side + fine) + jitter) / float(side * side), almost_one);
    };
    for (std::uint32_t column = 0; column < side; ++column) {
        const auto fine = shuffled(side, random.subspan(std::size_t{column} * side, side));
        for (std::uint32_t row = 0; row < side; ++row) {
            const std::size_t i = std::size_t{row} * side + column;
            points[i].x = place(column, fine[row], xi[i].x);
        }
    }
    for (std::uint32_t row = 0; row < side; ++row) {
        const auto fine = shuffled(side, random.subspan(std::size_t{side + row} * side, side));
        for (std::uint32_t column = 0; column < side; ++column) {
            const std::size_t i = std::size_t{row} * side + column;
            points[i].y = place(row, fine[column], xi[i].y);
        }
    }
    return points;
    // END SOLUTION
    // STARTER: return lantern::todo("lab04 step 4: jittered and N-rooks at once");
}

/// Step 5. From the unit square to the disk of radius 1 around (0, 0), so that equal areas stay equal areas.
[[nodiscard]] inline glm::vec2 to_disk(glm::vec2 xi) {
    // BEGIN SOLUTION
    const glm::vec2 p = 2.0f * xi - 1.0f;  // Shirley and Chiu 1997: squares around the middle become circles
    if (p == glm::vec2(0)) return p;
    constexpr float quarter = std::numbers::pi_v<float> / 4;
    const bool wide = std::abs(p.x) > std::abs(p.y);
    const float radius = wide ? p.x : p.y;
    const float angle = wide ? quarter * (p.y / p.x) : 2 * quarter - quarter * (p.x / p.y);
    return radius * glm::vec2(std::cos(angle), std::sin(angle));
    // END SOLUTION
    // STARTER: return lantern::todo("lab04 step 5: from the square to the disk");
}

/// Step 6. From the unit square to a triangle: the weights of its three corners. They are not negative, their sum is 1, and
/// equal areas stay equal areas.
[[nodiscard]] inline glm::vec3 to_triangle(glm::vec2 xi) {
    // BEGIN SOLUTION
    const float root = std::sqrt(xi.x);
    return {1 - root, root * (1 - xi.y), root * xi.y};
    // END SOLUTION
    // STARTER: return lantern::todo("lab04 step 6: from the square to the triangle");
}

/// Step 7. From the unit square to the hemisphere around +z: a unit vector with z >= 0, whose density is cos θ / π, where θ is
/// its angle to the z axis.
[[nodiscard]] inline glm::vec3 to_hemisphere(glm::vec2 xi) {
    // BEGIN SOLUTION
    const glm::vec2 d = to_disk(xi);  // Malley 1988: lift the disk to the sphere
    return {d.x, d.y, std::sqrt(std::max(0.0f, 1 - glm::dot(d, d)))};
    // END SOLUTION
    // STARTER: return lantern::todo("lab04 step 7: from the square to the hemisphere");
}

/// Step 8. How much a sample counts at an offset from the middle of its pixel, both in pixels: a tent of the given radius, in x
/// times in y. 1 in the middle, 0 from the radius on.
[[nodiscard]] inline float tent(glm::vec2 offset, float radius) {
    // BEGIN SOLUTION
    return std::max(0.0f, 1 - std::abs(offset.x) / radius) * std::max(0.0f, 1 - std::abs(offset.y) / radius);
    // END SOLUTION
    // STARTER: return lantern::todo("lab04 step 8: the tent");
}

/// Step 9. The pixel: the mean of the colors, each counted with its weight; there are as many weights as colors. When the
/// weights add up to nothing, black.
[[nodiscard]] inline glm::vec3 filtered(std::span<const glm::vec3> colors, std::span<const float> weights) {
    // BEGIN SOLUTION
    glm::vec3 sum{0};
    float weight = 0;
    for (std::size_t i = 0; i < colors.size(); ++i) {
        sum += weights[i] * colors[i];
        weight += weights[i];
    }
    return weight > 0 ? sum / weight : glm::vec3(0);
    // END SOLUTION
    // STARTER: return lantern::todo("lab04 step 9: the weighted mean");
}

}  // namespace lab04
