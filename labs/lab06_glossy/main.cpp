// SPDX-License-Identifier: MIT
// Lab 06: a picture for each step, from the basis to frosted glass.

#include "../support/pages.hpp"
#include "pictures.hpp"

int main(int argc, char** argv) {
    return support::draw(argc, argv, {
        {"lab06_1_axes.png", pictures::axes},
        {"lab06_2_square.png", pictures::square},
        {"lab06_3_row.png", [] { return hall::picture(pictures::row(5)); }},
        {"lab06_4_points.png", [] { return pictures::points(); }},
        {"lab06_5_frosted.png", [] { return hall::picture(pictures::frosted(5)); }},
    });
}
