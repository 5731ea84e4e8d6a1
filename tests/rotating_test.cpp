// SPDX-License-Identifier: MIT
#include <lantern/rotating.hpp>

#include <lantern/box.hpp>
#include <lantern/moving.hpp>
#include <lantern/plane.hpp>
#include <lantern/sphere.hpp>
#include <lantern/triangle.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <cmath>
#include <limits>
#include <numbers>

using lantern::interval;
using lantern::ray;
using lantern::rotating;
using lantern::sphere;
using lantern::timed_ray;
using lantern::triangle;

static_assert(!lantern::surface<rotating<sphere>> && lantern::surface<rotating<sphere>, timed_ray>);
static_assert(lantern::bounded<rotating<sphere>> && !lantern::bounded<rotating<lantern::plane>>);
static_assert(lantern::surface<lantern::moving<rotating<sphere>>, timed_ray>, "a wheel that rolls");

namespace {

constexpr int count = 3000;
constexpr float pi = std::numbers::pi_v<float>;

/// v turned about the axis through `point`, by hand: in a basis of the axis and two perpendiculars.
glm::dvec3 by_hand(glm::vec3 v, glm::vec3 point, glm::vec3 axis, double angle) {
    const glm::dvec3 w = glm::normalize(glm::dvec3(axis)), d = glm::dvec3(v) - glm::dvec3(point);
    const glm::dvec3 x = d - glm::dot(d, w) * w, y = glm::cross(w, x);
    return glm::dvec3(point) + glm::dot(d, w) * w + std::cos(angle) * x + std::sin(angle) * y;
}

}  // namespace

TEST_CASE("a quarter turn brings x to y about z, counter-clockwise") {
    const rotating m{sphere{{3, 0, 0}, 0.5f}, {0, 0, 7}, {0, 0, 2}, pi / 2};
    const auto shot = [&](float x, float y, float time) { return intersect(m, timed_ray{{{x, y, 5}, {0, 0, -1}}, time}, interval{}); };
    CHECK(shot(3, 0, 0));
    CHECK_FALSE(shot(0, 3, 0));
    CHECK_FALSE(shot(3, 0, 1));
    REQUIRE(shot(0, 3, 1));
    CHECK(shot(0, 3, 1)->t == Approx(4.5));
    CHECK(shot(0, 3, 1)->normal.z == Approx(1));
    CHECK(shot(3 * std::sqrt(0.5f), 3 * std::sqrt(0.5f), 0.5f));
}

TEST_CASE("a turned triangle is hit where the triangle would be") {
    dice d{1};
    int hits = 0;
    for (int i = 0; i < count; ++i) {
        const rotating m{triangle{d.in_cube(), d.in_cube(), d.in_cube()}, d.in_cube(3), d.in_cube(), d.between(-10, 10)};
        const float time = d.between(0, 1);
        const auto turned = [&](glm::vec3 p) { return by_hand(p, m.point, m.axis, double(time) * double(m.angle)); };
        const glm::dvec3 a = turned(m.surface.a), b = turned(m.surface.b), c = turned(m.surface.c);
        const double u = d.unit() * 1.2 - 0.1, v = d.unit() * (1.1 - u);
        if (std::min({std::abs(u), std::abs(v), std::abs(1 - u - v)}) < 1e-3) continue;
        const glm::vec3 o = d.in_cube(8), direction(a + u * (b - a) + v * (c - a) - glm::dvec3(o));
        const glm::dvec3 n = glm::normalize(glm::cross(b - a, c - a));
        if (std::abs(glm::dot(n, glm::normalize(glm::dvec3(direction)))) < 0.05 || glm::length(glm::cross(b - a, c - a)) < 0.05) continue;
        const auto h = intersect(m, timed_ray{{o, direction}, time}, interval{});
        REQUIRE(h.has_value() == (u > 0 && v > 0 && u + v < 1));
        if (!h) continue;
        ++hits;
        REQUIRE(std::abs(double(h->t) - 1) < 1e-5);
        REQUIRE(glm::length(glm::dvec3(h->normal) - n) < 1e-6);
        REQUIRE(std::abs(glm::dot(n, glm::dvec3(h->point) - a)) < 3e-6);
    }
    CHECK(hits > count / 4);
}

