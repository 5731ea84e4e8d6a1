// SPDX-License-Identifier: MIT
// A number of samples says nothing of where they lie: `render` wants a sampler.
// must say: sampler

#include <lantern/camera.hpp>
#include <lantern/render.hpp>
#include <lantern/samples.hpp>

const lantern::camera cam{lantern::view{.eye = {0, 0, 4}, .target = {0, 0, 0}}};

lantern::image picture() {
    const auto shade = [](const lantern::ray&, const auto&) { return glm::vec3(1); };
#ifdef FIXED
    return lantern::render({4, 4}, cam, lantern::independent{.samples = 16}, shade);
#else
    return lantern::render({4, 4}, cam, 16, shade);
#endif
}
