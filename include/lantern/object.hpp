// SPDX-License-Identifier: MIT
#pragma once
// A shape together with what it is made of.

#include <lantern/aabb.hpp>
#include <lantern/hull.hpp>
#include <lantern/interval.hpp>
#include <lantern/precise.hpp>
#include <lantern/ray.hpp>
#include <lantern/surface.hpp>
#include <lantern/validate.hpp>

#include <concepts>
#include <optional>

namespace lantern {

/// A surface wherever its shape is one, bounded when its shape is. The library never looks at the material: that is
/// between the program and its integrator.
template <class Shape, class Material>
struct object {
    Shape shape;
    Material material;
};

template <class Shape, class Material>
object(Shape, Material) -> object<Shape, Material>;

template <class Shape, class Material, std::derived_from<precise::ray> Ray>
    requires precise_surface<Shape, Ray>
[[nodiscard]] std::optional<precise::hit> intersect(const object<Shape, Material>& o, const Ray& r, interval range) {
    return intersect(o.shape, r, range);
}

/// In the shape's own way: rounded where it finds a hit, or in float altogether, as a user's own may be.
template <class Shape, class Material, std::derived_from<ray> Ray>
    requires surface<Shape, Ray>
[[nodiscard]] std::optional<hit> intersect(const object<Shape, Material>& o, const Ray& r, interval range) {
    return intersect(o.shape, r, range);
}

template <bounded Shape, class Material>
[[nodiscard]] aabb bounds(const object<Shape, Material>& o) {
    return bounds(o.shape);
}

template <bounded Shape, class Material>
[[nodiscard]] aabb bounds_at(const object<Shape, Material>& o, float time) {
    return bounds_at(o.shape, time);
}

template <bounded Shape, class Material>
[[nodiscard]] hull hull_of(const object<Shape, Material>& o) {
    return hull_of(o.shape);
}

template <class Shape, class Material>
void validate(const object<Shape, Material>& o) {
    validate_if_possible(o.shape);
    validate_if_possible(o.material);
}

}  // namespace lantern
