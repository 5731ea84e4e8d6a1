// SPDX-License-Identifier: MIT
// A camera takes its lens before its shutter; a shutter in the lens's place is no lens.
// must say: lens

#include <lantern/camera.hpp>

int main() {
#ifndef FIXED
    const lantern::camera cam{lantern::view{}, lantern::shutter{}};
#else
    const lantern::camera cam{lantern::view{}, lantern::pinhole{}, lantern::shutter{}};
#endif
    (void)cam;
}
