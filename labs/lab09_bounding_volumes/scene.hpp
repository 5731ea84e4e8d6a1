// SPDX-License-Identifier: MIT
#pragma once
// The shelf of lab 09: a ball, a stick, a plate and a pot, all of triangles; each fits closely into a ball of radius 1 around the
// origin. And lines from everywhere to look at them.

#include <lantern/hash.hpp>
#include <lantern/interval.hpp>
#include <lantern/ray.hpp>
#include <lantern/surface.hpp>
#include <lantern/warp.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace shelf {

struct triangle {
    glm::vec3 a, b, c;
};

struct thing {
    std::string name;
    glm::vec3 color{1};
    bool convex = true;
    std::vector<triangle> triangles{};

    [[nodiscard]] std::vector<glm::vec3> points() const {
        std::vector<glm::vec3> all;
        for (const triangle& t : triangles) all.insert(all.end(), {t.a, t.b, t.c});
        return all;
    }
    [[nodiscard]] double area() const {
        double sum = 0;
        for (const triangle& t : triangles) sum += 0.5 * double(glm::length(glm::cross(t.b - t.a, t.c - t.a)));
        return sum;
    }
};

/// The nearest hit with any of the triangles (Möller and Trumbore 1997), all of which are tested: that is what volumes are to save.
[[nodiscard]] inline std::optional<lantern::hit> intersect(const thing& s, const lantern::ray& r, lantern::interval range) {
    std::optional<lantern::hit> nearest;
    for (const triangle& one : s.triangles) {
        const glm::vec3 ab = one.b - one.a, ac = one.c - one.a, p = glm::cross(r.direction, ac), from_a = r.origin - one.a, q = glm::cross(from_a, ab);
        const float determinant = glm::dot(ab, p), u = glm::dot(from_a, p) / determinant, v = glm::dot(r.direction, q) / determinant;
        const float t = glm::dot(ac, q) / determinant;
        if (!(u >= 0 && v >= 0 && u + v <= 1 && contains(range, t))) continue;
        nearest = lantern::hit{.t = t, .point = at(r, t), .normal = glm::normalize(glm::cross(ab, ac))};
        range.max = t;
    }
    return nearest;
}

/// Where the ray meets the thing; not asked where it passes the ball of radius 1, in which all of them are.
[[nodiscard]] inline std::optional<lantern::hit> seen(const thing& s, const lantern::ray& r) {
    if (glm::length(glm::cross(r.origin, r.direction)) > 1.01f * glm::length(r.direction)) return std::nullopt;
    return intersect(s, r, {});
}

/// Rings of points, each joined with the next; the normals point to the left of the rings' way round, as seen from the last.
inline void join(thing& s, const std::vector<std::vector<glm::vec3>>& rings) {
    const auto add = [&](glm::vec3 a, glm::vec3 b, glm::vec3 c) {
        if (glm::length(glm::cross(b - a, c - a)) > 1e-7f) s.triangles.push_back({a, b, c});  // none at the poles, where a ring is a point
    };
    for (std::size_t i = 0; i + 1 < rings.size(); ++i)
        for (std::size_t k = 0, n = rings[i].size(); k < n; ++k) {
            const std::size_t next = (k + 1) % n;
            add(rings[i][k], rings[i][next], rings[i + 1][next]);
            add(rings[i][k], rings[i + 1][next], rings[i + 1][k]);
        }
}

/// Turned on a lathe: the profile's x is the distance from the axis, its y the height, from below to above.
inline void turn(thing& s, const std::vector<glm::vec2>& profile, int around) {
    std::vector<std::vector<glm::vec3>> rings;
    for (const glm::vec2 p : profile) {
        std::vector<glm::vec3> ring;
        for (int k = 0; k < around; ++k) {
            const float angle = -2 * std::numbers::pi_v<float> * float(k) / float(around);
            ring.push_back({p.x * std::cos(angle), p.y, p.x * std::sin(angle)});
        }
        rings.push_back(ring);
    }
    join(s, rings);
}

