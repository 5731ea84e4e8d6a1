// SPDX-License-Identifier: MIT
#include <lantern/bvh_quartets.hpp>

#include <lantern/aabb.hpp>
#include <lantern/bvh_layout.hpp>
#include <lantern/closest.hpp>
#include <lantern/interval.hpp>
#include <lantern/ray.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

using lantern::aabb;
using lantern::bvh_layout;
using lantern::bvh_quartets;
using lantern::interval;
using lantern::ray;

// That closest hits are found is tested with bvh.hpp, which goes by it. Here: what is offered, and in which order.

namespace {

struct walk {
    std::vector<std::uint32_t> offered;
    lantern::probe counter;
};

walk walk_through(bvh_layout& layout, const ray& r, interval range = {}, std::uint32_t until = ~0u) {
    walk w;
    const bvh_quartets fours(layout.nodes());
    fours.traverse(r, range, layout.indices(), [&](std::uint32_t i, interval rest) -> interval {
        w.offered.push_back(i);
        return i == until ? interval{0, 0} : rest;
    }, w.counter);
    return w;
}

}  // namespace

TEST_CASE("along a row of any length every leaf is offered once, the nearest first, from either end") {
    for (const std::uint32_t count : {1u, 2u, 3u, 4u, 5u, 6u, 7u, 16u, 61u, 1000u}) {
        std::vector<aabb> row;
        for (std::uint32_t i = 0; i < count; ++i) row.push_back({{3.0f * float(i), -1, -1}, {3.0f * float(i) + 1, 1, 1}});
        for (const lantern::split rule : {lantern::split::surface_area, lantern::split::median, lantern::split::bottom_up}) {
            bvh_layout layout(row, {.rule = rule, .leaf_size = 1});
            std::vector<std::uint32_t> expected(count);
            std::iota(expected.begin(), expected.end(), 0u);
            const walk there = walk_through(layout, {{-5, 0, 0}, {1, 0, 0}});
            REQUIRE(there.offered == expected);
            REQUIRE(there.counter.offers == count);
            const walk back = walk_through(layout, {{1e4f, 0, 0}, {-1, 0, 0}});
            std::reverse(expected.begin(), expected.end());
            REQUIRE(back.offered == expected);
            REQUIRE(walk_through(layout, {{-5, 3, 0}, {1, 0, 0}}).offered.empty());
        }
    }
}

namespace {

// Takes any order; writes down what it gets, and ends with the first, or never.
struct any_order {
    using takes_any_order = void;
    std::vector<std::uint32_t>& offered;
    bool ends;
    interval operator()(std::uint32_t i, interval rest) const {
        offered.push_back(i);
        return ends ? interval{0, 0} : rest;
    }
};

}  // namespace

TEST_CASE("an offer that takes any order gets what is farthest first, and everything if it does not end") {
    static_assert(lantern::takes_any_order<any_order> && lantern::takes_any_order<any_order&> && !lantern::takes_any_order<lantern::probe>);
    std::vector<aabb> row;
    for (int i = 0; i < 1000; ++i) row.push_back({{3.0f * float(i), -1, -1}, {3.0f * float(i) + 1, 1, 1}});
    bvh_layout layout(row, {.leaf_size = 1});
    const bvh_quartets fours(layout.nodes());
    for (const bool there : {true, false})
        for (const bool ends : {false, true}) {
            std::vector<std::uint32_t> offered;
            const ray r = there ? ray{{-5, 0, 0}, {1, 0, 0}} : ray{{1e4f, 0, 0}, {-1, 0, 0}};
            fours.traverse(r, {}, layout.indices(), any_order{offered, ends}, lantern::no_probe{});
            CHECK(offered.front() == (there ? 999 : 0));
            std::sort(offered.begin(), offered.end());
            std::vector<std::uint32_t> expected(ends ? 1 : 1000, there ? 999 : 0);
            if (!ends) std::iota(expected.begin(), expected.end(), 0u);
            CHECK(offered == expected);
        }
}

