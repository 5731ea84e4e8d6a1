// SPDX-License-Identifier: MIT
#pragma once
// How a bounding volume hierarchy is built: which surfaces belong together, from the top down or from the bottom up.

#include <lantern/aabb.hpp>
#include <lantern/agglomerate.hpp>
#include <lantern/boxes_of.hpp>
#include <lantern/reinsertion.hpp>
#include <lantern/validate.hpp>

#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace lantern {

/// How it is decided which surfaces go into which of a node's two children.
enum class split {
    middle,        ///< at the middle of their centres: cheap to find, blind to crowds
    median,        ///< half of them each: balanced, blind to space
    surface_area,  ///< where the expected number of tests is least (Goldsmith and Salmon 1987), over 16 bins (Wald 2007)
    bottom_up      ///< the nearest are joined first, and so on up to the root: see agglomerate.hpp
};

struct bvh_options {
    split rule = split::surface_area;
    std::uint32_t leaf_size = 4;   ///< at most so many surfaces in a leaf, unless the depth is used up; `surface_area` makes it smaller where that pays
    std::uint32_t max_depth = 48;  ///< levels below the root, at most 64
    std::uint32_t reinsertions = 4;  ///< rounds in which `surface_area` looks for better places afterwards, as long as that pays: see reinsertion.hpp; 0: none
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
        std::vector<cluster> clusters;
        if (options_.rule == split::bottom_up) {
            clusters = agglomerate(boxes, indices_);
        } else {
            const bool reinserting = options_.rule == split::surface_area && options_.reinsertions > 0 && size > options_.leaf_size;
            divide(boxes, 0, 0, size, options_.max_depth, options_.rule == split::surface_area && !reinserting);
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
    struct cut {
        std::uint32_t middle;  ///< how many go to the lower child
        std::uint32_t axis;
    };

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
        const cut c = cut_of(boxes, std::span(indices_).subspan(first, size), box, centers, levels);
        if (c.middle == 0) return become_leaf();
        const auto children = static_cast<std::uint32_t>(nodes_.size());
        nodes_.resize(nodes_.size() + 2);
        nodes_[at].first = children;
        nodes_[at].axis = c.axis & 3u;
        divide(boxes, children, first, first + c.middle, levels - 1, small);
        divide(boxes, children + 1, first + c.middle, last, levels - 1, small);
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
    cut cut_of(std::span<const aabb> boxes, std::span<std::uint32_t> indices, const aabb& box, const aabb& centers,
               std::uint32_t levels) const {
        const bool fits = indices.size() <= options_.leaf_size;
        const bool needs_halving = !fits && static_cast<std::uint32_t>(std::bit_width(indices.size() / options_.leaf_size)) >= levels;
        if (options_.rule != split::median && !needs_halving) {
            const double limit = fits ? surface_area(box) * (double(indices.size()) - pair_cost) : std::numeric_limits<double>::infinity();
            const cut c = options_.rule == split::middle ? middle_cut(boxes, indices, centers)
                                                         : surface_area_cut(boxes, indices, centers, limit);
            if (c.middle > 0 && c.middle < indices.size()) return c;
        }
        return fits ? cut{0, 0} : median_cut(boxes, indices, centers);
    }

    static std::uint32_t longest_axis(const aabb& box) {
        const glm::vec3 size = box.max - box.min;
        return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    }

    static std::uint32_t partition(std::span<std::uint32_t> indices, auto&& below) {
        return static_cast<std::uint32_t>(std::partition(indices.begin(), indices.end(), below) - indices.begin());
    }

    static cut middle_cut(std::span<const aabb> boxes, std::span<std::uint32_t> indices, const aabb& centers) {
        const std::uint32_t axis = longest_axis(centers);
        const float middle = center(centers)[int(axis)];
        return {partition(indices, [&](std::uint32_t i) { return center(boxes[i])[int(axis)] < middle; }), axis};
    }

    static cut median_cut(std::span<const aabb> boxes, std::span<std::uint32_t> indices, const aabb& centers) {
        const std::uint32_t axis = longest_axis(centers);
        const std::uint32_t half = static_cast<std::uint32_t>(indices.size() / 2);
        std::nth_element(indices.begin(), indices.begin() + half, indices.end(), [&](std::uint32_t a, std::uint32_t b) {
            const float ca = center(boxes[a])[int(axis)], cb = center(boxes[b])[int(axis)];
            return ca < cb || (ca == cb && a < b);
        });
        return {half, axis};
    }

    static constexpr std::uint32_t bins = 16;
    static constexpr double pair_cost = 1;  // of a look at two boxes, in tests of a surface

    // The bin of a center; all centers of a degenerate axis share bin 0.
    static std::uint32_t bin_of(const aabb& box, const aabb& centers, int axis) {
        const double low = centers.min[axis], extent = double(centers.max[axis]) - low;
        const double where = extent > 0 ? (double(center(box)[axis]) - low) / extent * bins : 0;
        return std::min(static_cast<std::uint32_t>(where), bins - 1);
    }

    // Of 15 cuts on each axis the one with the least sum, over both children, of area times number of surfaces. None
    // where there is no area to compare, as of points on a line, and none where the sum is not below `least`.
    static cut surface_area_cut(std::span<const aabb> boxes, std::span<std::uint32_t> indices, const aabb& centers,
                                double least) {
        int best_axis = 0;
        std::uint32_t best_bin = bins;
        for (int axis = 0; axis < 3; ++axis) {
            std::array<aabb, bins> box{};
            std::array<std::uint32_t, bins> size{};
            for (const std::uint32_t i : indices) {
                const std::uint32_t b = bin_of(boxes[i], centers, axis);
                box[b] = enclose(box[b], boxes[i]);
                ++size[b];
            }
            std::array<double, bins> below{};  // below[b]: the cost of all in bins 0 … b - 1
            aabb sum;
            std::uint32_t count = 0;
            for (std::uint32_t b = 0; b + 1 < bins; ++b) {
                sum = enclose(sum, box[b]);
                count += size[b];
                below[b + 1] = count > 0 ? surface_area(sum) * count : 0;
            }
            sum = {};
            count = 0;
            for (std::uint32_t b = bins - 1; b > 0; --b) {
                sum = enclose(sum, box[b]);
                count += size[b];
                const bool both = count > 0 && count < indices.size();
                const double cost = below[b] + (count > 0 ? surface_area(sum) * count : 0);
                if (both && cost < least) {
                    least = cost;
                    best_axis = axis;
                    best_bin = b;
                }
            }
        }
        const auto lower = [&](std::uint32_t i) { return bin_of(boxes[i], centers, best_axis) < best_bin; };
        return {least > 0 && best_bin < bins ? partition(indices, lower) : 0, static_cast<std::uint32_t>(best_axis)};
    }

    std::vector<bvh_node<aabb>> nodes_;
    std::vector<std::uint32_t> indices_;
    bvh_options options_;
};

}  // namespace lantern
