// SPDX-License-Identifier: MIT
#pragma once
// Lab 12: Monte Carlo, the full ray tracer. The handout is README.md in this folder.

#include <lantern/basis.hpp>
#include <lantern/interval.hpp>
#include <lantern/ray.hpp>
#include <lantern/rectangle.hpp>
#include <lantern/sphere.hpp>
#include <lantern/surface.hpp>
#include <lantern/todo.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

namespace lab12 {

// ---- given ------------------------------------------------------------------------------------------------------------

/// A matt surface: what part of the light it sends back, and what light it gives by itself, the same in all directions.
struct matter {
    glm::vec3 albedo{0.5f};
    glm::vec3 emission{0};
};

/// A ball of two halves: `upper` where y is above that of the centre.
struct ball {
    lantern::sphere shape;
    matter upper{}, lower{};
};

/// A parallelogram. It gives light to the side of u × v only.
struct wall {
    lantern::rectangle shape;
    matter what{};
};

struct scene {
    std::vector<ball> balls;
    std::vector<wall> walls;
    std::optional<std::size_t> lamp{};  ///< which of the walls shadow rays are sent to
};

/// What a ray meets first. The normal has length 1 and is on the side that the ray comes from.
struct found {
    lantern::hit at;
    matter what;           ///< its emission is already 0 where the ray sees the back of a wall
    bool is_lamp = false;  ///< whether it is the lamp's front
};

[[nodiscard]] inline std::optional<found> find(const scene& s, const lantern::ray& r) {
    std::optional<found> best;
    const auto meet = [&](const auto& shape) { return intersect(shape, r, {0, best ? best->at.t : lantern::infinity}); };
    for (const ball& b : s.balls)
        if (const auto h = meet(b.shape)) best = found{*h, h->point.y > b.shape.center.y ? b.upper : b.lower, false};
    for (std::size_t i = 0; i < s.walls.size(); ++i)
        if (const auto h = meet(s.walls[i].shape)) {
            best = found{*h, s.walls[i].what, false};
            if (glm::dot(h->normal, r.direction) >= 0) best->what.emission = glm::vec3(0);
            else best->is_lamp = s.lamp == i;
        }
    if (best && glm::dot(best->at.normal, r.direction) > 0) best->at.normal = -best->at.normal;
    return best;
}

/// Whether anything stands between a hit and a point of the lamp. (The lamp itself does not.)
[[nodiscard]] inline bool blocked(const scene& s, const lantern::hit& from, glm::vec3 point) {
    const glm::vec3 origin = lantern::leave(from, point - from.point);
    const lantern::ray r{origin, point - origin};
    const auto meets = [&](const auto& thing) { return intersect(thing.shape, r, {0, 1}).has_value(); };
    for (std::size_t i = 0; i < s.walls.size(); ++i)
        if (s.lamp != i && meets(s.walls[i])) return true;
    return std::ranges::any_of(s.balls, meets);
}

/// Random numbers in [0, 1), the same for the same seed on every machine (SplitMix64; Steele, Lea and Flood 2014).
class numbers {
public:
    explicit numbers(std::uint64_t seed) : state_(seed) { state_ = next(); }  // or near seeds would give shifted numbers

