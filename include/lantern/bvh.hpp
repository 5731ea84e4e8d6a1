// SPDX-License-Identifier: MIT
#pragma once
// A bounding volume hierarchy over anything that is bounded, of boxes or of any other bounding volume.

#include <lantern/aabb.hpp>
#include <lantern/bounding_volume.hpp>
#include <lantern/boxes_of.hpp>
#include <lantern/bvh_layout.hpp>
#include <lantern/bvh_quartets.hpp>
#include <lantern/closest.hpp>
#include <lantern/interval.hpp>
#include <lantern/ray.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <ranges>
#include <span>
#include <utility>
#include <vector>

namespace lantern {

/// Volumes in volumes, with indices of surfaces in the leaves. It keeps nothing of the surfaces but their indices, and an
/// index is all it ever offers. A surface whose bounds are empty or not finite is left out, and counted. Whatever the volume,
/// the tree is laid out by boxes; then each node's volume is fitted to all the surfaces below it.
template <bounding_volume Volume = aabb>
class bvh {
public:
    using node = bvh_node<Volume>;

    /// Over a range of bounded surfaces: `bvh tree{things};` or `bvh<obb> tree{things};`
    template <std::ranges::random_access_range Surfaces>
        requires bounded<std::ranges::range_value_t<Surfaces>>
    explicit bvh(const Surfaces& surfaces, const bvh_options& options = {}) {
        const std::vector<aabb> boxes = boxes_of(surfaces);
        bvh_layout layout(boxes, options);
        adopt(boxes.size(), layout);
        if constexpr (std::same_as<Volume, aabb>) {
            adopt_boxes(layout);
        } else {
            std::vector<Volume> volumes;
            for (const std::uint32_t i : indices_) volumes.push_back(volume_of<Volume>(std::ranges::begin(surfaces)[i]));
            fit(layout.nodes(), volumes);
        }
    }

    explicit bvh(std::span<const aabb> boxes, const bvh_options& options = {})
        requires std::same_as<Volume, aabb>
    {
        bvh_layout layout(boxes, options);
        adopt(boxes.size(), layout);
        adopt_boxes(layout);
    }

    /// See the concept `accelerator`. Both children are looked at together; the nearer one comes first (the farther one, if
    /// the offer takes any order), and the other one waits. By the time its turn comes, a closer hit may have cut it off.
    /// Boxes are looked at by fours: see bvh_quartets.hpp.
    template <std::derived_from<ray> Ray, class Offer, class Probe = no_probe>
        requires std::constructible_from<volume_ray<Volume>, const Ray&, interval, const Volume&>
    void traverse(const Ray& r, interval range, Offer&& offer, Probe&& counter = {}) const {
        if (nodes_.empty() || empty(range)) return;
        if constexpr (std::same_as<Volume, aabb>) return fours_.traverse(r, range, in_order_ ? std::span<const std::uint32_t>() : indices_, offer, counter);
        volume_ray<Volume> way(r, range, nodes_[0].volume);
        struct sibling {
            std::uint32_t at;
            float entry;
        };
        std::array<sibling, 64> waiting;  // one a level
        std::size_t count = 0;
        std::uint32_t at = 0;
        float entry, entry_of_second;
        counter.node();
        if (!way.meets(nodes_[0].volume, entry)) return;
        while (true) {
            const node& n = nodes_[at];
            if (n.size == 0) {
                counter.node();
                counter.node();
                const bool first = way.meets(nodes_[n.first].volume, entry);
                const bool second = way.meets(nodes_[n.first + 1].volume, entry_of_second);
                // Written as branches: the processor guesses which way it goes, and fetches that child, while it computes.
                if (first) {
                    at = n.first;
                    if (second) {
                        if (way.second_first(entry, entry_of_second, n.axis) != takes_any_order<Offer>) {
                            waiting[count++] = {n.first, entry};
                            at = n.first + 1;
                        } else {
                            waiting[count++] = {n.first + 1, entry_of_second};
                        }
                    }
                    continue;
                }
                if (second) {
                    at = n.first + 1;
                    continue;
                }
            } else {
                range = offer_each(std::span(indices_).subspan(n.first, n.size), range, offer, counter);
                if (empty(range)) return;
                way.shorten(range.max);
            }
            do {
                if (count == 0) return;
                at = waiting[--count].at;
            } while (!way.still_meets(nodes_[at].volume, waiting[count].entry));
        }
    }

    /// The surfaces in the order of the leaves: those that are looked at together then lie together in memory, which is a third
    /// of the time in large scenes. From now on the tree offers places in *that* order. What was left out is not in it.
    template <std::ranges::random_access_range Surfaces>
    [[nodiscard]] auto put_in_order(const Surfaces& surfaces) {
        std::vector<std::ranges::range_value_t<Surfaces>> sorted;
        sorted.reserve(indices_.size());
        for (std::uint32_t& i : indices_) {
            sorted.push_back(std::ranges::begin(surfaces)[i]);
            i = static_cast<std::uint32_t>(sorted.size() - 1);
        }
        in_order_ = true;
        return sorted;
    }

    /// How many surfaces the tree was built over.
    [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(indices_.size()) + left_out_; }

    /// How many of them were left out, because their bounds are empty or not finite.
    [[nodiscard]] std::uint32_t left_out() const { return left_out_; }

    /// What it keeps in memory, besides itself.
    [[nodiscard]] std::size_t bytes() const { return nodes_.size() * sizeof(node) + indices_.size() * sizeof(std::uint32_t) + fours_.bytes(); }

    /// What the tree is made of: for pictures of it, and for tests.
    [[nodiscard]] std::span<const node> nodes() const { return nodes_; }
    [[nodiscard]] std::span<const std::uint32_t> indices() const { return indices_; }

private:
    void adopt(std::size_t surfaces, bvh_layout& layout) {
        indices_ = std::move(layout.indices());
        left_out_ = static_cast<std::uint32_t>(surfaces - indices_.size());
    }

    void adopt_boxes(bvh_layout& layout) {
        nodes_ = std::move(layout.nodes());
        fours_ = bvh_quartets(nodes_);
    }

    // From the last node to the first: when a parent's turn comes, it is known which stretch of the volumes, in the order of
    // the leaves, each of its children has.
    void fit(std::span<const bvh_node<aabb>> boxes, std::span<const Volume> volumes) {
        nodes_.resize(boxes.size());
        std::vector<std::uint32_t> begin(boxes.size()), end(boxes.size());
        for (std::size_t i = boxes.size(); i-- > 0;) {
            const auto& b = boxes[i];
            begin[i] = b.size > 0 ? b.first : begin[b.first];
            end[i] = b.size > 0 ? b.first + b.size : end[b.first + 1];
            nodes_[i] = {enclose(volumes.subspan(begin[i], end[i] - begin[i])), b.first, b.size, b.axis};
        }
    }

    std::vector<node> nodes_;
    bvh_quartets fours_;  // the same once more, where the volumes are boxes
    std::vector<std::uint32_t> indices_;
    std::uint32_t left_out_ = 0;
    bool in_order_ = false;  // then indices_[i] is i
};

}  // namespace lantern
