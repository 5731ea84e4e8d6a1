// SPDX-License-Identifier: MIT
#include <lantern/within.hpp>

#include <lantern/bounding_sphere.hpp>
#include <lantern/closest.hpp>
#include <lantern/instance.hpp>
#include <lantern/moving.hpp>
#include <lantern/obb.hpp>
#include <lantern/plane.hpp>
#include <lantern/sphere.hpp>
#include <lantern/triangle.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <glm/mat4x4.hpp>

#include <cmath>
#include <optional>
#include <vector>

using lantern::aabb;
using lantern::bounding_sphere;
using lantern::interval;
using lantern::obb;
using lantern::put_within;
using lantern::ray;
using lantern::sphere;
using lantern::surface;
using lantern::timed_ray;
using lantern::triangle;
using lantern::within;

namespace mine {

/// A surface of a user's own that knows float only, and counts how often it is asked.
struct wall {
    int* asked;
};

std::optional<lantern::hit> intersect(const wall& w, const ray& r, interval range) {
    ++*w.asked;
    const float t = -r.origin.z / r.direction.z;
    const glm::vec3 p = at(r, t);
    if (!contains(range, t) || std::abs(p.x) > 1 || std::abs(p.y) > 1) return std::nullopt;
    return lantern::hit{t, p, {0, 0, 1}, 0};
}

aabb bounds(const wall&) { return {{-1, -1, 0}, {1, 1, 0}}; }

}  // namespace mine

static_assert(surface<within<obb, triangle>> && lantern::precise_surface<within<obb, triangle>>);
static_assert(surface<within<aabb, triangle>, timed_ray> && lantern::bounded<within<aabb, triangle>>);
static_assert(!surface<within<aabb, lantern::moving<sphere>>> && surface<within<aabb, lantern::moving<sphere>>, timed_ray>);
static_assert(surface<within<bounding_sphere, mine::wall>> && !lantern::precise_surface<within<obb, mine::wall>>);
static_assert(surface<lantern::instance<within<obb, triangle>>>);
static_assert(surface<within<aabb, lantern::plane>> && !lantern::bounded<within<aabb, lantern::plane>>);

namespace {

template <class Volume>
void check_transparent() {
    dice d{.state = 1};
    const auto same = [](const auto& bare, const auto& r) {
        const auto inside = put_within<Volume>(bare);
        const auto expected = intersect(bare, r, interval{}), got = intersect(inside, r, interval{});
        REQUIRE(got.has_value() == expected.has_value());
        REQUIRE(bounds(inside).min == bounds(bare).min);
        if (!got) return 0;
        REQUIRE(got->t == expected->t);
        REQUIRE(got->point == expected->point);
        REQUIRE(got->normal == expected->normal);
        REQUIRE(got->error == expected->error);
        return 1;
    };
    int hits = 0;
    for (int i = 0; i < 3000; ++i) {
        const sphere s{d.in_cube(), d.between(0, 1)};
        const triangle t{d.in_cube(), d.in_cube(), d.in_cube()};
        const glm::vec3 from = d.in_cube(3), to = d.in_cube() - from;
        hits += same(s, ray{from, to}) + same(t, ray{from, to});
        hits += same(lantern::moving{t, d.in_cube()}, timed_ray{{from, to}, d.between(0, 1)});
        const glm::mat4 placed(glm::vec4(2, 0, 0, 0), glm::vec4(0, 0, 1, 0), glm::vec4(1, -1, 0, 0), glm::vec4(d.in_cube(), 1));
        hits += same(lantern::instance(put_within<Volume>(t), placed), ray{from, to});
    }
    CHECK(hits > 500);
}

}  // namespace

TEST_CASE("a surface within a volume is hit as if it stood alone") {
    check_transparent<aabb>();
    check_transparent<bounding_sphere>();
    check_transparent<obb>();
}

TEST_CASE("a ray that passes the volume by never reaches the surface") {
    int asked = 0;
    const auto thing = put_within<bounding_sphere>(mine::wall{&asked});
    CHECK_FALSE(intersect(thing, ray{{0, 5, 3}, {0, 0, -1}}, interval{}));
    CHECK_FALSE(intersect(thing, ray{{0, 0, 3}, {0, 0, 1}}, interval{}));
    CHECK_FALSE(intersect(thing, ray{{0, 0, 3}, {0, 0, -1}}, interval{0, 1}));
    CHECK(asked == 0);
    CHECK(intersect(thing, ray{{0, 0, 3}, {0, 0, -1}}, interval{})->t == 3);
    CHECK(asked == 1);
}

TEST_CASE("a volume of one's own choice may be wrong, and then it cuts; an empty one is refused") {
    const within cut{aabb{{-1, -1, -1}, {0, 1, 1}}, sphere{}};
    CHECK(intersect(cut, ray{{-0.5f, 0, 3}, {0, 0, -1}}, interval{}));
    CHECK_FALSE(intersect(cut, ray{{0.5f, 0, 3}, {0, 0, -1}}, interval{}));
    CHECK_THROWS_WITH(validate(within{aabb{}, sphere{}}), containing("volume"));
    CHECK_THROWS_WITH(validate(within{aabb{{0, 0, 0}, {1, 1, 1}}, sphere{{0, 0, 0}, lantern::infinity}}), containing("radius"));
    CHECK_NOTHROW(validate(put_within<obb>(sphere{})));
}

TEST_CASE("a scene of bounded surfaces is a scene") {
    std::vector<within<obb, triangle>> things;
    dice d{.state = 2};
    for (int i = 0; i < 50; ++i) things.push_back(put_within<obb>(triangle{d.in_cube(), d.in_cube(), d.in_cube()}));
    int hits = 0;
    for (int i = 0; i < 500; ++i) hits += closest(lantern::every{50}, things, ray{d.in_cube(3), d.in_cube()}).has_value();
    CHECK(hits > 10);
}
