// SPDX-License-Identifier: MIT
// Lab 04: well-placed points in the unit square, and where to carry them.
// Random numbers come from a hash of fixed seeds, so every run sees the same. Chi-square tests reject below a probability
// of 1e-6: one right answer in a million would be called wrong, and then always.

#include "contract.hpp"

#include <catch.hpp>
#include <hint.hpp>
#include <statistics.hpp>

#include <lantern/hash.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

using namespace contract::lab04;

namespace {

constexpr float last = 0x1.fffffep-1f;  // the largest number that a generator may give

std::vector<float> numbers(std::size_t count, std::uint64_t seed) {
    std::vector<float> result(count);
    for (std::size_t i = 0; i < count; ++i) result[i] = lantern::to_unit(lantern::low(lantern::hash(seed, i)));
    return result;
}

std::vector<glm::vec2> pairs(std::size_t count, std::uint64_t seed) {
    const auto n = numbers(2 * count, seed + 1000);
    std::vector<glm::vec2> result(count);
    for (std::size_t i = 0; i < count; ++i) result[i] = {n[2 * i], n[2 * i + 1]};
    return result;
}

/// The middles of 200 × 200 cells of the unit square: what a map does to area, it does to their number.
std::vector<glm::vec2> fine_grid() {
    std::vector<glm::vec2> result;
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 200; ++x) result.push_back({(float(x) + 0.5f) / 200, (float(y) + 0.5f) / 200});
    return result;
}

bool in_unit_square(glm::vec2 p) { return p.x >= 0 && p.y >= 0 && p.x < 1 && p.y < 1; }

std::size_t stratum(float x, std::size_t count) {
    return std::min(static_cast<std::size_t>(std::max(0.0f, x) * float(count)), count - 1);
}

/// Whether each of `count` equal stretches of [0, 1) holds exactly one of the numbers.
template <class Coordinate>
bool one_in_each(const std::vector<glm::vec2>& points, Coordinate coordinate) {
    std::set<std::size_t> taken;
    for (const glm::vec2 p : points) taken.insert(stratum(coordinate(p), points.size()));
    return taken.size() == points.size();
}

float x_of(glm::vec2 p) { return p.x; }
float y_of(glm::vec2 p) { return p.y; }

}  // namespace

// ---- Step 1: a sample in each cell ---------------------------------------------------------------------------------

TEST_CASE("every sample lies in its own cell", "[step1]") {
    INFO(hint("some cells have two samples and others none", "cell i is in column i % side and in row i / side", "§1 Jittered"));
    for (const std::uint32_t side : {1u, 2u, 3u, 7u}) {
        const auto xi = pairs(std::size_t{side} * side, side);
        for (std::uint32_t i = 0; i < side * side; ++i) {
            const glm::vec2 p = jittered(i, side, xi[i]);
            CAPTURE(side, i, p.x, p.y);
            REQUIRE(in_unit_square(p));
            REQUIRE(stratum(p.x, side) == i % side);
            REQUIRE(stratum(p.y, side) == i / side);
        }
    }
}

TEST_CASE("the two random numbers place the sample within its cell", "[step1]") {
    INFO(hint("parts of the square are never sampled: a regular grid shows through", "the whole of the cell must be reached: (cell + ξ) / side, with ξ for x and ξ' for y",
              "§1 Jittered"));
    CHECK(glm::length(jittered(6, 4, {0.25f, 0.75f}) - glm::vec2(2.25f, 1.75f) / 4.0f) <= 1e-6f);
    CHECK(glm::length(jittered(0, 2, {0, 0.5f}) - glm::vec2(0, 0.25f)) <= 1e-6f);
    CHECK(glm::length(jittered(3, 2, {0.9f, 0.1f}) - glm::vec2(0.95f, 0.55f)) <= 1e-6f);
}

TEST_CASE("no sample reaches 1, whatever is drawn", "[step1]") {
    INFO(hint("very rarely, a sample in the neighbouring pixel or an index out of range", "(7 + 0.99999994) / 8 is rounded to 1: take the minimum with almost_one",
              "§1 Almost one"));
    for (const std::uint32_t side : {1u, 2u, 8u, 100u}) {
        const glm::vec2 p = jittered(side * side - 1, side, {last, last});
        CAPTURE(side);
        CHECK(in_unit_square(p));
    }
}

// ---- Step 2: a fair shuffle ----------------------------------------------------------------------------------------

TEST_CASE("a shuffle holds every number once", "[step2]") {
    INFO(hint("numbers are missing, others stand twice", "exchange two places, never copy one over the other", "§2 The shuffle"));
    for (const std::uint32_t n : {1u, 2u, 5u, 16u, 100u}) {
        auto order = shuffled(n, numbers(n, n));
        REQUIRE(order.size() == n);
        std::ranges::sort(order);
        for (std::uint32_t i = 0; i < n; ++i) REQUIRE(order[i] == i);
    }
    CHECK(shuffled(0, {}).empty());
}

