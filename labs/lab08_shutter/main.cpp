// SPDX-License-Identifier: MIT
// Lab 08: things that move while the shutter is open.

#include "../support/pages.hpp"
#include "pictures.hpp"

int main(int argc, char** argv) {
    return support::draw(argc, argv, {
        {"lab08_2_moving.png", [] { return pictures::moving({720, 300}, 4); }},
        {"lab08_3_boxes.png", [] { return pictures::boxes({720, 300}, 4); }},
        {"lab08_4_whole.png", [] { return pictures::whole({720, 300}, 6); }},
        {"lab08_5_lamps.png", pictures::lamps},
        {"lab08_6_profiles.png", pictures::profiles},
    });
}
