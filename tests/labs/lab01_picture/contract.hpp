// SPDX-License-Identifier: MIT
#pragma once
// What lab 01 asks for.

#include <contract.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <string>

namespace contract::lab01 {

inline constexpr function<"direction", glm::vec3(glm::uvec2 pixel, glm::uvec2 size, float fov)> direction;
inline constexpr function<"encode", float(float linear)> encode;
inline constexpr function<"quantise", std::uint8_t(float encoded)> quantise;
inline constexpr function<"ppm", std::string(glm::uvec2 size, std::span<const glm::vec3> pixels)> ppm;

}  // namespace contract::lab01
