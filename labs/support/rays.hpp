// SPDX-License-Identifier: MIT
#pragma once
// What a recorder has heard, as a tree: from which ray each ray comes, and why it was sent.

#include "recorder.hpp"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace support {

/// What ./lab explain knows of a scene, besides what the rays ask.
struct world {
    struct thing {
        figure shape;
        std::string name, material;
        glm::vec3 color{0.5f};
    };
    struct lamp {
        figure shape;  ///< a sphere of radius 0 is a point
        std::string name;
    };
    glm::vec3 eye{0};
    std::vector<thing> things{};
    std::vector<lamp> lamps{};
    std::optional<float> floor{};  ///< the height of a floor that the scene's code meets by itself, behind all its surfaces
    float floor_ends = lantern::infinity;  ///< no t as large meets it
    std::string beyond = "the sky";
    bool matt = false;  ///< a ray that goes on was drawn, not mirrored
};

/// A ray's place in the tree.
struct place {
    std::ptrdiff_t parent = -1;  ///< the ray that it goes on from; -1 for none
    std::string why;             ///< camera, shadow, reflected, refracted or bounced
    float gap = 0;               ///< how far from the parent's hit it starts
};

/// Meets the floor, where the scene has one and it is nearer than what was met.
inline void add_floor(asked& a, const world& w) {
    if (!w.floor || std::isfinite(a.range.max)) return;  // a shadow ray does not ask for it
    const float t = (*w.floor - a.ray.origin.y) / a.ray.direction.y;
    if (!contains(a.range, t) || t >= w.floor_ends || (a.met && a.met->t <= t)) return;
    glm::vec3 point = at(a.ray, t);
    point.y = *w.floor;
    a.met = lantern::hit{.t = t, .point = point, .normal = {0, 1, 0}};
    a.what = level_at(*w.floor);
}

/// A shadow ray is one that asks about a stretch that ends, or that goes straight to a lamp which is a point.
[[nodiscard]] inline bool asks_for_light(const asked& a, const world& w) {
    if (std::isfinite(a.range.max)) return true;
    for (const world::lamp& l : w.lamps) {
        if (l.shape.kind != "sphere" || l.shape.numbers[3] != 0) continue;
        const glm::vec3 to = glm::vec3(l.shape.numbers[0], l.shape.numbers[1], l.shape.numbers[2]) - a.ray.origin;
        const float along = glm::dot(to, a.ray.direction);
        if (along > 0 && glm::length(glm::cross(to, a.ray.direction)) <= 1e-4f * along) return true;
    }
    return false;
}

/// What starts where the first ray does comes from the camera. Any other ray goes on from the hit that is nearest to where it starts; of several, from the last. On the side from which the ray before it
/// came it is reflected, on the other one refracted.
[[nodiscard]] inline std::vector<place> tree_of(const std::vector<asked>& rays, const world& w) {
    std::vector<place> all(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        place& here = all[i];
        here.why = "camera";
        if (rays[i].ray.origin == rays[0].ray.origin) continue;
        for (std::size_t k = 0; k < i; ++k) {
            if (!rays[k].met || all[k].why == "shadow") continue;
            const float gap = glm::distance(rays[i].ray.origin, rays[k].met->point);
            if (here.parent < 0 || gap <= here.gap) here.parent = std::ptrdiff_t(k), here.gap = gap;
        }
        if (asks_for_light(rays[i], w)) {
            here.why = "shadow";
        } else if (here.parent >= 0) {
            const asked& before = rays[std::size_t(here.parent)];
            const glm::vec3 n = before.met->normal;
            const bool other_side = glm::dot(before.ray.direction, n) * glm::dot(rays[i].ray.direction, n) > 0;
            here.why = other_side ? "refracted" : w.matt ? "bounced" : "reflected";
        }
    }
    return all;
}

}  // namespace support
