// SPDX-License-Identifier: MIT
#include <lantern/rectangle.hpp>

#include <lantern/precise.hpp>
#include <lantern/surface.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <algorithm>
#include <array>
#include <limits>

using lantern::interval;
using lantern::ray;
using lantern::rectangle;

namespace {

constexpr int count = 5000;

rectangle random_parallelogram(dice& d, double size) { return {d.in_cube(3), d.in_cube(size), d.in_cube(size)}; }

glm::dvec3 at(const rectangle& s, double a, double b) { return glm::dvec3(s.corner) + a * glm::dvec3(s.u) + b * glm::dvec3(s.v); }

}  // namespace

TEST_CASE("a rectangle is hit between its edges, and its normal is along u × v") {
    const rectangle s{{-1, 0, -1}, {0, 0, 2}, {2, 0, 0}};
    const auto h = intersect(s, ray{{0.5f, 2, 0.25f}, {0, -2, 0}}, interval{});
    REQUIRE(h);
    CHECK(h->t == 1);
    CHECK(h->point == glm::vec3(0.5f, 0, 0.25f));
    CHECK(h->normal == glm::vec3(0, 1, 0));
    CHECK(intersect(s, ray{{1, 2, 1}, {0, -2, 0}}, interval{}));  // the corner itself
    CHECK_FALSE(intersect(s, ray{{1.001f, 2, 0}, {0, -2, 0}}, interval{}));
    CHECK_FALSE(intersect(s, ray{{0, 2, -1.001f}, {0, -2, 0}}, interval{}));
    CHECK_FALSE(intersect(s, ray{{0, 0, -3}, {0, 0, 1}}, interval{}));  // within the plane
    CHECK_FALSE(intersect(s, ray{{0, 2, 0}, {0, -2, 0}}, interval{0, 0.99999994f}));
}

TEST_CASE("a parallelogram is hit right, to half an ulp") {
    dice d{GENERATE(1u, 2u, 3u)};
    const double size = GENERATE(1.0, 1e-3);
    double t_error = 0, beyond = 0;
    int wrong = 0, hits = 0;
    for (int i = 0; i < count; ++i) {
        const rectangle s = random_parallelogram(d, size);
        const glm::vec3 o = d.in_cube(5);
        const double a = d.unit() * 1.4 - 0.2, b = d.unit() * 1.4 - 0.2;
        const ray r{o, glm::vec3(glm::normalize(at(s, a, b) - glm::dvec3(o)))};
        const wide3 u = widened(s.u), v = widened(s.v), n = cross(u, v), to = widened(s.corner) - widened(o);
        const wide t = dot(n, to) / dot(n, widened(r.direction));
        const wide3 p = t * widened(r.direction) - to;
        const wide alpha = dot(cross(p, v), n) / dot(n, n), beta = dot(cross(u, p), n) / dot(n, n);
        const auto inside = [](wide x) { return x >= 0 && x <= 1; };
        const auto near_edge = [](wide x) { return magnitude(x) < wide(1e-9) || magnitude(x - 1) < wide(1e-9); };
        if (near_edge(alpha) || near_edge(beta)) continue;
        const bool met = t > 0 && inside(alpha) && inside(beta);
        const auto h = intersect(s, r, interval{});
        wrong += h.has_value() != met;
        if (!h || !met) continue;
        ++hits;
        t_error = std::max(t_error, error_in_ulp(h->t, t));
        const wide away = magnitude(dot(n, widened(h->point) - widened(s.corner))) / length(n);
        const glm::vec3 q = glm::abs(h->point);
        beyond = std::max(beyond, double(away / wide(h->error + 0.87f * lantern::ulp(std::max({q.x, q.y, q.z})))));
    }
    CHECK(hits > count / 3);
    CHECK(wrong == 0);
    CHECK(t_error <= 0.501);
    CHECK(beyond <= 1);
}

TEST_CASE("nothing leaks between two rectangles that share an edge") {
    dice d{4};
    int leaked = 0, aimed = 0;
    for (int i = 0; i < 4 * count; ++i) {
        // Numbers of few digits, so that the second one's corner is the first one's exactly, and the ray meets the edge.
        const auto coarse = [&] { return glm::vec3(glm::ivec3(d.in_cube(1000))) / 64.0f; };
        const rectangle first{coarse(), coarse(), coarse()}, second{first.corner + first.u, coarse(), first.v};
        const glm::vec3 o = coarse(), edge = second.corner + static_cast<float>(1 + d.below(7)) / 8 * first.v;
        // Seen edge on, one of them hides behind the other, or the ray passes on the outside of both.
        const glm::dvec3 n = glm::cross(glm::dvec3(edge - o), glm::dvec3(first.v));
        if (glm::dot(n, glm::dvec3(first.u)) * glm::dot(n, glm::dvec3(second.u)) <= 0) continue;
        ++aimed;
        const ray r{o, edge - o};
        leaked += !intersect(first, r, interval{}) && !intersect(second, r, interval{});
    }
    CHECK(aimed > count);
    CHECK(leaked == 0);
}

