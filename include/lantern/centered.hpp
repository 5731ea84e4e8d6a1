// SPDX-License-Identifier: MIT
#pragma once
// One sample for everything, in the middle: no random numbers at all.

#include <lantern/samples.hpp>

#include <glm/vec2.hpp>

#include <cstdint>

namespace lantern {

/// A sampler of one sample, whose numbers are all 1/2: one ray through the middle of each pixel, towards the middle of
/// each light, through the middle of the lens, at half the exposure. The picture of 1980: sharp everywhere, and jagged.
struct centered {
    struct source {
        [[nodiscard]] static float draw1(purpose, std::uint32_t = 0) { return 0.5f; }
        [[nodiscard]] static glm::vec2 draw2(purpose, std::uint32_t = 0) { return glm::vec2(0.5f); }
        [[nodiscard]] static source branch(std::uint32_t) { return {}; }
    };

    [[nodiscard]] static std::uint32_t count() { return 1; }
    [[nodiscard]] static source at(glm::uvec2, std::uint32_t) { return {}; }
};

static_assert(sampler<centered>);

}  // namespace lantern
