// SPDX-License-Identifier: MIT
// A plane is infinite, so it has no bounds, and no hierarchy of bounding volumes can hold it.
// must say: bounded

#include <lantern/bvh.hpp>
#include <lantern/plane.hpp>
#include <lantern/sphere.hpp>

#include <vector>

#ifdef FIXED
const std::vector<lantern::sphere> surfaces;
#else
const std::vector<lantern::plane> surfaces;
#endif

const lantern::bvh tree{surfaces};
