// SPDX-License-Identifier: MIT
// A sampler out of lab 13's pieces: `cells` says into how many columns and rows the square is divided, `stratum` which of the cells
// a sample takes. Where in the cell is ours to say.

#include "write.hpp"

#include <lab13_error/error.hpp>

#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>

namespace {

constexpr float almost_one = 0x1.fffffep-1f;

/// (cell + xi) / cells. The last cell ends below 1; what lies beyond it is the student's, and stays there.
float within(std::uint32_t cell, float xi, std::uint32_t cells) {
    const float x = (float(cell) + xi) / float(cells);
    return cell < cells ? std::min(x, almost_one) : x;
}

void own(const points::wanted& w, std::span<glm::vec2> set) {
    const auto count = static_cast<std::uint32_t>(set.size());
    const glm::uvec2 grid = w.numbers == 1 ? glm::uvec2(count, 1) : lab13::cells(count);
    if (grid.x == 0 || grid.y == 0)
        throw std::domain_error("cells(" + std::to_string(count) + ") is " + std::to_string(grid.x) + " by " + std::to_string(grid.y) +
                                ": there is no such grid");
    const auto xi = points::random_points(count, w.key);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t cell = lab13::stratum(i, count, w.purpose, w.pixel);
        // One number: a row of cells, and what is beyond it stays beyond it.
        const glm::uvec2 at = w.numbers == 1 ? glm::uvec2(cell, 0) : glm::uvec2(cell % grid.x, cell / grid.x);
        set[i] = {within(at.x, xi[i].x, grid.x), within(at.y, xi[i].y, grid.y)};
    }
}

constexpr std::array<points::pattern, 1> patterns{{{"cells and strata", own}}};

}  // namespace

int main(int argc, char** argv) { return points::write(argc, argv, patterns); }
