// SPDX-License-Identifier: MIT
#pragma once
// Which things are the visible bodies of which lights: light that can be found in two ways must not be counted twice.

#include <lantern/alternative.hpp>
#include <lantern/any_of.hpp>
#include <lantern/light.hpp>
#include <lantern/material.hpp>
#include <lantern/surface.hpp>
#include <lantern/validate.hpp>

#include <glm/vec3.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace lantern {

/// A light with a surface, that can tell how densely it draws a point of it: `density(light, point, position)` per solid
/// angle, with the time as a last argument where it moves.
template <class L>
concept light_with_body = requires(const L& l) { surface_of(l); } && (requires(const L& l, glm::vec3 p) {
    { density(l, p, p) } -> std::same_as<double>;
} || requires(const L& l, glm::vec3 p, float time) {
    { density(l, p, p, time) } -> std::same_as<double>;
});

/// Of a light, or of any alternative of a variant.
template <class L>
inline constexpr bool may_have_body = light_with_body<L>;
template <class... Ls>
inline constexpr bool may_have_body<std::variant<Ls...>> = (light_with_body<Ls> || ...);

/// Whether two surfaces are of the same type and equal; a surface among several is what it holds.
template <class A, class B>
[[nodiscard]] bool same_surface(const A& a, const B& b) {
    if constexpr (std::same_as<A, B> && std::equality_comparable<A>) return a == b;
    else return false;
}
template <class... Surfaces, class B>
[[nodiscard]] bool same_surface(const any_of<Surfaces...>& a, const B& b) {
    return std::visit([&](const auto& which) { return same_surface(which, b); }, a.value);
}

/// A light has a body when a thing that shines has the surface `surface_of(light)`. Then rays find it too, and its light
/// arrives in two ways; a light without a body is found by shadow rays alone, and a thing that shines and is no light by
/// rays alone. One thing is the body of one light.
class emitters {
public:
    /// Refuses a body that does not shine to the front as its light does: std::invalid_argument.
    template <class Thing, class Light>
    emitters(std::span<const Thing> things, std::span<const Light> lights) : has_body_(lights.size()) {
        if constexpr (may_have_body<Light> && requires(const Thing& t) { t.shape; }) {
            for (std::size_t i = 0; i < things.size(); ++i)
                with_alternative(things[i].material, [&]<class M>(const M& m) {
                    if constexpr (emits<M>) find_light(i, things[i].shape, m, lights);
                });
        }
    }

    [[nodiscard]] bool has_body(std::uint32_t light) const { return has_body_[light]; }

    /// The light whose body a thing is.
    [[nodiscard]] std::optional<std::uint32_t> light_of(std::uint32_t thing) const {
        const auto found = std::ranges::lower_bound(bodies_, thing, {}, &std::pair<std::uint32_t, std::uint32_t>::first);
        if (found == bodies_.end() || found->first != thing) return std::nullopt;
        return found->second;
    }

private:
    std::vector<std::pair<std::uint32_t, std::uint32_t>> bodies_;  // thing and light; in the order of the things
    std::vector<bool> has_body_;

    template <class Shape, class Material, class Light>
    void find_light(std::size_t thing, const Shape& shape, const Material& m, std::span<const Light> lights) {
        for (std::size_t k = 0; k < lights.size(); ++k) {
            const bool found = !has_body_[k] && with_alternative(lights[k], [&]<class L>(const L& light) {
                if constexpr (light_with_body<L>) {
                    if (!same_surface(shape, surface_of(light))) return false;
                    require_same(thing, emitted(m, {0, 0, -1}, hit{.normal = {0, 0, 1}}), k, light);
                    return true;
                } else {
                    return false;
                }
            });
            if (!found) continue;
            has_body_[k] = true;
            bodies_.emplace_back(static_cast<std::uint32_t>(thing), static_cast<std::uint32_t>(k));
            return;
        }
    }

    template <class L>
    static void require_same(std::size_t thing, glm::vec3 shown, std::size_t k, const L& light) {
        if constexpr (requires { light.surface.radiance; }) {
            require_same(thing, shown, k, light.surface);
        } else if constexpr (requires { light.radiance; }) {
            if (shown != light.radiance)
                refuse("things[" + std::to_string(thing) + "]: radiance", to_text(shown),
                       "that of lights[" + std::to_string(k) + "], whose surface it has: " + to_text(light.radiance));
        }
    }
};

}  // namespace lantern
