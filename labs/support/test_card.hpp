// SPDX-License-Identifier: MIT
#pragma once
// The picture of a lab that is not written yet: a television's test card with the number of the step to do next.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <string>
#include <string_view>

namespace support {

/// The number after "step " in what an unfinished function says; 0 when there is none.
[[nodiscard]] inline int step_number(std::string_view message) {
    const auto at = message.find("step ");
    return at == std::string_view::npos || at + 5 >= message.size() ? 0 : message[at + 5] - '0';
}

/// Whether a point lies on the digit as an alarm clock shows it; the digit fills x from 0 to 1 and y, downwards, from 0 to 2.
[[nodiscard]] inline bool on_digit(glm::vec2 p, int digit) {
    struct segment { float left, top, right, bottom; };
    static constexpr float w = 0.2f;
    static constexpr std::array<segment, 7> segments{{
        {0, 0, 1, w}, {1 - w, 0, 1, 1}, {1 - w, 1, 1, 2}, {0, 2 - w, 1, 2}, {0, 1, w, 2}, {0, 0, w, 1}, {0, 1 - w / 2, 1, 1 + w / 2}}};
    static constexpr std::array<unsigned, 10> lit{0x3f, 0x06, 0x5b, 0x4f, 0x66, 0x6d, 0x7d, 0x07, 0x7f, 0x6f};
    for (unsigned i = 0; i < 7; ++i) {
        const segment s = segments[i];
        if ((lit[unsigned(digit) % 10] >> i & 1) && p.x >= s.left && p.x < s.right && p.y >= s.top && p.y < s.bottom) return true;
    }
    return false;
}

/// The card's linear colour at a point of the film, (0, 0) the top left corner and (1, 1) the bottom right one.
[[nodiscard]] inline glm::vec3 test_card(glm::vec2 film, int step) {
    const glm::vec2 p = (film - glm::vec2(0.41f, 0.22f)) * glm::vec2(1 / 0.18f, 2 / 0.48f);
    const bool plate = film.x > 0.36f && film.x < 0.64f && film.y > 0.14f && film.y < 0.78f;
    if (plate) return on_digit(p, step) ? glm::vec3(1, 0.75f, 0.1f) : glm::vec3(0.02f);
    if (film.y > 0.84f) return glm::vec3(std::floor(film.x * 11) / 10);
    const int bar = 7 - int(film.x * 8);  // white, yellow, cyan, green, magenta, red, blue, black
    return 0.8f * glm::vec3(bar >> 1 & 1, bar >> 2 & 1, bar & 1);
}

/// Paints the card onto a part of a picture: anything whose pixels are picture(x, y).
template <class Picture>
void paint_test_card(Picture& picture, glm::uvec2 corner, glm::uvec2 size, int step) {
    for (unsigned y = 0; y < size.y; ++y)
        for (unsigned x = 0; x < size.x; ++x)
            picture(corner.x + x, corner.y + y) = test_card((glm::vec2(x, y) + 0.5f) / glm::vec2(size), step);
}

}  // namespace support
