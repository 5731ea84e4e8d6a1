// SPDX-License-Identifier: MIT
#include <lantern/sphere_light.hpp>

#include <lantern/exact_light.hpp>

#include "catch.hpp"
#include "light_checks.hpp"
#include "oracle.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <numbers>

using lantern::sphere_light;

TEST_CASE("above the horizon the mean over a sphere light is pi L (R/d)^2 cos, exactly, at any size and distance") {
    dice d{.state = 1};
    for (int i = 0; i < 60; ++i) {
        const float distance = d.magnitude_between(-6, 6), ratio = i < 30 ? d.between(0.01, 0.9999) : d.magnitude_between(-9, -1);
        const glm::vec3 axis(d.on_sphere());
        const sphere_light l{distance * axis, ratio * distance, glm::vec3(3)};
        const double sine = double(l.radius) / glm::length(glm::dvec3(l.center));
        // As far from the axis as leaves the whole sphere above the horizon.
        const double tilt = (std::numbers::pi / 2 - std::asin(sine)) * d.unit() * 0.99;
        const auto b = lantern::basis_from(l.center);
        const glm::dvec3 normal = std::cos(tilt) * glm::normalize(glm::dvec3(l.center)) + std::sin(tilt) * glm::dvec3(b.u);
        const double exact = 3 * std::numbers::pi * sine * sine * std::cos(tilt);
        REQUIRE(mean_irradiance(l, {0, 0, 0}, normal, 200) == Approx(exact).epsilon(1e-4));
    }
}

TEST_CASE("a sphere light at the horizon is cut by it") {
    for (const double cosine : {0.3, 0.0, -0.3}) {
        const sphere_light l{{0, 0, -2}, 1, glm::vec3(1)};
        const glm::dvec3 normal(std::sqrt(1 - cosine * cosine), 0, -cosine);
        CHECK(mean_irradiance(l, {0, 0, 0}, normal, 256) ==
              Approx(lantern::exact::sphere_irradiance(2, 1, cosine)).epsilon(1e-3));
    }
}

TEST_CASE("every sample of a sphere light brings the same: radiance times solid angle, to the last bits") {
    dice d{.state = 2};
    for (int i = 0; i < 5000; ++i) {
        const sphere_light l{d.magnitude_between(-3, 3) * glm::vec3(d.on_sphere()), 1, glm::vec3(1)};
        const sphere_light small{l.center, glm::length(l.center) * d.magnitude_between(-8, -0.01), glm::vec3(1)};
        const wide d2 = dot(widened(small.center), widened(small.center)), r2 = wide(small.radius) * wide(small.radius);
        if (!(r2 < d2)) continue;
        const wide solid_angle = wide(2) * wide(std::numbers::pi_v<long double>) * (1 - square_root((d2 - r2) / d2));
        REQUIRE(error_in_ulp(illuminate(small, {0, 0, 0}, glm::vec2(d.unit(), d.unit())).irradiance.x, solid_angle) < 0.6);
    }
}

TEST_CASE("samples of a sphere light lie on its near side, uniform by solid angle") {
    dice d{.state = 3};
    const sphere_light l{{0, 0, -2}, 1, glm::vec3(1)};
    const double height = 1 - std::sqrt(0.75);  // of the cap seen
    int inner = 0;
    constexpr int count = 20000;
    for (int i = 0; i < count; ++i) {
        const auto p = glm::dvec3(illuminate(l, {0, 0, 0}, glm::vec2(d.unit(), d.unit())).position);
        REQUIRE(glm::distance(p, glm::dvec3(l.center)) == Approx(1).epsilon(1e-5));
        REQUIRE(glm::dot(p - glm::dvec3(l.center), -p) > -1e-4);  // its outside faces the point
        inner += -p.z / glm::length(p) > 1 - height / 2;
    }
    CHECK(inner == Approx(count / 2).margin(4 * std::sqrt(count / 4.0)));  // false alarm: 6e-5
}

TEST_CASE("inside a sphere light, and on it, it is dark, and nothing is NaN") {
    const sphere_light l{{1, 0, 0}, 2, glm::vec3(1)};
    for (const glm::vec3 p : {glm::vec3(1, 0, 0), glm::vec3(1, 1.9f, 0), glm::vec3(3, 0, 0)})
        CHECK(illuminate(l, p, {0.3f, 0.8f}).irradiance == glm::vec3(0));
    const auto grazing = illuminate(l, {std::nextafter(3.0f, 4.0f), 0, 0}, {0.3f, 0.8f});
    CHECK(grazing.irradiance.x == Approx(2 * std::numbers::pi).epsilon(1e-2));
    CHECK(std::isfinite(grazing.position.x));
}

TEST_CASE("the corners of the unit square are points of the sphere light too") {
    for (const float x : {0.0f, 0.5f, 1.0f})
        for (const float y : {0.0f, 0.5f, 1.0f})
            for (const float radius : {1e-20f, 1e-6f, 1.0f, 1.999999f}) {
                const auto i = illuminate(sphere_light{{0, 0, -2}, radius, glm::vec3(1)}, {0, 0, 0}, {x, y});
                CHECK(glm::distance(i.position, glm::vec3(0, 0, -2)) == Approx(radius).margin(2e-6));
                CHECK(i.irradiance.x >= 0);
            }
}

TEST_CASE("the surface of a sphere light never blocks its own light, wherever it hangs") {
    dice d{.state = 4};
    int blocked = 0;
    for (int i = 0; i < 400; ++i) {
        const float reach = d.magnitude_between(-6, 6), size = reach * d.magnitude_between(-4, 1);
        const glm::vec3 place = d.in_cube(reach * d.magnitude_between(-6, 2));
        blocked += blocked_by_itself(sphere_light{place, size}, d, reach, 500);
    }
    CHECK(blocked == 0);
}

TEST_CASE("a sphere light without radius is refused") {
    CHECK_THROWS_WITH(validate(sphere_light{.radius = 0}), containing("sphere_light: radius is 0"));
    CHECK_THROWS_WITH(validate(sphere_light{.radius = -1}), containing("positive"));
    CHECK_THROWS_WITH(validate(sphere_light{.radiance = glm::vec3(-1)}), containing("radiance"));
    CHECK_THROWS(validate(sphere_light{.center = glm::vec3(std::numeric_limits<float>::quiet_NaN())}));
    CHECK_NOTHROW(validate(sphere_light{}));
}