TEST_CASE("all 24 orders of four things are equally likely", "[step2]") {
    INFO(hint("some orders come more often than others", "Fisher and Yates: the last place takes one of all, the place before it one of the rest, and so on; k choices for the k-th",
              "§2 The shuffle"));
    std::vector<double> count(256);
    for (std::uint64_t trial = 0; trial < 24000; ++trial) {
        const auto order = shuffled(4, numbers(4, 77 + trial));
        REQUIRE(order.size() == 4);
        ++count[(order[0] * 64 + order[1] * 16 + order[2] * 4 + order[3]) % 256];
    }
    std::erase(count, 0.0);
    REQUIRE(count.size() == 24);
    CHECK(statistics::chi_square_test(count) >= statistics::false_alarm);
}

TEST_CASE("the largest random number is no problem", "[step2]") {
    INFO(hint("a crash, once in a million pictures", "0.99999994 * k may be rounded to k: limit the index to k - 1", "§2 The shuffle"));
    for (const std::uint32_t n : {2u, 7u, 1000u}) {
        auto order = shuffled(n, std::vector<float>(n, last));
        std::ranges::sort(order);
        bool all = order.size() == n;
        for (std::uint32_t i = 0; all && i < n; ++i) all = order[i] == i;
        CAPTURE(n);
        CHECK(all);
    }
}

// ---- Step 3: N-rooks -----------------------------------------------------------------------------------------------

TEST_CASE("one rook in every row and one in every column", "[step3]") {
    INFO(hint("rooks threaten each other", "sample i goes to column i and row order[i]", "§3 N-rooks"));
    for (const std::size_t n : {1u, 4u, 10u, 33u}) {
        std::vector<std::uint32_t> order(n);
        for (std::size_t i = 0; i < n; ++i) order[i] = std::uint32_t((i * 7 + 3) % n);
        const auto p = n_rooks(order, pairs(n, n));
        CAPTURE(n);
        REQUIRE(p.size() == n);
        CHECK(std::ranges::all_of(p, in_unit_square));
        CHECK(one_in_each(p, x_of));
        CHECK(one_in_each(p, y_of));
    }
}

TEST_CASE("the rooks stand where the order says", "[step3]") {
    INFO(hint("all samples lie on a diagonal", "row order[i], not row i: the order is there to be used", "§3 N-rooks"));
    const std::vector<std::uint32_t> order{2, 0, 3, 1};
    const std::vector<glm::vec2> xi{{0.5f, 0.25f}, {0, 0}, {0.75f, 0.5f}, {0.1f, 0.9f}};
    const auto p = n_rooks(order, xi);
    REQUIRE(p.size() == 4);
    for (std::size_t i = 0; i < 4; ++i) {
        CAPTURE(i);
        CHECK(glm::length(p[i] - (glm::vec2(i, order[i]) + xi[i]) / 4.0f) <= 1e-6f);
    }
}

// ---- Step 4: multi-jittered ----------------------------------------------------------------------------------------

TEST_CASE("one sample in every cell, in every narrow column and in every narrow row", "[step4]") {
    INFO(hint("better than jittered in one direction only, or in none", "within a column of cells the samples share out its side narrow columns; within a row of cells its narrow rows",
              "§4 Multi-jittered"));
    for (const std::uint32_t side : {1u, 2u, 3u, 5u, 8u}) {
        const std::size_t n = std::size_t{side} * side;
        const auto p = multi_jittered(side, pairs(n, 3 * side), numbers(2 * n, 5 * side));
        CAPTURE(side);
        REQUIRE(p.size() == n);
        REQUIRE(std::ranges::all_of(p, in_unit_square));
        std::set<std::size_t> cells;
        for (const glm::vec2 q : p) cells.insert(stratum(q.x, side) * side + stratum(q.y, side));
        CHECK(cells.size() == n);
        CHECK(one_in_each(p, x_of));
        CHECK(one_in_each(p, y_of));
    }
}

TEST_CASE("every narrow column of a cell is equally likely", "[step4]") {
    INFO(hint("the same slanted pattern in every pixel", "the narrow columns are shared out by a shuffle, for each column of cells anew; likewise the rows",
              "§4 Multi-jittered"));
    // Which of the 3 narrow columns and 3 narrow rows does the sample of cell (0, 0) take? Nine cases, 9000 trials.
    std::vector<double> count(9);
    for (std::uint64_t trial = 0; trial < 9000; ++trial) {
        const auto p = multi_jittered(3, pairs(9, 20000 + trial), numbers(18, 50000 + trial));
        REQUIRE(p.size() == 9);
        for (const glm::vec2 q : p)
            if (q.x < 1 / 3.0f && q.y < 1 / 3.0f) ++count[std::min<std::size_t>(stratum(q.x * 3, 3) * 3 + stratum(q.y * 3, 3), 8)];
    }
    CHECK(statistics::chi_square_test(count) >= statistics::false_alarm);
}

