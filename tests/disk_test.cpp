// SPDX-License-Identifier: MIT
#include <lantern/disk.hpp>

#include <lantern/surface.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <algorithm>
#include <limits>

using lantern::disk;
using lantern::interval;
using lantern::ray;

namespace {
constexpr int count = 5000;
}

TEST_CASE("a disk is hit out to its radius") {
    const disk s{{0, 0, -1}, {0, 0, 3}, 2};
    const auto h = intersect(s, ray{{1, 1, 1}, {0, 0, -4}}, interval{});
    REQUIRE(h);
    CHECK(h->t == 0.5f);
    CHECK(h->point == glm::vec3(1, 1, -1));
    CHECK(h->normal == glm::vec3(0, 0, 1));
    CHECK(intersect(s, ray{{2, 0, 1}, {0, 0, -1}}, interval{}));
    CHECK_FALSE(intersect(s, ray{{2.0000002f, 0, 1}, {0, 0, -1}}, interval{}));
    CHECK_FALSE(intersect(s, ray{{0, 0, 1}, {0, 0, 1}}, interval{}));
    CHECK_FALSE(intersect(s, ray{{-5, 0, -1}, {1, 0, 0}}, interval{}));
    CHECK(intersect(disk{{0, 0, -1}, {0, 0, 3}, -2}, ray{{1, 1, 1}, {0, 0, -4}}, interval{}));
}

TEST_CASE("a disk is hit right, to half an ulp") {
    dice d{GENERATE(1u, 2u, 3u)};
    double t_error = 0, beyond = 0;
    int wrong = 0, hits = 0;
    for (int i = 0; i < count; ++i) {
        const disk s{d.in_cube(3), d.in_cube(), d.magnitude_between(-3, 1)};
        const glm::vec3 o = d.in_cube(5);
        const glm::dvec3 side = glm::normalize(glm::cross(glm::dvec3(s.normal), d.on_sphere()));
        const glm::dvec3 target = glm::dvec3(s.center) + 1.3 * d.unit() * s.radius * side;
        const ray r{o, glm::vec3(glm::normalize(target - glm::dvec3(o)))};
        const wide3 n = widened(s.normal), to = widened(s.center) - widened(o);
        const wide t = dot(n, to) / dot(n, widened(r.direction));
        const wide from_center = length(t * widened(r.direction) - to) / wide(s.radius);
        if (magnitude(from_center - 1) < wide(1e-10)) continue;
        const bool met = t > 0 && from_center < 1;
        const auto h = intersect(s, r, interval{});
        wrong += h.has_value() != met;
        if (!h || !met) continue;
        ++hits;
        t_error = std::max(t_error, error_in_ulp(h->t, t));
        const wide away = magnitude(dot(n, widened(h->point) - widened(s.center))) / length(n);
        const glm::vec3 q = glm::abs(h->point);
        beyond = std::max(beyond, double(away / wide(h->error + 0.87f * lantern::ulp(std::max({q.x, q.y, q.z})))));
    }
    CHECK(hits > count / 3);
    CHECK(wrong == 0);
    CHECK(t_error <= 0.501);
    CHECK(beyond <= 1);
}

TEST_CASE("the bounds contain the rim for certain, and are flat where the disk is") {
    dice d{4};
    for (int i = 0; i < count; ++i) {
        const disk s{d.in_cube(), d.in_cube(), d.magnitude_between(-6, 6)};
        const lantern::aabb box = bounds(s);
        const wide3 n = (1 / length(widened(s.normal))) * widened(s.normal);
        for (int k = 0; k < 3; ++k) {
            const wide reach = wide(s.radius) * square_root(1 - n[std::size_t(k)] * n[std::size_t(k)]);
            REQUIRE((wide(box.min[k]) <= wide(s.center[k]) - reach && wide(box.max[k]) >= wide(s.center[k]) + reach));
            REQUIRE(wide(box.max[k]) - wide(s.center[k]) - reach <= wide(2 * lantern::ulp(std::abs(s.center[k]) + s.radius)));
        }
    }
    const lantern::aabb flat = bounds(disk{{1, 2, 3}, {0, 5, 0}, 1});
    CHECK(flat.max.y - flat.min.y <= 4 * lantern::ulp(2));
    CHECK(flat.max.x >= 2);
    CHECK(flat.max.x <= 2.000001f);
}

TEST_CASE("numbers that are none are refused and missed") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const ray r{{0, 0, 2}, {0, 0, -1}};
    for (const float bad : {nan, lantern::infinity}) {
        CHECK_FALSE(intersect(disk{{bad, 0, 0}}, r, interval{}));
        CHECK_FALSE(intersect(disk{{0, 0, 0}, {bad, 0, 1}}, r, interval{}));
        CHECK_THROWS_WITH(validate(disk{{bad, 0, 0}}), containing("disk: center"));
        CHECK_THROWS_WITH(validate(disk{{0, 0, 0}, {0, bad, 0}}), containing("disk: normal"));
        CHECK_THROWS_WITH(validate(disk{{0, 0, 0}, {0, 1, 0}, bad}), containing("disk: radius"));
    }
    CHECK_FALSE(intersect(disk{{0, 0, 0}, {0, 0, 1}, nan}, r, interval{}));
    CHECK_FALSE(intersect(disk{{0, 0, 0}, {0, 0, 1}, lantern::infinity}, r, interval{}));
    CHECK_FALSE(intersect(disk{{0, 0, 0}, {0, 0, 0}, 1}, r, interval{}));
    CHECK_THROWS_WITH(validate(disk{{0, 0, 0}, {0, 0, 0}, 1}), containing("different from zero"));
}

TEST_CASE("a ray that leaves a disk does not meet it again, and one towards it does, at any scale") {
    dice d{6};
    for (int i = 0; i < count; ++i) {
        const float scale = d.magnitude_between(-6, 6);
        const disk s{scale * d.in_cube(3), d.in_cube(), scale * d.magnitude_between(-1, 3)};
        const glm::dvec3 side = glm::normalize(glm::cross(glm::dvec3(s.normal), d.on_sphere()));
        const glm::vec3 from = scale * d.in_cube(5);
        const auto h = intersect(s, ray{from, glm::vec3(glm::normalize(glm::dvec3(s.center) + 0.9 * d.unit() * s.radius * side - glm::dvec3(from)))}, interval{});
        if (!h) continue;
        const glm::vec3 away(d.on_sphere());
        REQUIRE_FALSE(intersect(s, ray{leave(*h, away), away}, interval{}));
        REQUIRE(intersect(s, ray{leave(*h, h->normal), -h->normal}, interval{}));
    }
}
