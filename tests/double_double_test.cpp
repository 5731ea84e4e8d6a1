// SPDX-License-Identifier: MIT
#include <lantern/double_double.hpp>

#include <lantern/hash.hpp>

#include "catch.hpp"

#include <cstdint>
#include <utility>

using namespace lantern;

namespace {

/// Whole numbers of up to 31 bits, of either sign: their products are exact in 64 bits, and the oracle is arithmetic in those.
std::int64_t whole(std::uint64_t i) { return std::int64_t(low(hash(i)) >> 1) - (1 << 30); }

std::int64_t sum_of(double_double x) { return std::int64_t(x.high) + std::int64_t(x.low); }

}  // namespace

TEST_CASE("a product is high + low, exactly") {
    for (std::uint64_t i = 0; i < 10000; ++i) {
        const std::int64_t a = whole(2 * i), b = whole(2 * i + 1);
        REQUIRE(sum_of(two_product(double(a), double(b))) == a * b);
    }
    const double next = 1 + 0x1p-52;  // (1 + e)² = 1 + 2e + e²
    CHECK(two_product(next, next).high == 1 + 0x1p-51);
    CHECK(two_product(next, next).low == 0x1p-104);
}

TEST_CASE("a sum is high + low, exactly, in either order") {
    for (const auto& [a, b] : {std::pair{1.0, 0x1p-60}, std::pair{-0x1p60, 3.0}, std::pair{0x1p53, 1.0}}) {
        CHECK(two_sum(a, b).high == two_sum(b, a).high);
        CHECK(two_sum(a, b).low == two_sum(b, a).low);
    }
    CHECK(two_sum(1, 0x1p-60).high == 1);
    CHECK(two_sum(1, 0x1p-60).low == 0x1p-60);
}

TEST_CASE("sums and products of double-doubles keep what a double loses") {
    const double_double x{1, 0x1p-80};
    CHECK((x - double_double{1}).high == 0x1p-80);
    CHECK((x * x - double_double{1}).high == 0x1p-79);  // 1 + 2 · 2^-80 + 2^-160
    for (std::uint64_t i = 0; i < 10000; ++i) {
        const std::int64_t a = whole(4 * i), b = whole(4 * i + 1), c = whole(4 * i + 2), d = whole(4 * i + 3);
        const double_double difference = two_product(double(a), double(b)) - two_product(double(c), double(d));
        REQUIRE(sum_of(difference) == a * b - c * d);
    }
}

TEST_CASE("a difference of products never has the wrong sign, and changes it with their order") {
    for (std::uint64_t i = 0; i < 10000; ++i) {
        const std::int64_t a = whole(3 * i), b = whole(3 * i + 1), near = whole(3 * i + 2) & 1;
        const double forth = difference_of_products(double(a), double(b), double(b), double(a + near));
        const double back = difference_of_products(double(b), double(a + near), double(a), double(b));
        const std::int64_t exact = a * b - b * (a + near);
        REQUIRE(!(forth > 0 && exact < 0));
        REQUIRE(!(forth < 0 && exact > 0));
        REQUIRE(!(forth > 0 && back > 0));
        REQUIRE(!(forth < 0 && back < 0));
        if (near == 0) REQUIRE(forth == 0);
    }
}
