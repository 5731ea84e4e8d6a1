// SPDX-License-Identifier: MIT
// Where a moving light is only a ray with a time can ask; a camera without a shutter shoots none.
// must say: a moving light needs a camera with a shutter

#include <lantern/closest.hpp>
#include <lantern/diffuse.hpp>
#include <lantern/distribution.hpp>
#include <lantern/moving_light.hpp>
#include <lantern/object.hpp>
#include <lantern/sphere.hpp>
#include <lantern/sphere_light.hpp>

#include <vector>

#ifdef FIXED
using ray = lantern::timed_ray;
#else
using ray = lantern::ray;
#endif

glm::vec3 look(const std::vector<lantern::object<lantern::sphere, lantern::diffuse>>& things,
               const std::vector<lantern::moving<lantern::sphere_light>>& lights) {
    const lantern::every all{1};
    return lantern::distribution{all, things, lights}(ray{}, lantern::independent{}.at({0, 0}, 0));
}
