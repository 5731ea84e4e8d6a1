// SPDX-License-Identifier: MIT
// Lab 09: bounding volumes. Rays that touch are made of whole numbers, for which the truth is known exactly; so "never no to a ray
// that meets the volume" is meant to the last bit. Statistical tests fail a right answer once in a million (statistics::z_limit).

#include "truth.hpp"

#include <catch.hpp>
#include <hint.hpp>
#include <numbers.hpp>
#include <statistics.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

using namespace contract::lab09;
using namespace truth;

namespace {

bool met(const volume& v, const ray& r, interval range) { return meets(std::array{question{v, r, range}}).at(0); }

/// The share of `count` lines that meet the volume, against its area: how many standard deviations apart.
double crofton(const volume& v, double true_area, glm::vec3 center, float radius, std::uint64_t seed) {
    dice random(seed);
    constexpr int count = 20000;
    std::vector<question> asked;
    for (int i = 0; i < count; ++i) asked.push_back({v, random.line(center, radius), {}});
    const std::vector<bool> said = meets(asked);
    const auto met = double(std::count(said.begin(), said.end(), true));
    const double p = true_area / (4 * std::numbers::pi * double(radius) * double(radius));
    return (met - count * p) / std::sqrt(count * p * (1 - p));
}

}  // namespace

// ---- Step 1: boxes around things -----------------------------------------------------------------------------------

TEST_CASE("the box holds every point, and each of its faces touches one", "[step1]") {
    INFO(hint("things are cut off, or their boxes reach to the origin", "begin with the empty box, and take the minimum and the maximum along each axis by itself",
              "§1 Smallest and largest"));
    dice random(1);
    for (int i = 0; i < 200; ++i) {
        const cloud points = random.points(1 + i % 20, 2, 5.0f * random.vector());
        const box b = box_of_points(points);
        CAPTURE(i, points, b.min, b.max);
        for (int axis = 0; axis < 3; ++axis) {
            float lower = inf, upper = -inf;
            for (const glm::vec3& p : points) lower = std::min(lower, p[axis]), upper = std::max(upper, p[axis]);
            REQUIRE(b.min[axis] == lower);
            REQUIRE(b.max[axis] == upper);
        }
    }
}

TEST_CASE("around nothing there is nothing", "[step1]") {
    INFO(hint("an empty group is hit", "without points the box stays as it is by default: min is infinite and max minus infinite", "§1 The empty box"));
    const box b = box_of_points({});
    CAPTURE(b.min, b.max);
    CHECK(nothing(b));
    CHECK(nothing(box_of_sphere({{1, 2, 3}, -1})));
}

TEST_CASE("the box around two boxes is the box around all their points", "[step1]") {
    INFO(hint("groups are cut off, or as large as the world", "the smaller min and the larger max along each axis; an empty box changes nothing",
              "§1 The empty box"));
    dice random(2);
    const box none{glm::vec3(inf), glm::vec3(-inf)};
    for (int i = 0; i < 100; ++i) {
        const glm::vec3 p = random.vector(), q = random.vector(), r = random.vector(), s = random.vector();
        const box a{glm::min(p, q), glm::max(p, q)}, b{glm::min(r, s), glm::max(r, s)};
        const box both = box_of_boxes(a, b), other = box_of_boxes(b, a), left = box_of_boxes(none, a), right = box_of_boxes(a, none);
        CAPTURE(a.min, a.max, b.min, b.max);
        REQUIRE(both.min == glm::min(a.min, b.min));
        REQUIRE(both.max == glm::max(a.max, b.max));
        REQUIRE((other.min == both.min && other.max == both.max));
        REQUIRE((left.min == a.min && left.max == a.max));
        REQUIRE((right.min == a.min && right.max == a.max));
    }
    CHECK(nothing(box_of_boxes(none, none)));
}

TEST_CASE("the box of a sphere holds all of it, after rounding", "[step1]") {
    INFO(hint("spheres are flattened at their poles by a hair, or larger than they are",
              "center - radius and center + radius, in double; then min is rounded down and max up", "§1 Rounded outwards"));
    dice random(3);
    for (int i = 0; i < 500; ++i) {
        const ball s{random.between(1, 100) * random.vector(), i % 7 == 0 ? 0.0f : random.between(0.001f, 10)};
        const box b = box_of_sphere(s);
        CAPTURE(s.center, s.radius, b.min, b.max);
        for (int axis = 0; axis < 3; ++axis) {
            const double lower = double(s.center[axis]) - double(s.radius), upper = double(s.center[axis]) + double(s.radius);
            REQUIRE(double(b.min[axis]) <= lower);
            REQUIRE(double(b.max[axis]) >= upper);
            REQUIRE(double(std::nextafter(b.min[axis], inf)) > lower);  // and no float would be nearer
            REQUIRE(double(std::nextafter(b.max[axis], -inf)) < upper);
        }
    }
}

TEST_CASE("a box has six sides, a flat one two, and nothing none", "[step1]") {
    INFO(hint("volumes are compared wrongly: predictions do not come true", "2 (xy + yz + zx), in double; 0 for an empty box", "§1 The area"));
    CHECK(area(box{{1, 1, 1}, {2, 3, 4}}) == Approx(2 * (1 * 2 + 2 * 3 + 3 * 1)));
    CHECK(area(box{{0, 0, 0}, {5, 0, 7}}) == Approx(70));
    CHECK(area(box{{1, 2, 3}, {1, 2, 3}}) == 0);
    CHECK(area(box{glm::vec3(inf), glm::vec3(-inf)}) == 0);
    CHECK(area(box{{1, 1, 1}, {0, 0, 0}}) == 0);
    CHECK(area(box{glm::vec3(-1e25f), glm::vec3(1e25f)}) == Approx(24e50));
}

// ---- Step 2: a ray and a box ---------------------------------------------------------------------------------------

TEST_CASE("a ray through the box meets it, and one past it does not", "[step2]") {
    INFO(hint("boxes are nowhere, or everywhere", "a ray is in the box where it is between the two planes of all three axes at the same t", "§2 Three slabs"));
    dice random(4);
    const box b{{-1, -2, -3}, {1, 2, 3}};
    for (int i = 0; i < 500; ++i) {
        const glm::vec3 inside = 0.99f * random.vector() * b.max, origin = 9.0f * random.direction();
        const glm::vec3 outside = origin + 5.0f * random.vector();
        CAPTURE(inside, origin);
        REQUIRE(met(b, {origin, inside - origin}, {}));
        REQUIRE(met(b, {inside, random.vector()}, {}));  // from inside it is met at once
        // Through two points of a plane that keeps away from the box.
        const glm::vec3 away = random.direction(), reach = glm::abs(away) * b.max;
        const float gap = reach.x + reach.y + reach.z + 0.01f;
        const glm::vec3 p = outside + (gap - glm::dot(away, outside)) * away, q = inside + (gap - glm::dot(away, inside)) * away;
        REQUIRE_FALSE(met(b, {p, q - p}, {-inf, inf}));
    }
}

TEST_CASE("what lies behind the origin or beyond the range is not met", "[step2]") {
    INFO(hint("rays look at boxes in their back; shadow rays at what is behind the lamp", "begin with the range, and cut it down slab by slab", "§2 The range"));
    const box b{{-1, -1, 4}, {1, 1, 6}};
    const ray r{{0.2f, 0.1f, 0}, {0, 0, 2}};  // within from t = 2 to t = 3
    CHECK(met(b, r, {}));
    CHECK_FALSE(met(b, {r.origin, -r.direction}, {}));
    CHECK(met(b, {r.origin, -r.direction}, {-10, 10}));
    CHECK_FALSE(met(b, r, {0, 1.99f}));
    CHECK(met(b, r, {0, 2.01f}));
    CHECK_FALSE(met(b, r, {3.01f, inf}));
    CHECK(met(b, r, {2.99f, inf}));
    CHECK(met(b, r, {2.4f, 2.6f}));
    CHECK_FALSE(met(b, r, {2.6f, 2.4f}));
}

