// SPDX-License-Identifier: MIT
#pragma once
// The library's rectangle itself, and nobody is told: what the explained pixels must be equal to.

#include <lantern/rectangle.hpp>

namespace told = lantern;
