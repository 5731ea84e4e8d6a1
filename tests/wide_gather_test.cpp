// SPDX-License-Identifier: MIT
#include <lantern/wide_gather.hpp>

#include <lantern/aabb.hpp>
#include <lantern/triangle.hpp>
#include <lantern/wide_build.hpp>
#include <lantern/wide_split.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

using lantern::aabb;
using lantern::triangle;

TEST_CASE("triangles are gathered in their order, without those that are not finite, by any number of threads") {
    dice d{.state = 6};
    std::vector<triangle> all;
    for (int i = 0; i < 100'000; ++i) {
        const glm::vec3 a = d.in_cube(), b = d.in_cube(), c = d.in_cube();
        all.push_back({a, b, i % 7 == 0 ? a + 1e-3f * c : c});  // some needles
    }
    for (const std::size_t i : {0u, 5u, 16'383u, 16'384u, 50'000u, 99'999u}) all[i].b.y = std::numeric_limits<float>::infinity();
    lantern::wide::needles expected;
    std::vector<std::uint32_t> indices;
    std::vector<lantern::wide::item> boxes;
    for (std::uint32_t i = 0; i < all.size(); ++i) {
        const aabb box = bounds(all[i]);
        if (!empty(box)) boxes.push_back({box.min, i, box.max, 0}), expected.add(all[i], boxes.back());
    }
    for (const unsigned threads : {1u, 3u, 50u}) {
        lantern::wide::helpers others(threads);
        lantern::wide::gathered got(all.begin(), static_cast<std::uint32_t>(all.size()), others);
        REQUIRE(got.items.size() == boxes.size());
        bool same = true;
        float reach = 0;
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            same = same && got.items[i].index == boxes[i].index && got.items[i].lower == boxes[i].lower && got.items[i].upper == boxes[i].upper;
            for (int axis = 0; axis < 3; ++axis) reach = std::max({reach, -boxes[i].lower[axis], boxes[i].upper[axis]});
        }
        CHECK(same);
        CHECK(got.reach == reach);
        lantern::wide::item_list copy(boxes.begin(), boxes.end());
        CHECK(got.thin.count(got.items) == lantern::wide::needles(expected).count(copy));
    }
    lantern::wide::helpers none(1);
    CHECK(lantern::wide::gathered(all.begin(), 0, none).items.empty());
}
