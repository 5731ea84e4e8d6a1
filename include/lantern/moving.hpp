// SPDX-License-Identifier: MIT
#pragma once
// A surface that moves along a straight line while the shutter is open.

#include <lantern/aabb.hpp>
#include <lantern/hull.hpp>
#include <lantern/interval.hpp>
#include <lantern/precise.hpp>
#include <lantern/ray.hpp>
#include <lantern/surface.hpp>
#include <lantern/validate.hpp>

#include <glm/vec3.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <optional>

namespace lantern {

/// At time t it is where `surface` would be after a translation by t * displacement: at 0 the shutter opens, at 1 it
/// closes. A surface for timed rays only.
template <class Surface>
struct moving {
    Surface surface;
    glm::vec3 displacement{0};

    [[nodiscard]] bool operator==(const moving&) const = default;
};

template <class Surface>
moving(Surface, glm::vec3) -> moving<Surface>;

namespace precise {

/// What `moving` adds to the error of a point: the shift is rounded, and the sum. That the ray's origin was rounded, too, moves the
/// point along the surface, not away from it.
[[nodiscard]] inline double error_moved(const glm::dvec3& shift, const glm::dvec3& point) { return 0x1p-52 * (size(shift) + size(point)); }

}  // namespace precise

template <class Surface, std::derived_from<precise::timed_ray> Ray>
    requires precise_surface<Surface, Ray>
[[nodiscard]] std::optional<precise::hit> intersect(const moving<Surface>& m, const Ray& r, interval range) {
    const glm::dvec3 shift = r.time * glm::dvec3(m.displacement);
    Ray local = r;
    local.origin -= shift;
    auto h = intersect(m.surface, local, range);
    if (h) {
        h->point += shift;
        h->error += precise::error_moved(shift, h->point);
    }
    return h;
}

/// The same, rounded where it is made, for surfaces that hand what they find to `make`.
template <class Surface, std::derived_from<timed_ray> Ray>
    requires requires(const Surface& s, const precise::ray& r, interval range) { find_hit(s, r, range, precise::rounded_at_once); }
[[nodiscard]] std::optional<hit> intersect(const moving<Surface>& m, const Ray& r, interval range) {
    const glm::dvec3 shift = double(r.time) * glm::dvec3(m.displacement);
    const auto make = [&](double t, const glm::dvec3& point, const glm::dvec3& normal, double error) {
        const glm::dvec3 there = point + shift;
        return precise::rounded_at_once(t, there, normal, error + precise::error_moved(shift, there));
    };
    return find_hit(m.surface, precise::ray{glm::dvec3(r.origin) - shift, glm::dvec3(r.direction)}, range, make);
}

/// For surfaces that answer in float only: a user's own.
template <class Surface, std::derived_from<timed_ray> Ray>
    requires(surface<Surface, Ray> && !precise_surface<Surface, decltype(precise::widen(Ray{}))>)
[[nodiscard]] std::optional<hit> intersect(const moving<Surface>& m, const Ray& r, interval range) {
    const glm::vec3 shift = r.time * m.displacement;
    Ray local = r;
    local.origin -= shift;
    auto h = intersect(m.surface, local, range);
    if (h) {
        h->point += shift;
        h->error += 4 * std::max({ulp(r.origin.x), ulp(r.origin.y), ulp(r.origin.z), ulp(shift.x), ulp(shift.y), ulp(shift.z)});
    }
    return h;
}

/// Over the whole exposure; rounded outwards.
template <bounded Surface>
[[nodiscard]] aabb bounds(const moving<Surface>& m) {
    const aabb open = bounds(m.surface);
    return enclose(open, moved(open, m.displacement));
}

/// At time 0 or 1.
template <bounded Surface>
[[nodiscard]] aabb bounds_at(const moving<Surface>& m, float time) {
    return moved(bounds_at(m.surface, time), time * m.displacement);
}

/// Between where it is when the shutter opens and when it closes.
template <bounded Surface>
[[nodiscard]] hull hull_of(const moving<Surface>& m) {
    hull h = hull_of(m.surface);
    const std::size_t count = h.points.size();
    double size = 0;
    for (std::size_t i = 0; i < count; ++i) {
        h.points.push_back(h.points[i] + glm::dvec3(m.displacement));
        size = std::max(size, precise::size(h.points.back()));
    }
    h.radius += 0x1p-50 * size;
    return h;
}

template <class Surface>
void validate(const moving<Surface>& m) {
    require_finite(m.displacement, "moving: displacement");
    if constexpr (requires { validate(m.surface); }) validate(m.surface);
}

}  // namespace lantern
