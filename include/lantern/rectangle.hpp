// SPDX-License-Identifier: MIT
#pragma once
// The rectangle, or any parallelogram.

#include <lantern/aabb.hpp>
#include <lantern/hull.hpp>
#include <lantern/interval.hpp>
#include <lantern/plane.hpp>
#include <lantern/precise.hpp>
#include <lantern/validate.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace lantern {

/// All points corner + α u + β v, α and β in [0, 1]; a rectangle when u ⟂ v. The normal is along u × v. A ray through the
/// edge hits, even within the rounding error: no ray passes between two that share an edge.
struct rectangle {
    glm::vec3 corner{0};
    glm::vec3 u{1, 0, 0};
    glm::vec3 v{0, 1, 0};

    [[nodiscard]] bool operator==(const rectangle&) const = default;
};

inline void validate(const rectangle& s) {
    require_finite(s.corner, "rectangle: corner");
    require_finite(s.u, "rectangle: u");
    require_finite(s.v, "rectangle: v");
    if (glm::cross(glm::dvec3(s.u), glm::dvec3(s.v)) == glm::dvec3(0))
        refuse("rectangle: v", to_text(s.v), "not parallel to u = " + to_text(s.u));
}

/// Rounded outwards; empty when a number is not finite.
[[nodiscard]] inline aabb bounds(const rectangle& s) {
    if (!(is_finite(s.corner) && is_finite(s.u) && is_finite(s.v))) return {};
    const aabb u = moved(aabb{s.corner, s.corner}, s.u);
    const aabb edge = enclose(u, s.corner);
    return enclose(edge, moved(edge, s.v));
}

[[nodiscard]] inline hull hull_of(const rectangle& s) {
    const glm::dvec3 corner(s.corner), u(s.u), v(s.v);
    return {{corner, corner + u, corner + v, corner + u + v}, 0x1p-50 * (precise::size(corner) + precise::size(u) + precise::size(v))};
}

[[nodiscard]] inline std::optional<precise::hit> intersect(const rectangle& s, const precise::ray& r, interval range) {
    const glm::dvec3 corner(s.corner), u(s.u), v(s.v), n = glm::cross(u, v);
    const double t = precise::meet_plane(r, corner, n);
    if (!contains(range, t)) return std::nullopt;
    // n·n α = ((p - corner) × v)·n, and likewise β; both wrong by at most `doubt`.
    const glm::dvec3 step = t * r.direction, p = (r.origin - corner) + step;
    const double nn = glm::dot(n, n), alpha = glm::dot(glm::cross(p, v), n) / nn, beta = glm::dot(glm::cross(u, p), n) / nn;
    const double rounding = 0x1p-49 * (precise::size(corner) + precise::size(r.origin) + precise::size(step));
    const double per_n = rounding / std::sqrt(nn), doubt_alpha = per_n * precise::size(v), doubt_beta = per_n * precise::size(u);
    if (!(alpha >= -doubt_alpha && alpha <= 1 + doubt_alpha && beta >= -doubt_beta && beta <= 1 + doubt_beta))
        return std::nullopt;
    glm::dvec3 on = glm::clamp(alpha, 0.0, 1.0) * u + glm::clamp(beta, 0.0, 1.0) * v;
    const bool inside = alpha >= 0 && alpha <= 1 && beta >= 0 && beta <= 1;
    if (!(inside && std::max(doubt_alpha, doubt_beta) < 0x1p-10)) {  // seldom; of thin ones α and β say little: how far is it?
        double nearest = precise::size(p - on);
        const auto along = [&](const glm::dvec3& from, const glm::dvec3& edge) {
            const glm::dvec3 q = from + glm::clamp(glm::dot(p - from, edge) / glm::dot(edge, edge), 0.0, 1.0) * edge;
            if (precise::size(p - q) < nearest) nearest = precise::size(p - q), on = q;
        };
        along(glm::dvec3(0), u);
        along(glm::dvec3(0), v);
        along(v, u);
        along(u, v);
        if (!(nearest <= 4 * rounding)) return std::nullopt;
    }
    const double size = precise::size(corner) + precise::size(u) + precise::size(v);
    if (!precise::fits(size)) return std::nullopt;
    return precise::hit{t, corner + on, n / std::sqrt(nn), 0x1p-50 * size};
}

}  // namespace lantern
