// SPDX-License-Identifier: MIT
#pragma once
// A box that moves with what is in it: for hierarchies over surfaces that move.

#include <lantern/aabb.hpp>
#include <lantern/bounding_volume.hpp>
#include <lantern/box_ray.hpp>
#include <lantern/boxes_of.hpp>
#include <lantern/hull.hpp>
#include <lantern/interval.hpp>
#include <lantern/precise.hpp>
#include <lantern/ray.hpp>

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <span>

namespace lantern {

/// Where things are at time 0 and at time 1. At any time between, what moves along a straight line or not at all is in the box
/// between: of a box that moves evenly with its thing, so does the box around several (its lower face is where the least of
/// several straight lines is, and that bends inwards). A ray without a time sees the whole exposure.
struct moving_aabb {
    aabb open, close;

    /// Around a surface; see `bounds_at`.
    template <bounded Surface>
    [[nodiscard]] static moving_aabb around(const Surface& s) {
        return {bounds_at(s, 0), bounds_at(s, 1)};
    }
};

[[nodiscard]] inline aabb bounds(const moving_aabb& b) { return enclose(b.open, b.close); }

/// Not rounded outwards: off by up to 5 parts in 2^24 of the largest coordinate.
[[nodiscard]] inline aabb bounds_at(const moving_aabb& b, float time) {
    return {b.open.min + time * (b.close.min - b.open.min), b.open.max + time * (b.close.max - b.open.max)};
}

[[nodiscard]] inline bool empty(const moving_aabb& b) { return empty(b.open) || empty(b.close); }

/// On the average over the exposure, nearly.
[[nodiscard]] inline double surface_area(const moving_aabb& b) { return empty(b) ? 0 : surface_area(bounds_at(b, 0.5f)); }

[[nodiscard]] inline moving_aabb enclose(const moving_aabb& a, const moving_aabb& b) {
    return {enclose(a.open, b.open), enclose(a.close, b.close)};
}
[[nodiscard]] inline moving_aabb enclose(const moving_aabb& b, const hull& h) { return {enclose(b.open, h), enclose(b.close, h)}; }
[[nodiscard]] inline moving_aabb enclose(std::span<const moving_aabb> boxes) {
    moving_aabb all;
    for (const moving_aabb& b : boxes) all = enclose(all, b);
    return all;
}

template <class Ray>
    requires std::derived_from<Ray, ray> || std::derived_from<Ray, precise::ray>
[[nodiscard]] bool overlaps(const moving_aabb& b, const Ray& r, interval range) {
    return overlaps(bounds(b), r, range);
}

template <>
class volume_ray<moving_aabb> : public box_ray {
public:
    volume_ray(const timed_ray& r, interval range, const moving_aabb& all)
        : box_ray(r, range, reach_of(bounds(all)), 0x1p-21 * reach_of(bounds(all))), time_(r.time) {}
    [[nodiscard]] bool meets(const moving_aabb& b, float& entry) const { return box_ray::meets(bounds_at(b, time_), entry); }
    [[nodiscard]] bool still_meets(const moving_aabb&, float entry) const { return reaches(entry); }
    [[nodiscard]] bool second_first(float entry, float of_second, std::uint32_t) const { return of_second < entry; }

private:
    float time_;
};

}  // namespace lantern
