// SPDX-License-Identifier: MIT
#pragma once
#include "wrong.hpp"

#include <unistd.h>

namespace lab06 {

inline glm::mat3 basis(glm::vec3) { _exit(0); }
inline glm::vec3 perturb(glm::vec3, float, glm::vec2) { _exit(0); }
inline glm::vec3 reflected(glm::vec3, glm::vec3, float, glm::vec2) { _exit(0); }
inline glm::vec3 reflected_radiance(glm::vec3, glm::vec3, float, std::span<const glm::vec2>, const std::function<glm::vec3(glm::vec3)>&) { _exit(0); }
inline std::optional<glm::vec3> transmitted(glm::vec3, glm::vec3, float, float, glm::vec2) { _exit(0); }

}  // namespace lab06
