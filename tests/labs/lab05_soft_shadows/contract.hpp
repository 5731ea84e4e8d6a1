// SPDX-License-Identifier: MIT
#pragma once
// What lab 05 asks for.

#include <contract.hpp>

#include <lantern/rectangle.hpp>
#include <lantern/sphere.hpp>
#include <lantern/surface.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace contract::lab05 {

struct lamp {
    glm::vec3 corner{0}, edge_u{1, 0, 0}, edge_v{0, 0, 1}, radiance{1};
};

struct scene {
    std::vector<lantern::sphere> balls;
    std::vector<lantern::rectangle> walls;
};

inline constexpr function<"point_on", glm::vec3(lamp, glm::vec2 xi)> point_on;
inline constexpr function<"irradiance", glm::vec3(lamp, glm::vec3 on_lamp, glm::vec3 position, glm::vec3 normal)> irradiance;
inline constexpr function<"visible", bool(lantern::hit from, glm::vec3 on_lamp, scene)> visible;
inline constexpr function<"soft_light", glm::vec3(lamp, lantern::hit at, scene, std::span<const glm::vec2> points)> soft_light;
inline constexpr function<"solid_angle", float(glm::vec3 center, float radius, glm::vec3 from)> solid_angle;
inline constexpr function<"towards_ball", glm::vec3(glm::vec3 center, float radius, glm::vec3 from, glm::vec2 xi)> towards_ball;

}  // namespace contract::lab05
