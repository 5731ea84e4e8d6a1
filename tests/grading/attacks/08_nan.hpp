// SPDX-License-Identifier: MIT
#pragma once
#include "wrong.hpp"

#include <limits>

namespace lab06 {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

inline glm::mat3 basis(glm::vec3) { return glm::mat3(glm::vec3(nan), glm::vec3(nan), glm::vec3(nan)); }
inline glm::vec3 perturb(glm::vec3, float, glm::vec2) { return glm::vec3(nan); }
inline glm::vec3 reflected(glm::vec3, glm::vec3, float, glm::vec2) { return glm::vec3(nan); }
inline glm::vec3 reflected_radiance(glm::vec3, glm::vec3, float, std::span<const glm::vec2> points, const std::function<glm::vec3(glm::vec3)>& radiance) {
    for (std::size_t i = 0; i < points.size(); ++i) radiance(glm::vec3(nan));
    return glm::vec3(nan);
}
inline std::optional<glm::vec3> transmitted(glm::vec3, glm::vec3, float, float, glm::vec2) { return glm::vec3(nan); }

}  // namespace lab06