TEST_CASE("no box is lost by a ray that touches it", "[step2]") {
    INFO(hint("cracks where boxes meet: single pixels of the background shine through", "entering and leaving at the same t is meeting: <=; and what is rounded must not decide",
              "§2 Touching"));
    // Whole numbers, so that it is known exactly what is met; through corners, edges, faces; 0 and -0; from inside and from the faces.
    const mistakes m = mistakes_in(5, 20000, any_box);
    CAPTURE(m.shown, m.kept);
    CHECK(m.lost == 0);
}

TEST_CASE("no ray that passes at a distance is kept", "[step2]") {
    INFO(hint("slow: most rays that miss the box are not sorted out", "three slabs, the range, and no more room than rounding needs", "§2 Three slabs"));
    const mistakes m = mistakes_in(6, 20000, any_box);
    CAPTURE(m.shown, m.lost);
    CHECK(m.kept == 0);
}

TEST_CASE("along an axis: 0 and -0 are the same, and a face belongs to the box", "[step2]") {
    INFO(hint("lines of missing pixels, where the camera looks along an axis", "0 · infinity is NaN, and 1 / -0 is minus infinity: where a component is 0 the origin alone decides",
              "§2 Zero"));
    const auto along_axis = [](dice& random) {
        const aim a = aim_at_box(random);
        whole_ray w;
        const int axis = int(random.whole_between(0, 2));
        const std::int64_t step = random.one_in(2) ? 1 : -1;
        w.direction[axis] = step;
        w.origin = a.target;
        w.origin[axis] -= step * random.whole_between(-10, 40);
        if (random.one_in(3)) w.origin[(axis + 1) % 3] += random.whole_between(-3, 3);
        return box_question(a, w);
    };
    const mistakes m = mistakes_in(7, 5000, along_axis);
    CAPTURE(m.shown);
    CHECK(m.lost == 0);
    CHECK(m.kept == 0);
    const box b{{0, 0, 0}, {1, 1, 1}};
    for (const float zero : {0.0f, -0.0f})
        for (const float x : {0.0f, 0.5f, 1.0f}) {
            CAPTURE(zero, x);
            CHECK(met(b, {{x, 0.5f, 5}, {zero, zero, -1}}, {}));
            CHECK(met(b, {{0.5f, x, 5}, {zero, zero, -1}}, {}));
            CHECK(met(b, {{x, x, -5}, {zero, zero, 1}}, {}));
            CHECK_FALSE(met(b, {{x - 2, 0.5f, 5}, {zero, zero, -1}}, {}));
            CHECK_FALSE(met(b, {{0.5f, x + 2, 5}, {zero, zero, -1}}, {}));
        }
}

TEST_CASE("flat boxes and single points are met", "[step2]") {
    INFO(hint("floors, walls and triangles along an axis vanish", "min = max is a slab without thickness, not without points: enter <= leave", "§2 Touching"));
    const auto flat = [](dice& random) {
        aim a = aim_at_box(random);
        const int axis = int(random.whole_between(0, 2));
        a.lower[axis] = a.upper[axis] = a.target[axis];
        if (random.one_in(3)) a.lower = a.upper = a.target;
        return box_question(a, towards(random, a.target));
    };
    const mistakes m = mistakes_in(8, 5000, flat);
    CAPTURE(m.shown);
    CHECK(m.lost == 0);
    CHECK(m.kept == 0);
}

TEST_CASE("an empty box is never met", "[step2]") {
    INFO(hint("an empty group costs as much as the whole scene", "min > max along an axis: ask before min and max are sorted by the direction", "§2 Three slabs"));
    dice random(9);
    for (int i = 0; i < 50; ++i) {
        const ray r{random.vector(), random.vector()};
        CAPTURE(r.origin, r.direction);
        REQUIRE_FALSE(met(box{glm::vec3(inf), glm::vec3(-inf)}, r, {-inf, inf}));
        REQUIRE_FALSE(met(box{{1, 1, 1}, {-1, -1, -1}}, r, {-inf, inf}));
        REQUIRE_FALSE(met(box{{-1, -1, 0.5f}, {1, 1, -0.5f}}, r, {-inf, inf}));
    }
}

TEST_CASE("what a surface hits at the very end of the range is not lost", "[step2]") {
    INFO(hint("of two surfaces in one place the wrong one is seen, depending on what else there is",
              "the surface's t is rounded to float before it is compared with the range; the box must allow for that", "§2 The range"));
    dice random(10);
    for (int i = 0; i < 2000; ++i) {
        const glm::vec3 aim = random.vector(), origin = 5.0f * random.direction(), direction = random.between(0.3f, 3) * (aim - origin);
        const int axis = i % 3;
        box wall{glm::vec3(-2), glm::vec3(2)};
        wall.min[axis] = wall.max[axis] = aim[axis];
        const float t = float((double(aim[axis]) - double(origin[axis])) / double(direction[axis]));  // a rectangle's, say
        if (!(t > 0 && t < 4)) continue;
        CAPTURE(wall.min, wall.max, origin, direction, t);
        REQUIRE(met(wall, {origin, direction}, {0, t}));
        REQUIRE(met(wall, {origin, direction}, {std::nextafter(t, 0.0f), inf}));
    }
}

TEST_CASE("the world may be as small as an atom or as large as a galaxy, the direction of any length", "[step2]") {
    INFO(hint("small things are missing", "a fixed number such as 1e-6 does not know how large the scene is", "§2 Touching"));
    const auto [scene, length] = GENERATE(std::pair(0x1p-60f, 1.0f), std::pair(0x1p40f, 1.0f), std::pair(1.0f, 0x1p-50f), std::pair(0x1p-30f, 0x1p30f));
    INFO("scene := " << scene << ", length := " << length);
    const mistakes m = mistakes_in(11, 4000, any_box, scene, length);
    CAPTURE(m.shown);
    CHECK(m.lost == 0);
    CHECK(m.kept == 0);
}

TEST_CASE("of all lines a box meets as many as its area says", "[step2]") {
    INFO(hint("some rays are lost, or kept, that nobody has thought of", "Crofton: of all lines that meet a ball, the share area / (4πR²) meets a convex body in it", "§2 Crofton's formula"));
    CHECK(std::abs(crofton(box{{-1, -1, -1}, {1, 1, 1}}, 24, {0, 0, 0}, 1.75f, 12)) <= statistics::z_limit);
    CHECK(std::abs(crofton(box{{9, 0, -2}, {9, 3, 4}}, 36, {9, 1.5f, 1}, 3.5f, 13)) <= statistics::z_limit);
    CHECK(std::abs(crofton(box{{-5, 1, 1}, {5, 1.1f, 1.2f}}, 2 * (1 + 2 + 0.02), {0, 1, 1}, 5.1f, 14)) <= statistics::z_limit);
}

// ---- Step 3: a sphere around points --------------------------------------------------------------------------------

TEST_CASE("the sphere holds every point, after rounding", "[step3]") {
    INFO(hint("a few pixels are missing at the rim of things", "the center moves when it is rounded to float: measure the radius from the stored center, and round it up", "§3 Rounded upwards"));
    dice random(16);
    std::vector<cloud> all = clouds();
    for (int i = 0; i < 100; ++i) all.push_back(random.points(50, 1, 100.0f * random.vector()));
    for (const cloud& points : all) {
        const ball s = sphere_of_points(points);
        CAPTURE(points.size(), points[0], s.center, s.radius);
        REQUIRE(radius_needed(points, s.center) <= double(s.radius) * (1 + slack));
    }
}

