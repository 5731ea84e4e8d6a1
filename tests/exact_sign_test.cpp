// SPDX-License-Identifier: MIT
#include <lantern/exact_sign.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <glm/vec3.hpp>

#include <cmath>
#include <limits>

using lantern::expansion;
using lantern::triple_product;

TEST_CASE("an expansion forgets nothing") {
    expansion<8> s;
    for (const double x : {1e300, 1.0, 0x1p-300, -1e300, -1.0}) s.add(x);
    CHECK(s.largest() == 0x1p-300);
    s.add(-0x1p-300);
    CHECK(s.largest() == 0);
}

TEST_CASE("an exact product of three keeps all 159 bits") {
    const double x = 1 + 0x1p-52;
    expansion<16> s;
    s.add_product(x, x, x);  // 1 + 3 e + 3 e² + e³
    for (const double term : {-1.0, -0x3p-52, -0x3p-104}) s.add(term);
    CHECK(s.largest() == 0x1p-156);
}

TEST_CASE("a line through an edge has a triple product of zero, and beside it the right sign") {
    dice d{.state = 1};
    const auto lattice = [&](int bits) {  // coordinates of so many bits
        const auto number = [&] { return std::ldexp(double(static_cast<int>(d.below(1u << bits)) - (1 << (bits - 1))), -bits); };
        const double x = number(), y = number(), z = number();
        return glm::dvec3(x, y, z);
    };
    int zeros = 0;
    for (int i = 0; i < 5000; ++i) {
        const glm::dvec3 o = lattice(10), a = lattice(10), b = lattice(10), p = 0.25 * a + 0.75 * b;  // on the edge, exactly
        const glm::dvec3 way = 3.0 * (p - o);
        REQUIRE(triple_product(way, o, a, b) == 0);
        ++zeros;
        // Moved by the least that double can say it is no longer on it.
        glm::dvec3 aside = way;
        const int k = static_cast<int>(d.below(3));
        aside[k] = std::nextafter(aside[k], 10.0);
        const glm::dvec3 n = glm::cross(a - o, b - o);
        const double got = triple_product(aside, o, a, b), expected = (aside[k] - way[k]) * n[k];
        REQUIRE((got > 0) == (expected > 0));
        REQUIRE((got < 0) == (expected < 0));
        REQUIRE(triple_product(aside, o, b, a) == -got);
    }
    CHECK(zeros == 5000);
}

TEST_CASE("of floats far apart in size the sign is right") {
    dice d{.state = 2};
    int small = 0;
    for (int i = 0; i < 5000; ++i) {
        const glm::dvec3 o(d.in_cube()), a(d.magnitude_between(-20, 3) * d.in_cube()), b(d.magnitude_between(-20, 3) * d.in_cube()),
            way(d.below(2) == 0 ? glm::dvec3(d.in_cube()) : glm::dvec3(glm::vec3(-o)));
        const wide3 p = widened(glm::vec3(a)) - widened(glm::vec3(o)), q = widened(glm::vec3(b)) - widened(glm::vec3(o));
        const wide3 terms = cross(p, q);
        const wide truth = dot(widened(glm::vec3(way)), terms);
        const wide doubt = static_cast<wide>(1e-25) * length(p) * length(q) * length(widened(glm::vec3(way)));
        if (magnitude(truth) <= doubt) continue;
        const double got = triple_product(way, o, a, b);
        REQUIRE(static_cast<double>(magnitude(static_cast<wide>(got) / truth - 1)) < 1e-6);
        small += static_cast<double>(magnitude(truth)) < 1e-17;
    }
    CHECK(small > 50);
}

TEST_CASE("what is not finite has no sign") {
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, inf, -inf}) {
        CHECK(std::isnan(triple_product({bad, 0, 1}, {0, 0, 0}, {1, 0, 1}, {0, 1, 1})));
        CHECK(std::isnan(triple_product({0, 0, 1}, {bad, 0, 0}, {1, 0, 1}, {0, 1, 1})));
        CHECK(std::isnan(triple_product({0, 0, 1}, {0, 0, 0}, {1, bad, 1}, {0, 1, 1})));
    }
}
