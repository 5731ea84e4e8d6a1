// SPDX-License-Identifier: MIT
#pragma once
// How a bounding volume hierarchy is built: which surfaces belong together, from the top down or from the bottom up.

#include <lantern/aabb.hpp>
#include <lantern/agglomerate.hpp>
#include <lantern/boxes_of.hpp>
#include <lantern/bvh_cut.hpp>
#include <lantern/reinsertion.hpp>
#include <lantern/validate.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace lantern {

struct bvh_options {
    split rule = split::surface_area;
    std::uint32_t leaf_size = 4;     ///< at most so many surfaces in a leaf, unless the depth is used up; `surface_area` makes it smaller where that pays
    std::uint32_t max_depth = 48;    ///< levels below the root, at most 64
    std::uint32_t reinsertions = 4;  ///< rounds at most in which `surface_area` puts elsewhere what lies badly, as long as that pays: see reinsertion.hpp
};

template <class Volume>
struct bvh_node {
    Volume volume;
    std::uint32_t first = 0;      ///< of two neighbouring children, or of the leaf's indices
    std::uint32_t size : 30 = 0;  ///< surfaces in a leaf; 0 for an inner node
    std::uint32_t axis : 2 = 0;   ///< along which the children are divided, the lower one first
};

/// The nodes of a hierarchy of boxes, parents before children, and the surfaces' indices in the order of the leaves: those
/// below any node are neighbours. What has no place in space is left out.
class bvh_layout {
public:
    bvh_layout(std::span<const aabb> boxes, const bvh_options& options) : options_(options) {
        if (options.leaf_size == 0) refuse("bvh: leaf_size", "0", "at least 1");
        if (options.max_depth > 64) refuse("bvh: max_depth", std::to_string(options.max_depth), "at most 64");
        indices_ = placeable(boxes);
        if (indices_.empty()) return;
        nodes_.reserve(2 * indices_.size() / options_.leaf_size + 1);
        nodes_.emplace_back();
        const auto size = static_cast<std::uint32_t>(indices_.size());
        const bool by_area = options_.rule == split::surface_area, reinserting = by_area && options_.reinsertions > 0 && size > options_.leaf_size;
        std::vector<cluster> clusters;
        if (options_.rule == split::bottom_up) {
            clusters = agglomerate(boxes, indices_);
        } else {
            divide(boxes, 0, 0, size, options_.max_depth, by_area && !reinserting);
            if (!reinserting) return;
            clusters = clusters_of(boxes);
            reinsert_where_it_pays(clusters, options_.leaf_size, options_.max_depth, options_.reinsertions);
        }
        nodes_.resize(1);
        indices_.clear();
        lay_out(boxes, clusters, clusters.back(), 0, options_.max_depth);
    }

    /// To be moved out of it.
    [[nodiscard]] std::vector<bvh_node<aabb>>& nodes() { return nodes_; }
    [[nodiscard]] std::vector<std::uint32_t>& indices() { return indices_; }

private:
    // Makes nodes_[at] the root of a tree over indices_[first, last) with so many levels left below it. What fits into a leaf is
    // one, or, where `small` ones may pay, as `cut_of` says.
    void divide(std::span<const aabb> boxes, std::uint32_t at, std::uint32_t first, std::uint32_t last,
                std::uint32_t levels, bool small) {
        aabb box, centers;
        for (std::uint32_t i = first; i < last; ++i) {
            box = enclose(box, boxes[indices_[i]]);
            centers = enclose(centers, center(boxes[indices_[i]]));
        }
        nodes_[at].volume = box;
        const std::uint32_t size = last - first;
        const auto become_leaf = [&] {
            nodes_[at].first = first;
            nodes_[at].size = size & 0x3fffffffu;
        };
        if (levels == 0 || size == 1 || (size <= options_.leaf_size && !small)) return become_leaf();
        const bvh_cut cut = cut_of({boxes, std::span(indices_).subspan(first, size), centers}, box, levels);
        if (cut.lower == 0) return become_leaf();
        const auto children = static_cast<std::uint32_t>(nodes_.size());
        nodes_.resize(nodes_.size() + 2);
        nodes_[at].first = children;
        nodes_[at].axis = cut.axis & 3u;
        divide(boxes, children, first, first + cut.lower, levels - 1, small);
        divide(boxes, children + 1, first + cut.lower, last, levels - 1, small);
    }

