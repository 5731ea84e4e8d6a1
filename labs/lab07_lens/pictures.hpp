// SPDX-License-Identifier: MIT
#pragma once
// Lab 07's pictures: the program shows them with the student's code, the handout with ours.

#include "../support/pixels.hpp"
#include "scene.hpp"

#include <lab07_lens/lens.hpp>

#include <lantern/image.hpp>
#include <lantern/render.hpp>
#include <lantern/samples.hpp>

#include <glm/geometric.hpp>

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace pictures {

/// Draws dots into a square of `side` pixels that shows -1.15 to 1.15.
inline void dots(lantern::image& page, unsigned left, unsigned side, const std::vector<glm::vec2>& points, glm::vec3 color) {
    for (const glm::vec2 p : points)
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                const glm::vec2 at = float(side) * (0.5f + glm::vec2(p.x, -p.y) / 2.3f) + glm::vec2(dx, dy);
                if (at.x >= 0 && at.y >= 0 && at.x < float(side) && at.y < float(side)) page(left + unsigned(at.x), unsigned(at.y)) = color;
            }
}

inline std::vector<glm::vec2> placed(std::uint32_t side, const std::function<glm::vec2(glm::vec2)>& place) {
    const lantern::jittered sampler{.side = side};
    std::vector<glm::vec2> points;
    for (std::uint32_t i = 0; i < sampler.count(); ++i) points.push_back(place(sampler.at({1, 1}, i).draw2(lantern::purpose::lens)));
    return points;
}

/// Step 1: 24 x 24 jittered points on the lens.
inline lantern::image lens() {
    lantern::image page({300, 300}, glm::vec3(1));
    dots(page, 0, 300, placed(24, [](glm::vec2 xi) { return lab07::on_lens(xi, 1); }), {0.1f, 0.2f, 0.6f});
    return page;
}

/// How a picture is taken: which ray goes through a point of the film, for a point of the unit square.
using shot = std::function<lantern::ray(const garden::stand&, glm::vec2 film, glm::vec2 xi)>;

constexpr float half_height = 0.26f;  // of the film, at distance 1

/// What is taken: side × side samples a pixel.
struct photograph {
    glm::uvec2 size{0};
    std::uint32_t side = 1;
    shot through{};
    std::vector<garden::ball> balls = garden::balls();
    garden::stand camera{};
};

inline glm::vec3 sample(const photograph& p, const lantern::multi_jittered& sampler, glm::uvec2 pixel, std::uint32_t i) {
    const float half_width = half_height * float(p.size.x) / float(p.size.y);
    const auto source = sampler.at(pixel, i);
    const glm::vec2 at = (glm::vec2(pixel) + source.draw2(lantern::purpose::film)) / glm::vec2(p.size);
    const glm::vec2 film{(2 * at.x - 1) * half_width, (1 - 2 * at.y) * half_height};
    return garden::radiance(p.balls, p.through(p.camera, film, source.draw2(lantern::purpose::lens)));
}

inline glm::vec3 pixel(const photograph& p, glm::uvec2 at) {
    const lantern::multi_jittered sampler{.side = p.side};
    return support::mean_of(sampler.count(), [&](std::uint32_t i) { return sample(p, sampler, at, i); });
}

inline lantern::image taken(const photograph& p) {
    return support::picture_of(p.size, [&](glm::uvec2 at) { return pixel(p, at); });
}

/// The depth of ball i of the five.
inline float depth_of(std::size_t i) { return garden::stand{}.depth(garden::balls()[i].shape.center); }

/// Step 3: focused on one of the balls.
inline photograph focused(glm::uvec2 size, std::uint32_t side, float radius, float focus) {
    return {size, side, [=](const garden::stand& c, glm::vec2 film, glm::vec2 xi) { return lab07::through_lens(c.eye, c.axes, film, radius, focus, xi); }};
}

