// SPDX-License-Identifier: MIT
#include <lantern/object.hpp>

#include <lantern/closest.hpp>
#include <lantern/moving.hpp>
#include <lantern/plane.hpp>
#include <lantern/sphere.hpp>

#include "catch.hpp"

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

using lantern::interval;
using lantern::object;
using lantern::ray;
using lantern::sphere;

namespace mine {

/// A surface of a user's own, which knows float only.
struct wall {
    float z = 0;
};

std::optional<lantern::hit> intersect(const wall& w, const ray& r, interval range) {
    const float t = (w.z - r.origin.z) / r.direction.z;
    if (!contains(range, t)) return std::nullopt;
    return lantern::hit{t, at(r, t), {0, 0, 1}, 0};
}

struct paint {
    float grey = 0;
};

void validate(const paint& p) {
    if (!(p.grey >= 0 && p.grey <= 1)) throw std::invalid_argument("paint: grey");
}

}  // namespace mine

static_assert(lantern::surface<object<sphere, int>> && lantern::bounded<object<sphere, int>>);
static_assert(lantern::surface<object<lantern::plane, int>> && !lantern::bounded<object<lantern::plane, int>>);
static_assert(lantern::surface<object<mine::wall, int>> && !lantern::bounded<object<mine::wall, int>>);
static_assert(lantern::surface<object<mine::wall, int>, lantern::timed_ray>);
static_assert(!lantern::surface<object<lantern::moving<sphere>, int>>);
static_assert(lantern::surface<object<lantern::moving<sphere>, int>, lantern::timed_ray>);
static_assert(lantern::bounded<object<lantern::moving<sphere>, int>>);

TEST_CASE("an object is hit where its shape is hit, and is bounded as it is") {
    const object thing{sphere{{0, 0, -5}, 2}, std::string("red")};
    const ray r{{0.5f, 0.25f, 0}, {0, 0, -1}};
    const auto h = intersect(thing, r, interval{}), bare = intersect(thing.shape, r, interval{});
    REQUIRE(h);
    CHECK(h->t == Approx(bare->t));
    CHECK(glm::length(h->point - bare->point) <= 1e-6f);
    CHECK(glm::length(h->normal - bare->normal) <= 1e-6f);
    CHECK(bounds(thing).min == bounds(thing.shape).min);
    CHECK_FALSE(intersect(thing, r, interval{0, 1}));
}

TEST_CASE("a shape of the user's own becomes an object like any other") {
    const std::vector<object<mine::wall, mine::paint>> things{{{-3}, {0.5f}}, {{-2}, {0.25f}}};
    const auto nearest = closest(lantern::every{2}, things, ray{{0, 0, 0}, {0, 0, -1}});
    REQUIRE(nearest);
    CHECK(nearest->t == 2);
    CHECK(things[nearest->index].material.grey == 0.25f);
}

TEST_CASE("what is wrong with the shape or the material is found through the object") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    CHECK_THROWS_WITH(validate(object{sphere{{0, 0, 0}, nan}, mine::paint{}}), containing("sphere: radius"));
    CHECK_THROWS_WITH(validate(object{sphere{}, mine::paint{2}}), containing("paint: grey"));
    CHECK_NOTHROW(validate(object{sphere{}, 5}));
}
