// SPDX-License-Identifier: MIT
#include <lantern/moving.hpp>

#include <lantern/instance.hpp>
#include <lantern/plane.hpp>
#include <lantern/sphere.hpp>
#include <lantern/triangle.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <algorithm>
#include <limits>

using lantern::interval;
using lantern::moving;
using lantern::ray;
using lantern::sphere;
using lantern::timed_ray;
using lantern::triangle;

namespace mine {

/// A surface of a user's own, which knows float only.
struct wall {
    float z = 0;
};

std::optional<lantern::hit> intersect(const wall& w, const ray& r, interval range) {
    const float t = (w.z - r.origin.z) / r.direction.z;
    if (!contains(range, t)) return std::nullopt;
    return lantern::hit{t, at(r, t), {0, 0, 1}, 0};
}

}  // namespace mine

static_assert(!lantern::surface<moving<sphere>> && lantern::surface<moving<sphere>, timed_ray>,
              "what moves is a surface for timed rays only");
static_assert(lantern::bounded<moving<sphere>> && !lantern::bounded<moving<lantern::plane>>);
static_assert(lantern::surface<moving<moving<sphere>>, timed_ray>);
static_assert(lantern::surface<lantern::instance<moving<sphere>>, timed_ray> && !lantern::surface<lantern::instance<moving<sphere>>>);
static_assert(lantern::surface<moving<mine::wall>, timed_ray> && !lantern::surface<moving<mine::wall>>);

namespace {
constexpr int count = 4000;
}

TEST_CASE("a moved sphere is hit where the sphere would be") {
    dice d{1};
    int hits = 0;
    for (int i = 0; i < count; ++i) {
        // Coarse numbers, so that the sphere moved by hand is not rounded.
        const auto coarse = [&] { return glm::vec3(glm::ivec3(d.in_cube(1000))) / 256.0f; };
        const float time = static_cast<float>(d.below(17)) / 16;
        const moving m{sphere{coarse(), 1.5f}, coarse()};
        const sphere there{m.surface.center + time * m.displacement, 1.5f};
        const glm::vec3 o = coarse();
        const timed_ray r{{o, there.center + 1.2f * d.in_cube() - o}, time};
        const auto h = intersect(m, r, interval{}), expected = intersect(there, ray{r.origin, r.direction}, interval{});
        REQUIRE(h.has_value() == expected.has_value());
        if (!h) continue;
        ++hits;
        REQUIRE(error_in_ulp(h->t, expected->t) <= 1);
        REQUIRE(glm::length(h->point - expected->point) <= 2e-6f);
        REQUIRE(glm::length(h->normal - expected->normal) <= 2e-7f);
    }
    CHECK(hits > count / 2);
}

TEST_CASE("at times 0 and 1 it is where the shutter opens and closes") {
    const moving m{sphere{{0, 0, -5}, 1}, {3, 0, 0}};
    const auto shot = [&](float x, float time) { return intersect(m, timed_ray{{{x, 0, 0}, {0, 0, -1}}, time}, interval{}); };
    CHECK(shot(0, 0)->t == 4);
    CHECK_FALSE(shot(3, 0));
    CHECK(shot(3, 1)->t == 4);
    CHECK_FALSE(shot(0, 1));
    CHECK(shot(1.5f, 0.5f)->point == glm::vec3(1.5f, 0, -4));
    CHECK(shot(1.5f, 0.5f)->normal == glm::vec3(0, 0, 1));
}

TEST_CASE("movements add up") {
    const moving twice{moving{sphere{{0, 0, -5}, 1}, {1, 0, 0}}, {0, 2, 0}};
    CHECK(intersect(twice, timed_ray{{{1, 2, 0}, {0, 0, -1}}, 1}, interval{})->t == 4);
    CHECK(intersect(twice, timed_ray{{{0.5f, 1, 0}, {0, 0, -1}}, 0.5f}, interval{})->t == 4);
    CHECK(bounds(twice).max.x >= 2);
    CHECK(bounds(twice).max.y >= 3);
}

TEST_CASE("a surface of the user's own moves as well") {
    const moving m{mine::wall{-4}, {0, 0, 2}};
    CHECK(intersect(m, timed_ray{{{0, 0, 0}, {0, 0, -1}}, 0}, interval{})->t == 4);
    CHECK(intersect(m, timed_ray{{{0, 0, 0}, {0, 0, -1}}, 1}, interval{})->t == 2);
    CHECK(intersect(m, timed_ray{{{0, 0, 0}, {0, 0, -1}}, 1}, interval{})->point.z == -2);
}

TEST_CASE("the bounds contain the surface during the whole exposure") {
    dice d{2};
    for (int i = 0; i < count; ++i) {
        const moving m{sphere{d.in_cube(3), d.magnitude_between(-3, 0)}, d.magnitude_between(-6, 3) * d.in_cube()};
        const lantern::aabb box = bounds(m);
        for (const float time : {0.0f, d.between(0, 1), 1.0f}) {
            for (int k = 0; k < 3; ++k) {
                const wide center = wide(m.surface.center[k]) + wide(time) * wide(m.displacement[k]);
                REQUIRE((wide(box.min[k]) <= center - wide(m.surface.radius) && wide(box.max[k]) >= center + wide(m.surface.radius)));
            }
        }
    }
}

TEST_CASE("a ray that leaves a moved surface does not meet it again, at any scale and time") {
    dice d{3};
    int left = 0;
    for (int i = 0; i < count; ++i) {
        const float scale = d.magnitude_between(-6, 6), time = d.between(0, 1);
        const moving m{sphere{scale * d.in_cube(3), scale * d.between(0.1, 1)}, scale * d.in_cube(10)};
        const glm::vec3 from = scale * d.in_cube(20), to = m.surface.center + time * m.displacement;
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

TEST_CASE("a displacement that is none is refused and missed") {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), lantern::infinity}) {
        const moving m{sphere{}, {bad, 0, 0}};
        CHECK_FALSE(intersect(m, timed_ray{{{0, 0, 5}, {0, 0, -1}}, 0.5f}, interval{}));
        CHECK_THROWS_WITH(validate(m), containing("moving: displacement"));
    }
    CHECK_THROWS_WITH(validate(moving{sphere{{0, 0, 0}, lantern::infinity}, {0, 0, 0}}), containing("sphere: radius"));
}
