// SPDX-License-Identifier: MIT
#pragma once
// Where wide_bvh cuts a number of boxes in two, so that rays have the least to do: three axes at once, a lane for each.

#include <lantern/interval.hpp>
#include <lantern/lanes.hpp>

#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <span>

namespace lantern::wide {

/// A box, and which triangle is in it.
struct item {
    glm::vec3 lower;
    std::uint32_t index;
    glm::vec3 upper;
    std::uint32_t unused;
};

inline constexpr std::uint32_t packet_size = 4, most_packets = 7;  ///< of triangles; of packets in a leaf

[[nodiscard]] constexpr std::uint32_t packets(std::size_t count) { return static_cast<std::uint32_t>((count + packet_size - 1) / packet_size); }

/// A range on each axis, in one register: where it begins, x, y, z and one to spare, and where it ends, negated. The smaller
/// numbers of two ranges are those of the range around both.
inline void box_of(const item& i, floats& box) {
    static_assert(sizeof i == sizeof box);
    std::memcpy(&box, &i, sizeof box);
    constexpr std::int32_t keep = -1, negate = std::numeric_limits<std::int32_t>::min();
    box = reinterpret_cast<floats>((reinterpret_cast<integers>(box) & integers{keep, keep, keep, 0, keep, keep, keep, 0}) ^
                                   integers{0, 0, 0, 0, negate, negate, negate, negate});
}
[[nodiscard]] inline quad length_of(const floats& range) {
    quad lower, negated_upper;
    take_apart(range, lower, negated_upper);
    return -(negated_upper + lower);
}

/// What a number of boxes reach over, and their centers, doubled.
struct extent {
    floats box, centers;

    extent() {
        spread(infinity, box);
        centers = box;
    }
    void add(const floats& b) {
        quad lower, negated_upper;
        take_apart(b, lower, negated_upper);
        const quad center = lower - negated_upper;
        floats point;
        put_together(center, -center, point);
        keep_smaller(box, b);
        keep_smaller(centers, point);
    }
    void add(const item& i) {
        floats b;
        box_of(i, b);
        add(b);
    }
};

/// Divides the items below a node of a binary tree between its two children.
class divider {
public:
    /// Orders the items and says how many go to the lower child: where area times packets, summed over both children, is
    /// least; into halves where no cut is found, or where the levels would run out otherwise. 0 where a leaf is cheaper. `all` is what
    /// the items reach over; `low` and `high` become what the children's do, if there is a cut. `by_length`: where many boxes are long and
    /// overlap, those that are long in the same way are put together, too.
    [[nodiscard]] static std::uint32_t cut(std::span<item> items, const extent& all, bool by_length, std::uint32_t levels, extent& low, extent& high) {
        const auto count = static_cast<std::uint32_t>(items.size());
        const bool needs_halving = static_cast<std::uint32_t>(std::bit_width(count / packet_size)) >= levels;
        std::uint32_t middle = needs_halving ? 0 : cheapest_cut(items, all, by_length, low, high);
        if ((middle > 0 && middle < count) || count <= most_packets * packet_size) return middle;
        const quad length = length_of(all.centers);
        const int axis = length[0] >= length[1] && length[0] >= length[2] ? 0 : length[1] >= length[2] ? 1 : 2;
        middle = (count / 2 + packet_size - 1) / packet_size * packet_size;
        std::nth_element(items.begin(), items.begin() + middle, items.end(), [&](const item& i, const item& j) {
            const float ci = i.lower[axis] + i.upper[axis], cj = j.lower[axis] + j.upper[axis];
            return ci < cj || (ci == cj && i.index < j.index);
        });
        low = high = {};
        for (const item& i : items.first(middle)) low.add(i);
        for (const item& i : items.subspan(middle)) high.add(i);
        return middle;
    }

private:
    static constexpr std::uint32_t bins = 32;
    static constexpr float step_cost = 1.2f;  // of entering a branch, in packets: measured

    // What tells items apart: where their boxes' centers are, doubled, or how long the boxes are; axis by axis.
    enum class measure { center, length };

    // From a box to its bin on each axis.
    struct binning {
        quad_integers sign;  // of the lower end: what is measured is the upper end plus the lower, or minus
        quad lower, scale{};

        binning(measure what, const floats& range, std::uint32_t used) : sign((what == measure::center ? 0 : INT32_MIN) + quad_integers{}) {
            quad negated_upper;
            take_apart(range, lower, negated_upper);
            for (int axis = 0; axis < 3; ++axis)
                if (const float size = -(negated_upper[axis] + lower[axis]); size > 0)
                    scale[axis] = std::min(0.9999f * float(used) / size, std::numeric_limits<float>::max());
        }
        quad_integers operator()(const floats& box) const {
            quad from, negated_upper;
            take_apart(box, from, negated_upper);
            const quad measured = reinterpret_cast<quad>(reinterpret_cast<quad_integers>(from) ^ sign) - negated_upper;
            return __builtin_convertvector((measured - lower) * scale, quad_integers);
        }
    };

