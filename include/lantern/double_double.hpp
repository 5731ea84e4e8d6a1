// SPDX-License-Identifier: MIT
#pragma once
// Arithmetic that knows its own rounding error: for the rare cases in which double is not enough.

#include <cmath>

namespace lantern {

// Where a compiler may contract x * y + z to a fused multiply-add, it must be told what is meant, or a difference of
// products loses its antisymmetry and an error-free transform its exactness. There every product that matters is
// written as a fused operation; elsewhere nothing can be contracted, and plain products are what they look like.
#if defined(FP_FAST_FMA) || defined(__FMA__) || defined(__ARM_FEATURE_FMA) || defined(__riscv_flen)
inline constexpr bool has_fused_multiply_add = true;
#else
inline constexpr bool has_fused_multiply_add = false;
#endif

/// x * y, rounded by itself whatever is done with it next.
[[nodiscard]] inline double product(double x, double y) {
    if constexpr (has_fused_multiply_add) return std::fma(x, y, 0.0);
    return x * y;
}

/// z + x * y; the same operations wherever it is inlined.
[[nodiscard]] inline double multiply_add(double x, double y, double z) {
    if constexpr (has_fused_multiply_add) return std::fma(x, y, z);
    return x * y + z;
}

/// a * b - c * d, never of the wrong sign, and zero or of the opposite sign when the products are exchanged. With fused
/// multiply-add by Kahan's algorithm (Jeannerod, Louvet and Muller 2013): at most 1.5 ulp of the result wrong.
[[nodiscard]] inline double difference_of_products(double a, double b, double c, double d) {
    if constexpr (has_fused_multiply_add) {
        const double cd = std::fma(c, d, 0.0);
        const double error = std::fma(-c, d, cd);
        return std::fma(a, b, -cd) + error;
    }
    return a * b - c * d;
}

/// The unevaluated sum high + low, |low| <= ulp(high) / 2: about 106 bits, as long as nothing overflows or underflows.
struct double_double {
    double high = 0;
    double low = 0;
};

/// a + b, exactly (Knuth).
[[nodiscard]] inline double_double two_sum(double a, double b) {
    const double sum = a + b;
    const double rest = sum - a;
    return {sum, (a - (sum - rest)) + (b - rest)};
}

/// a * b, exactly (Dekker and Veltkamp, or a fused multiply-add).
[[nodiscard]] inline double_double two_product(double a, double b) {
    const double p = product(a, b);
    if constexpr (has_fused_multiply_add) return {p, std::fma(a, b, -p)};
    constexpr double half = 134217729;  // 2^27 + 1
    const double as = half * a, ah = as - (as - a), al = a - ah;
    const double bs = half * b, bh = bs - (bs - b), bl = b - bh;
    return {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
}

[[nodiscard]] inline double_double operator-(double_double a) { return {-a.high, -a.low}; }

[[nodiscard]] inline double_double operator+(double_double a, double_double b) {
    const double_double s = two_sum(a.high, b.high), t = two_sum(a.low, b.low);
    const double_double u = two_sum(s.high, s.low + t.high);
    return two_sum(u.high, u.low + t.low);
}

[[nodiscard]] inline double_double operator-(double_double a, double_double b) { return a + -b; }

[[nodiscard]] inline double_double operator*(double_double a, double_double b) {
    const double_double p = two_product(a.high, b.high);
    return two_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

}  // namespace lantern
