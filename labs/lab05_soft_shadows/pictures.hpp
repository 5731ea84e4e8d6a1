// SPDX-License-Identifier: MIT
#pragma once
// Lab 05's pictures: a table under a lamp, lit in three ways.

#include <lab05_soft_shadows/soft_shadows.hpp>

#include <lantern/camera.hpp>
#include <lantern/samples.hpp>
#include <lantern/surface.hpp>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace pictures {

inline constexpr glm::uvec2 size{320, 320};
inline constexpr lantern::jittered samples{.side = 4};
inline constexpr glm::vec3 eye{0, 2.1f, 4.2f}, lamp_middle{-0.9f, 3.2f, 0.6f};
inline constexpr float ball_of_light = 0.35f;  // its radius

inline const lantern::camera<> camera{lantern::view{.eye = eye, .target = {0, 0.35f, 0}, .vertical_fov = 0.62f}};
inline const lab05::lamp lamp{lamp_middle + glm::vec3(0.6f, 0, -0.6f), {0, 0, 1.2f}, {-1.2f, 0, 0}, glm::vec3(12, 11.5f, 10)};

/// What there is, and its colours: first the balls, then the walls.
struct room {
    lab05::scene table{{{{0.1f, 0.5f, 0}, 0.5f}, {{-0.95f, 0.25f, 0.75f}, 0.25f}, {{1.15f, 0.2f, 0.55f}, 0.2f}},
                       {{{-6, 0, 6}, {12, 0, 0}, {0, 0, -12}}, {{0.75f, 0, -0.6f}, {0.5f, 0, 0.35f}, {0, 1.3f, 0}}}};
    std::vector<glm::vec3> colors{{0.75f, 0.3f, 0.2f}, {0.25f, 0.45f, 0.7f}, {0.8f, 0.65f, 0.25f}, {0.62f, 0.6f, 0.57f}, {0.5f, 0.6f, 0.4f}};
};

struct seen {
    lantern::hit hit;
    glm::vec3 color;
};

inline std::optional<seen> nearest(const room& in, const lantern::ray& r) {
    std::optional<seen> best;
    std::size_t i = 0;
    const auto meet = [&](const auto& surface) {
        const auto h = intersect(surface, r, {0, best ? best->hit.t : lantern::infinity});
        if (h) best = seen{*h, in.colors[i]};
        ++i;
    };
    for (const auto& ball : in.table.balls) meet(ball);
    for (const auto& wall : in.table.walls) meet(wall);
    if (best && glm::dot(best->hit.normal, r.direction) > 0) best->hit.normal = -best->hit.normal;
    return best;
}

/// One ray to the middle of the lamp: a hard shadow.
inline constexpr auto hard = [](const room& in, const lantern::hit& h, const auto&) {
    const glm::vec3 middle = lab05::point_on(lamp, {0.5f, 0.5f});
    const glm::vec3 light = lab05::irradiance(lamp, middle, h.point, h.normal);
    return lab05::visible(h, middle, in.table) ? light : glm::vec3(0);
};

/// One point of the lamp for each of the pixel's sixteen samples: the mean over the pixel is the mean over the lamp too.
inline constexpr auto soft = [](const room& in, const lantern::hit& h, const auto& source) {
    const glm::vec2 point = source.draw2(lantern::purpose::light);
    return lab05::soft_light(lamp, h, in.table, {&point, 1});
};

/// A ball of light instead, as bright from the front.
inline constexpr auto round = [](const room& in, const lantern::hit& h, const auto& source) {
    const glm::vec3 d = lab05::towards_ball(lamp_middle, ball_of_light, h.point, source.draw2(lantern::purpose::light));
    const float cosine = glm::dot(d, h.normal), distance = glm::length(lamp_middle - h.point);
    if (!(cosine > 0)) return glm::vec3(0);
    const glm::vec3 light = glm::vec3(40) * (lab05::solid_angle(lamp_middle, ball_of_light, h.point) * cosine);
    return lab05::visible(h, h.point + (distance - ball_of_light) * d, in.table) ? light : glm::vec3(0);
};

/// The light along a ray, when light(room, hit, source) comes from the lamp.
template <class Light>
struct shade {
    const room& in;
    Light light;

    glm::vec3 operator()(const lantern::ray& r, const auto& source) const {
        const auto found = nearest(in, r);
        if (!found) return glm::vec3(0.02f);
        return found->color / 3.14159265f * light(in, found->hit, source) + 0.02f * found->color;
    }
};

}  // namespace pictures