TEST_CASE("each box is looked at once, and what lies beyond the range is not offered") {
    std::vector<aabb> row;
    for (int i = 0; i < 256; ++i) row.push_back({{3.0f * float(i), -1, -1}, {3.0f * float(i) + 1, 1, 1}});
    bvh_layout layout(row, {.leaf_size = 1});
    CHECK(walk_through(layout, {{-5, 0, 0}, {1, 0, 0}}).counter.nodes <= 1 + 256 + 256 / 2);  // of 255 inner ones a third is left out
    CHECK(walk_through(layout, {{-5, 0, 0}, {1, 0, 0}}, {0, 12}).offered == std::vector<std::uint32_t>{0, 1, 2});
    const walk first = walk_through(layout, {{-5, 0, 0}, {1, 0, 0}}, {}, 0);
    CHECK(first.offered == std::vector<std::uint32_t>{0});
    CHECK(first.counter.nodes <= 1 + 4 * 4);
}

TEST_CASE("what lies beyond a hit is neither offered nor looked at, and what waits there is let go") {
    std::vector<aabb> row;
    for (int i = 0; i < 1024; ++i) row.push_back({{3.0f * float(i), -1, -1}, {3.0f * float(i) + 1, 1, 1}});
    bvh_layout layout(row, {.leaf_size = 1});
    const bvh_quartets fours(layout.nodes());
    for (const std::uint32_t hit : {0u, 9u, 500u}) {
        lantern::probe counter;
        std::vector<std::uint32_t> offered;
        fours.traverse(ray{{-1, 0, 0}, {1, 0, 0}}, {}, layout.indices(), [&](std::uint32_t i, interval rest) -> interval {
            offered.push_back(i);
            return i == hit ? interval{rest.min, 1 + row[i].min.x} : rest;
        }, counter);
        CHECK(offered.size() == hit + 1);
        CHECK(counter.nodes <= hit + hit / 2 + 1 + 6 * 4);
    }
    lantern::probe counter;
    std::uint32_t offers = 0;  // what remains is empty, though it ends far away
    fours.traverse(ray{{-1, 0, 0}, {1, 0, 0}}, {}, layout.indices(), [&](std::uint32_t, interval) -> interval { return ++offers, interval{9000, 9000}; }, counter);
    CHECK(offers == 1);
}

TEST_CASE("without indices, places in the order of the leaves are offered") {
    std::vector<aabb> row;
    for (int i = 0; i < 50; ++i) row.push_back({{3.0f * float(i * 37 % 50), -1, -1}, {3.0f * float(i * 37 % 50) + 1, 1, 1}});
    bvh_layout layout(row, {});
    std::vector<std::uint32_t> by_index, by_place;
    const bvh_quartets fours(layout.nodes());
    const auto note = [](std::vector<std::uint32_t>& list) { return [&](std::uint32_t i, interval rest) { return list.push_back(i), rest; }; };
    fours.traverse(ray{{-5, 0, 0}, {1, 0, 0}}, {}, layout.indices(), note(by_index), lantern::no_probe{});
    fours.traverse(ray{{-5, 0, 0}, {1, 0, 0}}, {}, {}, note(by_place), lantern::no_probe{});
    REQUIRE((by_index.size() == 50 && by_place.size() == 50));
    for (std::size_t k = 0; k < 50; ++k) REQUIRE(layout.indices()[by_place[k]] == by_index[k]);
}

TEST_CASE("a slot that is not used does not count") {
    std::vector<aabb> row;
    for (int i = 0; i < 3; ++i) row.push_back({{3.0f * float(i), -1, -1}, {3.0f * float(i) + 1, 1, 1}});
    bvh_layout layout(row, {.leaf_size = 1});
    CHECK(walk_through(layout, {{-5, 0, 0}, {1, 0, 0}}).counter.nodes == 4);  // the root's box, and three
}

TEST_CASE("nothing at all, and rays that are none") {
    bvh_layout layout({}, {});
    CHECK(layout.indices().empty());
    const std::vector<aabb> two{{{0, 0, 0}, {1, 1, 1}}, {{5, 0, 0}, {6, 1, 1}}};
    bvh_layout of_two(two, {.leaf_size = 1});
    const float bad = std::numeric_limits<float>::quiet_NaN();
    for (const float x : {bad, lantern::infinity, 0.0f})
        for (const float y : {bad, lantern::infinity, 0.0f}) CHECK(walk_through(of_two, {{x, x, x}, {y, y, y}}).offered.size() <= 6);
}