TEST_CASE("the sphere is at most 1.3 times as large as the smallest", "[step3]") {
    INFO(hint("slow: spheres are far too large", "two points far apart give the first sphere; each point outside makes it as little larger as possible, and moves its center", "§3 Ritter's sphere"));
    for (const cloud& points : clouds()) {
        const ball s = sphere_of_points(points);
        CAPTURE(points, s.center, s.radius);
        REQUIRE(at_most(double(s.radius)) <= 1.3 * smallest_radius(points) + 1e-6);
    }
}

TEST_CASE("a crowd does not pull the sphere to its side", "[step3]") {
    INFO(hint("slow: where a mesh has many small triangles its sphere is twice too large", "the mean of the points is where most of them are, not the middle", "§3 Ritter's sphere"));
    dice random(17);
    for (int i = 0; i < 20; ++i) {
        const glm::vec3 here = random.vector(), there = here + 10.0f * random.direction();
        cloud points = random.points(500, 0.01f, here);
        points.push_back(there);
        const ball s = sphere_of_points(points);
        CAPTURE(here, there, s.center, s.radius);
        REQUIRE(std::abs(double(s.radius) - 5) <= 0.05);
        REQUIRE(radius_needed(points, s.center) <= double(s.radius) * (1 + slack));
    }
}

TEST_CASE("around nothing, around one point, around two", "[step3]") {
    INFO(hint("the program dies on an empty group; NaN", "no points: the empty sphere, radius -1; one: that point, radius 0", "§3 Ritter's sphere"));
    CHECK(sphere_of_points({}).radius < 0);
    const cloud one{{1, 2, 3}}, same{{1, 2, 3}, {1, 2, 3}}, two{{-1, 2, 3}, {3, 2, 3}};
    for (const cloud& points : {one, same}) {
        const ball s = sphere_of_points(points);
        CHECK(s.center == glm::vec3(1, 2, 3));
        CHECK(s.radius == 0);
    }
    const ball s = sphere_of_points(two);
    CHECK(glm::distance(s.center, {1, 2, 3}) <= 1e-6f);
    CHECK(s.radius == Approx(2));
}

TEST_CASE("the sphere grows with the scene and moves with it", "[step3]") {
    INFO(hint("small or distant things have wrong spheres", "no fixed epsilon, and no squares in float: (1e-25)² is 0 there", "§3 In double"));
    dice random(18);
    for (int i = 0; i < 20; ++i) {
        cloud points, moved;
        for (int k = 0; k < 30; ++k) {
            const glm::vec3 p = real(random.whole_in_cube(500));
            points.push_back(p);
            moved.push_back(p + glm::vec3(70000, -20000, 4096));
        }
        const ball s = sphere_of_points(points), far = sphere_of_points(moved);
        CAPTURE(s.center, s.radius, far.center, far.radius);
        REQUIRE(double(far.radius) == Approx(double(s.radius)).epsilon(1e-4));
        for (const float scale : {0x1p-90f, 0x1p90f}) {
            cloud scaled;
            for (const glm::vec3& p : points) scaled.push_back(scale * p);
            const ball other = sphere_of_points(scaled);
            CAPTURE(scale, other.center, other.radius);
            REQUIRE(double(other.radius) / double(scale) == Approx(double(s.radius)).epsilon(1e-5));
            REQUIRE(radius_needed(scaled, other.center) <= double(other.radius) * (1 + slack));
        }
    }
}

TEST_CASE("a sphere has the area 4πR²", "[step3]") {
    INFO(hint("volumes are compared wrongly: predictions do not come true", "4πR² in double; 0 for an empty sphere", "§3 The area"));
    CHECK(area(ball{{7, 7, 7}, 3}) == Approx(36 * std::numbers::pi));
    CHECK(area(ball{{7, 7, 7}, 0}) == 0);
    CHECK(area(ball{{7, 7, 7}, -1}) == 0);
    CHECK(area(ball{{0, 0, 0}, 1e25f}) == Approx(4e50 * std::numbers::pi));
}

// ---- Step 4: a ray and a sphere ------------------------------------------------------------------------------------

TEST_CASE("no sphere is lost by a ray that touches it", "[step4]") {
    INFO(hint("a few pixels are missing at the rim of things", "compute in double, compare with <=, and leave the last bits to neither side", "§4 The nearest point"));
    const mistakes m = mistakes_in(19, 20000, any_sphere);
    CAPTURE(m.shown, m.kept);
    CHECK(m.lost == 0);
}

TEST_CASE("no ray that passes the sphere at a distance is kept", "[step4]") {
    INFO(hint("slow: rays that miss the sphere are not sorted out", "only the stretch within the range counts: clamp the nearest t to it", "§4 The range"));
    const mistakes m = mistakes_in(20, 20000, any_sphere);
    CAPTURE(m.shown, m.lost);
    CHECK(m.kept == 0);
}

TEST_CASE("spheres behind the origin, beyond the range, around the origin", "[step4]") {
    INFO(hint("rays look at spheres in their back, or miss those that they start in", "the sphere is solid: it is met where the nearest point of the stretch lies in it", "§4 The range"));
    const ball s{{0, 0, 10}, 2};
    const ray r{{0, 0, 0}, {0, 0, 4}};  // within from t = 2 to t = 3
    CHECK(met(s, r, {}));
    CHECK_FALSE(met(s, {r.origin, -r.direction}, {}));
    CHECK(met(s, {r.origin, -r.direction}, {-10, 0}));
    CHECK_FALSE(met(s, r, {0, 1.99f}));
    CHECK(met(s, r, {0, 2.01f}));
    CHECK_FALSE(met(s, r, {3.01f, inf}));
    CHECK(met(s, r, {2.4f, 2.6f}));  // all of it inside
    CHECK(met(s, {{0, 0, 10}, {1, 0, 0}}, {}));
    CHECK(met(s, {{0, 0, 11.9f}, {0, 0, 1}}, {}));
    CHECK_FALSE(met(s, {{0, 0, 12.1f}, {0, 0, 1}}, {}));
}

TEST_CASE("an empty range meets no sphere", "[step4]") {
    INFO(hint("rays look at spheres beyond the point where they were stopped", "where the range ends before it begins there is no t to clamp: ask that first",
              "§4 The range"));
    const ball s{{0, 0, 10}, 2};
    const ray r{{0, 0, 0}, {0, 0, 4}};
    CHECK_FALSE(met(s, r, {2.6f, 2.4f}));
}

TEST_CASE("an empty sphere is never met, a single point is", "[step4]") {
    INFO(hint("an empty group costs as much as the whole scene", "a negative radius is no radius, though its square is positive", "§4 The nearest point"));
    CHECK_FALSE(met(ball{{0, 0, 0}, -1}, {{0, 0, 5}, {0, 0, -1}}, {}));
    CHECK_FALSE(met(ball{{0, 0, 0}, -9}, {{0, 0, 5}, {0, 0, -1}}, {}));
    CHECK(met(ball{{0, 0, 0}, 0}, {{0, 0, 5}, {0, 0, -1}}, {}));
    CHECK_FALSE(met(ball{{0, 0, 0}, 0}, {{0, 0.1f, 5}, {0, 0, -1}}, {}));
}

TEST_CASE("what a surface in the sphere hits at the very end of the range is not lost", "[step4]") {
    INFO(hint("of two surfaces in one place the wrong one is seen, depending on what else there is",
              "the surface's t is rounded to float before it is compared with the range; the sphere must allow for that", "§4 The range"));
    dice random(21);
    for (int i = 0; i < 2000; ++i) {
        const ball s{random.vector(), random.between(0.2f, 1)};
        const glm::vec3 origin = s.center + 6.0f * random.direction(), direction = s.center + 0.8f * s.radius * random.direction() - origin;
        const glm::dvec3 d(direction), f = glm::dvec3(origin) - glm::dvec3(s.center);
        const double a = glm::dot(d, d), b = glm::dot(d, f), root = std::sqrt(b * b - a * (glm::dot(f, f) - double(s.radius) * double(s.radius)));
        const float enters = float((-b - root) / a), leaves = float((-b + root) / a);  // the surface of the sphere itself, say
        CAPTURE(s.center, s.radius, origin, direction, enters, leaves);
        REQUIRE(met(s, {origin, direction}, {0, enters}));
        REQUIRE(met(s, {origin, direction}, {std::nextafter(leaves, 0.0f), inf}));
    }
}

