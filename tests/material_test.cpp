// SPDX-License-Identifier: MIT
#include <lantern/material.hpp>

#include "catch.hpp"

#include <glm/vec3.hpp>

#include <limits>

using lantern::bounce;
using lantern::bounces;
using lantern::hit;

namespace mine {

struct velvet {};
glm::vec3 evaluate(const velvet&, glm::vec3, const hit&, glm::vec3) { return glm::vec3(0.1f); }

struct lamp {};
glm::vec3 emitted(const lamp&, glm::vec3, const hit&) { return glm::vec3(1); }

}  // namespace mine

TEST_CASE("a type of another namespace is a material by any one of the functions") {
    STATIC_REQUIRE(lantern::material<mine::velvet>);
    STATIC_REQUIRE(lantern::reflects_light<mine::velvet>);
    STATIC_REQUIRE_FALSE(lantern::specular<mine::velvet>);
    STATIC_REQUIRE_FALSE(lantern::emits<mine::velvet>);
    STATIC_REQUIRE(lantern::material<mine::lamp>);
    STATIC_REQUIRE_FALSE(lantern::reflects_light<mine::lamp>);
    STATIC_REQUIRE_FALSE(lantern::material<int>);
}

TEST_CASE("none, one or two rays go on") {
    CHECK(bounces{}.empty());
    const bounces one = bounce{{0, 0, 1}, glm::vec3(0.5f)};
    CHECK(one.size() == 1);
    const bounces two{bounce{{0, 0, 1}, glm::vec3(0.25f)}, bounce{{0, 1, 0}, glm::vec3(0.75f)}};
    CHECK(two.size() == 2);
    CHECK(two[1].direction == glm::vec3(0, 1, 0));
    glm::vec3 sum{0};
    for (const bounce& b : 0.5f * two) sum += b.weight;
    CHECK(sum == glm::vec3(0.5f));
}

TEST_CASE("the facing normal is on the side that the ray came from") {
    const glm::vec3 up(0, 0, 1);
    CHECK(lantern::facing(up, {0, 0, -1}) == up);
    CHECK(lantern::facing(up, {0, 0, 1}) == -up);
    CHECK(lantern::facing(up, {1, 0, 0}) == up);
}

TEST_CASE("an albedo is between 0 and 1") {
    CHECK_NOTHROW(lantern::require_albedo({0, 0.5f, 1}, "x"));
    CHECK_THROWS_WITH(lantern::require_albedo({0, 0, 1.01f}, "diffuse: color"), "diffuse: color is (0, 0, 1.01), but must be between 0 and 1");
    CHECK_THROWS(lantern::require_albedo({-0.1f, 0, 0}, "x"));
    CHECK_THROWS(lantern::require_albedo({0, std::numeric_limits<float>::quiet_NaN(), 0}, "x"));
}
