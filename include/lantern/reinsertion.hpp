// SPDX-License-Identifier: MIT
#pragma once
// A hierarchy made better after it is built: what lies badly is taken out, and put in again where it costs least.

#include <lantern/aabb.hpp>
#include <lantern/agglomerate.hpp>

#include <cstdint>
#include <vector>

namespace lantern {

/// Insertion-based optimization (Bittner, Hapala and Havran 2013), with the search of Meister and Bittner, "Parallel reinsertion for
/// bounding volume hierarchy optimization", 2018. The cost of a hierarchy is the surface of all its inner boxes. A cluster that is
/// taken out spares its parent, and the boxes above shrink; where it is put in, a new parent is needed, and the boxes above grow.
/// It goes where the most is left of what was spared.
class reinsertion {
public:
    /// Over the clusters of one tree, the root last. Those of up to `leaf_size` boxes are moved as a whole, or not at all.
    reinsertion(std::vector<cluster>& clusters, std::uint32_t leaf_size)
        : clusters_(clusters), parent_(clusters.size()), area_(clusters.size()), root_(static_cast<std::uint32_t>(clusters.size() - 1)), leaf_size_(leaf_size) {
        for (std::uint32_t i = 0; i <= root_; ++i) {
            const cluster& c = clusters_[i];
            area_[i] = surface_area(c.box);
            if (is_leaf(i)) continue;
            parent_[c.left] = parent_[c.right] = i;
            cost_ += area_[i];
        }
    }

    /// The surface of all inner boxes, from which everything is moved.
    [[nodiscard]] double cost() const { return cost_; }

    /// Takes the cluster out and puts it in where that saves most, if it saves anything. Says how much.
    double reinsert(std::uint32_t i) {
        const std::uint32_t parent = parent_[i];
        if (parent == 0 || parent == root_) return 0;  // 0 is no parent, as of the root: the first cluster is a box
        const double before = cost_;
        if (const std::uint32_t to = best_place(i); to != root_) move(i, to);
        return before - cost_;
    }

    /// Reinserts every `stride`-th cluster, from the root down, until the tree has `max_height` levels or more. Whether it
    /// pays to go on: whether all of them, at this rate, would save a fiftieth of the cost.
    bool round(std::uint32_t stride, std::uint32_t max_height) {
        const double before = cost_;
        for (std::uint32_t i = 1; i <= root_ && clusters_[root_].height < max_height; i += stride) reinsert(root_ - i);
        return (before - cost_) * stride > 0.02 * before;
    }

private:
    static constexpr std::uint32_t most_steps = 200;  // of a search; without that, boxes that all overlap would take O(n²)

    struct place {
        double left;  // of what was spared
        std::uint32_t at;
    };

    [[nodiscard]] bool is_leaf(std::uint32_t i) const { return clusters_[i].size <= leaf_size_; }
    [[nodiscard]] std::uint32_t sibling(std::uint32_t i) const {
        const cluster& p = clusters_[parent_[i]];
        return p.left == i ? p.right : p.left;
    }

    // Beside which cluster it belongs; the root if where it already is. From its parent upwards, the pivot, the other side is searched
    // first; then the place beside the pivot itself is tried. No place below another can be better than one where nothing grew, and the
    // new parent has but the cluster's own box.
    std::uint32_t best_place(std::uint32_t i) {
        const aabb box = clusters_[i].box;
        const std::uint32_t parent = parent_[i];
        std::uint32_t to = root_, pivot = parent, other = sibling(i);
        double spared = area_[parent], best = 0x1p-30 * spared;  // less may be nothing but rounding
        aabb rest = clusters_[other].box;                        // of the pivot, without the cluster
        for (std::uint32_t steps = 0; steps < most_steps;) {
            waiting_.assign(1, {spared, other});
            for (; !waiting_.empty() && steps < most_steps; ++steps) {
                const place p = waiting_.back();
                waiting_.pop_back();
                const double left = p.left - surface_area(enclose(clusters_[p.at].box, box));
                if (left > best && p.at != sibling(i)) best = left, to = p.at;
                const double below = left + area_[p.at];
                if (is_leaf(p.at) || below - area_[i] <= best) continue;
                waiting_.push_back({below, clusters_[p.at].left});
                waiting_.push_back({below, clusters_[p.at].right});
            }
            if (pivot == root_) break;
            if (pivot != parent) {
                rest = enclose(rest, clusters_[other].box);
                spared += area_[pivot] - surface_area(rest);
                if (const double left = spared - area_[pivot]; left > best) best = left, to = pivot;
            }
            other = sibling(pivot);
            pivot = parent_[pivot];
        }
        return to;
    }

    // Its sibling takes its parent's place, and the parent comes to lie above the two.
    void move(std::uint32_t i, std::uint32_t to) {
        const std::uint32_t parent = parent_[i], above = parent_[parent];
        replace(above, parent, sibling(i));
        replace(parent_[to], to, parent);
        clusters_[parent].left = to;
        clusters_[parent].right = i;
        parent_[to] = parent;
        fit(above);
        fit(parent);
    }

    void replace(std::uint32_t of, std::uint32_t child, std::uint32_t by) {
        (clusters_[of].left == child ? clusters_[of].left : clusters_[of].right) = by;
        parent_[by] = of;
    }

    // This cluster and those above it, to what is in them now.
    void fit(std::uint32_t i) {
        while (true) {
            cost_ -= area_[i];
            clusters_[i] = joined(clusters_, clusters_[i].left, clusters_[i].right);
            area_[i] = surface_area(clusters_[i].box);
            cost_ += area_[i];
            if (i == root_) return;
            i = parent_[i];
        }
    }

    std::vector<cluster>& clusters_;
    std::vector<std::uint32_t> parent_;
    std::vector<double> area_;
    std::vector<place> waiting_;
    std::uint32_t root_, leaf_size_;
    double cost_ = 0;
};

/// Up to so many rounds, as long as they pay. Most scenes need none: to know it, every 16th cluster is tried, of those that will not
/// become a leaf. Only if that pays, it is done in earnest, down to single boxes.
inline void reinsert_where_it_pays(std::vector<cluster>& clusters, std::uint32_t leaf_size, std::uint32_t max_height, std::uint32_t rounds) {
    if (!reinsertion(clusters, leaf_size).round(16, max_height)) return;
    reinsertion all(clusters, 1);
    while (rounds-- > 0 && all.round(1, max_height)) {
    }
}

}  // namespace lantern
