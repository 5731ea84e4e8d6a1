// SPDX-License-Identifier: MIT
#pragma once
// Where to cut a crowd of boxes in two, for a hierarchy that is built from the top down.

#include <lantern/aabb.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace lantern {

/// How it is decided which surfaces go into which of a node's two children.
enum class split {
    middle,        ///< at the middle of their centres: cheap to find, blind to crowds
    median,        ///< half of them each: balanced, blind to space
    surface_area,  ///< where the expected number of tests is least (Goldsmith and Salmon 1987), over 16 bins (Wald 2007)
    bottom_up      ///< the nearest are joined first, and so on up to the root: see agglomerate.hpp
};

/// How many go to the lower child, and along which axis. None: there is no cut.
struct bvh_cut {
    std::uint32_t lower = 0;
    std::uint32_t axis = 0;
};

/// Boxes, which of them are to be cut in two, and the box around these boxes' centers. A cut reorders the indices: those of the lower
/// child come first.
struct crowd {
    std::span<const aabb> boxes;
    std::span<std::uint32_t> indices;
    aabb centers;

    [[nodiscard]] bvh_cut cut_middle() const {
        const std::uint32_t axis = longest_axis(centers);
        const float middle = center(centers)[int(axis)];
        return {partition([&](std::uint32_t i) { return center(boxes[i])[int(axis)] < middle; }), axis};
    }

    [[nodiscard]] bvh_cut cut_median() const {
        const std::uint32_t axis = longest_axis(centers), half = static_cast<std::uint32_t>(indices.size() / 2);
        std::nth_element(indices.begin(), indices.begin() + half, indices.end(), [&](std::uint32_t a, std::uint32_t b) {
            const float ca = center(boxes[a])[int(axis)], cb = center(boxes[b])[int(axis)];
            return ca < cb || (ca == cb && a < b);
        });
        return {half, axis};
    }

    /// Of 15 cuts on each axis the one with the least sum, over both children, of area times number of surfaces. None
    /// where there is no area to compare, as of points on a line, and none where the sum is not below `least`.
    [[nodiscard]] bvh_cut cut_by_surface_area(double least) const {
        int best_axis = 0;
        std::uint32_t best_bin = bins;
        for (int axis = 0; axis < 3; ++axis) {
            std::array<aabb, bins> box{};
            std::array<std::uint32_t, bins> size{};
            for (const std::uint32_t i : indices) {
                const std::uint32_t b = bin_of(i, axis);
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
        if (!(least > 0 && best_bin < bins)) return {};
        return {partition([&](std::uint32_t i) { return bin_of(i, best_axis) < best_bin; }), static_cast<std::uint32_t>(best_axis)};
    }

private:
    static constexpr std::uint32_t bins = 16;

    // The bin of a center; all centers of a degenerate axis share bin 0.
    [[nodiscard]] std::uint32_t bin_of(std::uint32_t i, int axis) const {
        const double low = centers.min[axis], extent = double(centers.max[axis]) - low;
        const double where = extent > 0 ? (double(center(boxes[i])[axis]) - low) / extent * bins : 0;
        return std::min(static_cast<std::uint32_t>(where), bins - 1);
    }

    [[nodiscard]] std::uint32_t partition(auto&& below) const {
        return static_cast<std::uint32_t>(std::partition(indices.begin(), indices.end(), below) - indices.begin());
    }
};

}  // namespace lantern
