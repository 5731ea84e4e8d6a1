// SPDX-License-Identifier: MIT
// Lab 03: the basic ray tracer.

#include "contract.hpp"

#include <catch.hpp>
#include <hint.hpp>
#include <numbers.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace contract::lab03;

namespace {

constexpr glm::vec3 up{0, 1, 0};

/// The largest difference between two colours or vectors; NaN when there is one.
float apart(glm::vec3 a, glm::vec3 b) {
    const glm::vec3 d = glm::abs(a - b);
    return d.x + d.y + d.z != d.x + d.y + d.z ? NAN : std::max({d.x, d.y, d.z});
}

/// The direction at an angle from `up`, in the plane of x and y.
glm::vec3 at_angle(float angle) { return {std::sin(angle), std::cos(angle), 0}; }

float sine_to(glm::vec3 normal, glm::vec3 direction) { return glm::length(glm::cross(normal, direction)); }

lantern::hit hit_of(const lantern::sphere& s, const lantern::ray& r) {
    const auto h = intersect(s, r, lantern::interval{});
    REQUIRE(h);
    return *h;
}

lantern::hit hit_of(const lantern::plane& s, const lantern::ray& r) {
    const auto h = intersect(s, r, lantern::interval{});
    REQUIRE(h);
    return *h;
}

const lantern::plane floor_plane{{0, 0, 0}, up};

}  // namespace

// ---- Step 1: shading -----------------------------------------------------------------------------------------------

TEST_CASE("a matt surface sends back the cosine's share of the light", "[step1]") {
    INFO(hint("surfaces look flat, or are too bright at the rim", "the body's part is body · (n·l)", "§1 Lambert"));
    const matte m{.body = {0.8f, 0.4f, 0.2f}};
    const float angle = GENERATE(0.0f, 0.5f, 1.0f, 1.5f);
    CAPTURE(angle);
    CHECK(apart(shade(m, up, at_angle(angle), up), m.body * std::cos(angle)) <= 1e-5f);
}

TEST_CASE("a matt surface looks the same from everywhere", "[step1]") {
    INFO(hint("the brightness changes when the eye moves", "only the highlight depends on the eye", "§1 Lambert"));
    const matte m{.body = {0.8f, 0.4f, 0.2f}};
    for (const float angle : {-1.4f, -0.7f, 0.0f, 0.7f, 1.4f}) {
        CAPTURE(angle);
        CHECK(apart(shade(m, up, at_angle(0.6f), at_angle(angle)), m.body * std::cos(0.6f)) <= 1e-5f);
    }
}

TEST_CASE("a light behind the surface gives nothing", "[step1]") {
    INFO(hint("black or coloured rims, or highlights in the shade", "n·l < 0: neither the body nor the highlight gets any light",
              "§1 The light behind"));
    const matte m{.body = glm::vec3(0.8f), .highlight = glm::vec3(0.5f), .exponent = 1};
    for (const float angle : {1.6f, 2.0f, 3.0f, -1.6f, -2.5f}) {
        CAPTURE(angle);
        CHECK(apart(shade(m, up, at_angle(angle), at_angle(0.8f)), glm::vec3(0)) <= 0);
    }
}

TEST_CASE("the highlight is brightest where eye and light lie opposite each other", "[step1]") {
    INFO(hint("the highlight is in the wrong place", "h is the unit vector halfway between to_light and to_eye", "§1 The highlight"));
    const matte m{.body = glm::vec3(0), .highlight = {1, 0.5f, 0.25f}, .exponent = 30};
    for (const float angle : {0.0f, 0.4f, 1.2f}) {
        CAPTURE(angle);
        CHECK(apart(shade(m, up, at_angle(angle), at_angle(-angle)), m.highlight) <= 1e-4f);
    }
}

