// SPDX-License-Identifier: MIT
#include <lantern/solid_angle.hpp>

#include "catch.hpp"
#include "statistics.hpp"

#include <lantern/samples.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

using lantern::seen_point;
using lantern::seen_rectangle;
using lantern::solid_angle;
using lantern::sphere_seen_from;
using std::numbers::pi;

namespace {

constexpr std::size_t side = 12;
constexpr std::uint32_t count = 60'000;
const lantern::independent points{.samples = count, .seed = 3};

struct flat {
    glm::vec3 corner, u, v, viewer;
};

/// Where on the rectangle, as fractions of its edges.
glm::dvec2 place_on(const flat& r, glm::dvec3 p) {
    const glm::dvec3 d = p - glm::dvec3(r.corner), u(r.u), v(r.v);
    return {glm::dot(d, u) / glm::dot(u, u), glm::dot(d, v) / glm::dot(v, v)};
}

/// The solid angle of part of a rectangle, by brute force: the sum of cos/r² over small pieces.
double slow_solid_angle(const flat& r, glm::dvec2 from, glm::dvec2 to, int pieces) {
    const glm::dvec3 u(r.u), v(r.v), cross = glm::cross(u, v);
    double sum = 0;
    for (int i = 0; i < pieces; ++i) {
        for (int j = 0; j < pieces; ++j) {
            const glm::dvec2 at = from + (to - from) * (glm::dvec2(i, j) + .5) / double(pieces);
            const glm::dvec3 d = glm::dvec3(r.corner) + at.x * u + at.y * v - glm::dvec3(r.viewer);
            sum += std::abs(glm::dot(d, cross)) / std::pow(glm::dot(d, d), 1.5);
        }
    }
    return sum * (to.x - from.x) * (to.y - from.y) / (pieces * pieces);
}

/// Each cell of a rectangle must receive as many points as its share of the solid angle, or of the area, is.
double p_value(const flat& r, bool by_area) {
    const seen_rectangle seen{r.viewer, r.corner, r.u, r.v};
    std::vector<double> cells(side * side), expected(side * side);
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::dvec2 at = place_on(r, to_seen(seen, points.at({0, 0}, i).draw2(lantern::purpose::light)).position);
        ++cells[statistics::cell(at.y, side) * side + statistics::cell(at.x, side)];
    }
    for (std::size_t y = 0; y < side; ++y) {
        for (std::size_t x = 0; x < side; ++x) {
            const glm::dvec2 from = glm::dvec2(x, y) / double(side);
            const double share = slow_solid_angle(r, from, from + 1.0 / double(side), 60) / solid_angle(seen);
            expected[y * side + x] = count * (by_area ? 1.0 / (side * side) : share);
        }
    }
    return statistics::chi_square_test(cells, expected);
}

}  // namespace

TEST_CASE("a rectangle's solid angle is the sum of its pieces'") {
    for (const flat& r :
         {flat{{-1, -1, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 1}}, flat{{1, 2, -3}, {0, 1, 1}, {5, 0, 0}, {.3f, .1f, .2f}},
          flat{{-.1f, -.1f, -2}, {.2f, 0, 0}, {0, .2f, 0}, {3, 4, 5}}}) {
        const double slow = slow_solid_angle(r, {0, 0}, {1, 1}, 1500);
        CHECK(std::abs(solid_angle(seen_rectangle{r.viewer, r.corner, r.u, r.v}) / slow - 1) < 1e-5);
    }
}

TEST_CASE("a rectangle's solid angle: the face of a cube, from its centre, is a sixth of the sphere") {
    CHECK(std::abs(solid_angle(seen_rectangle{{0, 0, 0}, {-1, -1, 1}, {2, 0, 0}, {0, 2, 0}}) - 4 * pi / 6) < 1e-14);
    // Half of everything, from just above a vast plane.
    CHECK(std::abs(solid_angle(seen_rectangle{{0, 0, 1e-6f}, {-1e6f, -1e6f, 0}, {2e6f, 0, 0}, {0, 2e6f, 0}}) - 2 * pi) <
          1e-10);
}

