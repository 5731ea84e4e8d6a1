// SPDX-License-Identifier: MIT
#pragma once
// Four triangles side by side, tested against one ray at once, by the exact rules of `triangle`.

#include <lantern/lanes.hpp>
#include <lantern/precise.hpp>
#include <lantern/ray.hpp>
#include <lantern/triangle.hpp>

#include <glm/vec3.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace lantern {

/// Vertex by vertex, axis by axis, the four triangles' coordinates are neighbours: what one vector register takes. Slots that
/// are not set hold NaN, which no ray meets.
struct alignas(32) triangle_packet {
    float vertex[3 * 3 * 4];   ///< [a, b or c][x, y or z][which triangle]
    std::uint32_t index[4]{};  ///< in the mesh

    triangle_packet() { std::ranges::fill(vertex, std::numeric_limits<float>::quiet_NaN()); }

    [[nodiscard]] triangle operator[](std::size_t i) const {
        const float* const v = vertex + i;
        return {{v[0], v[4], v[8]}, {v[12], v[16], v[20]}, {v[24], v[28], v[32]}};
    }
    void set(std::size_t i, const triangle& t, std::uint32_t which) {
        float* v = vertex + i;
        for (const glm::vec3& corner : {t.a, t.b, t.c})
            for (int axis = 0; axis < 3; ++axis, v += 4) *v = corner[axis];
        index[i] = which;
    }
};

/// A ray made ready to be tested against many packets: the shear that turns its direction into (0, 0, 1).
struct sheared_ray {
    std::size_t x, y, z;  ///< where a packet's rows for the axes begin; z is the one along which the direction is longest
    doubles ox, oy, oz;   ///< the origin along them; all lanes alike, here and below
    doubles sx, sy, sz;
    doubles doubt;        ///< by how much at most an edge function may be wrong

    /// `reach`: the largest coordinate of any triangle. With P the largest component of vertex - origin, sheared coordinates are
    /// up to 2 P and wrong by 9 · 2^-53 P, hence the edge functions by less than 2^-46 P²: docs/headers/triangle_packet.md.
    [[gnu::always_inline]] sheared_ray(const ray& r, float reach) {
        // Without branches: nobody can predict which way the next ray goes.
        quad length{r.direction.x, r.direction.y, r.direction.z};
        magnitude(length, length);
        const float longest = std::max(std::max(length[0], length[1]), length[2]);
        const auto kz = static_cast<std::size_t>(std::countr_zero(lanes_of(quad_integers(length == longest)) | 4u));
        static constexpr std::size_t next[] = {1, 2, 0};
        const std::size_t kx = next[kz], ky = next[kx];
        x = 4 * kx;
        y = 4 * ky;
        z = 4 * kz;
        const float* const o = &r.origin.x;
        const float* const d = &r.direction.x;
        spread(o[kx], ox);
        spread(o[ky], oy);
        spread(o[kz], oz);
        const double per_z = 1 / double(d[kz]);
        spread(per_z, sz);
        spread(-double(d[kx]) * per_z, sx);
        spread(-double(d[ky]) * per_z, sy);
        const double farthest = double(std::max(std::max(std::abs(o[0]), std::abs(o[1])), std::abs(o[2]))) + double(reach);
        spread(0x1p-46 * farthest * farthest, doubt);
    }
};

/// On which side of a triangle's edges the ray passes, and how far: its three edge functions. Of one sign: it passes through.
struct packet_sides {
    doubles least, most;
};

/// What a ray and a packet have in common, triangle by triangle.
struct packet_hits {
    doubles normal[3];     ///< n = (b - a) x (c - a)
    doubles above, speed;  ///< n * (a - o) and n * d: t = above / speed
    std::uint32_t alike;   ///< the lanes where `intersect` of the triangle is sure of a hit, and computes this t, to the last bit
};

/// Which triangles the line of a finite ray passes through: bit i for triangle i. Where rounding might decide it says yes, so it
/// never says no to a triangle that is hit. Nearly all triangles end here, so it costs as little as can be.
[[nodiscard, gnu::always_inline]] inline std::uint32_t passes_through(const triangle_packet& p, const sheared_ray& r,
                                                                      packet_sides& sides) {
    const float *const in_x = p.vertex + r.x, *const in_y = p.vertex + r.y, *const in_z = p.vertex + r.z;
    struct {
        doubles x, y;
    } A, B, C;  // sheared: beside the ray, seen along it
    const auto shear = [&](std::size_t v, auto& to) __attribute__((always_inline)) {
        doubles x, y, z;
        widen(in_x + 12 * v, x);
        widen(in_y + 12 * v, y);
        widen(in_z + 12 * v, z);
        x -= r.ox;
        y -= r.oy;
        z -= r.oz;
        multiply_add(r.sx, z, x, to.x);
        multiply_add(r.sy, z, y, to.y);
    };
    shear(0, A);
    shear(1, B);
    shear(2, C);
    const auto edge = [](const auto& from, const auto& to, doubles& side) __attribute__((always_inline)) {
        multiply_add(from.x, to.y, -(from.y * to.x), side);
    };
    doubles u, v, w;
    edge(C, B, u);
    edge(A, C, v);
    edge(B, A, w);
    auto& [least, most] = sides;
    least = most = u;
    keep_smaller(least, v);
    keep_smaller(least, w);
    keep_larger(most, v);
    keep_larger(most, w);
    // Inside where no two signs differ, as far as double can tell; never for NaN.
    return lanes_less(-r.doubt, least) | lanes_less(most, r.doubt);
}

