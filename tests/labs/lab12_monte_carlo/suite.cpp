// SPDX-License-Identifier: MIT
// Lab 12: path tracing, against closed forms.

#include "contract.hpp"

#include <catch.hpp>
#include <hint.hpp>
#include <numbers.hpp>
#include <statistics.hpp>

#include <lantern/exact_light.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

using namespace contract::lab12;

namespace {

constexpr float pi = std::numbers::pi_v<float>;

// Statistical tests: |z| < 4.5 fails a right answer once in 150,000 times, and seeds are fixed. Of a skewed mean that is
// less often or more, so all means here are over at least 4000 samples.
constexpr double limit = 4.5;

const lantern::rectangle ground{{-50, 0, 50}, {100, 0, 0}, {0, 0, -100}};  // faces up

/// Three above the ground, one and a half by one, facing down.
const lantern::rectangle ceiling{{-0.75f, 3, -0.5f}, {1.5f, 0, 0}, {0, 0, 1}};

lantern::exact::polygon corners_of(const lantern::rectangle& r) {
    return lantern::exact::corners({glm::dvec3(r.corner), glm::dvec3(r.u), glm::dvec3(r.v)});
}

scene lit_ground(const lantern::rectangle& lamp, glm::vec3 albedo, glm::vec3 emission) {
    return {{}, {{ground, {albedo, glm::vec3(0)}}, {lamp, {glm::vec3(0), emission}}}, 1};
}

statistics::mean mean_of(const std::vector<glm::vec3>& seen) {
    statistics::mean m;
    for (const glm::vec3& s : seen) m.add(double(s.x));
    return m;
}

lantern::hit ground_at(float x, float z) { return {1, {x, 0, z}, {0, 1, 0}, 0}; }

const lantern::ray down{{0.4f, 1, 0.2f}, {0, -1, 0}};

}  // namespace

// ---- Step 1: the estimator -------------------------------------------------------------------------------------------

TEST_CASE("the estimate is the mean of value over density", "[step1]") {
    INFO(hint("too bright or too dark by a factor", "each sample stands for value / density; divide the sum by the number of samples", "§1 The estimator"));
    CHECK(estimate({{6, 2}}) == Approx(3));
    CHECK(estimate({{6, 2}, {1, 0.5f}}) == Approx(2.5));
    CHECK(estimate({{0, 4}, {0, 1}, {3, 1}}) == Approx(1));
}

TEST_CASE("a sample that found nothing counts as well", "[step1]") {
    INFO(hint("the darker the scene, the more it is too bright", "divide by the number of all samples, not of those that found light", "§1 The estimator"));
    CHECK(estimate({{2, 1}, {0, 1}, {0, 1}, {0, 1}}) == Approx(0.5));
}

TEST_CASE("where the density is in proportion to the function one sample is enough", "[step1]") {
    INFO(hint("noise where there should be none", "divide each value by its own density, before the mean", "§1 The estimator"));
    for (const float x : {0.1f, 0.5f, 0.9f}) CHECK(estimate({{3 * x * x, 3 * x * x / 7}}) == Approx(7));
    CHECK(estimate({{1, 0.25f}, {4, 1}, {2, 0.5f}}) == Approx(4));
}

TEST_CASE("no samples, no light", "[step1]") {
    INFO(hint("NaN: the pixel stays black or breaks the picture", "0 samples: 0, not 0 / 0", "§1 The estimator"));
    CHECK(estimate({}) == 0);
}

// ---- Step 2: a direction by the cosine -------------------------------------------------------------------------------

TEST_CASE("directions have length 1 and are on the side of the normal", "[step2]") {
    INFO(hint("light leaks through surfaces, or the picture has dark seams", "raise the point of the disk by √(1 - r²) along the normal; use the basis around the normal",
              "§2 By the cosine"));
    numbers random(1);
    for (int i = 0; i < 3000; ++i) {
        const glm::vec3 n = random.direction(), d = cosine_direction(n, {random.unit(), random.unit()});
        REQUIRE(std::abs(glm::length(d) - 1) <= 1e-5f);
        REQUIRE(glm::dot(d, n) >= -1e-6f);
    }
}

