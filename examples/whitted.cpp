// SPDX-License-Identifier: MIT
// Whitted's scene of 1980: a mirror and a glass sphere over a chequered floor, by the basic ray tracer.
//     whitted [PATH.png] [SIDE]        SIDE² rays a pixel; 1 is the picture of 1980, jagged as it was

#include <lantern/any_of.hpp>
#include <lantern/camera.hpp>
#include <lantern/diffuse.hpp>
#include <lantern/glass.hpp>
#include <lantern/light.hpp>
#include <lantern/mirror.hpp>
#include <lantern/object.hpp>
#include <lantern/rectangle.hpp>
#include <lantern/render.hpp>
#include <lantern/sphere.hpp>
#include <lantern/whitted.hpp>

#include "picture.hpp"

#include <cmath>
#include <variant>
#include <vector>

namespace {

/// A material of our own: matt, in two colours, square by square. The functions beside it make it a material.
struct chequered {
    glm::vec3 even, odd;

    [[nodiscard]] lantern::diffuse at(const lantern::hit& h) const {
        const bool is_even = (std::lround(std::floor(h.point.x)) + std::lround(std::floor(h.point.z))) % 2 == 0;
        return {is_even ? even : odd};
    }
};

glm::vec3 albedo(const chequered& m, const lantern::hit& h) { return m.at(h).color; }

glm::vec3 evaluate(const chequered& m, glm::vec3 in, const lantern::hit& h, glm::vec3 out) {
    return evaluate(m.at(h), in, h, out);
}

using shape = lantern::any_of<lantern::sphere, lantern::rectangle>;
using material = std::variant<chequered, lantern::mirror, lantern::glass>;

}  // namespace

int main(int argc, char** argv) {
    return picture::main(argc, argv, "whitted", 4, [](const std::string& path, std::uint32_t side) {
        const std::vector<lantern::object<shape, material>> things{
            {lantern::rectangle{{-4, 0, 3}, {9, 0, 0}, {0, 0, -14}}, chequered{{0.9f, 0.75f, 0.1f}, {0.7f, 0.05f, 0.04f}}},
            {lantern::sphere{{0.1f, 1.55f, 0.6f}, 0.95f}, lantern::glass{.index = 1.5f}},
            {lantern::sphere{{1.25f, 1.0f, -1.35f}, 0.9f}, lantern::mirror{.color = {0.85f, 0.85f, 0.85f}}},
        };
        const std::vector lights{lantern::point_light{{-4, 9, 5}, glm::vec3(260)}};
        const lantern::every all{static_cast<std::uint32_t>(things.size())};
        const lantern::sky blue{.horizon = {0.45f, 0.65f, 0.95f}, .zenith = {0.1f, 0.25f, 0.7f}};
        const lantern::whitted tracer{all, things, lights, blue, {.ambient = glm::vec3(0.25f)}};
        const lantern::camera cam{lantern::view{
            .eye = {0, 2.2f, 6.5f}, .target = {0.5f, 1.25f, 0}, .vertical_fov = 0.6f, .aspect = 4.0f / 3}};
        picture::write(path, lantern::render({640, 480}, cam, lantern::jittered{.side = side}, tracer,
                                             {.progress = picture::bar("whitted")}));
    });
}
