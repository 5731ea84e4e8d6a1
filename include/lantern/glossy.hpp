// SPDX-License-Identifier: MIT
#pragma once
// Glossy reflection and transmission: the mirror's ray, perturbed.

#include <lantern/basis.hpp>
#include <lantern/glass.hpp>
#include <lantern/lobe.hpp>
#include <lantern/material.hpp>
#include <lantern/mirror.hpp>
#include <lantern/surface.hpp>
#include <lantern/validate.hpp>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <cstdint>

namespace lantern {

/// A ray r perturbed within a square of side `width`, perpendicular to r and one unit of length away (Cook, Porter
/// and Carpenter 1984): with an orthonormal basis whose w = r / |r|,
///     u = -a/2 + ξ a,  v = -a/2 + ξ' a,  r' = w + u U + v V,
/// so the blur does not depend on the length of r. r' has unit length. A width of zero gives r itself, to the last bit.
[[nodiscard]] inline glm::vec3 perturbed(glm::vec3 r, float width, glm::vec2 xi) {
    if (width == 0) return r;
    const basis b = basis_from(r);
    const double a = width, u = -a / 2 + double(xi.x) * a, v = -a / 2 + double(xi.y) * a;
    return glm::vec3(glm::normalize(glm::dvec3(b.w) + u * glm::dvec3(b.u) + v * glm::dvec3(b.v)));
}

/// How densely `perturbed` draws `direction`, per solid angle: 1 / (a² cos³ θ) within the square, of which a piece dA at the
/// distance 1 / cos θ is seen under dA cos³ θ; 0 outside. Only for widths that are not `sharp`.
[[nodiscard]] inline double perturbed_density(glm::vec3 r, float width, glm::vec3 direction) {
    const basis b = basis_from(r);
    const glm::dvec3 d(direction);
    const double cosine = glm::dot(d, glm::dvec3(b.w)), half = double(width) / 2 * cosine;
    if (!(cosine > 0 && std::abs(glm::dot(d, glm::dvec3(b.u))) < half && std::abs(glm::dot(d, glm::dvec3(b.v))) < half)) return 0;
    return 1 / (double(width) * double(width) * cosine * cosine * cosine);
}

/// Whether a square is so small that the rounding of a direction, some 2^-24, blurs its border by more than a thousandth.
[[nodiscard]] inline bool sharp(float width) { return !(width > 0x1p-14f); }

/// Brings a direction to the side that `normal` points to. Near grazing part of the square lies behind the surface: at
/// an incidence of 80° and width 1 a third of it. Folded back at the surface, as by a second reflection, that part goes on
/// with all its energy; to absorb it would draw dark rims, to draw again until it fits would take more numbers and
/// spoil their stratification. Folding keeps solid angles, and is continuous: neighbours in the square stay neighbours.
[[nodiscard]] inline glm::vec3 folded(glm::vec3 direction, glm::vec3 normal) {
    const float height = glm::dot(direction, normal);
    return height < 0 ? direction - 2 * height * normal : direction;
}

/// A blurred mirror: metal that is brushed or worn.
struct glossy {
    glm::vec3 color{1};
    float width = 0.2f;  ///< the side a of the square; 0 is a mirror
};

inline void validate(const glossy& m) {
    require_albedo(m.color, "glossy: color");
    require_not_negative(m.width, "glossy: width");
}

[[nodiscard]] inline bounces scatter(const glossy& m, glm::vec3 in, const hit& h, glm::vec2 xi) {
    const glm::vec3 r = perturbed(mirrored(in, h.normal), m.width, xi);
    return bounce{folded(r, facing(h.normal, in)), m.color};
}

/// How densely a perturbed and folded direction is drawn: what is folded comes on top. `normal` has unit length.
[[nodiscard]] inline double folded_density(glm::vec3 r, float width, glm::vec3 direction, glm::vec3 normal) {
    const float height = glm::dot(direction, normal);
    if (!(height > 0)) return 0;
    return perturbed_density(r, width, direction) + perturbed_density(r, width, direction - 2 * height * normal);
}

[[nodiscard]] inline response lobe(const glossy& m, glm::vec3 in, const hit& h, glm::vec3 out) {
    if (sharp(m.width)) return {};
    const double density = folded_density(mirrored(in, h.normal), m.width, out, facing(h.normal, in));
    return {static_cast<float>(density) * m.color, density};
}

/// Frosted glass: both of its rays are perturbed, each by a point of its own.
struct frosted {
    glass body{};
    float width = 0.1f;  ///< the side a of the square; 0 is clear glass
};

inline void validate(const frosted& m) {
    validate(m.body);
    require_not_negative(m.width, "frosted: width");
}

[[nodiscard]] inline bounces scatter(const frosted& m, glm::vec3 in, const hit& h, glm::vec2 xi, glm::vec2 xi2) {
    const glm::vec3 front = facing(h.normal, in);
    const auto perturb = [&](const bounce& b, glm::vec2 point) {
        const bool reflected = glm::dot(b.direction, front) > 0;
        return bounce{folded(perturbed(b.direction, m.width, point), reflected ? front : -front), b.weight};
    };
    const bounces clear = scatter(m.body, in, h);
    return clear.size() == 2 ? bounces{perturb(clear[0], xi), perturb(clear[1], xi2)} : bounces{perturb(clear[0], xi)};
}

[[nodiscard]] inline response lobe(const frosted& m, glm::vec3 in, const hit& h, glm::vec3 out) {
    if (sharp(m.width)) return {};
    const glm::vec3 front = facing(h.normal, in);
    const bounces clear = scatter(m.body, in, h);
    const float first = chance_of_first(clear);
    response sum;
    for (std::uint32_t k = 0; k < clear.size(); ++k) {
        const bool reflected = glm::dot(clear[k].direction, front) > 0;
        const double density = folded_density(clear[k].direction, m.width, out, reflected ? front : -front);
        sum.value += static_cast<float>(density) * clear[k].weight;
        sum.density += double(k == 0 ? first : 1 - first) * density;
    }
    return sum;
}

}  // namespace lantern
