// SPDX-License-Identifier: MIT
#include <lantern/mirror.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

using lantern::mirror;

TEST_CASE("the angle of reflection is the angle of incidence, in one plane, to half an ulp a component") {
    dice d{.state = 1};
    for (int i = 0; i < 20000; ++i) {
        const glm::vec3 in(d.on_sphere()), normal(d.on_sphere());
        const wide3 w = widened(in), n = widened(normal);
        wide3 truth = w - (2 * dot(n, w) / dot(n, n)) * n;
        truth = (1 / length(truth)) * truth;
        REQUIRE(largest_difference(lantern::mirrored(in, normal), truth) <= 0x1.001p-25);
    }
}

TEST_CASE("neither the side nor the length of the normal matters") {
    const glm::vec3 in = glm::normalize(glm::vec3(1, -2, 0.5f)), n = glm::normalize(glm::vec3(0.1f, 1, 0.2f));
    CHECK(lantern::mirrored(in, n) == lantern::mirrored(in, -n));
    CHECK(glm::distance(lantern::mirrored(in, n), lantern::mirrored(in, 1e-20f * n)) < 1e-6f);
}

TEST_CASE("reflected twice, a ray goes as it came") {
    dice d{.state = 2};
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 in(d.on_sphere()), n(d.on_sphere());
        REQUIRE(glm::distance(lantern::mirrored(lantern::mirrored(in, n), n), in) < 3e-7f);
    }
}

TEST_CASE("a mirror sends one ray on, needs no number, and answers no light") {
    STATIC_REQUIRE(lantern::specular<mirror>);
    STATIC_REQUIRE_FALSE(lantern::scatters_by_sample<mirror>);
    STATIC_REQUIRE_FALSE(lantern::reflects_light<mirror>);
    const auto rays = scatter(mirror{{1, 0.5f, 0}}, {0, 0, -1}, {.normal = {0, 0, 1}});
    REQUIRE(rays.size() == 1);
    CHECK(rays[0].direction == glm::vec3(0, 0, 1));
    CHECK(rays[0].weight == glm::vec3(1, 0.5f, 0));
    CHECK_THROWS_WITH(validate(mirror{glm::vec3(1.5f)}), containing("mirror: color"));
}
