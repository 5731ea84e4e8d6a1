// SPDX-License-Identifier: MIT
#include <lantern/hull.hpp>

#include <lantern/any_of.hpp>
#include <lantern/box.hpp>
#include <lantern/instance.hpp>
#include <lantern/moving.hpp>
#include <lantern/object.hpp>
#include <lantern/rectangle.hpp>
#include <lantern/sphere.hpp>
#include <lantern/surface.hpp>
#include <lantern/triangle.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

using lantern::aabb;
using lantern::hull;
using lantern::hull_of;
using lantern::sphere;
using lantern::triangle;

TEST_CASE("a sphere is its center and its radius, a triangle its corners, a box its eight") {
    const hull ball = hull_of(sphere{{1, 2, 3}, -4});
    CHECK(ball.points == std::vector{glm::dvec3(1, 2, 3)});
    CHECK(ball.radius == 4);
    CHECK(hull_of(triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).points.size() == 3);
    const hull box = hull_of(lantern::box{{-1, -2, -3}, {1, 2, 3}});
    CHECK(box.points.size() == 8);
    CHECK(std::find(box.points.begin(), box.points.end(), glm::dvec3(1, -2, 3)) != box.points.end());
    CHECK(hull_of(aabb{}).points.empty());
}

TEST_CASE("what wraps a surface hands its hull on") {
    using shape = lantern::any_of<sphere, triangle>;
    const lantern::object<shape, int> thing{sphere{{1, 0, 0}, 2}, 0};
    CHECK(hull_of(thing).points == std::vector{glm::dvec3(1, 0, 0)});
    const hull path = hull_of(lantern::moving{thing, {0, 5, 0}});
    CHECK(path.points == std::vector{glm::dvec3(1, 0, 0), glm::dvec3(1, 5, 0)});
    CHECK(path.radius >= 2);
    CHECK(path.radius < 2.000001);
}

TEST_CASE("the box around a hull is the surface's own, to two ulp") {
    dice d{.state = 1};
    const auto check = [](const auto& surface) {
        const aabb own = bounds(surface), box = enclose(aabb{}, hull_of(surface));
        const glm::vec3 size = glm::max(glm::abs(own.min), glm::abs(own.max));
        for (int k = 0; k < 3; ++k) {
            REQUIRE(std::abs(box.min[k] - own.min[k]) <= 2 * lantern::ulp(size[k]));
            REQUIRE(std::abs(box.max[k] - own.max[k]) <= 2 * lantern::ulp(size[k]));
        }
    };
    for (int i = 0; i < 2000; ++i) {
        const sphere s{d.in_cube(10), d.magnitude_between(-4, 2)};
        const triangle t{d.in_cube(10), d.in_cube(), d.in_cube()};
        check(s);
        check(t);
        check(lantern::moving{s, d.in_cube()});
        check(lantern::box{d.in_cube(), glm::vec3(1) + d.in_cube(0)});
    }
}

TEST_CASE("a transformed triangle stays one: its hull is far smaller than its box's") {
    dice d{.state = 2};
    for (int i = 0; i < 500; ++i) {
        const triangle t{d.in_cube(), d.in_cube(), d.in_cube()};
        const glm::mat4 m(glm::vec4(d.in_cube(), 0), glm::vec4(d.in_cube(), 0), glm::vec4(d.in_cube(), 0), glm::vec4(d.in_cube(5), 1));
        if (std::abs(glm::determinant(glm::mat3(m))) < 1e-3f) continue;
        const lantern::instance placed(t, m);
        const hull h = hull_of(placed);
        REQUIRE(h.points.size() == 3);
        const aabb box = enclose(aabb{}, h), loose = bounds(placed);
        REQUIRE(surface_area(box) <= surface_area(loose) * (1 + 1e-6));
        const lantern::ray r{glm::vec3(20, 0, 0), glm::vec3(h.points[0] + h.points[1] + h.points[2]) / 3.0f - glm::vec3(20, 0, 0)};
        const auto hit = intersect(placed, r, lantern::interval{});
        if (hit) REQUIRE(contains(grown(box, glm::vec3(1e-5f)), hit->point));
    }
}

TEST_CASE("many boxes are enclosed at once") {
    const std::vector<aabb> boxes{{{0, 0, 0}, {1, 1, 1}}, {}, {{-1, 2, 0}, {0, 3, 0}}};
    CHECK(enclose(std::span<const aabb>(boxes)).min == glm::vec3(-1, 0, 0));
    CHECK(enclose(std::span<const aabb>(boxes)).max == glm::vec3(1, 3, 1));
    CHECK(empty(enclose(std::span<const aabb>())));
}
