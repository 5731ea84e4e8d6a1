// SPDX-License-Identifier: MIT
// Lab 13: errors that are measured.

#include "../support/pages.hpp"
#include "pictures.hpp"

int main(int argc, char** argv) {
    return support::draw(argc, argv, {
        {"lab13_3_slopes.png", pictures::slopes},
        {"lab13_5_cells.png", pictures::grids},
        {"lab13_6_swirls.png", [] { return pictures::swirls({360, 240}); }},
        {"lab13_8_patients.png", pictures::ward},
    });
}
