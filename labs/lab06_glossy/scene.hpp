// SPDX-License-Identifier: MIT
#pragma once
// The hall of lab 06: glossy balls in a row on a chequered floor, between small matt ones, under a sky with lamps.

#include "../support/pixels.hpp"

#include <lantern/camera.hpp>
#include <lantern/image.hpp>
#include <lantern/samples.hpp>
#include <lantern/sphere.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

namespace hall {

struct ball {
    lantern::sphere shape;
    glm::vec3 color{1};
    float width = -1;  // of the square; matt where negative
};

/// What happens at a ball that is not matt: the light that comes back along `in`. `look` follows a ray on from the ball.
using look = std::function<glm::vec3(glm::vec3 origin, glm::vec3 direction, std::uint32_t which)>;
using material = std::function<glm::vec3(const ball&, glm::vec3 in, const lantern::hit&, glm::vec2 xi, const look&)>;

inline std::vector<ball> row_of(const std::array<float, 5>& widths, glm::vec3 color) {
    std::vector<ball> balls;
    for (int i = 0; i < 5; ++i) balls.push_back({{{-4.8f + 2.4f * float(i), 1, 0}, 1}, color, widths[std::size_t(i)]});
    const std::array<glm::vec3, 3> paints{{{0.75f, 0.06f, 0.04f}, {0.03f, 0.2f, 0.6f}, {0.9f, 0.55f, 0.03f}}};
    for (int i = 0; i < 6; ++i) balls.push_back({{{-6 + 2.4f * float(i), 0.35f, 1.9f}, 0.35f}, paints[std::size_t(i) % 3]});
    return balls;
}

/// Evening, and four long lamps overhead.
inline glm::vec3 sky(glm::vec3 d) {
    if (d.y > 0.3f && std::abs(d.z / d.y) < 1.5f && std::abs(std::remainder(d.x / d.y, 0.9f)) < 0.09f && std::abs(d.x / d.y) < 2)
        return glm::vec3(2.6f, 2.3f, 1.9f);
    return glm::mix(glm::vec3(0.85f, 0.55f, 0.35f), glm::vec3(0.1f, 0.2f, 0.45f), std::sqrt(glm::clamp(d.y, 0.0f, 1.0f)));
}

/// The light along a ray.
class eye {
public:
    eye(const std::vector<ball>& balls, const material& what) : balls_(balls), what_(what) {}

    template <lantern::sample_source Source>
    glm::vec3 operator()(const lantern::ray& r, const Source& source, int depth = 0) const {
        lantern::interval range;
        const ball* nearest = nullptr;
        lantern::hit h;
        for (const ball& b : balls_)
            if (const auto found = intersect(b.shape, r, range)) {
                nearest = &b;
                h = *found;
                range.max = h.t;
            }
        const float t = -r.origin.y / r.direction.y;
        if (contains(range, t)) return floor(at(r, t));
        if (!nearest) return sky(r.direction);
        if (nearest->width < 0) return nearest->color * (0.35f + 0.65f * (0.5f + 0.5f * h.normal.y));
        if (depth == 6) return glm::vec3(0);
        return what_(*nearest, r.direction, h, source.draw2(lantern::purpose::gloss), [&](glm::vec3 origin, glm::vec3 direction, std::uint32_t which) {
            return (*this)({origin, direction}, source.branch(which), depth + 1);
        });
    }

private:
    /// Squares, darker where balls stand near: the part of the light from above that they hide, roughly.
    glm::vec3 floor(glm::vec3 p) const {
        float open = 1;
        for (const ball& b : balls_) {
            const glm::vec3 to = b.shape.center - p;
            const float distance = glm::length(to), sine = b.shape.radius / distance;
            open *= 1 - glm::clamp(sine * sine * to.y / distance, 0.0f, 1.0f);
        }
        const bool light = (int(std::floor(p.x / 1.2f)) + int(std::floor(p.z / 1.2f))) % 2 == 0;
        const float far = glm::clamp((glm::length(p) - 12) / 50, 0.0f, 1.0f);
        return glm::mix(open * (light ? glm::vec3(0.6f, 0.57f, 0.5f) : glm::vec3(0.06f, 0.07f, 0.09f)), sky({1, 0, 0}), far);
    }

    const std::vector<ball>& balls_;
    const material& what_;
};

/// The glossy metal that a function `reflected(in, normal, width, xi)` makes.
template <class Reflected>
material metal(Reflected reflected) {
    return [=](const ball& b, glm::vec3 in, const lantern::hit& h, glm::vec2 xi, const look& look_along) {
        const glm::vec3 out = reflected(in, h.normal, b.width, xi);
        if (glm::dot(out, h.normal) < 0) return glm::vec3(0);  // lost in the ball
        return b.color * look_along(leave(h, out), out, 0);
    };
}

/// What a picture of the hall is taken of, and how: side × side samples a pixel. `part` says what is shown: left, top, right and bottom as
/// fractions of the whole hall.
struct shot {
    glm::uvec2 size{0};
    std::uint32_t side = 1;
    std::vector<ball> balls{};
    material what{};
    glm::vec4 part{0, 0, 1, 1};
};

inline const lantern::camera<> whole{lantern::view{.eye = {0, 2.6f, 13}, .target = {0, 0.85f, 0}, .vertical_fov = 0.28f, .aspect = 3.4f}};

inline glm::vec3 sample(const shot& s, const lantern::jittered& sampler, glm::uvec2 pixel, std::uint32_t i) {
    const auto source = sampler.at(pixel, i);
    const glm::vec2 film = (glm::vec2(pixel) + source.draw2(lantern::purpose::film)) / glm::vec2(s.size);
    const glm::vec2 shown = glm::mix(glm::vec2(s.part.x, s.part.y), glm::vec2(s.part.z, s.part.w), film);
    return eye(s.balls, s.what)(shoot(whole, shown), source);
}

inline glm::vec3 pixel(const shot& s, glm::uvec2 at) {
    const lantern::jittered sampler{.side = s.side};
    return support::mean_of(sampler.count(), [&](std::uint32_t i) { return sample(s, sampler, at, i); });
}

inline lantern::image picture(const shot& s) {
    return support::picture_of(s.size, [&](glm::uvec2 at) { return pixel(s, at); });
}

}  // namespace hall
