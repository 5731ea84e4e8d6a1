// SPDX-License-Identifier: MIT
// Lab 02: a small world in the colours of its normals. What is not written yet is not there.

#include "../support/gaps.hpp"

#include <lab02_surfaces/surfaces.hpp>

#include <lantern/camera.hpp>
#include <lantern/png.hpp>
#include <lantern/render.hpp>
#include <lantern/samples.hpp>

#include <glm/common.hpp>

#include <exception>
#include <filesystem>
#include <iostream>
#include <optional>
#include <span>
#include <type_traits>
#include <variant>
#include <vector>

namespace {

support::gaps gaps;

template <class Surface>
bool is_written() {
    return gaps.is_written([] { return intersect(Surface{}, lantern::ray{}, lantern::interval{}); });
}

struct thing {
    std::variant<lab02::sphere, lab02::plane, lab02::triangle> shape;
};

std::optional<lantern::hit> intersect(const thing& one, const lantern::ray& r, lantern::interval range) {
    return std::visit([&](const auto& shape) { return intersect(shape, r, range); }, one.shape);
}

/// Until step 4 is done: whatever stands last in the list is seen, be it behind the others.
std::optional<lab02::nearest> last(std::span<const thing> things, const lantern::ray& r) {
    std::optional<lab02::nearest> seen;
    for (std::uint32_t i = 0; i < things.size(); ++i)
        if (const auto h = intersect(things[i], r, {})) seen = lab02::nearest{*h, i};
    return seen;
}

std::vector<thing> world() {
    std::vector<thing> things;
    const auto add = [&]<class Shape>(std::type_identity<Shape>, const std::vector<Shape>& shapes) {
        if (is_written<Shape>())
            for (const Shape& shape : shapes) things.push_back({shape});
    };
    add(std::type_identity<lab02::plane>{}, {{{0, 0, 0}, {0, 1, 0}}});
    add(std::type_identity<lab02::sphere>{}, {{{-1.1f, 1, 0}, 1}, {{0.4f, 0.45f, 1.5f}, 0.45f}, {{-0.6f, 0.25f, 1.9f}, 0.25f}});
    // A pyramid of four faces, seen counter-clockwise from outside.
    const glm::vec3 top{1.5f, 1.9f, 0}, front{1.3f, 0, 1.2f}, right{2.6f, 0, -0.6f}, left{0.4f, 0, -0.8f};
    add(std::type_identity<lab02::triangle>{}, {{front, right, top}, {right, left, top}, {left, front, top}, {front, left, right}});
    return things;
}

lantern::image picture(glm::uvec2 size) {
    const std::vector<thing> things = world();
    const bool in_order = gaps.is_written([] { return lab02::closest(std::span<const thing>{}, lantern::ray{}, lantern::interval{}); });
    if (things.empty()) {
        lantern::image card(size);
        support::paint_test_card(card, {0, 0}, size, gaps.next_step());
        return card;
    }
    const lantern::camera camera{lantern::view{.eye = {0.3f, 1.7f, 6.5f}, .target = {0.3f, 0.85f, 0}, .aspect = float(size.x) / float(size.y)}};
    return lantern::render(size, camera, lantern::jittered{.side = 3}, [&](const lantern::ray& r, const auto&) {
        const auto seen = in_order ? lab02::closest(std::span<const thing>(things), r, lantern::interval{}) : last(things, r);
        if (!seen) return glm::mix(glm::vec3(0.75f, 0.85f, 1), glm::vec3(0.3f, 0.5f, 0.9f), glm::clamp(4 * r.direction.y, 0.0f, 1.0f));
        return 0.5f * seen->at.normal + 0.5f;
    });
}

}  // namespace

int main(int argc, char** argv) try {
    const std::filesystem::path path = std::filesystem::path(argc > 1 ? argv[1] : "out") / "lab02.png";
    lantern::write_png(path, picture({640, 480}));
    std::cout << path.string() << '\n';
    gaps.tell();
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
