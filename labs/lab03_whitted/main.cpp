// SPDX-License-Identifier: MIT
// Lab 03: Whitted's spheres. What is not written yet is replaced by something plain.

#include "../support/test_card.hpp"

#include "scene.hpp"

#include <lab03_whitted/whitted.hpp>

#include <lantern/camera.hpp>
#include <lantern/png.hpp>
#include <lantern/render.hpp>
#include <lantern/samples.hpp>
#include <lantern/todo.hpp>

#include <glm/common.hpp>

#include <exception>
#include <filesystem>
#include <iostream>
#include <set>
#include <string>

namespace {

/// The steps that are not done yet, as they say it themselves.
std::set<std::string> missing;

template <class Call>
bool is_written(Call call) {
    try {
        (void)call();
        return true;
    } catch (const lantern::unfinished& gap) {
        missing.insert(gap.what());
        return false;
    }
}

/// Until step 6 is done: nothing is followed, and every material is matt. Uses the steps that are there.
struct preview {
    lab03::scene scene = lab03::whitted_scene();
    bool shading = is_written([] { return lab03::shade({}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}); });
    bool shadows = is_written([] { return lab03::lit({}, {}, {0, 1, 0}); });
    bool mirrors = is_written([] { return lab03::reflected({0, -1, 0}, {0, 1, 0}); });

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
    is_written([] { return lab03::refracted({0, -1, 0}, {0, 1, 0}, 1); });
    is_written([] { return lab03::reflectance(1, 1); });
    const lab03::scene world = lab03::whitted_scene();
    const bool all = is_written([&] { return lab03::trace(world, {{0, 9, 0}, {0, 1, 0}}, 1); }) && missing.empty();

    lantern::image made = all ? lantern::render(size, camera, lantern::jittered{.side = 3},
                                                [&](const lantern::ray& r, const auto&) { return lab03::trace(world, r, 8); })
                              : lantern::render(size, camera, lantern::jittered{.side = 3}, plain);
    if (all) return made;
    // The number of the next step, in a corner.
    const glm::uvec2 corner = size / 5u;
    for (unsigned y = 0; y < corner.y; ++y)
        for (unsigned x = 0; x < corner.x; ++x)
            made(x, y) = support::test_card((glm::vec2(x, y) + 0.5f) / glm::vec2(corner), support::step_number(*missing.begin()));
    return made;
}

}  // namespace

int main(int argc, char** argv) try {
    const std::filesystem::path path = std::filesystem::path(argc > 1 ? argv[1] : "out") / "lab03.png";
    lantern::write_png(path, picture({640, 480}));
    std::cout << path.string() << '\n';
    for (const std::string& gap : missing) std::cout << "still to do: " << gap << '\n';
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
