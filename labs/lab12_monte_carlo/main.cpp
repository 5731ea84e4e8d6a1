// SPDX-License-Identifier: MIT
// Lab 12: a picture for each step, from noise to the Cornell box.

#include "../support/pages.hpp"
#include "pictures.hpp"

int main(int argc, char** argv) {
    return support::draw(argc, argv, {
        {"lab12_1_estimates.png", pictures::estimates},
        {"lab12_2_directions.png", pictures::directions},
        {"lab12_3_cosine.png", pictures::cosine},
        {"lab12_5_direct.png", [] { return pictures::direct(16); }},
        {"lab12_6_two_ways.png", [] { return pictures::two_ways(); }},
        {"lab12_7_survivors.png", pictures::survivors},
        {"lab12_8_box.png", [] { return pictures::box(32); }},
    });
}
