// SPDX-License-Identifier: MIT
#pragma once
// The infinite plane, and the one formula that all flat surfaces share.

#include <lantern/double_double.hpp>
#include <lantern/interval.hpp>
#include <lantern/precise.hpp>
#include <lantern/validate.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <optional>

namespace lantern {

/// All points p with normal·(p - point) = 0. The normal need not have unit length. A plane is not finite, so it has no
/// `bounds`, and no hierarchy takes it.
struct plane {
    glm::vec3 point{0};
    glm::vec3 normal{0, 1, 0};
};

inline void validate(const plane& p) {
    require_finite(p.point, "plane: point");
    require_finite(p.normal, "plane: normal");
    if (p.normal == glm::vec3(0)) refuse("plane: normal", to_text(p.normal), "different from zero");
}

namespace precise {

/// n·(q - o) / n·d in double-double; NaN or infinite where n·d = 0.
[[nodiscard, gnu::noinline]] inline double meet_plane_in_doubt(const ray& r, const glm::dvec3& q,
                                                               const std::array<double_double, 3>& n) {
    double_double above, speed;
    for (int i = 0; i < 3; ++i) {
        above = above + n[std::size_t(i)] * two_sum(q[i], -r.origin[i]);
        speed = speed + n[std::size_t(i)] * double_double{r.direction[i]};
    }
    return above.high / speed.high;
}

/// Where the ray's line meets the plane through q with the normal n: t = n·(q - o) / n·d (never with n·q computed
/// beforehand, which cancels). NaN or infinite only where n·d = 0. In double where that is enough for float.
[[nodiscard]] inline double meet_plane(const ray& r, const glm::dvec3& q, const glm::dvec3& n) {
    const glm::dvec3 to = q - r.origin;
    const double above = glm::dot(n, to), speed = glm::dot(n, r.direction), scale = 0x1p-14 * size(n);
    if (std::abs(above) > scale * size(to) && std::abs(speed) > scale * size(r.direction)) return above / speed;
    return meet_plane_in_doubt(r, q, {{{n.x}, {n.y}, {n.z}}});
}

}  // namespace precise

[[nodiscard]] inline std::optional<precise::hit> intersect(const plane& p, const precise::ray& r, interval range) {
    const glm::dvec3 q(p.point), n(p.normal);
    const double t = precise::meet_plane(r, q, n);
    if (!contains(range, t)) return std::nullopt;
    const glm::dvec3 along = precise::at(r, t), unit = n / glm::length(n);
    const double size = precise::size(q) + precise::size(along);
    if (!precise::fits(size)) return std::nullopt;
    return precise::hit{t, along - glm::dot(along - q, unit) * unit, unit, 0x1p-50 * size};
}

}  // namespace lantern