TEST_CASE("a sphere far away is met where it is", "[step4]") {
    INFO(hint("far things vanish, or are torn", "float has seven digits, and 10000² - 1 needs eight: compute in double", "§4 The nearest point"));
    dice random(22);
    int inside = 0, outside = 0;
    for (int i = 0; i < 2000; ++i) {
        const ball s{random.vector(), 1};
        const glm::vec3 origin = s.center + 10000.0f * random.direction(), direction = s.center + 2.0f * random.vector() - origin;
        const glm::dvec3 to = glm::dvec3(s.center) - glm::dvec3(origin);
        const double distance = glm::length(glm::cross(to, glm::dvec3(direction))) / glm::length(glm::dvec3(direction));
        CAPTURE(s.center, origin, direction, distance);
        if (distance < 1 - 1e-6) ++inside;
        if (distance < 1 - 1e-6) REQUIRE(met(s, {origin, direction}, {}));
        if (distance > 1.2) ++outside;
        if (distance > 1.2) REQUIRE_FALSE(met(s, {origin, direction}, {}));
    }
    CHECK((inside > 100 && outside > 100));
}

TEST_CASE("spheres as small as an atom or as large as a galaxy, directions of any length", "[step4]") {
    INFO(hint("small things are missing", "a fixed number such as 1e-6 does not know how large the scene is; divide by d·d", "§4 The nearest point"));
    const auto [scene, length] = GENERATE(std::pair(0x1p-60f, 1.0f), std::pair(0x1p40f, 1.0f), std::pair(1.0f, 0x1p-50f), std::pair(0x1p-30f, 0x1p30f));
    INFO("scene := " << scene << ", length := " << length);
    const mistakes m = mistakes_in(23, 4000, any_sphere, scene, length);
    CAPTURE(m.shown);
    CHECK(m.lost == 0);
    CHECK(m.kept == 0);
}

TEST_CASE("of all lines a sphere meets as many as its area says", "[step4]") {
    INFO(hint("some rays are lost, or kept, that nobody has thought of", "Crofton: of all lines that meet a ball, the share area / (4πR²) meets a convex body in it", "§2 Crofton's formula"));
    CHECK(std::abs(crofton(ball{{3, 2, 1}, 0.6f}, 4 * std::numbers::pi * 0.36, {3, 2, 1}, 1, 24)) <= statistics::z_limit);
    CHECK(std::abs(crofton(ball{{3, 2, 1}, 1}, 4 * std::numbers::pi, {2, 1, 1}, 2.5f, 25)) <= statistics::z_limit);
}

// ---- Step 5: an oriented box around points -------------------------------------------------------------------------

namespace {

/// The box has, in some order, these axes (up to their sign), each with this half extent.
bool same_box(const tilted& b, glm::dvec3 center, const glm::dmat3& axes, glm::dvec3 half, double tolerance) {
    if (!(glm::distance(glm::dvec3(b.center), center) <= tolerance)) return false;
    for (int i = 0; i < 3; ++i) {
        bool found = false;
        for (std::size_t k = 0; k < 3; ++k)
            found = found || (std::abs(glm::dot(axes[i], glm::dvec3(b.axes[k]))) >= 1 - 1e-5 && std::abs(half[i] - double(b.half[int(k)])) <= tolerance);
        if (!found) return false;
    }
    return true;
}

}  // namespace

TEST_CASE("the oriented box holds every point, after rounding", "[step5]") {
    INFO(hint("a few pixels are missing at the edges of things", "center and axes move when they are rounded to float: measure each half from the stored ones, and round it up",
              "§5 Rounded outwards"));
    dice random(26);
    std::vector<cloud> all = clouds();
    for (int i = 0; i < 100; ++i) all.push_back(random.points(50, 1, 100.0f * random.vector()));
    for (const cloud& points : all) {
        const tilted b = oriented_box_of_points(points);
        const double size = glm::length(glm::dvec3(b.half)) + radius_needed(points, b.center);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            CAPTURE(points.size(), points[0], b.center, axis, b.axes[axis], b.half);
            REQUIRE(half_needed(points, b, axis) <= double(b.half[int(axis)]) + slack * size);
        }
    }
}

TEST_CASE("the axes have length 1 and are perpendicular", "[step5]") {
    INFO(hint("boxes are skew or grow out of all proportion", "an eigenvector has a direction; its length is not the eigenvalue", "§5 Principal axes"));
    for (const cloud& points : clouds()) {
        const tilted b = oriented_box_of_points(points);
        for (std::size_t i = 0; i < 3; ++i) {
            CAPTURE(points, b.axes[i]);
            REQUIRE(std::abs(glm::length(glm::dvec3(b.axes[i])) - 1) <= 1e-6);
            REQUIRE(std::abs(glm::dot(glm::dvec3(b.axes[i]), glm::dvec3(b.axes[(i + 1) % 3]))) <= 1e-6);
        }
    }
}

TEST_CASE("every face touches a point", "[step5]") {
    INFO(hint("slow: oriented boxes are too large", "the center is in the middle between the first and the last point along each axis; half is half of the way between these two",
              "§5 The middle"));
    dice random(27);
    for (int i = 0; i < 100; ++i) {
        const cloud points = random.points(30, 1, 3.0f * random.vector());
        const tilted b = oriented_box_of_points(points);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            double lower = inf, upper = -inf;
            for (const glm::dvec3 p : points) {
                const double along = glm::dot(glm::dvec3(b.axes[axis]), p - glm::dvec3(b.center));
                lower = std::min(lower, along), upper = std::max(upper, along);
            }
            CAPTURE(b.center, b.axes[axis], b.half, lower, upper);
            REQUIRE(at_most(std::abs(double(b.half[int(axis)]) - upper)) <= 1e-5);
            REQUIRE(at_most(std::abs(double(b.half[int(axis)]) + lower)) <= 1e-5);
        }
    }
}

TEST_CASE("the corners of a tilted box give the box back", "[step5]") {
    INFO(hint("oriented boxes are no better than boxes", "the eigenvectors of the covariance: the sum of (p - mean)(p - mean)ᵀ", "§5 Principal axes"));
    dice random(28);
    for (int i = 0; i < 100; ++i) {
        const glm::dmat3 axes = random.turn();
        const glm::dvec3 half{random.between(0.1f, 0.5f), random.between(0.8f, 1.2f), random.between(2, 5)};
        const cloud points = corners(glm::dvec3(0), axes, half);
        const tilted b = oriented_box_of_points(points);
        CAPTURE(axes[0], axes[1], axes[2], half, b.center, b.axes[0], b.axes[1], b.axes[2], b.half);
        REQUIRE(same_box(b, glm::dvec3(0), axes, half, 1e-5));
    }
}

TEST_CASE("wherever it stands", "[step5]") {
    INFO(hint("boxes of distant things point to the origin", "the mean must be subtracted before squares are summed", "§5 Principal axes"));
    dice random(29);
    for (int i = 0; i < 50; ++i) {
        const glm::dmat3 axes = random.turn();
        const glm::dvec3 half{0.3, 1, 3}, center = 50.0 * glm::dvec3(random.direction());
        const tilted b = oriented_box_of_points(corners(center, axes, half));
        CAPTURE(axes[0], axes[1], axes[2], center, b.center, b.axes[0], b.axes[1], b.axes[2], b.half);
        REQUIRE(same_box(b, center, axes, half, 1e-4));
    }
}

