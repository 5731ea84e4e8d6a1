// SPDX-License-Identifier: MIT
// Lab 03: Whitted's spheres. What is not written yet is replaced by something plain.

#include "../support/gaps.hpp"
#include "pictures.hpp"

#include <lantern/image.hpp>
#include <lantern/png.hpp>
#include <lantern/render.hpp>

#include <exception>
#include <filesystem>
#include <iostream>

int main(int argc, char** argv) try {
    const std::filesystem::path path = std::filesystem::path(argc > 1 ? argv[1] : "out") / "lab03.png";
    support::gaps gaps;
    const pictures::shade shade(gaps);
    lantern::image made = lantern::render(pictures::size, lab03::whitted_camera(pictures::size), pictures::samples, shade);
    // The number of the next step, in a corner.
    if (!shade.is_whole()) support::paint_test_card(made, {0, 0}, pictures::size / 5u, gaps.next_step());
    lantern::write_png(path, made);
    std::cout << path.string() << '\n';
    gaps.tell();
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
