// SPDX-License-Identifier: MIT
// A bounding volume holds what it is said to hold: measured in double, without a tolerance.

#include "laws.hpp"

#include <numbers>

namespace stress {

namespace {

bool holds(const box& b, const glm::dvec3& lo, const glm::dvec3& hi) {
    for (int k = 0; k < 3; ++k)
        if (!(double(b.min[k]) <= lo[k] && hi[k] <= double(b.max[k]))) return false;
    return true;
}

/// Points in a cloud, in line, in a plane, all equal, far from the origin.
std::vector<glm::vec3> cloud(dice& d) {
    const std::uint32_t kind = d.below(5), count = kind == 3 ? 1 + d.below(5) : 2 + d.below(60);
    const glm::vec3 at = d.magnitude_between(-3, 5) * d.in_cube(), u = d.magnitude_between(-4, 2) * d.in_cube(), v = d.magnitude_between(-4, 2) * d.in_cube();
    std::vector<glm::vec3> points;
    for (std::uint32_t k = 0; k < count; ++k) {
        if (kind == 0) points.push_back(at + d.in_cube());
        if (kind == 1) points.push_back(at + d.between(-1, 1) * u);
        if (kind == 2) points.push_back(at + d.between(-1, 1) * u + d.between(-1, 1) * v);
        if (kind == 3) points.push_back(at);
        if (kind == 4) points.push_back(d.magnitude_between(-20, 15) * d.in_cube());
    }
    return points;
}

/// v turned about a unit axis.
glm::dvec3 turned(const glm::dvec3& v, const glm::dvec3& k, double angle) {
    return std::cos(angle) * v + std::sin(angle) * glm::cross(k, v) + (1 - std::cos(angle)) * glm::dot(k, v) * k;
}

}  // namespace

void add_bounds(std::vector<test_case>& cases) {
    const std::string margin = "none: a box that is too small loses hits";
    add(cases, "boxes/around-a-sphere", "center ± radius rounded outwards", "directed rounding", margin, [](const answers& a) { return a.box_around_sphere; },
        [](const answers& a, score& s, std::uint32_t i) {
            dice d = dice_of(i, 300);
            for (int k = 0; k < 16; ++k) {
                const ball b{d.magnitude_between(-6, 6) * d.in_cube(), d.magnitude_between(-12, 6)};
                const box around = a.box_around_sphere(b);
                // The sums of two floats are exact in double, unless they are 2^29 apart: then a step outwards is due anyway.
                s.check(holds(around, glm::dvec3(b.center) - double(b.radius), glm::dvec3(b.center) + double(b.radius)), "too small, around" + shown({b.center, glm::vec3(b.radius)}));
            }
        });
    add(cases, "boxes/ball-around-points", "points in a cloud, in line, in a plane, all equal, far away", "Welzl 1991; inflate when rounding", margin,
        [](const answers& a) { return a.ball_around; }, [](const answers& a, score& s, std::uint32_t i) {
            dice d = dice_of(i, 301);
            const auto points = cloud(d);
            const ball b = a.ball_around(points);
            bool all = true;
            for (const glm::vec3 p : points) all = all && glm::length(glm::dvec3(p) - glm::dvec3(b.center)) <= double(b.radius);
            s.check(all, "a point is outside");
        });
    add(cases, "boxes/oriented-around-points", "the same, in a turned box", "inflate when rounding", margin, [](const answers& a) { return a.oriented_box_around; },
        [](const answers& a, score& s, std::uint32_t i) {
            dice d = dice_of(i, 302);
            const auto points = cloud(d);
            const oriented_box b = a.oriented_box_around(points);
            bool all = true;
            for (const glm::vec3 p : points)
                for (int k = 0; k < 3; ++k)
                    all = all && std::abs(glm::dot(glm::dvec3(b.axes[std::size_t(k)]), glm::dvec3(p) - glm::dvec3(b.center))) <= double(b.half[k]);
            s.check(all, "a point is outside");
        });
    add(cases, "camera/box-of-what-moves", "a moving sphere's box holds it all the time", "the union of both ends, rounded outwards", margin,
        [](const answers& a) { return a.box_around_moving; }, [](const answers& a, score& s, std::uint32_t i) {
            dice d = dice_of(i, 303);
            const ball b{d.in_cube(5), d.magnitude_between(-3, 1)};
            const glm::vec3 way = d.magnitude_between(-7, 4) * d.in_cube();
            const box around = a.box_around_moving(b, way);
            bool all = true;
            for (int k = 0; k <= 16; ++k) {
                const glm::dvec3 c = glm::dvec3(b.center) + k / 16.0 * glm::dvec3(way);
                all = all && holds(around, c - double(b.radius), c + double(b.radius));
            }
            s.check(all, "it leaves its box:" + shown({b.center, way}));
        });
    add(cases, "camera/box-of-what-turns", "a sphere on its way around an axis stays in its box", "an arc bulges beyond its ends by R(1 - cos(angle/2))",
        margin, [](const answers& a) { return a.box_around_turning; }, [](const answers& a, score& s, std::uint32_t i) {
            dice d = dice_of(i, 304);
            const ball b{d.in_cube(5), d.magnitude_between(-4, 0)};
            const glm::vec3 axis = d.in_cube();
            const float angle = d.between(-7, 7);
            const box around = a.box_around_turning(b, axis, angle);
            const glm::dvec3 k = glm::normalize(glm::dvec3(axis));
            bool all = true;
            for (int step = 0; step <= 64; ++step) {
                const glm::dvec3 c = turned(glm::dvec3(b.center), k, step / 64.0 * double(angle)), radius(double(b.radius) * (1 - 1e-12));
                all = all && holds(around, c - radius, c + radius);
            }
            s.check(all, "it leaves its box:" + shown({b.center, axis, glm::vec3(angle)}));
        });
}

}  // namespace stress
