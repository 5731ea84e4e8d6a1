// SPDX-License-Identifier: MIT
// Lab 12's hidden tests, for surfaces, lamps and rooms drawn anew for each grading: the solution's answers where there is one right
// answer, laws where there are several, and closed forms for whole paths. Parts of 32 × 32 jittered points are off by less than 0.04, eight times
// their standard deviation; means of paths by less than six times theirs, of which a right answer exceeds one in 500 million.

#include "contract.hpp"

#include <catch.hpp>
#include <hidden.hpp>
#include <statistics.hpp>

#include <lab12_monte_carlo/monte_carlo.hpp>
#include <lantern/exact_light.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

using namespace contract::lab12;

namespace {

constexpr double unlucky = 0.04, limit = 6;

bool close(double a, double b, double relative) { return a == b || std::abs(a - b) <= relative * std::abs(b); }

glm::vec3 color(numbers& random) { return 0.5f + 0.45f * random.vector(); }

/// Somewhere above, its lit side downwards, nearly: no part of the ground near it is behind it.
lantern::rectangle any_lamp(numbers& random) {
    const glm::vec3 w = glm::normalize(glm::vec3(0, -8, 0) + random.vector()), u = glm::normalize(glm::cross(w, random.direction()));
    return {glm::vec3(0, 3, 0) + random.vector(), random.between(0.3f, 1.5f) * u, random.between(0.3f, 1.5f) * glm::cross(w, u)};
}

const lantern::rectangle ground{{-50, 0, 50}, {100, 0, 0}, {0, 0, -100}};

/// The lamp above the ground, and balls in between: for the suite and for the solution.
struct rooms {
    scene asked;
    lab12::scene ours;
    rooms(numbers& random, int balls) {
        asked.walls = {{ground, {color(random), glm::vec3(0)}}, {any_lamp(random), {glm::vec3(0), 10.0f * color(random)}}};
        for (int i = 0; i < balls; ++i) {
            const glm::vec3 at = glm::vec3(0, 1.2f, 0) + random.vector();
            asked.balls.push_back({lantern::sphere{at, random.between(0.1f, 0.4f)}, {}, {}});
        }
        asked.lamp = 1;
        for (const ball& b : asked.balls) ours.balls.push_back({b.shape, {}, {}});
        for (const wall& w : asked.walls) ours.walls.push_back({w.shape, {w.what.albedo, w.what.emission}});
        ours.lamp = 1;
    }
};

}  // namespace

TEST_CASE("an estimate from any samples", "[step1]") {
    numbers random = hidden::drawn(1);
    for (int i = 0; i < 100; ++i) {
        std::vector<drawn> asked;
        std::vector<lab12::drawn> ours;
        for (std::uint32_t k = hidden::below(random, 30); k > 0; --k) {
            const float value = random.unit() < 0.3f ? 0 : random.between(0, 5), density = hidden::magnitude(random, 0.01f, 10);
            asked.push_back({value, density});
            ours.push_back({value, density});
        }
        CHECK(close(double(estimate(asked)), double(lab12::estimate(ours)), 1e-4));
    }
}

TEST_CASE("directions around any normal", "[step2]") {
    numbers random = hidden::drawn(2);
    for (int i = 0; i < 5; ++i) {
        const glm::vec3 n = random.direction(), side = glm::normalize(glm::cross(n, random.direction()));
        const double least = double(random.between(0.2f, 0.9f));
        int steep = 0, beside = 0;
        for (const glm::vec2 xi : hidden::jittered(random, 32)) {
            const glm::vec3 d = cosine_direction(n, xi);
            CHECK(std::abs(glm::length(d) - 1) <= 1e-5f);
            CHECK(glm::dot(n, d) >= -1e-6f);
            steep += double(glm::dot(n, d)) > least ? 1 : 0;
            beside += glm::dot(side, d) > 0 ? 1 : 0;
        }
        CHECK(std::abs(steep / 1024.0 - (1 - least * least)) < unlucky);
        CHECK(std::abs(beside / 1024.0 - 0.5) < unlucky);
        for (int k = 0; k < 40; ++k) {
            const glm::vec3 d = random.direction();
            CHECK(hidden::apart(cosine_density(n, d), lab12::cosine_density(n, d)) < 1e-5);
        }
    }
}

TEST_CASE("what any bounce carries", "[step3]") {
    numbers random = hidden::drawn(3);
    for (int i = 0; i < 200; ++i) {
        const glm::vec3 carried = 2.0f * color(random), albedo = color(random), n = random.direction(), d = random.direction();
        const float density = hidden::magnitude(random, 0.05f, 20);
        if (std::abs(glm::dot(n, d)) < 1e-3f) continue;
        CHECK(hidden::apart(bounced(carried, albedo, n, d, density), lab12::bounced(carried, albedo, n, d, density)) < 1e-4);
    }
}

