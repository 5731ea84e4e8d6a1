// SPDX-License-Identifier: MIT
// Only a ray that knows its time can meet a surface that moves; a camera without a shutter shoots none.
// must say: surface

#include <lantern/closest.hpp>
#include <lantern/moving.hpp>
#include <lantern/sphere.hpp>

#include <vector>

#ifdef FIXED
using ray = lantern::timed_ray;
#else
using ray = lantern::ray;
#endif

auto meet(const std::vector<lantern::moving<lantern::sphere>>& surfaces) {
    return closest(lantern::every{1}, surfaces, ray{});
}
