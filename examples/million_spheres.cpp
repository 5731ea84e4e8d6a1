// SPDX-License-Identifier: MIT
// A field of a million spheres on rolling hills, up to the horizon: in a tree they cost a ray little more than a thousand do.
//     million_spheres [PATH.png] [SPHERES]

#include <lantern/bvh.hpp>
#include <lantern/camera.hpp>
#include <lantern/closest.hpp>
#include <lantern/diffuse.hpp>
#include <lantern/distribution.hpp>
#include <lantern/hash.hpp>
#include <lantern/object.hpp>
#include <lantern/rectangle_light.hpp>
#include <lantern/render.hpp>
#include <lantern/sobol.hpp>
#include <lantern/sphere.hpp>

#include "picture.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace {

using thing = lantern::object<lantern::sphere, lantern::diffuse>;

/// A number in (0, 1) for each (sphere, purpose): the same field on every machine.
float random(std::uint32_t which, std::uint32_t what) { return lantern::to_unit(lantern::low(lantern::hash(which, what, 7u))); }

float height(float x, float z) { return 2.2f * std::sin(0.11f * x) * std::cos(0.13f * z) + 0.7f * std::sin(0.31f * x + 0.4f * z); }

/// In rows over a square of 200 by 200, each a little out of line.
std::vector<thing> field(std::uint32_t count) {
    const auto side = static_cast<std::uint32_t>(std::max(1.0, std::round(std::sqrt(count))));
    const float spacing = 200.0f / float(side);
    std::vector<thing> things;
    things.reserve(std::size_t(side) * side);
    for (std::uint32_t row = 0; row < side; ++row)
        for (std::uint32_t column = 0; column < side; ++column) {
            const std::uint32_t i = row * side + column;
            const float x = (float(column) + random(i, 0)) * spacing - 100, z = -(float(row) + random(i, 1)) * spacing;
            const float radius = spacing * (0.72f + 0.4f * random(i, 2) * random(i, 3)), y = height(x, z), high = (y + 3) / 6;
            const glm::vec3 green{0.08f, 0.25f, 0.05f}, gold{0.75f, 0.5f, 0.12f}, red{0.6f, 0.06f, 0.04f};
            const glm::vec3 color = random(i, 4) < 0.02f ? red : green + high * (gold - green) * (0.6f + 0.8f * random(i, 5));
            things.push_back({lantern::sphere{{x, y, z}, radius}, lantern::diffuse{glm::clamp(color, 0.0f, 1.0f)}});
        }
    return things;
}

}  // namespace

int main(int argc, char** argv) {
    return picture::main(argc, argv, "million_spheres", 1'000'000, [](const std::string& path, std::uint32_t count) {
        const auto began = std::chrono::steady_clock::now();
        const auto scattered = field(count);
        lantern::bvh tree{scattered};
        const auto things = tree.put_in_order(scattered);
        const std::chrono::duration<double> built = std::chrono::steady_clock::now() - began;
        const std::vector lights{lantern::rectangle_light{{-75, 34, -70}, {0, 12, 0}, {-12, 0, 12}, glm::vec3(260, 225, 170)}};
        const lantern::distribution tracer{tree, things, lights, lantern::sky{}, {.ambient = glm::vec3(0.22f, 0.26f, 0.34f)}};
        const lantern::camera cam{lantern::view{.eye = {0, 6.5f, 6}, .target = {0, 1, -24}, .vertical_fov = 0.75f, .aspect = 16.0f / 9},
                                  lantern::pinhole{}};
        picture::write(path, lantern::render({800, 450}, cam, lantern::sobol{.samples = 16}, tracer, {.progress = picture::bar("million_spheres")}));
        lantern::probe counter;
        constexpr std::uint32_t rays = 10'000;
        for (std::uint32_t i = 0; i < rays; ++i)
            (void)closest(tree, things, shoot(cam, {random(i, 8), random(i, 9)}), {}, counter);
        std::printf("%zu spheres, built in %.1f s; a ray from the eye looks at %.1f boxes and %.1f spheres\n", things.size(), built.count(),
                    double(counter.nodes) / rays, double(counter.offers) / rays);
    });
}
