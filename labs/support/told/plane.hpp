// SPDX-License-Identifier: MIT
#pragma once
// The library's plane, but one that tells the recorder who asks: see sphere.hpp.

#include "../recorder.hpp"

#include <lantern/plane.hpp>

namespace told {

using namespace ::lantern;

struct plane {
    glm::vec3 point{0};
    glm::vec3 normal{0, 1, 0};
};

[[nodiscard]] inline std::optional<hit> intersect(const plane& p, const ray& r, interval range) {
    const support::figure what{"plane", {p.point.x, p.point.y, p.point.z, p.normal.x, p.normal.y, p.normal.z}};
    return support::tell(what, r, range, [&] { return std::optional<hit>(::lantern::intersect(::lantern::plane{p.point, p.normal}, r, range)); });
}

}  // namespace told