TEST_CASE("seen from above, the directions fill the disk evenly", "[step2]") {
    INFO(hint("surfaces are too bright or too dark in corners", "for a uniform disk the radius is √ξ, and the height √(1 - ξ)", "§2 By the cosine"));
    // 8 rings of equal area and 8 sectors: chi-square with 63 degrees of freedom; below 1e-6 once in a million.
    numbers random(2);
    const glm::vec3 n = glm::normalize(glm::vec3(0.3f, -0.8f, 0.5f));
    const glm::vec3 u = glm::normalize(glm::cross(n, glm::vec3(1, 0, 0))), v = glm::cross(n, u);
    std::vector<double> cells(64);
    for (int i = 0; i < 64'000; ++i) {
        const glm::vec3 d = cosine_direction(n, {random.unit(), random.unit()});
        const double x = double(glm::dot(d, u)), y = double(glm::dot(d, v));
        const std::size_t ring = statistics::cell(x * x + y * y, 8), sector = statistics::cell(std::atan2(y, x) / (2 * double(pi)) + 0.5, 8);
        ++cells[8 * ring + sector];
    }
    CHECK(statistics::chi_square_test(cells) > statistics::false_alarm);
}

TEST_CASE("the density is cos θ / π, and all of it is 1", "[step2]") {
    INFO(hint("everything too bright or too dark by π, or light from below", "cos θ / π above the surface, 0 below", "§2 The density"));
    const glm::vec3 n{0, 1, 0};
    CHECK(cosine_density(n, n) == Approx(1 / pi));
    CHECK(cosine_density(n, glm::normalize(glm::vec3(1, 1, 0))) == Approx(std::sqrt(0.5) / double(pi)));
    CHECK(cosine_density(n, glm::normalize(glm::vec3(1, -1, 0))) == 0);
    double sum = 0;  // equal heights, equal areas of the sphere
    for (int i = 0; i < 2000; ++i) {
        const float y = -1 + (float(i) + 0.5f) / 1000;
        sum += double(cosine_density(n, {std::sqrt(1 - y * y), y, 0})) * 4 * double(pi) / 2000;
    }
    CHECK(sum == Approx(1).epsilon(1e-4));
}

// ---- Step 3: what a bounce carries -----------------------------------------------------------------------------------

TEST_CASE("drawn by the cosine, a bounce carries the albedo", "[step3]") {
    INFO(hint("every bounce loses or gains light", "albedo/π times cos θ divided by cos θ/π: only the albedo is left", "§3 The throughput"));
    for (const float cosine : {1.0f, 0.5f, 0.01f}) {
        const glm::vec3 d{std::sqrt(1 - cosine * cosine), cosine, 0};
        const glm::vec3 carried = bounced({1, 0.5f, 2}, {0.25f, 0.5f, 0.75f}, {0, 1, 0}, d, cosine / pi);
        CHECK(carried.x == Approx(0.25).epsilon(1e-4));
        CHECK(carried.y == Approx(0.25).epsilon(1e-4));
        CHECK(carried.z == Approx(1.5).epsilon(1e-4));
    }
}

TEST_CASE("drawn evenly over the hemisphere, a bounce carries 2 albedo cos θ", "[step3]") {
    INFO(hint("right with cosine directions only", "divide by the density that was handed in, whatever it is, and multiply by the cosine", "§3 The throughput"));
    const float even = 1 / (2 * pi);
    CHECK(bounced(glm::vec3(1), glm::vec3(0.5f), {0, 0, 1}, {0, 0, 1}, even).x == Approx(1));
    CHECK(bounced(glm::vec3(1), glm::vec3(0.5f), {0, 0, 1}, {0.8f, 0, 0.6f}, even).y == Approx(0.6));
}

