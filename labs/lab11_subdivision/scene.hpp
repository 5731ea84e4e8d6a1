// SPDX-License-Identifier: MIT
#pragma once
// The five scenes of lab 11. Each is hard for somebody.

#include <lantern/any_of.hpp>
#include <lantern/camera.hpp>
#include <lantern/cylinder.hpp>
#include <lantern/hash.hpp>
#include <lantern/sphere.hpp>
#include <lantern/triangle.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace stage {

using shape = lantern::any_of<lantern::sphere, lantern::triangle, lantern::cylinder>;

struct scene {
    std::string name;
    std::vector<shape> shapes;
    lantern::view view;
};

/// Number k of item i, from 0 to 1.
inline float number(std::uint32_t i, std::uint32_t k) { return lantern::to_unit(lantern::low(lantern::hash(11, i, k))); }
inline glm::vec3 in_cube(std::uint32_t i, std::uint32_t k) {
    return 2.0f * glm::vec3(number(i, k), number(i, k + 1), number(i, k + 2)) - 1.0f;
}

/// A surface point(u, v), u and v from 0 to 1, in triangles.
template <class Point>
void add_sheet(std::vector<shape>& to, int columns, int rows, Point point) {
    const auto at = [&](int i, int k) { return point(float(i) / float(columns), float(k) / float(rows)); };
    const auto add = [&](glm::vec3 a, glm::vec3 b, glm::vec3 c) {
        if (a != b && b != c && c != a) to.push_back(lantern::triangle{a, b, c});
    };
    for (int k = 0; k < rows; ++k)
        for (int i = 0; i < columns; ++i) {
            add(at(i, k), at(i + 1, k), at(i + 1, k + 1));
            add(at(i, k), at(i + 1, k + 1), at(i, k + 1));
        }
}

/// A teapot, 30 cm wide, in the middle of a stadium of 240 m by 180 m.
inline scene stadium() {
    scene s{"stadium", {}, {.eye = {0.14f, 0.2f, 0.62f}, .target = {0.015f, 0.085f, 0}, .vertical_fov = 0.62f, .aspect = 4 / 3.0f}};
    constexpr float turn = 2 * std::numbers::pi_v<float>;
    // Body and lid: the profile's radius and height, turned around the axis.
    const auto profile = [](float v) -> glm::vec2 {
        if (v < 0.8f) {
            const float a = (0.03f + 0.66f * v / 0.8f) * std::numbers::pi_v<float>;
            return {0.1f * std::sin(a), 0.075f - 0.08f * std::cos(a)};
        }
        const float a = (v - 0.8f) / 0.2f;
        return {0.075f * (1 - a) + 0.014f * std::sin(a * std::numbers::pi_v<float>), 0.122f + 0.04f * a * (0.4f + 0.6f * a)};
    };
    add_sheet(s.shapes, 40, 30, [&](float u, float v) {
        const glm::vec2 p = profile(v);
        return glm::vec3(p.x * std::cos(turn * u), p.y, p.x * std::sin(turn * u));
    });
    // Spout and handle: circles along an arc in the plane z = 0.
    const auto tube = [&](glm::vec3 middle, float reach_x, float reach_y, float from, float to, float thick, float thin) {
        add_sheet(s.shapes, 10, 16, [&](float u, float v) {
            const float a = turn * (from + (to - from) * v), radius = thick + (thin - thick) * v;
            const glm::vec3 out{std::cos(a), std::sin(a), 0};
            return middle + glm::vec3(reach_x, reach_y, 1) * out + radius * (std::cos(turn * u) * out + std::sin(turn * u) * glm::vec3(0, 0, 1));
        });
    };
    tube({-0.09f, 0.085f, 0}, 0.055f, 0.045f, 0.2f, 0.8f, 0.01f, 0.01f);
    tube({0.02f, 0.26f, 0}, 0.19f, 0.19f, 0.79f, 0.89f, 0.026f, 0.01f);
    // The field, and eight tiers of seats around it.
    const auto oval = [&](float u, float width) { return glm::vec3((80 + width) * std::cos(turn * u), 0, (50 + width) * std::sin(turn * u)); };
    add_sheet(s.shapes, 15, 1, [](float u, float v) {
        const float x = 2 * u - 1;
        return glm::vec3(80 * x, 0, (2 * v - 1) * 50 * std::sqrt(1 - x * x));
    });
    for (int tier = 0; tier < 8; ++tier) {
        const float inner = 5.0f * float(tier), low = 0.4f * float(tier * tier), high = 0.4f * float((tier + 1) * (tier + 1));
        add_sheet(s.shapes, 48, 1, [&](float u, float v) { return oval(u, inner) + glm::vec3(0, low + (high - low) * v, 0); });
        add_sheet(s.shapes, 48, 1, [&](float u, float v) { return oval(u, inner + 5 * v) + glm::vec3(0, high, 0); });
    }
    return s;
}

