// SPDX-License-Identifier: MIT
#include <lantern/cylinder.hpp>

#include <lantern/surface.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <algorithm>
#include <limits>

using lantern::cylinder;
using lantern::interval;
using lantern::ray;

namespace {

constexpr int count = 5000;

/// The stretch within the solid, with 113 bits. `sure` is false where the ray grazes it.
bool true_stretch(const cylinder& s, const ray& r, wide& near, wide& far, bool& sure) {
    const wide3 f = widened(r.origin) - widened(s.from), d = widened(r.direction), axis = widened(s.to) - widened(s.from);
    const wide axis2 = dot(axis, axis), height = dot(f, axis), climb = dot(d, axis);
    near = wide(-1e300), far = wide(1e300);
    if (climb != 0) {
        near = std::min(-height / climb, (axis2 - height) / climb);
        far = std::max(-height / climb, (axis2 - height) / climb);
    } else if (height < 0 || height > axis2) {
        return false;
    }
    const wide3 m = cross(f, axis), k = cross(d, axis);
    const wide a = dot(k, k), b = -dot(m, k), c = dot(m, m) - wide(s.radius) * wide(s.radius) * axis2;
    if (a == 0) return c <= 0;
    const wide discriminant = b * b - a * c;
    sure = magnitude(discriminant) > wide(1e-9) * (b * b + a * dot(m, m));
    if (discriminant < 0) return false;
    const wide root = square_root(discriminant), q = b >= 0 ? b + root : b - root;
    near = std::max(near, std::min(c / q, q / a));
    far = std::min(far, std::max(c / q, q / a));
    sure = sure && magnitude(near - far) > wide(1e-9) * (magnitude(near) + magnitude(far));
    return near <= far;
}

cylinder random_cylinder(dice& d) { return {d.in_cube(3), d.in_cube(3), d.magnitude_between(-2, 0.5)}; }

}  // namespace

TEST_CASE("a cylinder has a tube and two lids") {
    const cylinder s{{0, -1, 0}, {0, 2, 0}, 0.5f};
    const auto tube = intersect(s, ray{{2, 0, 0}, {-1, 0, 0}}, interval{});
    REQUIRE(tube);
    CHECK(tube->t == 1.5f);
    CHECK(glm::length(tube->point - glm::vec3(0.5f, 0, 0)) < 1e-7f);
    CHECK(tube->normal == glm::vec3(1, 0, 0));
    const auto top = intersect(s, ray{{0.25f, 5, 0}, {0, -2, 0}}, interval{});
    REQUIRE(top);
    CHECK(top->t == 1.5f);
    CHECK(top->point == glm::vec3(0.25f, 2, 0));
    CHECK(top->normal == glm::vec3(0, 1, 0));
    const auto bottom = intersect(s, ray{{0.25f, 0, 0.1f}, {0, -1, 0}}, interval{});  // from inside
    REQUIRE(bottom);
    CHECK(bottom->point == glm::vec3(0.25f, -1, 0.1f));
    CHECK(bottom->normal == glm::vec3(0, -1, 0));
    const auto wall = intersect(s, ray{{0, 0, 0}, {0, 0, 2}}, interval{});
    REQUIRE(wall);
    CHECK(wall->t == 0.25f);
    CHECK(wall->normal == glm::vec3(0, 0, 1));
    CHECK_FALSE(intersect(s, ray{{2, 2.001f, 0}, {-1, 0, 0}}, interval{}));
    CHECK_FALSE(intersect(s, ray{{0.501f, 5, 0}, {0, -1, 0}}, interval{}));
    CHECK_FALSE(intersect(s, ray{{2, 0, 0}, {1, 0, 0}}, interval{}));
}