TEST_CASE("a rectangle's solid angle: tiny ones are area · cos/r², to many digits") {
    for (const float size : {1e-3f, 1e-6f, 1e-12f}) {
        const double ideal = double{size} * size * 2 / std::pow(1 + 4 + 4, 1.5);  // the middle is at (1, 2, 2)
        const seen_rectangle seen{{1, 2, 2}, {-size / 2, -size / 2, 0}, {size, 0, 0}, {0, size, 0}};
        CHECK(std::abs(solid_angle(seen) / ideal - 1) < 1e-6);
    }
}

TEST_CASE("rectangle: uniform by solid angle, near and far, in front and aside, at grazing angles") {
    const flat near{{-1, -2, 0}, {2, 0, 0}, {0, 3, 0}, {.2f, .1f, .3f}};
    CHECK(p_value(near, false) > statistics::false_alarm);
    CHECK(p_value({{-1, -2, 0}, {2, 0, 0}, {0, 3, 0}, {.2f, .1f, -2}}, false) >
          statistics::false_alarm);  // from behind
    CHECK(p_value({{3, 1, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 1}}, false) > statistics::false_alarm);
    CHECK(p_value({{3, 1, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 1e-3f}}, false) > statistics::false_alarm);
    CHECK(p_value({{3, 1, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 1e-6f}}, false) > statistics::false_alarm);
    CHECK(p_value({{1, 1, 1}, {0, 1e-3f, 1e-3f}, {1e-3f, 0, 0}, {-9, 8, 7}}, false) > statistics::false_alarm);

    SECTION("and the test sees one that is uniform by area") { CHECK(p_value(near, true) < statistics::false_alarm); }
}

TEST_CASE("rectangle: tiny solid angles and slanted edges are drawn by area") {
    CHECK(p_value({{1, 1, 1}, {0, 1e-6f, 1e-6f}, {1e-6f, 0, 0}, {-9, 8, 7}}, true) > statistics::false_alarm);
}

TEST_CASE("rectangle: one over the density is the solid angle, on the average, however it is drawn") {
    for (const flat& r : {flat{{-1, -2, 0}, {2, 0, 0}, {0, 3, 0}, {.2f, .1f, 1}},
                          flat{{-1, -2, 0}, {2, .5f, 0}, {0, 3, 0}, {.2f, .1f, 1}},
                          flat{{1, 1, 1}, {0, 1e-6f, 1e-6f}, {1e-6f, 0, 0}, {-9, 8, 7}}}) {
        const seen_rectangle seen{r.viewer, r.corner, r.u, r.v};
        statistics::mean one_over;
        for (std::uint32_t i = 0; i < count; ++i)
            one_over.add(1 / to_seen(seen, points.at({0, 0}, i).draw2(lantern::purpose::light)).density);
        CHECK(std::abs(one_over.value() / solid_angle(seen) - 1) < .02);
    }
}

TEST_CASE("rectangle: at the extremes points are finite and on it") {
    for (const float height : {1e-30f, 1e-6f, 1.0f, 1e6f, 1e15f}) {
        const flat r{{-1, -2, 0}, {2, 0, 0}, {0, 3, 0}, {5, .1f, height}};
        const seen_rectangle seen{r.viewer, r.corner, r.u, r.v};
        for (const float x : {0.0f, 0x1p-24f, .5f, 1 - 0x1p-24f, 1.0f}) {
            for (const float y : {0.0f, 0x1p-24f, .5f, 1 - 0x1p-24f, 1.0f}) {
                const seen_point p = to_seen(seen, {x, y});
                const glm::dvec2 at = place_on(r, p.position);
                CHECK(std::min(at.x, at.y) > -1e-9);
                CHECK(std::max(at.x, at.y) < 1 + 1e-9);
                CHECK(p.density > 0);
            }
        }
    }
    const seen_rectangle edge_on{{5, 0, 0}, {-1, -2, 0}, {2, 0, 0}, {0, 3, 0}};  // the viewer is in its plane
    CHECK(solid_angle(edge_on) == 0);
    CHECK(1 / to_seen(edge_on, {.5f, .5f}).density == 0);
}

