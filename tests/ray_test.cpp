// SPDX-License-Identifier: MIT
#include <lantern/ray.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <glm/vec3.hpp>

#include <cmath>
#include <concepts>

using lantern::ray;
using lantern::timed_ray;

TEST_CASE("t counts in units of the direction's length") {
    const ray r{{1, 2, 3}, {0, 0, -2}};
    CHECK(at(r, 0) == glm::vec3(1, 2, 3));
    CHECK(at(r, 1.5f) == glm::vec3(1, 2, 0));
}

TEST_CASE("a ray that goes on keeps its time, and a ray without time gets none") {
    const timed_ray r{{{0, 0, 0}, {0, 0, 1}}, 0.25f};
    const auto next = continued(r, {1, 0, 0}, {0, 1, 0});
    STATIC_REQUIRE(std::same_as<decltype(next), const timed_ray>);
    CHECK(next.time == 0.25f);
    CHECK(next.origin == glm::vec3(1, 0, 0));
    CHECK(next.direction == glm::vec3(0, 1, 0));
    STATIC_REQUIRE(std::same_as<decltype(continued(ray{}, {}, {})), ray>);
}

TEST_CASE("a scene without a shutter does not store the time") {
    STATIC_REQUIRE(sizeof(ray) == 24);
    STATIC_REQUIRE(sizeof(timed_ray) == 28);
}

TEST_CASE("a unit vector has length 1 to half an ulp a component, however long or short it was") {
    dice d{.state = 11};
    for (int i = 0; i < 20000; ++i) {
        const glm::vec3 v = d.magnitude_between(-37, 37) * glm::vec3(d.on_sphere());
        const wide3 w = widened(v);
        const wide3 truth = (1 / length(w)) * w;
        REQUIRE(largest_difference(lantern::unit(v), truth) <= 0x1.01p-25);
    }
    CHECK(std::isnan(lantern::unit({0, 0, 0}).x));
}
