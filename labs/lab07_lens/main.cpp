// SPDX-License-Identifier: MIT
// Lab 07: points of a lens, and what they do to a picture.

#include "../support/pages.hpp"
#include "pictures.hpp"

int main(int argc, char** argv) {
    return support::draw(argc, argv, {
        {"lab07_1_lens.png", pictures::lens},
        {"lab07_3_focus.png", [] { return pictures::taken(pictures::focused({720, 300}, 6, 0.12f, pictures::depth_of(1))); }},
        {"lab07_5_discs.png", pictures::discs},
        {"lab07_6_samples.png", pictures::samples},
        {"lab07_7_blades.png", [] { return pictures::taken(pictures::blades({720, 300}, 6, 6)); }},
    });
}
