// SPDX-License-Identifier: MIT
#pragma once
#include "@ROOT@/solutions/lab06_glossy/glossy.hpp"
