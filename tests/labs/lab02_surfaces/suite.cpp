// SPDX-License-Identifier: MIT
// Lab 02: where a ray meets a sphere, a plane, a triangle, and which of many it meets first.

#include "contract.hpp"

#include <catch.hpp>
#include <hint.hpp>
#include <numbers.hpp>

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <vector>

using namespace contract::lab02;
using lantern::interval;
using lantern::ray;

namespace {

/// How far apart two points or vectors are; NaN when either is.
double apart(glm::vec3 a, glm::dvec3 b) { return glm::length(glm::dvec3(a) - b); }

glm::dvec3 along(const ray& r, double t) { return glm::dvec3(r.origin) + t * glm::dvec3(r.direction); }

}  // namespace

// ---- Step 1: the sphere --------------------------------------------------------------------------------------------

TEST_CASE("a ray towards the centre hits where the sphere begins", "[step1]") {
    INFO(hint("the sphere is missing, or one sees its back", "of the two solutions the smaller t comes first", "§1 Two solutions"));
    const auto h = intersect_sphere({0, 0, 0}, 1, {{0, 0, 5}, {0, 0, -1}}, {});
    REQUIRE(h);
    CHECK(h->t == Approx(4));
    CHECK(apart(h->point, {0, 0, 1}) <= 1e-6);
    CHECK(apart(h->normal, {0, 0, 1}) <= 1e-6);
}

TEST_CASE("a ray that passes the sphere misses it", "[step1]") {
    INFO(hint("everything is sphere, or NaN", "a negative discriminant means that there is no solution", "§1 Two solutions"));
    CHECK_FALSE(intersect_sphere({0, 0, 0}, 1, {{0, 1.01f, 5}, {0, 0, -1}}, {}));
    CHECK_FALSE(intersect_sphere({7, 0, 0}, 1, {{0, 0, 5}, {0, 0, -1}}, {}));
    CHECK(intersect_sphere({0, 0, 0}, 1, {{0, 0.99f, 5}, {0, 0, -1}}, {}));
}

TEST_CASE("a sphere behind the ray is not hit", "[step1]") {
    INFO(hint("things behind the eye show up in front of it", "a solution counts only when its t lies in the range", "§1 The range"));
    CHECK_FALSE(intersect_sphere({0, 0, 0}, 1, {{0, 0, 5}, {0, 0, 1}}, {}));
}

TEST_CASE("from inside the ray hits the far side, and the normal still points outwards", "[step1]") {
    INFO(hint("glass spheres are empty, or lit from the wrong side",
              "when the first solution is not in the range, try the second; do not turn the normal", "§1 The range"));
    const auto h = intersect_sphere({1, 2, 3}, 2, {{1, 2, 3}, {0, 0, -1}}, {});
    REQUIRE(h);
    CHECK(h->t == Approx(2));
    CHECK(apart(h->normal, {0, 0, -1}) <= 1e-6);
}

TEST_CASE("the length of the direction changes nothing but the unit of t", "[step1]") {
    INFO(hint("spheres swell or vanish when the direction is not normalised", "a = d · d is left out of the quadratic equation",
              "§1 The equation"));
    const float length = GENERATE(0.001f, 0.3f, 7.0f, 500.0f);
    CAPTURE(length);
    const glm::vec3 direction = glm::normalize(glm::vec3(0.1f, 0.05f, -1));
    const auto once = intersect_sphere({0, 0, 0}, 1, {{0, 0, 5}, direction}, {});
    const auto scaled = intersect_sphere({0, 0, 0}, 1, {{0, 0, 5}, length * direction}, {});
    REQUIRE(once);
    REQUIRE(scaled);
    CHECK(scaled->t * length == Approx(once->t).epsilon(1e-5));
    CHECK(apart(scaled->point, once->point) <= 1e-5);
}

