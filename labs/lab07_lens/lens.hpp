// SPDX-License-Identifier: MIT
#pragma once
// Lab 07: a lens in front of the camera. The handout is README.md in this folder.

#include <lantern/ray.hpp>
#include <lantern/todo.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numbers>
#include <span>
#include <stdexcept>
#include <utility>

namespace lab07 {

/// Step 1. A point of the round lens, seen from its middle: uniform by area when xi is uniform in the unit square.
[[nodiscard]] inline glm::vec2 on_lens(glm::vec2 xi, float radius) {
    return lantern::todo("lab07 step 1: a point of the lens");
}

/// Step 2. The point that is in focus on the ray from the eye through a point of the film. The film stands at distance 1
/// before the eye; `film` says how far to the right and upwards, in scene units. The columns of `axes` are unit vectors
/// to the right, upwards and forward. The plane of focus stands parallel to the film, at the distance `focus` before the eye.
[[nodiscard]] inline glm::vec3 point_in_focus(glm::vec3 eye, const glm::mat3& axes, glm::vec2 film, float focus) {
    return lantern::todo("lab07 step 2: the point in focus");
}

/// Step 3. The ray from a point of the lens (step 1) to the point in focus (step 2), with a direction of length 1. The
/// lens is parallel to the film and its middle is the eye. A radius of 0 gives the ray of a pinhole, and `focus` may be infinite.
[[nodiscard]] inline lantern::ray through_lens(glm::vec3 eye, const glm::mat3& axes, glm::vec2 film, float radius, float focus,
                                               glm::vec2 xi) {
    return lantern::todo("lab07 step 3: a ray through the lens");
}

/// Step 4. The diameter of the circle of confusion: the disc on the film, at distance 1, over which the lens spreads the
/// light of a point at the distance `depth` before the eye. `focus` and `depth` may be infinite, but not both.
[[nodiscard]] inline float circle_of_confusion(float radius, float focus, float depth) {
    return lantern::todo("lab07 step 4: the circle of confusion");
}

/// Step 5. The nearest and the farthest depth whose circle of confusion is not larger than `diameter`. The farthest may be
/// infinite. A lens of radius 0 has everything in focus: (0, infinity).
[[nodiscard]] inline std::pair<float, float> depth_of_field(float radius, float focus, float diameter) {
    return lantern::todo("lab07 step 5: the depth of field");
}

/// Step 6. The light of a pixel: the mean over its samples. Sample i goes through film[i], a point of the film, and through the
/// lens where lens[i], a point of the unit square, says. Throws std::invalid_argument unless there are equally many of both.
[[nodiscard]] inline glm::vec3 pixel(glm::vec3 eye, const glm::mat3& axes, float radius, float focus, std::span<const glm::vec2> film,
                                     std::span<const glm::vec2> lens, const std::function<glm::vec3(lantern::ray)>& radiance) {
    return lantern::todo("lab07 step 6: a pixel, seen through the lens");
}

/// Step 7. A point of an aperture of straight blades: a regular polygon with `blades` corners (at least 3) at the distance
/// `radius` from its middle, the first of them to the right. Uniform by area when xi is uniform in the unit square.
[[nodiscard]] inline glm::vec2 on_blades(glm::vec2 xi, float radius, int blades) {
    return lantern::todo("lab07 step 7: an aperture with blades");
}

}  // namespace lab07
