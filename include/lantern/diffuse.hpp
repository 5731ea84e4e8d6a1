// SPDX-License-Identifier: MIT
#pragma once
// A matte surface.

#include <lantern/material.hpp>
#include <lantern/surface.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <numbers>

namespace lantern {

/// Lambert's surface: the same radiance in all directions. `color` is the albedo, in [0, 1].
struct diffuse {
    glm::vec3 color{0.5f};
};

inline void validate(const diffuse& m) { require_albedo(m.color, "diffuse: color"); }

[[nodiscard]] inline glm::vec3 albedo(const diffuse& m, const hit&) { return m.color; }

/// ρ/π cos θ, on the side that is seen only.
[[nodiscard]] inline glm::vec3 evaluate(const diffuse& m, glm::vec3 in, const hit& h, glm::vec3 out) {
    const float cosine = std::max(0.0f, glm::dot(facing(h.normal, in), out));
    return m.color * (cosine * std::numbers::inv_pi_v<float>);
}

}  // namespace lantern
