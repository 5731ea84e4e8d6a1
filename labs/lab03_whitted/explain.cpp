// SPDX-License-Identifier: MIT
// Lab 03's picture, explained: ./lab explain 03, ./lab heat 03.

#include <told/plane.hpp>
#include <told/rectangle.hpp>
#include <told/sphere.hpp>

namespace lab03 {
namespace lantern = told;  // the student's code, and its scene, are made of shapes that tell who asks them
}

#include "../support/explain.hpp"
#include "../support/gaps.hpp"
#include "pictures.hpp"

#include <lantern/render.hpp>

#include <memory>
#include <variant>
#include <vector>

namespace {

support::figure figure_of(const told::sphere& s) { return support::ball_at(s.center, s.radius); }
support::figure figure_of(const told::rectangle& s) { return support::plate_at(s.corner, s.u, s.v); }
support::figure figure_of(const told::plane& s) { return {"plane", {s.point.x, s.point.y, s.point.z, s.normal.x, s.normal.y, s.normal.z}}; }

std::string material_of(const lab03::material& m) {
    static constexpr const char* names[]{"matt", "matt, in squares", "a mirror", "glass"};
    return names[m.index()];
}

support::world world_of(const lab03::scene& s, glm::vec3 eye) {
    support::world w{.eye = eye};
    static constexpr const char* names[]{"the floor", "the glass ball", "the mirror ball", "the blue ball"};
    const glm::vec3 colors[]{{0.7f, 0.4f, 0.1f}, {0.8f, 0.9f, 0.95f}, {0.7f, 0.7f, 0.75f}, {0.1f, 0.3f, 0.7f}};
    for (std::size_t i = 0; i < s.things.size(); ++i)
        w.things.push_back({std::visit([](const auto& shape) { return figure_of(shape); }, s.things[i].body.value), names[i], material_of(s.things[i].material), colors[i]});
    for (const lab03::light& l : s.lights) w.lamps.push_back({support::ball_at(l.position, 0), "the lamp"});
    return w;
}

/// What no ray meets, but for the one whose way it stands in.
lab03::thing card_of(float light, glm::vec3 ambient) { return {told::sphere{{0, 0, 0}, 0}, lab03::matte{.body = light / ambient}}; }

std::vector<support::subject> subjects() {
    support::gaps gaps;
    const auto plain = std::make_shared<const pictures::shade>(gaps);
    const auto camera = std::make_shared<const lantern::camera<>>(lab03::whitted_camera(pictures::size));
    // While a step is missing, a test card lies in a corner.
    const glm::uvec2 card = pictures::size / 5u;
    const int step = gaps.next_step();
    const auto on_card = [=](glm::uvec2 pixel) { return step > 0 && pixel.x < card.x && pixel.y < card.y; };
    const auto sample = [=](const pictures::shade& shade, glm::uvec2 pixel, std::uint32_t i) {
        return lantern::render_sample(pixel, pictures::size, *camera, pictures::samples, i, shade).color;
    };
    return {{.name = "lab03.png",
             .size = pictures::size,
             .samples = pictures::samples.count(),
             .pixel = [=](glm::uvec2 pixel) {
                 if (on_card(pixel)) return support::test_card((glm::vec2(pixel) + 0.5f) / glm::vec2(card), step);
                 return lantern::render_pixel(pixel, pictures::size, *camera, pictures::samples, *plain).mean();
             },
             .sample = [=](glm::uvec2 pixel, std::uint32_t i) {
                 return on_card(pixel) ? support::test_card((glm::vec2(pixel) + 0.5f) / glm::vec2(card), step) : sample(*plain, pixel, i);
             },
             .with_card = [=](glm::uvec2 pixel, std::uint32_t i, float light) {
                 pictures::shade shade = *plain;
                 shade.scene.things.push_back(card_of(light, shade.scene.ambient));
                 return sample(shade, pixel, i);
             },
             .world = world_of(plain->scene, {0, 2.2f, 6.5f})}};
}

}  // namespace

int main(int argc, char** argv) { return support::explain(argc, argv, subjects); }
