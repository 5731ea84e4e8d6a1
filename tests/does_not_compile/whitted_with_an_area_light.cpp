// SPDX-License-Identifier: MIT
// The basic ray tracer draws no samples, so it has no use for a light with area.
// must say: whitted knows lights without extent only; use distribution for lights with area

#include <lantern/closest.hpp>
#include <lantern/diffuse.hpp>
#include <lantern/object.hpp>
#include <lantern/rectangle_light.hpp>
#include <lantern/sphere.hpp>
#include <lantern/whitted.hpp>

#include <vector>

#ifdef FIXED
using light = lantern::point_light;
#else
using light = lantern::rectangle_light;
#endif

glm::vec3 look(const std::vector<lantern::object<lantern::sphere, lantern::diffuse>>& things, const std::vector<light>& lights) {
    const lantern::every all{1};
    return lantern::whitted{all, things, lights}(lantern::ray{});
}
