// SPDX-License-Identifier: MIT
#pragma once
// What lab 04 asks for.

#include <contract.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace contract::lab04 {

using points = std::vector<glm::vec2>;

inline constexpr function<"jittered", glm::vec2(std::uint32_t i, std::uint32_t side, glm::vec2 xi)> jittered;
inline constexpr function<"shuffled", std::vector<std::uint32_t>(std::uint32_t n, std::span<const float> random)> shuffled;
inline constexpr function<"n_rooks", points(std::span<const std::uint32_t> order, std::span<const glm::vec2> xi)> n_rooks;
inline constexpr function<"multi_jittered", points(std::uint32_t side, std::span<const glm::vec2> xi, std::span<const float> random)>
    multi_jittered;
inline constexpr function<"to_disk", glm::vec2(glm::vec2 xi)> to_disk;
inline constexpr function<"to_triangle", glm::vec3(glm::vec2 xi)> to_triangle;
inline constexpr function<"to_hemisphere", glm::vec3(glm::vec2 xi)> to_hemisphere;
inline constexpr function<"tent", float(glm::vec2 offset, float radius)> tent;
inline constexpr function<"filtered", glm::vec3(std::span<const glm::vec3> colors, std::span<const float> weights)> filtered;

}  // namespace contract::lab04
