// SPDX-License-Identifier: MIT
#pragma once
// A body under a coat: varnish, polish, a wet floor.

#include <lantern/lobe.hpp>
#include <lantern/material.hpp>
#include <lantern/surface.hpp>
#include <lantern/validate.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <concepts>

namespace lantern {

/// The coat sends `share` of the light on, as a mirror or a glossy surface does; what is left reaches the body, which
/// answers lights. This is the classic sum of local and reflected light (Whitted 1980) with weights that add up to 1.
template <reflects_light Body, material Coat>
struct coated {
    Body body{};
    Coat coat{};
    float share = 0.1f;  ///< in [0, 1]
};

template <class Body, class Coat>
coated(Body, Coat, float) -> coated<Body, Coat>;

template <class Body, class Coat>
void validate(const coated<Body, Coat>& m) {
    validate(m.body);
    validate(m.coat);
    if (!(m.share >= 0 && m.share <= 1)) refuse("coated: share", to_text(m.share), "between 0 and 1");
}

template <class Body, class Coat>
[[nodiscard]] glm::vec3 evaluate(const coated<Body, Coat>& m, glm::vec3 in, const hit& h, glm::vec3 out) {
    return (1 - m.share) * evaluate(m.body, in, h, out);
}

template <reflects_ambient Body, class Coat>
[[nodiscard]] glm::vec3 albedo(const coated<Body, Coat>& m, const hit& h) {
    return (1 - m.share) * albedo(m.body, h);
}

/// Directions for the body are drawn as the body draws them.
template <draws_directions Body, class Coat>
[[nodiscard]] glm::vec3 draw(const coated<Body, Coat>& m, glm::vec3 in, const hit& h, glm::vec2 xi) {
    return draw(m.body, in, h, xi);
}
template <draws_directions Body, class Coat>
[[nodiscard]] double density(const coated<Body, Coat>& m, glm::vec3 in, const hit& h, glm::vec3 out) {
    return density(m.body, in, h, out);
}

template <class Body, has_lobe Coat>
[[nodiscard]] response lobe(const coated<Body, Coat>& m, glm::vec3 in, const hit& h, glm::vec3 out) {
    const response coat = lobe(m.coat, in, h, out);
    return {m.share * coat.value, coat.density};
}

/// With as many points of the unit square as the coat asks for.
template <class Body, class Coat, std::same_as<glm::vec2>... Points>
    requires requires(const Coat& c, glm::vec3 in, const hit& h, Points... xi) { scatter(c, in, h, xi...); }
[[nodiscard]] bounces scatter(const coated<Body, Coat>& m, glm::vec3 in, const hit& h, Points... xi) {
    return m.share * scatter(m.coat, in, h, xi...);
}

}  // namespace lantern
