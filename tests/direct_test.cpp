// SPDX-License-Identifier: MIT
#include <lantern/direct.hpp>

#include <lantern/diffuse.hpp>
#include <lantern/moving.hpp>
#include <lantern/moving_light.hpp>
#include <lantern/rectangle.hpp>
#include <lantern/rectangle_light.hpp>
#include <lantern/sphere.hpp>
#include <lantern/sphere_light.hpp>

#include "catch.hpp"
#include "oracle.hpp"
#include "recording_source.hpp"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
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

/// Lit from either side, as a leaf is.
struct leaf {};
glm::vec3 evaluate(leaf, glm::vec3, const lantern::hit& h, glm::vec3 out) { return glm::vec3(std::abs(glm::dot(out, h.normal))); }

bool same(const lantern::illumination& a, const lantern::illumination& b) { return a.position == b.position && a.irradiance == b.irradiance; }

/// Counts the rays that it is asked about.
struct counting : every {
    mutable int rays = 0;
    void traverse(const ray& r, lantern::interval range, auto&& offer, auto&&... counter) const {
        ++rays;
        every::traverse(r, range, offer, counter...);
    }
};

}  // namespace

TEST_CASE("a light is asked with what it needs: numbers of its own, the time of the ray, or neither") {
    const point_light spark{{0, 3, 0}, glm::vec3(7)};
    const lantern::moving firefly{spark, {4, 0, 0}};
    const lantern::rectangle_light window{{-1, 3, -1}, {2, 0, 0}, {0, 0, 2}};
    const lantern::moving comet{lantern::sphere_light{{-2, 3, 0}, 0.5f}, {4, 0, 0}};
    const lantern::timed_ray r{{}, 0.25f};
    const glm::vec3 point(0.5f, 0, 0);
    recording asked;
    const auto numbers = lantern::independent{}.at({3, 4}, 0);
    const recording_source source{numbers, &asked};
    const glm::vec2 xi = numbers.draw2(lantern::purpose::light, 5);
    CHECK(same(illumination_from(spark, 5, r, point, source), illuminate(spark, point)));
    CHECK(same(illumination_from(firefly, 5, r, point, source), illuminate(firefly, point, 0.25f)));
    CHECK(asked.empty());
    CHECK(same(illumination_from(window, 5, r, point, source), illuminate(window, point, xi)));
    CHECK(asked.size() == 1);
    CHECK(same(illumination_from(comet, 5, r, point, source), illuminate(comet, point, xi, 0.25f)));
    CHECK(asked.size() == 1);
}

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

TEST_CASE("colours are answered each by itself: black in one is not black") {
    const std::vector<sphere> things{{{0, 0, -5}, 1}, {{0, 0, -2}, 0.5f}};
    const ray r{};
    const lantern::hit h = *intersect(things[0], r, {});
    const auto seen = [&](glm::vec3 material, glm::vec3 light, std::uint32_t count = 1) {
        return direct_light(every{count}, things, r, r.direction, h, diffuse{material}, illuminate(point_light{{0, 0, 0}, light}, h.point));
    };
    const glm::vec3 whole = seen(glm::vec3(1), glm::vec3(1));
    for (const glm::vec3 one : {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)}) {
        CHECK(seen(one, glm::vec3(1)) == one * whole);
        CHECK(seen(glm::vec3(1), one) == one * whole);
        CHECK(seen(one, glm::vec3(1), 2) == glm::vec3(0));  // in the shadow of the other sphere
    }
}

TEST_CASE("a shadow ray leaves to the side of the light, not to that of the eye") {
    const std::vector<rectangle> things{{{-5, 0, -5}, {0, 0, 10}, {10, 0, 0}}};
    const ray down{{0, 1, 0}, {0, -1, 0}};
    const lantern::hit h = *intersect(things[0], down, {});
    for (const float height : {4.0f, -4.0f})
        CHECK(direct_light(every{1}, things, down, down.direction, h, leaf{}, illuminate(point_light{{0, height, 0}}, h.point)).x > 0);
}

TEST_CASE("a shadow ray ends at the light, however far it is stepped off where it begins") {
    const lantern::hit rough{.t = 1, .point = {0, 0, 0}, .normal = {0, 1, 0}, .error = 0.5f};
    const ray down{{0, 1, 0}, {0, -1, 0}};
    const auto lit_under = [&](float height) {
        const std::vector<rectangle> lid{{{-1, height, -1}, {2, 0, 0}, {0, 0, 2}}};
        return direct_light(every{1}, lid, down, down.direction, rough, white, illuminate(point_light{{0, 4, 0}}, rough.point)).x > 0;
    };
    CHECK(lit_under(4.001f));
    CHECK_FALSE(lit_under(3.999f));
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
    const std::vector<sphere> none;  // that might shade it, and hide what is wrong
    CHECK(direct_light(every{0}, none, r, r.direction, h, leaf{}, illuminate(point_light{h.point}, h.point)) == glm::vec3(0));
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
