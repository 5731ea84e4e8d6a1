// SPDX-License-Identifier: MIT
#pragma once
// What a surface is: anything a ray can be intersected with.

#include <lantern/interval.hpp>
#include <lantern/ray.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>

namespace lantern {

/// Where a ray meets a surface.
struct hit {
    float t = 0;           ///< the ray's parameter, in units of the length of its direction
    glm::vec3 point{0};    ///< the meeting point, brought back onto the surface; nearer to it than at(ray, t)
    glm::vec3 normal{0};   ///< geometric normal, unit length; points out of closed surfaces, whatever side was hit
    float error = 0;       ///< bounds the distance from `point`, before it was rounded to float, to the surface
};

/// A surface says where a ray meets it first within a range; a miss is nullopt. A user's own type becomes a surface
/// when an `intersect` is found beside it (argument-dependent lookup). `Ray` is `timed_ray` for moving surfaces.
template <class S, class Ray = ray>
concept surface = requires(const S& s, const Ray& r, interval range) {
    { intersect(s, r, range) } -> std::same_as<std::optional<hit>>;
};

/// One unit in the last place of |x|: the distance to the next float away from zero. x must be finite.
[[nodiscard]] inline float ulp(float x) {
    const float magnitude = std::min(std::abs(x), std::numeric_limits<float>::max() / 2);
    return std::bit_cast<float>(std::bit_cast<std::uint32_t>(magnitude) + 1) - magnitude;  // nextafter, without the call
}

/// The origin of a ray that leaves a hit towards `direction`: the hit point, stepped off the surface along its
/// normal, to the side that `direction` points to. The step is the error bound of the hit and two ulp of the point's
/// largest coordinate: rounding the point and the sum moves them by at most .87 ulp each (half of an ulp along each
/// axis), hence the new origin is on its own side of the surface at any scale of the scene. No epsilon is absolute.
[[nodiscard]] inline glm::vec3 leave(const hit& h, glm::vec3 direction) {
    const float largest = std::max(std::max(std::abs(h.point.x), std::abs(h.point.y)), std::abs(h.point.z));
    const float step = 2 * ulp(largest) + h.error;
    return h.point + (glm::dot(direction, h.normal) < 0 ? -step : step) * h.normal;
}

}  // namespace lantern
