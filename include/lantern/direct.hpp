// SPDX-License-Identifier: MIT
#pragma once
// Direct light: what one light adds at a hit, and the shadow ray that decides.

#include <lantern/closest.hpp>
#include <lantern/interval.hpp>
#include <lantern/light.hpp>
#include <lantern/material.hpp>
#include <lantern/ray.hpp>
#include <lantern/surface.hpp>

#include <glm/vec3.hpp>

namespace lantern {

/// The radiance that `material` sends back along r when lit by `light`, or nothing if a surface is in the way. The
/// shadow ray runs from the hit, stepped off its surface, to the light's position; it keeps the time of r, and it is
/// not shot at all where the material has no answer to give.
template <class Accelerator, class Things, class Ray, reflects_light Material>
[[nodiscard]] glm::vec3 direct_light(const Accelerator& structure, const Things& things, const Ray& r, glm::vec3 in,
                                     const hit& h, const Material& m, const illumination& light) {
    if (light.irradiance == glm::vec3(0)) return glm::vec3(0);
    const glm::vec3 out = unit(light.position - h.point);
    const glm::vec3 answer = evaluate(m, in, h, out) * light.irradiance;
    if (answer == glm::vec3(0)) return answer;
    const glm::vec3 origin = leave(h, out);
    const auto shadow = continued(r, origin, light.position - origin);
    return occluded(structure, things, shadow, interval{0, 1}) ? glm::vec3(0) : answer;
}

}  // namespace lantern
