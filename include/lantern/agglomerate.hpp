// SPDX-License-Identifier: MIT
#pragma once
// Joining what lies together, from the bottom up: boxes to pairs, pairs to clusters, until one is left.

#include <lantern/aabb.hpp>

#include <glm/vec3.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

namespace lantern {

struct cluster {
    aabb box;
    std::uint32_t left = 0;    ///< a cluster; of one box its index
    std::uint32_t right = 0;   ///< a cluster
    std::uint32_t size = 1;    ///< boxes in it
    std::uint32_t height = 0;  ///< levels below it; 0 for one box
};

/// Two clusters as one.
[[nodiscard]] inline cluster joined(std::span<const cluster> clusters, std::uint32_t left, std::uint32_t right) {
    const cluster &a = clusters[left], &b = clusters[right];
    return {enclose(a.box, b.box), left, right, a.size + b.size, std::max(a.height, b.height) + 1};
}

/// Where p lies in the box on a curve that visits near points one after the other: the bits of x, y, z interleaved (Morton
/// 1966), 21 of each.
[[nodiscard]] inline std::uint64_t morton_code(glm::vec3 p, const aabb& box) {
    std::uint64_t code = 0;
    for (int i = 0; i < 3; ++i) {
        const double low = box.min[i], extent = double(box.max[i]) - low;
        const double where = extent > 0 ? (double(p[i]) - low) / extent : 0;
        const auto cell = static_cast<std::uint64_t>(std::clamp(where, 0.0, 1.0) * 0x1fffff);
        for (int bit = 0; bit < 21; ++bit) code |= (cell >> bit & 1) << (3 * bit + i);
    }
    return code;
}

/// The clusters, the one of all boxes last; at least one index is asked for. Locally-ordered clustering (Meister and Bittner,
/// "Parallel locally-ordered clustering for bounding volume hierarchy construction", 2018): along the curve each cluster
/// looks 16 places to either side for the partner with whom its box would have the least surface, and those who find
/// each other are joined. Where hardly any do, as among concentric boxes, neighbours are joined; so the number of
/// clusters shrinks by a sixteenth each time at least, and the time is O(n log n) whatever the boxes are.
[[nodiscard]] inline std::vector<cluster> agglomerate(std::span<const aabb> boxes, std::vector<std::uint32_t> indices) {
    aabb centers;
    for (const std::uint32_t i : indices) centers = enclose(centers, center(boxes[i]));
    std::vector<std::uint64_t> codes(boxes.size());
    for (const std::uint32_t i : indices) codes[i] = morton_code(center(boxes[i]), centers);
    std::sort(indices.begin(), indices.end(),
              [&](std::uint32_t a, std::uint32_t b) { return codes[a] < codes[b] || (codes[a] == codes[b] && a < b); });
    std::vector<cluster> clusters;
    clusters.reserve(2 * indices.size());
    for (const std::uint32_t i : indices) clusters.push_back({boxes[i], i});

    constexpr std::uint32_t reach = 16;
    std::vector<std::uint32_t> active(indices.size()), partner, next;
    std::iota(active.begin(), active.end(), 0u);
    while (active.size() > 1) {
        const auto count = static_cast<std::uint32_t>(active.size());
        partner.assign(count, 0);
        for (std::uint32_t i = 0; i < count; ++i) {
            double least = std::numeric_limits<double>::infinity();
            for (std::uint32_t j = i > reach ? i - reach : 0; j < std::min(i + reach + 1, count); ++j) {
                if (j == i) continue;
                const double area = surface_area(enclose(clusters[active[i]].box, clusters[active[j]].box));
                // Of equals the one with the smallest i ^ j: this is mutual, so that duplicates pair off at once.
                if (area < least || (area == least && (i ^ j) < (i ^ partner[i]))) least = area, partner[i] = j;
            }
        }
        std::uint32_t mutual = 0;
        for (std::uint32_t i = 0; i < count; ++i) mutual += partner[partner[i]] == i;
        if (mutual < count / 8)
            for (std::uint32_t i = 0; i < count; ++i) partner[i] = (i ^ 1) < count ? i ^ 1 : i;
        next.clear();
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t j = partner[i];
            if (j == i || partner[j] != i) next.push_back(active[i]);
            if (partner[j] != i || i >= j) continue;
            next.push_back(static_cast<std::uint32_t>(clusters.size()));
            clusters.push_back(joined(clusters, active[i], active[j]));
        }
        active.swap(next);
    }
    return clusters;
}

/// Appends the indices of the boxes in it.
inline void collect(std::span<const cluster> clusters, const cluster& top, std::vector<std::uint32_t>& indices) {
    std::vector<const cluster*> waiting{&top};  // not by recursion: a chain of clusters may be as long as there are boxes
    while (!waiting.empty()) {
        const cluster& c = *waiting.back();
        waiting.pop_back();
        if (c.height == 0) {
            indices.push_back(c.left);
            continue;
        }
        waiting.push_back(&clusters[c.right]);
        waiting.push_back(&clusters[c.left]);
    }
}

}  // namespace lantern
