// SPDX-License-Identifier: MIT
#pragma once
// What lab 13 asks for.

#include <contract.hpp>

#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace contract::lab13 {

/// As the student's bias, finding and mistake.
struct bias_then {
    double mean, z;
};
enum class finding_then : std::uint8_t { sound, repeats, biased, slow };
enum class mistake_then : std::uint8_t { unknown, biased_jitter, constant_seed, clamped, no_cosine, half_lamp, dense_lens };

inline constexpr function<"rmse", double(std::span<const float> estimates, float exact)> rmse;
inline constexpr function<"bias_of", bias_then(std::span<const float> estimates, float exact)> bias_of;
inline constexpr function<"slope", double(std::span<const std::uint32_t> samples, std::span<const double> errors)> slope;
inline constexpr function<"time_factor", double(double slope, double factor)> time_factor;
inline constexpr function<"cells", glm::uvec2(std::uint32_t count)> cells;
inline constexpr function<"stratum", std::uint32_t(std::uint32_t i, std::uint32_t count, std::uint32_t purpose, glm::uvec2 pixel)> stratum;
inline constexpr function<"diagnose", finding_then(std::span<const std::uint32_t> samples, std::span<const std::vector<float>> estimates,
                                                   float exact, double theory)> diagnose;
inline constexpr function<"diagnoses", std::array<mistake_then, 6>()> diagnoses;

}  // namespace contract::lab13
