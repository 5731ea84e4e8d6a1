// SPDX-License-Identifier: MIT
#pragma once
// The sphere, right from a ray that grazes it to a ground of radius 1e12.

#include <lantern/aabb.hpp>
#include <lantern/double_double.hpp>
#include <lantern/hull.hpp>
#include <lantern/interval.hpp>
#include <lantern/precise.hpp>
#include <lantern/validate.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace lantern {

/// All points at the distance |radius| from the center. A negative radius turns the normals inwards: the inner wall of
/// a hollow glass ball. A sphere of radius 0 is a point, and only a ray exactly through it hits it.
struct sphere {
    glm::vec3 center{0};
    float radius = 1;

    [[nodiscard]] bool operator==(const sphere&) const = default;
};

inline void validate(const sphere& s) {
    require_finite(s.center, "sphere: center");
    require_finite(s.radius, "sphere: radius");
}

/// Rounded outwards.
[[nodiscard]] inline aabb bounds(const sphere& s) {
    const float radius = std::abs(s.radius);
    return grown({s.center, s.center}, glm::vec3(radius));
}

[[nodiscard]] inline hull hull_of(const sphere& s) { return {{glm::dvec3(s.center)}, std::abs(double(s.radius))}; }

/// The general case of `intersect`, for where double is in doubt: roots of |f + t d|² = R² in double-double.
[[nodiscard, gnu::noinline]] inline std::optional<precise::hit> intersect_in_doubt(const sphere& s,
                                                                                   const precise::ray& r,
                                                                                   interval range) {
    const double radius = std::abs(double(s.radius));
    std::array<double_double, 3> f;
    double_double a, b, k = -two_product(radius, radius);  // k = |f|² - R²
    for (int i = 0; i < 3; ++i) {
        f[std::size_t(i)] = two_sum(r.origin[i], -double(s.center[i]));
        const double_double fi = f[std::size_t(i)], di{r.direction[i]};
        a = a + di * di;
        b = b - fi * di;
        k = k + fi * fi;
    }
    const double_double discriminant = b * b - a * k;
    if (!(discriminant.high >= 0)) return std::nullopt;
    const double root = std::sqrt(discriminant.high);
    const double q = b.high >= 0 ? b.high + root : b.high - root;  // no cancellation: Higham 2002, section 1.8
    const double t0 = b.high >= 0 ? k.high / q : q / a.high, t1 = b.high >= 0 ? q / a.high : k.high / q;
    const bool enters = contains(range, t0);
    if (!enters && !contains(range, t1)) return std::nullopt;
    const double t = enters ? t0 : t1;

    // The normal from the foot l of the perpendicular from the center, f + (b/a) d.
    const double foot = b.high / a.high;
    const double_double rest = b - a * double_double{foot};
    const double along = (enters ? -root : root) / a.high + rest.high / a.high;
    glm::dvec3 normal;
    for (int i = 0; i < 3; ++i)
        normal[i] = (f[std::size_t(i)] + two_product(foot, r.direction[i]) + two_product(along, r.direction[i])).high;
    if (radius == 0 || normal == glm::dvec3(0)) normal = -r.direction;  // a point, or too far away to be more
    normal /= glm::length(normal);

    // Measured from the center, or from the ray's origin: whichever rounds less.
    const glm::dvec3 c(s.center), step = t * r.direction;
    const double from_center = precise::size(c) + radius, from_origin = precise::size(r.origin) + precise::size(step);
    if (!precise::fits(from_center)) return std::nullopt;
    const glm::dvec3 point = from_origin < from_center ? r.origin + step : c + radius * normal;
    return precise::hit{t, point, s.radius < 0 ? -normal : normal, 0x1p-50 * std::min(from_center, from_origin)};
}

namespace precise {

/// The first of the roots of a t² - 2 b t + k that lies in the range, and what the sphere looks like there, handed to `make`; f is
/// center - origin.
template <class Make>
[[nodiscard, gnu::always_inline]] inline auto meet(const sphere& s, const ray& r, const interval& range, const glm::dvec3& f, double a, double b,
                                                   double k, double root, Make make) -> decltype(make(0.0, f, f, 0.0)) {
    const double q = b >= 0 ? b + root : b - root;
    double t = b >= 0 ? k / q : q / a;
    if (!contains(range, t)) {
        t = b >= 0 ? q / a : k / q;
        if (!contains(range, t)) return std::nullopt;
    }
    const glm::dvec3 c(s.center), out = t * r.direction - f;  // of length R, but for an error e
    const double radius = s.radius, size = precise::size(c) + std::abs(radius);
    if (!fits(size)) return std::nullopt;
    // By the arithmetic mean of R² and |out|² for their geometric mean, which leaves e² / 2.
    const glm::dvec3 normal = (2 * radius / (radius * radius + glm::dot(out, out))) * out;
    return make(t, c + radius * normal, normal, 0x1p-50 * size);
}

}  // namespace precise

