// SPDX-License-Identifier: MIT
#pragma once
// What an acceleration structure is built over: the boxes of many surfaces, and which of them it can take.

#include <lantern/aabb.hpp>
#include <lantern/validate.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ranges>
#include <span>
#include <string>
#include <vector>

namespace lantern {

/// Of each surface its box, in their order.
template <std::ranges::input_range Surfaces>
    requires bounded<std::ranges::range_value_t<Surfaces>>
[[nodiscard]] std::vector<aabb> boxes_of(const Surfaces& surfaces) {
    std::vector<aabb> boxes;
    if constexpr (std::ranges::sized_range<const Surfaces>) boxes.reserve(std::ranges::size(surfaces));
    for (const auto& s : surfaces) boxes.push_back(bounds(s));
    return boxes;
}

/// Which boxes are neither empty nor infinite nor NaN. The others no structure can place: they are left out, and counted.
/// Throws std::invalid_argument for 2^30 boxes or more.
[[nodiscard]] inline std::vector<std::uint32_t> placeable(std::span<const aabb> boxes) {
    if (boxes.size() >= std::size_t{1} << 30)
        refuse("acceleration structure: the number of surfaces", std::to_string(boxes.size()), "below 2^30");
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
        if (!empty(boxes[i]) && is_finite(boxes[i].min) && is_finite(boxes[i].max)) indices.push_back(i);
    return indices;
}

/// The largest absolute coordinate.
[[nodiscard]] inline double reach_of(const aabb& box) {
    double reach = 0;
    for (int i = 0; i < 3; ++i) reach = std::max({reach, std::abs(double(box.min[i])), std::abs(double(box.max[i]))});
    return reach;
}

}  // namespace lantern
