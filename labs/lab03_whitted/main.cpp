// SPDX-License-Identifier: MIT
// Lab 03: Whitted's spheres. What is not written yet is replaced by something plain.

#include "../support/gaps.hpp"

#include "scene.hpp"

#include <lab03_whitted/whitted.hpp>

#include <lantern/camera.hpp>
#include <lantern/png.hpp>
#include <lantern/render.hpp>
#include <lantern/samples.hpp>

#include <glm/common.hpp>

#include <exception>
#include <filesystem>
#include <iostream>

namespace {

support::gaps gaps;

/// Until step 6 is done: nothing is followed, and every material is matt. Uses the steps that are there.
struct preview {
    lab03::scene scene = lab03::whitted_scene();
    bool shading = gaps.is_written([] { return lab03::shade({}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}); });
    bool shadows = gaps.is_written([] { return lab03::lit({}, {}, {0, 1, 0}); });
    bool mirrors = gaps.is_written([] { return lab03::reflected({0, -1, 0}, {0, 1, 0}); });

    glm::vec3 operator()(const lantern::ray& r, const auto&...) const { return color(r, mirrors); }

    glm::vec3 color(const lantern::ray& r, bool follow) const {
        const auto h = lab03::closest(scene, r);
        if (!h) return lab03::sky(scene, r.direction);
        const lab03::material& m = scene.things[h->index].material;
        const auto found = lab03::matte_at(m, h->point);
        if (!found && follow) {
            const glm::vec3 onwards = lab03::reflected(r.direction, h->normal);
            return 0.85f * color({lantern::leave(*h, onwards), onwards}, false);
        }
        const lab03::matte surface = found.value_or(lab03::matte{.highlight = glm::vec3(0.5f)});
        glm::vec3 sum = (shading ? scene.ambient : glm::vec3(0.5f)) * surface.body;
        for (const lab03::light& l : scene.lights) {
            const glm::vec3 to_light = l.position - h->point;
            if (!shading || (shadows && !lab03::lit(scene, *h, l.position))) continue;
            sum += l.intensity / glm::dot(to_light, to_light) *
                   lab03::shade(surface, h->normal, glm::normalize(to_light), -r.direction);
        }
        return sum;
    }
};

lantern::image picture(glm::uvec2 size) {
    const lantern::camera camera = lab03::whitted_camera(size);
    const preview plain;
    gaps.is_written([] { return lab03::refracted({0, -1, 0}, {0, 1, 0}, 1); });
    gaps.is_written([] { return lab03::reflectance(1, 1); });
    const lab03::scene world = lab03::whitted_scene();
    const bool all = gaps.is_written([&] { return lab03::trace(world, {{0, 9, 0}, {0, 1, 0}}, 1); }) && gaps.none();

    lantern::image made = all ? lantern::render(size, camera, lantern::jittered{.side = 3},
                                                [&](const lantern::ray& r, const auto&) { return lab03::trace(world, r, 8); })
                              : lantern::render(size, camera, lantern::jittered{.side = 3}, plain);
    if (all) return made;
    // The number of the next step, in a corner.
    support::paint_test_card(made, {0, 0}, size / 5u, gaps.next_step());
    return made;
}

}  // namespace

int main(int argc, char** argv) try {
    const std::filesystem::path path = std::filesystem::path(argc > 1 ? argv[1] : "out") / "lab03.png";
    lantern::write_png(path, picture({640, 480}));
    std::cout << path.string() << '\n';
    gaps.tell();
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
