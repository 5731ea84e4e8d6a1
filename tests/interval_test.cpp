// SPDX-License-Identifier: MIT
#include <lantern/interval.hpp>

#include "catch.hpp"

#include <cmath>
#include <limits>

using lantern::contains;
using lantern::empty;
using lantern::infinity;
using lantern::interval;

namespace {
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
}

TEST_CASE("an interval is open at its beginning and closed at its end") {
    constexpr interval range{1, 2};
    CHECK_FALSE(contains(range, 1.0f));
    CHECK(contains(range, std::nextafter(1.0f, 2.0f)));
    CHECK(contains(range, 2.0f));
    CHECK_FALSE(contains(range, std::nextafter(2.0f, 3.0f)));
}

TEST_CASE("the default interval is all that lies before a ray, without an epsilon") {
    CHECK_FALSE(contains(interval{}, 0.0f));
    CHECK_FALSE(contains(interval{}, -1.0f));
    CHECK(contains(interval{}, std::numeric_limits<float>::denorm_min()));
    CHECK(contains(interval{}, std::numeric_limits<float>::max()));
}

TEST_CASE("infinity and NaN lie in no interval") {
    CHECK_FALSE(contains(interval{}, infinity));
    CHECK_FALSE(contains(interval{}, not_a_number));
    CHECK_FALSE(contains(interval{not_a_number, 1}, 0.5f));
    CHECK_FALSE(contains(interval{0, not_a_number}, 0.5f));
}

TEST_CASE("an interval is empty when it ends where it begins, or before, or is NaN") {
    CHECK(empty(interval{1, 1}));
    CHECK(empty(interval{2, 1}));
    CHECK(empty(interval{not_a_number, 1}));
    CHECK(empty(interval{0, not_a_number}));
    CHECK_FALSE(empty(interval{}));
    CHECK_FALSE(empty(interval{1, std::nextafter(1.0f, 2.0f)}));
}