/// Small balls, spread evenly in a cube.
inline scene cloud() {
    scene s{"cloud", {}, {.eye = {1.6f, 1.2f, 3.4f}, .target = {0, 0, 0}, .vertical_fov = 0.6f, .aspect = 4 / 3.0f}};
    for (std::uint32_t i = 0; i < 3000; ++i) s.shapes.push_back(lantern::sphere{in_cube(i, 0), 0.015f + 0.025f * number(i, 3)});
    return s;
}

/// Long thin sticks along the diagonals of a cube: their boxes are nearly all empty.
inline scene sticks() {
    scene s{"sticks", {}, {.eye = {0.6f, 0.4f, 4.4f}, .target = {0, 0, 0}, .vertical_fov = 0.6f, .aspect = 4 / 3.0f}};
    for (std::uint32_t i = 0; i < 600; ++i) {
        const glm::vec3 middle = 0.8f * in_cube(5000 + i, 0);
        const float side = i % 2 == 0 ? 1.0f : -1.0f;
        const glm::vec3 along = 0.4f * glm::normalize(glm::vec3(side, 1, 0.8f) + 0.25f * in_cube(5000 + i, 3));
        s.shapes.push_back(lantern::cylinder{middle - along, middle + along, 0.006f + 0.006f * number(5000 + i, 6)});
    }
    return s;
}

/// Hills, in triangles: a surface, not a volume.
inline scene hills() {
    scene s{"hills", {}, {.eye = {0, 0.75f, 2.6f}, .target = {0, 0.05f, 0}, .vertical_fov = 0.6f, .aspect = 4 / 3.0f}};
    add_sheet(s.shapes, 48, 48, [](float u, float v) {
        const float x = 3 * u - 1.5f, z = 3 * v - 1.5f;
        float y = 0, height = 0.2f, wave = 2.1f;
        for (std::uint32_t k = 0; k < 5; ++k, height *= 0.5f, wave *= 1.9f) {
            const float angle = 6.3f * number(9000, k);
            y += height * std::sin(wave * (x * std::cos(angle) + z * std::sin(angle)) + 9 * number(9001, k)) *
                 std::cos(wave * (z * std::cos(angle) - x * std::sin(angle)) + 9 * number(9002, k));
        }
        return glm::vec3(x, y, z);
    });
    return s;
}

/// Swarms: crowded in a few places, empty in between.
inline scene swarms() {
    scene s{"swarms", {}, {.eye = {1.2f, 0.9f, 3.6f}, .target = {0, 0, 0}, .vertical_fov = 0.6f, .aspect = 4 / 3.0f}};
    for (std::uint32_t swarm = 0; swarm < 12; ++swarm) {
        const glm::vec3 middle = in_cube(7000 + swarm, 0);
        const float reach = 0.05f + 0.3f * number(7000 + swarm, 3) * number(7000 + swarm, 3);
        for (std::uint32_t i = 0; i < 250; ++i) {
            const glm::vec3 way = in_cube(10000 + 250 * swarm + i, 0);
            s.shapes.push_back(lantern::sphere{middle + reach * glm::dot(way, way) * way, reach * 0.08f * (0.3f + number(10000 + 250 * swarm + i, 3))});
        }
    }
    return s;
}

/// In the order of the student's predictions.
inline std::vector<scene> scenes() { return {stadium(), cloud(), sticks(), hills(), swarms()}; }

}  // namespace stage
