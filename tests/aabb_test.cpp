// SPDX-License-Identifier: MIT
#include <lantern/aabb.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

using lantern::aabb;
using lantern::interval;
using lantern::ray;

namespace {

constexpr float nan_value = std::numeric_limits<float>::quiet_NaN();
constexpr int count = 10000;

/// Three slabs with 113 bits; a face's plane counts as the box.
bool truly_overlaps(const aabb& box, const ray& r, interval range) {
    wide near = range.min, far = range.max;
    for (int i = 0; i < 3; ++i) {
        const wide o = r.origin[i], d = r.direction[i], lo = wide(box.min[i]) - o, hi = wide(box.max[i]) - o;
        if (r.direction[i] == 0) {
            if (lo > 0 || hi < 0) return false;
            continue;
        }
        near = std::max(near, std::min(lo / d, hi / d));
        far = std::min(far, std::max(lo / d, hi / d));
    }
    return near <= far;
}

aabb random_box(dice& d, double size) {
    const glm::vec3 a = d.in_cube(size), b = d.in_cube(size);
    return lantern::enclose({a, a}, b);
}

/// One of few values, so that coincidences are the rule.
float coarse(dice& d) { return static_cast<float>(d.below(5)) - 2.0f; }

}  // namespace

TEST_CASE("the default box is empty, and enclosing anything gives that thing") {
    const aabb nothing;
    CHECK(empty(nothing));
    CHECK(surface_area(nothing) == 0);
    const aabb box{{-1, 0, 2}, {1, 3, 4}};
    CHECK_FALSE(empty(box));
    CHECK(enclose(nothing, box).min == box.min);
    CHECK(enclose(box, nothing).max == box.max);
    const aabb point = enclose(nothing, glm::vec3(1, 2, 3));
    CHECK(point.min == glm::vec3(1, 2, 3));
    CHECK(point.max == glm::vec3(1, 2, 3));
    CHECK_FALSE(empty(point));
    CHECK(empty(aabb{{0, 0, 0}, {1, -1, 1}}));
    CHECK(empty(aabb{{0, 0, nan_value}, {1, 1, 1}}));
}

TEST_CASE("the union contains both, and is the smallest box that does") {
    dice d{1};
    for (int i = 0; i < 1000; ++i) {
        const aabb a = random_box(d, 5), b = random_box(d, 5), both = enclose(a, b);
        for (const aabb& part : {a, b}) REQUIRE((contains(both, part.min) && contains(both, part.max)));
        for (int k = 0; k < 3; ++k) {
            REQUIRE((both.min[k] == a.min[k] || both.min[k] == b.min[k]));
            REQUIRE((both.max[k] == a.max[k] || both.max[k] == b.max[k]));
        }
    }
}

TEST_CASE("center and surface area") {
    const aabb box{{-1, 0, 2}, {1, 3, 8}};
    CHECK(center(box) == glm::vec3(0, 1.5f, 5));
    CHECK(surface_area(box) == 2 * (2 * 3 + 3 * 6 + 6 * 2));
    CHECK(surface_area(aabb{{0, 0, 0}, {2, 3, 0}}) == 12);
    const float most = std::numeric_limits<float>::max();
    CHECK(center(aabb{{most, -most, -most}, {most, most, -most}}) == glm::vec3(most, 0, -most));
    CHECK(std::isfinite(surface_area(aabb{glm::vec3(-1e30f), glm::vec3(1e30f)})));
}

TEST_CASE("what is grown or moved is rounded outwards, by less than two ulp") {
    dice d{2};
    for (int i = 0; i < count; ++i) {
        const glm::vec3 p = d.in_cube(), by = glm::abs(d.magnitude_between(-12, 3) * d.in_cube());
        const aabb wider = lantern::grown({p, p}, by), away = lantern::moved({p, p}, by);
        for (int k = 0; k < 3; ++k) {
            const wide lo = wide(p[k]) - wide(by[k]), hi = wide(p[k]) + wide(by[k]);
            REQUIRE((wide(wider.min[k]) <= lo && error_in_ulp(wider.min[k], lo) <= 1));
            REQUIRE((wide(wider.max[k]) >= hi && error_in_ulp(wider.max[k], hi) <= 1));
            REQUIRE((wide(away.min[k]) <= hi && wide(away.max[k]) >= hi));
        }
    }
}

