// SPDX-License-Identifier: MIT
// No volume holds a plane.
// must say: bounded

#include <lantern/plane.hpp>
#include <lantern/sphere.hpp>
#include <lantern/within.hpp>

#ifdef FIXED
const auto thing = lantern::put_within<lantern::aabb>(lantern::sphere{});
#else
const auto thing = lantern::put_within<lantern::aabb>(lantern::plane{});
#endif
