// SPDX-License-Identifier: MIT
#include <lantern/samples.hpp>

#include "catch.hpp"
#include "counting_source.hpp"
#include "sampler_laws.hpp"

#include <glm/common.hpp>

#include <stdexcept>

using lantern::correlated_multi_jittered;
using lantern::independent;
using lantern::jittered;
using lantern::multi_jittered;
using lantern::n_rooks;
using lantern::purpose;

static_assert(lantern::sampler<independent> && lantern::sampler<n_rooks> && lantern::sampler<jittered>);
static_assert(lantern::sampler<multi_jittered> && lantern::sampler<correlated_multi_jittered>);
static_assert(lantern::pattern<independent> && lantern::pattern<correlated_multi_jittered>);
static_assert(lantern::sample_source<counting_source>);
static_assert(!lantern::sampler<int> && !lantern::sample_source<int>);

namespace {

/// A rule of one's own is a sampler after three lines: `source_of` does the rest.
struct everything_in_the_middle {
    std::uint64_t seed = 0;
    static std::uint32_t count() { return 1; }
    static std::uint32_t place1(std::uint32_t, std::uint64_t) { return 1u << 31; }
    static glm::uvec2 place2(std::uint32_t, std::uint64_t) { return {1u << 31, 1u << 31}; }
    [[nodiscard]] auto at(glm::uvec2 pixel, std::uint32_t i) const { return lantern::source_of(*this, pixel, i); }
};
static_assert(lantern::sampler<everything_in_the_middle>);

}  // namespace

TEST_CASE("the numbers are the same on every machine, to the last bit") {
    const auto film = [](const auto& set) { return set.at({12, 34}, 5).draw2(purpose::film); };
    const auto time = [](const auto& set) { return set.at({12, 34}, 5).branch(1).draw1(purpose::time, 2); };
    CHECK(film(independent{.samples = 16, .seed = 1}) == glm::vec2(12841567, 16328179) * 0x1p-24f);
    CHECK(time(independent{.samples = 16, .seed = 1}) == 10658883 * 0x1p-24f);
    CHECK(film(n_rooks{.samples = 16, .seed = 1}) == glm::vec2(8598103, 808803) * 0x1p-24f);
    CHECK(time(n_rooks{.samples = 16, .seed = 1}) == 13622105 * 0x1p-24f);
    CHECK(film(jittered{.side = 4, .seed = 1}) == glm::vec2(837981, 11623823) * 0x1p-24f);
    CHECK(time(jittered{.side = 4, .seed = 1}) == 13622105 * 0x1p-24f);
    CHECK(film(multi_jittered{.side = 4, .seed = 1}) == glm::vec2(2306647, 9197411) * 0x1p-24f);
    CHECK(time(multi_jittered{.side = 4, .seed = 1}) == 13622105 * 0x1p-24f);
    CHECK(film(correlated_multi_jittered{.samples = 10, .seed = 1}) == glm::vec2(10066037, 9682693) * 0x1p-24f);
    CHECK(time(correlated_multi_jittered{.samples = 10, .seed = 1}) == 1662709 * 0x1p-24f);
}

TEMPLATE_TEST_CASE("a number depends on what it is for, and on nothing else", "", independent, n_rooks, jittered,
                   multi_jittered, correlated_multi_jittered) {
    laws::order_does_not_matter(TestType{});
    laws::every_name_counts(TestType{});
}

TEST_CASE("no number of samples is biased: 10, 1000 and 1024") {
    for (const std::uint32_t n : {10u, 1000u, 1024u}) {
        laws::is_unbiased(independent{.samples = n});
        laws::is_unbiased(n_rooks{.samples = n});
        laws::is_unbiased(correlated_multi_jittered{.samples = n});
    }
    laws::is_unbiased(jittered::of(1024));
    laws::is_unbiased(multi_jittered::of(1024));
    for (const std::uint32_t n : {1u, 2u, 3u, 5u, 17u}) laws::is_unbiased(correlated_multi_jittered{.samples = n});
}

TEST_CASE("a grid that does not fit its count would be biased, and is refused") {
    for (const std::uint32_t n : {0u, 2u, 10u, 1000u, 0xffffffffu}) {
        CHECK_THROWS_AS(jittered::of(n), std::invalid_argument);
        CHECK_THROWS_AS(multi_jittered::of(n), std::invalid_argument);
    }
    CHECK_THROWS_WITH(jittered::of(10),
                      containing("jittered: samples is 10") && containing("a square number such as 9"));
    CHECK_THROWS_WITH(multi_jittered::of(1000), containing("multi_jittered: samples is 1000") && containing("1024"));
    CHECK(jittered::of(1024).side == 32);
    CHECK(jittered::of(65535u * 65535u).count() == 65535u * 65535u);
}

