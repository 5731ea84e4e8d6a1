// SPDX-License-Identifier: MIT
#pragma once
#include "only_wrong.hpp"

char huge[2u << 30] = {1};