TEST_CASE("a hit lies on the sphere and on the ray, and its normal points away from the centre", "[step1]") {
    INFO(hint("shading is wrong, or shadows have dots", "normal = (point - centre) / radius, of length 1", "§1 The normal"));
    numbers random(1);
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 center = 3.0f * random.vector();
        const float radius = random.between(0.2f, 2);
        const glm::vec3 origin = center + (radius + random.between(0.5f, 5)) * random.direction();
        const ray r{origin, random.between(0.5f, 3) * (center + 0.9f * radius * random.direction() - origin)};
        const auto h = intersect_sphere(center, radius, r, {});
        CAPTURE(i, center, radius, r.origin, r.direction);
        REQUIRE(h);
        REQUIRE(std::abs(apart(h->point, center) - radius) <= 1e-5);
        REQUIRE(apart(h->point, along(r, h->t)) <= 1e-5);
        REQUIRE(apart(h->normal, (glm::dvec3(h->point) - glm::dvec3(center)) / double(radius)) <= 1e-4);
        REQUIRE(std::abs(glm::length(h->normal) - 1) <= 1e-5f);
    }
}

TEST_CASE("a solution outside the range does not count", "[step1]") {
    INFO(hint("shadow rays find what lies behind the light", "ask contains(range, t) for each solution", "§1 The range"));
    const ray r{{0, 0, 5}, {0, 0, -1}};  // solutions at t = 4 and t = 6
    const auto second = intersect_sphere({0, 0, 0}, 1, r, {4.5f, 100});
    REQUIRE(second);
    CHECK(second->t == Approx(6));
    CHECK_FALSE(intersect_sphere({0, 0, 0}, 1, r, {0, 3.9f}));
    CHECK_FALSE(intersect_sphere({0, 0, 0}, 1, r, {4.5f, 5.5f}));
    CHECK_FALSE(intersect_sphere({0, 0, 0}, 1, r, {6.5f, 100}));
}

TEST_CASE("the world may be as small as a grain of sand or as large as a country", "[step1]") {
    INFO(hint("small things are missing", "a fixed number such as 0.001 or 1e-8 does not know how large the scene is", "§1 The range"));
    const float scale = GENERATE(1e-5f, 1.0f, 1e5f);
    INFO("scale := " << scale);
    const auto h = intersect_sphere({0, 0, 0}, scale, {{0, 0, 5 * scale}, {0, 0, -1}}, {});
    REQUIRE(h);
    CHECK(h->t == Approx(4 * scale).epsilon(1e-5));
}

TEST_CASE("a sphere far away is hit at its surface, not at its middle", "[step1]") {
    INFO(hint("far spheres are flat, torn, or missing",
              "float has seven digits, and 100000² - 1 needs ten: compute in double and round once at the end", "§1 In double"));
    const auto h = intersect_sphere({0, 0, 0}, 1, {{0, 0, 1e5f}, {0, 0, -1}}, {});
    REQUIRE(h);
    CHECK(std::abs(h->t - 99999) <= 0.01f);
    CHECK_FALSE(intersect_sphere({0, 0, 0}, 1, {{0, 1.1f, 1e5f}, {0, 0, -1}}, {}));
}

// ---- Step 2: the plane ---------------------------------------------------------------------------------------------

TEST_CASE("a ray straight down hits the floor at its height", "[step2]") {
    INFO(hint("the floor is missing or at the wrong height", "t = n·(q - o) / n·d: check the signs", "§2 The plane"));
    const auto h = intersect_plane({3, 1, 3}, {0, 1, 0}, {{0, 5, 0}, {0, -1, 0}}, {});
    REQUIRE(h);
    CHECK(h->t == Approx(4));
    CHECK(apart(h->point, {0, 1, 0}) <= 1e-6);
    CHECK(apart(h->normal, {0, 1, 0}) <= 1e-6);
}

