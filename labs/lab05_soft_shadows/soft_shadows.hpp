// SPDX-License-Identifier: MIT
#pragma once
// Lab 05: lights with area, and the shadows that they cast. The handout is README.md in this folder.

#include <lantern/basis.hpp>
#include <lantern/interval.hpp>
#include <lantern/ray.hpp>
#include <lantern/rectangle.hpp>
#include <lantern/sphere.hpp>
#include <lantern/surface.hpp>
#include <lantern/todo.hpp>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

namespace lab05 {

/// Given: a lamp is a parallelogram from `corner` along two edges. It shines to the side of edge_u × edge_v, with the same
/// radiance in all directions and from all of its points.
struct lamp {
    glm::vec3 corner{0};
    glm::vec3 edge_u{1, 0, 0};
    glm::vec3 edge_v{0, 0, 1};
    glm::vec3 radiance{1};
};

/// Given: what may stand in the way of light.
struct scene {
    std::vector<lantern::sphere> balls;
    std::vector<lantern::rectangle> walls;
};

/// Given: whether the ray meets anything at a t within the range (t > range.min and t <= range.max). t counts in units of
/// the length of the ray's direction.
[[nodiscard]] inline bool blocked(const scene& s, const lantern::ray& r, lantern::interval range) {
    const auto meets = [&](const auto& surface) { return intersect(surface, r, range).has_value(); };
    return std::ranges::any_of(s.balls, meets) || std::ranges::any_of(s.walls, meets);
}

/// Step 1. The point of the lamp that a point xi of the unit square is carried to: (0, 0) to the corner, (1, 0) to the end of
/// edge_u, and evenly in between.
[[nodiscard]] inline glm::vec3 point_on(const lamp& l, glm::vec2 xi) {
    return lantern::todo("lab05 step 1: a point on the lamp");
}

/// Step 2. The irradiance at `position` on a surface with this unit normal, estimated from one point of the lamp, which
/// stands for the whole: L A cos θ cos θ' / d². Nothing arrives from behind the surface, and nothing leaves the lamp's back.
[[nodiscard]] inline glm::vec3 irradiance(const lamp& l, glm::vec3 on_lamp, glm::vec3 position, glm::vec3 normal) {
    return lantern::todo("lab05 step 2: what one point of the lamp stands for");
}

/// Step 3. Whether nothing stands between a hit and a point of a lamp. `lantern::leave(hit, direction)` gives an origin that
/// is just off the hit's surface, on the side that the direction points to.
[[nodiscard]] inline bool visible(const lantern::hit& from, glm::vec3 on_lamp, const scene& s) {
    return lantern::todo("lab05 step 3: the shadow ray");
}

/// Step 4. The irradiance at a hit: the mean over the lamp's points that the given points of the unit square are carried to,
/// where those that are hidden bring nothing. No points, no light.
[[nodiscard]] inline glm::vec3 soft_light(const lamp& l, const lantern::hit& at, const scene& s,
                                          std::span<const glm::vec2> points) {
    return lantern::todo("lab05 step 4: the mean over the lamp");
}

/// Step 5. The solid angle under which a point outside sees a ball, in steradians; accurate for balls of any size and
/// distance, a ball of radius 1 at the distance 10000 too.
[[nodiscard]] inline float solid_angle(glm::vec3 center, float radius, glm::vec3 from) {
    return lantern::todo("lab05 step 5: how large a ball looks");
}

/// Step 6. A unit direction towards the ball, uniform in the cone that just holds it: xi.x says how far from the cone's
/// axis, from 0 on the axis to 1 at the border, and xi.y how far round it. `lantern::basis_from(w)` has unit vectors u, v and w.
[[nodiscard]] inline glm::vec3 towards_ball(glm::vec3 center, float radius, glm::vec3 from, glm::vec2 xi) {
    return lantern::todo("lab05 step 6: a direction towards the ball");
}

}  // namespace lab05
