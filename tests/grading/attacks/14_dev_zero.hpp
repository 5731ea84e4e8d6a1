// SPDX-License-Identifier: MIT
#pragma once
#include "only_wrong.hpp"
#include "/dev/zero"
