// SPDX-License-Identifier: MIT
#pragma once
// A hierarchy of boxes for fast traversal: four children a node instead of two.

#include <lantern/aabb.hpp>
#include <lantern/box_quartet.hpp>
#include <lantern/boxes_of.hpp>
#include <lantern/bvh_layout.hpp>
#include <lantern/closest.hpp>
#include <lantern/interval.hpp>
#include <lantern/lanes.hpp>
#include <lantern/ray.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace lantern {

/// The leaves of a binary tree under half as many levels: a node's children are its grandchildren, whose boxes are tested at once. Most
/// of a ray's time goes into decisions that the processor cannot foresee, and here there are fewer of them.
class bvh_quartets {
public:
    bvh_quartets() = default;
    explicit bvh_quartets(std::span<const bvh_node<aabb>> nodes) {
        if (nodes.empty()) return;
        quartets_.reserve(nodes.size() / 4 + 1);
        root_ = {nodes[0].volume, under(nodes, 0)};
    }

    /// As in `bvh`; the nearest of the children comes first, and the others wait. (If the offer takes any order, the farthest comes
    /// first, and the others in no order.) `indices` may be left out (an empty span) where the surfaces are in the order of the
    /// leaves: what is not read need not be fetched.
    template <class Offer, class Probe>
    void traverse(const ray& r, interval range, std::span<const std::uint32_t> indices, Offer&& offer, Probe&& counter) const {
        box_quartet_ray way(r, range, reach_of(root_.box));
        struct sibling {
            const child* what;
            float entry;
        };
        std::array<sibling, 3 * 64> waiting;  // of each level at most three
        std::size_t count = 0;
        sibling at{&root_.what, 0};
        counter.node();
        if (!way.meets(root_.box, at.entry)) return;
        while (true) {
            if (at.what->size == 0) {
                const quartet& four = quartets_[at.what->first];
                for (std::size_t i = 0; i < 4; ++i)
                    if (!empty(four.boxes[i])) counter.node();
                quad entries;
                const std::uint32_t met = way.meets(four.boxes, entries);
                // Written as branches: the processor guesses which way it goes, and fetches that child, while it computes.
                if (met != 0) {
                    const std::size_t level = count;
                    bool found = false;
                    const auto consider = [&](std::size_t i) __attribute__((always_inline)) {
                        if (!(met >> i & 1)) return;
                        sibling s{&four.what[i], entries[i]};
                        if (!found) {
                            at = s;
                            found = true;
                            return;
                        }
                        if (takes_any_order<Offer> ? s.entry > at.entry : s.entry < at.entry) std::swap(s, at);
                        std::size_t place = count++;
                        if constexpr (!takes_any_order<Offer>)  // the farther, the deeper on the stack
                            for (; place > level && waiting[place - 1].entry < s.entry; --place) waiting[place] = waiting[place - 1];
                        waiting[place] = s;
                    };
                    consider(0), consider(1), consider(2), consider(3);
                    continue;
                }
            } else {
                const std::uint32_t first = at.what->first, end = first + at.what->size;
                for (std::uint32_t i = first; i < end; ++i) {
                    counter.offer();
                    range = offer(indices.empty() ? i : indices[i], range);
                    if (empty(range)) return;
                }
                way.shorten(range.max);
            }
            do {
                if (count == 0) return;
                at = waiting[--count];
            } while (!way.reaches(at.entry));
        }
    }

    [[nodiscard]] std::size_t bytes() const { return quartets_.size() * sizeof(quartet); }

private:
    struct child {
        std::uint32_t first, size;  // of a leaf's indices; of an inner node its quartet's number and 0
    };
    struct alignas(128) quartet {  // two lines of the cache, of the kind that come together
        box_quartet boxes;
        std::array<child, 4> what;
    };

    [[nodiscard]] child under(std::span<const bvh_node<aabb>> nodes, std::uint32_t at) {
        return nodes[at].size > 0 ? child{nodes[at].first, nodes[at].size} : child{gather(nodes, at), 0};
    }

    // The children of a node; of these the largest inner one is replaced by its own, until there are four.
    std::uint32_t gather(std::span<const bvh_node<aabb>> nodes, std::uint32_t at) {
        std::array<std::uint32_t, 4> chosen{nodes[at].first, nodes[at].first + 1};
        std::size_t count = 2;
        while (count < 4) {
            const auto size = [&](std::uint32_t i) { return nodes[i].size > 0 ? -1 : surface_area(nodes[i].volume); };
            const auto largest = std::max_element(chosen.begin(), chosen.begin() + count, [&](auto a, auto b) { return size(a) < size(b); });
            if (nodes[*largest].size > 0) break;
            chosen[count++] = nodes[*largest].first + 1;
            *largest = nodes[*largest].first;
        }
        const auto here = static_cast<std::uint32_t>(quartets_.size());
        quartets_.emplace_back();
        quartets_[here].what.fill({0, 1});  // if a ray of NaN should come by: an offer too many does no harm
        for (std::size_t i = 0; i < count; ++i) {
            quartets_[here].boxes.set(i, nodes[chosen[i]].volume);
            const child c = under(nodes, chosen[i]);  // more quartets, which may move
            quartets_[here].what[i] = c;
        }
        return here;
    }

    struct {
        aabb box;
        child what;
    } root_{};
    std::vector<quartet> quartets_;
};

}  // namespace lantern
