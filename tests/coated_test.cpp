// SPDX-License-Identifier: MIT
#include <lantern/coated.hpp>

#include <lantern/diffuse.hpp>
#include <lantern/glass.hpp>
#include <lantern/glossy.hpp>
#include <lantern/mirror.hpp>

#include "catch.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

using lantern::coated;
using lantern::diffuse;
using lantern::glossy;
using lantern::mirror;

namespace {
const lantern::hit up{.normal = {0, 0, 1}};
const glm::vec3 down(0, 0, -1);
}  // namespace

TEST_CASE("a coated body needs what its coat needs") {
    STATIC_REQUIRE(lantern::specular<coated<diffuse, mirror>>);
    STATIC_REQUIRE_FALSE(lantern::scatters_by_sample<coated<diffuse, mirror>>);
    STATIC_REQUIRE(lantern::scatters_by_sample<coated<diffuse, glossy>>);
    STATIC_REQUIRE_FALSE(lantern::specular<coated<diffuse, glossy>>);
    STATIC_REQUIRE(lantern::scatters_by_two_samples<coated<diffuse, lantern::frosted>>);
    STATIC_REQUIRE(lantern::reflects_light<coated<diffuse, glossy>>);
    STATIC_REQUIRE(lantern::reflects_ambient<coated<diffuse, glossy>>);
}

TEST_CASE("what the coat sends on and what the body answers add up to what arrives") {
    const coated m{diffuse{glm::vec3(1)}, mirror{glm::vec3(1)}, 0.25f};
    CHECK(albedo(m, up) == glm::vec3(0.75f));
    CHECK(scatter(m, down, up)[0].weight == glm::vec3(0.25f));
    CHECK(evaluate(m, down, up, {0, 0, 1}) == 0.75f * evaluate(m.body, down, up, {0, 0, 1}));
}

TEST_CASE("a glossy coat is perturbed as a glossy surface is") {
    const coated m{diffuse{}, glossy{.width = 0.5f}, 0.5f};
    const glm::vec2 xi(0.1f, 0.8f);
    CHECK(scatter(m, down, up, xi)[0].direction == scatter(m.coat, down, up, xi)[0].direction);
}

TEST_CASE("a share outside of 0 to 1, and what body or coat refuse, is refused") {
    CHECK_THROWS_WITH(validate(coated{diffuse{}, mirror{}, 1.5f}), containing("coated: share is 1.5"));
    CHECK_THROWS_WITH(validate(coated{diffuse{glm::vec3(2)}, mirror{}, 0.5f}), containing("diffuse: color"));
    CHECK_THROWS_WITH(validate(coated{diffuse{}, mirror{glm::vec3(2)}, 0.5f}), containing("mirror: color"));
    CHECK_NOTHROW(validate(coated{diffuse{}, mirror{}, 1.0f}));
}
