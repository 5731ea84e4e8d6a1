// SPDX-License-Identifier: MIT
#pragma once
// What lab 02 asks for.

#include <contract.hpp>

#include <lantern/interval.hpp>
#include <lantern/ray.hpp>
#include <lantern/surface.hpp>

#include <glm/vec3.hpp>

#include <cstdint>
#include <functional>
#include <optional>

namespace contract::lab02 {

using found = std::optional<lantern::hit>;

inline constexpr function<"sphere", found(glm::vec3 center, float radius, lantern::ray, lantern::interval)> intersect_sphere;
inline constexpr function<"plane", found(glm::vec3 point, glm::vec3 normal, lantern::ray, lantern::interval)> intersect_plane;
inline constexpr function<"triangle", found(glm::vec3 a, glm::vec3 b, glm::vec3 c, lantern::ray, lantern::interval)> intersect_triangle;

struct nearest {
    lantern::hit at;
    std::uint32_t index;
};

/// The surfaces are the suite's: `intersect(i, range)` is the answer of surface i.
using surfaces = std::function<found(std::uint32_t i, lantern::interval range)>;
inline constexpr function<"closest", std::optional<nearest>(std::uint32_t count, surfaces intersect, lantern::interval)> closest;

}  // namespace contract::lab02
