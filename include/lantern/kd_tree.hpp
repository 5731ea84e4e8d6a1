// SPDX-License-Identifier: MIT
#pragma once
// A kd-tree over anything that is bounded: space is cut in two where that is expected to cost least.

#include <lantern/aabb.hpp>
#include <lantern/boxes_of.hpp>
#include <lantern/closest.hpp>
#include <lantern/interval.hpp>
#include <lantern/ray.hpp>
#include <lantern/validate.hpp>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ranges>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace lantern {

struct kd_tree_options {
    double test_cost = 2;          ///< of one surface, in steps of the traversal
    double empty_bonus = 0.5;      ///< the part of the cost that is forgiven where a cut sets empty space apart
    std::uint32_t leaf_size = 1;   ///< a cell with no more surfaces is not divided
    std::uint32_t max_depth = 0;   ///< levels below the root, at most 64; 0 for 8 + 1.3 log2 n
    std::uint32_t max_entries_per_surface = 32;  ///< on average; after that, no cell is divided any more
};

/// Cuts by planes across an axis, with the indices of the surfaces that reach into the leaves: of one surface, several leaves
/// may know. A surface whose bounds are empty or not finite is left out, and counted.
class kd_tree {
public:
    explicit kd_tree(std::span<const aabb> boxes, const kd_tree_options& options = {}) : options_(options) {
        if (!(options.test_cost > 0)) refuse("kd_tree: test_cost", to_text(options.test_cost), "positive");
        if (!(options.empty_bonus >= 0 && options.empty_bonus < 1))
            refuse("kd_tree: empty_bonus", to_text(options.empty_bonus), "in [0, 1)");
        if (options.max_depth > 64) refuse("kd_tree: max_depth", std::to_string(options.max_depth), "at most 64");
        if (options.max_entries_per_surface == 0) refuse("kd_tree: max_entries_per_surface", "0", "at least 1");
        std::vector<std::uint32_t> indices = placeable(boxes);
        size_ = static_cast<std::uint32_t>(boxes.size());
        left_out_ = size_ - static_cast<std::uint32_t>(indices.size());
        if (indices.empty()) return;
        for (const std::uint32_t i : indices) box_ = enclose(box_, boxes[i]);
        entries_left_ = std::uint64_t{options.max_entries_per_surface} * indices.size() - indices.size();
        const auto usual = static_cast<std::uint32_t>(8 + 1.3 * static_cast<double>(std::bit_width(indices.size())));
        nodes_.emplace_back();
        divide(boxes, 0, box_, std::move(indices), options.max_depth > 0 ? options.max_depth : std::min(usual, 64u));
    }

    /// Over a range of bounded surfaces: `kd_tree cells{things};`
    template <std::ranges::random_access_range Surfaces>
        requires bounded<std::ranges::range_value_t<Surfaces>>
    explicit kd_tree(const Surfaces& surfaces, const kd_tree_options& options = {}) : kd_tree(boxes_of(surfaces), options) {}

    /// See the concept `accelerator`. A cell is a stretch [enter, leave] of the ray; a plane cuts it in two, and both parts
    /// reach a little beyond the plane: more than all rounding, so a ray within the plane walks on both sides. NaN, from 0 *
    /// infinity where the ray runs within it, cuts nothing. What lies beyond the closest hit is not entered.
    template <class Offer, class Probe = no_probe>
    void traverse(const ray& r, interval range, Offer&& offer, Probe&& counter = {}) const {
        const slab_ray prepared(r);
        if (nodes_.empty() || empty(range) || !overlaps(box_, prepared, range)) return;
        const double padding = prepared.padding + 0x1p-40 * reach_of(box_);
        struct stretch {
            std::uint32_t node;
            double enter, leave;
        };
        std::array<stretch, 66> waiting;  // one sibling a level, and the root
        std::size_t count = 0;
        waiting[count++] = {0, range.min - 0x1p-22 * std::abs(range.min), std::numeric_limits<double>::max()};
        while (count > 0) {
            const auto [at, enter, leave] = waiting[--count];
            counter.node();
            if (enter > range.max + 0x1p-22 * std::abs(range.max)) continue;
            const node& n = nodes_[at];
            if (n.axis < 3) {
                const int axis = n.axis;
                const bool forward = !std::signbit(prepared.reciprocal[axis]);
                const double below = (n.cut - padding - prepared.origin[axis]) * prepared.reciprocal[axis];
                const double above = (n.cut + padding - prepared.origin[axis]) * prepared.reciprocal[axis];
                const double far_enters = forward ? below : above, near_leaves = forward ? above : below;
                const std::uint32_t near = forward ? n.first : n.first + 1, far = forward ? n.first + 1 : n.first;
                if (!(far_enters > leave)) waiting[count++] = {far, far_enters > enter ? far_enters : enter, leave};
                if (!(near_leaves < enter)) waiting[count++] = {near, enter, near_leaves < leave ? near_leaves : leave};
                continue;
            }
            range = offer_each(std::span(entries_).subspan(n.first, n.size), range, offer, counter);
            if (empty(range)) return;
        }
    }

    /// How many surfaces the tree was built over, and how many of them were left out.
    [[nodiscard]] std::uint32_t size() const { return size_; }
    [[nodiscard]] std::uint32_t left_out() const { return left_out_; }

