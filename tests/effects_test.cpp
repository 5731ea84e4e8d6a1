// SPDX-License-Identifier: MIT
// Every effect of distribution ray tracing, alone and together, against pixels known in closed form. The renderer's own
// camera, sampler, surfaces and integrator do the work; bench/effects.cpp does the same with a million samples.
#include "exact_scenes.hpp"

#include <lantern/disk_light.hpp>
#include <lantern/sphere_light.hpp>

#include "catch.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <variant>
#include <vector>

using namespace exact_scenes;

namespace {

/// 8000 renderings of 16 samples. By chance |z| > 4 once in 16,000; the RMSE is known within about .9 %, so 3 % is more
/// than three standard deviations. The seeds are fixed: what passes once passes always.
void check(const outcome& o) {
    CAPTURE(o.name, o.mean, o.rendered_mean, o.rmse, o.rendered_rmse);
    CHECK(std::abs(o.z) < 4);
    CHECK(o.rendered_rmse / o.rmse == Approx(1).margin(0.03));
}

/// Sets of effects by their bits, so that tests can go through them.
effects of_bits(unsigned set) {
    return {.film = (set & 1) != 0,
            .shadow = (set & 2) != 0,
            .gloss = (set & 4) != 0,
            .lens = (set & 8) != 0,
            .time = (set & 16) != 0};
}

}  // namespace

TEST_CASE("each effect alone has the mean and the error that are known for it") {
    for (const unsigned effect : {1u, 2u, 4u, 8u, 16u}) check(render(of_bits(effect), {}));
    check(render({.lens = true, .round_lens = true}, {}));
}

TEST_CASE("every pair of effects has the mean and the error that are known for it") {
    for (unsigned set = 0; set < 32; ++set)
        if (std::popcount(set) == 2) check(render(of_bits(set), {}));
}

TEST_CASE("all effects together have the mean and the error that are known for them") {
    check(render({.film = true, .shadow = true, .gloss = true, .lens = true, .time = true}, {}));
    check(render({.film = true, .shadow = true, .gloss = true, .lens = true, .time = true, .round_lens = true}, {}));
    // Seven numbers a sample: antialiasing with lens, motion and light.
    check(render({.film = true, .shadow = true, .lens = true, .time = true}, {}));
}

TEST_CASE("more samples a pixel: mean and error are those of the finer strata") {
    check(render({.film = true}, {.side = 8, .renderings = 4000}));
    check(render({.shadow = true, .time = true}, {.side = 8, .renderings = 4000}));
}

TEST_CASE("at wide angles each effect alone is the exact one, not an approximation for small ones") {
    check(wide_antialiasing({}));
    check(wide_penumbra({}));
    check(wide_gloss({}));
    check(wide_lens({}));
    check(crossing_ball({}));
}

TEST_CASE("a light in the shape of a ball or a disk brings the irradiance of the closed form") {
    // Tilted floor, so that the cosine counts; the sphere's solid angle is sampled, the disk's area.
    const std::vector<lantern::object<lantern::rectangle, lantern::diffuse>> things{
        {lantern::rectangle{{-4, -4, 0}, {8, 0, 0}, {0, 8, 0}}, lantern::diffuse{glm::vec3(1)}}};
    const lantern::every structure{1};
    const lantern::camera cam{lantern::view{.eye = {0.5f, -2, 0.25f}, .target = {0, 0, 0}, .up = {0, 0, 1}}};
    const auto rendered = [&](const auto& light, double irradiance) {
        const std::vector lights{light};
        const lantern::distribution tracer{structure, things, lights};
        return render_often({"", irradiance / std::numbers::pi, 1}, cam, tracer, point_filter{}, {}).z;
    };
    for (const glm::vec3 center : {glm::vec3(0.5f, -0.25f, 2), glm::vec3(3, 1, 1.25f), glm::vec3(2, 0, 0.5f)}) {
        const double distance = glm::length(glm::dvec3(center));
        CHECK(std::abs(rendered(lantern::sphere_light{center, 1, glm::vec3(1)},
                                exact::sphere_irradiance(distance, 1, center.z / distance))) < 4);
        CHECK(std::abs(rendered(lantern::disk_light{center, {0, 0, -1}, 0.75f, glm::vec3(1)},
                                exact::disc_irradiance(center.z, std::hypot(center.x, center.y), 0.75))) < 4);
    }
}

TEST_CASE("an effect without influence changes no bit of the picture") {
    // The same scene, with parts of no effect left out by their type or present with the value zero.
    using paint = std::variant<lantern::mirror, lantern::glossy, lantern::diffuse>;
    using thing = lantern::object<lantern::any_of<lantern::rectangle, lantern::moving<lantern::rectangle>>, paint>;
    using still = lantern::object<lantern::rectangle, paint>;
    const lantern::rectangle metal{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}, ceiling{{-4, -4, 3}, {8, 0, 0}, {0, 8, 0}};
    const lantern::rectangle board{{-3, 0, 1}, {2.5f, 0.5f, 0}, {0, 3, 0}};
    const lantern::diffuse white{glm::vec3(1)};
    const std::vector<still> plain{{metal, lantern::mirror{}}, {ceiling, white}, {board, white}};
    const std::vector<still> no_gloss{
        {metal, lantern::glossy{.color = glm::vec3(1), .width = 0}}, {ceiling, white}, {board, white}};
    const std::vector<thing> no_motion{
        {metal, lantern::mirror{}}, {ceiling, white}, {lantern::moving{board, {0, 0, 0}}, white}};
    const std::vector lights{lantern::rectangle_light{{-3, -1, 0}, {1, 0, 0}, {0, 2, 0}, glm::vec3(5)}};
    const lantern::view from{.eye = {0.25f, -0.5f, 2}, .target = {0, 0, 0}};
    const lantern::every structure{3};
    const auto picture = [&](const auto& things, const auto& cam) {
        const lantern::distribution tracer{structure, things, lights};
        std::vector<glm::vec3> pixels;
        const lantern::image rendered =
            lantern::render({24, 24}, cam, lantern::jittered{.side = 2}, tracer, {.threads = 1});
        for (std::uint32_t y = 0; y < 24; ++y)
            for (std::uint32_t x = 0; x < 24; ++x) pixels.push_back(rendered(x, y));
        return pixels;
    };
    const auto reference = picture(plain, lantern::camera{from});
    const auto same = [&](const auto& pixels) { return pixels == reference; };  // pictures are too long to be printed
    CHECK(same(picture(no_gloss, lantern::camera{from})));
    CHECK(same(picture(plain, lantern::camera{from, lantern::thin_lens{.radius = 0, .focus_distance = 3}})));
    CHECK(same(picture(plain, lantern::camera{from, lantern::pinhole{}, lantern::shutter{}})));
    CHECK(same(picture(no_motion, lantern::camera{from, lantern::pinhole{}, lantern::shutter{}})));
    // And it is no empty picture: a lens that is open changes it.
    CHECK_FALSE(same(picture(plain, lantern::camera{from, lantern::thin_lens{.radius = 0.25f, .focus_distance = 3}})));
}
