// SPDX-License-Identifier: MIT
#include <lantern/triangle_packet.hpp>

#include <lantern/interval.hpp>
#include <lantern/lanes.hpp>
#include <lantern/precise.hpp>
#include <lantern/surface.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cstdint>

using lantern::passes_through;
using lantern::ray;
using lantern::sheared_ray;
using lantern::triangle;
using lantern::triangle_packet;

namespace {

triangle random_triangle(dice& d, double size) {
    const glm::dvec3 center(d.in_cube());
    const auto vertex = [&] { return glm::vec3(center + size * d.on_sphere()); };
    return {vertex(), vertex(), vertex()};
}

// As long as the scene, and 1e-4 as wide.
triangle needle(dice& d) {
    const glm::dvec3 a(d.in_cube()), along = d.on_sphere();
    return {glm::vec3(a), glm::vec3(a + along), glm::vec3(a + double(d.between(0, 1)) * along + 1e-4 * d.on_sphere())};
}

}  // namespace

TEST_CASE("a packet gives its triangles back as they were") {
    dice d{.state = 1};
    triangle_packet p;
    const triangle t = random_triangle(d, 1), s = random_triangle(d, 1);
    p.set(0, t, 7);
    p.set(3, s, 9);
    CHECK((p[0].a == t.a && p[0].b == t.b && p[0].c == t.c));
    CHECK((p[3].a == s.a && p[3].b == s.b && p[3].c == s.c));
    CHECK(p.index[0] == 7);
    CHECK(p.index[3] == 9);
}

TEST_CASE("a packet decides as its triangles do alone, in any direction, through edges and vertices too") {
    dice d{.state = 2};
    lantern::packet_sides ignored;
    int hits = 0;
    for (int i = 0; i < 20'000; ++i) {
        const double size = i % 3 == 0 ? 1e-3 : 1;
        triangle_packet p;
        for (std::uint32_t k = 0; k < 4; ++k) p.set(k, random_triangle(d, size), k);
        const triangle t = p[d.below(4)];
        const glm::vec3 o = d.in_cube(3);
        const glm::vec3 to = i % 4 == 0   ? t.b - o
                             : i % 4 == 1 ? 0.5f * (t.a + t.b) - o
                             : i % 4 == 2 ? (t.a + t.b + t.c) / 3.0f - o
                                          : glm::vec3(0);
        ray r{o, to};
        if (i % 4 == 3) {
            r.direction[static_cast<int>(d.below(3))] = d.below(2) == 0 ? 1.0f : -1.0f;
            r.origin = t.a - 2.0f * r.direction;
        }
        const std::uint32_t lanes = passes_through(p, sheared_ray(r, 3), ignored);
        for (std::uint32_t k = 0; k < 4; ++k) {
            // Ahead of the origin or behind it: a line passes through either way.
            const bool alone = intersect(p[k], r, lantern::interval{}) || intersect(p[k], ray{r.origin, -r.direction}, lantern::interval{});
            if (alone) REQUIRE((lanes >> k & 1) == 1);
            hits += alone;
        }
    }
    CHECK(hits > 5000);
}

