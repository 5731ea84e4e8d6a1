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
    // BEGIN SOLUTION
    // Concentric squares become concentric circles: Shirley and Chiu 1997.
    const glm::vec2 p = 2.0f * xi - 1.0f;
    if (p.x == 0 && p.y == 0) return {0, 0};
    constexpr float quarter = std::numbers::pi_v<float> / 4;
    const bool sideways = std::abs(p.x) > std::abs(p.y);
    const float distance = sideways ? p.x : p.y;
    const float angle = sideways ? quarter * (p.y / p.x) : 2 * quarter - quarter * (p.x / p.y);
    return radius * distance * glm::vec2(std::cos(angle), std::sin(angle));
    // END SOLUTION
    // STARTER: return lantern::todo("lab07 step 1: a point of the lens");
}

/// Step 2. The point that is in focus on the ray from the eye through a point of the film. The film stands at distance 1
/// before the eye; `film` says how far to the right and upwards, in scene units. The columns of `axes` are unit vectors
/// to the right, upwards and forward. The plane of focus stands parallel to the film, at the distance `focus` before the eye.
[[nodiscard]] inline glm::vec3 point_in_focus(glm::vec3 eye, const glm::mat3& axes, glm::vec2 film, float focus) {
    // BEGIN SOLUTION
    return eye + focus * (axes * glm::vec3(film, 1));
    // END SOLUTION
    // STARTER: return lantern::todo("lab07 step 2: the point in focus");
}

/// Step 3. The ray from a point of the lens (step 1) to the point in focus (step 2), with a direction of length 1. The
/// lens is parallel to the film and its middle is the eye. A radius of 0 gives the ray of a pinhole, and `focus` may be infinite.
[[nodiscard]] inline lantern::ray through_lens(glm::vec3 eye, const glm::mat3& axes, glm::vec2 film, float radius, float focus,
                                               glm::vec2 xi) {
    // BEGIN SOLUTION
    const glm::vec2 l = on_lens(xi, radius);
    const glm::vec3 offset = l.x * axes[0] + l.y * axes[1];
    // Towards eye + f d, from eye + l, goes f d - l; and d - l / f, which holds for an infinite f too.
    return {eye + offset, glm::normalize(axes * glm::vec3(film, 1) - offset / focus)};
    // END SOLUTION
    // STARTER: return lantern::todo("lab07 step 3: a ray through the lens");
}

/// Step 4. The diameter of the circle of confusion: the disc on the film, at distance 1, over which the lens spreads the
/// light of a point at the distance `depth` before the eye. `focus` and `depth` may be infinite, but not both.
[[nodiscard]] inline float circle_of_confusion(float radius, float focus, float depth) {
    // BEGIN SOLUTION
    return 2 * radius * std::abs(1 / focus - 1 / depth);
    // END SOLUTION
    // STARTER: return lantern::todo("lab07 step 4: the circle of confusion");
}

/// Step 5. The nearest and the farthest depth whose circle of confusion is not larger than `diameter`. The farthest may be
/// infinite. A lens of radius 0 has everything in focus: (0, infinity).
[[nodiscard]] inline std::pair<float, float> depth_of_field(float radius, float focus, float diameter) {
    // BEGIN SOLUTION
    const float reach = diameter / (2 * radius);  // in 1 / depth, to both sides of 1 / focus
    const float nearest = 1 / (1 / focus + reach);
    const float farthest = reach < 1 / focus ? 1 / (1 / focus - reach) : std::numeric_limits<float>::infinity();
    return {nearest, farthest};
    // END SOLUTION
    // STARTER: return lantern::todo("lab07 step 5: the depth of field");
}

/// Step 6. The light of a pixel: the mean over its samples. Sample i goes through film[i], a point of the film, and through the
/// lens where lens[i], a point of the unit square, says. Throws std::invalid_argument unless there are equally many of both.
[[nodiscard]] inline glm::vec3 pixel(glm::vec3 eye, const glm::mat3& axes, float radius, float focus, std::span<const glm::vec2> film,
                                     std::span<const glm::vec2> lens, const std::function<glm::vec3(lantern::ray)>& radiance) {
    // BEGIN SOLUTION
    if (film.size() != lens.size()) throw std::invalid_argument("pixel: each point of the film needs one point of the lens");
    glm::vec3 sum{0};
    for (std::size_t i = 0; i < film.size(); ++i) sum += radiance(through_lens(eye, axes, film[i], radius, focus, lens[i]));
    return sum / float(film.size());
    // END SOLUTION
    // STARTER: return lantern::todo("lab07 step 6: a pixel, seen through the lens");
}

/// Step 7. A point of an aperture of straight blades: a regular polygon with `blades` corners (at least 3) at the distance
/// `radius` from its middle, the first of them to the right. Uniform by area when xi is uniform in the unit square.
[[nodiscard]] inline glm::vec2 on_blades(glm::vec2 xi, float radius, int blades) {
    // BEGIN SOLUTION
    // xi.x chooses one of the triangles from the middle to an edge; what is left of it is a fresh number.
    const float scaled = xi.x * float(blades);
    const float which = std::fmin(std::floor(scaled), float(blades - 1));
    const auto corner = [&](float i) {
        const float angle = 2 * std::numbers::pi_v<float> * i / float(blades);
        return radius * glm::vec2(std::cos(angle), std::sin(angle));
    };
    const float outwards = std::sqrt(scaled - which);
    return outwards * glm::mix(corner(which), corner(which + 1), xi.y);
    // END SOLUTION
    // STARTER: return lantern::todo("lab07 step 7: an aperture with blades");
}

}  // namespace lab07