TEST_CASE("a crowd at one end makes the oriented box no longer", "[step5]") {
    INFO(hint("slow: where a mesh has many small triangles its box sticks out at the other end", "the mean is where most points are, not the middle", "§5 The middle"));
    dice random(30);
    for (int i = 0; i < 50; ++i) {
        const glm::dmat3 axes = random.turn();
        const glm::dvec3 half{0.3, 1, 3};
        cloud points = corners(glm::dvec3(1, 2, 3), axes, half);
        const cloud ends = points;
        for (int k = 0; k < 5; ++k)  // the four corners at one end, again and again: the axes stay the same
            for (const std::size_t corner : {4u, 5u, 6u, 7u}) points.push_back(ends[corner]);
        const tilted b = oriented_box_of_points(points);
        CAPTURE(axes[0], axes[1], axes[2], b.center, b.axes[0], b.axes[1], b.axes[2], b.half);
        REQUIRE(same_box(b, {1, 2, 3}, axes, half, 1e-5));
    }
}

TEST_CASE("nothing, a point, a line and a plane have oriented boxes, too", "[step5]") {
    INFO(hint("NaN, or the program dies", "no points: half = -1; where points have no extent, half is 0 or as small as rounding makes it", "§5 Rounded outwards"));
    const tilted none = oriented_box_of_points({});
    CHECK_FALSE((none.half.x >= 0 && none.half.y >= 0 && none.half.z >= 0));
    const tilted point = oriented_box_of_points(cloud{{1, 2, 3}});
    CHECK(point.half == glm::vec3(0));
    CHECK(point.center == glm::vec3(1, 2, 3));
    cloud line, plane;
    for (int i = 0; i <= 10; ++i) {
        line.push_back({float(i), float(2 * i), float(-2 * i)});
        for (int k = 0; k <= 4; ++k) plane.push_back({float(i), float(k), float(i - 2 * k)});
    }
    const glm::vec3 of_line = oriented_box_of_points(line).half, of_plane = oriented_box_of_points(plane).half;
    CAPTURE(of_line, of_plane);
    CHECK(std::max({of_line.x, of_line.y, of_line.z}) == Approx(15));
    CHECK(of_line.x + of_line.y + of_line.z <= 15.0001f);
    CHECK(std::min({of_plane.x, of_plane.y, of_plane.z}) <= 1e-5f);
    CHECK(std::min({of_plane.x, of_plane.y, of_plane.z}) >= 0);
}

TEST_CASE("an oriented box has the area of a box of the same extents", "[step5]") {
    INFO(hint("volumes are compared wrongly: predictions do not come true", "the extents are twice the halves: 8 (xy + yz + zx); 0 for an empty box", "§5 Principal axes"));
    tilted b{{1, 2, 3}, {{{0.6f, 0.8f, 0}, {-0.8f, 0.6f, 0}, {0, 0, 1}}}, {1, 2, 3}};
    CHECK(area(b) == Approx(8 * (1 * 2 + 2 * 3 + 3 * 1)));
    b.half = {5, 0, 7};
    CHECK(area(b) == Approx(280));
    b.half = {5, -1, 7};
    CHECK(area(b) == 0);
    b.half = glm::vec3(1e25f);
    CHECK(area(b) == Approx(24e50));
}

// ---- Step 6: a ray and an oriented box -----------------------------------------------------------------------------

namespace {

tilted tilted_box(const glm::dvec3& center, const glm::dmat3& axes, const glm::dvec3& half) {
    return {glm::vec3(center), {{glm::vec3(axes[0]), glm::vec3(axes[1]), glm::vec3(axes[2])}}, glm::vec3(half)};
}

/// Whether the ray meets the box with its halves made larger by `more`.
bool meets_larger(const tilted& b, const ray& r, double more) {
    double near = 0, far = inf;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 axis(b.axes[i]);
        const double o = glm::dot(axis, glm::dvec3(r.origin) - glm::dvec3(b.center)), d = glm::dot(axis, glm::dvec3(r.direction));
        const double reach = double(b.half[int(i)]) + more, one = (-reach - o) / d, other = (reach - o) / d;
        near = std::max(near, std::min(one, other));
        far = std::min(far, std::max(one, other));
    }
    return near <= far;
}

}  // namespace

TEST_CASE("a ray meets a tilted box where its points are", "[step6]") {
    INFO(hint("boxes are met where they are not", "the ray's origin, seen from the center, and its direction are measured along the axes: both of them", "§6 Into its frame"));
    dice random(31);
    int within = 0;
    for (int i = 0; i < 4000; ++i) {
        const glm::dvec3 half{random.between(0.1f, 2), random.between(0.1f, 2), random.between(0.1f, 2)};
        const tilted b = tilted_box(3.0 * glm::dvec3(random.vector()), random.turn(), half);
        const glm::vec3 origin = b.center + random.between(0, 9) * random.direction(), aim = b.center + 2.0f * random.vector();
        const ray r{origin, random.between(0.2f, 4) * (aim - origin)};
        CAPTURE(b.center, b.axes[0], b.axes[1], b.axes[2], b.half, r.origin, r.direction);
        if (meets_larger(b, r, -1e-5)) {
            ++within;
            REQUIRE(met(b, r, {}));
        } else if (!meets_larger(b, r, 1e-4)) {
            REQUIRE_FALSE(met(b, r, {}));
        }
    }
    CHECK((within > 1000 && within < 3500));
}

TEST_CASE("no oriented box is lost by a ray that touches it", "[step6]") {
    INFO(hint("cracks at the edges of boxes", "as for boxes along the axes: 0 and -0, flat boxes, origins in a face, all of it in double", "§6 Into its frame"));
    const mistakes m = mistakes_in(32, 20000, any_tilted);
    CAPTURE(m.shown);
    CHECK(m.lost == 0);
    CHECK(m.kept == 0);
}

TEST_CASE("behind the origin and beyond the range there is no oriented box", "[step6]") {
    INFO(hint("rays look at boxes in their back", "t is the same in both frames, so the range is, too", "§6 The range"));
    const float s = std::sqrt(0.5f);
    const tilted b{{0, 0, 10}, {{{s, 0, s}, {0, 1, 0}, {-s, 0, s}}}, {1, 1, 1}};  // stands on its edge: from 10 - √2 to 10 + √2
    const ray r{{0, 0.5f, 0}, {0, 0, 2}};
    CHECK(met(b, r, {}));
    CHECK_FALSE(met(b, {r.origin, -r.direction}, {}));
    CHECK_FALSE(met(b, r, {0, 4.28f}));
    CHECK(met(b, r, {0, 4.31f}));
    CHECK_FALSE(met(b, r, {5.72f, inf}));
    CHECK(met(b, r, {5.69f, inf}));
    CHECK(met(b, {{0, 0, 10}, {1, 1, 1}}, {}));
}

