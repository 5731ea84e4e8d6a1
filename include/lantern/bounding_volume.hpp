// SPDX-License-Identifier: MIT
#pragma once
// What a bounding volume is: something simple around something complex, which a ray is tested against first.

#include <lantern/aabb.hpp>
#include <lantern/box_ray.hpp>
#include <lantern/boxes_of.hpp>
#include <lantern/hull.hpp>
#include <lantern/interval.hpp>
#include <lantern/precise.hpp>
#include <lantern/ray.hpp>

#include <concepts>
#include <cstdint>
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
    if constexpr (requires { Volume::around(s); }) return Volume::around(s);
    else return enclose(Volume{}, hull_of(s));
}

/// Around a group of surfaces.
template <bounding_volume Volume, std::ranges::input_range Surfaces>
[[nodiscard]] Volume volume_of_all(const Surfaces& surfaces) {
    std::vector<Volume> each;
    for (const auto& s : surfaces) each.push_back(volume_of<Volume>(s));
    return enclose(std::span<const Volume>(each));
}

/// A ray on its way through a tree of volumes: it gets shorter with every hit. This one asks a volume again when its turn has
/// come, if a hit was found meanwhile; boxes have a quicker one.
template <bounding_volume Volume>
class volume_ray {
public:
    volume_ray(const ray& r, interval range, const Volume& /*all*/) : ray_(precise::widen(r)), range_(range) {}

    /// Whether it may meet what is in the volume; `entry` is for the two questions that follow.
    [[nodiscard]] bool meets(const Volume& v, float& entry) const {
        entry = range_.max;
        return overlaps(v, ray_, range_);
    }
    [[nodiscard]] bool still_meets(const Volume& v, float entry) const { return entry == range_.max || overlaps(v, ray_, range_); }

    /// Of two volumes that it meets, divided along an axis, the lower one first: whether it enters the second one first.
    [[nodiscard]] bool second_first(float /*entry*/, float /*of_second*/, std::uint32_t axis) const { return ray_.direction[int(axis)] < 0; }

    void shorten(float max) { range_.max = max; }

private:
    precise::ray ray_;
    interval range_;
};

template <>
class volume_ray<aabb> : public box_ray {
public:
    volume_ray(const ray& r, interval range, const aabb& all) : box_ray(r, range, reach_of(all)) {}
    [[nodiscard]] bool still_meets(const aabb&, float entry) const { return reaches(entry); }
    [[nodiscard]] bool second_first(float entry, float of_second, std::uint32_t) const { return of_second < entry; }
};

}  // namespace lantern