// ---- Step 5: the disk ----------------------------------------------------------------------------------------------

TEST_CASE("every point of the square lands in the disk", "[step5]") {
    INFO(hint("points outside the lens, or not a number", "the radius is at most 1; and mind the middle, where 0 is divided by 0", "§5 The disk"));
    for (const float x : {0.0f, 0.25f, 0.5f, 0.75f, last})
        for (const float y : {0.0f, 0.25f, 0.5f, 0.75f, last}) {
            CAPTURE(x, y);
            CHECK(glm::length(to_disk({x, y})) <= 1 + 1e-6f);
        }
}

TEST_CASE("equal areas of the disk get equally many points", "[step5]") {
    INFO(hint("samples crowd in the middle of the lens", "the area within r grows like r²: r = √ξ, not ξ", "§5 The disk"));
    const auto grid = fine_grid();
    double mean = 0;
    std::vector<double> within(10);
    for (const glm::vec2 xi : grid) {
        const float r = glm::length(to_disk(xi));
        mean += double(r);
        for (std::size_t k = 0; k < 10; ++k) within[k] += r * r <= float(k + 1) / 10 + 1e-6f;
    }
    for (std::size_t k = 0; k < 10; ++k) {
        CAPTURE(k);
        CHECK(within[k] / double(grid.size()) == Approx(double(k + 1) / 10).margin(0.01));  // a ring of cells is cut: below 1 %
    }
    CHECK(mean / double(grid.size()) == Approx(2.0 / 3).margin(0.005));
}

TEST_CASE("the disk is filled all round", "[step5]") {
    INFO(hint("only a spiral, a half or a quarter of the lens is used", "the angle goes once round with ξ', the radius with ξ: two different numbers", "§5 The disk"));
    const auto grid = fine_grid();
    std::vector<double> sectors(32);  // 16 angles, inner and outer half of the area
    for (const glm::vec2 xi : grid) {
        const glm::vec2 d = to_disk(xi);
        const float turn = std::atan2(d.y, d.x) / (2 * std::numbers::pi_v<float>) + 0.5f;
        ++sectors[2 * stratum(turn, 16) + (glm::dot(d, d) > 0.5f)];
    }
    for (std::size_t k = 0; k < 32; ++k) {
        CAPTURE(k);
        CHECK(sectors[k] / double(grid.size()) == Approx(1.0 / 32).margin(0.003));
    }
}

// ---- Step 6: the triangle ------------------------------------------------------------------------------------------

TEST_CASE("weights of a triangle are not negative and add up to 1", "[step6]") {
    INFO(hint("points outside of the triangle", "three weights, each from 0 to 1, whose sum is 1", "§6 The triangle"));
    for (const float x : {0.0f, 0.3f, 0.5f, 0.8f, last})
        for (const float y : {0.0f, 0.2f, 0.5f, 0.9f, last}) {
            const glm::vec3 b = to_triangle({x, y});
            CAPTURE(x, y);
            CHECK(std::min({b.x, b.y, b.z}) >= 0);
            CHECK(b.x + b.y + b.z == Approx(1).epsilon(1e-6));
        }
}

TEST_CASE("equal areas of the triangle get equally many points", "[step6]") {
    INFO(hint("samples crowd at a corner", "ξ and ξ'(1 - ξ) fill the triangle unevenly: take the root of ξ, or fold the square over its diagonal", "§6 The triangle"));
    const auto grid = fine_grid();
    glm::dvec3 mean{0}, square{0}, mixed{0};
    for (const glm::vec2 xi : grid) {
        const glm::dvec3 b(to_triangle(xi));
        mean += b;
        square += b * b;
        mixed += b * glm::dvec3(b.y, b.z, b.x);
    }
    for (int k = 0; k < 3; ++k) {  // integrals of a uniform density over a triangle: 1/3, 1/6 and 1/12
        CAPTURE(k);
        CHECK(mean[k] / double(grid.size()) == Approx(1.0 / 3).margin(0.002));
        CHECK(square[k] / double(grid.size()) == Approx(1.0 / 6).margin(0.002));
        CHECK(mixed[k] / double(grid.size()) == Approx(1.0 / 12).margin(0.002));
    }
}

// ---- Step 7: the hemisphere ----------------------------------------------------------------------------------------

