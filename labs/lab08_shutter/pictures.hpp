// SPDX-License-Identifier: MIT
#pragma once
// Lab 08's pictures: the program shows them with the student's code, the handout with ours.

#include "scene.hpp"

#include <lab08_shutter/shutter.hpp>

#include <lantern/camera.hpp>
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
#include <utility>
#include <vector>

namespace pictures {

/// Step 2: the balls, without shadows and reflections.
inline lantern::image moving(glm::uvec2 size, std::uint32_t side) { return stage::taken(size, side, {.alone = true}); }

/// Step 3: the same, with the boxes of all balls.
inline lantern::image boxes(glm::uvec2 size, std::uint32_t side) {
    std::vector<std::pair<glm::vec3, glm::vec3>> all;
    for (const stage::ball& b : stage::balls()) all.push_back(lab08::bounds(b.shape, 0, 1));
    const auto on_edge = [&](const lantern::ray& r) {
        for (const auto& [lower, upper] : all)
            for (int axis = 0; axis < 3; ++axis)
                for (const float side_at : {lower[axis], upper[axis]}) {
                    const float t = (side_at - r.origin[axis]) / r.direction[axis];
                    const glm::vec3 p = at(r, t), inside = glm::min(p - lower, upper - p);
                    const float a = inside[(axis + 1) % 3], b = inside[(axis + 2) % 3];
                    if (t > 0 && a > -0.02f && b > -0.02f && std::min(a, b) < 0.02f) return true;
                }
        return false;
    };
    const stage::eye<> seen({.alone = true});
    return lantern::render(size, stage::camera(), lantern::multi_jittered{.side = side}, [&](const lantern::ray& r, const auto& source) {
        if (on_edge(r)) return glm::vec3(1, 0.85f, 0.2f);
        return seen({r.origin, r.direction, lab08::moment(0, 1, source.draw1(lantern::purpose::time))});
    });
}

/// Step 4: shadows, reflections, and what is seen through glass.
inline lantern::image whole(glm::uvec2 size, std::uint32_t side) { return stage::taken(size, side, {}); }

/// Step 5: lamps out of focus, one at rest, the others moving to the right, downwards and upwards. 8 x 8 points of the lens come row
/// by row. Above, the moments come in the same order; below, shuffled.
inline lantern::image lamps() {
    constexpr unsigned width = 720, height = 150;
    lantern::image page({width, 2 * height + 2}, glm::vec3(1));
    const std::array<glm::vec2, 4> starts{{{70, 75}, {180, 75}, {430, 40}, {600, 110}}}, ways{{{0, 0}, {120, 0}, {0, 70}, {0, -70}}};
    for (unsigned half = 0; half < 2; ++half) {
        lantern::in_parallel(height, 0, [&](std::size_t row) {
            for (unsigned x = 0; x < width; ++x) {
                const std::uint64_t key = lantern::hash(7, x, row);
                std::vector<std::uint32_t> order;
                std::vector<float> jitter;
                for (std::uint32_t i = 0; i < 64; ++i) {
                    order.push_back(half == 0 ? i : lantern::permute(i, 64, key));
                    jitter.push_back(lantern::to_unit(lantern::low(lantern::hash(key, i))));
                }
                const std::vector<float> moments = lab08::times(0, 1, order, jitter);
                float light = 0;
                for (std::uint32_t i = 0; i < 64; ++i) {
                    const std::uint64_t h = lantern::hash(key, i, 1);
                    const glm::vec2 cell(i % 8, i / 8), lens = lantern::to_disk((cell + glm::vec2(lantern::to_unit(lantern::low(h)), lantern::to_unit(lantern::high(h)))) / 8.0f);
                    for (std::size_t k = 0; k < starts.size(); ++k)
                        if (glm::length(starts[k] + moments[i] * ways[k] + 24.0f * lens - glm::vec2(x, row)) < 6) light += 8.0f / 64;
                }
                page(x, half * (height + 2) + unsigned(row)) = light * glm::vec3(1, 0.75f, 0.4f) + 0.015f;
            }
        });
    }
    return page;
}

/// Step 6: discs of three speeds. The upper half of each is the mean over 64 moments, the lower half the closed form.
inline lantern::image profiles() {
    constexpr unsigned width = 720, height = 62;
    lantern::image page({width, 3 * height}, glm::vec3(0.02f));
    const std::array<float, 3> ways{0, 150, 560};
    for (unsigned k = 0; k < 3; ++k)
        for (unsigned y = 0; y < height; ++y)
            for (unsigned x = 0; x < width; ++x) {
                const glm::vec2 p = glm::vec2(x, y) + 0.5f, center(60, float(height) / 2);
                float light = 0;
                if (p.y < center.y) {
                    const std::uint64_t key = lantern::hash(8, x, y);
                    for (std::uint32_t i = 0; i < 64; ++i) {
                        const float t = (float(i) + lantern::to_unit(lantern::low(lantern::hash(key, i)))) / 64;
                        light += glm::length(center + t * glm::vec2(ways[k], 0) - p) <= 25 ? 1 / 64.0f : 0;
                    }
                } else {
                    light = lab08::covered(p, center, {ways[k], 0}, 25, 0, 1);
                }
                page(x, k * height + y) += light * glm::vec3(1, 0.75f, 0.4f);
            }
    return page;
}

}  // namespace pictures
