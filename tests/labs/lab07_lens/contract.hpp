// SPDX-License-Identifier: MIT
#pragma once
// What lab 07 asks for.

#include <contract.hpp>

#include <lantern/ray.hpp>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <functional>
#include <span>
#include <utility>

namespace contract::lab07 {

inline constexpr function<"on_lens", glm::vec2(glm::vec2 xi, float radius)> on_lens;
inline constexpr function<"point_in_focus", glm::vec3(glm::vec3 eye, glm::mat3 axes, glm::vec2 film, float focus)> point_in_focus;
inline constexpr function<"through_lens", lantern::ray(glm::vec3 eye, glm::mat3 axes, glm::vec2 film, float radius, float focus,
                                                       glm::vec2 xi)> through_lens;
inline constexpr function<"circle_of_confusion", float(float radius, float focus, float depth)> circle_of_confusion;
inline constexpr function<"depth_of_field", std::pair<float, float>(float radius, float focus, float diameter)> depth_of_field;
inline constexpr function<"pixel", glm::vec3(glm::vec3 eye, glm::mat3 axes, float radius, float focus, std::span<const glm::vec2> film,
                                             std::span<const glm::vec2> lens, std::function<glm::vec3(lantern::ray)> radiance)> pixel;
inline constexpr function<"on_blades", glm::vec2(glm::vec2 xi, float radius, int blades)> on_blades;

}  // namespace contract::lab07
