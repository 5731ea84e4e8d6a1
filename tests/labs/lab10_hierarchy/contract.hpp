// SPDX-License-Identifier: MIT
#pragma once
// What lab 10 asks for. A traversal's questions are answered by the suite, and counted there.

#include <contract.hpp>

#include <lantern/aabb.hpp>
#include <lantern/interval.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace contract::lab10 {

/// As the student's.
struct node {
    lantern::aabb box;
    std::uint32_t left = 0, right = 0, first = 0, count = 0;
};
struct tree {
    std::vector<node> nodes;
    std::vector<std::uint32_t> order;
};
struct halves {
    std::vector<std::uint32_t> left, right;
};

using boxes_in = std::span<const lantern::aabb>;
using group_in = std::span<const std::uint32_t>;
using splitter = std::function<halves(group_in group)>;
using enter_box = std::function<std::optional<float>(std::uint32_t node)>;
using offer_surface = std::function<lantern::interval(std::uint32_t surface, lantern::interval range)>;
using blocks_ray = std::function<bool(std::uint32_t surface)>;

inline constexpr function<"box_around", lantern::aabb(boxes_in boxes, group_in group)> box_around;
inline constexpr function<"at_median", halves(boxes_in boxes, group_in group)> at_median;
inline constexpr function<"at_middle", halves(boxes_in boxes, group_in group)> at_middle;
inline constexpr function<"build", tree(boxes_in boxes, splitter split, std::uint32_t leaf_size, std::uint32_t max_depth)> build;
inline constexpr function<"cost", double(tree t)> cost;
inline constexpr function<"at_least_cost", halves(boxes_in boxes, group_in group)> at_least_cost;
inline constexpr function<"bottom_up", tree(boxes_in boxes)> bottom_up;
inline constexpr function<"traverse", void(tree t, lantern::interval range, enter_box enter, offer_surface offer)> traverse;
inline constexpr function<"occluded", bool(tree t, lantern::interval range, enter_box enter, blocks_ray blocks)> occluded;
inline constexpr function<"refit", tree(tree t, boxes_in opening, boxes_in closing)> refit;

}  // namespace contract::lab10
