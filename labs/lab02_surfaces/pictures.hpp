// SPDX-License-Identifier: MIT
#pragma once
// Lab 02's picture: a small world in the colours of its normals. What is not written yet is not there.

#include "../support/gaps.hpp"

#include <lab02_surfaces/surfaces.hpp>

#include <lantern/camera.hpp>
#include <lantern/samples.hpp>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace pictures {

inline constexpr glm::uvec2 size{640, 480};
inline constexpr lantern::jittered samples{.side = 3};
inline constexpr glm::vec3 eye{0.3f, 1.7f, 6.5f};

inline lantern::camera<> camera() {
    return lantern::camera{lantern::view{.eye = eye, .target = {0.3f, 0.85f, 0}, .aspect = float(size.x) / float(size.y)}};
}

struct thing {
    std::variant<lab02::sphere, lab02::plane, lab02::triangle> shape;
};

inline std::optional<lantern::hit> intersect(const thing& one, const lantern::ray& r, lantern::interval range) {
    return std::visit([&](const auto& shape) { return intersect(shape, r, range); }, one.shape);
}

template <class Surface>
bool is_written(support::gaps& gaps) {
    return gaps.is_written([] { return intersect(Surface{}, lantern::ray{}, lantern::interval{}); });
}

inline std::vector<thing> world(support::gaps& gaps) {
    std::vector<thing> things;
    const auto add = [&]<class Shape>(std::type_identity<Shape>, const std::vector<Shape>& shapes) {
        if (is_written<Shape>(gaps))
            for (const Shape& shape : shapes) things.push_back({shape});
    };
    add(std::type_identity<lab02::plane>{}, {{{0, 0, 0}, {0, 1, 0}}});
    add(std::type_identity<lab02::sphere>{}, {{{-1.1f, 1, 0}, 1}, {{0.4f, 0.45f, 1.5f}, 0.45f}, {{-0.6f, 0.25f, 1.9f}, 0.25f}});
    // A pyramid of four faces, seen counter-clockwise from outside.
    const glm::vec3 top{1.5f, 1.9f, 0}, front{1.3f, 0, 1.2f}, right{2.6f, 0, -0.6f}, left{0.4f, 0, -0.8f};
    add(std::type_identity<lab02::triangle>{}, {{front, right, top}, {right, left, top}, {left, front, top}, {front, left, right}});
    return things;
}

/// Until step 4 is done: whatever stands last in the list is seen, be it behind the others.
template <class Thing>
std::optional<lab02::nearest> last(std::span<const Thing> things, const lantern::ray& r) {
    std::optional<lab02::nearest> seen;
    for (std::uint32_t i = 0; i < things.size(); ++i)
        if (const auto h = intersect(things[i], r, {})) seen = lab02::nearest{*h, i};
    return seen;
}

inline bool in_order(support::gaps& gaps) {
    return gaps.is_written([] { return lab02::closest(std::span<const thing>{}, lantern::ray{}, lantern::interval{}); });
}

/// The colour of what a ray meets first; or last in the list.
template <class Thing>
struct shade {
    std::vector<Thing> things;
    bool in_order = true;

    glm::vec3 operator()(const lantern::ray& r, const auto&) const {
        const auto seen = in_order ? lab02::closest(std::span<const Thing>(things), r, lantern::interval{}) : last(std::span<const Thing>(things), r);
        if (!seen) return glm::mix(glm::vec3(0.75f, 0.85f, 1), glm::vec3(0.3f, 0.5f, 0.9f), glm::clamp(4 * r.direction.y, 0.0f, 1.0f));
        return 0.5f * seen->at.normal + 0.5f;
    }
};

}  // namespace pictures
