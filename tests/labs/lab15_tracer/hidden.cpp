// SPDX-License-Identifier: MIT
// Lab 15: hidden tests.

#include "contract.hpp"

#include <catch.hpp>
#include <hidden.hpp>

#include <lantern/samples.hpp>
#include <lantern/sky.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
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
    std::vector<std::vector<std::uint32_t>> paths;
    [[nodiscard]] draw source() {
        return [this](std::uint32_t dimensions, std::uint32_t p, std::uint32_t which, std::span<const std::uint32_t> path) {
            purposes.push_back(p);
            paths.emplace_back(path.begin(), path.end());
            return answer(dimensions, p, which, path.size());
        };
    }
    [[nodiscard]] static glm::vec2 answer(std::uint32_t dimensions, std::uint32_t p, std::uint32_t which, std::size_t length) {
        numbers random(p * 1000 + which * 100 + dimensions * 10 + length);
        return hidden::point(random);
    }
    [[nodiscard]] std::ptrdiff_t of(purpose p) const { return std::ranges::count(purposes, std::uint32_t(p)); }
};

/// A place and three directions at right angles, so that no plane is a coordinate's: a × b points against `up`.
struct frame {
    glm::vec3 origin, a, up, b;
    explicit frame(numbers& random) : origin(random.vector()), up(random.direction()) {
        a = glm::normalize(glm::cross(up, std::abs(up.x) < 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0)));
        b = glm::cross(a, up);
    }
    [[nodiscard]] glm::vec3 at(float x, float height, float z) const { return origin + x * a + height * up + z * b; }
    /// A square sheet, seen from below by its u × v.
    [[nodiscard]] lantern::rectangle sheet(float x, float height, float z, float half) const { return {at(x - half, height, z - half), 2 * half * a, 2 * half * b}; }
    [[nodiscard]] lantern::rectangle ground() const { return {at(-9, 0, 9), 18.0f * a, -18.0f * b}; }
};

/// How many rays are shot into a room, and what is seen.
struct sight {
    glm::vec3 light{0};
    int rays = 0;
    counted drawn_here;
};
sight into(const room& r, const lantern::ray& along, std::uint32_t depth, std::optional<float> time = std::nullopt) {
    sight s;
    s.light = radiance(r, along, time, depth, s.drawn_here.source(), [&](const lantern::ray&, std::optional<float>, lantern::interval) { ++s.rays; });
    return s;
}

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

