// SPDX-License-Identifier: MIT
#include <lantern/filter.hpp>

#include "catch.hpp"
#include "statistics.hpp"

#include <lantern/halton.hpp>
#include <lantern/samples.hpp>
#include <lantern/sobol.hpp>

#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

using lantern::box_filter;
using lantern::gaussian_filter;
using lantern::mitchell_filter;
using lantern::tent_filter;

static_assert(lantern::pixel_filter<box_filter> && lantern::pixel_filter<tent_filter>);
static_assert(lantern::pixel_filter<gaussian_filter> && lantern::pixel_filter<mitchell_filter>);

namespace {

constexpr double reach = 3.2;  // beyond the radius of every filter below, and off their borders
constexpr std::size_t side = 32;

/// Sums f over a fine grid of [-reach, reach]².
template <class F>
double integral(F f, std::size_t pieces = 1600) {
    const double step = 2 * reach / static_cast<double>(pieces);
    double sum = 0;
    for (std::size_t i = 0; i < pieces; ++i)
        for (std::size_t j = 0; j < pieces; ++j)
            sum += f(glm::dvec2(static_cast<double>(i) + .5, static_cast<double>(j) + .5) * step - reach);
    return sum * step * step;
}

template <class Filter>
void keeps_the_laws(const Filter& f, double bound) {
    CHECK(std::abs(integral([&](glm::dvec2 p) { return double{value(f, glm::vec2(p))}; }) - 1) < bound);

    // Where samples go, by their weights: as many as |filter| says, and the sign is the filter's.
    const lantern::independent set{.samples = 200'000, .seed = 5};
    const double total = integral([&](glm::dvec2 p) { return std::abs(double{value(f, glm::vec2(p))}); });
    std::vector<double> seen(side * side), expected(side * side);
    statistics::mean weight;
    bool signs = true, magnitude = true;
    for (std::uint32_t i = 0; i < set.count(); ++i) {
        const auto [offset, w] = sample(f, set.at({0, 0}, i).draw2(lantern::purpose::film));
        const glm::dvec2 at = (glm::dvec2(offset) + reach) / (2 * reach);
        ++seen[statistics::cell(at.y, side) * side + statistics::cell(at.x, side)];
        weight.add(w);
        const float v = value(f, offset);
        signs = signs && (v * w >= 0 || std::abs(v) < 1e-5f);
        magnitude = magnitude && std::abs(std::abs(double{w}) / total - 1) < 1e-3 + bound;
    }
    CHECK(signs);
    CHECK(magnitude);
    CHECK(std::abs(weight.z(1)) < statistics::z_limit);
    constexpr int fine = 24;
    for (std::size_t y = 0; y < side; ++y)
        for (std::size_t x = 0; x < side; ++x)
            for (int i = 0; i < fine * fine; ++i) {
                const glm::dvec2 within((i % fine + .5) / fine, (i / fine + .5) / fine);
                const glm::dvec2 p = (glm::dvec2(x, y) + within) * (2 * reach / side) - reach;
                expected[y * side + x] += std::abs(double{value(f, glm::vec2(p))});
            }
    double sum = 0;
    for (const double e : expected) sum += e;
    for (double& e : expected) e *= set.count() / sum;
    CHECK(statistics::chi_square_test(seen, expected) > statistics::false_alarm);

    for (const float x : {0.0f, 0x1p-24f, .5f, 1 - 0x1p-24f, 1.0f})
        for (const float y : {0.0f, 0x1p-24f, .5f, 1 - 0x1p-24f, 1.0f}) {
            const auto [offset, w] = sample(f, {x, y});
            CHECK(std::isfinite(w));
            CHECK(std::max(std::abs(offset.x), std::abs(offset.y)) <= f.radius * 1.000001f);
        }
}

}  // namespace

// The grids below have borders at multiples of 0.2, where the box has its own; the tolerance is that of the sum.
TEST_CASE("box filter: integral 1, samples where it is") {
    keeps_the_laws(box_filter{.radius = .6f}, 1e-6);
    keeps_the_laws(box_filter{.radius = 1.4f}, 1e-6);
}
TEST_CASE("tent filter: integral 1, samples where it is large") { keeps_the_laws(tent_filter{.radius = 1}, 1e-5); }
TEST_CASE("Gaussian filter: integral 1, samples where it is large") {
    keeps_the_laws(gaussian_filter{.sigma = .5f, .radius = 2}, 1e-4);
    keeps_the_laws(gaussian_filter{.sigma = .8f, .radius = 3}, 1e-4);
}
TEST_CASE("Mitchell filter: integral 1, samples where it is large, with the sign that it has there") {
    keeps_the_laws(mitchell_filter{}, 1e-5);
    keeps_the_laws(mitchell_filter{.b = 0, .c = .5f, .radius = 2}, 1e-5);  // Catmull and Rom's
    keeps_the_laws(mitchell_filter{.b = 1, .c = 0, .radius = 3}, 1e-5);    // the cubic B-spline
    keeps_the_laws(mitchell_filter{.b = 0, .c = 0, .radius = 1.5f}, 1e-5);
    keeps_the_laws(mitchell_filter{.b = 1, .c = 1, .radius = 2}, 1e-5);
}

TEST_CASE("Mitchell filter: the values of the paper") {
    const double scale = 8.0 / 9;  // the height in the middle, for B = C = 1/3, in one direction
    CHECK(std::abs(value(mitchell_filter{}, {0, 0}) - scale * scale) < 1e-6);
    CHECK(std::abs(value(mitchell_filter{}, {1, 0}) - scale / 18) < 1e-6);  // B/6
    CHECK(value(mitchell_filter{}, {1.5f, 0}) < 0);
    CHECK(value(mitchell_filter{}, {2, 0}) == 0);
    CHECK(value(mitchell_filter{}, {1.5f, 1.5f}) > 0);
}

TEST_CASE("a constant image stays constant under every filter, at any count: no darkening") {
    const auto means = [](const auto& filter, const auto& set) {
        double sum = 0, weights = 0;
        for (std::uint32_t i = 0; i < set.count(); ++i) {
            const auto [offset, weight] = sample(filter, set.at({4, 2}, i).draw2(lantern::purpose::film));
            sum += .7 * weight;
            weights += weight;
        }
        CAPTURE(set.count());
        CHECK(std::abs(sum / weights - .7) < 1e-9);
        // Together the weights are positive, and nearly the number of samples. (A single one may be negative.)
        if (set.count() > 1) CHECK(weights > .5 * set.count());
    };
    const auto all = [&](const auto& filter) {
        for (const std::uint32_t n : {1u, 10u, 64u, 1000u}) {
            means(filter, lantern::correlated_multi_jittered{.samples = n});
            means(filter, lantern::sobol{.samples = n});
            means(filter, lantern::halton{.samples = n});
        }
    };
    all(box_filter{});
    all(tent_filter{});
    all(gaussian_filter{});
    all(mitchell_filter{});
}

TEST_CASE("filters that cannot be are refused") {
    CHECK_THROWS_WITH(validate(box_filter{.radius = 0}), containing("box_filter: radius is 0"));
    CHECK_THROWS_WITH(validate(tent_filter{.radius = -1}), containing("tent_filter: radius is -1"));
    CHECK_THROWS_WITH(validate(gaussian_filter{.sigma = std::nanf("")}), containing("gaussian_filter: sigma is nan"));
    CHECK_THROWS_AS(validate(gaussian_filter{.radius = 0}), std::invalid_argument);
    CHECK_THROWS_WITH(validate(mitchell_filter{.b = 2}), containing("mitchell_filter: b is 2"));
    CHECK_THROWS_AS(validate(mitchell_filter{.c = -.1f}), std::invalid_argument);
    CHECK_NOTHROW(validate(mitchell_filter{}));
}
