// SPDX-License-Identifier: MIT
// A shade is called from several threads at once, so it must be callable as a constant.
// must say: shade_for

#include <lantern/render.hpp>

int main() {
    int calls = 0;
    const auto fixed = [](const lantern::ray&, const auto&) { return glm::vec3(0); };
    auto counts = [calls](const lantern::ray&, const auto&) mutable { return glm::vec3(static_cast<float>(++calls)); };
#ifndef FIXED
    const auto& shade = counts;
#else
    const auto& shade = fixed;
#endif
    (void)fixed, (void)counts;
    (void)lantern::render({1, 1}, lantern::camera{lantern::view{}}, lantern::jittered{}, shade);
}
