// SPDX-License-Identifier: MIT
#pragma once
// Closed meshes, out of which nothing may leak.

#include "oracle.hpp"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

/// The corners of each triangle of a surface around the origin: an octahedron, each face divided in four so often, its vertices
/// pushed out to between 1 and 1.3 times `scale`; the same number for all faces that meet in a vertex.
inline std::vector<std::array<glm::vec3, 3>> closed_mesh(dice& d, int divisions, float scale) {
    std::vector<std::array<glm::vec3, 3>> faces;
    for (const float x : {-1.0f, 1.0f})
        for (const float y : {-1.0f, 1.0f})
            for (const float z : {-1.0f, 1.0f}) faces.push_back({glm::vec3(x, 0, 0), glm::vec3(0, y, 0), glm::vec3(0, 0, z)});
    for (int i = 0; i < divisions; ++i) {
        std::vector<std::array<glm::vec3, 3>> finer;
        for (const auto& [a, b, c] : faces) {
            const glm::vec3 ab = 0.5f * (a + b), bc = 0.5f * (b + c), ca = 0.5f * (c + a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {bc, ca, ab}});
        }
        faces = finer;
    }
    const std::uint64_t seed = d.bits();
    const auto pushed = [&](glm::vec3 p) {
        const auto key = [](float x) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::ldexp(x, 16))) & 0x1ffffu; };
        dice at{seed ^ (key(p.x) << 34 | key(p.y) << 17 | key(p.z))};
        return scale * glm::vec3(glm::normalize(glm::dvec3(p)) * (1.0 + 0.3 * at.unit()));
    };
    for (auto& corners : faces)
        for (glm::vec3& p : corners) p = pushed(p);
    return faces;
}
