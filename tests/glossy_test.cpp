// SPDX-License-Identifier: MIT
#include <lantern/glossy.hpp>

#include "catch.hpp"
#include "hemisphere.hpp"
#include "oracle.hpp"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

using lantern::glossy;
using lantern::perturbed;

namespace {

const lantern::hit up{.normal = {0, 0, 1}};

const std::array<glm::vec3, 8> hard{{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}, {1e-10f, 0, -1}, {3e-4f, -4e-4f, -1},
                                     {0.6f, 0, 0.8f}, {0.577f, 0.577f, -0.577f}}};

/// Where in the square a perturbed direction goes through it: in units along u and v.
glm::dvec2 in_square(glm::vec3 r, glm::vec3 perturbed) {
    const lantern::basis b = lantern::basis_from(r);
    const glm::dvec3 p(perturbed);
    const double forward = glm::dot(p, glm::dvec3(b.w));
    return {glm::dot(p, glm::dvec3(b.u)) / forward, glm::dot(p, glm::dvec3(b.v)) / forward};
}

}  // namespace

TEST_CASE("a perturbed ray goes through the square of side a as the lecture has it, at the poles too") {
    dice d{.state = 1};
    for (int i = 0; i < 20000; ++i) {
        const glm::vec3 r = i % 2 == 0 ? glm::normalize(hard[d.below(8)]) : glm::vec3(d.on_sphere());
        const float a = d.between(0.001, 3);
        const glm::vec2 xi(d.unit(), d.unit());
        const glm::vec3 p = perturbed(r, a, xi);
        REQUIRE(glm::length(p) == Approx(1).epsilon(1e-6));
        const glm::dvec2 uv = in_square(r, p);
        REQUIRE(std::abs(uv.x - (-a / 2 + double(xi.x) * a)) < 1e-6 * (1 + a * a));
        REQUIRE(std::abs(uv.y - (-a / 2 + double(xi.y) * a)) < 1e-6 * (1 + a * a));
    }
}

TEST_CASE("uniform in the unit square is uniform in the square of side a: chi-square, and mean") {
    // 64 cells, 63 degrees of freedom: above 125 once in 200,000 times. The mean within 4.5 sigma: once in 150,000.
    dice d{.state = 2};
    constexpr int count = 64000;
    const float a = 0.8f;
    for (const glm::vec3& direction : hard) {
        const glm::vec3 r = glm::normalize(direction);
        std::array<int, 64> cell{};
        glm::dvec2 mean{0};
        for (int i = 0; i < count; ++i) {
            const glm::dvec2 uv = in_square(r, perturbed(r, a, glm::vec2(d.unit(), d.unit())));
            mean += uv / double(count);
            const auto x = static_cast<std::size_t>(std::clamp((uv.x / double(a) + 0.5) * 8, 0.0, 7.0));
            const auto y = static_cast<std::size_t>(std::clamp((uv.y / double(a) + 0.5) * 8, 0.0, 7.0));
            ++cell[8 * y + x];
        }
        double chi2 = 0;
        for (const int n : cell) chi2 += (n - count / 64.0) * (n - count / 64.0) / (count / 64.0);
        CHECK(chi2 < 125);
        const double sigma = double(a) / std::sqrt(12.0 * count);
        CHECK(std::abs(mean.x) < 4.5 * sigma);
        CHECK(std::abs(mean.y) < 4.5 * sigma);
    }
}

TEST_CASE("the blur does not depend on the length of the ray") {
    dice d{.state = 3};
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 r(d.on_sphere());
        const glm::vec2 xi(d.unit(), d.unit());
        for (const float length : {1e-20f, 0.01f, 100.0f, 1e20f})
            REQUIRE(glm::distance(perturbed(length * r, 0.7f, xi), perturbed(r, 0.7f, xi)) < 1e-6f);
    }
}

