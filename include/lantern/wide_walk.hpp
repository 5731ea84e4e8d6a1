// SPDX-License-Identifier: MIT
#pragma once
// How a ray goes through a wide_bvh: step by step, each step a node of eight boxes or a few packets of triangles.

#include <lantern/box_packet.hpp>
#include <lantern/closest.hpp>
#include <lantern/interval.hpp>
#include <lantern/lanes.hpp>
#include <lantern/precise.hpp>
#include <lantern/ray.hpp>
#include <lantern/triangle.hpp>
#include <lantern/triangle_packet.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>

namespace lantern::wide {

/// Eight boxes and what is in them.
struct node {
    box_packet boxes;
    std::uint32_t child[8]{1, 1, 1, 1, 1, 1, 1, 1};  ///< see `word`; 1 is the packet of nothing with which the tree begins
};

/// Nodes and packets lie in one array of these, so that either can be fetched ahead without asking which it is.
struct alignas(32) block {
    std::byte bytes[32];
};
inline constexpr std::uint32_t node_blocks = sizeof(node) / sizeof(block);
inline constexpr std::uint32_t packet_blocks = sizeof(triangle_packet) / sizeof(block);
static_assert(sizeof(node) == 224 && sizeof(triangle_packet) == 160);

/// Where a child begins, in units of four bytes: an address is one addition away. Blocks are eight of these, so the lowest
/// three bits are free to say how many packets it is, from one to seven; zero is a node.
[[nodiscard]] constexpr std::uint32_t word(std::size_t block, std::uint32_t packets) {
    return static_cast<std::uint32_t>(block * sizeof(wide::block) / 4) + packets;
}

/// The other way round.
[[nodiscard]] constexpr std::uint32_t block_of(std::uint32_t word) { return word / std::uint32_t{sizeof(block) / 4}; }

/// The block that a child's word leads to, if its packets are taken off.
[[nodiscard, gnu::always_inline]] inline const std::byte* at(const std::byte* tree, std::uint32_t word) {
    return tree + std::size_t{word} * 4;
}

/// Fetched into the cache ahead: a node takes four of its lines. (GCC 12 leaves out calls of functions that do no more than
/// this, unless they are inlined always.)
[[gnu::always_inline]] inline void fetch(const std::byte* tree, std::uint32_t word) {
    for (std::size_t line = 0; line < 4; ++line) __builtin_prefetch(at(tree, word) + 64 * line);
}

/// A ray on its way through the tree.
struct traveller {
    const ray* given;
    box_packet_ray boxes;
    sheared_ray triangles;
    interval range;
    float min, max;         ///< of the range, as the boxes count
    std::int32_t farthest;  ///< the bits of max, and some slack
    std::uint32_t next;     ///< the node or packet to go to
    std::uint64_t* bottom;  ///< of what waits: the distance's bits above the child's word, so that comparing keys compares distances
    std::uint64_t* top;

    // In place: the processor waits where a vector is read back that was written in parts.
    [[gnu::always_inline]] traveller(const ray& ray, interval all, float reach, std::uint32_t root, std::uint64_t* waiting)
        : given(&ray), boxes(ray, reach), triangles(ray, reach), range{std::max(all.min, 0.0f), all.max}, min(range.min * boxes.per_unit),
          max(range.max * boxes.per_unit), farthest(bits(max) + slack), next(root), bottom(waiting), top(waiting) {}

    [[gnu::always_inline]] void shorten(float to) {
        range.max = to;
        max = to * boxes.per_unit;
        farthest = bits(max) + slack;
    }
};

/// The triangle itself is asked, for the lanes where a packet is not sure.
[[nodiscard, gnu::noinline]] inline std::optional<precise::hit> ask(const triangle_packet& p, std::size_t lane, const ray& r,
                                                                    interval range) {
    return intersect(p[lane], precise::widen(r), range);
}

/// What `closest` keeps of the best hit so far: enough to say at the very end where it is.
struct best_hit {
    const triangle_packet* packet = nullptr;
    std::uint32_t lane = 0, index = 0;
    bool sure = false;  ///< the packet was; so is the triangle, whose bounds of the error are smaller
    float t = 0;

