// SPDX-License-Identifier: MIT
#pragma once
// How fast an error falls: root mean square error over many seeds, its slope with an interval, bias, and what accuracy costs.

#include <lantern/hash.hpp>
#include <lantern/image.hpp>
#include <lantern/render.hpp>
#include <lantern/validate.hpp>

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace lantern {

/// One rendering against what it must be: the mean of its errors and of their squares, over all its values.
struct trial {
    double mean_error = 0;
    double mean_square = 0;
    std::uint64_t not_finite = 0;  ///< values and samples that were NaN or infinite: left out, and counted
};

/// Of a picture, over pixels and channels. Refuses pictures of different sizes.
[[nodiscard]] inline trial difference(const image& picture, const image& exact) {
    if (picture.size() != exact.size()) refuse("difference: the pictures' sizes", "two different ones", "equal");
    trial t{.not_finite = picture.rejected()};
    double count = 0;
    for (std::size_t i = 0; i < exact.pixels().size(); ++i)
        for (int channel = 0; channel < 3; ++channel) {
            const double error = double{picture.pixels()[i][channel]} - double{exact.pixels()[i][channel]};
            if (!std::isfinite(error)) {
                ++t.not_finite;
                continue;
            }
            t.mean_error += error;
            t.mean_square += error * error;
            ++count;
        }
    if (count > 0) t.mean_error /= count, t.mean_square /= count;
    return t;
}

/// What came of it: trials[i] were made with samples[i] samples each, and seeds that no others had.
struct convergence {
    std::vector<std::uint32_t> samples;
    std::vector<std::vector<trial>> trials;
};

struct convergence_options {
    std::vector<std::uint32_t> samples{4, 16, 64, 256, 1024};
    std::uint32_t trials = 16;    ///< for each number of samples
    std::uint64_t first_seed = 0;
    unsigned threads = 0;         ///< 0: as many as the machine has
};

/// Calls experiment(samples, seed) -> trial from several threads. Refuses fewer than two trials, no samples, and numbers of
/// samples that do not ascend from at least 1. Never time this: time one thread that does nothing else.
template <class Experiment>
    requires std::same_as<std::invoke_result_t<const Experiment&, std::uint32_t, std::uint64_t>, trial>
[[nodiscard]] convergence measure_convergence(const Experiment& experiment, const convergence_options& options = {}) {
    if (options.trials < 2) refuse("convergence: trials", std::to_string(options.trials), "at least 2");
    const bool ascends = std::ranges::adjacent_find(options.samples, std::ranges::greater_equal{}) == options.samples.end();
    if (options.samples.empty() || options.samples.front() == 0 || !ascends)
        refuse("convergence: samples", "what was given", "numbers that ascend from at least 1");
    convergence result{options.samples, {}};
    result.trials.assign(options.samples.size(), std::vector<trial>(options.trials));
    in_parallel(options.samples.size() * options.trials, options.threads, [&](std::size_t i) {
        const std::size_t n = options.samples.size() - 1 - i / options.trials, k = i % options.trials;  // the longest first
        result.trials[n][k] = experiment(options.samples[n], hash(options.first_seed, n, k));
    });
    return result;
}

[[nodiscard]] inline double rmse(std::span<const trial> trials) {
    double sum = 0;
    for (const trial& t : trials) sum += t.mean_square;
    return std::sqrt(sum / static_cast<double>(trials.size()));
}

/// The mean error, and how many of its standard errors it is away from 0. `reference` is the standard error of the
/// reference itself, where it is no closed form. With n trials z has Student's distribution with n - 1 degrees of freedom.
struct bias {
    double value = 0, z = 0;
};

[[nodiscard]] inline bias bias_of(std::span<const trial> trials, double reference = 0) {
    const auto count = static_cast<double>(trials.size());
    double mean = 0, squares = 0;
    for (const trial& t : trials) mean += t.mean_error / count;
    for (const trial& t : trials) squares += (t.mean_error - mean) * (t.mean_error - mean);
    const double error = std::hypot(std::sqrt(squares / (count - 1) / count), reference);
    return {mean, error > 0 ? mean / error : mean == 0 ? 0 : std::copysign(std::numeric_limits<double>::infinity(), mean)};
}

/// A figure, and the interval that holds it with a confidence of 95 %.
struct estimate {
    double value = 0, low = 0, high = 0;
};

/// The exponent e of RMSE = c Nᵉ: least squares through the logarithms.
[[nodiscard]] inline double fitted_slope(std::span<const double> samples, std::span<const double> errors) {
    double x = 0, y = 0, xx = 0, xy = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double logn = std::log(samples[i]), loge = std::log(errors[i]);
        x += logn, y += loge, xx += logn * logn, xy += logn * loge;
    }
    const auto n = static_cast<double>(samples.size());
    return (n * xy - x * y) / (n * xx - x * x);
}

