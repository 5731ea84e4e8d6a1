// SPDX-License-Identifier: MIT
// A tracer looks at its accelerator and does not own it: one that is gone at the end of the line is refused.
// must say: delete

#include <lantern/closest.hpp>
#include <lantern/diffuse.hpp>
#include <lantern/object.hpp>
#include <lantern/sphere.hpp>
#include <lantern/whitted.hpp>

#include <vector>

auto look(const std::vector<lantern::object<lantern::sphere, lantern::diffuse>>& things, const std::vector<lantern::point_light>& lights) {
#ifdef FIXED
    const lantern::every all{1};
    return lantern::whitted{all, things, lights}(lantern::ray{});
#else
    return lantern::whitted{lantern::every{1}, things, lights};
#endif
}
