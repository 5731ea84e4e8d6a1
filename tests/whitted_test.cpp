// SPDX-License-Identifier: MIT
#include <lantern/whitted.hpp>

#include <lantern/any_of.hpp>
#include <lantern/blinn_phong.hpp>
#include <lantern/bvh.hpp>
#include <lantern/diffuse.hpp>
#include <lantern/emissive.hpp>
#include <lantern/glass.hpp>
#include <lantern/mirror.hpp>
#include <lantern/moving_light.hpp>
#include <lantern/object.hpp>
#include <lantern/plane.hpp>
#include <lantern/rectangle.hpp>
#include <lantern/sphere.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <variant>
#include <vector>

using lantern::diffuse;
using lantern::every;
using lantern::glass;
using lantern::mirror;
using lantern::object;
using lantern::plane;
using lantern::point_light;
using lantern::ray;
using lantern::sphere;
using lantern::whitted;

namespace {

const std::vector<point_light> no_lights;
const lantern::sky white{.horizon = glm::vec3(1), .zenith = glm::vec3(1)};

}  // namespace

TEST_CASE("a diffuse surface under a point light: albedo / pi, intensity / d^2, cosine") {
    const std::vector things{object{plane{{0, 0, 0}, {0, 1, 0}}, diffuse{{0.2f, 0.4f, 0.8f}}}};
    const std::vector lights{point_light{{3, 4, 0}, glm::vec3(50)}};
    const every all{1};
    const whitted tracer{all, things, lights};
    const glm::vec3 seen = tracer(ray{{0, 2, 0}, {0, -1, 0}});
    const double expected = 0.4 / std::numbers::pi * 50 / 25 * 0.8;
    CHECK(seen.y == Approx(expected));
    CHECK(seen.x == Approx(expected / 2));
    CHECK(seen.z == Approx(expected * 2));
}

TEST_CASE("lights add up, and so do ambient light and emission") {
    using material = std::variant<diffuse, lantern::emissive>;
    const std::vector<object<sphere, material>> things{{sphere{{0, 0, -3}, 1}, diffuse{glm::vec3(0.5f)}},
                                                       {sphere{{0, 0, 3}, 1}, lantern::emissive{glm::vec3(2)}}};
    const point_light a{{0, 5, 0}, glm::vec3(9)}, b{{5, 0, 0}, glm::vec3(5)};
    const every all{2};
    const auto seen = [&](std::vector<point_light> lights, float ambient) {
        const whitted tracer{all, things, lights, lantern::darkness{}, {.ambient = glm::vec3(ambient)}};
        return tracer(ray{}).x;
    };
    CHECK(seen({a, b}, 0) == Approx(seen({a}, 0) + seen({b}, 0)));
    CHECK(seen({}, 0.5f) == 0.25f);
    const whitted tracer{all, things, no_lights};
    CHECK(tracer(ray{{0, 0, 0}, {0, 0, 1}}) == glm::vec3(2));
}

TEST_CASE("a ray that meets nothing sees the background, whatever the length of its direction") {
    const std::vector<object<sphere, diffuse>> things;
    const every none{0};
    const lantern::sky s;
    const whitted tracer{none, things, no_lights, s};
    for (const float length : {1e-30f, 1.0f, 1e30f})
        CHECK(glm::distance(tracer(ray{{0, 0, 0}, length * glm::vec3(0.6f, 0.8f, 0)}), radiance(s, {0.6f, 0.8f, 0})) < 1e-6f);
}

