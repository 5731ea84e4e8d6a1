// SPDX-License-Identifier: MIT
// All five effects in one picture: antialiasing, soft shadows, glossy reflection, depth of field, motion blur.
//     distribution [PATH.png] [SAMPLES]

#include <lantern/any_of.hpp>
#include <lantern/bvh.hpp>
#include <lantern/camera.hpp>
#include <lantern/coated.hpp>
#include <lantern/diffuse.hpp>
#include <lantern/distribution.hpp>
#include <lantern/emissive.hpp>
#include <lantern/glossy.hpp>
#include <lantern/moving.hpp>
#include <lantern/object.hpp>
#include <lantern/rectangle.hpp>
#include <lantern/rectangle_light.hpp>
#include <lantern/render.hpp>
#include <lantern/sobol.hpp>
#include <lantern/sphere.hpp>

#include "picture.hpp"

#include <variant>
#include <vector>

namespace {

using shape = lantern::any_of<lantern::sphere, lantern::moving<lantern::sphere>, lantern::rectangle>;
using polished = lantern::coated<lantern::diffuse, lantern::glossy>;
using material = std::variant<polished, lantern::glossy, lantern::glass, lantern::emissive>;
using thing = lantern::object<shape, material>;

polished ball(glm::vec3 color) { return {{color}, {.color = glm::vec3(1), .width = 0.02f}, 0.07f}; }

}  // namespace

int main(int argc, char** argv) {
    return picture::main(argc, argv, "distribution", 64, [](const std::string& path, std::uint32_t samples) {
        const lantern::rectangle_light lamp{{-1, 7, -2}, {0, 0, 4}, {-4, 0, 0}, glm::vec3(9, 8.5f, 7.5f)};
        const std::vector<thing> things{
            {lantern::rectangle{{-30, 0, 12}, {60, 0, 0}, {0, 0, -60}},
             polished{{{0.25f, 0.3f, 0.36f}}, {.color = glm::vec3(1), .width = 0.25f}, 0.2f}},
            {lantern::sphere{{0, 1, 0}, 1}, lantern::glossy{.color = {0.95f, 0.75f, 0.35f}, .width = 0.25f}},
            {lantern::sphere{{-2.3f, 1, -1.2f}, 1}, ball({0.7f, 0.06f, 0.05f})},
            {lantern::moving{lantern::sphere{{2.2f, 1, 0.2f}, 1}, {0.6f, 0, 0}}, ball({0.06f, 0.2f, 0.6f})},
            {lantern::sphere{{-5.2f, 1, -8}, 1}, ball({0.1f, 0.45f, 0.12f})},
            {lantern::sphere{{4.4f, 1, -12}, 1}, ball({0.8f, 0.6f, 0.1f})},
            {lantern::sphere{{-1.2f, 0.5f, 2.6f}, 0.5f}, lantern::glass{}},
            {surface_of(lamp), lantern::emissive{lamp.radiance}},
        };
        const std::vector lights{lamp};
        const lantern::bvh tree{things};
        const lantern::sky dusk{.horizon = {0.35f, 0.38f, 0.45f}, .zenith = {0.05f, 0.07f, 0.14f}};
        const lantern::distribution tracer{tree, things, lights, dusk, {.ambient = glm::vec3(0.12f)}};
        const lantern::camera cam{
            lantern::view{.eye = {0, 2.4f, 9}, .target = {0, 0.8f, 0}, .vertical_fov = 0.5f, .aspect = 2},
            lantern::thin_lens{.radius = 0.12f, .focus_distance = 9.1f}, lantern::shutter{.open = 0, .close = 1}};
        picture::write(path, lantern::render({800, 400}, cam, lantern::sobol{.samples = samples}, tracer,
                                             {.progress = picture::bar("distribution")}));
    });
}
