// SPDX-License-Identifier: MIT
#include <lantern/precise.hpp>

#include "catch.hpp"

#include <glm/vec3.hpp>

#include <limits>
#include <optional>

namespace mine {

/// Answers what it is told to, if the range allows.
struct oracle {
    double t;
    double point;
};
std::optional<lantern::precise::hit> intersect(const oracle& o, const lantern::precise::ray&, lantern::interval range) {
    if (!contains(range, o.t)) return std::nullopt;
    return lantern::precise::hit{o.t, glm::dvec3(o.point), {0, 1, 0}, 0};
}

}  // namespace mine

TEST_CASE("a surface that answers in double is a surface in float, rounded once") {
    STATIC_REQUIRE(lantern::precise_surface<mine::oracle>);
    STATIC_REQUIRE(lantern::precise_surface<mine::oracle, lantern::precise::timed_ray>);
    STATIC_REQUIRE(lantern::surface<mine::oracle>);
    STATIC_REQUIRE(lantern::surface<mine::oracle, lantern::timed_ray>);
    const mine::oracle o{1.0 / 3, 2.0 / 3};
    const auto h = intersect(o, lantern::ray{}, {});
    REQUIRE(h);
    CHECK(h->t == static_cast<float>(1.0 / 3));
    CHECK(h->point == glm::vec3(static_cast<float>(2.0 / 3)));
}

TEST_CASE("the range is compared with what is stored of t: its float") {
    const double just_beyond = 1 + 0x1p-30;  // rounds to 1
    CHECK(intersect(mine::oracle{just_beyond, 0}, lantern::ray{}, {0, 1}));
    CHECK_FALSE(intersect(mine::oracle{just_beyond, 0}, lantern::ray{}, {1, 2}));
    CHECK_FALSE(intersect(mine::oracle{1e-60, 0}, lantern::ray{}, {}));  // rounds to 0
    CHECK_FALSE(intersect(mine::oracle{1e60, 0}, lantern::ray{}, {}));   // rounds to infinity
    CHECK_FALSE(intersect(mine::oracle{std::numeric_limits<double>::quiet_NaN(), 0}, lantern::ray{}, {}));
}

TEST_CASE("widening changes no number") {
    const lantern::timed_ray r{{{0.1f, 0.2f, 0.3f}, {0.4f, 0.5f, 0.6f}}, 0.7f};
    const auto wide = lantern::precise::widen(r);
    CHECK(glm::vec3(wide.origin) == r.origin);
    CHECK(glm::vec3(wide.direction) == r.direction);
    CHECK(static_cast<float>(wide.time) == r.time);
    CHECK(lantern::precise::at(wide, 2).x == double(0.1f) + 2 * double(0.4f));
}