TEST_CASE("any two sets of samples", "[step2]") {
    numbers random = hidden::drawn(9);
    for (int i = 0; i < 30; ++i) {
        const std::uint32_t side = 6 + hidden::below(random, 6), dimensions = 1 + hidden::below(random, 2), p = hidden::below(random, 10);
        const std::uint64_t seed = hidden::below(random, 1u << 24);
        const question q{dimensions, p, hidden::below(random, 4)};
        question purpose_ = q, which = q, path = q;
        purpose_.purpose = (p + 1 + hidden::below(random, 9)) % 10;
        ++which.which;
        path.path.push_back(hidden::below(random, 2));
        const glm::uvec2 pixel{hidden::below(random, 4000), hidden::below(random, 4000)};
        const auto one = drawn(side, seed, pixel, q);
        for (const auto& other : {drawn(side, seed, pixel, purpose_), drawn(side, seed, pixel, which), drawn(side, seed, pixel, path),
                                  drawn(side, seed + 1, pixel, q), drawn(side, seed, pixel + glm::uvec2(i % 2, 1 - i % 2), q)}) {
            // Of 36 samples or more one is in its old cell, on average, and none at its old place there; half of them are never.
            REQUIRE(other.size() == one.size());
            const float cells = dimensions == 1 ? float(side * side) : float(side);
            std::size_t same_cell = 0, same_place = 0;
            for (std::size_t k = 0; k < one.size(); ++k) {
                const glm::vec2 a = one[k] * cells, b = other[k] * cells;
                const int n = dimensions == 1 ? 1 : 2;
                bool cell = true, place = true;
                for (int axis = 0; axis < n; ++axis) {
                    cell = cell && std::floor(a[axis]) == std::floor(b[axis]);
                    place = place && std::abs((a[axis] - std::floor(a[axis])) - (b[axis] - std::floor(b[axis]))) < 1e-4f;
                }
                same_cell += cell ? 1 : 0, same_place += place ? 1 : 0;
            }
            CHECK(same_cell < one.size() / 2);
            CHECK(same_place < one.size() / 2);
        }
    }
    const auto last = [](std::uint32_t, std::uint32_t count, std::uint32_t, glm::uvec2) { return count - 1; };
    const auto jitter = [](std::uint32_t, std::uint32_t, glm::vec2 xi) { return xi; };
    for (int i = 0; i < 500; ++i)
        REQUIRE(drawn_with(1000, hidden::below(random, 1u << 24), {hidden::below(random, 4000), 7}, 5, {1, hidden::below(random, 10), 0}, jitter, last).x < 1);
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
    const meet_part part = [](glm::vec3 center, glm::vec3 velocity, float radius, glm::vec3 origin, glm::vec3 direction, float at) -> std::optional<float> {
        const glm::dvec3 along(direction), away = glm::dvec3(origin) - glm::dvec3(center) - double(at) * glm::dvec3(velocity);
        const double a = glm::dot(along, along), p = glm::dot(away, along), root = std::sqrt(p * p - a * (glm::dot(away, away) - double(radius) * radius));
        for (const double t : {(-p - root) / a, (-p + root) / a})
            if (t > 0) return float(t);
        return std::nullopt;
    };
    for (int i = 0; i < 400; ++i) {
        // Well within the ball, from near and far; the range begins before it or in it, or ends before it.
        const body ball{random.vector(), random.between(0.2f, 1), 2.0f * random.vector()};
        const float time = random.unit(), far = hidden::magnitude(random, 3, 300);
        const glm::dvec3 middle = glm::dvec3(ball.center) + double(time) * glm::dvec3(*ball.velocity);
        const glm::vec3 aim = glm::vec3(middle) + 0.8f * random.unit() * ball.radius * random.direction(), origin = aim + far * random.direction();
        const lantern::ray r{origin, random.between(0.1f, 3) * (aim - origin)};
        const glm::dvec3 d(r.direction), from = glm::dvec3(r.origin) - middle;
        const double a = glm::dot(d, d), p = glm::dot(from, d), root = std::sqrt(p * p - a * (glm::dot(from, from) - double(ball.radius) * ball.radius));
        const double in = (-p - root) / a, out = (-p + root) / a;
        const std::array<lantern::interval, 4> ranges{{{0, lantern::infinity}, {float(0.5 * (in + out)), lantern::infinity}, {0, float(0.999 * in - 0.001 * out)}, {float(0.5 * in), float(0.5 * (in + out))}}};
        const auto h = intersect(ball, r, time, ranges[std::size_t(i % 4)], part);
        CHECK(h.has_value() == (i % 4 != 2));
        if (!h) continue;
        const double expected = i % 4 == 1 ? out : in;
        CHECK(std::abs(double(h->t) - expected) < 1e-4 * expected);
        const glm::dvec3 outwards = glm::dvec3(h->point) - middle;
        CHECK(std::abs(glm::length(outwards) - double(ball.radius)) < 1.5e-6);
        CHECK(hidden::apart(glm::dvec3(h->normal), outwards / double(ball.radius)) < 1e-5);
        CHECK(glm::length(glm::dvec3(r.origin) + expected * d - glm::dvec3(h->point)) < 1e-5 * double(3 + far));
    }
}