TEST_CASE("a hit lies on the plane and on the ray", "[step2]") {
    INFO(hint("the floor is bent or slanted", "t = n·(q - o) / n·d: check the signs", "§2 The plane"));
    numbers random(2);
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 point = random.vector(), normal = random.between(0.1f, 4) * random.direction();
        const glm::vec3 origin = 5.0f * random.vector();
        // A point of the plane to aim at.
        const glm::vec3 aim = point + glm::cross(normal, random.vector());
        const ray r{origin, aim - origin};
        if (std::abs(glm::dot(glm::normalize(normal), glm::normalize(r.direction))) < 0.05f) continue;
        const auto h = intersect_plane(point, normal, r, {});
        CAPTURE(i, point, normal, r.origin, r.direction);
        REQUIRE(h);
        REQUIRE(std::abs(h->t - 1) <= 1e-4f);
        REQUIRE(apart(h->point, aim) <= 1e-4);
        REQUIRE(apart(h->normal, glm::normalize(glm::dvec3(normal))) <= 1e-5);
    }
}

TEST_CASE("a ray parallel to the plane never hits it", "[step2]") {
    INFO(hint("NaN, or a hit at infinity", "n·d = 0: there is no solution", "§2 Parallel"));
    CHECK_FALSE(intersect_plane({0, 0, 0}, {0, 1, 0}, {{0, 1, 0}, {1, 0, -1}}, {}));
    CHECK_FALSE(intersect_plane({0, 0, 0}, {0, 1, 0}, {{0, 0, 0}, {1, 0, -1}}, {}));
}

TEST_CASE("a ray that is nearly parallel hits the plane far away", "[step2]") {
    INFO(hint("the floor ends before the horizon", "only n·d = 0 itself has no solution; a small n·d does, and so does a short d", "§2 Parallel"));
    const auto far = intersect_plane({0, 0, 0}, {0, 1, 0}, {{0, 1, 0}, {1, -1e-7f, 0}}, {});
    REQUIRE(far);
    CHECK(far->t == Approx(1e7));
    const auto short_one = intersect_plane({0, 0, 0}, {0, 1, 0}, {{0, 1, 0}, {0, -1e-9f, 0}}, {});
    REQUIRE(short_one);
    CHECK(short_one->t == Approx(1e9));
}

TEST_CASE("a plane is seen from both sides, and its normal stays", "[step2]") {
    INFO(hint("the floor is missing when seen from below", "the sign of n·d says from which side one looks, not whether one hits", "§2 The plane"));
    const auto h = intersect_plane({0, 0, 0}, {0, 1, 0}, {{0, -2, 0}, {0, 1, 0}}, {});
    REQUIRE(h);
    CHECK(h->t == Approx(2));
    CHECK(apart(h->normal, {0, 1, 0}) <= 1e-6);
}

TEST_CASE("a plane outside the range is not hit", "[step2]") {
    INFO(hint("the floor shows up in the sky, or things behind a light cast shadows", "ask contains(range, t)", "§2 The plane"));
    CHECK_FALSE(intersect_plane({0, 0, 0}, {0, 1, 0}, {{0, 5, 0}, {0, 1, 0}}, {}));
    CHECK_FALSE(intersect_plane({0, 0, 0}, {0, 1, 0}, {{0, 5, 0}, {0, -1, 0}}, {0, 4.9f}));
    CHECK_FALSE(intersect_plane({0, 0, 0}, {0, 1, 0}, {{0, 5, 0}, {0, -1, 0}}, {5.1f, 100}));
}

// ---- Step 3: the triangle ------------------------------------------------------------------------------------------

