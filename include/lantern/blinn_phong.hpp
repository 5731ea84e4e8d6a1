// SPDX-License-Identifier: MIT
#pragma once
// A matte surface with a highlight.

#include <lantern/material.hpp>
#include <lantern/surface.hpp>
#include <lantern/validate.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lantern {

/// A diffuse body with a highlight (Blinn 1977); `exponent` sharpens it. The highlight is scaled so that at normal
/// incidence it sends back exactly the fraction `highlight`, and less at any other angle: the factor is
/// (e + 2)(e + 4) / 8π(2^(-e/2) + e) (Giesen, "Phong and Blinn-Phong normalization factors", 2009). The surface thus
/// creates no light as long as `body` + `highlight` is at most 1.
struct blinn_phong {
    glm::vec3 body{0.5f};
    glm::vec3 highlight{0.04f};
    float exponent = 50;
};

inline void validate(const blinn_phong& m) {
    require_albedo(m.body, "blinn_phong: body");
    require_albedo(m.highlight, "blinn_phong: highlight");
    require_not_negative(m.exponent, "blinn_phong: exponent");
}

[[nodiscard]] inline glm::vec3 albedo(const blinn_phong& m, const hit&) { return m.body; }

[[nodiscard]] inline glm::vec3 evaluate(const blinn_phong& m, glm::vec3 in, const hit& h, glm::vec3 out) {
    const glm::vec3 normal = facing(h.normal, in);
    const float cosine = glm::dot(normal, out);
    if (!(cosine > 0)) return glm::vec3(0);
    const glm::vec3 sum = out - in;  // zero only when the light stands behind the surface
    const float halfway = std::clamp(glm::dot(normal, sum) / glm::length(sum), 0.0f, 1.0f);
    const float e = m.exponent, scale = (e + 2) * (e + 4) / (8 * std::numbers::pi_v<float> * (std::exp2(-e / 2) + e));
    const float lobe = scale * std::pow(halfway, e);
    return (m.body * std::numbers::inv_pi_v<float> + m.highlight * lobe) * cosine;
}

}  // namespace lantern
