// SPDX-License-Identifier: MIT
#pragma once
// Lab 03's picture: Whitted's spheres, as far as the student's code goes. What is not written yet is replaced by something plain.

#include "../support/gaps.hpp"

#include "scene.hpp"

#include <lab03_whitted/whitted.hpp>

#include <lantern/ray.hpp>
#include <lantern/samples.hpp>
#include <lantern/surface.hpp>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace pictures {

inline constexpr glm::uvec2 size{640, 480};
inline constexpr lantern::jittered samples{.side = 3};

/// The light along a ray.
class shade {
public:
    explicit shade(support::gaps& gaps)
        : shading_(gaps.is_written([] { return lab03::shade({}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}); })),
          shadows_(gaps.is_written([] { return lab03::lit({}, {}, {0, 1, 0}); })),
          mirrors_(gaps.is_written([] { return lab03::reflected({0, -1, 0}, {0, 1, 0}); })) {
        gaps.is_written([] { return lab03::refracted({0, -1, 0}, {0, 1, 0}, 1); });
        gaps.is_written([] { return lab03::reflectance(1, 1); });
        whole_ = gaps.is_written([&] { return lab03::trace(scene, {{0, 9, 0}, {0, 1, 0}}, 1); }) && gaps.none();
    }

    [[nodiscard]] bool is_whole() const { return whole_; }

    glm::vec3 operator()(const lantern::ray& r, const auto&...) const { return whole_ ? lab03::trace(scene, r, 8) : preview(r, mirrors_); }

    lab03::scene scene = lab03::whitted_scene();

private:
    /// Until step 6 is done: nothing is followed, and every material is matt. Uses the steps that are there.
    glm::vec3 preview(const lantern::ray& r, bool follow) const {
        const auto h = lab03::closest(scene, r);
        if (!h) return lab03::sky(scene, r.direction);
        const lab03::material& m = scene.things[h->index].material;
        const auto found = lab03::matte_at(m, h->point);
        if (!found && follow) {
            const glm::vec3 onwards = lab03::reflected(r.direction, h->normal);
            return 0.85f * preview({lantern::leave(*h, onwards), onwards}, false);
        }
        const lab03::matte surface = found.value_or(lab03::matte{.highlight = glm::vec3(0.5f)});
        glm::vec3 sum = (shading_ ? scene.ambient : glm::vec3(0.5f)) * surface.body;
        for (const lab03::light& l : scene.lights) {
            const glm::vec3 to_light = l.position - h->point;
            if (!shading_ || (shadows_ && !lab03::lit(scene, *h, l.position))) continue;
            sum += l.intensity / glm::dot(to_light, to_light) *
                   lab03::shade(surface, h->normal, glm::normalize(to_light), -r.direction);
        }
        return sum;
    }

    bool shading_, shadows_, mirrors_, whole_ = false;
};

}  // namespace pictures
