// SPDX-License-Identifier: MIT
// Lab 09's hidden tests: the laws of the public suite, for points, volumes and rays drawn anew for each grading. Where there is one
// right answer it is the solution's. None is a matter of chance: rays that touch are made of whole numbers, as in the public suite.

#include "truth.hpp"

#include <catch.hpp>
#include <hidden.hpp>

#include <lab09_bounding_volumes/bounding_volumes.hpp>

#include <numbers>

using namespace contract::lab09;
using namespace truth;

namespace {

bool close(double a, double b, double relative) { return std::abs(a - b) <= relative * std::abs(b); }

/// Somewhere, of some size: all orders of magnitude alike.
cloud any_cloud(dice& random, int most) {
    const float size = hidden::magnitude(random, 1e-3f, 1e3f);
    return random.points(1 + int(random.whole_between(0, most - 1)), size, 3 * size * random.vector());
}

tilted any_tilted_box(dice& random) {
    const glm::dmat3 axes = random.turn();
    const float x = random.between(0.1f, 2), y = random.between(0.1f, 2);
    return {3.0f * random.vector(), {{glm::vec3(axes[0]), glm::vec3(axes[1]), glm::vec3(axes[2])}}, {x, y, random.between(0.1f, 2)}};
}

/// Nothing is lost and nothing is kept, in a world of any size, with directions of any length.
template <class Make>
mistakes anywhere(std::uint64_t test, const Make& make) {
    dice random(hidden::seed(test));
    const float scene = std::ldexp(1.0f, int(random.whole_between(-40, 30))), length = std::ldexp(1.0f, int(random.whole_between(-30, 20)));
    return mistakes_in(hidden::seed(test + 100), 4000, make, scene, length);
}

/// The points lie behind the ray's end but for rounding, so a volume around them must be met.
question up_to(const volume& v, glm::vec3 origin, glm::vec3 direction, float t, bool from) {
    return {v, {origin, direction}, from ? interval{std::nextafter(t, 0.0f), inf} : interval{0, t}};
}

}  // namespace

TEST_CASE("any box around anything", "[step1]") {
    dice random(hidden::seed(1));
    for (int i = 0; i < 200; ++i) {
        const cloud points = any_cloud(random, 30);
        const auto middle = points.begin() + std::ptrdiff_t(hidden::below(random, std::uint32_t(points.size() + 1)));
        const auto ours = [](const cloud& some) {
            const lab09::box b = lab09::box_around(some);
            return box{b.min, b.max};
        };
        const box whole_box = ours(points), asked = box_of_points(points), both = box_of_boxes(ours({points.begin(), middle}), ours({middle, points.end()}));
        CHECK((asked.min == whole_box.min && asked.max == whole_box.max));
        CHECK((both.min == whole_box.min && both.max == whole_box.max));
        const lab09::sphere s{points[0], hidden::magnitude(random, 1e-3f, 10)};
        const box around = box_of_sphere({s.center, s.radius});
        const lab09::box of_sphere = box_around(s);
        CHECK((around.min == of_sphere.min && around.max == of_sphere.max));
        CHECK(close(area(whole_box), surface_area(lab09::box{whole_box.min, whole_box.max}), 1e-5));
    }
}

TEST_CASE("any ray and any box", "[step2]") {
    const mistakes m = anywhere(2, any_box);
    CHECK(m.lost == 0);
    CHECK(m.kept == 0);
}

TEST_CASE("any wall at the end of the range", "[step2]") {
    dice random(hidden::seed(3));
    std::vector<question> asked;
    while (asked.size() < 500) {
        const glm::vec3 aim = random.vector(), origin = 5.0f * random.direction(), direction = random.between(0.3f, 3) * (aim - origin);
        const int axis = int(random.whole_between(0, 2));
        box wall{glm::vec3(-2), glm::vec3(2)};
        wall.min[axis] = wall.max[axis] = aim[axis];
        const auto t = float((double(aim[axis]) - double(origin[axis])) / double(direction[axis]));
        if (!(t > 0 && t < 4)) continue;
        asked.push_back(up_to(wall, origin, direction, t, random.one_in(2)));
    }
    const std::vector<bool> said = meets(asked);
    CHECK(std::count(said.begin(), said.end(), true) == 500);
}

