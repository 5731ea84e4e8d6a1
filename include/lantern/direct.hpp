// SPDX-License-Identifier: MIT
#pragma once
// Direct light: what one light adds at a hit, and the shadow ray that decides.

#include <lantern/closest.hpp>
#include <lantern/interval.hpp>
#include <lantern/light.hpp>
#include <lantern/material.hpp>
#include <lantern/ray.hpp>
#include <lantern/samples.hpp>
#include <lantern/surface.hpp>

#include <glm/vec3.hpp>

#include <concepts>
#include <cstdint>

namespace lantern {

/// What a light brings to a point that r has found; `which` tells the lights' numbers apart. It draws what the light needs.
template <light Kind, class Ray, sample_source Source>
[[nodiscard]] illumination illumination_from(const Kind& light, std::uint32_t which, const Ray& r, glm::vec3 point,
                                             const Source& source) {
    static_assert(still_light<Kind> || std::derived_from<Ray, timed_ray>, "a moving light needs a camera with a shutter");
    if constexpr (point_like<Kind>) return illuminate(light, point);
    else if constexpr (sampled_light<Kind>) return illuminate(light, point, source.draw2(purpose::light, which));
    else if constexpr (moving_point_light<Kind>) return illuminate(light, point, r.time);
    else return illuminate(light, point, source.draw2(purpose::light, which), r.time);
}

/// Whether a surface stands between a hit and a light. `out` is the unit direction from the hit to the light's position.
/// The shadow ray begins at the hit, stepped off its surface, and keeps the time of r.
template <class Accelerator, class Things, class Ray>
[[nodiscard]] bool shadowed(const Accelerator& structure, const Things& things, const Ray& r, const hit& h, glm::vec3 out,
                            glm::vec3 position) {
    const glm::vec3 origin = leave(h, out);
    return occluded(structure, things, continued(r, origin, position - origin), interval{0, 1});
}

/// The radiance that `material` sends back along r when lit by `light`, or nothing if a surface is in the way. No shadow
/// ray is shot where the material has no answer to give.
template <class Accelerator, class Things, class Ray, reflects_light Material>
[[nodiscard]] glm::vec3 direct_light(const Accelerator& structure, const Things& things, const Ray& r, glm::vec3 in,
                                     const hit& h, const Material& m, const illumination& light) {
    if (light.irradiance == glm::vec3(0)) return glm::vec3(0);
    const glm::vec3 out = unit(light.position - h.point);
    const glm::vec3 answer = evaluate(m, in, h, out) * light.irradiance;
    if (answer == glm::vec3(0)) return answer;
    return shadowed(structure, things, r, h, out, light.position) ? glm::vec3(0) : answer;
}

}  // namespace lantern
