// SPDX-License-Identifier: MIT
#include <lantern/light.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <limits>

using lantern::illumination;
using lantern::point_light;

namespace mine {

struct beam {};
illumination illuminate(const beam&, glm::vec3, glm::vec2) { return {}; }

struct wandering {};
illumination illuminate(const wandering&, glm::vec3, float) { return {}; }

}  // namespace mine

TEST_CASE("the number of arguments says what a light needs") {
    STATIC_REQUIRE(lantern::point_like<point_light>);
    STATIC_REQUIRE_FALSE(lantern::sampled_light<point_light>);
    STATIC_REQUIRE_FALSE(lantern::moving_light<point_light>);
    STATIC_REQUIRE(lantern::sampled_light<mine::beam>);
    STATIC_REQUIRE_FALSE(lantern::point_like<mine::beam>);
    STATIC_REQUIRE(lantern::moving_point_light<mine::wandering>);
    STATIC_REQUIRE_FALSE(lantern::still_light<mine::wandering>);
    STATIC_REQUIRE_FALSE(lantern::light<int>);
}

TEST_CASE("a point light falls off with the square of the distance") {
    const point_light l{{0, 0, 0}, {1, 2, 4}};
    CHECK(illuminate(l, {2, 0, 0}).irradiance == glm::vec3(0.25f, 0.5f, 1));
    CHECK(illuminate(l, {0, 4, 0}).irradiance == glm::vec3(0.0625f, 0.125f, 0.25f));
    CHECK(illuminate(l, {0, 4, 0}).position == l.position);
}

TEST_CASE("the inverse square is right to the last bit from 1e-15 to 1e15") {
    dice d{.state = 1};
    for (int i = 0; i < 20000; ++i) {
        const point_light l{d.magnitude_between(-15, 15) * glm::vec3(d.on_sphere()), glm::vec3(1)};
        const glm::vec3 p = d.magnitude_between(-15, 15) * glm::vec3(d.on_sphere());
        const wide3 to = widened(l.position) - widened(p);
        REQUIRE(error_in_ulp(illuminate(l, p).irradiance.x, 1 / dot(to, to)) <= 0.5 + 1e-6);
    }
}

TEST_CASE("at its own place a point light brings nothing, not NaN") {
    CHECK(illuminate(point_light{{1, 2, 3}, glm::vec3(1)}, {1, 2, 3}).irradiance == glm::vec3(0));
}

TEST_CASE("a light with area shines to the front only, by the cosine, and not at its own plane") {
    const glm::dvec3 area_normal(0, 0, -2);  // area 2, shining down
    const auto at = [&](glm::vec3 p) { return lantern::illuminate_from({0, 0, 3}, area_normal, glm::vec3(5), p).irradiance.x; };
    CHECK(at({0, 0, 1}) == Approx(5 * 2 / 4.0));
    CHECK(at({0, 0, 5}) == 0);
    CHECK(at({1, 0, 3}) == 0);
    CHECK(at({0, 0, 3}) == 0);
    CHECK(at({2, 0, 1}) == Approx(5 * 2 * std::sqrt(0.5) / 8));
}

TEST_CASE("a point light that is not finite or shines negatively is refused") {
    constexpr float bad = std::numeric_limits<float>::quiet_NaN();
    CHECK_THROWS_WITH(validate(point_light{{bad, 0, 0}}), containing("point_light: position is (nan, 0, 0)"));
    CHECK_THROWS_WITH(validate(point_light{{0, 0, 0}, {-1, 0, 0}}), containing("intensity"));
    CHECK_NOTHROW(validate(point_light{}));
}