TEST_CASE("a pixel without samples is refused, wherever it is asked for") {
    const auto refuses = [](const auto& set, const char* name) {
        CHECK_THROWS_WITH(set.count(), containing(name));
        CHECK_THROWS_AS(set.at({0, 0}, 0), std::invalid_argument);
    };
    refuses(independent{.samples = 0}, "independent: samples is 0");
    refuses(n_rooks{.samples = 0}, "n_rooks: samples is 0");
    refuses(correlated_multi_jittered{.samples = 0}, "correlated_multi_jittered: samples is 0");
    refuses(jittered{.side = 0}, "jittered: side is 0");
    refuses(multi_jittered{.side = 0}, "multi_jittered: side is 0");
    refuses(jittered{.side = 65536}, "jittered: side is 65536");  // side² would wrap around to 0
}

TEMPLATE_TEST_CASE("purposes, pixels, lights and bounces are unrelated: no swirls", "", independent, n_rooks, jittered,
                   multi_jittered, correlated_multi_jittered) {
    laws::purposes_are_unrelated(TestType{});
    laws::purposes_are_unrelated(TestType{8});
}

TEST_CASE("a shared pattern would be noticed: that is what the test above is for") {
    const jittered set{};
    const auto x = [&](glm::uvec2 pixel, std::uint32_t i) { return double{set.at(pixel, i).draw2(purpose::film).x}; };
    const auto late = [&](glm::uvec2 pixel, std::uint32_t i) { return double{set.at(pixel, i).draw1(purpose::time)}; };
    CHECK_FALSE(laws::unrelated(16, x, x));
    CHECK_FALSE(
        laws::unrelated(16, x, [&](glm::uvec2 pixel, std::uint32_t i) { return .2 * x(pixel, i) + late(pixel, i); }));
    CHECK_FALSE(laws::unrelated(16, x, [&](glm::uvec2 pixel, std::uint32_t i) {  // now with it, now against it
        return pixel.x % 2 == 0 ? x(pixel, i) : -x(pixel, i);
    }));
}

TEST_CASE("N-rooks: one sample in each column and each row, for every purpose") {
    for (const std::uint32_t n : {16u, 64u, 256u}) {
        laws::for_each_set(n_rooks{.samples = n}, [&](const auto& points) {
            CHECK(laws::one_in_each(points, n, 1));
            CHECK(laws::one_in_each(points, 1, n));
        });
    }
}

TEST_CASE("N-rooks: the diagonal is not fixed") {
    std::vector<double> second(16);  // where the row of the sample in column 0 is
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        const n_rooks set{.samples = 16, .seed = seed};
        for (std::uint32_t i = 0; i < 16; ++i) {
            const glm::vec2 p = set.at({0, 0}, i).draw2(purpose::film);
            if (p.x < 1.0f / 16) ++second[statistics::cell(double{p.y}, 16)];
        }
    }
    CHECK(statistics::chi_square_test(second) > statistics::false_alarm);
}

TEST_CASE("jittered: one sample in each cell, for every purpose") {
    for (const std::uint32_t side : {2u, 4u, 16u})
        laws::for_each_set(jittered{.side = side},
                           [&](const auto& points) { CHECK(laws::one_in_each(points, side, side)); });
}

TEST_CASE("jittered: within its cell a sample is anywhere") {
    std::vector<double> where(64);
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        for (std::uint32_t i = 0; i < 16; ++i) {
            const glm::dvec2 p(jittered{.side = 4, .seed = seed}.at({0, 0}, i).draw2(purpose::film));
            const glm::dvec2 q = 4.0 * p - glm::floor(4.0 * p);
            ++where[statistics::cell(q.x, 8) * 8 + statistics::cell(q.y, 8)];
        }
    }
    CHECK(statistics::chi_square_test(where) > statistics::false_alarm);
}

TEST_CASE("multi-jittered, correlated or not: one in each cell, each fine column and each fine row") {
    for (const std::uint32_t side : {2u, 4u, 16u}) {
        const auto check = [&](const auto& points) {
            CHECK(laws::one_in_each(points, side, side));
            CHECK(laws::one_in_each(points, side * side, 1));
            CHECK(laws::one_in_each(points, 1, side * side));
        };
        laws::for_each_set(multi_jittered{.side = side}, check);
        laws::for_each_set(correlated_multi_jittered{.samples = side * side}, check);
    }
}

TEST_CASE("correlated multi-jittered: the rows are strata for any number of samples") {
    for (const std::uint32_t n : {2u, 8u, 32u, 128u, 512u})
        laws::for_each_set(correlated_multi_jittered{.samples = n},
                           [&](const auto& p) { CHECK(laws::one_in_each(p, 1, n)); });
}

TEST_CASE("what wants one number, such as time, has strata of its own: as many as there are samples") {
    for (const std::uint32_t side : {2u, 4u, 16u}) {
        const auto check = [&](const auto& points) { CHECK(laws::one_in_each(points, side * side, 1)); };
        laws::for_each_line(jittered{.side = side}, check);
        laws::for_each_line(multi_jittered{.side = side}, check);
        laws::for_each_line(n_rooks{.samples = side * side}, check);
        laws::for_each_line(correlated_multi_jittered{.samples = side * side}, check);
    }
}
