// SPDX-License-Identifier: MIT
#pragma once
// A sample source that writes down what is asked of it: the proof that absent effects draw nothing.

#include <lantern/samples.hpp>

#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>

/// How many numbers were drawn for each purpose.
struct draws {
    std::array<int, 64> by_purpose{};

    [[nodiscard]] int of(lantern::purpose p) const { return by_purpose[static_cast<std::size_t>(p)]; }
    [[nodiscard]] int total() const { return std::accumulate(by_purpose.begin(), by_purpose.end(), 0); }
};

/// Answers every question with the same numbers, and counts.
struct counting_source {
    draws* counted;
    float one = 0.5f;
    glm::vec2 two{0.25f, 0.75f};

    [[nodiscard]] float draw1(lantern::purpose p, std::uint32_t = 0) const {
        counted->by_purpose[static_cast<std::size_t>(p)] += 1;
        return one;
    }
    [[nodiscard]] glm::vec2 draw2(lantern::purpose p, std::uint32_t = 0) const {
        counted->by_purpose[static_cast<std::size_t>(p)] += 2;
        return two;
    }
    [[nodiscard]] counting_source branch(std::uint32_t) const { return *this; }
};
