// SPDX-License-Identifier: MIT
#pragma once
// Lab 01: from a pixel to a ray, and from colours to a file. The handout is README.md in this folder.

#include <lantern/todo.hpp>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>

namespace lab01 {

/// Step 1. The unit direction of the ray from the eye through the centre of a pixel. The eye stands at the origin and
/// looks along -z; x points to the right, y up. Pixel (0, 0) is the top left one, `size` is (width, height), and
/// `fov` is the angle between the upper and the lower border of the picture, in radians. Pixels are square.
[[nodiscard]] inline glm::vec3 direction(glm::uvec2 pixel, glm::uvec2 size, float fov) {
    return lantern::todo("lab01 step 1: the ray through the centre of a pixel");
}

/// Step 2. What a screen must be told so that it shines with the brightness `linear`: the sRGB curve. Brightness below 0
/// counts as 0, above 1 as 1.
[[nodiscard]] inline float encode(float linear) {
    return lantern::todo("lab01 step 2: the sRGB curve");
}

/// Step 3. The byte, 0 to 255, nearest to an encoded value from 0 to 1. Values outside give the nearest end; NaN gives 0.
[[nodiscard]] inline std::uint8_t quantise(float encoded) {
    return lantern::todo("lab01 step 3: from a number to a byte");
}

/// Step 4. The picture as a binary PPM file (P6): a header, then three bytes for each pixel, row by row from the top,
/// each row from the left. `pixels` are linear colours in that order. Throws std::invalid_argument when there are not
/// exactly size.x * size.y of them.
[[nodiscard]] inline std::string ppm(glm::uvec2 size, std::span<const glm::vec3> pixels) {
    return lantern::todo("lab01 step 4: the PPM file");
}

}  // namespace lab01