TEST_CASE("any ball's box", "[step5]") {
    numbers random = hidden::drawn(10);
    const bounds_part part = [](glm::vec3 center, glm::vec3 velocity, float radius, float open, float close) {
        const glm::vec3 first = center + open * velocity, last = center + close * velocity;
        return std::pair{glm::min(first, last) - radius, glm::max(first, last) + radius};
    };
    for (int i = 0; i < 200; ++i) {
        body ball{hidden::magnitude(random, 1, 1e6f) * random.vector(), random.between(0.1f, 2)};
        if (i % 3 != 0) ball.velocity = 5.0f * random.vector();
        const lantern::aabb box = bounds(ball, part);
        const glm::vec3 size = glm::max(glm::abs(box.min), glm::abs(box.max));
        const double largest = double(std::max({size.x, size.y, size.z})), little = 2 * 8 * largest * 0x1p-24;  // 8 ulp
        for (int axis = 0; axis < 3; ++axis) {
            const double c = ball.center[axis], v = ball.velocity ? double((*ball.velocity)[axis]) : 0;
            const double low = std::min(c, c + v) - double(ball.radius), high = std::max(c, c + v) + double(ball.radius);
            CHECK((double(box.min[axis]) <= low && double(box.min[axis]) >= low - little));
            CHECK((double(box.max[axis]) >= high && double(box.max[axis]) <= high + little));
        }
    }
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
        const std::uint32_t depth = 1 + hidden::below(random, 3);  // one is enough
        const glm::vec3 got = radiance(r, {eye, direction}, std::nullopt, depth, c.source(), [&](const lantern::ray&, std::optional<float>, lantern::interval) { ++rays; });
        const float d2 = glm::dot(way, way), arrives = shaded ? 0 : way.y / std::sqrt(d2) / d2;
        const glm::vec3 expected = tint * albedo * (ambient + arrives / std::numbers::pi_v<float>);
        CHECK(hidden::apart(got, expected) < 2e-4);
        CHECK(rays == 3);
        CHECK(c.purposes.empty());
    }
}

TEST_CASE("any lamps", "[step6]") {
    numbers random = hidden::drawn(11);
    for (int i = 0; i < 60; ++i) {
        // A floor askew, lamps above it, and sheets that are just now between it and some of them.
        const frame f(random);
        const float time = random.between(0.2f, 1), x = random.between(-3, 3), z = random.between(-3, 3);
        const glm::vec3 albedo = color(random), point = f.at(x, 0, z);
        room r{.walls = {{.shape = f.ground(), .color = albedo}}};
        const std::uint32_t count = 1 + hidden::below(random, 3);
        glm::dvec3 expected(0);
        for (std::uint32_t k = 0; k < count; ++k) {
            const float half = random.between(0.1f, 0.4f);
            const lantern::rectangle lamp = f.sheet(x + 2 * float(k) - 2, random.between(4, 7), z + random.between(-2, 2), half);
            r.lamps.push_back(lamp);
            const glm::vec2 xi = counted::answer(2, std::uint32_t(purpose::light), k, 0);
            const glm::vec3 there = lamp.corner + xi.x * lamp.u + xi.y * lamp.v;
            if (random.unit() < 0.4f) {
                const glm::vec3 between = point + 0.8f * (there - point), velocity = random.between(2, 5) * f.a;
                r.walls.push_back({.shape = {between - 0.1f * (f.a + f.b) - time * velocity, 0.2f * f.a, 0.2f * f.b}, .velocity = velocity});
                continue;
            }
            const glm::dvec3 way = glm::dvec3(there) - glm::dvec3(point);
            const double d2 = glm::dot(way, way), height = glm::dot(way, glm::dvec3(f.up)), area = 4.0 * double(half) * double(half);
            expected += glm::dvec3(albedo) * (area * height * height / (d2 * d2) / std::numbers::pi);
        }
        const glm::vec3 eye = f.at(x + random.between(2, 3), random.between(0.3f, 0.5f), z);
        const sight s = into(r, {eye, point - eye}, 2, time);
        CHECK(hidden::apart(glm::dvec3(s.light), expected) < 1e-4);
        CHECK(s.drawn_here.of(purpose::light) == std::ptrdiff_t(count));
        CHECK(s.rays == 1 + int(count));
    }
}

