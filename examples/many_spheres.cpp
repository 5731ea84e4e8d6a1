// SPDX-License-Identifier: MIT
// A field of about 500 spheres of the three classic materials (matt, metal, glass) on one huge one.
//     many_spheres [PATH.png] [SAMPLES]

#include <lantern/bvh.hpp>
#include <lantern/camera.hpp>
#include <lantern/diffuse.hpp>
#include <lantern/distribution.hpp>
#include <lantern/glass.hpp>
#include <lantern/glossy.hpp>
#include <lantern/hash.hpp>
#include <lantern/object.hpp>
#include <lantern/rectangle_light.hpp>
#include <lantern/render.hpp>
#include <lantern/sobol.hpp>
#include <lantern/sphere.hpp>

#include "picture.hpp"

#include <variant>
#include <vector>

namespace {

using material = std::variant<lantern::diffuse, lantern::glossy, lantern::glass>;
using thing = lantern::object<lantern::sphere, material>;

/// A number in (0, 1) for each (x, z, purpose): the same field on every machine.
float random(int x, int z, int what) {
    return lantern::to_unit(lantern::low(lantern::hash(unsigned(x + 100), unsigned(z + 100), unsigned(what))));
}

material random_material(int x, int z) {
    const float kind = random(x, z, 2);
    const glm::vec3 color{random(x, z, 3), random(x, z, 4), random(x, z, 5)};
    if (kind < 0.7f) return lantern::diffuse{color * color};
    if (kind < 0.88f) return lantern::glossy{.color = 0.5f + 0.5f * color, .width = random(x, z, 6) * 0.5f};
    return lantern::glass{};
}

std::vector<thing> field() {
    std::vector<thing> things{
        {lantern::sphere{{0, -1000, 0}, 1000}, lantern::diffuse{{0.45f, 0.47f, 0.5f}}},
        {lantern::sphere{{0, 1, 0}, 1}, lantern::glass{}},
        {lantern::sphere{{-4, 1, 0}, 1}, lantern::diffuse{{0.4f, 0.2f, 0.1f}}},
        {lantern::sphere{{4, 1, 0}, 1}, lantern::glossy{.color = {0.85f, 0.8f, 0.7f}, .width = 0}},
    };
    for (int x = -11; x < 11; ++x)
        for (int z = -11; z < 11; ++z) {
            const glm::vec3 center{float(x) + 0.9f * random(x, z, 0), 0.2f, float(z) + 0.9f * random(x, z, 1)};
            if (glm::length(center - glm::vec3(4, 0.2f, 0)) > 1.1f && glm::length(center - glm::vec3(0, 0.2f, 0)) > 1.1f &&
                glm::length(center - glm::vec3(-4, 0.2f, 0)) > 1.1f)
                things.push_back({lantern::sphere{center, 0.2f}, random_material(x, z)});
        }
    return things;
}

}  // namespace

int main(int argc, char** argv) {
    return picture::main(argc, argv, "many_spheres", 16, [](const std::string& path, std::uint32_t samples) {
        const auto things = field();
        const lantern::bvh tree{things};
        const std::vector lights{lantern::rectangle_light{{2, 16, 12}, {4, 0, -6}, {6, 0, 4}, glm::vec3(26)}};
        const lantern::distribution tracer{tree, things, lights, lantern::sky{}, {.ambient = glm::vec3(0.35f)}};
        const lantern::camera cam{
            lantern::view{.eye = {13, 2, 3}, .target = {0, 0.4f, 0}, .vertical_fov = 0.35f, .aspect = 16.0f / 9},
            lantern::thin_lens{.radius = 0.05f, .focus_distance = 9.5f}};
        picture::write(path, lantern::render({800, 450}, cam, lantern::sobol{.samples = samples}, tracer,
                                             {.progress = picture::bar("many_spheres")}));
    });
}