TEST_CASE("the highlight falls with a power of the cosine to the halfway vector", "[step1]") {
    INFO(hint("the highlight is too wide, too narrow, or of a wrong shape",
              "(n·h)^exponent, with h of length 1; n·h, not r·v: that would be Phong's model", "§1 The highlight"));
    const matte m{.body = glm::vec3(0), .highlight = glm::vec3(1), .exponent = 20};
    for (const float eye : {-0.9f, -0.5f, 0.1f, 0.7f}) {
        const float halfway = (0.3f + eye) / 2;  // the angle between the normal and h
        CAPTURE(eye, halfway);
        CHECK(shade(m, up, at_angle(0.3f), at_angle(eye)).x == Approx(std::pow(std::cos(halfway), 20)).epsilon(1e-3));
    }
}

TEST_CASE("the side that the eye sees is the side that is shaded", "[step1]") {
    INFO(hint("a wall is black from behind, or shines through", "when the normal points away from the eye, take the other one", "§1 Two sides"));
    const matte m{.body = glm::vec3(0.8f)};
    CHECK(apart(shade(m, -up, at_angle(0.5f), at_angle(0.2f)), glm::vec3(0.8f) * std::cos(0.5f)) <= 1e-5f);
    CHECK(apart(shade(m, up, at_angle(0.5f), -up), glm::vec3(0)) <= 0);
}

// ---- Step 2: the shadow ray ----------------------------------------------------------------------------------------

TEST_CASE("in the open a light is seen, behind a sphere it is not", "[step2]") {
    INFO(hint("no shadows, or nothing but shadows", "lit means that the shadow ray meets nothing", "§2 The shadow ray"));
    const scene s{.things = {{floor_plane}, {lantern::sphere{{0, 3, 0}, 1}}}};
    const auto under = hit_of(floor_plane, {{0.2f, 1, 0.1f}, {0, -1, 0}});
    const auto beside = hit_of(floor_plane, {{5, 1, 0}, {0, -1, 0}});
    CHECK_FALSE(lit(s, under, {0, 9, 0}));
    CHECK(lit(s, beside, {0, 9, 0}));
    CHECK(lit(s, beside, {5, 0.01f, 0}));
}

TEST_CASE("what lies behind the light casts no shadow", "[step2]") {
    INFO(hint("shadows where the light is nearer than everything else", "the shadow ray ends at the light: t in (0, 1] when its direction is light - point",
              "§2 The shadow ray"));
    const scene s{.things = {{floor_plane}, {lantern::sphere{{0, 9, 0}, 1}}}};
    CHECK(lit(s, hit_of(floor_plane, {{0, 1, 0}, {0, -1, 0}}), {0, 7.9f, 0}));
    CHECK(lit(s, hit_of(floor_plane, {{0, 1, 0}, {0, -1, 0}}), {0, 0.5f, 0}));
}

TEST_CASE("what lies just before the light casts a shadow", "[step2]") {
    INFO(hint("things far from the surface cast no shadow", "a direction of length 1 has the light at t = distance, one of full length at t = 1; do not mix them",
              "§2 The shadow ray"));
    const scene s{.things = {{floor_plane}, {lantern::sphere{{0, 9, 0}, 1}}}};
    CHECK_FALSE(lit(s, hit_of(floor_plane, {{0, 1, 0}, {0, -1, 0}}), {0, 10.1f, 0}));
    CHECK_FALSE(lit(s, hit_of(floor_plane, {{3, 1, 0}, {0, -1, 0}}), {0, 10.5f, 0}));
}