    /// What the tree is made of: for pictures of it, and for tests.
    struct node {
        float cut = 0;                ///< where the plane is, in an inner node
        std::uint32_t first = 0;      ///< of two neighbouring children, the lower one first, or of the leaf's entries
        std::uint32_t size : 30 = 0;  ///< entries in a leaf
        std::uint32_t axis : 2 = 3;   ///< that the plane is across; 3 in a leaf
    };
    [[nodiscard]] const aabb& box() const { return box_; }
    [[nodiscard]] std::span<const node> nodes() const { return nodes_; }
    [[nodiscard]] std::span<const std::uint32_t> indices() const { return entries_; }

private:
    struct plane_cut {
        double cost = std::numeric_limits<double>::infinity();
        float at = 0;
        std::uint32_t axis = 3;
    };

    static constexpr std::uint32_t bins = 32;

    // What touches the plane only, belongs to one side only; each point of the box is on a closed side it belongs to.
    static bool reaches_below(const aabb& box, const plane_cut& c) {
        return box.max[int(c.axis)] <= c.at || box.min[int(c.axis)] < c.at;
    }
    static bool reaches_above(const aabb& box, const plane_cut& c) { return box.max[int(c.axis)] > c.at; }

    // Of 31 planes between the content's ends on each axis, and of the six at its ends, the one with the least expected cost:
    // a step, and the tests on either side, each times the share of the rays through the cell that pass there (MacDonald
    // and Booth 1990; the bonus for empty space: Hurley et al. 2002). How many reach below or above a plane is known
    // from how many boxes begin and end in each bin (Shevtsov, Soupikov and Kapustin 2007).
    [[nodiscard]] plane_cut best_cut(std::span<const aabb> boxes, std::span<const std::uint32_t> indices,
                                     const aabb& cell) const {
        aabb content;
        for (const std::uint32_t i : indices) content = enclose(content, cut_off(boxes[i], cell));
        plane_cut best;
        const bool on_a_line = surface_area(cell) == 0;  // there lengths say what areas cannot
        const auto size = [&](const aabb& b) {
            const glm::dvec3 e = glm::dvec3(b.max) - glm::dvec3(b.min);
            return on_a_line ? e.x + e.y + e.z : surface_area(b);
        };
        const double whole = size(cell), n = double(indices.size());
        const auto consider = [&](int axis, float at, double below, double above) {
            if (!(at > cell.min[axis] && at < cell.max[axis])) return;
            aabb lower = cell, upper = cell;
            lower.max[axis] = upper.min[axis] = at;
            const double tests = (size(lower) * below + size(upper) * above) / whole;
            const double bonus = below == 0 || above == 0 ? 1 - options_.empty_bonus : 1;
            const double cost = 1 + bonus * options_.test_cost * tests;
            if (cost < best.cost) best = {cost, at, static_cast<std::uint32_t>(axis)};
        };
        for (int axis = 0; axis < 3; ++axis) {
            consider(axis, std::nextafter(content.min[axis], -infinity), 0, n);
            consider(axis, content.max[axis], n, 0);
            const double low = content.min[axis], width = (double(content.max[axis]) - low) / bins;
            if (!(width > 0)) continue;
            const auto bin_of = [&](float x) {
                const double where = (x - low) / width;
                return !(where > 0) ? 0u : where >= bins ? bins - 1 : static_cast<std::uint32_t>(where);
            };
            std::array<double, bins> begin{}, end{};
            for (const std::uint32_t i : indices) {
                ++begin[bin_of(boxes[i].min[axis])];
                ++end[bin_of(boxes[i].max[axis])];
            }
            double below = 0, above = n;
            for (std::uint32_t b = 1; b < bins; ++b) {
                below += begin[b - 1];
                above -= end[b - 1];
                consider(axis, static_cast<float>(low + b * width), below, above);
            }
        }
        return best;
    }

    static aabb cut_off(const aabb& box, const aabb& cell) { return {glm::max(box.min, cell.min), glm::min(box.max, cell.max)}; }

    // Makes nodes_[at] the root of a tree over the indices in the cell, cut for as long as that is expected to pay.
    void divide(std::span<const aabb> boxes, std::uint32_t at, const aabb& cell, std::vector<std::uint32_t> indices,
                std::uint32_t levels) {
        const double leaf_cost = options_.test_cost * double(indices.size());
        plane_cut c;
        std::vector<std::uint32_t> lower, upper;
        bool divided = indices.size() > options_.leaf_size && levels > 0;
        if (divided) {
            c = best_cut(boxes, indices, cell);
            divided = c.cost < leaf_cost;
        }
        if (divided) {
            for (const std::uint32_t i : indices) {
                if (reaches_below(boxes[i], c)) lower.push_back(i);
                if (reaches_above(boxes[i], c)) upper.push_back(i);
            }
            divided = lower.size() + upper.size() - indices.size() <= entries_left_;
        }
        if (!divided) {
            nodes_[at].first = static_cast<std::uint32_t>(entries_.size());
            nodes_[at].size = static_cast<std::uint32_t>(indices.size()) & 0x3fffffffu;
            entries_.insert(entries_.end(), indices.begin(), indices.end());
            return;
        }
        entries_left_ -= lower.size() + upper.size() - indices.size();
        indices = {};
        const auto children = static_cast<std::uint32_t>(nodes_.size());
        nodes_.resize(nodes_.size() + 2);
        nodes_[at] = {c.at, children, 0, c.axis & 3u};
        aabb below = cell, above = cell;
        below.max[int(c.axis)] = above.min[int(c.axis)] = c.at;
        divide(boxes, children, below, std::move(lower), levels - 1);
        divide(boxes, children + 1, above, std::move(upper), levels - 1);
    }

    aabb box_;
    std::vector<node> nodes_;
    std::vector<std::uint32_t> entries_;
    std::uint64_t entries_left_ = 0;
    std::uint32_t size_ = 0, left_out_ = 0;
    kd_tree_options options_;
};

}  // namespace lantern
