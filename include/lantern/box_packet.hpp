// SPDX-License-Identifier: MIT
#pragma once
// Eight boxes side by side, tested against one ray at once, so that rounding never makes the ray miss one.

#include <lantern/aabb.hpp>
#include <lantern/lanes.hpp>
#include <lantern/ray.hpp>

#include <glm/vec3.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace lantern {

/// Plane by plane, the eight boxes' coordinates are neighbours. In slots that are not used lower > upper: no ray meets them.
struct alignas(32) box_packet {
    float plane[6 * 8];  ///< [lower x, y, z, upper x, y, z][which box]

    box_packet() {
        std::fill(plane, plane + 24, infinity);
        std::fill(plane + 24, plane + 48, -infinity);
    }
    void set(std::size_t i, const aabb& box) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            plane[8 * axis + i] = box.min[int(axis)];
            plane[24 + 8 * axis + i] = box.max[int(axis)];
        }
    }
};

/// Floats that are not negative are ordered as the integers that their bits spell.
[[nodiscard]] inline std::int32_t bits(float x) { return std::bit_cast<std::int32_t>(x); }

/// A finite ray with a direction, made ready to be tested against many boxes. The ray passes a plane at
/// t = plane * reciprocal + before. Why no box is missed: docs/headers/box_packet.md.
struct box_packet_ray {
    floats reciprocal[3];                       ///< of the direction; axis by axis, all lanes alike
    floats near_before[3], far_before[3];       ///< -origin * reciprocal; the origin is moved on for near planes, back for far ones
    std::size_t near_plane[3], far_plane[3];    ///< where the planes begin in a packet, in bytes
    float per_unit = 1;                        ///< the test's t is the ray's times this

    /// `reach`: no coordinate of a box is larger; below 2^60.
    [[gnu::always_inline]] box_packet_ray(const ray& r, float reach) {
        const quad o{r.origin.x, r.origin.y, r.origin.z};
        quad d{r.direction.x, r.direction.y, r.direction.z}, length, distance;
        magnitude(d, length);
        magnitude(o, distance);
        const auto largest = [](const quad& v) __attribute__((always_inline)) { return std::max(std::max(v[0], v[1]), v[2]); };
        if (const float longest = largest(length); !(0x1p-20f < longest && longest < 0x1p20f)) [[unlikely]] {
            const int power = std::ilogb(longest);
            for (int i = 0; i < 3; ++i) d[i] = std::ldexp(d[i], -power);
            per_unit = std::ldexp(1.0f, power);
            magnitude(d, length);
        }
        quad shift = 0x1p-21f * distance + (0x1p-34f * largest(distance) + 0x1p-34f * reach);
        signed_as(shift, d, shift);
        keep_larger(length, 0x1p-60f + quad{});
        signed_as(length, d, length);
        const quad per_length = 1 / length, near_offset = (-o - shift) * per_length, far_offset = (shift - o) * per_length;
        for (int i = 0; i < 3; ++i) {
            spread(per_length[i], reciprocal[i]);
            spread(near_offset[i], near_before[i]);
            spread(far_offset[i], far_before[i]);
        }
        const float way[3] = {r.direction.x, r.direction.y, r.direction.z};
        for (std::size_t i = 0; i < 3; ++i) {
            constexpr std::size_t plane = 8 * sizeof(float), upper = 3 * plane;
            const auto backwards = static_cast<std::size_t>(std::int64_t{bits(way[i])} >> 63);
            near_plane[i] = i * plane + (backwards & upper);
            far_plane[i] = i * plane + (~backwards & upper);
        }
    }
};

/// What rounding may add between entering a box and leaving it, or between a box and the hit in it: in such integers.
inline constexpr std::int32_t slack = 16;

/// Bit i is set where the ray meets box i within the range, which is in the box_packet_ray's units; `entry` gets the distances.
[[nodiscard, gnu::always_inline]] inline std::uint32_t overlaps(const box_packet& p, const box_packet_ray& r, float min, float max,
                                                                floats& entry) {
    const auto pass = [&](std::size_t offset, int axis, const floats& before, floats& t) __attribute__((always_inline)) {
        load(p.plane, offset, t);
        multiply_add(t, r.reciprocal[axis], before, t);
    };
    floats enter_x, enter_y, enter_z, leave_x, leave_y, leave_z, exit;
    spread(min, entry);
    spread(max, exit);
    pass(r.near_plane[0], 0, r.near_before[0], enter_x);
    pass(r.near_plane[1], 1, r.near_before[1], enter_y);
    pass(r.near_plane[2], 2, r.near_before[2], enter_z);
    pass(r.far_plane[0], 0, r.far_before[0], leave_x);
    pass(r.far_plane[1], 1, r.far_before[1], leave_y);
    pass(r.far_plane[2], 2, r.far_before[2], leave_z);
    keep_larger(enter_x, enter_y);
    keep_larger(entry, enter_z);
    keep_larger(entry, enter_x);
    keep_smaller(leave_x, leave_y);
    keep_smaller(exit, leave_z);
    keep_smaller(exit, leave_x);
    return lanes_of(integers(reinterpret_cast<integers>(exit) + (slack + 1) > reinterpret_cast<integers>(entry)));
}

}  // namespace lantern