TEST_CASE("what lies in a tilted plane is not lost", "[step6]") {
    INFO(hint("thin plates have holes", "the products with the axes are rounded, and the plate is thinner than that: move the faces outwards by 2^-40 of the numbers involved",
              "§6 Rounding"));
    dice random(33);
    std::vector<question> asked;
    for (int i = 0; i < 300; ++i) {
        // A grid of whole numbers in a plane, and the box around it along the plane's own directions.
        const whole corner = random.whole_in_cube(40), u = random.whole_in_cube(9), v = random.whole_in_cube(9);
        const glm::dvec3 along(real(u)), across(real(v)), up = glm::cross(along, across);
        if (glm::length(up) < 1) continue;
        cloud points;
        for (std::int64_t k = 0; k <= 4; ++k)
            for (std::int64_t l = 0; l <= 4; ++l) points.push_back(real(corner + k * u + l * v));
        const glm::dvec3 x = glm::normalize(along), z = glm::normalize(up);
        tilted b = tilted_box(glm::dvec3(real(corner)) + 2.0 * (along + across), {x, glm::cross(z, x), z}, {0, 0, 0});
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double needed = half_needed(points, b, axis) * (1 + 1e-15) + 1e-15;
            const float nearest = float(needed);
            b.half[int(axis)] = double(nearest) < needed ? std::nextafter(nearest, inf) : nearest;
        }
        for (int k = 0; k < 100; ++k) {
            const whole d = random.one_in(2) ? random.whole_between(-3, 3) * u + random.whole_between(-3, 3) * v + random.whole_in_cube(1)
                                             : random.whole_between(-3, 3) * u + random.whole_between(-3, 3) * v;
            if (d == whole(0)) continue;
            const glm::vec3 p = points[std::size_t(random.whole_between(0, 24))], step = real(d);
            asked.push_back({b, {p - float(random.whole_between(1, 50)) * step, step}, {}});
        }
    }
    const std::vector<bool> said = meets(asked);
    CHECK(said.size() == asked.size());
    CHECK(std::count(said.begin(), said.end(), false) == 0);
}

TEST_CASE("an empty oriented box is never met", "[step6]") {
    INFO(hint("an empty group costs as much as the whole scene", "a negative half: no point is in it", "§6 Into its frame"));
    dice random(34);
    for (int i = 0; i < 50; ++i) {
        const ray r{random.vector(), random.vector()};
        const auto axes = tilted_box(glm::dvec3(0), random.turn(), {-1, -1, -1}).axes;
        CAPTURE(r.origin, r.direction);
        REQUIRE_FALSE(met(tilted{{0, 0, 0}, axes, {-1, -1, -1}}, r, {-inf, inf}));
        REQUIRE_FALSE(met(tilted{{0, 0, 0}, axes, {9, 9, -0.5f}}, r, {-inf, inf}));
    }
}

TEST_CASE("oriented boxes as small as an atom or as large as a galaxy, directions of any length", "[step6]") {
    INFO(hint("small things are missing", "room for rounding has to grow and shrink with the scene", "§6 Rounding"));
    const auto [scene, length] = GENERATE(std::pair(0x1p-60f, 1.0f), std::pair(0x1p40f, 1.0f), std::pair(1.0f, 0x1p-50f), std::pair(0x1p-30f, 0x1p30f));
    INFO("scene := " << scene << ", length := " << length);
    const mistakes m = mistakes_in(35, 4000, any_tilted, scene, length);
    CAPTURE(m.shown);
    CHECK(m.lost == 0);
    CHECK(m.kept == 0);
}

TEST_CASE("of all lines an oriented box meets as many as its area says", "[step6]") {
    INFO(hint("some rays are lost, or kept, that nobody has thought of", "Crofton: of all lines that meet a ball, the share area / (4πR²) meets a convex body in it", "§2 Crofton's formula"));
    dice random(36);
    const glm::dmat3 turn = random.turn();
    CHECK(std::abs(crofton(tilted_box({1, 2, 3}, turn, {1, 0.6, 0.3}), 8 * (0.6 + 0.18 + 0.3), {1, 2, 3}, 1.25f, 37)) <= statistics::z_limit);
    CHECK(std::abs(crofton(tilted_box({1, 2, 3}, turn, {1, 0.7, 0}), 8 * 0.7, {1, 2, 3}, 1.25f, 38)) <= statistics::z_limit);
}

// ---- Step 7: volumes around what is transformed --------------------------------------------------------------------

namespace {

/// Any linear map: turned, stretched, and turned again; sometimes mirrored, sometimes flattened.
struct map {
    glm::mat3 m;
    double stretch;                ///< the most it stretches anything, but for rounding
    glm::dvec3 stretched;          ///< the direction that it stretches so
};
map any_map(dice& random) {
    const glm::dmat3 first = random.turn(), second = random.turn();
    glm::dvec3 s{random.between(2, 3), random.between(-1.5f, 1.5f), random.between(0.1f, 1)};
    if (random.one_in(5)) s.z = 0;
    if (random.one_in(5)) s.y = s.z = 0;
    const glm::dmat3 scale(glm::dvec3(s.x, 0, 0), glm::dvec3(0, s.y, 0), glm::dvec3(0, 0, s.z));
    return {glm::mat3(second * scale * glm::transpose(first)), s.x, first[0]};
}

glm::dvec3 carried(const glm::mat3& m, glm::vec3 shift, const glm::dvec3& p) {
    return glm::dmat3(m) * p + glm::dvec3(shift);
}

/// Where the eight corners of the box arrive: the exact extents, but for the rounding of double.
std::pair<glm::dvec3, glm::dvec3> extents(const glm::mat3& m, glm::vec3 shift, const box& b) {
    glm::dvec3 lower(inf), upper(-inf);
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 p = carried(m, shift, glm::dvec3(i & 1 ? b.max.x : b.min.x, i & 2 ? b.max.y : b.min.y, i & 4 ? b.max.z : b.min.z));
        lower = glm::min(lower, p), upper = glm::max(upper, p);
    }
    return {lower, upper};
}

}  // namespace

TEST_CASE("the box of a turned box holds all its corners", "[step7]") {
    INFO(hint("things are cut off as soon as they are turned", "min and max are two corners of eight, and after a turn they are no longer the outermost", "§7 A turned box"));
    dice random(39);
    for (int i = 0; i < 500; ++i) {
        const map a = any_map(random);
        const glm::vec3 shift = 10.0f * random.vector(), lower = random.vector(), size = random.vector() + 1.0f;
        const box b{lower, lower + (i % 6 == 0 ? glm::vec3(0, size.y, size.z) : size)}, around = transformed_box(a.m, shift, b);
        const auto [least, most] = extents(a.m, shift, b);
        CAPTURE(a.m[0], a.m[1], a.m[2], shift, b.min, b.max, around.min, around.max, least, most);
        for (int axis = 0; axis < 3; ++axis) {
            REQUIRE(double(around.min[axis]) <= least[axis] + slack * 20);
            REQUIRE(double(around.max[axis]) >= most[axis] - slack * 20);
        }
    }
}

TEST_CASE("the box of a turned box is no larger than it must be", "[step7]") {
    INFO(hint("slow: boxes of transformed things are too large", "each face touches one of the eight corners", "§7 A turned box"));
    dice random(40);
    for (int i = 0; i < 500; ++i) {
        const map a = any_map(random);
        const glm::vec3 shift = 10.0f * random.vector(), lower = random.vector();
        const box b{lower, lower + random.vector() + 1.0f}, around = transformed_box(a.m, shift, b);
        const auto [least, most] = extents(a.m, shift, b);
        CAPTURE(a.m[0], a.m[1], a.m[2], shift, b.min, b.max, around.min, around.max, least, most);
        for (int axis = 0; axis < 3; ++axis) {
            REQUIRE(at_most(std::abs(double(around.min[axis]) - least[axis])) <= 5e-6);
            REQUIRE(at_most(std::abs(double(around.max[axis]) - most[axis])) <= 5e-6);
        }
    }
}

