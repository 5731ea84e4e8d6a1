// SPDX-License-Identifier: MIT
#pragma once
// The error that a picture must have: the root mean square error of jittered samples, predicted from closed forms.

#include <lantern/exact.hpp>
#include <lantern/warp.hpp>

#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lantern::exact {

/// Jittered samples of something that is either seen or not, one in each cell of a side × side grid: every cell adds
/// the variance of one toss, p (1 - p), so the RMSE of the mean is √Σ p (1-p) / N, N = side². `fraction(i, j)` is the
/// part of cell (i, j) that is seen.
template <std::invocable<std::uint32_t, std::uint32_t> Fraction>
[[nodiscard]] double jittered_rmse(std::uint32_t side, Fraction fraction) {
    double sum = 0;
    for (std::uint32_t j = 0; j < side; ++j)
        for (std::uint32_t i = 0; i < side; ++i) {
            const double p = fraction(i, j);
            sum += p * (1 - p);
        }
    return std::sqrt(sum) / (double(side) * side);
}

/// The same for an edge: only the cells that it crosses have any variance, about N^½ of N, hence the error falls as
/// N^-¾.
[[nodiscard]] inline double jittered_rmse(std::uint32_t side, half_plane h) {
    return jittered_rmse(side, [=](std::uint32_t i, std::uint32_t j) {
        return clipped_area({h.a + (i * h.b + j * h.c) / side, h.b / side, h.c / side});
    });
}

/// What one purpose draws, with its weights as in `fraction_below`: one number from a row of N strata (time; the second
/// weight is not used), two from a grid (pixel, square lens, light, gloss), or two from a grid that `to_disk` makes
/// round (round lens; the weights are those of its radii to the right and upwards).
struct drawn {
    enum class shape { line, square, disc };
    std::array<double, 2> weights{};
    shape from = shape::square;
};

namespace detail {

/// A function that is 0 below `low` and 1 above `high`, read from a table: the second moments ask for it very often.
class table {
public:
    template <std::invocable<double> Function>
    table(Function f, double low, double high) : low_(low), scale_(steps / (high - low)) {
        for (int i = 0; i <= steps; ++i) values_.push_back(f(low + i / scale_));
    }
    [[nodiscard]] double operator()(double x) const {
        const double at = (x - low_) * scale_;
        if (!(at > 0)) return 0;
        if (!(at < steps)) return 1;
        const auto i = std::size_t(at);
        return values_[i] + (at - double(i)) * (values_[i + 1] - values_[i]);
    }

private:
    static constexpr int steps = 2048;
    double low_, scale_;
    std::vector<double> values_;
};

/// Points of one stratum of a round lens, or, with side 1, of the whole.
[[nodiscard]] inline std::vector<double> disc_points(const drawn& lens, std::uint32_t i, std::uint32_t j,
                                                     std::uint32_t side) {
    const std::uint32_t points = side == 1 ? 64 : 16;
    std::vector<double> offsets;
    for (std::uint32_t y = 0; y < points; ++y)
        for (std::uint32_t x = 0; x < points; ++x) {
            const glm::vec2 at = to_disk((glm::vec2(i, j) + (glm::vec2(x, y) + 0.5f) / float(points)) / float(side));
            offsets.push_back(lens.weights[0] * at.x + lens.weights[1] * at.y);
        }
    return offsets;
}

/// How far each stratum of a purpose moves the ray; a stratum of a lens, by each of its points.
[[nodiscard]] inline std::vector<std::vector<double>> strata(const drawn& p, std::uint32_t side) {
    std::vector<std::vector<double>> all;
    for (std::uint32_t j = 0; j < side; ++j)
        for (std::uint32_t i = 0; i < side; ++i) {
            if (p.from == drawn::shape::line)
                all.push_back({p.weights[0] * (j * side + i) / (side * side)});
            else if (p.from == drawn::shape::square)
                all.push_back({(p.weights[0] * i + p.weights[1] * j) / side});
            else
                all.push_back(disc_points(p, i, j, side));
        }
    return all;
}

/// E[(E[seen | strata of the fixed purposes])²]: the mean square, over all strata of these, of what is seen from there.
/// Good to about 1e-4.
[[nodiscard]] inline double second_moment(std::span<const drawn> purposes, std::uint32_t fixed, std::uint32_t side,
                                          double d) {
    std::vector<double> weights;  // of what is left to chance: all that is not fixed, and the place within a stratum
    std::vector<std::vector<std::vector<double>>> outer;
    std::vector<double> lens{0};
    for (std::size_t k = 0; k < purposes.size(); ++k) {
        const drawn& p = purposes[k];
        const bool is_fixed = fixed >> k & 1;
        if (is_fixed) outer.push_back(strata(p, side));
        if (p.from == drawn::shape::disc) {
            if (!is_fixed) lens = disc_points(p, 0, 0, 1);
            continue;
        }
        weights.push_back(p.weights[0] / (!is_fixed ? 1 : p.from == drawn::shape::line ? side * side : side));
        if (p.from == drawn::shape::square) weights.push_back(p.weights[1] / (is_fixed ? side : 1));
    }
    double low = 0, high = 0;
    for (const double w : weights) (w < 0 ? low : high) += w;
    const table square([&](double x) { return fraction_below(weights, x); }, low, high);
    const auto [left, right] = std::ranges::minmax(lens);
    const table free(
        [&](double x) {
            double sum = 0;
            for (const double offset : lens) sum += square(x - offset);
            return sum / double(lens.size());
        },
        low + left, high + right);

    const auto over = [&](const auto& self, std::size_t k, const std::vector<double>& rests) -> double {
        if (k == outer.size()) {
            double sum = 0;
            for (const double rest : rests) sum += free(rest);
            return sum * sum / double(rests.size() * rests.size());
        }
        double sum = 0;
        std::vector<double> further;
        for (const std::vector<double>& stratum : outer[k]) {
            further.clear();
            for (const double rest : rests)
                for (const double offset : stratum) further.push_back(rest - offset);
            sum += self(self, k + 1, further);
        }
        return sum / double(outer[k].size());
    };
    return over(over, 0, {d});
}

}  // namespace detail

