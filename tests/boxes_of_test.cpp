// SPDX-License-Identifier: MIT
#include <lantern/boxes_of.hpp>

#include <lantern/sphere.hpp>

#include "catch.hpp"

#include <cstdint>
#include <limits>
#include <vector>

using lantern::aabb;
using lantern::sphere;

TEST_CASE("each surface's box, in their order") {
    const std::vector<sphere> balls{{{0, 0, 0}, 1}, {{5, 0, 0}, 2}};
    const auto boxes = lantern::boxes_of(balls);
    REQUIRE(boxes.size() == 2);
    CHECK(boxes[0].max == glm::vec3(1));
    CHECK(boxes[1].min == glm::vec3(3, -2, -2));
    CHECK(lantern::boxes_of(std::vector<sphere>{}).empty());
}

TEST_CASE("what is empty, infinite or NaN has no place; what is flat has") {
    constexpr float bad = std::numeric_limits<float>::quiet_NaN(), inf = lantern::infinity;
    const std::vector<aabb> boxes{{}, {{0, 0, 0}, {0, 0, 0}}, {{-inf, 0, 0}, {1, 1, 1}}, {{0, bad, 0}, {1, 1, 1}}, {{0, 0, 0}, {1, 1, 1}}};
    CHECK(lantern::placeable(boxes) == std::vector<std::uint32_t>{1, 4});
}

TEST_CASE("the reach is the largest coordinate, whatever its sign") {
    CHECK(lantern::reach_of({{-7, 0, 0}, {1, 2, 3}}) == 7);
    CHECK(lantern::reach_of({{1, 1, 1}, {1, 1, 8}}) == 8);
}
