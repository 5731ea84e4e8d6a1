// SPDX-License-Identifier: MIT
// Lab 02: a small world in the colours of its normals. What is not written yet is not there.

#include "../support/gaps.hpp"
#include "pictures.hpp"

#include <lantern/image.hpp>
#include <lantern/png.hpp>
#include <lantern/render.hpp>

#include <exception>
#include <filesystem>
#include <iostream>
#include <vector>

namespace {

support::gaps gaps;

lantern::image picture() {
    const std::vector<pictures::thing> things = pictures::world(gaps);
    const bool in_order = pictures::in_order(gaps);
    if (things.empty()) {
        lantern::image card(pictures::size);
        support::paint_test_card(card, {0, 0}, card.size(), gaps.next_step());
        return card;
    }
    return lantern::render(pictures::size, pictures::camera(), pictures::samples, pictures::shade<pictures::thing>{things, in_order});
}

}  // namespace

int main(int argc, char** argv) try {
    const std::filesystem::path path = std::filesystem::path(argc > 1 ? argv[1] : "out") / "lab02.png";
    lantern::write_png(path, picture());
    std::cout << path.string() << '\n';
    gaps.tell();
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
