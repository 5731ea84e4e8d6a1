// SPDX-License-Identifier: MIT
#pragma once
// Refusing bad input where it enters: every message names the value and the rule.

#include <lantern/alternative.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <ranges>
#include <stdexcept>
#include <string>

namespace lantern {

/// The shortest text that reads back as the same number.
[[nodiscard]] inline std::string to_text(std::floating_point auto x) {
    std::array<char, 48> buffer{};
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), x);
    return {buffer.data(), end};
}

[[nodiscard]] inline std::string to_text(glm::vec3 v) {
    std::string text = "(";  // += and not +, of which GCC 12 warns without reason (its bug 105329)
    text += to_text(v.x) + ", " + to_text(v.y) + ", " + to_text(v.z);
    return text += ")";
}

/// Throws std::invalid_argument "WHAT is VALUE, but must be RULE".
[[noreturn]] inline void refuse(const std::string& what, const std::string& value, const std::string& rule) {
    throw std::invalid_argument(what + " is " + value + ", but must be " + rule);
}

[[nodiscard]] inline bool is_finite(std::floating_point auto x) { return std::isfinite(x); }
[[nodiscard]] inline bool is_finite(glm::vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

inline void require_finite(const auto& value, const char* what) {
    if (!is_finite(value)) refuse(what, to_text(value), "finite");
}

inline void require_positive(float value, const char* what) {
    if (!(value > 0 && is_finite(value))) refuse(what, to_text(value), "positive and finite");
}

inline void require_not_negative(float value, const char* what) {
    if (!(value >= 0 && is_finite(value))) refuse(what, to_text(value), "finite and not negative");
}

/// For colours, intensities and radiances.
inline void require_not_negative(glm::vec3 value, const char* what) {
    if (!(value.x >= 0 && value.y >= 0 && value.z >= 0 && is_finite(value)))
        refuse(what, to_text(value), "finite and not negative");
}

/// Calls the `validate` beside a type, or beside the alternative that a variant holds. A type without one is content.
template <class T>
void validate_if_possible(const T& value) {
    with_alternative(value, [](const auto& kind) {
        if constexpr (requires { validate(kind); }) validate(kind);
    });
}

/// The same for each element; the message begins with which one it is: "things[3]: sphere: radius is …".
void validate_each(const std::ranges::input_range auto& values, const char* what) {
    std::size_t i = 0;
    for (const auto& value : values) {
        try {
            validate_if_possible(value);
        } catch (const std::invalid_argument& problem) {
            throw std::invalid_argument(std::string(what) + "[" + std::to_string(i) + "]: " + problem.what());
        }
        ++i;
    }
}

}  // namespace lantern
