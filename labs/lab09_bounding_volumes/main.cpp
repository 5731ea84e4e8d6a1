// SPDX-License-Identifier: MIT
// Lab 09: which volume is tight? Four things in each volume, and a table of the rays that come in vain.

#include "../support/pages.hpp"
#include "pictures.hpp"

#include <iostream>

int main(int argc, char** argv) {
    const int status = support::draw(argc, argv, {
        {"lab09_2_boxes.png", [] { return pictures::boxes(2); }},
        {"lab09_4_spheres.png", [] { return pictures::spheres(2); }},
        {"lab09_6_oriented.png", [] { return pictures::oriented_boxes(2); }},
        {"lab09_7_turned.png", [] { return pictures::turned(2); }},
        {"lab09_8_saved.png", [] { return pictures::saved(2); }},
        {"lab09_9_smallest.png", [] { return pictures::smallest(2); }},
    });
    std::cout << '\n';
    pictures::write_table(std::cout);
    return status;
}