TEST_CASE("directions have unit length and point upwards", "[step7]") {
    INFO(hint("light from below the surface, or not a number at the horizon", "z = √(1 - x² - y²), and rounding may make that root's argument negative", "§7 The hemisphere"));
    for (const float x : {0.0f, 0.3f, 0.5f, 0.8f, last})
        for (const float y : {0.0f, 0.2f, 0.5f, 0.9f, last}) {
            const glm::vec3 d = to_hemisphere({x, y});
            CAPTURE(x, y);
            CHECK(glm::length(d) == Approx(1).epsilon(1e-5));
            CHECK(d.z >= 0);
        }
}

TEST_CASE("directions come as often as the cosine says", "[step7]") {
    INFO(hint("matt surfaces get too much light from the horizon", "a uniform hemisphere is not enough: with density cos θ / π it is z² that is uniform", "§7 The hemisphere"));
    const auto grid = fine_grid();
    std::vector<double> below(10);
    double mean = 0;
    for (const glm::vec2 xi : grid) {
        const float z = to_hemisphere(xi).z;
        mean += double(z);
        for (std::size_t k = 0; k < 10; ++k) below[k] += z * z < float(k + 1) / 10;
    }
    CHECK(mean / double(grid.size()) == Approx(2.0 / 3).margin(0.003));
    for (std::size_t k = 0; k < 9; ++k) {
        CAPTURE(k);
        CHECK(below[k] / double(grid.size()) == Approx(double(k + 1) / 10).margin(0.01));
    }
}

TEST_CASE("directions go all round the normal", "[step7]") {
    INFO(hint("light from one side only", "both coordinates of the disk are used, as x and y", "§7 The hemisphere"));
    const auto grid = fine_grid();
    std::vector<double> sectors(8);
    for (const glm::vec2 xi : grid) {
        const glm::vec3 d = to_hemisphere(xi);
        ++sectors[stratum(std::atan2(d.y, d.x) / (2 * std::numbers::pi_v<float>) + 0.5f, 8)];
    }
    for (std::size_t k = 0; k < 8; ++k) {
        CAPTURE(k);
        CHECK(sectors[k] / double(grid.size()) == Approx(1.0 / 8).margin(0.005));
    }
}

// ---- Step 8: the tent ----------------------------------------------------------------------------------------------

TEST_CASE("a tent is 1 in the middle, one half on half the way, and 0 from its radius on", "[step8]") {
    INFO(hint("the picture is too sharp or too soft, or has rings", "1 - |x| / radius, but never below 0, in x times in y", "§8 Filters"));
    CHECK(tent({0, 0}, 1) == 1);
    CHECK(tent({0.5f, 0}, 1) == Approx(0.5));
    CHECK(tent({0, -0.5f}, 1) == Approx(0.5));
    CHECK(tent({-0.5f, 0.5f}, 1) == Approx(0.25));
    CHECK(tent({1, 0}, 2) == Approx(0.5));
    CHECK(tent({1, 0}, 1) == 0);
    CHECK(tent({0.2f, 3}, 1) == 0);
    CHECK(tent({-3, 3}, 1) == 0);  // minus by minus
}

// ---- Step 9: the weighted mean -------------------------------------------------------------------------------------

TEST_CASE("a wall of one color keeps its color, whatever the weights", "[step9]") {
    INFO(hint("the picture gets darker or brighter with the number of samples", "divide by the sum of the weights that were taken, not by the number of samples, nor by the number that was asked for",
              "§9 The mean"));
    const glm::vec3 color{0.2f, 0.5f, 0.9f};
    for (const std::size_t n : {1u, 3u, 10u, 64u}) {
        const std::vector<glm::vec3> colors(n, color);
        const glm::vec3 mean = filtered(colors, numbers(n, n));
        CAPTURE(n);
        CHECK(glm::length(mean - color) <= 1e-5f);
    }
}

TEST_CASE("heavier samples count more", "[step9]") {
    INFO(hint("the filter makes no difference", "each color is multiplied by its weight before it is added", "§9 The mean"));
    const std::vector<glm::vec3> colors{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const std::vector<float> weights{1, 2, 5};
    const glm::vec3 mean = filtered(colors, weights);
    CHECK(glm::length(mean - glm::vec3(0.125f, 0.25f, 0.625f)) <= 1e-6f);
}

TEST_CASE("without weight the pixel is black, not undefined", "[step9]") {
    INFO(hint("not a number in the picture", "0 / 0: ask before you divide", "§9 The mean"));
    CHECK(filtered({}, {}) == glm::vec3(0));
    const std::vector<glm::vec3> colors{{1, 2, 3}};
    const std::vector<float> weights{0};
    CHECK(filtered(colors, weights) == glm::vec3(0));
}
