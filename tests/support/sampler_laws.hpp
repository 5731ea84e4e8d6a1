// SPDX-License-Identifier: MIT
#pragma once
// What every sampler owes to who uses it, as tests that a sampler's own test file calls.

#include "catch.hpp"
#include "statistics.hpp"

#include <lantern/samples.hpp>

#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace laws {

using lantern::purpose;

inline constexpr std::array two_numbers{purpose::film, purpose::lens, purpose::light, purpose::gloss, purpose::scatter};
inline constexpr std::array one_number{purpose::time, purpose::light_choice, purpose::branch, purpose::roulette};

/// Numbers do not depend on what was drawn before, nor in which order.
template <lantern::sampler Sampler>
void order_does_not_matter(const Sampler& set) {
    const auto first = set.at({3, 5}, 7);
    const glm::vec2 lens = first.draw2(purpose::lens);
    const float time = first.draw1(purpose::time);
    const glm::vec2 light = first.draw2(purpose::light, 2), film = first.draw2(purpose::film);
    const glm::vec2 bounce = first.branch(1).draw2(purpose::light);

    const auto again = set.at({3, 5}, 7);
    CHECK(again.branch(1).draw2(purpose::light) == bounce);
    CHECK(again.draw2(purpose::film) == film);
    CHECK(again.draw2(purpose::film) == film);
    CHECK(again.draw2(purpose::light, 2) == light);
    CHECK(again.draw1(purpose::time) == time);
    CHECK(again.draw2(purpose::lens) == lens);
}

/// Everything that names a number makes a difference: pixel, sample, purpose, which, path, seed, one number or two.
template <lantern::sampler Sampler>
void every_name_counts(Sampler set) {
    const auto source = set.at({3, 5}, 2);
    std::vector<float> drawn;
    const auto note = [&](const auto& s, purpose p, std::uint32_t which) {
        const glm::vec2 two = s.draw2(p, which);
        drawn.insert(drawn.end(), {s.draw1(p, which), two.x, two.y});
    };
    for (const purpose p : two_numbers)
        for (std::uint32_t which = 0; which < 3; ++which) note(source, p, which);
    for (std::uint32_t k = 0; k < 3; ++k) {
        note(source.branch(k), purpose::film, 0);
        note(source.branch(k).branch(0), purpose::film, 0);
    }
    note(set.at({5, 3}, 2), purpose::film, 0);
    note(set.at({4, 5}, 2), purpose::film, 0);
    note(set.at({3, 5}, 3), purpose::film, 0);
    note(set.at({3, 5}, 2 + set.count()), purpose::film, 0);  // the next set
    ++set.seed;
    note(set.at({3, 5}, 2), purpose::film, 0);
    std::sort(drawn.begin(), drawn.end());
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        CHECK(drawn[i] > 0);
        CHECK(drawn[i] < 1);
        if (i > 0) CHECK(drawn[i] != drawn[i - 1]);
    }
}

/// At any number of samples the mean is right, and so is each sample by itself: then so is every subset.
template <lantern::sampler Sampler>
void is_unbiased(Sampler set) {
    const std::uint32_t n = set.count();
    CAPTURE(n);
    const std::uint64_t seeds = n > 100 ? 400 : 10'000;
    statistics::mean edge, bump, late;
    std::array<std::vector<double>, 3> where;
    where.fill(std::vector<double>(16));
    for (set.seed = 0; set.seed < seeds; ++set.seed) {
        double inside = 0, height = 0, after = 0;
        for (std::uint32_t i = 0; i < n; ++i) {
            const auto source = set.at({1, 2}, i);
            const glm::dvec2 p(source.draw2(purpose::lens));
            inside += p.x + .6180339887 * p.y < .7;
            height += p.x * p.x * p.y;
            after += source.draw1(purpose::time) > .7f;
        }
        edge.add(inside / n);
        bump.add(height / n);
        late.add(after / n);
    }
    CHECK(std::abs(edge.z(.7 - .6180339887 / 2)) < statistics::z_limit);
    CHECK(std::abs(bump.z(1.0 / 6)) < statistics::z_limit);
    // Where the strata fit, every set has the same share, which differs from .3 by less than a stratum.
    if (late.variance() > 1e-20) CHECK(std::abs(late.z(.3)) < statistics::z_limit);

    for (set.seed = 0; set.seed < 8000; ++set.seed) {
        const std::array chosen{0u, n / 2, n - 1};
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec2 p = set.at({1, 2}, chosen[k]).draw2(purpose::lens);
            ++where[k][statistics::cell(double{p.x}, 4) * 4 + statistics::cell(double{p.y}, 4)];
        }
    }
    for (const auto& counts : where) CHECK(statistics::chi_square_test(counts) > statistics::false_alarm);
}

