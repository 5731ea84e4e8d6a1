// SPDX-License-Identifier: MIT
#pragma once
// Axis-aligned bounding boxes: union, and a test that no ray slips through.

#include <lantern/double_double.hpp>
#include <lantern/interval.hpp>
#include <lantern/precise.hpp>
#include <lantern/ray.hpp>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>

namespace lantern {

/// All points with min <= p <= max. The default box is empty: `enclose` of it and anything is that thing.
struct aabb {
    glm::vec3 min{infinity};
    glm::vec3 max{-infinity};
};

inline constexpr aabb empty_aabb{};

/// A surface that is finite says within which box it lies for certain: rounded outwards. Planes have no `bounds`.
template <class S>
concept bounded = requires(const S& s) {
    { bounds(s) } -> std::same_as<aabb>;
};

/// The box of a surface at time 0 or 1, for boxes that are interpolated: at times between the surface must lie within the box
/// between, without rounding. What does not move along a straight line stays in its whole box all the time.
template <bounded S>
[[nodiscard]] aabb bounds_at(const S& s, float /*time*/) {
    return bounds(s);
}

/// No point lies in it: some min > max, or NaN. A flat box is not empty, nor is a single point.
[[nodiscard]] inline bool empty(const aabb& box) {
    return !(box.min.x <= box.max.x && box.min.y <= box.max.y && box.min.z <= box.max.z);
}

[[nodiscard]] inline bool contains(const aabb& box, glm::vec3 p) {
    return box.min.x <= p.x && p.x <= box.max.x && box.min.y <= p.y && p.y <= box.max.y && box.min.z <= p.z &&
           p.z <= box.max.z;
}

/// The smallest box around both.
[[nodiscard]] inline aabb enclose(const aabb& a, const aabb& b) { return {glm::min(a.min, b.min), glm::max(a.max, b.max)}; }
[[nodiscard]] inline aabb enclose(const aabb& a, glm::vec3 p) { return {glm::min(a.min, p), glm::max(a.max, p)}; }

/// The middle; does not overflow.
[[nodiscard]] inline glm::vec3 center(const aabb& box) { return 0.5f * box.min + 0.5f * box.max; }

/// Along which the box is longest; of equal ones the first.
[[nodiscard]] inline std::uint32_t longest_axis(const aabb& box) {
    const glm::vec3 size = box.max - box.min;
    return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

/// Of all six sides; 0 for an empty box. In double, for squares of floats overflow.
[[nodiscard]] inline double surface_area(const aabb& box) {
    if (empty(box)) return 0;
    const glm::dvec3 e = glm::dvec3(box.max) - glm::dvec3(box.min);
    return 2 * (e.x * e.y + e.y * e.z + e.z * e.x);
}

/// The largest float <= x.high + x.low, and the smallest float >= it.
[[nodiscard]] inline float round_down(double_double x) {
    const float f = static_cast<float>(x.high);
    const bool above = double(f) > x.high || (double(f) == x.high && x.low < 0);
    return above ? std::nextafter(f, -infinity) : f;
}
[[nodiscard]] inline float round_up(double_double x) { return -round_down(-x); }

/// The box around all points lo <= p <= hi, rounded outwards.
[[nodiscard]] inline aabb enclosing(const glm::dvec3& lo, const glm::dvec3& hi) {
    return {{round_down({lo.x}), round_down({lo.y}), round_down({lo.z})},
            {round_up({hi.x}), round_up({hi.y}), round_up({hi.z})}};
}

/// The box with its faces moved outwards by `by`, which is not negative; rounded outwards.
[[nodiscard]] inline aabb grown(const aabb& box, glm::vec3 by) {
    aabb result;
    for (int i = 0; i < 3; ++i) {
        result.min[i] = round_down(two_sum(box.min[i], -double(by[i])));
        result.max[i] = round_up(two_sum(box.max[i], by[i]));
    }
    return result;
}

/// The box moved by `by`; rounded outwards.
[[nodiscard]] inline aabb moved(const aabb& box, glm::vec3 by) {
    aabb result;
    for (int i = 0; i < 3; ++i) {
        result.min[i] = round_down(two_sum(box.min[i], by[i]));
        result.max[i] = round_up(two_sum(box.max[i], by[i]));
    }
    return result;
}

/// A ray made ready to be tested against many boxes.
struct slab_ray {
    glm::dvec3 origin;
    glm::dvec3 reciprocal;  ///< of the direction's components; infinite for 0
    double padding;         ///< how far rounding may have moved what is in the boxes, as seen from the origin

    explicit slab_ray(const precise::ray& r)
        : origin(r.origin), reciprocal(1.0 / r.direction),
          padding(0x1p-40 * std::max({std::abs(origin.x), std::abs(origin.y), std::abs(origin.z)})) {}
    explicit slab_ray(const ray& r) : slab_ray(precise::widen(r)) {}
};

/// Whether the ray may meet what is in the box, within the range. Touching counts, flat boxes and points can be hit, and
/// a ray within a face's plane meets the box. It may say yes to a ray that passes the box at some 1e-12 of the
/// coordinates, never no to one that meets it. Three slabs (Kay and Kajiya 1986); the padding after Ize 2013; a NaN from
/// 0 * infinity, where the ray runs within a face, fails its comparison and bounds nothing (Williams et al. 2005).
[[nodiscard]] inline bool overlaps(const aabb& box, const slab_ray& r, interval range) {
    if (empty(box)) return false;
    double size = 0;
    for (int i = 0; i < 3; ++i) size = std::max({size, double(std::abs(box.min[i])), double(std::abs(box.max[i]))});
    const double padding = r.padding + 0x1p-40 * size;
    double near = range.min, far = range.max;
    near -= 0x1p-22 * std::abs(near);  // a hit's t is rounded to float before it is compared
    far += 0x1p-22 * std::abs(far);
    for (int i = 0; i < 3; ++i) {
        const double lower = ((box.min[i] - padding) - r.origin[i]) * r.reciprocal[i];
        const double upper = ((box.max[i] + padding) - r.origin[i]) * r.reciprocal[i];
        const bool forward = !std::signbit(r.reciprocal[i]);
        const double enter = forward ? lower : upper, leave = forward ? upper : lower;
        near = enter > near ? enter : near;
        far = leave < far ? leave : far;
    }
    return near <= far + 0x1p-40 * std::abs(far);
}

template <class Ray>
    requires std::derived_from<Ray, ray> || std::derived_from<Ray, precise::ray>
[[nodiscard]] bool overlaps(const aabb& box, const Ray& r, interval range) {
    return overlaps(box, slab_ray(r), range);
}

}  // namespace lantern
