// SPDX-License-Identifier: MIT
#pragma once
// Eight floats or four doubles at a time: the compiler's vector extensions, and the few steps that they lack.

#include <lantern/double_double.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

#if defined(__SSE2__)
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
using quad = float __attribute__((vector_size(16)));              ///< 4 floats: x, y, z of something, and one to spare
using quad_integers = std::int32_t __attribute__((vector_size(16)));  ///< 4

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
[[gnu::always_inline]] inline void keep_smaller(quad& a, const quad& b) {
#if defined(__SSE2__)
    a = _mm_min_ps(a, b);
#else
    a = b < a ? b : a;
#endif
}
[[gnu::always_inline]] inline void keep_larger(quad& a, const quad& b) {
#if defined(__SSE2__)
    a = _mm_max_ps(a, b);
#else
    a = b > a ? b : a;
#endif
}
[[gnu::always_inline]] inline void keep_smaller(doubles& a, const doubles& b) {
#if defined(__AVX2__)
    a = _mm256_min_pd(a, b);
#else
    a = b < a ? b : a;
#endif
}
[[gnu::always_inline]] inline void keep_larger(doubles& a, const doubles& b) {
#if defined(__AVX2__)
    a = _mm256_max_pd(a, b);
#else
    a = b > a ? b : a;
#endif
}

/// x in all lanes.
[[gnu::always_inline]] inline void spread(float x, floats& to) { to = floats{x, x, x, x, x, x, x, x}; }

[[gnu::always_inline]] inline void spread(double x, doubles& to) { to = doubles{x, x, x, x}; }

/// Eight floats in a row, that many bytes from an address; a multiple of 32 both.
[[gnu::always_inline]] inline void load(const float* from, std::size_t bytes, floats& to) {
    using in_memory = floats __attribute__((may_alias));
    to = *reinterpret_cast<const in_memory*>(reinterpret_cast<const std::byte*>(from) + bytes);
}

/// The first four lanes, and the last four.
[[gnu::always_inline]] inline void take_apart(const floats& all, quad& first, quad& last) {
#if defined(__AVX2__)
    first = _mm256_castps256_ps128(all);
    last = _mm256_extractf128_ps(all, 1);
#else
    first = quad{all[0], all[1], all[2], all[3]};
    last = quad{all[4], all[5], all[6], all[7]};
#endif
}
[[gnu::always_inline]] inline void put_together(const quad& first, const quad& last, floats& all) {
#if defined(__AVX2__)
    all = _mm256_set_m128(last, first);
#else
    all = floats{first[0], first[1], first[2], first[3], last[0], last[1], last[2], last[3]};
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
[[nodiscard, gnu::always_inline]] inline std::uint32_t lanes_of(const quad_integers& mask) {
#if defined(__SSE2__)
    return static_cast<std::uint32_t>(_mm_movemask_ps(reinterpret_cast<__m128>(mask)));
#else
    std::uint32_t bits = 0;
    for (int i = 0; i < 4; ++i) bits |= static_cast<std::uint32_t>(mask[i] & 1) << i;
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

/// Bit i is set where a < b in lane i.
[[nodiscard, gnu::always_inline]] inline std::uint32_t lanes_less(const doubles& a, const doubles& b) {
#if defined(__AVX2__)
    return static_cast<std::uint32_t>(_mm256_movemask_pd(_mm256_cmp_pd(a, b, _CMP_LT_OQ)));
#else
    return lanes_of(long_integers(a < b));
#endif
}

[[nodiscard, gnu::always_inline]] inline std::uint32_t lanes_less(const quad& a, const quad& b) {
#if defined(__AVX2__)
    return static_cast<std::uint32_t>(_mm_movemask_ps(_mm_cmp_ps(a, b, _CMP_LT_OQ)));
#else
    return lanes_of(quad_integers(a < b));
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

[[gnu::always_inline]] inline void widen(const quad& from, doubles& to) { to = __builtin_convertvector(from, doubles); }
[[gnu::always_inline]] inline void narrow(const doubles& from, quad& to) { to = __builtin_convertvector(from, quad); }

/// x, negated where y is negative.
[[gnu::always_inline]] inline void signed_as(const quad& x, const quad& y, quad& to) {
    to = reinterpret_cast<quad>(reinterpret_cast<quad_integers>(x) ^ (reinterpret_cast<quad_integers>(y) & INT32_MIN));
}

[[gnu::always_inline]] inline void signed_as(const doubles& x, const doubles& y, doubles& to) {
    to = reinterpret_cast<doubles>(reinterpret_cast<long_integers>(x) ^ (reinterpret_cast<long_integers>(y) & INT64_MIN));
}

/// |x|: all bits but the sign's.
[[gnu::always_inline]] inline void magnitude(const quad& x, quad& to) {
    to = reinterpret_cast<quad>(reinterpret_cast<quad_integers>(x) & INT32_MAX);
}
[[gnu::always_inline]] inline void magnitude(const doubles& x, doubles& to) {
    to = reinterpret_cast<doubles>(reinterpret_cast<long_integers>(x) & INT64_MAX);
}

/// Lane by lane what `std::fma` does: x * y + z, rounded once.
[[gnu::always_inline]] inline void fused(const doubles& x, const doubles& y, const doubles& z, doubles& to) {
#if defined(__AVX2__) && defined(__FMA__)
    to = _mm256_fmadd_pd(x, y, z);
#else
    to = doubles{std::fma(x[0], y[0], z[0]), std::fma(x[1], y[1], z[1]), std::fma(x[2], y[2], z[2]), std::fma(x[3], y[3], z[3])};
#endif
}

/// x * y + z, in one step where the processor has one.
[[gnu::always_inline]] inline void multiply_add(const floats& x, const floats& y, const floats& z, floats& to) {
#if defined(__AVX2__) && defined(__FMA__)
    to = _mm256_fmadd_ps(x, y, z);
#else
    to = x * y + z;
#endif
}

/// To the last bit what its namesake of double_double.hpp does in each lane.
[[gnu::always_inline]] inline void multiply_add(const doubles& x, const doubles& y, const doubles& z, doubles& to) {
    if constexpr (has_fused_multiply_add)
        fused(x, y, z, to);
    else
        to = x * y + z;
}

}  // namespace lantern
