// SPDX-License-Identifier: MIT
#pragma once
// For tests of numbers: a wider type to know the truth in, errors in ulp, and dice that fall alike everywhere.

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

/// At least 113 bits where there are any; 64 with 80-bit long double.
#if defined(__SIZEOF_FLOAT128__)
__extension__ typedef __float128 wide;
#else
using wide = long double;
#endif

using wide3 = std::array<wide, 3>;

inline wide3 widened(glm::vec3 v) { return {v.x, v.y, v.z}; }
inline wide3 operator+(const wide3& a, const wide3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline wide3 operator-(const wide3& a, const wide3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline wide3 operator*(wide s, const wide3& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline wide dot(const wide3& a, const wide3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline wide3 cross(const wide3& a, const wide3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline wide magnitude(wide x) { return x < 0 ? -x : x; }

/// Newton's steps from the double root: 53 bits, 106, all.
inline wide square_root(wide x) {
    if (!(x > 0)) return 0;
    wide root = std::sqrt(static_cast<double>(x));
    for (int i = 0; i < 2; ++i) root = (root + x / root) / 2;
    return root;
}

inline wide length(const wide3& a) { return square_root(dot(a, a)); }

/// |got - truth| in units of the last place that a float of the truth's size has.
inline double error_in_ulp(float got, wide truth) {
    const double size = std::abs(static_cast<double>(truth));
    int exponent = 0;
    std::frexp(size, &exponent);
    const double ulp = std::ldexp(1.0, std::max(exponent, std::numeric_limits<float>::min_exponent) - 24);
    return static_cast<double>(magnitude(static_cast<wide>(got) - truth) / static_cast<wide>(ulp));
}

/// The largest absolute difference of a component.
inline double largest_difference(glm::vec3 got, const wide3& truth) {
    double largest = 0;
    for (int i = 0; i < 3; ++i)
        largest = std::max(largest, static_cast<double>(magnitude(static_cast<wide>(got[i]) - truth[std::size_t(i)])));
    return largest;
}

/// Splitmix64 (Steele, Lea and Flood 2014): no std::uniform_*_distribution, which differs between libraries.
struct dice {
    std::uint64_t state = 1;

    std::uint64_t bits() {
        std::uint64_t z = (state += 0x9e3779b97f4a7c15u);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>((bits() >> 32) * n >> 32); }
    double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
    float between(double lo, double hi) { return static_cast<float>(lo + unit() * (hi - lo)); }
    /// 10^lo … 10^hi, every order of magnitude alike.
    float magnitude_between(double lo, double hi) { return static_cast<float>(std::pow(10, lo + unit() * (hi - lo))); }
    glm::vec3 in_cube(double half = 1) { return {between(-half, half), between(-half, half), between(-half, half)}; }
    glm::dvec3 on_sphere() {
        const double z = 2 * unit() - 1, angle = 2 * std::numbers::pi * unit(), r = std::sqrt(1 - z * z);
        return {r * std::cos(angle), r * std::sin(angle), z};
    }
};