TEST_CASE("nothing is carried below the surface, nor by a direction that is never drawn", "[step3]") {
    INFO(hint("NaN or infinite pixels, or light that comes from below", "a cosine of 0 or less, or a density of 0: black", "§3 The throughput"));
    CHECK(bounced(glm::vec3(1), glm::vec3(1), {0, 1, 0}, glm::normalize(glm::vec3(1, -1, 0)), 0.5f) == glm::vec3(0));
    CHECK(bounced(glm::vec3(1), glm::vec3(1), {0, 1, 0}, {1, 0, 0}, 0) == glm::vec3(0));
    CHECK(bounced(glm::vec3(1), glm::vec3(1), {0, 1, 0}, {0, 1, 0}, 0) == glm::vec3(0));
}

// ---- Step 4: how densely the lamp is drawn ---------------------------------------------------------------------------

TEST_CASE("straight below a lamp the density is d² / A", "[step4]") {
    INFO(hint("the lamp gets brighter or darker with its size or distance, in the wrong way", "per solid angle: d² / (A cos θ')", "§4 From area to solid angle"));
    CHECK(lamp_density(ceiling, {0, 3, 0}, {0, 1, 0}) == Approx(4 / 1.5));
    CHECK(lamp_density(ceiling, {0, 3, 0}, {0, -3, 0}) == Approx(36 / 1.5));
}

TEST_CASE("askew the lamp looks smaller, so each of its directions is denser", "[step4]") {
    INFO(hint("too bright aside of the lamp", "θ' is the angle between the lamp's normal and the direction to the surface", "§4 From area to solid angle"));
    for (const float x : {1.0f, 4.0f, 20.0f}) {
        const float d2 = x * x + 9, cosine = 3 / std::sqrt(d2);
        CHECK(lamp_density(ceiling, {0, 3, 0}, {x, 0, 0}) == Approx(d2 / (1.5f * cosine)).epsilon(1e-4));
    }
}

TEST_CASE("seen from far away the density is one over the solid angle; from behind it is 0", "[step4]") {
    INFO(hint("lamps shine backwards, or negative light", "from behind the cosine is negative: nothing is drawn there", "§4 From area to solid angle"));
    const double solid = lantern::exact::solid_angle({7, -40, 11}, corners_of(ceiling));
    CHECK(double(lamp_density(ceiling, {0, 3, 0}, {7, -40, 11})) == Approx(1 / solid).epsilon(2e-3));
    CHECK(lamp_density(ceiling, {0, 3, 0}, {0, 5, 0}) == 0);
    CHECK(lamp_density(ceiling, {0, 3, 0}, {8, 3, 0}) == 0);
}

// ---- Step 5: light straight from the lamp ----------------------------------------------------------------------------

TEST_CASE("the mean over the lamp is Lambert's formula", "[step5]") {
    INFO(hint("the lit ground is off by a factor", "the lamp's emission, as a bounce of that density carries it: bounced(emission, albedo, n, direction, density)",
              "§5 One shadow ray"));
    const scene s = lit_ground(ceiling, glm::vec3(0.6f), {10, 20, 40});
    const glm::dvec3 at{0.4, 0, 0.2};
    const double exact = 0.6 / double(pi) * lantern::exact::irradiance(at, {0, 1, 0}, corners_of(ceiling));
    glm::dvec3 sum{0};
    for (int i = 0; i < 32; ++i)
        for (int j = 0; j < 32; ++j)
            sum += glm::dvec3(from_lamp(s, ground_at(0.4f, 0.2f), glm::vec3(0.6f), {(float(i) + 0.5f) / 32, (float(j) + 0.5f) / 32}).light) / 1024.0;
    CHECK(sum.x == Approx(10 * exact).epsilon(1e-3));
    CHECK(sum.z == Approx(40 * exact).epsilon(1e-3));
}

