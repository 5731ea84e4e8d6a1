// SPDX-License-Identifier: MIT
// Lab 06's pictures of the hall, explained: ./lab explain 06, ./lab heat 06.

#include <told/sphere.hpp>

namespace hall {
namespace lantern = told;  // the hall's balls tell who asks them
}

#include "../support/explain.hpp"
#include "pictures.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

support::world world_of(const hall::shot& s, const std::string& material) {
    support::world w{.eye = {0, 2.6f, 13}, .floor = 0.0f};
    const char* places[]{"the leftmost ball", "the second ball", "the middle ball", "the fourth ball", "the rightmost ball"};
    for (std::size_t i = 0; i < s.balls.size(); ++i) {
        const hall::ball& b = s.balls[i];
        std::string width = std::to_string(b.width);
        width.erase(width.find_last_not_of('0') + 1);
        if (width.back() == '.') width += '0';
        w.things.push_back({support::ball_at(b.shape.center, b.shape.radius), i < 5 ? places[i] : "a small ball",
                            b.width < 0 ? "matt" : material + ", a = " + width, b.color});
    }
    w.things.push_back({support::level_at(0), "the floor", "matt, in squares", glm::vec3(0.4f)});
    return w;
}

/// What no ray meets, but for the one whose way it stands in: matt, and as bright as a ball is that is seen from below.
hall::ball card(float light) { return {told::sphere{{0, 0, 0}, 0}, glm::vec3(light / 0.35f)}; }

support::subject subject(std::string name, const hall::shot& shot, const std::string& material) {
    const auto shared = std::make_shared<const hall::shot>(shot);
    const lantern::jittered sampler{.side = shot.side};
    return {.name = std::move(name),
            .size = shot.size,
            .samples = sampler.count(),
            .pixel = [=](glm::uvec2 at) { return hall::pixel(*shared, at); },
            .sample = [=](glm::uvec2 at, std::uint32_t i) { return hall::sample(*shared, sampler, at, i); },
            .with_card = [=](glm::uvec2 at, std::uint32_t i, float light) {
                hall::shot more = *shared;
                more.balls.push_back(card(light));
                return hall::sample(more, sampler, at, i);
            },
            .world = world_of(shot, material)};
}

/// Four shots beside each other, a white line between them.
support::subject points() {
    std::vector<support::subject> panels;
    for (std::uint32_t k = 0; k < 4; ++k) panels.push_back(subject("", pictures::points(k), "glossy metal"));
    const auto on_panel = [](glm::uvec2 at) { return glm::uvec2(at.x % 221, at.y); };
    support::subject all = panels[0];
    all.name = "lab06_4_points.png";
    all.size = {4 * 220 + 3, 220};
    all.pixel = [=](glm::uvec2 at) { return at.x % 221 == 220 ? glm::vec3(1) : panels[at.x / 221].pixel(on_panel(at)); };
    all.sample = [=](glm::uvec2 at, std::uint32_t i) { return at.x % 221 == 220 ? glm::vec3(1) : panels[at.x / 221].sample(on_panel(at), i); };
    all.with_card = [=](glm::uvec2 at, std::uint32_t i, float light) { return panels[at.x / 221].with_card(on_panel(at), i, light); };
    return all;
}

std::vector<support::subject> subjects() {
    return {subject("lab06_3_row.png", pictures::row(5), "glossy metal"), points(), subject("lab06_5_frosted.png", pictures::frosted(5), "frosted glass")};
}

}  // namespace

int main(int argc, char** argv) { return support::explain(argc, argv, subjects); }
