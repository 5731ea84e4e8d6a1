// SPDX-License-Identifier: MIT
#pragma once
// The worker's side of a contract: reads the arguments, calls the student's code, writes the value. It decides nothing.

#include "wire.hpp"

#include <contract.hpp>

#include <cstdint>
#include <functional>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace contract::worker {

using handler = std::function<void(wire::decoder&, wire::encoder&)>;

/// The handler of the contract's function number `index`.
void serve(std::uint32_t index, handler);

/// Has the judge call the function that the suite handed in; answers its own questions meanwhile. Returns the result's bytes.
[[nodiscard]] std::string call_back(std::uint32_t which, std::string_view arguments);

template <class T>
struct argument {
    static wire::kept_as<T> from(wire::decoder& in) { return wire::read<wire::kept_as<T>>(in); }
};

template <class Result, class... Arguments>
struct argument<std::function<Result(Arguments...)>> {
    static std::function<Result(Arguments...)> from(wire::decoder& in) {
        return [which = in.number<std::uint32_t>()](Arguments... arguments) -> Result {
            wire::encoder out;
            (wire::write(out, arguments), ...);
            const std::string bytes = call_back(which, out.bytes());
            if constexpr (!std::is_void_v<Result>) {
                wire::decoder result(bytes);
                return wire::read<std::remove_cvref_t<Result>>(result);
            }
        };
    }
};

template <class Function>
struct answering;

template <name Name, class Result, class... Arguments>
struct answering<function<Name, Result(Arguments...)>> {
    static void call(wire::decoder& in, wire::encoder& out) {
        // In braces the arguments are read from left to right.
        std::tuple<decltype(argument<std::remove_cvref_t<Arguments>>::from(in))...> arguments{
            argument<std::remove_cvref_t<Arguments>>::from(in)...};
        in.finish();
        const auto invoke = [](auto&... values) -> Result {
            return function<Name, Result(Arguments...)>::target(static_cast<Arguments>(values)..., location{"", 0});
        };
        if constexpr (std::is_void_v<Result>) std::apply(invoke, arguments);
        else wire::write(out, std::remove_cvref_t<Result>(std::apply(invoke, arguments)));
    }
};

/// A line of the worker's table.
template <auto Function>
[[nodiscard]] binding answer(std::uint32_t index) {
    serve(index, answering<std::remove_const_t<decltype(Function)>>::call);
    return {};
}

}  // namespace contract::worker
