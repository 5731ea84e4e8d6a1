// SPDX-License-Identifier: MIT
// The figures of lab 07's handout.

#include "../../labs/lab07_lens/pictures.hpp"

#include <lantern/png.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <vector>

namespace {

/// Pictures of the same height side by side.
lantern::image beside(const std::vector<lantern::image>& parts) {
    unsigned width = 0;
    for (const lantern::image& part : parts) width += part.size().x + 2;
    lantern::image page({width - 2, parts.front().size().y}, glm::vec3(1));
    unsigned left = 0;
    for (const lantern::image& part : parts) {
        for (unsigned y = 0; y < part.size().y; ++y) std::ranges::copy(part.row(y), page.row(y).begin() + left);
        left += part.size().x + 2;
    }
    return page;
}

/// 24 x 24 jittered points, carried to the disc in four ways.
lantern::image lenses() {
    const auto polar = [](float distance, float turn) {
        return distance * glm::vec2(std::cos(2 * std::numbers::pi_v<float> * turn), std::sin(2 * std::numbers::pi_v<float> * turn));
    };
    const std::vector<std::function<glm::vec2(glm::vec2)>> ways{
        [&](glm::vec2 xi) { return polar(xi.x, xi.y); },
        [&](glm::vec2 xi) { return polar(std::sqrt(xi.x), xi.x); },
        [&](glm::vec2 xi) { return polar(std::sqrt(xi.x), xi.y); },
        [&](glm::vec2 xi) { return lab07::on_lens(xi, 1); },
    };
    lantern::image page({4 * 200, 200}, glm::vec3(1));
    for (unsigned i = 0; i < 4; ++i) pictures::dots(page, 200 * i, 200, pictures::placed(24, ways[i]), {0.1f, 0.2f, 0.6f});
    return page;
}

/// Sharp in the middle ball's plane; and four mistakes.
lantern::image mistakes() {
    const glm::uvec2 size{176, 176};
    const float focus = pictures::depth_of(1);
    const auto way = [&](auto direction) {
        return pictures::taken({size, 12, [=](const garden::stand& c, glm::vec2 film, glm::vec2 xi) { return direction(c, film, xi); }});
    };
    const auto through = [focus](const garden::stand& c, glm::vec2 film, glm::vec2 l) {
        const glm::vec3 offset = l.x * c.axes[0] + l.y * c.axes[1];
        return lantern::ray{c.eye + offset, glm::normalize(c.axes * glm::vec3(film, 1) - offset / focus)};
    };
    return beside({
        way([&](const garden::stand& c, glm::vec2 film, glm::vec2 xi) { return through(c, film, lab07::on_lens(xi, 0.12f)); }),
        way([&](const garden::stand& c, glm::vec2 film, glm::vec2 xi) {  // the origin is moved, the direction is not
            lantern::ray r = through(c, film, lab07::on_lens(xi, 0.12f));
            r.direction = glm::normalize(c.axes * glm::vec3(film, 1));
            return r;
        }),
        way([&](const garden::stand& c, glm::vec2 film, glm::vec2 xi) { return through(c, film, 0.12f * (2.0f * xi - 1.0f)); }),
        way([&](const garden::stand& c, glm::vec2 film, glm::vec2 xi) {  // one number twice
            return through(c, film, 0.12f * std::sqrt(xi.x) * glm::vec2(std::cos(6.2831853f * xi.x), std::sin(6.2831853f * xi.x)));
        }),
    });
}

}  // namespace

int main(int argc, char** argv) {
    const std::filesystem::path folder = argc > 1 ? argv[1] : "labs/lab07_lens/figures";
    lantern::write_png(folder / "lenses.png", lenses());
    lantern::write_png(folder / "focus.png", pictures::taken(pictures::focused({720, 300}, 18, 0.12f, pictures::depth_of(1))));
    lantern::write_png(folder / "three.png", beside({pictures::taken(pictures::focused({246, 164}, 18, 0, pictures::depth_of(0))),
                                                     pictures::taken(pictures::focused({246, 164}, 18, 0.12f, pictures::depth_of(0))),
                                                     pictures::taken(pictures::focused({246, 164}, 18, 0.12f, pictures::depth_of(2)))}));
    lantern::write_png(folder / "discs.png", pictures::discs());
    lantern::write_png(folder / "samples.png", pictures::samples());
    lantern::write_png(folder / "blades.png", pictures::taken(pictures::blades({720, 300}, 18, 6)));
    lantern::write_png(folder / "mistakes.png", mistakes());
}
