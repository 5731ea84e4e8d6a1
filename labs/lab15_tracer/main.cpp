// SPDX-License-Identifier: MIT
// Lab 15: your ray tracer.

#include "../support/pages.hpp"
#include "pictures.hpp"

int main(int argc, char** argv) {
    return support::draw(argc, argv, {
        {"lab15_1_camera.png", [] { return pictures::cameras(); }},
        {"lab15_2_samples.png", pictures::samples},
        {"lab15_3_lamp.png", [] { return pictures::lamp(); }},
        {"lab15_4_gloss.png", [] { return pictures::gloss(); }},
        {"lab15_5_balls.png", [] { return pictures::balls(); }},
        {"lab15_6_tracer.png", [] { return pictures::still_life(); }},
        {"lab15_7_tree.png", [] { return pictures::questions(); }},
        {"lab15_8_yours.png", [&] { return pictures::assembled(argc > 1 ? argv[1] : "out"); }},
        {"lab15_9_error.png", [] { return pictures::errors(); }},
    });
}
