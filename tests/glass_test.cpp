// SPDX-License-Identifier: MIT
#include <lantern/glass.hpp>

#include "catch.hpp"
#include "hemisphere.hpp"
#include "oracle.hpp"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using lantern::glass;
using lantern::refracted;

namespace {

const lantern::hit up{.normal = {0, 0, 1}};

/// A unit direction in float, `nudge` ulp or so from the angle with this sine, coming down on a random normal.
struct meeting {
    glm::vec3 in, normal;
};
meeting at_sine(dice& d, double sine) {
    const glm::dvec3 n = d.on_sphere(), side = glm::normalize(glm::cross(n, d.on_sphere()));
    return {glm::vec3(sine * side - std::sqrt(std::max(0.0, 1 - sine * sine)) * n), glm::vec3(n)};
}

}  // namespace

TEST_CASE("total internal reflection is told right to the last ulp of the angle") {
    dice d{.state = 1};
    int wrong = 0, reflected = 0;
    for (int i = 0; i < 300000; ++i) {
        const float index = d.between(1.0001, 3);
        const double sine = (1 / double(index)) * (1 + 0x1p-23 * (8 * d.unit() - 4));
        const auto [in, normal] = at_sine(d, sine);
        const wide3 n = widened(normal), w = widened(in), x = cross(n, w);
        const bool total = wide(index) * wide(index) * dot(x, x) >= dot(n, n) * dot(w, w);
        wrong += total == refracted(in, normal, index).has_value();
        reflected += total;
    }
    CHECK(wrong == 0);
    CHECK(reflected > 50000);  // both sides of the critical angle were visited
    CHECK(reflected < 250000);
}

TEST_CASE("at exactly the critical angle, which numbers of one or two digits can hit, nothing passes") {
    CHECK_FALSE(refracted({4, 0, -3}, {0, 0, 1}, 1.25));  // sine 4/5 times 5/4
    CHECK(refracted({4, 0, -3.000001f}, {0, 0, 1}, 1.25));
}

TEST_CASE("the refracted direction is right to half an ulp a component, also near the critical angle") {
    dice d{.state = 2};
    for (int i = 0; i < 100000; ++i) {
        const double ratio = i % 2 == 0 ? double(d.between(0.3, 3)) : 1 / double(d.between(0.3, 3));
        const double sine = i % 3 == 0 ? std::min(1.0, 1 / ratio) * (1 - d.magnitude_between(-7, -1)) : d.unit();
        const auto [in, normal] = at_sine(d, sine);
        const auto got = refracted(in, normal, ratio);
        const wide3 n = (1 / length(widened(normal))) * widened(normal), w = (1 / length(widened(in))) * widened(in);
        const wide3 x = cross(n, w);
        const wide sine2 = wide(ratio) * wide(ratio) * dot(x, x);
        REQUIRE(got.has_value() == (sine2 < 1));
        if (!got) continue;
        const wide cosine = square_root(1 - sine2);
        const wide3 truth = wide(ratio) * w + (-(wide(ratio) * dot(n, w)) - cosine) * n;
        REQUIRE(largest_difference(got->direction, truth) <= 0x1.01p-25);
    }
}

TEST_CASE("Snell's law: the sine changes by the ratio, within the plane of incidence") {
    for (const double angle : {0.1, 0.5, 1.0, 1.5}) {
        const auto r = refracted(-tilted(angle), {0, 0, 1}, 1 / 1.5);
        REQUIRE(r);
        CHECK(glm::length(glm::vec2(r->direction)) == Approx(std::sin(angle) / 1.5).epsilon(1e-6));
        CHECK(r->direction.z < 0);
        CHECK(r->direction.x < 0);
        CHECK(r->direction.y == 0);
    }
}

