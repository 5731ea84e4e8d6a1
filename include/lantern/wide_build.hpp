// SPDX-License-Identifier: MIT
#pragma once
// How wide_bvh is built: a binary tree over boxes, cut where that costs least, with several threads.

#include <lantern/aabb.hpp>
#include <lantern/lanes.hpp>
#include <lantern/large_pages.hpp>
#include <lantern/wide_collapse.hpp>

#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace lantern::wide {

/// A box, and which triangle is in it.
struct item {
    glm::vec3 lower;
    std::uint32_t index;
    glm::vec3 upper;
    std::uint32_t unused;
};
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
    static constexpr std::uint32_t packet_size = 4, most_packets = 7;  ///< of triangles; of packets in a leaf
    static constexpr std::uint32_t max_depth = 60;

    /// Reorders the items, of which there is at least one. The tree is the same with any number of threads. `by_length`: where many
    /// boxes are long and overlap, those that are long in the same way are put together, too.
    binary_tree(std::span<item> items, bool by_length, helpers& others)
        : items_(items), branches_(2 * items.size()), by_length_(by_length), others_(others) {
        extent all;
        for (const item& i : items) all.add(corners(i));
        const double surface = cost(all.box, 1);
        per_surface_ = surface > 0 ? 1 / surface : 0;
        place(0, all, 0, static_cast<std::uint32_t>(items.size()));
        divide(0, all, max_depth);
    }

    [[nodiscard]] static std::uint32_t packets(std::size_t count) { return static_cast<std::uint32_t>((count + packet_size - 1) / packet_size); }
    [[nodiscard]] const branch& operator[](std::uint32_t i) const { return branches_[i]; }
    [[nodiscard]] branch& operator[](std::uint32_t i) { return branches_[i]; }

