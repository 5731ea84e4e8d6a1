// SPDX-License-Identifier: MIT
#pragma once
// As much JSON as the labs' programs write for the tools.

#include <glm/vec3.hpp>

#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace support::json {

/// Nine digits tell every float from every other. What is not finite is null.
[[nodiscard]] inline std::string of(double x) {
    if (!std::isfinite(x)) return "null";
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", x);
    return text;
}
[[nodiscard]] inline std::string of(glm::vec3 v) { return '[' + of(double(v.x)) + ',' + of(double(v.y)) + ',' + of(double(v.z)) + ']'; }

[[nodiscard]] inline std::string of(std::string_view text) {
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        if (static_cast<unsigned char>(c) < 0x20) {
            char code[8];
            std::snprintf(code, sizeof code, "\\u%04x", unsigned(c));
            quoted += code;
        } else {
            quoted += c;
        }
    }
    return quoted + '"';
}

template <class Items, class Write>
[[nodiscard]] std::string list(const Items& items, const Write& write) {
    std::string text = "[";
    for (const auto& item : items) {
        if (text.size() > 1) text += ',';
        text += write(item);
    }
    return text + ']';
}

/// The values are JSON already.
[[nodiscard]] inline std::string object(const std::vector<std::pair<std::string_view, std::string>>& members) {
    std::string text = "{";
    for (const auto& [name, value] : members) {
        if (text.size() > 1) text += ',';
        text += of(name) + ':' + value;
    }
    return text + '}';
}

}  // namespace support::json
