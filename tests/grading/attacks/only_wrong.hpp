// SPDX-License-Identifier: MIT
#pragma once
// Nothing but the wrong answers, for attacks that do not need to know whether they got through.

#include "wrong.hpp"

namespace lab06 {

using wrong::basis;
using wrong::perturb;
using wrong::reflected;
using wrong::reflected_radiance;
using wrong::transmitted;

}  // namespace lab06
