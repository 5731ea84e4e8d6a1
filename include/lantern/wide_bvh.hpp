// SPDX-License-Identifier: MIT
#pragma once
// The fast hierarchy, over triangles: eight boxes are tested at once, then four triangles; and it is never wrong.

#include <lantern/box_packet.hpp>
#include <lantern/closest.hpp>
#include <lantern/interval.hpp>
#include <lantern/lanes.hpp>
#include <lantern/large_pages.hpp>
#include <lantern/mesh.hpp>
#include <lantern/ray.hpp>
#include <lantern/triangle.hpp>
#include <lantern/triangle_packet.hpp>
#include <lantern/validate.hpp>
#include <lantern/wide_build.hpp>
#include <lantern/wide_collapse.hpp>
#include <lantern/wide_gather.hpp>
#include <lantern/wide_walk.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <new>
#include <optional>
#include <ranges>
#include <span>
#include <string>
#include <thread>
#include <vector>

namespace lantern {

struct wide_bvh_options {
    unsigned threads = 0;  ///< for the build; 0: as many as the machine has
};

/// It keeps the triangles themselves, four in a packet, and needs no mesh to find a hit: `closest(tree, ray)`. It is an
/// accelerator, too, and then offers only triangles that the ray's line passes through; a needle perhaps more than once. What it
/// answers is what `every` answers, to the last bit. Only what lies ahead of a ray's origin is found, whatever the range says.
class wide_bvh {
    using binary_tree = wide::binary_tree;
    static constexpr wide::visiting nearest_first = wide::visiting::nearest_first;

public:
    /// Over a mesh, or any range of triangles, fewer than 2^27 (134 million). One that is not finite is left out, and
    /// counted. Throws std::invalid_argument where a coordinate is 2^60 (1.15e18) or more: the boxes' arithmetic would overflow.
    template <std::ranges::random_access_range Triangles>
        requires std::same_as<std::ranges::range_value_t<Triangles>, triangle>
    explicit wide_bvh(const Triangles& triangles, const wide_bvh_options& options = {}) {
        const auto count = static_cast<std::size_t>(std::ranges::size(triangles));
        if (count >= std::size_t{1} << 27) refuse("wide_bvh: the number of triangles", std::to_string(count), "below 2^27");
        size_ = static_cast<std::uint32_t>(count);
        wide::helpers others(options.threads > 0 ? options.threads : std::max(1u, std::thread::hardware_concurrency()));
        const auto begin = std::ranges::begin(triangles);
        wide::gathered all(begin, size_, others);
        wide::item_list& items = all.items;
        reach_ = all.reach;
        if (!(reach_ < 0x1p60f)) refuse("wide_bvh: a coordinate", to_text(reach_), "less than 2^60");
        left_out_ = size_ - static_cast<std::uint32_t>(items.size());
        if (items.empty()) return;
        const std::size_t thin = all.thin.count(items);
        std::optional<binary_tree> tree;
        std::size_t blocks = 0;
        const auto plant = [&](bool by_length) {
            tree.emplace(items, by_length, others);
            blocks = wide::packet_blocks + measure(*tree, 0);  // one packet of nothing comes first: unused slots of nodes lead there
        };
        // A few long thin triangles are cut up; but if they are many, that would take too much memory.
        std::size_t cuts = items.size() * 3 / 10;
        if (thin > 0 && thin <= cuts) {
            const auto triangle_of = [&](std::uint32_t i) -> triangle { return begin[i]; };
            for (;;) {
                all.thin.cut(items, triangle_of, cuts);
                plant(false);
                if (blocks * sizeof(wide::block) <= most_bytes * count) break;
                cuts /= 2;
                tree.reset();
                items = wide::gathered(begin, size_, others).items;  // they have been cut, and put in another order
                if (thin > cuts) break;
            }
        }
        if (!tree) plant(thin > 0);
        if (blocks >= std::size_t{1} << 29) refuse("wide_bvh: the memory for it", std::to_string(blocks * sizeof(wide::block)), "below 2^34 bytes");
        blocks_.resize(blocks);
        put(0, triangle_packet{});
        const auto packet = [&](std::uint32_t first, std::uint32_t number) {
            triangle_packet p;
            for (std::uint32_t i = 0; i < number; ++i) {
                const std::uint32_t index = items[first + i].index;
                p.set(i, begin[index], index);
            }
            return p;
        };
        root_ = lay_out(*tree, 0, wide::packet_blocks, packet, others);
    }

