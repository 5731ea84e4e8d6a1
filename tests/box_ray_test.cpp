// SPDX-License-Identifier: MIT
#include <lantern/box_ray.hpp>

#include <lantern/aabb.hpp>
#include <lantern/boxes_of.hpp>

#include "box_laws.hpp"
#include "catch.hpp"
#include "oracle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

using lantern::aabb;
using lantern::box_ray;
using lantern::interval;
using lantern::ray;
using namespace box_laws;

namespace {

bool meets(const aabb& box, const ray& r, interval range) {
    float entry;
    return box_ray(r, range, lantern::reach_of(box)).meets(box, entry);
}

}  // namespace

TEST_CASE("box_ray: no ray that meets a box is told that it does not") { no_ray_is_lost(meets); }

TEST_CASE("box_ray: a ray that clearly passes a box is told so, at any scale") {
    dice d{5};
    for (const float scale : {1e-30f, 1.0f, 1e30f}) {
        int missed = 0, told = 0;
        for (int i = 0; i < count; ++i) {
            const aabb box = random_box(d, 3);
            const ray r{d.in_cube(5), d.in_cube()};
            if (truly_overlaps(lantern::grown(box, glm::vec3(1e-5f)), r, {})) continue;
            ++missed;
            told += !meets({scale * box.min, scale * box.max}, {scale * r.origin, r.direction}, {});
        }
        CHECK(missed > count / 4);
        CHECK(told == missed);
    }
}

TEST_CASE("box_ray: what a surface in the box may have been rounded by, is no miss either") {
    const aabb box{{0, 0, 0}, {1, 1, 1}}, far{{0x1p20f, 0, 0}, {0x1p20f, 1, 1}};
    const auto beside = [](float by, float x) { return ray{{x, -by, -1}, {0, 0, 1}}; };  // runs below the lower face
    CHECK(meets(box, beside(0x1p-35f, 0.5f), {}));
    CHECK_FALSE(meets(box, beside(0x1p-30f, 0.5f), {}));
    CHECK(meets(far, beside(0x1p-15f, 0x1p20f), {}));
    CHECK_FALSE(meets(far, beside(0x1p-10f, 0x1p20f), {}));
    for (const float from : {0.0f, -1.0f}) {  // of a range that begins behind the origin, too
        const interval range{from, 9};
        CHECK(meets(box, beside(0x1p-35f, 0.5f), range));
        CHECK_FALSE(meets(box, beside(0x1p-30f, 0.5f), range));
        float entry;
        CHECK(box_ray(beside(0.009f, 0.5f), range, 1, 0.01).meets(box, entry));  // of a box that is rounded itself
        CHECK_FALSE(box_ray(beside(0.011f, 0.5f), range, 1, 0.01).meets(box, entry));
    }
}

TEST_CASE("box_ray: the range cuts the ray, and rounding t to float does not lose its last hit") {
    const aabb box{{-1, -1, -1}, {1, 1, 1}};
    for (const float length : {1.0f, 0.7f, 1e-30f, 1e30f}) {
        const ray r{{0, 0, 5}, {0, 0, -length}};
        const auto within = [&](float from, float to) { return meets(box, r, {from / length, to / length}); };
        CHECK(within(0, 4));
        CHECK_FALSE(within(0, 3.9999f));
        CHECK(within(6, 7));
        CHECK_FALSE(within(6.0001f, 7));
        CHECK(within(5, 5.5f));
        CHECK_FALSE(meets(box, ray{{0, 0, 5}, {0, 0, length}}, {}));
        CHECK(meets(box, ray{{0, 0, 5}, {0, 0, length}}, {-4.5f / length, 1 / length}));
        CHECK_FALSE(meets(box, ray{{0, 0, 5}, {0, 0, length}}, {-3.9f / length, 1 / length}));
        CHECK(meets(box, ray{{0, 0, 5}, {0, 0, length}}, {-lantern::infinity, 0}));
        CHECK(meets(box, r, {-lantern::infinity, lantern::infinity}));
    }
    dice d{8};
    for (int i = 0; i < count; ++i) {  // a flat box, and a range that ends where it is hit: t rounded, up or down
        const float scale = d.magnitude_between(-4, 0), z = scale * d.between(1, 9), origin = scale * d.between(10, 20);
        const float length = d.magnitude_between(-5, d.below(2) == 0 ? 5 : 38);  // t may be among the smallest floats
        const float t = static_cast<float>((double(z) - origin) / -length);
        REQUIRE(meets({{-1, -1, z}, {1, 1, z}}, {{0, 0, origin}, {0, 0, -length}}, {0, t}));
        const float from_zero = static_cast<float>(double(z) / length);
        REQUIRE(meets({{-1, -1, z}, {1, 1, z}}, {{0, 0, 0}, {0, 0, length}}, {0, from_zero}));
        const float behind = static_cast<float>((double(z) + origin) / -length);
        const interval range{d.below(2) == 0 ? 1.00001f * behind : 2 * behind, behind};
        if (!empty(range)) REQUIRE(meets({{-1, -1, z}, {1, 1, z}}, {{0, 0, -origin}, {0, 0, -length}}, range));
    }
}

TEST_CASE("box_ray: entries are in the order of the distances, and what lies behind a hit is reached no more") {
    const aabb near{{-1, -1, -3}, {1, 1, -2}}, far{{-1, -1, -9}, {1, 1, -8}};
    box_ray way(ray{{0, 0, 0}, {0, 0, -0.25f}}, {}, 9);
    float first, second;
    REQUIRE((way.meets(near, first) && way.meets(far, second)));
    CHECK(first < second);
    CHECK((way.reaches(first) && way.reaches(second)));
    way.shorten(8);  // in the ray's own unit, a quarter
    CHECK((way.reaches(first) && !way.reaches(second)));
    float again;
    CHECK_FALSE(way.meets(far, again));
    way.shorten(32);
    CHECK(way.meets(far, again));
}

TEST_CASE("box_ray: infinite boxes are always met, and any ray is answered") {
    dice d{6};
    const float inf = lantern::infinity, nan = std::numeric_limits<float>::quiet_NaN();
    for (int i = 0; i < 1000; ++i) {
        ray r{d.in_cube(5), d.in_cube()};
        if (i % 3 == 0) r.direction.x = 0;
        REQUIRE(meets(aabb{glm::vec3(-inf), glm::vec3(inf)}, r, {}));
    }
    for (const float x : {0.0f, inf, -inf, nan, std::numeric_limits<float>::max(), std::numeric_limits<float>::denorm_min()})
        for (const float y : {0.0f, inf, nan}) {
            (void)meets({{0, 0, 0}, {1, 1, 1}}, {{x, y, 0}, {1, 0, 0}}, {});
            (void)meets({{0, 0, 0}, {1, 1, 1}}, {{0, 0, 0}, {x, y, 0}}, {});
            (void)meets({{0, 0, 0}, {1, 1, 1}}, {{0, 0, 0}, {x, y, 0}}, {y, x});
        }
}
