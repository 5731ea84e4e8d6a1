// SPDX-License-Identifier: MIT
#pragma once
// Wrong answers for lab 06: what stands under every attack. They pass no step.

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <functional>
#include <optional>
#include <span>

namespace wrong {

inline glm::mat3 basis(glm::vec3) { return glm::mat3(1); }
inline glm::vec3 perturb(glm::vec3 r, float, glm::vec2) { return r; }
inline glm::vec3 reflected(glm::vec3 in, glm::vec3, float, glm::vec2) { return -in; }
inline glm::vec3 reflected_radiance(glm::vec3 in, glm::vec3, float, std::span<const glm::vec2>, const std::function<glm::vec3(glm::vec3)>& radiance) {
    return 0.5f * radiance(in);
}
inline std::optional<glm::vec3> transmitted(glm::vec3 in, glm::vec3, float, float, glm::vec2) { return in; }

}  // namespace wrong
