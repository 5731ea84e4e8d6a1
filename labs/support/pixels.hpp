// SPDX-License-Identifier: MIT
#pragma once
// Pictures whose pixels are functions: for labs that bring a renderer of their own.

#include <lantern/image.hpp>
#include <lantern/render.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>

namespace support {

/// The mean of sample(i) for all i below `count`, as `lantern::render` would add them.
template <class Sample>
[[nodiscard]] glm::vec3 mean_of(std::uint32_t count, const Sample& sample) {
    lantern::accumulator sum;
    for (std::uint32_t i = 0; i < count; ++i) sum.add(sample(i));
    return sum.mean();
}

/// pixel({x, y}) for every pixel, in parallel.
template <class Pixel>
[[nodiscard]] lantern::image picture_of(glm::uvec2 size, const Pixel& pixel) {
    lantern::image result(size);
    lantern::in_parallel(size.y, 0, [&](std::size_t row) {
        for (unsigned x = 0; x < size.x; ++x) result(x, unsigned(row)) = pixel(glm::uvec2(x, unsigned(row)));
    });
    return result;
}

}  // namespace support
