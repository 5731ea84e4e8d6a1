// SPDX-License-Identifier: MIT
#pragma once
// The stage of lab 10: many balls on a floor, seen with the library's tree or with the student's; and what a ray asks on its way.

#include <lab10_hierarchy/hierarchy.hpp>

#include <lantern/aabb.hpp>
#include <lantern/boxes_of.hpp>
#include <lantern/bvh.hpp>
#include <lantern/camera.hpp>
#include <lantern/closest.hpp>
#include <lantern/interval.hpp>
#include <lantern/ray.hpp>
#include <lantern/sphere.hpp>
#include <lantern/surface.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace stage {

using balls = std::vector<lantern::sphere>;

/// A ball with nine of a third of its radius around it, six at its equator and three above; each of these with nine around it; and so on:
/// 1, 10, 91, 820, 7381 balls (E. Haines, "A proposal for standard graphics environments", IEEE CG&A 7(11), 1987).
inline void add_flake(balls& all, glm::vec3 center, float radius, glm::vec3 up, unsigned depth) {
    all.push_back({center, radius});
    if (depth == 0) return;
    const glm::vec3 side = glm::normalize(glm::cross(up, std::abs(up.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0)));
    const glm::vec3 front = glm::cross(side, up);
    for (unsigned i = 0; i < 9; ++i) {
        const float latitude = i < 6 ? 0 : std::numbers::pi_v<float> * 0.3f;
        const float longitude = std::numbers::pi_v<float> * (i < 6 ? float(i) / 3 : float(i) * 2 / 3 + 1.0f / 6);
        const glm::vec3 out = std::cos(latitude) * (std::cos(longitude) * side + std::sin(longitude) * front) + std::sin(latitude) * up;
        add_flake(all, center + radius * 4 / 3 * out, radius / 3, out, depth - 1);
    }
}
inline balls flake(unsigned depth) {
    balls all;
    add_flake(all, {0, 0, 0}, 1, {0, 1, 0}, depth);
    return all;
}

/// Two arms of a spiral, crowded and small in the middle, large and far apart outside.
inline balls galaxy() {
    balls all;
    for (unsigned i = 0; i < 600; ++i) {
        const float way = std::pow(float(i) / 600, 2.0f), radius = 0.014f + 0.06f * way;
        const float turn = 9 * std::sqrt(way) + std::numbers::pi_v<float> * float(i % 2);
        const float out = 0.1f + 2 * way + 0.3f * std::sin(float(i) * 2.4f) * std::sqrt(way) * (1.1f - way);
        all.push_back({{out * std::cos(turn), radius, out * std::sin(turn)}, radius});
    }
    return all;
}

/// Below the flake, and below the galaxy.
inline constexpr float floor_height = -1.25f, galaxy_floor = 0;

inline lantern::camera<> camera(glm::uvec2 size) {
    const float aspect = float(size.x) / float(size.y);
    return lantern::camera{lantern::view{.eye = {1, 2.6f, 8.6f}, .target = {0, 0.15f, 0}, .vertical_fov = 0.5f, .aspect = aspect}};
}
inline lantern::camera<> from_above(glm::uvec2 size) {
    const float aspect = float(size.x) / float(size.y);
    return lantern::camera{lantern::view{.eye = {0, 7.4f, 3.4f}, .target = {0, 0, 0.05f}, .vertical_fov = 0.5f, .aspect = aspect}};
}

// ---- What a ray asks -----------------------------------------------------------------------------------------------

/// Where a ray enters a box (lab 09's slabs), a little early, so that no rounding puts it behind a hit. std::nullopt when it misses.
inline std::optional<float> entry(const lantern::aabb& box, const lantern::ray& r) {
    double near = 0, far = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
        const double per_unit = 1 / double(r.direction[k]);
        const double a = (double(box.min[k]) - double(r.origin[k])) * per_unit, b = (double(box.max[k]) - double(r.origin[k])) * per_unit;
        const double enter = per_unit < 0 ? b : a, leave = per_unit < 0 ? a : b;
        if (enter > near) near = enter;  // a NaN, of a ray within a face, is not greater and bounds nothing
        if (leave < far) far = leave;
    }
    if (!(near <= far * (1 + 1e-6))) return std::nullopt;
    return float(near * (1 - 1e-6));
}

