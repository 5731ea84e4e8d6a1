// SPDX-License-Identifier: MIT
#pragma once
// A light that moves along a straight line while the shutter is open.

#include <lantern/light.hpp>
#include <lantern/moving.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <concepts>

namespace lantern {

/// A light that can be put elsewhere; every light of the library can.
template <class L>
concept movable_light = still_light<L> && requires(const L& l, glm::vec3 by) {
    { displaced(l, by) } -> std::same_as<L>;
};

/// `moving{light, displacement}` is the light moved by time * displacement, as for surfaces. It draws what the light draws.
template <movable_light L>
    requires point_like<L>
[[nodiscard]] illumination illuminate(const moving<L>& l, glm::vec3 point, float time) {
    return illuminate(displaced(l.surface, time * l.displacement), point);
}

template <movable_light L>
    requires sampled_light<L>
[[nodiscard]] illumination illuminate(const moving<L>& l, glm::vec3 point, glm::vec2 xi, float time) {
    return illuminate(displaced(l.surface, time * l.displacement), point, xi);
}

/// How densely `illuminate` draws the direction from `point` to `position`, a point of the light at that time, per solid angle.
template <movable_light L>
    requires requires(const L& l, glm::vec3 point) { density(l, point, point); }
[[nodiscard]] double density(const moving<L>& l, glm::vec3 point, glm::vec3 position, float time) {
    return density(displaced(l.surface, time * l.displacement), point, position);
}

/// The surface that shines, moving with the light.
template <movable_light L>
    requires requires(const L& l) { surface_of(l); }
[[nodiscard]] auto surface_of(const moving<L>& l) {
    return moving{surface_of(l.surface), l.displacement};
}

}  // namespace lantern
