// SPDX-License-Identifier: MIT
#pragma once
// A uniform grid over anything that is bounded, walked cell by cell.

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
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ranges>
#include <span>
#include <string>
#include <vector>

namespace lantern {

struct grid_options {
    double density = 3;  ///< a cube is divided into density * ∛n cells along each side, a square into density * √n
    std::uint64_t max_cells = std::uint64_t{1} << 24;
    std::uint32_t max_entries_per_surface = 64;  ///< on average; where that is not enough, the cells are made larger
};

/// Equal cells, each with the indices of the surfaces whose boxes reach into it. Quick to build, and quickest to walk where
/// surfaces are spread evenly; a teapot in a stadium falls into one cell. A surface whose bounds are empty or not finite is
/// left out, and counted.
class grid {
public:
    explicit grid(std::span<const aabb> boxes, const grid_options& options = {}) {
        if (!(options.density > 0 && options.density <= 1e6)) refuse("grid: density", to_text(options.density), "in (0, 1e6]");
        if (options.max_cells == 0 || options.max_cells >= std::uint64_t{1} << 31)
            refuse("grid: max_cells", std::to_string(options.max_cells), "from 1 to 2^31 - 1");
        if (options.max_entries_per_surface == 0) refuse("grid: max_entries_per_surface", "0", "at least 1");
        build(boxes, options);
    }

    /// Over a range of bounded surfaces: `grid cells{things};`
    template <std::ranges::random_access_range Surfaces>
        requires bounded<std::ranges::range_value_t<Surfaces>>
    explicit grid(const Surfaces& surfaces, const grid_options& options = {}) : grid(boxes_of(surfaces), options) {}

    /// See the concept `accelerator`. Amanatides and Woo, "A fast voxel traversal algorithm for ray tracing", 1987, in whole
    /// steps: where the ray leaves a cell is computed from the cell's integer coordinates, never by adding up. Surfaces reach
    /// `padding_` beyond their boxes, more than all rounding on the way: it does not matter on which side of a face the
    /// walk believes to be. It ends in the cell where the closest hit lies, not in the cell where it was found.
    template <class Offer, class Probe = no_probe>
    void traverse(const ray& r, interval range, Offer&& offer, Probe&& counter = {}) const {
        const slab_ray prepared(r);
        if (entries_.empty() || empty(range) || !overlaps(box_, prepared, range)) return;
        std::array<std::uint32_t, 16> recent;  // a mailbox: who reaches into many cells is not offered in each
        recent.fill(~0u);
        const auto offer_cell = [&](std::uint32_t first, std::uint32_t last) {
            for (std::uint32_t i = first; i < last && !empty(range); ++i) {
                const std::uint32_t index = entries_[i];
                if (recent[index % 16] == index) continue;
                recent[index % 16] = index;
                counter.offer();
                range = offer(index, range);
            }
        };
        // From so far that double cannot tell the cells apart: all of them.
        if (!(0x1p-8 * prepared.padding < padding_)) {
            counter.node();
            return offer_cell(0, static_cast<std::uint32_t>(entries_.size()));
        }

        double t = range.min - 0x1p-22 * std::abs(range.min);  // of the first cell; a hit's t is rounded to float
        for (int i = 0; i < 3; ++i) {
            const double enter = crossing(prepared, i, prepared.reciprocal[i] > 0 ? 0 : count_[i]);
            t = enter > t && enter < std::numeric_limits<double>::infinity() ? enter : t;
        }
        glm::ivec3 cell;
        glm::dvec3 leave;
        for (int i = 0; i < 3; ++i) {
            cell[i] = cell_of(r.origin[i] + t * r.direction[i], i);
            leave[i] = crossing(prepared, i, cell[i] + (prepared.reciprocal[i] > 0));
        }
        while (true) {
            counter.node();
            const std::uint32_t at = number_of(cell);
            offer_cell(starts_[at], starts_[at + 1]);
            const int axis = leave.x < leave.y ? (leave.x < leave.z ? 0 : 2) : (leave.y < leave.z ? 1 : 2);
            if (empty(range) || !(leave[axis] <= range.max + 0x1p-22 * std::abs(range.max))) return;
            const bool forward = prepared.reciprocal[axis] > 0;
            cell[axis] += forward ? 1 : -1;
            if (cell[axis] < 0 || cell[axis] >= count_[axis]) return;
            leave[axis] = crossing(prepared, axis, cell[axis] + forward);
        }
    }

    /// How many surfaces the grid was built over, and how many of them were left out.
    [[nodiscard]] std::uint32_t size() const { return size_; }
    [[nodiscard]] std::uint32_t left_out() const { return left_out_; }

    /// What the grid is made of: for pictures of it, and for tests.
    [[nodiscard]] const aabb& box() const { return box_; }
    [[nodiscard]] glm::ivec3 cells() const { return count_; }
    [[nodiscard]] std::span<const std::uint32_t> entries() const { return entries_; }
    [[nodiscard]] std::span<const std::uint32_t> entries(glm::ivec3 cell) const {
        const std::uint32_t at = number_of(cell);
        return std::span(entries_).subspan(starts_[at], starts_[at + 1] - starts_[at]);
    }

private:
    struct cell_range {
        glm::ivec3 first, last;
    };

