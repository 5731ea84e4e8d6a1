// SPDX-License-Identifier: MIT
#pragma once
// Catch2, version 3 or 2.13: whichever the build found.

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_approx.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/catch_tostring.hpp>
#include <catch2/generators/catch_generators_all.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
using Catch::Approx;  // as in version 2
#else
#include <catch2/catch.hpp>
#endif

#include <glm/detail/qualifier.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <iomanip>
#include <sstream>
#include <string>

/// Vectors show their numbers when a test fails: nine digits, which tell every float, and no 0 for 1e-25.
template <glm::length_t L, class T, glm::qualifier Q>
struct Catch::StringMaker<glm::vec<L, T, Q>> {
    static std::string convert(const glm::vec<L, T, Q>& v) {
        std::ostringstream text;
        text << std::setprecision(9);
        for (glm::length_t i = 0; i < L; ++i) text << (i == 0 ? "(" : ", ") << +v[i];
        return text.str() + ")";
    }
};

/// For CHECK_THROWS_WITH and CHECK_THAT: the text contains `part`. The matcher's name differs between the versions.
inline auto containing(const std::string& part) {
#if __has_include(<catch2/catch_all.hpp>)
    return Catch::Matchers::ContainsSubstring(part);
#else
    return Catch::Matchers::Contains(part);
#endif
}