TEST_CASE("it says which direction was drawn, and how densely", "[step5]") {
    INFO(hint("the two ways do not add up later", "the direction has length 1, and the density is step 4's", "§5 One shadow ray"));
    const lit l = from_lamp(lit_ground(ceiling, glm::vec3(0.6f), glm::vec3(1)), ground_at(0, 0), glm::vec3(0.6f), {0.75f, 0.25f});
    const glm::vec3 way{0.375f, 3, -0.25f};
    CHECK(glm::length(l.direction - glm::normalize(way)) <= 1e-5f);
    const float d2 = glm::dot(way, way);
    CHECK(l.density == Approx(d2 / (1.5f * 3 / std::sqrt(d2))).epsilon(1e-4));
}

TEST_CASE("half of the lamp hidden is half of its light", "[step5]") {
    INFO(hint("no shadows", "ask `blocked` for the hit and the point of the lamp", "§5 One shadow ray"));
    scene s = lit_ground(ceiling, glm::vec3(0.6f), glm::vec3(10));
    const auto mean = [&] {
        double sum = 0;
        for (int i = 0; i < 32; ++i)
            for (int j = 0; j < 32; ++j)
                sum += double(from_lamp(s, ground_at(0, 0), glm::vec3(0.6f), {(float(i) + 0.5f) / 32, (float(j) + 0.5f) / 32}).light.x) / 1024;
        return sum;
    };
    const double whole = mean();
    s.walls.push_back({{{0, 1, -9}, {9, 0, 0}, {0, 0, 18}}, {}});
    CHECK(mean() == Approx(whole / 2).epsilon(1e-3));
}

TEST_CASE("no lamp, the lamp's back and the surface's back: no light", "[step5]") {
    INFO(hint("a crash, or light where none can be", "look whether the scene has a lamp; a direction below the surface carries nothing", "§5 One shadow ray"));
    scene s = lit_ground(ceiling, glm::vec3(0.6f), glm::vec3(10));
    CHECK(from_lamp(s, {1, {0, 0, 0}, {0, -1, 0}, 0}, glm::vec3(1), {0.5f, 0.5f}).light == glm::vec3(0));
    CHECK(from_lamp(s, {1, {0, 5, 0}, {0, -1, 0}, 0}, glm::vec3(1), {0.5f, 0.5f}).light == glm::vec3(0));
    s.lamp.reset();
    CHECK(from_lamp(s, ground_at(0, 0), glm::vec3(1), {0.5f, 0.5f}).light == glm::vec3(0));
}

// ---- Step 6: two ways to the lamp ------------------------------------------------------------------------------------

TEST_CASE("the shares of two ways add up to 1, and the denser one has more", "[step6]") {
    INFO(hint("too bright where both ways find the lamp", "the balance heuristic, mine / (mine + other), or the power heuristic, with both squared", "§6 Two ways"));
    numbers random(3);
    for (int i = 0; i < 1000; ++i) {
        const float a = std::pow(10.0f, random.between(-6, 6)), b = std::pow(10.0f, random.between(-6, 6));
        CAPTURE(a, b);
        REQUIRE(std::abs(share(a, b) + share(b, a) - 1) <= 1e-5f);
        REQUIRE((share(a, b) >= 0.5f) == (a >= b));
    }
    CHECK(share(2, 2) == Approx(0.5));
    CHECK(share(3, 1) >= 0.74f);
    CHECK(share(3, 1) <= 0.91f);
}

TEST_CASE("a way that cannot draw the direction has no share, and is left none", "[step6]") {
    INFO(hint("NaN, or light that is missing", "other = 0: everything; mine = 0: nothing, even when both are 0", "§6 Two ways"));
    CHECK(share(0.7f, 0) == 1);
    CHECK(share(0, 0.7f) == 0);
    CHECK(share(0, 0) == 0);
}