TEST_CASE("no ray that meets a box is told that it does not") {
    dice d{GENERATE(3u, 4u)};
    int met = 0;
    const auto check = [&](const aabb& box, const ray& r, interval range) {
        if (!truly_overlaps(box, r, range)) return;
        ++met;
        if (overlaps(box, r, range)) return;
        CAPTURE(box.min, box.max, r.origin, r.direction, range.min, range.max);
        FAIL("lost");
    };
    SECTION("random boxes and rays") {
        for (int i = 0; i < count; ++i) check(random_box(d, 3), {d.in_cube(5), d.in_cube()}, {});
    }
    SECTION("rays at points of the surface, to its edges and corners") {
        for (int i = 0; i < count; ++i) {
            const aabb box = random_box(d, 3);
            glm::vec3 p;
            for (int k = 0; k < 3; ++k) {
                const std::uint32_t choice = d.below(3);
                p[k] = choice == 0 ? box.min[k] : choice == 1 ? box.max[k] : d.between(box.min[k], box.max[k]);
            }
            const glm::vec3 o = d.in_cube(5);
            check(box, {o, p - o}, {});
            check(box, {o, p - o}, {0, 1});
        }
    }
    SECTION("coincidences: flat boxes, points, origins on faces, directions along the axes, both zeros") {
        for (int i = 0; i < 4 * count; ++i) {
            const glm::vec3 a(coarse(d), coarse(d), coarse(d)), b(coarse(d), coarse(d), coarse(d));
            const auto direction = [&] {
                const float x = coarse(d);
                return x == 0 && d.below(2) == 0 ? -0.0f : x;
            };
            const ray r{{coarse(d), coarse(d), coarse(d)}, {direction(), direction(), direction()}};
            if (r.direction == glm::vec3(0)) continue;
            check(lantern::enclose({a, a}, b), r, {0, d.below(2) == 0 ? lantern::infinity : 1.0f});
        }
    }
    SECTION("nearly parallel to a face") {
        for (int i = 0; i < count; ++i) {
            const aabb box = random_box(d, 3);
            const glm::vec3 direction(1, d.magnitude_between(-44, -3), d.between(-1e-3, 1e-3));
            check(box, {{-9, d.below(2) == 0 ? box.min.y : box.max.y, d.between(box.min.z, box.max.z)}, direction}, {});
        }
    }
    SECTION("from far away") {
        for (int i = 0; i < count; ++i) {
            const aabb box = random_box(d, 3);
            // Some whole number of steps back from a corner, so that the ray runs exactly through it.
            const glm::vec3 corner(glm::ivec3(box.min)), step(glm::ivec3(d.in_cube(8)));
            const glm::vec3 o = corner - std::exp2(float(d.below(40))) * step;
            if (glm::dvec3(corner) - glm::dvec3(o) == double(1) * glm::dvec3(corner - o) && step != glm::vec3(0))
                check({corner, corner + glm::vec3(0.1f)}, {o, step}, {});
        }
    }
    SECTION("at any scale") {
        for (int i = 0; i < count; ++i) {
            const float scale = d.magnitude_between(-30, 30);
            const aabb box = random_box(d, 3);
            check({scale * box.min, scale * box.max}, {scale * d.in_cube(5), d.magnitude_between(-7, 7) * d.in_cube()}, {});
        }
    }
    CHECK(met > count / 40);
}

TEST_CASE("a ray that clearly passes a box is told so") {
    dice d{5};
    int missed = 0, told = 0;
    for (int i = 0; i < count; ++i) {
        const aabb box = random_box(d, 3);
        const ray r{d.in_cube(5), d.in_cube()};
        if (truly_overlaps(lantern::grown(box, glm::vec3(1e-5f)), r, {})) continue;
        ++missed;
        told += !overlaps(box, r, {});
    }
    CHECK(missed > count / 4);
    CHECK(told == missed);
}

TEST_CASE("the range cuts the ray, and rounding t to float does not lose its last hit") {
    const aabb box{{-1, -1, -1}, {1, 1, 1}};
    const ray r{{0, 0, 5}, {0, 0, -1}};
    CHECK(overlaps(box, r, {0, 4}));
    CHECK_FALSE(overlaps(box, r, {0, 3.99f}));
    CHECK(overlaps(box, r, {6, 7}));
    CHECK_FALSE(overlaps(box, r, {6.01f, 7}));
    CHECK(overlaps(box, r, {5, 5.5f}));
    CHECK_FALSE(overlaps(box, ray{{0, 0, 5}, {0, 0, 1}}, {}));
    // The plane z = 1/3 of a unit ray from 3 is met at t = 2.666…, which rounds up; at 1/3 + 2 it would round down.
    const float third = 1.0f / 3;
    for (const float z : {3.0f, 5.0f, 7.0f, 11.0f}) {
        const float t = static_cast<float>((double(third) - z) / -0.7f);
        CHECK(overlaps(aabb{{-1, -1, third}, {1, 1, third}}, ray{{0, 0, z}, {0, 0, -0.7f}}, {0, t}));
    }
}

TEST_CASE("empty boxes are never met, infinite ones always") {
    dice d{6};
    const float inf = lantern::infinity;
    for (int i = 0; i < 1000; ++i) {
        ray r{d.in_cube(5), d.in_cube()};
        if (i % 3 == 0) r.direction.x = 0;
        REQUIRE_FALSE(overlaps(aabb{}, r, {}));
        REQUIRE(overlaps(aabb{glm::vec3(-inf), glm::vec3(inf)}, r, {}));
    }
}

TEST_CASE("one prepared ray serves many boxes") {
    dice d{7};
    for (int i = 0; i < 1000; ++i) {
        const ray r{d.in_cube(5), d.in_cube()};
        const lantern::slab_ray ready(r);
        const aabb box = random_box(d, 3);
        REQUIRE(overlaps(box, ready, {}) == overlaps(box, r, {}));
    }
}
