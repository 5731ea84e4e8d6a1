// SPDX-License-Identifier: MIT
// Lab 15: hidden tests.

#include "contract.hpp"

#include <catch.hpp>
#include <hidden.hpp>

#include <lantern/samples.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

using namespace contract::lab15;
using lantern::purpose;

namespace {

glm::vec3 color(numbers& random) { return 0.5f * (random.vector() + 1.0f); }

/// Numbers that depend on what they are for, and are counted.
struct counted {
    std::vector<std::uint32_t> purposes;
    [[nodiscard]] draw source() {
        return [this](std::uint32_t dimensions, std::uint32_t p, std::uint32_t which, std::span<const std::uint32_t> path) {
            purposes.push_back(p);
            numbers random(p * 1000 + which * 100 + dimensions * 10 + path.size());
            return hidden::point(random);
        };
    }
    [[nodiscard]] std::ptrdiff_t of(purpose p) const { return std::ranges::count(purposes, std::uint32_t(p)); }
};

}  // namespace

TEST_CASE("any camera", "[step1]") {
    numbers random = hidden::drawn(1);
    for (int i = 0; i < 40; ++i) {
        const bool optics = i % 2 == 0, shutter = i % 4 < 2;
        const glm::vec2 half{random.between(0.1f, 2), random.between(0.1f, 2)}, film = hidden::point(random);
        const glm::vec2 place{(2 * film.x - 1) * half.x, (1 - 2 * film.y) * half.y};
        viewer v{random.vector(), glm::mat3(1), half};
        if (optics) v.lens = glm::vec2(random.unit(), random.between(1, 9));
        if (shutter) v.exposure = glm::vec2(0.25f * random.unit(), 0.5f + 0.5f * random.unit());
        glm::vec2 seen(9);
        const lens_part lens = [&](glm::vec3 eye, glm::mat3, glm::vec2 f, float radius, float, glm::vec2) {
            seen = f;
            return lantern::ray{eye + radius, {0, 0, 1}};
        };
        counted c;
        const shot got = shoot(v, film, lens, [](float open, float close, float) { return 0.5f * (open + close); }, c.source());
        CHECK(glm::length(seen - place) < 1e-5f);
        CHECK(got.ray.origin == v.eye + (optics ? v.lens->x : 0.0f));
        CHECK(c.of(purpose::lens) == (optics ? 1 : 0));
        CHECK(c.of(purpose::time) == (shutter ? 1 : 0));
        CHECK(got.time.has_value() == shutter);
        if (shutter) CHECK(got.time == 0.5f * (v.exposure->x + v.exposure->y));
    }
}

TEST_CASE("any set of samples", "[step2]") {
    numbers random = hidden::drawn(2);
    for (int i = 0; i < 60; ++i) {
        const std::uint32_t side = 1 + hidden::below(random, 12), dimensions = 1 + hidden::below(random, 2);
        question q{dimensions, hidden::below(random, 10), hidden::below(random, 4)};
        for (std::uint32_t k = hidden::below(random, 3); k > 0; --k) q.path.push_back(hidden::below(random, 2));
        const glm::uvec2 pixel{hidden::below(random, 4000), hidden::below(random, 4000)};
        std::set<std::pair<int, int>> cells;
        const auto all = drawn(side, hidden::below(random, 1u << 24), pixel, q);
        for (const glm::vec2 p : all) {
            REQUIRE((p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1));
            cells.insert(dimensions == 1 ? std::pair{int(p.x * float(side * side)), 0} : std::pair{int(p.x * float(side)), int(p.y * float(side))});
        }
        CHECK(all.size() == side * side);
        CHECK(cells.size() == all.size());
    }
}

TEST_CASE("any lamp", "[step3]") {
    numbers random = hidden::drawn(3);
    const place_part place = [](const lantern::rectangle& lamp, glm::vec2 xi) { return lamp.corner + xi.x * lamp.u + xi.y * lamp.v; };
    for (int i = 0; i < 100; ++i) {
        const lantern::rectangle shape{random.vector(), 2.0f * random.direction(), 0.5f * random.direction()};
        if (glm::length(glm::cross(shape.u, shape.v)) < 0.05f) continue;
        const glm::vec3 point = 4.0f * random.direction(), radiance_ = color(random);
        const glm::vec2 xi = hidden::point(random);
        const irradiance_part brings = [](const lantern::rectangle&, glm::vec3 radiance_here, glm::vec3 on_lamp, glm::vec3 position, glm::vec3 normal) {
            return radiance_here * glm::dot(normal, on_lamp - position);  // a length, where the normal faces the point
        };
        const auto got = illuminate(shape, radiance_, point, xi, place, brings);
        const glm::vec3 there = place(shape, xi);
        CHECK(hidden::apart(got.irradiance, radiance_ * glm::length(there - point)) < 1e-5);
        CHECK(glm::length(got.position - there) < 1e-5f);
        const glm::vec3 normal = glm::normalize(glm::cross(shape.u, shape.v));
        CHECK(glm::dot(glm::dvec3(got.position) - glm::dvec3(shape.corner), glm::dvec3(normal)) > 0);
    }
}

