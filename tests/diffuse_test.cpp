// SPDX-License-Identifier: MIT
#include <lantern/diffuse.hpp>

#include "catch.hpp"
#include "hemisphere.hpp"
#include "oracle.hpp"

#include <glm/vec3.hpp>

#include <numbers>

using lantern::diffuse;

namespace {
const lantern::hit up{.normal = {0, 0, 1}};
}

TEST_CASE("a diffuse surface sends back its color of what arrives, from whatever side it is seen") {
    const diffuse m{{0.2f, 0.5f, 1}};
    for (const double angle : {0.0, 0.7, 1.5}) {
        const glm::vec3 in = -tilted(angle);
        const auto total = [&](int c) { return over_hemisphere([&](glm::vec3 out) { return evaluate(m, in, up, out)[c]; }, 200); };
        CHECK(total(0) == Approx(0.2).epsilon(1e-4));
        CHECK(total(2) == Approx(1.0).epsilon(1e-4));
    }
    CHECK(albedo(m, up) == m.color);
}

TEST_CASE("light from behind does not shine through") {
    const diffuse m{glm::vec3(1)};
    CHECK(evaluate(m, {0, 0, -1}, up, {0, 0, -1}) == glm::vec3(0));
    CHECK(evaluate(m, {0, 0, 1}, up, {0, 0, 1}) == glm::vec3(0));  // seen from behind, lit from the front
    CHECK(evaluate(m, {0, 0, 1}, up, {0, 0, -1}).x == Approx(std::numbers::inv_pi));
}

TEST_CASE("diffuse reflection does not change when light and eye are exchanged") {
    dice d{.state = 1};
    const diffuse m{glm::vec3(0.7f)};
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 a = tilted(d.unit() * 1.5, 6 * d.unit()), b = tilted(d.unit() * 1.5, 6 * d.unit());
        REQUIRE(evaluate(m, -a, up, b).x / b.z == Approx(evaluate(m, -b, up, a).x / a.z).epsilon(1e-5));
    }
}

TEST_CASE("a diffuse color above 1 is refused") {
    CHECK_THROWS_WITH(validate(diffuse{glm::vec3(1.5f)}), containing("diffuse: color"));
    CHECK_NOTHROW(validate(diffuse{}));
}
