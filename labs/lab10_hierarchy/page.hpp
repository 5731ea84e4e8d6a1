// SPDX-License-Identifier: MIT
#pragma once
// How lab 10's pictures are put together: tables of pictures, numbers, frames around boxes, the heat scale, a plot.

#include "../support/test_card.hpp"

#include <lantern/aabb.hpp>
#include <lantern/image.hpp>
#include <lantern/ray.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pictures {

inline void paste(lantern::image& page, glm::uvec2 corner, const lantern::image& part) {
    for (unsigned y = 0; y < part.size().y; ++y) std::ranges::copy(part.row(y), page.row(corner.y + y).begin() + corner.x);
}

/// Pictures of the same size, so many in a row.
inline lantern::image table(const std::vector<lantern::image>& parts, unsigned columns) {
    const glm::uvec2 size = parts.front().size(), rows{columns, (unsigned(parts.size()) + columns - 1) / columns};
    lantern::image page((size + 2u) * rows - 2u, glm::vec3(1));
    for (unsigned i = 0; i < parts.size(); ++i) paste(page, (size + 2u) * glm::uvec2(i % columns, i / columns), parts[i]);
    return page;
}

/// A whole number, its top left corner at `at`, with digits so many pixels wide.
inline void write_number(lantern::image& page, glm::vec2 at, unsigned number, float width, glm::vec3 color) {
    for (const char digit : std::to_string(number)) {
        for (unsigned y = unsigned(at.y); y < std::min(unsigned(at.y + 2 * width + 1), page.size().y); ++y)
            for (unsigned x = unsigned(at.x); x < std::min(unsigned(at.x + width + 1), page.size().x); ++x)
                if (support::on_digit((glm::vec2(x, y) + 0.5f - at) / width, digit - '0')) page(x, y) = color;
        at.x += 1.5f * width;
    }
}

/// A colour for group number i, unlike that of its neighbours.
inline glm::vec3 color_of(std::size_t i) {
    static constexpr std::array<glm::vec3, 12> colors{{{0.75f, 0.1f, 0.08f}, {0.08f, 0.3f, 0.75f}, {0.85f, 0.55f, 0.05f}, {0.1f, 0.5f, 0.15f},
        {0.5f, 0.12f, 0.6f}, {0.05f, 0.55f, 0.6f}, {0.8f, 0.3f, 0.4f}, {0.35f, 0.38f, 0.1f}, {0.3f, 0.5f, 0.85f}, {0.55f, 0.28f, 0.1f},
        {0.6f, 0.7f, 0.25f}, {0.25f, 0.2f, 0.45f}}};
    return colors[i % colors.size()];
}

/// A box of which only the edges are drawn.
struct frame {
    lantern::aabb box;
    glm::vec3 color{1, 0.85f, 0.2f};
};

/// The colour of the nearest edge before t; nothing where there is none.
inline std::optional<glm::vec3> on_edge(const std::vector<frame>& frames, const lantern::ray& r, float t, float width = 0.008f) {
    std::optional<glm::vec3> color;
    for (const frame& f : frames)
        for (int axis = 0; axis < 3; ++axis)
            for (const float side : {f.box.min[axis], f.box.max[axis]}) {
                const float there = (side - r.origin[axis]) / r.direction[axis];
                const glm::vec3 p = at(r, there), inside = glm::min(p - f.box.min, f.box.max - p);
                const float a = inside[(axis + 1) % 3], b = inside[(axis + 2) % 3];
                if (there > 0 && there < t && a > -width && b > -width && std::min(a, b) < width) t = there, color = f.color;
            }
    return color;
}

