// SPDX-License-Identifier: MIT
// The figures of lab 06's handout.

#include "../../labs/lab06_glossy/pictures.hpp"

#include <lantern/png.hpp>

#include <glm/common.hpp>

#include <array>
#include <filesystem>

namespace {

/// The middle ball, right and as mistakes show it.
lantern::image mistakes() {
    struct panel {
        glm::vec3 (*reflected)(glm::vec3 in, glm::vec3 normal, float width, glm::vec2 xi);
        float width;
    };
    const auto streaks = [](glm::vec3 in, glm::vec3 n, float width, glm::vec2 xi) { return lab06::reflected(in, n, width, {xi.x, xi.x}); };
    const auto aside = [](glm::vec3 in, glm::vec3 n, float width, glm::vec2 xi) { return lab06::reflected(in, n, width, 0.5f + xi); };
    const auto ghosts = [](glm::vec3 in, glm::vec3 n, float width, glm::vec2 xi) {
        return lab06::reflected(in, n, width, glm::floor(xi * 2.0f) * 0.5f + 0.25f);
    };
    const auto lost = [](glm::vec3 in, glm::vec3 n, float width, glm::vec2 xi) { return lab06::perturb(glm::reflect(in, n), width, xi); };
    const std::array<panel, 6> panels{{{lab06::reflected, 0.5f}, {streaks, 0.5f}, {aside, 0.5f}, {ghosts, 0.5f}, {lab06::reflected, 1.4f}, {lost, 1.4f}}};

    const unsigned side = 140;
    lantern::image result({unsigned(panels.size()) * (side + 1) - 1, side}, glm::vec3(1));
    for (unsigned i = 0; i < panels.size(); ++i) {
        const auto balls = hall::row_of({-1, -1, panels[i].width, -1, -1}, {0.95f, 0.9f, 0.8f});
        const lantern::image ball = hall::picture({{side, side}, 14, balls, hall::metal(panels[i].reflected), {0.4f, 0.14f, 0.6f, 0.82f}});
        for (unsigned y = 0; y < side; ++y)
            for (unsigned x = 0; x < side; ++x) result((side + 1) * i + x, y) = ball(x, y);
    }
    return result;
}

}  // namespace

int main(int argc, char** argv) {
    const std::filesystem::path folder = argc > 1 ? argv[1] : "labs/lab06_glossy/figures";
    lantern::write_png(folder / "axes.png", pictures::axes());
    lantern::write_png(folder / "square.png", pictures::square());
    lantern::write_png(folder / "row.png", hall::picture(pictures::row(14)));
    lantern::write_png(folder / "points.png", pictures::points());
    lantern::write_png(folder / "frosted.png", hall::picture(pictures::frosted(14)));
    lantern::write_png(folder / "mistakes.png", mistakes());
}
