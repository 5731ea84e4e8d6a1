// SPDX-License-Identifier: MIT
// The basic ray tracer draws no samples, so a material that needs one is refused, and the message says what to use.
// must say: whitted draws no samples, and this material needs them; use distribution

#include <lantern/closest.hpp>
#include <lantern/glossy.hpp>
#include <lantern/object.hpp>
#include <lantern/sphere.hpp>
#include <lantern/whitted.hpp>

#include <vector>

#ifdef FIXED
using material = lantern::mirror;
#else
using material = lantern::glossy;
#endif

glm::vec3 look(const std::vector<lantern::object<lantern::sphere, material>>& things, const std::vector<lantern::point_light>& lights) {
    const lantern::every all{1};
    return lantern::whitted{all, things, lights}(lantern::ray{});
}
