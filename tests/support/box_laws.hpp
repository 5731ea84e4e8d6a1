// SPDX-License-Identifier: MIT
#pragma once
// What every test of a ray against an axis-aligned box must keep, in whatever arithmetic it is done.

#include <lantern/aabb.hpp>
#include <lantern/interval.hpp>
#include <lantern/ray.hpp>

#include <glm/common.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace box_laws {

using lantern::aabb;
using lantern::interval;
using lantern::ray;

constexpr int count = 10000;

/// Three slabs with 113 bits; a face's plane counts as the box.
inline bool truly_overlaps(const aabb& box, const ray& r, interval range) {
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

inline aabb random_box(dice& d, double size) {
    const glm::vec3 a = d.in_cube(size), b = d.in_cube(size);
    return lantern::enclose({a, a}, b);
}

/// One of few values, so that coincidences are the rule.
inline float coarse(dice& d) { return static_cast<float>(d.below(5)) - 2.0f; }

/// meets(box, ray, range): what is tested. Never false where 113 bits see the ray meet the box.
template <class Meets>
void no_ray_is_lost(Meets meets) {
    dice d{GENERATE(3u, 4u)};
    int met = 0;
    const auto check = [&](const aabb& box, const ray& r, interval range) {
        if (!truly_overlaps(box, r, range)) return;
        ++met;
        if (meets(box, r, range)) return;
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
    SECTION("ranges that begin behind the origin, or end at the box") {
        for (int i = 0; i < count; ++i) {
            const aabb box = random_box(d, 3);
            const float from = -d.magnitude_between(-3, 3);
            check(box, {d.in_cube(5), d.in_cube()}, {from, from + d.between(0, 10)});
            check(box, {d.in_cube(5), d.in_cube()}, {-lantern::infinity, d.between(-10, 10)});
        }
    }
    SECTION("at any scale") {
        for (int i = 0; i < count; ++i) {
            const float scale = d.magnitude_between(-44, 38.5);
            const aabb box = random_box(d, 0.9);
            check({scale * box.min, scale * box.max}, {scale * d.in_cube(0.9), d.magnitude_between(-7, 7) * d.in_cube()}, {});
        }
    }
    SECTION("the largest coordinates, whose differences are beyond float") {
        for (int i = 0; i < count; ++i) {
            const aabb box = random_box(d, 1);
            const glm::vec3 o = d.in_cube(1), to = glm::mix(box.min, box.max, glm::vec3(d.between(0, 1), d.between(0, 1), d.between(0, 1))) - o;
            check({3e38f * box.min, 3e38f * box.max}, {3e38f * o, d.below(2) == 0 ? to : 1e30f * to}, {});
        }
    }
    SECTION("directions of any length") {
        for (int i = 0; i < count; ++i) {
            const aabb box = random_box(d, 3);
            const glm::vec3 o = d.in_cube(5), to = glm::mix(box.min, box.max, glm::vec3(d.between(0, 1), d.below(2), d.between(0, 1))) - o;
            check(box, {o, d.magnitude_between(-44, 37) * to}, {});
        }
    }
    SECTION("the longest directions, whose reciprocals have lost bits, to edges and corners") {
        for (int i = 0; i < count; ++i) {
            const aabb box = random_box(d, 3);
            glm::vec3 p;
            for (int k = 0; k < 3; ++k) p[k] = d.below(3) == 0 ? d.between(box.min[k], box.max[k]) : d.below(2) == 0 ? box.min[k] : box.max[k];
            const glm::vec3 o = d.below(2) == 0 ? glm::vec3(0) : d.in_cube(5), to = p - o;  // from there it is exact
            const float longest = std::max({std::abs(to.x), std::abs(to.y), std::abs(to.z)});
            if (longest > 0) check(box, {o, std::ldexp(1.0f, 127 - std::ilogb(longest)) * to}, {});
        }
    }
    CHECK(met > count / 40);
}

}  // namespace box_laws
