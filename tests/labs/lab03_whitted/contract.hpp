// SPDX-License-Identifier: MIT
#pragma once
// What lab 03 asks for.

#include <contract.hpp>

#include <lantern/plane.hpp>
#include <lantern/ray.hpp>
#include <lantern/sphere.hpp>
#include <lantern/surface.hpp>

#include <glm/vec3.hpp>

#include <optional>
#include <variant>
#include <vector>

namespace contract::lab03 {

// The scene as plain values; the student's header has the same.

struct matte {
    glm::vec3 body{0.5f};
    glm::vec3 highlight{0};
    float exponent = 50;
};

struct mirror {
    glm::vec3 color{1};
};

struct glass {
    float index = 1.5f;
    glm::vec3 color{1};
};

struct thing {
    std::variant<lantern::sphere, lantern::plane> shape;
    std::variant<matte, mirror, glass> material = matte{};
};

struct light {
    glm::vec3 position{0};
    glm::vec3 intensity{1};
};

struct scene {
    std::vector<thing> things{};
    std::vector<light> lights{};
    glm::vec3 ambient{0};
    glm::vec3 horizon{0}, zenith{0};
};

inline constexpr function<"shade", glm::vec3(matte, glm::vec3 normal, glm::vec3 to_light, glm::vec3 to_eye)> shade;
inline constexpr function<"lit", bool(scene, lantern::hit, glm::vec3 light_position)> lit;
inline constexpr function<"reflected", glm::vec3(glm::vec3 in, glm::vec3 normal)> reflected;
inline constexpr function<"refracted", std::optional<glm::vec3>(glm::vec3 in, glm::vec3 normal, float ratio)> refracted;
inline constexpr function<"reflectance", float(float cosine, float ratio)> reflectance;
inline constexpr function<"trace", glm::vec3(scene, lantern::ray, int depth)> trace;

}  // namespace contract::lab03
