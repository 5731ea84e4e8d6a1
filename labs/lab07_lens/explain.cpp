// SPDX-License-Identifier: MIT
// Lab 07's photographs, explained: ./lab explain 07, ./lab heat 07.

#include <told/sphere.hpp>

namespace garden {
namespace lantern = told;  // the garden's balls tell who asks them
}

#include "../support/explain.hpp"
#include "pictures.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

/// `focus` is the depth of the ball that is sharp.
support::world world_of(const pictures::photograph& p, float focus) {
    support::world w{.eye = p.camera.eye, .floor = 0.0f, .beyond = "the dusk"};
    const char* places[]{"the nearest ball", "the second ball", "the middle ball", "the fourth ball", "the farthest ball"};
    for (std::size_t i = 0; i < p.balls.size(); ++i) {
        const garden::ball& b = p.balls[i];
        w.things.push_back({support::ball_at(b.shape.center, b.shape.radius), b.lamp ? "a lamp" : places[i], b.lamp ? "gives light" : "matt", b.lamp ? 0.12f * b.color : b.color});
    }
    w.things.push_back({support::level_at(0), "the floor", "matt, in squares", glm::vec3(0.4f)});
    const glm::vec3 right = 1.8f * p.camera.axes[0], up = 1.4f * p.camera.axes[1], middle = p.camera.eye + focus * p.camera.axes[2];
    w.things.push_back({support::plate_at(middle - right - up, 2.0f * right, 2.0f * up), "the plane of focus", "nothing is there", glm::vec3(0.3f, 0.6f, 0.9f)});
    return w;
}

support::subject subject(std::string name, const pictures::photograph& of, float focus) {
    const auto shared = std::make_shared<const pictures::photograph>(of);
    const lantern::multi_jittered sampler{.side = of.side};
    return {.name = std::move(name),
            .size = of.size,
            .samples = sampler.count(),
            .pixel = [=](glm::uvec2 at) { return pictures::pixel(*shared, at); },
            .sample = [=](glm::uvec2 at, std::uint32_t i) { return pictures::sample(*shared, sampler, at, i); },
            .world = world_of(of, focus)};
}

std::vector<support::subject> subjects() {
    const float first = pictures::depth_of(0), second = pictures::depth_of(1);
    return {subject("lab07_3_focus.png", pictures::focused({720, 300}, 6, 0.12f, second), second), subject("lab07_7_blades.png", pictures::blades({720, 300}, 6, 6), first)};
}

}  // namespace

int main(int argc, char** argv) { return support::explain(argc, argv, subjects); }