TEST_CASE("any glass", "[step6]") {
    numbers random = hidden::drawn(12);
    for (int i = 0; i < 40; ++i) {
        const frame f(random);
        const glm::vec3 tint = color(random), behind = color(random), before = color(random), horizon = color(random), zenith = color(random);
        const lantern::ray r{f.at(0, 3, 0), random.between(0.2f, 4) * (f.at(random.between(-0.4f, 0.4f), 1, 0) - f.at(0, 3, 0))};
        room glass{.walls = {{.shape = f.ground(), .made_of = substance::shining, .color = behind},
                             {.shape = f.sheet(0, 1, 0, 9), .made_of = substance::glass, .color = tint},
                             {.shape = f.sheet(0, 5, 0, 9), .made_of = substance::shining, .color = before}}};
        CHECK(hidden::apart(into(glass, r, 1).light, tint * behind + 0.5f * before) < 1e-5);
        glass.walls[1].color = glm::vec3(0);
        CHECK(into(glass, r, 1).rays == 2);  // none for what is black
        glass.walls[0].made_of = glass.walls[2].made_of = substance::frosted;
        glass.walls[1].color = tint;
        auto paths = into(glass, r, 2).drawn_here.paths;
        std::ranges::sort(paths);
        CHECK(paths == std::vector<std::vector<std::uint32_t>>{{0}, {1}});
        CHECK(into(glass, r, 1).drawn_here.purposes.empty());  // nothing is drawn for a ray that is not shot
        const glm::vec3 upwards = random.between(0.2f, 4) * random.direction();
        CHECK(hidden::apart(into({.walls = {}, .horizon = horizon, .zenith = zenith}, {f.origin, upwards}, 2).light,
                            lantern::radiance(lantern::sky{horizon, zenith}, glm::normalize(upwards))) < 1e-5);
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

TEST_CASE("any row of boxes", "[step7]") {
    numbers random = hidden::drawn(13);
    for (int i = 0; i < 40; ++i) {
        // Along an axis; whatever is offered may end the search, or leave all.
        const int axis = i % 3;
        const float sign = random.unit() < 0.5f ? -1.0f : 1.0f, zero = random.unit() < 0.5f ? 0.0f : -0.0f, length = random.between(0.2f, 4);
        lantern::ray r{random.vector(), glm::vec3(zero)};
        r.direction[axis] = sign * length;
        std::vector<lantern::aabb> row;
        float at = 1;
        for (std::uint32_t k = 0; k < 6; ++k, at += 3) {
            glm::vec3 low = r.origin - random.between(0.5f, 2), high = r.origin + random.between(0.5f, 2);
            const float first = r.origin[axis] + sign * at, last = first + sign * random.between(0.5f, 2);
            low[axis] = std::min(first, last), high[axis] = std::max(first, last);
            row.push_back({low, high});
        }
        const auto all = entries(row, r, {});
        for (std::uint32_t k = 0; k < 6; ++k) {
            REQUIRE(all[k].has_value());
            CHECK(std::abs(double(*all[k]) * double(length) - (1 + 3.0 * k)) < 1e-4);
        }
        const std::uint32_t end = hidden::below(random, 6);
        std::vector<std::uint32_t> offered;
        traverse(row, r, {}, [&](std::uint32_t k, lantern::interval rest) -> lantern::interval {
            offered.push_back(k);
            return k == end ? lantern::interval{0, 0} : rest;
        });
        CHECK(offered.size() == end + 1);
    }
}

TEST_CASE("any scene", "[step8]") {
    numbers random = hidden::drawn(8);
    for (int i = 0; i < 24; ++i) {
        const bool opened = random.unit() < 0.5f, moving = random.unit() < 0.5f, blurs = random.unit() < 0.5f;
        stage s{.from = {.axes = glm::mat3{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}, .half = {0.5f, 0.4f}, .lens = glm::vec2(opened ? 0.05f : 0, 5), .exposure = glm::vec2(0.2f, 0.9f)}};
        const std::uint32_t count = 2 + hidden::below(random, 6), one = hidden::below(random, count);
        for (std::uint32_t k = 0; k < count; ++k)
            s.marbles.push_back({.center = glm::vec3(0, 0, -5) + 1.5f * random.vector(), .radius = random.between(0.3f, 0.9f), .color = color(random)});
        if (moving) s.marbles[one].velocity = hidden::magnitude(random, 1e-7f, 0.5f) * random.direction();
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
