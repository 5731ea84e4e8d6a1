// SPDX-License-Identifier: MIT
// The figures of lab 02's handout.

#include <lab02_surfaces/surfaces.hpp>

#include <lantern/camera.hpp>
#include <lantern/image.hpp>
#include <lantern/png.hpp>
#include <lantern/render.hpp>
#include <lantern/samples.hpp>

#include <glm/common.hpp>

#include <cmath>
#include <filesystem>
#include <functional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace {

constexpr glm::vec3 paper{1}, ink{0.02f}, red{0.8f, 0.03f, 0.02f}, blue{0.03f, 0.1f, 0.8f}, grey{0.7f};

/// A picture of a plane: 4 samples a pixel of what `color` says of the point.
lantern::image drawing(glm::uvec2 size, glm::vec2 centre, float height, const std::function<glm::vec3(glm::vec2)>& color) {
    lantern::image picture(size);
    for (unsigned y = 0; y < size.y; ++y)
        for (unsigned x = 0; x < size.x; ++x)
            for (unsigned i = 0; i < 4; ++i) {
                const glm::vec2 p = glm::vec2(x, y) + glm::vec2(i & 1, i >> 1) / 2.0f + 0.25f;
                const glm::vec2 from_middle = (p - glm::vec2(size) / 2.0f) * (height / float(size.y));
                picture(x, y) += 0.25f * color(centre + glm::vec2(from_middle.x, -from_middle.y));
            }
    return picture;
}

/// Rays from the left meet a sphere: the first solution red, the second blue.
lantern::image two_solutions() {
    const lab02::sphere ball{{0, 0, 0}, 1};
    return drawing({560, 300}, {-0.35f, 0}, 3, [&](glm::vec2 p) {
        glm::vec3 color = std::abs(glm::length(p) - 1) < 0.012f ? ink : paper;
        for (const float y : {-1.3f, -0.95f, -0.6f, 0.0f, 0.5f, 1.15f}) {
            const lantern::ray r{{-2.7f, y, 0}, {1, 0, 0}};
            const auto first = intersect(ball, r, {});
            if (std::abs(p.y - y) < 0.008f && p.x > r.origin.x) color = first && p.x > first->point.x ? grey : ink;
            if (!first) continue;
            if (glm::length(p - glm::vec2(first->point)) < 0.045f) color = red;
            const auto second = intersect(ball, r, {first->t, lantern::infinity});
            if (second && glm::length(p - glm::vec2(second->point)) < 0.045f) color = blue;
        }
        return color;
    });
}

/// A triangle, and u and v around it.
lantern::image inside() {
    const glm::vec2 a{0, 0}, b{2, 0.4f}, c{0.5f, 1.6f};
    const lab02::triangle t{{a, 0}, {b, 0}, {c, 0}};
    return drawing({420, 320}, {0.85f, 0.65f}, 2.9f, [&](glm::vec2 p) {
        const float area = (b - a).x * (c - a).y - (b - a).y * (c - a).x;
        const float u = ((p - a).x * (c - a).y - (p - a).y * (c - a).x) / area, v = ((b - a).x * (p - a).y - (b - a).y * (p - a).x) / area;
        const bool hit = intersect(t, lantern::ray{{p, 3}, {0, 0, -1}}, {}).has_value();
        const auto line = [](float x) { return std::abs(x) < 0.008f; };
        if (line(u) || line(v) || line(u + v - 1)) return ink;
        const glm::vec3 color{glm::clamp(u, 0.0f, 1.0f), glm::clamp(v, 0.0f, 1.0f), 0.25f};
        return hit ? color : 0.85f * paper + 0.12f * color;
    });
}

struct thing {
    std::variant<lab02::sphere, lab02::plane> shape;
};

std::optional<lantern::hit> intersect(const thing& one, const lantern::ray& r, lantern::interval range) {
    return std::visit([&](const auto& shape) { return intersect(shape, r, range); }, one.shape);
}

/// The same three things: on the left the last hit is seen, on the right the closest.
lantern::image order() {
    const std::vector<thing> things{{lab02::plane{}}, {lab02::sphere{{0, 0.8f, 1.2f}, 0.8f}}, {lab02::sphere{{0.9f, 0.8f, -0.6f}, 0.8f}}};
    const lantern::camera camera{lantern::view{.eye = {0.3f, 1.8f, 6}, .target = {0.3f, 0.8f, 0}, .aspect = 1}};
    const auto half = [&](auto&& seen) {
        return lantern::render({280, 280}, camera, lantern::jittered{.side = 3}, [&](const lantern::ray& r, const auto&) {
            const std::optional<lab02::nearest> n = seen(r);
            return n ? 0.5f * n->at.normal + 0.5f : glm::vec3(0.6f, 0.75f, 0.95f);
        });
    };
    const lantern::image wrong = half([&](const lantern::ray& r) {
        std::optional<lab02::nearest> last;
        for (std::uint32_t i = 0; i < things.size(); ++i)
            if (const auto h = intersect(things[i], r, {})) last = lab02::nearest{*h, i};
        return last;
    });
    const lantern::image right = half([&](const lantern::ray& r) { return lab02::closest(std::span<const thing>(things), r, {}); });
    lantern::image both({570, 280}, paper);
    for (unsigned y = 0; y < 280; ++y)
        for (unsigned x = 0; x < 280; ++x) {
            both(x, y) = wrong(x, y);
            both(x + 290, y) = right(x, y);
        }
    return both;
}

}  // namespace

int main(int argc, char** argv) {
    const std::filesystem::path folder = argc > 1 ? argv[1] : "labs/lab02_surfaces/figures";
    lantern::write_png(folder / "two_solutions.png", two_solutions());
    lantern::write_png(folder / "inside.png", inside());
    lantern::write_png(folder / "order.png", order());
}