TEST_CASE("a surface casts no shadow on itself where it faces the light", "[step2]") {
    INFO(hint("dots, stripes or rings all over: shadow acne",
              "the hit is rounded, half of the time to the wrong side: start at lantern::leave(hit, towards the light)", "§2 Acne"));
    const float scale = GENERATE(1e-3f, 1.0f, 1e4f);
    const float offset = GENERATE(0.0f, 300.0f);  // of the whole scene from the origin, in its own units
    CAPTURE(scale, offset);
    numbers random(4);
    const lantern::sphere ball{scale * (glm::vec3(1, 2, -1) * offset), scale};
    const scene s{.things = {{ball}}};
    int in_shadow = 0;
    for (int i = 0; i < 500; ++i) {
        const glm::vec3 from = ball.center + 4 * scale * random.direction();
        const auto h = hit_of(ball, {from, ball.center + 0.9f * scale * random.direction() - from});
        const glm::vec3 to_light = random.direction();
        if (glm::dot(to_light, h.normal) < 0.1f) continue;
        in_shadow += !lit(s, h, h.point + 5 * scale * to_light);
    }
    CHECK(in_shadow == 0);
}

TEST_CASE("under a sheet of paper the floor is dark", "[step2]") {
    INFO(hint("things seem to float: light leaks in where one thing stands on another",
              "a fixed offset such as 0.001 jumps over what is nearer than that: lantern::leave takes the smallest step that is enough",
              "§2 No epsilon"));
    const float scale = GENERATE(1e-3f, 1.0f, 1e3f);
    CAPTURE(scale);
    const scene s{.things = {{floor_plane}, {lantern::plane{{0, 1e-4f * scale, 0}, up}}}};
    const auto h = hit_of(floor_plane, {{0.5f * scale, 3 * scale, 0}, {0, -1, 0}});
    CHECK_FALSE(lit(s, h, {0, 10 * scale, 0}));
    CHECK_FALSE(lit(s, h, {9 * scale, 10 * scale, 0}));
}

// ---- Step 3: the law of reflection ---------------------------------------------------------------------------------

TEST_CASE("a ray that falls straight on a mirror comes straight back", "[step3]") {
    INFO(hint("mirrors show what is behind them, or nothing", "r = d - 2 (n·d) n", "§3 The mirror"));
    CHECK(apart(reflected(-up, up), up) <= 1e-6f);
    CHECK(apart(reflected({0, 0, -1}, {0, 0, 1}), {0, 0, 1}) <= 1e-6f);
}

TEST_CASE("angle of incidence and angle of reflection are equal, and in one plane", "[step3]") {
    INFO(hint("reflections are distorted", "r = d - 2 (n·d) n: only the part along the normal is turned round", "§3 The mirror"));
    numbers random(5);
    for (int i = 0; i < 200; ++i) {
        const glm::vec3 in = random.direction(), normal = random.direction();
        const glm::vec3 out = reflected(in, normal);
        CAPTURE(i, in, normal, out);
        REQUIRE(std::abs(glm::dot(out, normal) + glm::dot(in, normal)) <= 1e-5f);
        REQUIRE(apart(out - glm::dot(out, normal) * normal, in - glm::dot(in, normal) * normal) <= 1e-5f);
        REQUIRE(std::abs(glm::length(out) - 1) <= 1e-5f);
    }
}

TEST_CASE("a mirror works from both sides, and twice is as good as not at all", "[step3]") {
    INFO(hint("mirrors are black from inside", "(n·d) n is the same for n and -n: leave the formula as it is", "§3 The mirror"));
    numbers random(6);
    for (int i = 0; i < 50; ++i) {
        const glm::vec3 in = random.direction(), normal = random.direction();
        CAPTURE(i, in, normal);
        REQUIRE(apart(reflected(in, normal), reflected(in, -normal)) <= 1e-5f);
        REQUIRE(apart(reflected(reflected(in, normal), normal), in) <= 1e-5f);
    }
}

// ---- Step 4: Snell's law -------------------------------------------------------------------------------------------

TEST_CASE("straight on, a ray is not bent", "[step4]") {
    INFO(hint("things behind glass are shifted", "across = 0 here: what remains is -normal", "§4 Snell's law"));
    for (const float ratio : {0.5f, 1.0f, 1.5f}) {
        CAPTURE(ratio);
        const auto out = refracted(-up, up, ratio);
        REQUIRE(out);
        CHECK(apart(*out, -up) <= 1e-6f);
    }
}

