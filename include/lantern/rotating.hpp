// SPDX-License-Identifier: MIT
#pragma once
// A surface that turns about an axis while the shutter is open.

#include <lantern/aabb.hpp>
#include <lantern/interval.hpp>
#include <lantern/precise.hpp>
#include <lantern/ray.hpp>
#include <lantern/surface.hpp>
#include <lantern/validate.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <numbers>
#include <optional>

namespace lantern {

/// At time t it is where `surface` would be after a turn by t * angle about the line through `point` along `axis`, counter-
/// clockwise when the axis points to the viewer. The axis need not have unit length; the angle is in radians and may be more
/// than a whole turn. A surface for timed rays only.
template <class Surface>
struct rotating {
    Surface surface;
    glm::vec3 point{0};
    glm::vec3 axis{0, 1, 0};
    float angle = 0;
};

template <class Surface>
rotating(Surface, glm::vec3, glm::vec3, float) -> rotating<Surface>;

namespace precise {

/// v turned about a unit axis (Rodrigues).
[[nodiscard]] inline glm::dvec3 turned(const glm::dvec3& v, const glm::dvec3& axis, double cosine, double sine) {
    return cosine * v + sine * glm::cross(axis, v) + (1 - cosine) * glm::dot(axis, v) * axis;
}

}  // namespace precise

template <class Surface, std::derived_from<precise::timed_ray> Ray>
    requires precise_surface<Surface, Ray>
[[nodiscard]] std::optional<precise::hit> intersect(const rotating<Surface>& m, const Ray& r, interval range) {
    const glm::dvec3 point(m.point), axis = glm::dvec3(m.axis) / glm::length(glm::dvec3(m.axis));
    const double angle = r.time * double(m.angle), cosine = std::cos(angle), sine = std::sin(angle);
    Ray local = r;
    local.origin = point + precise::turned(r.origin - point, axis, cosine, -sine);
    local.direction = precise::turned(r.direction, axis, cosine, -sine);
    auto h = intersect(m.surface, local, range);
    if (h) {
        h->error += 0x1p-48 * (precise::size(h->point) + precise::size(point));
        h->point = point + precise::turned(h->point - point, axis, cosine, sine);
        h->normal = precise::turned(h->normal, axis, cosine, sine);
    }
    return h;
}

/// Over the whole exposure; rounded outwards. The box's corners run along arcs, and an arc bulges beyond its ends: along each
/// coordinate it is c + a cos θ + b sin θ, which reaches c ± √(a² + b²) wherever θ = atan2(b, a) + kπ is passed.
template <bounded Surface>
[[nodiscard]] aabb bounds(const rotating<Surface>& m) {
    const aabb box = bounds(m.surface);
    if (empty(box)) return {};
    const glm::dvec3 point(m.point), axis = glm::dvec3(m.axis) / glm::length(glm::dvec3(m.axis));
    const double angle = m.angle, from = std::min(angle, 0.0), to = std::max(angle, 0.0);
    glm::dvec3 lo(infinity), hi(-infinity);
    double size = precise::size(point);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p((corner & 1) != 0 ? box.max.x : box.min.x, (corner & 2) != 0 ? box.max.y : box.min.y,
                           (corner & 4) != 0 ? box.max.z : box.min.z);
        const glm::dvec3 arm = p - point, along = glm::dot(arm, axis) * axis, a = arm - along, b = glm::cross(axis, a), c = point + along;
        size = std::max(size, precise::size(point) + precise::size(p));
        for (int k = 0; k < 3; ++k) {
            const auto reach = [&](double value) {
                lo[k] = std::min(lo[k], c[k] + value);
                hi[k] = std::max(hi[k], c[k] + value);
            };
            reach(a[k]);
            reach(a[k] * std::cos(angle) + b[k] * std::sin(angle));
            const double most = std::hypot(a[k], b[k]), pi = std::numbers::pi, at = std::atan2(b[k], a[k]);
            constexpr double doubt = 1e-9;  // of an angle: rather a little too much
            // The first maximum and the first minimum not before `from`.
            const auto first = [&](double turn) { return turn + 2 * pi * std::ceil((from - doubt - turn) / (2 * pi)); };
            if (first(at) <= to + doubt) reach(most);
            if (first(at + pi) <= to + doubt) reach(-most);
        }
    }
    return enclosing(lo - 0x1p-46 * size, hi + 0x1p-46 * size);
}

template <class Surface>
void validate(const rotating<Surface>& m) {
    require_finite(m.point, "rotating: point");
    require_finite(m.axis, "rotating: axis");
    if (m.axis == glm::vec3(0)) refuse("rotating: axis", to_text(m.axis), "different from zero");
    require_finite(m.angle, "rotating: angle");
    if constexpr (requires { validate(m.surface); }) validate(m.surface);
}

}  // namespace lantern
