// SPDX-License-Identifier: MIT
#pragma once
// Lab 13's stage: two scenes with known pixels, and six renderers that get them wrong, each in its own way. To read it before you
// have looked at their curves is to look up the answers.

#include <lantern/hash.hpp>
#include <lantern/warp.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace patients {

/// In the order of lab13::mistake.
enum class fault : std::uint8_t { none, biased_jitter, constant_seed, clamped, no_cosine, half_lamp, dense_lens };

/// Who is patient 1, 2, …, 6.
inline constexpr std::array<fault, 6> patient{fault::no_cosine, fault::biased_jitter, fault::dense_lens,
                                              fault::half_lamp, fault::constant_seed, fault::clamped};

/// Point i of n, in a unit square that is divided into ⌊√n⌋² cells; what is beyond them is left out.
struct point {
    glm::vec2 xi{0};
    bool is_there = true;
};
[[nodiscard]] inline point jittered(std::uint32_t i, std::uint32_t n, std::uint64_t key) {
    const auto side = static_cast<std::uint32_t>(std::sqrt(float(n)) + 1e-3f);
    const std::uint64_t h = lantern::hash(key, i);
    const glm::vec2 inside(lantern::to_unit(lantern::low(h)), lantern::to_unit(lantern::high(h)));
    if (i >= side * side) return {inside, false};
    return {(glm::vec2(i % side, i / side) + inside) / float(side), true};
}

// ---- scene 1: a lamp over a floor, behind the edge of a board -------------------------------------------------------

/// The lamp is the square of side 1 around (0, 0) at height 1; it shines down. The board stands at height 1/2, where x > 0.1.
/// What one point of the lamp, (-1/2 … 1/2)², brings to a point of the floor.
[[nodiscard]] inline double from_lamp(glm::dvec2 on_lamp, glm::dvec2 floor, bool both_cosines = true) {
    if ((on_lamp.x + floor.x) / 2 > 0.1) return 0;
    const glm::dvec2 aside = on_lamp - floor;
    const double d2 = glm::dot(aside, aside) + 1, cosine = 1 / std::sqrt(d2);
    return 2 * cosine * (both_cosines ? cosine : 1) / d2;
}

/// The exact value: 256 × 256 points, and in the strip of them that the board's edge crosses the part that is seen.
[[nodiscard]] inline float lamp_exactly(glm::vec2 floor) {
    constexpr int n = 256;
    const double last = 0.2 - double(floor.x);  // points of the lamp with a larger x are hidden
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        const double begin = double(i) / n - 0.5, end = std::min(begin + 1.0 / n, last);
        if (end <= begin) break;
        for (int j = 0; j < n; ++j) {
            const glm::dvec2 middle((begin + end) / 2, (j + 0.5) / n - 0.5), aside = middle - glm::dvec2(floor);
            const double d2 = glm::dot(aside, aside) + 1;
            sum += 2 / (d2 * d2) * (end - begin) / n;
        }
    }
    return float(sum);
}

// ---- scene 2: white stripes through a lens --------------------------------------------------------------------------

/// Half of the plane is white, in stripes 1 wide; a point of the lens moves what is seen by up to 0.3.
[[nodiscard]] inline float stripes(float x) { return x - 2 * std::floor(x / 2) < 1 ? 1.0f : 0.0f; }

/// The part of a disc of radius 0.3 around x that is white: circular segments.
[[nodiscard]] inline float lens_exactly(glm::vec2 floor) {
    const auto below = [](double t) {  // the part of the unit disc on this side of t
        t = std::clamp(t, -1.0, 1.0);
        return 0.5 + (t * std::sqrt(1 - t * t) + std::asin(t)) / std::numbers::pi;
    };
    double sum = 0;
    const double x = double(floor.x);
    for (int k = -4; k <= 4; ++k) sum += below((2 * k + 1 - x) / 0.3) - below((2 * k - x) / 0.3);
    return float(sum);
}

// ---- the renderers --------------------------------------------------------------------------------------------------

[[nodiscard]] inline bool through_the_lens(fault f) { return f == fault::dense_lens || f == fault::constant_seed; }

/// The value of a place on the floor, as it must be.
[[nodiscard]] inline float exactly(fault f, glm::vec2 floor) { return through_the_lens(f) ? lens_exactly(floor) : lamp_exactly(floor); }

/// One rendering of it with n samples.
[[nodiscard]] inline float rendered(fault f, glm::vec2 floor, std::uint32_t n, std::uint64_t seed) {
    const auto bits = [](float x) { return std::uint64_t(std::int64_t(x * 4096)); };
    const std::uint64_t key = lantern::hash(f == fault::constant_seed ? 1 : seed, bits(floor.x), bits(floor.y));
    double sum = 0, count = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
        const auto [xi, is_there] = jittered(i, n, key);
        if (f == fault::biased_jitter) ++count;
        if (!is_there) continue;
        if (f != fault::biased_jitter) ++count;
        if (through_the_lens(f)) {
            const float radius = f == fault::dense_lens ? xi.x : std::sqrt(xi.x), angle = 2 * std::numbers::pi_v<float> * xi.y;
            sum += stripes(floor.x + 0.3f * radius * std::cos(angle));
        } else {
            glm::dvec2 on_lamp = glm::dvec2(xi) - 0.5;
            if (f == fault::half_lamp) on_lamp /= 2.0;
            const double value = from_lamp(on_lamp, glm::dvec2(floor), f != fault::no_cosine);
            sum += f == fault::clamped ? std::min(value, 1.0) : value;
        }
    }
    return float(sum / count);
}

/// The place that a picture's point shows: film from (0, 0), top left, to (1, 1).
[[nodiscard]] inline glm::vec2 floor_at(glm::vec2 film) { return {3 * film.x - 1.5f, 1.5f * film.y - 0.75f}; }

/// The place whose renderings make the curve: where the mistake shows.
[[nodiscard]] inline glm::vec2 measured_place(fault f) {
    if (through_the_lens(f)) return {0.15f, 0};
    return f == fault::clamped ? glm::vec2(-0.2f, 0) : f == fault::half_lamp ? glm::vec2(0.4f, 0.1f) : glm::vec2(0.1f, 0.4f);
}

/// How many samples: no squares, all the same mistake for those that jitter.
inline constexpr std::array<std::uint32_t, 5> counts{6, 22, 88, 352, 1408};
inline constexpr std::uint32_t trials = 48;

}  // namespace patients
