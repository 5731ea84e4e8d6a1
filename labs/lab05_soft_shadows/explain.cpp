// SPDX-License-Identifier: MIT
// Lab 05's pictures, explained: ./lab explain 05, ./lab heat 05.

#include <told/rectangle.hpp>
#include <told/sphere.hpp>

namespace lab05 {
namespace lantern = told;  // the student's code, and its scene, are made of shapes that tell who asks them
}

#include "../support/explain.hpp"
#include "pictures.hpp"

#include <lantern/render.hpp>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

using pictures::size;

support::world world_of(const pictures::room& in, const support::world::lamp& lamp) {
    support::world w{.eye = pictures::eye, .lamps = {lamp}, .beyond = "the dark"};
    static constexpr const char* names[]{"the red ball", "the blue ball", "the yellow ball", "the table", "the screen"};
    std::size_t i = 0;
    for (const auto& b : in.table.balls) w.things.push_back({support::ball_at(b.center, b.radius), names[i], "matt", in.colors[i]}), ++i;
    for (const auto& b : in.table.walls) w.things.push_back({support::plate_at(b.corner, b.u, b.v), names[i], "matt", in.colors[i]}), ++i;
    return w;
}

/// A room with a card in it: what no ray meets, but for the one whose way it stands in. Where no lamp shines, a fiftieth of a surface's
/// colour is its light.
pictures::room with_card(pictures::room in, float light) {
    in.table.walls.push_back({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}});
    in.colors.push_back(glm::vec3(light / 0.02f));
    return in;
}

template <class Light>
support::subject subject(std::string name, Light light, const support::world::lamp& lamp) {
    const auto in = std::make_shared<const pictures::room>();
    const auto sample = [=](const pictures::room& room, glm::uvec2 at, std::uint32_t i) {
        return lantern::render_sample(at, size, pictures::camera, pictures::samples, i, pictures::shade<Light>{room, light}).color;
    };
    return {.name = std::move(name),
            .size = size,
            .samples = pictures::samples.count(),
            .pixel = [=](glm::uvec2 at) { return lantern::render_pixel(at, size, pictures::camera, pictures::samples, pictures::shade<Light>{*in, light}).mean(); },
            .sample = [=](glm::uvec2 at, std::uint32_t i) { return sample(*in, at, i); },
            .with_card = [=](glm::uvec2 at, std::uint32_t i, float shines) { return sample(with_card(*in, shines), at, i); },
            .world = world_of(*in, lamp)};
}

/// Hard shadows on the left, soft ones on the right.
support::subject both() {
    const support::world::lamp lamp{support::plate_at(pictures::lamp.corner, pictures::lamp.edge_u, pictures::lamp.edge_v), "the lamp"};
    const support::subject left = subject("", pictures::hard, lamp), right = subject("", pictures::soft, lamp);
    const auto half = [=](glm::uvec2 at) -> const support::subject& { return at.x < size.x ? left : right; };
    const auto inside = [](glm::uvec2 at) { return glm::uvec2(at.x % size.x, at.y); };
    return {.name = "lab05.ppm",
            .size = {2 * size.x, size.y},
            .samples = left.samples,
            .pixel = [=](glm::uvec2 at) { return half(at).pixel(inside(at)); },
            .sample = [=](glm::uvec2 at, std::uint32_t i) { return half(at).sample(inside(at), i); },
            .with_card = [=](glm::uvec2 at, std::uint32_t i, float light) { return half(at).with_card(inside(at), i, light); },
            .world = left.world};
}

std::vector<support::subject> subjects() {
    return {both(), subject("lab05_round.ppm", pictures::round, {support::ball_at(pictures::lamp_middle, pictures::ball_of_light), "the ball of light"})};
}

}  // namespace

int main(int argc, char** argv) { return support::explain(argc, argv, subjects); }
