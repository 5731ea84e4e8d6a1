// SPDX-License-Identifier: MIT
#pragma once
// Lab 13: how large the error is, how fast it falls, and what is wrong when it does not. The handout is README.md in this folder.

#include <lantern/hash.hpp>
#include <lantern/todo.hpp>

#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace lab13 {

/// Step 1. The root mean square error of estimates of one and the same value. There is at least one.
[[nodiscard]] inline double rmse(std::span<const float> estimates, float exact) {
    return lantern::todo("lab13 step 1: the root mean square error");
}

/// A mean error, and how many of its own standard errors it is away from 0.
struct bias {
    double mean = 0;
    double z = 0;
};

/// Step 2. The bias of at least two estimates. Their mean error is known within s / √n, where s² is the sum of the squared
/// distances from their mean, divided by n - 1; z is the mean error divided by that. Without any scatter z is 0 where the
/// estimates are right, and infinite, with the sign of the error, where they are wrong.
[[nodiscard]] inline bias bias_of(std::span<const float> estimates, float exact) {
    return lantern::todo("lab13 step 2: bias, in standard errors");
}

/// Step 3. The exponent e of errors ≈ c · samplesᵉ: the slope of the straight line through the logarithms that is nearest to
/// them by least squares. At least two different numbers of samples, as many errors, all positive.
[[nodiscard]] inline double slope(std::span<const std::uint32_t> samples, std::span<const double> errors) {
    return lantern::todo("lab13 step 3: the slope");
}

/// Step 4. How many times as long it takes until the error is `factor` times as large (1/2: half the error), when it falls with
/// this slope and time is proportional to samples. Infinite when the error does not fall.
[[nodiscard]] inline double time_factor(double slope, double factor) {
    return lantern::todo("lab13 step 4: what half the error costs");
}

/// Step 5. A grid for jittered samples with exactly `count` cells: columns and rows. Of all such grids the one nearest to a
/// square, not higher than wide. count is at least 1.
[[nodiscard]] inline glm::uvec2 cells(std::uint32_t count) {
    return lantern::todo("lab13 step 5: a grid for any number of samples");
}

/// Step 6. Which stratum of a purpose sample i of a pixel takes, when each purpose has `count` strata and the pixel `count`
/// samples. Over all i it is a permutation of 0 … count - 1, and every purpose and every pixel has another one, which has nothing to
/// do with those of the others. `lantern::permute(i, count, key)` is element i of a permutation that the 64 bits of `key` choose;
/// `lantern::hash(a, b, c …)` makes a key of whole numbers.
[[nodiscard]] inline std::uint32_t stratum(std::uint32_t i, std::uint32_t count, std::uint32_t purpose, glm::uvec2 pixel) {
    return lantern::todo("lab13 step 6: an order for each purpose");
}

/// What a measured curve shows.
enum class finding : std::uint8_t {
    sound,    ///< nothing is wrong
    repeats,  ///< every rendering is the same: they cannot be averaged
    biased,   ///< the error does not go away
    slow,     ///< it goes away, but slower than it should
};

/// Step 7. estimates[k] are renderings of one value with samples[k] samples each, with different seeds; there are at least 32 for each
/// number, and at least three numbers, ascending. Repeats: where, for each number of samples, all are equal. Biased: |z| above 5 at
/// the largest number of samples. Slow: the slope of RMSE is more than 0.12 above `theory`. In this order: the first that holds.
[[nodiscard]] inline finding diagnose(std::span<const std::uint32_t> samples, std::span<const std::vector<float>> estimates, float exact,
                                      double theory) {
    return lantern::todo("lab13 step 7: reading a curve");
}

/// What is wrong with a patient of the picture lab13_8_patients.png.
enum class mistake : std::uint8_t {
    unknown,        ///< you have not looked yet
    biased_jitter,  ///< jittered in ⌊√n⌋² cells, but divided by n
    constant_seed,  ///< the same random numbers in every rendering
    clamped,        ///< samples brighter than 1 count as 1
    no_cosine,      ///< the lamp's own cosine is forgotten
    half_lamp,      ///< only the middle of the lamp is sampled, but it counts as the whole
    dense_lens,     ///< the radius on the lens is ξ where it should be √ξ
};

/// Step 8. What is wrong with patients 1 to 6, in this order. Each mistake is one patient's.
[[nodiscard]] inline std::array<mistake, 6> diagnoses() {
    return lantern::todo("lab13 step 8: six patients");
}

}  // namespace lab13
