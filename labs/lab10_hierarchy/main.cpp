// SPDX-License-Identifier: MIT
// Lab 10: many balls, in boxes, in boxes.

#include "../support/pages.hpp"
#include "pictures.hpp"

int main(int argc, char** argv) {
    const glm::uvec2 half{359, 280}, third{300, 260};
    return support::draw(argc, argv, {
        {"lab10_1_groups.png", [] { return pictures::groups({720, 480}); }},
        {"lab10_2_halves.png", [=] { return pictures::median_and_middle(half); }},
        {"lab10_3_levels.png", [=] { return pictures::levels(third); }},
        {"lab10_4_costs.png", pictures::costs},
        {"lab10_4_halves.png", [=] { return pictures::divided_thrice(third, lab10::at_least_cost); }},
        {"lab10_5_joined.png", [=] { return pictures::joined(third); }},
        {"lab10_6_cost.png", [=] { return pictures::cost_map(third); }},
        {"lab10_6_growth.png", [] { return pictures::plot(pictures::growth(5)); }},
        {"lab10_7_shadows.png", [=] { return pictures::shadows(half); }},
        {"lab10_8_moving.png", [=] { return pictures::moving(half, 3); }},
    });
}
