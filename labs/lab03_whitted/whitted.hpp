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
    return lantern::todo("lab03 step 1: shading");
}

/// Step 2. Whether light from a point reaches the hit: the shadow ray.
[[nodiscard]] inline bool lit(const scene& s, const lantern::hit& h, glm::vec3 light_position) {
    return lantern::todo("lab03 step 2: the shadow ray");
}

/// Step 3. The direction in which a mirror sends a ray on. `in` and `normal` have length 1, and so has the result; the
/// normal may point to either side.
[[nodiscard]] inline glm::vec3 reflected(glm::vec3 in, glm::vec3 normal) {
    return lantern::todo("lab03 step 3: the law of reflection");
}

/// Step 4. The direction in which a ray goes on behind a surface (Snell), or std::nullopt where everything is reflected.
/// `in` and `normal` have length 1, and so has the result; the normal points to the side that the ray comes from.
/// `ratio` is the index of refraction on that side divided by the index on the other side.
[[nodiscard]] inline std::optional<glm::vec3> refracted(glm::vec3 in, glm::vec3 normal, float ratio) {
    lantern::todo("lab03 step 4: Snell's law");
}

/// Step 5. The fraction of the light that is reflected where two clear materials meet (Fresnel): the mean of both
/// polarisations, 1 where everything is reflected. `cosine` is that of the angle of incidence; `ratio` as in step 4.
[[nodiscard]] inline float reflectance(float cosine, float ratio) {
    return lantern::todo("lab03 step 5: Fresnel's equations");
}

/// Step 6. The light that comes back along a ray, whose direction may have any length. It may be followed on `depth` times:
/// with depth 0 a mirror or glass is black.
[[nodiscard]] inline glm::vec3 trace(const scene& s, const lantern::ray& r, int depth) {
    return lantern::todo("lab03 step 6: following the rays");
}

}  // namespace lab03
