// SPDX-License-Identifier: MIT
#pragma once
// A surface that shines.

#include <lantern/material.hpp>
#include <lantern/surface.hpp>
#include <lantern/validate.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace lantern {

/// The same radiance in all directions, from the side that the normal points to; the back is black. This is what a
/// ray sees of a light with area. It lights nothing by itself: for that, put the light beside the scene as well.
struct emissive {
    glm::vec3 radiance{1};
};

inline void validate(const emissive& m) { require_not_negative(m.radiance, "emissive: radiance"); }

[[nodiscard]] inline glm::vec3 emitted(const emissive& m, glm::vec3 in, const hit& h) {
    return glm::dot(in, h.normal) < 0 ? m.radiance : glm::vec3(0);
}

}  // namespace lantern