    float one() { return static_cast<float>(next() >> 40) * 0x1p-24f; }
    glm::vec2 two() {
        const float x = one(), y = one();
        return {x, y};
    }

private:
    std::uint64_t state_;

    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
};

/// A sample: the value of a function at a point, and how densely the point was drawn there.
struct drawn {
    float value = 0;
    float density = 1;  ///< above 0
};

/// Light that came straight from the lamp and is reflected, as one shadow ray sees it.
struct lit {
    glm::vec3 light{0};      ///< reflected radiance; 0 where the lamp does not shine or something is in the way
    glm::vec3 direction{0};  ///< of the shadow ray; length 1
    float density = 0;       ///< how densely that direction was drawn, per solid angle; 0 when there is no light
};

// ---- yours ------------------------------------------------------------------------------------------------------------

/// Step 1. An estimate of the integral of a function from samples of it: the mean of value / density. No samples: 0.
[[nodiscard]] inline float estimate(std::span<const drawn> samples) {
    // BEGIN SOLUTION
    if (samples.empty()) return 0;
    double sum = 0;
    for (const drawn& s : samples) sum += double(s.value) / double(s.density);
    return static_cast<float>(sum / double(samples.size()));
    // END SOLUTION
    // STARTER: return lantern::todo("lab12 step 1: the estimator");
}

/// Step 2. A direction of length 1 on the side of the normal, denser towards it: a point of the unit square becomes a point of
/// the unit disc, evenly, and is raised to the hemisphere. lantern::basis_from(w) gives unit vectors u, v and w.
[[nodiscard]] inline glm::vec3 cosine_direction(glm::vec3 normal, glm::vec2 xi) {
    // BEGIN SOLUTION
    const float radius = std::sqrt(xi.x), angle = 2 * std::numbers::pi_v<float> * xi.y;
    const lantern::basis b = lantern::basis_from(normal);
    return glm::normalize(radius * std::cos(angle) * b.u + radius * std::sin(angle) * b.v + std::sqrt(1 - xi.x) * b.w);
    // END SOLUTION
    // STARTER: return lantern::todo("lab12 step 2: a direction by the cosine");
}

/// Step 2, too. How densely that function draws a direction, per solid angle: cos θ / π, and 0 below the surface.
[[nodiscard]] inline float cosine_density(glm::vec3 normal, glm::vec3 direction) {
    // BEGIN SOLUTION
    return std::max(0.0f, glm::dot(normal, direction)) * std::numbers::inv_pi_v<float>;
    // END SOLUTION
    // STARTER: return lantern::todo("lab12 step 2: how densely it is drawn");
}

/// Step 3. What a path carries after a bounce off a matt surface: the throughput before it, times albedo/π, times the cosine,
/// divided by the density with which the direction was drawn. Nothing is carried below the surface, nor at a density of 0.
[[nodiscard]] inline glm::vec3 bounced(glm::vec3 throughput, glm::vec3 albedo, glm::vec3 normal, glm::vec3 direction, float density) {
    // BEGIN SOLUTION
    const float cosine = glm::dot(normal, direction);
    if (!(cosine > 0 && density > 0)) return glm::vec3(0);
    return throughput * albedo * (std::numbers::inv_pi_v<float> * cosine / density);
    // END SOLUTION
    // STARTER: return lantern::todo("lab12 step 3: what a bounce carries");
}

/// Step 4. When a point of the lamp is drawn evenly by area: how densely the direction from `from` to `on_lamp` is drawn, per
/// solid angle. 0 behind the lamp, which shines to the side of u × v.
[[nodiscard]] inline float lamp_density(const lantern::rectangle& lamp, glm::vec3 on_lamp, glm::vec3 from) {
    // BEGIN SOLUTION
    const glm::vec3 area_normal = glm::cross(lamp.u, lamp.v), way = from - on_lamp;  // as long as the area
    const float d2 = glm::dot(way, way), area_cosine = glm::dot(area_normal, way) / std::sqrt(d2);
    return area_cosine > 0 ? d2 / area_cosine : 0;
    // END SOLUTION
    // STARTER: return lantern::todo("lab12 step 4: how densely the lamp is drawn");
}

/// Step 5. The light of the lamp that a matt surface sends back, by a shadow ray to the point corner + ξ u + ξ' v of the lamp:
/// its emission, as a bounce carries it. Nothing without a lamp, below the surface, behind the lamp, or when it is blocked.
[[nodiscard]] inline lit from_lamp(const scene& s, const found& f, glm::vec2 xi) {
    // BEGIN SOLUTION
    if (!s.lamp) return {};
    const wall& lamp = s.walls[*s.lamp];
    const glm::vec3 point = lamp.shape.corner + xi.x * lamp.shape.u + xi.y * lamp.shape.v;
    const glm::vec3 direction = glm::normalize(point - f.at.point);
    const float density = lamp_density(lamp.shape, point, f.at.point);
    const glm::vec3 light = bounced(lamp.what.emission, f.what.albedo, f.at.normal, direction, density);
    if (light == glm::vec3(0) || blocked(s, f.at, point)) return {};
    return {light, direction, density};
    // END SOLUTION
    // STARTER: return lantern::todo("lab12 step 5: light straight from the lamp");
}

/// Step 6. Two ways draw the same direction, one with the density `mine`, the other with `other`: the share of the first. Both
/// shares add up to 1. From 0 to 1e30; a way that never draws the direction has no share.
[[nodiscard]] inline float share(float mine, float other) {
    // BEGIN SOLUTION
    if (!(mine > 0)) return 0;
    const float ratio = other / mine;
    return 1 / (1 + ratio * ratio);
    // END SOLUTION
    // STARTER: return lantern::todo("lab12 step 6: two ways to the lamp");
}

/// Step 7. Whether a path goes on: with a probability equal to the largest component of its throughput, but never above
/// 0.9999; xi in [0, 1) decides. What goes on carries more, so that the mean stays what it was. Nothing: the path ends.
[[nodiscard]] inline std::optional<glm::vec3> roulette(glm::vec3 throughput, float xi) {
    // BEGIN SOLUTION
    const float chance = std::min(0.9999f, std::max({throughput.x, throughput.y, throughput.z}));
    if (!(xi < chance)) return std::nullopt;
    return throughput / chance;
    // END SOLUTION
    // STARTER: lantern::todo("lab12 step 7: Russian roulette");
}

/// Step 8. The radiance along a ray, by one path: at every hit what shines there and what comes straight from the lamp, then one
/// bounce, until nothing is met or roulette, from the fourth bounce on, ends it. The lamp is found in two ways, and each gets its
/// share. What else shines is found by bounces alone; so is all that the eye sees.
[[nodiscard]] inline glm::vec3 radiance(const scene& s, lantern::ray r, numbers& random) {
    // BEGIN SOLUTION
    glm::vec3 sum{0}, throughput{1}, from{0};
    float density = 0;  // of the ray's direction
    for (int bounce = 0;; ++bounce) {
        const auto f = find(s, r);
        if (!f) return sum;
        const float part = f->is_lamp && bounce > 0 ? share(density, lamp_density(s.walls[*s.lamp].shape, f->at.point, from)) : 1;
        sum += throughput * part * f->what.emission;

        const lit straight = from_lamp(s, *f, random.two());
        sum += throughput * share(straight.density, cosine_density(f->at.normal, straight.direction)) * straight.light;

        const glm::vec3 direction = cosine_direction(f->at.normal, random.two());
        density = cosine_density(f->at.normal, direction);
        throughput = bounced(throughput, f->what.albedo, f->at.normal, direction, density);
        if (throughput == glm::vec3(0)) return sum;
        if (bounce >= 3) {
            const auto kept = roulette(throughput, random.one());
            if (!kept) return sum;
            throughput = *kept;
        }
        from = f->at.point;
        r = {lantern::leave(f->at, direction), direction};
    }
    // END SOLUTION
    // STARTER: return lantern::todo("lab12 step 8: the whole path");
}

}  // namespace lab12
