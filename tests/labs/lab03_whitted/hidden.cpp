// SPDX-License-Identifier: MIT
// Lab 03's hidden tests: the solution's answers, for directions, materials and scenes drawn anew for each grading.

#include "contract.hpp"

#include <catch.hpp>
#include <hidden.hpp>

#include <lab03_whitted/whitted.hpp>

using namespace contract::lab03;

namespace {

glm::vec3 color(numbers& random) { return 0.5f + 0.5f * random.vector(); }

/// A direction that comes in from the side of the normal, not too flat.
glm::vec3 incoming(numbers& random, glm::vec3 normal) {
    for (;;) {
        const glm::vec3 d = random.direction();
        if (glm::dot(d, normal) < -0.02f) return d;
    }
}

/// Some balls over a floor, the same for the suite and for the solution.
struct both {
    contract::lab03::scene asked;
    lab03::scene ours;
    explicit both(numbers& random) {
        asked.ambient = ours.ambient = 0.2f * color(random);
        asked.horizon = ours.horizon = color(random);
        asked.zenith = ours.zenith = color(random);
        add(lantern::plane{{0, -1, 0}, {0, 1, 0}}, contract::lab03::matte{color(random), glm::vec3(0), 10}, lab03::matte{});
        for (int i = 0; i < 4; ++i) {
            const lantern::sphere ball{2.5f * random.vector(), random.between(0.4f, 1)};
            const float kind = random.unit();
            if (kind < 0.4f) add(ball, contract::lab03::matte{color(random), 0.3f * color(random), random.between(5, 60)}, lab03::matte{});
            else if (kind < 0.7f) add(ball, contract::lab03::mirror{color(random)}, lab03::mirror{});
            else add(ball, contract::lab03::glass{random.between(1.2f, 2), color(random)}, lab03::glass{});
        }
        for (int i = 0; i < 2; ++i) {
            const glm::vec3 position = glm::vec3(0, 6, 0) + 3.0f * random.vector(), intensity = 30.0f * color(random);
            asked.lights.push_back({position, intensity});
            ours.lights.push_back({position, intensity});
        }
    }

private:
    template <class Shape, class Asked, class Ours>
    void add(Shape shape, Asked a, Ours o) {
        if constexpr (requires { a.body; }) o = {a.body, a.highlight, a.exponent};
        else if constexpr (requires { a.index; }) o = {a.index, a.color};
        else o = {a.color};
        asked.things.push_back({shape, a});
        ours.things.push_back({lab03::shape(shape), lab03::material(o)});
    }
};

}  // namespace

TEST_CASE("any light on any matt body", "[step1]") {
    numbers random = hidden::drawn(1);
    hidden::agreement all;
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 body = color(random), highlight = color(random), n = random.direction(), l = random.direction(), e = random.direction();
        const float exponent = random.between(1, 100);
        all.count(hidden::apart(shade({body, highlight, exponent}, n, l, e), lab03::shade({body, highlight, exponent}, n, l, e)) < 1e-3);
    }
    CHECK(all.holds());
}

TEST_CASE("any shadow", "[step2]") {
    numbers random = hidden::drawn(2);
    hidden::agreement all;
    for (int i = 0; i < 30; ++i) {
        const both scene(random);
        for (int k = 0; k < 10; ++k) {
            const lantern::ray r{{0, 1, 7}, random.vector() + glm::vec3(0, -0.3f, -3)};
            const auto h = closest(scene.ours, r);
            if (!h) continue;
            const glm::vec3 light = scene.ours.lights[0].position;
            all.count(lit(scene.asked, static_cast<const lantern::hit&>(*h), light) == lab03::lit(scene.ours, *h, light));
        }
    }
    CHECK(all.holds());
}

TEST_CASE("any reflection", "[step3]") {
    numbers random = hidden::drawn(3);
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 in = random.direction(), n = random.direction();
        CHECK(hidden::apart(reflected(in, n), lab03::reflected(in, n)) < 1e-5);
    }
}

TEST_CASE("any refraction", "[step4]") {
    numbers random = hidden::drawn(4);
    hidden::agreement all;
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 n = random.direction(), in = incoming(random, n);
        const float ratio = random.between(0.4f, 2.5f);
        all.count(hidden::apart(refracted(in, n, ratio), lab03::refracted(in, n, ratio)) < 1e-3);
    }
    CHECK(all.holds());
}

TEST_CASE("any part that is reflected", "[step5]") {
    numbers random = hidden::drawn(5);
    hidden::agreement all;
    for (int i = 0; i < 300; ++i) {
        const float cosine = random.between(0.01f, 1), ratio = random.between(0.4f, 2.5f);
        all.count(hidden::apart(reflectance(cosine, ratio), lab03::reflectance(cosine, ratio)) < 1e-3);
    }
    CHECK(all.holds());
}

TEST_CASE("any ray through any scene", "[step6]") {
    numbers random = hidden::drawn(6);
    hidden::agreement all;
    for (int i = 0; i < 20; ++i) {
        const both scene(random);
        for (int k = 0; k < 15; ++k) {
            const lantern::ray r{{0, 1, 7}, hidden::magnitude(random, 0.1f, 10) * (random.vector() + glm::vec3(0, -0.3f, -3))};
            const int depth = int(hidden::below(random, 4));
            // Behind three curved surfaces a difference in the last bits has grown.
            all.count(hidden::apart(trace(scene.asked, r, depth), lab03::trace(scene.ours, r, depth)) < 1e-2);
        }
    }
    CHECK(all.holds());
}