TEST_CASE("between equal materials a ray is not bent", "[step4]") {
    INFO(hint("a sphere of air in air is visible", "with ratio 1 the formula gives `in` back", "§4 Snell's law"));
    numbers random(7);
    for (int i = 0; i < 100; ++i) {
        const glm::vec3 normal = random.direction(), v = random.direction();
        const glm::vec3 in = glm::dot(v, normal) > 0 ? -v : v;
        if (glm::dot(in, normal) > -0.01f) continue;
        CAPTURE(i, in, normal);
        const auto out = refracted(in, normal, 1);
        REQUIRE(out);
        REQUIRE(apart(*out, in) <= 1e-4f);
    }
}

TEST_CASE("the sines of the two angles are in the ratio of the indices", "[step4]") {
    INFO(hint("glass bends the wrong way, or too much", "sin behind = ratio · sin before; ratio = index before / index behind, not the other way round",
              "§4 Snell's law"));
    const float ratio = GENERATE(1 / 2.4f, 1 / 1.5f, 0.9f, 1.2f);
    CAPTURE(ratio);
    numbers random(8);
    for (int i = 0; i < 100; ++i) {
        const glm::vec3 normal = random.direction(), v = random.direction();
        const glm::vec3 in = glm::dot(v, normal) > 0 ? -v : v;
        if (ratio * sine_to(normal, in) > 0.98f) continue;
        const auto out = refracted(in, normal, ratio);
        CAPTURE(i, in, normal);
        REQUIRE(out);
        REQUIRE(std::abs(sine_to(normal, *out) - ratio * sine_to(normal, in)) <= 1e-4f);
        REQUIRE(std::abs(glm::length(*out) - 1) <= 1e-4f);
        REQUIRE(glm::dot(*out, normal) < 0);                                                        // it went through,
        REQUIRE(std::abs(glm::dot(*out, glm::cross(in, normal))) <= 1e-4f);                         // stayed in the plane,
        REQUIRE(glm::dot(*out + glm::dot(*out, -normal) * normal, in) >= -1e-4f);                   // and did not turn back
    }
}

TEST_CASE("beyond the critical angle nothing goes through", "[step4]") {
    INFO(hint("NaN, or a silvery rim that is missing inside glass", "where ratio · sin >= 1 there is no angle behind: return std::nullopt",
              "§4 Total internal reflection"));
    const float critical = std::asin(1 / 1.5f);
    CHECK(refracted(-at_angle(critical - 0.01f), up, 1.5f));
    CHECK_FALSE(refracted(-at_angle(critical + 0.01f), up, 1.5f));
    CHECK_FALSE(refracted(-at_angle(1.5f), up, 1.5f));
    CHECK(refracted(-at_angle(1.5f), up, 1 / 1.5f));
}

TEST_CASE("light finds its way back", "[step4]") {
    INFO(hint("what one sees through a glass does not see one", "back again the ratio is 1 / ratio and the normal the other one", "§4 Snell's law"));
    for (const float angle : {0.1f, 0.6f, 1.2f, 1.5f}) {
        CAPTURE(angle);
        const glm::vec3 in = -at_angle(angle);
        const auto inside = refracted(in, up, 1 / 1.5f);
        REQUIRE(inside);
        const auto back = refracted(-*inside, -up, 1.5f);
        REQUIRE(back);
        CHECK(apart(*back, -in) <= 1e-3f);
    }
}

// ---- Step 5: Fresnel's equations -----------------------------------------------------------------------------------

TEST_CASE("glass reflects four percent straight on", "[step5]") {
    INFO(hint("glass looks like a soap bubble, or like nothing", "straight on both polarisations give ((1 - ratio) / (1 + ratio))²", "§5 Two polarisations"));
    CHECK(reflectance(1, 1 / 1.5f) == Approx(0.04).epsilon(1e-3));
    CHECK(reflectance(1, 1.5f) == Approx(0.04).epsilon(1e-3));
    CHECK(reflectance(1, 1 / 2.4f) == Approx(0.169550).epsilon(1e-3));
}

