// SPDX-License-Identifier: MIT
// Lab 04's hidden tests, with inputs drawn anew for each grading: the solution's answers where there is one right answer, and
// laws where there are many. A part of 32 × 32 jittered points is off by less than 0.04, eight times its standard deviation.

#include "contract.hpp"

#include <catch.hpp>
#include <hidden.hpp>

#include <lab04_sampling/sampling.hpp>

#include <set>

using namespace contract::lab04;

namespace {

constexpr double unlucky = 0.04;

std::vector<float> several(numbers& random, std::size_t count) {
    std::vector<float> all(count);
    for (float& each : all) each = random.unit();
    return all;
}

/// The part of the points that `law` holds for.
template <class Map, class Law>
double part(numbers& random, Map map, Law law) {
    int inside = 0;
    for (const glm::vec2 xi : hidden::jittered(random, 32)) inside += law(map(xi)) ? 1 : 0;
    return inside / 1024.0;
}

}  // namespace

TEST_CASE("any cell of any grid", "[step1]") {
    numbers random = hidden::drawn(1);
    for (int i = 0; i < 200; ++i) {
        const std::uint32_t side = 1 + hidden::below(random, 50), cell = hidden::below(random, side * side);
        const glm::vec2 xi = hidden::point(random);
        CHECK(hidden::apart(jittered(cell, side, xi), lab04::jittered(cell, side, xi)) < 1e-5);
    }
}

TEST_CASE("any shuffle is an order, and every number may come first", "[step2]") {
    numbers random = hidden::drawn(2);
    std::set<std::uint32_t> first;
    for (int i = 0; i < 200; ++i) {
        const std::uint32_t n = i < 150 ? 5 : 1 + hidden::below(random, 60);
        std::vector<std::uint32_t> order = shuffled(n, several(random, n));
        if (i < 150 && !order.empty()) first.insert(order[0]);
        std::sort(order.begin(), order.end());
        std::vector<std::uint32_t> all(n);
        for (std::uint32_t k = 0; k < n; ++k) all[k] = k;
        CHECK(order == all);
    }
    CHECK(first.size() == 5);  // misses one of them by chance once in 10^14
}

TEST_CASE("any rooks", "[step3]") {
    numbers random = hidden::drawn(3);
    for (int i = 0; i < 50; ++i) {
        const std::uint32_t n = 1 + hidden::below(random, 40);
        const std::vector<std::uint32_t> order = lab04::shuffled(n, several(random, n));
        const std::vector<glm::vec2> xi = hidden::points(random, n);
        const points theirs = n_rooks(order, xi), ours = lab04::n_rooks(order, xi);
        REQUIRE(theirs.size() == ours.size());
        for (std::size_t k = 0; k < ours.size(); ++k) CHECK(hidden::apart(theirs[k], ours[k]) < 1e-5);
    }
}

TEST_CASE("any multi-jittered points", "[step4]") {
    numbers random = hidden::drawn(4);
    for (int i = 0; i < 30; ++i) {
        const std::uint32_t side = 1 + hidden::below(random, 9), n = side * side;
        std::vector<glm::vec2> xi = hidden::points(random, n);
        for (glm::vec2& each : xi) each = 0.05f + 0.9f * each;
        std::set<std::uint32_t> cells, columns, rows;
        const points all = multi_jittered(side, xi, several(random, 2 * n));
        REQUIRE(all.size() == n);
        for (const glm::vec2 p : all) {
            REQUIRE((p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1));
            cells.insert(std::uint32_t(p.x * float(side)) + side * std::uint32_t(p.y * float(side)));
            columns.insert(std::uint32_t(p.x * float(n)));
            rows.insert(std::uint32_t(p.y * float(n)));
        }
        CHECK((cells.size() == n && columns.size() == n && rows.size() == n));
    }
}

TEST_CASE("any part of the disk", "[step5]") {
    numbers random = hidden::drawn(5);
    const float radius = random.between(0.2f, 0.95f);
    const glm::vec2 side = glm::normalize(glm::vec2(random.direction()));
    CHECK(std::abs(part(random, to_disk, [&](glm::vec2 p) { return glm::length(p) < radius; }) - double(radius * radius)) < unlucky);
    CHECK(std::abs(part(random, to_disk, [&](glm::vec2 p) { return glm::dot(p, side) > 0; }) - 0.5) < unlucky);
    CHECK(part(random, to_disk, [&](glm::vec2 p) { return glm::length(p) <= 1.00001f; }) == 1);
}

TEST_CASE("any part of the triangle", "[step6]") {
    numbers random = hidden::drawn(6);
    for (int corner = 0; corner < 3; ++corner) {
        const float most = random.between(0.1f, 0.9f);  // a smaller triangle at this corner
        CHECK(std::abs(part(random, to_triangle, [&](glm::vec3 w) { return w[corner] > most; }) - double((1 - most) * (1 - most))) < unlucky);
    }
    CHECK(part(random, to_triangle, [](glm::vec3 w) { return w.x >= 0 && w.y >= 0 && w.z >= 0 && std::abs(w.x + w.y + w.z - 1) < 1e-5f; }) == 1);
}

TEST_CASE("any part of the hemisphere", "[step7]") {
    numbers random = hidden::drawn(7);
    const float height = random.between(0.2f, 0.95f);
    const glm::vec2 side = glm::normalize(glm::vec2(random.direction()));
    CHECK(std::abs(part(random, to_hemisphere, [&](glm::vec3 d) { return d.z < height; }) - double(height * height)) < unlucky);
    CHECK(std::abs(part(random, to_hemisphere, [&](glm::vec3 d) { return glm::dot(glm::vec2(d), side) > 0; }) - 0.5) < unlucky);
    CHECK(part(random, to_hemisphere, [](glm::vec3 d) { return d.z >= 0 && std::abs(glm::length(d) - 1) < 1e-5f; }) == 1);
}

TEST_CASE("any tent", "[step8]") {
    numbers random = hidden::drawn(8);
    for (int i = 0; i < 200; ++i) {
        const float radius = random.between(0.2f, 3);
        const glm::vec2 offset = 3.0f * glm::vec2(random.vector());
        CHECK(hidden::apart(tent(offset, radius), lab04::tent(offset, radius)) < 1e-5);
    }
}

TEST_CASE("any weighted mean", "[step9]") {
    numbers random = hidden::drawn(9);
    for (int i = 0; i < 100; ++i) {
        std::vector<glm::vec3> colors(1 + hidden::below(random, 30));
        for (glm::vec3& each : colors) each = random.vector();
        std::vector<float> weights = several(random, colors.size());
        weights[0] += 0.1f;
        CHECK(hidden::apart(filtered(colors, weights), lab04::filtered(colors, weights)) < 1e-4);
    }
}
