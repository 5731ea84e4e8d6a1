// SPDX-License-Identifier: MIT
#pragma once
// The triangle: watertight, and right for slivers, at any size and from any angle.

#include <lantern/aabb.hpp>
#include <lantern/double_double.hpp>
#include <lantern/exact_sign.hpp>
#include <lantern/hull.hpp>
#include <lantern/interval.hpp>
#include <lantern/plane.hpp>
#include <lantern/precise.hpp>
#include <lantern/validate.hpp>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace lantern {

/// The normal points to where a, b, c are seen counter-clockwise. No ray passes between triangles that share an edge or a
/// vertex: the same two or three points, in any order.
struct triangle {
    glm::vec3 a{0}, b{0}, c{0};
};

inline void validate(const triangle& t) {
    require_finite(t.a, "triangle: a");
    require_finite(t.b, "triangle: b");
    require_finite(t.c, "triangle: c");
}

/// Exact; empty when a coordinate is not finite.
[[nodiscard]] inline aabb bounds(const triangle& t) {
    if (!(is_finite(t.a) && is_finite(t.b) && is_finite(t.c))) return {};
    return enclose(enclose({t.a, t.a}, t.b), t.c);
}
[[nodiscard]] inline hull hull_of(const triangle& t) { return {{glm::dvec3(t.a), glm::dvec3(t.b), glm::dvec3(t.c)}, 0}; }

namespace precise {

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

}  // namespace precise

/// The general case of `intersect`, for where double is in doubt. Inside or outside is decided exactly, so neighbours decide
/// alike; a triangle of no area has no inside. t comes from the plane in double-double: the hit lies between the vertices,
/// so t is kept between theirs.
[[nodiscard, gnu::noinline]] inline std::optional<precise::hit> intersect_in_doubt(const triangle& s, const precise::ray& r,
                                                                                   interval range) {
    const glm::dvec3 a(s.a), b(s.b), c(s.c), &o = r.origin, &d = r.direction, length = glm::abs(d);
    const int kz = length.x >= length.y && length.x >= length.z ? 0 : length.y >= length.z ? 1 : 2;
    const double za = (a[kz] - o[kz]) / d[kz], zb = (b[kz] - o[kz]) / d[kz], zc = (c[kz] - o[kz]) / d[kz];
    const auto [nearest, farthest] = std::minmax({za, zb, zc});
    const glm::dvec3 e1 = b - a, e2 = c - a, to = a - o, rough = glm::cross(e1, e2);
    const double above = glm::dot(rough, to), speed = glm::dot(rough, d), scale = 0x1p-45 * precise::size(e1) * precise::size(e2);
    // Behind the origin for certain: most often the very triangle that the ray has just left.
    const bool sure = std::abs(above) > scale * precise::size(to) && std::abs(speed) > scale * precise::size(d);
    if (sure && (above < 0) != (speed < 0) && nearest <= 0 && range.min >= 0) return std::nullopt;

    const double u = triple_product(d, o, c, b), v = triple_product(d, o, a, c), w = triple_product(d, o, b, a);
    if (!((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0)) || u + v + w == 0) return std::nullopt;
    const double sum = u + v + w, wa = u / sum, wb = v / sum, wc = w / sum;
    const auto n = precise::normal_in_doubt(s);
    double t = precise::meet_plane_in_doubt(r, a, n);
    t = std::isfinite(t) ? std::clamp(t, nearest, farthest) : wa * za + wb * zb + wc * zc;
    if (!contains(range, t)) return std::nullopt;
    glm::dvec3 normal(n[0].high, n[1].high, n[2].high);
    if (normal == glm::dvec3(0)) normal = -d;
    const glm::dvec3 largest = glm::max(glm::max(glm::abs(a), glm::abs(b)), glm::abs(c));
    return precise::hit{t, wa * a + wb * b + wc * c, normal / glm::length(normal), 0x1p-50 * (largest.x + largest.y + largest.z)};
}

/// Inside or outside by the signs of three edge functions in sheared space, where the ray is the z axis and its direction (0, 0, 1)
/// (Woop, Benthin and Wald, "Watertight ray/triangle intersection", JCGT 2(1), 2013), in double. A sign that rounding might have
/// decided is not believed, and neither is a plane too slanting or too near for t: `intersect_in_doubt` decides then. No triangle
/// is too small: only a determinant of 0 is a miss. (Inlined always, for the widened numbers to stay in registers.)
[[nodiscard, gnu::always_inline]] inline std::optional<precise::hit> intersect(const triangle& s, const precise::ray& r,
                                                                               interval range) {
    const double* const d = glm::value_ptr(r.direction);
    const double* const o = glm::value_ptr(r.origin);
    const double dx = std::abs(d[0]), dy = std::abs(d[1]), dz = std::abs(d[2]);
    const int kz = dx >= dy && dx >= dz ? 0 : dy >= dz ? 1 : 2, kx = kz == 2 ? 0 : kz + 1, ky = kx == 2 ? 0 : kx + 1;
    const double sz = 1 / d[kz], sx = -d[kx] * sz, sy = -d[ky] * sz, ox = o[kx], oy = o[ky], oz = o[kz];
    struct vertex {
        double x, y, z;
    };
    const auto shear = [&](const glm::vec3& v) -> vertex {
        const float* const p = glm::value_ptr(v);
        const double z = double(p[kz]) - oz;
        return {multiply_add(sx, z, double(p[kx]) - ox), multiply_add(sy, z, double(p[ky]) - oy), z};
    };
    const vertex A = shear(s.a), B = shear(s.b), C = shear(s.c);
    const double u = difference_of_products(C.x, B.y, C.y, B.x);
    const double v = difference_of_products(A.x, C.y, A.y, C.x);
    const double w = difference_of_products(B.x, A.y, B.y, A.x);
    // u, v, w are wrong by less than `doubt`: sx and sy by 2^-52, each sheared coordinate by 5 |z| + 2 |x| times 2^-53.
    const double width = std::abs(A.x) + std::abs(A.y) + std::abs(B.x) + std::abs(B.y) + std::abs(C.x) + std::abs(C.y);
    const double doubt = 0x1p-49 * width * (width + (std::abs(A.z) + std::abs(B.z) + std::abs(C.z)));
    const double least = std::min(std::min(u, v), w), most = std::max(std::max(u, v), w);
    if (least < -doubt && most > doubt) return std::nullopt;

    const glm::dvec3 a(s.a), b(s.b), c(s.c), e1 = b - a, e2 = c - a, to = a - r.origin, n = glm::cross(e1, e2);
    const double above = glm::dot(n, to), speed = glm::dot(n, r.direction), scale = 0x1p-15 * precise::size(e1) * precise::size(e2);
    if (!((least > doubt || most < -doubt) && std::abs(above) > scale * precise::size(to) &&
          std::abs(speed) > scale * precise::size(r.direction))) {
        const auto h = intersect_in_doubt(s, precise::ray(r), range);
        if (!h) return std::nullopt;
        return precise::hit{h->t, h->point, h->normal, h->error};
    }
    const double t = above / speed;
    if (!contains(range, t)) return std::nullopt;
    const double per_sum = 1 / (u + v + w), wa = u * per_sum, wb = v * per_sum, wc = w * per_sum;
    const glm::dvec3 largest = glm::max(glm::max(glm::abs(a), glm::abs(b)), glm::abs(c));
    return precise::hit{t, wa * a + wb * b + wc * c, n / glm::length(n), 0x1p-50 * (largest.x + largest.y + largest.z)};
}

}  // namespace lantern
