// SPDX-License-Identifier: MIT
#pragma once
// A sampler that hands out points which were made before, by whomever.

#include <lantern/hash.hpp>
#include <lantern/samples.hpp>

#include <glm/vec2.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

/// The points of one rendering: `count` for each pixel, row by row, of each purpose, one purpose after the other. Of a purpose that
/// takes one number only x is used. Any finite point does, be it outside the unit square: what comes of that is to be seen.
struct point_table {
    std::vector<lantern::purpose> purposes;
    glm::uvec2 size{1};
    std::uint32_t samples = 1;
    std::vector<glm::vec2> points;
};

/// Hands out a table's points to the first vertex of each path. All other numbers are independent of everything.
struct replayed {
    const point_table* table = nullptr;

    struct source {
        const point_table* table;
        std::size_t at;  ///< where the point of the table's first purpose stands
        std::uint64_t key;

        [[nodiscard]] glm::vec2 draw2(lantern::purpose p, std::uint32_t which = 0) const {
            const auto found = std::ranges::find(table->purposes, p);
            if (which == 0 && at < table->points.size() && found != table->purposes.end())
                return table->points[at + std::size_t(found - table->purposes.begin()) * table->size.x * table->size.y * table->samples];
            const std::uint64_t h = lantern::hash(key, static_cast<std::uint32_t>(p), which);
            return {lantern::to_unit(lantern::low(h)), lantern::to_unit(lantern::high(h))};
        }
        [[nodiscard]] float draw1(lantern::purpose p, std::uint32_t which = 0) const { return draw2(p, which).x; }
        [[nodiscard]] source branch(std::uint32_t k) const { return {table, table->points.size(), lantern::hash(key, k)}; }
    };

    [[nodiscard]] std::uint32_t count() const { return table->samples; }
    [[nodiscard]] source at(glm::uvec2 pixel, std::uint32_t i) const {
        const std::size_t place = (std::size_t{pixel.y} * table->size.x + pixel.x) * table->samples + i;
        return {table, place, lantern::hash(0, pixel.x, pixel.y, i)};
    }
};
static_assert(lantern::sampler<replayed>);
