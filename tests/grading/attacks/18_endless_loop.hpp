// SPDX-License-Identifier: MIT
#pragma once
// Right everywhere but in step 1, which never ends. The loop costs that step, and the steps that rest on it are the student's own to lose.
#include "right.hpp"

namespace lab06 {

using right::perturb;
using right::reflected;
using right::reflected_radiance;
using right::transmitted;

inline glm::mat3 basis(glm::vec3 r) {
    volatile bool forever = true;
    while (forever) {}
    return right::basis(r);
}

}  // namespace lab06
