// SPDX-License-Identifier: MIT
// The figures of lab 03's handout.

#include "../../labs/lab03_whitted/scene.hpp"

#include <lab03_whitted/whitted.hpp>

#include <lantern/camera.hpp>
#include <lantern/image.hpp>
#include <lantern/png.hpp>
#include <lantern/render.hpp>
#include <lantern/samples.hpp>

#include <glm/common.hpp>

#include <cmath>
#include <filesystem>
#include <functional>
#include <numbers>
#include <vector>

namespace {

using shade = std::function<glm::vec3(const lantern::ray&)>;

lantern::image rendered(glm::uvec2 size, const lantern::camera<>& camera, const shade& color) {
    return lantern::render(size, camera, lantern::jittered{.side = 3}, [&](const lantern::ray& r, const auto&) { return color(r); });
}

/// Pictures of one size, in rows.
lantern::image sheet(const std::vector<lantern::image>& pictures, unsigned columns) {
    const unsigned gap = 6;
    const glm::uvec2 one = pictures.front().size(), cells{columns, unsigned(pictures.size()) / columns};
    lantern::image made(cells * (one + gap) - gap, glm::vec3(1));
    for (unsigned i = 0; i < pictures.size(); ++i)
        for (unsigned y = 0; y < one.y; ++y)
            for (unsigned x = 0; x < one.x; ++x)
                made(i % columns * (one.x + gap) + x, i / columns * (one.y + gap) + y) = pictures[i](x, y);
    return made;
}

/// Whitted's scene with what the first `step` steps can do.
lantern::image stage(int step) {
    lab03::scene scene = lab03::whitted_scene();
    if (step >= 6) return rendered({300, 225}, lab03::whitted_camera({300, 225}), [&](const lantern::ray& r) { return lab03::trace(scene, r, 8); });
    return rendered({300, 225}, lab03::whitted_camera({300, 225}), [&](const lantern::ray& r) {
        const auto h = lab03::closest(scene, r);
        if (!h) return lab03::sky(scene, r.direction);
        const lab03::matte m = lab03::matte_at(scene.things[h->index].material, h->point).value_or(lab03::matte{.highlight = glm::vec3(0.5f)});
        glm::vec3 sum = (step == 0 ? glm::vec3(0.5f) : scene.ambient) * m.body;
        for (const lab03::light& l : scene.lights) {
            const glm::vec3 to_light = l.position - h->point;
            if (step == 0 || (step >= 2 && !lab03::lit(scene, *h, l.position))) continue;
            sum += l.intensity / glm::dot(to_light, to_light) * lab03::shade(m, h->normal, glm::normalize(to_light), -r.direction);
        }
        return sum;
    });
}

/// Body, highlight, and both, for three exponents.
lantern::image highlights() {
    std::vector<lantern::image> pictures;
    for (const lab03::matte& m : {lab03::matte{{0.7f, 0.25f, 0.1f}, glm::vec3(0), 1}, lab03::matte{{0.7f, 0.25f, 0.1f}, glm::vec3(0.6f), 5},
                                  lab03::matte{{0.7f, 0.25f, 0.1f}, glm::vec3(0.6f), 30}, lab03::matte{{0.7f, 0.25f, 0.1f}, glm::vec3(0.6f), 300}}) {
        const lab03::scene scene{.things = {{lantern::sphere{}, m}}, .lights = {{{-3, 4, 6}, glm::vec3(50)}}, .ambient = glm::vec3(0.1f), .horizon = glm::vec3(1), .zenith = glm::vec3(1)};
        pictures.push_back(rendered({150, 150}, lantern::camera<>{lantern::view{.eye = {0, 0, 6}, .target = {0, 0, 0}, .vertical_fov = 0.4f}},
                                    [&](const lantern::ray& r) { return lab03::trace(scene, r, 1); }));
    }
    return sheet(pictures, 4);
}

/// Where the shadow ray starts: at the rounded hit, a thousandth away from it, and where it should. The sphere's radius is
/// 30000.
lantern::image acne() {
    const float s = 30000;
    const lab03::matte matt{.body = glm::vec3(0.7f)};
    const lab03::scene scene{.things = {{lantern::plane{}, matt}, {lantern::sphere{{0, s, 0}, s}, matt}},
                             .lights = {{{-3 * s, 5 * s, 4 * s}, glm::vec3(40 * s * s)}},
                             .ambient = glm::vec3(0.2f)};
    const lantern::camera<> camera{lantern::view{.eye = {0, 1.6f * s, 5 * s}, .target = {0, 0.8f * s, 0}}};
    const auto with = [&](const std::function<glm::vec3(const lantern::hit&, glm::vec3)>& start) {
        return lantern::render({200, 200}, camera, lantern::jittered{.side = 1}, [&](const lantern::ray& r, const auto&) {
            const auto h = lab03::closest(scene, r);
            if (!h) return glm::vec3(0.6f, 0.75f, 0.95f);
            const glm::vec3 position = scene.lights[0].position, to_light = position - h->point;
            const glm::vec3 origin = start(*h, to_light);
            glm::vec3 sum = scene.ambient * matt.body;
            if (!lab03::occluded(scene, {origin, position - origin}, {0, 1}))
                sum += scene.lights[0].intensity / glm::dot(to_light, to_light) * lab03::shade(matt, h->normal, glm::normalize(to_light), -r.direction);
            return sum;
        });
    };
    return sheet({with([](const lantern::hit& h, glm::vec3) { return h.point; }),
                  with([](const lantern::hit& h, glm::vec3 to_light) { return h.point + 0.001f * glm::normalize(to_light); }),
                  with([](const lantern::hit& h, glm::vec3 to_light) { return lantern::leave(h, to_light); })}, 3);
}

/// The reflectance of glass by angle, from 0 to 90 degrees: from outside black, from inside red, Schlick's approximation grey.
lantern::image fresnel() {
    const glm::uvec2 size{450, 240};
    lantern::image picture(size, glm::vec3(1));
    const auto height = [&](float value) { return (1 - value) * float(size.y - 9) + 4; };
    const auto plot = [&](const std::function<float(float)>& curve, glm::vec3 color) {
        for (unsigned x = 0; x < size.x; ++x) {
            const auto at = [&](float column) { return height(curve(std::cos(column / float(size.x) * std::numbers::pi_v<float> / 2))); };
            const float low = std::min(at(float(x)), at(float(x) + 1)), high = std::max(at(float(x)), at(float(x) + 1));
            for (unsigned y = 0; y < size.y; ++y) {
                const float outside = std::max({0.0f, low - float(y), float(y) - high});
                picture(x, y) = glm::mix(color, picture(x, y), glm::clamp(outside - 0.7f, 0.0f, 1.0f));
            }
        }
    };
    for (unsigned i = 0; i <= 10; ++i)
        for (unsigned x = 0; x < size.x; ++x) picture(x, unsigned(height(float(i) / 10))) = glm::vec3(0.82f);
    for (unsigned i = 0; i < 9; ++i)
        for (unsigned y = 0; y < size.y; ++y) picture(i * size.x / 9, y) = glm::vec3(0.82f);
    plot([](float cosine) { return 0.04f + 0.96f * std::pow(1 - cosine, 5.0f); }, glm::vec3(0.45f));
    plot([](float cosine) { return lab03::reflectance(cosine, 1.5f); }, {0.8f, 0.03f, 0.02f});
    plot([](float cosine) { return lab03::reflectance(cosine, 1 / 1.5f); }, glm::vec3(0));
    return picture;
}

}  // namespace

int main(int argc, char** argv) {
    const std::filesystem::path folder = argc > 1 ? argv[1] : "labs/lab03_whitted/figures";
    lantern::write_png(folder / "stages.png", sheet({stage(0), stage(1), stage(2), stage(6)}, 2));
    lantern::write_png(folder / "highlights.png", highlights());
    lantern::write_png(folder / "acne.png", acne());
    lantern::write_png(folder / "fresnel.png", fresnel());
}