private:
    static constexpr std::uint32_t bins = 16;
    static constexpr double step_cost = 1.2;  // of entering a branch, in packets: measured

    // x, y, z and a zero.
    struct box4 {
        quad lower, upper;
    };
    static box4 corners(const item& i) {
        return {quad{i.lower.x, i.lower.y, i.lower.z}, quad{i.upper.x, i.upper.y, i.upper.z}};
    }

    // What a number of boxes reach over, and their centers, doubled.
    struct extent {
        box4 box{infinity + quad{}, quad{} - infinity}, centers = box;

        void add(const box4& b) {
            const quad center = b.lower + b.upper;
            keep_smaller(box.lower, b.lower);
            keep_larger(box.upper, b.upper);
            keep_smaller(centers.lower, center);
            keep_larger(centers.upper, center);
        }
    };

    void place(std::uint32_t at, const extent& e, std::uint32_t first, std::uint32_t count) {
        const quad &l = e.box.lower, &u = e.box.upper;
        branches_[at] = {{{l[0], l[1], l[2]}, {u[0], u[1], u[2]}}, first, count, 0, 0, {}};
    }

    void divide(std::uint32_t at, const extent& all, std::uint32_t levels) {
        const std::uint32_t first = branches_[at].first, count = branches_[at].count;
        const auto surface = static_cast<float>(cost(all.box, 1) * per_surface_);
        extent low, high;
        const std::uint32_t middle = count > packet_size ? cut(items_.subspan(first, count), all, by_length_, levels, low, high) : 0;
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

    // Orders the items and says how many go to the lower child: where area times packets, summed over both children, is
    // least; into halves where no cut is found, or where the levels would run out otherwise. 0 where a leaf is cheaper.
    static std::uint32_t cut(std::span<item> items, const extent& all, bool by_length, std::uint32_t levels, extent& low, extent& high) {
        const auto count = static_cast<std::uint32_t>(items.size());
        const bool needs_halving = static_cast<std::uint32_t>(std::bit_width(count / packet_size)) >= levels;
        std::uint32_t middle = needs_halving ? 0 : cheapest_cut(items, all, by_length, low, high);
        if ((middle > 0 && middle < count) || count <= most_packets * packet_size) return middle;
        const quad size = all.centers.upper - all.centers.lower;
        const int axis = size[0] >= size[1] && size[0] >= size[2] ? 0 : size[1] >= size[2] ? 1 : 2;
        middle = (count / 2 + packet_size - 1) / packet_size * packet_size;
        std::nth_element(items.begin(), items.begin() + middle, items.end(), [&](const item& i, const item& j) {
            const float ci = i.lower[axis] + i.upper[axis], cj = j.lower[axis] + j.upper[axis];
            return ci < cj || (ci == cj && i.index < j.index);
        });
        low = high = {};
        for (const item& i : items.first(middle)) low.add(corners(i));
        for (const item& i : items.subspan(middle)) high.add(corners(i));
        return middle;
    }

    // Half the surface, times the packets. In double, for squares of floats overflow.
    static double cost(const box4& b, std::size_t count) {
        doubles e;
        widen(b.upper - b.lower, e);
        return (e[0] * e[1] + e[1] * e[2] + e[2] * e[0]) * packets(count);
    }

    // What tells items apart: where their boxes' centers are, doubled, or how long the boxes are; axis by axis.
    enum class measure { center, length };
    static quad measured(measure what, const box4& b) { return what == measure::center ? b.lower + b.upper : b.upper - b.lower; }

    // From a box to its bin on each axis.
    struct binning {
        measure what;
        quad lower, scale{};

        binning(measure of, const box4& range, std::uint32_t used) : what(of), lower(range.lower) {
            const quad size = range.upper - range.lower;
            for (int axis = 0; axis < 3; ++axis)
                if (size[axis] > 0) scale[axis] = std::min(0.9999f * float(used) / size[axis], std::numeric_limits<float>::max());
        }
        quad_integers operator()(const box4& b) const {
            return __builtin_convertvector((measured(what, b) - lower) * scale, quad_integers);
        }
    };

    struct candidate {
        double cost;
        std::optional<binning> by;
        int axis = 0;
        std::uint32_t bin = 0;  // the first that goes to the upper child
    };

    // All axes are tried, each with up to 16 bins (Wald 2007).
    static void try_cuts(std::span<const item> items, const binning& bin_of, std::uint32_t used, candidate& best) {
        std::array<std::array<box4, bins>, 3> box;
        std::array<std::array<std::uint32_t, bins>, 3> number{};
        for (auto& row : box) std::fill_n(row.begin(), used, extent{}.box);
        for (const item& i : items) {
            const box4 b = corners(i);
            const quad_integers bin = bin_of(b);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const auto k = static_cast<std::size_t>(bin[int(axis)]);
                keep_smaller(box[axis][k].lower, b.lower);
                keep_larger(box[axis][k].upper, b.upper);
                ++number[axis][k];
            }
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            std::array<double, bins> above{};
            box4 sum = extent{}.box;
            std::uint32_t count = 0;
            const auto add = [&](std::uint32_t k) {
                keep_smaller(sum.lower, box[axis][k].lower);
                keep_larger(sum.upper, box[axis][k].upper);
                count += number[axis][k];
            };
            for (std::uint32_t k = used - 1; k > 0; --k) {
                add(k);
                above[k] = count > 0 ? cost(sum, count) : 0;
            }
            sum = extent{}.box;
            count = 0;
            for (std::uint32_t k = 1; k < used; ++k) {
                add(k - 1);
                if (count == 0 || count == items.size()) continue;
                if (const double c = cost(sum, count) + above[k]; c < best.cost) best = {c, bin_of, static_cast<int>(axis), k};
            }
        }
    }

    static std::uint32_t cheapest_cut(std::span<item> items, const extent& all, bool by_length, extent& low, extent& high) {
        const auto used = std::min(bins, static_cast<std::uint32_t>(4 + items.size() / 4));
        candidate best{std::numeric_limits<double>::infinity(), std::nullopt};
        if (items.size() <= most_packets * packet_size) best.cost = cost(all.box, items.size()) - step_cost * cost(all.box, 1);
        try_cuts(items, binning(measure::center, all.centers, used), used, best);
        if (by_length) {
            box4 lengths = extent{}.box;
            for (const item& i : items) {
                const quad length = measured(measure::length, corners(i));
                keep_smaller(lengths.lower, length);
                keep_larger(lengths.upper, length);
            }
            try_cuts(items, binning(measure::length, lengths, used), used, best);
        }
        if (!(best.cost > 0 && best.by)) return 0;
        // Which side an item is on nobody can predict, so there is no branch: each trades places with the first of those at the upper side.
        const binning bin_of = *best.by;
        extent side[2];
        std::size_t first = 0;
        for (std::size_t i = 0; i < items.size(); ++i) {
            const item moving = items[i];
            const box4 b = corners(moving);
            const bool lower = bin_of(b)[best.axis] < static_cast<std::int32_t>(best.bin);
            side[lower ? 0 : 1].add(b);
            items[i] = items[first];
            items[first] = moving;
            first += lower;
        }
        low = side[0];
        high = side[1];
        return static_cast<std::uint32_t>(first);
    }

    std::span<item> items_;
    std::vector<branch, large_page_allocator<branch>> branches_;
    std::atomic<std::uint32_t> used_{2};  // 1 stays free: two children never straddle
    bool by_length_;
    double per_surface_ = 0;  // costs count in the root's surface, so that float has room for all
    helpers& others_;
};

}  // namespace lantern::wide