TEST_CASE("any sphere around points", "[step3]") {
    dice random(hidden::seed(4));
    hidden::agreement small_enough;  // Ritter's is not proved to be below 1.3 for every cloud
    for (int i = 0; i < 100; ++i) {
        const cloud points = any_cloud(random, 12);
        const ball s = sphere_of_points(points);
        CHECK(radius_needed(points, s.center) <= double(s.radius) * (1 + slack));
        small_enough.count(at_most(double(s.radius)) <= 1.3 * smallest_radius(points) * (1 + 1e-6));
        CHECK(close(area(s), 4 * std::numbers::pi * double(s.radius) * double(s.radius), 1e-5));
    }
    CHECK(small_enough.holds());
}

TEST_CASE("any ray and any sphere", "[step4]") {
    const mistakes m = anywhere(5, any_sphere);
    CHECK(m.lost == 0);
    CHECK(m.kept == 0);
}

TEST_CASE("any sphere at the end of the range", "[step4]") {
    dice random(hidden::seed(6));
    std::vector<question> asked;
    for (int i = 0; i < 500; ++i) {
        const ball s{random.vector(), random.between(0.2f, 1)};
        const glm::vec3 origin = s.center + 6.0f * random.direction(), direction = s.center + 0.8f * s.radius * random.direction() - origin;
        const glm::dvec3 d(direction), f = glm::dvec3(origin) - glm::dvec3(s.center);
        const double a = glm::dot(d, d), b = glm::dot(d, f), root = std::sqrt(b * b - a * (glm::dot(f, f) - double(s.radius) * double(s.radius)));
        const bool from = random.one_in(2);
        asked.push_back(up_to(s, origin, direction, float((from ? root - b : -root - b) / a), from));
    }
    const std::vector<bool> said = meets(asked);
    CHECK(std::count(said.begin(), said.end(), true) == 500);
}

TEST_CASE("any oriented box around points", "[step5]") {
    dice random(hidden::seed(7));
    for (int i = 0; i < 60; ++i) {
        // The corners of a box whose sides differ: its axes are the principal ones, and no others.
        const glm::dmat3 axes = random.turn();
        const glm::dvec3 half{random.between(0.1f, 0.5f), random.between(0.8f, 1.2f), random.between(2, 4)}, center = 20.0 * glm::dvec3(random.vector());
        const cloud points = corners(center, axes, half);
        const tilted b = oriented_box_of_points(points);
        CHECK(glm::distance(glm::dvec3(b.center), center) <= 1e-4);
        for (int k = 0; k < 3; ++k) {
            bool found = false;
            for (std::size_t n = 0; n < 3; ++n)
                found = found || (std::abs(glm::dot(axes[k], glm::dvec3(b.axes[n]))) >= 1 - 1e-5 && std::abs(half[k] - double(b.half[int(n)])) <= 1e-4);
            CHECK(found);
        }
        const cloud others = any_cloud(random, 40);
        const tilted around = oriented_box_of_points(others);
        const double size = glm::length(glm::dvec3(around.half)) + radius_needed(others, around.center);
        for (std::size_t n = 0; n < 3; ++n) CHECK(half_needed(others, around, n) <= double(around.half[int(n)]) + slack * size);
        const tilted any = any_tilted_box(random);
        const glm::dvec3 h(any.half);
        CHECK(close(area(any), 8 * (h.x * h.y + h.y * h.z + h.z * h.x), 1e-5));
    }
}

TEST_CASE("any ray and any oriented box", "[step6]") {
    const mistakes m = anywhere(8, any_tilted);
    CHECK(m.lost == 0);
    CHECK(m.kept == 0);
}

TEST_CASE("any ray and any box that is turned", "[step6]") {
    dice random(hidden::seed(9));
    std::vector<question> asked;
    std::vector<bool> right;
    while (asked.size() < 2000) {
        tilted b = any_tilted_box(random);
        const glm::vec3 origin = b.center + random.between(0, 9) * random.direction(), aim = b.center + 2.0f * random.vector();
        const ray r{origin, random.between(0.2f, 4) * (aim - origin)};
        const auto met = [&](float more) { return overlaps(lab09::oriented_box{b.center, b.axes, b.half + more}, r, {}); };
        if (met(-1e-5f) != met(1e-4f)) continue;  // so near that it may be told either way
        right.push_back(met(0));
        asked.push_back({b, r, {}});
    }
    CHECK(meets(asked) == right);
}

