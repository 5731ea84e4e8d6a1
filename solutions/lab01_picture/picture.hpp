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
    // BEGIN SOLUTION
    const float half_height = std::tan(fov / 2);
    const float half_width = half_height * float(size.x) / float(size.y);
    const glm::vec2 centre = glm::vec2(pixel) + 0.5f;
    const float x = 2 * centre.x / float(size.x) - 1;
    const float y = 1 - 2 * centre.y / float(size.y);
    return glm::normalize(glm::vec3(x * half_width, y * half_height, -1));
    // END SOLUTION
    // STARTER: return lantern::todo("lab01 step 1: the ray through the centre of a pixel");
}

/// Step 2. What a screen must be told so that it shines with the brightness `linear`: the sRGB curve. Brightness below 0
/// counts as 0, above 1 as 1.
[[nodiscard]] inline float encode(float linear) {
    // BEGIN SOLUTION
    if (!(linear > 0)) return 0;  // the way round that sends NaN here too
    if (linear >= 1) return 1;
    if (linear <= 0.0031308f) return 12.92f * linear;
    return 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
    // END SOLUTION
    // STARTER: return lantern::todo("lab01 step 2: the sRGB curve");
}

/// Step 3. The byte, 0 to 255, nearest to an encoded value from 0 to 1. Values outside give the nearest end; NaN gives 0.
[[nodiscard]] inline std::uint8_t quantise(float encoded) {
    // BEGIN SOLUTION
    if (!(encoded > 0)) return 0;
    if (encoded >= 1) return 255;
    return static_cast<std::uint8_t>(255 * encoded + 0.5f);
    // END SOLUTION
    // STARTER: return lantern::todo("lab01 step 3: from a number to a byte");
}

/// Step 4. The picture as a binary PPM file (P6): a header, then three bytes for each pixel, row by row from the top,
/// each row from the left. `pixels` are linear colours in that order. Throws std::invalid_argument when there are not
/// exactly size.x * size.y of them.
[[nodiscard]] inline std::string ppm(glm::uvec2 size, std::span<const glm::vec3> pixels) {
    // BEGIN SOLUTION
    if (pixels.size() != std::size_t{size.x} * size.y)
        throw std::invalid_argument("ppm: " + std::to_string(pixels.size()) + " pixels do not fill a picture of " +
                                    std::to_string(size.x) + " x " + std::to_string(size.y));
    std::string file = "P6\n" + std::to_string(size.x) + ' ' + std::to_string(size.y) + "\n255\n";
    for (const glm::vec3& colour : pixels)
        for (const float channel : {colour.r, colour.g, colour.b})
            file += static_cast<char>(quantise(encode(channel)));
    return file;
    // END SOLUTION
    // STARTER: return lantern::todo("lab01 step 4: the PPM file");
}

}  // namespace lab01