TEST_CASE("the reflectance is the mean of both polarisations at every angle", "[step5]") {
    INFO(hint("the rims of glass are too bright or too dark", "Fresnel's equations, not Schlick's approximation; the mean of the two squares",
              "§5 Two polarisations"));
    // n = 1.5, at 30, 60, 75 and 85 degrees; then from inside at 20 and 40.
    CHECK(reflectance(0.8660254f, 1 / 1.5f) == Approx(0.0415226).epsilon(2e-3));
    CHECK(reflectance(0.5f, 1 / 1.5f) == Approx(0.0891867).epsilon(2e-3));
    CHECK(reflectance(0.2588190f, 1 / 1.5f) == Approx(0.2530606).epsilon(2e-3));
    CHECK(reflectance(0.0871557f, 1 / 1.5f) == Approx(0.6127996).epsilon(2e-3));
    CHECK(reflectance(0.9396926f, 1.5f) == Approx(0.0417285).epsilon(2e-3));
    CHECK(reflectance(0.7660444f, 1.5f) == Approx(0.2452913).epsilon(2e-3));
}

TEST_CASE("at Brewster's angle one polarisation vanishes", "[step5]") {
    INFO(hint("the rims of glass are too bright or too dark", "one of the two polarisations is missing, or counted twice", "§5 Two polarisations"));
    // tan θ = 1.5: the parallel part is 0, and half of the perpendicular one remains.
    const double perpendicular = (1 - 1.5 * 1.5) / (1 + 1.5 * 1.5);
    CHECK(reflectance(float(std::cos(std::atan(1.5))), 1 / 1.5f) == Approx(perpendicular * perpendicular / 2).epsilon(1e-3));
}

TEST_CASE("at a grazing angle, and beyond the critical one, everything is reflected", "[step5]") {
    INFO(hint("NaN, or glass without a bright rim", "where ratio · sin >= 1 the answer is 1", "§5 Everything"));
    CHECK(reflectance(0, 1 / 1.5f) == Approx(1));
    CHECK(reflectance(0, 1.5f) == Approx(1));
    CHECK(reflectance(0.5f, 1.5f) == Approx(1));
}

TEST_CASE("from both sides of a surface the same part is reflected", "[step5]") {
    INFO(hint("glass is brighter from inside", "`cosine` is that of the angle on the ray's own side", "§5 Two polarisations"));
    for (const float angle : {0.2f, 0.8f, 1.3f, 1.5f}) {
        CAPTURE(angle);
        const float inside = std::asin(std::sin(angle) / 1.5f);
        CHECK(reflectance(std::cos(angle), 1 / 1.5f) == Approx(reflectance(std::cos(inside), 1.5f)).epsilon(1e-2));
    }
}

// ---- Step 6: following the rays ------------------------------------------------------------------------------------

namespace {

const lantern::ray downwards{{0, 2, 0}, {0, -1, 0}};

}  // namespace

TEST_CASE("a ray that meets nothing sees the sky", "[step6]") {
    INFO(hint("the background is black", "return sky(scene, direction), the direction of length 1", "§6 The recipe"));
    const scene s{.horizon = {0.2f, 0.4f, 0.6f}, .zenith = {1, 1, 0}};
    CHECK(apart(trace(s, {{0, 0, 0}, {0, 0, -1}}, 5), s.horizon) <= 1e-6f);
    CHECK(apart(trace(s, {{0, 0, 0}, {0, 7, 0}}, 5), s.zenith) <= 1e-6f);
    CHECK(apart(trace(s, {{0, 0, 0}, {0, 3, 4}}, 0), 0.4f * s.horizon + 0.6f * s.zenith) <= 1e-5f);
}