    [[gnu::always_inline]] bool visit(const triangle_packet& p, std::uint32_t lanes, const packet_sides& sides, traveller& r, auto& counter) {
        packet_hits hits;
        const std::uint32_t decided = meets_plane(p, r.triangles, *r.given, lanes, sides, hits);
        const doubles all = hits.above / hits.speed;
        do {
            counter.offer();
            const auto i = static_cast<std::uint32_t>(std::countr_zero(lanes));
            const bool certain = (decided >> i & 1) != 0;
            float found = static_cast<float>(all[i]);
            if (!certain) [[unlikely]] {
                const auto h = ask(p, i, *r.given, r.range);
                found = h ? static_cast<float>(h->t) : infinity;
            }
            if (contains(r.range, found) && (found < r.range.max || packet == nullptr || p.index[i] < index)) {
                packet = &p;
                lane = i;
                index = p.index[i];
                t = found;
                sure = (hits.alike >> i & 1) != 0;
                r.shorten(found);
            }
        } while ((lanes &= lanes - 1) != 0);
        return true;
    }

    [[nodiscard, gnu::always_inline]] std::optional<nearest> result(const ray& given) const {
        if (packet == nullptr) return std::nullopt;
        if (!sure) [[unlikely]] {
            const auto h = ask(*packet, lane, given, interval{});
            return h ? std::optional(nearest{rounded(*h), index}) : std::nullopt;
        }
        return nearest{hit_at((*packet)[lane], given, t), index};
    }
};

/// What `occluded` keeps.
struct any_hit {
    bool found = false;

