// SPDX-License-Identifier: MIT
#include <lantern/warp.hpp>

#include "catch.hpp"
#include "statistics.hpp"

#include <lantern/samples.hpp>

#include <array>
#include <numbers>
#include <stdexcept>
#include <vector>

using std::numbers::pi;

namespace {

constexpr std::size_t side = 16;  // of the grid of cells
constexpr std::uint32_t count = 100'000;

/// Carries many independent points over, and counts in which cell of a 16 × 16 grid each arrives. `place` gives its
/// coordinates there, in [0, 1]², chosen such that all cells have the same measure: area, or solid angle.
template <class Warp, class Place>
std::vector<double> arrivals(Warp warp, Place place) {
    std::vector<double> cells(side * side);
    const lantern::independent set{.samples = count, .seed = 1};
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::dvec2 at = place(warp(set.at({0, 0}, i).draw2(lantern::purpose::user)));
        ++cells[statistics::cell(at.y, side) * side + statistics::cell(at.x, side)];
    }
    return cells;
}

/// What a uniform density says of every cell, when all of them together have this measure.
std::vector<double> uniform(double density, double measure) {
    return std::vector<double>(side * side, count * density * measure / (side * side));
}

/// The angle around the axis, as a fraction of a turn.
double turn(double x, double y) {
    const double angle = std::atan2(y, x) / (2 * pi);
    return angle < 0 ? angle + 1 : angle;
}

bool agree(const std::vector<double>& seen, const std::vector<double>& expected) {
    return statistics::chi_square_test(seen, expected) > statistics::false_alarm;
}

/// All of the border, where formulas divide by zero, and the middle, where Shirley and Chiu's does.
template <class F>
void at_the_extremes(F f) {
    for (const float x : {0.0f, 0x1p-24f, 0.5f, 1 - 0x1p-24f, 1.0f})
        for (const float y : {0.0f, 0x1p-24f, 0.5f, 1 - 0x1p-24f, 1.0f}) f(glm::vec2{x, y});
}

}  // namespace

TEST_CASE("chi-square probabilities are those of the tables") {
    CHECK(std::abs(statistics::chi_square_tail(3.841458821, 1) - .05) < 1e-9);
    CHECK(std::abs(statistics::chi_square_tail(18.30703805, 10) - .05) < 1e-9);
    CHECK(std::abs(statistics::chi_square_tail(149.4492528, 100) - .001) < 1e-9);
    CHECK(std::abs(statistics::chi_square_tail(2.0, 2) - std::exp(-1.0)) < 1e-14);
    CHECK(statistics::chi_square_tail(255, 255) > .48);
    CHECK(statistics::chi_square_tail(500, 255) < 1e-17);
}

TEST_CASE("disk: uniform by area") {
    const auto place = [](glm::vec2 p) { return glm::dvec2(glm::dot(p, p), turn(p.x, p.y)); };
    CHECK(agree(arrivals(lantern::to_disk, place), uniform(lantern::disk_density(), pi)));

    SECTION("and the test sees a radius that is ξ instead of √ξ") {
        const auto wrong = [](glm::vec2 xi) {
            return xi.x * glm::vec2(std::cos(6.2831853f * xi.y), std::sin(6.2831853f * xi.y));
        };
        CHECK_FALSE(agree(arrivals(wrong, place), uniform(lantern::disk_density(), pi)));
    }
}

TEST_CASE("disk: the borders of the square become the circle, its middle the centre") {
    at_the_extremes([](glm::vec2 xi) {
        const glm::dvec2 p(lantern::to_disk(xi));
        const glm::dvec2 q = 2.0 * glm::dvec2(xi) - 1.0;
        CHECK(std::abs(glm::length(p) - std::max(std::abs(q.x), std::abs(q.y))) < 1e-7);
    });
    CHECK(lantern::to_disk({.5f, .5f}) == glm::vec2(0));
}

TEST_CASE("disk: neighbours stay neighbours") {
    for (float x = 0; x < 1; x += 0x1p-5f) {
        for (float y = 0; y < 1; y += 0x1p-5f) {
            const glm::vec2 here = lantern::to_disk({x, y});
            CHECK(glm::length(lantern::to_disk({x + 0x1p-10f, y}) - here) < 4 * 0x1p-10f);
            CHECK(glm::length(lantern::to_disk({x, y + 0x1p-10f}) - here) < 4 * 0x1p-10f);
        }
    }
}

TEST_CASE("triangle: uniform by area, for any triangle") {
    const glm::vec3 a{1, 2, 3}, b{4, 2, 3}, c{1, 7, 3};  // of area 7.5
    const auto place = [](glm::vec3 weight) {
        const double together = double{weight.x} + weight.y;
        return glm::dvec2(together * together, weight.x / together);
    };
    CHECK(agree(arrivals(lantern::to_triangle, place), uniform(lantern::triangle_density(a, b, c), 7.5)));
    at_the_extremes([](glm::vec2 xi) {
        const glm::vec3 w = lantern::to_triangle(xi);
        CHECK(std::min({w.x, w.y, w.z}) >= 0);
        CHECK(std::abs(w.x + w.y + w.z - 1) < 1e-6f);
    });
}

