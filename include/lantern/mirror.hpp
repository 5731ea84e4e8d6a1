// SPDX-License-Identifier: MIT
#pragma once
// A perfect mirror.

#include <lantern/material.hpp>
#include <lantern/surface.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace lantern {

/// The law of reflection, in - 2 (n·in) n for a normal of any length, in double; of unit length. Called `mirrored`, as
/// GLM owns `reflect`.
[[nodiscard]] inline glm::vec3 mirrored(glm::vec3 in, glm::vec3 normal) {
    const glm::dvec3 d(in), n(normal);
    return glm::vec3(glm::normalize(d - 2 * glm::dot(n, d) / glm::dot(n, n) * n));
}

/// Reflects everything, tinted.
struct mirror {
    glm::vec3 color{1};
};

inline void validate(const mirror& m) { require_albedo(m.color, "mirror: color"); }

[[nodiscard]] inline bounces scatter(const mirror& m, glm::vec3 in, const hit& h) {
    return bounce{mirrored(in, h.normal), m.color};
}

}  // namespace lantern
