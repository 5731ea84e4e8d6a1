// SPDX-License-Identifier: MIT
#include <lantern/lobe.hpp>

#include <lantern/blinn_phong.hpp>
#include <lantern/coated.hpp>
#include <lantern/diffuse.hpp>
#include <lantern/glossy.hpp>
#include <lantern/mirror.hpp>

#include "catch.hpp"
#include "hemisphere.hpp"
#include "oracle.hpp"
#include "statistics.hpp"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

using lantern::blinn_phong;
using lantern::diffuse;
using lantern::glossy;

namespace mine {

/// Chalk: only `evaluate`, nothing else.
struct chalk {};
glm::vec3 evaluate(const chalk&, glm::vec3 in, const lantern::hit& h, glm::vec3 out) {
    return glm::vec3(0.2f * glm::max(0.0f, glm::dot(lantern::facing(h.normal, in), out)));
}

}  // namespace mine

namespace {

using mine::chalk;

const lantern::hit up{.normal = {0, 0, 1}};

/// How often directions fall into 16 × 32 cells of height and angle, and what their density says: Pearson's test. Each
/// cell's probability is the mean over fine × fine points of it.
template <class Draw, class Density>
double agreement(const Draw& draw, const Density& density, int count = 200'000, int fine = 24) {
    constexpr std::size_t rows = 16, columns = 32;
    std::vector<double> observed(rows * columns), expected(rows * columns);
    dice d{.state = 5};
    int lost = 0;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 out = draw(glm::vec2(d.unit(), d.unit()));
        if (!(out.z > 0)) {
            ++lost;
            continue;
        }
        const double turn = std::atan2(double(out.y), double(out.x)) / (2 * std::numbers::pi) + 0.5;
        ++observed[statistics::cell(double(out.z), rows) * columns + statistics::cell(turn, columns)];
    }
    double all = 0;
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t column = 0; column < columns; ++column) {
            double sum = 0;
            for (int y = 0; y < fine; ++y)
                for (int x = 0; x < fine; ++x) {
                    const double z = (double(row) + (y + 0.5) / fine) / rows;
                    const double turn = (double(column) + (x + 0.5) / fine) / columns - 0.5;
                    sum += density(tilted(std::acos(z), turn * 2 * std::numbers::pi));
                }
            all += expected[row * columns + column] = sum / (fine * fine) * 2 * std::numbers::pi / (rows * columns) * count;
        }
    INFO(lost << " below the surface, " << count - all << " expected");
    CHECK(std::abs(lost - (count - all)) < 5 * std::sqrt(std::max(0.0, count - all)) + 5e-3 * count);
    return statistics::chi_square_test(observed, expected);
}

}  // namespace

TEST_CASE("a material of one's own gets directions by the cosine, and the side that is seen") {
    STATIC_REQUIRE_FALSE(lantern::draws_directions<chalk>);
    for (const glm::vec3 in : {-tilted(0.7), tilted(0.7)}) {
        const float side = in.z < 0 ? 1.0f : -1.0f;
        const auto flipped = [&](glm::vec3 v) { return glm::vec3(v.x, v.y, side * v.z); };
        CHECK(agreement([&](glm::vec2 xi) { return flipped(lantern::drawn_direction(chalk{}, in, up, xi)); },
                        [&](glm::vec3 out) { return lantern::direction_density(chalk{}, in, up, flipped(out)); }) > statistics::false_alarm);
        CHECK(lantern::direction_density(chalk{}, in, up, flipped({0, 0, -1})) == 0);
    }
}

