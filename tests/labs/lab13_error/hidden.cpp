// SPDX-License-Identifier: MIT
// Lab 13's hidden tests: the solution's answers, for estimates, curves and pixels drawn anew for each grading. Only step 6 is left to
// chance, in one test that says how often a right answer fails. Step 8 asks for six words, always the same: they can be known by heart.

#include "contract.hpp"

#include <catch.hpp>
#include <hidden.hpp>

#include <lab13_error/error.hpp>

#include <array>
#include <cmath>
#include <set>
#include <vector>

using namespace contract::lab13;

namespace {

bool near(double a, double b, double relative) { return a == b || std::abs(a - b) <= relative * std::abs(b); }

/// About a value, off by `shift`, scattered by `scatter`.
std::vector<float> any_estimates(numbers& random, std::size_t count, float exact, float shift, float scatter) {
    std::vector<float> all(count);
    for (float& each : all) each = exact + shift + scatter * random.between(-1, 1);
    return all;
}

std::vector<std::uint32_t> any_counts(numbers& random) {
    std::vector<std::uint32_t> all{1 + hidden::below(random, 9)};
    for (std::uint32_t k = 2 + hidden::below(random, 4); k > 0; --k) all.push_back(all.back() + 1 + hidden::below(random, 4 * all.back()));
    return all;
}

}  // namespace

TEST_CASE("the error of any estimates", "[step1]") {
    numbers random = hidden::drawn(1);
    for (int i = 0; i < 100; ++i) {
        const float exact = 10 * random.between(-1, 1);
        const auto some = any_estimates(random, 1 + hidden::below(random, 50), exact, random.between(-1, 1), hidden::magnitude(random, 1e-3f, 10));
        CHECK(near(rmse(some, exact), lab13::rmse(some, exact), 1e-6));
    }
}

TEST_CASE("the bias of any estimates", "[step2]") {
    numbers random = hidden::drawn(2);
    for (int i = 0; i < 100; ++i) {
        const float exact = 10 * random.between(-1, 1), scatter = hidden::magnitude(random, 0.01f, 10);
        const auto some = any_estimates(random, 2 + hidden::below(random, 50), exact, random.between(-1, 1), scatter);
        const bias_then theirs = bias_of(some, exact);
        const lab13::bias ours = lab13::bias_of(some, exact);
        CHECK(std::abs(theirs.mean - ours.mean) <= 1e-6 * double(scatter) + 1e-6 * std::abs(ours.mean));
        CHECK(std::abs(theirs.z - ours.z) <= 1e-5 * (1 + std::abs(ours.z)));
    }
}

TEST_CASE("the slope of any curve", "[step3]") {
    numbers random = hidden::drawn(3);
    for (int i = 0; i < 100; ++i) {
        const std::vector<std::uint32_t> samples = any_counts(random);
        std::vector<double> errors;
        for (std::size_t k = 0; k < samples.size(); ++k) errors.push_back(double(hidden::magnitude(random, 1e-4f, 10)));
        CHECK(std::abs(slope(samples, errors) - lab13::slope(samples, errors)) <= 1e-8 * (1 + std::abs(lab13::slope(samples, errors))));
    }
}

TEST_CASE("what any accuracy costs", "[step4]") {
    numbers random = hidden::drawn(4);
    for (int i = 0; i < 100; ++i) {
        const double falls = double(random.between(-2, 0.4f)), factor = double(hidden::magnitude(random, 0.1f, 10));
        if (std::abs(falls) < 0.02) continue;
        CHECK(near(time_factor(falls, factor), lab13::time_factor(falls, factor), 1e-6));
    }
}

TEST_CASE("a grid for any number", "[step5]") {
    numbers random = hidden::drawn(5);
    for (int i = 0; i < 200; ++i) {
        const std::uint32_t count = 1 + hidden::below(random, i < 100 ? 1000 : 1'000'000);
        CHECK(cells(count) == lab13::cells(count));
    }
}

