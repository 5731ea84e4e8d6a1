// SPDX-License-Identifier: MIT
#pragma once
// Four boxes side by side, tested against one ray at once.

#include <lantern/aabb.hpp>
#include <lantern/box_ray.hpp>
#include <lantern/interval.hpp>
#include <lantern/lanes.hpp>
#include <lantern/ray.hpp>

#include <cstddef>
#include <cstdint>

namespace lantern {

/// Axis by axis, the lower ends of all four are neighbours, and so are their upper ends. A slot that is not used holds the empty
/// box, which no ray meets.
struct box_quartet {
    quad lower[3]{all(infinity), all(infinity), all(infinity)};
    quad upper[3]{all(-infinity), all(-infinity), all(-infinity)};

    static quad all(float x) { return quad{x, x, x, x}; }
    void set(std::size_t i, const aabb& box) {
        for (int axis = 0; axis < 3; ++axis) lower[axis][i] = box.min[axis], upper[axis][i] = box.max[axis];
    }
    [[nodiscard]] aabb operator[](std::size_t i) const { return {{lower[0][i], lower[1][i], lower[2][i]}, {upper[0][i], upper[1][i], upper[2][i]}}; }
};

/// A `box_ray` that asks four boxes in the steps that it takes for one: the same answers, to the last bit.
class box_quartet_ray : public box_ray {
public:
    [[gnu::always_inline]] box_quartet_ray(const ray& r, interval range, double reach, double rounded = 0) : box_ray(r, range, reach, rounded) {
        const auto make = [&](int i) __attribute__((always_inline)) {
            return slab{box_quartet::all(near_origin_[i]), box_quartet::all(far_origin_[i]), box_quartet::all(per_near_[i]), box_quartet::all(per_far_[i]),
                        per_near_[i] < 0 ? &box_quartet::upper : &box_quartet::lower, per_near_[i] < 0 ? &box_quartet::lower : &box_quartet::upper};
        };
        x_ = make(0), y_ = make(1), z_ = make(2);
    }

    using box_ray::meets;

    /// Bit i is set where the ray may meet what is in box i within the range; lane i of `entry` gets how far away that begins.
    [[nodiscard, gnu::always_inline]] std::uint32_t meets(const box_quartet& boxes, quad& entry) const {
        quad near_x = ((boxes.*x_.near)[0] - x_.near_origin) * x_.per_near, far_x = ((boxes.*x_.far)[0] - x_.far_origin) * x_.per_far;
        quad near_y = ((boxes.*y_.near)[1] - y_.near_origin) * y_.per_near, far_y = ((boxes.*y_.far)[1] - y_.far_origin) * y_.per_far;
        quad near_z = ((boxes.*z_.near)[2] - z_.near_origin) * z_.per_near, far_z = ((boxes.*z_.far)[2] - z_.far_origin) * z_.per_far;
        quad exit = box_quartet::all(far_);
        entry = box_quartet::all(near_);
        keep_larger(near_x, near_y);
        keep_larger(entry, near_z);
        keep_larger(entry, near_x);
        keep_smaller(far_x, far_y);
        keep_smaller(exit, far_z);
        keep_smaller(exit, far_x);
        return lanes_of(quad_integers(entry <= exit));
    }

private:
    struct slab {
        quad near_origin, far_origin, per_near, per_far;
        quad (box_quartet::*near)[3];
        quad (box_quartet::*far)[3];
    };

    slab x_, y_, z_;
};

}  // namespace lantern
