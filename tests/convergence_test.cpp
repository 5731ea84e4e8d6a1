// SPDX-License-Identifier: MIT
#include <lantern/convergence.hpp>

#include <lantern/samples.hpp>

#include "catch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

using namespace lantern;

namespace {

/// A value whose error is Gaussian enough: the mean of N numbers with variance 1/12 around a biased truth.
trial mean_of(std::uint32_t samples, std::uint64_t seed, double offset) {
    double sum = 0;
    for (std::uint32_t i = 0; i < samples; ++i) sum += double(to_unit(high(hash(seed, i))));
    const double error = sum / samples - 0.5 + offset;
    return {error, error * error, 0};
}

/// As if measured: every trial at N has the error c N^e.
convergence exactly(double c, double e) {
    convergence all{{4, 16, 64, 256}, {}};
    for (const std::uint32_t n : all.samples) {
        const double error = c * std::pow(n, e);
        all.trials.push_back({{error, error * error}, {-error, error * error}});
    }
    return all;
}

}  // namespace

TEST_CASE("the difference of pictures is the mean over pixels and channels") {
    image picture({2, 1}), exact({2, 1});
    picture(0, 0) = {1, 2, 3};
    exact(1, 0) = {0, 0, 2};
    const trial t = difference(picture, exact);
    CHECK(t.mean_error == Approx((1 + 2 + 3 - 2) / 6.0));
    CHECK(t.mean_square == Approx((1 + 4 + 9 + 4) / 6.0));
    CHECK(t.not_finite == 0);
    CHECK_THROWS_AS(difference(picture, image({1, 2})), std::invalid_argument);
}

TEST_CASE("what is not finite is left out and counted") {
    image picture({2, 1}), exact({2, 1});
    picture(0, 0) = {std::numeric_limits<float>::quiet_NaN(), 1, std::numeric_limits<float>::infinity()};
    picture.add_rejected(3);
    const trial t = difference(picture, exact);
    CHECK(t.not_finite == 5);
    CHECK(t.mean_error == Approx(1 / 4.0));
}

TEST_CASE("a power law has its exponent for a slope, and an interval of no width") {
    for (const double exponent : {-0.5, -0.75, -1.5}) {
        const estimate found = slope(exactly(0.3, exponent));
        CHECK(found.value == Approx(exponent));
        CHECK(found.low == Approx(exponent));
        CHECK(found.high == Approx(exponent));
    }
}

TEST_CASE("the slope is fitted from the least number of samples on") {
    convergence bent = exactly(1, -0.5);
    bent.trials[0] = {{100, 1e4}, {-100, 1e4}};
    CHECK(slope(bent).value < -1);
    CHECK(slope(bent, 16).value == Approx(-0.5));
}

TEST_CASE("independent samples: slope -1/2 within the interval, RMSE as the variance says, no bias") {
    // 400 trials: the RMSE is known within 3.5 % (one standard deviation), and the slope over a factor of 64 within .012.
    // Five checks at four deviations or more: a false alarm once in 3,000 seeds. The interval misses once in 20, so it is
    // asked for 4 standard deviations' worth of room: three times its own width.
    const convergence c = measure_convergence([](std::uint32_t n, std::uint64_t seed) { return mean_of(n, seed, 0); },
                                              {.samples = {4, 16, 64, 256}, .trials = 400, .first_seed = 5});
    for (std::size_t n = 0; n < c.samples.size(); ++n) {
        CHECK(rmse(c.trials[n]) == Approx(std::sqrt(1 / 12.0 / c.samples[n])).epsilon(0.15));
        CHECK(std::abs(bias_of(c.trials[n]).z) < 4);
    }
    const estimate found = slope(c);
    CHECK(std::abs(found.value + 0.5) <= 3 * (found.high - found.low) / 2);
    CHECK(found.high - found.low > 0.02);
    CHECK(found.high - found.low < 0.1);
}

