// SPDX-License-Identifier: MIT
#include <lantern/wide_cut.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

using lantern::wide::divider;
using lantern::wide::extent;
using lantern::wide::item;

namespace {

item cube_at(glm::vec3 p, std::uint32_t index, float size = 1) { return {p, index, p + size, 0}; }

struct division {
    std::vector<item> items;
    extent all, low, high;
    std::uint32_t lower;

    explicit division(std::vector<item> given, bool by_length = false, std::uint32_t levels = 60) : items(std::move(given)) {
        for (const item& i : items) all.add(i);
        lower = divider::cut(items, all, by_length, levels, low, high);
    }
    std::vector<std::uint32_t> lower_indices() const {
        std::vector<std::uint32_t> found;
        for (std::size_t i = 0; i < lower; ++i) found.push_back(items[i].index);
        std::sort(found.begin(), found.end());
        return found;
    }
};

bool same(const extent& a, const extent& b) {
    for (const int i : {0, 1, 2, 4, 5, 6})
        if (a.box[i] != b.box[i] || a.centers[i] != b.centers[i]) return false;
    return true;
}

}  // namespace

TEST_CASE("two crowds are told apart along any axis, and each child's extent is that of its items") {
    dice d{.state = 3};
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<item> items;
        for (std::uint32_t i = 0; i < 200; ++i) {
            glm::vec3 p = d.in_cube();
            if (i % 2 == 1) p[axis] += 50;
            items.push_back(cube_at(p, i));
        }
        const division cut(items);
        REQUIRE(cut.lower == 100);
        const auto lower = cut.lower_indices();
        CHECK(std::all_of(lower.begin(), lower.end(), [](std::uint32_t i) { return i % 2 == 0; }));
        extent low, high;
        for (std::size_t i = 0; i < items.size(); ++i) (i < 100 ? low : high).add(cut.items[i]);
        CHECK(same(low, cut.low));
        CHECK(same(high, cut.high));
    }
}

TEST_CASE("what is at one place is one leaf if it is small, and halved if it is not") {
    std::vector<item> few(8, cube_at({1, 2, 3}, 0)), many(100, cube_at({1, 2, 3}, 0));
    for (std::uint32_t i = 0; i < 100; ++i) many[i].index = i;
    CHECK(division(few).lower == 0);
    const division halved(many);
    CHECK(halved.lower == 52);  // in whole packets of four
    CHECK(halved.lower_indices().back() == 51);
}

TEST_CASE("where the levels would run out it is halved, whatever that costs") {
    std::vector<item> items;
    for (std::uint32_t i = 0; i < 128; ++i) items.push_back(cube_at({i < 4 ? 0.0f : 1000.0f + float(i), 0, 0}, i));
    CHECK(division(items).lower == 4);
    CHECK(division(items, false, 6).lower == 64);
}

TEST_CASE("boxes at one place that are long along different axes are told apart by their lengths, if that is asked for") {
    std::vector<item> items;
    for (std::uint32_t i = 0; i < 60; ++i) {
        glm::vec3 half(0.1f);
        half[int(i % 3)] = 10;
        items.push_back({-half, i, half, 0});
    }
    CHECK(division(items).lower == 32);  // all centers are equal: halves
    const auto lower = division(items, true).lower_indices();
    REQUIRE((lower.size() == 20 || lower.size() == 40));
    std::vector<std::uint32_t> of_axis(3);
    for (const std::uint32_t i : lower) ++of_axis[i % 3];
    CHECK(std::all_of(of_axis.begin(), of_axis.end(), [](std::uint32_t n) { return n == 0 || n == 20; }));
}
