// SPDX-License-Identifier: MIT
#pragma once
// Lab 10: boxes in boxes, so that a ray need not ask every surface. The handout is README.md in this folder.

#include <lantern/aabb.hpp>
#include <lantern/interval.hpp>
#include <lantern/todo.hpp>

#include <glm/vec3.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

namespace lab10 {

/// A box, and what is in it: two nodes, or a stretch of the tree's `order`.
struct node {
    lantern::aabb box;
    std::uint32_t left = 0, right = 0;   ///< of an inner node: where its children stand in the tree, both behind their parent
    std::uint32_t first = 0, count = 0;  ///< of a leaf: its surfaces are order[first] ... order[first + count - 1]; 0 of an inner node
};

/// nodes[0] is the root. A tree over nothing has no nodes.
struct tree {
    std::vector<node> nodes;
    std::vector<std::uint32_t> order;  ///< the surfaces' numbers, leaf by leaf
};

// A surface is known by its number: boxes[i] is the box of surface i, finite and not empty. A group is a list of such numbers.

/// Step 1. The smallest box around all boxes of the group; the empty box, lantern::aabb{}, when the group has none.
[[nodiscard]] inline lantern::aabb box_around(std::span<const lantern::aabb> boxes, std::span<const std::uint32_t> group) {
    return lantern::todo("lab10 step 1: the box around a group");
}

/// A group, divided: every surface is in one half and none is in both.
struct halves {
    std::vector<std::uint32_t> left, right;
};

/// Step 2. Divides a group of two or more along the axis on which its centres spread the farthest: half of them (of an odd
/// number the smaller half) go left, and none of these lies above any of the others.
[[nodiscard]] inline halves at_median(std::span<const lantern::aabb> boxes, std::span<const std::uint32_t> group) {
    return lantern::todo("lab10 step 2: half to the left, half to the right");
}

/// Step 2. Along the same axis: those whose centre lies below the middle, halfway between the lowest and the highest centre, go
/// left. Neither half is empty: where nothing lies below the middle, or nothing above, the group is divided at the median.
[[nodiscard]] inline halves at_middle(std::span<const lantern::aabb> boxes, std::span<const std::uint32_t> group) {
    return lantern::todo("lab10 step 2: on this side of the middle, or on that");
}

/// Says how a group of two or more is divided.
using splitter = std::function<halves(std::span<const std::uint32_t> group)>;

/// Step 3. The tree from the top down. A group of at most `leaf_size` surfaces becomes a leaf, and so does any group at
/// `max_depth` (the root's depth is 0, its children's 1 ...); every other is divided by `split`. A split that leaves one half empty
/// is none: the group's list is cut in the middle instead. Throws std::invalid_argument when leaf_size is 0.
[[nodiscard]] inline tree build(std::span<const lantern::aabb> boxes, const splitter& split, std::uint32_t leaf_size = 4,
                                std::uint32_t max_depth = 24) {
    return lantern::todo("lab10 step 3: a tree from the top down");
}

/// Step 4. How many questions a ray asks on average that crosses the root's box and is not stopped by any surface: in an inner
/// node it asks about two boxes, in a leaf about `count` surfaces, and the part of the rays that cross a node is the area of its box
/// divided by that of the root's. 0 when the tree has no nodes, or the root's box no area.
[[nodiscard]] inline double cost(const tree& t) {
    return lantern::todo("lab10 step 4: what a tree costs");
}

/// Step 4. Divides a group of two or more where it costs least: on each axis in turn the group is sorted by its centres, and of
/// all places to cut the three lists the one is taken for which area times number, left plus right, is smallest.
[[nodiscard]] inline halves at_least_cost(std::span<const lantern::aabb> boxes, std::span<const std::uint32_t> group) {
    return lantern::todo("lab10 step 4: the split that costs least");
}

/// Step 5. The tree from the bottom up, with one surface in each leaf: of all that is not joined yet, the two are joined whose
/// common box has the smallest area; and so on, until one is left, the root.
[[nodiscard]] inline tree bottom_up(std::span<const lantern::aabb> boxes) {
    return lantern::todo("lab10 step 5: a tree from the bottom up");
}

/// The t at which the ray enters the box of a node, or std::nullopt when it misses it. No hit in the box is nearer than that.
using enter_box = std::function<std::optional<float>(std::uint32_t node)>;

/// Intersects a surface within the range, and answers what remains of the range: up to the hit, if there is one. Both ends of what
/// remains may change, and where it is empty nothing more is to be asked.
using offer_surface = std::function<lantern::interval(std::uint32_t surface, lantern::interval range)>;

/// Step 6. Offers every surface whose box the ray enters within what remains of the range, and asks no question that need not be asked.
/// No node is asked about twice, none whose parent was missed, or is entered only beyond the end of what remains by now. Of two children
/// the one that is entered first comes first, with all that is in it. The tree may be as deep as it has leaves.
inline void traverse(const tree& t, lantern::interval range, const enter_box& enter, const offer_surface& offer) {
    lantern::todo("lab10 step 6: the closest hit");
}

/// Whether a surface is hit within the range.
using blocks_ray = std::function<bool(std::uint32_t surface)>;

/// Step 7. Whether any surface is hit within the range: the shadow ray's question. The first that is ends the search. Nothing is asked
/// about what the ray misses, or enters only beyond the end of the range.
[[nodiscard]] inline bool occluded(const tree& t, lantern::interval range, const enter_box& enter, const blocks_ray& blocks) {
    return lantern::todo("lab10 step 7: is anything in the way?");
}

/// Step 8. The same tree, when its surfaces move: `opening` are their boxes when the shutter opens, `closing` when it closes, and in
/// between each goes along a straight line. Every node's box is the smallest that holds all its surfaces during the whole exposure;
/// nothing else changes. Throws std::invalid_argument unless both have a box for each surface of the tree.
[[nodiscard]] inline tree refit(const tree& t, std::span<const lantern::aabb> opening, std::span<const lantern::aabb> closing) {
    return lantern::todo("lab10 step 8: things that move");
}

}  // namespace lab10
