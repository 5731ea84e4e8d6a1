// SPDX-License-Identifier: MIT
#pragma once
// The library's rectangle, but one that tells the recorder who asks: see sphere.hpp.

#include "../recorder.hpp"

#include <lantern/rectangle.hpp>

namespace told {

using namespace ::lantern;

struct rectangle {
    glm::vec3 corner{0};
    glm::vec3 u{1, 0, 0};
    glm::vec3 v{0, 1, 0};
};

[[nodiscard]] inline std::optional<hit> intersect(const rectangle& s, const ray& r, interval range) {
    return support::tell(support::plate_at(s.corner, s.u, s.v), r, range,
                         [&] { return std::optional<hit>(::lantern::intersect(::lantern::rectangle{s.corner, s.u, s.v}, r, range)); });
}

}  // namespace told
