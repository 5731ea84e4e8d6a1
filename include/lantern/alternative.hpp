// SPDX-License-Identifier: MIT
#pragma once
// One call for a type chosen at compile time and for a closed choice made at run time.

#include <utility>
#include <variant>

namespace lantern {

/// f(value), or f(the alternative it holds) for a std::variant. A scene of one kind of material pays for no choice. Throws
/// std::bad_variant_access where a variant holds none.
template <class T, class F>
constexpr decltype(auto) with_alternative(const T& value, F&& f) {
    return std::forward<F>(f)(value);
}

template <class... Ts, class F>
constexpr decltype(auto) with_alternative(const std::variant<Ts...>& value, F&& f) {
    if (value.valueless_by_exception()) throw std::bad_variant_access{};
    // Said before `visit` is called: GCC then does once, before a loop, what every alternative begins with for every ray.
    if (value.index() >= sizeof...(Ts)) __builtin_unreachable();
    return std::visit(std::forward<F>(f), value);
}

}  // namespace lantern
