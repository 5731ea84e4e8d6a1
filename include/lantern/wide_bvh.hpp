// SPDX-License-Identifier: MIT
#pragma once
// The fast hierarchy, over triangles: eight boxes are tested at once, then four triangles; and it is never wrong.

#include <lantern/aabb.hpp>
#include <lantern/closest.hpp>
#include <lantern/interval.hpp>
#include <lantern/lanes.hpp>
#include <lantern/mesh.hpp>
#include <lantern/precise.hpp>
#include <lantern/ray.hpp>
#include <lantern/triangle.hpp>
#include <lantern/triangle_packet.hpp>
#include <lantern/validate.hpp>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <ranges>
#include <span>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace lantern {

namespace wide {

/// Eight boxes and what is in them.
struct alignas(32) node {
    floats planes[6];          ///< the lower x, y, z of the boxes, then the upper; an empty slot has lower > upper
    std::uint32_t child[8]{};  ///< see `word`
};

/// Nodes and packets lie in one array of these, so that either can be fetched ahead without asking which it is.
struct alignas(32) block {
    std::byte bytes[32];
};
inline constexpr std::uint32_t node_blocks = sizeof(node) / sizeof(block);
inline constexpr std::uint32_t packet_blocks = sizeof(triangle_packet) / sizeof(block);
static_assert(sizeof(node) == 224 && sizeof(triangle_packet) == 160);

/// Which block a child begins at, and whether it is a packet.
[[nodiscard]] constexpr std::uint32_t word(std::size_t at, bool packet) {
    return static_cast<std::uint32_t>(at << 1) | std::uint32_t{packet};
}

/// A ray made ready to be tested against many boxes, so that rounding never makes it miss one: see docs/headers.
struct box_ray {
    floats near_origin[3], far_origin[3], reciprocal[3];
    std::size_t near_plane[3], far_plane[3];
    float per_unit;   ///< t is multiplied by this, for the longest component of the direction to be between 1 and 2
    bool usable;      ///< finite, and with a direction

    /// `reach`: the largest coordinate of anything in the boxes.
    box_ray(const ray& r, float reach) {
        const doubles o{r.origin.x, r.origin.y, r.origin.z, 0}, d{r.direction.x, r.direction.y, r.direction.z, 0};
        const doubles away = o < 0 ? -o : o, length = d < 0 ? -d : d;
        const double longest = std::max({length[0], length[1], length[2]}), farthest = std::max({away[0], away[1], away[2]});
        usable = is_finite(r.origin) && is_finite(r.direction) && longest > 0;
        if (!usable) return;
        // The largest power of two <= longest: its exponent's bits alone.
        const double power = std::bit_cast<double>(std::bit_cast<std::uint64_t>(longest) & 0x7ff0000000000000u), scale = 1 / power;
        per_unit = static_cast<float>(power);
        const doubles least = doubles{} + 0x1p-60, scaled = length * scale, raised = scaled > least ? scaled : least;
        const doubles shift = 0x1p-22 * away + 0x1p-34 * (farthest + reach);
        const doubles per_length = d < 0 ? -1 / raised : 1 / raised, along = d < 0 ? -shift : shift;
        const doubles near = o + along, far = o - along;
        for (std::size_t i = 0; i < 3; ++i) {
            reciprocal[i] = floats{} + static_cast<float>(per_length[i]);
            near_origin[i] = floats{} + rounded(near[i]);
            far_origin[i] = floats{} + rounded(far[i]);
            near_plane[i] = d[i] < 0 ? i + 3 : i;
            far_plane[i] = d[i] < 0 ? i : i + 3;
        }
    }

private:
    static float rounded(double x) {
        constexpr double most = std::numeric_limits<float>::max();
        return static_cast<float>(std::clamp(x, -most, most));
    }
};

/// Floats that are not negative are ordered as the integers that their bits spell.
[[nodiscard]] inline std::int32_t bits(float x) { return std::bit_cast<std::int32_t>(x); }

/// What rounding may add between entering a box and leaving it, or between a box and the hit in it: in such integers.
inline constexpr std::int32_t slack = 8;

/// Bit i is set where the ray meets box i within the range, which is in the box_ray's units; `entry` gets the distances.
[[nodiscard, gnu::always_inline]] inline std::uint32_t overlaps(const node& n, const box_ray& r, float min, float max,
                                                                floats& entry) {
    floats exit = floats{} + max;
    entry = floats{} + min;
    for (int i = 0; i < 3; ++i) {
        keep_larger(entry, (n.planes[r.near_plane[i]] - r.near_origin[i]) * r.reciprocal[i]);
        keep_smaller(exit, (n.planes[r.far_plane[i]] - r.far_origin[i]) * r.reciprocal[i]);
    }
    return lanes_of(integers(reinterpret_cast<integers>(entry) <= reinterpret_cast<integers>(exit) + slack));
}

/// The binary tree that is built first, then gathered up into nodes of eight.
class builder {
public:
    struct item {
        aabb box;
        std::uint32_t index;
    };
    struct branch {
        aabb box;
        std::uint32_t first, count;  ///< of the items
        std::uint32_t children;      ///< the first of two; 0 for a leaf
    };
    static constexpr std::uint32_t leaf_size = 4;
    static constexpr std::uint32_t max_depth = 60;

