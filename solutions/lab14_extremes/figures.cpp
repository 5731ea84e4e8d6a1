// SPDX-License-Identifier: MIT
// The figures of lab 14's handout.

#include "../../labs/lab14_extremes/pictures.hpp"

#include <lantern/png.hpp>

#include <filesystem>

int main(int argc, char** argv) {
    const std::filesystem::path folder = argc > 1 ? argv[1] : "labs/lab14_extremes/figures";
    support::gaps none;
    lantern::write_png(folder / "ground.png", pictures::grounds(none));
    lantern::write_png(folder / "cloth.png", pictures::cloths(none));
    lantern::write_png(folder / "wall.png", pictures::walls(none));
    lantern::write_png(folder / "shadows.png", pictures::shadows(none));
    lantern::write_png(folder / "poles.png", pictures::poles(none));
    lantern::write_png(folder / "sums.png", pictures::sums(none));
    lantern::write_png(folder / "critical.png", pictures::critical(none));
}
