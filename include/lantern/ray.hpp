// SPDX-License-Identifier: MIT
#pragma once
// A ray, and a ray that knows its time.

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace lantern {

/// The half-line origin + t * direction, t > 0. The direction need not have unit length: t counts in units of it.
struct ray {
    glm::vec3 origin{0};
    glm::vec3 direction{0, 0, -1};
};

/// A ray shot at one moment: 0 and 1 are the beginning and the end of what moves in a scene, and a shutter is open for all
/// of that or for a part. Only a camera with a shutter shoots these, and only they can meet a moving surface.
struct timed_ray : ray {
    float time = 0;
};

/// v / |v|, in double: neither 1e-30 nor 1e30 is lost on the way. NaN for the zero vector, which has no direction.
[[nodiscard]] inline glm::vec3 unit(glm::vec3 v) {
    const glm::dvec3 d(v);
    return glm::vec3(d / glm::length(d));
}

[[nodiscard]] inline glm::vec3 at(const ray& r, float t) { return r.origin + t * r.direction; }

/// The ray that goes on from a point: a shadow, reflected or refracted ray keeps the time of the ray that caused it.
[[nodiscard]] inline ray continued(const ray&, glm::vec3 origin, glm::vec3 direction) { return {origin, direction}; }
[[nodiscard]] inline timed_ray continued(const timed_ray& r, glm::vec3 origin, glm::vec3 direction) {
    return {{origin, direction}, r.time};
}

}  // namespace lantern
