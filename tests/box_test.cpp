// SPDX-License-Identifier: MIT
#include <lantern/box.hpp>

#include <lantern/surface.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <algorithm>
#include <limits>
#include <optional>

using lantern::box;
using lantern::interval;
using lantern::ray;

namespace {

constexpr int count = 10000;

/// The stretch of the ray within the box, with 113 bits.
bool true_stretch(const box& b, const ray& r, wide& near, wide& far) {
    near = wide(-1e300), far = wide(1e300);
    for (int i = 0; i < 3; ++i) {
        const wide o = r.origin[i], d = r.direction[i], lo = wide(b.min[i]) - o, hi = wide(b.max[i]) - o;
        if (r.direction[i] == 0) {
            if (lo > 0 || hi < 0) return false;
            continue;
        }
        near = std::max(near, std::min(lo / d, hi / d));
        far = std::min(far, std::max(lo / d, hi / d));
    }
    return near <= far;
}

float coarse(dice& d) { return static_cast<float>(d.below(5)) - 2.0f; }

box random_box(dice& d) {
    const glm::vec3 a = d.in_cube(3), b = d.in_cube(3);
    return {glm::min(a, b), glm::max(a, b)};
}

}  // namespace

TEST_CASE("a box is hit where it is entered, from inside where it is left, with the normal of that face") {
    const box b{{-1, -2, -3}, {1, 2, 3}};
    for (int k = 0; k < 3; ++k) {
        for (const float side : {-1.0f, 1.0f}) {
            glm::vec3 direction(0.1f, 0.2f, 0.3f), normal(0);
            direction[k] = -4 * side;
            normal[k] = side;
            const auto entered = intersect(b, ray{-2.0f * direction, direction}, interval{});
            REQUIRE(entered);
            CHECK(entered->normal == normal);
            CHECK(entered->point[k] == side * b.max[k]);
            const auto left = intersect(b, ray{{0, 0, 0}, -direction}, interval{});
            REQUIRE(left);
            CHECK(left->normal == normal);
            CHECK(left->t == Approx(b.max[k] / 4));
        }
    }
    CHECK_FALSE(intersect(b, ray{{0, 0, 5}, {0, 0, 1}}, interval{}));
    CHECK_FALSE(intersect(b, ray{{0, 0, 5}, {0, 0, -1}}, interval{0, 1.9f}));
    CHECK(intersect(b, ray{{0, 0, 5}, {0, 0, -1}}, interval{2, 9})->t == 8);
    CHECK_FALSE(intersect(b, ray{{0, 0, 5}, {0, 0, -1}}, interval{2, 7}));
}

TEST_CASE("no ray that meets a box is lost, none that misses it is found, and t is right to half an ulp") {
    dice d{GENERATE(1u, 2u)};
    int wrong = 0, hits = 0, off = 0;
    double t_error = 0;
    const auto judge = [&](const box& b, const ray& r) {
        if (r.direction == glm::vec3(0)) return;
        wide near = 0, far = 0;
        const bool meets = true_stretch(b, r, near, far);
        if (!meets && magnitude(near - far) < wide(1e-14) * magnitude(near)) return;  // passes an edge nearer than double sees
        const wide t = near > 0 ? near : far;
        const bool met = meets && t > 0;
        const auto h = intersect(b, r, interval{});
        wrong += h.has_value() != met;
        if (!h || !met) return;
        ++hits;
        t_error = std::max(t_error, error_in_ulp(h->t, t));
        bool on_face = false, within = true;
        for (int k = 0; k < 3; ++k) {
            on_face = on_face || (h->normal[k] == 1 && h->point[k] == b.max[k]) || (h->normal[k] == -1 && h->point[k] == b.min[k]);
            within = within && b.min[k] <= h->point[k] && h->point[k] <= b.max[k];
        }
        off += !(on_face && within && h->error == 0);
    };
    SECTION("random") {
        for (int i = 0; i < count; ++i) judge(random_box(d), {d.in_cube(5), d.in_cube()});
    }
    SECTION("aimed at faces, edges and corners") {
        for (int i = 0; i < count; ++i) {
            const box b = random_box(d);
            glm::vec3 p;
            for (int k = 0; k < 3; ++k) {
                const std::uint32_t choice = d.below(3);
                p[k] = choice == 0 ? b.min[k] : choice == 1 ? b.max[k] : d.between(b.min[k], b.max[k]);
            }
            const glm::vec3 o = d.in_cube(5);
            judge(b, {o, p - o});
        }
    }
    SECTION("coincidences: flat boxes, origins on faces, directions along the axes, both zeros") {
        for (int i = 0; i < 4 * count; ++i) {
            const glm::vec3 a(coarse(d), coarse(d), coarse(d)), c(coarse(d), coarse(d), coarse(d));
            const auto direction = [&] {
                const float x = coarse(d);
                return x == 0 && d.below(2) == 0 ? -0.0f : x;
            };
            const glm::vec3 o(coarse(d), coarse(d), coarse(d));
            judge({glm::min(a, c), glm::max(a, c)}, {o, {direction(), direction(), direction()}});
        }
    }
    SECTION("at any scale") {
        for (int i = 0; i < count; ++i) {
            const float scale = d.magnitude_between(-30, 30);
            const box b = random_box(d);
            judge({scale * b.min, scale * b.max}, {scale * d.in_cube(4), d.magnitude_between(-7, 7) * d.in_cube()});
        }
    }
    CHECK(hits > count / 40);
    CHECK(wrong == 0);
    CHECK(off == 0);
    CHECK(t_error <= 0.501);
}