/// For rays that graze the outer part of the sphere, come from afar or start near its surface: the discriminant from the distance of
/// the ray's line to the center (Haines et al., Ray Tracing Gems, chapter 7), here as a R² - |f × d|², which needs no division.
/// Where the error bounds say that the t rounded to float or the decision might be wrong, double-double decides: for rays that
/// graze the outermost 2^-13 of the radius, or start nearer to the surface than 2^-15 of it.
[[nodiscard, gnu::noinline]] inline std::optional<precise::hit> intersect_with_care(const sphere& s, const precise::ray& r,
                                                                                    const interval& range) {
    const glm::dvec3 c(s.center), d = r.direction, f = c - r.origin;
    const double radius = s.radius, rr = radius * radius;
    const double a = glm::dot(d, d), b = glm::dot(f, d), ff = glm::dot(f, f), k = ff - rr;  // k wrong by at most 2^-50 |f|²
    const glm::dvec3 m = glm::cross(f, d);
    const double arr = a * rr, discriminant = arr - glm::dot(m, m);  // wrong by 2^-48 a |f| R, unless |m| > 2 R |d|
    const bool root_is_right = discriminant > 0x1p-12 * arr && ff < 0x1p34 * rr;
    const bool k_is_right = std::abs(k) > 0x1p-14 * ff || (k < -0x1p-48 * ff && b > 0 && range.min >= 0);
    if (!(root_is_right && k_is_right)) {
        if (discriminant < -(0x1p-30 * arr + 0x1p-50 * a * ff)) return std::nullopt;
        return intersect_in_doubt(s, r, range);
    }
    return precise::meet(s, r, range, f, a, b, k, std::sqrt(discriminant), precise::as_it_is);
}

namespace precise {

/// The roots of a t² - 2 b t + k without cancellation (Higham 2002, section 1.8). The discriminant is b² - a k where that is right,
/// which is for rays within 500 radii that do not graze: to 2^-31 of itself, when it is more than 2^-18 of a |f|², so t to
/// 2^-10 ulp of float. (Inlined always, for the widened ray to stay in registers.)
template <class Make>
[[nodiscard, gnu::always_inline]] inline auto find_hit(const sphere& s, const ray& r, const interval& range, Make make)
    -> decltype(make(0.0, r.origin, r.origin, 0.0)) {
    const glm::dvec3 d = r.direction, f = glm::dvec3(s.center) - r.origin;
    const double a = glm::dot(d, d);  // before the first return: what is always done, a loop over spheres does once
    const double b = glm::dot(f, d), ff = glm::dot(f, f), k = ff - double(s.radius) * double(s.radius);
    if (b <= 0 && k > 0x1p-48 * ff && range.min >= 0) return std::nullopt;  // outside, and going away
    const double aff = a * ff, discriminant = b * b - a * k;  // wrong by at most 2^-49 a (|f|² + R²)
    if (discriminant > 0x1p-18 * aff && std::abs(k) > 0x1p-14 * ff) [[likely]]
        return meet(s, r, range, f, a, b, k, std::sqrt(discriminant), make);
    if (discriminant < -0x1p-46 * aff && k > 0) return std::nullopt;
    const auto h = intersect_with_care(s, ray(r), range);
    if (!h) return std::nullopt;
    return make(h->t, h->point, h->normal, h->error);
}

}  // namespace precise

[[nodiscard, gnu::always_inline]] inline std::optional<precise::hit> intersect(const sphere& s, const precise::ray& r, interval range) {
    return precise::find_hit(s, r, range, precise::as_it_is);
}

/// The same, rounded where it is made: it need not go through memory.
[[nodiscard]] inline std::optional<hit> intersect(const sphere& s, const ray& r, interval range) {
    return precise::find_hit(s, precise::widen(r), range, precise::rounded_at_once);
}
/// For a timed ray the general template, which rounds later, would match better.
[[nodiscard]] inline std::optional<hit> intersect(const sphere& s, const timed_ray& r, interval range) {
    return intersect(s, static_cast<const ray&>(r), range);
}

}  // namespace lantern
