// SPDX-License-Identifier: MIT
// The figures of lab 05's handout.

#include <lab05_soft_shadows/soft_shadows.hpp>

#include <lantern/exact_light.hpp>
#include <lantern/image.hpp>
#include <lantern/png.hpp>
#include <lantern/samples.hpp>

#include <filesystem>

namespace {

/// Two by two, three above the floor; a board at height 1 covers x < 0.
const lab05::lamp lamp{{1, 3, -1}, {0, 0, 2}, {-2, 0, 0}, glm::vec3(1)};
const lab05::scene board{{}, {{{-500, 1, -500}, {500, 0, 0}, {0, 0, 1000}}}};

lantern::hit floor_at(float x, float z = 0) { return {1, {x, 0, z}, {0, 1, 0}, 0}; }

/// The floor from x = -1.2 to 1.2, seen from above; the upper strips with 16 points a pixel, the lowest one exact.
/// From the top: the lamp's middle alone, independent points, one in each cell of a grid, the closed form.
lantern::image strips() {
    const unsigned width = 480, height = 60;
    lantern::image picture({width, 4 * height + 9}, glm::vec3(1));
    const float full = 2.2f;
    const lantern::independent chance{.samples = 16};
    const lantern::jittered grid{.side = 4};
    for (unsigned x = 0; x < width; ++x)
        for (unsigned y = 0; y < height; ++y) {
            const float at = 2.4f * (float(x) + 0.5f) / float(width) - 1.2f;
            const auto points = [&](const auto& sampler) {
                std::vector<glm::vec2> result;
                for (std::uint32_t i = 0; i < 16; ++i) result.push_back(sampler.at({x, y}, i).draw2(lantern::purpose::light));
                return result;
            };
            const std::vector<glm::vec2> middle{{0.5f, 0.5f}};
            const auto light = [&](const std::vector<glm::vec2>& p) { return lab05::soft_light(lamp, floor_at(at), board, p) * full; };
            const double exact = lantern::exact::penumbra({at, 0, 0}, {0, 1, 0}, {{0, 1, 0}, {0, 0, 1}},
                                                          {glm::dvec3(lamp.corner), glm::dvec3(lamp.edge_u), glm::dvec3(lamp.edge_v)});
            picture(x, y) = light(middle);
            picture(x, y + height + 3) = light(points(chance));
            picture(x, y + 2 * (height + 3)) = light(points(grid));
            picture(x, y + 3 * (height + 3)) = glm::vec3(float(exact) * full);
        }
    return picture;
}

/// A cut through the scene: lamp, board and floor; each point of the air in the light that reaches it. Black: the umbra.
lantern::image section() {
    const unsigned width = 480, height = 330;
    lantern::image picture({width, height});
    for (unsigned px = 0; px < width; ++px)
        for (unsigned py = 0; py < height; ++py) {
            const float x = 4.8f * (float(px) + 0.5f) / float(width) - 2.4f, y = 3.15f - 3.3f * (float(py) + 0.5f) / float(height);
            int seen = 0;
            const int count = 64;
            for (int i = 0; i < count; ++i) {
                const glm::vec3 on_lamp{1 - 2 * (float(i) + 0.5f) / float(count), 3, 0};
                seen += !lab05::blocked(board, {{x, y, 0}, on_lamp - glm::vec3(x, y, 0)}, {0, 1});
            }
            glm::vec3 color = glm::vec3(1, 0.9f, 0.6f) * (float(seen) / float(count));
            if (seen > 0 && seen < count) color *= glm::vec3(0.75f, 0.85f, 1.2f);
            if (y < 0) color = glm::vec3(0.25f);
            if (std::abs(y - 1) < 0.02f && x < 0) color = glm::vec3(0.7f, 0.1f, 0.05f);
            if (std::abs(y - 3) < 0.03f) color = std::abs(x) < 1 ? glm::vec3(1) : glm::vec3(0.1f);
            if (y > 3.03f) color = glm::vec3(0.1f);
            picture(px, py) = color;
        }
    return picture;
}

}  // namespace

int main(int argc, char** argv) {
    const std::filesystem::path folder = argc > 1 ? argv[1] : "labs/lab05_soft_shadows/figures";
    lantern::write_png(folder / "section.png", section());
    lantern::write_png(folder / "strips.png", strips());
}