TEST_CASE("polygon: uniform by area, with straight edges") {
    for (const std::uint32_t corners : {3u, 4u, 6u, 9u}) {
        const double sector = 2 * pi / corners, rotation = .3;
        // How far out, as a fraction of the way to the edge, and which sector and place along its edge.
        const auto place = [=](glm::vec2 p) {
            const double angle = turn(p.x, p.y) * 2 * pi - rotation, around = angle < 0 ? angle + 2 * pi : angle;
            const double which = std::floor(around / sector), within = around - (which + .5) * sector;
            const double out = glm::length(glm::dvec2(p)) * std::cos(within) / std::cos(sector / 2);
            CHECK(out < 1 + 1e-6);
            const double along = (std::tan(within) / std::tan(sector / 2) + 1) / 2;
            return glm::dvec2(out * out, (which + along) / corners);
        };
        const auto warp = [=](glm::vec2 xi) { return lantern::to_polygon(xi, corners, .3f); };
        const double area = corners * std::sin(sector) / 2;
        CAPTURE(corners);
        CHECK(agree(arrivals(warp, place), uniform(lantern::polygon_density(corners), area)));
        at_the_extremes([&](glm::vec2 xi) { CHECK(glm::length(warp(xi)) < 1.000001f); });
    }
}

TEST_CASE("sphere, hemisphere: uniform by solid angle") {
    const auto place = [](double low) {
        return [=](glm::vec3 d) { return glm::dvec2((d.z - low) / (1 - low), turn(d.x, d.y)); };
    };
    CHECK(agree(arrivals(lantern::to_sphere, place(-1)), uniform(lantern::sphere_density(), 4 * pi)));
    CHECK(agree(arrivals(lantern::to_hemisphere, place(0)), uniform(lantern::hemisphere_density(), 2 * pi)));
}

TEST_CASE("cosine hemisphere: as dense as the cosine") {
    const auto place = [](glm::vec3 d) { return glm::dvec2(d.z, turn(d.x, d.y)); };
    std::vector<double> expected;
    for (std::size_t turns = 0; turns < side; ++turns) {
        for (std::size_t height = 0; height < side; ++height) {
            const double middle = (static_cast<double>(height) + .5) / side;  // exact: the density is linear in z
            expected.push_back(count * double{lantern::cosine_hemisphere_density({0, 0, static_cast<float>(middle)})} *
                               2 * pi / (side * side));
        }
    }
    CHECK(agree(arrivals(lantern::to_cosine_hemisphere, place), expected));
    CHECK_FALSE(agree(arrivals(lantern::to_hemisphere, place), expected));
    CHECK(lantern::cosine_hemisphere_density({0, 0, -1}) == 0);
}

TEST_CASE("cone: uniform by solid angle, for any angle, however small") {
    for (const double angle : {pi, 2.0, pi / 2, .3, 1e-3, 1e-9, 1e-18}) {
        const lantern::cone c = lantern::cone_of(angle);
        // 1 - cos from the sine near the axis, where 1 - z would cancel.
        const auto place = [&](glm::dvec3 d) {
            const double sine2 = d.x * d.x + d.y * d.y, height = d.z > 0 ? sine2 / (1 + d.z) : 1 - d.z;
            return glm::dvec2(height / c.height, turn(d.x, d.y));
        };
        const auto warp = [&](glm::vec2 xi) { return lantern::to_cone(c, xi); };
        CAPTURE(angle);
        CHECK(agree(arrivals(warp, place), uniform(lantern::cone_density(c), lantern::solid_angle(c))));
        at_the_extremes([&](glm::vec2 xi) { CHECK(place(warp(xi)).x < 1 + 1e-6); });
    }
    CHECK(std::abs(lantern::solid_angle(lantern::cone_of(1e-9)) / (pi * 1e-18) - 1) < 1e-12);  // πa²
    CHECK(std::abs(lantern::solid_angle(lantern::cone_of(pi)) - 4 * pi) < 1e-12);
    CHECK_THROWS_WITH(lantern::cone_of(0), containing("cone: half angle is 0"));
    CHECK_THROWS_AS(lantern::cone_of(4), std::invalid_argument);
    CHECK_THROWS_AS(lantern::cone_of(std::nan("")), std::invalid_argument);
}

TEST_CASE("directions have unit length, at the extremes too") {
    at_the_extremes([](glm::vec2 xi) {
        for (const glm::vec3 d :
             {lantern::to_sphere(xi), lantern::to_hemisphere(xi), lantern::to_cosine_hemisphere(xi)})
            CHECK(std::abs(glm::length(d) - 1) < 3e-7f);
        CHECK(lantern::to_hemisphere(xi).z >= 0);
        CHECK(lantern::to_cosine_hemisphere(xi).z >= 0);
    });
}
