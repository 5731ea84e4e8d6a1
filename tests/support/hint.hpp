// SPDX-License-Identifier: MIT
#pragma once
// What a failing lab test tells the student besides the numbers.

#include <string>
#include <string_view>

/// `INFO(hint("the picture is upside down", "y grows downwards in pictures, upwards in space", "§1"))`, the first line of
/// a test. `lab check` takes the three lines out of the report again and prints them by their names.
[[nodiscard]] inline std::string hint(std::string_view symptom, std::string_view cause, std::string_view read) {
    return std::string("symptom: ").append(symptom).append("\ncause: ").append(cause).append("\nread: ").append(read);
}
