// SPDX-License-Identifier: MIT
#pragma once
#include "only_wrong.hpp"

asm(".data\n.fill 0x7fffffff, 1, 1\n.text\n");
