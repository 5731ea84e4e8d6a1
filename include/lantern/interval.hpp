// SPDX-License-Identifier: MIT
#pragma once
// The stretch of a ray that still matters.

#include <limits>

namespace lantern {

inline constexpr float infinity = std::numeric_limits<float>::infinity();

/// The half-open stretch (min, max] of a ray's parameter t: open at min, so that a ray does not hit the point
/// it starts from; closed at max, so that a second surface at the same t is still offered and a tie can be broken
/// by index, whatever the order of the offers. Empty when max <= min, or when either is NaN.
struct interval {
    float min = 0;
    float max = infinity;
};

[[nodiscard]] constexpr bool empty(interval range) { return !(range.min < range.max); }

/// Whether t lies in (min, max]. Infinity and NaN lie in no interval.
[[nodiscard]] constexpr bool contains(interval range, float t) {
    return range.min < t && t <= range.max && t < infinity;
}

}  // namespace lantern
