// SPDX-License-Identifier: MIT
#pragma once
// A surface that shines.

#include <lantern/material.hpp>
#include <lantern/surface.hpp>
#include <lantern/validate.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace lantern {

/// The same radiance in all directions. The front, where the normal points to, is the side on which lights with area
/// shine; the back is black unless it is told to shine as well. This is what a ray sees of a light. It lights
/// nothing by itself: for that, put the light beside the scene as well.
struct emissive {
    glm::vec3 radiance{1};  ///< of the front
    glm::vec3 back{0};      ///< of the back: `emissive{.radiance = e, .back = e}` shines on both sides
};

inline void validate(const emissive& m) {
    require_not_negative(m.radiance, "emissive: radiance");
    require_not_negative(m.back, "emissive: back");
}

[[nodiscard]] inline glm::vec3 emitted(const emissive& m, glm::vec3 in, const hit& h) {
    return glm::dot(in, h.normal) < 0 ? m.radiance : m.back;
}

}  // namespace lantern
