// SPDX-License-Identifier: MIT
// A scene that is chosen when the program runs, cut down to what it needs before it is rendered.
//     leave_out [PATH.png] [SAMPLES] [lens] [motion] [gloss] [soft]
// Says what was left out and why; the fewer words, the faster.

#include <lantern/any_of.hpp>
#include <lantern/diffuse.hpp>
#include <lantern/distribution.hpp>
#include <lantern/glossy.hpp>
#include <lantern/mirror.hpp>
#include <lantern/moving.hpp>
#include <lantern/render.hpp>
#include <lantern/sky.hpp>
#include <lantern/sobol.hpp>
#include <lantern/sphere.hpp>
#include <lantern/sphere_light.hpp>
#include <lantern/trim.hpp>

#include "picture.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

int main(int argc, char** argv) {
    return picture::main(argc, argv, "leave_out", 64, [&](const std::string& path, std::uint32_t samples) {
        using namespace lantern;
        const std::span words(argv, static_cast<std::size_t>(argc));
        const auto said = [&](std::string_view word) { return std::ranges::find(words, word) != words.end(); };

        // Types that can hold whatever may be asked for.
        using shape = any_of<sphere, moving<sphere>>;
        using material = std::variant<diffuse, mirror, glossy>;
        using light = std::variant<point_light, sphere_light>;
        ingredients<object<shape, material>, light> scene;
        const glm::vec3 way = said("motion") ? glm::vec3(0.6f, 0.1f, 0) : glm::vec3(0);
        scene.things = {
            {sphere{{0, -1000, 0}, 1000}, diffuse{{0.5f, 0.5f, 0.45f}}},
            {sphere{{-0.9f, 0.8f, 0}, 0.8f}, glossy{.color = {0.9f, 0.75f, 0.5f}, .width = said("gloss") ? 0.25f : 0.0f}},
            {sphere{{0.9f, 0.6f, -1.5f}, 0.6f}, mirror{glm::vec3(0.85f)}},
            {moving{sphere{{0.5f, 0.4f, 1}, 0.4f}, way}, diffuse{{0.7f, 0.2f, 0.15f}}},
        };
        if (said("soft")) scene.lights = {sphere_light{{3, 6, 3}, 1, glm::vec3(36)}};
        else scene.lights = {point_light{{3, 6, 3}, glm::vec3(113)}};
        scene.from = {.eye = {0, 1.6f, 6}, .target = {0, 0.6f, 0}, .vertical_fov = 0.6f, .aspect = 1.5f};
        scene.lens = {.radius = said("lens") ? 0.12f : 0.0f, .focus_distance = 5};

        for (const finding& f : look_at(scene))
            std::printf("%-24s %-9s %s\n", f.what.c_str(), f.left_out ? "left out:" : "needed:", f.why.c_str());
        const auto start = std::chrono::steady_clock::now();
        const image result = trim(scene, [&](const auto& structure, const auto& things, const auto& lights, const auto& cam) {
            const distribution tracer{structure, things, lights, sky{}};
            return render({480, 320}, cam, sobol{.samples = samples}, tracer);
        });
        std::printf("%.2f s\n", std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        picture::write(path, result);
    });
}
