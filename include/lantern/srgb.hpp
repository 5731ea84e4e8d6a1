// SPDX-License-Identifier: MIT
#pragma once
// The sRGB transfer curve: from linear light to the numbers that files and screens hold, and back.

#include <lantern/validate.hpp>

#include <glm/vec3.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace lantern {

/// IEC 61966-2-1. Linear light in [0, 1] to [0, 1]; what lies outside is clamped first, NaN counts as black.
/// In double, for the value rounded to float, and then to a byte, is in practice the same with every C library.
[[nodiscard]] inline float to_srgb(float linear) {
    if (!(linear > 0)) return 0;
    if (linear >= 1) return 1;
    const double x = linear, seam = 0.0031308;
    if (x <= seam) return static_cast<float>(12.92 * x);
    // The standard's rounded constants let the curve fall by 3e-8 at the seam; it must not.
    return static_cast<float>(std::max(12.92 * seam, 1.055 * std::pow(x, 1 / 2.4) - 0.055));
}

/// The inverse, for [0, 1] likewise clamped.
[[nodiscard]] inline float from_srgb(float encoded) {
    if (!(encoded > 0)) return 0;
    if (encoded >= 1) return 1;
    const double x = encoded;
    return static_cast<float>(x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4));
}

/// The nearest of the 256 levels. from_srgb(byte / 255) brings each back exactly.
[[nodiscard]] inline std::uint8_t to_byte(float linear) {
    return static_cast<std::uint8_t>(to_srgb(linear) * 255.0 + 0.5);
}

/// Three bytes a pixel. Returns how many pixels were not finite: NaN and -infinity become 0, +infinity 255.
inline std::uint64_t encode_srgb(std::span<const glm::vec3> pixels, std::span<std::uint8_t> bytes) {
    assert(bytes.size() == 3 * pixels.size());
    std::uint64_t not_finite = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        not_finite += !is_finite(pixels[i]);
        bytes[3 * i] = to_byte(pixels[i].x);
        bytes[3 * i + 1] = to_byte(pixels[i].y);
        bytes[3 * i + 2] = to_byte(pixels[i].z);
    }
    return not_finite;
}

}  // namespace lantern
