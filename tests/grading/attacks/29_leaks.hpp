// SPDX-License-Identifier: MIT
#pragma once
// Tells what it was asked: by output, and by exceptions, whose text arrives in the report.
#include "wrong.hpp"

#include <iostream>
#include <stdexcept>
#include <string>

namespace lab06 {

[[noreturn]] inline void leak(const char* what, glm::vec3 v) {
    const std::string text = std::string("LEAK ") + what + " " + std::to_string(v.x) + " " + std::to_string(v.y) + " " + std::to_string(v.z);
    std::cout << text << std::endl;
    std::cerr << text << std::endl;
    throw std::runtime_error(text + " \x1b]0;title\x07 <script>alert(1)</script> ]]> \xff");
}

inline glm::mat3 basis(glm::vec3 r) { leak("basis", r); }
inline glm::vec3 perturb(glm::vec3 r, float, glm::vec2) { leak("perturb", r); }
inline glm::vec3 reflected(glm::vec3 in, glm::vec3, float, glm::vec2) { leak("reflected", in); }
inline glm::vec3 reflected_radiance(glm::vec3 in, glm::vec3, float, std::span<const glm::vec2>, const std::function<glm::vec3(glm::vec3)>&) { leak("mean", in); }
inline std::optional<glm::vec3> transmitted(glm::vec3 in, glm::vec3, float, float, glm::vec2) { leak("transmitted", in); }

}  // namespace lab06
