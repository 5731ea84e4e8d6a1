// SPDX-License-Identifier: MIT
#pragma once
// The sphere, right from a ray that grazes it to a ground of radius 1e12.

#include <lantern/aabb.hpp>
#include <lantern/double_double.hpp>
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
    if (radius == 0) normal = -r.direction;
    normal /= glm::length(normal);

    // Measured from the center, or from the ray's origin: whichever rounds less.
    const glm::dvec3 c(s.center), step = t * r.direction;
    const double from_center = precise::size(c) + radius, from_origin = precise::size(r.origin) + precise::size(step);
    const glm::dvec3 point = from_origin < from_center ? r.origin + step : c + radius * normal;
    return precise::hit{t, point, s.radius < 0 ? -normal : normal, 0x1p-50 * std::min(from_center, from_origin)};
}

/// The discriminant from the distance of the ray's line to the center (Haines et al., Ray Tracing Gems, chapter 7), the
/// roots without cancellation (Higham 2002, section 1.8). Where the error bounds say that the t rounded to float or
/// the decision might be wrong, double-double decides.
[[nodiscard]] inline std::optional<precise::hit> intersect(const sphere& s, const precise::ray& r, interval range) {
    const glm::dvec3 c(s.center), d = r.direction, f = r.origin - c;
    const double radius = std::abs(double(s.radius));
    const double a = glm::dot(d, d), b = -glm::dot(f, d), ff = glm::dot(f, f), rr = radius * radius;
    const double k = ff - rr;  // wrong by at most 2^-50 |f|²
    if (k > 0x1p-48 * ff && b <= 0 && range.min >= 0) return std::nullopt;  // outside, and going away

    const double per_a = 1 / a;
    const glm::dvec3 l = f + (b * per_a) * d;  // wrong by at most 2^-50 |f|
    const double gap = rr - glm::dot(l, l);
    const double size = precise::size(f);
    const double doubt = 0x1p-48 * size * (radius + 0x1p-46 * size);  // bounds the error of gap, whenever |l| < 2 R
    if (gap < -doubt) return std::nullopt;

    const double root = std::sqrt(a * gap);
    const double q = b >= 0 ? b + root : b - root;
    const bool root_is_right = a * doubt < root * std::min(0x1p-26 * root, 0x1p-35 * std::abs(q));
    const bool k_is_right = std::abs(k) > 0x1p-14 * ff || (k < -0x1p-48 * ff && b > 0 && range.min >= 0);
    if (!(root_is_right && k_is_right)) return intersect_in_doubt(s, r, range);

    const double by_k = k / q, by_a = q * per_a;
    const double t0 = b >= 0 ? by_k : by_a, t1 = b >= 0 ? by_a : by_k;
    const bool enters = contains(range, t0);
    if (!enters && !contains(range, t1)) return std::nullopt;
    const double along = (enters ? -root : root) * per_a;
    const glm::dvec3 normal = (l + along * d) / radius;  // of length 1 already, for |l|² + gap = R²
    const double error = 0x1p-50 * (size + precise::size(c) + radius);
    return precise::hit{enters ? t0 : t1, c + radius * normal, s.radius < 0 ? -normal : normal, error};
}

}  // namespace lantern
