// SPDX-License-Identifier: MIT
#pragma once
// Lab 13's pictures: the program shows them with the student's code, the handout with ours.

#include "../support/test_card.hpp"
#include "patients.hpp"

#include <lab13_error/error.hpp>

#include <lantern/hash.hpp>
#include <lantern/image.hpp>
#include <lantern/render.hpp>
#include <lantern/warp.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace pictures {

using glm::vec2;
using glm::vec3;

inline const vec3 paper(0.9f), ink(0.02f), blue(0.03f, 0.2f, 0.65f), red(0.7f, 0.05f, 0.03f), green(0.02f, 0.4f, 0.1f), grey(0.45f);

/// A part of a page with logarithmic axes: samples to the right, errors upwards. A line each power of ten.
class chart {
public:
    chart(lantern::image& page, glm::uvec2 corner, glm::uvec2 size, vec2 samples, vec2 errors)
        : page_(page), corner_(corner), size_(size), low_(std::log10(samples.x), std::log10(errors.x)),
          high_(std::log10(samples.y), std::log10(errors.y)) {
        for (unsigned y = 0; y < size.y; ++y)
            for (unsigned x = 0; x < size.x; ++x) page_(corner.x + x, corner.y + y) = paper;
        for (float k = std::ceil(low_.x); k <= high_.x; ++k) line({k, low_.y}, {k, high_.y}, 0.8f * paper);
        for (float k = std::ceil(low_.y); k <= high_.y; ++k) line({low_.x, k}, {high_.x, k}, 0.8f * paper);
    }
    void dot(double samples, double error, vec3 colour, int radius = 2) {
        if (!(error > 0)) return;
        const glm::ivec2 at = place({std::log10(samples), std::log10(error)});
        for (int y = -radius; y <= radius; ++y)
            for (int x = -radius; x <= radius; ++x) paint(at + glm::ivec2(x, y), colour);
    }
    void segment(double samples_a, double error_a, double samples_b, double error_b, vec3 colour) {
        if (!(error_a > 0 && error_b > 0)) return;
        line({std::log10(samples_a), std::log10(error_a)}, {std::log10(samples_b), std::log10(error_b)}, colour);
    }

private:
    [[nodiscard]] glm::ivec2 place(vec2 p) const {
        const vec2 part = (p - low_) / (high_ - low_);
        return {int(part.x * float(size_.x - 1)), int((1 - part.y) * float(size_.y - 1))};
    }
    void line(vec2 a, vec2 b, vec3 colour) {
        const glm::ivec2 p = place(a), q = place(b);
        const int steps = std::max({std::abs(q.x - p.x), std::abs(q.y - p.y), 1});
        for (int k = 0; k <= steps; ++k) paint(p + (q - p) * k / steps, colour);
    }
    void paint(glm::ivec2 at, vec3 colour) {
        if (at.x >= 0 && at.y >= 0 && at.x < int(size_.x) && at.y < int(size_.y))
            page_(corner_.x + unsigned(at.x), corner_.y + unsigned(at.y)) = colour;
    }
    lantern::image& page_;
    glm::uvec2 corner_, size_;
    vec2 low_, high_;
};

// ---- steps 1 to 4: how fast ------------------------------------------------------------------------------------------

/// How much of a pixel lies on one side of an edge: .390983, by random samples and by jittered ones.
[[nodiscard]] inline float edge(std::uint32_t n, std::uint64_t seed, bool jitter) {
    float sum = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint64_t h = lantern::hash(seed, n, i);
        vec2 xi(lantern::to_unit(lantern::low(h)), lantern::to_unit(lantern::high(h)));
        if (jitter) xi = patients::jittered(i, n, seed).xi;
        sum += xi.x + 0.6180339887f * xi.y < 0.7f ? 1.0f : 0.0f;
    }
    return sum / float(n);
}