/// The variance of the mean of N samples whose purposes are each stratified by themselves, N strata each, and paired by
/// independent random permutations (Latin hypercube sampling, McKay, Beckman and Conover 1979, with grids for columns).
/// `mean_square` is E[f²]; `moment(T)` is E[(E[f | strata of the purposes in T])²], T a set of bits, moment(0) the
/// squared mean. Two samples never share a stratum; what they share is therefore a little less than nothing: cov = Σ_T
/// (N/(N-1))^(K-|T|) (-1/(N-1))^|T| moment(T) - mean². Sets of more than `largest` purposes are left out: they weigh
/// (N-1)^-|T|.
template <std::invocable<std::uint32_t> Moment>
[[nodiscard]] double padded_variance(std::uint32_t purposes, std::uint32_t count, double mean_square, Moment moment,
                                     int largest = 3) {
    const double N = count, mean2 = moment(0);
    double covariance = 0;
    for (std::uint32_t T = 1; T < 1u << purposes; ++T) {
        const int size = std::popcount(T);
        if (size > largest) continue;
        covariance += std::pow(N / (N - 1), int(purposes) - size) * std::pow(-1 / (N - 1), size) * (moment(T) - mean2);
    }
    return (mean_square - mean2) / N + (N - 1) / N * covariance;
}

/// The RMSE of side² jittered samples of P(Σ wᵢUᵢ < d), for any combination of effects.
[[nodiscard]] inline double jittered_rmse(std::uint32_t side, std::span<const drawn> purposes, double d) {
    const double mean = std::sqrt(detail::second_moment(purposes, 0, side, d));
    return std::sqrt(padded_variance(std::uint32_t(purposes.size()), side * side, mean, [&](std::uint32_t fixed) {
        return detail::second_moment(purposes, fixed, side, d);
    }));
}

}  // namespace lantern::exact