TEST_CASE("shares are numbers however large the densities are", "[step6]") {
    INFO(hint("NaN near tiny lamps", "the square of 1e30 is infinite in float, and infinity / infinity is no number: divide first, square then", "§6 Two ways"));
    CHECK(share(1e30f, 1) == Approx(1));
    CHECK(share(1, 1e30f) <= 1e-6f);
    CHECK(share(1e30f, 1e30f) == Approx(0.5));
    CHECK(share(1e-30f, 1e-30f) == Approx(0.5));
}

// ---- Step 7: Russian roulette ----------------------------------------------------------------------------------------

TEST_CASE("on average roulette changes nothing", "[step7]") {
    INFO(hint("the picture gets darker, or brighter, by roulette", "a path that goes on is divided by its chance to go on", "§7 Roulette"));
    for (const glm::vec3 t : {glm::vec3(0.5f, 0.25f, 0.1f), glm::vec3(0.9f, 0.99f, 0.3f), glm::vec3(0.02f), glm::vec3(1.5f, 0.2f, 0)}) {
        glm::dvec3 sum{0};
        for (int i = 0; i < 10'000; ++i)
            if (const auto kept = roulette(t, (float(i) + 0.5f) / 10'000)) sum += glm::dvec3(*kept) / 10'000.0;
        CHECK(glm::length(sum - glm::dvec3(t)) <= 1e-3 * glm::length(glm::dvec3(t)) + 1e-4);
    }
}

TEST_CASE("what goes on carries 1 and no more: weak paths end often, strong ones seldom", "[step7]") {
    INFO(hint("single very bright pixels (fireflies), or paths that take for ever", "the chance is the largest component of the throughput", "§7 Roulette"));
    for (const float most : {0.9f, 0.1f, 0.001f}) {
        int going = 0;
        for (int i = 0; i < 10'000; ++i)
            if (const auto kept = roulette({most / 2, most, most / 4}, (float(i) + 0.5f) / 10'000)) {
                ++going;
                REQUIRE(std::abs(kept->y - 1) <= 1e-4f);
            }
        CHECK(std::abs(float(going) - 10'000 * most) <= 2);
    }
}

TEST_CASE("black ends, and white does not go on for ever", "[step7]") {
    INFO(hint("the program hangs in a white room, or NaN", "xi < chance, so that 0 is never enough; at most 0.9999", "§7 Roulette"));
    CHECK_FALSE(roulette(glm::vec3(0), 0).has_value());
    CHECK_FALSE(roulette(glm::vec3(1), 0.99995f).has_value());
    CHECK(roulette(glm::vec3(1), 0.9998f).has_value());
    CHECK(roulette(glm::vec3(1), 0.5f).value_or(glm::vec3(0)).x == Approx(1).epsilon(2e-4));
}

// ---- Step 8: the whole path ------------------------------------------------------------------------------------------

TEST_CASE("what the eye sees shines as it is", "[step8]") {
    INFO(hint("the lamp in the picture is black, or too dim", "the first hit's emission counts in full: no other way led there", "§8 The whole path"));
    const scene s = lit_ground(ceiling, glm::vec3(0.5f), {10, 20, 40});
    for (const glm::vec3 seen : radiance(s, {{{0, 1, 0}, {0, 1, 0}}}, 20, 1)) CHECK(seen == glm::vec3(10, 20, 40));
    for (const glm::vec3 seen : radiance(s, {{{0, 5, 0}, {0.01f, -1, 0}}}, 20, 1)) CHECK(seen == glm::vec3(0));  // the back of the lamp
    for (const glm::vec3 seen : radiance(s, {{{0, 5, 0}, {0, 1, 0}}}, 20, 1)) CHECK(seen == glm::vec3(0));       // nothing at all
}

TEST_CASE("a closed sphere of two halves: L = Le + ρ <Le> / (1 - <ρ>)", "[step8]") {
    INFO(hint("too bright or too dark after many bounces", "emission is weighed by the throughput before it, each bounce by `bounced`; colours are multiplied, not averaged",
              "§8 A furnace"));
    const matter upper{{0.8f, 0.3f, 0.5f}, {1, 0, 2}}, lower{{0.2f, 0.5f, 0.5f}, {0, 3, 0}};
    const scene s{{{lantern::sphere{{0, 0, 0}, 2}, upper, lower}}, {}, {}};
    for (const float up : {1.0f, -1.0f}) {
        const matter& here = up > 0 ? upper : lower;
        const auto seen = radiance(s, {{{0.3f, 0, 0.1f}, {0.2f, up, 0}}}, 60'000, 11);
        for (int k = 0; k < 3; ++k) {
            const double albedo = (double(upper.albedo[k]) + double(lower.albedo[k])) / 2, emission = (double(upper.emission[k]) + double(lower.emission[k])) / 2;
            const double exact = double(here.emission[k]) + double(here.albedo[k]) * emission / (1 - albedo);
            statistics::mean m;
            for (const glm::vec3& x : seen) m.add(double(x[k]));
            CAPTURE(up, k, m.value(), exact);
            CHECK(std::abs(m.z(exact)) < limit);
            CHECK(m.standard_error() < 0.012 * exact);
        }
    }
}

TEST_CASE("no light is lost at an albedo of .999", "[step8]") {
    INFO(hint("a white room is too dark", "no limit on the number of bounces: only roulette ends a path, and it divides", "§8 A furnace"));
    // 1000 bounces on average. A limit of 50 would lose 95 %, one of 1000 still a third.
    const scene s{{{lantern::sphere{{0, 0, 0}, 1}, {glm::vec3(0.999f), glm::vec3(0)}, {glm::vec3(0.999f), glm::vec3(2)}}}, {}, {}};
    const auto m = mean_of(radiance(s, {{{0, 0, 0}, {0, 1, 0}}}, 4000, 12));
    const double rho = double(0.999f), exact = rho / (1 - rho);
    CAPTURE(m.value(), exact);
    CHECK(std::abs(m.z(exact)) < limit);
    CHECK(m.standard_error() < 0.02 * exact);
}

TEST_CASE("the ground under a lamp: Lambert's formula, each way counted once", "[step8]") {
    INFO(hint("twice too bright, or dark near the lamp", "the shadow ray's light and the lamp that a bounce finds are each weighed by their share; both shares use the same two densities",
              "§8 Two ways, each counted once"));
    const lantern::ray rays[]{down, {{3, 1, 0}, {0, -1, 0}}};
    for (const lantern::ray& r : rays) {
        const scene s = lit_ground(ceiling, glm::vec3(0.8f), glm::vec3(5));
        const double exact = 5 * 0.8 / double(pi) * lantern::exact::irradiance({double(r.origin.x), 0, double(r.origin.z)}, {0, 1, 0}, corners_of(ceiling));
        const auto m = mean_of(radiance(s, {r}, 40'000, 13));
        CAPTURE(m.value(), exact);
        CHECK(std::abs(m.z(exact)) < limit);
        CHECK(m.standard_error() < 0.004 * exact);
    }
}

TEST_CASE("neither a tiny lamp nor one that is very near makes noise", "[step8]") {
    INFO(hint("single very bright pixels, next to the lamp or everywhere", "a tiny lamp is found by shadow rays, a near one by bounces: use both, with their shares",
              "§8 Two ways, each counted once"));
    const lantern::rectangle speck{{0.4f, 2, 0.2f}, {1e-3f, 0, 0}, {0, 0, 1e-3f}};
    const auto tiny = mean_of(radiance(lit_ground(speck, glm::vec3(0.8f), glm::vec3(1e6f)), {down}, 4000, 14));
    const double exact = 0.8 / double(pi) * 1e6 * lantern::exact::irradiance({double(0.4f), 0, double(0.2f)}, {0, 1, 0}, corners_of(speck));
    CAPTURE(tiny.value(), exact);
    CHECK(tiny.value() == Approx(exact).epsilon(1e-3));
    const lantern::rectangle lid{{-2, 0.02f, -2}, {4, 0, 0}, {0, 0, 4}};
    const auto near = mean_of(radiance(lit_ground(lid, glm::vec3(0.8f), glm::vec3(1)), {{{0, 0.01f, 0}, {0, -1, 0}}}, 4000, 15));
    CAPTURE(near.value(), near.standard_error());
    CHECK(near.value() == Approx(0.8).epsilon(0.02));
    CHECK(near.standard_error() < 0.005);  // shadow rays alone: 0.1 and more
}

TEST_CASE("the form factor of opposite squares is .1998", "[step8]") {
    INFO(hint("walls light each other too much or too little", "what shines and is no lamp is found by bounces alone, and counts in full", "§8 A form factor"));
    // Howell's catalogue, C-11, at a distance of 1: F = 2/π [½ ln 4/3 + 2 √2 atan 1/√2 - π/2].
    const double exact = 2 / double(pi) * (0.5 * std::log(4.0 / 3) + 2 * std::numbers::sqrt2 * std::atan(1 / std::numbers::sqrt2) - double(pi) / 2);
    const lantern::rectangle square{{0, 0, 1}, {1, 0, 0}, {0, 0, -1}}, above{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}};
    std::vector<lantern::ray> rays;
    numbers random(4);
    for (int i = 0; i < 40'000; ++i) rays.push_back({{random.unit(), 0.5f, random.unit()}, {0, -1, 0}});
    for (const bool lamp : {false, true}) {
        scene s{{}, {{square, {glm::vec3(1), glm::vec3(0)}}, {above, {glm::vec3(0), glm::vec3(1)}}}, {}};
        if (lamp) s.lamp = 1;
        const auto m = mean_of(radiance(s, rays, 40'000, 16));
        CAPTURE(lamp, m.value(), exact);
        CHECK(std::abs(m.z(exact)) < limit);
    }
}

TEST_CASE("light goes to and fro between lamp and ground: a geometric series", "[step8]") {
    INFO(hint("too dark where walls are bright", "the lamp reflects too; every hit on the way gets its shadow ray", "§8 A furnace"));
    // Two plates, so large that they are endless to 1e-4: L of the ground = ρ (Le + ρ' L).
    const scene s{{}, {{ground, {glm::vec3(0.8f), glm::vec3(0)}}, {{{-50, 0.25f, -50}, {100, 0, 0}, {0, 0, 100}}, {glm::vec3(0.5f), glm::vec3(1)}}}, 1};
    const auto m = mean_of(radiance(s, {{{0, 0.1f, 0}, {0, -1, 0}}}, 40'000, 17));
    const double exact = 0.8 / (1 - 0.8 * 0.5);
    CAPTURE(m.value(), exact);
    CHECK(std::abs(m.z(exact)) < limit);
    CHECK(m.standard_error() < 0.01 * exact);
}

TEST_CASE("no NaN, no infinity and no negative light, in a box full of balls", "[step8]") {
    INFO(hint("black or white single pixels", "a density of 0 divides nothing; a cosine of 0 carries nothing", "§8 The whole path"));
    scene s = lit_ground(ceiling, glm::vec3(0.9f), glm::vec3(50));
    numbers random(5);
    for (int i = 0; i < 6; ++i) s.balls.push_back({lantern::sphere{random.vector() + glm::vec3(0, 1, 0), 0.4f}, {glm::vec3(0.9f), glm::vec3(0)}, {glm::vec3(0.5f), glm::vec3(0.1f)}});
    std::vector<lantern::ray> rays;
    for (int i = 0; i < 2000; ++i) rays.push_back({3.0f * random.vector() + glm::vec3(0, 1.5f, 0), random.direction()});
    int broken = 0;
    for (const glm::vec3& seen : radiance(s, rays, 20'000, 18))
        for (int k = 0; k < 3; ++k) broken += !(seen[k] >= 0 && seen[k] < std::numeric_limits<float>::infinity());
    CHECK(broken == 0);
}
