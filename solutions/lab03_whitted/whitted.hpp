// SPDX-License-Identifier: MIT
#pragma once
// Lab 03: the basic ray tracer, after Whitted (1980). The handout is README.md in this folder.

#include <lantern/any_of.hpp>
#include <lantern/closest.hpp>
#include <lantern/interval.hpp>
#include <lantern/plane.hpp>
#include <lantern/ray.hpp>
#include <lantern/rectangle.hpp>
#include <lantern/sphere.hpp>
#include <lantern/surface.hpp>
#include <lantern/todo.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace lab03 {

// ---- The scene: given ----------------------------------------------------------------------------------------------

/// A matt body with a highlight.
struct matte {
    glm::vec3 body{0.5f};
    glm::vec3 highlight{0};
    float exponent = 50;
};

/// A floor of squares of side 1.
struct chequered {
    matte even, odd;
};

struct mirror {
    glm::vec3 color{0.9f};
};

/// `index` is the index of refraction inside, outside it is 1; `color` is what passes when a ray crosses the surface.
struct glass {
    float index = 1.5f;
    glm::vec3 color{1};
};

using material = std::variant<matte, chequered, mirror, glass>;
using shape = lantern::any_of<lantern::sphere, lantern::plane, lantern::rectangle>;

struct thing {
    shape body;
    lab03::material material;
};

/// For lantern::closest and lantern::occluded.
[[nodiscard]] inline std::optional<lantern::hit> intersect(const thing& one, const lantern::ray& r, lantern::interval range) {
    return intersect(one.body, r, range);
}

/// A light of no size. At a distance d it brings intensity / d² to a surface that faces it.
struct light {
    glm::vec3 position{0};
    glm::vec3 intensity{1};
};

struct scene {
    std::vector<thing> things;
    std::vector<light> lights;
    glm::vec3 ambient{0};                 ///< light that comes evenly from everywhere
    glm::vec3 horizon{0}, zenith{0};      ///< the sky's colours
};

/// What a ray sees that meets nothing; `direction` has length 1.
[[nodiscard]] inline glm::vec3 sky(const scene& s, glm::vec3 direction) {
    return glm::mix(s.horizon, s.zenith, std::clamp(direction.y, 0.0f, 1.0f));
}

/// The matt material at a point, when it is one.
[[nodiscard]] inline std::optional<matte> matte_at(const material& m, glm::vec3 point) {
    if (const auto* plain = std::get_if<matte>(&m)) return *plain;
    if (const auto* squares = std::get_if<chequered>(&m))
        return (std::lround(std::floor(point.x)) + std::lround(std::floor(point.z))) % 2 == 0 ? squares->even : squares->odd;
    return std::nullopt;
}

/// The surface that the ray meets first; nothing limits how far.
[[nodiscard]] inline std::optional<lantern::nearest> closest(const scene& s, const lantern::ray& r) {
    return lantern::closest(lantern::every{std::uint32_t(s.things.size())}, s.things, r);
}

/// Whether the ray meets anything at all within the range.
[[nodiscard]] inline bool occluded(const scene& s, const lantern::ray& r, lantern::interval range) {
    return lantern::occluded(lantern::every{std::uint32_t(s.things.size())}, s.things, r, range);
}

// ---- What you write ------------------------------------------------------------------------------------------------

/// Step 1. The fraction of the light from `to_light` that goes to `to_eye` (Blinn 1977):
/// body · (n·l) + highlight · (n·h)^exponent, where h lies halfway between the two. All three vectors have length 1. The
/// side of the surface that the eye sees counts; when the light is on the other side the fraction is 0.
[[nodiscard]] inline glm::vec3 shade(const matte& m, glm::vec3 normal, glm::vec3 to_light, glm::vec3 to_eye) {
    // BEGIN SOLUTION
    const glm::vec3 n = glm::dot(normal, to_eye) < 0 ? -normal : normal;
    const float cosine = glm::dot(n, to_light);
    if (!(cosine > 0)) return glm::vec3(0);
    const float halfway = glm::dot(n, glm::normalize(to_light + to_eye));
    return m.body * cosine + m.highlight * std::pow(halfway, m.exponent);
    // END SOLUTION
    // STARTER: return lantern::todo("lab03 step 1: shading");
}

