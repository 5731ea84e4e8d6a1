// SPDX-License-Identifier: MIT
// Lab 04: a zone plate, whose rings grow finer and finer, with one sample a pixel and with sixteen; and the point sets.

#include "../support/gaps.hpp"

#include <lab04_sampling/sampling.hpp>

#include <lantern/hash.hpp>
#include <lantern/image.hpp>
#include <lantern/ppm.hpp>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <vector>

namespace {

constexpr std::uint32_t side = 320;  // of a panel, in pixels

support::gaps gaps;

float random(std::uint64_t a, std::uint64_t b, std::uint64_t c) { return lantern::to_unit(lantern::low(lantern::hash(a, b, c))); }

/// Rings around the lower left corner; at the upper right one they are narrower than a pixel.
float zone_plate(glm::vec2 pixels) {
    const glm::vec2 p(pixels.x, float(side) - pixels.y);
    return 0.5f + 0.5f * std::cos(glm::dot(p, p) * 0.75f * 3.14159265f / float(side));
}

/// Fills a panel of the picture; or, while a step is missing, with the test card.
template <class Color>
void panel(lantern::image& picture, std::uint32_t left, const Color& color) {
    try {
        for (std::uint32_t y = 0; y < side; ++y)
            for (std::uint32_t x = 0; x < side; ++x) picture(left + x, y) = color(x, y);
    } catch (const lantern::unfinished& gap) {
        gaps.note(gap);
        support::paint_test_card(picture, {left, 0}, glm::uvec2(side), support::step_number(gap.what()));
    }
}

/// Sixteen jittered samples over the 2 × 2 pixels around the pixel's middle, each counted by the tent.
glm::vec3 smooth(std::uint32_t x, std::uint32_t y) {
    std::vector<glm::vec3> colors;
    std::vector<float> weights;
    for (std::uint32_t i = 0; i < 16; ++i) {
        const std::uint64_t pixel = y * side + x;
        const glm::vec2 point = lab04::jittered(i, 4, {random(pixel, i, 0), random(pixel, i, 1)});
        const glm::vec2 offset = 2.0f * point - 1.0f;
        colors.emplace_back(zone_plate(glm::vec2(x, y) + 0.5f + offset));
        weights.push_back(lab04::tent(offset, 1));
    }
    return lab04::filtered(colors, weights);
}

/// Points as dots in a panel; the test card if `where` is unfinished.
template <class Where>
void dots(lantern::image& picture, std::uint32_t left, Where where) {
    std::vector<glm::vec2> points;
    try {
        points = where();
    } catch (const lantern::unfinished& gap) {
        gaps.note(gap);
        return support::paint_test_card(picture, {left, 0}, glm::uvec2(side), support::step_number(gap.what()));
    }
    panel(picture, left, [&](std::uint32_t x, std::uint32_t y) {
        if (x < 4 || y < 4 || x >= side - 4 || y >= side - 4) return glm::vec3(0.6f);
        const glm::vec2 at = (glm::vec2(x, side - 1 - y) - 9.5f) / float(side - 20);
        for (const glm::vec2 p : points)
            if (glm::length(p - at) < 0.011f) return glm::vec3(0.02f, 0.1f, 0.35f);
        return glm::vec3(1);
    });
}

std::vector<glm::vec2> random_points(std::uint32_t n) {
    std::vector<glm::vec2> result;
    for (std::uint32_t i = 0; i < n; ++i) result.push_back({random(1, i, 0), random(1, i, 1)});
    return result;
}

std::vector<float> random_numbers(std::uint32_t n) {
    std::vector<float> result;
    for (std::uint32_t i = 0; i < n; ++i) result.push_back(random(2, i, 0));
    return result;
}

void save(const std::filesystem::path& path, const lantern::image& picture) {
    lantern::write_ppm(path, picture);
    std::cout << path.string() << '\n';
}

}  // namespace

int main(int argc, char** argv) try {
    const std::filesystem::path folder = argc > 1 ? argv[1] : "out";

    lantern::image plates({2 * side, side});
    panel(plates, 0, [](std::uint32_t x, std::uint32_t y) { return glm::vec3(zone_plate(glm::vec2(x, y) + 0.5f)); });
    panel(plates, side, smooth);
    save(folder / "lab04.ppm", plates);

    lantern::image sets({5 * side, side});
    dots(sets, 0, [] { return random_points(64); });
    dots(sets, side, [] {
        auto p = random_points(64);
        for (std::uint32_t i = 0; i < 64; ++i) p[i] = lab04::jittered(i, 8, p[i]);
        return p;
    });
    dots(sets, 2 * side, [] { return lab04::n_rooks(lab04::shuffled(64, random_numbers(64)), random_points(64)); });
    dots(sets, 3 * side, [] { return lab04::multi_jittered(8, random_points(64), random_numbers(128)); });
    dots(sets, 4 * side, [] {
        auto p = lab04::multi_jittered(8, random_points(64), random_numbers(128));
        for (glm::vec2& q : p) q = 0.5f + 0.5f * lab04::to_disk(q);
        return p;
    });
    save(folder / "lab04_points.ppm", sets);

    gaps.tell();
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
