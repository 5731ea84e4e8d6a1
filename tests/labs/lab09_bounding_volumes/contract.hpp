// SPDX-License-Identifier: MIT
#pragma once
// What lab 09 asks for.

#include <contract.hpp>

#include <lantern/interval.hpp>
#include <lantern/ray.hpp>
#include <lantern/surface.hpp>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace contract::lab09 {

/// As the student's box, sphere and oriented_box.
struct upright {
    glm::vec3 min, max;
};
struct round {
    glm::vec3 center;
    float radius;
};
struct tilted {
    glm::vec3 center;
    std::array<glm::vec3, 3> axes;
    glm::vec3 half;
};
using volume = std::variant<upright, round, tilted>;

using points = std::span<const glm::vec3>;
using lantern::interval;
using lantern::ray;

/// Does the ray meet the volume within the range?
struct question {
    volume asked;
    ray along;
    interval range;
};

inline constexpr function<"box_around", upright(points)> box_of_points;
inline constexpr function<"box_around_sphere", upright(round)> box_of_sphere;
inline constexpr function<"enclose", upright(upright, upright)> box_of_boxes;
inline constexpr function<"surface_area", double(volume)> area;
/// Many at once: in grading each call is a message.
inline constexpr function<"overlaps", std::vector<bool>(std::span<const question>)> meets;
inline constexpr function<"sphere_around", round(points)> sphere_of_points;
inline constexpr function<"oriented_box_around", tilted(points)> oriented_box_of_points;
inline constexpr function<"transformed_box", upright(glm::mat3 m, glm::vec3 shift, upright)> transformed_box;
inline constexpr function<"transformed_sphere", round(glm::mat3 m, glm::vec3 shift, round)> transformed_sphere;
inline constexpr function<"smallest_sphere", round(points)> smallest_sphere_of_points;

/// A surface in one volume, or in two, of which number 0 is the outer one. All answers are the suite's: what volume i says of a ray and
/// a range, and what the surface says of them.
using volume_says = std::function<bool(std::uint32_t i, ray, interval)>;
using surface_says = std::function<std::optional<lantern::hit>(ray, interval)>;
inline constexpr function<"bounded", std::optional<lantern::hit>(volume_says, surface_says, ray, interval)> behind_one;
inline constexpr function<"bounded_twice", std::optional<lantern::hit>(volume_says, surface_says, ray, interval)> behind_two;

}  // namespace contract::lab09