    builder(std::span<item> items, unsigned threads)
        : items_(items), branches_(std::make_unique_for_overwrite<branch[]>(2 * items.size())),
          idle_(static_cast<int>(threads) - 1) {
        const auto count = static_cast<std::uint32_t>(items.size());
        const extent all = extent_of(0, count);
        branches_[0] = {all.box, 0, count, 0};
        divide(0, all.centers, max_depth);
    }

    [[nodiscard]] const branch& operator[](std::uint32_t i) const { return branches_[i]; }

private:
    static constexpr std::uint32_t bins = 16;

    struct extent {
        aabb box, centers;  ///< around items, and around their centers
    };
    [[nodiscard]] extent extent_of(std::uint32_t first, std::uint32_t count) const {
        extent e;
        for (const item& i : items_.subspan(first, count)) {
            e.box = enclose(e.box, i.box);
            e.centers = enclose(e.centers, center(i.box));
        }
        return e;
    }

    void divide(std::uint32_t at, const aabb& centers, std::uint32_t levels) {
        const branch b = branches_[at];
        if (b.count <= leaf_size) return;
        const std::uint32_t middle = cut(b, centers, levels);
        const std::uint32_t lower = used_.fetch_add(2), upper = lower + 1;
        const extent low = extent_of(b.first, middle), high = extent_of(b.first + middle, b.count - middle);
        branches_[at].children = lower;
        branches_[lower] = {low.box, b.first, middle, 0};
        branches_[upper] = {high.box, b.first + middle, b.count - middle, 0};
        const bool large = b.count > 10'000;
        std::optional<std::jthread> helper;
        if (large && idle_.fetch_sub(1) > 0) {
            try {
                helper.emplace([&] { divide(lower, low.centers, levels - 1); });
            } catch (const std::system_error&) {  // no more threads to be had
            }
        }
        if (!helper) divide(lower, low.centers, levels - 1);
        divide(upper, high.centers, levels - 1);
        helper.reset();
        if (large) idle_.fetch_add(1);
    }

    // Orders the items and says how many go to the lower child: where area times packets, summed over both children, is
    // least; into halves where no cut is found, or where the levels would run out otherwise.
    std::uint32_t cut(const branch& b, const aabb& centers, std::uint32_t levels) {
        const std::span<item> items = items_.subspan(b.first, b.count);
        const bool needs_halving = static_cast<std::uint32_t>(std::bit_width(b.count / leaf_size)) >= levels;
        if (const std::uint32_t middle = needs_halving ? 0 : best_cut(items, centers); middle > 0) return middle;
        const glm::vec3 size = centers.max - centers.min;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const auto middle = (static_cast<std::uint32_t>(items.size()) / 2 + leaf_size - 1) / leaf_size * leaf_size;
        std::nth_element(items.begin(), items.begin() + middle, items.end(), [&](const item& i, const item& j) {
            const float ci = center(i.box)[axis], cj = center(j.box)[axis];
            return ci < cj || (ci == cj && i.index < j.index);
        });
        return middle;
    }

    struct bin {
        aabb box;
        std::uint32_t count = 0;
    };
    static double cost(const bin& b) { return b.count > 0 ? surface_area(b.box) * ((b.count + leaf_size - 1) / leaf_size) : 0; }

