// SPDX-License-Identifier: MIT
#pragma once
// Lab 06's pictures, one for each step: the program shows them with the student's code, the handout with ours.

#include "scene.hpp"

#include <lab06_glossy/glossy.hpp>

#include <lantern/image.hpp>
#include <lantern/samples.hpp>

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace pictures {

/// Step 1: the ball of all directions, seen from in front and from behind, in the colours of U.
inline lantern::image axes() {
    lantern::image result({480, 240}, glm::vec3(0.02f));
    for (unsigned y = 0; y < 240; ++y)
        for (unsigned x = 0; x < 480; ++x) {
            const glm::vec2 p = (glm::vec2(x % 240, y) - 119.5f) / 110.0f;
            if (glm::dot(p, p) >= 1) continue;
            const float z = std::sqrt(1 - glm::dot(p, p)) * (x < 240 ? 1.0f : -1.0f);
            result(x, y) = 0.5f + 0.5f * lab06::basis({p.x, -p.y, z})[0];
        }
    return result;
}

/// Step 2: where 16 x 16 perturbed rays meet the plane perpendicular to r, for three r; the frame has the side a.
inline lantern::image square() {
    lantern::image result({720, 240}, glm::vec3(1));
    const std::array<glm::vec3, 3> rays{{{0, 1, 0}, {1, 2, 3}, {-9, 4, 0.5f}}};
    for (unsigned panel = 0; panel < 3; ++panel) {
        const auto dot = [&](glm::vec2 p, glm::vec3 color, int radius) {  // p in the square from -1 to 1
            for (int dy = -radius; dy <= radius; ++dy)
                for (int dx = -radius; dx <= radius; ++dx) {
                    const glm::vec2 at = 120.0f + 70.0f * p + glm::vec2(dx, dy);
                    if (at.x >= 0 && at.y >= 0 && at.x < 240 && at.y < 240) result(240 * panel + unsigned(at.x), unsigned(at.y)) = color;
                }
        };
        const glm::vec3 r = rays[panel], w = glm::normalize(r);
        const glm::mat3 b = lab06::basis(r);
        for (int i = -70; i <= 70; ++i)
            for (const float side : {-1.0f, 1.0f}) {
                dot({float(i) / 70, side}, glm::vec3(0.5f), 0);
                dot({side, float(i) / 70}, glm::vec3(0.5f), 0);
            }
        const lantern::jittered sampler{.side = 16};
        for (std::uint32_t i = 0; i < sampler.count(); ++i) {
            const glm::vec3 d = lab06::perturb(r, 0.8f, sampler.at({panel, 0}, i).draw2(lantern::purpose::gloss));
            const glm::vec3 q = (d / glm::dot(d, w) - w) / 0.4f;
            dot({glm::dot(q, b[0]), glm::dot(q, b[1])}, {0.1f, 0.2f, 0.6f}, 1);
        }
        dot({0, 0}, {0.9f, 0.1f, 0}, 2);
    }
    return result;
}

/// Step 3: one reflected ray for each sample of a pixel, side × side of them.
inline hall::shot row(std::uint32_t side) {
    return {{748, 220}, side, hall::row_of({0, 0.1f, 0.25f, 0.5f, 1}, {0.95f, 0.9f, 0.8f}), hall::metal(lab06::reflected)};
}

/// Step 4: one sample a pixel, and 1, 4, 16, 64 points for its reflection, as the panel is 0, 1, 2, 3.
inline hall::shot points(std::uint32_t panel) {
    const lantern::jittered set{.side = 1u << panel};
    const hall::material many = [set](const hall::ball& b, glm::vec3 in, const lantern::hit& h, glm::vec2 xi, const hall::look& look) {
        std::vector<glm::vec2> unit_square;
        const auto pixel = glm::uvec2(xi * 65536.0f);  // another set for each
        for (std::uint32_t i = 0; i < set.count(); ++i) unit_square.push_back(set.at(pixel, i).draw2(lantern::purpose::gloss));
        return b.color * lab06::reflected_radiance(in, h.normal, b.width, unit_square, [&](glm::vec3 out) { return look(leave(h, out), out, 0); });
    };
    return {{220, 220}, 1, hall::row_of({-1, -1, 0.5f, -1, -1}, {0.95f, 0.9f, 0.8f}), many, {0.4f, 0.12f, 0.6f, 0.8f}};
}
inline lantern::image points() {
    lantern::image result({4 * 220 + 3, 220}, glm::vec3(1));
    for (std::uint32_t panel = 0; panel < 4; ++panel) {
        const lantern::image part = hall::picture(points(panel));
        for (unsigned y = 0; y < 220; ++y)
            for (unsigned x = 0; x < 220; ++x) result(221 * panel + x, y) = part(x, y);
    }
    return result;
}

/// Step 5: balls of frosted glass. The ray is perturbed where it enters and where it leaves.
inline hall::shot frosted(std::uint32_t side) {
    const hall::material glass = [](const hall::ball& b, glm::vec3 in, const lantern::hit& h, glm::vec2 xi, const hall::look& look) {
        const bool enters = glm::dot(in, h.normal) < 0;
        const glm::vec3 normal = enters ? h.normal : -h.normal;
        const auto through = lab06::transmitted(in, normal, enters ? 1 / 1.5f : 1.5f, b.width, xi);
        const glm::vec3 out = through ? *through : glm::reflect(in, normal);
        return look(leave(h, out), out, 0) * glm::sqrt(b.color);
    };
    return {{748, 220}, side, hall::row_of({0, 0.05f, 0.12f, 0.25f, 0.5f}, {0.9f, 0.97f, 0.95f}), glass};
}

}  // namespace pictures
