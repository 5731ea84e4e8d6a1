// SPDX-License-Identifier: MIT
// Lab 12's pictures of the box, explained: ./lab explain 12, ./lab heat 12.

#include <told/rectangle.hpp>
#include <told/sphere.hpp>

namespace lab12 {
namespace lantern = told;  // the student's code, and its scene, are made of shapes that tell who asks them
}
namespace pictures {
namespace lantern = told;
}

#include "../support/explain.hpp"
#include "pictures.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

constexpr glm::uvec2 size{300, 300};

using look = glm::vec3 (*)(const lab12::scene&, const lantern::ray&, lab12::numbers&);

support::world world_of(const lab12::scene& s) {
    support::world w{.eye = {0, 1, 4.7f}, .beyond = "the dark", .matt = true};
    static constexpr const char* names[]{"the lamp", "the floor", "the ceiling", "the back wall", "the red wall", "the green wall", "the white ball", "the blue ball"};
    std::size_t i = 0;
    for (const lab12::wall& each : s.walls) {
        const support::figure shape = support::plate_at(each.shape.corner, each.shape.u, each.shape.v);
        if (s.lamp == i) w.lamps.push_back({shape, names[i]});
        w.things.push_back({shape, names[i], s.lamp == i ? "gives light" : "matt", each.what.albedo});
        ++i;
    }
    for (const lab12::ball& each : s.balls) w.things.push_back({support::ball_at(each.shape.center, each.shape.radius), names[i++], "matt", each.upper.albedo});
    return w;
}

/// A scene with a card in it: what no ray meets, but for the one whose way it stands in.
lab12::scene with_card(lab12::scene s, float light) {
    const lab12::matter card{glm::vec3(0), glm::vec3(light)};
    s.balls.push_back({told::sphere{{0, 0, 0}, 0}, card, card});
    return s;
}

support::subject subject(std::string name, std::uint32_t samples, look along) {
    const auto scene = std::make_shared<const lab12::scene>(pictures::cornell());
    const auto camera = std::make_shared<const lantern::camera<>>(pictures::before_the_box());
    const auto in = [along](const lab12::scene& s) {
        return [&s, along](const lantern::ray& r, lab12::numbers& random) { return along(s, r, random); };
    };
    return {.name = std::move(name),
            .size = size,
            .samples = samples,
            .pixel = [=](glm::uvec2 at) { return pictures::pixel(size, *camera, at, samples, in(*scene)); },
            .sample = [=](glm::uvec2 at, std::uint32_t i) { return pictures::sample(size, *camera, at, i, in(*scene)); },
            .with_card = [=](glm::uvec2 at, std::uint32_t i, float light) { return pictures::sample(size, *camera, at, i, in(with_card(*scene, light))); },
            .world = world_of(*scene)};
}

std::vector<support::subject> subjects() {
    return {subject("lab12_8_box.png", 32, [](const lab12::scene& s, const lantern::ray& r, lab12::numbers& random) { return lab12::radiance(s, r, random); }),
            subject("lab12_5_direct.png", 16, pictures::direct_light)};
}

}  // namespace

int main(int argc, char** argv) { return support::explain(argc, argv, subjects); }
