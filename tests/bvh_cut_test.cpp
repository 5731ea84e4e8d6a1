// SPDX-License-Identifier: MIT
#include <lantern/bvh_cut.hpp>

#include "catch.hpp"

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <numeric>
#include <vector>

using lantern::aabb;
using lantern::bvh_cut;
using lantern::crowd;

namespace {

constexpr double any = std::numeric_limits<double>::infinity();

// Unit cubes at these places along the y axis, in this order.
struct row {
    std::vector<aabb> boxes;
    std::vector<std::uint32_t> indices;
    explicit row(std::initializer_list<float> places) : indices(places.size()) {
        for (const float y : places) boxes.push_back({{0, y, 0}, {1, y + 1, 1}});
        std::iota(indices.begin(), indices.end(), 0u);
    }
    crowd all() {
        aabb centers;
        for (const aabb& b : boxes) centers = enclose(centers, center(b));
        return {boxes, indices, centers};
    }
    std::vector<std::uint32_t> lower(const bvh_cut& cut) const {
        std::vector<std::uint32_t> first(indices.begin(), indices.begin() + cut.lower);
        std::sort(first.begin(), first.end());
        return first;
    }
};

}  // namespace

TEST_CASE("the middle looks at space, the median at numbers, the surface area at both") {
    row r{100, 2, 0, 4, 98, 96, 94, 3};  // four near 0, which is 0 to 4, four near 100
    const auto middle = r.all().cut_middle();
    CHECK(middle.axis == 1);
    CHECK(r.lower(middle) == std::vector<std::uint32_t>{1, 2, 3, 7});

    row lopsided{0, 1, 2, 3, 4, 5, 6, 100};
    CHECK(lopsided.lower(lopsided.all().cut_middle()).size() == 7);
    CHECK(lopsided.lower(lopsided.all().cut_median()) == std::vector<std::uint32_t>{0, 1, 2, 3});
    CHECK(lopsided.lower(lopsided.all().cut_by_surface_area(any)).size() == 7);
}

TEST_CASE("the surface area rule takes the least of all cuts, and none that does not save enough") {
    row r{0, 1, 2, 13, 14};
    // n cubes in a row have a surface of 4 n + 2: three and two of them
    const double cost = 14 * 3 + 10 * 2;
    const auto cut = r.all().cut_by_surface_area(any);
    CHECK(r.lower(cut) == std::vector<std::uint32_t>{0, 1, 2});
    CHECK(cut.axis == 1);
    CHECK(r.all().cut_by_surface_area(cost * 1.0001).lower == 3);
    CHECK(r.all().cut_by_surface_area(cost).lower == 0);
}

TEST_CASE("where all centers are equal, or nothing has a surface, only the median finds a cut") {
    row same{7, 7, 7, 7, 7};
    CHECK(same.all().cut_middle().lower == 0);
    CHECK(same.all().cut_by_surface_area(any).lower == 0);
    CHECK(same.lower(same.all().cut_median()) == std::vector<std::uint32_t>{0, 1});
    row points{0, 1, 2, 3};
    for (aabb& b : points.boxes) b.max = b.min;
    CHECK(points.all().cut_by_surface_area(any).lower == 0);
    CHECK(points.lower(points.all().cut_median()) == std::vector<std::uint32_t>{0, 1});
}
