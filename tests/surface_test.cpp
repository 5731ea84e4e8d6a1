// SPDX-License-Identifier: MIT
#include <lantern/surface.hpp>

#include <lantern/interval.hpp>
#include <lantern/ray.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <glm/vec3.hpp>

#include <cmath>
#include <limits>
#include <optional>

using lantern::hit;

namespace mine {

struct wall {};
std::optional<hit> intersect(const wall&, const lantern::ray&, lantern::interval) { return std::nullopt; }

struct door {};
std::optional<hit> intersect(const door&, const lantern::timed_ray&, lantern::interval) { return std::nullopt; }

struct says_yes {};
bool intersect(const says_yes&, const lantern::ray&, lantern::interval) { return true; }

}  // namespace mine

TEST_CASE("a type of another namespace is a surface when its intersect stands beside it") {
    STATIC_REQUIRE(lantern::surface<mine::wall>);
    STATIC_REQUIRE(lantern::surface<mine::wall, lantern::timed_ray>);
    STATIC_REQUIRE_FALSE(lantern::surface<mine::says_yes>);
    STATIC_REQUIRE_FALSE(lantern::surface<int>);
}

TEST_CASE("what needs the time is no surface for a ray without") {
    STATIC_REQUIRE(lantern::surface<mine::door, lantern::timed_ray>);
    STATIC_REQUIRE_FALSE(lantern::surface<mine::door, lantern::ray>);
}

TEST_CASE("an ulp is the distance to the next float away from zero") {
    CHECK(lantern::ulp(1) == 0x1p-23f);
    CHECK(lantern::ulp(-1) == 0x1p-23f);
    CHECK(lantern::ulp(std::nextafter(1.0f, 0.0f)) == 0x1p-24f);
    CHECK(lantern::ulp(0) == std::numeric_limits<float>::denorm_min());
    CHECK(std::isfinite(lantern::ulp(std::numeric_limits<float>::max())));
}

namespace {

/// How far `origin` is above the tangent plane at the true point, along the true normal.
double height(glm::vec3 origin, glm::dvec3 point, glm::dvec3 normal) {
    return glm::dot(glm::dvec3(origin) - point, normal);
}

}  // namespace

TEST_CASE("a ray leaves on the side that it goes to, at any scale, and never farther than 5 ulp") {
    dice d{.state = 5};
    double farthest = 0;
    for (int i = 0; i < 200000; ++i) {
        // Just below powers of two a coordinate's ulp doubles while the step is made.
        glm::dvec3 point = d.on_sphere() * double(d.magnitude_between(-30, 30));
        if (i % 2 == 0)
            for (int k = 0; k < 3; ++k)
                point[k] = std::ldexp(1 - 0x1p-25 * d.unit() * 6, int(d.below(3)) + 20) * (d.below(2) ? 1 : -1);
        glm::dvec3 normal = d.on_sphere();
        if (i % 5 == 0) normal = glm::normalize(glm::dvec3(1) + 0.1 * d.on_sphere());
        const hit h{1, glm::vec3(point), glm::vec3(normal), 0};
        const glm::vec3 out(d.on_sphere());
        const double up = height(leave(h, out), point, normal);
        const double side = glm::dot(glm::dvec3(out), normal);
        if (std::abs(side) < 1e-6) continue;
        REQUIRE(up * side > 0);
        const double largest = std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)});
        farthest = std::max(farthest, std::abs(up) / double(lantern::ulp(float(largest))));
    }
    CHECK(farthest < 5);
}

TEST_CASE("a hit that knows its point badly is left by more") {
    const hit h{1, {0, 0, 0}, {0, 1, 0}, 0.5f};
    CHECK(leave(h, {0, 1, 0}).y >= 0.5f);
    CHECK(leave(h, {0, -1, 0}).y <= -0.5f);
}