TEST_CASE("any coat", "[step4]") {
    numbers random = hidden::drawn(4);
    for (int i = 0; i < 50; ++i) {
        const glm::vec3 in = random.direction(), tint = color(random);
        const lantern::hit h{1, random.vector(), random.direction(), 0};
        const float width = random.unit();
        const glm::vec2 xi = hidden::point(random);
        const gloss_part part = [&](glm::vec3 i_, glm::vec3 normal, float w, glm::vec2 x) { return i_ + 10.0f * normal + w * glm::vec3(x, 0); };
        const glm::vec3 front = glm::dot(h.normal, in) > 0 ? -h.normal : h.normal;
        const auto blurred = scatter(tint, width, in, h, xi, part), sharp = scatter_sharp(tint, in, h, part);
        REQUIRE(blurred.size() == 1);
        REQUIRE(sharp.size() == 1);
        CHECK(blurred[0].direction == in + 10.0f * front + width * glm::vec3(xi, 0));
        CHECK(sharp[0].direction == in + 10.0f * front);
        CHECK(blurred[0].weight == tint);
        CHECK(sharp[0].weight == tint);
    }
}

TEST_CASE("any ball", "[step5]") {
    numbers random = hidden::drawn(5);
    hidden::agreement agreed;
    for (int i = 0; i < 400; ++i) {
        const body b{random.vector(), random.between(0.2f, 1), 2.0f * random.vector()};
        const float time = random.unit();
        const lantern::ray r{4.0f * random.direction(), random.vector()};
        const lantern::interval range{random.between(0, 4), random.between(2, 12)};
        const glm::dvec3 d(r.direction), from = glm::dvec3(r.origin) - glm::dvec3(b.center) - double(time) * glm::dvec3(*b.velocity);
        const double a = glm::dot(d, d), p = glm::dot(from, d), root = std::sqrt(p * p - a * (glm::dot(from, from) - double(b.radius) * b.radius));
        std::optional<double> expected;
        for (const double t : {(-p - root) / a, (-p + root) / a})
            if (!expected && t > double(range.min) && t <= double(range.max)) expected = t;
        const meet_part part = [](glm::vec3 center, glm::vec3 velocity, float radius, glm::vec3 origin, glm::vec3 direction, float at) -> std::optional<float> {
            const glm::dvec3 along(direction), away = glm::dvec3(origin) - glm::dvec3(center) - double(at) * glm::dvec3(velocity);
            const double aa = glm::dot(along, along), pp = glm::dot(away, along), rr = std::sqrt(pp * pp - aa * (glm::dot(away, away) - double(radius) * radius));
            for (const double t : {(-pp - rr) / aa, (-pp + rr) / aa})
                if (t > 0) return float(t);
            return std::nullopt;
        };
        const auto h = intersect(b, r, time, range, part);
        agreed.count(h.has_value() == expected.has_value());
        if (!h || !expected) continue;
        agreed.count(std::abs(double(h->t) - *expected) < 1e-4 * (1 + *expected));
        const glm::dvec3 out = glm::dvec3(h->point) - glm::dvec3(b.center) - double(time) * glm::dvec3(*b.velocity);
        CHECK(std::abs(glm::length(out) - double(b.radius)) < 1e-6);
        CHECK(hidden::apart(glm::dvec3(h->normal), out / double(b.radius)) < 1e-5);
    }
    CHECK(agreed.holds());
}

