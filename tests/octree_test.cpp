// SPDX-License-Identifier: MIT
#include <lantern/octree.hpp>

#include <lantern/aabb.hpp>
#include <lantern/plane.hpp>
#include <lantern/sphere.hpp>

#include "accelerator_laws.hpp"
#include "catch.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

using lantern::aabb;
using lantern::octree;
using lantern::sphere;

static_assert(lantern::accelerator<octree> && lantern::accelerator<octree, lantern::timed_ray>);
static_assert(std::is_constructible_v<octree, std::vector<lantern::sphere>>);
static_assert(!std::is_constructible_v<octree, std::vector<lantern::plane>>, "what is infinite has no cell");

namespace {

const auto build = [](const std::vector<aabb>& boxes) { return octree(boxes); };

}  // namespace

TEST_CASE("octree: what brute force finds is found, whatever the scene and the ray") { accelerator_laws::agrees_with_every(build); }

TEST_CASE("octree: what moves is found at any time") { accelerator_laws::finds_what_moves(build); }

TEST_CASE("octree: a hundred thousand duplicates, concentric boxes or points in line do no harm") {
    accelerator_laws::survives_degenerate_input(build);
}

TEST_CASE("octree: surfaces that are not finite are left out and counted") { accelerator_laws::leaves_out_and_counts(build); }

TEST_CASE("octree: few surfaces are looked at, and none behind a hit") { accelerator_laws::looks_at_few(build, 12, 60); }

TEST_CASE("octree: the walk ends, whatever the ray") { accelerator_laws::ends_with_any_ray(build); }

TEST_CASE("octree: a teapot in a stadium is taken apart") {
    std::vector<aabb> parts{{{-1e4f, -1, -1e4f}, {1e4f, 0, 1e4f}}};
    for (int i = 0; i < 10000; ++i) {
        const glm::vec3 p = 1e-2f * glm::vec3(float(i % 25), float(i / 25 % 20), float(i / 500));
        parts.push_back({p, p + 5e-3f});
    }
    const octree tree(parts);
    std::uint32_t largest = 0;
    for (const auto& n : tree.nodes()) largest = std::max(largest, std::uint32_t{n.size});
    CHECK(largest <= 64);
}

TEST_CASE("octree: memory is bounded, and so is the depth") {
    std::vector<aabb> onion;
    for (int i = 0; i < 20000; ++i) onion.push_back({glm::vec3(-float(i)), glm::vec3(float(i))});
    CHECK(octree(onion).indices().size() <= 32 * onion.size());
    CHECK(octree(onion, {.max_entries_per_surface = 1}).indices().size() == onion.size());
    std::vector<aabb> points;
    for (int i = 0; i < 4096; ++i) points.push_back({glm::vec3(float(i)), glm::vec3(float(i))});
    for (const std::uint32_t cap : {1u, 2u, 5u}) {
        const octree tree(points, {.max_depth = cap});
        CHECK(tree.nodes().size() <= std::size_t{1} << (3 * cap + 1));
    }
}

TEST_CASE("octree: options that cannot be are refused") {
    const std::vector<aabb> boxes(3);
    CHECK_THROWS_WITH(octree(boxes, {.max_depth = 65}), containing("max_depth is 65"));
    CHECK_THROWS_WITH(octree(boxes, {.max_entries_per_surface = 0}), containing("max_entries_per_surface"));
}

TEST_CASE("octree: a scene too long for float to add up its sides loses nothing at its end") {
    const std::vector<lantern::sphere> spheres{{{0, 0, 0}, 1}, {{1e20f, 1e20f, -1e20f}, 1}, {{5, 5, 5}, 1}, {{-5, 5, 5}, 1}, {{5, -5, 5}, 1},
                                               {{5, 5, 8}, 1}};
    const octree tree(spheres, {.leaf_size = 1});
    const auto h = closest(tree, spheres, lantern::ray{{5, 5, 20}, {0, 0, -1}});
    REQUIRE(h);
    CHECK(h->index == 5);
}
