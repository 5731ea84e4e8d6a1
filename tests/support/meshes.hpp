// SPDX-License-Identifier: MIT
#pragma once
// Meshes for tests and measurements, of any number of triangles.

#include "oracle.hpp"

#include <lantern/mesh.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace meshes {

using lantern::mesh;

/// A closed surface around the origin, 8 divisions² triangles: an octahedron's faces divided and pushed out to the unit
/// sphere, then multiplied by up to 1 ± roughness and by the scale.
inline mesh sphere(std::uint32_t divisions, float roughness = 0, float scale = 1) {
    const std::uint32_t n = divisions;
    std::vector<glm::vec3> vertices;
    dice d{.state = 77};
    // Rows of latitude, from pole to pole; row i of the upper half has 4 i vertices, a pole has one.
    std::vector<std::uint32_t> first, size;
    for (std::uint32_t row = 0; row <= 2 * n; ++row) {
        const std::uint32_t i = row <= n ? row : 2 * n - row, count = i == 0 ? 1 : 4 * i;
        first.push_back(static_cast<std::uint32_t>(vertices.size()));
        size.push_back(count);
        const double polar = std::numbers::pi * row / (2.0 * n);
        for (std::uint32_t k = 0; k < count; ++k) {
            const double around = 2 * std::numbers::pi * k / count, r = std::sin(polar);
            const double length = scale * (1 + roughness * (2 * d.unit() - 1));
            vertices.emplace_back(length * glm::dvec3(r * std::cos(around), std::cos(polar), r * std::sin(around)));
        }
    }
    std::vector<glm::uvec3> triangles;
    for (std::uint32_t row = 0; row < 2 * n; ++row) {  // a band between two rows, a quarter at a time
        const bool upper = row < n;
        const std::uint32_t narrow = upper ? row : row + 1, wide = upper ? row + 1 : row;
        const std::uint32_t steps = size[wide] / 4, fewer = steps - 1;
        for (std::uint32_t quarter = 0; quarter < 4; ++quarter) {
            const auto at_wide = [&](std::uint32_t k) { return first[wide] + (quarter * steps + k) % size[wide]; };
            const auto at_narrow = [&](std::uint32_t k) { return first[narrow] + (quarter * fewer + k) % size[narrow]; };
            const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
                triangles.push_back(upper ? glm::uvec3{a, c, b} : glm::uvec3{a, b, c});
            };
            for (std::uint32_t k = 0; k < steps; ++k) add(at_narrow(k), at_wide(k), at_wide(k + 1));
            for (std::uint32_t k = 0; k < fewer; ++k) add(at_narrow(k), at_wide(k + 1), at_narrow(k + 1));
        }
    }
    return mesh(vertices, triangles);
}

/// Hills over the unit square in x and z: 2 side² triangles, ever finer waves on top of each other.
inline mesh terrain(std::uint32_t side) {
    std::vector<glm::vec3> vertices;
    for (std::uint32_t j = 0; j <= side; ++j)
        for (std::uint32_t i = 0; i <= side; ++i) {
            const double x = double(i) / side, z = double(j) / side;
            double y = 0;
            for (int octave = 0; octave < 7; ++octave) {
                const double f = 3.1 * (1 << octave), phase = 1.7 * octave;
                y += 0.08 / (1 << octave) * std::sin(f * (x + 0.6 * z) + phase) * std::cos(f * (z - 0.4 * x) - phase);
            }
            vertices.emplace_back(glm::dvec3(x, y, z));
        }
    std::vector<glm::uvec3> triangles;
    for (std::uint32_t j = 0; j < side; ++j)
        for (std::uint32_t i = 0; i < side; ++i) {
            const std::uint32_t a = j * (side + 1) + i, b = a + 1, c = a + side + 1, e = c + 1;
            triangles.push_back({a, c, b});
            triangles.push_back({b, c, e});
        }
    return mesh(vertices, triangles);
}

/// `count` needles, as long as the scene and 1e-4 as wide, in all directions.
inline mesh slivers(std::uint32_t count) {
    std::vector<glm::vec3> vertices;
    std::vector<glm::uvec3> triangles;
    dice d{.state = 78};
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::dvec3 a(d.in_cube()), along = d.on_sphere();
        vertices.emplace_back(a);
        vertices.emplace_back(a + along);
        vertices.emplace_back(a + d.unit() * along + 1e-4 * d.on_sphere());
        triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return mesh(vertices, triangles);
}

/// `count` triangles of one size, anywhere in the cube from -1 to 1, in no relation to each other.
inline mesh soup(std::uint32_t count, double size) {
    std::vector<glm::vec3> vertices;
    std::vector<glm::uvec3> triangles;
    dice d{.state = 79};
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::dvec3 center(d.in_cube());
        for (int k = 0; k < 3; ++k) vertices.emplace_back(center + size * d.on_sphere());
        triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return mesh(vertices, triangles);
}

/// `count` small triangles anywhere in the cube, and a needle for each hundred of them: as beams among what stands in a hall.
inline mesh hall(std::uint32_t count) {
    const mesh small = soup(count, 2 / std::cbrt(double(count))), thin = slivers(count / 100);
    std::vector<glm::vec3> vertices(small.vertices().begin(), small.vertices().end());
    std::vector<glm::uvec3> triangles(small.triangles().begin(), small.triangles().end());
    const auto first = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), thin.vertices().begin(), thin.vertices().end());
    for (const glm::uvec3& t : thin.triangles()) triangles.push_back(t + first);
    return mesh(vertices, triangles);
}

/// The same triangles, elsewhere and of another size.
inline mesh placed(const mesh& m, float scale, glm::vec3 by = glm::vec3(0)) {
    std::vector<glm::vec3> vertices;
    for (const glm::vec3& v : m.vertices()) vertices.push_back(scale * v + by);
    return mesh(vertices, m.triangles());
}

}  // namespace meshes