TEST_CASE("nine of ten intervals and more hold the true slope") {
    // 95 % of them should; of 60, fewer than 50 would be a chance of 1e-5 (binomial), allowing for the bootstrap's own 2 %.
    std::uint32_t held = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        const estimate found = slope(measure_convergence([](std::uint32_t n, std::uint64_t s) { return mean_of(n, s, 0); },
                                                         {.samples = {4, 16, 64}, .trials = 40, .first_seed = seed}), 1, 300);
        held += found.low <= -0.5 && -0.5 <= found.high;
    }
    CHECK(held >= 50);
}

TEST_CASE("a bias is seen, and a reference that is not sure excuses it") {
    const convergence c = measure_convergence([](std::uint32_t n, std::uint64_t seed) { return mean_of(n, seed, 0.01); },
                                              {.samples = {256}, .trials = 100});
    const bias found = bias_of(c.trials[0]);
    CHECK(found.value == Approx(0.01).margin(0.01));
    CHECK(found.z > 4);  // .01 is 5.5 standard errors
    CHECK(std::abs(bias_of(c.trials[0], 0.01).z) < 2);
}

TEST_CASE("errors that are all the same are no chance") {
    const std::vector<trial> wrong(3, trial{0.5, 0.25}), right(3);
    CHECK(bias_of(wrong).z == std::numeric_limits<double>::infinity());
    CHECK(bias_of(right).z == 0);
}

TEST_CASE("samples for an error: between measurements, at them, and beyond") {
    const convergence c = exactly(2, -0.5);
    for (const double n : {5.0, 16.0, 100.0, 256.0, 10000.0}) CHECK(samples_for(c, 2 / std::sqrt(n)) == Approx(n));
    CHECK(samples_for(convergence{{4, 16}, {{trial{0, 1}}, {trial{0, 1}}}}, 0.5) == std::numeric_limits<double>::infinity());
    CHECK_THROWS_AS(samples_for(c, 0), std::invalid_argument);
    CHECK_THROWS_AS(samples_for(convergence{{4}, {{}}}, 1), std::invalid_argument);
}

TEST_CASE("half the error at the same time is four times the efficiency") {
    CHECK(efficiency(0.5, 2) == Approx(4 * efficiency(1, 2)));
    CHECK(efficiency(1, 1) == Approx(2 * efficiency(1, 2)));
}

TEST_CASE("a measurement does not depend on the number of threads, and every trial has its own seed") {
    const auto seeds = [](std::uint32_t n, std::uint64_t seed) { return trial{double(n), double(seed), 0}; };
    const convergence one = measure_convergence(seeds, {.samples = {1, 2, 3}, .trials = 5, .threads = 1});
    const convergence many = measure_convergence(seeds, {.samples = {1, 2, 3}, .trials = 5, .threads = 7});
    std::vector<double> all;
    for (std::size_t n = 0; n < 3; ++n)
        for (std::size_t k = 0; k < 5; ++k) {
            CHECK(one.trials[n][k].mean_error == double(n + 1));
            CHECK(one.trials[n][k].mean_square == many.trials[n][k].mean_square);
            all.push_back(one.trials[n][k].mean_square);
        }
    std::ranges::sort(all);
    CHECK(std::ranges::adjacent_find(all) == all.end());
}

TEST_CASE("a measurement without a question is refused") {
    const auto nothing = [](std::uint32_t, std::uint64_t) { return trial{}; };
    CHECK_THROWS_AS(measure_convergence(nothing, {.trials = 1}), std::invalid_argument);
    CHECK_THROWS_AS(measure_convergence(nothing, {.samples = {}}), std::invalid_argument);
    CHECK_THROWS_AS(measure_convergence(nothing, {.samples = {0, 1}}), std::invalid_argument);
    CHECK_THROWS_AS(measure_convergence(nothing, {.samples = {4, 4}}), std::invalid_argument);
}
