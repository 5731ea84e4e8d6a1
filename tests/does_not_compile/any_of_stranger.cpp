// SPDX-License-Identifier: MIT
// any_of is a closed choice: what is not among its alternatives is refused.
// must say: any_of
#include <lantern/any_of.hpp>
#include <lantern/disk.hpp>
#include <lantern/rectangle.hpp>
#include <lantern/sphere.hpp>

int main() {
    using shape = lantern::any_of<lantern::sphere, lantern::rectangle>;
#ifndef FIXED
    const shape s = lantern::disk{};
#else
    const shape s = lantern::rectangle{};
#endif
    return intersect(s, lantern::ray{}, lantern::interval{}).has_value();
}
