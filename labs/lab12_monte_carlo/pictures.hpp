// SPDX-License-Identifier: MIT
#pragma once
// Lab 12's pictures: the program shows them with the student's code, the handout with ours.

#include "../support/pixels.hpp"

#include <lab12_monte_carlo/monte_carlo.hpp>

#include <lantern/camera.hpp>
#include <lantern/image.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

namespace pictures {

using shade = std::function<glm::vec3(const lantern::ray&, lab12::numbers&)>;

/// Sample i of a pixel, with numbers of its own.
inline glm::vec3 sample(glm::uvec2 size, const lantern::camera<>& cam, glm::uvec2 pixel, std::uint32_t i, const shade& look) {
    lab12::numbers random((std::size_t{pixel.y} * size.x + pixel.x) * 65536 + i);
    const glm::vec2 film = (glm::vec2(pixel) + random.two()) / glm::vec2(size);
    return look(shoot(cam, film), random);
}

/// The mean of so many samples.
inline glm::vec3 pixel(glm::uvec2 size, const lantern::camera<>& cam, glm::uvec2 at, std::uint32_t samples, const shade& look) {
    return support::mean_of(samples, [&](std::uint32_t i) { return sample(size, cam, at, i, look); });
}

inline lantern::image picture(glm::uvec2 size, const lantern::camera<>& cam, std::uint32_t samples, const shade& look) {
    return support::picture_of(size, [&](glm::uvec2 at) { return pixel(size, cam, at, samples, look); });
}

/// Panels beside each other, a white line between them.
inline lantern::image beside(const std::vector<lantern::image>& panels) {
    unsigned width = 0;
    for (const auto& p : panels) width += p.size().x + 2;
    lantern::image all({width - 2, panels[0].size().y}, glm::vec3(1));
    unsigned at = 0;
    for (const auto& p : panels) {
        for (unsigned y = 0; y < p.size().y; ++y) std::ranges::copy(p.row(y), all.row(y).begin() + at);
        at += p.size().x + 2;
    }
    return all;
}

// ---- steps 1 to 3: a white ball under an evening sky -----------------------------------------------------------------

inline glm::vec3 sky(glm::vec3 d) {
    const glm::vec3 sun = glm::normalize(glm::vec3(1, 0.8f, 0.6f));
    const glm::vec3 haze = glm::mix(glm::vec3(0.9f, 0.75f, 0.6f), glm::vec3(0.15f, 0.3f, 0.6f), std::sqrt(std::max(0.0f, d.y)));
    return (d.y < 0 ? glm::vec3(0.12f, 0.1f, 0.08f) : haze) + 6.0f * std::pow(std::max(0.0f, glm::dot(d, sun)), 40.0f) * glm::vec3(1, 0.8f, 0.5f);
}

inline lantern::image ball(std::uint32_t samples, const std::function<glm::vec3(glm::vec3 normal, lab12::numbers&)>& light) {
    const lantern::sphere white{{0, 0, 0}, 1};
    const lantern::camera cam{lantern::view{.eye = {0, 0, 5}, .target = {0, 0, 0}, .vertical_fov = 0.46f}};
    return picture({200, 200}, cam, samples, [&](const lantern::ray& r, lab12::numbers& random) {
        const auto h = intersect(white, r, lantern::interval{});
        return h ? light(h->normal, random) : sky(r.direction);
    });
}

/// Directions drawn evenly over the whole sphere, a density of 1/4π: half of them are in vain.
inline glm::vec3 anywhere(lab12::numbers& random) {
    const glm::vec2 xi = random.two();
    const float y = 1 - 2 * xi.x, r = std::sqrt(std::max(0.0f, 1 - y * y)), angle = 2 * std::numbers::pi_v<float> * xi.y;
    return {r * std::cos(angle), y, r * std::sin(angle)};
}

/// Step 1: 1, 4, 16, 64 samples of the light that a ball sends back.
inline lantern::image estimates() {
    std::vector<lantern::image> panels;
    for (const std::uint32_t samples : {1u, 4u, 16u, 64u})
        panels.push_back(ball(samples, [](glm::vec3 n, lab12::numbers& random) {
            const glm::vec3 d = anywhere(random), value = sky(d) * (0.7f / std::numbers::pi_v<float> * std::max(0.0f, glm::dot(n, d)));
            const float density = 1 / (4 * std::numbers::pi_v<float>);
            const auto one = [&](float v) {
                const lab12::drawn sample{v, density};
                return lab12::estimate({&sample, 1});
            };
            return glm::vec3(one(value.x), one(value.y), one(value.z));
        }));
    return beside(panels);
}

/// Step 2: 400 directions, seen from the side and from above.
inline lantern::image directions() {
    lantern::image all({402, 200}, glm::vec3(1));
    const auto put = [&](glm::vec2 p, unsigned left, glm::vec3 color) {
        const auto at = glm::ivec2(glm::vec2(100, 100) + 90.0f * glm::vec2(p.x, -p.y));
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x) all(left + unsigned(std::clamp(at.x + x, 0, 199)), unsigned(std::clamp(at.y + y, 0, 199))) = color;
    };
    for (int i = 0; i < 720; ++i) {
        const float a = float(i) * std::numbers::pi_v<float> / 360;
        put({std::cos(a), std::max(0.0f, std::sin(a))}, 0, glm::vec3(0.6f));
        put({std::cos(a), std::sin(a)}, 202, glm::vec3(0.6f));
    }
    lab12::numbers random(1);
    for (int i = 0; i < 400; ++i) {
        const glm::vec3 d = lab12::cosine_direction({0, 1, 0}, random.two());
        put({d.x, d.y}, 0, {0.1f, 0.2f, 0.6f});
        put({d.x, d.z}, 202, {0.1f, 0.2f, 0.6f});
    }
    return all;
}

