// SPDX-License-Identifier: MIT
#include <lantern/direct.hpp>

#include <lantern/diffuse.hpp>
#include <lantern/moving.hpp>
#include <lantern/rectangle.hpp>
#include <lantern/sphere.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <vector>

using lantern::diffuse;
using lantern::direct_light;
using lantern::every;
using lantern::point_light;
using lantern::ray;
using lantern::rectangle;
using lantern::sphere;

namespace {

const diffuse white{glm::vec3(1)};

/// Counts the rays that it is asked about.
struct counting : every {
    mutable int rays = 0;
    void traverse(const ray& r, lantern::interval range, auto&& offer, auto&&... counter) const {
        ++rays;
        every::traverse(r, range, offer, counter...);
    }
};

}  // namespace

TEST_CASE("light that nothing blocks arrives whole: answer times irradiance") {
    const std::vector<sphere> things{{{0, 0, -5}, 1}};
    const ray r{};
    const auto h = closest(every{1}, things, r);
    const auto lit = illuminate(point_light{{0, 3, 0}, glm::vec3(7)}, h->point);
    const glm::vec3 out = lantern::unit(lit.position - h->point);
    CHECK(direct_light(every{1}, things, r, r.direction, *h, white, lit) == evaluate(white, r.direction, *h, out) * lit.irradiance);
}

TEST_CASE("only what stands between the hit and the light makes a shadow") {
    const rectangle floor{{-5, 0, -5}, {0, 0, 10}, {10, 0, 0}};  // its normal points up
    const ray down{{0, 1, 0}, {0, -1, 0}};
    const auto lit_with = [&](glm::vec3 place) {
        const std::vector<rectangle> things{floor, {place - glm::vec3(1, 0, 1), {2, 0, 0}, {0, 0, 2}}};
        const lantern::hit h = *intersect(floor, down, {});
        const auto lit = illuminate(point_light{{0, 4, 0}}, h.point);
        return direct_light(every{2}, things, down, down.direction, h, white, lit).x > 0;
    };
    CHECK_FALSE(lit_with({0, 2, 0}));
    CHECK(lit_with({0, 4.001f, 0}));   // beyond the light
    CHECK(lit_with({0, -0.001f, 0}));  // below the floor
    CHECK(lit_with({3, 2, 0}));        // beside
    CHECK_FALSE(lit_with({0, 1e-6f, 0}));
    CHECK_FALSE(lit_with({0, 3.999f, 0}));
}

TEST_CASE("no shadow ray is shot where there is nothing to lose") {
    const std::vector<sphere> things{{{0, 0, -5}, 1}};
    const counting all{{1}};
    const ray r{};
    const lantern::hit h = *intersect(things[0], r, {});
    CHECK(direct_light(all, things, r, r.direction, h, white, illuminate(point_light{{0, 0, -50}}, h.point)) == glm::vec3(0));
    CHECK(direct_light(all, things, r, r.direction, h, white, {{0, 3, 0}, glm::vec3(0)}) == glm::vec3(0));
    CHECK(direct_light(all, things, r, r.direction, h, diffuse{glm::vec3(0)}, illuminate(point_light{{0, 0, 0}}, h.point)) == glm::vec3(0));
    CHECK(all.rays == 0);
    CHECK(direct_light(all, things, r, r.direction, h, white, illuminate(point_light{{0, 0, 0}}, h.point)).x > 0);
    CHECK(all.rays == 1);
}

TEST_CASE("a light in the surface itself gives no NaN") {
    const std::vector<sphere> things{{{0, 0, -5}, 1}};
    const ray r{};
    const lantern::hit h = *intersect(things[0], r, {});
    CHECK(direct_light(every{1}, things, r, r.direction, h, white, illuminate(point_light{h.point}, h.point)) == glm::vec3(0));
}

TEST_CASE("a shadow ray keeps the time of the ray that caused it") {
    const std::vector screen{lantern::moving{rectangle{{-1, 2, -1}, {2, 0, 0}, {0, 0, 2}}, {10, 0, 0}}};
    const rectangle floor{{-5, 0, -5}, {0, 0, 10}, {10, 0, 0}};
    for (const float time : {0.0f, 1.0f}) {
        const lantern::timed_ray down{{{0, 1, 0}, {0, -1, 0}}, time};
        const lantern::hit h = *intersect(floor, down, {});
        const auto lit = illuminate(point_light{{0, 4, 0}}, h.point);
        CHECK((direct_light(every{1}, screen, down, down.direction, h, white, lit).x > 0) == (time == 1));
    }
}

TEST_CASE("no acne: a convex surface never shades itself, at any scale, anywhere") {
    dice d{.state = 1};
    int lit = 0, acne = 0;
    for (const float scale : {1e-15f, 1e-6f, 1e-3f, 1.0f, 1e3f, 1e6f, 1e15f})
        for (const float offset : {0.0f, 10.0f, 1000.0f}) {
            const glm::vec3 place = offset * scale * glm::vec3(1, -0.7f, 0.3f);
            for (int i = 0; i < 3000; ++i) {
                const std::vector<sphere> things{{place, scale * d.between(0.1, 1)}};
                const glm::vec3 eye = place + 5 * scale * glm::vec3(d.on_sphere());
                const ray r{eye, lantern::unit(place + things[0].radius * d.in_cube() - eye)};
                const auto h = closest(every{1}, things, r);
                if (!h) continue;
                const point_light lamp{place + scale * d.magnitude_between(0.2, 3) * glm::vec3(d.on_sphere()), glm::vec3(scale * scale)};
                const auto arriving = illuminate(lamp, h->point);
                const glm::vec3 out = lantern::unit(lamp.position - h->point);
                if (!(evaluate(white, r.direction, *h, out).x > 1e-6f)) continue;
                ++lit;
                acne += direct_light(every{1}, things, r, r.direction, *h, white, arriving) == glm::vec3(0);
            }
        }
    CHECK(lit > 10000);
    CHECK(acne == 0);
}

TEST_CASE("no light leaks through a contact: a lid 16 ulp above a floor shades it, at any scale, anywhere") {
    dice d{.state = 2};
    int leaks = 0;
    for (const float scale : {1e-15f, 1e-6f, 1e-3f, 1.0f, 1e3f, 1e6f, 1e15f})
        for (const float offset : {0.0f, 10.0f, 1000.0f}) {
            const float level = -offset * scale, size = scale * (10 + 4 * offset);
            const float gap = 16 * lantern::ulp(std::max(size, -level));
            const rectangle floor{{-size, level, -size}, {0, 0, 2 * size}, {2 * size, 0, 0}};
            const std::vector<rectangle> things{floor, {{-size, level + gap, -size}, {0, 0, 2 * size}, {2 * size, 0, 0}}};
            const point_light lamp{{0, level + 3 * scale, 0}, glm::vec3(scale * scale)};
            for (int i = 0; i < 500; ++i) {
                const glm::vec3 p = scale * d.in_cube();
                const ray r{{p.x, level + gap / 2, p.z}, {0, -1, 0}};
                const auto h = closest(every{2}, things, r);
                REQUIRE(h);
                REQUIRE(h->index == 0);
                leaks += direct_light(every{2}, things, r, r.direction, *h, white, illuminate(lamp, h->point)) != glm::vec3(0);
            }
        }
    CHECK(leaks == 0);
}
