// SPDX-License-Identifier: MIT
// A Cornell box: what distribution ray tracing sees of it, and what path tracing adds, side by side.
//     cornell [PATH.png] [SAMPLES]
// left: light that comes straight from the lamp; right: all of it, from wall to wall and through the glass.

#include <lantern/any_of.hpp>
#include <lantern/camera.hpp>
#include <lantern/coated.hpp>
#include <lantern/diffuse.hpp>
#include <lantern/distribution.hpp>
#include <lantern/emissive.hpp>
#include <lantern/glass.hpp>
#include <lantern/glossy.hpp>
#include <lantern/object.hpp>
#include <lantern/path.hpp>
#include <lantern/rectangle.hpp>
#include <lantern/rectangle_light.hpp>
#include <lantern/render.hpp>
#include <lantern/sobol.hpp>
#include <lantern/sphere.hpp>

#include "picture.hpp"

#include <algorithm>
#include <variant>
#include <vector>

int main(int argc, char** argv) {
    return picture::main(argc, argv, "cornell", 256, [](const std::string& path, std::uint32_t samples) {
        using namespace lantern;
        using material = std::variant<diffuse, glass, coated<diffuse, glossy>, emissive>;
        using thing = object<any_of<rectangle, sphere>, material>;

        const diffuse white{{0.73f, 0.73f, 0.73f}}, red{{0.63f, 0.06f, 0.04f}}, green{{0.12f, 0.45f, 0.09f}};
        const rectangle_light lamp{{-0.5f, 1.998f, -0.4f}, {1, 0, 0}, {0, 0, 0.8f}, {15, 11.5f, 7.5f}};
        const std::vector<thing> things{
            {rectangle{{-1, 0, 1}, {2, 0, 0}, {0, 0, -2}}, white},    // floor
            {rectangle{{-1, 2, -1}, {2, 0, 0}, {0, 0, 2}}, white},    // ceiling
            {rectangle{{-1, 0, -1}, {2, 0, 0}, {0, 2, 0}}, white},    // back
            {rectangle{{-1, 0, 1}, {0, 0, -2}, {0, 2, 0}}, red},      // left
            {rectangle{{1, 0, -1}, {0, 0, 2}, {0, 2, 0}}, green},     // right
            {sphere{{-0.42f, 0.45f, -0.35f}, 0.45f}, coated{diffuse{{0.2f, 0.25f, 0.6f}}, glossy{.width = 0.15f}, 0.35f}},
            {sphere{{0.45f, 0.35f, 0.3f}, 0.35f}, glass{}},
            {surface_of(lamp), emissive{lamp.radiance}},              // so that the lamp is seen
        };
        const std::vector lights{lamp};
        const every all{static_cast<std::uint32_t>(things.size())};
        const camera cam{view{.eye = {0, 1, 4.6f}, .target = {0, 1, 0}, .vertical_fov = 0.58f}};

        constexpr std::uint32_t side = 400;
        auto progress = picture::bar("cornell");
        image sheet({2 * side, side});
        const auto put = [&](std::uint32_t column, const auto& tracer) {
            const image part = render({side, side}, cam, sobol{.samples = samples}, tracer,
                                      {.progress = [&](double done) { progress((column + done) / 2); }});
            for (std::uint32_t y = 0; y < side; ++y) std::ranges::copy(part.row(y), sheet.row(y).begin() + column * side);
            sheet.add_rejected(part.rejected());
        };
        put(0, distribution{all, things, lights});
        put(1, lantern::path{all, things, lights});
        picture::write(path, sheet);
    });
}
