// SPDX-License-Identifier: MIT
#pragma once
// A value of a large type as one of a smaller type, where what it holds allows: a moving sphere that stands still is a sphere.

#include <lantern/any_of.hpp>
#include <lantern/coated.hpp>
#include <lantern/glass.hpp>
#include <lantern/glossy.hpp>
#include <lantern/mirror.hpp>
#include <lantern/moving.hpp>
#include <lantern/object.hpp>
#include <lantern/rotating.hpp>

#include <glm/vec3.hpp>

#include <concepts>
#include <type_traits>
#include <utility>
#include <variant>

namespace lantern {

// What may be left out. For each there are two functions, for values of any type:
//     needs(what, value)    whether the value would not be the same without;
//     reduced(what, value)  the value, in a type that does not have it. Only where it does not need it.
// A type of one's own may have both beside it; a type without is kept as it is.

struct motion {};
struct gloss {};

/// All alternatives but T.
template <class T>
struct all_but {};

namespace detail {

template <class... Ts>
struct types {};

template <class List, class... Ts>
struct distinct;
template <class... Kept>
struct distinct<types<Kept...>> {
    using type = types<Kept...>;
};
template <class... Kept, class T, class... Ts>
struct distinct<types<Kept...>, T, Ts...>
    : distinct<std::conditional_t<(std::same_as<T, Kept> || ...), types<Kept...>, types<Kept..., T>>, Ts...> {};

/// One of several types, or the only one, without a choice.
template <template <class...> class Choice, class List>
struct chosen;
template <template <class...> class Choice, class T>
struct chosen<Choice, types<T>> {
    using type = T;
};
template <template <class...> class Choice, class... Ts>
struct chosen<Choice, types<Ts...>> {
    using type = Choice<Ts...>;
};

template <template <class...> class Choice, class... Ts>
using choice_of = typename chosen<Choice, typename distinct<types<>, Ts...>::type>::type;

}  // namespace detail

template <class What, class T>
[[nodiscard]] constexpr bool needs(What, const T&) { return false; }
template <class What, class T>
[[nodiscard]] constexpr T reduced(What, const T& value) { return value; }

template <class S>
[[nodiscard]] bool needs(motion, const moving<S>& m) { return m.displacement != glm::vec3(0); }
template <class S>
[[nodiscard]] S reduced(motion, const moving<S>& m) { return m.surface; }

template <class S>
[[nodiscard]] bool needs(motion, const rotating<S>& m) { return m.angle != 0; }
template <class S>
[[nodiscard]] S reduced(motion, const rotating<S>& m) { return m.surface; }

[[nodiscard]] inline bool needs(gloss, const glossy& m) { return m.width != 0; }
[[nodiscard]] inline mirror reduced(gloss, const glossy& m) { return {m.color}; }

[[nodiscard]] inline bool needs(gloss, const frosted& m) { return m.width != 0; }
[[nodiscard]] inline glass reduced(gloss, const frosted& m) { return m.body; }

template <class Body, class Coat>
[[nodiscard]] bool needs(gloss what, const coated<Body, Coat>& m) { return needs(what, m.coat); }
template <class Body, class Coat>
[[nodiscard]] auto reduced(gloss what, const coated<Body, Coat>& m) {
    return coated<Body, decltype(reduced(what, m.coat))>{m.body, reduced(what, m.coat), m.share};
}

template <class What, class... Ts>
[[nodiscard]] bool needs(What what, const std::variant<Ts...>& value) {
    return std::visit([&](const auto& kind) { return needs(what, kind); }, value);
}
template <class What, class... Ts>
[[nodiscard]] auto reduced(What what, const std::variant<Ts...>& value) {
    using result = detail::choice_of<std::variant, decltype(reduced(what, std::declval<const Ts&>()))...>;
    return std::visit([&](const auto& kind) { return result(reduced(what, kind)); }, value);
}

template <class What, class... Ts>
[[nodiscard]] bool needs(What what, const any_of<Ts...>& value) {
    return std::visit([&](const auto& kind) { return needs(what, kind); }, value.value);
}
template <class What, class... Ts>
[[nodiscard]] auto reduced(What what, const any_of<Ts...>& value) {
    using result = detail::choice_of<any_of, decltype(reduced(what, std::declval<const Ts&>()))...>;
    return std::visit([&](const auto& kind) { return result(reduced(what, kind)); }, value.value);
}

template <class T, class... Ts>
[[nodiscard]] bool needs(all_but<T>, const std::variant<Ts...>& value) { return !std::holds_alternative<T>(value); }
template <class T, class... Ts>
[[nodiscard]] T reduced(all_but<T>, const std::variant<Ts...>& value) { return std::get<T>(value); }
template <class T, class... Ts>
[[nodiscard]] bool needs(all_but<T>, const any_of<Ts...>& value) { return !std::holds_alternative<T>(value.value); }
template <class T, class... Ts>
[[nodiscard]] T reduced(all_but<T>, const any_of<Ts...>& value) { return std::get<T>(value.value); }

/// A thing needs what its shape or its material needs.
template <class What, class Shape, class Material>
[[nodiscard]] bool needs(What what, const object<Shape, Material>& o) {
    return needs(what, o.shape) || needs(what, o.material);
}
template <class What, class Shape, class Material>
[[nodiscard]] auto reduced(What what, const object<Shape, Material>& o) {
    return object{reduced(what, o.shape), reduced(what, o.material)};
}
/// Of the shape alone.
template <class T, class Shape, class Material>
[[nodiscard]] bool needs(all_but<T> what, const object<Shape, Material>& o) {
    return needs(what, o.shape);
}
template <class T, class Shape, class Material>
[[nodiscard]] auto reduced(all_but<T> what, const object<Shape, Material>& o) {
    return object<T, Material>{reduced(what, o.shape), o.material};
}

}  // namespace lantern
