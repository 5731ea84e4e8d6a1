// SPDX-License-Identifier: MIT
#pragma once
// Statistics for tests: is a count what it should be, up to chance?

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

namespace statistics {

/// Tests fail when what they see would happen by chance less often than this. Seeds are fixed, so a test that passes once
/// passes always; after a change of the numbers drawn, one right test in a million fails.
inline constexpr double false_alarm = 1e-6;

/// The same limit for a normal deviate, on both sides.
inline constexpr double z_limit = 4.892;

/// The regularised upper incomplete gamma function Q(a, x), a > 0, x >= 0: its series below a + 1, its continued
/// fraction (by Lentz's method) above. Abramowitz and Stegun 6.5.29 and 6.5.31.
[[nodiscard]] inline double gamma_tail(double a, double x) {
    if (!(a > 0 && x >= 0)) throw std::invalid_argument("gamma_tail: a must be positive, x not negative");
    if (x == 0) return 1;
    const double scale = std::exp(a * std::log(x) - x - std::lgamma(a));
    if (x < a + 1) {
        double term = 1 / a, sum = term;
        for (double n = a + 1; term > sum * 1e-16; ++n) sum += term *= x / n;
        return 1 - sum * scale;
    }
    constexpr double tiny = std::numeric_limits<double>::min();
    double b = x + 1 - a, c = 1 / tiny, d = 1 / b, fraction = d;
    for (int i = 1; i < 100'000; ++i) {
        const double numerator = -i * (i - a);
        b += 2;
        d = 1 / (numerator * d + b);
        c = b + numerator / c;
        fraction *= c * d;
        if (std::abs(c * d - 1) < 1e-15) break;
    }
    return fraction * scale;
}

/// The probability that a chi-square variable with so many degrees of freedom exceeds the value.
[[nodiscard]] inline double chi_square_tail(double value, double degrees) { return gamma_tail(degrees / 2, value / 2); }

/// Pearson's test: the probability that counts differ this much from what is expected, if nothing is wrong. Cells that
/// expect less than 5 are thrown together with the next. Something in a cell that expects nothing gives 0.
[[nodiscard]] inline double chi_square_test(std::span<const double> observed, std::span<const double> expected) {
    double sum = 0, o = 0, e = 0;
    int cells = 0;
    for (std::size_t i = 0; i < observed.size(); ++i) {
        if (expected[i] == 0 && observed[i] > 0) return 0;
        o += observed[i];
        e += expected[i];
        if (e < 5) continue;
        sum += (o - e) * (o - e) / e;
        ++cells;
        o = e = 0;
    }
    return cells > 1 ? chi_square_tail(sum, cells - 1) : 1;
}

/// All cells expect the same.
[[nodiscard]] inline double chi_square_test(std::span<const double> observed) {
    double total = 0;
    for (const double o : observed) total += o;
    const std::vector<double> expected(observed.size(), total / static_cast<double>(observed.size()));
    return chi_square_test(observed, expected);
}

/// The mean of many numbers, and how sure it is.
class mean {
public:
    void add(double x) {
        ++count_;
        const double step = x - mean_;
        mean_ += step / count_;
        squares_ += step * (x - mean_);
    }
    [[nodiscard]] double value() const { return mean_; }
    [[nodiscard]] double variance() const { return squares_ / (count_ - 1); }
    /// Of the mean.
    [[nodiscard]] double standard_error() const { return std::sqrt(variance() / count_); }
    /// How many standard errors the mean is from what it should be. Rounding is no deviation.
    [[nodiscard]] double z(double expected) const {
        return (mean_ - expected) / std::max(standard_error(), 1e-12 * (1 + std::abs(expected)));
    }

private:
    double count_ = 0, mean_ = 0, squares_ = 0;
};

/// The cell of a number in [0, 1] when there are so many; 1 is in the last.
[[nodiscard]] inline std::size_t cell(double x, std::size_t cells) {
    const auto i = static_cast<std::size_t>(std::max(0.0, x) * static_cast<double>(cells));
    return i < cells ? i : cells - 1;
}

}  // namespace statistics
