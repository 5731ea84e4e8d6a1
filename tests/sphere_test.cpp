// SPDX-License-Identifier: MIT
#include <lantern/sphere.hpp>

#include <lantern/surface.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <glm/vec3.hpp>

#include <algorithm>
#include <limits>
#include <optional>

using lantern::interval;
using lantern::ray;
using lantern::sphere;

namespace {

struct truth {
    wide t;
    wide3 point, normal;
};

/// What a ray hits first at t > 0, as seen with 113 bits. `sure` is false where even those cannot tell.
std::optional<truth> true_hit(const sphere& s, const ray& r, bool& sure) {
    const wide3 f = widened(r.origin) - widened(s.center), d = widened(r.direction);
    const wide radius = magnitude(s.radius), a = dot(d, d), b = -dot(f, d), k = dot(f, f) - radius * radius;
    const wide discriminant = b * b - a * k;
    sure = magnitude(discriminant) > static_cast<wide>(1e-25) * b * b || discriminant == 0;
    if (discriminant < 0) return std::nullopt;
    const wide root = square_root(discriminant), q = b >= 0 ? b + root : b - root;
    const wide t0 = b >= 0 ? k / q : q / a, t1 = b >= 0 ? q / a : k / q;
    const wide t = t0 > 0 ? t0 : t1;
    if (!(t > 0)) return std::nullopt;
    const wide3 normal = (1 / radius) * (f + t * d);
    return truth{t, widened(r.origin) + t * d, normal};
}

struct score {
    int rays = 0, hits = 0, wrong = 0;
    double t = 0, normal = 0, beyond = 0;  // the largest: ulp of t, of the normal's components, distance / (error + rounding)
};

void judge(score& all, const sphere& s, const ray& r) {
    bool sure = true;
    const auto expected = true_hit(s, r, sure);
    if (!sure) return;
    const auto h = intersect(s, r, interval{});
    ++all.rays;
    if (h.has_value() != expected.has_value()) {
        ++all.wrong;
        return;
    }
    if (!h) return;
    ++all.hits;
    all.t = std::max(all.t, error_in_ulp(h->t, expected->t));
    all.normal = std::max(all.normal, largest_difference(h->normal, expected->normal));
    const wide away = magnitude(length(widened(h->point) - widened(s.center)) - magnitude(s.radius));
    const glm::vec3 p = glm::abs(h->point);
    const float rounding = 0.87f * lantern::ulp(std::max({p.x, p.y, p.z}));
    all.beyond = std::max(all.beyond, static_cast<double>(away / static_cast<wide>(h->error + rounding)));
}

void check(const score& all) {
    INFO(all.rays << " rays, " << all.hits << " hits");
    CHECK(all.wrong == 0);
    CHECK(all.hits > all.rays / 10);
    CHECK(all.t <= 0.501);
    CHECK(all.normal <= 6e-8);
    CHECK(all.beyond <= 1);
}

/// A ray from `origin` that passes the center at `offset` radii.
ray aimed(dice& d, const sphere& s, const glm::dvec3& origin, double offset) {
    const glm::dvec3 to = glm::dvec3(s.center) - origin;
    const glm::dvec3 side = glm::normalize(glm::cross(to, d.on_sphere()));
    const double distance = glm::length(to);
    // The tangent cone's angle, so that `offset` 1 is tangential however near the origin is.
    const double sine = std::min(1.0, offset * std::abs(double(s.radius)) / distance);
    return {glm::vec3(origin), glm::vec3(std::sqrt(1 - sine * sine) * to / distance + sine * side)};
}

constexpr int count = 4000;

}  // namespace

TEST_CASE("a sphere is hit where the formulas of school say") {
    const sphere s{{0, 0, -5}, 1};
    const auto h = intersect(s, ray{{0, 0, 0}, {0, 0, -2}}, interval{});
    REQUIRE(h);
    CHECK(h->t == 2);
    CHECK(h->point == glm::vec3(0, 0, -4));
    CHECK(h->normal == glm::vec3(0, 0, 1));
    CHECK_FALSE(intersect(s, ray{{0, 0, 0}, {0, 0, 2}}, interval{}));
    CHECK_FALSE(intersect(s, ray{{0, 1.001f, 0}, {0, 0, -1}}, interval{}));
}

