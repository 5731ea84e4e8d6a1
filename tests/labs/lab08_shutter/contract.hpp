// SPDX-License-Identifier: MIT
#pragma once
// What lab 08 asks for.

#include <contract.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace contract::lab08 {

/// As the student's timed_ray and moving_sphere.
struct ray_then {
    glm::vec3 origin, direction;
    float time;
};
struct ball {
    glm::vec3 center, velocity;
    float radius;
};

inline constexpr function<"moment", float(float open, float close, float xi)> moment;
inline constexpr function<"intersect", std::optional<float>(ball s, ray_then r)> intersect;
inline constexpr function<"bounds", std::pair<glm::vec3, glm::vec3>(ball s, float open, float close)> bounds;
inline constexpr function<"shadow_ray", ray_then(ray_then r, glm::vec3 point, glm::vec3 light)> shadow_ray;
inline constexpr function<"reflected_ray", ray_then(ray_then r, glm::vec3 point, glm::vec3 normal)> reflected_ray;
inline constexpr function<"refracted_ray", std::optional<ray_then>(ray_then r, glm::vec3 point, glm::vec3 normal, float eta)> refracted_ray;
inline constexpr function<"times", std::vector<float>(float open, float close, std::span<const std::uint32_t> order, std::span<const float> xi)> times;
inline constexpr function<"covered", float(glm::vec2 point, glm::vec2 center, glm::vec2 velocity, float radius, float open, float close)> covered;

}  // namespace contract::lab08
