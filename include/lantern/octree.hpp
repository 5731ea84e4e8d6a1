// SPDX-License-Identifier: MIT
#pragma once
// An octree over anything that is bounded: space is halved along all three axes at once, where it is crowded.

#include <lantern/aabb.hpp>
#include <lantern/box_ray.hpp>
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
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ranges>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace lantern {

struct octree_options {
    std::uint32_t leaf_size = 4;   ///< a cell with more surfaces is divided, if that pays
    std::uint32_t max_depth = 20;  ///< levels below the root, at most 32
    std::uint32_t max_entries_per_surface = 32;  ///< on average; after that, no cell is divided any more
};

/// Cells in cells, with the indices of the surfaces that reach into the leaves: of one surface, several leaves may know.
/// A surface whose bounds are empty or not finite is left out, and counted.
class octree {
public:
    explicit octree(std::span<const aabb> boxes, const octree_options& options = {}) : options_(options) {
        if (options.leaf_size == 0) refuse("octree: leaf_size", "0", "at least 1");
        if (options.max_depth > 32) refuse("octree: max_depth", std::to_string(options.max_depth), "at most 32");
        if (options.max_entries_per_surface == 0) refuse("octree: max_entries_per_surface", "0", "at least 1");
        std::vector<std::uint32_t> indices = placeable(boxes);
        size_ = static_cast<std::uint32_t>(boxes.size());
        left_out_ = size_ - static_cast<std::uint32_t>(indices.size());
        if (indices.empty()) return;
        aabb all;
        for (const std::uint32_t i : indices) all = enclose(all, boxes[i]);
        entries_left_ = std::uint64_t{options.max_entries_per_surface} * indices.size() - indices.size();
        nodes_.push_back({all, 0, 0, 0});
        divide(boxes, 0, cube_around(all), std::move(indices), options.max_depth);
    }

    /// Over a range of bounded surfaces: `octree cells{things};`
    template <std::ranges::random_access_range Surfaces>
        requires bounded<std::ranges::range_value_t<Surfaces>>
    explicit octree(const Surfaces& surfaces, const octree_options& options = {}) : octree(boxes_of(surfaces), options) {}

    /// See the concept `accelerator`. Of eight octants number i lies before number j on the ray when the bits in which they
    /// differ say so; hence the order 0 … 7 with the bits of the axes turned over along which the ray runs backwards.
    template <class Offer, class Probe = no_probe>
    void traverse(const ray& r, interval range, Offer&& offer, Probe&& counter = {}) const {
        if (nodes_.empty() || empty(range)) return;
        box_ray way(r, range, reach_of(nodes_[0].box));
        float entry;
        std::uint32_t backwards = 0;
        for (int i = 0; i < 3; ++i) backwards |= std::uint32_t{r.direction[i] < 0} << i;
        std::array<std::uint32_t, 8 + 7 * 32> waiting;  // of each level at most seven siblings
        std::size_t count = 0;
        waiting[count++] = 0;
        while (count > 0) {
            const node& n = nodes_[waiting[--count]];
            counter.node();
            if (!way.meets(n.box, entry)) continue;
            if (n.octants != 0) {
                for (std::uint32_t i = 8; i-- > 0;) {  // the last comes first on the stack
                    const std::uint32_t octant = i ^ backwards, below = (1u << octant) - 1;
                    if (n.octants >> octant & 1) waiting[count++] = n.first + bits_set(n.octants & below);
                }
                continue;
            }
            range = offer_each(std::span(entries_).subspan(n.first, n.size), range, offer, counter);
            if (empty(range)) return;
            way.shorten(range.max);
        }
    }

    /// How many surfaces the tree was built over, and how many of them were left out.
    [[nodiscard]] std::uint32_t size() const { return size_; }
    [[nodiscard]] std::uint32_t left_out() const { return left_out_; }

    /// What the tree is made of: for pictures of it, and for tests.
    struct node {
        aabb box;                  ///< of what is in the cell, cut off at the cell's faces: no larger than it
        std::uint32_t first = 0;   ///< of the neighbouring children, or of the leaf's entries
        std::uint32_t size = 0;    ///< entries in a leaf
        std::uint32_t octants = 0; ///< which of eight children there are, one bit each; 0 in a leaf
    };
    [[nodiscard]] std::span<const node> nodes() const { return nodes_; }
    [[nodiscard]] std::span<const std::uint32_t> indices() const { return entries_; }

private:
    [[nodiscard]] static std::uint32_t bits_set(std::uint32_t x) { return static_cast<std::uint32_t>(std::popcount(x)); }

    // With its lower corner at that of the box: what is flat then lies in a face of every cell, not amidst them. Where the sides
    // are too different for float to add, no corner of the box may be left outside.
    static aabb cube_around(const aabb& box) {
        const glm::vec3 size = 0.5f * box.max - 0.5f * box.min;
        const float half = std::max({size.x, size.y, size.z});
        return {box.min, glm::max(box.max, glm::min((box.min + half) + half, glm::vec3(std::numeric_limits<float>::max())))};
    }

    static aabb octant_of(const aabb& cell, std::uint32_t octant) {
        aabb part = cell;
        const glm::vec3 middle = center(cell);
        for (int i = 0; i < 3; ++i) (octant >> i & 1 ? part.min : part.max)[i] = middle[i];
        return part;
    }

    // Whether the box has to do with that half of the cell. What touches the middle only, belongs to one half only; each
    // point of the box is in a closed half to which the box belongs.
    static bool reaches(const aabb& box, const glm::vec3& middle, std::uint32_t octant) {
        for (int i = 0; i < 3; ++i)
            if (octant >> i & 1 ? !(box.max[i] > middle[i]) : !(box.min[i] < middle[i] || box.max[i] <= middle[i])) return false;
        return true;
    }

    static aabb cut_off(const aabb& box, const aabb& cell) { return {glm::max(box.min, cell.min), glm::min(box.max, cell.max)}; }

    void become_leaf(std::uint32_t at, const std::vector<std::uint32_t>& indices) {
        nodes_[at].first = static_cast<std::uint32_t>(entries_.size());
        nodes_[at].size = static_cast<std::uint32_t>(indices.size());
        entries_.insert(entries_.end(), indices.begin(), indices.end());
    }

    // Divides while the children would cost less than three quarters of what the leaf would: the sum of their numbers of
    // surfaces, each times the share of the rays through this cell that pass through it, as the surface areas say. And while
    // hardly a surface reaches into two children: in a crowd that the middle just misses, the next division pays.
    void divide(std::span<const aabb> boxes, std::uint32_t at, const aabb& cell, std::vector<std::uint32_t> indices,
                std::uint32_t levels) {
        const glm::vec3 middle = center(cell);
        if (indices.size() <= options_.leaf_size || levels == 0) return become_leaf(at, indices);
        std::array<std::vector<std::uint32_t>, 8> parts;
        std::array<aabb, 8> content;
        double cost = 0, entries = 0;
        for (std::uint32_t octant = 0; octant < 8; ++octant) {
            const aabb part = octant_of(cell, octant);
            for (const std::uint32_t i : indices) {
                if (!reaches(boxes[i], middle, octant)) continue;
                parts[octant].push_back(i);
                content[octant] = enclose(content[octant], cut_off(boxes[i], part));
            }
            cost += surface_area(content[octant]) * double(parts[octant].size());
            entries += double(parts[octant].size());
        }
        const double more = std::max(0.0, entries - double(indices.size()));
        const bool pays = cost < 0.75 * surface_area(nodes_[at].box) * double(indices.size()) || more <= 0.1 * double(indices.size());
        if (!pays || more > double(entries_left_)) return become_leaf(at, indices);
        entries_left_ -= static_cast<std::uint64_t>(more);
        indices = {};

        const auto first = static_cast<std::uint32_t>(nodes_.size());
        nodes_[at].first = first;
        for (std::uint32_t octant = 0; octant < 8; ++octant) {
            if (parts[octant].empty()) continue;
            nodes_[at].octants |= 1u << octant;
            nodes_.push_back({content[octant], 0, 0, 0});
        }
        std::uint32_t child = first;
        for (std::uint32_t octant = 0; octant < 8; ++octant)
            if (!parts[octant].empty()) divide(boxes, child++, octant_of(cell, octant), std::move(parts[octant]), levels - 1);
    }

    std::vector<node> nodes_;
    std::vector<std::uint32_t> entries_;
    std::uint64_t entries_left_ = 0;
    std::uint32_t size_ = 0, left_out_ = 0;
    octree_options options_;
};

}  // namespace lantern
