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

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
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

/// The size of the smallest vector that no coordinate of the three exceeds.
[[nodiscard]] inline double largest_size(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const auto largest = [](double x, double y, double z) { return std::max(std::max(std::abs(x), std::abs(y)), std::abs(z)); };
    return largest(a.x, b.x, c.x) + largest(a.y, b.y, c.y) + largest(a.z, b.z, c.z);
}

}  // namespace precise

/// The general case of `intersect`, for where double is in doubt. Inside or outside is decided exactly, so neighbours decide
/// alike; a triangle of no area has no inside. t comes from the plane in double-double: the hit lies between the vertices,
/// so t is kept between theirs.
[[nodiscard, gnu::noinline]] inline std::optional<precise::hit> intersect_in_doubt(const triangle& s, const precise::ray& r,
                                                                                   const interval& range) {
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
    return precise::hit{t, wa * a + wb * b + wc * c, normal / glm::length(normal), 0x1p-50 * precise::largest_size(a, b, c)};
}

namespace precise {

/// A point beside the ray, which has become the z axis: sheared so that its direction is (0, 0, 1), seen along it.
struct sheared {
    double x, y;
};

/// A ray made ready to be tested against many triangles: its shear.
struct triangle_ray : ray {
    std::ptrdiff_t kx, ky, kz;  ///< the axes; z is the one along which the direction is longest
    double sx, sy;
    double ox, oy, oz;  ///< the origin along these axes

    explicit triangle_ray(const ray& r) : ray(r) {
        const glm::dvec3 length = glm::abs(direction);
        const int z = length.x >= length.y && length.x >= length.z ? 0 : length.y >= length.z ? 1 : 2;
        const int x = z == 2 ? 0 : z + 1, y = x == 2 ? 0 : x + 1;
        const double sz = 1 / direction[z];
        sx = -direction[x] * sz, sy = -direction[y] * sz;
        ox = origin[x], oy = origin[y], oz = origin[z];
        kx = x, ky = y, kz = z;
    }
    explicit triangle_ray(const lantern::ray& r) : triangle_ray(widen(r)) {}

    [[nodiscard, gnu::always_inline]] sheared operator()(const glm::vec3& vertex) const {
        const float* const v = glm::value_ptr(vertex);  // vertex[kx] would ask which one it is
        const double z = v[kz] - oz;
        return {multiply_add(sx, z, v[kx] - ox), multiply_add(sy, z, v[ky] - oy)};
    }
};

/// The three vertices, sheared, for a ray that meets one triangle only: a branch for each axis instead of numbers in memory.
[[nodiscard, gnu::always_inline]] inline std::array<sheared, 3> shear(const glm::dvec3& to_a, const glm::dvec3& to_b,
                                                                      const glm::dvec3& to_c, const glm::dvec3& d) {
    const auto along = [&](int x, int y, int z) -> std::array<sheared, 3> {
        const double sz = 1 / d[z], sx = -d[x] * sz, sy = -d[y] * sz;
        return {{{multiply_add(sx, to_a[z], to_a[x]), multiply_add(sy, to_a[z], to_a[y])},
                 {multiply_add(sx, to_b[z], to_b[x]), multiply_add(sy, to_b[z], to_b[y])},
                 {multiply_add(sx, to_c[z], to_c[x]), multiply_add(sy, to_c[z], to_c[y])}}};
    };
    const double dx = std::abs(d.x), dy = std::abs(d.y), dz = std::abs(d.z);
    if (dx >= dy && dx >= dz) return along(1, 2, 0);
    if (dy >= dz) return along(2, 0, 1);
    return along(0, 1, 2);
}

/// Inside or outside by the signs of three edge functions in sheared space (Woop, Benthin and Wald, "Watertight ray/triangle
/// intersection", JCGT 2(1), 2013), in double. A sign that rounding might have decided is not believed, and neither is a plane too
/// slanting or too near for t: `intersect_in_doubt` decides then. No triangle is too small: only a determinant of 0 is a miss.
/// (Inlined always, for the widened numbers to stay in registers.)
template <class Ray, class Make, class Doubt>
[[nodiscard, gnu::always_inline]] inline auto find_hit(const triangle& s, const Ray& r, const interval& range, Make make, Doubt in_doubt)
    -> decltype(make(0.0, r.origin, r.origin, 0.0)) {
    const glm::dvec3 a(s.a), b(s.b), c(s.c), d = r.direction, to_a = a - r.origin, to_b = b - r.origin, to_c = c - r.origin;
    std::array<sheared, 3> corner;
    if constexpr (std::same_as<Ray, triangle_ray>) corner = {r(s.a), r(s.b), r(s.c)};
    else corner = shear(to_a, to_b, to_c, d);
    const auto& [A, B, C] = corner;
    const double u = difference_of_products(C.x, B.y, C.y, B.x);
    const double v = difference_of_products(A.x, C.y, A.y, C.x);
    const double w = difference_of_products(B.x, A.y, B.y, A.x);
    // No coordinate is larger than `reach`. With e = 2^-53, sx and sy are wrong by 2 e of themselves and what is sheared by 7 e reach,
    // hence u, v, w by 32 e reach².
    const glm::dvec3 e1 = b - a, e2 = c - a;
    const double size1 = size(e1), size2 = size(e2), distance = size(to_a), reach = distance + (size1 + size2);
    const double doubt = 0x1p-47 * (reach * reach), least = std::min(std::min(u, v), w), most = std::max(std::max(u, v), w);
    if (least < -doubt && most > doubt) return std::nullopt;

    const glm::dvec3 n = glm::cross(e1, e2);
    const double above = glm::dot(n, to_a), speed = glm::dot(n, d), scale = 0x1p-15 * size1 * size2;
    if (!((least > doubt || most < -doubt) && std::abs(above) > scale * distance && std::abs(speed) > scale * size(d))) {
        const std::optional<hit> h = in_doubt();
        if (!h) return std::nullopt;
        return make(h->t, h->point, h->normal, h->error);
    }
    const double t = above / speed;
    if (!contains(range, t)) return std::nullopt;
    const double per_sum = 1 / (u + v + w), wa = u * per_sum, wb = v * per_sum, wc = w * per_sum;
    return make(t, wa * a + wb * b + wc * c, n / glm::length(n), 0x1p-50 * largest_size(a, b, c));
}

}  // namespace precise

[[nodiscard, gnu::always_inline]] inline std::optional<precise::hit> intersect(const triangle& s, const precise::ray& r, interval range) {
    return precise::find_hit(s, r, range, precise::as_it_is, [&] { return intersect_in_doubt(s, precise::ray(r), range); });
}

/// For a ray that meets many triangles: see `ready_for`.
[[nodiscard, gnu::always_inline]] inline std::optional<precise::hit> intersect(const triangle& s, const precise::triangle_ray& r,
                                                                               interval range) {
    return precise::find_hit(s, r, range, precise::as_it_is, [&] { return intersect_in_doubt(s, r, range); });
}

/// The same, rounded where it is made: it need not go through memory.
[[nodiscard]] inline std::optional<hit> intersect(const triangle& s, const ray& r, interval range) {
    return precise::find_hit(s, precise::widen(r), range, precise::rounded_at_once,
                             [&] { return intersect_in_doubt(s, precise::widen(r), range); });
}

}  // namespace lantern
