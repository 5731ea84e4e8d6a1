// SPDX-License-Identifier: MIT
#include "pixel_bias.hpp"

#include "catch.hpp"
#include "statistics.hpp"

#include <lantern/hash.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

using bench::pixel_bias;
using bench::pixel_bias_of;

namespace {

using picture_errors = std::vector<std::vector<float>>;  // [trial][pixel]

/// A number with the normal distribution (Box and Muller 1958), always the same for the same three.
double normal(std::uint64_t seed, std::uint64_t trial, std::uint64_t pixel) {
    const std::uint64_t h = lantern::hash(seed, trial, pixel);
    const double u = double(lantern::to_unit(lantern::low(h))), v = double(lantern::to_unit(lantern::high(h)));
    return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * v);
}

/// Noise of standard deviation 1, and a bias that is positive in every other pixel and negative in the rest: none of the whole picture.
picture_errors noise(std::uint64_t seed, std::size_t trials, std::size_t pixels, double bias = 0) {
    picture_errors errors(trials, std::vector<float>(pixels));
    for (std::size_t n = 0; n < trials; ++n)
        for (std::size_t p = 0; p < pixels; ++p)
            errors[n][p] = static_cast<float>(normal(seed, n, p) + (p % 2 == 0 ? bias : -bias));
    return errors;
}

}  // namespace

TEST_CASE("two trials of one pixel: the square of the bias is the product of the errors") {
    // m² - s²/2 = ((a + b)² - (a - b)²) / 4 = a b, and its variance 4 (s²/2)² = (a - b)⁴ / 4.
    const pixel_bias same_side = pixel_bias_of(picture_errors{{3}, {1}});
    CHECK(same_side.rms == Approx(std::sqrt(3.0)));
    CHECK(same_side.z == Approx(2 * 3 / 4.0));
    const pixel_bias other_side = pixel_bias_of(picture_errors{{1}, {-1}});
    CHECK(other_side.rms == 0);
    CHECK(other_side.z == Approx(-2 * 1 / 4.0));
}

TEST_CASE("any number of trials: the mean product of two of them, over all pairs") {
    for (const std::size_t trials : {2u, 3u, 7u, 20u}) {
        constexpr std::size_t pixels = 5;
        const picture_errors errors = noise(trials, trials, pixels, 2);
        double sum = 0;
        for (std::size_t p = 0; p < pixels; ++p)
            for (std::size_t i = 0; i < trials; ++i)
                for (std::size_t j = 0; j < trials; ++j)
                    if (i != j) sum += double(errors[i][p]) * double(errors[j][p]);
        CHECK(pixel_bias_of(errors).rms == Approx(std::sqrt(sum / double(pixels * trials * (trials - 1)))));
    }
}

TEST_CASE("a bias that cancels in the mean over the picture is there all the same, and without noise beyond doubt") {
    const pixel_bias found = pixel_bias_of(picture_errors{{.25f, -.25f}, {.25f, -.25f}, {.25f, -.25f}});
    CHECK(found.rms == .25);
    CHECK(found.z == std::numeric_limits<double>::infinity());
}

TEST_CASE("no error at all is no bias") {
    const pixel_bias found = pixel_bias_of(picture_errors{{0, 0}, {0, 0}});
    CHECK(found.rms == 0);
    CHECK(found.z == 0);
}

TEST_CASE("what is not finite counts as no error") {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
    const pixel_bias found = pixel_bias_of(picture_errors{{nan, -infinite, 1}, {2, 3, 1}}), same = pixel_bias_of(picture_errors{{0, 0, 1}, {2, 3, 1}});
    CHECK(found.rms == same.rms);
    CHECK(found.z == same.z);
}

// With n trials of P pixels and noise of σ = 1, z is nearly normal, for P is large. Its denominator is a little too large, for the mean of
// s⁴ is σ⁴ (n + 1)/(n - 1): the standard deviation of z is √((n - 1)/(n + 1)).
TEST_CASE("noise alone: z is about 0, and no wider than it should be") {
    constexpr std::size_t trials = 8, pixels = 400, times = 400;
    statistics::mean z, square;
    for (std::uint64_t seed = 0; seed < times; ++seed) {
        const double one = pixel_bias_of(noise(seed, trials, pixels)).z;
        z.add(one), square.add(one * one);
    }
    CHECK(std::abs(z.z(0)) < statistics::z_limit);
    CHECK(std::abs(square.z((trials - 1.0) / (trials + 1.0))) < statistics::z_limit);
}

TEST_CASE("a bias in noise: its size is found, and z grows with the number of pixels") {
    constexpr std::size_t trials = 100;
    constexpr double bias = .2;
    for (const std::size_t pixels : {100u, 1600u}) {
        const pixel_bias found = pixel_bias_of(noise(1, trials, pixels, bias));
        // The mean of P values of m² - s²/n, each with the variance 4 b²/n + 2/(n (n - 1)).
        const double off = std::sqrt((4 * bias * bias / trials + 2.0 / trials / (trials - 1)) / double(pixels));
        CHECK(std::abs(found.rms * found.rms - bias * bias) < statistics::z_limit * off);
        // What is seen of b², and the deviation of it that noise alone would have, here but for what is random in s⁴: 1.4 %.
        const double noise_alone = std::sqrt(2.0 / trials / (trials - 1) / double(pixels));
        CHECK(found.z == Approx(found.rms * found.rms / noise_alone).epsilon(.08));
    }
}