TEST_CASE("moved, mirrored and stretched boxes are what they are", "[step7]") {
    INFO(hint("mirrored things vanish", "a negative entry makes the largest out of the smallest: take min and max of both products", "§7 A turned box"));
    const box b{{1, 2, 3}, {2, 4, 6}};
    const box same = transformed_box(glm::mat3(1), {0, 0, 0}, b), moved = transformed_box(glm::mat3(1), {10, 20, 30}, b);
    const box mirrored = transformed_box(glm::mat3(-1, 0, 0, 0, 1, 0, 0, 0, 2), {0, 0, 0}, b);
    const box swapped = transformed_box(glm::mat3(0, 1, 0, 1, 0, 0, 0, 0, 1), {0, 0, 0}, b);
    CHECK((same.min == b.min && same.max == b.max));
    CHECK((moved.min == glm::vec3(11, 22, 33) && moved.max == glm::vec3(12, 24, 36)));
    CHECK((mirrored.min == glm::vec3(-2, 2, 6) && mirrored.max == glm::vec3(-1, 4, 12)));
    CHECK((swapped.min == glm::vec3(2, 1, 3) && swapped.max == glm::vec3(4, 2, 6)));
    // The columns of glm::mat3 are where the axes go: sheared along x by y.
    const box sheared = transformed_box(glm::mat3(1, 0, 0, 2, 1, 0, 0, 0, 1), {0, 0, 0}, b);
    CHECK((sheared.min == glm::vec3(5, 2, 3) && sheared.max == glm::vec3(10, 4, 6)));
}

TEST_CASE("nothing stays nothing, however it is transformed", "[step7]") {
    INFO(hint("an empty group is everywhere after it was turned", "0 · infinity is NaN: an empty volume is its own transformed one", "§7 A turned box"));
    dice random(41);
    for (int i = 0; i < 50; ++i) {
        const map a = any_map(random);
        CAPTURE(a.m[0], a.m[1], a.m[2]);
        REQUIRE(nothing(transformed_box(a.m, {1, 2, 3}, {glm::vec3(inf), glm::vec3(-inf)})));
        REQUIRE(nothing(transformed_box(a.m, {1, 2, 3}, {{1, 1, 1}, {0, 2, 2}})));
        REQUIRE(transformed_sphere(a.m, {1, 2, 3}, {{0, 0, 0}, -1}).radius < 0);
    }
    CHECK(nothing(transformed_box(glm::mat3(1), {1, 2, 3}, {glm::vec3(inf), glm::vec3(-inf)})));
}

TEST_CASE("the sphere of a transformed sphere holds all of it", "[step7]") {
    INFO(hint("stretched spheres are cut off", "the longest column of m is not the most that m stretches: that is the root of the largest eigenvalue of mᵀm", "§7 A stretched sphere"));
    dice random(42);
    for (int i = 0; i < 500; ++i) {
        const map a = any_map(random);
        const glm::vec3 shift = 10.0f * random.vector();
        const ball s{3.0f * random.vector(), i % 8 == 0 ? 0.0f : random.between(0.01f, 2)}, around = transformed_sphere(a.m, shift, s);
        CAPTURE(a.m[0], a.m[1], a.m[2], a.stretch, shift, s.center, s.radius, around.center, around.radius);
        for (const double side : {1.0, -1.0}) {
            const glm::dvec3 farthest = carried(a.m, shift, glm::dvec3(s.center) + side * double(s.radius) * a.stretched);
            REQUIRE(at_most(glm::distance(farthest, glm::dvec3(around.center))) <= double(around.radius) + slack * 50);
        }
        for (int k = 0; k < 20; ++k) {
            const glm::dvec3 p = carried(a.m, shift, glm::dvec3(s.center) + double(s.radius) * glm::normalize(glm::dvec3(random.direction())));
            REQUIRE(at_most(glm::distance(p, glm::dvec3(around.center))) <= double(around.radius) + slack * 50);
        }
    }
}

TEST_CASE("the sphere of a transformed sphere is no larger than it must be", "[step7]") {
    INFO(hint("slow: spheres grow as soon as they are turned", "a turn stretches nothing; a stretch by s multiplies the radius by s, not by the sum of what it does to all axes", "§7 A stretched sphere"));
    dice random(43);
    for (int i = 0; i < 300; ++i) {
        const map a = any_map(random);
        const ball s{random.vector(), random.between(0.5f, 2)}, around = transformed_sphere(a.m, {1, 2, 3}, s);
        CAPTURE(a.m[0], a.m[1], a.m[2], a.stretch, s.center, s.radius, around.center, around.radius);
        REQUIRE(at_most(double(around.radius)) <= a.stretch * double(s.radius) + 1e-5);
        const ball turned = transformed_sphere(glm::mat3(random.turn()), {1, 2, 3}, s);
        REQUIRE(at_most(double(turned.radius)) <= double(s.radius) + 1e-5);
    }
}

// ---- Step 8: the bounded surface -----------------------------------------------------------------------------------

namespace {

/// A surface with hits at certain t, behind volumes that say yes where they are told to; counts who is asked.
struct scenario {
    std::vector<bool> volumes_say;
    std::vector<float> hits_at;
    std::vector<interval> volume_asked{}, surface_asked{};
    std::vector<ray> rays{};

    std::optional<lantern::hit> ask(ray r, interval range) {
        const volume_says volume = [this](std::uint32_t i, ray asked, interval over) {
            volume_asked.push_back(over);
            rays.push_back(asked);
            return i < volumes_say.size() && volumes_say[i];
        };
        const surface_says surface = [this](ray asked, interval over) -> std::optional<lantern::hit> {
            surface_asked.push_back(over);
            rays.push_back(asked);
            for (const float t : hits_at)
                if (contains(over, t)) return hit_at(t);
            return std::nullopt;
        };
        return volumes_say.size() == 1 ? behind_one(volume, surface, r, range) : behind_two(volume, surface, r, range);
    }
    static lantern::hit hit_at(float t) { return {.t = t, .point = {t, 2, 3}, .normal = {0, 0.6f, 0.8f}, .error = 0.125f}; }
};

bool same(const std::optional<lantern::hit>& a, const lantern::hit& b) {
    return a && a->t == b.t && a->point == b.point && a->normal == b.normal && a->error == b.error;
}

}  // namespace

TEST_CASE("the hit is the surface's, bit for bit", "[step8]") {
    INFO(hint("things look different as soon as they are bounded", "the volume only says whether the surface is asked: the hit is the surface's, all of it", "§8 Transparent"));
    scenario one{{true}, {2.5f, 7}};
    CHECK(same(one.ask({{1, 2, 3}, {0, 0, -1}}, {}), scenario::hit_at(2.5f)));
    CHECK(same(one.ask({{1, 2, 3}, {0, 0, -1}}, {3, 9}), scenario::hit_at(7)));
}

TEST_CASE("where the volume is missed the surface is not asked", "[step8]") {
    INFO(hint("right pictures, and no faster than before", "the volume comes first; when it says no, the answer is std::nullopt at once", "§8 First the volume"));
    scenario missed{{false}, {2.5f}};
    CHECK_FALSE(missed.ask({{1, 2, 3}, {0, 0, -1}}, {}));
    CHECK(missed.surface_asked.empty());
    CHECK(missed.volume_asked.size() == 1);
}

TEST_CASE("meeting the volume is not yet a hit", "[step8]") {
    INFO(hint("things look like their boxes", "when the surface finds nothing there is nothing", "§8 Transparent"));
    scenario nothing_there{{true}, {}};
    CHECK_FALSE(nothing_there.ask({{1, 2, 3}, {0, 0, -1}}, {}));
    CHECK(nothing_there.surface_asked.size() == 1);
    CHECK(nothing_there.volume_asked.size() == 1);
}

TEST_CASE("volume and surface are asked for the range that was asked for, along the ray that was shot", "[step8]") {
    INFO(hint("things behind a light cast shadows, or what is behind a hit is searched again", "pass the range on, unchanged, to both", "§8 The range"));
    scenario s{{true}, {2.5f, 7}};
    CHECK_FALSE(s.ask({{1, 2, 3}, {0, 0.5f, -1}}, {3, 6}));
    REQUIRE(s.volume_asked.size() == 1);
    REQUIRE(s.surface_asked.size() == 1);
    CHECK((s.volume_asked[0].min == 3 && s.volume_asked[0].max == 6));
    CHECK((s.surface_asked[0].min == 3 && s.surface_asked[0].max == 6));
    for (const ray& r : s.rays) CHECK((r.origin == glm::vec3(1, 2, 3) && r.direction == glm::vec3(0, 0.5f, -1)));
}

