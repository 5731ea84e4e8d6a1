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
    // BEGIN SOLUTION
    lantern::aabb box;
    for (const std::uint32_t i : group) box = enclose(box, boxes[i]);
    return box;
    // END SOLUTION
    // STARTER: return lantern::todo("lab10 step 1: the box around a group");
}

/// A group, divided: every surface is in one half and none is in both.
struct halves {
    std::vector<std::uint32_t> left, right;
};

/// Step 2. Divides a group of two or more along the axis on which its centres spread the farthest: half of them (of an odd
/// number the smaller half) go left, and none of these lies above any of the others.
[[nodiscard]] inline halves at_median(std::span<const lantern::aabb> boxes, std::span<const std::uint32_t> group) {
    // BEGIN SOLUTION
    lantern::aabb centers;
    for (const std::uint32_t i : group) centers = enclose(centers, center(boxes[i]));
    const glm::vec3 size = centers.max - centers.min;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    std::vector<std::uint32_t> sorted(group.begin(), group.end());
    const auto half = sorted.begin() + std::ptrdiff_t(sorted.size() / 2);
    std::nth_element(sorted.begin(), half, sorted.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return center(boxes[a])[axis] < center(boxes[b])[axis]; });
    return {{sorted.begin(), half}, {half, sorted.end()}};
    // END SOLUTION
    // STARTER: return lantern::todo("lab10 step 2: half to the left, half to the right");
}

/// Step 2. Along the same axis: those whose centre lies below the middle, halfway between the lowest and the highest centre, go
/// left. Neither half is empty: where nothing lies below the middle, or nothing above, the group is divided at the median.
[[nodiscard]] inline halves at_middle(std::span<const lantern::aabb> boxes, std::span<const std::uint32_t> group) {
    // BEGIN SOLUTION
    lantern::aabb centers;
    for (const std::uint32_t i : group) centers = enclose(centers, center(boxes[i]));
    const glm::vec3 spread = centers.max - centers.min;
    const int along = spread.x >= spread.y && spread.x >= spread.z ? 0 : spread.y >= spread.z ? 1 : 2;
    const float middle = center(centers)[along];
    halves parts;
    for (const std::uint32_t i : group) (center(boxes[i])[along] < middle ? parts.left : parts.right).push_back(i);
    return parts.left.empty() || parts.right.empty() ? at_median(boxes, group) : parts;
    // END SOLUTION
    // STARTER: return lantern::todo("lab10 step 2: on this side of the middle, or on that");
}

/// Says how a group of two or more is divided.
using splitter = std::function<halves(std::span<const std::uint32_t> group)>;

/// Step 3. The tree from the top down. A group of at most `leaf_size` surfaces becomes a leaf, and so does any group at
/// `max_depth` (the root's depth is 0, its children's 1 ...); every other is divided by `split`. A split that leaves one half empty
/// is none: the group's list is cut in the middle instead. Throws std::invalid_argument when leaf_size is 0.
[[nodiscard]] inline tree build(std::span<const lantern::aabb> boxes, const splitter& split, std::uint32_t leaf_size = 4,
                                std::uint32_t max_depth = 24) {
    // BEGIN SOLUTION
    if (leaf_size == 0) throw std::invalid_argument("build: leaf_size is 0, and a leaf must hold at least 1 surface");
    tree t;
    if (boxes.empty()) return t;
    struct task {
        std::uint32_t at, depth;
        std::vector<std::uint32_t> group;
    };
    std::vector<task> waiting(1);
    waiting[0].group.resize(boxes.size());
    std::iota(waiting[0].group.begin(), waiting[0].group.end(), 0u);
    t.nodes.emplace_back();
    while (!waiting.empty()) {
        const task now = std::move(waiting.back());
        waiting.pop_back();
        node& n = t.nodes[now.at];
        n.box = box_around(boxes, now.group);
        if (now.group.size() <= leaf_size || now.depth == max_depth) {
            n.first = std::uint32_t(t.order.size());
            n.count = std::uint32_t(now.group.size());
            t.order.insert(t.order.end(), now.group.begin(), now.group.end());
            continue;
        }
        halves parts = split(now.group);
        if (parts.left.empty() || parts.right.empty()) {
            const auto half = now.group.begin() + std::ptrdiff_t(now.group.size() / 2);
            parts = {{now.group.begin(), half}, {half, now.group.end()}};
        }
        n.left = std::uint32_t(t.nodes.size());
        n.right = n.left + 1;
        waiting.push_back({n.right, now.depth + 1, std::move(parts.right)});
        waiting.push_back({n.left, now.depth + 1, std::move(parts.left)});
        t.nodes.resize(t.nodes.size() + 2);  // from here on `n` is gone
    }
    return t;
    // END SOLUTION
    // STARTER: return lantern::todo("lab10 step 3: a tree from the top down");
}

