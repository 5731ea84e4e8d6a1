// SPDX-License-Identifier: MIT
#pragma once
// Eight floats or four doubles at a time: the compiler's vector extensions, and the few steps that they lack.

#include <lantern/double_double.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

#if defined(__AVX2__)
#include <immintrin.h>
#endif

namespace lantern {

// + - * / and comparisons work lane by lane. A comparison gives integers, -1 where it holds and 0 where it does not.
// Without wide registers the compiler takes several narrow ones, or none. Vectors are handed over by reference only, for
// how they are handed over by value depends on the processor that is compiled for.
using floats = float __attribute__((vector_size(32)));            ///< 8
using integers = std::int32_t __attribute__((vector_size(32)));   ///< 8
using doubles = double __attribute__((vector_size(32)));          ///< 4
using long_integers = std::int64_t __attribute__((vector_size(32)));  ///< 4

/// The lanes' smaller (larger) numbers. No NaN, please.
[[gnu::always_inline]] inline void keep_smaller(floats& a, const floats& b) {
#if defined(__AVX2__)
    a = _mm256_min_ps(a, b);
#else
    a = b < a ? b : a;
#endif
}
[[gnu::always_inline]] inline void keep_larger(floats& a, const floats& b) {
#if defined(__AVX2__)
    a = _mm256_max_ps(a, b);
#else
    a = b > a ? b : a;
#endif
}

/// Bit i is set where lane i of a comparison's result holds.
[[nodiscard, gnu::always_inline]] inline std::uint32_t lanes_of(const integers& mask) {
#if defined(__AVX2__)
    return static_cast<std::uint32_t>(_mm256_movemask_ps(reinterpret_cast<__m256>(mask)));
#else
    std::uint32_t bits = 0;
    for (int i = 0; i < 8; ++i) bits |= static_cast<std::uint32_t>(mask[i] & 1) << i;
    return bits;
#endif
}
[[nodiscard, gnu::always_inline]] inline std::uint32_t lanes_of(const long_integers& mask) {
#if defined(__AVX2__)
    return static_cast<std::uint32_t>(_mm256_movemask_pd(reinterpret_cast<__m256d>(mask)));
#else
    std::uint32_t bits = 0;
    for (int i = 0; i < 4; ++i) bits |= static_cast<std::uint32_t>(mask[i] & 1) << i;
    return bits;
#endif
}

/// Four floats in a row, as doubles: exact.
[[gnu::always_inline]] inline void widen(const float* from, doubles& to) {
#if defined(__AVX2__)
    to = _mm256_cvtps_pd(_mm_loadu_ps(from));
#else
    to = doubles{double(from[0]), double(from[1]), double(from[2]), double(from[3])};
#endif
}

/// Lane by lane what `std::fma` does: x * y + z, rounded once.
[[gnu::always_inline]] inline void fused(const doubles& x, const doubles& y, const doubles& z, doubles& to) {
#if defined(__AVX2__) && defined(__FMA__)
    to = _mm256_fmadd_pd(x, y, z);
#else
    to = doubles{std::fma(x[0], y[0], z[0]), std::fma(x[1], y[1], z[1]), std::fma(x[2], y[2], z[2]), std::fma(x[3], y[3], z[3])};
#endif
}

/// To the last bit what their namesakes of double_double.hpp do in each lane.
[[gnu::always_inline]] inline void multiply_add(const doubles& x, const doubles& y, const doubles& z, doubles& to) {
    if constexpr (has_fused_multiply_add)
        fused(x, y, z, to);
    else
        to = x * y + z;
}
[[gnu::always_inline]] inline void difference_of_products(const doubles& a, const doubles& b, const doubles& c,
                                                          const doubles& d, doubles& to) {
    if constexpr (has_fused_multiply_add) {
        doubles cd, error;
        fused(c, d, doubles{}, cd);
        fused(-c, d, cd, error);
        fused(a, b, -cd, to);
        to += error;
    } else {
        to = a * b - c * d;
    }
}

}  // namespace lantern
