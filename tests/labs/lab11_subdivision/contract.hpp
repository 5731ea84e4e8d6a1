// SPDX-License-Identifier: MIT
#pragma once
// What lab 11 asks for.

#include <contract.hpp>

#include <lantern/aabb.hpp>
#include <lantern/interval.hpp>
#include <lantern/ray.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace contract::lab11 {

using lantern::aabb;
using lantern::interval;
using lantern::ray;

/// As the student's types of these names.
struct lattice {
    aabb box;
    glm::ivec3 count;
};
struct cell_range {
    glm::ivec3 first, last;
};
struct stretch {
    double enter, leave;
};
struct octree_node {
    std::uint32_t children, first, size;
};
struct octree {
    aabb cell;
    std::vector<octree_node> nodes;
    std::vector<std::uint32_t> entries;
};
struct octant_part {
    std::uint32_t octant;
    stretch part;
};
struct cut {
    std::uint32_t axis;
    float at;
};
struct costs {
    float step, test, empty_bonus;
};
struct kd_node {
    std::uint32_t axis;
    float at;
    std::uint32_t first, size;
};
struct kd_tree {
    aabb box;
    std::vector<kd_node> nodes;
};
enum class structure : std::uint8_t { undecided, grid, octree, kd_tree, bvh };

/// The suite's, and run there: ray number r visits a cell; surface i is offered; surface i is offered to ray number r.
using visitor = std::function<interval(std::uint32_t r, std::uint32_t cell, stretch part)>;
using offer = std::function<interval(std::uint32_t i, interval range)>;
using offer_to_ray = std::function<interval(std::uint32_t r, std::uint32_t i, interval range)>;

inline constexpr function<"resolution", glm::ivec3(aabb box, std::uint32_t surfaces, float cells_per_surface)> resolution;
inline constexpr function<"cells_of", cell_range(lattice g, aabb box)> cells_of;

/// One ray after the other. The answer means nothing.
inline constexpr function<"walk_grid", bool(lattice g, std::span<const ray> rays, interval range, visitor visit)> walk_grid;
inline constexpr function<"walk_kd_tree", bool(kd_tree tree, std::span<const ray> rays, interval range, visitor visit)> walk_kd_tree;

/// One ray's walk through several cells, with one mailbox: the range, after each cell.
inline constexpr function<"offer_all", std::vector<interval>(std::vector<std::vector<std::uint32_t>> cells, interval range, offer to)> offer_all;

inline constexpr function<"octant_of", aabb(aabb cell, std::uint32_t number)> octant_of;
inline constexpr function<"build_octree", octree(std::span<const aabb> boxes, std::uint32_t leaf_size, std::uint32_t max_depth)> build_octree;
inline constexpr function<"octants_met", std::vector<octant_part>(aabb cell, ray r, stretch part)> octants_met;
inline constexpr function<"best_cut", std::optional<cut>(aabb cell, std::span<const aabb> boxes, costs c)> best_cut;
inline constexpr function<"predictions", std::array<structure, 5>()> predictions;

/// Everything together: builds the structure over the boxes, and traverses it with one ray after the other. The answer means nothing.
inline constexpr function<"traverse", bool(structure which, std::span<const aabb> boxes, std::span<const ray> rays, offer_to_ray to)> traverse;

}  // namespace contract::lab11