    /// See the concept `accelerator`.
    template <class Offer, class Probe = no_probe>
    void traverse(const ray& r, interval range, Offer&& offer, Probe&& counter = {}) const {
        wide::offering<Offer> visitor{offer};
        walk<nearest_first>(r, range, counter, visitor);
    }

    template <class Probe>
    [[nodiscard]] std::optional<nearest> closest(const ray& ray, interval range, Probe& counter) const {
        wide::best_hit best;
        walk<nearest_first>(ray, range, counter, best);
        return best.result(ray);
    }

    /// Rays that have nothing to do with each other wait for memory most of the time. So several are on their way at once,
    /// and while the next node of one is fetched, the others take their steps.
    void closest(std::span<const ray> rays, std::span<std::optional<nearest>> hits, interval range) const {
        if (hits.size() != rays.size())
            refuse("wide_bvh: the number of hits", std::to_string(hits.size()), "that of the rays, " + std::to_string(rays.size()));
        struct flight {
            wide::traveller r;
            wide::best_hit best;
            std::size_t number;
        };
        constexpr std::size_t most = 16;
        std::array<stack, most> waiting;
        std::array<std::optional<flight>, most> flights;
        std::array<std::size_t, most> flying;
        std::size_t count = 0, boarded = 0;
        const auto board = [&](std::size_t i) {
            for (; boarded < rays.size(); ++boarded) {
                hits[boarded] = std::nullopt;
                if (!worthwhile(rays[boarded], range)) continue;
                flights[i].emplace(wide::traveller(rays[boarded], range, reach_, root_, waiting[i].data()), wide::best_hit(), boarded);
                ++boarded;
                return true;
            }
            return false;
        };
        for (std::size_t i = 0; i < most && board(i); ++i) flying[count++] = i;
        if (count == 0) return;
        const std::byte* const tree = blocks_.data()->bytes;
        no_probe counter;
        while (count > 0)
            for (std::size_t k = 0; k < count;) {
                flight& f = *flights[flying[k]];
                if (wide::step<nearest_first>(tree, f.r, f.best, counter)) {
                    wide::fetch(tree, f.r.next);
                    ++k;
                } else {
                    hits[f.number] = f.best.result(rays[f.number]);
                    if (board(flying[k]))
                        ++k;
                    else
                        flying[k] = flying[--count];
                }
            }
    }

    template <class Probe>
    [[nodiscard]] bool occluded(const ray& r, interval range, Probe& counter) const {
        wide::any_hit any;
        if (wide::far_end_first(r) == wide::visiting::upper_first)
            walk<wide::visiting::upper_first>(r, range, counter, any);
        else
            walk<wide::visiting::lower_first>(r, range, counter, any);
        return any.found;
    }

    /// How many triangles it was built over, and how many of them were left out because they are not finite.
    [[nodiscard]] std::uint32_t size() const { return size_; }
    [[nodiscard]] std::uint32_t left_out() const { return left_out_; }

    /// All that it keeps.
    [[nodiscard]] std::size_t bytes() const { return blocks_.size() * sizeof(wide::block); }

private:
    template <class T>
    void put(std::size_t where, const T& thing) {
        ::new (static_cast<void*>(&blocks_[where])) T(thing);
    }

    /// How many blocks a branch takes.
    static std::uint32_t measure(binary_tree& tree, std::uint32_t root) {
        std::uint32_t& sum = tree[root].blocks;
        if (tree[root].cost.leaf) return sum = wide::packet_blocks * wide::packets(tree[root].count);
        const wide::children slots(tree, root);
        sum = wide::node_blocks;
        for (std::size_t i = 0; i < slots.count; ++i) sum += measure(tree, slots.at[i]);
        return sum;
    }

