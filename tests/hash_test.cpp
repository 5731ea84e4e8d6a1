// SPDX-License-Identifier: MIT
#include <lantern/hash.hpp>

#include "catch.hpp"
#include "statistics.hpp"

#include <cmath>
#include <map>
#include <vector>

using lantern::hash;
using lantern::permute;

TEST_CASE("hashes are the same on every machine, for ever") {
    STATIC_REQUIRE(hash(0) == 0xe220a8397b1dcdafu);  // the first output of SplitMix64 with the seed 0
    STATIC_REQUIRE(hash(1, 2, 3) == 0xd0734750fde362b3u);
    STATIC_REQUIRE(hash(3, 2, 1) == 0xd62a7f6e291fef64u);
    STATIC_REQUIRE(permute(5, 10, 0x0123456789abcdefu) == 5);
    STATIC_REQUIRE(permute(123'456, 1'000'000, 42) == 992044);
}

TEST_CASE("every bit of the input changes every bit of the hash half of the time") {
    constexpr int tries = 4000;
    for (int bit = 0; bit < 64; bit += 3) {
        std::vector<double> flips(64);
        for (std::uint64_t i = 0; i < tries; ++i) {
            const std::uint64_t changed = hash(i, 7u) ^ hash(i ^ (std::uint64_t{1} << bit), 7u);
            for (std::size_t out = 0; out < 64; ++out) flips[out] += static_cast<double>((changed >> out) & 1);
        }
        for (const double f : flips) CHECK(std::abs(f - tries / 2.0) < 5.5 * std::sqrt(tries / 4.0));
    }
}

TEST_CASE("a unit number is never 0, never 1, and one half on the average") {
    STATIC_REQUIRE(lantern::to_unit(0) == 0x1p-24f);
    STATIC_REQUIRE(lantern::to_unit(0xffffffffu) == 1 - 0x1p-24f);
    double sum = 0;
    for (std::uint32_t i = 0; i < (1u << 23); ++i) sum += double{lantern::to_unit(i << 9)};
    CHECK(sum == 0x1p22);
}

TEST_CASE("a permutation takes every value once") {
    for (const std::uint32_t count : {1u, 2u, 3u, 4u, 7u, 10u, 16u, 31u, 100u, 1000u, 1024u, 4097u}) {
        for (std::uint64_t key = 0; key < 20; ++key) {
            std::vector<int> seen(count);
            for (std::uint32_t i = 0; i < count; ++i) {
                const std::uint32_t p = permute(i, count, hash(key));
                REQUIRE(p < count);
                ++seen[p];
            }
            CHECK(seen == std::vector<int>(count, 1));
        }
    }
}

TEST_CASE("the largest permutations do not overflow") {
    for (const std::uint32_t count : {0x80000000u, 0x80000001u, 0xffffffffu})
        for (std::uint64_t key = 0; key < 100; ++key) CHECK(permute(count - 1, count, hash(key)) < count);
}

TEST_CASE("all 24 orders of four things come up, about equally often") {
    std::map<std::uint32_t, double> frequency;
    constexpr int keys = 24'000;
    for (std::uint64_t key = 0; key < keys; ++key) {
        std::uint32_t order = 0;
        for (std::uint32_t i = 0; i < 4; ++i) order = order * 4 + permute(i, 4, hash(key));
        ++frequency[order];
    }
    CHECK(frequency.size() == 24);
    for (const auto& [order, f] : frequency) CHECK(std::abs(f - keys / 24.0) < .15 * keys / 24);
}

TEST_CASE("two things are put anywhere together, whatever the number of things") {
    constexpr int keys = 20'000;
    for (const std::uint32_t count : {5u, 8u, 16u}) {
        for (const std::uint32_t other : {1u, count / 2, count - 1}) {
            std::vector<double> pairs(count * count);
            for (std::uint64_t key = 0; key < keys; ++key)
                ++pairs[permute(0, count, hash(key)) * count + permute(other, count, hash(key))];
            std::vector<double> expected(count * count, keys / (count * (count - 1.0)));
            for (std::uint32_t i = 0; i < count; ++i) expected[i * count + i] = 0;
            CAPTURE(count, other);
            CHECK(statistics::chi_square_test(pairs, expected) > statistics::false_alarm);
        }
    }
}
