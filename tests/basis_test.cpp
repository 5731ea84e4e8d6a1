// SPDX-License-Identifier: MIT
#include <lantern/basis.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <glm/geometric.hpp>

#include <limits>

using lantern::basis;
using lantern::basis_from;

namespace {

/// The largest deviation from unit length and from a right angle, in double.
double deviation(const basis& b) {
    const glm::dvec3 u(b.u), v(b.v), w(b.w);
    double largest = 0;
    for (const double x : {glm::length(u) - 1, glm::length(v) - 1, glm::length(w) - 1, glm::dot(u, v), glm::dot(v, w), glm::dot(w, u)})
        if (!(std::abs(x) <= largest)) largest = std::abs(x);  // NaN is the largest
    return largest;
}

bool right_handed(const basis& b) { return glm::dot(glm::cross(glm::dvec3(b.u), glm::dvec3(b.v)), glm::dvec3(b.w)) > 0.999; }

bool along(const basis& b, glm::vec3 w) { return glm::length(glm::cross(glm::normalize(glm::dvec3(w)), glm::dvec3(b.w))) < 1e-7; }

}  // namespace

TEST_CASE("a basis is orthonormal, right-handed, and has w along the given vector") {
    dice d{1};
    double largest = 0;
    for (int i = 0; i < 50000; ++i) {
        const glm::vec3 w(double(d.magnitude_between(-18, 18)) * d.on_sphere());
        const basis b = basis_from(w);
        largest = std::max(largest, deviation(b));
        REQUIRE(right_handed(b));
        REQUIRE(along(b, w));
    }
    CHECK(largest <= 8e-8);
}

TEST_CASE("near the poles, and with either zero, the basis is as good") {
    for (const float z : {1.0f, -1.0f}) {
        for (const float tiny : {0.0f, -0.0f, 1e-45f, 1e-30f, 1e-10f, 1e-4f}) {
            const glm::vec3 w(tiny, -tiny, z);
            CHECK(deviation(basis_from(w)) <= 8e-8);
            CHECK(right_handed(basis_from(w)));
            CHECK(along(basis_from(w), w));
        }
    }
    CHECK(deviation(basis_from({1, 0, 0.0f})) <= 8e-8);
    CHECK(deviation(basis_from({1, 0, -0.0f})) <= 8e-8);
}

TEST_CASE("w need not be normalised, however long or short") {
    const float least = std::numeric_limits<float>::denorm_min(), most = std::numeric_limits<float>::max();
    for (const glm::vec3 w : {glm::vec3(least), glm::vec3(most), glm::vec3(least, 0, 0), glm::vec3(0, -most, most), glm::vec3(1.001f, 0, 0)}) {
        CHECK(deviation(basis_from(w)) <= 8e-8);
        CHECK(along(basis_from(w), w));
    }
}

TEST_CASE("a vector that has no direction gives the axes") {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    for (const glm::vec3 w : {glm::vec3(0), glm::vec3(-0.0f), glm::vec3(nan, 0, 1), glm::vec3(0, inf, 0)}) {
        const basis b = basis_from(w);
        CHECK(b.u == glm::vec3(1, 0, 0));
        CHECK(b.v == glm::vec3(0, 1, 0));
        CHECK(b.w == glm::vec3(0, 0, 1));
    }
}

TEST_CASE("coordinates in the basis come to the world by its vectors") {
    dice d{2};
    for (int i = 0; i < 1000; ++i) {
        const basis b = basis_from(glm::vec3(d.on_sphere()));
        CHECK(to_world(b, {1, 0, 0}) == b.u);
        CHECK(to_world(b, {0, 1, 0}) == b.v);
        CHECK(to_world(b, {0, 0, 1}) == b.w);
        const glm::vec3 p = d.in_cube();
        CHECK(glm::length(to_world(b, p)) == Approx(glm::length(p)));
    }
}
