// SPDX-License-Identifier: MIT
#include <lantern/exact_sum.hpp>

#include <lantern/hash.hpp>

#include "catch.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

using lantern::exact_sum;

namespace {

/// A float of any finite size and sign.
float any_float(std::uint64_t i) {
    const std::uint32_t bits = lantern::low(lantern::hash(7u, i));
    const float x = std::bit_cast<float>(bits);
    return std::isfinite(x) ? x : std::bit_cast<float>(bits & ~(1u << 30));
}

exact_sum of(const std::vector<float>& numbers) {
    exact_sum s;
    for (const float x : numbers) s.add(x);
    return s;
}

}  // namespace

TEST_CASE("small integers are added as on paper") {
    CHECK(exact_sum{}.value() == 0);
    CHECK(of({1, 2, 3}).value() == 6);
    CHECK(of({-1, -2, 5}).value() == 2);
    CHECK(of({1, -4}).value() == -3);
    CHECK(of({0.5f, 0.25f}).value() == 0.75);
}

TEST_CASE("what cancels leaves nothing behind, however large it was") {
    const float most = std::numeric_limits<float>::max(), least = std::numeric_limits<float>::denorm_min();
    CHECK(of({most, 1, -most}).value() == 1);
    CHECK(of({most, least, -most}).value() == double{least});
    exact_sum products;
    products.add(most, most);
    products.add(least, least);
    products.add(-most, most);
    CHECK(products.value() == double{least} * double{least});
}

TEST_CASE("order and grouping make no difference to a single bit") {
    std::vector<float> numbers;
    for (std::uint64_t i = 0; i < 3000; ++i) numbers.push_back(any_float(i));
    const exact_sum forwards = of(numbers);
    exact_sum parts[3];
    for (std::size_t i = 0; i < numbers.size(); ++i) parts[i % 3].add(numbers[i]);
    exact_sum together;
    for (const int i : {2, 0, 1}) together.add(parts[i]);
    std::ranges::sort(numbers);
    CHECK(of(numbers) == forwards);
    CHECK(together == forwards);
    CHECK(together.value() == forwards.value());
    CHECK(exact_sum::from(forwards.settled()) == forwards);
}

TEST_CASE("a sum and its mirror image are the same but for the sign") {
    exact_sum plus, minus;
    for (std::uint64_t i = 0; i < 1000; ++i) {
        plus.add(any_float(i), any_float(i + 5000));
        minus.add(-any_float(i), any_float(i + 5000));
    }
    CHECK(minus.value() == -plus.value());
    plus.add(minus);
    CHECK(plus.value() == 0);
}

TEST_CASE("the value is right to two units in the last place of a double") {
    // Integers below 2^24 times powers of two that differ by 40: the sum is known in 64-bit integers.
    for (std::uint64_t round = 0; round < 200; ++round) {
        exact_sum s;
        std::int64_t expected = 0;
        for (std::uint64_t i = 0; i < 50; ++i) {
            const auto x = static_cast<std::int64_t>(lantern::hash(round, i) >> 40) - (1 << 23);
            const int power = static_cast<int>(lantern::hash(i, round) % 33);
            s.add(static_cast<float>(x), std::ldexp(1.0f, power));
            expected += x * (std::int64_t{1} << power);
        }
        const double right = static_cast<double>(expected);
        CHECK(std::abs(s.value() - right) <= 2 * std::abs(right) * std::numeric_limits<double>::epsilon());
    }
}

TEST_CASE("a hundred million equal samples are a hundred million times the sample") {
    exact_sum s, block;
    for (int i = 0; i < 10'000; ++i) block.add(0.1f);
    for (int i = 0; i < 10'000; ++i) s.add(block);
    CHECK(s.value() == Approx(1e8 * double{0.1f}).epsilon(1e-15));
}