/// Percentiles of what `figure` makes of trials that are drawn anew, with replacement, among those at each number of samples:
/// the bootstrap of Efron 1979. `figure` takes a convergence and gives a number.
template <class Figure>
[[nodiscard]] estimate bootstrap(const convergence& c, const Figure& figure, std::uint32_t resamples = 1000, std::uint64_t seed = 0) {
    std::vector<double> figures;
    convergence drawn = c;
    for (std::uint32_t r = 0; r < resamples; ++r) {
        for (std::size_t n = 0; n < c.trials.size(); ++n)
            for (std::size_t k = 0; k < c.trials[n].size(); ++k)
                drawn.trials[n][k] = c.trials[n][hash(seed, r, n, k) % c.trials[n].size()];
        figures.push_back(figure(drawn));
    }
    std::ranges::sort(figures);
    const auto at = [&](double part) { return figures[static_cast<std::size_t>(part * static_cast<double>(figures.size() - 1) + 0.5)]; };
    return {figure(c), at(0.025), at(0.975)};
}

/// The slope of RMSE against the number of samples, from `least` samples on. Minus a half for independent samples; minus three
/// quarters for jittered ones on an edge. Where a trial's error is exactly 0 there is no slope: NaN.
[[nodiscard]] inline estimate slope(const convergence& c, std::uint32_t least = 1, std::uint32_t resamples = 1000) {
    return bootstrap(c, [=](const convergence& some) {
        std::vector<double> samples, errors;
        for (std::size_t n = 0; n < some.samples.size(); ++n)
            if (some.samples[n] >= least) {
                samples.push_back(some.samples[n]);
                errors.push_back(rmse(some.trials[n]));
            }
        return fitted_slope(samples, errors);
    }, resamples);
}

/// How many samples an error takes: along the straight line through the logarithms of the two nearest measurements, and of the
/// last two beyond these; infinite where the error does not fall from one to the other. Times the seconds of one sample it is the
/// time to that error. Refuses an error that is not positive, and fewer than two numbers of samples.
[[nodiscard]] inline double samples_for(const convergence& c, double error) {
    if (!(error > 0)) refuse("samples_for: error", std::to_string(error), "positive");
    if (c.samples.size() < 2) refuse("samples_for: numbers of samples", std::to_string(c.samples.size()), "at least 2");
    std::size_t n = 1;
    while (n + 1 < c.samples.size() && rmse(c.trials[n]) > error) ++n;
    const double before = rmse(c.trials[n - 1]), after = rmse(c.trials[n]);
    if (!(after < before)) return std::numeric_limits<double>::infinity();
    const double steps = std::log(error / before) / std::log(after / before);
    return c.samples[n - 1] * std::pow(double(c.samples[n]) / c.samples[n - 1], steps);
}

/// 1 / (variance × time): twice as much is worth twice the processors (Hammersley and Handscomb 1964).
[[nodiscard]] inline double efficiency(double rmse, double seconds) { return 1 / (rmse * rmse * seconds); }

}  // namespace lantern
