// SPDX-License-Identifier: MIT
#include <lantern/any_of.hpp>

#include <lantern/closest.hpp>
#include <lantern/instance.hpp>
#include <lantern/moving.hpp>
#include <lantern/object.hpp>
#include <lantern/plane.hpp>
#include <lantern/rectangle.hpp>
#include <lantern/sphere.hpp>
#include <lantern/triangle.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <limits>
#include <vector>

using lantern::any_of;
using lantern::interval;
using lantern::moving;
using lantern::plane;
using lantern::ray;
using lantern::sphere;
using lantern::surface;
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

static_assert(surface<any_of<sphere, triangle>> && surface<any_of<sphere, triangle>, timed_ray>);
static_assert(lantern::precise_surface<any_of<sphere, triangle>>);
static_assert(lantern::bounded<any_of<sphere, triangle>> && !lantern::bounded<any_of<sphere, plane>>,
              "bounded only when every alternative is");
static_assert(!surface<any_of<sphere, moving<sphere>>> && surface<any_of<sphere, moving<sphere>>, timed_ray>,
              "one alternative that moves makes it a surface for timed rays only");
static_assert(surface<any_of<sphere, mine::wall>> && !lantern::precise_surface<any_of<sphere, mine::wall>>);
static_assert(surface<any_of<moving<sphere>, mine::wall>, timed_ray>);
static_assert(surface<lantern::instance<any_of<sphere, triangle>>>);
static_assert(surface<moving<any_of<sphere, triangle>>, timed_ray>);
static_assert(!std::is_constructible_v<any_of<sphere, triangle>, plane>);

TEST_CASE("whatever it holds is hit as if it stood alone") {
    dice d{1};
    for (int i = 0; i < 2000; ++i) {
        const sphere s{d.in_cube(), 0.5f};
        const triangle t{d.in_cube(), d.in_cube(), d.in_cube()};
        const ray r{d.in_cube(3), d.in_cube()};
        using shape = any_of<sphere, triangle>;
        const auto same = [&](const auto& bare) {
            const auto expected = intersect(bare, r, interval{}), got = intersect(shape{bare}, r, interval{});
            REQUIRE(got.has_value() == expected.has_value());
            if (!got) return;
            // Equal, unless the compiler contracts the two calls differently and a last bit of the doubles shows.
            REQUIRE(error_in_ulp(got->t, expected->t) <= 1);
            REQUIRE(glm::length(got->point - expected->point) <= 3e-7f);
            REQUIRE(glm::length(got->normal - expected->normal) <= 2e-7f);
        };
        same(s);
        same(t);
        REQUIRE(bounds(shape{s}).min == bounds(s).min);
        REQUIRE(bounds(shape{t}).max == bounds(t).max);
    }
}

TEST_CASE("a scene of several kinds is a vector") {
    const std::vector<any_of<sphere, plane, mine::wall>> things{plane{{0, -1, 0}}, sphere{{0, 0, -5}, 1}, mine::wall{-10}};
    const auto hit_by = [&](const ray& r) { return closest(lantern::every{3}, things, r); };
    CHECK(hit_by({{0, 0, 0}, {0, 0, -1}})->index == 1);
    CHECK(hit_by({{0, 0, 0}, {0, -1, 0}})->index == 0);
    CHECK(hit_by({{3, 0, 0}, {0, 0, -1}})->index == 2);
    CHECK_FALSE(hit_by({{0, 0, 0}, {0, 1, 1}}));
}

TEST_CASE("a timed ray meets what stands still, too") {
    const std::vector<any_of<sphere, moving<sphere>>> things{sphere{{0, 0, -5}, 1}, moving{sphere{{0, 5, -5}, 1}, {0, -5, 2}}};
    CHECK(closest(lantern::every{2}, things, timed_ray{{{0, 0, 0}, {0, 0, -1}}, 0})->index == 0);
    CHECK(closest(lantern::every{2}, things, timed_ray{{{0, 0, 0}, {0, 0, -1}}, 1})->index == 1);
}

TEST_CASE("what is wrong with the alternative is found") {
    using shape = any_of<sphere, mine::wall>;
    CHECK_THROWS_WITH(validate(shape{sphere{{0, 0, 0}, std::numeric_limits<float>::quiet_NaN()}}), containing("sphere: radius"));
    CHECK_NOTHROW(validate(shape{mine::wall{}}));
}
