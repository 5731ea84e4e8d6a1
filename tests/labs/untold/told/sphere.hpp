// SPDX-License-Identifier: MIT
#pragma once
// The library's sphere itself, and nobody is told: what the explained pixels must be equal to.

#include <lantern/sphere.hpp>

namespace told = lantern;