/// Step 3: 16 directions, anywhere or by the cosine. The same light, and less noise.
inline lantern::image cosine() {
    return beside({ball(16, [](glm::vec3 n, lab12::numbers& random) {
                       const glm::vec3 d = anywhere(random);
                       return sky(d) * lab12::bounced(glm::vec3(1), glm::vec3(0.7f), n, d, 1 / (4 * std::numbers::pi_v<float>));
                   }),
                   ball(16, [](glm::vec3 n, lab12::numbers& random) {
                       const glm::vec3 d = lab12::cosine_direction(n, random.two());
                       return sky(d) * lab12::bounced(glm::vec3(1), glm::vec3(0.7f), n, d, lab12::cosine_density(n, d));
                   })});
}

// ---- steps 4 to 8: the Cornell box -----------------------------------------------------------------------------------

/// After Goral, Torrance, Greenberg and Battaile 1984: one red and one green wall, and a lamp in the ceiling.
inline lab12::scene cornell() {
    using namespace lab12;
    const auto quad = [](glm::vec3 corner, glm::vec3 u, glm::vec3 v, glm::vec3 color) { return wall{{corner, u, v}, {color, glm::vec3(0)}}; };
    const glm::vec3 white(0.73f), red(0.63f, 0.06f, 0.05f), green(0.12f, 0.45f, 0.1f);
    scene s;
    s.walls = {{{{-0.4f, 1.999f, -0.4f}, {0.8f, 0, 0}, {0, 0, 0.8f}}, {glm::vec3(0.1f), glm::vec3(18, 14, 9)}},
               quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, white),
               quad({-1, 2, -1}, {2, 0, 0}, {0, 0, 2}, white),
               quad({-1, 0, -1}, {2, 0, 0}, {0, 2, 0}, white),
               quad({-1, 0, 1}, {0, 0, -2}, {0, 2, 0}, red),
               quad({1, 0, -1}, {0, 0, 2}, {0, 2, 0}, green)};
    s.lamp = 0;
    const matter chalk{glm::vec3(0.78f), glm::vec3(0)}, blue{{0.25f, 0.35f, 0.7f}, glm::vec3(0)};
    s.balls = {{lantern::sphere{{-0.42f, 0.5f, -0.35f}, 0.5f}, chalk, chalk}, {lantern::sphere{{0.45f, 0.32f, 0.35f}, 0.32f}, blue, blue}};
    return s;
}