TEST_CASE("the bounds contain the surface during the whole exposure, with the bulge of its arcs") {
    dice d{2};
    for (int i = 0; i < count; ++i) {
        const glm::vec3 a = d.in_cube(), b = d.in_cube();
        const rotating m{lantern::box{glm::min(a, b), glm::max(a, b)}, d.in_cube(3), d.in_cube(), d.between(-8, 8)};
        const lantern::aabb box = bounds(m);
        for (int k = 0; k < 20; ++k) {
            const float time = k == 0 ? 0.0f : k == 1 ? 1.0f : d.between(0, 1);
            const glm::vec3 corner(d.below(2) == 0 ? a.x : b.x, d.below(2) == 0 ? a.y : b.y, d.below(2) == 0 ? a.z : b.z);
            const glm::dvec3 p = by_hand(corner, m.point, m.axis, double(time) * double(m.angle));
            for (int axis = 0; axis < 3; ++axis) REQUIRE((double(box.min[axis]) <= p[axis] && p[axis] <= double(box.max[axis])));
        }
    }
    // Half a turn of a small thing on a long arm: the union of the boxes at its ends is flat, the way is not.
    const lantern::aabb half = bounds(rotating{sphere{{10, 0, 0}, 0.001f}, {0, 0, 0}, {0, 0, 1}, pi});
    CHECK(half.max.y >= 10);
    CHECK(half.max.y <= 10.01f);
    CHECK(half.min.y >= -0.01f);
    CHECK(half.max.z <= 0.0011f);
    const lantern::aabb still = bounds(rotating{sphere{{10, 0, 0}, 1}, {0, 0, 0}, {0, 0, 1}, 0});
    CHECK(still.max.x <= 11.00001f);
    CHECK(still.max.y <= 1.00001f);
}

TEST_CASE("a ray that leaves a turned surface neither meets it again nor loses touch") {
    dice d{3};
    int left = 0;
    for (int i = 0; i < count; ++i) {
        const float scale = d.magnitude_between(-5, 5), time = d.between(0, 1);
        const rotating m{sphere{scale * d.in_cube(3), scale * d.between(0.1, 1)}, scale * d.in_cube(3), d.in_cube(), d.between(-4, 4)};
        const glm::vec3 from = scale * d.in_cube(20), to(by_hand(m.surface.center, m.point, m.axis, double(time) * double(m.angle)));
        const auto h = intersect(m, timed_ray{{from, to - from}, time}, interval{});
        if (!h) continue;
        ++left;
        glm::vec3 away(d.on_sphere());
        if (glm::dot(away, h->normal) < 0) away = -away;
        REQUIRE_FALSE(intersect(m, timed_ray{{leave(*h, away), away}, time}, interval{}));
        REQUIRE(intersect(m, timed_ray{{leave(*h, -away), -away}, time}, interval{}));
    }
    CHECK(left > count / 2);
}

TEST_CASE("a turn that is none is refused and missed") {
    const timed_ray r{{{0, 0, 5}, {0, 0, -1}}, 0.5f};
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), lantern::infinity}) {
        CHECK_FALSE(intersect(rotating{sphere{}, {bad, 0, 0}, {0, 1, 0}, 1}, r, interval{}));
        CHECK_FALSE(intersect(rotating{sphere{}, {0, 0, 0}, {0, 1, 0}, bad}, r, interval{}));
        CHECK_THROWS_WITH(validate(rotating{sphere{}, {bad, 0, 0}, {0, 1, 0}, 1}), containing("rotating: point"));
        CHECK_THROWS_WITH(validate(rotating{sphere{}, {0, 0, 0}, {0, bad, 0}, 1}), containing("rotating: axis"));
        CHECK_THROWS_WITH(validate(rotating{sphere{}, {0, 0, 0}, {0, 1, 0}, bad}), containing("rotating: angle"));
    }
    CHECK_FALSE(intersect(rotating{sphere{}, {0, 0, 0}, {0, 0, 0}, 1}, r, interval{}));
    CHECK_THROWS_WITH(validate(rotating{sphere{}, {0, 0, 0}, {0, 0, 0}, 1}), containing("rotating: axis is (0, 0, 0), but must be different from zero"));
}
