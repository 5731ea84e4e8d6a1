// SPDX-License-Identifier: MIT
#include <lantern/bounding_sphere.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

using lantern::bounding_sphere;
using lantern::hull;
using lantern::hull_of;
using lantern::quick_sphere;
using lantern::smallest_sphere;

namespace {

bool holds(const bounding_sphere& s, const hull& h) {
    return std::all_of(h.points.begin(), h.points.end(), [&](const glm::dvec3& p) {
        const wide3 from{wide(p.x) - wide(s.center.x), wide(p.y) - wide(s.center.y), wide(p.z) - wide(s.center.z)};
        return length(from) + wide(h.radius) <= wide(s.radius);
    });
}

/// The smallest sphere is through two, three or four of the points: try all.
double by_trying_all(const std::vector<glm::dvec3>& p) {
    double least = lantern::infinity;
    const auto consider = [&](std::vector<glm::dvec3> on) {
        const auto b = lantern::precise::sphere_through(on);
        if (b.radius < 0 || b.radius >= least) return;
        for (const auto& q : p)
            if (glm::length(q - b.center) > b.radius * (1 + 1e-9)) return;
        least = b.radius;
    };
    for (std::size_t i = 0; i < p.size(); ++i)
        for (std::size_t j = i + 1; j < p.size(); ++j) {
            consider({p[i], p[j]});
            for (std::size_t k = j + 1; k < p.size(); ++k) {
                consider({p[i], p[j], p[k]});
                for (std::size_t l = k + 1; l < p.size(); ++l) consider({p[i], p[j], p[k], p[l]});
            }
        }
    return least;
}

hull random_points(dice& d, std::uint32_t count, double half = 1) {
    hull h;
    for (std::uint32_t i = 0; i < count; ++i) h.points.emplace_back(d.in_cube(half));
    return h;
}

}  // namespace

TEST_CASE("the smallest sphere is known: one point, two, a triangle, a tetrahedron, a cube") {
    CHECK(smallest_sphere({{glm::dvec3(1, 2, 3)}, 0}).radius == 0);
    const bounding_sphere two = smallest_sphere({{glm::dvec3(0, 0, 0), glm::dvec3(4, 0, 0)}, 0});
    CHECK(two.center == glm::vec3(2, 0, 0));
    CHECK(two.radius == Approx(2));
    const hull obtuse{{glm::dvec3(0, 0, 0), glm::dvec3(4, 0, 0), glm::dvec3(1, 0.5, 0)}, 0};
    CHECK(smallest_sphere(obtuse).radius == Approx(2));  // the third point does not matter
    const hull tetrahedron{{glm::dvec3(1, 1, 1), glm::dvec3(1, -1, -1), glm::dvec3(-1, 1, -1), glm::dvec3(-1, -1, 1)}, 0};
    CHECK(smallest_sphere(tetrahedron).radius == Approx(std::sqrt(3.0)));
    CHECK(smallest_sphere(hull_of(lantern::aabb{glm::vec3(-1), glm::vec3(1)})).radius == Approx(std::sqrt(3.0)));
    CHECK(smallest_sphere({{glm::dvec3(0, 0, 0), glm::dvec3(4, 0, 0)}, 1.5}).radius == Approx(3.5));
    CHECK(empty(smallest_sphere({})));
    CHECK(empty(quick_sphere({})));
}

TEST_CASE("no sphere through two, three or four points is smaller") {
    dice d{.state = 1};
    for (int i = 0; i < 200; ++i) {
        const hull h = random_points(d, 2 + d.below(9), d.magnitude_between(-6, 6));
        REQUIRE(double(smallest_sphere(h).radius) == Approx(by_trying_all(h.points)).epsilon(1e-6));
    }
}

TEST_CASE("both hold all the points, and the quick one is at most a quarter larger") {
    dice d{.state = 2};
    double worst = 0;
    for (int i = 0; i < 400; ++i) {
        hull h = random_points(d, 1 + d.below(60), d.magnitude_between(-15, 15));
        const glm::dvec3 far(d.in_cube(d.magnitude_between(-10, 18)));
        for (auto& p : h.points) p = glm::dvec3(glm::vec3(p + far));
        if (i % 3 == 0) h.radius = d.magnitude_between(-12, 12);
        if (i % 4 == 0)
            for (auto& p : h.points) p.y = p.x;  // in a plane
        const bounding_sphere small = smallest_sphere(h), quick = quick_sphere(h);
        REQUIRE(holds(small, h));
        REQUIRE(holds(quick, h));
        REQUIRE(small.radius <= quick.radius * (1 + 1e-5f) + 1e-6f * glm::length(quick.center));
        if (glm::length(far) < 1e-3) worst = std::max(worst, double(quick.radius) / double(small.radius));
    }
    INFO("at worst " << worst);
    CHECK(worst < 1.25);
}

