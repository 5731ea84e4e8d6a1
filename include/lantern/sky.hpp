// SPDX-License-Identifier: MIT
#pragma once
// What a ray sees when it hits nothing.

#include <lantern/validate.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <concepts>

namespace lantern {

/// A background: a radiance for every unit direction.
template <class B>
concept background = requires(const B& b, glm::vec3 direction) {
    { radiance(b, direction) } -> std::same_as<glm::vec3>;
};

/// A gradient from the horizon to the zenith (y is up); below the horizon it stays what it is there.
struct sky {
    glm::vec3 horizon{1};
    glm::vec3 zenith{0.5f, 0.7f, 1};
};

inline void validate(const sky& s) {
    require_not_negative(s.horizon, "sky: horizon");
    require_not_negative(s.zenith, "sky: zenith");
}

[[nodiscard]] inline glm::vec3 radiance(const sky& s, glm::vec3 direction) {
    const float height = glm::clamp(direction.y, 0.0f, 1.0f);
    return (1 - height) * s.horizon + height * s.zenith;
}

/// Black: all light comes from lights.
struct darkness {};

[[nodiscard]] inline glm::vec3 radiance(darkness, glm::vec3) { return glm::vec3(0); }

}  // namespace lantern
