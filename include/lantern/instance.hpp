// SPDX-License-Identifier: MIT
#pragma once
// A surface placed in the world by an affine transform: moved, turned, stretched, sheared, mirrored.

#include <lantern/aabb.hpp>
#include <lantern/hull.hpp>
#include <lantern/interval.hpp>
#include <lantern/precise.hpp>
#include <lantern/validate.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <optional>
#include <string>
#include <utility>

namespace lantern {

/// The ray is carried to the surface's own space and its direction is not normalised there, so t is the same in both.
/// Normals go by the inverse transpose, hence outward ones stay outward, whether the transform mirrors or not.
template <class Surface>
class instance {
public:
    /// Throws std::invalid_argument when the transform is not finite, not affine (last row 0 0 0 1) or singular.
    explicit instance(Surface surface, const glm::mat4& to_world = glm::mat4(1))
        : surface_(std::move(surface)), linear_(glm::mat3(to_world)), translation_(to_world[3]) {
        for (int column = 0; column < 4; ++column) {
            require_finite(glm::vec3(to_world[column]), "instance: a column of to_world");
            const float last = to_world[column][3], wanted = column == 3 ? 1.0f : 0.0f;
            if (last != wanted) refuse("instance: the last row of to_world", to_text(last), "0 0 0 1 (affine)");
        }
        // Divided by the length of its columns the determinant says how flat the transform is, whatever its scale.
        const double determinant = glm::determinant(linear_);
        const double lengths = glm::length(linear_[0]) * glm::length(linear_[1]) * glm::length(linear_[2]);
        if (!(std::abs(determinant) > 0x1p-48 * lengths))
            refuse("instance: the determinant of to_world", to_text(determinant), "different from zero");
        inverse_ = glm::inverse(linear_);
        bool finite = true;
        for (int column = 0; column < 3; ++column)
            for (int row = 0; row < 3; ++row) finite = finite && std::isfinite(inverse_[column][row]);
        if (!finite) refuse("instance: the determinant of to_world", to_text(determinant), "large enough to invert");
    }

    [[nodiscard]] const Surface& surface() const { return surface_; }

    /// The transform: p -> linear() * p + translation().
    [[nodiscard]] const glm::dmat3& linear() const { return linear_; }
    [[nodiscard]] const glm::dvec3& translation() const { return translation_; }
    [[nodiscard]] const glm::dmat3& inverse() const { return inverse_; }

private:
    Surface surface_;
    glm::dmat3 linear_, inverse_;
    glm::dvec3 translation_;
};

template <class Surface>
instance(Surface, const glm::mat4&) -> instance<Surface>;
template <class Surface>
instance(Surface) -> instance<Surface>;

template <class Surface, std::derived_from<precise::ray> Ray>
    requires precise_surface<Surface, Ray>
[[nodiscard]] std::optional<precise::hit> intersect(const instance<Surface>& s, const Ray& r, interval range) {
    Ray local = r;
    local.origin = s.inverse() * (r.origin - s.translation());
    local.direction = s.inverse() * r.direction;
    auto h = intersect(s.surface(), local, range);
    if (!h) return h;
    const glm::dvec3 linear_point = s.linear() * h->point, normal = h->normal * s.inverse();  // by the transpose
    double stretch = 0;
    for (int i = 0; i < 3; ++i) stretch = std::max(stretch, precise::size(s.linear()[i]));
    h->error = 2 * stretch * h->error + 0x1p-50 * (stretch * precise::size(h->point) + precise::size(s.translation()));
    h->point = linear_point + s.translation();
    h->normal = normal / glm::length(normal);
    return h;
}

/// Around the transformed corners; rounded outwards.
template <bounded Surface>
[[nodiscard]] aabb bounds(const instance<Surface>& s) {
    const aabb local = bounds(s.surface());
    if (empty(local)) return {};
    glm::dvec3 lo = s.translation(), hi = lo, size = glm::abs(lo);
    for (int column = 0; column < 3; ++column) {
        const glm::dvec3 a = double(local.min[column]) * s.linear()[column], b = double(local.max[column]) * s.linear()[column];
        lo += glm::min(a, b);
        hi += glm::max(a, b);
        size += glm::max(glm::abs(a), glm::abs(b));
    }
    return enclosing(lo - 0x1p-50 * size, hi + 0x1p-50 * size);
}

/// The transformed points. Balls around them become ellipsoids, whose longest half axis is at most the square root of the
/// sum of squares of the matrix (its Frobenius norm).
template <bounded Surface>
[[nodiscard]] hull hull_of(const instance<Surface>& s) {
    hull h = hull_of(s.surface());
    double stretch = 0, size = 0;
    for (int column = 0; column < 3; ++column) stretch += glm::dot(s.linear()[column], s.linear()[column]);
    for (glm::dvec3& p : h.points) {
        size = std::max(size, std::sqrt(stretch) * precise::size(p) + precise::size(s.translation()));
        p = s.linear() * p + s.translation();
    }
    h.radius = std::sqrt(stretch) * h.radius + 0x1p-49 * size;
    return h;
}

template <class Surface>
void validate(const instance<Surface>& s) {
    if constexpr (requires { validate(s.surface()); }) validate(s.surface());
}

}  // namespace lantern