TEST_CASE("the range is open at its beginning and closed at its end") {
    const sphere s{{0, 0, -5}, 1};
    const ray r{{0, 0, 0}, {0, 0, -1}};
    CHECK(intersect(s, r, interval{0, 4})->t == 4);
    CHECK_FALSE(intersect(s, r, interval{0, 3.9999998f}));
    CHECK(intersect(s, r, interval{4, 10})->t == 6);  // the far side, when the near one is behind the beginning
    CHECK_FALSE(intersect(s, r, interval{6, 10}));
    CHECK(intersect(s, ray{{0, 0, -10}, {0, 0, -1}}, interval{-10, 0})->t == -6);
}

TEST_CASE("far, near, inside, grazing, at any size, a sphere is hit right to half an ulp") {
    dice d{GENERATE(1u, 2u)};
    score all;
    SECTION("from everywhere") {
        for (int i = 0; i < count; ++i) {
            const sphere s{d.in_cube(10), d.magnitude_between(-3, 1)};
            judge(all, s, aimed(d, s, d.in_cube(10), 1.3 * d.unit()));
        }
    }
    SECTION("from 100 000 radii away") {
        for (int i = 0; i < count; ++i) {
            const sphere s{d.in_cube(), 1};
            judge(all, s, aimed(d, s, 1e5 * d.on_sphere(), 1.3 * d.unit()));
        }
    }
    SECTION("from the surface's height 0.0001 r") {
        for (int i = 0; i < count; ++i) {
            const sphere s{d.in_cube(), d.magnitude_between(-2, 2)};
            const glm::dvec3 origin = glm::dvec3(s.center) + (1 + 1e-4) * s.radius * d.on_sphere();
            judge(all, s, {glm::vec3(origin), glm::vec3(d.on_sphere())});
        }
    }
    SECTION("from just above and just below the surface") {
        for (int i = 0; i < count; ++i) {
            const sphere s{d.in_cube(), d.magnitude_between(-2, 2)};
            const double height = (d.unit() < 0.5 ? -1.0 : 1.0) * d.magnitude_between(-12, -1);
            judge(all, s, {glm::vec3(glm::dvec3(s.center) + (1 + height) * s.radius * d.on_sphere()), glm::vec3(d.on_sphere())});
        }
    }
    SECTION("from inside") {
        for (int i = 0; i < count; ++i) {
            const sphere s{d.in_cube(), 3};
            judge(all, s, {d.in_cube(), glm::vec3(d.on_sphere())});
        }
    }
    SECTION("a ground of radius 1e6 or 1e12") {
        const float radius = GENERATE(1e6f, 1e12f);
        const sphere s{{0, -radius, 0}, radius};
        for (int i = 0; i < count; ++i) {
            const glm::vec3 from(d.between(-10, 10), d.magnitude_between(-7, 5), d.between(-10, 10));
            const float spread = d.magnitude_between(-4, 1);
            const glm::vec3 to(d.between(-spread, spread), 0, d.between(-spread, spread));
            judge(all, s, {from, i % 2 == 0 ? to - from : glm::vec3(d.on_sphere())});
        }
    }
    SECTION("a slope of radius 1e6 or 1e12, through the origin") {
        const float fifth = GENERATE(0x1p18f, 0x1p38f);
        const sphere s{{-3 * fifth, -4 * fifth, 0}, 5 * fifth};
        for (int i = 0; i < count; ++i) {
            const glm::vec3 to = d.magnitude_between(-4, 1) * glm::vec3(4, -3, 5) * d.between(-1, 1);
            const glm::vec3 from = to + d.magnitude_between(-7, 11) * (d.in_cube() + glm::vec3(1.1f, 1.2f, 0));
            if (from != to) judge(all, s, {from, to - from});
        }
    }
    SECTION("grazing") {
        for (int i = 0; i < count; ++i) {
            const sphere s{d.in_cube(), 1};
            const double offset = 1 + (d.unit() < 0.5 ? -1.0 : 1.0) * d.magnitude_between(-16, -5);
            judge(all, s, aimed(d, s, double(d.between(0.5, 4)) * d.on_sphere(), offset));
        }
    }
    SECTION("a direction that is not of unit length") {
        for (int i = 0; i < count; ++i) {
            const sphere s{d.in_cube(10), d.magnitude_between(-3, 1)};
            ray r = aimed(d, s, d.in_cube(10), 1.3 * d.unit());
            r.direction *= d.magnitude_between(-18, 18);
            judge(all, s, r);
        }
    }
    check(all);
}

