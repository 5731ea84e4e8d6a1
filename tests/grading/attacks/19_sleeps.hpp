// SPDX-License-Identifier: MIT
#pragma once
#include "wrong.hpp"

#include <unistd.h>

namespace lab06 {

using wrong::perturb;
using wrong::reflected;
using wrong::reflected_radiance;
using wrong::transmitted;

inline glm::mat3 basis(glm::vec3) {
    for (;;) pause();
}

}  // namespace lab06
