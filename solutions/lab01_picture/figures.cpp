// SPDX-License-Identifier: MIT
// The figures of lab 01's handout.

#include <lab01_picture/picture.hpp>

#include <lantern/image.hpp>
#include <lantern/png.hpp>
#include <lantern/srgb.hpp>

#include <glm/common.hpp>

#include <filesystem>

namespace {

glm::vec3 rays_as_colours(glm::vec3 direction) { return 0.5f * direction + 0.5f; }

lantern::image rays() {
    lantern::image picture({320, 240});
    for (unsigned y = 0; y < 240; ++y)
        for (unsigned x = 0; x < 320; ++x) picture(x, y) = rays_as_colours(lab01::direction({x, y}, {320, 240}, 1.7f));
    return picture;
}

/// A picture of 6 x 4 pixels, each 70 wide, with a dot where its ray goes through.
lantern::image pixels() {
    const unsigned side = 70;
    lantern::image picture(glm::uvec2(6, 4) * side + 1u, glm::vec3(1));
    for (unsigned y = 0; y < 4 * side; ++y)
        for (unsigned x = 0; x < 6 * side; ++x) {
            const glm::uvec2 pixel = glm::uvec2(x, y) / side, within = glm::uvec2(x, y) % side;
            const float from_centre = glm::length(glm::vec2(within) - 0.5f * float(side));
            if (within.x == 0 || within.y == 0) continue;
            picture(x, y) = from_centre < 4 ? glm::vec3(0) : rays_as_colours(lab01::direction(pixel, {6, 4}, 1.7f));
        }
    return picture;
}

/// Eleven equal steps of light: above as a screen shows them unencoded, below encoded.
lantern::image steps_of_light() {
    lantern::image picture({550, 160});
    for (unsigned y = 0; y < 160; ++y)
        for (unsigned x = 0; x < 550; ++x) {
            const float light = float(x / 50) / 10;
            picture(x, y) = glm::vec3(lantern::from_srgb(y < 80 ? light : lab01::encode(light)));
        }
    return picture;
}

}  // namespace

int main(int argc, char** argv) {
    const std::filesystem::path folder = argc > 1 ? argv[1] : "labs/lab01_picture/figures";
    lantern::write_png(folder / "rays.png", rays());
    lantern::write_png(folder / "pixels.png", pixels());
    lantern::write_png(folder / "light.png", steps_of_light());
}
