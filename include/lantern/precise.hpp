// SPDX-License-Identifier: MIT
#pragma once
// The double-precision layer: primitives are stored in float, intersected in double, and rounded once.

#include <lantern/interval.hpp>
#include <lantern/ray.hpp>
#include <lantern/surface.hpp>

#include <glm/vec3.hpp>

#include <cmath>
#include <concepts>
#include <optional>

namespace lantern {

namespace precise {

/// `lantern::ray`, widened. Instances carry rays to their own space in this form, so that no rounding happens there.
struct ray {
    glm::dvec3 origin{0};
    glm::dvec3 direction{0, 0, -1};
};

struct timed_ray : ray {
    double time = 0;
};

/// `lantern::hit` before it is rounded. `error` bounds the distance of `point` from the surface.
struct hit {
    double t = 0;
    glm::dvec3 point{0};
    glm::dvec3 normal{0};
    double error = 0;
};

[[nodiscard]] inline glm::dvec3 at(const ray& r, double t) { return r.origin + t * r.direction; }

/// |x| + |y| + |z|: the size of a vector for the purposes of an error bound.
[[nodiscard]] inline double size(const glm::dvec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

/// Whether something of this size can be rounded to float. A hit beyond that is none.
[[nodiscard]] inline bool fits(double size) { return size < 0x1p128; }

[[nodiscard]] inline ray widen(const lantern::ray& r) { return {glm::dvec3(r.origin), glm::dvec3(r.direction)}; }
[[nodiscard]] inline timed_ray widen(const lantern::timed_ray& r) {
    return {{glm::dvec3(r.origin), glm::dvec3(r.direction)}, double(r.time)};
}

}  // namespace precise

/// A surface that answers in double precision. Such a surface is a `surface` too: see `intersect` below.
template <class S, class Ray = precise::ray>
concept precise_surface = requires(const S& s, const Ray& r, interval range) {
    { intersect(s, r, range) } -> std::same_as<std::optional<precise::hit>>;
};

/// Whether t, *rounded to float*, lies in the range. Every precise surface must decide by this rule: two hits are
/// then ordered by what is stored of them, and the closest does not depend on the order of the tests.
[[nodiscard]] inline bool contains(interval range, double t) { return contains(range, static_cast<float>(t)); }

/// Rounds to nearest, once.
[[nodiscard]] inline hit rounded(const precise::hit& h) {
    return {static_cast<float>(h.t), glm::vec3(h.point), glm::vec3(h.normal), static_cast<float>(h.error)};
}
[[nodiscard]] inline const hit& rounded(const hit& h) { return h; }

/// What a ray is turned into before it meets many surfaces of one type: itself, unless the type names a `ready_ray` in which
/// part of the work is done already.
template <class S, class Ray>
[[nodiscard]] decltype(auto) ready_for(const Ray& r) {
    if constexpr (requires { typename S::ready_ray; }) return typename S::ready_ray(r);
    else return (r);  // a reference
}

namespace precise {

// What becomes of a hit that a primitive has found, for those that are asked so often that it matters: kept in double, or rounded
// at once, before it has been put together.
inline constexpr auto as_it_is = [](double t, const glm::dvec3& point, const glm::dvec3& normal, double error) {
    return std::optional(hit{t, point, normal, error});
};
inline constexpr auto rounded_at_once = [](double t, const glm::dvec3& point, const glm::dvec3& normal, double error) {
    return std::optional(lantern::hit{static_cast<float>(t), glm::vec3(point), glm::vec3(normal), static_cast<float>(error)});
};

}  // namespace precise

/// A precise surface meets an ordinary ray: widened, intersected in double, rounded once.
template <class S, std::derived_from<ray> Ray>
    requires requires(const S& s, const Ray& r, interval range) {
        { intersect(s, precise::widen(r), range) } -> std::same_as<std::optional<precise::hit>>;
    }
[[nodiscard]] std::optional<hit> intersect(const S& s, const Ray& r, interval range) {
    if (const auto h = intersect(s, precise::widen(r), range)) return rounded(*h);
    return std::nullopt;
}

}  // namespace lantern