TEST_CASE("where a packet is sure of t, the triangle says the same, bit by bit") {
    dice d{.state = 4};
    int alike = 0, rounded = 0, unsure = 0;
    for (int i = 0; i < 40'000; ++i) {
        triangle_packet p;
        for (std::uint32_t k = 0; k < 4; ++k) p.set(k, i % 4 == 3 ? needle(d) : random_triangle(d, 1), k);
        const triangle t = p[d.below(4)];
        ray r{d.in_cube(3), {}};
        r.direction = (t.a + t.b + t.c) / 3.0f - r.origin;
        if (i % 4 == 0) r = {(t.a + t.b + t.c) / 3.0f, d.in_cube()};                      // from a triangle
        if (i % 4 == 1) r = {t.a + 2.0f * (t.a - t.b) + 1e-6f * d.in_cube(), t.b - t.a};  // along an edge
        const sheared_ray sheared(r, 10);
        lantern::packet_sides sides;
        lantern::packet_hits hits;
        const std::uint32_t lanes = passes_through(p, sheared, sides), decided = meets_plane(p, sheared, r, lanes, sides, hits);
        for (std::uint32_t k = 0; k < 4; ++k) {
            if ((lanes >> k & 1) == 0) continue;
            const bool exactly = (hits.alike >> k & 1) != 0;
            (exactly ? alike : (decided >> k & 1) != 0 ? rounded : unsure) += 1;
            if ((decided >> k & 1) == 0) continue;
            const double at = hits.above[int(k)] / hits.speed[int(k)];
            const auto alone = intersect(p[k], lantern::precise::widen(r), lantern::interval{});
            REQUIRE(alone.has_value() == contains(lantern::interval{}, at));
            if (!alone) continue;
            if (!exactly) {
                REQUIRE(static_cast<float>(alone->t) == static_cast<float>(at));
                continue;
            }
#if defined(LANTERN_ALLOW_FP_CONTRACT)  // fused as the compiler likes, here and there; above and speed may be 2^-15 of what they are made of
            REQUIRE(alone->t == Approx(at).epsilon(0x1p-33));
#else
            REQUIRE(alone->t == at);
#endif
        }
    }
    CHECK(alike > 10'000);
    CHECK(rounded > 1000);  // or these would not have been tried
    CHECK(unsure > 100);
}

TEST_CASE("needles need not be asked themselves") {
    dice d{.state = 5};
    int hit = 0, unsure = 0;
    for (int i = 0; i < 20'000; ++i) {
        triangle_packet p;
        for (std::uint32_t k = 0; k < 4; ++k) p.set(k, needle(d), k);
        const triangle t = p[0];
        const glm::vec3 o = d.in_cube(3);
        const ray r{o, 0.5f * t.a + 0.25f * t.b + 0.25f * t.c - o};
        const sheared_ray sheared(r, 3);
        lantern::packet_sides sides;
        lantern::packet_hits hits;
        const std::uint32_t lanes = passes_through(p, sheared, sides);
        if ((lanes & 1) == 0) continue;
        ++hit;
        unsure += (meets_plane(p, sheared, r, lanes, sides, hits) & 1) == 0;
    }
    CHECK(hit > 15'000);
    CHECK(unsure < hit / 50);
}

TEST_CASE("where a packet is sure of a hit, so is the triangle, however near an edge: the same place, bit by bit") {
    dice d{.state = 5};
    int sure = 0, unsure = 0;
    for (int i = 0; i < 60'000; ++i) {
        // Edges through the middle, seen from afar; rays along an axis pass them by next to nothing, which no rounding hides.
        const int z = i % 3, x = (z + 1) % 3, y = (z + 2) % 3;
        const glm::vec3 side = d.in_cube();
        triangle t{d.magnitude_between(-2, 1) * side, -d.magnitude_between(-2, 1) * side, d.magnitude_between(-3, 1) * d.in_cube()};
        for (glm::vec3* const v : {&t.a, &t.b, &t.c}) (*v)[z] += d.between(-1, 1);
        if (i % 2 == 1) t = {t.c, t.a, t.b};
        ray r{glm::vec3(0), glm::vec3(0)};
        r.origin[x] = d.magnitude_between(-18, -6) * d.between(-1, 1);
        r.origin[y] = d.magnitude_between(-18, -6) * d.between(-1, 1);
        r.origin[z] = -d.magnitude_between(0.5, 4);
        r.direction[z] = d.magnitude_between(-3, 3);
        triangle_packet p;
        p.set(2, t, 0);
        lantern::packet_sides sides;
        lantern::packet_hits hits;
        const sheared_ray sheared(r, 12);
        const std::uint32_t lanes = passes_through(p, sheared, sides);
        static_cast<void>(meets_plane(p, sheared, r, lanes, sides, hits));
        if ((lanes >> 2 & 1) == 0) continue;
        const bool certain = (hits.alike >> 2 & 1) != 0;
        (certain ? sure : unsure) += 1;
        const auto alone = intersect(t, r, lantern::interval{});
        if (!certain || !alone) continue;
        const lantern::hit known = hit_at(t, r, static_cast<float>(hits.above[2] / hits.speed[2]));
#if defined(LANTERN_ALLOW_FP_CONTRACT)
        REQUIRE(glm::distance(known.point, alone->point) < 1e-6f);
#else
        REQUIRE((known.t == alone->t && known.point == alone->point && known.normal == alone->normal && known.error == alone->error));
#endif
    }
    CHECK(sure > 1000);
    CHECK(unsure > 1000);
}

TEST_CASE("slots that are empty are never met, and a point is no triangle") {
    dice d{.state = 3};
    lantern::packet_sides ignored;
    for (int i = 0; i < 2000; ++i) {
        triangle_packet p;
        const glm::vec3 point = d.in_cube();
        const glm::vec3 o = d.in_cube(3);
        for (const ray& r : {ray{o, point - o}, ray{o, -o}, ray{point - glm::vec3(1, 0, 0), {1, 0, 0}}})
            REQUIRE(passes_through(p, sheared_ray(r, 1), ignored) == 0);
        p.set(1, {point, point, point}, 0);
        REQUIRE((passes_through(p, sheared_ray({o, point - o}, 1), ignored) & 0b1101u) == 0);
        REQUIRE_FALSE(intersect(p[1], ray{o, point - o}, lantern::interval{}));
    }
}

TEST_CASE("what is clearly passed is not offered") {
    dice d{.state = 4};
    lantern::packet_sides ignored;
    int offered = 0;
    for (int i = 0; i < 5000; ++i) {
        triangle_packet p;
        for (std::uint32_t k = 0; k < 4; ++k) p.set(k, random_triangle(d, 1e-3), k);
        const ray r{d.in_cube(3), d.in_cube()};
        const std::uint32_t lanes = passes_through(p, sheared_ray(r, 1.01f), ignored);
        for (std::uint32_t k = 0; k < 4; ++k) {
            const bool alone = intersect(p[k], r, lantern::interval{}) || intersect(p[k], ray{r.origin, -r.direction}, lantern::interval{});
            offered += (lanes >> k & 1) == 1 && !alone;
        }
    }
    CHECK(offered < 20);
}
