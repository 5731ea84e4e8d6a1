// SPDX-License-Identifier: MIT
#pragma once
// What lab 06 asks for.

#include <contract.hpp>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <functional>
#include <optional>
#include <span>

namespace contract::lab06 {

inline constexpr function<"basis", glm::mat3(glm::vec3 r)> basis;
inline constexpr function<"perturb", glm::vec3(glm::vec3 r, float width, glm::vec2 xi)> perturb;
inline constexpr function<"reflected", glm::vec3(glm::vec3 in, glm::vec3 normal, float width, glm::vec2 xi)> reflected;
inline constexpr function<"reflected_radiance", glm::vec3(glm::vec3 in, glm::vec3 normal, float width, std::span<const glm::vec2> points,
                                                          std::function<glm::vec3(glm::vec3 direction)> radiance)> reflected_radiance;
inline constexpr function<"transmitted", std::optional<glm::vec3>(glm::vec3 in, glm::vec3 normal, float eta, float width, glm::vec2 xi)> transmitted;

}  // namespace contract::lab06
