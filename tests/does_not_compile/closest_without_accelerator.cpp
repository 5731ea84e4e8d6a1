// SPDX-License-Identifier: MIT
// What stands first in `closest` must be able to offer surfaces along a ray.
// must say: accelerator

#include <lantern/closest.hpp>
#include <lantern/sphere.hpp>

#include <vector>

auto meet(const std::vector<lantern::sphere>& surfaces) {
#ifdef FIXED
    return lantern::closest(lantern::every{1}, surfaces, lantern::ray{});
#else
    return lantern::closest(surfaces, surfaces, lantern::ray{});
#endif
}
