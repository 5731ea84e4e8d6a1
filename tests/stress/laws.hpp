// SPDX-License-Identifier: MIT
#pragma once
// For cases that need no file of truths: laws, with inputs from dice.

#include "oracle.hpp"  // dice
#include "scorecard.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace stress {

inline constexpr std::uint32_t variants = 256;

/// The dice of variant i: the same on every machine.
inline dice dice_of(std::uint32_t i, std::uint64_t salt) { return {.state = (salt << 32) + i}; }

inline bool is_finite(glm::vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// All digits, for whoever wants to try it again.
inline std::string shown(std::initializer_list<glm::vec3> vectors) {
    std::string text;
    for (const glm::vec3 v : vectors) {
        std::array<char, 100> numbers{};
        std::snprintf(numbers.data(), numbers.size(), " (%.9g, %.9g, %.9g)", double(v.x), double(v.y), double(v.z));
        text += numbers.data();
    }
    return text;
}

/// How many floats lie between two of the same sign; 1e30 where that makes no sense.
inline double places(float a, float b) {
    if (a == b) return 0;
    if (!(std::isfinite(a) && std::isfinite(b) && (a > 0) == (b > 0))) return 1e30;
    const auto x = std::int64_t{std::bit_cast<std::int32_t>(a)}, y = std::int64_t{std::bit_cast<std::int32_t>(b)};
    return static_cast<double>(x > y ? x - y : y - x);
}

/// Adds a case: about, source, what it asks for, and its body for one variant.
inline void add(std::vector<test_case>& cases, std::string id, std::string about, std::string source, std::string margin, auto asked,
                auto body) {
    cases.push_back({std::move(id), std::move(about), std::move(source), std::move(margin), 2, 0.501,
                     [asked](const answers& a) { return bool(asked(a)); },
                     [body](const answers& a, bool, score& s) {
                         for (std::uint32_t i = 0; i < variants; ++i) body(a, s, i);
                     }});
}

}  // namespace stress
