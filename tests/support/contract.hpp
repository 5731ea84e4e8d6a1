// SPDX-License-Identifier: MIT
#pragma once
// The contract between a lab's suite and the code it judges: names and types, nothing else. Which code answers is
// decided when the program is linked, so the suite never sees student code and the binding never sees Catch2.

// The types that contracts are made of. This header is precompiled for all bindings: what it includes costs nothing.
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace contract {

/// A string that can stand between angle brackets.
template <std::size_t Size>
struct name {
    char text[Size]{};
    consteval name(const char (&literal)[Size]) { std::copy_n(literal, Size, text); }
    [[nodiscard]] constexpr std::string_view view() const { return {text, Size - 1}; }
};

/// Where a test calls: std::source_location, which Clang 14 does not have yet.
struct location {
    const char* file;
    unsigned line;
    [[nodiscard]] static constexpr location here(const char* file = __builtin_FILE(), unsigned line = __builtin_LINE()) {
        return {file, line};
    }
};

template <name Name, class Signature>
struct function;

/// One function of the contract. The constant is called as if it were the function; `bind` (or the judge) says who answers.
/// The trailing location is that of the test, for the judge to report when no answer comes.
template <name Name, class Result, class... Arguments>
struct function<Name, Result(Arguments...)> {
    using target_type = Result (*)(Arguments..., location);
    inline static target_type target = nullptr;

    Result operator()(Arguments... arguments, location caller = location::here()) const {
        if (!target) throw std::logic_error("nothing is bound to the contract's " + std::string(Name.view()));
        return target(std::forward<Arguments>(arguments)..., caller);
    }

    /// Makes `code` answer the calls from now on.
    template <class Code>
    static void answer_with(Code code) {
        static Code answering = std::move(code);
        target = [](Arguments... arguments, location) -> Result {
            return answering(std::forward<Arguments>(arguments)...);
        };
    }

    template <class Code>
    static constexpr bool fits = std::is_invocable_r_v<Result, Code&, Arguments...>;
};

template <class T>
inline constexpr bool is_contract_function = false;
template <name Name, class Signature>
inline constexpr bool is_contract_function<function<Name, Signature>> = true;

/// A line of the table: who answers is settled when it is made.
struct binding {};

/// `bind<contract::lab01::quantise>(quantise)`. In a binding file the contract's own name is found only where the
/// student's header lacks it (see any bind.cpp), and that is what the first assertion is about.
template <auto Function, class Code>
[[nodiscard]] binding bind(Code code) {
    static_assert(!is_contract_function<Code>, "YOUR HEADER LACKS THIS FUNCTION: it must declare it, by this name, in the lab's namespace");
    if constexpr (!is_contract_function<Code>) {
        using declared = std::remove_const_t<decltype(Function)>;
        static_assert(declared::template fits<Code>, "YOUR FUNCTION HAS OTHER PARAMETERS OR ANOTHER RESULT than the handout's");
        if constexpr (declared::template fits<Code>) declared::answer_with(std::move(code));
    }
    return {};
}

/// All bindings of a lab, made before main.
class table {
public:
    template <class... Bindings>
    explicit table(const Bindings&...) {}
};

}  // namespace contract
