// SPDX-License-Identifier: MIT
#pragma once
// The stage of lab 08: balls that fly, fall and rest, on a polished floor, in the light of one lamp; and one of glass.

#include <lab08_shutter/shutter.hpp>

#include <lantern/camera.hpp>
#include <lantern/image.hpp>
#include <lantern/render.hpp>
#include <lantern/samples.hpp>
#include <lantern/surface.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace stage {

using lab08::moving_sphere;
using lab08::timed_ray;

struct ball {
    moving_sphere shape;
    glm::vec3 color{1};
    bool glass = false;
};

inline std::vector<ball> balls() {
    return {
        {{{-2.8f, 0.8f, 0}, {1.1f, 0, 0}, 0.8f}, {0.8f, 0.07f, 0.05f}},
        {{{0.8f, 2.7f, -0.6f}, {0.1f, -0.9f, 0}, 0.6f}, {0.04f, 0.25f, 0.75f}},
        {{{2.9f, 0.9f, 0}, {0, 0, 0}, 0.9f}, {0.1f, 0.45f, 0.12f}},
        {{{0.3f, 0.35f, 2.4f}, {0.7f, 0, -0.2f}, 0.35f}, {0.95f, 0.6f, 0.05f}},
        {{{-2.6f, 0.5f, 2.6f}, {0, 0, 0}, 0.5f}, glm::vec3(1), true},
    };
}

inline constexpr glm::vec3 lamp{-4, 9, 6};

/// What the picture asks of the lab. The handout puts mistakes into it.
struct parts {
    std::function<std::optional<float>(const moving_sphere&, const timed_ray&)> intersect = lab08::intersect;
    std::function<timed_ray(const timed_ray&, glm::vec3, glm::vec3)> shadow = lab08::shadow_ray;
    std::function<timed_ray(const timed_ray&, glm::vec3, glm::vec3)> reflected = lab08::reflected_ray;
    std::function<std::optional<timed_ray>(const timed_ray&, glm::vec3, glm::vec3, float)> refracted = lab08::refracted_ray;
    bool alone = false;  ///< no rays go on: neither shadows nor reflections
};

/// Whoever watches is asked for the light along each ray, and may look for it, or know better. Nobody just looks.
struct nobody {
    template <class Look>
    glm::vec3 operator()(const timed_ray&, const Look& look) const {
        return look();
    }
};

template <class Watch = nobody>
class eye {
public:
    explicit eye(parts what, Watch watch = {}) : what_(std::move(what)), watch_(std::move(watch)) {}

    [[nodiscard]] glm::vec3 operator()(const timed_ray& r, int depth = 0) const {
        return watch_(r, [&] { return light(r, depth); });
    }

private:
    glm::vec3 light(const timed_ray& r, int depth) const {
        const ball* nearest = nullptr;
        float t = std::numeric_limits<float>::infinity();
        for (const ball& b : balls_)
            if (const auto found = what_.intersect(b.shape, r); found && *found < t) {
                nearest = &b;
                t = *found;
            }
        const float floor = -r.origin.y / r.direction.y;
        if (floor > 0 && floor < t) return on_floor(r, {floor, (r.origin + floor * r.direction) * glm::vec3(1, 0, 1), {0, 1, 0}}, depth);
        if (!nearest) return sky(glm::normalize(r.direction));

        const glm::vec3 center = nearest->shape.center + r.time * nearest->shape.velocity;
        const glm::vec3 normal = glm::normalize(r.origin + t * r.direction - center);
        const lantern::hit h{t, center + nearest->shape.radius * normal, normal};
        if (nearest->glass) return through_glass(r, h, depth);
        return lit(r, h, nearest->color) + mirrored(r, h, 0.08f, depth);
    }

    static glm::vec3 sky(glm::vec3 d) { return glm::mix(glm::vec3(0.3f, 0.34f, 0.4f), glm::vec3(0.05f, 0.1f, 0.22f), glm::clamp(d.y * 2, 0.0f, 1.0f)); }

    /// Light from the lamp, where a shadow ray reaches it, and a little from everywhere.
    glm::vec3 lit(const timed_ray& r, const lantern::hit& h, glm::vec3 color) const {
        const glm::vec3 to_lamp = lamp - h.point;
        float light = std::max(glm::dot(glm::normalize(to_lamp), h.normal), 0.0f);
        if (light > 0 && !what_.alone) {
            const timed_ray shadow = what_.shadow(r, leave(h, to_lamp), lamp);
            for (const ball& b : balls_)
                if (const auto t = what_.intersect(b.shape, shadow); t && *t < 1) light *= b.glass ? 0.6f : 0.0f;
        }
        return color * (0.22f + 1.1f * light);
    }

    glm::vec3 mirrored(const timed_ray& r, const lantern::hit& h, float part, int depth) const {
        if (depth >= 4 || what_.alone) return glm::vec3(0);
        const glm::vec3 normal = glm::dot(r.direction, h.normal) < 0 ? h.normal : -h.normal;
        const timed_ray next = what_.reflected(r, leave(h, normal), normal);
        return part * (*this)(next, depth + 1);
    }

    glm::vec3 on_floor(const timed_ray& r, const lantern::hit& h, int depth) const {
        const bool light = (int(std::floor(h.point.x)) + int(std::floor(h.point.z))) % 2 == 0;
        const float far = glm::clamp((glm::length(h.point) - 8) / 30, 0.0f, 1.0f);
        const glm::vec3 near = lit(r, h, light ? glm::vec3(0.4f, 0.37f, 0.32f) : glm::vec3(0.1f, 0.1f, 0.12f)) + mirrored(r, h, 0.35f, depth);
        return glm::mix(near, sky({1, 0, 0}), far);
    }

    glm::vec3 through_glass(const timed_ray& r, const lantern::hit& h, int depth) const {
        if (depth >= 6 || what_.alone) return glm::vec3(0.3f);
        const bool enters = glm::dot(r.direction, h.normal) < 0;
        const glm::vec3 normal = enters ? h.normal : -h.normal;
        const auto next = what_.refracted(r, leave(h, -normal), normal, enters ? 1 / 1.5f : 1.5f);
        return 0.95f * (next ? (*this)(*next, depth + 1) : (*this)(what_.reflected(r, leave(h, normal), normal), depth + 1));
    }

    std::vector<ball> balls_ = balls();
    parts what_;
    Watch watch_;
};

inline lantern::camera<> camera() { return lantern::camera{lantern::view{.eye = {0, 1.9f, 9}, .target = {0, 1.2f, 0}, .vertical_fov = 0.46f, .aspect = 2.4f}}; }

/// A shade for lantern::render: each sample at its own moment while the shutter is open.
template <class Watch>
struct exposed {
    eye<Watch> seen;
    float open = 0, close = 1;

    glm::vec3 operator()(const lantern::ray& r, const auto& source) const {
        return seen({r.origin, r.direction, lab08::moment(open, close, source.draw1(lantern::purpose::time))});
    }
};

/// side × side samples a pixel.
inline lantern::image taken(glm::uvec2 size, std::uint32_t side, const parts& what, float open = 0, float close = 1) {
    return lantern::render(size, camera(), lantern::multi_jittered{.side = side}, exposed<nobody>{eye<>(what), open, close});
}

}  // namespace stage
