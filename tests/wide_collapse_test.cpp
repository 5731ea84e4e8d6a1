// SPDX-License-Identifier: MIT
#include <lantern/wide_collapse.hpp>

#include <lantern/interval.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

using lantern::wide::branch_cost;

namespace {

struct branch {
    std::uint32_t children;
    float surface, as_leaf;
    branch_cost cost;
};
using binary_tree = std::vector<branch>;

/// Below branch `at`, so many levels at most; surfaces shrink from level to level, and small branches may be leaves.
void grow(binary_tree& tree, std::uint32_t at, float surface, int levels, dice& d) {
    const auto packets = 1 + d.below(1u << levels);
    tree[at] = {0, surface, packets <= 7 ? surface * static_cast<float>(packets) : lantern::infinity, {}};
    if (levels == 0 || (packets <= 7 && d.below(4) == 0)) {
        tree[at].as_leaf = surface * static_cast<float>(1 + packets % 7);
        tree[at].cost = lantern::wide::cost_of_leaf(surface, 1 + packets % 7);
        return;
    }
    const auto lower = static_cast<std::uint32_t>(tree.size());
    tree.resize(tree.size() + 2);
    tree[at].children = lower;
    for (const std::uint32_t i : {lower, lower + 1}) grow(tree, i, surface * d.between(0.2f, 1), levels - 1, d);
    tree[at].cost = lantern::wide::cost_of(tree[lower].cost, tree[lower + 1].cost, surface, tree[at].as_leaf);
}

/// What each of all ways would cost: as one child; as several.
double cheapest(const binary_tree& tree, std::uint32_t i, std::size_t most) {
    const branch& b = tree[i];
    if (b.children == 0) return b.as_leaf;
    const auto together = [&](std::size_t of) {
        double least = lantern::infinity;
        for (std::size_t k = 1; k < of; ++k)
            least = std::min(least, cheapest(tree, b.children, k) + cheapest(tree, b.children + 1, of - k));
        return least;
    };
    const double alone = std::min(double(b.as_leaf), b.surface + together(8));
    return most == 1 ? alone : std::min(alone, together(most));
}

/// What the tree costs that is made of it.
double realized(const binary_tree& tree, std::uint32_t i) {
    if (tree[i].cost.leaf) return tree[i].as_leaf;
    const lantern::wide::children slots(tree, i);
    REQUIRE(slots.count >= 2);
    double sum = tree[i].surface;
    for (std::size_t k = 0; k < slots.count; ++k) sum += realized(tree, slots.at[k]);
    return sum;
}

}  // namespace

TEST_CASE("no other tree of eight children a node is cheaper") {
    dice d{.state = 1};
    for (int i = 0; i < 300; ++i) {
        binary_tree tree(1);
        grow(tree, 0, 1, 4, d);
        const double least = cheapest(tree, 0, 1);
        CHECK(tree[0].cost.least[0] == Approx(least).epsilon(1e-5));
        CHECK(realized(tree, 0) == Approx(least).epsilon(1e-5));
        for (std::size_t most = 2; most <= 8; ++most) CHECK(tree[0].cost.least[most - 1] == Approx(cheapest(tree, 0, most)).epsilon(1e-5));
    }
}

TEST_CASE("two branches share eight places in every way there is") {
    dice d{.state = 2};
    for (int i = 0; i < 1000; ++i) {
        branch_cost of[2];
        for (branch_cost& c : of) {
            std::ranges::generate(c.least, [&] { return d.between(0, 1); });
            std::ranges::sort(c.least, std::ranges::greater());
        }
        const branch_cost both = lantern::wide::cost_of(of[0], of[1], 0.1f, d.between(0, 2));
        for (std::size_t most = 2; most <= 8; ++most) {
            float least = both.least[0];
            for (std::size_t k = 1; k < most; ++k) least = std::min(least, of[0].least[k - 1] + of[1].least[most - k - 1]);
            CHECK(both.least[most - 1] == least);
        }
    }
}

TEST_CASE("where all has the same surface, or none, every branch is in one node, once") {
    for (const float surface : {0.0f, 1.0f}) {
        binary_tree tree(2 * 64);
        for (std::uint32_t i = 1; i < 128; ++i) tree[i] = {i < 64 ? 2 * i : 0, surface, lantern::infinity, {}};
        for (std::uint32_t i = 127; i > 0; --i)
            tree[i].cost = i < 64 ? lantern::wide::cost_of(tree[2 * i].cost, tree[2 * i + 1].cost, surface, lantern::infinity)
                                  : lantern::wide::cost_of_leaf(surface, 1);
        std::vector<int> met(128);
        std::vector<std::uint32_t> waiting{1};
        while (!waiting.empty()) {
            const std::uint32_t i = waiting.back();
            waiting.pop_back();
            if (tree[i].cost.leaf) {
                ++met[i];
                continue;
            }
            const lantern::wide::children slots(tree, i);
            waiting.insert(waiting.end(), slots.at.begin(), slots.at.begin() + static_cast<std::ptrdiff_t>(slots.count));
        }
        CHECK(std::count(met.begin() + 64, met.end(), 1) == 64);
        CHECK(std::count(met.begin(), met.begin() + 64, 0) == 64);
    }
}
