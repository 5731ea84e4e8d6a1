// SPDX-License-Identifier: MIT
#include <lantern/closest.hpp>

#include <lantern/moving.hpp>
#include <lantern/plane.hpp>
#include <lantern/sphere.hpp>

#include "catch.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

using lantern::every;
using lantern::interval;
using lantern::plane;
using lantern::ray;
using lantern::sphere;

namespace mine {

/// Offers in an order of its own and knows no probe.
struct ordered {
    std::vector<std::uint32_t> order;
    template <class Offer>
    void traverse(const ray&, interval range, Offer&& offer) const {
        for (const std::uint32_t i : order) {
            if (empty(range)) return;
            range = offer(i, range);
        }
    }
};
static_assert(lantern::accelerator<ordered>);

/// Breaks the rules: answers where it was not asked, or with NaN.
struct liar {
    float t;
};
std::optional<lantern::hit> intersect(const liar& l, const ray&, interval) { return lantern::hit{.t = l.t}; }

}  // namespace mine

namespace {

const ray forward{{0, 0, 0}, {0, 0, -1}};

std::vector<sphere> row() { return {{{0, 0, -9}, 1}, {{0, 0, -3}, 1}, {{0, 0, -6}, 1}, {{0, 0, 5}, 1}}; }

}  // namespace

TEST_CASE("the closest of several surfaces is found, and which one it is") {
    const auto spheres = row();
    const auto h = closest(every{4}, spheres, forward);
    REQUIRE(h);
    CHECK(h->index == 1);
    CHECK(h->t == 2);
    CHECK(h->normal == glm::vec3(0, 0, 1));
}

TEST_CASE("the order in which a structure offers changes nothing") {
    const auto spheres = row();
    std::vector<std::uint32_t> order{0, 1, 2, 3};
    do {
        const auto h = closest(mine::ordered{order}, spheres, forward);
        REQUIRE(h);
        REQUIRE(h->index == 1);
    } while (std::next_permutation(order.begin(), order.end()));
}

TEST_CASE("of surfaces at the same t the smaller index is taken, whatever the order") {
    const std::vector<sphere> same(5, sphere{{0, 0, -3}, 1});
    for (const auto& order : {std::vector<std::uint32_t>{0, 1, 2, 3, 4}, {4, 3, 2, 1, 0}, {3, 0, 4, 1, 2}})
        CHECK(closest(mine::ordered{order}, same, forward)->index == 0);
    CHECK(closest(mine::ordered{{4, 2, 3}}, same, forward)->index == 2);
}

TEST_CASE("the range limits what counts: open where it begins, closed where it ends") {
    const auto spheres = row();  // front at t = 2, back at t = 4
    CHECK(closest(every{4}, spheres, forward, {0, 2})->t == 2);
    CHECK_FALSE(closest(every{4}, spheres, forward, {0, 1.9f}));
    CHECK(closest(every{4}, spheres, forward, {2, 100})->t == 4);
    CHECK_FALSE(closest(every{4}, spheres, forward, {3, 1}));
}

TEST_CASE("nothing in the scene is no hit") {
    const std::vector<sphere> none;
    CHECK_FALSE(closest(every{0}, none, forward));
    CHECK_FALSE(occluded(every{0}, none, forward, {}));
}

TEST_CASE("a shadow ray stops at the first surface that it finds") {
    const auto spheres = row();
    lantern::probe counter;
    CHECK(occluded(every{4}, spheres, forward, {0, 100}, counter));
    CHECK(counter.offers == 1);
    CHECK_FALSE(occluded(every{4}, spheres, forward, {0, 1}));
    CHECK(occluded(every{4}, spheres, forward, {0, 2}));
}

TEST_CASE("a probe counts, also for a structure that knows no probe") {
    const auto spheres = row();
    lantern::probe brute, own;
    (void)closest(every{4}, spheres, forward, {}, brute);
    (void)closest(mine::ordered{{1, 0}}, spheres, forward, {}, own);
    CHECK(brute.offers == 4);
    CHECK(own.offers == 2);
    CHECK(own.nodes == 0);
}

TEST_CASE("brute force takes what has no bounds") {
    const std::vector<plane> floor{{{0, -1, 0}, {0, 1, 0}}};
    const auto h = closest(every{1}, floor, ray{{0, 0, 0}, {0, -2, 0}});
    REQUIRE(h);
    CHECK(h->t == 0.5f);
}

TEST_CASE("a ray with a time meets a moving surface where it is then") {
    const std::vector moving{lantern::moving{sphere{{0, 0, -3}, 1}, {10, 0, 0}}};
    CHECK(closest(every{1}, moving, lantern::timed_ray{forward, 0}));
    CHECK_FALSE(closest(every{1}, moving, lantern::timed_ray{forward, 1}));
    CHECK(occluded(every{1}, moving, lantern::timed_ray{{{10, 0, 0}, {0, 0, -1}}, 1}, {}));
}

TEST_CASE("an answer outside of the range, or NaN, hides nothing") {
    constexpr float bad = std::numeric_limits<float>::quiet_NaN();
    const std::vector<mine::liar> liars{{bad}, {-1}, {0}, {7}, {lantern::infinity}};
    const auto h = closest(every{5}, liars, forward, {0, 10});
    REQUIRE(h);
    CHECK(h->index == 3);
    CHECK_FALSE(occluded(every{3}, liars, forward, {0, 10}));
    CHECK_FALSE(closest(every{5}, liars, forward, {0, 5}));
}