/// Step 4. How many questions a ray asks on average that crosses the root's box and is not stopped by any surface: in an inner
/// node it asks about two boxes, in a leaf about `count` surfaces, and the part of the rays that cross a node is the area of its box
/// divided by that of the root's. 0 when the tree has no nodes, or the root's box no area.
[[nodiscard]] inline double cost(const tree& t) {
    // BEGIN SOLUTION
    const double whole = t.nodes.empty() ? 0 : surface_area(t.nodes[0].box);
    if (!(whole > 0)) return 0;
    double sum = 0;
    for (const node& n : t.nodes) sum += surface_area(n.box) / whole * (n.count > 0 ? n.count : 2);
    return sum;
    // END SOLUTION
    // STARTER: return lantern::todo("lab10 step 4: what a tree costs");
}

/// Step 4. Divides a group of two or more where it costs least: on each axis in turn the group is sorted by its centres, and of
/// all places to cut the three lists the one is taken for which area times number, left plus right, is smallest.
[[nodiscard]] inline halves at_least_cost(std::span<const lantern::aabb> boxes, std::span<const std::uint32_t> group) {
    // BEGIN SOLUTION
    double least = std::numeric_limits<double>::infinity();
    halves best;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<std::uint32_t> sorted(group.begin(), group.end());
        std::sort(sorted.begin(), sorted.end(),
                  [&](std::uint32_t a, std::uint32_t b) { return center(boxes[a])[axis] < center(boxes[b])[axis]; });
        std::vector<double> right_cost(sorted.size());  // of all from i on
        lantern::aabb box;
        for (std::size_t i = sorted.size(); i-- > 1;) {
            box = enclose(box, boxes[sorted[i]]);
            right_cost[i] = surface_area(box) * double(sorted.size() - i);
        }
        box = {};
        for (std::size_t i = 1; i < sorted.size(); ++i) {
            box = enclose(box, boxes[sorted[i - 1]]);
            const double both = surface_area(box) * double(i) + right_cost[i];
            if (!(both < least)) continue;
            least = both;
            const auto cut = sorted.begin() + std::ptrdiff_t(i);
            best = {{sorted.begin(), cut}, {cut, sorted.end()}};
        }
    }
    return best;
    // END SOLUTION
    // STARTER: return lantern::todo("lab10 step 4: the split that costs least");
}

