// SPDX-License-Identifier: MIT
#pragma once
// A sum without rounding: in whatever order, and in however many parts, numbers are added, the result has the same bits.

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace lantern {

/// The exact sum of up to 2^62 products of two floats each. A long fixed-point number in digits of 32 bits, each kept in a
/// 64-bit integer so that carries may wait (the superaccumulator of Kulisch; Neal, "Fast exact summation using small and
/// large superaccumulators", 2015). All digits but the last are in [0, 2^32) once `settle` has carried: the digits are then
/// the same for the same sum, whatever its history.
class exact_sum {
public:
    /// The least product of two floats is 2^-298; the greatest is below 2^256, and 2^62 of them below 2^318.
    static constexpr int lowest_power = -352;
    static constexpr std::size_t digits = 21;

    /// Adds value × weight. Both must be finite.
    void add(float value, float weight = 1) {
        const double product = double{value} * double{weight};  // exact: 24 + 24 bits
        if (product == 0) return;
        int exponent = 0;
        const double fraction = std::frexp(product, &exponent);  // product = fraction × 2^exponent, 1/2 <= |fraction| < 1
        const auto bits = static_cast<std::int64_t>(std::ldexp(std::abs(fraction), 53));
        const auto position = static_cast<unsigned>(exponent - 53 - lowest_power);
        const std::size_t first = position / 32;
        const unsigned shift = position % 32;
        const auto low = static_cast<std::uint64_t>(bits) << shift;
        const auto high = shift == 0 ? 0 : static_cast<std::uint64_t>(bits) >> (64 - shift);
        const std::int64_t sign = product < 0 ? -1 : 1;
        digit_[first] += sign * static_cast<std::int64_t>(low & 0xffffffffu);
        digit_[first + 1] += sign * static_cast<std::int64_t>(low >> 32);
        digit_[first + 2] += sign * static_cast<std::int64_t>(high);
        if (++waiting_ == most_waiting) settle();
    }

    /// Adds what another one holds.
    void add(const exact_sum& other) {
        exact_sum settled = other;
        settled.settle();
        settle();
        for (std::size_t i = 0; i < digits; ++i) digit_[i] += settled.digit_[i];
        settle();
    }

    /// The sum, rounded: within two units in the last place of double, and a function of the exact sum alone.
    [[nodiscard]] double value() const {
        exact_sum settled = *this;
        settled.settle();
        const bool negative = settled.digit_.back() < 0;
        if (negative) settled.negate();
        double sum = 0;
        for (std::size_t i = 0; i < digits; ++i)  // from the smallest: each step rounds what is far below the result
            sum += std::ldexp(static_cast<double>(settled.digit_[i]), static_cast<int>(32 * i) + lowest_power);
        return negative ? -sum : sum;
    }

    /// The digits after all carries, the lowest first: what to keep in a file.
    [[nodiscard]] std::array<std::int64_t, digits> settled() const {
        exact_sum s = *this;
        s.settle();
        return s.digit_;
    }

    /// From digits as `settled` gives them.
    [[nodiscard]] static exact_sum from(std::span<const std::int64_t, digits> those) {
        exact_sum s;
        for (std::size_t i = 0; i < digits; ++i) s.digit_[i] = those[i];
        return s;
    }

    [[nodiscard]] bool operator==(const exact_sum& other) const { return settled() == other.settled(); }

private:
    static constexpr std::uint32_t most_waiting = std::uint32_t{1} << 29;  // of numbers below 2^32: no digit overflows

    void settle() {
        for (std::size_t i = 0; i + 1 < digits; ++i) {
            const std::int64_t carry = digit_[i] >> 32;  // rounds down, also below zero
            digit_[i] -= carry * (std::int64_t{1} << 32);
            digit_[i + 1] += carry;
        }
        waiting_ = 0;
    }
    void negate() {
        for (std::int64_t& d : digit_) d = -d;
        settle();
    }

    std::array<std::int64_t, digits> digit_{};
    std::uint32_t waiting_ = 0;
};

}  // namespace lantern
