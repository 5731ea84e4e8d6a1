// SPDX-License-Identifier: MIT
// The figures of lab 13's handout.

#include "../../labs/lab13_error/pictures.hpp"

#include <lantern/png.hpp>

#include <filesystem>

int main(int argc, char** argv) {
    const std::filesystem::path folder = argc > 1 ? argv[1] : "labs/lab13_error/figures";
    lantern::write_png(folder / "slopes.png", pictures::slopes());
    lantern::write_png(folder / "grids.png", pictures::grids());
    lantern::write_png(folder / "swirls.png", pictures::swirls({360, 240}));
    lantern::write_png(folder / "patients.png", pictures::ward());
}
