// SPDX-License-Identifier: MIT
#include <lantern/obb.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using lantern::aabb;
using lantern::frame;
using lantern::hull;
using lantern::obb;
using lantern::principal_box;
using lantern::tight_box;

namespace {

bool holds(const obb& b, const hull& h) {
    for (std::size_t i = 0; i < 3; ++i) {
        const wide3 axis = widened(b.axes[i]);
        for (const glm::dvec3& p : h.points) {
            const wide3 from{wide(p.x) - wide(b.center.x), wide(p.y) - wide(b.center.y), wide(p.z) - wide(b.center.z)};
            if (magnitude(dot(axis, from)) + wide(h.radius) * length(axis) > wide(b.half[int(i)])) return false;
        }
    }
    return true;
}

frame random_frame(dice& d) {
    const glm::dvec3 u = d.on_sphere(), v = glm::normalize(glm::cross(u, d.on_sphere()));
    return {u, v, glm::cross(u, v)};
}

/// The corners of a box that stands at an angle.
hull turned_box(const frame& f, glm::dvec3 center, glm::dvec3 half) {
    hull h;
    for (int i = 0; i < 8; ++i)
        h.points.push_back(center + (i & 1 ? half.x : -half.x) * f[0] + (i & 2 ? half.y : -half.y) * f[1] +
                           (i & 4 ? half.z : -half.z) * f[2]);
    return h;
}

double area(glm::dvec3 half) { return 8 * (half.x * half.y + half.y * half.z + half.z * half.x); }

}  // namespace

TEST_CASE("every box holds what it was fitted to, at any scale and place") {
    dice d{.state = 1};
    for (int i = 0; i < 500; ++i) {
        hull h;
        const float size = d.magnitude_between(-12, 12);
        const glm::vec3 far = d.in_cube(d.magnitude_between(-12, 15));
        for (std::uint32_t k = d.below(30) + 1; k > 0; --k) h.points.emplace_back(far + d.in_cube(size));
        if (i % 2 == 0) h.radius = d.magnitude_between(-12, 12);
        if (i % 3 == 0)
            for (auto& p : h.points) p.z = far.z;
        REQUIRE(holds(tight_box(h), h));
        REQUIRE(holds(principal_box(h), h));
        REQUIRE(holds(box_along(random_frame(d), h), h));
        const hull corners = hull_of(tight_box(h));
        REQUIRE(holds(enclose(obb{}, corners), h));  // corners are where they should be
    }
}

TEST_CASE("a box that stands at an angle is found again") {
    dice d{.state = 2};
    for (int i = 0; i < 300; ++i) {
        const glm::dvec3 half(d.between(0.1, 1), d.between(0.1, 1), d.between(0.1, 1));
        const hull h = turned_box(random_frame(d), glm::dvec3(d.in_cube(5)), half);
        REQUIRE(surface_area(tight_box(h)) == Approx(area(half)).epsilon(1e-4));
    }
}

TEST_CASE("a crowd in one corner turns the principal axes, and not the tight box") {
    dice d{.state = 3};
    double principal = 0, tight = 0, best = 0;
    for (int i = 0; i < 50; ++i) {
        const glm::dvec3 half(1, 0.8, 0.6);
        const frame f = random_frame(d);
        hull h = turned_box(f, {}, half);
        for (int k = 0; k < 200; ++k) h.points.push_back(h.points[0] + (h.points[7] - h.points[0]) * 0.2 * d.unit());
        principal += surface_area(principal_box(h));
        tight += surface_area(tight_box(h));
        best += area(half);
    }
    INFO("principal axes " << principal / best << ", tight " << tight / best);
    CHECK(principal > 1.3 * best);
    CHECK(tight < 1.01 * best);
}

