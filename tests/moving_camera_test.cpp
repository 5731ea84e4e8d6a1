// SPDX-License-Identifier: MIT
#include <lantern/moving_camera.hpp>

#include <lantern/image.hpp>
#include <lantern/moving.hpp>
#include <lantern/render.hpp>
#include <lantern/sphere.hpp>

#include "catch.hpp"
#include "counting_source.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

using namespace lantern;

namespace {

const view before{.eye = {0, 1, 5}, .target = {0, 0, 0}};
const view after{.eye = {2, 1.5f, 4}, .target = {0.5f, 0, -1}, .up = {0.1f, 1, 0}, .vertical_fov = 0.5f};

timed_ray at_time(const auto& cam, float time, glm::vec2 film = {0.3f, 0.8f}) {
    draws counted;
    return shoot(cam, film, counting_source{&counted, time});
}

}  // namespace

TEST_CASE("at the ends of the exposure a moving camera is the camera at each end") {
    const moving_camera cam(before, after, thin_lens{.radius = 0.1f, .focus_distance = 4});
    for (const auto& [time, where] : {std::pair{0.0f, before}, std::pair{1.0f, after}}) {
        draws counted;
        const ray still = shoot(camera(where, thin_lens{.radius = 0.1f, .focus_distance = 4}), {0.3f, 0.8f}, counting_source{&counted});
        const timed_ray moving = at_time(cam, time);
        CHECK(moving.origin == still.origin);
        CHECK(moving.direction == still.direction);
        CHECK(moving.time == time);
    }
}

TEST_CASE("halfway the eye is halfway") {
    const timed_ray r = at_time(moving_camera(before, after), 0.5f);
    CHECK(glm::length(r.origin - glm::vec3(1, 1.25f, 4.5f)) <= 1e-6f);
    CHECK(glm::length(r.direction) == Approx(1).epsilon(1e-6));
}

TEST_CASE("a moving camera draws a time, and what its lens draws") {
    draws pin, lens;
    (void)shoot(moving_camera(before, after), {0.5f, 0.5f}, counting_source{&pin});
    (void)shoot(moving_camera(before, after, thin_lens{0.1f, 4}), {0.5f, 0.5f}, counting_source{&lens});
    CHECK(pin.total() == 1);
    CHECK(pin.of(purpose::time) == 1);
    CHECK(lens.total() == 3);
}

TEST_CASE("times stay within the shutter") {
    const moving_camera cam(before, after, pinhole{}, shutter{0.25f, 0.5f});
    CHECK(at_time(cam, 0).time == 0.25f);
    CHECK(at_time(cam, 0.5f).time == 0.375f);
    CHECK(at_time(cam, 0x1.fffffep-1f).time <= 0.5f);
}

TEST_CASE("a camera that travels with the only thing it sees takes a sharp picture of it") {
    const glm::vec3 way{3, 0, 0};
    view later = before;
    later.eye += way;
    later.target += way;
    const auto normals = [](const auto& s) {
        return [&s](const auto& r, const auto&) {
            const auto h = intersect(s, r, interval{});
            return h ? 0.5f * h->normal + 0.5f : glm::vec3(0);
        };
    };
    const sphere still{};
    const moving passing{still, way};
    const image sharp = render({24, 24}, camera(before), jittered{.side = 4}, normals(still));
    const image both = render({24, 24}, moving_camera(before, later), jittered{.side = 4}, normals(passing));
    const image blurred = render({24, 24}, moving_camera(before, later), jittered{.side = 4}, normals(still));
    float worst = 0, blur = 0;
    for (std::uint32_t y = 0; y < 24; ++y)
        for (std::uint32_t x = 0; x < 24; ++x) {
            worst = std::max(worst, glm::length(sharp(x, y) - both(x, y)));
            blur = std::max(blur, glm::length(sharp(x, y) - blurred(x, y)));
        }
    CHECK(worst <= 0.02f);  // a ray within an ulp of the outline may fall on the other side of it
    CHECK(blur >= 0.3f);
}

TEST_CASE("what a camera refuses, a moving one refuses at either end") {
    const auto refuses = [](const view& open, const view& close, const char* what) {
        CHECK_THROWS_WITH(moving_camera(open, close), containing(what));
    };
    view wrong = before;
    wrong.vertical_fov = -1;
    refuses(wrong, after, "vertical_fov");
    refuses(before, wrong, "vertical_fov");
    wrong = before;
    wrong.eye.x = std::numeric_limits<float>::quiet_NaN();
    refuses(before, wrong, "eye");
    wrong = before;
    wrong.target = {0, 2, 10};  // looks back
    refuses(before, wrong, "right angle");
    wrong = before;
    wrong.up = {0, -1, 0};
    refuses(before, wrong, "up");
    CHECK_THROWS_AS(moving_camera(before, after, thin_lens{-1, 4}), std::invalid_argument);
    CHECK_THROWS_AS(moving_camera(before, after, pinhole{}, shutter{1, 0}), std::invalid_argument);
}