    std::uint32_t best_cut(std::span<item> items, const aabb& centers) const {
        glm::vec3 scale;  // from a center to its bin
        for (int axis = 0; axis < 3; ++axis) {
            const float size = centers.max[axis] - centers.min[axis];
            scale[axis] = size > 0 ? std::min(0.9999f * float(bins) / size, std::numeric_limits<float>::max()) : 0;
        }
        const auto bin_of = [&](const item& i, int axis) {
            const float where = (center(i.box)[axis] - centers.min[axis]) * scale[axis];
            return std::min(static_cast<std::uint32_t>(where), bins - 1);
        };
        std::array<std::array<bin, bins>, 3> all{};
        for (const item& i : items)
            for (int axis = 0; axis < 3; ++axis) {
                bin& b = all[std::size_t(axis)][bin_of(i, axis)];
                b.box = enclose(b.box, i.box);
                ++b.count;
            }
        double least = std::numeric_limits<double>::infinity();
        int best_axis = 0;
        std::uint32_t best_bin = 0;
        for (int axis = 0; axis < 3; ++axis) {
            std::array<double, bins> below{};
            bin sum;
            const auto add = [&](const bin& b) {
                sum.box = enclose(sum.box, b.box);
                sum.count += b.count;
            };
            for (std::uint32_t b = 0; b + 1 < bins; ++b) {
                add(all[std::size_t(axis)][b]);
                below[b + 1] = cost(sum);
            }
            sum = {};
            for (std::uint32_t b = bins - 1; b > 0; --b) {
                add(all[std::size_t(axis)][b]);
                const bool both = sum.count > 0 && sum.count < items.size();
                if (const double c = below[b] + cost(sum); both && c < least) {
                    least = c;
                    best_axis = axis;
                    best_bin = b;
                }
            }
        }
        if (!(least > 0 && best_bin > 0)) return 0;
        const auto lower = [&](const item& i) { return bin_of(i, best_axis) < best_bin; };
        return static_cast<std::uint32_t>(std::partition(items.begin(), items.end(), lower) - items.begin());
    }

    std::span<item> items_;
    std::unique_ptr<branch[]> branches_;
    std::atomic<std::uint32_t> used_{2};  // 1 stays free: two children never straddle
    std::atomic<int> idle_;
};

}  // namespace wide

struct wide_bvh_options {
    unsigned threads = 0;  ///< for the build; 0: as many as the machine has
};

/// It keeps the triangles themselves, four in a packet, and needs no mesh to find a hit: `closest(tree, ray)`. It is an
/// accelerator, too, and then offers only triangles that the ray's line passes through. What it answers is what `every`
/// answers, to the last bit. Only what lies ahead of a ray's origin is found, whatever the range says.
class wide_bvh {
public:
    /// Over a mesh, or any range of triangles. One that is not finite is left out, and counted. Throws
    /// std::invalid_argument where a coordinate is 2^60 (1.15e18) or more: the boxes' arithmetic would overflow.
    template <std::ranges::random_access_range Triangles>
        requires std::same_as<std::ranges::range_value_t<Triangles>, triangle>
    explicit wide_bvh(const Triangles& triangles, const wide_bvh_options& options = {}) {
        const auto count = static_cast<std::size_t>(std::ranges::size(triangles));
        if (count >= std::size_t{1} << 30) refuse("wide_bvh: the number of triangles", std::to_string(count), "below 2^30");
        size_ = static_cast<std::uint32_t>(count);
        std::vector<wide::builder::item> items;
        items.reserve(count);
        const auto begin = std::ranges::begin(triangles);
        for (std::uint32_t i = 0; i < size_; ++i) {
            const triangle t = begin[i];
            if (!is_finite(t.a) || !is_finite(t.b) || !is_finite(t.c)) continue;
            items.push_back({bounds(t), i});
            const glm::vec3 far = glm::max(glm::abs(items.back().box.min), glm::abs(items.back().box.max));
            reach_ = std::max({reach_, far.x, far.y, far.z});
        }
        if (!(reach_ < 0x1p60f)) refuse("wide_bvh: a coordinate", to_text(reach_), "less than 2^60");
        left_out_ = size_ - static_cast<std::uint32_t>(items.size());
        if (items.empty()) return;
        const unsigned threads = options.threads > 0 ? options.threads : std::max(1u, std::thread::hardware_concurrency());
        const wide::builder tree(items, threads);
        blocks_.reserve(items.size() * 2);
        const auto packet = [&](const wide::builder::branch& b) {
            triangle_packet p;
            for (std::uint32_t i = 0; i < b.count; ++i) {
                const std::uint32_t index = items[b.first + i].index;
                p.set(i, begin[index], index);
            }
            return p;
        };
        root_ = gather(tree, 0, packet);
        blocks_.shrink_to_fit();
    }