inline lantern::camera<> before_the_box() {
    return lantern::camera{lantern::view{.eye = {0, 1, 4.7f}, .target = {0, 1, 0}, .vertical_fov = 0.56f}};
}

/// Steps 4 and 5: light straight from the lamp.
inline glm::vec3 direct_light(const lab12::scene& s, const lantern::ray& r, lab12::numbers& random) {
    const auto f = find(s, r);
    return f ? f->what.emission + lab12::from_lamp(s, *f, random.two()).light : glm::vec3(0);
}
inline lantern::image direct(std::uint32_t samples) {
    const lab12::scene s = cornell();
    return picture({300, 300}, before_the_box(), samples, [&](const lantern::ray& r, lab12::numbers& random) { return direct_light(s, r, random); });
}

/// Step 6: a floor before a bright screen that stands on it. Shadow rays alone, bounces alone, both with their shares.
inline lantern::image two_ways(std::uint32_t samples = 16) {
    using namespace lab12;
    scene s;
    s.walls = {{{{-1.2f, 0, 0}, {2.4f, 0, 0}, {0, 1.2f, 0}}, {glm::vec3(0), glm::vec3(2, 1.7f, 1.2f)}},
               {{{-30, 0, 30}, {60, 0, 0}, {0, 0, -60}}, {glm::vec3(0.7f), glm::vec3(0)}}};
    s.lamp = 0;
    const lantern::camera cam{lantern::view{.eye = {0, 2.2f, 5}, .target = {0, 0.2f, 0.8f}, .vertical_fov = 0.55f}};
    std::vector<lantern::image> panels;
    for (int way = 0; way < 3; ++way)
        panels.push_back(picture({220, 220}, cam, samples, [&](const lantern::ray& r, lab12::numbers& random) {
            const auto f = find(s, r);
            if (!f) return glm::vec3(0);
            glm::vec3 sum = f->what.emission;
            if (f->is_lamp) return sum;
            const lit straight = from_lamp(s, *f, random.two());
            const glm::vec3 d = cosine_direction(f->at.normal, random.two());
            const float density = cosine_density(f->at.normal, d);
            const auto other = find(s, {lantern::leave(f->at, d), d});
            const glm::vec3 met = other && other->is_lamp ? bounced(other->what.emission, f->what.albedo, f->at.normal, d, density) : glm::vec3(0);
            if (way == 0) return sum + straight.light;
            if (way == 1) return sum + met;
            sum += share(straight.density, cosine_density(f->at.normal, straight.direction)) * straight.light;
            if (met != glm::vec3(0)) sum += share(density, lamp_density(s.walls[0].shape, other->at.point, f->at.point)) * met;
            return sum;
        }));
    return beside(panels);
}

/// Step 7: how much of 1000 paths with a throughput of .8 a bounce is still on its way after 0, 1, 2, … bounces: the bars are
/// how many there are, the line what they carry together.
inline lantern::image survivors() {
    lantern::image all({402, 200}, glm::vec3(1));
    std::vector<float> carried(1000, 1.0f);
    lab12::numbers random(2);
    for (unsigned bounce = 0; bounce < 20; ++bounce) {
        float sum = 0;
        unsigned going = 0;
        for (const float c : carried) sum += c / 1000, going += c > 0;
        for (unsigned y = 0; y < 180; ++y)
            for (unsigned x = 2; x < 18; ++x) {
                const float level = 1 - float(y) / 180;
                if (level < float(going) / 1000) all(20 * bounce + x, 10 + y) = {0.35f, 0.5f, 0.8f};
                if (std::abs(level - sum) < 0.012f) all(20 * bounce + x, 10 + y) = {0.8f, 0.2f, 0.05f};
            }
        for (float& c : carried) {
            if (c == 0) continue;
            const auto kept = lab12::roulette(glm::vec3(0.8f * c), random.one());
            c = kept ? kept->x : 0;
        }
    }
    return all;
}

/// Step 8: all of the light.
inline lantern::image box(std::uint32_t samples, unsigned side = 300) {
    const lab12::scene s = cornell();
    return picture({side, side}, before_the_box(), samples, [&](const lantern::ray& r, lab12::numbers& random) { return lab12::radiance(s, r, random); });
}

}  // namespace pictures
