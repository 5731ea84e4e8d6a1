// SPDX-License-Identifier: MIT
// `render` calls shade(ray, source): one that takes a ray alone is refused where it is handed over.
// must say: shade_for

#include <lantern/camera.hpp>
#include <lantern/render.hpp>
#include <lantern/samples.hpp>

const lantern::camera cam{lantern::view{.eye = {0, 0, 4}, .target = {0, 0, 0}}};

lantern::image picture() {
#ifdef FIXED
    const auto shade = [](const lantern::ray&, const auto&) { return glm::vec3(1); };
#else
    const auto shade = [](const lantern::ray&) { return glm::vec3(1); };
#endif
    return lantern::render({4, 4}, cam, lantern::independent{}, shade);
}
