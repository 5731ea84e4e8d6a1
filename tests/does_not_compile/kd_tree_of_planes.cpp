// SPDX-License-Identifier: MIT
// A plane is infinite, so it has no bounds, and no cell can hold it.
// must say: bounded

#include <lantern/kd_tree.hpp>
#include <lantern/plane.hpp>
#include <lantern/sphere.hpp>

#include <vector>

#ifdef FIXED
const std::vector<lantern::sphere> surfaces;
#else
const std::vector<lantern::plane> surfaces;
#endif

const lantern::kd_tree cells{surfaces};
