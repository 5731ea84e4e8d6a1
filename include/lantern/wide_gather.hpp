// SPDX-License-Identifier: MIT
#pragma once
// What wide_bvh is built over: the triangles' boxes, read by several threads, and which of the triangles are needles.

#include <lantern/aabb.hpp>
#include <lantern/boxes_of.hpp>
#include <lantern/triangle.hpp>
#include <lantern/wide_build.hpp>
#include <lantern/wide_split.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace lantern::wide {

struct gathered {
    item_list items;
    needles thin;
    float reach = 0;  ///< the largest coordinate

    /// Those of the `count` triangles from `begin` on that are finite. Shares of one size are read by whatever thread is free, and
    /// put together in their order, so that all sums are the same with any number of threads.
    gathered(const auto& begin, std::uint32_t count, helpers& others) : items(count) {
        struct share {
            needles thin;
            float reach = 0;
            std::uint32_t kept = 0;
        };
        constexpr std::uint32_t size = 1u << 14;
        std::vector<share> shares((count + size - 1) / size);
        const auto read = [&](auto&& self, std::size_t from, std::size_t to) -> void {
            if (to - from > 1) {
                const std::size_t middle = (from + to) / 2;
                return others.both(true, [&] { self(self, from, middle); }, [&] { self(self, middle, to); });
            }
            share s;  // apart from the others', whose memory is near
            const auto first = static_cast<std::uint32_t>(from) * size, last = std::min(first + size, count);
            for (std::uint32_t i = first; i < last; ++i) {
                const triangle t = begin[i];
                const aabb box = bounds(t);
                if (empty(box)) continue;
                item& next = items[first + s.kept++];
                next = {box.min, i, box.max, 0};
                s.thin.add(t, next);
                s.reach = std::max(s.reach, static_cast<float>(reach_of(box)));
            }
            shares[from] = std::move(s);
        };
        if (count > 0) read(read, 0, shares.size());
        std::size_t kept = 0, from = 0;
        for (const share& s : shares) {
            if (kept < from) std::copy_n(items.begin() + static_cast<std::ptrdiff_t>(from), s.kept, items.begin() + static_cast<std::ptrdiff_t>(kept));
            kept += s.kept;
            from += size;
            thin.append(s.thin);
            reach = std::max(reach, s.reach);
        }
        items.resize(kept);
    }
};

}  // namespace lantern::wide