TEST_CASE("sphere: uniform over the part that is seen") {
    const glm::vec3 center{1, 2, 3};
    for (const float distance : {1.000001f, 1.1f, 3.0f, 1e3f, 1e9f}) {
        const glm::vec3 viewer = center + distance * glm::vec3(2, -1, 2) / 3.0f;
        const auto seen = sphere_seen_from(viewer, center, 1);
        REQUIRE(seen);
        std::vector<double> cells(side * side);
        bool on_it = true, in_front = true;
        for (std::uint32_t i = 0; i < count; ++i) {
            const glm::dvec3 p = to_seen(*seen, points.at({0, 0}, i).draw2(lantern::purpose::light)).position;
            const glm::dvec3 normal = p - glm::dvec3(center), back = glm::normalize(glm::dvec3(viewer) - p);
            on_it = on_it && std::abs(glm::length(normal) - 1) < 1e-6;
            in_front = in_front && glm::dot(normal, back) > -1e-6;
            // 1 - cos of the angle from the axis, by its sine. From very far away the frame, which is in float, is too
            // coarse to tell directions apart; but there the disk is seen from in front, and the normal tells as much.
            const glm::dvec3 w(seen->frame.w), u(seen->frame.u), v(seen->frame.v);
            const bool far = distance > 1e6f;
            const glm::dvec3 d = far ? normal : -back;
            const double x = glm::dot(d, u), y = glm::dot(d, v), sine2 = x * x + y * y;
            const double height = glm::dot(d, w) > 0 ? sine2 / (1 + std::sqrt(1 - sine2)) : 2;
            const double out = far ? sine2 : height / seen->directions.height;
            const double angle = std::atan2(y, x) / (2 * pi);
            ++cells[statistics::cell(angle < 0 ? angle + 1 : angle, side) * side + statistics::cell(out, side)];
        }
        CAPTURE(distance);
        CHECK(on_it);
        CHECK(in_front);
        CHECK(statistics::chi_square_test(cells) > statistics::false_alarm);
    }
}

TEST_CASE("sphere: the solid angle holds from horizon to horizon and down to nothing") {
    CHECK(std::abs(solid_angle(*sphere_seen_from({0, 0, 2}, {0, 0, 0}, 1)) - 2 * pi * (1 - std::sqrt(.75))) < 1e-15);
    CHECK(std::abs(solid_angle(*sphere_seen_from({0, 0, 1e10f}, {0, 0, 0}, 1)) / (pi * 1e-20) - 1) < 1e-7);
    CHECK(std::abs(solid_angle(*sphere_seen_from({0, 0, 1e6f}, {0, 0, 0}, 1e-20f)) / (pi * 1e-52) - 1) < 1e-6);
    CHECK(std::abs(solid_angle(*sphere_seen_from({0, 0, 1 + 0x1p-23f}, {0, 0, 0}, 1)) - 2 * pi) < .01);
    CHECK_FALSE(sphere_seen_from({0, 0, 1}, {0, 0, 0}, 1));  // on it
    CHECK_FALSE(sphere_seen_from({0, 0, 0}, {0, 0, 0}, 1));
    CHECK_FALSE(sphere_seen_from({0, 0, std::nanf("")}, {0, 0, 0}, 1));
}

TEST_CASE("sphere: at the extremes points are finite and on it") {
    for (const float distance : {1.0000002f, 2.0f, 1e10f}) {
        const auto seen = sphere_seen_from({0, 0, distance}, {0, 0, 0}, 1);
        REQUIRE(seen);
        for (const float x : {0.0f, 0x1p-24f, .5f, 1 - 0x1p-24f, 1.0f})
            for (const float y : {0.0f, 0x1p-24f, .5f, 1 - 0x1p-24f, 1.0f})
                CHECK(std::abs(glm::length(to_seen(*seen, {x, y}).position) - 1) < 1e-6);
        CHECK(to_seen(*seen, {.5f, .5f}).position == glm::dvec3(0, 0, 1));  // the point that is nearest
    }
}
