// SPDX-License-Identifier: MIT
#pragma once
#include "only_wrong.hpp"

constexpr unsigned long endless() {
    unsigned long n = 0;
    for (unsigned long i = 1; i != 0; ++i) n += i;
    return n;
}
constexpr unsigned long never = endless();
