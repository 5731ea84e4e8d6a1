// SPDX-License-Identifier: MIT
#include <lantern/disk_light.hpp>

#include <lantern/exact_light.hpp>

#include "catch.hpp"
#include "light_checks.hpp"
#include "oracle.hpp"

#include <glm/geometric.hpp>

using lantern::disk_light;

TEST_CASE("the mean over a disk light is the view factor of a disk, on its axis and aside") {
    dice d{.state = 1};
    for (int i = 0; i < 60; ++i) {
        const float radius = d.between(0.2, 2), height = d.between(1, 4), aside = d.between(0, 3);
        const glm::dvec3 down = d.on_sphere();  // any orientation of the whole arrangement
        const auto b = lantern::basis_from(glm::vec3(down));
        const disk_light l{-height * b.w + aside * b.u, 3.0f * b.w, radius, glm::vec3(1)};
        const double exact = lantern::exact::disc_irradiance(height, aside, radius);
        CHECK(mean_irradiance(l, {0, 0, 0}, -glm::dvec3(b.w), 128) == Approx(exact).epsilon(3e-4));
    }
}

TEST_CASE("a disk light shines to the side of its normal only") {
    const disk_light l{{0, 3, 0}, {0, -1, 0}, 1, glm::vec3(1)};
    CHECK(illuminate(l, {0, 0, 0}, {0.5f, 0.5f}).irradiance.x > 0);
    CHECK(illuminate(l, {0, 6, 0}, {0.5f, 0.5f}).irradiance.x == 0);
}

TEST_CASE("points of a disk light are uniform by area: half of them within the radius / sqrt 2") {
    const disk_light l{{0, 3, 0}, {0, -1, 0}, 2, glm::vec3(1)};
    int within = 0;
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x) {
            const auto p = illuminate(l, {0, 0, 0}, (glm::vec2(x, y) + 0.5f) / 100.0f).position - l.center;
            REQUIRE(glm::length(p) < 2.00001f);
            within += glm::length(p) < 1.41421356f;
        }
    CHECK(within == Approx(5000).margin(150));
}

TEST_CASE("the surface of a disk light never blocks its own light, wherever it hangs") {
    dice d{.state = 2};
    int blocked = 0;
    for (int i = 0; i < 400; ++i) {
        const float reach = d.magnitude_between(-6, 6), size = reach * d.magnitude_between(-4, 1);
        const glm::vec3 place = d.in_cube(reach * d.magnitude_between(-6, 2));
        blocked += blocked_by_itself(disk_light{place, d.in_cube(), size}, d, reach, 500);
    }
    CHECK(blocked == 0);
}

TEST_CASE("a disk light without radius or normal is refused") {
    CHECK_THROWS_WITH(validate(disk_light{.radius = 0}), containing("disk_light: radius"));
    CHECK_THROWS_WITH(validate(disk_light{.radius = -1}), containing("positive"));
    CHECK_THROWS_WITH(validate(disk_light{.normal = glm::vec3(0)}), containing("normal"));
    CHECK_THROWS_WITH(validate(disk_light{.radiance = glm::vec3(-1)}), containing("radiance"));
    CHECK_NOTHROW(validate(disk_light{}));
}
