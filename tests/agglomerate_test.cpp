// SPDX-License-Identifier: MIT
#include <lantern/agglomerate.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

using lantern::aabb;
using lantern::agglomerate;
using lantern::cluster;

namespace {

std::vector<std::uint32_t> all_of(const std::vector<aabb>& boxes) {
    std::vector<std::uint32_t> indices(boxes.size());
    std::iota(indices.begin(), indices.end(), 0u);
    return indices;
}

std::vector<std::uint32_t> sorted_members(const std::vector<cluster>& clusters, const cluster& c) {
    std::vector<std::uint32_t> members;
    collect(clusters, c, members);
    std::sort(members.begin(), members.end());
    return members;
}

}  // namespace

TEST_CASE("every box is in one cluster after the other, up to the one of all") {
    dice d{.state = 1};
    for (const std::uint32_t count : {1u, 2u, 3u, 100u, 1777u}) {
        std::vector<aabb> boxes;
        for (std::uint32_t i = 0; i < count; ++i) {
            const glm::vec3 p = d.in_cube();
            boxes.push_back({p, p + 0.1f});
        }
        const auto clusters = agglomerate(boxes, all_of(boxes));
        REQUIRE(clusters.size() == 2 * count - 1);
        REQUIRE(clusters.back().size == count);
        REQUIRE(sorted_members(clusters, clusters.back()) == all_of(boxes));
        for (const cluster& c : clusters) {
            if (c.height == 0) continue;
            const cluster &a = clusters[c.left], &b = clusters[c.right];
            REQUIRE(c.size == a.size + b.size);
            REQUIRE(c.height == 1 + std::max(a.height, b.height));
            REQUIRE(c.box.min == enclose(a.box, b.box).min);
            REQUIRE(c.box.max == enclose(a.box, b.box).max);
        }
    }
}

TEST_CASE("only what is asked for is joined") {
    const std::vector<aabb> boxes(10, aabb{{0, 0, 0}, {1, 1, 1}});
    const auto clusters = agglomerate(boxes, {2, 5, 7});
    CHECK(sorted_members(clusters, clusters.back()) == std::vector<std::uint32_t>{2, 5, 7});
}

TEST_CASE("two crowds are joined last") {
    dice d{.state = 2};
    std::vector<aabb> boxes;
    for (int i = 0; i < 200; ++i) {
        const glm::vec3 p = d.in_cube() + (i % 2 == 0 ? glm::vec3(0) : glm::vec3(100, 100, 0));
        boxes.push_back({p, p + 0.1f});
    }
    const auto clusters = agglomerate(boxes, all_of(boxes));
    const auto left = sorted_members(clusters, clusters[clusters.back().left]);
    CHECK(left.size() == 100);
    CHECK(std::all_of(left.begin(), left.end(), [&](std::uint32_t i) { return i % 2 == left[0] % 2; }));
}

TEST_CASE("duplicates pair off, and concentric boxes do not make a chain") {
    const std::vector<aabb> same(1 << 14, aabb{{0, 0, 0}, {1, 1, 1}});
    CHECK(agglomerate(same, all_of(same)).back().height == 14);
    std::vector<aabb> onion;
    for (int i = 0; i < 1 << 14; ++i) onion.push_back({glm::vec3(-float(i)), glm::vec3(float(i))});
    CHECK(agglomerate(onion, all_of(onion)).back().height < 400);
}

TEST_CASE("the curve begins in the lower corner and ends in the upper one, and near points are near on it") {
    const aabb box{{-1, -1, -1}, {1, 1, 1}};
    CHECK(lantern::morton_code({-1, -1, -1}, box) == 0);
    CHECK(lantern::morton_code({1, 1, 1}, box) == (std::uint64_t{1} << 63) - 1);
    CHECK(lantern::morton_code({1, -1, -1}, box) < lantern::morton_code({-1, 1, -1}, box));
    CHECK(lantern::morton_code({-1, 1, -1}, box) < lantern::morton_code({-1, -1, 1}, box));
    CHECK(lantern::morton_code({5, 5, 5}, {{5, 5, 5}, {5, 5, 5}}) == 0);
}