/// How often a ray has asked about a box, and about a surface.
struct count {
    std::uint32_t questions = 0, offers = 0;
    [[nodiscard]] float total() const { return float(questions) + float(offers); }

    void question(std::uint32_t, const std::optional<float>&) { ++questions; }
    void offer(std::uint32_t, const std::optional<lantern::hit>&, lantern::interval) { ++offers; }
};

/// The first hit, found by the student's traversal. `asked` hears of every question: which node was entered where, which surface was
/// offered for which range, and where it was hit.
template <class Count>
std::optional<lantern::nearest> closest(const lab10::tree& t, const balls& all, const lantern::ray& r, Count& asked) {
    std::optional<lantern::nearest> best;
    lab10::traverse(t, {},
                    [&](std::uint32_t at) {
                        const auto entered = entry(t.nodes[at].box, r);
                        asked.question(at, entered);
                        return entered;
                    },
                    [&](std::uint32_t surface, lantern::interval rest) {
                        const auto h = intersect(all[surface], r, rest);
                        asked.offer(surface, h, rest);
                        if (!h) return rest;
                        if (!best || h->t < best->t || surface < best->index) best = lantern::nearest{*h, surface};
                        return lantern::interval{rest.min, h->t};
                    });
    return best;
}

/// Whether anything stands between the ray's origin and the light, at t = 1; by the student's search.
template <class Count>
bool dark(const lab10::tree& t, const balls& all, const lantern::ray& r, Count& asked) {
    const lantern::interval range{0, 1};
    return lab10::occluded(t, range,
                           [&](std::uint32_t at) {
                               const auto entered = entry(t.nodes[at].box, r);
                               asked.question(at, entered);
                               return entered;
                           },
                           [&](std::uint32_t surface) {
                               const auto h = intersect(all[surface], r, range);
                               asked.offer(surface, h, range);
                               return h.has_value();
                           });
}

// ---- Trees ---------------------------------------------------------------------------------------------------------

/// The library's tree in the lab's form: for pictures of steps whose tree is still to be written.
inline lab10::tree library_tree(const balls& all, lantern::split rule) {
    const lantern::bvh<> made(all, {.rule = rule, .max_depth = 24});
    lab10::tree t;
    t.order.assign(made.indices().begin(), made.indices().end());
    for (const auto& n : made.nodes()) {
        if (n.size > 0) t.nodes.push_back({.box = n.volume, .first = n.first, .count = n.size});
        else t.nodes.push_back({.box = n.volume, .left = n.first, .right = n.first + 1});
    }
    return t;
}

// ---- Light ---------------------------------------------------------------------------------------------------------

inline constexpr glm::vec3 lamp{-4, 7, 5};

inline glm::vec3 sky(const lantern::ray& r) {
    return glm::mix(glm::vec3(0.55f, 0.6f, 0.66f), glm::vec3(0.16f, 0.26f, 0.42f), glm::clamp(2 * glm::normalize(r.direction).y + 0.6f, 0.0f, 1.0f));
}

/// What is reflected at a hit, lit by the lamp unless something is in its way, and by the sky.
inline glm::vec3 lit(const lantern::hit& h, glm::vec3 color, bool in_the_dark) {
    const float cosine = glm::dot(glm::normalize(lamp - h.point), h.normal);
    return color * ((in_the_dark ? 0 : 0.9f * std::max(cosine, 0.0f)) + 0.2f + 0.1f * h.normal.y);
}

/// Where a ray meets the floor; nothing where it does not.
inline std::optional<lantern::hit> on_floor(const lantern::ray& r, float height) {
    const float t = (height - r.origin.y) / r.direction.y;
    if (!(t > 0 && t < 60)) return std::nullopt;
    glm::vec3 p = at(r, t);
    p.y = height;
    return lantern::hit{.t = t, .point = p, .normal = {0, 1, 0}};
}

inline lantern::ray to_lamp(const lantern::hit& h) {
    const glm::vec3 from = lantern::leave(h, lamp - h.point);
    return {from, lamp - from};
}

}  // namespace stage