TEST_CASE("a ray through the middle of a triangle hits it", "[step3]") {
    INFO(hint("the triangle is missing", "solve o + t d = a + u (b - a) + v (c - a) for t, u and v", "§3 Three unknowns"));
    const auto h = intersect_triangle({0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {{1, 1, 2}, {0, 0, -1}}, {});
    REQUIRE(h);
    CHECK(h->t == Approx(2));
    CHECK(apart(h->point, {1, 1, 0}) <= 1e-6);
    CHECK(apart(h->normal, {0, 0, 1}) <= 1e-6);
}

TEST_CASE("inside the three edges the triangle is hit, outside it is not", "[step3]") {
    INFO(hint("the triangle is a parallelogram, or has no end", "inside means u >= 0, v >= 0 and u + v <= 1: all three", "§3 Inside"));
    numbers random(3);
    for (int i = 0; i < 600; ++i) {
        const glm::vec3 a = 2.0f * random.vector(), b = a + 2.0f * random.vector(), c = a + 2.0f * random.vector();
        const glm::dvec3 ab = glm::dvec3(b) - glm::dvec3(a), ac = glm::dvec3(c) - glm::dvec3(a);
        const float u = random.between(-0.6f, 1.5f), v = random.between(-0.6f, 1.5f);
        const glm::vec3 aim = a + glm::vec3(double(u) * ab + double(v) * ac);
        const glm::vec3 normal = glm::vec3(glm::cross(ab, ac));
        const ray r{aim + 3.0f * glm::normalize(normal) + random.vector(), {}};
        const ray towards{r.origin, aim - r.origin};
        const float margin = std::min({std::abs(u), std::abs(v), std::abs(u + v - 1)});
        if (glm::length(normal) < 0.2f || margin < 0.01f) continue;  // slivers, and rays too near to an edge to call
        const bool inside = u > 0 && v > 0 && u + v < 1;
        CAPTURE(i, u, v, a, b, c, towards.origin, towards.direction);
        const auto h = intersect_triangle(a, b, c, towards, {});
        REQUIRE(h.has_value() == inside);
        if (!inside) continue;
        REQUIRE(std::abs(h->t - 1) <= 1e-4f);
        REQUIRE(apart(h->point, aim) <= 1e-4);
    }
}

TEST_CASE("a triangle is seen from both sides, and its normal stays", "[step3]") {
    INFO(hint("every second triangle of a mesh is missing", "the sign of the determinant says from which side one looks, not whether one hits",
              "§3 The determinant"));
    const auto front = intersect_triangle({0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {{1, 1, 2}, {0, 0, -1}}, {});
    const auto back = intersect_triangle({0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {{1, 1, -2}, {0, 0, 1}}, {});
    REQUIRE(front);
    REQUIRE(back);
    CHECK(back->t == Approx(2));
    CHECK(apart(front->normal, {0, 0, 1}) <= 1e-6);
    CHECK(apart(back->normal, {0, 0, 1}) <= 1e-6);
}

TEST_CASE("the normal has length 1 and stands upright where a, b, c are seen counter-clockwise", "[step3]") {
    INFO(hint("the mesh is too bright, or lit from inside", "normalise (b - a) × (c - a), in this order", "§3 The normal"));
    const auto h = intersect_triangle({0, 0, 0}, {0, 0, 20}, {10, 0, 0}, {{1, 5, 1}, {0, -1, 0}}, {});
    REQUIRE(h);
    CHECK(apart(h->normal, {0, 1, 0}) <= 1e-6);
}

TEST_CASE("a small triangle is hit like a large one", "[step3]") {
    INFO(hint("fine meshes have holes, or vanish", "the determinant is an area: \"smaller than 1e-8\" says nothing but that the triangle is small",
              "§3 The determinant"));
    const float size = GENERATE(1e-6f, 1e-3f, 1e3f, 1e6f);
    INFO("size := " << size);
    const auto h = intersect_triangle({0, 0, 0}, {size, 0, 0}, {0, size, 0}, {{size / 4, size / 4, size}, {0, 0, -1}}, {});
    REQUIRE(h);
    CHECK(h->t == Approx(size).epsilon(1e-5));
}

TEST_CASE("a triangle outside the range is not hit", "[step3]") {
    INFO(hint("things behind the eye show up in front of it", "ask contains(range, t)", "§3 Inside"));
    CHECK_FALSE(intersect_triangle({0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {{1, 1, 2}, {0, 0, 1}}, {}));
    CHECK_FALSE(intersect_triangle({0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {{1, 1, 2}, {0, 0, -1}}, {0, 1.9f}));
    CHECK_FALSE(intersect_triangle({0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {{1, 1, 2}, {0, 0, -1}}, {2.1f, 9}));
}

TEST_CASE("edge-on, or without area, a triangle is not hit", "[step3]") {
    INFO(hint("NaN in the picture", "a determinant of exactly 0: return std::nullopt before dividing by it", "§3 The determinant"));
    CHECK_FALSE(intersect_triangle({0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {{5, 1, 0}, {-1, 0, 0}}, {}));
    CHECK_FALSE(intersect_triangle({0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {{1, 0, 2}, {0, 0, -1}}, {}));
    CHECK_FALSE(intersect_triangle({1, 1, 0}, {1, 1, 0}, {1, 1, 0}, {{1, 1, 2}, {0, 0, -1}}, {}));
}

// ---- Step 4: the closest hit ---------------------------------------------------------------------------------------

namespace {

/// Surfaces that are hit at the given t, if that lies in the range; remembers what they were asked.
struct targets {
    std::vector<float> t;
    std::vector<interval> asked{};

    std::optional<nearest> closest_of(interval range = {}) {
        return closest(std::uint32_t(t.size()), [this](std::uint32_t i, interval r) -> found {
            asked.push_back(r);
            if (i >= t.size() || !contains(r, t[i])) return std::nullopt;
            return lantern::hit{.t = t[i], .point = {0, 0, -t[i]}, .normal = {float(i), 0, 1}};
        }, range);
    }
};

}  // namespace

TEST_CASE("where there is nothing, nothing is hit", "[step4]") {
    INFO(hint("the program dies, or the sky is painted", "start with an empty std::optional, and return it", "§4 The closest hit"));
    CHECK_FALSE(targets{{}}.closest_of());
    CHECK_FALSE(targets{{-1, -2}}.closest_of());
}

TEST_CASE("the nearest is seen, in whatever order the surfaces stand", "[step4]") {
    INFO(hint("things that are behind are seen in front", "keep the hit with the smallest t, not the first nor the last one", "§4 The closest hit"));
    const std::vector<float> t = GENERATE(std::vector<float>{3, 1, 2}, std::vector<float>{1, 2, 3}, std::vector<float>{3, 2, 1},
                                          std::vector<float>{-1, 2, 9, 8, 1, -5});
    CAPTURE(t);
    const auto n = targets{t}.closest_of();
    REQUIRE(n);
    CHECK(n->at.t == 1);
    REQUIRE(n->index < t.size());
    CHECK(t[n->index] == 1);
    CHECK(n->at.normal.x == float(n->index));
}

TEST_CASE("of two surfaces at the same place the first is seen", "[step4]") {
    INFO(hint("two surfaces in one place flicker", "a range includes its end: what is exactly as far as the best so far must not replace it",
              "§4 Two in one place"));
    const auto n = targets{{5, 2, 2, 2, 7}}.closest_of();
    REQUIRE(n);
    CHECK(n->index == 1);
}

TEST_CASE("no surface is asked for what lies behind the nearest hit so far", "[step4]") {
    INFO(hint("the picture is right, but slow: later labs save their work by this", "pass on a range that ends at the nearest t so far",
              "§4 The closest hit"));
    targets row{{6, 8, 3, 4, 9}};
    REQUIRE(row.closest_of({0.5f, 100}));
    REQUIRE(row.asked.size() == 5);
    const float ends[] = {100, 6, 6, 3, 3};
    for (std::size_t i = 0; i < 5; ++i) {
        CAPTURE(i);
        CHECK(row.asked[i].min == 0.5f);
        CHECK(row.asked[i].max == ends[i]);
    }
}

TEST_CASE("nothing outside the range is seen", "[step4]") {
    INFO(hint("a wall behind the light casts a shadow", "the range of the caller must reach every surface", "§4 The closest hit"));
    const auto n = targets{{1, 2, 3, 4}}.closest_of({1.5f, 10});
    REQUIRE(n);
    CHECK(n->index == 1);
    CHECK_FALSE(targets{{1, 2, 3, 4}}.closest_of({4.5f, 10}));
    CHECK_FALSE(targets{{1, 2, 3, 4}}.closest_of({0, 0.5f}));
}