/// RMSE against samples: random samples red, jittered ones blue, with the fitted lines.
inline lantern::image slopes() {
    lantern::image page({480, 320}, paper);
    chart plot(page, {10, 10}, {460, 300}, {3, 6000}, {3e-4f, 0.5f});
    const std::array<std::uint32_t, 6> counts{4, 16, 64, 256, 1024, 4096};
    for (const bool jitter : {false, true}) {
        std::vector<double> errors;
        for (const std::uint32_t n : counts) {
            std::vector<float> estimates;
            for (std::uint64_t seed = 0; seed < 64; ++seed) estimates.push_back(edge(n, seed, jitter));
            errors.push_back(lab13::rmse(estimates, 0.390983f));
            plot.dot(n, errors.back(), jitter ? blue : red);
        }
        const double e = lab13::slope(counts, errors);
        double mean = 0;
        for (std::size_t k = 0; k < counts.size(); ++k) mean += std::log(errors[k]) - e * std::log(counts[k]);
        const double c = std::exp(mean / double(counts.size()));
        plot.segment(4, c * std::pow(4, e), 4096, c * std::pow(4096, e), jitter ? blue : red);
        std::cout << (jitter ? "jittered" : "random") << " samples at an edge: slope " << e << ", half the error costs "
                  << lab13::time_factor(e, 0.5) << " times the time\n";
    }
    return page;
}

// ---- step 5: grids ---------------------------------------------------------------------------------------------------

/// Jittered samples in the student's grids: 16, 12, 10 and 7 cells.
inline lantern::image grids() {
    constexpr unsigned side = 150;
    lantern::image page({4 * side + 50, side + 20}, paper);
    unsigned left = 10;
    for (const std::uint32_t count : {16u, 12u, 10u, 7u}) {
        const glm::uvec2 grid = lab13::cells(count);
        for (unsigned y = 0; y < side; ++y)
            for (unsigned x = 0; x < side; ++x) {
                const vec2 p = vec2(x, y) / float(side) * vec2(grid);
                const vec2 q = vec2(x + 1, y + 1) / float(side) * vec2(grid);
                const bool border = x == 0 || y == 0 || x + 1 == side || y + 1 == side || glm::floor(p) != glm::floor(q);
                page(left + x, 10 + y) = border ? grey : vec3(1);
            }
        for (std::uint32_t i = 0; i < grid.x * grid.y && grid.x > 0; ++i) {
            const std::uint64_t h = lantern::hash(count, i);
            const vec2 xi = (vec2(i % grid.x, i / grid.x) + vec2(lantern::to_unit(lantern::low(h)), lantern::to_unit(lantern::high(h)))) / vec2(grid);
            const glm::ivec2 at(xi * float(side - 4));
            for (int y = 0; y < 4; ++y)
                for (int x = 0; x < 4; ++x) page(left + unsigned(at.x + x), 10 + unsigned(at.y + y)) = red;
        }
        left += side + 10;
    }
    return page;
}

// ---- step 6: swirls --------------------------------------------------------------------------------------------------

/// Balls in front of the plane of focus and behind it, which shine; the lens and the pixel have the same 64 strata. `order` says
/// which stratum of a purpose a sample takes.
inline lantern::image defocused(glm::uvec2 size, const std::function<std::uint32_t(std::uint32_t i, std::uint32_t purpose, glm::uvec2 pixel)>& order) {
    constexpr std::uint32_t side = 6, n = side * side;
    lantern::image page(size);
    lantern::in_parallel(size.y, 0, [&](std::size_t row) {
        for (unsigned x = 0; x < size.x; ++x) {
            const glm::uvec2 pixel(x, unsigned(row));
            vec3 sum(0);
            for (std::uint32_t i = 0; i < n; ++i) {
                const auto drawn = [&](std::uint32_t purpose) {
                    const std::uint32_t cell = order(i, purpose, pixel) % n;
                    const std::uint64_t h = lantern::hash(pixel.x, pixel.y, i, purpose + 10);
                    return (vec2(cell % side, cell / side) + vec2(lantern::to_unit(lantern::low(h)), lantern::to_unit(lantern::high(h)))) / float(side);
                };
                const vec2 lens = lantern::to_disk(drawn(0));
                const vec2 lamp = lantern::to_disk(drawn(1));
                // A floor, seen through the lens, lit by a round lamp: both blur the same edges of a grating between them.
                const vec2 at = vec2(pixel) / float(size.y) * 3.0f + 0.28f * lens;
                const vec2 towards = at + 0.28f * lamp;
                const vec2 cell = glm::fract(towards) - 0.5f;
                sum += glm::dot(cell, cell) < 0.09f ? vec3(1.3f, 1.1f, 0.8f) : vec3(0.03f, 0.05f, 0.1f);
            }
            page(x, unsigned(row)) = sum / float(n);
        }
    });
    return page;
}