TEST_CASE("points that are equal, in line, on one sphere, or a hundred thousand") {
    const hull same{std::vector<glm::dvec3>(100000, glm::dvec3(1, 2, 3)), 0};
    CHECK(smallest_sphere(same).radius == 0);
    hull line, shell, many;
    dice d{.state = 3};
    for (int i = 0; i < 20000; ++i) {
        line.points.push_back(double(i) * glm::dvec3(1, 1, 1));
        shell.points.push_back(3.0 * d.on_sphere());
        many.points.emplace_back(d.in_cube());
    }
    CHECK(smallest_sphere(line).radius == Approx(19999 * std::sqrt(3.0) / 2));
    CHECK(smallest_sphere(shell).radius == Approx(3));
    CHECK(holds(smallest_sphere(shell), shell));
    CHECK(holds(smallest_sphere(many), many));
    CHECK(smallest_sphere(many).radius <= quick_sphere(many).radius);
}

TEST_CASE("points of a coarse lattice, of which many lie in one plane, in line or on one sphere, have a smallest sphere all the same") {
    dice d{7};
    for (int i = 0; i < 20'000; ++i) {
        hull h;
        for (std::uint32_t k = 2 + d.below(10); k > 0; --k) h.points.emplace_back(d.below(4), d.below(4), i % 3 == 0 ? 0 : d.below(4));
        const bounding_sphere s = smallest_sphere(h);
        REQUIRE_FALSE(empty(s));
        REQUIRE(holds(s, h));
        REQUIRE(s.radius <= quick_sphere(h).radius * 1.000001f);
    }
}

TEST_CASE("spheres are enclosed: two exactly, many well") {
    const bounding_sphere a{{0, 0, 0}, 1}, b{{5, 0, 0}, 2}, within{{0.5f, 0, 0}, 0.25f};
    CHECK(enclose(a, b).radius == Approx(4));
    CHECK(enclose(a, b).center.x == Approx(3));
    CHECK(enclose(a, within).radius == Approx(1));
    CHECK(enclose(a, bounding_sphere{}).radius == a.radius);
    CHECK(empty(enclose(bounding_sphere{}, bounding_sphere{})));
    dice d{.state = 4};
    for (int i = 0; i < 300; ++i) {
        std::vector<bounding_sphere> group;
        hull all;
        for (std::uint32_t k = d.below(30) + 1; k > 0; --k) group.push_back({d.in_cube(10), d.magnitude_between(-3, 1)});
        const bounding_sphere around = enclose(std::span<const bounding_sphere>(group));
        for (const auto& s : group) REQUIRE(holds(around, hull_of(s)));
        REQUIRE(around.radius < 40);
    }
}

TEST_CASE("a sphere of NaN is empty; contains and bounds") {
    const float bad = std::numeric_limits<float>::quiet_NaN();
    CHECK(empty(bounding_sphere{{bad, 0, 0}, 1}));
    CHECK(empty(bounding_sphere{{0, 0, 0}, bad}));
    const bounding_sphere s{{1, 0, 0}, 2};
    CHECK(contains(s, glm::dvec3(3, 0, 0)));
    CHECK_FALSE(contains(s, glm::dvec3(3.0001, 0, 0)));
    CHECK(bounds(s).min == glm::vec3(-1, -2, -2));
    CHECK(empty(bounds(bounding_sphere{})));
    CHECK(surface_area(s) == Approx(16 * 3.14159265));
}

TEST_CASE("a bounding sphere seems larger by what rounding may have moved, and no more") {
    const bounding_sphere near{{0, 0, 0}, 1}, far{{0x1p20f, 0, 0}, 1};
    const auto beside = [](float x, float by) { return lantern::ray{{x, 1 + by, 0}, {1, 0, 0}}; };  // runs above it
    CHECK(overlaps(near, beside(-0x1p20f, 0x1p-21f), {}));
    CHECK_FALSE(overlaps(near, beside(-0x1p20f, 0x1p-17f), {}));
    CHECK(overlaps(far, beside(0, 0x1p-21f), {}));
    CHECK_FALSE(overlaps(far, beside(0, 0x1p-17f), {}));
    CHECK_FALSE(overlaps(near, beside(-2, 0x1p-23f), {}));
}