TEST_CASE("a ray along the axis, or nearly, meets the lids") {
    const cylinder s{{1, 2, 3}, {4, 6, 3}, 1};  // the axis (3, 4, 0)
    for (const glm::vec3 tilt : {glm::vec3(0), glm::vec3(0, 0, 1e-30f), glm::vec3(0, 0, 1e-7f), glm::vec3(1e-7f, 0, 0)}) {
        const auto h = intersect(s, ray{glm::vec3(-5, -6, 3.5f), glm::vec3(3, 4, 0) + tilt}, interval{});
        REQUIRE(h);
        CHECK(h->t == Approx(2));
        CHECK(h->normal.x == Approx(-0.6f));
        CHECK(h->normal.y == Approx(-0.8f));
    }
    CHECK_FALSE(intersect(s, ray{{-5, -6, 4.5f}, {3, 4, 0}}, interval{}));
}

TEST_CASE("from anywhere, a cylinder is hit right to half an ulp") {
    dice d{GENERATE(1u, 2u, 3u)};
    double t_error = 0, normal_error = 0, beyond = 0;
    int wrong = 0, hits = 0;
    for (int i = 0; i < count; ++i) {
        const cylinder s = random_cylinder(d);
        const glm::dvec3 from(s.from), to(s.to), side = glm::normalize(glm::cross(to - from, d.on_sphere()));
        const glm::vec3 o = i % 3 == 0 ? glm::vec3(from + d.unit() * (to - from) + 0.5 * s.radius * side) : d.in_cube(6);
        const glm::dvec3 target = from + (d.unit() * 1.4 - 0.2) * (to - from) + 1.3 * d.unit() * s.radius * side;
        const ray r{o, glm::vec3(glm::normalize(target - glm::dvec3(o)))};
        wide near = 0, far = 0;
        bool sure = true;
        const bool meets = true_stretch(s, r, near, far, sure);
        if (!sure || magnitude(near) < wide(1e-9)) continue;
        const wide t = near > 0 ? near : far;
        const bool met = meets && t > 0;
        const auto h = intersect(s, r, interval{});
        wrong += h.has_value() != met;
        if (!h || !met) continue;
        ++hits;
        t_error = std::max(t_error, error_in_ulp(h->t, t));
        const wide3 p = widened(h->point) - widened(s.from), axis = widened(s.to) - widened(s.from);
        const wide along = dot(p, axis) / length(axis), out = length(p - (dot(p, axis) / dot(axis, axis)) * axis) - wide(s.radius);
        // The nearest of tube and lids; the normal is that of whichever was hit.
        const wide away = std::min({magnitude(out), magnitude(along), magnitude(along - length(axis))});
        const glm::vec3 q = glm::abs(h->point);
        beyond = std::max(beyond, double(away / wide(h->error + 0.87f * lantern::ulp(std::max({q.x, q.y, q.z})))));
        normal_error = std::max(normal_error, std::abs(glm::length(glm::dvec3(h->normal)) - 1));
        CHECK((glm::dot(h->normal, r.direction) <= 0) == (t == near));
    }
    CHECK(hits > count / 3);
    CHECK(wrong == 0);
    CHECK(t_error <= 0.501);
    CHECK(normal_error <= 1e-7);
    CHECK(beyond <= 1);
}

TEST_CASE("the same cylinder at another scale is the same cylinder") {
    const float scale = GENERATE(0x1p66f, 0x1p-66f, 0x1p-80f);
    dice d{4};
    for (int i = 0; i < count; ++i) {
        const cylinder s = random_cylinder(d);
        const ray r{d.in_cube(6), glm::vec3(d.on_sphere())};
        const auto h = intersect(s, r, interval{}),
                   scaled = intersect(cylinder{scale * s.from, scale * s.to, scale * s.radius}, ray{scale * r.origin, r.direction}, interval{});
        REQUIRE(h.has_value() == scaled.has_value());
        if (!h) continue;
        REQUIRE(scaled->t == scale * h->t);
        REQUIRE(scaled->normal == h->normal);
    }
}