/// Where a ray meets the planes of the four triangles. Returns the lanes where t, rounded to float, is the triangle's own: because
/// it is computed in the same way, number by number, or because no error that it may have would change how it is rounded. In the
/// others, which are rare, the triangle itself must be asked. Where t is negative it says no more than that. (docs/headers/triangle_packet.md)
[[nodiscard, gnu::always_inline]] inline std::uint32_t meets_plane(const triangle_packet& p, const sheared_ray& r, const ray& given,
                                                                   std::uint32_t lanes, const packet_sides& sides,
                                                                   packet_hits& hits) {
    const precise::ray exact = precise::widen(given);
    doubles e1[3], e2[3], to[3];
    for (std::size_t i = 0; i < 3; ++i) {
        doubles a;
        widen(p.vertex + 4 * i, a);
        widen(p.vertex + 12 + 4 * i, e1[i]);
        widen(p.vertex + 24 + 4 * i, e2[i]);
        e1[i] -= a;
        e2[i] -= a;
        to[i] = a - exact.origin[int(i)];
    }
    hits.normal[0] = e1[1] * e2[2] - e2[1] * e1[2];
    hits.normal[1] = e1[2] * e2[0] - e2[2] * e1[0];
    hits.normal[2] = e1[0] * e2[1] - e2[0] * e1[1];
    const auto& [nx, ny, nz] = hits.normal;
    hits.above = nx * to[0] + ny * to[1] + nz * to[2];
    hits.speed = nx * exact.direction.x + ny * exact.direction.y + nz * exact.direction.z;

    const auto size = [](const doubles (&v)[3], doubles& sum) __attribute__((always_inline)) {
        doubles y, z;
        magnitude(v[0], sum);
        magnitude(v[1], y);
        magnitude(v[2], z);
        sum = sum + y + z;
    };
    doubles size1, size2, distance, height, slope;
    size(e1, size1);
    size(e2, size2);
    size(to, distance);
    magnitude(hits.above, height);
    magnitude(hits.speed, slope);
    const doubles scale = 0x1p-15 * size1 * size2, low = scale * distance, flat = scale * precise::size(exact.direction);
    // Inside for certain: the sides are wrong by 2^-46.6 span². In units of them the bound of `intersect` is at most 2^-49 span², and
    // its numbers are wrong by half of that; so a triangle is sure, too, of whatever this believes.
    const doubles span = distance + (size1 + size2), doubt = 0x1p-46 * (span * span);
    const std::uint32_t inside = lanes_less(doubt, sides.least) | lanes_less(sides.most, -doubt);
    hits.alike = inside & lanes_less(low, height) & lanes_less(flat, slope);
    if ((lanes & ~hits.alike) == 0) return hits.alike;
    // Behind the origin for certain: most often the very triangle that the ray has just left.
    doubles nearest, z;
    for (std::size_t v = 0; v < 3; ++v) {
        widen(p.vertex + 12 * v + r.z, z);
        z = (z - r.oz) * r.sz;
        if (v == 0) nearest = z;
        keep_smaller(nearest, z);
    }
    const doubles zero{};
    const std::uint32_t backwards = lanes_less(hits.above, zero) ^ lanes_less(hits.speed, zero);
    const std::uint32_t behind = backwards & lanes_less(0x1p-30 * low, height) & lanes_less(0x1p-30 * flat, slope) & ~lanes_less(zero, nearest);
    if ((lanes & ~(hits.alike | behind)) == 0) [[likely]] return hits.alike | behind;
    // Ahead, and all t that it may be round alike. above and speed are wrong by less than 2^-49 |e1| |e2| |a - o| and 2^-49 |e1| |e2| |d|.
    const doubles error = 0x1p-50 + 0x1p-34 * (low / height + flat / slope), t = hits.above / hits.speed;
    quad first, last;
    narrow(t - t * error, first);
    narrow(t + t * error, last);
    const std::uint32_t alike = lanes_of(quad_integers(first == last)) & lanes_less(error, 0x1p-20 + zero);
    return hits.alike | behind | (inside & ~backwards & alike);
}

}  // namespace lantern
