// SPDX-License-Identifier: MIT
#include <lantern/rectangle_light.hpp>

#include <lantern/exact_light.hpp>

#include "catch.hpp"
#include "light_checks.hpp"
#include "oracle.hpp"

#include <glm/geometric.hpp>

#include <limits>

using lantern::rectangle_light;

namespace {

double exact(const rectangle_light& l, glm::vec3 point, glm::dvec3 normal) {
    const lantern::exact::polygon p =
        corners(lantern::exact::parallelogram{glm::dvec3(l.corner), glm::dvec3(l.edge_u), glm::dvec3(l.edge_v)});
    return lantern::exact::irradiance(glm::dvec3(point), normal, p);
}

}  // namespace

TEST_CASE("the mean over a rectangle light is Lambert's irradiance, also part below the horizon") {
    dice d{.state = 1};
    for (int i = 0; i < 40; ++i) {
        const glm::vec3 point = d.in_cube();
        const rectangle_light l{{-1, 3, -1}, {2, 0, 0}, {0.3f, 0, 2}, glm::vec3(1)};  // u × v points down
        const glm::dvec3 normal = d.on_sphere();
        CHECK(mean_irradiance(l, point, normal, 200) == Approx(exact(l, point, normal)).epsilon(2e-3).margin(1e-4));
        const glm::dvec3 up(0, 1, 0);
        CHECK(mean_irradiance(l, point, up) == Approx(exact(l, point, up)).epsilon(1e-4));
    }
}

TEST_CASE("a rectangle light shines to the side of u cross v only") {
    const rectangle_light l{{-1, 3, -1}, {2, 0, 0}, {0, 0, 2}, glm::vec3(1)};
    CHECK(illuminate(l, {0, 0, 0}, {0.5f, 0.5f}).irradiance.x > 0);
    CHECK(illuminate(l, {0, 6, 0}, {0.5f, 0.5f}).irradiance.x == 0);
    CHECK(illuminate(l, {5, 3, 0}, {0.5f, 0.5f}).irradiance.x == 0);
}

TEST_CASE("the unit square is carried to a rectangle light linearly") {
    const rectangle_light l{{-1, 3, -1}, {2, 0, 0}, {0.5f, 0, 2}, glm::vec3(1)};
    for (const glm::vec2 xi : {glm::vec2(0), glm::vec2(1, 0), glm::vec2(0.25f, 0.75f)}) {
        const glm::vec3 truth = l.corner + xi.x * l.edge_u + xi.y * l.edge_v;
        CHECK(glm::distance(illuminate(l, {0, 0, 0}, xi).position, truth) < 1e-5f);
    }
}

TEST_CASE("the surface of a rectangle light never blocks its own light, wherever it hangs") {
    dice d{.state = 2};
    int blocked = 0;
    for (int i = 0; i < 400; ++i) {
        const float reach = d.magnitude_between(-6, 6), size = reach * d.magnitude_between(-4, 1);
        const glm::vec3 place = d.in_cube(reach * d.magnitude_between(-6, 2));
        blocked += blocked_by_itself(rectangle_light{place, d.in_cube(size), d.in_cube(size)}, d, reach, 500);
    }
    CHECK(blocked == 0);
}

TEST_CASE("what stands just before a rectangle light blocks it") {
    dice d{.state = 3};
    for (const float scale : {1e-6f, 1.0f, 1e6f}) {
        const rectangle_light l{scale * glm::vec3(-1, 3, -1), scale * glm::vec3(2, 0, 0), scale * glm::vec3(0, 0, 2)};
        const lantern::rectangle lid{scale * glm::vec3(-9, 3 * (1 - 0x1p-18f), -9), scale * glm::vec3(18, 0, 0),
                                     scale * glm::vec3(0, 0, 18)};
        for (int i = 0; i < 2000; ++i) {
            const glm::vec3 origin = scale * d.in_cube();
            const auto lit = illuminate(l, origin, glm::vec2(d.unit(), d.unit()));
            REQUIRE(intersect(lid, lantern::ray{origin, lit.position - origin}, {0, 1}));
        }
    }
}

TEST_CASE("a rectangle light that is flat to a line, not finite or negative is refused") {
    CHECK_THROWS_WITH(validate(rectangle_light{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), containing("not parallel"));
    CHECK_THROWS_WITH(validate(rectangle_light{.radiance = glm::vec3(-1)}), containing("rectangle_light: radiance"));
    CHECK_THROWS(validate(rectangle_light{.corner = glm::vec3(std::numeric_limits<float>::infinity())}));
    CHECK_NOTHROW(validate(rectangle_light{}));
}