TEST_CASE("between two mirrors a ray is followed as often as the depth allows, and each takes its share") {
    // Mirrors at x = 0 and x = 1, open above: a ray at slope 1:1 from the middle of the floor leaves after 5 reflections.
    const std::vector things{object{lantern::rectangle{{0, 0, -9}, {0, 4.9f, 0}, {0, 0, 18}}, mirror{glm::vec3(0.5f)}},
                             object{lantern::rectangle{{1, 0, -9}, {0, 4.9f, 0}, {0, 0, 18}}, mirror{glm::vec3(0.5f)}}};
    const every all{2};
    const ray r{{0.5f, 0, 0}, {1, 1, 0}};
    const auto seen = [&](lantern::whitted_options o) { return whitted{all, things, no_lights, white, o}(r).x; };
    CHECK(seen({.depth = 5, .cutoff = 0}) == 0.03125f);
    CHECK(seen({.depth = 50, .cutoff = 0}) == 0.03125f);
    CHECK(seen({.depth = 4, .cutoff = 0}) == 0);
    CHECK(seen({.depth = 50, .cutoff = 0.03f}) == 0.03125f);
    CHECK(seen({.depth = 50, .cutoff = 0.1f}) == 0);
}

TEST_CASE("a mirror shows what is there: the reflected ray hits what a ray from the image would") {
    using material = std::variant<mirror, lantern::emissive>;
    const std::vector<object<lantern::any_of<plane, sphere>, material>> things{
        {plane{{0, 0, 0}, {0, 1, 0}}, mirror{glm::vec3(0.5f)}}, {sphere{{0, 1, -4}, 0.5f}, lantern::emissive{glm::vec3(3)}}};
    const every all{2};
    const whitted tracer{all, things, no_lights};
    CHECK(tracer(ray{{0, 1, 0}, {0, -2, -4}}) == glm::vec3(1.5f));  // towards the image below the mirror
    CHECK(tracer(ray{{0, 1, 0}, {0, -1, -4}}) == glm::vec3(0));
}

TEST_CASE("a glass ball in an even white world cannot be seen") {
    const std::vector things{object{sphere{{0, 0, -3}, 1}, glass{.index = 1.5f}}};
    const every all{1};
    const whitted tracer{all, things, no_lights, white, {.depth = 60, .cutoff = 0}};
    for (float x = 0; x < 0.995f; x += 0.05f) CHECK(tracer(ray{{x, 0, 0}, {0, 0, -1}}).x == Approx(1).epsilon(1e-4));
}

TEST_CASE("a hollow ball with walls of index 1 is not there") {
    const std::vector things{object{sphere{{0, 0, -3}, 1}, glass{.index = 1}}, object{sphere{{0, 0, -3}, -0.9f}, glass{.index = 1}}};
    const every all{2};
    const lantern::sky s;
    const whitted tracer{all, things, no_lights, s};
    dice d{.state = 1};
    for (int i = 0; i < 200; ++i) {
        const glm::vec3 direction(d.on_sphere());
        CHECK(glm::distance(tracer(ray{{0, 0, 0}, direction}), radiance(s, direction)) < 1e-6f);
    }
}

TEST_CASE("a glass ball is a lens: paraxial rays meet at 1.5 R from its center") {
    const std::vector<sphere> ball{{{0, 0, 0}, 1}};
    ray r{{0.02f, 0, 5}, {0, 0, -1}};
    for (int surface = 0; surface < 2; ++surface) {
        const auto h = closest(every{1}, ball, r);
        REQUIRE(h);
        const auto rays = scatter(glass{.index = 1.5f}, r.direction, *h);
        REQUIRE(rays.size() == 2);
        r = {leave(*h, rays[1].direction), rays[1].direction};
    }
    CHECK(r.origin.z + r.direction.z * (r.origin.x / -r.direction.x) == Approx(-1.5).epsilon(1e-3));
}

TEST_CASE("no black rims and no speckles: whatever faces the light is lit, up to the silhouette") {
    for (const float scale : {1e-6f, 1.0f, 1e6f}) {
        const std::vector<object<lantern::any_of<sphere, plane>, diffuse>> things{
            {sphere{{0, 0, 0}, scale}, diffuse{glm::vec3(1)}}, {plane{{0, -scale, 0}, {0, 1, 0}}, diffuse{glm::vec3(1)}}};
        const std::vector lights{point_light{{0, 0, 4 * scale}, glm::vec3(scale * scale)}};  // at the eye: no shadow can be seen
        const every all{2};
        const whitted tracer{all, things, lights};
        dice d{.state = 2};
        int black = 0;
        for (int i = 0; i < 20000; ++i) {
            const ray r{{0, 0, 4 * scale}, {d.between(-0.5, 0.5), d.between(-0.5, 0.1), -1}};
            const auto h = closest(all, things, r);
            if (h && -glm::dot(lantern::unit(r.direction), h->normal) > 1e-6f) black += tracer(r) == glm::vec3(0);
        }
        CHECK(black == 0);
    }
}