TEST_CASE("how densely any lamp is drawn", "[step4]") {
    numbers random = hidden::drawn(4);
    for (int i = 0; i < 200; ++i) {
        const lantern::rectangle lamp = any_lamp(random);
        const glm::vec2 xi = hidden::point(random);
        const glm::vec3 on_lamp = lamp.corner + xi.x * lamp.u + xi.y * lamp.v, from = on_lamp + hidden::magnitude(random, 0.1f, 20) * random.direction();
        if (std::abs(glm::dot(glm::normalize(glm::cross(lamp.u, lamp.v)), glm::normalize(from - on_lamp))) < 0.02f) continue;
        CHECK(close(double(lamp_density(lamp, on_lamp, from)), double(lab12::lamp_density(lamp, on_lamp, from)), 1e-3));
    }
}

TEST_CASE("light straight from any lamp, past any balls", "[step5]") {
    numbers random = hidden::drawn(5);
    hidden::agreement all;
    for (int i = 0; i < 20; ++i) {
        const rooms room(random, 5);
        for (int k = 0; k < 10; ++k) {
            const lantern::hit at{1, glm::vec3(2, 0, 2) * random.vector(), glm::normalize(glm::vec3(0, 1.5f, 0) + random.vector()), 0};
            const glm::vec3 albedo = color(random);
            const glm::vec2 xi = hidden::point(random);
            const lit theirs = from_lamp(room.asked, at, albedo, xi);
            const lab12::lit ours = lab12::from_lamp(room.ours, {at, {albedo, glm::vec3(0)}, false}, xi);
            const bool dark = ours.light == glm::vec3(0);
            all.count(hidden::apart(theirs.light, ours.light) < 1e-3 && (dark || (hidden::apart(theirs.direction, ours.direction) < 1e-4 &&
                                                                                close(double(theirs.density), double(ours.density), 1e-3))));
        }
    }
    CHECK(all.holds());
}

TEST_CASE("the shares of any two densities", "[step6]") {
    numbers random = hidden::drawn(6);
    for (int i = 0; i < 200; ++i) {
        float a = hidden::magnitude(random, 1e-3f, 1e3f), b = hidden::magnitude(random, 1e-3f, 1e3f);
        if (a < b) std::swap(a, b);
        const double more = double(share(a, b)), r = double(b) / double(a);
        CHECK(std::abs(more + double(share(b, a)) - 1) <= 1e-5);
        // Between the balance heuristic and the power heuristic: both are right.
        CHECK(more >= 1 / (1 + r) - 1e-5);
        CHECK(more <= 1 / (1 + r * r) + 1e-5);
        CHECK(share(a, 0) == 1);
        CHECK(share(0, b) == 0);
    }
}

TEST_CASE("roulette with any throughput", "[step7]") {
    numbers random = hidden::drawn(7);
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 carried = random.between(0.05f, 1.5f) * color(random);
        const float chance = std::min(0.9999f, std::max({carried.x, carried.y, carried.z})), xi = random.unit();
        if (std::abs(xi - chance) < 2e-4f) continue;
        CHECK(hidden::apart(roulette(carried, xi), lab12::roulette(carried, xi)) < 1e-4);
    }
}

TEST_CASE("any closed sphere of two halves", "[step8]") {
    numbers random = hidden::drawn(8);
    const matter upper{color(random), 2.0f * color(random)}, lower{color(random), 2.0f * color(random)};
    const scene s{{{lantern::sphere{random.vector(), random.between(0.5f, 4)}, upper, lower}}, {}, {}};
    const bool up = random.unit() < 0.5f;
    const matter& here = up ? upper : lower;
    const auto seen = radiance(s, {{s.balls[0].shape.center, {0.3f * random.unit(), up ? 1.0f : -1.0f, 0.3f * random.unit()}}}, 20'000, hidden::seed(9));
    for (int k = 0; k < 3; ++k) {
        const double albedo = (double(upper.albedo[k]) + double(lower.albedo[k])) / 2, emission = (double(upper.emission[k]) + double(lower.emission[k])) / 2;
        const double exact = double(here.emission[k]) + double(here.albedo[k]) * emission / (1 - albedo);
        statistics::mean m;
        for (const glm::vec3& x : seen) m.add(double(x[k]));
        CHECK(std::abs(m.z(exact)) < limit);
        CHECK(m.standard_error() < 0.03 * exact);
    }
}

TEST_CASE("the ground under any lamp", "[step8]") {
    numbers random = hidden::drawn(10);
    for (int i = 0; i < 3; ++i) {
        const rooms room(random, 0);
        const glm::vec3 at{2 * random.unit() - 1, 0, 2 * random.unit() - 1};
        const lantern::rectangle& lamp = room.asked.walls[1].shape;
        const double irradiance = lantern::exact::irradiance(glm::dvec3(at), {0, 1, 0}, lantern::exact::corners({glm::dvec3(lamp.corner), glm::dvec3(lamp.u), glm::dvec3(lamp.v)}));
        const auto seen = radiance(room.asked, {{at + glm::vec3(0, 0.1f, 0), {0, -1, 0}}}, 10'000, hidden::seed(11 + std::uint64_t(i)));
        for (int k = 0; k < 3; ++k) {
            const double exact = double(room.asked.walls[0].what.albedo[k]) * double(room.asked.walls[1].what.emission[k]) / std::numbers::pi * irradiance;
            statistics::mean m;
            for (const glm::vec3& x : seen) m.add(double(x[k]));
            CHECK(std::abs(m.z(exact)) < limit);
            CHECK(m.standard_error() < 0.02 * exact);
        }
    }
}
