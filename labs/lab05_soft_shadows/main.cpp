// SPDX-License-Identifier: MIT
// Lab 05: a table under a lamp. Left: one ray to the lamp's middle; right: sixteen points of the lamp, once everything is
// written. A second picture, of a round lamp, comes with the last steps.

#include "../support/gaps.hpp"
#include "pictures.hpp"

#include <lantern/image.hpp>
#include <lantern/ppm.hpp>
#include <lantern/render.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace {

using pictures::size;

support::gaps gaps;

/// Every pixel in a light; or, while a step is missing, the test card. `render` hands on what a thread throws.
template <class Light>
lantern::image picture(const Light& light) {
    const pictures::room table;
    try {
        return lantern::render(size, pictures::camera, pictures::samples, pictures::shade<Light>{table, light});
    } catch (const lantern::unfinished& gap) {
        gaps.note(gap);
        lantern::image card(size);
        support::paint_test_card(card, {0, 0}, size, support::step_number(gap.what()));
        return card;
    }
}

void save(const std::filesystem::path& path, const lantern::image& picture) {
    lantern::write_ppm(path, picture);
    std::cout << path.string() << '\n';
}

}  // namespace

int main(int argc, char** argv) try {
    const std::filesystem::path folder = argc > 1 ? argv[1] : "out";
    lantern::image both({2 * size.x, size.y});
    const lantern::image left = picture(pictures::hard), right = picture(pictures::soft);
    for (unsigned y = 0; y < size.y; ++y) {
        std::ranges::copy(left.row(y), both.row(y).begin());
        std::ranges::copy(right.row(y), both.row(y).begin() + size.x);
    }
    save(folder / "lab05.ppm", both);
    if (gaps.none()) save(folder / "lab05_round.ppm", picture(pictures::round));
    gaps.tell();
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