TEST_CASE("a picture does not depend on the scale of its scene") {
    std::vector<float> seen;
    for (const float scale : {1.0f, 0x1p-50f, 0x1p60f}) {
        const std::vector things{object{sphere{glm::vec3(0, 0, -3 * scale), scale}, lantern::blinn_phong{}},
                                 object{sphere{glm::vec3(0, -101 * scale, -3 * scale), 100 * scale}, lantern::blinn_phong{}}};
        const std::vector lights{point_light{glm::vec3(2, 4, 0) * scale, glm::vec3(40 * scale) * scale}};
        const every all{2};
        const whitted tracer{all, things, lights};
        std::size_t at = 0;
        for (float y = -0.6f; y < 0.6f; y += 0.07f)
            for (float x = -0.6f; x < 0.6f; x += 0.07f) {
                const float value = tracer(ray{{0, 0, 0}, lantern::unit({x, y, -1})}).x;
                if (scale == 1) seen.push_back(value);
                else REQUIRE(value == seen[at++]);  // powers of two change no digit
            }
    }
}

TEST_CASE("a tree and brute force give the same picture, to the last bit") {
    dice d{.state = 3};
    using material = std::variant<diffuse, mirror, glass>;
    std::vector<object<sphere, material>> things;
    for (int i = 0; i < 200; ++i) {
        const material m = i % 3 == 0 ? material(diffuse{}) : i % 3 == 1 ? material(mirror{}) : material(glass{});
        things.push_back({sphere{d.in_cube(3), d.between(0.1, 0.4)}, m});
    }
    const std::vector lights{point_light{{4, 4, 4}, glm::vec3(50)}};
    const every all{200};
    const lantern::bvh tree{things};
    const whitted slow{all, things, lights, white};
    const whitted fast{tree, things, lights, white};
    for (int i = 0; i < 1000; ++i) {
        const ray r{d.in_cube(5), d.in_cube()};
        REQUIRE(slow(r) == fast(r));
    }
}

TEST_CASE("a moving point light needs a time, and the shadow falls where the light then is") {
    const std::vector things{object{plane{{0, 0, 0}, {0, 1, 0}}, diffuse{glm::vec3(1)}},
                             object{plane{{0, 0, 0}, {0, 1, 0}}, diffuse{glm::vec3(1)}}};
    const std::vector lights{lantern::moving{point_light{{0, 2, 0}, glm::vec3(4)}, {0, 2, 0}}};
    const every all{1};
    const whitted tracer{all, things, lights};
    const ray down{{0, 1, 0}, {0, -1, 0}};
    CHECK(tracer(lantern::timed_ray{down, 0}).x == Approx(1 / std::numbers::pi));
    CHECK(tracer(lantern::timed_ray{down, 1}).x == Approx(0.25 / std::numbers::pi));
}

TEST_CASE("what cannot be is refused when the tracer is made") {
    const every all{1}, two{2};
    const std::vector bad{object{sphere{{0, 0, std::numeric_limits<float>::quiet_NaN()}, 1}, diffuse{}}};
    const std::vector good{object{sphere{}, diffuse{}}};
    CHECK_THROWS_WITH((whitted{all, bad, no_lights}), containing("things[0]: sphere: center"));
    CHECK_THROWS_WITH((whitted{two, good, no_lights}), containing("number of things"));
    const std::vector hole{point_light{{0, 0, 0}, glm::vec3(-1)}};
    CHECK_THROWS_WITH((whitted{all, good, hole}), containing("lights[0]: point_light: intensity"));
    CHECK_THROWS_WITH((whitted{all, good, no_lights, white, {.ambient = glm::vec3(-1)}}), containing("whitted: ambient"));
}
