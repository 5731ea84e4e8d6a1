// SPDX-License-Identifier: MIT
#include <lantern/emissive.hpp>

#include "catch.hpp"

#include <glm/vec3.hpp>

using lantern::emissive;

TEST_CASE("an emissive surface shines to the front; its back is black unless it is told to shine") {
    const lantern::hit up{.normal = {0, 0, 1}};
    const glm::vec3 e(1, 2, 3), from_front(0, 0, -1), from_behind(0, 0, 1);
    CHECK(emitted(emissive{e}, from_front, up) == e);
    CHECK(emitted(emissive{e}, from_behind, up) == glm::vec3(0));
    CHECK(emitted(emissive{.radiance = e, .back = 2.0f * e}, from_behind, up) == 2.0f * e);
}

TEST_CASE("an emissive surface reflects nothing") {
    STATIC_REQUIRE(lantern::emits<emissive>);
    STATIC_REQUIRE_FALSE(lantern::reflects_light<emissive>);
    STATIC_REQUIRE_FALSE(lantern::specular<emissive>);
    STATIC_REQUIRE_FALSE(lantern::reflects_ambient<emissive>);
}

TEST_CASE("negative radiance is refused, radiance above 1 is not") {
    CHECK_THROWS_WITH(validate(emissive{glm::vec3(-1)}), containing("emissive: radiance"));
    CHECK_THROWS_WITH(validate(emissive{.back = glm::vec3(-1)}), containing("emissive: back"));
    CHECK_NOTHROW(validate(emissive{glm::vec3(1000)}));
}
