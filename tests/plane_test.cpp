// SPDX-License-Identifier: MIT
#include <lantern/plane.hpp>

#include <lantern/aabb.hpp>
#include <lantern/surface.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <algorithm>
#include <limits>

using lantern::interval;
using lantern::plane;
using lantern::ray;

static_assert(lantern::surface<plane> && !lantern::bounded<plane>, "a plane is a surface, but has no bounds");

namespace {

struct score {
    int rays = 0, hits = 0, wrong = 0;
    double t = 0, beyond = 0;
};

void judge(score& all, const plane& s, const ray& r) {
    const wide3 n = widened(s.normal);
    const wide speed = dot(n, widened(r.direction)), above = dot(n, widened(s.point) - widened(r.origin));
    const bool met = speed != 0 && above / speed > 0 && above / speed < wide(3e38);
    const auto h = intersect(s, r, interval{});
    ++all.rays;
    all.wrong += h.has_value() != met;
    if (!h || !met) return;
    ++all.hits;
    all.t = std::max(all.t, error_in_ulp(h->t, above / speed));
    const wide away = magnitude(dot(n, widened(h->point) - widened(s.point))) / length(n);
    const glm::vec3 p = glm::abs(h->point);
    const float rounding = 0.87f * lantern::ulp(std::max({p.x, p.y, p.z}));
    all.beyond = std::max(all.beyond, static_cast<double>(away / static_cast<wide>(h->error + rounding)));
    CHECK(largest_difference(h->normal, (1 / length(n)) * n) <= 6e-8);
}

constexpr int count = 5000;

}  // namespace

TEST_CASE("a plane is met where the height above it is used up") {
    const plane ground{{5, -1, 3}, {0, 2, 0}};
    const auto h = intersect(ground, ray{{0, 1, 0}, {2, -1, 0}}, interval{});
    REQUIRE(h);
    CHECK(h->t == 2);
    CHECK(h->point == glm::vec3(4, -1, 0));
    CHECK(h->normal == glm::vec3(0, 1, 0));
    CHECK_FALSE(intersect(ground, ray{{0, 1, 0}, {2, 1, 0}}, interval{}));
    CHECK(intersect(ground, ray{{0, -3, 0}, {0, 1, 0}}, interval{})->normal == glm::vec3(0, 1, 0));
    CHECK_FALSE(intersect(ground, ray{{0, 1, 0}, {2, -1, 0}}, interval{0, 1.9999999f}));
    CHECK_FALSE(intersect(ground, ray{{0, 1, 0}, {2, -1, 0}}, interval{2, 9}));
}

TEST_CASE("only a ray exactly parallel to a plane is missed for that") {
    const plane ground{};
    CHECK_FALSE(intersect(ground, ray{{0, 1, 0}, {1, 0, 0}}, interval{}));
    CHECK_FALSE(intersect(ground, ray{{0, 0, 0}, {1, 0, 0}}, interval{}));
    CHECK(intersect(ground, ray{{0, 1, 0}, {1, -1e-30f, 0}}, interval{}));
    CHECK_FALSE(intersect(ground, ray{{0, 1, 0}, {0, 0, 0}}, interval{}));
}

TEST_CASE("slanting, far, near or scaled, a plane is met right to half an ulp") {
    dice d{GENERATE(1u, 2u)};
    score all;
    SECTION("anywhere") {
        for (int i = 0; i < count; ++i) judge(all, {d.in_cube(10), d.in_cube()}, {d.in_cube(10), d.in_cube()});
    }
    SECTION("a ray within 1e-5 of the plane, and nearer") {
        for (int i = 0; i < count; ++i) {
            const plane s{d.in_cube(10), d.in_cube()};
            const glm::dvec3 n = glm::normalize(glm::dvec3(s.normal));
            const glm::dvec3 along = glm::cross(n, d.on_sphere()) + double(d.magnitude_between(-8, -5)) * d.on_sphere();
            judge(all, s, {d.in_cube(10), glm::vec3(along)});
        }
    }
    SECTION("an origin next to the plane, far from the origin of the world") {
        for (int i = 0; i < count; ++i) {
            const plane s{d.in_cube(1e5), d.in_cube()};
            const glm::dvec3 side = glm::cross(glm::dvec3(s.normal), d.on_sphere());
            judge(all, s, {glm::vec3(glm::dvec3(s.point) + 1e3 * side), d.in_cube()});
        }
    }
    SECTION("at any scale") {
        for (int i = 0; i < count; ++i) {
            const float scale = d.magnitude_between(-25, 25);
            judge(all, {scale * d.in_cube(10), d.magnitude_between(-12, 12) * d.in_cube()}, {scale * d.in_cube(10), d.in_cube()});
        }
    }
    CHECK(all.hits > all.rays / 4);
    CHECK(all.wrong == 0);
    CHECK(all.t <= 0.501);
    CHECK(all.beyond <= 1);
}

TEST_CASE("numbers that are none are no plane") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float bad : {nan, lantern::infinity}) {
        CHECK_FALSE(intersect(plane{{0, bad, 0}, {0, 1, 0}}, ray{{0, 1, 0}, {0, -1, 0}}, interval{}));
        CHECK_FALSE(intersect(plane{{0, 0, 0}, {0, bad, 0}}, ray{{0, 1, 0}, {0, -1, 0}}, interval{}));
        CHECK_THROWS_WITH(validate(plane{{0, bad, 0}, {0, 1, 0}}), containing("plane: point"));
        CHECK_THROWS_WITH(validate(plane{{0, 0, 0}, {bad, 1, 0}}), containing("plane: normal"));
    }
    CHECK_FALSE(intersect(plane{{0, 0, 0}, {0, 0, 0}}, ray{{0, 1, 0}, {0, -1, 0}}, interval{}));
    CHECK_THROWS_WITH(validate(plane{{0, 0, 0}, {0, 0, 0}}), containing("plane: normal is (0, 0, 0), but must be different from zero"));
    CHECK_NOTHROW(validate(plane{}));
}

TEST_CASE("a ray that leaves a plane does not meet it again, and one towards it does, at any scale") {
    dice d{3};
    for (int i = 0; i < count; ++i) {
        const float scale = d.magnitude_between(-6, 6);
        const plane s{scale * d.in_cube(10), d.in_cube()};
        const auto h = intersect(s, ray{scale * d.in_cube(10), d.in_cube()}, interval{});
        if (!h) continue;
        const glm::vec3 away(d.on_sphere());
        const glm::vec3 origin = leave(*h, away);
        REQUIRE_FALSE(intersect(s, ray{origin, away}, interval{}));
        REQUIRE(intersect(s, ray{origin, -away}, interval{}));
    }
}
