// SPDX-License-Identifier: MIT
#pragma once
#include "only_wrong.hpp"

#define main other_main
