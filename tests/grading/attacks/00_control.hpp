// SPDX-License-Identifier: MIT
#pragma once
// No attack: shows that one that got through would earn full marks, and so be seen.

namespace attack {
inline bool succeeded() { return true; }
}  // namespace attack

#include "either.hpp"
