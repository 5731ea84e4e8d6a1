// SPDX-License-Identifier: MIT
#include <lantern/sobol.hpp>

#include "catch.hpp"
#include "sampler_laws.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <set>
#include <stdexcept>

using lantern::packing;
using lantern::purpose;
using lantern::sobol;

static_assert(lantern::sampler<sobol>);

TEST_CASE("sobol: the numbers are the same on every machine, to the last bit") {
    const auto packed = sobol{.samples = 64, .seed = 1}.at({12, 34}, 5);
    CHECK(packed.draw2(purpose::scatter) == glm::vec2(12286961, 13413033) * 0x1p-24f);
    CHECK(packed.draw1(purpose::time) == 7207203 * 0x1p-24f);
    const auto bounced = sobol{.samples = 10, .seed = 1}.at({12, 34}, 5).branch(1);
    CHECK(bounced.draw1(purpose::time, 2) == 4045807 * 0x1p-24f);
}

TEST_CASE("sobol: a number depends on what it is for, and on nothing else") {
    laws::order_does_not_matter(sobol{});
    laws::every_name_counts(sobol{});
}

TEST_CASE("sobol: no number of samples is biased: 10, 1000 and 1024") {
    for (const std::uint32_t n : {1u, 2u, 3u, 10u, 1000u, 1024u}) {
        laws::is_unbiased(sobol{.samples = n});
        laws::is_unbiased(sobol{.samples = n, .packed = {}});
    }
}

TEST_CASE("sobol: purposes, pixels, lights and bounces are unrelated") {
    laws::purposes_are_unrelated(sobol{.samples = 16, .packed = {}});
    laws::purposes_are_unrelated(sobol{.samples = 10, .packed = {}});
}

TEST_CASE("sobol: a pixel without samples is refused") {
    CHECK_THROWS_WITH(sobol{.samples = 0}.count(), containing("sobol: samples is 0"));
    CHECK_THROWS_AS((sobol{.samples = 0}.at({0, 0}, 0)), std::invalid_argument);
}

TEST_CASE("sobol: every purpose by itself is a net: all boxes of equal area hold one sample") {
    for (const std::uint32_t n : {4u, 16u, 128u, 1024u}) {
        const auto check = [&](const auto& points) {
            for (std::uint32_t columns = 1; columns <= n; columns *= 2)
                CHECK(laws::one_in_each(points, columns, n / columns));
        };
        laws::for_each_set(sobol{.samples = n}, check);
        laws::for_each_set(sobol{.samples = n, .packed = {}}, check);
        laws::for_each_line(sobol{.samples = n}, [&](const auto& points) { CHECK(laws::one_in_each(points, n, 1)); });
    }
}

TEST_CASE("sobol: what is packed is spread together: film and lens in four dimensions, film and time in three") {
    constexpr std::uint32_t n = 1024;
    const sobol set{.samples = n};
    std::vector<int> four(256), three(512);  // boxes that hold 4 and 2 samples on the average
    for (std::uint32_t i = 0; i < n; ++i) {
        const auto s = set.at({2, 3}, i);
        const glm::dvec2 film(s.draw2(purpose::film)), lens(s.draw2(purpose::lens));
        const double time = s.draw1(purpose::time);
        const auto cell = [](double x, std::size_t cells) { return statistics::cell(x, cells); };
        ++four[((cell(film.x, 4) * 4 + cell(film.y, 4)) * 4 + cell(lens.x, 4)) * 4 + cell(lens.y, 4)];
        ++three[(cell(film.x, 8) * 8 + cell(film.y, 8)) * 8 + cell(time, 8)];
    }
    CHECK(*std::max_element(four.begin(), four.end()) <= 8);  // chance would put 11 or more into one of them
    CHECK(*std::min_element(four.begin(), four.end()) >= 1);  // and leave 4 or 5 of them empty
    CHECK(*std::max_element(three.begin(), three.end()) <= 4);
}