/// Two sequences of a pixel, correlated over its samples. Unrelated ones have a correlation of mean 0 and of variance
/// 1/(n - 1), exactly so for random pairings. The swirls of a shared pattern would be a correlation of 1.
template <class Left, class Right>
[[nodiscard]] bool unrelated(std::uint32_t n, Left left, Right right) {
    statistics::mean correlation, square;
    for (std::uint32_t pixel = 0; pixel < 300; ++pixel) {
        double sx = 0, sy = 0, sxx = 0, syy = 0, sxy = 0;
        for (std::uint32_t i = 0; i < n; ++i) {
            const double x = left(glm::uvec2{pixel, 2 * pixel}, i), y = right(glm::uvec2{pixel, 2 * pixel}, i);
            sx += x, sy += y, sxx += x * x, syy += y * y, sxy += x * y;
        }
        const double r = (n * sxy - sx * sy) / std::sqrt((n * sxx - sx * sx) * (n * syy - sy * sy));
        correlation.add(r);
        square.add(r * r * (n - 1));
    }
    return std::abs(correlation.z(0)) < statistics::z_limit &&
           square.value() < 1 + statistics::z_limit * square.standard_error();
}

/// Purposes are unrelated to each other, within a pixel and with the neighbour's; so are lights and branches.
template <lantern::sampler Sampler>
void purposes_are_unrelated(const Sampler& set) {
    const std::uint32_t n = set.count();
    const auto two = [&](purpose p, glm::uvec2 aside, std::uint32_t which, int axis) {
        return [=, &set](glm::uvec2 pixel, std::uint32_t i) {
            return double{set.at(pixel + aside, i).draw2(p, which)[axis]};
        };
    };
    const auto one = [&](purpose p, glm::uvec2 aside) {
        return [=, &set](glm::uvec2 pixel, std::uint32_t i) { return double{set.at(pixel + aside, i).draw1(p)}; };
    };
    const auto bounced = [&](std::uint32_t k) {
        return [k, &set](glm::uvec2 pixel, std::uint32_t i) {
            return double{set.at(pixel, i).branch(k).draw2(purpose::gloss).x};
        };
    };
    const glm::uvec2 here{0, 0};
    for (std::size_t a = 0; a < two_numbers.size(); ++a) {
        for (std::size_t b = a + 1; b < two_numbers.size(); ++b) {
            CAPTURE(n, a, b);
            CHECK(unrelated(n, two(two_numbers[a], here, 0, 0), two(two_numbers[b], here, 0, 0)));
            CHECK(unrelated(n, two(two_numbers[a], here, 0, 1), two(two_numbers[b], here, 0, 0)));
        }
        CAPTURE(n, a);
        CHECK(unrelated(n, two(two_numbers[a], here, 0, 0), one(purpose::time, here)));
        CHECK(unrelated(n, two(two_numbers[a], here, 0, 1), one(purpose::time, here)));
        CHECK(unrelated(n, two(two_numbers[a], here, 0, 0), two(two_numbers[a], {1, 0}, 0, 0)));
        CHECK(unrelated(n, two(two_numbers[a], here, 0, 1), two(two_numbers[a], {0, 1}, 0, 1)));
    }
    CHECK(unrelated(n, one(purpose::time, here), one(purpose::branch, here)));
    CHECK(unrelated(n, one(purpose::time, here), one(purpose::time, {1, 0})));
    CHECK(unrelated(n, two(purpose::light, here, 0, 0), two(purpose::light, here, 1, 0)));
    CHECK(unrelated(n, two(purpose::light, here, 1, 1), two(purpose::light, here, 2, 1)));
    CHECK(unrelated(n, two(purpose::gloss, here, 0, 0), bounced(0)));
    CHECK(unrelated(n, bounced(0), bounced(1)));
}

/// How many of columns × rows equal cells hold exactly one of the points. Those on a line within 2^-23 of a cell's border
/// count for the side that they were rounded to; columns and rows are powers of two where that must not be.
inline bool one_in_each(const std::vector<glm::vec2>& points, std::size_t columns, std::size_t rows) {
    std::vector<int> held(columns * rows);
    for (const glm::vec2 p : points)
        ++held[statistics::cell(double{p.y}, rows) * columns + statistics::cell(double{p.x}, columns)];
    return held == std::vector<int>(columns * rows, 1);
}

/// Calls f(name, points) with the whole set of every purpose, of several lights, and at later hits.
template <lantern::sampler Sampler, class F>
void for_each_set(const Sampler& set, F f) {
    const auto gather = [&](auto draw) {
        std::vector<glm::vec2> points;
        for (std::uint32_t i = 0; i < set.count(); ++i) points.push_back(draw(set.at({7, 9}, i)));
        return points;
    };
    for (const purpose p : two_numbers) {
        for (std::uint32_t which = 0; which < 2; ++which) f(gather([=](const auto& s) { return s.draw2(p, which); }));
        f(gather([=](const auto& s) { return s.branch(1).draw2(p); }));
    }
}
template <lantern::sampler Sampler, class F>
void for_each_line(const Sampler& set, F f) {
    const auto gather = [&](auto draw) {
        std::vector<glm::vec2> points;
        for (std::uint32_t i = 0; i < set.count(); ++i) points.push_back({draw(set.at({7, 9}, i)), .5f});
        return points;
    };
    for (const purpose p : one_number) {
        for (std::uint32_t which = 0; which < 2; ++which) f(gather([=](const auto& s) { return s.draw1(p, which); }));
        f(gather([=](const auto& s) { return s.branch(0).draw1(p); }));
    }
    f(gather([=](const auto& s) { return s.draw1(purpose::film); }));
}

}  // namespace laws
