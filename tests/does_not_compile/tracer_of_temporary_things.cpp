// SPDX-License-Identifier: MIT
// A tracer looks at its things and does not own them: a vector that is gone at the end of the line is refused.
// must say: lasting_range

#include <lantern/closest.hpp>
#include <lantern/diffuse.hpp>
#include <lantern/object.hpp>
#include <lantern/sphere.hpp>
#include <lantern/whitted.hpp>

#include <vector>

std::vector<lantern::object<lantern::sphere, lantern::diffuse>> things();

void look(const std::vector<lantern::point_light>& lights) {
    const lantern::every all{1};
#ifdef FIXED
    const auto lasting = things();
    const lantern::whitted tracer{all, lasting, lights};
#else
    const lantern::whitted tracer{all, things(), lights};
#endif
    (void)tracer;
}
