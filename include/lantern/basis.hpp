// SPDX-License-Identifier: MIT
#pragma once
// An orthonormal basis from one direction.

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace lantern {

/// Three unit vectors, perpendicular to each other, right-handed: u × v = w.
struct basis {
    glm::vec3 u{1, 0, 0};
    glm::vec3 v{0, 1, 0};
    glm::vec3 w{0, 0, 1};
};

/// A basis whose w points along the given vector, of any length; the frame of the axes when it is zero or not finite.
/// Duff et al., "Building an orthonormal basis, revisited", JCGT 6(1), 2017. That formula multiplies an error of w's length
/// into u and v, hence w is normalised first, in double and scaled by its largest component, so that no length is too
/// short or too long.
[[nodiscard]] inline basis basis_from(glm::vec3 w) {
    const double scale = std::max({std::abs(w.x), std::abs(w.y), std::abs(w.z)});
    const glm::dvec3 scaled = glm::dvec3(w) / scale;
    const glm::dvec3 n = scaled / glm::length(scaled);
    if (!(glm::dot(n, n) > 0)) return {};
    const double sign = std::copysign(1.0, n.z);
    const double a = -1 / (sign + n.z), b = n.x * n.y * a;
    return {glm::vec3(glm::dvec3(1 + sign * n.x * n.x * a, sign * b, -sign * n.x)),
            glm::vec3(glm::dvec3(b, sign + n.y * n.y * a, -n.y)), glm::vec3(n)};
}

/// From coordinates in the basis to the world.
[[nodiscard]] inline glm::vec3 to_world(const basis& b, glm::vec3 local) {
    return local.x * b.u + local.y * b.v + local.z * b.w;
}

}  // namespace lantern