    /// See the concept `accelerator`.
    template <class Offer, class Probe = no_probe>
    void traverse(const ray& r, interval range, Offer&& offer, Probe&& counter = {}) const {
        walk<true>(r, range, counter, [&](const triangle_packet& p, std::uint32_t lanes, interval remaining) {
            for (; lanes != 0 && !empty(remaining); lanes &= lanes - 1) {
                counter.offer();
                remaining = offer(p.index[std::countr_zero(lanes)], remaining);
            }
            return remaining;
        });
    }

    template <std::derived_from<ray> Ray, class Probe = no_probe>
    [[nodiscard]] friend std::optional<nearest> closest(const wide_bvh& tree, const Ray& r, interval range = {},
                                                        Probe&& counter = {}) {
        std::optional<nearest> best;
        const precise::ray widened = precise::widen(static_cast<const ray&>(r));
        tree.walk<true>(r, range, counter, [&](const triangle_packet& p, std::uint32_t lanes, interval remaining) {
            for (; lanes != 0; lanes &= lanes - 1) {
                counter.offer();
                const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
                const auto h = intersect(p[lane], widened, remaining);
                if (!h) continue;
                const nearest found{rounded(*h), p.index[lane]};
                if (!best || found.t < best->t || found.index < best->index) best = found;
                remaining.max = best->t;
            }
            return remaining;
        });
        return best;
    }

    /// In no order: the first hit found will do.
    template <std::derived_from<ray> Ray, class Probe = no_probe>
    [[nodiscard]] friend bool occluded(const wide_bvh& tree, const Ray& r, interval range, Probe&& counter = {}) {
        bool found = false;
        const precise::ray widened = precise::widen(static_cast<const ray&>(r));
        tree.walk<false>(r, range, counter, [&](const triangle_packet& p, std::uint32_t lanes, interval remaining) {
            for (; lanes != 0 && !found; lanes &= lanes - 1) {
                counter.offer();
                found = intersect(p[static_cast<std::size_t>(std::countr_zero(lanes))], widened, remaining).has_value();
            }
            return found ? interval{0, 0} : remaining;
        });
        return found;
    }

    /// As of any accelerator, but without a look at the mesh.
    template <std::derived_from<ray> Ray, class Probe = no_probe>
    [[nodiscard]] friend std::optional<nearest> closest(const wide_bvh& tree, const mesh&, const Ray& r, interval range = {},
                                                        Probe&& counter = {}) {
        return closest(tree, r, range, counter);
    }
    template <std::derived_from<ray> Ray, class Probe = no_probe>
    [[nodiscard]] friend bool occluded(const wide_bvh& tree, const mesh&, const Ray& r, interval range, Probe&& counter = {}) {
        return occluded(tree, r, range, counter);
    }

    /// How many triangles it was built over, and how many of them were left out because they are not finite.
    [[nodiscard]] std::uint32_t size() const { return size_; }
    [[nodiscard]] std::uint32_t left_out() const { return left_out_; }

    /// All that it keeps.
    [[nodiscard]] std::size_t bytes() const { return blocks_.size() * sizeof(wide::block); }

private:
    template <class T>
    [[nodiscard]] const T& at(std::uint32_t word) const {
        return *std::launder(reinterpret_cast<const T*>(&blocks_[word >> 1]));
    }

    template <class T>
    std::size_t append(const T& thing) {
        const std::size_t where = blocks_.size();
        blocks_.resize(where + sizeof(T) / sizeof(wide::block));
        put(where, thing);
        return where;
    }
    template <class T>
    void put(std::size_t where, const T& thing) {
        ::new (static_cast<void*>(&blocks_[where])) T(thing);
    }