TEST_CASE("the light on a floor falls with the square of the distance", "[step6]") {
    INFO(hint("lamps are too strong far away", "a light brings intensity / distance²", "§6 Direct light"));
    for (const float height : {1.0f, 2.0f, 5.0f}) {
        CAPTURE(height);
        const scene s{.things = {{floor_plane, matte{.body = {0.5f, 0.25f, 1}}}}, .lights = {{{0, height, 0}, glm::vec3(4)}}};
        const lantern::ray slanted{{3, 1, 0}, {-3, -1, 0}};  // to the point under the light
        CHECK(apart(trace(s, slanted, 5), glm::vec3(0.5f, 0.25f, 1) * (4 / (height * height))) <= 1e-4f);
    }
}

TEST_CASE("lights add up, each with its own shadow", "[step6]") {
    INFO(hint("one lamp's shadow puts out the others", "a shadow ray for every light; a light that is hidden is skipped, the next one is not", "§6 Direct light"));
    scene s{.things = {{floor_plane, matte{.body = glm::vec3(1)}}}, .lights = {{{0, 4, 0}, {16, 0, 0}}, {{3, 4, 0}, {0, 125, 0}}}};
    const lantern::ray slanted{{0, 1, 3}, {0, -1, -3}};
    CHECK(apart(trace(s, slanted, 5), {1, 125 / 25.0f * 0.8f, 0}) <= 1e-4f);
    s.things.push_back({lantern::sphere{{0, 3, 0}, 0.3f}});
    CHECK(apart(trace(s, slanted, 5), {0, 125 / 25.0f * 0.8f, 0}) <= 1e-4f);
}

TEST_CASE("ambient light reaches the shadows too, once", "[step6]") {
    INFO(hint("shadows are black, or brighter with every lamp", "ambient · body is added once, before the loop over the lights", "§6 Direct light"));
    const scene s{.things = {{floor_plane, matte{.body = {1, 0.5f, 0.5f}}}, {lantern::sphere{{0, 3, 0}, 0.5f}}},
                  .lights = {{{0, 9, 0}, glm::vec3(100)}, {{0, 8, 0}, glm::vec3(100)}},
                  .ambient = {0.1f, 0.2f, 0.4f}};
    CHECK(apart(trace(s, {{0, 1, 3}, {0, -1, -3}}, 5), {0.1f, 0.1f, 0.2f}) <= 1e-5f);
}

TEST_CASE("the length of a ray's direction changes nothing", "[step6]") {
    INFO(hint("reflections of reflections are too bright, glass glows", "normalise the direction before shading with it", "§6 The recipe"));
    const matte shiny{.body = glm::vec3(0.5f), .highlight = glm::vec3(1), .exponent = 10};
    const scene s{.things = {{floor_plane, shiny}, {lantern::sphere{{0, 1, 0}, 0.5f}, glass{}}},
                  .lights = {{{2, 3, 2}, glm::vec3(10)}},
                  .horizon = {1, 0, 0},
                  .zenith = {0, 0, 1}};
    for (const glm::vec3 direction : {glm::vec3(1, -1.5f, 0), glm::vec3(0.1f, -1, 0.2f)}) {
        CAPTURE(direction);
        const glm::vec3 once = trace(s, {{0, 3, 0}, glm::normalize(direction)}, 6);
        CHECK(apart(trace(s, {{0, 3, 0}, 5.0f * direction}, 6), once) <= 1e-4f);
        CHECK(apart(trace(s, {{0, 3, 0}, 0.01f * direction}, 6), once) <= 1e-4f);
    }
}

TEST_CASE("a mirror shows the sky in its colour", "[step6]") {
    INFO(hint("mirrors are black, or as bright as if they were not there", "color · trace(reflected ray, depth - 1)", "§6 The recipe"));
    const scene s{.things = {{floor_plane, mirror{{0.9f, 0.8f, 0.7f}}}}, .horizon = {0.2f, 0.4f, 0.6f}, .zenith = {1, 1, 0.5f}};
    CHECK(apart(trace(s, downwards, 5), glm::vec3(0.9f, 0.8f, 0.7f) * s.zenith) <= 1e-5f);
    CHECK(apart(trace(s, downwards, 1), glm::vec3(0.9f, 0.8f, 0.7f) * s.zenith) <= 1e-5f);
}