TEST_CASE("the same scene at another scale is the same scene") {
    const float scale = GENERATE(0x1p66f, 0x1p-66f, 0x1p100f, 0x1p-80f);  // 7e19, 1e-20, 1e30, 8e-25
    dice d{3};
    int hits = 0;
    for (int i = 0; i < count; ++i) {
        const sphere s{d.in_cube(10), d.magnitude_between(-1, 1)};
        const ray r = aimed(d, s, d.in_cube(10), 1.1 * d.unit());
        const auto h = intersect(s, r, interval{});
        const auto scaled = intersect(sphere{scale * s.center, scale * s.radius}, ray{scale * r.origin, r.direction}, interval{});
        const auto both = intersect(sphere{scale * s.center, scale * s.radius}, ray{scale * r.origin, scale * r.direction}, interval{});
        REQUIRE(h.has_value() == scaled.has_value());
        REQUIRE(h.has_value() == both.has_value());
        if (!h) continue;
        ++hits;
        REQUIRE(scaled->t == scale * h->t);
        REQUIRE(scaled->point == scale * h->point);
        REQUIRE(scaled->normal == h->normal);
        REQUIRE(both->t == h->t);
        REQUIRE(both->normal == h->normal);
    }
    CHECK(hits > count / 2);
}

TEST_CASE("a mirrored scene is the mirrored scene") {
    dice d{4};
    for (int i = 0; i < count; ++i) {
        const sphere s{d.in_cube(10), d.magnitude_between(-1, 1)};
        const ray r = aimed(d, s, d.in_cube(10), 1.1 * d.unit());
        const glm::vec3 flip(-1, 1, -1);
        const auto h = intersect(s, r, interval{}), m = intersect(sphere{flip * s.center, s.radius}, ray{flip * r.origin, flip * r.direction}, interval{});
        REQUIRE(h.has_value() == m.has_value());
        if (!h) continue;
        REQUIRE(m->t == h->t);
        REQUIRE(m->normal == flip * h->normal);
    }
}

TEST_CASE("a negative radius turns the normals inwards and changes nothing else") {
    dice d{5};
    for (int i = 0; i < count; ++i) {
        const sphere s{d.in_cube(), d.magnitude_between(-1, 1)}, hollow{s.center, -s.radius};
        const ray r{d.in_cube(5), glm::vec3(d.on_sphere())};
        const auto h = intersect(s, r, interval{}), inner = intersect(hollow, r, interval{});
        REQUIRE(h.has_value() == inner.has_value());
        if (!h) continue;
        REQUIRE(inner->t == h->t);
        REQUIRE(inner->point == h->point);
        REQUIRE(inner->normal == -h->normal);
        REQUIRE(bounds(hollow).min == bounds(s).min);
    }
}

TEST_CASE("a sphere of radius 0 is a point") {
    const sphere s{{1, 2, 3}, 0};
    const auto h = intersect(s, ray{{1, 2, 0}, {0, 0, 2}}, interval{});
    REQUIRE(h);
    CHECK(h->t == 1.5f);
    CHECK(h->point == s.center);
    CHECK(h->normal == glm::vec3(0, 0, -1));
    CHECK_FALSE(intersect(s, ray{{1, 2.0000002f, 0}, {0, 0, 2}}, interval{}));
    CHECK_FALSE(intersect(s, ray{{0, 0, 0}, {0, 0, 2}}, interval{}));
}

