// SPDX-License-Identifier: MIT
// A sphere is a surface: hollow, and nothing is enclosed in it. What a tree is made of are bounding volumes.
// must say: bounding_volume

#include <lantern/bounding_sphere.hpp>
#include <lantern/bvh.hpp>
#include <lantern/sphere.hpp>

#include <vector>

const std::vector<lantern::sphere> surfaces;

#ifdef FIXED
const lantern::bvh<lantern::bounding_sphere> tree{surfaces};
#else
const lantern::bvh<lantern::sphere> tree{surfaces};
#endif
