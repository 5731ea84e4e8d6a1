// SPDX-License-Identifier: MIT
#include <lantern/aabb.hpp>

#include "box_laws.hpp"
#include "catch.hpp"
#include "oracle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

using lantern::aabb;
using lantern::interval;
using lantern::ray;
using namespace box_laws;

namespace {

constexpr float nan_value = std::numeric_limits<float>::quiet_NaN();
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

TEST_CASE("the longest axis, the first of equal ones") {
    CHECK(lantern::longest_axis({{0, 0, 0}, {1, 2, 1}}) == 1);
    CHECK(lantern::longest_axis({{0, 0, 0}, {1, 2, 3}}) == 2);
    CHECK(lantern::longest_axis({{0, 0, 0}, {2, 2, 2}}) == 0);
    CHECK(lantern::longest_axis({{0, 0, 0}, {1, 2, 2}}) == 1);
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
    no_ray_is_lost([](const aabb& box, const ray& r, interval range) { return overlaps(box, r, range); });
}

TEST_CASE("what a surface in the box may have been rounded by, is no miss either: of the box's size, and of the origin's") {
    const aabb box{{0, 0, 0}, {1, 1, 1}}, huge{{0, 0, 0}, {0x1p20f, 1, 0x1p20f}};
    const auto beside = [](float by, float z) { return ray{{0.5f, -by, z}, {0, 0, 1}}; };  // runs below the lower face
    CHECK(overlaps(box, beside(0x1p-41f, -1), {}));
    CHECK_FALSE(overlaps(box, beside(0x1p-37f, -1), {}));
    CHECK(overlaps(huge, beside(0x1p-21f, -1), {}));
    CHECK(overlaps(box, beside(0x1p-21f, -0x1p20f), {}));
    CHECK_FALSE(overlaps(box, beside(0x1p-17f, -0x1p20f), {}));
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

TEST_CASE("a box seems larger by what rounding may have moved, of its own coordinates and of the ray's origin, and no more") {
    const aabb near{{0, 0, 0}, {1, 1, 1}}, far{{0x1p20f, 0, 0}, {0x1p20f, 1, 1}};
    const auto beside = [](float x, float by) { return ray{{x, -by, 0.5f}, {1, 0, 0}}; };  // runs below the lower face
    CHECK(overlaps(near, beside(-1, 0x1p-41f), {}));
    CHECK_FALSE(overlaps(near, beside(-1, 0x1p-37f), {}));
    CHECK(overlaps(near, beside(-0x1p20f, 0x1p-21f), {}));  // far is the origin
    CHECK_FALSE(overlaps(near, beside(-0x1p20f, 0x1p-18f), {}));
    CHECK(overlaps(far, beside(0, 0x1p-21f), {}));  // far is the box
    CHECK_FALSE(overlaps(far, beside(0, 0x1p-18f), {}));
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
