// SPDX-License-Identifier: MIT
#pragma once
// The judge's side of a contract: each function is answered by the worker. No student code is linked in here.

#include "wire.hpp"

#include <contract.hpp>

#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace contract::judge {

/// What the suite handed in, to be called by the student's code: reads the arguments, writes the result.
using callback = std::function<void(wire::decoder&, wire::encoder&)>;

/// Asks the worker, answers its callbacks meanwhile, and returns the bytes of its answer. The student's exception is
/// thrown again by its type. When no answer comes the running test has failed from then on, whatever it does with `lost`.
[[nodiscard]] std::string ask(std::string_view function, std::uint32_t index, std::string_view arguments,
                              const std::vector<callback>& callbacks, location caller);

/// Thrown when the worker gave no valid answer. No std::exception: no suite may take it for the student's.
struct lost {
    std::string what;
};

/// The answer cannot be read: that is a loss, too.
[[noreturn]] void lose(std::string_view function, const std::string& what, location caller);

template <class T>
void write_argument(wire::encoder& out, std::vector<callback>&, const T& value) {
    wire::write(out, value);
}

template <class Result, class... Arguments>
void write_argument(wire::encoder& out, std::vector<callback>& callbacks, const std::function<Result(Arguments...)>& function) {
    wire::write(out, std::uint32_t(callbacks.size()));
    callbacks.push_back([&function](wire::decoder& in, wire::encoder& result) {
        std::tuple<wire::kept_as<Arguments>...> arguments;
        wire::read(in, arguments);
        in.finish();
        if constexpr (std::is_void_v<Result>) std::apply(function, arguments);
        else wire::write(result, std::remove_cvref_t<Result>(std::apply(function, arguments)));
    });
}

template <class Function>
struct proxy;

template <name Name, class Result, class... Arguments>
struct proxy<function<Name, Result(Arguments...)>> {
    /// The function's place in the contract: judge and worker are made from the same list.
    inline static std::uint32_t index = 0;

    static Result call(Arguments... arguments, location caller) {
        wire::encoder out;
        std::vector<callback> callbacks;
        (write_argument(out, callbacks, arguments), ...);
        const std::string bytes = ask(Name.view(), index, out.bytes(), callbacks, caller);
        try {
            wire::decoder in(bytes);
            if constexpr (std::is_void_v<Result>) in.finish();
            else {
                auto result = wire::read<std::remove_cvref_t<Result>>(in);
                in.finish();
                return result;
            }
        } catch (const wire::violation& broken) {
            lose(Name.view(), "answered with " + broken.what, caller);
        }
    }
};

/// A line of the judge's table.
template <auto Function>
[[nodiscard]] binding ask_worker(std::uint32_t index) {
    using declared = std::remove_const_t<decltype(Function)>;
    proxy<declared>::index = index;
    declared::target = proxy<declared>::call;
    return {};
}

}  // namespace contract::judge