TEST_CASE("the bounds contain both rims for certain, and hardly more") {
    dice d{5};
    for (int i = 0; i < count; ++i) {
        const cylinder s = random_cylinder(d);
        const lantern::aabb box = bounds(s);
        const wide3 axis = widened(s.to) - widened(s.from), n = (1 / length(axis)) * axis;
        for (int k = 0; k < 3; ++k) {
            const wide reach = wide(s.radius) * square_root(1 - n[std::size_t(k)] * n[std::size_t(k)]);
            const wide lo = wide(std::min(s.from[k], s.to[k])) - reach, hi = wide(std::max(s.from[k], s.to[k])) + reach;
            REQUIRE((wide(box.min[k]) <= lo && wide(box.max[k]) >= hi));
            REQUIRE((lo - wide(box.min[k]) <= wide(1e-6) && wide(box.max[k]) - hi <= wide(1e-6)));
        }
    }
}

TEST_CASE("numbers that are none, and a cylinder without an axis, are refused and missed") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const ray r{{5, 0.5f, 0}, {-1, 0, 0}};
    REQUIRE(intersect(cylinder{}, r, interval{}));
    for (const float bad : {nan, lantern::infinity}) {
        CHECK_FALSE(intersect(cylinder{{bad, 0, 0}, {0, 1, 0}, 1}, r, interval{}));
        CHECK_FALSE(intersect(cylinder{{0, 0, 0}, {0, bad, 0}, 1}, r, interval{}));
        CHECK_FALSE(intersect(cylinder{{0, 0, 0}, {0, 1, 0}, bad}, r, interval{}));
        CHECK_FALSE(intersect(cylinder{}, ray{{5, bad, 0}, {-1, 0, 0}}, interval{}));
        CHECK_THROWS_WITH(validate(cylinder{{bad, 0, 0}}), containing("cylinder: from"));
        CHECK_THROWS_WITH(validate(cylinder{{0, 0, 0}, {0, bad, 0}}), containing("cylinder: to"));
        CHECK_THROWS_WITH(validate(cylinder{{0, 0, 0}, {0, 1, 0}, bad}), containing("cylinder: radius"));
    }
    CHECK_FALSE(intersect(cylinder{{0, 0, 0}, {0, 0, 0}, 1}, r, interval{}));
    CHECK_THROWS_WITH(validate(cylinder{{1, 2, 3}, {1, 2, 3}, 1}), containing("cylinder: to is (1, 2, 3), but must be different from"));
}

TEST_CASE("a ray that leaves a cylinder neither meets it again nor loses touch, at any scale") {
    dice d{6};
    int left = 0;
    for (int i = 0; i < count; ++i) {
        const float scale = d.magnitude_between(-6, 6);
        cylinder s = random_cylinder(d);
        s = {scale * s.from, scale * s.to, scale * s.radius};
        const glm::vec3 from = scale * d.in_cube(6);
        const auto h = intersect(s, ray{from, s.from + d.between(0, 1) * (s.to - s.from) - from}, interval{});
        if (!h) continue;
        ++left;
        glm::vec3 away(d.on_sphere());
        if (glm::dot(away, h->normal) < 0) away = -away;
        // In float the point may lie beyond the seam of tube and lid by the error; well away from it nothing is met again.
        const glm::vec3 axis = s.to - s.from;
        const float along = glm::dot(h->point - s.from, axis) / glm::dot(axis, axis);
        const float out = glm::length(h->point - s.from - along * axis) / s.radius;
        const bool on_tube = std::abs(glm::dot(h->normal, glm::normalize(axis))) < 0.5f;
        if (on_tube ? (along < 1e-3f || along > 0.999f) : out > 0.999f) continue;
        REQUIRE_FALSE(intersect(s, ray{leave(*h, away), away}, interval{}));
        REQUIRE(intersect(s, ray{leave(*h, -away), -away}, interval{}));
    }
    CHECK(left > count / 2);
}
