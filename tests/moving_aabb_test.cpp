// SPDX-License-Identifier: MIT
#include <lantern/moving_aabb.hpp>

#include <lantern/aabb.hpp>
#include <lantern/any_of.hpp>
#include <lantern/bounding_volume.hpp>
#include <lantern/bvh.hpp>
#include <lantern/closest.hpp>
#include <lantern/moving.hpp>
#include <lantern/object.hpp>
#include <lantern/rotating.hpp>
#include <lantern/sphere.hpp>
#include <lantern/triangle.hpp>
#include <lantern/within.hpp>

#include "accelerator_laws.hpp"
#include "catch.hpp"
#include "oracle.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

using lantern::aabb;
using lantern::bvh;
using lantern::moving;
using lantern::moving_aabb;
using lantern::sphere;
using lantern::timed_ray;

static_assert(lantern::bounding_volume<moving_aabb>);
static_assert(lantern::accelerator<bvh<moving_aabb>, timed_ray>);
static_assert(!lantern::accelerator<bvh<moving_aabb>, lantern::ray>);

TEST_CASE("what moves along a line is in the box between, what turns in its whole box, and wrappers hand on which it is") {
    const moving ball{sphere{{0, 0, 0}, 1}, {8, 0, 0}};
    const auto box = moving_aabb::around(ball);
    CHECK(box.open.max.x == 1);
    CHECK(box.close.min.x == 7);
    CHECK(bounds_at(box, 0.5f).min.x == 3);
    CHECK(bounds(box).max.x == 9);
    const lantern::rotating arm{sphere{{5, 0, 0}, 1}, {0, 0, 0}, {0, 1, 0}, 3};
    CHECK(moving_aabb::around(arm).open.min == bounds(arm).min);
    CHECK(moving_aabb::around(arm).close.max == bounds(arm).max);
    const moving both{arm, {8, 0, 0}};
    CHECK(moving_aabb::around(both).close.min.x >= bounds(arm).min.x + 7.999f);
    CHECK(moving_aabb::around(lantern::any_of<moving<sphere>, sphere>(ball)).close.min.x == 7);
    CHECK(moving_aabb::around(lantern::object{ball, 0}).close.min.x == 7);
    CHECK(moving_aabb::around(lantern::put_within<aabb>(ball)).close.min.x == 7);
    CHECK(lantern::volume_of<moving_aabb>(ball).close.min.x == 7);
    CHECK(empty(moving_aabb{}));
}

TEST_CASE("a ray finds in the moving box what is there at its time: far from the origin, at any scale, on faces and corners") {
    dice d{3};
    int met = 0;
    for (int i = 0; i < 40000; ++i) {
        const float scale = d.magnitude_between(-20, 20);
        const glm::vec3 far = d.below(2) == 0 ? glm::vec3(0) : d.in_cube(1000);
        std::vector<moving<lantern::triangle>> points;  // which are their own boxes
        moving_aabb all;
        for (int k = 0; k < 3; ++k) {
            const glm::vec3 p = scale * (far + d.in_cube());
            points.push_back({{p, p, p}, scale * d.in_cube(d.below(2) == 0 ? 1 : 100)});
            all = enclose(all, moving_aabb::around(points.back()));
        }
        const float time = d.below(4) == 0 ? float(d.below(2)) : d.between(0, 1);
        const auto& target = points[d.below(3)];
        const glm::dvec3 there = glm::dvec3(target.surface.a) + double(time) * glm::dvec3(target.displacement);
        // The ray starts in that very point, up to its own rounding, or runs to it along an axis.
        timed_ray r{{glm::vec3(there), scale * d.in_cube()}, time};
        if (d.below(2) == 0) {
            r.direction = {};
            const int axis = int(d.below(3));
            r.direction[axis] = scale;
            r.origin[axis] -= scale * 2000;
        }
        if (r.origin[0] == there.x && r.origin[1] == there.y && r.origin[2] == there.z) ++met;
        float entry;
        const lantern::volume_ray<moving_aabb> way(r, {-4000, 4000}, all);
        CAPTURE(i, scale, time);
        REQUIRE(way.meets(all, entry));
    }
    CHECK(met > 10);
}

TEST_CASE("a tree of moving boxes finds what brute force finds, whatever moves how") {
    accelerator_laws::finds_what_moves([](const std::vector<accelerator_laws::moving_shape>& things) { return bvh<moving_aabb>(things); });
}

TEST_CASE("where things move far, a tree of moving boxes looks at much less") {
    dice d{4};
    std::vector<moving<sphere>> balls;
    for (int i = 0; i < 2000; ++i) balls.push_back({{d.in_cube(), 0.02f}, {0.6f, 0.1f, 0}});
    const bvh whole(balls);
    const bvh<moving_aabb> between(balls);
    lantern::probe by_whole, by_between;
    for (int i = 0; i < 2000; ++i) {
        const timed_ray r{{d.in_cube(2), d.in_cube()}, d.between(0, 1)};
        const auto a = closest(whole, balls, r, {}, by_whole), b = closest(between, balls, r, {}, by_between);
        REQUIRE(a.has_value() == b.has_value());
        if (a) REQUIRE((a->index == b->index && a->t == b->t));
    }
    INFO("offers: whole boxes " << by_whole.offers << ", moving ones " << by_between.offers);
    CHECK(by_between.offers < by_whole.offers / 4);
    CHECK(by_between.nodes < by_whole.nodes * 2 / 3);
}
