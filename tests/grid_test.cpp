// SPDX-License-Identifier: MIT
#include <lantern/grid.hpp>

#include <lantern/aabb.hpp>
#include <lantern/plane.hpp>
#include <lantern/sphere.hpp>

#include "accelerator_laws.hpp"
#include "catch.hpp"

#include <type_traits>
#include <vector>

using lantern::aabb;
using lantern::grid;

static_assert(lantern::accelerator<grid> && lantern::accelerator<grid, lantern::timed_ray>);
static_assert(std::is_constructible_v<grid, std::vector<lantern::sphere>>);
static_assert(!std::is_constructible_v<grid, std::vector<lantern::plane>>, "what is infinite has no cell");

namespace {

const auto build = [](const std::vector<aabb>& boxes) { return grid(boxes); };

}  // namespace

TEST_CASE("grid: what brute force finds is found, whatever the scene and the ray") { accelerator_laws::agrees_with_every(build); }

TEST_CASE("grid: what moves is found at any time") { accelerator_laws::finds_what_moves(build); }

TEST_CASE("grid: a hundred thousand duplicates, concentric boxes or points in line do no harm") {
    accelerator_laws::survives_degenerate_input(build);
}

TEST_CASE("grid: surfaces that are not finite are left out and counted") { accelerator_laws::leaves_out_and_counts(build); }

TEST_CASE("grid: few surfaces are looked at, and none behind a hit") { accelerator_laws::looks_at_few(build, 12, 60); }

TEST_CASE("grid: the walk ends, whatever the ray") { accelerator_laws::ends_with_any_ray(build); }

TEST_CASE("grid: cells are cubic as far as may be: in space, on a terrain, in a row") {
    std::vector<aabb> space, terrain, row;
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 p(float(i % 10), float(i / 10 % 10), float(i / 100)), q(float(i % 40), float(i / 40), 0);
        space.push_back({p, p});
        terrain.push_back({q, q});
        row.push_back({{float(i), 0, 0}, {float(i), 0, 0}});
    }
    CHECK(grid(space).cells() == glm::ivec3(30));
    CHECK(grid(terrain).cells().z == 1);
    CHECK(grid(terrain).cells().x > 110);
    CHECK(grid(row).cells() == glm::ivec3(3000, 1, 1));
    CHECK(grid(row, {.max_cells = 100}).cells().x <= 100);
}

TEST_CASE("grid: memory is bounded, however large the surfaces are") {
    const std::vector<aabb> large(20000, aabb{{0, 0, 0}, {1, 1, 1}});
    CHECK(grid(large).entries().size() <= 64 * large.size());
    CHECK(grid(large, {.max_entries_per_surface = 1}).entries().size() == large.size());
}

TEST_CASE("grid: options that cannot be are refused") {
    const std::vector<aabb> boxes(3);
    CHECK_THROWS_WITH(grid(boxes, {.density = 0}), containing("density"));
    CHECK_THROWS_WITH(grid(boxes, {.max_cells = 0}), containing("max_cells"));
    CHECK_THROWS_WITH(grid(boxes, {.max_entries_per_surface = 0}), containing("max_entries_per_surface"));
}