/// Step 2. Whether light from a point reaches the hit: the shadow ray.
[[nodiscard]] inline bool lit(const scene& s, const lantern::hit& h, glm::vec3 light_position) {
    // BEGIN SOLUTION
    const glm::vec3 origin = lantern::leave(h, light_position - h.point);
    return !occluded(s, {origin, light_position - origin}, {0, 1});
    // END SOLUTION
    // STARTER: return lantern::todo("lab03 step 2: the shadow ray");
}

/// Step 3. The direction in which a mirror sends a ray on. `in` and `normal` have length 1, and so has the result; the
/// normal may point to either side.
[[nodiscard]] inline glm::vec3 reflected(glm::vec3 in, glm::vec3 normal) {
    // BEGIN SOLUTION
    return in - 2 * glm::dot(normal, in) * normal;
    // END SOLUTION
    // STARTER: return lantern::todo("lab03 step 3: the law of reflection");
}

/// Step 4. The direction in which a ray goes on behind a surface (Snell), or std::nullopt where everything is reflected.
/// `in` and `normal` have length 1, and so has the result; the normal points to the side that the ray comes from.
/// `ratio` is the index of refraction on that side divided by the index on the other side.
[[nodiscard]] inline std::optional<glm::vec3> refracted(glm::vec3 in, glm::vec3 normal, float ratio) {
    // BEGIN SOLUTION
    const float cosine = -glm::dot(normal, in);
    const glm::vec3 across = ratio * (in + cosine * normal);  // along the surface: sin of the new angle
    const float sine_squared = glm::dot(across, across);
    if (!(sine_squared < 1)) return std::nullopt;
    return glm::normalize(across - std::sqrt(1 - sine_squared) * normal);
    // END SOLUTION
    // STARTER: lantern::todo("lab03 step 4: Snell's law");
}

/// Step 5. The fraction of the light that is reflected where two clear materials meet (Fresnel): the mean of both
/// polarisations, 1 where everything is reflected. `cosine` is that of the angle of incidence; `ratio` as in step 4.
[[nodiscard]] inline float reflectance(float cosine, float ratio) {
    // BEGIN SOLUTION
    const float sine_squared = ratio * ratio * (1 - cosine * cosine);
    if (!(sine_squared < 1)) return 1;
    const float cosine_behind = std::sqrt(1 - sine_squared);
    const float perpendicular = (ratio * cosine - cosine_behind) / (ratio * cosine + cosine_behind);
    const float parallel = (cosine - ratio * cosine_behind) / (cosine + ratio * cosine_behind);
    return (perpendicular * perpendicular + parallel * parallel) / 2;
    // END SOLUTION
    // STARTER: return lantern::todo("lab03 step 5: Fresnel's equations");
}

/// Step 6. The light that comes back along a ray, whose direction may have any length. It may be followed on `depth` times:
/// with depth 0 a mirror or glass is black.
[[nodiscard]] inline glm::vec3 trace(const scene& s, const lantern::ray& r, int depth) {
    // BEGIN SOLUTION
    const auto h = closest(s, r);
    const glm::vec3 in = glm::normalize(r.direction);
    if (!h) return sky(s, in);

    const material& m = s.things[h->index].material;
    if (const auto surface = matte_at(m, h->point)) {
        glm::vec3 sum = s.ambient * surface->body;
        for (const light& l : s.lights) {
            if (!lit(s, *h, l.position)) continue;
            const glm::vec3 to_light = l.position - h->point;
            const float distance_squared = glm::dot(to_light, to_light);
            sum += l.intensity / distance_squared * shade(*surface, h->normal, glm::normalize(to_light), -in);
        }
        return sum;
    }

    if (depth <= 0) return glm::vec3(0);
    const auto follow = [&](glm::vec3 direction) { return trace(s, {lantern::leave(*h, direction), direction}, depth - 1); };
    const glm::vec3 mirrored = reflected(in, h->normal);
    if (const auto* mirroring = std::get_if<mirror>(&m)) return mirroring->color * follow(mirrored);

    const auto& clear = std::get<glass>(m);
    const bool entering = glm::dot(in, h->normal) < 0;
    const glm::vec3 facing = entering ? h->normal : -h->normal;
    const float ratio = entering ? 1 / clear.index : clear.index;
    const auto bent = refracted(in, facing, ratio);
    if (!bent) return follow(mirrored);
    const float part = reflectance(-glm::dot(in, facing), ratio);
    return part * follow(mirrored) + (1 - part) * clear.color * follow(*bent);
    // END SOLUTION
    // STARTER: return lantern::todo("lab03 step 6: following the rays");
}

}  // namespace lab03
