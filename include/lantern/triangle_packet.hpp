// SPDX-License-Identifier: MIT
#pragma once
// Four triangles side by side, tested against one ray at once, by the exact rules of `triangle`.

#include <lantern/lanes.hpp>
#include <lantern/ray.hpp>
#include <lantern/triangle.hpp>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace lantern {

/// Vertex by vertex, axis by axis, the four triangles' coordinates are neighbours: what one vector register takes. Slots that
/// are not set hold NaN, which no ray meets.
struct alignas(32) triangle_packet {
    float vertex[3][3][4];     ///< [a, b or c][x, y or z][which triangle]
    std::uint32_t index[4]{};  ///< in the mesh

    triangle_packet() {
        for (auto& corner : vertex)
            for (auto& axis : corner)
                for (float& x : axis) x = std::numeric_limits<float>::quiet_NaN();
    }

    [[nodiscard]] triangle operator[](std::size_t i) const {
        const auto corner = [&](std::size_t v) { return glm::vec3(vertex[v][0][i], vertex[v][1][i], vertex[v][2][i]); };
        return {corner(0), corner(1), corner(2)};
    }
    void set(std::size_t i, const triangle& t, std::uint32_t which) {
        const glm::vec3* const corners[3] = {&t.a, &t.b, &t.c};
        for (std::size_t v = 0; v < 3; ++v)
            for (int axis = 0; axis < 3; ++axis) vertex[v][axis][i] = (*corners[v])[axis];
        index[i] = which;
    }
};

/// A ray made ready to be tested against many packets: the shear that turns its direction into (0, 0, 1).
struct sheared_ray {
    std::size_t x, y, z;  ///< the axes; z is the one along which the direction is longest
    double ox, oy, oz;    ///< the origin along them
    double sx, sy;
    double doubt;         ///< by how much at most an edge function may be wrong

    /// `reach`: the largest coordinate of any triangle. With P the largest component of vertex - origin, sheared coordinates are
    /// up to 2 P and wrong by 9 · 2^-53 P, hence the edge functions by less than 2^-46 P²: see `intersect` of a triangle.
    sheared_ray(const ray& r, float reach) {
        const glm::dvec3 o(r.origin), d(r.direction), length = glm::abs(d);
        const int kz = length.x >= length.y && length.x >= length.z ? 0 : length.y >= length.z ? 1 : 2;
        const int kx = kz == 2 ? 0 : kz + 1, ky = kx == 2 ? 0 : kx + 1;
        x = static_cast<std::size_t>(kx);
        y = static_cast<std::size_t>(ky);
        z = static_cast<std::size_t>(kz);
        ox = o[kx];
        oy = o[ky];
        oz = o[kz];
        const double sz = 1 / d[kz];
        sx = -d[kx] * sz;
        sy = -d[ky] * sz;
        const double farthest = std::max({std::abs(o.x), std::abs(o.y), std::abs(o.z)}) + double(reach);
        doubt = 0x1p-46 * farthest * farthest;
    }
};

/// Which triangles the line of a finite ray passes through: bit i for triangle i. Where rounding might decide it says yes, so it
/// never says no to a triangle whose own `intersect` would be hit; which is so, and where, is left to that.
[[nodiscard, gnu::always_inline]] inline std::uint32_t passes_through(const triangle_packet& p, const sheared_ray& r) {
    struct {
        doubles x, y;
    } corner[3];
    const doubles sx = doubles{} + r.sx, sy = doubles{} + r.sy;
    for (int v = 0; v < 3; ++v) {
        doubles x, y, z;
        widen(p.vertex[v][r.x], x);
        widen(p.vertex[v][r.y], y);
        widen(p.vertex[v][r.z], z);
        x -= r.ox;
        y -= r.oy;
        z -= r.oz;
        multiply_add(sx, z, x, corner[v].x);
        multiply_add(sy, z, y, corner[v].y);
    }
    const auto& [A, B, C] = corner;
    doubles u, v, w;
    difference_of_products(C.x, B.y, C.y, B.x, u);
    difference_of_products(A.x, C.y, A.y, C.x, v);
    difference_of_products(B.x, A.y, B.y, A.x, w);
    const doubles doubt = doubles{} + r.doubt;
    const long_integers outside = ((u < -doubt) | (v < -doubt) | (w < -doubt)) & ((u > doubt) | (v > doubt) | (w > doubt));
    const doubles sum = u + v + w;
    return lanes_of(long_integers(~outside & (sum == sum)));
}

}  // namespace lantern