TEST_CASE("Fresnel's laws where they have a short form") {
    for (const double index : {1.1, 1.5, 2.4}) {
        const double normal = std::pow((index - 1) / (index + 1), 2);
        CHECK(refracted({0, 0, -1}, {0, 0, 1}, 1 / index)->reflectance == Approx(normal).epsilon(1e-6));
        CHECK(refracted({0, 0, -1}, {0, 0, 1}, index)->reflectance == Approx(normal).epsilon(1e-6));
        // At Brewster's angle one polarisation passes whole.
        const double brewster = std::atan(index), other = std::pow((index * index - 1) / (index * index + 1), 2);
        CHECK(refracted(-tilted(brewster), {0, 0, 1}, 1 / index)->reflectance == Approx(other / 2).epsilon(1e-6));
        CHECK(refracted(-tilted(std::numbers::pi / 2 - 1e-5), {0, 0, 1}, 1 / index)->reflectance > 0.999f);
        const double critical = std::asin(1 / index);
        const auto nearly = refracted(-tilted(critical * (1 - 1e-6)), {0, 0, 1}, index);
        REQUIRE(nearly);
        CHECK(nearly->reflectance > 0.97f);
    }
}

TEST_CASE("a ray that takes the way back is reflected by the same part") {
    dice d{.state = 3};
    for (int i = 0; i < 5000; ++i) {
        const double index = 1 + 2 * d.unit();
        const auto in = refracted(-tilted(1.55 * d.unit()), {0, 0, 1}, 1 / index);
        const auto back = refracted(-in->direction, {0, 0, -1}, index);
        REQUIRE(back);
        REQUIRE(back->reflectance == Approx(in->reflectance).epsilon(2e-4).margin(1e-6));
    }
}

TEST_CASE("what is reflected and what passes is all there is") {
    dice d{.state = 4};
    const glass m{.index = 1.5f};
    for (int i = 0; i < 20000; ++i) {
        glm::vec3 sum{0};
        const glm::vec3 in(d.on_sphere());
        for (const lantern::bounce& b : scatter(m, in, up)) {
            REQUIRE(b.weight.x > 0);
            REQUIRE(glm::length(b.direction) == Approx(1).epsilon(1e-6));
            sum += b.weight;
        }
        REQUIRE(std::abs(sum.x - 1) <= 0x1p-24f);
    }
}

TEST_CASE("an index of exactly 1 lets every ray pass, to the last bit") {
    dice d{.state = 5};
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 in(d.on_sphere());
        const auto rays = scatter(glass{.index = 1}, in, up);
        REQUIRE(rays.size() == 1);
        REQUIRE(rays[0].direction == in);
        REQUIRE(rays[0].weight == glm::vec3(1));
    }
}

TEST_CASE("glass bends towards the normal on the way in, and away from it on the way out") {
    const glass m{.index = 1.5f, .color = {1, 0.5f, 0.25f}};
    const auto in = scatter(m, -tilted(0.7), up);
    REQUIRE(in.size() == 2);
    CHECK(in[0].direction.z > 0);
    CHECK(in[1].direction.z < -std::cos(0.7));
    CHECK(in[1].weight.y == 0.5f * in[1].weight.x);  // tinted as it passes, not as it is reflected
    CHECK(in[0].weight.x == in[0].weight.y);
    const auto out = scatter(m, tilted(0.5), up);
    REQUIRE(out.size() == 2);
    CHECK(out[1].direction.z > 0);
    CHECK(out[1].direction.z < std::cos(0.5));
    CHECK(scatter(m, tilted(0.8), up).size() == 1);  // beyond asin(1/1.5) = .73
}

TEST_CASE("along the surface nothing is NaN") {
    for (const float index : {0.5f, 1.0f, 1.5f, 1e-30f, 1e30f})
        for (const glm::vec3 in : {glm::vec3(1, 0, 0), glm::vec3(1, 0, 1e-8f), glm::vec3(1, 0, -1e-8f), glm::vec3(0, 0, -1)})
            for (const lantern::bounce& b : scatter(glass{.index = index}, in, up)) {
                CHECK(glm::length(b.direction) == Approx(1).epsilon(1e-5));
                CHECK(b.weight.x >= 0);
                CHECK(b.weight.x <= 1);
            }
}

TEST_CASE("an index of zero or less is refused") {
    CHECK_THROWS_WITH(validate(glass{.index = 0}), containing("glass: index is 0"));
    CHECK_THROWS_WITH(validate(glass{.index = -1.5f}), containing("positive"));
    CHECK_THROWS_WITH(validate(glass{.color = glm::vec3(2)}), containing("glass: color"));
    CHECK_NOTHROW(validate(glass{}));
}