TEST_CASE("an edge is as wide as rounding, and no wider") {
    const rectangle near{}, far{{64, 64, 0}, {1, 0, 0}, {0, 1, 0}};
    for (const rectangle& s : {near, far})
        for (const int side : {0, 1, 2, 3}) {
            const float size = s.corner.x + 2;  // of the numbers that are rounded
            const auto beside = [&](float by) {  // a ray that passes an edge on the outside
                const double x = side == 0 ? -double(by) : side == 1 ? 1 + double(by) : 0.5, y = side == 2 ? -double(by) : side == 3 ? 1 + double(by) : 0.5;
                const lantern::precise::ray r{glm::dvec3(s.corner) + glm::dvec3(x, y, 1), {0, 0, -1}};
                return intersect(s, r, interval{});
            };
            CAPTURE(s.corner.x, side);
            CHECK(beside(0));
            CHECK(beside(size * 0x1p-51f));
            CHECK_FALSE(beside(size * 0x1p-45f));
            CHECK_FALSE(beside(size * 0x1p-30f));
        }
}

TEST_CASE("the bounds contain the corners for certain, and hardly more") {
    dice d{5};
    for (int i = 0; i < count; ++i) {
        rectangle s = random_parallelogram(d, d.magnitude_between(-9, 6));
        if (i % 3 == 0) s.v.y = s.u.y = 0;  // flat
        const lantern::aabb box = bounds(s);
        for (int k = 0; k < 3; ++k) {
            wide lo = 0, hi = 0;
            for (const int a : {0, 1})
                for (const int b : {0, 1}) {
                    const wide x = wide(s.corner[k]) + a * wide(s.u[k]) + b * wide(s.v[k]);
                    lo = a + b == 0 ? x : std::min(lo, x);
                    hi = a + b == 0 ? x : std::max(hi, x);
                }
            REQUIRE((wide(box.min[k]) <= lo && wide(box.max[k]) >= hi));
            const wide slack = wide(4 * lantern::ulp(std::max(std::abs(box.min[k]), std::abs(box.max[k])) + std::abs(s.corner[k])));
            REQUIRE((lo - wide(box.min[k]) <= slack && wide(box.max[k]) - hi <= slack));
        }
    }
}

TEST_CASE("numbers that are none, and a rectangle of no area, are refused and missed") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const ray r{{0.5f, 0.5f, 2}, {0, 0, -1}};
    for (const float bad : {nan, lantern::infinity}) {
        CHECK_FALSE(intersect(rectangle{{bad, 0, 0}}, r, interval{}));
        CHECK_FALSE(intersect(rectangle{{0, 0, 0}, {bad, 0, 0}}, r, interval{}));
        CHECK_THROWS_WITH(validate(rectangle{{bad, 0, 0}}), containing("rectangle: corner"));
        CHECK_THROWS_WITH(validate(rectangle{{0, 0, 0}, {1, bad, 0}}), containing("rectangle: u"));
        CHECK_THROWS_WITH(validate(rectangle{{0, 0, 0}, {1, 0, 0}, {0, 1, bad}}), containing("rectangle: v"));
    }
    const rectangle line{{0, 0, 0}, {1, 2, 3}, {2, 4, 6}};
    CHECK_FALSE(intersect(line, r, interval{}));
    CHECK_THROWS_WITH(validate(line), containing("rectangle: v is (2, 4, 6), but must be not parallel to u = (1, 2, 3)"));
    CHECK_NOTHROW(validate(rectangle{}));
}

TEST_CASE("a ray that leaves a rectangle does not meet it again, and one towards it does, at any scale") {
    dice d{6};
    for (int i = 0; i < count; ++i) {
        const float scale = d.magnitude_between(-6, 6);
        rectangle s = random_parallelogram(d, i % 2 == 0 ? 1 : 1000);
        s = {scale * s.corner, scale * s.u, scale * s.v};
        const glm::vec3 from = scale * d.in_cube(5);
        const auto h = intersect(s, ray{from, glm::vec3(glm::normalize(at(s, 0.1 + 0.8 * d.unit(), 0.1 + 0.8 * d.unit()) - glm::dvec3(from)))}, interval{});
        if (!h) continue;
        const glm::vec3 away(d.on_sphere());
        REQUIRE_FALSE(intersect(s, ray{leave(*h, away), away}, interval{}));
        REQUIRE(intersect(s, ray{leave(*h, h->normal), -h->normal}, interval{}));
    }
}

TEST_CASE("a rectangle far away, and thinner than rounding there, is not met a universe away from itself") {
    const lantern::rectangle s{{-3, 0, -2.18173e24f}, {9.55089e-39f, 0, 4}, {0, 0, 5.5f}};  // found by fuzzing
    CHECK_FALSE(intersect(s, lantern::ray{{5.5f, 5.5f, 5.5f}, {5.5f, -1.125f, -1}}, lantern::interval{}));
}