TEST_CASE("directions for a highlight are drawn as its density says, from exponent 0 to 200") {
    STATIC_REQUIRE(lantern::draws_directions<blinn_phong>);
    for (const float exponent : {0.0f, 3.0f, 30.0f, 200.0f})
        for (const double angle : {0.2, 1.2}) {
            const blinn_phong m{glm::vec3(0.2f), glm::vec3(0.5f), exponent};
            const glm::vec3 in = -tilted(angle);
            INFO("exponent " << exponent << ", angle " << angle);
            CHECK(agreement([&](glm::vec2 xi) { return draw(m, in, up, xi); }, [&](glm::vec3 out) { return density(m, in, up, out); },
                            50'000, exponent > 50 ? 60 : 16) > statistics::false_alarm);
        }
}

TEST_CASE("no sample of a highlight weighs much, however sharp: rounding of the direction is no matter") {
    dice d{.state = 2};
    for (const float exponent : {0.0f, 1.0f, 50.0f, 1e4f, 1e6f, 1e9f}) {
        const blinn_phong m{glm::vec3(0), glm::vec3(1), exponent};
        statistics::mean weight;
        for (int i = 0; i < 20'000; ++i) {
            const glm::vec3 in = -tilted(0.5), out = draw(m, in, up, glm::vec2(d.unit(), d.unit()));
            const double p = density(m, in, up, out), w = p > 0 ? double(evaluate(m, in, up, out).x) / p : 0;
            REQUIRE(w < 8.0001);
            weight.add(w);
        }
        const double exact = exponent > 1000 ? -1 : over_hemisphere([&](glm::vec3 out) { return double(evaluate(m, -tilted(0.5), up, out).x); });
        INFO("exponent " << exponent << ": " << weight.value());
        if (exact > 0) CHECK(std::abs(weight.z(exact)) < statistics::z_limit);
        else CHECK(weight.value() == Approx(std::cos(0.5) * std::cos(0.5)).epsilon(0.01));  // (o·h)(o·n) at the peak
    }
}

TEST_CASE("a lobe is as dense as glossy rays are drawn, near grazing and folded too") {
    for (const float width : {0.3f, 1.0f, 5.0f})
        for (const double angle : {0.0, 0.8, 1.5}) {
            const glossy m{.color = glm::vec3(0.8f), .width = width};
            const glm::vec3 in = -tilted(angle, 0.4);
            INFO("width " << width << ", angle " << angle);
            CHECK(agreement([&](glm::vec2 xi) { return scatter(m, in, up, xi)[0].direction; },
                            [&](glm::vec3 out) { return lobe(m, in, up, out).density; }, 50'000, 60) > statistics::false_alarm);
            const auto seen = lobe(m, in, up, scatter(m, in, up, {0.4f, 0.7f})[0].direction);
            CHECK(double(seen.value.x) == Approx(0.8 * seen.density));
        }
}

TEST_CASE("the lobes of frosted glass add up to its two rays") {
    const lantern::frosted m{.body = {.color = glm::vec3(0.7f)}, .width = 0.6f};
    const glm::vec3 in = -tilted(1.2);
    const auto clear = scatter(m.body, in, up);
    const double up_there = over_hemisphere([&](glm::vec3 out) { return double(lobe(m, in, up, out).value.x); }, 500);
    const double down_there = over_hemisphere([&](glm::vec3 out) { return double(lobe(m, in, up, -out).value.x); }, 500);
    CHECK(up_there == Approx(clear[0].weight.x).epsilon(5e-3));
    CHECK(down_there == Approx(clear[1].weight.x).epsilon(5e-3));
    const double all = over_hemisphere([&](glm::vec3 out) { return lobe(m, in, up, out).density + lobe(m, in, up, -out).density; }, 500);
    CHECK(all == Approx(1).epsilon(5e-3));
}

TEST_CASE("a coat's lobe has its share; what is sharp has none") {
    const lantern::coated m{diffuse{}, glossy{.width = 0.5f}, 0.25f};
    const glm::vec3 in = -tilted(0.3), out = tilted(-0.35);
    const auto coat = lobe(m.coat, in, up, out), whole = lobe(m, in, up, out);
    CHECK(whole.value == 0.25f * coat.value);
    CHECK(whole.density == coat.density);
    CHECK(coat.density > 0);
    STATIC_REQUIRE_FALSE(lantern::has_lobe<lantern::mirror>);
    STATIC_REQUIRE_FALSE(lantern::has_lobe<lantern::coated<diffuse, lantern::mirror>>);
    CHECK(lobe(glossy{.width = 1e-5f}, in, up, lantern::mirrored(in, up.normal)).density == 0);
    CHECK(lobe(lantern::frosted{.width = 0}, in, up, lantern::mirrored(in, up.normal)).density == 0);
}
