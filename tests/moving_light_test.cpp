// SPDX-License-Identifier: MIT
#include <lantern/moving_light.hpp>

#include <lantern/disk_light.hpp>
#include <lantern/rectangle_light.hpp>
#include <lantern/sphere_light.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <glm/vec3.hpp>

using lantern::moving;

TEST_CASE("a moving light needs the time, and a moving point light nothing besides") {
    STATIC_REQUIRE(lantern::moving_point_light<moving<lantern::point_light>>);
    STATIC_REQUIRE_FALSE(lantern::moving_sampled_light<moving<lantern::point_light>>);
    STATIC_REQUIRE(lantern::moving_sampled_light<moving<lantern::rectangle_light>>);
    STATIC_REQUIRE(lantern::moving_sampled_light<moving<lantern::disk_light>>);
    STATIC_REQUIRE(lantern::moving_sampled_light<moving<lantern::sphere_light>>);
    STATIC_REQUIRE_FALSE(lantern::still_light<moving<lantern::point_light>>);
    STATIC_REQUIRE_FALSE(lantern::still_light<moving<lantern::sphere_light>>);
}

TEST_CASE("a moved light shines as if it stood there") {
    const glm::vec3 p{0.3f, -0.2f, 0.1f};
    const moving m{lantern::point_light{{0, 4, 0}, glm::vec3(8)}, {4, 0, 0}};
    CHECK(illuminate(m, p, 0.0f).position == glm::vec3(0, 4, 0));
    CHECK(illuminate(m, p, 0.5f).position == glm::vec3(2, 4, 0));
    CHECK(illuminate(m, p, 0.5f).irradiance == illuminate(lantern::point_light{{2, 4, 0}, glm::vec3(8)}, p).irradiance);
    const moving s{lantern::sphere_light{{0, 4, 0}, 0.5f, glm::vec3(8)}, {4, 0, 0}};
    const auto a = illuminate(s, p, {0.2f, 0.9f}, 0.25f);
    const auto b = illuminate(lantern::sphere_light{{1, 4, 0}, 0.5f, glm::vec3(8)}, p, {0.2f, 0.9f});
    CHECK(a.position == b.position);
    CHECK(a.irradiance == b.irradiance);
}

TEST_CASE("the surface of a moving light moves with it and never blocks it") {
    dice d{.state = 1};
    for (int i = 0; i < 200; ++i) {
        const float reach = d.magnitude_between(-3, 3), size = 0.1f * reach;
        const moving m{lantern::rectangle_light{d.in_cube(1e-3f * reach), d.in_cube(size), d.in_cube(size)}, d.in_cube(20 * reach)};
        const auto surface = surface_of(m);
        for (int k = 0; k < 200; ++k) {
            const glm::vec3 point = d.in_cube(reach);
            const float time = d.between(0, 1);
            const auto lit = illuminate(m, point, glm::vec2(d.unit(), d.unit()), time);
            if (lit.irradiance == glm::vec3(0)) continue;
            REQUIRE_FALSE(intersect(surface, lantern::timed_ray{{point, lit.position - point}, time}, {0, 1}));
        }
    }
}

TEST_CASE("a moving light is validated as the light is") {
    CHECK_THROWS_WITH(validate(moving{lantern::sphere_light{.radius = -1}, glm::vec3(0)}), containing("radius"));
    CHECK_NOTHROW(validate(moving{lantern::point_light{}, glm::vec3(1)}));
}
