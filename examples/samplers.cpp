// SPDX-License-Identifier: MIT
// Points in the unit square as pictures: a column for each sampler, a row for each number of samples.
//     samplers [PATH.png] [SEED]

#include <lantern/halton.hpp>
#include <lantern/image.hpp>
#include <lantern/samples.hpp>
#include <lantern/sobol.hpp>

#include "picture.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <array>

namespace {

constexpr std::uint32_t square = 176, margin = 16;
constexpr std::array sides{4u, 8u, 16u};

/// Darkens the pixels that a dot covers; its rim is as soft as a pixel is wide.
void dot(lantern::image& sheet, glm::vec2 at, float radius) {
    const glm::ivec2 low(glm::floor(at - radius - 1.0f)), high(glm::ceil(at + radius + 1.0f));
    for (int y = low.y; y <= high.y; ++y) {
        for (int x = low.x; x <= high.x; ++x) {
            const float covered = glm::clamp(radius + 0.5f - glm::length(glm::vec2(x, y) + 0.5f - at), 0.0f, 1.0f);
            glm::vec3& pixel = sheet(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
            pixel = glm::mix(pixel, glm::vec3(0.05f, 0.1f, 0.3f), covered);
        }
    }
}

/// One set of points on white, over a grid of side × side cells.
template <lantern::sampler Sampler>
void draw(lantern::image& sheet, glm::uvec2 corner, std::uint32_t side, const Sampler& sampler) {
    for (std::uint32_t y = 0; y <= square; ++y) {
        for (std::uint32_t x = 0; x <= square; ++x) {
            const bool on_line = x * side % square < side || y * side % square < side;
            sheet(corner.x + x, corner.y + y) = glm::vec3(on_line && side < 16 ? 0.8f : 1.0f);
        }
    }
    for (std::uint32_t i = 0; i < sampler.count(); ++i) {
        const glm::vec2 p = sampler.at({0, 0}, i).draw2(lantern::purpose::film);
        dot(sheet, glm::vec2(corner) + p * static_cast<float>(square), side < 16 ? 2.5f : 1.6f);
    }
}

}  // namespace

int main(int argc, char** argv) {
    return picture::main(argc, argv, "samplers", 1, [](const std::string& path, std::uint32_t seed) {
        constexpr std::uint32_t step = square + margin;
        lantern::image sheet({7 * step + margin, 3 * step + margin}, glm::vec3(0.55f));
        for (std::uint32_t row = 0; row < sides.size(); ++row) {
            const std::uint32_t side = sides[row], n = side * side;
            std::uint32_t column = 0;
            const auto next = [&](const auto& sampler) {
                draw(sheet, {margin + column * step, margin + row * step}, side, sampler);
                ++column;
            };
            next(lantern::independent{.samples = n, .seed = seed});
            next(lantern::n_rooks{.samples = n, .seed = seed});
            next(lantern::jittered{.side = side, .seed = seed});
            next(lantern::multi_jittered{.side = side, .seed = seed});
            next(lantern::correlated_multi_jittered{.samples = n, .seed = seed});
            next(lantern::halton{.samples = n, .seed = seed});
            next(lantern::sobol{.samples = n, .seed = seed});
        }
        picture::write(path, sheet);
        std::printf(
            "columns: independent, N-rooks, jittered, multi-jittered, correlated multi-jittered, Halton, Sobol\n"
            "rows: 16, 64 and 256 samples\n");
    });
}
