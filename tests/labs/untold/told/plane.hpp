// SPDX-License-Identifier: MIT
#pragma once
// The library's plane itself, and nobody is told: what the explained pixels must be equal to.

#include <lantern/plane.hpp>

namespace told = lantern;
