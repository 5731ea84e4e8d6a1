// SPDX-License-Identifier: MIT
#pragma once
// The scene of the leave-out proofs: four balls under a lamp, in types that are large enough for every effect.

#include <lantern/any_of.hpp>
#include <lantern/camera.hpp>
#include <lantern/diffuse.hpp>
#include <lantern/glossy.hpp>
#include <lantern/light.hpp>
#include <lantern/mirror.hpp>
#include <lantern/moving.hpp>
#include <lantern/object.hpp>
#include <lantern/sphere.hpp>
#include <lantern/sphere_light.hpp>
#include <lantern/trim.hpp>

#include <glm/vec3.hpp>

#include <variant>
#include <vector>

namespace trim_scene {

using shape = lantern::any_of<lantern::sphere, lantern::moving<lantern::sphere>>;
using material = std::variant<lantern::diffuse, lantern::mirror, lantern::glossy>;
using light = std::variant<lantern::point_light, lantern::sphere_light>;
using thing = lantern::object<shape, material>;
using everything = lantern::ingredients<thing, light>;

/// What the scene has of each effect. The types have all of them, whatever is asked for.
struct effects {
    bool lens = false, motion = false, gloss = false, soft = false;
};

/// At most three bounces, as in all kernels that are compared.
inline constexpr std::uint32_t depth = 3;

[[nodiscard]] inline everything of(const effects& on) {
    const lantern::sphere ball{{0.6f, 1.1f, 0.9f}, 0.35f};
    const glm::vec3 way = on.motion ? glm::vec3(0.5f, 0.2f, 0) : glm::vec3(0);
    everything s;
    s.things = {{lantern::sphere{{0, -1000, 0}, 1000}, lantern::diffuse{{0.5f, 0.5f, 0.45f}}},
                {lantern::sphere{{-0.8f, 0.7f, 0}, 0.7f}, lantern::glossy{.color = {0.9f, 0.8f, 0.6f}, .width = on.gloss ? 0.2f : 0.0f}},
                {lantern::sphere{{0.9f, 0.5f, -0.4f}, 0.5f}, lantern::mirror{glm::vec3(0.85f)}},
                {lantern::moving{ball, way}, lantern::diffuse{{0.7f, 0.2f, 0.15f}}}};
    const glm::vec3 lamp(2, 5, 3);
    if (on.soft) s.lights = {lantern::sphere_light{lamp, 0.8f, glm::vec3(20)}};
    else s.lights = {lantern::point_light{lamp, glm::vec3(40)}};
    s.from = {.eye = {0, 1.5f, 5}, .target = {0, 0.6f, 0}};
    s.lens = {.radius = on.lens ? 0.1f : 0.0f, .focus_distance = 5};
    return s;
}

}  // namespace trim_scene