TEST_CASE("a width of zero is a mirror, to the last bit") {
    dice d{.state = 4};
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 in(d.on_sphere()), n(d.on_sphere());
        const lantern::hit h{.normal = n};
        const glm::vec3 mirrored = scatter(lantern::mirror{}, in, h)[0].direction;
        REQUIRE(scatter(glossy{.width = 0}, in, h, glm::vec2(d.unit(), d.unit()))[0].direction == mirrored);
    }
}

TEST_CASE("the width goes to zero without a jump, and may be huge") {
    const glm::vec3 r = glm::normalize(glm::vec3(1, 2, 3));
    CHECK(glm::distance(perturbed(r, 1e-30f, {0.9f, 0.1f}), r) < 1e-7f);
    const glm::vec3 far = perturbed(r, 1e30f, {0.9f, 0.1f});
    CHECK(glm::length(far) == Approx(1));
    CHECK(std::abs(glm::dot(far, r)) < 1e-6f);
}

TEST_CASE("no glossy ray goes below the surface, and folding loses none") {
    dice d{.state = 5};
    const glossy m{.color = glm::vec3(0.9f), .width = 1};
    const glm::vec3 in = -tilted(80 * 0.017453292519943);
    int below = 0;
    constexpr int count = 100000;
    for (int i = 0; i < count; ++i) {
        const glm::vec2 xi(d.unit(), d.unit());
        const auto rays = scatter(m, in, up, xi);
        REQUIRE(rays.size() == 1);
        REQUIRE(rays[0].direction.z >= 0);
        REQUIRE(rays[0].weight == glm::vec3(0.9f));
        const glm::vec3 plain = perturbed(lantern::mirrored(in, up.normal), 1, xi);
        below += plain.z < 0;
        const glm::vec3 folded = plain.z < 0 ? glm::vec3(plain.x, plain.y, -plain.z) : plain;
        REQUIRE(glm::distance(rays[0].direction, folded) < 1e-6f);
    }
    CHECK(below == Approx(0.32 * count).epsilon(0.03));
}

TEST_CASE("seen from behind, a glossy surface sends rays back to where they came from") {
    dice d{.state = 6};
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 in = tilted(1.5 * d.unit(), 6 * d.unit());
        REQUIRE(scatter(glossy{.width = 1}, in, up, glm::vec2(d.unit(), d.unit()))[0].direction.z <= 0);
    }
}

TEST_CASE("frosted glass keeps each ray on its side, and its weights") {
    dice d{.state = 7};
    const lantern::frosted m{.body = {.index = 1.5f}, .width = 1.5f};
    STATIC_REQUIRE(lantern::scatters_by_two_samples<lantern::frosted>);
    STATIC_REQUIRE_FALSE(lantern::scatters_by_sample<lantern::frosted>);
    for (int i = 0; i < 5000; ++i) {
        const glm::vec3 in(d.on_sphere());
        const auto clear = scatter(m.body, in, up);
        const auto rays = scatter(m, in, up, glm::vec2(d.unit(), d.unit()), glm::vec2(d.unit(), d.unit()));
        REQUIRE(rays.size() == clear.size());
        for (std::uint32_t k = 0; k < rays.size(); ++k) {
            REQUIRE(rays[k].weight == clear[k].weight);
            REQUIRE(rays[k].direction.z * clear[k].direction.z >= 0);
        }
    }
    const auto clear = scatter(m.body, -tilted(0.5), up);
    const auto sharp = scatter(lantern::frosted{.width = 0}, -tilted(0.5), up, {0.1f, 0.2f}, {0.3f, 0.4f});
    CHECK(sharp[0].direction == clear[0].direction);
    CHECK(sharp[1].direction == clear[1].direction);
}

TEST_CASE("a negative or infinite width is refused") {
    CHECK_THROWS_WITH(validate(glossy{.width = -0.1f}), containing("glossy: width is -0.1"));
    CHECK_THROWS(validate(glossy{.width = lantern::infinity}));
    CHECK_THROWS_WITH(validate(glossy{.color = glm::vec3(2)}), containing("glossy: color"));
    CHECK_THROWS_WITH(validate(lantern::frosted{.body = {.index = 0}}), containing("glass: index"));
    CHECK_NOTHROW(validate(lantern::frosted{}));
}