TEST_CASE("with depth 0 a mirror and glass are black, a matt surface is not", "[step6]") {
    INFO(hint("one reflection too many, or too few", "`depth` counts the rays that may still follow; a shadow ray is not one of them", "§6 The end"));
    const scene reflecting{.things = {{floor_plane, mirror{}}}, .horizon = glm::vec3(1), .zenith = glm::vec3(1)};
    const scene clear{.things = {{floor_plane, glass{}}}, .horizon = glm::vec3(1), .zenith = glm::vec3(1)};
    const scene matt{.things = {{floor_plane, matte{.body = glm::vec3(0.5f)}}}, .lights = {{{0, 1, 1}, glm::vec3(2)}}, .ambient = glm::vec3(1)};
    CHECK(apart(trace(reflecting, downwards, 0), glm::vec3(0)) <= 0);
    CHECK(apart(trace(clear, downwards, 0), glm::vec3(0)) <= 0);
    CHECK(apart(trace(matt, downwards, 0), glm::vec3(0.5f + std::sqrt(0.5f) / 2)) <= 1e-5f);
}

TEST_CASE("a ray between two mirrors comes to an end", "[step6]") {
    INFO(hint("the program runs for ever, or crashes", "every ray that follows another has a depth one less", "§6 The end"));
    const scene s{.things = {{floor_plane, mirror{}}, {lantern::plane{{0, 3, 0}, -up}, mirror{}}}, .horizon = glm::vec3(1), .zenith = glm::vec3(1)};
    CHECK(apart(trace(s, downwards, 50), glm::vec3(0)) <= 0);
}

TEST_CASE("a mirror shows things that are lit, with their shadows", "[step6]") {
    INFO(hint("reflections are unlit or show nothing but sky", "a reflected ray is traced like the first one", "§6 The recipe"));
    // From the mirror the ray goes up to a ceiling that a lamp near the mirror lights; the lamp may be hidden.
    scene s{.things = {{floor_plane, mirror{}}, {lantern::plane{{0, 4, 0}, -up}, matte{.body = glm::vec3(1)}}},
            .lights = {{{0, 2, 0}, glm::vec3(4)}},
            .ambient = glm::vec3(0.1f)};
    const lantern::ray r{{-1, 2, 0}, {0.25f, -2, 0}};  // meets the floor at x = -3/4, the ceiling at x = -1/4
    const float distance_squared = 4 + 1 / 16.0f;
    CHECK(apart(trace(s, r, 5), glm::vec3(0.1f + 4 / distance_squared * 2 / std::sqrt(distance_squared))) <= 1e-4f);
    s.things.push_back({lantern::sphere{{-1 / 16.0f, 2.5f, 0}, 0.1f}});  // between lamp and ceiling, beside the ray
    CHECK(apart(trace(s, r, 5), glm::vec3(0.1f)) <= 1e-4f);
}

TEST_CASE("clear glass in an even light is invisible", "[step6]") {
    INFO(hint("glass is dark, or shines by itself", "the reflected and the refracted part together are 1: R and 1 - R", "§6 Glass"));
    // What is missing is only what the depth cuts off: less than R^13 of the light.
    const scene s{.things = {{lantern::sphere{{0, 0, 0}, 1}, glass{}}}, .horizon = glm::vec3(0.7f), .zenith = glm::vec3(0.7f)};
    for (const float height : {0.0f, 0.3f, 0.6f, 0.9f}) {
        CAPTURE(height);
        CHECK(apart(trace(s, {{0, height, 5}, {0, 0, -1}}, 14), glm::vec3(0.7f)) <= 2e-3f);
    }
}

