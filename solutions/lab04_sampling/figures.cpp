// SPDX-License-Identifier: MIT
// The figures of lab 04's handout.

#include <lab04_sampling/sampling.hpp>

#include <lantern/hash.hpp>
#include <lantern/image.hpp>
#include <lantern/png.hpp>

#include <filesystem>
#include <functional>
#include <vector>

namespace {

float random(std::uint64_t a, std::uint64_t b) { return lantern::to_unit(lantern::low(lantern::hash(40 + a, b))); }

std::vector<glm::vec2> pairs(std::uint32_t n) {
    std::vector<glm::vec2> result;
    for (std::uint32_t i = 0; i < n; ++i) result.push_back({random(1, i), random(2, i)});
    return result;
}

std::vector<float> numbers(std::uint32_t n) {
    std::vector<float> result;
    for (std::uint32_t i = 0; i < n; ++i) result.push_back(random(3, i));
    return result;
}

constexpr unsigned panel = 180;

/// Dots, over a grid of `coarse` cells a side (dark lines) and `fine` ones (light lines).
void draw(lantern::image& picture, unsigned left, const std::vector<glm::vec2>& points, unsigned coarse, unsigned fine) {
    for (unsigned y = 0; y < panel; ++y)
        for (unsigned x = 0; x < panel; ++x) {
            const glm::vec2 at = (glm::vec2(x, panel - 1 - y) - 9.5f) / float(panel - 20);
            const auto near_line = [&](unsigned count) {
                const glm::vec2 cells = at * float(count), off = glm::abs(cells - glm::round(cells)) / float(count);
                return std::min(off.x, off.y) < 0.0035f;
            };
            glm::vec3 color(1);
            if (std::min(at.x, at.y) > -0.004f && std::max(at.x, at.y) < 1.004f) {
                if (fine > 0 && near_line(fine)) color = glm::vec3(0.82f);
                if (coarse > 0 && near_line(coarse)) color = glm::vec3(0.4f);
            }
            for (const glm::vec2 p : points)
                if (glm::length(p - at) < 0.022f) color = glm::vec3(0.02f, 0.1f, 0.4f);
            picture(left + x, y) = color;
        }
}

/// Sixteen samples: independent, jittered, N-rooks, multi-jittered.
lantern::image sets() {
    lantern::image picture({4 * panel, panel});
    auto jittered = pairs(16);
    for (std::uint32_t i = 0; i < 16; ++i) jittered[i] = lab04::jittered(i, 4, jittered[i]);
    draw(picture, 0, pairs(16), 1, 0);
    draw(picture, panel, jittered, 4, 0);
    draw(picture, 2 * panel, lab04::n_rooks(lab04::shuffled(16, numbers(16)), pairs(16)), 1, 16);
    draw(picture, 3 * panel, lab04::multi_jittered(4, pairs(16), numbers(32)), 4, 16);
    return picture;
}

/// The same 256 jittered points: in the square, on the disk by r = ξ (wrong), by r = √ξ, and by the concentric map.
lantern::image disks() {
    lantern::image picture({4 * panel, panel}, glm::vec3(1));
    const auto map = [&](unsigned left, const std::function<glm::vec2(glm::vec2)>& f) {
        auto points = pairs(256);
        for (std::uint32_t i = 0; i < 256; ++i) points[i] = f(lab04::jittered(i, 16, points[i]));
        for (unsigned y = 0; y < panel; ++y)
            for (unsigned x = 0; x < panel; ++x) {
                const glm::vec2 at = (glm::vec2(x, panel - 1 - y) - 9.5f) / float(panel - 20);
                for (const glm::vec2 p : points)
                    if (glm::length(p - at) < 0.012f) picture(left + x, y) = glm::vec3(0.02f, 0.1f, 0.4f);
            }
    };
    const auto polar = [](float r, float turn) {
        return 0.5f + 0.5f * r * glm::vec2(std::cos(6.2831853f * turn), std::sin(6.2831853f * turn));
    };
    map(0, [](glm::vec2 xi) { return xi; });
    map(panel, [&](glm::vec2 xi) { return polar(xi.x, xi.y); });
    map(2 * panel, [&](glm::vec2 xi) { return polar(std::sqrt(xi.x), xi.y); });
    map(3 * panel, [](glm::vec2 xi) { return 0.5f + 0.5f * lab04::to_disk(xi); });
    return picture;
}

/// A zone plate: one sample in the middle of each pixel; sixteen random ones in the pixel; sixteen jittered under a tent.
lantern::image plates() {
    constexpr unsigned side = 220;
    lantern::image picture({3 * side + 20, side}, glm::vec3(1));
    const auto plate = [](glm::vec2 p) {
        p.y = float(side) - p.y;
        return 0.5f + 0.5f * std::cos(glm::dot(p, p) * 0.75f * 3.14159265f / float(side));
    };
    for (unsigned y = 0; y < side; ++y)
        for (unsigned x = 0; x < side; ++x) {
            const glm::vec2 middle = glm::vec2(x, y) + 0.5f;
            picture(x, y) = glm::vec3(plate(middle));
            std::vector<glm::vec3> box, colors;
            std::vector<float> ones, weights;
            for (std::uint32_t i = 0; i < 16; ++i) {
                const std::uint64_t key = (y * side + x) * 16 + i;
                const glm::vec2 xi{random(5, key), random(6, key)};
                box.emplace_back(plate(middle - 0.5f + xi));
                ones.push_back(1);
                const glm::vec2 offset = 2.0f * lab04::jittered(i, 4, xi) - 1.0f;
                colors.emplace_back(plate(middle + offset));
                weights.push_back(lab04::tent(offset, 1));
            }
            picture(side + 10 + x, y) = lab04::filtered(box, ones);
            picture(2 * side + 20 + x, y) = lab04::filtered(colors, weights);
        }
    return picture;
}

}  // namespace

int main(int argc, char** argv) {
    const std::filesystem::path folder = argc > 1 ? argv[1] : "labs/lab04_sampling/figures";
    lantern::write_png(folder / "sets.png", sets());
    lantern::write_png(folder / "disks.png", disks());
    lantern::write_png(folder / "plates.png", plates());
}