    // The nodes as clusters, the root last. How the surfaces of a leaf are joined is of no matter.
    std::vector<cluster> clusters_of(std::span<const aabb> boxes) const {
        std::vector<cluster> clusters;
        clusters.reserve(2 * indices_.size());
        std::vector<std::uint32_t> cluster_of(nodes_.size());
        for (std::size_t i = nodes_.size(); i-- > 0;) {
            const bvh_node<aabb>& n = nodes_[i];
            if (n.size == 0) clusters.push_back(joined(clusters, cluster_of[n.first], cluster_of[n.first + 1]));
            for (std::uint32_t k = 0; k < n.size; ++k) {
                const std::uint32_t index = indices_[n.first + k];
                clusters.push_back({boxes[index], index});
                const auto last = static_cast<std::uint32_t>(clusters.size() - 1);
                if (k > 0) clusters.push_back(joined(clusters, last - 1, last));
            }
            cluster_of[i] = static_cast<std::uint32_t>(clusters.size() - 1);
        }
        return clusters;
    }

    // The same over the clusters below `c`, which are joined already. Where they are stacked higher than there are levels,
    // they are divided from the top down instead.
    void lay_out(std::span<const aabb> boxes, std::span<const cluster> clusters, const cluster& c, std::uint32_t at,
                 std::uint32_t levels) {
        const auto first = static_cast<std::uint32_t>(indices_.size());
        if (c.size <= options_.leaf_size || c.height > levels) {
            collect(clusters, c, indices_);
            return divide(boxes, at, first, first + c.size, levels, options_.rule == split::surface_area);
        }
        const cluster *lower = &clusters[c.left], *upper = &clusters[c.right];
        const aabb centers = enclose(aabb{center(lower->box), center(lower->box)}, center(upper->box));
        const std::uint32_t axis = longest_axis(centers);
        if (center(lower->box)[int(axis)] > center(upper->box)[int(axis)]) std::swap(lower, upper);
        const auto children = static_cast<std::uint32_t>(nodes_.size());
        nodes_.resize(nodes_.size() + 2);
        nodes_[at] = {c.box, children, 0, axis & 3u};
        lay_out(boxes, clusters, *lower, children, levels - 1);
        lay_out(boxes, clusters, *upper, children + 1, levels - 1);
    }

    // Reorders the indices so that the lower child's come first. A rule that finds no cut, as where all centres are
    // equal, or that would use up the levels on crumbs, gives way to the median, which always halves; but what fits into
    // a leaf is one then: no cut.
    bvh_cut cut_of(const crowd& c, const aabb& box, std::uint32_t levels) const {
        const std::size_t size = c.indices.size();
        const bool fits = size <= options_.leaf_size;
        const bool needs_halving = !fits && static_cast<std::uint32_t>(std::bit_width(size / options_.leaf_size)) >= levels;
        if (options_.rule != split::median && !needs_halving) {
            const double limit = fits ? surface_area(box) * (double(size) - pair_cost) : std::numeric_limits<double>::infinity();
            const bvh_cut cut = options_.rule == split::middle ? c.cut_middle() : c.cut_by_surface_area(limit);
            if (cut.lower > 0 && cut.lower < size) return cut;
        }
        return fits ? bvh_cut{} : c.cut_median();
    }

    static constexpr double pair_cost = 1;  // of a look at two boxes, in tests of a surface

    std::vector<bvh_node<aabb>> nodes_;
    std::vector<std::uint32_t> indices_;
    bvh_options options_;
};

}  // namespace lantern
