// SPDX-License-Identifier: MIT
#include <lantern/lanes.hpp>

#include <lantern/double_double.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

using lantern::doubles;
using lantern::floats;
using lantern::integers;
using lantern::long_integers;

TEST_CASE("the smaller and the larger, lane by lane") {
    const floats a{1, -2, 3, 0, 5, 1e30f, -7, 8}, b{2, -3, 3, 1, 4, -1e30f, -6, 8};
    floats small = a, large = a;
    lantern::keep_smaller(small, b);
    lantern::keep_larger(large, b);
    for (int i = 0; i < 8; ++i) {
        CHECK(small[i] == std::min(a[i], b[i]));
        CHECK(large[i] == std::max(a[i], b[i]));
    }
}

TEST_CASE("lanes where a comparison holds become bits") {
    for (std::uint32_t wish = 0; wish < 256; ++wish) {
        floats x{};
        for (int i = 0; i < 8; ++i) x[i] = (wish >> i & 1) != 0 ? 1.0f : -1.0f;
        REQUIRE(lantern::lanes_of(integers(x > 0)) == wish);
        const doubles y{x[0], x[1], x[2], x[3]};
        REQUIRE(lantern::lanes_of(long_integers(y > 0)) == (wish & 15));
    }
}

TEST_CASE("widening is exact") {
    const std::array<float, 5> from{0, 0.1f, -1e30f, 1e-40f, 7};
    doubles to;
    lantern::widen(from.data() + 1, to);  // from any address
    for (int i = 0; i < 4; ++i) CHECK(to[i] == double(from[static_cast<std::size_t>(i) + 1]));
}

TEST_CASE("each lane computes what the scalar does, to the last bit") {
    dice d{.state = 1};
    for (int k = 0; k < 5000; ++k) {
        doubles a, b, c, sum;
        for (int i = 0; i < 4; ++i) {
            a[i] = d.unit() - 0.5;
            b[i] = d.unit() - 0.5;
            c[i] = k % 2 == 0 ? -a[i] * b[i] : d.unit();  // what cancels but for the rounding
        }
        lantern::multiply_add(a, b, c, sum);
        for (int i = 0; i < 4; ++i) REQUIRE(sum[i] == lantern::multiply_add(a[i], b[i], c[i]));
    }
}

TEST_CASE("eight lanes are two halves") {
    const lantern::floats all{1, 2, 3, 4, 5, 6, 7, 8};
    lantern::quad first, last;
    lantern::take_apart(all, first, last);
    for (int i = 0; i < 4; ++i) CHECK((first[i] == all[i] && last[i] == all[i + 4]));
    lantern::floats again;
    lantern::put_together(last, first, again);
    for (int i = 0; i < 4; ++i) CHECK((again[i] == all[i + 4] && again[i + 4] == all[i]));
}