/// Step 5. The tree from the bottom up, with one surface in each leaf: of all that is not joined yet, the two are joined whose
/// common box has the smallest area; and so on, until one is left, the root.
[[nodiscard]] inline tree bottom_up(std::span<const lantern::aabb> boxes) {
    // BEGIN SOLUTION
    tree t;
    if (boxes.empty()) return t;
    auto free = std::uint32_t(2 * boxes.size() - 1);  // filled from the back, so that parents come before their children
    t.nodes.resize(free);
    std::vector<std::uint32_t> active;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        t.order.push_back(i);
        t.nodes[--free] = {.box = boxes[i], .first = i, .count = 1};
        active.push_back(free);
    }
    while (active.size() > 1) {
        double least = std::numeric_limits<double>::infinity();
        std::size_t one = 0, other = 1;
        for (std::size_t i = 0; i < active.size(); ++i)
            for (std::size_t k = i + 1; k < active.size(); ++k) {
                const double area = surface_area(enclose(t.nodes[active[i]].box, t.nodes[active[k]].box));
                if (area < least) least = area, one = i, other = k;
            }
        const std::uint32_t left = active[one], right = active[other];
        t.nodes[--free] = {.box = enclose(t.nodes[left].box, t.nodes[right].box), .left = left, .right = right};
        active[one] = free;
        active.erase(active.begin() + std::ptrdiff_t(other));
    }
    return t;
    // END SOLUTION
    // STARTER: return lantern::todo("lab10 step 5: a tree from the bottom up");
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
    // BEGIN SOLUTION
    struct visit {
        std::uint32_t at;
        float entry;
    };
    std::vector<visit> waiting;  // the next one last
    const auto ask = [&](std::uint32_t at) {
        if (const auto entry = enter(at)) waiting.push_back({at, *entry});
    };
    if (t.nodes.empty() || empty(range)) return;
    ask(0);
    while (!waiting.empty()) {
        const visit now = waiting.back();
        waiting.pop_back();
        if (now.entry > range.max) continue;  // since it was asked about, something nearer was hit
        const node& n = t.nodes[now.at];
        for (std::uint32_t k = n.first; k < n.first + n.count; ++k) {
            range = offer(t.order[k], range);
            if (empty(range)) return;
        }
        if (n.count > 0) continue;
        const std::size_t before = waiting.size();
        ask(n.left);
        ask(n.right);
        if (waiting.size() == before + 2 && waiting[before].entry < waiting[before + 1].entry)
            std::swap(waiting[before], waiting[before + 1]);
    }
    // END SOLUTION
    // STARTER: lantern::todo("lab10 step 6: the closest hit");
}

/// Whether a surface is hit within the range.
using blocks_ray = std::function<bool(std::uint32_t surface)>;

/// Step 7. Whether any surface is hit within the range: the shadow ray's question. The first that is ends the search. Nothing is asked
/// about what the ray misses, or enters only beyond the end of the range.
[[nodiscard]] inline bool occluded(const tree& t, lantern::interval range, const enter_box& enter, const blocks_ray& blocks) {
    // BEGIN SOLUTION
    if (t.nodes.empty() || empty(range)) return false;
    std::vector<std::uint32_t> waiting{0};
    while (!waiting.empty()) {
        const std::uint32_t at = waiting.back();
        waiting.pop_back();
        const auto entry = enter(at);
        if (!entry || *entry > range.max) continue;
        const node& n = t.nodes[at];
        for (std::uint32_t k = n.first; k < n.first + n.count; ++k)
            if (blocks(t.order[k])) return true;
        if (n.count > 0) continue;
        waiting.push_back(n.right);
        waiting.push_back(n.left);
    }
    return false;
    // END SOLUTION
    // STARTER: return lantern::todo("lab10 step 7: is anything in the way?");
}

/// Step 8. The same tree, when its surfaces move: `opening` are their boxes when the shutter opens, `closing` when it closes, and in
/// between each goes along a straight line. Every node's box is the smallest that holds all its surfaces during the whole exposure;
/// nothing else changes. Throws std::invalid_argument unless both have a box for each surface of the tree.
[[nodiscard]] inline tree refit(const tree& t, std::span<const lantern::aabb> opening, std::span<const lantern::aabb> closing) {
    // BEGIN SOLUTION
    if (opening.size() != t.order.size() || closing.size() != t.order.size())
        throw std::invalid_argument("refit: each surface needs a box at the opening of the shutter and one at its closing");
    tree fitted = t;
    for (std::size_t i = fitted.nodes.size(); i-- > 0;) {  // children stand behind their parents
        node& n = fitted.nodes[i];
        n.box = {};
        for (std::uint32_t k = n.first; k < n.first + n.count; ++k) {
            const std::uint32_t surface = t.order[k];
            n.box = enclose(n.box, enclose(opening[surface], closing[surface]));
        }
        if (n.count == 0) n.box = enclose(fitted.nodes[n.left].box, fitted.nodes[n.right].box);
    }
    return fitted;
    // END SOLUTION
    // STARTER: return lantern::todo("lab10 step 8: things that move");
}

}  // namespace lab10
