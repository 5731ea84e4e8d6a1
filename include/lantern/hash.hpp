// SPDX-License-Identifier: MIT
#pragma once
// Random numbers without state: a hash of integers, a number in (0, 1) made of its bits, and keyed permutations.

#include <bit>
#include <concepts>
#include <cstdint>

namespace lantern {

/// A bijection of 64 bits in which every bit of the input changes every bit of the output with probability one half.
/// Variant 13 of Stafford, "Better bit mixing" (2011), the finaliser of SplitMix64 (Steele, Lea and Flood 2014).
[[nodiscard]] constexpr std::uint64_t mix_bits(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/// The hash of one or more integers, in their order. It has the same value on every machine, for ever.
template <std::convertible_to<std::uint64_t>... Integers>
[[nodiscard]] constexpr std::uint64_t hash(std::uint64_t first, Integers... rest) {
    constexpr std::uint64_t golden = 0x9e3779b97f4a7c15u;  // 2^64 / golden ratio: no input is a fixed point at zero
    std::uint64_t h = mix_bits(first + golden);
    ((h = mix_bits((h ^ static_cast<std::uint64_t>(rest)) + golden)), ...);
    return h;
}

[[nodiscard]] constexpr std::uint32_t low(std::uint64_t x) { return static_cast<std::uint32_t>(x); }
[[nodiscard]] constexpr std::uint32_t high(std::uint64_t x) { return static_cast<std::uint32_t>(x >> 32); }

/// The 32 bits as a fraction of one: an odd multiple of 2^-24, the middle of one of 2^23 equal stretches. Hence the
/// mean over all x is 1/2 exactly, and neither 0 nor 1 is ever returned. (x * 2^-32 rounded to float may be 1; and
/// (x >> 8) * 2^-24 has the mean 1/2 - 2^-25: a bias that a good sampler's error falls below within minutes.)
[[nodiscard]] constexpr float to_unit(std::uint32_t x) { return static_cast<float>((x >> 9) * 2 + 1) * 0x1p-24f; }

/// Element i of a permutation of 0 … count - 1 that the key chooses; i < count. Nothing is stored: invertible steps on
/// the smallest power of two that holds count, repeated until the result is below count (cycle walking; the idea is
/// Kensler's, "Correlated multi-jittered sampling", 2013; his constants reach only 8 of the 24 permutations of four
/// elements, these reach all, with equal frequency within .5 %). The last step makes every element uniform exactly.
[[nodiscard]] constexpr std::uint32_t permute(std::uint32_t i, std::uint32_t count, std::uint64_t key) {
    if (count < 2) return 0;
    const auto bits = static_cast<int>(std::bit_width(count - 1));  // its type differs between standard libraries
    const std::uint32_t mask = ~std::uint32_t{0} >> (32 - bits);
    const int half = (bits + 1) / 2;
    do {
        std::uint64_t k = key;
        for (int round = 0; round < 4; ++round) {
            k = k * 0xd1342543de82ef95u + 1;  // a linear congruential step: Steele and Vigna 2022
            i = (i + high(k)) * (low(k >> 20) | 1);
            i ^= (i & mask) >> half;
            i = (i * (low(k >> 40) | 1)) & mask;
            i ^= i >> 1;
        }
    } while (i >= count);
    const std::uint32_t turn = high(std::uint64_t{high(key) ^ (low(key) * 0x9e3779b9u)} * count);
    return i < count - turn ? i + turn : i - (count - turn);
}

}  // namespace lantern
