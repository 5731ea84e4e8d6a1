// SPDX-License-Identifier: MIT
#include <lantern/blinn_phong.hpp>

#include "catch.hpp"
#include "hemisphere.hpp"
#include "oracle.hpp"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <limits>

using lantern::blinn_phong;

namespace {

const lantern::hit up{.normal = {0, 0, 1}};

double reflected(const blinn_phong& m, double angle, int steps = 600) {
    return over_hemisphere([&](glm::vec3 out) { return double(evaluate(m, -tilted(angle), up, out).x); }, steps);
}

}  // namespace

TEST_CASE("at normal incidence the highlight sends back exactly its share") {
    for (const float exponent : {0.0f, 1.0f, 5.0f, 20.0f, 100.0f, 500.0f})
        CHECK(reflected({glm::vec3(0), glm::vec3(0.7f), exponent}, 0) == Approx(0.7).epsilon(2e-4));
}

TEST_CASE("no angle and no exponent creates light") {
    for (const float exponent : {0.0f, 0.5f, 2.0f, 10.0f, 50.0f, 300.0f})
        for (double angle = 0; angle < 1.57; angle += 0.15) {
            INFO("exponent " << exponent << ", angle " << angle);
            CHECK(reflected({glm::vec3(0.25f), glm::vec3(0.75f), exponent}, angle, 250) < 1.0005);
        }
}

TEST_CASE("without a highlight it is diffuse") {
    const blinn_phong m{glm::vec3(0.5f), glm::vec3(0), 50};
    CHECK(reflected(m, 1.0, 200) == Approx(0.5).epsilon(1e-4));
    CHECK(albedo(m, up) == glm::vec3(0.5f));
}

TEST_CASE("the highlight is brightest at the mirror's direction") {
    const blinn_phong m{glm::vec3(0), glm::vec3(1), 200};
    const glm::vec3 in = -tilted(0.6), mirrored = tilted(-0.6);
    const float peak = evaluate(m, in, up, mirrored).x / mirrored.z;
    for (const double off : {-0.3, -0.1, 0.1, 0.3}) {
        const glm::vec3 out = tilted(-0.6 + off);
        CHECK(evaluate(m, in, up, out).x / out.z < peak);
    }
}

TEST_CASE("Blinn-Phong reflection does not change when light and eye are exchanged") {
    dice d{.state = 1};
    const blinn_phong m{glm::vec3(0.2f), glm::vec3(0.7f), 30};
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 a = tilted(d.unit() * 1.5, 6 * d.unit()), b = tilted(d.unit() * 1.5, 6 * d.unit());
        REQUIRE(evaluate(m, -a, up, b).x / b.z == Approx(evaluate(m, -b, up, a).x / a.z).epsilon(1e-3));
    }
}

TEST_CASE("light from behind, along the ray or grazing gives a number") {
    const blinn_phong m{glm::vec3(0.5f), glm::vec3(0.5f), 50};
    for (const double angle : {0.0, 0.5, 1.5707963})
        for (const double other : {0.0, 0.5, 1.5707963, 2.0, 3.1415926}) {
            const glm::vec3 value = evaluate(m, -tilted(angle), up, tilted(other));
            CHECK(std::isfinite(value.x));
            CHECK(value.x >= 0);
            const glm::vec3 same = evaluate(m, tilted(other), up, tilted(other));  // the light behind the eye's far side
            CHECK(same == glm::vec3(0));
        }
    CHECK(std::isfinite(evaluate(blinn_phong{glm::vec3(0), glm::vec3(1), 1e9f}, {0, 0, -1}, up, {0, 0, 1}).x));
}

TEST_CASE("shares outside of 0 to 1 and negative exponents are refused") {
    CHECK_THROWS_WITH(validate(blinn_phong{.body = glm::vec3(2)}), containing("body"));
    CHECK_THROWS_WITH(validate(blinn_phong{.highlight = glm::vec3(-1)}), containing("highlight"));
    CHECK_THROWS_WITH(validate(blinn_phong{.exponent = -1}), containing("exponent is -1"));
    CHECK_THROWS(validate(blinn_phong{.exponent = std::numeric_limits<float>::quiet_NaN()}));
    CHECK_NOTHROW(validate(blinn_phong{}));
}