TEST_CASE("the tight box is never worse than the world's axes or the principal ones, and near the best of many frames") {
    dice d{.state = 4};
    double tight = 0, best_of_many = 0;
    for (int i = 0; i < 60; ++i) {
        hull h;
        const frame f = random_frame(d);
        for (int k = 0; k < 40; ++k) {
            const glm::dvec3 p(d.in_cube());
            h.points.push_back(p.x * f[0] + 0.5 * p.y * f[1] + 0.1 * p.z * f[2]);
        }
        const double area_of_it = surface_area(tight_box(h));
        REQUIRE(area_of_it <= surface_area(principal_box(h)));
        REQUIRE(area_of_it <= surface_area(enclose(aabb{}, h)) * (1 + 1e-5));
        double least = area_of_it;
        for (int k = 0; k < 500; ++k) least = std::min(least, surface_area(box_along(random_frame(d), h)));
        tight += area_of_it;
        best_of_many += least;
    }
    INFO(tight / best_of_many);
    CHECK(tight < 1.05 * best_of_many);
}

TEST_CASE("points, lines and planes have flat boxes") {
    CHECK(surface_area(tight_box({{glm::dvec3(1, 2, 3)}, 0})) == 0);
    const hull line{{glm::dvec3(0, 0, 0), glm::dvec3(1, 2, 3), glm::dvec3(2, 4, 6)}, 0};
    CHECK(surface_area(tight_box(line)) < 1e-5);
    dice d{.state = 5};
    hull plane;
    for (int i = 0; i < 50; ++i) {
        const double u = d.unit(), v = d.unit();
        plane.points.push_back(u * glm::dvec3(1, 2, 2) + v * glm::dvec3(2, 1, -2));
    }
    const obb flat = tight_box(plane);
    CHECK(std::min({flat.half.x, flat.half.y, flat.half.z}) < 1e-5f);
    CHECK(empty(tight_box({})));
    CHECK(empty(principal_box({})));
}

TEST_CASE("principal axes are perpendicular, of unit length, and the longest spread is among them") {
    dice d{.state = 6};
    for (int i = 0; i < 200; ++i) {
        const frame f = random_frame(d);
        std::vector<glm::dvec3> points;
        for (int k = 0; k < 100; ++k) {
            const glm::dvec3 p(d.in_cube());
            points.push_back(100.0 * p.x * f[0] + p.y * f[1] + 0.01 * p.z * f[2]);
        }
        const frame axes = lantern::principal_axes(points);
        double along = 0;
        for (std::size_t a = 0; a < 3; ++a) {
            REQUIRE(glm::length(axes[a]) == Approx(1));
            REQUIRE(std::abs(glm::dot(axes[a], axes[(a + 1) % 3])) < 1e-12);
            along = std::max(along, std::abs(glm::dot(axes[a], f[0])));
        }
        REQUIRE(along > 0.99);
    }
}

TEST_CASE("contains, bounds, and the ray's direction is turned, too") {
    const double s = std::sqrt(0.5);
    const obb b = box_along({{{s, s, 0}, {-s, s, 0}, {0, 0, 1}}}, turned_box({{{s, s, 0}, {-s, s, 0}, {0, 0, 1}}}, {}, {2, 1, 1}));
    CHECK(contains(b, glm::dvec3(2 * s, 2 * s, 0)));
    CHECK_FALSE(contains(b, glm::dvec3(2, 0, 0)));
    CHECK(bounds(b).max.x == Approx(3 * s));
    CHECK(overlaps(b, lantern::ray{{-5, 0, 0}, {1, 0, 0}}, lantern::interval{}));
    CHECK_FALSE(overlaps(b, lantern::ray{{1.7f, -5, 0}, {1, 1, 0}}, lantern::interval{}));
    CHECK(overlaps(b, lantern::ray{{1.7f, -5, 0}, {0, 1, 0}}, lantern::interval{}));
    CHECK_FALSE(overlaps(b, lantern::ray{{2.3f, -5, 0}, {0, 1, 0}}, lantern::interval{}));
    CHECK(empty(obb{}));
    CHECK(empty(obb{.half = {1, std::numeric_limits<float>::quiet_NaN(), 1}}));
}
