// SPDX-License-Identifier: MIT
#pragma once
// No attack: the wrong answers alone. What these earn, and no more, may an attack on top of them earn.
#include "only_wrong.hpp"
