// SPDX-License-Identifier: MIT
// The library rests on `double(float(x))` rounding. GCC 12's vectoriser forgets that it does; see cmake/numerics.cmake.

#include "catch.hpp"

#include <glm/vec3.hpp>

namespace {

[[gnu::noinline]] glm::dvec3 rounded(glm::dvec3 v) { return glm::dvec3(glm::vec3(v)); }

}  // namespace

TEST_CASE("a double that passes through a float is rounded") {
    const volatile double tenth = 0.1;
    const glm::dvec3 r = rounded({tenth, tenth, tenth});
    CHECK(r.x == double(0.1f));
    CHECK(r.y == double(0.1f));
    CHECK(r.z == double(0.1f));
}

TEST_CASE("products are not fused with sums, so that every machine computes the same image") {
    // 1 + 2^-12 squared is 1 + 2^-11 + 2^-24; the last term is lost when the product is rounded by itself.
    const volatile float x = 1 + 0x1p-12f, y = -(1 + 0x1p-11f);
    const float a = x, b = y;
#ifdef LANTERN_ALLOW_FP_CONTRACT
    CHECK((a * a + b == 0 || a * a + b == 0x1p-24f));
#else
    CHECK(a * a + b == 0);
#endif
}
