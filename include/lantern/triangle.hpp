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

/// How far a + wb e1 + wc e2 may be from the plane when it has been computed. Each coordinate is wrong by at most 6 * 2^-53 of the
/// largest of a vertex, and no vertex is larger than a and an edge.
[[nodiscard]] inline double error_within(const glm::dvec3& a, double size1, double size2) { return 0x1p-50 * (size(a) + (size1 + size2)); }

/// Whether above / speed is negative for certain, as neither is wrong by more than is said: the plane is behind the origin. Most often
/// it is that of the very triangle that the ray has just left.
[[nodiscard]] inline bool surely_behind(double above, double above_error, double speed, double speed_error) {
    return std::abs(above) > above_error && std::abs(speed) > speed_error && (above < 0) != (speed < 0);
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
    if (precise::surely_behind(above, scale * precise::size(to), speed, scale * precise::size(d)) && nearest <= 0 && range.min >= 0) return std::nullopt;

    const double u = triple_product(d, o, c, b), v = triple_product(d, o, a, c), w = triple_product(d, o, b, a);
    if (!((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0)) || u + v + w == 0) return std::nullopt;
    const double sum = u + v + w, wa = u / sum, wb = v / sum, wc = w / sum;
    const auto n = precise::normal_in_doubt(s);
    double t = precise::meet_plane_in_doubt(r, a, n);
    t = std::isfinite(t) ? std::clamp(t, nearest, farthest) : wa * za + wb * zb + wc * zc;
    if (!contains(range, t)) return std::nullopt;
    glm::dvec3 normal(n[0].high, n[1].high, n[2].high);
    if (normal == glm::dvec3(0)) normal = -d;
    return precise::hit{t, wa * a + wb * b + wc * c, normal / glm::length(normal), precise::error_within(a, precise::size(e1), precise::size(e2))};
}
[[nodiscard, gnu::noinline]] inline std::optional<hit> intersect_in_doubt(const triangle& s, const ray& r, interval range) {
    if (const auto h = intersect_in_doubt(s, precise::widen(r), range)) return rounded(*h);
    return std::nullopt;
}

namespace precise {

/// A ray made ready to be tested against many triangles: widened, and measured.
struct triangle_ray : ray {
    double longest;  ///< the largest coordinate of the direction

    explicit triangle_ray(const ray& r)
        : ray(r), longest(std::max(std::max(std::abs(direction.x), std::abs(direction.y)), std::abs(direction.z))) {}
    explicit triangle_ray(const lantern::ray& r) : triangle_ray(widen(r)) {}
};

/// Möller and Trumbore, "Fast, minimum storage ray/triangle intersection", JGT 2(1), 1997, without its division: with q = (a - o) × d,
/// v = q·(c - a), w = q·(a - b) and u = n·d - v - w are of one sign inside, in the ratio of the weights of b, c and a. In double;
/// a sign that rounding might have decided is not believed, and neither is a plane too slanting or too near for t: `in_doubt`
/// decides then. No triangle is too small: only a determinant of 0 is a miss. (Inlined always, for the widened numbers to stay in registers.)
template <class Make, class Doubt>
[[nodiscard, gnu::always_inline]] inline auto find_hit(const triangle& s, const triangle_ray& r, const interval& range, Make make,
                                                       Doubt in_doubt) -> decltype(in_doubt()) {
    const glm::dvec3 a(s.a), from_b = a - glm::dvec3(s.b), to_c = glm::dvec3(s.c) - a, to_a = a - r.origin;
    const glm::dvec3 q = glm::cross(to_a, r.direction);
    const double v = glm::dot(q, to_c), w = glm::dot(q, from_b);
    // Of x·(y × z) each of six products is wrong by at most 7 e, e = 2^-53: 1 for each difference, 4 for products and sums. Their sizes
    // add up to no more than size(x) size(y) max|z|. So v and w, n·d, and with two roundings more u, are right but for 9 e times this.
    const double size_b = size(from_b), size_c = size(to_c), distance = size(to_a);
    const double doubt = 0x1p-49 * r.longest * ((distance + size_b) * (size_b + size_c));
    if (v > doubt ? w < -doubt : v < -doubt && w > doubt) return std::nullopt;

    const glm::dvec3 n = glm::cross(to_c, from_b);
    const double above = glm::dot(n, to_a), speed = glm::dot(n, r.direction), u = speed - v - w;
    const double scale = 0x1p-15 * size_b * size_c;
    if (!(u > doubt ? v > doubt && w > doubt : u < -doubt && v < -doubt && w < -doubt)) {
        if (u > doubt ? std::min(v, w) < -doubt : u < -doubt && std::max(v, w) > doubt) return std::nullopt;
        return in_doubt();
    }
    if (!(std::abs(above) > scale * distance && std::abs(speed) > scale * r.longest)) {
        if (surely_behind(above, 0x1p-30 * scale * distance, speed, 0x1p-30 * scale * r.longest) && range.min >= 0) return std::nullopt;
        return in_doubt();
    }
    const double t = above / speed;
    if (!contains(range, t)) return std::nullopt;
    const double wb = v / speed, wc = w / speed;
    return make(t, a - wb * from_b + wc * to_c, n / glm::length(n), error_within(a, size_b, size_c));
}

}  // namespace precise

/// What `intersect` answers, to the last bit, where it is known that it is sure of a hit, and at which t.
[[nodiscard, gnu::always_inline]] inline hit hit_at(const triangle& s, const ray& r, float t) {
    const glm::dvec3 a(s.a), from_b = a - glm::dvec3(s.b), to_c = glm::dvec3(s.c) - a, d(r.direction);
    const glm::dvec3 q = glm::cross(a - glm::dvec3(r.origin), d), n = glm::cross(to_c, from_b);
    const double speed = glm::dot(n, d), wb = glm::dot(q, to_c) / speed, wc = glm::dot(q, from_b) / speed;
    return *precise::rounded_at_once(double(t), a - wb * from_b + wc * to_c, n / glm::length(n),
                                     precise::error_within(a, precise::size(from_b), precise::size(to_c)));
}

[[nodiscard, gnu::always_inline]] inline std::optional<precise::hit> intersect(const triangle& s, const precise::triangle_ray& r,
                                                                               interval range) {
    return precise::find_hit(s, r, range, precise::as_it_is, [&] { return intersect_in_doubt(s, precise::ray(r), range); });
}

[[nodiscard, gnu::always_inline]] inline std::optional<precise::hit> intersect(const triangle& s, const precise::ray& r, interval range) {
    return intersect(s, precise::triangle_ray(r), range);
}

/// The same, rounded where it is made: it need not go through memory.
[[nodiscard]] inline std::optional<hit> intersect(const triangle& s, const ray& r, interval range) {
    return precise::find_hit(s, precise::triangle_ray(r), range, precise::rounded_at_once, [&] { return intersect_in_doubt(s, r, range); });
}

}  // namespace lantern
