// SPDX-License-Identifier: MIT
#pragma once
// How a binary tree becomes one of nodes with up to eight children, such that rays have as little to do as can be.

#include <lantern/interval.hpp>
#include <lantern/lanes.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace lantern::wide {

/// What rays are expected to do in a branch: the sum of its nodes' surfaces, and of its leaves' times their packets, for a node takes
/// about as long as a packet. It depends on how many children of one node the branch may become.
struct branch_cost {
    float least[8];  ///< as one child of a node, as two at most, and so on: never more than the one before
    bool leaf;       ///< whether as one child it is a leaf best, and not a node of its own
};

[[nodiscard]] inline branch_cost cost_of_leaf(float surface, std::uint32_t packets) {
    branch_cost c;
    std::ranges::fill(c.least, surface * static_cast<float>(packets));
    c.leaf = true;
    return c;
}

/// Of two branches together: their children become those of one node, or it becomes a leaf, which costs `as_leaf`. All that can be
/// done is weighed, so from the leaves upwards the best tree of all is found (Ylitie, Karras and Laine, "Efficient incoherent ray
/// traversal on GPUs through compressed wide BVHs", HPG 2017).
[[nodiscard]] inline branch_cost cost_of(const branch_cost& lower, const branch_cost& upper, float surface, float as_leaf) {
    // Lane j: j + 1 children, k + 1 of them of the lower branch. What is not there costs infinitely much.
    std::array<float, 16> moved;
    std::fill_n(moved.begin(), 8, infinity);
    std::copy_n(upper.least, 8, moved.begin() + 8);
    floats least;
    spread(infinity, least);
    for (std::size_t k = 0; k < 7; ++k) {
        floats shared;
        std::memcpy(&shared, moved.data() + 7 - k, sizeof shared);
        shared += lower.least[k];
        keep_smaller(least, shared);
    }
    const float as_node = least[7] + surface;
    branch_cost c;
    c.leaf = as_leaf <= as_node;
    floats alone;
    spread(std::min(as_leaf, as_node), alone);
    keep_smaller(least, alone);
    std::memcpy(c.least, &least, sizeof least);
    return c;
}

/// Which branches of a binary tree become the children of the node at `root`. Of a tree is asked: `tree[i].children`, the first of
/// two neighbours, and `tree[i].cost`; it is a leaf if the cost says so.
struct children {
    std::array<std::uint32_t, 8> at;
    std::size_t count = 0;

    children(const auto& tree, std::uint32_t root) { share(tree, root, at.size()); }

private:
    // Two branches become so many children at most.
    void share(const auto& tree, std::uint32_t i, std::size_t most) {
        const std::uint32_t lower = tree[i].children, upper = lower + 1;
        const float *const below = tree[lower].cost.least, *const above = tree[upper].cost.least;
        std::size_t best = 1;
        for (std::size_t k = 2; k < most; ++k)
            if (below[k - 1] + above[most - k - 1] < below[best - 1] + above[most - best - 1]) best = k;
        open(tree, lower, best);
        open(tree, upper, most - best);
    }

    void open(const auto& tree, std::uint32_t i, std::size_t most) {
        const float* const least = tree[i].cost.least;
        while (most > 1 && least[most - 2] <= least[most - 1]) --most;  // no more than it takes
        if (most > 1) return share(tree, i, most);
        at[count++] = i;
    }
};

}  // namespace lantern::wide