/// A tube along a curve in the plane z = 0, with a radius at each point; open at its ends.
inline void bend(thing& s, const std::vector<glm::vec3>& curve, int around) {
    std::vector<std::vector<glm::vec3>> rings;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const glm::vec2 before = curve[i == 0 ? 0 : i - 1], after = curve[std::min(i + 1, curve.size() - 1)];
        const glm::vec2 way = glm::normalize(after - before);
        std::vector<glm::vec3> ring;
        for (int k = 0; k < around; ++k) {
            const float angle = 2 * std::numbers::pi_v<float> * float(k) / float(around);
            ring.push_back(glm::vec3(glm::vec2(curve[i]), 0) + curve[i].z * (std::cos(angle) * glm::vec3(-way.y, way.x, 0) + std::sin(angle) * glm::vec3(0, 0, 1)));
        }
        rings.push_back(ring);
    }
    join(s, rings);
}

/// A box with these half extents along three perpendicular axes.
inline void carpenter(thing& s, const std::array<glm::vec3, 3>& axes, glm::vec3 half) {
    for (std::size_t i = 0; i < 3; ++i)
        for (const float side : {-1.0f, 1.0f}) {
            const glm::vec3 middle = side * half[int(i)] * axes[i];
            const std::size_t k = (i + 1) % 3, l = (i + 2) % 3;
            const glm::vec3 u = side * half[int(k)] * axes[k], v = half[int(l)] * axes[l];
            s.triangles.push_back({middle - u - v, middle + u - v, middle + u + v});
            s.triangles.push_back({middle - u - v, middle + u + v, middle - u + v});
        }
}

inline std::array<glm::vec3, 3> axes_along(glm::vec3 first, glm::vec3 near_second) {
    const glm::vec3 u = glm::normalize(first), w = glm::normalize(glm::cross(u, near_second));
    return {u, glm::cross(w, u), w};
}

inline std::vector<thing> things() {
    thing ball{"ball", {0.75f, 0.1f, 0.06f}}, stick{"stick", {0.1f, 0.35f, 0.08f}}, plate{"plate", {0.06f, 0.16f, 0.6f}}, pot{"pot", {0.4f, 0.42f, 0.5f}, false};
    std::vector<glm::vec2> meridian;
    for (int i = 0; i <= 12; ++i) {
        const float angle = std::numbers::pi_v<float> * (float(i) / 12 - 0.5f);
        meridian.push_back({i % 12 == 0 ? 0 : std::cos(angle), std::sin(angle)});
    }
    turn(ball, meridian, 24);
    carpenter(stick, axes_along({0.8f, 0.75f, -0.7f}, {0, 0, 1}), {0.998f, 0.04f, 0.04f});
    carpenter(plate, axes_along({1, 0.25f, 0.2f}, {-0.2f, 0.8f, -0.5f}), {0.75f, 0.66f, 0.03f});
    // The lid and its knob are one with the body.
    turn(pot, {{0, -0.62f}, {0.38f, -0.62f}, {0.55f, -0.45f}, {0.6f, -0.2f}, {0.54f, 0.05f}, {0.4f, 0.22f}, {0.24f, 0.31f}, {0.06f, 0.35f}, {0.05f, 0.4f},
               {0.1f, 0.46f}, {0.07f, 0.52f}, {0, 0.54f}}, 20);
    bend(pot, {{0.5f, -0.38f, 0.14f}, {0.7f, -0.26f, 0.11f}, {0.78f, -0.02f, 0.08f}, {0.84f, 0.16f, 0.06f}, {0.96f, 0.22f, 0.05f}}, 8);
    bend(pot, {{-0.52f, 0.1f, 0.045f}, {-0.72f, 0.16f, 0.045f}, {-0.88f, 0.08f, 0.045f}, {-0.93f, -0.1f, 0.045f}, {-0.84f, -0.28f, 0.045f}, {-0.56f, -0.36f, 0.045f}}, 8);
    return {ball, stick, plate, pot};
}

/// Line number i of those that come from everywhere alike: through the ball of this radius around the origin, from a point of its
/// surface inwards, by the cosine. It meets a convex body in that ball with the probability area / (4πR²).
inline lantern::ray line(std::uint32_t i, float radius) {
    const auto number = [&](std::uint32_t k) { return lantern::to_unit(lantern::low(lantern::hash(9, i, k))); };
    const glm::vec3 up = lantern::to_sphere({number(0), number(1)}), inwards = lantern::to_cosine_hemisphere({number(2), number(3)});
    const glm::vec3 u = glm::normalize(glm::cross(up, std::abs(up.x) < 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0))), v = glm::cross(up, u);
    return {radius * up, inwards.x * u + inwards.y * v - inwards.z * up};
}

constexpr float lines_radius = 2.5f;  // room enough for whatever volume

}  // namespace shelf
