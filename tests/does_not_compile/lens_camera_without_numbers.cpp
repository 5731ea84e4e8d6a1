// SPDX-License-Identifier: MIT
// Only a pinhole without a shutter shoots without a source of numbers.
// must say: shoot

#include <lantern/camera.hpp>

int main() {
#ifndef FIXED
    const lantern::camera cam{lantern::view{}, lantern::thin_lens{.radius = 0.1f}};
#else
    const lantern::camera cam{lantern::view{}};
#endif
    (void)shoot(cam, glm::vec2{0.5f});
}
