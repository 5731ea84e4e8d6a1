// SPDX-License-Identifier: MIT
#include <lantern/sky.hpp>

#include "catch.hpp"

#include <glm/vec3.hpp>

#include <type_traits>

TEST_CASE("the sky goes from the horizon to the zenith, and stays what it is below") {
    const lantern::sky s{.horizon = {1, 0, 0}, .zenith = {0, 0, 1}};
    CHECK(radiance(s, {0, 1, 0}) == s.zenith);
    CHECK(radiance(s, {1, 0, 0}) == s.horizon);
    CHECK(radiance(s, {0, -1, 0}) == s.horizon);
    CHECK(radiance(s, {0, 0.5f, 0}) == glm::vec3(0.5f, 0, 0.5f));
    const lantern::sky evening{.horizon = {1, 0.6f, 0.3f}, .zenith = {0.1f, 0.2f, 0.5f}};
    CHECK(radiance(evening, {0, 1, 0}) == evening.zenith);  // at both ends exactly
    CHECK(radiance(evening, {1, 0, 0}) == evening.horizon);
}

TEST_CASE("darkness is black and takes no room") {
    CHECK(radiance(lantern::darkness{}, {0, 1, 0}) == glm::vec3(0));
    STATIC_REQUIRE(std::is_empty_v<lantern::darkness>);
    STATIC_REQUIRE(lantern::background<lantern::darkness>);
    STATIC_REQUIRE(lantern::background<lantern::sky>);
}

TEST_CASE("a sky that is negative or not finite is refused") {
    CHECK_THROWS_WITH(validate(lantern::sky{.horizon = {-1, 0, 0}}), containing("sky: horizon"));
    CHECK_NOTHROW(validate(lantern::sky{}));
}