    [[nodiscard]] std::uint32_t number_of(glm::ivec3 c) const {
        return static_cast<std::uint32_t>((c.z * count_.y + c.y) * count_.x + c.x);
    }

    // NaN is in cell 0, what lies outside in the nearest one.
    [[nodiscard]] int cell_of(double x, int axis) const {
        const double where = (x - box_.min[axis]) / cell_size_[axis];
        return !(where > 0) ? 0 : where >= count_[axis] ? count_[axis] - 1 : static_cast<int>(where);
    }

    // The t of the face below cell k; infinite where the ray runs beside it. The outermost faces stand off a little.
    [[nodiscard]] double crossing(const slab_ray& r, int axis, int k) const {
        if (std::isinf(r.reciprocal[axis])) return std::numeric_limits<double>::infinity();
        const double face = k == 0            ? box_.min[axis] - padding_
                            : k == count_[axis] ? box_.max[axis] + padding_
                                                : box_.min[axis] + k * cell_size_[axis];
        return (face - r.origin[axis]) * r.reciprocal[axis];
    }

    [[nodiscard]] cell_range cells_of(const aabb& box) const {
        cell_range c;
        for (int i = 0; i < 3; ++i) {
            c.first[i] = cell_of(box.min[i] - padding_, i);
            c.last[i] = cell_of(box.max[i] + padding_, i);
        }
        return c;
    }

    void for_each_cell(const aabb& box, auto&& visit) const {
        const cell_range c = cells_of(box);
        for (int z = c.first.z; z <= c.last.z; ++z)
            for (int y = c.first.y; y <= c.last.y; ++y)
                for (int x = c.first.x; x <= c.last.x; ++x) visit(number_of({x, y, z}));
    }

    // Of cubic cells, density^3 of them for each surface. Along an axis that is shorter than a cell there is one, and
    // the other axes share the rest: density^2 for each surface of a terrain, as many as density for each in a row.
    static double side_of(const glm::dvec3& extent, double surfaces, double density) {
        double side = 0;
        for (int shorter = 0; shorter < 3; ++shorter) {
            double sides = 1, axes = 0;
            for (int i = 0; i < 3; ++i)
                if (extent[i] > side) sides *= extent[i], ++axes;
            if (axes > 0) side = std::pow(sides / surfaces, 1 / axes) / density;
        }
        return side > 0 ? side : 1;
    }

    void build(std::span<const aabb> boxes, const grid_options& options) {
        const std::vector<std::uint32_t> indices = placeable(boxes);
        size_ = static_cast<std::uint32_t>(boxes.size());
        left_out_ = size_ - static_cast<std::uint32_t>(indices.size());
        if (indices.empty()) return;
        for (const std::uint32_t i : indices) box_ = enclose(box_, boxes[i]);
        const glm::dvec3 extent = glm::dvec3(box_.max) - glm::dvec3(box_.min);
        const double longest = std::max({extent.x, extent.y, extent.z});
        padding_ = std::max(0x1p-30 * longest, 0x1p-46 * reach_of(box_));

        // As fine as wished; then coarser, until neither the cells nor the entries are too many.
        for (double side = side_of(extent, double(indices.size()), options.density);; side *= 2) {
            for (int i = 0; i < 3; ++i) {
                count_[i] = static_cast<int>(std::clamp(extent[i] / side, 1.0, 0x1p30));
                cell_size_[i] = extent[i] > 0 ? extent[i] / count_[i] : 1;
            }
            if (count_ == glm::ivec3(1)) break;
            if (double(count_.x) * count_.y * count_.z > double(options.max_cells)) continue;
            double entries = 0;
            for (const std::uint32_t i : indices) {
                const cell_range c = cells_of(boxes[i]);
                const glm::dvec3 n = glm::dvec3(c.last - c.first + 1);
                entries += n.x * n.y * n.z;
            }
            if (entries <= double(options.max_entries_per_surface) * double(indices.size()) && entries < 0x1p32) break;
        }

        // Sorted by cell, by counting: how many in each, where each ends, and back to where it starts.
        starts_.assign(std::size_t(count_.x) * std::size_t(count_.y) * std::size_t(count_.z) + 1, 0);
        for (const std::uint32_t i : indices) for_each_cell(boxes[i], [&](std::uint32_t cell) { ++starts_[cell]; });
        for (std::size_t c = 1; c < starts_.size(); ++c) starts_[c] += starts_[c - 1];
        entries_.resize(starts_.back());
        for (auto i = indices.rbegin(); i != indices.rend(); ++i)
            for_each_cell(boxes[*i], [&](std::uint32_t cell) { entries_[--starts_[cell]] = *i; });
    }

    aabb box_;
    glm::ivec3 count_{0};
    glm::dvec3 cell_size_{0};
    double padding_ = 0;
    std::vector<std::uint32_t> starts_;  // of each cell's entries, and the end
    std::vector<std::uint32_t> entries_;
    std::uint32_t size_ = 0, left_out_ = 0;
};

}  // namespace lantern
