// SPDX-License-Identifier: MIT
#pragma once
// What lab 12 asks for.

#include <contract.hpp>

#include <lantern/ray.hpp>
#include <lantern/rectangle.hpp>
#include <lantern/sphere.hpp>
#include <lantern/surface.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace contract::lab12 {

struct matter {
    glm::vec3 albedo{0.5f}, emission{0};
};
struct ball {
    lantern::sphere shape;
    matter upper{}, lower{};
};
struct wall {
    lantern::rectangle shape;
    matter what{};
};
struct scene {
    std::vector<ball> balls;
    std::vector<wall> walls;
    std::optional<std::size_t> lamp{};
};
struct drawn {
    float value = 0, density = 1;
};
struct lit {
    glm::vec3 light{0}, direction{0};
    float density = 0;
};

inline constexpr function<"estimate", float(std::vector<drawn> samples)> estimate;
inline constexpr function<"cosine_direction", glm::vec3(glm::vec3 normal, glm::vec2 xi)> cosine_direction;
inline constexpr function<"cosine_density", float(glm::vec3 normal, glm::vec3 direction)> cosine_density;
inline constexpr function<"bounced", glm::vec3(glm::vec3 throughput, glm::vec3 albedo, glm::vec3 normal, glm::vec3 direction, float density)> bounced;
inline constexpr function<"lamp_density", float(lantern::rectangle lamp, glm::vec3 on_lamp, glm::vec3 from)> lamp_density;
/// At a hit of a surface with this albedo; its normal is on the lit side.
inline constexpr function<"from_lamp", lit(scene, lantern::hit at, glm::vec3 albedo, glm::vec2 xi)> from_lamp;
inline constexpr function<"share", float(float mine, float other)> share;
inline constexpr function<"roulette", std::optional<glm::vec3>(glm::vec3 throughput, float xi)> roulette;
/// `radiance` along each of the rays in turn, `count` times in all, each with numbers of its own.
inline constexpr function<"radiance", std::vector<glm::vec3>(scene, std::vector<lantern::ray> rays, std::uint32_t count, std::uint64_t seed)> radiance;

}  // namespace contract::lab12
