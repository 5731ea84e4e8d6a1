// SPDX-License-Identifier: MIT
// The five effects, added one by one: a sheet of six pictures. Each picture's types hold what it needs and no more.
//     effects [PATH.png] [SAMPLES]
// top row: one sample for everything; antialiasing; soft shadows.   bottom row: gloss; depth of field; motion blur.

#include <lantern/any_of.hpp>
#include <lantern/camera.hpp>
#include <lantern/centered.hpp>
#include <lantern/coated.hpp>
#include <lantern/diffuse.hpp>
#include <lantern/distribution.hpp>
#include <lantern/glossy.hpp>
#include <lantern/light.hpp>
#include <lantern/mirror.hpp>
#include <lantern/moving.hpp>
#include <lantern/object.hpp>
#include <lantern/rectangle.hpp>
#include <lantern/rectangle_light.hpp>
#include <lantern/render.hpp>
#include <lantern/sobol.hpp>
#include <lantern/sphere.hpp>
#include <lantern/whitted.hpp>

#include "picture.hpp"

#include <algorithm>
#include <type_traits>
#include <vector>

namespace {

enum stage { basic, antialiased, soft, blurred, focused, rolling };

constexpr glm::uvec2 panel{400, 300};

template <stage Stage>
lantern::image picture_of(std::uint32_t samples) {
    using namespace lantern;
    using shape = std::conditional_t<(Stage < rolling), any_of<sphere, rectangle>,
                                     any_of<sphere, moving<sphere>, rectangle>>;
    using coat = std::conditional_t<(Stage < blurred), mirror, glossy>;
    using thing = object<shape, coated<diffuse, coat>>;

    const auto coating = [](float width) {
        if constexpr (Stage < blurred) return mirror{};
        else return glossy{glm::vec3(1), width};
    };
    const auto rolled = [](const sphere& s, glm::vec3 way) {
        if constexpr (Stage < rolling) return sphere{s.center + 0.5f * way, s.radius};
        else return moving{s, way};
    };
    const std::vector<thing> things{
        {rectangle{{-40, 0, 20}, {80, 0, 0}, {0, 0, -120}}, {diffuse{{0.32f, 0.36f, 0.42f}}, coating(0.3f), 0.3f}},
        {sphere{{0, 1, 0}, 1}, {diffuse{{0.75f, 0.55f, 0.12f}}, coating(0.2f), 0.5f}},
        {rolled(sphere{{1.75f, 0.7f, 1.1f}, 0.7f}, {0.8f, 0, 0}), {diffuse{{0.06f, 0.22f, 0.65f}}, coating(0.02f), 0.08f}},
        {sphere{{-1.9f, 0.8f, 1.2f}, 0.8f}, {diffuse{{0.75f, 0.07f, 0.05f}}, coating(0.02f), 0.08f}},
        {sphere{{-3.6f, 1, -7}, 1}, {diffuse{{0.1f, 0.5f, 0.12f}}, coating(0.02f), 0.08f}},
        {sphere{{3.8f, 1, -10}, 1}, {diffuse{{0.6f, 0.12f, 0.5f}}, coating(0.02f), 0.08f}},
    };
    const auto lights = [] {
        const rectangle_light lamp{{-4.5f, 7, 1}, {0, 0, 3}, {-3, 0, 0}, glm::vec3(22)};
        const glm::vec3 middle = lamp.corner + 0.5f * (lamp.edge_u + lamp.edge_v);
        if constexpr (Stage < soft) return std::vector{point_light{middle, glm::vec3(22 * 9 * 0.85f)}};
        else return std::vector{lamp};
    }();
    const every all{static_cast<std::uint32_t>(things.size())};
    const sky evening{.horizon = {0.45f, 0.5f, 0.6f}, .zenith = {0.12f, 0.18f, 0.35f}};
    const glm::vec3 ambient(0.12f);

    const view seat{.eye = {0, 2.6f, 9}, .target = {0, 0.9f, 0}, .vertical_fov = 0.55f, .aspect = 4.0f / 3};
    const thin_lens lens{.radius = 0.15f, .focus_distance = 9};
    const auto cam = [&] {
        if constexpr (Stage < focused) return camera{seat};
        else if constexpr (Stage < rolling) return camera{seat, lens};
        else return camera{seat, lens, shutter{}};
    }();
    const auto tracer = [&] {
        if constexpr (Stage < soft) return whitted{all, things, lights, evening, {.ambient = ambient}};
        else return distribution{all, things, lights, evening, {.ambient = ambient}};
    }();
    if constexpr (Stage == basic) return render(panel, cam, centered{}, tracer);
    else return render(panel, cam, sobol{.samples = samples}, tracer);
}

}  // namespace

int main(int argc, char** argv) {
    return picture::main(argc, argv, "effects", 64, [](const std::string& path, std::uint32_t samples) {
        auto progress = picture::bar("effects");
        lantern::image sheet({3 * panel.x, 2 * panel.y});
        std::uint32_t done = 0;
        for (const auto picture : {picture_of<basic>, picture_of<antialiased>, picture_of<soft>, picture_of<blurred>,
                                   picture_of<focused>, picture_of<rolling>}) {
            const lantern::image part = picture(samples);
            const glm::uvec2 corner = panel * glm::uvec2(done % 3, done / 3);
            for (std::uint32_t y = 0; y < panel.y; ++y)
                std::ranges::copy(part.row(y), sheet.row(corner.y + y).begin() + corner.x);
            sheet.add_rejected(part.rejected());
            progress(++done / 6.0);
        }
        picture::write(path, sheet);
    });
}