TEST_CASE("sobol: leaving an effect out changes nothing else; a packing of one's own changes what it names") {
    const sobol all{.samples = 16}, few{.samples = 16, .packed = {purpose::film, purpose::light}};
    int moved = 0;
    for (std::uint32_t i = 0; i < 16; ++i) {
        const auto a = all.at({0, 0}, i), b = few.at({0, 0}, i);
        CHECK(a.draw2(purpose::film) == b.draw2(purpose::film));
        CHECK(a.draw2(purpose::light, 1) == b.draw2(purpose::light, 1));
        CHECK(a.branch(0).draw2(purpose::gloss) == b.branch(0).draw2(purpose::gloss));
        moved += a.draw2(purpose::light) != b.draw2(purpose::light);
    }
    CHECK(moved > 8);
}

TEST_CASE("a packing knows the place of each purpose, and refuses one named twice") {
    const packing p{purpose::film, purpose::time};
    CHECK(p.slot(purpose::film) == 0);
    CHECK(p.slot(purpose::time) == 1);
    CHECK(p.slot(purpose::lens) == packing::absent);
    CHECK(p.slot(static_cast<purpose>(1000)) == packing::absent);
    CHECK_THROWS_WITH((packing{purpose::film, purpose::film}), containing("packing") && containing("named once"));
    CHECK_THROWS_AS(packing{static_cast<purpose>(1000)}, std::invalid_argument);
    CHECK_NOTHROW(packing{purpose::film, purpose::lens, purpose::time, purpose::light, purpose::light_choice,
                          purpose::gloss, purpose::scatter, purpose::branch, purpose::roulette, purpose::user});
}

TEST_CASE("Owen's scramble: the coins of any two nodes of the tree are fair and independent") {
    constexpr std::uint32_t nodes = 31;  // of five levels: node 0 is the root, then 0, 1, then 00, 01, 10, 11, …
    std::vector<std::vector<double>> pairs(nodes * nodes, std::vector<double>(4));
    for (std::uint64_t seed = 0; seed < 4000; ++seed) {
        const std::uint32_t key = lantern::low(lantern::hash(seed));
        std::array<std::uint32_t, nodes> coin{};
        for (std::uint32_t node = 0; node < nodes; ++node) {
            const auto level = static_cast<std::uint32_t>(std::bit_width(node + 1) - 1),
                       above = node + 1 - (1u << level);
            coin[node] = (lantern::detail::mirrored_scramble(above, key) >> level) & 1;
        }
        for (std::uint32_t a = 0; a < nodes; ++a)
            for (std::uint32_t b = a + 1; b < nodes; ++b) ++pairs[a * nodes + b][2 * coin[a] + coin[b]];
    }
    for (std::uint32_t a = 0; a < nodes; ++a)
        for (std::uint32_t b = a + 1; b < nodes; ++b)
            CHECK(statistics::chi_square_test(pairs[a * nodes + b]) > statistics::false_alarm);
}

TEST_CASE("Owen's scramble keeps aligned blocks together: a bit depends on those below it only") {
    for (std::uint32_t i = 0; i < 2000; ++i) {
        const std::uint32_t x = lantern::low(lantern::hash(i, 1u)), key = lantern::low(lantern::hash(i, 2u));
        const std::uint32_t y = lantern::detail::mirrored_scramble(x, key);
        for (int bit = 0; bit < 32; ++bit) {
            const std::uint32_t changed = y ^ lantern::detail::mirrored_scramble(x ^ (1u << bit), key);
            REQUIRE((changed & ((2u << bit) - 1)) == (1u << bit));
        }
    }
}

TEST_CASE("every slot carries the indices of an aligned block over to an aligned block") {
    for (const auto& matrix : lantern::detail::sobol_slots) {
        for (const std::uint32_t n : {2u, 16u, 256u}) {
            std::set<std::uint32_t> seen;
            for (std::uint32_t i = 0; i < n; ++i) seen.insert(lantern::detail::times(matrix, i));
            CHECK(seen.size() == n);
            CHECK(*seen.rbegin() == n - 1);
        }
    }
}
