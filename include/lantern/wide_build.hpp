// SPDX-License-Identifier: MIT
#pragma once
// How wide_bvh is built: a binary tree over boxes, cut where that costs least, with several threads.

#include <lantern/aabb.hpp>
#include <lantern/interval.hpp>
#include <lantern/lanes.hpp>
#include <lantern/large_pages.hpp>
#include <lantern/wide_collapse.hpp>
#include <lantern/wide_cut.hpp>

#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <system_error>
#include <thread>
#include <vector>

namespace lantern::wide {

using item_list = std::vector<item, large_page_allocator<item>>;

/// How many other threads may be started yet.
class helpers {
public:
    explicit helpers(unsigned threads) : idle_(static_cast<int>(threads) - 1) {}

    /// Calls both, at the same time where that is worthwhile and a thread is to be had.
    void both(bool worthwhile, auto&& one, auto&& other) {
        std::optional<std::jthread> helper;
        if (worthwhile) {
            if (idle_.fetch_sub(1) > 0) {
                try {
                    helper.emplace([&] {
                        one();
                        idle_.fetch_add(1);
                    });
                } catch (const std::system_error&) {  // no more threads
                }
            }
            if (!helper) idle_.fetch_add(1);
        }
        if (!helper) one();
        other();
    }

private:
    std::atomic<int> idle_;
};

/// Below this many triangles a thread is not worthwhile.
inline constexpr std::uint32_t few = 4000;

class binary_tree {
public:
    struct branch {
        aabb box;
        std::uint32_t first, count;  ///< of the items
        std::uint32_t children;      ///< the first of two; 0 where nothing is to be cut
        std::uint32_t blocks;        ///< for whoever lays it out
        branch_cost cost;            ///< a leaf, or a node, as this says
    };
    static constexpr std::uint32_t max_depth = 60;

    /// Reorders the items, of which there is at least one. The tree is the same with any number of threads. `by_length`: as of `divider`.
    binary_tree(std::span<item> items, bool by_length, helpers& others)
        : items_(items), branches_(2 * items.size()), by_length_(by_length), others_(others) {
        extent all;
        for (const item& i : items) all.add(i);
        place(0, all, 0, static_cast<std::uint32_t>(items.size()));
        const double surface = surface_area(branches_[0].box);
        per_surface_ = surface > 0 ? 1 / surface : 0;
        divide(0, all, max_depth);
    }

    [[nodiscard]] const branch& operator[](std::uint32_t i) const { return branches_[i]; }
    [[nodiscard]] branch& operator[](std::uint32_t i) { return branches_[i]; }

private:
    void place(std::uint32_t at, const extent& e, std::uint32_t first, std::uint32_t count) {
        const floats& b = e.box;
        branches_[at] = {{{b[0], b[1], b[2]}, {-b[4], -b[5], -b[6]}}, first, count, 0, 0, {}};
    }

    void divide(std::uint32_t at, const extent& all, std::uint32_t levels) {
        const std::uint32_t first = branches_[at].first, count = branches_[at].count;
        const auto surface = static_cast<float>(surface_area(branches_[at].box) * per_surface_);
        extent low, high;
        const std::uint32_t middle = count > packet_size ? divider::cut(items_.subspan(first, count), all, by_length_, levels, low, high) : 0;
        if (middle == 0) {
            branches_[at].cost = cost_of_leaf(surface, packets(count));
            return;
        }
        const std::uint32_t lower = used_.fetch_add(2), upper = lower + 1;
        branches_[at].children = lower;
        place(lower, low, first, middle);
        place(upper, high, first + middle, count - middle);
        others_.both(count > few, [&] { divide(lower, low, levels - 1); }, [&] { divide(upper, high, levels - 1); });
        const float as_leaf = packets(count) <= most_packets ? surface * static_cast<float>(packets(count)) : infinity;
        branches_[at].cost = cost_of(branches_[lower].cost, branches_[upper].cost, surface, as_leaf);
    }

    std::span<item> items_;
    std::vector<branch, large_page_allocator<branch>> branches_;
    std::atomic<std::uint32_t> used_{2};  // 1 stays free: two children never straddle
    bool by_length_;
    double per_surface_ = 0;  // costs count in the root's surface, so that float has room for all
    helpers& others_;
};

}  // namespace lantern::wide
