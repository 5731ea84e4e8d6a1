// SPDX-License-Identifier: MIT
// Lab 05's hidden tests: the solution's answers, for lamps, balls and points drawn anew for each grading.

#include "contract.hpp"

#include <catch.hpp>
#include <hidden.hpp>

#include <lab05_soft_shadows/soft_shadows.hpp>

using namespace contract::lab05;

namespace {

/// The same for the suite and for the solution.
struct lamps {
    contract::lab05::lamp asked;
    lab05::lamp ours;
    explicit lamps(numbers& random) {
        const glm::vec3 u = random.direction(), v = glm::normalize(glm::cross(u, random.direction()));
        asked = {.corner = glm::vec3(0, 4, 0) + random.vector(), .edge_u = random.between(0.3f, 2) * u, .edge_v = random.between(0.3f, 2) * v,
                 .radiance = 3.0f + 2.0f * random.vector()};
        ours = {asked.corner, asked.edge_u, asked.edge_v, asked.radiance};
    }
};

struct balls {
    contract::lab05::scene asked;
    lab05::scene ours;
    explicit balls(numbers& random) {
        for (int i = 0; i < 4; ++i) asked.balls.push_back({glm::vec3(0, 2, 0) + 1.5f * random.vector(), random.between(0.1f, 0.5f)});
        ours.balls = asked.balls;
    }
};

/// Somewhere below, facing up or nearly.
lantern::hit floor(numbers& random) {
    return {.t = 1, .point = glm::vec3(2, 0, 2) * random.vector(), .normal = glm::normalize(glm::vec3(0, 2, 0) + random.vector())};
}

}  // namespace

TEST_CASE("any point of any lamp", "[step1]") {
    numbers random = hidden::drawn(1);
    for (int i = 0; i < 200; ++i) {
        const lamps l(random);
        const glm::vec2 xi = hidden::point(random);
        CHECK(hidden::apart(point_on(l.asked, xi), lab05::point_on(l.ours, xi)) < 1e-5);
    }
}

TEST_CASE("any light from any point", "[step2]") {
    numbers random = hidden::drawn(2);
    hidden::agreement all;
    for (int i = 0; i < 300; ++i) {
        const lamps l(random);
        const glm::vec3 on_lamp = lab05::point_on(l.ours, hidden::point(random)), position = 3.0f * random.vector(), normal = random.direction();
        if (glm::length(on_lamp - position) < 0.3f) continue;
        all.count(hidden::apart(irradiance(l.asked, on_lamp, position, normal), lab05::irradiance(l.ours, on_lamp, position, normal)) < 1e-4);
    }
    CHECK(all.holds());
}

TEST_CASE("any shadow ray", "[step3]") {
    numbers random = hidden::drawn(3);
    hidden::agreement all;
    for (int i = 0; i < 300; ++i) {
        const balls s(random);
        const lantern::hit h = floor(random);
        const glm::vec3 on_lamp = glm::vec3(0, 4, 0) + random.vector();
        all.count(visible(h, on_lamp, s.asked) == lab05::visible(h, on_lamp, s.ours));
    }
    CHECK(all.holds());
}

TEST_CASE("any soft shadow", "[step4]") {
    numbers random = hidden::drawn(4);
    hidden::agreement all;
    for (int i = 0; i < 200; ++i) {
        const lamps l(random);
        const balls s(random);
        const lantern::hit h = floor(random);
        const std::vector<glm::vec2> points = hidden::points(random, 1 + hidden::below(random, 12));
        all.count(hidden::apart(soft_light(l.asked, h, s.asked, points), lab05::soft_light(l.ours, h, s.ours, points)) < 1e-3);
    }
    CHECK(all.holds());
}

TEST_CASE("any ball, from near and far", "[step5]") {
    numbers random = hidden::drawn(5);
    for (int i = 0; i < 200; ++i) {
        const float radius = hidden::magnitude(random, 0.01f, 100), distance = radius * hidden::magnitude(random, 1.1f, 5000);
        const glm::vec3 from = radius * random.vector(), center = from + distance * random.direction();
        const double sine2 = std::pow(double(radius) / glm::length(glm::dvec3(center) - glm::dvec3(from)), 2);
        const double exact = 2 * 3.14159265358979323846 * sine2 / (1 + std::sqrt(1 - sine2));
        CHECK(std::abs(double(solid_angle(center, radius, from)) / exact - 1) < 2e-3);
    }
}

TEST_CASE("any direction towards any ball", "[step6]") {
    numbers random = hidden::drawn(6);
    for (int i = 0; i < 200; ++i) {
        const float radius = random.between(0.3f, 2), distance = radius * random.between(1.1f, 8);
        const glm::vec3 from = random.vector(), center = from + distance * random.direction();
        const glm::vec2 xi = hidden::point(random);
        const glm::dvec3 d(towards_ball(center, radius, from, xi)), axis = glm::normalize(glm::dvec3(center) - glm::dvec3(from));
        const double sine2 = std::pow(double(radius) / glm::length(glm::dvec3(center) - glm::dvec3(from)), 2);
        CHECK(std::abs(glm::length(d) - 1) < 1e-5);
        CHECK(std::abs(1 - glm::dot(glm::normalize(d), axis) - double(xi.x) * sine2 / (1 + std::sqrt(1 - sine2))) < 3e-6);
    }
}