/// Steps 4 and 5: a point of light at nine depths. Above, discs of the diameter that the formula gives; below, the points
/// themselves, seen through the lens. A green line marks the depths that are sharp to within a pixel.
inline lantern::image discs() {
    constexpr float radius = 0.3f, focus = 4, per_pixel = 1 / 460.0f;  // of the film
    const float depths[]{2, 2.5f, 3, 3.5f, 4, 5, 7, 12, std::numeric_limits<float>::infinity()};
    constexpr unsigned cell = 80;
    lantern::image page({9 * cell, 2 * cell + 12}, glm::vec3(0.02f));
    const auto [nearest, farthest] = lab07::depth_of_field(radius, focus, 24 * per_pixel);
    const lantern::jittered sampler{.side = 60};
    for (unsigned i = 0; i < 9; ++i) {
        const float wanted = lab07::circle_of_confusion(radius, focus, depths[i]) / per_pixel;
        for (unsigned y = 0; y < cell; ++y)
            for (unsigned x = 0; x < cell; ++x)
                if (glm::length(glm::vec2(x, y) + 0.5f - 0.5f * float(cell)) <= std::max(wanted / 2, 1.0f)) page(i * cell + x, y) = {0.9f, 0.6f, 0.2f};
        for (std::uint32_t k = 0; k < sampler.count(); ++k) {
            // From the middle of the plane of focus, back through the lens: where on the film the light of the point arrives.
            const lantern::ray r = lab07::through_lens({0, 0, 0}, glm::mat3(1), {0, 0}, radius, focus, sampler.at({i, 0}, k).draw2(lantern::purpose::lens));
            const glm::vec2 slope = glm::vec2(r.direction) / r.direction.z, lens(r.origin);
            const glm::vec2 film = -(std::isinf(depths[i]) ? slope : lens / depths[i] + slope) / per_pixel;
            const glm::vec2 at = film + 0.5f * float(cell);
            if (at.x >= 0 && at.y >= 0 && at.x < float(cell) && at.y < float(cell))
                page(i * cell + unsigned(at.x), cell + 6 + unsigned(at.y)) = {0.3f, 0.55f, 0.9f};
        }
        if (depths[i] >= nearest && depths[i] <= farthest)
            for (unsigned x = 0; x < cell; ++x) page(i * cell + x, 2 * cell + 9) = page(i * cell + x, 2 * cell + 8) = {0.2f, 0.8f, 0.2f};
    }
    return page;
}

/// Step 6: 1, 4 and 64 samples a pixel; and 64 whose lens points are the same in every pixel.
inline lantern::image samples() {
    constexpr unsigned cell = 180;
    lantern::image page({4 * (cell + 1) - 1, cell}, glm::vec3(1));
    const garden::stand camera;
    const std::vector<garden::ball> balls = garden::balls();
    const auto radiance = [&](const lantern::ray& r) { return garden::radiance(balls, r); };
    for (unsigned panel = 0; panel < 4; ++panel) {
        const lantern::jittered sampler{.side = panel == 0 ? 1u : panel == 1 ? 2u : panel == 2 ? 8u : 4u};
        lantern::in_parallel(cell, 0, [&](std::size_t row) {
            for (unsigned x = 0; x < cell; ++x) {
                std::vector<glm::vec2> film, lens;
                for (std::uint32_t i = 0; i < sampler.count(); ++i) {
                    const auto source = sampler.at({x, unsigned(row)}, i);
                    const glm::vec2 p = (glm::vec2(x, row) + source.draw2(lantern::purpose::film)) / float(cell);
                    film.push_back({(2 * p.x - 1) * 0.19f - 0.13f, (1 - 2 * p.y) * 0.19f});
                    lens.push_back((panel < 3 ? source : sampler.at({0, 0}, i)).draw2(lantern::purpose::lens));
                }
                page(panel * (cell + 1) + x, unsigned(row)) = lab07::pixel(camera.eye, camera.axes, 0.12f, depth_of(0), film, lens, radiance);
            }
        });
    }
    return page;
}

/// Step 7: six blades.
inline photograph blades(glm::uvec2 size, std::uint32_t side, int count) {
    return {size, side, [=](const garden::stand& c, glm::vec2 film, glm::vec2 xi) {
        const glm::vec2 l = lab07::on_blades(xi, 0.12f, count);
        const glm::vec3 offset = l.x * c.axes[0] + l.y * c.axes[1];
        return lantern::ray{c.eye + offset, glm::normalize(c.axes * glm::vec3(film, 1) - offset / depth_of(0))};
    }};
}

}  // namespace pictures
