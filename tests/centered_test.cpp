// SPDX-License-Identifier: MIT
#include <lantern/centered.hpp>

#include <lantern/camera.hpp>

#include "catch.hpp"

using namespace lantern;

TEST_CASE("one sample, and one half for every purpose, on every path") {
    CHECK(centered::count() == 1);
    const auto source = centered{}.at({17, 4}, 0);
    for (const purpose p : {purpose::film, purpose::lens, purpose::time, purpose::light, purpose::gloss}) {
        CHECK(source.draw1(p) == 0.5f);
        CHECK(source.draw2(p, 3) == glm::vec2(0.5f));
        CHECK(source.branch(1).branch(0).draw2(p) == glm::vec2(0.5f));
    }
}

TEST_CASE("a lens is passed through its middle, at half the exposure") {
    const view seat{.eye = {0, 1, 5}, .target = {0, 0, 0}};
    const auto source = centered{}.at({0, 0}, 0);
    const ray sharp = shoot(camera{seat}, {0.3f, 0.6f}, source);
    const timed_ray r = shoot(camera{seat, thin_lens{.radius = 1, .focus_distance = 3}, shutter{0, 0.5f}}, {0.3f, 0.6f}, source);
    CHECK(r.origin == sharp.origin);
    CHECK(r.direction == sharp.direction);
    CHECK(r.time == 0.25f);
}