    /// From a block on: a node, then its packets, then the nodes below.
    std::uint32_t lay_out(const binary_tree& tree, std::uint32_t root, std::uint32_t where, const auto& packet,
                          wide::helpers& others) {
        if (const auto& leaf = tree[root]; leaf.cost.leaf) {
            constexpr std::uint32_t full = wide::packet_size;
            for (std::uint32_t i = 0, at = where; i < leaf.count; i += full, at += wide::packet_blocks)
                put(at, packet(leaf.first + i, std::min(leaf.count - i, full)));
            return wide::word(where, wide::packets(leaf.count));
        }
        const wide::children slots(tree, root);
        wide::node n;
        std::uint32_t at = where + wide::node_blocks;
        for (const bool inner : {false, true})
            for (std::size_t i = 0; i < slots.count; ++i) {
                const auto& b = tree[slots.at[i]];
                if (b.cost.leaf == inner) continue;
                n.boxes.set(i, b.box);
                n.child[i] = wide::word(at, inner ? 0 : wide::packets(b.count));
                at += b.blocks;
            }
        put(where, n);
        const auto lay_out_from = [&](auto&& self, std::size_t i) -> void {
            const auto one = [&] { lay_out(tree, slots.at[i], wide::block_of(n.child[i]), packet, others); };
            if (i + 1 == slots.count) return one();
            others.both(tree[slots.at[i]].count > wide::few, one, [&] { self(self, i + 1); });
        };
        lay_out_from(lay_out_from, 0);
        return wide::word(where, 0);
    }

    // For each triangle, if needles are cut; without that it takes about fifty.
    static constexpr std::size_t most_bytes = 70;

    // A level leaves seven siblings behind.
    using stack = std::array<std::uint64_t, 7 * binary_tree::max_depth + 8>;

    // Finite, with a direction, and something ahead.
    [[nodiscard]] bool worthwhile(const ray& r, interval range) const {
        const quad o{r.origin.x, r.origin.y, r.origin.z}, d{r.direction.x, r.direction.y, r.direction.z}, zero{};
        const bool finite = lanes_of(quad_integers(o - o == d - d)) == 15;  // infinity and NaN give NaN
        return finite && lanes_of(quad_integers(d != zero)) != 0 && !blocks_.empty() && !empty(range) && range.max > 0;
    }

    template <wide::visiting order_of, class Probe, class Visitor>
    [[gnu::always_inline]] void walk(const ray& ray, interval range, Probe& counter, Visitor& visitor) const {
        if (!worthwhile(ray, range)) return;
        stack waiting;
        wide::traveller r(ray, range, reach_, root_, waiting.data());
        while (wide::step<order_of>(blocks_.data()->bytes, r, visitor, counter)) {
        }
    }

    std::vector<wide::block, large_page_allocator<wide::block>> blocks_;
    std::uint32_t root_ = 0;
    std::uint32_t size_ = 0, left_out_ = 0;
    float reach_ = 0;
};

template <std::derived_from<ray> Ray, class Probe = no_probe>
[[nodiscard]] std::optional<nearest> closest(const wide_bvh& tree, const Ray& r, interval range = {}, Probe&& counter = {}) {
    return tree.closest(r, range, counter);
}
template <std::derived_from<ray> Ray, class Probe = no_probe>
[[nodiscard]] bool occluded(const wide_bvh& tree, const Ray& r, interval range, Probe&& counter = {}) {
    return tree.occluded(r, range, counter);
}

/// All the rays, with the same answers as one by one; `hits` are as many as the rays. In trees that are larger than the
/// processor's cache it is faster than one by one, the more so the less the rays have to do with each other.
inline void closest(const wide_bvh& tree, std::span<const ray> rays, std::span<std::optional<nearest>> hits, interval range = {}) {
    tree.closest(rays, hits, range);
}

/// As of any accelerator, but without a look at the mesh.
template <std::derived_from<ray> Ray, class Probe = no_probe>
[[nodiscard]] std::optional<nearest> closest(const wide_bvh& tree, const mesh&, const Ray& r, interval range = {}, Probe&& counter = {}) {
    return tree.closest(r, range, counter);
}
template <std::derived_from<ray> Ray, class Probe = no_probe>
[[nodiscard]] bool occluded(const wide_bvh& tree, const mesh&, const Ray& r, interval range, Probe&& counter = {}) {
    return tree.occluded(r, range, counter);
}

}  // namespace lantern