    [[gnu::always_inline]] bool visit(const triangle_packet& p, std::uint32_t lanes, const packet_sides& sides, const traveller& r, auto& counter) {
        packet_hits hits;
        const std::uint32_t decided = meets_plane(p, r.triangles, *r.given, lanes, sides, hits);
        // Well within the range? That takes no division.
        const double first = std::max(r.range.min * (1 + 0x1p-20), 0x1p-126);
        const double last = std::min(r.range.max, std::numeric_limits<float>::max()) * (1 - 0x1p-20);
        doubles height, slope;
        magnitude(hits.speed, slope);
        signed_as(hits.above, hits.speed, height);
        found = (lanes & decided & lanes_less(first * slope, height) & lanes_less(height, last * slope)) != 0;
        for (; !found && lanes != 0; lanes &= lanes - 1) {
            counter.offer();
            const auto i = static_cast<std::uint32_t>(std::countr_zero(lanes));
            if ((decided >> i & 1) != 0) [[likely]]
                found = contains(r.range, static_cast<float>(hits.above[i] / hits.speed[i]));
            else
                found = ask(p, i, *r.given, r.range).has_value();
        }
        return !found;
    }
};

/// What `traverse` does.
template <class Offer>
struct offering {
    Offer& offer;
    bool visit(const triangle_packet& p, std::uint32_t lanes, const packet_sides&, traveller& r, auto& counter) {
        for (; lanes != 0 && !empty(r.range); lanes &= lanes - 1) {
            counter.offer();
            r.range = offer(p.index[std::countr_zero(lanes)], r.range);
        }
        r.shorten(r.range.max);
        return !empty(r.range);
    }
};

// Without a branch, which compilers make of std::min.
[[gnu::always_inline]] inline void order(std::uint64_t& near, std::uint64_t& far) {
    const std::uint64_t exchange = (near ^ far) & -std::uint64_t{far < near};
    near ^= exchange;
    far ^= exchange;
}

/// Which of the children that a ray meets it goes to first. Closest hits are found from the nearest on. For any hit the order is free,
/// and need not be computed: children lie in the order in which they were cut apart, lower ones first, so that the ray's direction says at
/// which end the far ones are. Those come first: near its origin, on a surface most often, a ray is in many boxes, and seldom meets what is in them.
enum class visiting { nearest_first, upper_first, lower_first };

[[nodiscard]] inline visiting far_end_first(const ray& r) {
    return r.direction.x + r.direction.y + r.direction.z > 0 ? visiting::upper_first : visiting::lower_first;
}

/// From a node on: goes to a child that is met; the others wait. False where none is met.
template <visiting order_of>
[[gnu::always_inline]] inline bool enter(const std::byte* tree, const node& n, traveller& r) {
    floats entry;
    std::uint32_t met = overlaps(n.boxes, r.boxes, r.min, r.max, entry);
    if (met == 0) return false;
    const std::uint32_t first = n.child[std::countr_zero(met)];
    std::uint32_t rest = met & (met - 1);
    if (rest == 0) {
        r.next = first;
        return true;
    }
    if constexpr (order_of != visiting::nearest_first) {
        constexpr bool upper_last = order_of == visiting::upper_first;  // the last one is gone to
        const auto high = [](std::uint32_t lanes) { return 31 - std::countl_zero(lanes); };
        r.next = upper_last ? first : n.child[high(met)];
        if (!upper_last) rest = met ^ 1u << high(met);
        fetch(tree, r.next);
        do {
            *r.top++ = r.next;
            const int i = upper_last ? std::countr_zero(rest) : high(rest);
            r.next = n.child[i];
            fetch(tree, r.next);
            rest = upper_last ? rest & (rest - 1) : rest ^ 1u << i;
        } while (rest != 0);
        return true;
    }
    std::array<std::uint32_t, 8> distance;
    std::memcpy(distance.data(), &entry, sizeof entry);
    const auto key = [&](std::uint32_t lanes) __attribute__((always_inline)) {
        const auto i = static_cast<std::size_t>(std::countr_zero(lanes));
        fetch(tree, n.child[i]);
        return std::uint64_t{distance[i]} << 32 | n.child[i];
    };
    std::uint64_t a = key(met), b = key(rest);
    order(a, b);
    if ((rest &= rest - 1) == 0) {
        *r.top++ = b;
        r.next = static_cast<std::uint32_t>(a);
        return true;
    }
    std::uint64_t c = key(rest);
    order(b, c);
    order(a, b);
    r.top[0] = c;
    r.top[1] = b;
    r.top[2] = a;
    std::uint64_t* const farthest = r.top;  // more than three, seldom: they are sorted in, the nearest last
    r.top += 2;
    while ((rest &= rest - 1) != 0) {
        const std::uint64_t k = key(rest);
        std::uint64_t* at = ++r.top;
        for (; at > farthest && at[-1] < k; --at) *at = at[-1];
        *at = k;
    }
    r.next = static_cast<std::uint32_t>(*r.top);
    return true;
}

/// Looks at a node or a packet. False when there is nothing left to look at.
template <visiting order_of, class Probe, class Visitor>
[[gnu::always_inline]] inline bool step(const std::byte* tree, traveller& r, Visitor& visitor, Probe& counter) {
    counter.node();
    if (std::uint32_t packets = r.next & 7; packets == 0) {
        if (enter<order_of>(tree, *reinterpret_cast<const node*>(at(tree, r.next)), r)) return true;
    } else {
        const auto* packet = reinterpret_cast<const triangle_packet*>(at(tree, r.next - packets));
        do {
            packet_sides sides;
            const std::uint32_t lanes = passes_through(*packet, r.triangles, sides);
            if (lanes != 0 && !visitor.visit(*packet, lanes, sides, r, counter)) return false;
            ++packet;
        } while (--packets != 0);
    }
    do {
        if (r.top == r.bottom) return false;
        r.next = static_cast<std::uint32_t>(*--r.top);
    } while (order_of == visiting::nearest_first && static_cast<std::int32_t>(*r.top >> 32) > r.farthest);
    return true;
}

}  // namespace lantern::wide
