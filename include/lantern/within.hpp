// SPDX-License-Identifier: MIT
#pragma once
// A surface behind a bounding volume, which is tested first.

#include <lantern/aabb.hpp>
#include <lantern/bounding_volume.hpp>
#include <lantern/hull.hpp>
#include <lantern/interval.hpp>
#include <lantern/precise.hpp>
#include <lantern/ray.hpp>
#include <lantern/surface.hpp>
#include <lantern/validate.hpp>

#include <concepts>
#include <optional>
#include <utility>

namespace lantern {

/// Worth it where the volume's test costs less than the surface's. Transparent to whoever renders it: the same hits, bit for
/// bit, as long as the volume holds the surface, and a surface wherever that is one. `put_within<obb>(thing)` sees to it.
template <bounding_volume Volume, class Surface>
struct within {
    Volume volume;
    Surface surface;
};

template <class Volume, class Surface>
within(Volume, Surface) -> within<Volume, Surface>;

/// The surface in a volume of its own size.
template <bounding_volume Volume, bounded Surface>
[[nodiscard]] within<Volume, Surface> put_within(Surface surface) {
    const Volume volume = volume_of<Volume>(surface);
    return {volume, std::move(surface)};
}

template <class Volume, class Surface, std::derived_from<precise::ray> Ray>
    requires precise_surface<Surface, Ray>
[[nodiscard]] std::optional<precise::hit> intersect(const within<Volume, Surface>& s, const Ray& r, interval range) {
    if (!overlaps(s.volume, r, range)) return std::nullopt;
    return intersect(s.surface, r, range);
}

/// For surfaces that answer in float only: a user's own.
template <class Volume, class Surface, std::derived_from<ray> Ray>
    requires(surface<Surface, Ray> && !precise_surface<Surface, decltype(precise::widen(Ray{}))>)
[[nodiscard]] std::optional<hit> intersect(const within<Volume, Surface>& s, const Ray& r, interval range) {
    if (!overlaps(s.volume, r, range)) return std::nullopt;
    return intersect(s.surface, r, range);
}

template <class Volume, bounded Surface>
[[nodiscard]] aabb bounds(const within<Volume, Surface>& s) {
    return bounds(s.surface);
}

template <class Volume, bounded Surface>
[[nodiscard]] aabb bounds_at(const within<Volume, Surface>& s, float time) {
    return bounds_at(s.surface, time);
}

template <class Volume, bounded Surface>
[[nodiscard]] hull hull_of(const within<Volume, Surface>& s) {
    return hull_of(s.surface);
}

template <class Volume, class Surface>
void validate(const within<Volume, Surface>& s) {
    if (empty(s.volume)) refuse("within: the volume", "empty", "around the surface");
    validate_if_possible(s.surface);
}

}  // namespace lantern
