// SPDX-License-Identifier: MIT
// Lab 07's hidden tests, with lenses drawn anew for each grading. Which point of the lens belongs to which xi is the
// student's choice; where it counts, laws are asked for that hold for any. A part of 32 × 32 jittered points is off by less than 0.04, eight times
// its standard deviation.

#include "contract.hpp"

#include <catch.hpp>
#include <hidden.hpp>

#include <lab07_lens/lens.hpp>

using namespace contract::lab07;

namespace {

constexpr double unlucky = 0.04;

struct view {
    glm::vec3 eye;
    glm::mat3 axes;
    explicit view(numbers& random) {
        eye = 3.0f * random.vector();
        const glm::vec3 forward = random.direction(), right = glm::normalize(glm::cross(forward, random.direction()));
        axes = {right, glm::cross(right, forward), forward};
    }
};

template <class Map, class Law>
double part(numbers& random, Map map, Law law) {
    int inside = 0;
    for (const glm::vec2 xi : hidden::jittered(random, 32)) inside += law(map(xi)) ? 1 : 0;
    return inside / 1024.0;
}

}  // namespace

TEST_CASE("any part of any lens", "[step1]") {
    numbers random = hidden::drawn(1);
    const float radius = hidden::magnitude(random, 0.01f, 10), part_of_it = random.between(0.2f, 0.95f);
    const glm::vec2 side = glm::normalize(glm::vec2(random.direction()));
    const auto map = [&](glm::vec2 xi) { return on_lens(xi, radius); };
    CHECK(std::abs(part(random, map, [&](glm::vec2 p) { return glm::length(p) < part_of_it * radius; }) - double(part_of_it * part_of_it)) < unlucky);
    CHECK(std::abs(part(random, map, [&](glm::vec2 p) { return glm::dot(p, side) > 0; }) - 0.5) < unlucky);
    CHECK(part(random, map, [&](glm::vec2 p) { return glm::length(p) <= 1.00001f * radius; }) == 1);
}

TEST_CASE("any point in focus", "[step2]") {
    numbers random = hidden::drawn(2);
    for (int i = 0; i < 200; ++i) {
        const view v(random);
        const glm::vec2 film(random.vector());
        const float focus = hidden::magnitude(random, 0.1f, 100);
        CHECK(hidden::apart(point_in_focus(v.eye, v.axes, film, focus), lab07::point_in_focus(v.eye, v.axes, film, focus)) < 1e-5);
    }
}

TEST_CASE("any ray through any lens", "[step3]") {
    numbers random = hidden::drawn(3);
    for (int i = 0; i < 200; ++i) {
        const view v(random);
        const glm::vec2 film(random.vector());
        const float focus = hidden::magnitude(random, 0.5f, 50), radius = random.between(0, 0.3f);
        const lantern::ray r = through_lens(v.eye, v.axes, film, radius, focus, hidden::point(random));
        const glm::dvec3 from = glm::dvec3(r.origin) - glm::dvec3(v.eye), aim = glm::dvec3(lab07::point_in_focus(v.eye, v.axes, film, focus)) - glm::dvec3(r.origin);
        CHECK(std::abs(glm::length(glm::dvec3(r.direction)) - 1) < 1e-5);
        CHECK(std::abs(glm::dot(from, glm::dvec3(v.axes[2]))) < 1e-5);
        CHECK(glm::length(from) <= 1.0001 * double(radius) + 1e-5);
        CHECK(glm::length(glm::cross(glm::normalize(aim), glm::dvec3(r.direction))) < 1e-4);
        CHECK(glm::dot(aim, glm::dvec3(r.direction)) > 0);
    }
}

TEST_CASE("any circle of confusion", "[step4]") {
    numbers random = hidden::drawn(4);
    for (int i = 0; i < 200; ++i) {
        const float radius = random.between(0.01f, 1), focus = hidden::magnitude(random, 0.2f, 100), depth = hidden::magnitude(random, 0.2f, 100);
        CHECK(hidden::apart(circle_of_confusion(radius, focus, depth), lab07::circle_of_confusion(radius, focus, depth)) < 1e-4);
    }
}

TEST_CASE("any depth of field", "[step5]") {
    numbers random = hidden::drawn(5);
    for (int i = 0; i < 200; ++i) {
        const float radius = random.between(0.01f, 0.5f), focus = hidden::magnitude(random, 0.2f, 20), diameter = hidden::magnitude(random, 1e-3f, 0.2f);
        const double reach = double(diameter) / (2 * double(radius)) * double(focus);
        if (std::abs(reach - 1) < 0.02) continue;  // where the farthest goes to infinity
        const auto [nearest, farthest] = depth_of_field(radius, focus, diameter);
        const auto ours = lab07::depth_of_field(radius, focus, diameter);
        CHECK(hidden::apart(nearest, ours.first) < 1e-3);
        CHECK(hidden::apart(farthest, ours.second) < 1e-3);
    }
}

TEST_CASE("any pixel through any lens", "[step6]") {
    numbers random = hidden::drawn(6);
    for (int i = 0; i < 40; ++i) {
        const view v(random);
        const float focus = random.between(1, 8), radius = random.between(0.01f, 0.3f);
        const std::size_t count = 1 + hidden::below(random, 16);
        const std::vector<glm::vec2> film = hidden::points(random, count), lens = hidden::points(random, count);
        glm::dvec3 expected{0};
        for (const glm::vec2 f : film) expected += glm::dvec3(lab07::point_in_focus(v.eye, v.axes, f, focus)) / double(count);
        // What is seen is the place where a ray meets the plane of focus: the same for all points of the lens.
        const glm::vec3 mean = pixel(v.eye, v.axes, radius, focus, film, lens, [&](lantern::ray r) {
            const float t = (focus - glm::dot(r.origin - v.eye, v.axes[2])) / glm::dot(r.direction, v.axes[2]);
            return r.origin + t * r.direction;
        });
        CHECK(hidden::apart(mean, glm::vec3(expected)) < 1e-4);
    }
}

TEST_CASE("any part of any blades", "[step7]") {
    numbers random = hidden::drawn(7);
    for (int i = 0; i < 3; ++i) {
        const int blades = 3 + int(hidden::below(random, 7));
        const float radius = hidden::magnitude(random, 0.1f, 10), smaller = random.between(0.3f, 0.95f);
        const double pi = 3.14159265358979323846;
        // How far out a point is: 1 on the polygon's edges.
        const auto outwards = [&](glm::vec2 p) {
            double most = 0;
            for (int k = 0; k < blades; ++k) {
                const double angle = 2 * pi * (k + 0.5) / blades;
                most = std::max(most, (double(p.x) * std::cos(angle) + double(p.y) * std::sin(angle)) / (double(radius) * std::cos(pi / blades)));
            }
            return p.x == p.x && p.y == p.y ? most : INFINITY;
        };
        const auto map = [&](glm::vec2 xi) { return on_blades(xi, radius, blades); };
        CHECK(std::abs(part(random, map, [&](glm::vec2 p) { return outwards(p) < double(smaller); }) - double(smaller * smaller)) < unlucky);
        CHECK(part(random, map, [&](glm::vec2 p) { return outwards(p) < 1.0001; }) == 1);
        CHECK(std::abs(part(random, map, [](glm::vec2 p) { return p.y > 0; }) - 0.5) < unlucky);
    }
}
