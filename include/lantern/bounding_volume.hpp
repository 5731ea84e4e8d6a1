// SPDX-License-Identifier: MIT
#pragma once
// What a bounding volume is: something simple around something complex, which a ray is tested against first.

#include <lantern/aabb.hpp>
#include <lantern/hull.hpp>
#include <lantern/interval.hpp>
#include <lantern/precise.hpp>
#include <lantern/ray.hpp>

#include <concepts>
#include <ranges>
#include <span>
#include <vector>

namespace lantern {

/// `aabb`, `bounding_sphere`, `obb`, or one of your own. A volume by default is empty, and `enclose` of it and a hull is the
/// volume around that hull. `overlaps` may say yes to a ray that passes by, and never no to one that meets what is inside.
template <class V>
concept bounding_volume = std::default_initializable<V> &&
                          requires(const V& v, const hull& h, std::span<const V> group, const ray& r, const precise::ray& p,
                                   interval range) {
    { empty(v) } -> std::same_as<bool>;
    { surface_area(v) } -> std::same_as<double>;
    { enclose(v, v) } -> std::same_as<V>;
    { enclose(v, h) } -> std::same_as<V>;
    { enclose(group) } -> std::same_as<V>;
    { overlaps(v, r, range) } -> std::same_as<bool>;
    { overlaps(v, p, range) } -> std::same_as<bool>;
};

/// Around one surface: a primitive, or one that is transformed, which is no looser for it.
template <bounding_volume Volume, class Surface>
    requires requires(const Surface& s) { hull_of(s); }
[[nodiscard]] Volume volume_of(const Surface& s) {
    return enclose(Volume{}, hull_of(s));
}

/// Around a group of surfaces.
template <bounding_volume Volume, std::ranges::input_range Surfaces>
[[nodiscard]] Volume volume_of_all(const Surfaces& surfaces) {
    std::vector<Volume> each;
    for (const auto& s : surfaces) each.push_back(volume_of<Volume>(s));
    return enclose(std::span<const Volume>(each));
}

}  // namespace lantern
