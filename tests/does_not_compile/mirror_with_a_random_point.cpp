// SPDX-License-Identifier: MIT
// A mirror needs no random numbers, so it takes none, and none are drawn for it.
// must say: scatter

#include <lantern/mirror.hpp>

auto reflected(glm::vec3 in, const lantern::hit& h) {
#ifdef FIXED
    return scatter(lantern::mirror{}, in, h);
#else
    return scatter(lantern::mirror{}, in, h, glm::vec2(0.5f));
#endif
}