TEST_CASE("a bounded surface is a surface, and may be bounded again", "[step8]") {
    INFO(hint("groups of groups go wrong", "the outer volume first, then the inner one, then the surface; each only when the one before says yes", "§8 First the volume"));
    for (const bool outer : {false, true})
        for (const bool inner : {false, true}) {
            scenario s{{outer, inner}, {2.5f}};
            const auto found = s.ask({{1, 2, 3}, {0, 0, -1}}, {1, 5});
            CAPTURE(outer, inner);
            CHECK(s.volume_asked.size() == (outer ? 2 : 1));
            CHECK(s.surface_asked.size() == (outer && inner ? 1 : 0));
            CHECK(same(found, scenario::hit_at(2.5f)) == (outer && inner));
        }
}

TEST_CASE("a ball in a box: the same picture, and as few tests as the areas say", "[step8]") {
    INFO(hint("the volume saves nothing", "of all rays that meet a box, π / 6 of them meet the ball that fills it: nobody else may be asked", "§8 What it saves"));
    // Volume and surface are the suite's: the cube around a ball of radius 1, by Crofton met by 24 / (4π 4) of the lines through a
    // ball of radius 2; and the ball by 1 / 4 of them. False alarm: once in a million for each of the two counts.
    dice random(44);
    constexpr int count = 5000;
    int asked = 0, hits = 0;
    const volume_says cube = [](std::uint32_t, ray r, interval) {
        double near = 0, far = inf;
        for (int i = 0; i < 3; ++i) {
            const double one = (-1 - double(r.origin[i])) / double(r.direction[i]), other = (1 - double(r.origin[i])) / double(r.direction[i]);
            near = std::max(near, std::min(one, other));
            far = std::min(far, std::max(one, other));
        }
        return near <= far;
    };
    const auto unbounded = [](ray r, interval range) -> std::optional<lantern::hit> {
        const glm::dvec3 o(r.origin), d(r.direction);
        const double a = glm::dot(d, d), b = glm::dot(o, d), discriminant = b * b - a * (glm::dot(o, o) - 1);
        if (!(discriminant >= 0)) return std::nullopt;
        const float t = float((-b - std::sqrt(discriminant)) / a);
        if (!contains(range, t)) return std::nullopt;
        return lantern::hit{.t = t, .point = glm::vec3(o + double(t) * d), .normal = glm::vec3(o + double(t) * d)};
    };
    const surface_says counted = [&](ray r, interval range) {
        ++asked;
        return unbounded(r, range);
    };
    for (int i = 0; i < count; ++i) {
        const ray r = random.line({0, 0, 0}, 2);
        const auto bare = unbounded(r, {}), found = behind_one(cube, counted, r, {});
        CAPTURE(r.origin, r.direction);
        REQUIRE(found.has_value() == bare.has_value());
        if (bare) REQUIRE(same(found, *bare));
        hits += found.has_value();
    }
    const auto z = [](int seen, double p) { return std::abs(seen - count * p) / std::sqrt(count * p * (1 - p)); };
    CAPTURE(asked, hits);
    CHECK(z(asked, 24 / (16 * std::numbers::pi)) <= statistics::z_limit);
    CHECK(z(hits, 0.25) <= statistics::z_limit);
}

// ---- Step 9: the smallest sphere -----------------------------------------------------------------------------------

TEST_CASE("no smaller sphere holds the points", "[step9]") {
    INFO(hint("the sphere is a little too large", "a point that is outside lies on the surface of the next sphere: go through the points before it again, with it fixed there",
              "§9 Welzl's sphere"));
    for (const cloud& points : clouds()) {
        const ball s = smallest_sphere_of_points(points);
        CAPTURE(points, s.center, s.radius);
        REQUIRE(at_most(double(s.radius)) <= smallest_radius(points) * (1 + 1e-6) + 1e-6);
    }
}

TEST_CASE("the smallest sphere holds every point, after rounding", "[step9]") {
    INFO(hint("a few pixels are missing at the rim of things", "measure the radius from the stored center, and round it up", "§3 Rounded upwards"));
    dice random(45);
    std::vector<cloud> all = clouds();
    for (int i = 0; i < 100; ++i) all.push_back(random.points(50, 1, 100.0f * random.vector()));
    for (const cloud& points : all) {
        const ball s = smallest_sphere_of_points(points);
        CAPTURE(points.size(), points[0], s.center, s.radius);
        REQUIRE(radius_needed(points, s.center) <= double(s.radius) * (1 + slack));
    }
}

TEST_CASE("known ones: a cube, a tetrahedron, a triangle with an obtuse angle", "[step9]") {
    INFO(hint("the sphere goes through points that do not matter", "the smallest sphere is given by two, three or four points: not always by as many as possible", "§9 Welzl's sphere"));
    const double cube = double(smallest_sphere_of_points(corners({1, 2, 3}, glm::dmat3(1), {1, 1, 1})).radius);
    CHECK(cube == Approx(std::sqrt(3.0)));
    const double tetrahedron = double(smallest_sphere_of_points(cloud{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}).radius);
    CHECK(tetrahedron == Approx(std::sqrt(3.0)));
    const ball obtuse = smallest_sphere_of_points(cloud{{-3, 0, 0}, {3, 0, 0}, {0, 1, 0}});
    CHECK(obtuse.radius == Approx(3));
    CHECK(glm::length(obtuse.center) <= 1e-5f);
    const ball equal = smallest_sphere_of_points(cloud{{0, 0, 0}, {2, 0, 0}, {1, std::sqrt(3.0f), 0}});
    CHECK(equal.radius == Approx(2 / std::sqrt(3.0)));
}

TEST_CASE("nothing, one point, many in one place, many in line", "[step9]") {
    INFO(hint("the program dies, or NaN", "no points: the empty sphere; and nothing may be divided by a distance of 0", "§9 Welzl's sphere"));
    CHECK(smallest_sphere_of_points({}).radius < 0);
    const ball one = smallest_sphere_of_points(cloud{{1, 2, 3}}), same_place = smallest_sphere_of_points(cloud(40, glm::vec3(1, 2, 3)));
    CHECK((one.center == glm::vec3(1, 2, 3) && one.radius == 0));
    CHECK((same_place.center == glm::vec3(1, 2, 3) && same_place.radius == 0));
    cloud line;
    for (int i = 0; i <= 40; ++i) line.push_back({float(i), float(2 * i), float(-2 * i)});
    CHECK(smallest_sphere_of_points(line).radius == Approx(60));
    cloud twice = corners({0, 0, 0}, glm::dmat3(1), {1, 2, 2});
    twice.insert(twice.end(), twice.begin(), twice.begin() + 8);
    CHECK(smallest_sphere_of_points(twice).radius == Approx(3));
}

TEST_CASE("whatever the order of the points", "[step9]") {
    INFO(hint("the sphere depends on the order of the points", "every point that is outside starts the search among those before it again", "§9 Welzl's sphere"));
    dice random(46);
    for (int i = 0; i < 20; ++i) {
        cloud points = random.points(200, 1);
        const ball first = smallest_sphere_of_points(points);
        std::sort(points.begin(), points.end(), [](const glm::vec3& a, const glm::vec3& b) { return a.x < b.x; });
        const ball sorted = smallest_sphere_of_points(points);
        std::reverse(points.begin(), points.end());
        const ball reversed = smallest_sphere_of_points(points);
        CAPTURE(first.center, first.radius, sorted.center, sorted.radius, reversed.center, reversed.radius);
        REQUIRE(double(sorted.radius) == Approx(double(first.radius)).epsilon(1e-6));
        REQUIRE(double(reversed.radius) == Approx(double(first.radius)).epsilon(1e-6));
    }
}