TEST_CASE("anything transformed", "[step7]") {
    dice random(hidden::seed(10));
    for (int i = 0; i < 200; ++i) {
        // Turned, stretched and turned again: so it is known what is stretched the most.
        const glm::dmat3 first = random.turn(), second = random.turn();
        const double most = random.between(1, 3);
        const glm::dmat3 stretch(glm::dvec3(most, 0, 0), glm::dvec3(0, most * double(random.between(-0.9f, 0.9f)), 0), glm::dvec3(0, 0, most * double(random.between(0, 0.9f))));
        const glm::mat3 m(second * stretch * glm::transpose(first));
        const glm::vec3 shift = 10.0f * random.vector(), lower = random.vector(), size = random.vector() + 1.0f;
        const auto carried = [&](const glm::dvec3& p) { return glm::dmat3(m) * p + glm::dvec3(shift); };

        const box b{lower, lower + size}, around = transformed_box(m, shift, b);
        glm::dvec3 least(inf), largest(-inf);
        for (int k = 0; k < 8; ++k) {
            const glm::dvec3 corner = carried({k & 1 ? b.max.x : b.min.x, k & 2 ? b.max.y : b.min.y, k & 4 ? b.max.z : b.min.z});
            least = glm::min(least, corner), largest = glm::max(largest, corner);
        }
        for (int axis = 0; axis < 3; ++axis) {
            CHECK((double(around.min[axis]) <= least[axis] + 20 * slack && double(around.min[axis]) >= least[axis] - 5e-6));
            CHECK((double(around.max[axis]) >= largest[axis] - 20 * slack && double(around.max[axis]) <= largest[axis] + 5e-6));
        }

        const ball s{random.vector(), random.between(0.1f, 2)}, turned = transformed_sphere(m, shift, s);
        CHECK(at_most(double(turned.radius)) <= most * double(s.radius) + 1e-5);
        for (const double side : {1.0, -1.0}) {
            const glm::dvec3 farthest = carried(glm::dvec3(s.center) + side * double(s.radius) * first[0]);
            CHECK(at_most(glm::distance(farthest, glm::dvec3(turned.center))) <= double(turned.radius) + 50 * slack);
        }
    }
}

TEST_CASE("anything bounded, once or twice", "[step8]") {
    dice random(hidden::seed(11));
    for (int i = 0; i < 100; ++i) {
        const bool twice = random.one_in(2), outer = random.one_in(2), inner = !twice || random.one_in(2);
        const ray r{random.vector(), random.vector()};
        const interval range{random.between(0, 1), random.between(2, 5)};
        const lantern::hit at{.t = random.between(0, 5), .point = random.vector(), .normal = random.direction(), .error = random.unit()};
        std::vector<std::uint32_t> volumes;
        int surfaces = 0;
        bool as_it_was = true;
        const auto same = [&](const ray& along, interval over) {
            as_it_was = as_it_was && along.origin == r.origin && along.direction == r.direction && over.min == range.min && over.max == range.max;
        };
        const volume_says volume = [&](std::uint32_t number, ray along, interval over) {
            same(along, over);
            volumes.push_back(number);
            return number == 0 ? outer : inner;
        };
        const surface_says surface = [&](ray along, interval over) {
            same(along, over);
            ++surfaces;
            return contains(over, at.t) ? std::optional(at) : std::nullopt;
        };
        const auto found = twice ? behind_two(volume, surface, r, range) : behind_one(volume, surface, r, range);
        CHECK(as_it_was);
        CHECK(volumes == (twice && outer ? std::vector<std::uint32_t>{0, 1} : std::vector<std::uint32_t>{0}));
        CHECK(surfaces == (outer && inner ? 1 : 0));
        REQUIRE(found.has_value() == (outer && inner && contains(range, at.t)));
        if (found) CHECK((found->t == at.t && found->point == at.point && found->normal == at.normal && found->error == at.error));
    }
}

TEST_CASE("the smallest of any spheres", "[step9]") {
    dice random(hidden::seed(12));
    for (int i = 0; i < 60; ++i) {
        cloud points = any_cloud(random, 12);
        if (random.one_in(3)) points.insert(points.end(), points.begin(), points.end());  // some twice
        const ball s = smallest_sphere_of_points(points);
        CHECK(radius_needed(points, s.center) <= double(s.radius) * (1 + slack));
        const double smallest = smallest_radius(points);
        double size = 0;  // that float can tell: the center is rounded
        for (const glm::dvec3 p : points) size = std::max(size, glm::length(p));
        CHECK(at_most(double(s.radius)) <= smallest * (1 + 1e-6) + 1e-6 * size);
    }
}