    struct candidate {
        float cost;
        std::optional<binning> by;
        int axis = 0;
        std::int32_t bin = 0;  // the first that goes to the upper child
    };

    // What is in the bins: axis by axis, bin by bin.
    struct binned {
        std::array<std::array<floats, bins>, 3> box;
        std::array<std::array<std::int32_t, bins>, 3> number{};

        binned(std::span<const item> items, const binning& bin_of, std::uint32_t used) {
            for (auto& row : box) std::fill_n(row.begin(), used, extent().box);
            for (const item& i : items) {
                floats b;
                box_of(i, b);
                const quad_integers bin = bin_of(b);
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const auto k = static_cast<std::size_t>(bin[int(axis)]);
                    keep_smaller(box[axis][k], b);
                    ++number[axis][k];
                }
            }
        }
    };

    // Bins put together, one after the other; for three axes at once, a lane for each.
    struct sweep {
        const binned& from;
        float unit;
        std::array<floats, 3> box{extent().box, extent().box, extent().box};
        quad_integers number{};

        void add(std::uint32_t k) {
            for (std::size_t axis = 0; axis < 3; ++axis) keep_smaller(box[axis], from.box[axis][k]);
            number += quad_integers{from.number[0][k], from.number[1][k], from.number[2][k]};
        }
        // Half the surface, times the packets.
        [[nodiscard]] quad cost() const {
            const quad a = length_of(box[0]), b = length_of(box[1]), c = length_of(box[2]);
            quad x{a[0], b[0], c[0]}, y{a[1], b[1], c[1]}, z{a[2], b[2], c[2]};
            x *= unit;
            y *= unit;
            z *= unit;
            static_assert(packet_size == 4);
            return number > 0 ? (x * y + y * z + z * x) * __builtin_convertvector((number + 3) >> 2, quad) : quad{};
        }
    };

    // All axes are tried, each with up to 32 bins (Wald 2007).
    static void try_cuts(std::span<const item> items, const binning& bin_of, std::uint32_t used, float unit, candidate& best) {
        const binned all(items, bin_of, used);
        std::array<quad, bins> above;
        sweep upper{all, unit}, lower{all, unit};
        for (std::uint32_t k = used - 1; k > 0; --k) {
            upper.add(k);
            above[k] = upper.cost();
        }
        const auto count = static_cast<std::int32_t>(items.size());
        quad least = infinity + quad{};
        quad_integers where{};
        for (std::uint32_t k = 1; k < used; ++k) {
            lower.add(k - 1);
            const quad c = lower.cost() + above[k];
            const quad_integers better = quad_integers(c < least) & quad_integers(lower.number > 0) & quad_integers(lower.number < count);
            least = better ? c : least;
            where = better ? static_cast<std::int32_t>(k) + quad_integers{} : where;
        }
        for (int axis = 0; axis < 3; ++axis)
            if (least[axis] < best.cost) best = {least[axis], bin_of, axis, where[axis]};
    }

    static std::uint32_t cheapest_cut(std::span<item> items, const extent& all, bool by_length, extent& low, extent& high) {
        const auto used = std::min(bins, static_cast<std::uint32_t>(4 + items.size() / 4));
        candidate best{infinity, std::nullopt};
        quad whole = length_of(all.box);  // squares of floats may overflow: lengths count in the longest
        const float unit = std::min(1 / std::max(std::max(whole[0], whole[1]), whole[2]), std::numeric_limits<float>::max());
        whole *= unit;
        if (items.size() <= most_packets * packet_size)
            best.cost = (whole[0] * whole[1] + whole[1] * whole[2] + whole[2] * whole[0]) * (static_cast<float>(packets(items.size())) - step_cost);
        try_cuts(items, binning(measure::center, all.centers, used), used, unit, best);
        if (by_length) {
            floats lengths = extent().box;
            for (const item& i : items) {
                floats box, point;
                box_of(i, box);
                const quad length = length_of(box);
                put_together(length, -length, point);
                keep_smaller(lengths, point);
            }
            try_cuts(items, binning(measure::length, lengths, used), used, unit, best);
        }
        if (!(best.cost > 0 && best.by)) return 0;
        // Which side an item is on nobody can predict, so there is no branch: each trades places with the first of those at the upper side.
        const binning bin_of = *best.by;
        extent side[2];
        std::size_t first = 0;
        for (std::size_t i = 0; i < items.size(); ++i) {
            const item moving = items[i];
            floats b;
            box_of(moving, b);
            const bool lower = bin_of(b)[best.axis] < best.bin;
            side[lower ? 0 : 1].add(b);
            items[i] = items[first];
            items[first] = moving;
            first += lower;
        }
        low = side[0];
        high = side[1];
        return static_cast<std::uint32_t>(first);
    }
};

}  // namespace lantern::wide
