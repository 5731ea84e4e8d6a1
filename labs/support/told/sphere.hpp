// SPDX-License-Identifier: MIT
#pragma once
// The library's sphere, but one that tells the recorder who asks. `namespace lab06 { namespace lantern = told; }` before lab 06's code
// makes it that code's lantern::sphere.

#include "../recorder.hpp"

#include <lantern/sphere.hpp>

namespace told {

using namespace ::lantern;

struct sphere {
    glm::vec3 center{0};
    float radius = 1;
};

[[nodiscard]] inline std::optional<hit> intersect(const sphere& s, const ray& r, interval range) {
    return support::tell(support::ball_at(s.center, s.radius), r, range,
                         [&] { return std::optional<hit>(::lantern::intersect(::lantern::sphere{s.center, s.radius}, r, range)); });
}

}  // namespace told
