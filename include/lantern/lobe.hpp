// SPDX-License-Identifier: MIT
#pragma once
// Directions that are drawn from what a material reflects, and how densely: what the full ray tracer asks of a material.

#include <lantern/basis.hpp>
#include <lantern/material.hpp>
#include <lantern/surface.hpp>
#include <lantern/warp.hpp>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <concepts>
#include <numbers>

namespace lantern {

// The basic ray tracer and distribution ray tracing ask a material for its answer to light from a known direction
// (`evaluate`), or for the rays that it sends on (`scatter`). A path is followed from every surface, and light that it may
// find in two ways is weighed by the densities of both. So a material may offer, beside these two:
//     draw(m, in, h, xi)       a direction for what `evaluate` answers, drawn with a point of the unit square;
//     density(m, in, h, out)   how densely, per solid angle; both or neither. Without, directions are drawn by the cosine;
//     lobe(m, in, h, out)      what `scatter` sends on, as a function of the direction, where it is spread over some.

/// Draws directions for `evaluate` in a way of its own.
template <class M>
concept draws_directions = requires(const M& m, glm::vec3 in, const hit& h, glm::vec2 xi, glm::vec3 out) {
    { draw(m, in, h, xi) } -> std::same_as<glm::vec3>;
    { density(m, in, h, out) } -> std::same_as<double>;
};

/// What reaches the eye of light from one direction, and how densely `scatter` draws this direction. Both are 0 where it
/// never does, and for a lobe so narrow that a direction in float does not tell whether it belongs to it.
struct response {
    glm::vec3 value{0};  ///< the BSDF times the cosine at the surface; per steradian
    double density = 0;  ///< probability per solid angle, when one of its rays is followed, by `chance_of_first`
};

/// Says what its `scatter` sends on in each direction, as long as it is not sharp.
template <class M>
concept has_lobe = requires(const M& m, glm::vec3 in, const hit& h, glm::vec3 out) {
    { lobe(m, in, h, out) } -> std::same_as<response>;
};

/// Denser towards the normal, as the cosine; on the side that `in` comes from.
[[nodiscard]] inline glm::vec3 draw_by_cosine(glm::vec3 in, const hit& h, glm::vec2 xi) {
    return to_world(basis_from(facing(h.normal, in)), to_cosine_hemisphere(xi));
}
[[nodiscard]] inline double cosine_density(glm::vec3 in, const hit& h, glm::vec3 out) {
    return double(std::max(0.0f, glm::dot(facing(h.normal, in), out)) * std::numbers::inv_pi_v<float>);
}

/// A direction for what `evaluate` answers: the material's own way, or by the cosine, which is right for any surface that
/// answers light on the side that is seen.
template <reflects_light M>
[[nodiscard]] glm::vec3 drawn_direction(const M& m, glm::vec3 in, const hit& h, glm::vec2 xi) {
    if constexpr (draws_directions<M>) return draw(m, in, h, xi);
    else return draw_by_cosine(in, h, xi);
}

/// Its density, per solid angle.
template <reflects_light M>
[[nodiscard]] double direction_density(const M& m, glm::vec3 in, const hit& h, glm::vec3 out) {
    if constexpr (draws_directions<M>) return density(m, in, h, out);
    else return cosine_density(in, h, out);
}

}  // namespace lantern
