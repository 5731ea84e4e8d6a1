// SPDX-License-Identifier: MIT
#pragma once
// What lab 14 asks for.

#include <contract.hpp>

#include <lantern/ray.hpp>

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <span>

namespace contract::lab14 {

/// As the student's frame.
struct frame_then {
    glm::vec3 u, v, w;
};

/// What the student's accumulator tells at the end.
struct mean_then {
    float mean;
    std::uint64_t rejected;
};

inline constexpr function<"hit_sphere", std::optional<float>(glm::vec3 center, float radius, const lantern::ray& r)> hit_sphere;
inline constexpr function<"hit_triangle", std::optional<float>(glm::vec3 a, glm::vec3 b, glm::vec3 c, const lantern::ray& r)> hit_triangle;
inline constexpr function<"meets_box", bool(glm::vec3 low, glm::vec3 high, const lantern::ray& r)> meets_box;
inline constexpr function<"on_sphere", glm::vec3(glm::vec3 center, float radius, const lantern::ray& r, float t)> on_sphere;
inline constexpr function<"on_triangle", glm::vec3(glm::vec3 a, glm::vec3 b, glm::vec3 c, const lantern::ray& r, float t)> on_triangle;
inline constexpr function<"leave", glm::vec3(glm::vec3 point, glm::vec3 normal, glm::vec3 direction)> leave;
inline constexpr function<"basis_around", frame_then(glm::vec3 w)> basis_around;
/// All samples, one after another, and that `times` times.
inline constexpr function<"add", mean_then(std::span<const float> samples, std::uint64_t times)> mean_of;
inline constexpr function<"refracted", std::optional<glm::vec3>(glm::vec3 in, glm::vec3 normal, float ratio)> refracted;

}  // namespace contract::lab14