    // Up to eight descendants of a branch become one node: the largest one is opened as long as there is room
    // (Wald, Benthin and Boulos 2008). Their packets follow it at once, then their nodes.
    std::uint32_t gather(const wide::builder& tree, std::uint32_t root, const auto& packet) {
        if (tree[root].children == 0) return wide::word(append(packet(tree[root])), true);
        std::array<std::uint32_t, 8> slot{tree[root].children, tree[root].children + 1};
        std::size_t count = 2;
        while (count < slot.size()) {
            double largest = -1;
            std::size_t widest = count;
            for (std::size_t i = 0; i < count; ++i)
                if (const auto& b = tree[slot[i]]; b.children != 0 && surface_area(b.box) > largest) {
                    largest = surface_area(b.box);
                    widest = i;
                }
            if (widest == count) break;
            const std::uint32_t children = tree[slot[widest]].children;
            slot[widest] = children;
            slot[count++] = children + 1;
        }
        wide::node n;
        for (int axis = 0; axis < 3; ++axis) {
            n.planes[axis] = floats{} + infinity;
            n.planes[axis + 3] = floats{} - infinity;
            for (std::size_t i = 0; i < count; ++i) {
                n.planes[axis][i] = tree[slot[i]].box.min[axis];
                n.planes[axis + 3][i] = tree[slot[i]].box.max[axis];
            }
        }
        const std::size_t where = append(n);
        for (const bool inner : {false, true})
            for (std::size_t i = 0; i < count; ++i)
                if ((tree[slot[i]].children != 0) == inner) n.child[i] = gather(tree, slot[i], packet);
        put(where, n);
        return wide::word(where, false);
    }

    [[gnu::always_inline]] void fetch(std::uint32_t word) const {
        const std::byte* const begin = blocks_[word >> 1].bytes;
        __builtin_prefetch(begin);
        __builtin_prefetch(begin + 64);
        __builtin_prefetch(begin + 128);
    }

    /// Calls visit(packet, lanes, range) -> range for packets with triangles that the ray's line passes through.
    template <bool near_first, class Probe, class Visit>
    [[gnu::always_inline]] void walk(const ray& ray, interval range, Probe& counter, Visit&& visit) const {
        range.min = std::max(range.min, 0.0f);
        if (blocks_.empty() || empty(range)) return;
        const wide::box_ray r(ray, reach_);
        if (!r.usable) return;
        const sheared_ray sheared(ray, reach_);
        const float min = range.min * r.per_unit;
        float max = range.max * r.per_unit;

        // What waits: the distance's bits above the child's word, so that comparing keys compares distances. A level
        // leaves seven siblings behind.
        std::array<std::uint64_t, 7 * wide::builder::max_depth + 8> waiting;
        std::size_t count = 0;
        std::uint32_t next = root_;
        for (;;) {
            counter.node();
            if ((next & 1) != 0) {
                const triangle_packet& packet = at<triangle_packet>(next);
                if (const std::uint32_t lanes = passes_through(packet, sheared); lanes != 0) {
                    range = visit(packet, lanes, range);
                    if (empty(range)) return;
                    max = range.max * r.per_unit;
                }
            } else {
                const wide::node& node = at<wide::node>(next);
                floats entry;
                std::uint32_t met = overlaps(node, r, min, max, entry);
                if (std::has_single_bit(met)) {
                    next = node.child[std::countr_zero(met)];
                    continue;
                }
                if (met != 0) {
                    const integers distance = reinterpret_cast<integers>(entry);
                    const std::size_t before = count;
                    for (; met != 0; met &= met - 1) {
                        const auto i = static_cast<std::size_t>(std::countr_zero(met));
                        fetch(node.child[i]);
                        waiting[count++] = std::uint64_t{static_cast<std::uint32_t>(distance[i])} << 32 | node.child[i];
                    }
                    if constexpr (near_first) sort(&waiting[before], count - before);
                    next = static_cast<std::uint32_t>(waiting[--count]);
                    continue;
                }
            }
            do {
                if (count == 0) return;
                next = static_cast<std::uint32_t>(waiting[--count]);
            } while (static_cast<std::int32_t>(waiting[count] >> 32) > wide::bits(max) + wide::slack);
        }
    }

    // The nearest last.
    [[gnu::always_inline]] static void sort(std::uint64_t* keys, std::size_t count) {
        const auto order = [&](std::size_t i, std::size_t j) {
            const std::uint64_t a = keys[i], b = keys[j];
            keys[i] = std::max(a, b);
            keys[j] = std::min(a, b);
        };
        order(0, 1);
        if (count == 2) return;
        order(1, 2);
        order(0, 1);
        for (std::size_t i = 3; i < count; ++i) {  // seldom
            const std::uint64_t key = keys[i];
            std::size_t j = i;
            for (; j > 0 && keys[j - 1] < key; --j) keys[j] = keys[j - 1];
            keys[j] = key;
        }
    }

    std::vector<wide::block> blocks_;
    std::uint32_t root_ = 0;
    std::uint32_t size_ = 0, left_out_ = 0;
    float reach_ = 0;
};

}  // namespace lantern
