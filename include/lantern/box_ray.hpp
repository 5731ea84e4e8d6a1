// SPDX-License-Identifier: MIT
#pragma once
// A ray made ready to be tested against many boxes, in float, and never to miss one.

#include <lantern/aabb.hpp>
#include <lantern/interval.hpp>
#include <lantern/ray.hpp>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace lantern {

/// Three slabs (Kay and Kajiya 1986). Near planes are seen from an origin that is moved forward by q, far planes from one that
/// is moved back: the box seems larger, by more than is rounded before the division. What is rounded afterwards, a few
/// parts in 2^24, is made up for by far distances that are 16 parts longer (Ize 2013). docs/headers/box_ray.md derives it.
class box_ray {
public:
    /// `reach`: the largest coordinate of the boxes that it will be tested against, and `rounded` by how much these may be off.
    /// Where differences of coordinates overflow, all boxes are met.
    [[gnu::always_inline]] box_ray(const ray& r, interval range, double reach, double rounded = 0) {
        const glm::vec3 away = glm::abs(r.origin), length = glm::abs(r.direction);
        const float longest = std::max(std::max(length.x, length.y), length.z);
        const float all = std::max(std::max(away.x, away.y), away.z) + static_cast<float>(reach);
        if (range.min >= 0 && 0x1p-20f < longest) [[likely]] {
            const float beyond = static_cast<float>(rounded) + 0x1p-33f * all;
            for (int i = 0; i < 3; ++i) {
                const float q = std::copysign(0x1p-21f * away[i] + beyond, r.direction[i]);
                look(i, r.origin[i] + q, r.origin[i] - q, std::copysign(1 / std::max(length[i], 0x1p-60f), r.direction[i]));
            }
            near_ = range.min;
        } else {
            make_ready(r, range, reach, rounded);
        }
        shorten(range.max);
    }

    /// From now on, only what is met up to t = `max` counts.
    void shorten(float max) {
        const double far = (max - start_ + 0x1p-149) * per_unit_;  // a hit's t may have been rounded down to max
        far_ = far < infinity ? static_cast<float>(far) * longer : infinity;
    }

    /// Whether the ray may meet what is in the box within the range; `entry` gets how far away it begins, in a unit of its own.
    /// The box must not be empty.
    [[nodiscard, gnu::always_inline]] bool meets(const aabb& box, float& entry) const {
        const auto near = [&](int i) { return ((box.*near_corner_[std::size_t(i)])[i] - near_origin_[i]) * per_near_[i]; };
        const auto far = [&](int i) { return ((box.*far_corner_[std::size_t(i)])[i] - far_origin_[i]) * per_far_[i]; };
        entry = std::max(std::max(near(0), near(1)), std::max(near(2), near_));
        return entry <= std::min(std::min(far(0), far(1)), std::min(far(2), far_));
    }

    /// Whether what begins there still counts.
    [[nodiscard]] bool reaches(float entry) const { return entry <= far_; }

protected:
    glm::vec3 near_origin_, far_origin_, per_near_, per_far_;
    float near_, far_;

private:
    static constexpr float longer = 1 + 0x1p-20f;

    // Along an axis: from where the planes are seen, and what a difference of coordinates is as a distance.
    [[gnu::always_inline]] void look(int axis, float near_origin, float far_origin, float per_length) {
        const auto i = static_cast<std::size_t>(axis);
        near_origin_[axis] = near_origin;
        far_origin_[axis] = far_origin;
        per_near_[axis] = per_length;
        per_far_[axis] = per_length * longer;
        near_corner_[i] = per_length < 0 ? &aabb::max : &aabb::min;
        far_corner_[i] = per_length < 0 ? &aabb::min : &aabb::max;
    }

    // The same for rays of any length, from anywhere.
    [[gnu::noinline]] void make_ready(const ray& r, interval range, double reach, double rounded) {
        // Where it begins behind its origin it is started there, so that no distance is negative.
        start_ = std::clamp(double(range.min), -double(std::numeric_limits<float>::max()), 0.0);
        const glm::dvec3 d(r.direction), from(r.origin), o = from + start_ * d, away = glm::abs(o) + glm::abs(from), length = glm::abs(d);
        const double longest = std::max({length.x, length.y, length.z}), all = std::max({away.x, away.y, away.z}) + reach;
        // The largest power of two <= longest: its exponent's bits alone. In this unit the longest is between 1 and 2.
        per_unit_ = std::bit_cast<double>(std::bit_cast<std::uint64_t>(longest) & 0x7ff0000000000000u);
        for (int i = 0; i < 3; ++i) {
            const double shift = all < 0x1p126 ? 0x1p-22 * away[i] + (0x1p-34 * all + rounded) : infinity, q = std::copysign(shift, d[i]);
            const double per_length = 1 / std::max(0x1p-60, length[i] * (1 / per_unit_));  // in this order for NaN
            look(i, static_cast<float>(o[i] + q), static_cast<float>(o[i] - q), static_cast<float>(std::copysign(per_length, d[i])));
        }
        near_ = static_cast<float>((range.min - start_) * per_unit_);
    }

    std::array<glm::vec3 aabb::*, 3> near_corner_, far_corner_;
    double start_ = 0, per_unit_ = 1;  // t - start_, times per_unit_, is the distance in our unit
};

}  // namespace lantern