TEST_CASE("numbers that are none, and rays without a direction, hit nothing") {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = lantern::infinity;
    const ray r{{0, 0, 5}, {0, 0, -1}};
    for (const float bad : {nan, inf, -inf}) {
        CHECK_FALSE(intersect(sphere{{bad, 0, 0}, 1}, r, interval{}));
        CHECK_FALSE(intersect(sphere{{0, 0, 0}, bad}, r, interval{}));
        CHECK_FALSE(intersect(sphere{}, ray{{0, bad, 5}, {0, 0, -1}}, interval{}));
        CHECK_FALSE(intersect(sphere{}, ray{{0, 0, 5}, {bad, 0, -1}}, interval{}));
        CHECK_THROWS_WITH(validate(sphere{{0, bad, 0}, 1}), containing("sphere: center is (0, "));
        CHECK_THROWS_WITH(validate(sphere{{0, 0, 0}, bad}), containing("sphere: radius is "));
    }
    CHECK_FALSE(intersect(sphere{}, ray{{0, 0, 5}, {0, 0, 0}}, interval{}));
    CHECK_FALSE(intersect(sphere{}, ray{{0, 0, 0}, {0, 0, 0}}, interval{}));
    CHECK_NOTHROW(validate(sphere{{0, 0, 0}, -1}));
}

TEST_CASE("the bounds contain the sphere for certain, and hardly more") {
    dice d{6};
    for (int i = 0; i < count; ++i) {
        const sphere s{d.in_cube(10), d.magnitude_between(-12, 6)};
        const lantern::aabb box = bounds(s);
        for (int k = 0; k < 3; ++k) {
            const wide lo = wide(s.center[k]) - wide(s.radius), hi = wide(s.center[k]) + wide(s.radius);
            REQUIRE(wide(box.min[k]) <= lo);
            REQUIRE(wide(box.max[k]) >= hi);
            REQUIRE(error_in_ulp(box.min[k], lo) <= 1);
            REQUIRE(error_in_ulp(box.max[k], hi) <= 1);
        }
    }
}

TEST_CASE("a ray that leaves a sphere neither meets it again nor loses touch, at any scale") {
    const float scale = GENERATE(1e-6f, 1e-3f, 1.0f, 1e3f, 1e6f);
    dice d{7};
    int again = 0, lost = 0, left = 0;
    for (int i = 0; i < count; ++i) {
        const sphere s{scale * d.in_cube(3), scale * d.between(0.1, 1)};
        const auto h = intersect(s, aimed(d, s, double(scale) * 10.0 * d.on_sphere(), d.unit()), interval{});
        if (!h) continue;
        ++left;
        glm::vec3 away(d.on_sphere());
        if (glm::dot(away, h->normal) < 0) away = -away;
        again += intersect(s, ray{leave(*h, away), away}, interval{}).has_value();     // outside a convex body: nothing to meet
        lost += !intersect(s, ray{leave(*h, -away), -away}, interval{}).has_value();  // inside: the other wall
    }
    CHECK(left > count / 2);
    CHECK(again == 0);
    CHECK(lost == 0);
}

TEST_CASE("a sphere so small and far that it is a point to double-double has a normal towards the ray, and never NaN") {
    const glm::vec3 center(3e7f, 1e7f, -2e7f);
    for (const float radius : {0.0f, 1e-18f, 1e-10f, 1e-3f}) {
        const auto h = intersect(sphere{center, radius}, ray{{0, 0, 0}, center}, interval{});
        REQUIRE(h);
        CHECK(h->t == 1);
        CHECK(glm::dot(h->normal, glm::normalize(center)) == Approx(-1));
    }
}
