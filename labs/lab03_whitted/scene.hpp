// SPDX-License-Identifier: MIT
#pragma once
// Whitted's picture of 1980: a sphere of glass and a mirror over a chequered floor.

#include <lab03_whitted/whitted.hpp>

#include <lantern/camera.hpp>

namespace lab03 {

[[nodiscard]] inline scene whitted_scene() {
    const matte yellow{.body = {0.85f, 0.7f, 0.1f}}, red{.body = {0.7f, 0.07f, 0.04f}};
    return {.things = {{lantern::rectangle{{-4, 0, 4}, {9, 0, 0}, {0, 0, -15}}, chequered{yellow, red}},
                       {lantern::sphere{{0.1f, 1.55f, 0.6f}, 0.95f}, glass{.index = 1.5f, .color = glm::vec3(0.98f)}},
                       {lantern::sphere{{1.3f, 1.0f, -1.5f}, 0.9f}, mirror{{0.85f, 0.85f, 0.85f}}},
                       {lantern::sphere{{-1.9f, 0.45f, -1.1f}, 0.45f}, matte{{0.1f, 0.3f, 0.7f}, glm::vec3(0.6f), 60}}},
            .lights = {{{-4, 9, 5}, glm::vec3(95)}},
            .ambient = glm::vec3(0.25f),
            .horizon = {0.45f, 0.65f, 0.95f},
            .zenith = {0.1f, 0.25f, 0.7f}};
}

[[nodiscard]] inline lantern::camera<> whitted_camera(glm::uvec2 size) {
    return lantern::camera<>{lantern::view{
        .eye = {0, 2.2f, 6.5f}, .target = {0.3f, 1.2f, 0}, .vertical_fov = 0.6f, .aspect = float(size.x) / float(size.y)}};
}

}  // namespace lab03
