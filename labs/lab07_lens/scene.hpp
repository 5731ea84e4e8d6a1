// SPDX-License-Identifier: MIT
#pragma once
// The garden of lab 07: painted balls one behind the other on a chequered floor, and strings of lamps far behind them.

#include <lantern/interval.hpp>
#include <lantern/ray.hpp>
#include <lantern/sphere.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <cmath>
#include <vector>

namespace garden {

struct ball {
    lantern::sphere shape;
    glm::vec3 color{1};
    bool lamp = false;
};

/// Where the camera stands: its axes point to the right, upwards and forward.
struct stand {
    glm::vec3 eye{0, 1.5f, 6};
    glm::mat3 axes = towards({0, 0.75f, 0});

    [[nodiscard]] glm::mat3 towards(glm::vec3 target) const {
        const glm::vec3 forward = glm::normalize(target - eye), right = glm::normalize(glm::cross(forward, glm::vec3(0, 1, 0)));
        return {right, glm::cross(right, forward), forward};
    }
    [[nodiscard]] float depth(glm::vec3 p) const { return glm::dot(p - eye, axes[2]); }
};

inline std::vector<ball> balls() {
    const glm::vec3 paints[]{{0.8f, 0.07f, 0.05f}, {0.9f, 0.5f, 0.03f}, {0.1f, 0.45f, 0.1f}, {0.04f, 0.22f, 0.6f}, {0.45f, 0.1f, 0.5f}};
    std::vector<ball> all;
    for (int i = 0; i < 5; ++i) all.push_back({{{-1.5f + 0.85f * float(i), 0.5f, 3.2f - 2.6f * float(i) - 0.35f * float(i * i)}, 0.5f}, paints[i]});
    for (int string = 0; string < 2; ++string)
        for (int i = 0; i < 8; ++i) {
            const float x = -9 + 2.6f * float(i) + 1.3f * float(string), sag = (float(i) - 3.5f) * (float(i) - 3.5f) / 12;
            const glm::vec3 glass = glm::mix(glm::vec3(1, 0.7f, 0.4f), paints[(2 * i + string) % 5], 0.45f);
            all.push_back({{{x, 1.9f + 1.5f * float(string) + 0.8f * sag, -22 - 3 * float(string)}, 0.2f}, 8.0f * glass, true});
        }
    return all;
}

/// The light along a ray: dusk, and a soft light from above.
inline glm::vec3 radiance(const std::vector<ball>& all, const lantern::ray& r) {
    lantern::interval range;
    const ball* nearest = nullptr;
    lantern::hit h;
    for (const ball& b : all)
        if (const auto found = intersect(b.shape, r, range)) {
            nearest = &b;
            h = *found;
            range.max = h.t;
        }
    const float t = -r.origin.y / r.direction.y;
    const glm::vec3 dusk{0.12f, 0.14f, 0.2f};
    if (contains(range, t)) {
        const glm::vec3 p = at(r, t);
        float open = 1;
        for (const ball& b : all) {
            const glm::vec3 to = b.shape.center - p;
            const float distance = glm::length(to), sine = b.shape.radius / distance;
            open *= 1 - glm::clamp(sine * sine * to.y / distance, 0.0f, 1.0f);
        }
        const bool light = (int(std::floor(p.x)) + int(std::floor(p.z))) % 2 == 0;
        const float far = glm::clamp((glm::length(p) - 10) / 25, 0.0f, 1.0f);
        return glm::mix(open * (light ? glm::vec3(0.55f, 0.5f, 0.42f) : glm::vec3(0.08f, 0.08f, 0.1f)), dusk, far);
    }
    if (!nearest) return glm::mix(dusk, glm::vec3(0.01f, 0.015f, 0.05f), std::sqrt(glm::clamp(r.direction.y * 3, 0.0f, 1.0f)));
    if (nearest->lamp) return nearest->color;
    const float gloss = std::pow(glm::clamp(glm::dot(glm::reflect(r.direction, h.normal), glm::normalize(glm::vec3(-1, 2, 1.5f))), 0.0f, 1.0f), 60.0f);
    return nearest->color * (0.25f + 0.75f * (0.5f + 0.5f * h.normal.y)) + 0.9f * gloss;
}

}  // namespace garden