TEST_CASE("an order for any purpose of any pixel", "[step6]") {
    numbers random = hidden::drawn(6);
    std::set<std::vector<std::uint32_t>> orders;
    const auto order_of = [](std::uint32_t count, std::uint32_t purpose, glm::uvec2 pixel) {
        std::vector<std::uint32_t> order;
        for (std::uint32_t i = 0; i < count; ++i) order.push_back(stratum(i, count, purpose, pixel));
        return order;
    };
    for (int i = 0; i < 40; ++i) {
        const std::uint32_t count = 24 + hidden::below(random, 40), purpose = hidden::below(random, 9);
        const glm::uvec2 pixel{hidden::below(random, 4000), hidden::below(random, 4000)};
        const auto order = order_of(count, purpose, pixel);
        CHECK(std::set<std::uint32_t>(order.begin(), order.end()).size() == count);
        for (const std::uint32_t k : order) CHECK(k < count);
        CHECK(order == order_of(count, purpose, pixel));
        orders.insert(order);
        orders.insert(order_of(count, purpose + 1, pixel));
        orders.insert(order_of(count, purpose, {pixel.x + 1, pixel.y}));
        orders.insert(order_of(count, purpose, {pixel.y + 4000, pixel.x}));
        std::set<std::uint32_t> steps;
        for (std::uint32_t k = 0; k + 1 < count; ++k) steps.insert((order[k + 1] + count - order[k]) % count);
        CHECK(steps.size() > 6);  // of a shuffled order half of all; of a rotated one 1
    }
    CHECK(orders.size() == 160);
}

TEST_CASE("any two purposes have nothing to do with each other", "[step6]") {
    // 250 pixels of 1000 for each of the 16 pairs, within 5.5 standard deviations of 13.7: a right answer fails once in a million seeds.
    numbers random = hidden::drawn(7);
    const std::uint32_t a = hidden::below(random, 20), b = a + 1 + hidden::below(random, 20);
    std::array<std::array<int, 4>, 4> pairs{};
    for (std::uint32_t k = 0; k < 1000; ++k) {
        const glm::uvec2 pixel{k % 40 + 40 * hidden::below(random, 50), k / 40 + 25 * hidden::below(random, 50)};
        for (std::uint32_t i = 0; i < 4; ++i) ++pairs[stratum(i, 4, a, pixel) % 4][stratum(i, 4, b, pixel) % 4];
    }
    for (const auto& row : pairs)
        for (const int count : row) CHECK(std::abs(count - 250) <= 75);
}

TEST_CASE("reading any curve", "[step7]") {
    numbers random = hidden::drawn(8);
    for (int i = 0; i < 100; ++i) {
        const std::vector<std::uint32_t> samples = any_counts(random);
        const float exact = random.unit(), shift = random.unit() < 0.4f ? hidden::magnitude(random, 1e-3f, 0.1f) * (random.unit() < 0.5f ? -1.0f : 1.0f) : 0;
        const double falls = double(random.between(-1.2f, -0.4f)), theory = random.unit() < 0.5f ? -0.5 : -0.75;
        const bool repeats = random.unit() < 0.2f;
        std::vector<std::vector<float>> estimates;
        std::vector<double> errors;
        for (const std::uint32_t n : samples) {
            estimates.push_back(any_estimates(random, 32 + hidden::below(random, 40), exact, shift, float(std::pow(n, falls))));
            if (repeats) estimates.back().assign(estimates.back().size(), estimates.back()[0]);
            errors.push_back(lab13::rmse(estimates.back(), exact));
        }
        // Not so near to a limit that rounding decides.
        if (std::abs(std::abs(lab13::bias_of(estimates.back(), exact).z) - 5) < 0.01 || std::abs(lab13::slope(samples, errors) - theory - 0.12) < 1e-4) continue;
        CHECK(int(diagnose(samples, estimates, exact, theory)) == int(lab13::diagnose(samples, estimates, exact, theory)));
    }
}
