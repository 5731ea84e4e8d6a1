// SPDX-License-Identifier: MIT
#pragma once
// The triangle: watertight, and right for slivers, at any size and from any angle.

#include <lantern/aabb.hpp>
#include <lantern/double_double.hpp>
#include <lantern/hull.hpp>
#include <lantern/interval.hpp>
#include <lantern/plane.hpp>
#include <lantern/precise.hpp>
#include <lantern/validate.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace lantern {

namespace precise {

struct triangle_ray;

}  // namespace precise

/// The normal points to where a, b, c are seen counter-clockwise. No ray passes between triangles that share an edge or a
/// vertex: the same two or three points, in any order.
struct triangle {
    glm::vec3 a{0}, b{0}, c{0};

    using ready_ray = precise::triangle_ray;
};

inline void validate(const triangle& t) {
    require_finite(t.a, "triangle: a");
    require_finite(t.b, "triangle: b");
    require_finite(t.c, "triangle: c");
}

/// Exact.
[[nodiscard]] inline aabb bounds(const triangle& t) { return enclose(enclose({t.a, t.a}, t.b), t.c); }
[[nodiscard]] inline hull hull_of(const triangle& t) { return {{glm::dvec3(t.a), glm::dvec3(t.b), glm::dvec3(t.c)}, 0}; }

namespace precise {

/// A vertex as seen along the ray: the ray becomes the z axis, sheared so that its direction is (0, 0, 1). Depends on
/// the ray and the vertex alone, so that neighbouring triangles see the same.
struct sheared {
    double x, y, z;
};

/// A ray made ready to be tested against many triangles.
struct triangle_ray : ray {
    std::ptrdiff_t kx, ky, kz;  ///< the axes; z is the one along which the direction is longest
    double sx, sy, sz;          ///< the shear
    double ox, oy, oz;          ///< the origin along these axes

    explicit triangle_ray(const ray& r) : ray(r) {
        const glm::dvec3 length = glm::abs(direction);
        const int z = length.x >= length.y && length.x >= length.z ? 0 : length.y >= length.z ? 1 : 2;
        const int x = z == 2 ? 0 : z + 1, y = x == 2 ? 0 : x + 1;
        sz = 1 / direction[z], sx = -direction[x] * sz, sy = -direction[y] * sz;
        ox = origin[x], oy = origin[y], oz = origin[z];
        kx = x, ky = y, kz = z;
    }
    explicit triangle_ray(const lantern::ray& r) : triangle_ray(widen(r)) {}

    [[nodiscard, gnu::always_inline]] sheared operator()(const glm::vec3& vertex) const {
        const float* const v = glm::value_ptr(vertex);  // vertex[kx] would ask which one it is
        const double z = v[kz] - oz;
        return {multiply_add(sx, z, v[kx] - ox), multiply_add(sy, z, v[ky] - oy), z};
    }
};

/// e1 × e2 for the edges from a, in double-double.
[[nodiscard]] inline std::array<double_double, 3> normal_in_doubt(const triangle& t) {
    std::array<double_double, 3> e1, e2, n;
    for (int i = 0; i < 3; ++i) {
        e1[std::size_t(i)] = two_sum(t.b[i], -double(t.a[i]));
        e2[std::size_t(i)] = two_sum(t.c[i], -double(t.a[i]));
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        n[i] = e1[j] * e2[k] - e1[k] * e2[j];
    }
    return n;
}

struct plane_hit {
    double t;
    glm::dvec3 normal;  ///< not of unit length
};

/// The plane of a triangle too thin, too slanting or too near for double. The hit lies between the vertices, so t is
/// kept between theirs. A triangle of no area, met in passing from one neighbour to the next, is seen from the front.
[[nodiscard, gnu::noinline]] inline plane_hit meet_plane_in_doubt(const triangle& s, const ray& r, double t_of_weights,
                                                                  double t_min, double t_max) {
    const auto n = normal_in_doubt(s);
    const double t = meet_plane_in_doubt(r, glm::dvec3(s.a), n);
    const glm::dvec3 normal(n[0].high, n[1].high, n[2].high);
    return {std::isfinite(t) ? std::clamp(t, t_min, t_max) : t_of_weights,
            normal == glm::dvec3(0) ? -r.direction : normal};
}

}  // namespace precise

/// Inside or outside by the signs of three edge functions in sheared space (Woop, Benthin and Wald, "Watertight ray/triangle
/// intersection", JCGT 2(1), 2013), in double: the sign of an edge never differs between the two triangles that share it.
/// t comes from the plane. No triangle is too small: only a determinant of 0 is a miss. (Inlined always,
/// for the widened numbers to stay in registers.)
[[nodiscard, gnu::always_inline]] inline std::optional<precise::hit> intersect(const triangle& s, const precise::triangle_ray& r,
                                                                               interval range) {
    const precise::sheared A = r(s.a), B = r(s.b), C = r(s.c);
    const double u = difference_of_products(C.x, B.y, C.y, B.x);
    const double v = difference_of_products(A.x, C.y, A.y, C.x);
    const double w = difference_of_products(B.x, A.y, B.y, A.x);
    const double least = std::min(std::min(u, v), w), most = std::max(std::max(u, v), w);
    if (std::min(-least, most) > 0) return std::nullopt;  // one is below 0 and one above
    const double sum = u + v + w;
    if (!(sum != 0)) return std::nullopt;
    const double per_sum = 1 / sum, wa = u * per_sum, wb = v * per_sum, wc = w * per_sum;

    const glm::dvec3 a(s.a), b(s.b), c(s.c), d = r.direction, e1 = b - a, e2 = c - a, to = a - r.origin, n = glm::cross(e1, e2);
    const double above = glm::dot(n, to), speed = glm::dot(n, d);
    const double scale = 0x1p-15 * precise::size(e1) * precise::size(e2);
    precise::plane_hit p{above / speed, n};
    if (!(std::abs(above) > scale * precise::size(to) && std::abs(speed) > scale * precise::size(d))) {
        const auto [nearest, farthest] = std::minmax({A.z * r.sz, B.z * r.sz, C.z * r.sz});
        // Behind the origin for certain: most often the very triangle that the ray has just left.
        const bool sure = std::abs(above) > 0x1p-30 * scale * precise::size(to) && std::abs(speed) > 0x1p-30 * scale * precise::size(d);
        if (sure && (above < 0) != (speed < 0) && nearest <= 0 && range.min >= 0) return std::nullopt;
        p = meet_plane_in_doubt(s, r, wa * (A.z * r.sz) + wb * (B.z * r.sz) + wc * (C.z * r.sz), nearest, farthest);
    }
    if (!contains(range, p.t)) return std::nullopt;
    const glm::dvec3 largest = glm::max(glm::max(glm::abs(a), glm::abs(b)), glm::abs(c));
    const double error = 0x1p-50 * (largest.x + largest.y + largest.z);
    return precise::hit{p.t, wa * a + wb * b + wc * c, p.normal / glm::length(p.normal), error};
}

/// A ray that meets one triangle only.
[[nodiscard]] inline std::optional<precise::hit> intersect(const triangle& s, const precise::ray& r, interval range) {
    return intersect(s, precise::triangle_ray(r), range);
}

}  // namespace lantern
