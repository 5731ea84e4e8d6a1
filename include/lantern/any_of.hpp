// SPDX-License-Identifier: MIT
#pragma once
// One of a closed set of surfaces, chosen at run time.

#include <lantern/aabb.hpp>
#include <lantern/alternative.hpp>
#include <lantern/hull.hpp>
#include <lantern/interval.hpp>
#include <lantern/precise.hpp>
#include <lantern/ray.hpp>
#include <lantern/surface.hpp>

#include <concepts>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

namespace lantern {

/// Holds one of its alternatives, by value: no allocation, no virtual call. It is a surface for a kind of ray when every
/// alternative is, and bounded when every alternative is. `any_of<sphere, plane> s = sphere{};`
template <class... Surfaces>
struct any_of {
    std::variant<Surfaces...> value;

    any_of() = default;

    template <class S>
        requires(std::same_as<std::remove_cvref_t<S>, Surfaces> || ...)
    any_of(S&& s) : value(std::forward<S>(s)) {}
};

template <class... Surfaces, std::derived_from<precise::ray> Ray>
    requires(precise_surface<Surfaces, Ray> && ...)
[[nodiscard]] std::optional<precise::hit> intersect(const any_of<Surfaces...>& s, const Ray& r, interval range) {
    return with_alternative(s.value, [&](const auto& which) { return intersect(which, r, range); });
}

/// Each in its own way: rounded where it finds a hit, or in float altogether, as a user's own may be.
template <class... Surfaces, std::derived_from<ray> Ray>
    requires(surface<Surfaces, Ray> && ...)
[[nodiscard]] std::optional<hit> intersect(const any_of<Surfaces...>& s, const Ray& r, interval range) {
    return with_alternative(s.value, [&](const auto& which) { return intersect(which, r, range); });
}

template <bounded... Surfaces>
[[nodiscard]] aabb bounds(const any_of<Surfaces...>& s) {
    return with_alternative(s.value, [](const auto& which) { return bounds(which); });
}

template <bounded... Surfaces>
[[nodiscard]] aabb bounds_at(const any_of<Surfaces...>& s, float time) {
    return with_alternative(s.value, [&](const auto& which) { return bounds_at(which, time); });
}

template <bounded... Surfaces>
[[nodiscard]] hull hull_of(const any_of<Surfaces...>& s) {
    return with_alternative(s.value, [](const auto& which) { return hull_of(which); });
}

template <class... Surfaces>
void validate(const any_of<Surfaces...>& s) {
    with_alternative(s.value, [](const auto& which) {
        if constexpr (requires { validate(which); }) validate(which);
    });
}

}  // namespace lantern
