// SPDX-License-Identifier: MIT
#pragma once
// A bias that differs from pixel to pixel: at edges that rise and edges that fall it cancels in the mean over a picture, and is
// there all the same.

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace bench {

/// The root mean square, over the pixels, of their biases; and how many standard deviations its square is above what noise makes.
struct pixel_bias {
    double rms = 0, z = 0;
};

/// errors[trial][pixel], at least two trials with as many pixels each; what is not finite counts as 0. With n trials of a pixel, mean m
/// and variance s², m² - s²/n is the square of its bias but for noise, which has the variance 2 s⁴/n² · n/(n-1) where errors are
/// normal. z is below zero as often as above when there is no bias; it has the tail of χ², so it passes 6 about once in 10⁵.
[[nodiscard]] inline pixel_bias pixel_bias_of(std::span<const std::vector<float>> errors) {
    const double n = double(errors.size());
    double excess = 0, variance = 0;
    for (std::size_t p = 0; p < errors[0].size(); ++p) {
        const auto at = [p](const std::vector<float>& trial) { return std::isfinite(trial[p]) ? double(trial[p]) : 0; };
        double mean = 0, squares = 0;
        for (const auto& trial : errors) mean += at(trial) / n;
        for (const auto& trial : errors) squares += (at(trial) - mean) * (at(trial) - mean);
        const double spread = squares / (n - 1) / n;
        excess += mean * mean - spread;
        variance += 2 * spread * spread * n / (n - 1);
    }
    const double rms = std::sqrt(excess > 0 ? excess / double(errors[0].size()) : 0);
    if (variance > 0) return {rms, excess / std::sqrt(variance)};
    return {rms, excess > 0 ? std::numeric_limits<double>::infinity() : 0};
}

}  // namespace bench