/// A colour for the number of questions a ray asks: each ten times as many is a step further, from 1 (black) to 1000 (white).
inline glm::vec3 heat(float asked) {
    static constexpr std::array<glm::vec3, 7> colors{{{0, 0, 0}, {0.02f, 0.02f, 0.25f}, {0.25f, 0.02f, 0.4f}, {0.65f, 0.05f, 0.15f},
                                                      {0.9f, 0.35f, 0.02f}, {1, 0.8f, 0.15f}, {1, 1, 1}}};
    const float at = glm::clamp(std::log10(std::max(asked, 1.0f)) / 3, 0.0f, 1.0f) * 6;
    const auto i = std::min(std::size_t(at), std::size_t(5));
    return glm::mix(colors[i], colors[i + 1], at - float(i));
}

/// What the colours mean: 1, 10, 100, 1000.
inline lantern::image scale(unsigned width) {
    lantern::image page({width, 36}, glm::vec3(1));
    for (unsigned x = 20; x + 40 < width; ++x)
        for (unsigned y = 2; y < 16; ++y) page(x, y) = heat(std::pow(10.0f, 3 * float(x - 20) / float(width - 60)));
    for (unsigned i = 0, number = 1; i < 4; ++i, number *= 10)
        write_number(page, {20 + float(i * (width - 60)) / 3 - 4 - (i > 0 ? 6 * float(i - 1) : 0), 20}, number, 6, glm::vec3(0));
    return page;
}

/// A page, and the scale below it.
inline lantern::image with_scale(const lantern::image& page) {
    lantern::image whole(page.size() + glm::uvec2(0, 36), glm::vec3(1));
    paste(whole, {0, 0}, page);
    paste(whole, {0, page.size().y}, scale(page.size().x));
    return whole;
}

/// A line in a plot: its points are joined.
struct curve {
    glm::vec3 color;
    std::vector<glm::vec2> points;
};

/// Both axes are logarithmic: to the right 1 to 100000 balls, upwards 1 to 1000 questions.
inline lantern::image plot(const std::vector<curve>& curves) {
    constexpr unsigned width = 640, height = 400, left = 60, right = 30, bottom = 40, top = 16;
    lantern::image page({width, height}, glm::vec3(1));
    const auto place = [&](glm::vec2 p) {
        const glm::vec2 part = glm::vec2(std::log10(p.x) / 5, std::log10(p.y) / 3);
        return glm::vec2(left + part.x * float(width - left - right), float(height - bottom) - part.y * float(height - bottom - top));
    };
    const auto dot = [&](glm::vec2 p, float radius, glm::vec3 color) {
        for (int y = int(p.y - radius) - 1; y <= int(p.y + radius) + 1; ++y)
            for (int x = int(p.x - radius) - 1; x <= int(p.x + radius) + 1; ++x) {
                if (x < 0 || y < int(top) || x >= int(width) || y >= int(height)) continue;
                const float inside = glm::clamp(radius + 0.5f - glm::length(glm::vec2(x, y) + 0.5f - p), 0.0f, 1.0f);
                page(unsigned(x), unsigned(y)) = glm::mix(page(unsigned(x), unsigned(y)), color, inside);
            }
    };
    for (unsigned i = 0, number = 1; i <= 5; ++i, number *= 10) {
        const glm::vec2 x = place({float(number), 1}), y = place({1, float(number)});
        for (unsigned k = top; k < height - bottom; ++k) page(unsigned(x.x), k) = glm::vec3(0.75f);
        write_number(page, {x.x - 4 - 4.5f * float(i), float(height - bottom) + 10}, number, 6, glm::vec3(0));
        if (i > 3) continue;
        for (unsigned k = left; k < width - right; ++k) page(k, unsigned(y.y)) = glm::vec3(0.75f);
        write_number(page, {float(left) - 14 - 9 * float(i), y.y - 6}, number, 6, glm::vec3(0));
    }
    for (const curve& c : curves)
        for (std::size_t i = 0; i < c.points.size(); ++i) {
            const glm::vec2 to = place(c.points[i]), from = i > 0 ? place(c.points[i - 1]) : to;
            for (float k = 0; k <= 1; k += 0.002f) dot(glm::mix(from, to, k), 1, c.color);
            dot(to, 4, c.color);
        }
    return page;
}

}  // namespace pictures
