// SPDX-License-Identifier: MIT
// Only a camera with a shutter shoots rays that know their time.
// must say: shade_for

#include <lantern/render.hpp>

int main() {
    const auto shade = [](const lantern::timed_ray& r, const auto&) { return glm::vec3(r.time); };
#ifndef FIXED
    const lantern::camera cam{lantern::view{}};
#else
    const lantern::camera cam{lantern::view{}, lantern::pinhole{}, lantern::shutter{}};
#endif
    (void)lantern::render({1, 1}, cam, lantern::jittered{}, shade);
}