TEST_CASE("glass of index 1 is not seen at all", "[step6]") {
    INFO(hint("glass bends the wrong way", "entering, the ratio is 1 / index; leaving, it is index", "§6 Glass"));
    const scene s{.things = {{lantern::sphere{{0, 0, 0}, 1}, glass{.index = 1}}}, .horizon = {1, 0, 0}, .zenith = {0, 0, 1}};
    const lantern::ray r{{0.3f, 0.2f, 5}, {0, 0.05f, -1}};
    CHECK(apart(trace(s, r, 5), trace(scene{.horizon = s.horizon, .zenith = s.zenith}, r, 5)) <= 1e-4f);
}

TEST_CASE("a glass sphere turns the world upside down", "[step6]") {
    INFO(hint("glass bends the wrong way, or looks like a bubble",
              "entering, the ratio is 1 / index; leaving, it is index. You enter when the ray runs against the normal", "§6 Glass"));
    // Through the lower part of the sphere one sees the zenith, through the upper part the horizon and below.
    const scene s{.things = {{lantern::sphere{{0, 0, 0}, 1}, glass{}}}, .horizon = {0, 0, 0}, .zenith = {1, 1, 1}};
    const float through_below = trace(s, {{0, -0.6f, 5}, {0, 0, -1}}, 2).x;
    const float through_above = trace(s, {{0, 0.6f, 5}, {0, 0, -1}}, 2).x;
    // A ray at height 0.6 has the angles asin 0.6 and asin 0.4, and is turned by twice their difference in all.
    const double turned = 2 * (std::asin(0.6) - std::asin(0.4));
    const double cosine = 0.8, behind = std::sqrt(1 - 0.16);
    const double perpendicular = (cosine / 1.5 - behind) / (cosine / 1.5 + behind), parallel = (cosine - behind / 1.5) / (cosine + behind / 1.5);
    const double passed = 1 - (perpendicular * perpendicular + parallel * parallel) / 2;
    CHECK(through_below == Approx(passed * passed * std::sin(turned)).epsilon(5e-3));
    // Through the upper part one sees downwards; what remains is the sky in the outside, 0.96 of the reflectance.
    CHECK(through_above == Approx(0.96 * (1 - passed)).epsilon(5e-3));
}

TEST_CASE("coloured glass colours light each time it crosses the surface", "[step6]") {
    INFO(hint("coloured glass has no colour, or colours its reflections", "color goes with the refracted part only, at each crossing", "§6 Glass"));
    const scene s{.things = {{lantern::sphere{{0, 0, 0}, 1}, glass{.index = 1.5f, .color = {1, 0.5f, 0.2f}}}},
                  .horizon = glm::vec3(1),
                  .zenith = glm::vec3(1)};
    // Straight through: 0.04 come back at once; 0.96² pass, coloured twice; the rest is at most 0.04 · 0.96.
    const glm::vec3 seen = trace(s, {{0, 0, 5}, {0, 0, -1}}, 2);
    CHECK(seen.x == Approx(0.04 + 0.96 * 0.96).epsilon(1e-3));
    CHECK(seen.y == Approx(0.04 + 0.96 * 0.96 * 0.25).epsilon(1e-3));
    CHECK(seen.z == Approx(0.04 + 0.96 * 0.96 * 0.04).epsilon(1e-3));
}

TEST_CASE("inside glass a ray can be caught", "[step6]") {
    INFO(hint("black or bright spots in glass", "where nothing is refracted the whole light is reflected: R = 1", "§6 Glass"));
    // From inside a glass sphere, at 0.9 of the radius sideways: beyond the critical angle for ever.
    const scene s{.things = {{lantern::sphere{{0, 0, 0}, 1}, glass{}}}, .horizon = glm::vec3(1), .zenith = glm::vec3(1)};
    CHECK(apart(trace(s, {{0, 0.9f, 0}, {0, 0, -1}}, 12), glm::vec3(0)) <= 1e-3f);
    CHECK(trace(s, {{0, 0.5f, 0}, {0, 0, -1}}, 12).x == Approx(1).epsilon(1e-3));
}