/// Left: lens and lamp take the same strata in the same order. Right: as the student says.
inline lantern::image swirls(glm::uvec2 half) {
    constexpr std::uint32_t n = 36;
    const lantern::image wrong = defocused(half, [](std::uint32_t i, std::uint32_t, glm::uvec2) { return i; });
    const lantern::image right = defocused(half, [](std::uint32_t i, std::uint32_t purpose, glm::uvec2 pixel) { return lab13::stratum(i, n, purpose, pixel); });
    lantern::image page({2 * half.x + 4, half.y}, vec3(1));
    for (unsigned y = 0; y < half.y; ++y) {
        std::ranges::copy(wrong.row(y), page.row(y).begin());
        std::ranges::copy(right.row(y), page.row(y).begin() + half.x + 4);
    }
    return page;
}

// ---- steps 7 and 8: the patients --------------------------------------------------------------------------------------

/// A row a patient: its number, the curve of one place (RMSE red, |mean error| grey), what it should look like, two of its renderings with
/// different seeds, and their mean error (red: too bright, blue: too dark). A table of the figures is printed.
inline lantern::image ward() {
    constexpr glm::uvec2 cell(150, 75);
    constexpr unsigned gap = 6, number = 34;
    constexpr std::uint32_t shown = 22;
    lantern::image page({number + 5 * (cell.x + gap), 6 * (cell.y + gap)}, paper);
    std::string table = "patient  samples      RMSE  mean error          z\n";
    for (unsigned k = 0; k < 6; ++k) {
        const patients::fault f = patients::patient[k];
        const unsigned top = k * (cell.y + gap);
        for (unsigned y = 0; y < 44; ++y)
            for (unsigned x = 0; x < 22; ++x)
                if (support::on_digit(vec2(x, y) / 22.0f, int(k) + 1)) page(6 + x, top + 15 + y) = ink;

        chart plot(page, {number, top}, cell, {4, 2200}, {1e-4f, 1});
        const vec2 place = patients::measured_place(f);
        const float exact = patients::exactly(f, place);
        std::vector<std::vector<float>> all;
        for (const std::uint32_t n : patients::counts) {
            std::vector<float> estimates;
            for (std::uint64_t seed = 0; seed < patients::trials; ++seed) estimates.push_back(patients::rendered(f, place, n, seed));
            const double error = lab13::rmse(estimates, exact);
            const auto [mean, z] = lab13::bias_of(estimates, exact);
            plot.dot(n, std::abs(mean), grey, 1);
            plot.dot(n, error, red);
            char line[80];
            std::snprintf(line, sizeof line, "%7u%9u%10.5f%+12.5f%11.4g\n", k + 1, n, error, mean, z);
            table += line;
            all.push_back(std::move(estimates));
        }
        static constexpr const char* found[]{"sound", "repeats", "biased", "slow"};
        table += std::string("         your step 7 finds: ") + found[std::size_t(lab13::diagnose(patients::counts, all, exact, -0.75)) % 4] + '\n';

        lantern::in_parallel(cell.y, 0, [&](std::size_t row) {
            for (unsigned x = 0; x < cell.x; ++x) {
                const vec2 floor = patients::floor_at((vec2(x, row) + 0.5f) / vec2(cell));
                const unsigned left = number + cell.x + gap, y = top + unsigned(row);
                const float right = patients::exactly(f, floor), exposure = patients::through_the_lens(f) ? 1 : 0.5f;
                float mean = 0;
                for (std::uint64_t seed = 0; seed < 8; ++seed) {
                    const float value = patients::rendered(f, floor, shown, seed);
                    mean += (value - right) / 8;
                    if (seed < 2) page(left + unsigned(seed + 1) * (cell.x + gap) + x, y) = vec3(exposure * value);
                }
                page(left + x, y) = vec3(exposure * right);
                const float off = std::min(4 * std::abs(mean), 1.0f);
                page(left + 3 * (cell.x + gap) + x, y) = mean > 0 ? vec3(1, 1 - off, 1 - off) : vec3(1 - off, 1 - off, 1);
            }
        });
    }
    std::cout << table;  // when all of it is there: a step may be missing
    return page;
}

}  // namespace pictures