TEST_CASE("any room", "[step6]") {
    numbers random = hidden::drawn(6);
    for (int i = 0; i < 60; ++i) {
        // A mirror above a floor shows the floor, which a lamp like a point lights, unless something is between.
        const float height = random.between(2, 4);
        const glm::vec3 tint = color(random), albedo = color(random), ambient = color(random), eye{random.between(-1, 1), 1, random.between(-1, 1)};
        const glm::vec3 direction = glm::normalize(glm::vec3(random.between(-0.3f, 0.3f), 1, random.between(-0.3f, 0.3f)));
        const glm::vec3 up = eye + direction * ((height - 1) / direction.y), point = up + glm::vec3(direction.x, -direction.y, direction.z) * (height / direction.y);
        const glm::vec3 lamp{point.x + random.between(0.6f, 1.5f), 0.75f, point.z + random.between(-1, 1)};  // far from where the ray comes down
        const bool shaded = i % 3 == 0;
        room r{.walls = {{.shape = {{-20, 0, 20}, {40, 0, 0}, {0, 0, -40}}, .color = albedo},
                         {.shape = {{-20, height, -20}, {40, 0, 0}, {0, 0, 40}}, .made_of = substance::mirror, .color = tint}},
               .points = {lamp},
               .ambient = ambient};
        const glm::vec3 way = lamp - point, middle = point + 0.5f * way;
        if (shaded) r.walls.push_back({.shape = {middle - glm::vec3(0.05f, 0, 0.05f), {0.1f, 0, 0}, {0, 0, 0.1f}}});
        int rays = 0;
        counted c;
        const glm::vec3 got = radiance(r, {eye, direction}, std::nullopt, 3, c.source(), [&](const lantern::ray&, std::optional<float>, lantern::interval) { ++rays; });
        const float d2 = glm::dot(way, way), arrives = shaded ? 0 : way.y / std::sqrt(d2) / d2;
        const glm::vec3 expected = tint * albedo * (ambient + arrives / std::numbers::pi_v<float>);
        CHECK(hidden::apart(got, expected) < 2e-4);
        CHECK(rays == 3);
        CHECK(c.purposes.empty());
    }
}

TEST_CASE("any box", "[step7]") {
    numbers random = hidden::drawn(7);
    hidden::agreement agreed;
    for (int i = 0; i < 40; ++i) {
        const lantern::ray r{4.0f * random.vector(), random.between(0.1f, 3) * random.direction()};
        std::vector<lantern::aabb> boxes;
        for (int k = 0; k < 20; ++k) {
            const glm::vec3 a = 5.0f * random.vector(), b = 5.0f * random.vector();
            boxes.push_back({glm::min(a, b), glm::max(a, b)});
        }
        const auto all = entries(boxes, r, {});
        REQUIRE(all.size() == boxes.size());
        for (std::size_t k = 0; k < boxes.size(); ++k) {
            double near = 0, far = INFINITY;
            for (int axis = 0; axis < 3; ++axis) {
                const double o = r.origin[axis], d = r.direction[axis];
                const double one = (double(boxes[k].min[axis]) - o) / d, other = (double(boxes[k].max[axis]) - o) / d;
                near = std::max(near, std::min(one, other));
                far = std::min(far, std::max(one, other));
            }
            agreed.count(all[k].has_value() == (near <= far));
            if (all[k] && near <= far) CHECK((double(*all[k]) <= near && double(*all[k]) >= near * (1 - 1e-5)));
        }
    }
    CHECK(agreed.holds());
}

TEST_CASE("any scene", "[step8]") {
    numbers random = hidden::drawn(8);
    for (int i = 0; i < 24; ++i) {
        const bool opened = random.unit() < 0.5f, moving = random.unit() < 0.5f, blurs = random.unit() < 0.5f;
        stage s{.from = {.axes = glm::mat3{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}, .half = {0.5f, 0.4f}, .lens = glm::vec2(opened ? 0.05f : 0, 5), .exposure = glm::vec2(0.2f, 0.9f)}};
        const std::uint32_t count = 2 + hidden::below(random, 6), one = hidden::below(random, count);
        for (std::uint32_t k = 0; k < count; ++k)
            s.marbles.push_back({.center = glm::vec3(0, 0, -5) + 1.5f * random.vector(), .radius = random.between(0.3f, 0.9f), .color = color(random)});
        if (moving) s.marbles[one].velocity = 0.5f * random.vector();
        if (blurs) s.marbles[one].width = random.between(0.01f, 1);
        counted c, all;
        const visited less = left_out(s, false, {6, 4}, c.source()), whole = left_out(s, true, {6, 4}, all.source());
        CHECK(less.lens == opened);
        CHECK(less.motion == moving);
        CHECK(less.shutter == moving);
        CHECK(less.blur == blurs);
        CHECK(c.of(purpose::lens) == (opened ? 24 : 0));
        CHECK(c.of(purpose::time) == (moving ? 24 : 0));
        if (!blurs) CHECK(c.of(purpose::gloss) == 0);
        REQUIRE(less.seen.size() == whole.seen.size());
        bool same = true;
        for (std::size_t k = 0; k < less.seen.size(); ++k)
            for (int axis = 0; axis < 3; ++axis) same = same && std::bit_cast<std::uint32_t>(less.seen[k][axis]) == std::bit_cast<std::uint32_t>(whole.seen[k][axis]);
        CHECK(same);
    }
}
