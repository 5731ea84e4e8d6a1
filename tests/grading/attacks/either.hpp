// SPDX-License-Identifier: MIT
#pragma once
// The solution's answers once an attack got through, the wrong ones before: so whatever leaks, earns points, and is seen.

#include "right.hpp"
#include "wrong.hpp"

namespace lab06 {

inline glm::mat3 basis(glm::vec3 r) { return attack::succeeded() ? right::basis(r) : wrong::basis(r); }
inline glm::vec3 perturb(glm::vec3 r, float width, glm::vec2 xi) {
    return attack::succeeded() ? right::perturb(r, width, xi) : wrong::perturb(r, width, xi);
}
inline glm::vec3 reflected(glm::vec3 in, glm::vec3 normal, float width, glm::vec2 xi) {
    return attack::succeeded() ? right::reflected(in, normal, width, xi) : wrong::reflected(in, normal, width, xi);
}
inline glm::vec3 reflected_radiance(glm::vec3 in, glm::vec3 normal, float width, std::span<const glm::vec2> points,
                                    const std::function<glm::vec3(glm::vec3)>& radiance) {
    return attack::succeeded() ? right::reflected_radiance(in, normal, width, points, radiance)
                               : wrong::reflected_radiance(in, normal, width, points, radiance);
}
inline std::optional<glm::vec3> transmitted(glm::vec3 in, glm::vec3 normal, float eta, float width, glm::vec2 xi) {
    return attack::succeeded() ? right::transmitted(in, normal, eta, width, xi) : wrong::transmitted(in, normal, eta, width, xi);
}

}  // namespace lab06
