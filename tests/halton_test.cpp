// SPDX-License-Identifier: MIT
#include <lantern/halton.hpp>

#include "catch.hpp"
#include "sampler_laws.hpp"

#include <algorithm>
#include <stdexcept>

using lantern::halton;
using lantern::purpose;
using lantern::radical_inverse;

static_assert(lantern::sampler<halton> && lantern::pattern<halton>);

TEST_CASE("a radical inverse mirrors the digits at the point") {
    STATIC_REQUIRE(radical_inverse<2>(0) == 0);
    STATIC_REQUIRE(radical_inverse<2>(1) == 0x80000000u);  // .1 in base two
    STATIC_REQUIRE(radical_inverse<2>(6) == 0x60000000u);  // 110 becomes .011
    STATIC_REQUIRE(radical_inverse<2>(0xffffffffu) == 0xffffffffu);
    STATIC_REQUIRE(radical_inverse<3>(1) == 0x55555555u);  // a third, rounded down
    STATIC_REQUIRE(radical_inverse<3>(5) == 0xc71c71c7u);  // 12 becomes .21 in base three: 7/9
    STATIC_REQUIRE(radical_inverse<5>(1) == 0x33333333u);
    for (std::uint32_t i = 0; i < 1000; ++i) {
        double slow = 0, digit = 1.0 / 3;
        for (std::uint32_t rest = i; rest > 0; rest /= 3, digit /= 3) slow += digit * (rest % 3);
        CHECK(std::abs(radical_inverse<3>(i) * 0x1p-32 - slow) < 0x1p-31);
    }
}

TEST_CASE("halton: the numbers are the same on every machine, to the last bit") {
    const halton set{.samples = 10, .seed = 1};
    CHECK(set.at({12, 34}, 5).draw2(purpose::film) == glm::vec2(6911753, 12020043) * 0x1p-24f);
    CHECK(set.at({12, 34}, 5).branch(1).draw1(purpose::time, 2) == 11955267 * 0x1p-24f);
}

TEST_CASE("halton: a number depends on what it is for, and on nothing else") {
    laws::order_does_not_matter(halton{});
    laws::every_name_counts(halton{});
}

TEST_CASE("halton: no number of samples is biased: 10, 1000 and 1024") {
    for (const std::uint32_t n : {1u, 10u, 1000u, 1024u}) laws::is_unbiased(halton{.samples = n});
}

TEST_CASE("halton: purposes, pixels, lights and bounces are unrelated") {
    laws::purposes_are_unrelated(halton{.samples = 8});
    laws::purposes_are_unrelated(halton{.samples = 27});
}

TEST_CASE("halton: a count that cannot be is refused") {
    CHECK_THROWS_WITH(halton{.samples = 0}.count(), containing("halton: samples is 0"));
    CHECK_THROWS_AS((halton{.samples = 0}.at({0, 0}, 0)), std::invalid_argument);
    CHECK_THROWS_WITH(halton{.samples = 0x80000001u}.count(), containing("at most 2147483648"));
}

TEST_CASE("halton: each purpose is evenly spread by itself, whatever the count") {
    for (const std::uint32_t n : {10u, 16u, 27u, 100u}) {
        // The base-2 discrepancy bound of the van der Corput sequence: no gap on the circle is wider than 2/n.
        const auto widest_gap = [&](std::vector<float> x) {
            std::sort(x.begin(), x.end());
            float gap = x.front() + 1 - x.back();
            for (std::size_t i = 1; i < x.size(); ++i) gap = std::max(gap, x[i] - x[i - 1]);
            return gap * static_cast<float>(n);
        };
        const auto check = [&](const auto& points) {
            std::vector<float> x;
            for (const glm::vec2 p : points) x.push_back(p.x);
            CHECK(widest_gap(x) < 2.001f);
        };
        laws::for_each_set(halton{.samples = n}, check);
        laws::for_each_line(halton{.samples = n}, check);
    }
}
