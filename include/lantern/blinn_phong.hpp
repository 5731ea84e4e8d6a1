// SPDX-License-Identifier: MIT
#pragma once
// A matte surface with a highlight.

#include <lantern/basis.hpp>
#include <lantern/lobe.hpp>
#include <lantern/material.hpp>
#include <lantern/surface.hpp>
#include <lantern/validate.hpp>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
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

/// The cosine at the surface, and what the highlight is made of: (n·h)^e and out·h, for h halfway between eye and light.
/// By the sine, |n × h|, and in double: 1 - cos² has lost the answer near the peak, and a cosine in float cannot be raised
/// to a power beyond some 1e5.
struct halfway {
    double cosine = 0, power = 0, out = 0;
};

[[nodiscard]] inline halfway halfway_of(const blinn_phong& m, glm::vec3 in, const hit& h, glm::vec3 out) {
    const glm::dvec3 normal(facing(h.normal, in)), sum = glm::dvec3(out) - glm::dvec3(in);
    const double cosine = glm::dot(normal, glm::dvec3(out)), along = glm::dot(normal, sum);
    if (!(cosine > 0 && along > 0)) return {std::max(0.0, cosine), 0, 0};  // sum is 0 when the light stands behind
    const glm::dvec3 across = glm::cross(normal, sum);
    const double length2 = glm::dot(sum, sum), sine2 = std::min(1.0, glm::dot(across, across) / length2);
    return {cosine, std::exp(double(m.exponent) / 2 * std::log1p(-sine2)), glm::dot(glm::dvec3(out), sum) / std::sqrt(length2)};
}

[[nodiscard]] inline glm::vec3 evaluate(const blinn_phong& m, glm::vec3 in, const hit& h, glm::vec3 out) {
    const halfway at = halfway_of(m, in, h, out);
    const double e = m.exponent, scale = (e + 2) * (e + 4) / (8 * std::numbers::pi * (std::exp2(-e / 2) + e));
    return glm::vec3((glm::dvec3(m.body) * std::numbers::inv_pi + glm::dvec3(m.highlight) * (scale * at.power)) * at.cosine);
}

/// How likely a direction is drawn for the highlight: its share of what both can send back.
[[nodiscard]] inline double chance_of_highlight(const blinn_phong& m) {
    const double body = largest(m.body), highlight = largest(m.highlight);
    return highlight > 0 ? highlight / (body + highlight) : 0;
}

/// By the cosine for the body; for the highlight a normal is drawn as (n·h)^e, and `in` mirrored by it. xi.x chooses
/// between the two, and what is left of it is a number again.
[[nodiscard]] inline glm::vec3 draw(const blinn_phong& m, glm::vec3 in, const hit& h, glm::vec2 xi) {
    const double chance = chance_of_highlight(m), x = xi.x;
    if (x >= chance) return draw_by_cosine(in, h, {static_cast<float>((x - chance) / (1 - chance)), xi.y});
    const double sine2 = -std::expm1(2 * std::log(x / chance) / (double(m.exponent) + 1));  // cos = ξ^(1/(e + 1))
    const double sine = std::sqrt(sine2), angle = 2 * std::numbers::pi * double(xi.y);
    const basis b = basis_from(facing(h.normal, in));
    const glm::dvec3 half = sine * std::cos(angle) * glm::dvec3(b.u) + sine * std::sin(angle) * glm::dvec3(b.v) +
                            std::sqrt(1 - sine2) * glm::dvec3(b.w);
    const glm::dvec3 out = glm::dvec3(in) - 2 * glm::dot(glm::dvec3(in), half) * half;
    return glm::vec3(glm::normalize(out));
}

/// The density of normals, (e + 1)/2π (n·h)^e, becomes one of directions by 1/(4 out·h) (Torrance and Sparrow 1967; PBRT 9.6).
[[nodiscard]] inline double density(const blinn_phong& m, glm::vec3 in, const hit& h, glm::vec3 out) {
    const double chance = chance_of_highlight(m);
    const halfway at = halfway_of(m, in, h, out);
    const double normals = (double(m.exponent) + 1) / (2 * std::numbers::pi) * at.power;
    return (1 - chance) * at.cosine * std::numbers::inv_pi + (at.out > 0 ? chance * normals / (4 * at.out) : 0);
}

}  // namespace lantern
