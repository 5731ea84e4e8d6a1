// SPDX-License-Identifier: MIT
#pragma once
// Your scene. This one is ours, lanterns over a lake at dusk: change it, or make your own. No test looks at it.

#include <lab15_tracer/tracer.hpp>

#include <lantern/camera.hpp>
#include <lantern/coated.hpp>
#include <lantern/diffuse.hpp>
#include <lantern/emissive.hpp>
#include <lantern/hash.hpp>
#include <lantern/rectangle.hpp>
#include <lantern/sky.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <cstdint>
#include <utility>

namespace mine {

inline constexpr lantern::sky dusk{.horizon = {0.18f, 0.085f, 0.12f}, .zenith = {0.0f, 0.01f, 0.08f}};
inline constexpr glm::vec3 ambient{0.035f, 0.04f, 0.07f};
inline constexpr glm::uvec2 size{480, 300};

/// A camera as the library's `view` describes it.
template <lab15::parts P>
[[nodiscard]] lab15::camera<P, lab15::lens, lab15::exposure> camera_at(const lantern::view& v, lab15::lens optics, lab15::exposure shutter) {
    const lantern::camera_frame frame(v);
    return {v.eye, glm::mat3(frame.right, frame.up, frame.forward), {frame.half_width, frame.half_height}, optics, shutter};
}

/// A number from 0 to 1, the same one whenever it is asked for.
[[nodiscard]] inline float chance(std::uint32_t i, std::uint32_t what) { return lantern::to_unit(lantern::low(lantern::hash(1984, i, what))); }

template <lab15::parts P>
[[nodiscard]] lab15::scene<P> lanterns() {
    using namespace lab15;
    using ball = lab15::ball<P, drift>;
    const auto coated = [](glm::vec3 body, glm::vec3 coat, float width, float share) {
        return lantern::coated{lantern::diffuse{body}, gloss<P, blurred>{coat, {width}}, share};
    };
    scene<P> s;

    // The lake, and three balls on its ice. The third one rolls.
    s.things.push_back({lantern::rectangle{{-150, 0, 20}, {300, 0, 0}, {0, 0, -320}}, coated({0.03f, 0.035f, 0.05f}, {0.8f, 0.85f, 1}, 0.10f, 0.5f)});
    s.things.push_back({ball{{-0.1f, 1, 0.2f}, 1, {}}, coated({0.65f, 0.36f, 0.06f}, {1, 0.8f, 0.45f}, 0.42f, 0.6f)});
    s.things.push_back({ball{{-2.05f, 0.72f, 1.0f}, 0.72f, {}}, coated({0.62f, 0.025f, 0.02f}, {1, 1, 1}, 0.02f, 0.09f)});
    s.things.push_back({ball{{1.6f, 0.55f, 1.25f}, 0.55f, {{0.5f, 0, -0.07f}}}, coated({0.04f, 0.16f, 0.62f}, {1, 1, 1}, 0.02f, 0.09f)});
    s.things.push_back({ball{{-0.72f, 0.26f, 1.85f}, 0.26f, {}}, coated({0.75f, 0.75f, 0.72f}, {1, 1, 1}, 0.0f, 0.10f)});
    s.things.push_back({ball{{0.78f, 0.2f, 2.1f}, 0.2f, {}}, coated({0.05f, 0.35f, 0.12f}, {1, 1, 1}, 0.0f, 0.10f)});

    // Lanterns: they rise, the farther the more of them, and drift a little.
    for (std::uint32_t i = 0; i < 90; ++i) {
        const float far = 4 + 46 * std::pow(chance(i, 0), 1.4f), across = (chance(i, 1) - 0.5f) * (4 + 0.85f * far);
        const float height = 0.25f + (0.1f + 0.30f * chance(i, 2) * chance(i, 3)) * far, radius = 0.10f + 0.09f * chance(i, 4);
        const glm::vec3 warm = glm::mix(glm::vec3(5.2f, 1.5f, 0.32f), glm::vec3(5.0f, 2.9f, 1.1f), chance(i, 5));
        s.things.push_back({ball{{across, height, -far}, radius, {{0, 0.12f * chance(i, 6), 0}}}, lantern::emissive{(0.5f + 0.7f * chance(i, 7)) * warm}});
    }

    // A warm lamp to the left, which can be seen in the balls; and the last light of the day, from behind on the right.
    const lantern::rectangle near{{-6.4f, 3.4f, 2.2f}, {0.8f, 0, 2.4f}, {1.0f, 2.2f, -0.4f}};
    const lantern::rectangle far{{9.4f, 1.4f, -4.5f}, {-1.2f, 0, -3.4f}, {0.5f, 3.6f, 0}};
    for (const auto& [shape, light] : {std::pair{near, glm::vec3(15, 10.5f, 6.5f)}, std::pair{far, glm::vec3(4.2f, 4.6f, 9)}}) {
        const glm::vec3 to_the_middle = glm::vec3(0, 0.8f, 0) - shape.corner;
        const bool turned = glm::dot(glm::cross(shape.u, shape.v), to_the_middle) < 0;
        s.lamps.push_back({turned ? lantern::rectangle{shape.corner, shape.v, shape.u} : shape, light});
        s.things.push_back({s.lamps.back().shape, lantern::emissive{light}});
    }

    const lantern::view seat{.eye = {0.35f, 1.35f, 8.2f}, .target = {-0.1f, 0.95f, 0}, .vertical_fov = 0.5f, .aspect = float(size.x) / float(size.y)};
    s.from = camera_at<P>(seat, {.radius = 0.13f, .focus = 7.6f}, {});
    return s;
}

}  // namespace mine
