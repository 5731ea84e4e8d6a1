// SPDX-License-Identifier: MIT
#pragma once
// What lab 15 asks for. The parts that are plugged in are the suite's, and so are the numbers that are drawn: what the student's code asks
// for, how often, and with which arguments, is seen on this side.

#include <contract.hpp>

#include <lantern/aabb.hpp>
#include <lantern/interval.hpp>
#include <lantern/light.hpp>
#include <lantern/ray.hpp>
#include <lantern/rectangle.hpp>
#include <lantern/surface.hpp>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace contract::lab15 {

/// Answers draw1 (in x; `dimensions` is 1) and draw2. `path` are the branches that were taken to the source that was asked.
using draw = std::function<glm::vec2(std::uint32_t dimensions, std::uint32_t purpose, std::uint32_t which, std::span<const std::uint32_t> path)>;

// ---- Step 1 ----

struct viewer {
    glm::vec3 eye{0};
    glm::mat3 axes{1};
    glm::vec2 half{0.5f};
    std::optional<glm::vec2> lens{};      ///< radius and focus; without, the camera is a pinhole by type
    std::optional<glm::vec2> exposure{};  ///< open and close; without, its rays know no time
};
struct shot {
    lantern::ray ray;
    std::optional<float> time;
};
using lens_part = std::function<lantern::ray(glm::vec3 eye, glm::mat3 axes, glm::vec2 film, float radius, float focus, glm::vec2 xi)>;
using moment_part = std::function<float(float open, float close, float xi)>;

inline constexpr function<"shoot", shot(viewer, glm::vec2 film, lens_part, moment_part, draw)> shoot;

// ---- Step 2 ----

struct question {
    std::uint32_t dimensions = 2, purpose = 0, which = 0;
    std::vector<std::uint32_t> path{};  ///< branches taken before
};
using jitter_part = std::function<glm::vec2(std::uint32_t i, std::uint32_t side, glm::vec2 xi)>;
using stratum_part = std::function<std::uint32_t(std::uint32_t i, std::uint32_t count, std::uint32_t purpose, glm::uvec2 pixel)>;

/// The answer of each of the pixel's side² samples; with sound parts.
inline constexpr function<"drawn", std::vector<glm::vec2>(std::uint32_t side, std::uint64_t seed, glm::uvec2 pixel, question)> drawn;
/// Of one sample, with these parts.
inline constexpr function<"drawn_with", glm::vec2(std::uint32_t side, std::uint64_t seed, glm::uvec2 pixel, std::uint32_t sample, question, jitter_part, stratum_part)> drawn_with;

// ---- Step 3 ----

using place_part = std::function<glm::vec3(lantern::rectangle lamp, glm::vec2 xi)>;
using irradiance_part = std::function<glm::vec3(lantern::rectangle lamp, glm::vec3 radiance, glm::vec3 on_lamp, glm::vec3 position, glm::vec3 normal)>;

inline constexpr function<"illuminate", lantern::illumination(lantern::rectangle lamp, glm::vec3 radiance, glm::vec3 point, glm::vec2 xi, place_part, irradiance_part)> illuminate;

// ---- Step 4 ----

struct sent {
    glm::vec3 direction{0}, weight{0};
};
using gloss_part = std::function<glm::vec3(glm::vec3 in, glm::vec3 normal, float width, glm::vec2 xi)>;

inline constexpr function<"scatter", std::vector<sent>(glm::vec3 color, float width, glm::vec3 in, lantern::hit, glm::vec2 xi, gloss_part)> scatter;
inline constexpr function<"scatter_sharp", std::vector<sent>(glm::vec3 color, glm::vec3 in, lantern::hit, gloss_part)> scatter_sharp;

// ---- Step 5 ----

struct body {
    glm::vec3 center{0};
    float radius = 1;
    std::optional<glm::vec3> velocity{};  ///< without, it stands still by type
};
using meet_part = std::function<std::optional<float>(glm::vec3 center, glm::vec3 velocity, float radius, glm::vec3 origin, glm::vec3 direction, float time)>;
using bounds_part = std::function<std::pair<glm::vec3, glm::vec3>(glm::vec3 center, glm::vec3 velocity, float radius, float open, float close)>;

/// By rays without a time: only where the body has no velocity.
inline constexpr function<"intersect", std::optional<lantern::hit>(body, lantern::ray, std::optional<float> time, lantern::interval, meet_part)> intersect;
inline constexpr function<"bounds", lantern::aabb(body, bounds_part)> bounds;

// ---- Step 6 ----

/// A rectangle that moves, and what it is made of: one of these.
enum class substance : std::uint8_t { matt, shining, mirror, frosted, glass };
struct wall {
    lantern::rectangle shape;
    glm::vec3 velocity{0};
    substance made_of = substance::matt;
    glm::vec3 color{1};  ///< of glass: of the first ray, which goes on straight; the second one goes back
};
struct room {
    std::vector<wall> walls;
    std::vector<lantern::rectangle> lamps{};  ///< each of radiance 1, to the side of u × v
    std::vector<glm::vec3> points{};          ///< lamps like points, of intensity 1; when there are some, `lamps` are left out
    glm::vec3 horizon{0}, zenith{0}, ambient{0};
};
/// Told of each ray that is shot, before it is traced.
using told = std::function<void(lantern::ray, std::optional<float> time, lantern::interval)>;

inline constexpr function<"radiance", glm::vec3(room, lantern::ray, std::optional<float> time, std::uint32_t depth, draw, told)> radiance;

// ---- Step 7 ----

using enter = std::function<std::optional<float>(std::uint32_t node)>;
using offer = std::function<lantern::interval(std::uint32_t, lantern::interval)>;

/// Where the ray enters each of the boxes, as the tree is told.
inline constexpr function<"entries", std::vector<std::optional<float>>(std::vector<lantern::aabb> boxes, lantern::ray, lantern::interval)> entries;
/// Through a sound tree over the boxes.
inline constexpr function<"traverse", void(std::vector<lantern::aabb> boxes, lantern::ray, lantern::interval, offer)> traverse;

// ---- Step 8 ----

/// A ball with a coat, or a shining one.
struct marble {
    glm::vec3 center{0};
    float radius = 1;
    glm::vec3 velocity{0};
    bool shines = false;
    glm::vec3 color{0.5f};
    float width = 0;
};
struct stage {
    std::vector<marble> marbles;
    viewer from;  ///< with lens and exposure
};
/// What the visitor was called with, by its types, and what it saw: for each pixel the distance, the direction in which the coat sends the ray on, and its
/// weight or the light.
struct visited {
    bool lens = false, shutter = false, motion = false, blur = false;
    std::uint32_t thing_size = 0, camera_size = 0;
    std::vector<glm::vec3> seen{};
};

/// With `whole`, the same pictures by the largest types, and without the student's leave_out.
inline constexpr function<"left_out", visited(stage, bool whole, glm::uvec2 size, draw)> left_out;

}  // namespace contract::lab15