TEST_CASE("numbers that are none, and boxes turned inside out, are refused and missed") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const ray r{{0, 0, 5}, {0, 0, -1}};
    CHECK_FALSE(intersect(box{{-1, nan, -1}, {1, 1, 1}}, r, interval{}));
    CHECK_FALSE(intersect(box{{-1, -1, -1}, {1, nan, 1}}, r, interval{}));
    CHECK_FALSE(intersect(box{{1, -1, -1}, {-1, 1, 1}}, r, interval{}));
    CHECK_FALSE(intersect(box{}, ray{{0, nan, 5}, {0, 0, -1}}, interval{}));
    CHECK_FALSE(intersect(box{}, ray{{0, 0, 5}, {nan, 0, -1}}, interval{}));
    CHECK_FALSE(intersect(box{}, ray{{0, 0, 0}, {0, 0, 0}}, interval{}));
    CHECK_FALSE(intersect(box{glm::vec3(-lantern::infinity), glm::vec3(lantern::infinity)}, r, interval{}));
    CHECK_THROWS_WITH(validate(box{{-1, nan, -1}, {1, 1, 1}}), containing("box: min"));
    CHECK_THROWS_WITH(validate(box{{-1, -1, -1}, {1, lantern::infinity, 1}}), containing("box: max"));
    CHECK_THROWS_WITH(validate(box{{1, -1, -1}, {-1, 1, 1}}), containing("box: min is (1, -1, -1), but must be nowhere greater than max = (-1, 1, 1)"));
    CHECK_NOTHROW(validate(box{{0, 0, 0}, {1, 0, 1}}));
}

TEST_CASE("a ray that leaves a box neither meets it again nor loses touch, at any scale") {
    dice d{6};
    for (int i = 0; i < count; ++i) {
        const float scale = d.magnitude_between(-6, 6);
        box b = random_box(d);
        b = {scale * b.min, scale * b.max};
        const glm::vec3 size = b.max - b.min;
        if (std::min({size.x, size.y, size.z}) < 0.01f * scale) continue;
        const glm::vec3 from = scale * 6.0f * glm::vec3(d.on_sphere());
        const glm::vec3 at = b.min + size * glm::vec3(d.between(0.1, 0.9), d.between(0.1, 0.9), d.between(0.1, 0.9));
        const auto h = intersect(b, ray{from, at - from}, interval{});
        REQUIRE(h);
        glm::vec3 away(d.on_sphere());
        if (glm::dot(away, h->normal) < 0) away = -away;
        REQUIRE_FALSE(intersect(b, ray{leave(*h, away), away}, interval{}));
        REQUIRE(intersect(b, ray{leave(*h, -away), -away}, interval{}));
    }
}

TEST_CASE("the bounds of a box are the box") {
    const box b{{-1, -2, -3}, {1, 2, 3}};
    CHECK(bounds(b).min == b.min);
    CHECK(bounds(b).max == b.max);
}
