// SPDX-License-Identifier: MIT
#pragma once
// Lab 06: glossy reflection and transmission. The handout is README.md in this folder.

#include <lantern/todo.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <functional>
#include <optional>
#include <span>

namespace lab06 {

/// Step 1. An orthonormal, right-handed basis whose third axis is r brought to length 1: the columns of the matrix are
/// U, V and W, with cross(U, V) = W. r may have any direction and any length but zero. Which U is taken is up to you.
[[nodiscard]] inline glm::mat3 basis(glm::vec3 r) {
    // BEGIN SOLUTION
    const glm::dvec3 w = glm::normalize(glm::dvec3(r));  // in double, the square of 1e-25 is not zero yet
    const glm::dvec3 size = glm::abs(w);
    const glm::dvec3 axis = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
                            : size.y <= size.z                   ? glm::dvec3(0, 1, 0)
                                                                 : glm::dvec3(0, 0, 1);
    const glm::dvec3 u = glm::normalize(glm::cross(axis, w));
    const glm::dvec3 v = glm::cross(w, u);
    return {glm::vec3(u), glm::vec3(v), glm::vec3(w)};
    // END SOLUTION
    // STARTER: return lantern::todo("lab06 step 1: a basis around r");
}

/// Step 2. The direction r, perturbed: it goes through a point of the square of side `width` that stands perpendicular
/// to r, one unit of length away. xi is a point of the unit square; (1/2, 1/2) gives r itself. The result has length 1,
/// and does not depend on the length of r.
[[nodiscard]] inline glm::vec3 perturb(glm::vec3 r, float width, glm::vec2 xi) {
    // BEGIN SOLUTION
    const glm::mat3 b = basis(r);
    const float u = -width / 2 + xi.x * width;
    const float v = -width / 2 + xi.y * width;
    return glm::normalize(b[2] + u * b[0] + v * b[1]);
    // END SOLUTION
    // STARTER: return lantern::todo("lab06 step 2: the perturbed ray");
}

/// Step 3. The direction in which a glossy surface reflects: `in`, mirrored, then perturbed. What comes out below the
/// surface is folded back to the upper side. `in` points to the surface; both vectors have length 1, and the normal is
/// the one on the side from which the ray comes.
[[nodiscard]] inline glm::vec3 reflected(glm::vec3 in, glm::vec3 normal, float width, glm::vec2 xi) {
    // BEGIN SOLUTION
    const glm::vec3 out = perturb(glm::reflect(in, normal), width, xi);
    const float height = glm::dot(out, normal);
    return height < 0 ? out - 2 * height * normal : out;
    // END SOLUTION
    // STARTER: return lantern::todo("lab06 step 3: the glossy reflection");
}

/// Step 4. The light that a glossy surface reflects: the mean over the points, each of which gives one reflected
/// direction. `radiance(direction)` says how much light comes from there. There is at least one point.
[[nodiscard]] inline glm::vec3 reflected_radiance(glm::vec3 in, glm::vec3 normal, float width, std::span<const glm::vec2> points,
                                                  const std::function<glm::vec3(glm::vec3 direction)>& radiance) {
    // BEGIN SOLUTION
    glm::vec3 sum{0};
    for (const glm::vec2 xi : points) sum += radiance(reflected(in, normal, width, xi));
    return sum / float(points.size());
    // END SOLUTION
    // STARTER: return lantern::todo("lab06 step 4: the mean over the lobe");
}

/// Step 5. The direction in which frosted glass lets a ray through: `in`, refracted, then perturbed; folded back where
/// it would come out again. Nothing beyond the critical angle. `eta` is the index of refraction on the side from which
/// the ray comes, divided by that of the other side; `in` and `normal` are as in step 3.
[[nodiscard]] inline std::optional<glm::vec3> transmitted(glm::vec3 in, glm::vec3 normal, float eta, float width, glm::vec2 xi) {
    // BEGIN SOLUTION
    const glm::vec3 inside = glm::refract(in, normal, eta);
    if (inside == glm::vec3(0)) return std::nullopt;  // so GLM says: total reflection
    const glm::vec3 out = perturb(inside, width, xi);
    const float height = glm::dot(out, normal);
    return height > 0 ? out - 2 * height * normal : out;
    // END SOLUTION
    // STARTER: lantern::todo("lab06 step 5: through frosted glass");
}

}  // namespace lab06
