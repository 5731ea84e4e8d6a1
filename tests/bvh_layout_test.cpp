// SPDX-License-Identifier: MIT
#include <lantern/bvh_layout.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <cstdint>
#include <vector>

using lantern::aabb;
using lantern::bvh_layout;
using lantern::split;

TEST_CASE("parents come before children, and what is below a node is one stretch of the indices") {
    dice d{.state = 1};
    std::vector<aabb> boxes;
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 p = d.in_cube();
        boxes.push_back({p, p + d.between(0, i % 2 == 0 ? 0.1 : 3)});  // some large, so that it pays to reinsert them
    }
    for (const split rule : {split::middle, split::median, split::surface_area, split::bottom_up})
        for (const std::uint32_t cap : {48u, 9u, 3u, 0u}) {
            bvh_layout layout(boxes, {.rule = rule, .max_depth = cap});
            const auto& nodes = layout.nodes();
            std::vector<std::uint32_t> begin(nodes.size()), end(nodes.size());
            for (std::uint32_t i = static_cast<std::uint32_t>(nodes.size()); i-- > 0;) {
                const auto& n = nodes[i];
                if (n.size == 0) {
                    REQUIRE((n.first > i && n.first + 1 < nodes.size()));
                    REQUIRE(end[n.first] == begin[n.first + 1]);
                }
                begin[i] = n.size > 0 ? n.first : begin[n.first];
                end[i] = n.size > 0 ? n.first + n.size : end[n.first + 1];
                aabb content;
                for (std::uint32_t k = begin[i]; k < end[i]; ++k) content = enclose(content, boxes[layout.indices()[k]]);
                REQUIRE((content.min == n.volume.min && content.max == n.volume.max));
            }
            REQUIRE((begin[0] == 0 && end[0] == 1000));
        }
}

TEST_CASE("the surface area rule expects fewer tests than halving does, and so does joining") {
    dice d{.state = 2};
    std::vector<aabb> boxes;  // crowds of different sizes
    for (int i = 0; i < 4000; ++i) {
        const float size = i % 4 == 0 ? 1.0f : 0.02f;
        const glm::vec3 p = glm::vec3(float(i % 5), float(i % 3), float(i % 2)) + d.in_cube(size);
        boxes.push_back({p, p + 0.1f * size});
    }
    const auto cost = [&](split rule) {
        bvh_layout layout(boxes, {.rule = rule, .leaf_size = 1});
        double sum = 0;
        for (const auto& n : layout.nodes()) sum += surface_area(n.volume) * (n.size > 0 ? n.size : 1);
        return sum / surface_area(layout.nodes()[0].volume);
    };
    const double middle = cost(split::middle), median = cost(split::median), area = cost(split::surface_area),
                 bottom_up = cost(split::bottom_up);
    INFO("middle " << middle << ", median " << median << ", surface area " << area << ", bottom up " << bottom_up);
    CHECK(area < median);
    CHECK(bottom_up < median);
}

TEST_CASE("the surface area rule makes leaves smaller where a look at two boxes costs less than the tests that it saves") {
    const auto leaves = [](const std::vector<aabb>& boxes, split rule) {
        bvh_layout layout(boxes, {.rule = rule});
        std::vector<std::uint32_t> sizes;
        for (const auto& n : layout.nodes())
            if (n.size > 0) sizes.push_back(n.size);
        return sizes;
    };
    const auto cube = [](float x, float size) { return aabb{{x, 0, 0}, {x + size, size, size}}; };
    const std::vector<aabb> apart{cube(0, 1), cube(100, 1), cube(200, 1)}, together{cube(0, 1), cube(0.125f, 1), cube(0.25f, 1)};
    const std::vector<aabb> two_and_two{cube(0, 1), cube(0.125f, 1), cube(100, 1), cube(100.125f, 1)};
    CHECK(leaves(apart, split::surface_area) == std::vector<std::uint32_t>{1, 1, 1});
    CHECK(leaves(together, split::surface_area) == std::vector<std::uint32_t>{3});
    CHECK(leaves(two_and_two, split::surface_area) == std::vector<std::uint32_t>{2, 2});
    CHECK(leaves(apart, split::middle) == std::vector<std::uint32_t>{3});
    CHECK(leaves(apart, split::median) == std::vector<std::uint32_t>{3});
    CHECK(leaves(apart, split::bottom_up) == std::vector<std::uint32_t>{3});
}

TEST_CASE("needles are put where they lie better, within the depth, and crowds of small boxes stay as they were divided") {
    dice d{.state = 3};
    std::vector<aabb> needles, crowd;
    for (int i = 0; i < 3000; ++i) {
        const glm::vec3 p = d.in_cube(), along = d.in_cube();
        needles.push_back({glm::min(p, p + along), glm::max(p, p + along)});
        crowd.push_back({p, p + 0.02f});
    }
    const auto cost = [](const std::vector<aabb>& boxes, const lantern::bvh_options& how) {
        bvh_layout layout(boxes, how);
        double sum = 0;
        std::vector<std::uint32_t> level(layout.nodes().size());
        for (std::size_t i = 0; i < layout.nodes().size(); ++i) {
            const auto& n = layout.nodes()[i];
            sum += surface_area(n.volume) * (n.size > 0 ? n.size : 1);
            REQUIRE(level[i] <= how.max_depth);
            if (n.size == 0) level[n.first] = level[n.first + 1] = level[i] + 1;
        }
        REQUIRE(layout.indices().size() == boxes.size());
        return sum;
    };
    const double as_divided = cost(needles, {.reinsertions = 0}), once = cost(needles, {.reinsertions = 1}), four_times = cost(needles, {});
    INFO(as_divided << ", after a round " << once << ", after four " << four_times);
    CHECK(once < 0.95 * as_divided);
    CHECK(four_times < 0.97 * once);
    CHECK(cost(needles, {.max_depth = 13}) <= 1.2 * as_divided);
    CHECK(cost(crowd, {}) == Approx(cost(crowd, {.reinsertions = 0})).epsilon(0.001));
}

TEST_CASE("nothing has no nodes") {
    bvh_layout layout({}, {});
    CHECK(layout.nodes().empty());
    CHECK(layout.indices().empty());
}
