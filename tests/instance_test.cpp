// SPDX-License-Identifier: MIT
#include <lantern/instance.hpp>

#include <lantern/plane.hpp>
#include <lantern/sphere.hpp>
#include <lantern/surface.hpp>
#include <lantern/triangle.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <glm/mat4x4.hpp>

#include <algorithm>
#include <limits>

using lantern::instance;
using lantern::interval;
using lantern::ray;
using lantern::sphere;
using lantern::triangle;

static_assert(lantern::surface<instance<sphere>> && lantern::bounded<instance<sphere>>);
static_assert(lantern::surface<instance<sphere>, lantern::timed_ray>);
static_assert(lantern::surface<instance<lantern::plane>> && !lantern::bounded<instance<lantern::plane>>);
static_assert(lantern::surface<instance<instance<triangle>>>, "instances nest");

namespace {

constexpr int count = 4000;

/// Columns x, y, z and the translation.
glm::mat4 affine(glm::vec3 x, glm::vec3 y, glm::vec3 z, glm::vec3 move) {
    return {glm::vec4(x, 0), glm::vec4(y, 0), glm::vec4(z, 0), glm::vec4(move, 1)};
}

glm::mat4 random_affine(dice& d) { return affine(d.in_cube(), d.in_cube(), d.in_cube(), d.in_cube(3)); }

/// The ellipsoid |M⁻¹(p - translation)| = 1, with 113 bits.
struct true_ellipsoid {
    std::array<wide3, 3> rows;  // of the inverse
    wide3 translation;

    explicit true_ellipsoid(const glm::mat4& m) : translation(widened(glm::vec3(m[3]))) {
        const wide3 x = widened(glm::vec3(m[0])), y = widened(glm::vec3(m[1])), z = widened(glm::vec3(m[2]));
        const wide per = 1 / dot(x, cross(y, z));
        rows = {per * cross(y, z), per * cross(z, x), per * cross(x, y)};
    }
    wide3 local(const wide3& v) const { return {dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)}; }
};

}  // namespace

TEST_CASE("a moved, turned or stretched sphere is hit where it stands") {
    const instance moved(sphere{}, affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {5, 0, 0}));
    const auto h = intersect(moved, ray{{5, 0, 3}, {0, 0, -2}}, interval{});
    REQUIRE(h);
    CHECK(h->t == 1);
    CHECK(h->point == glm::vec3(5, 0, 1));
    CHECK(h->normal == glm::vec3(0, 0, 1));
    const instance pancake(sphere{}, affine({2, 0, 0}, {0, 0.5f, 0}, {0, 0, 2}, {0, 0, 0}));
    CHECK(intersect(pancake, ray{{0, 3, 0}, {0, -1, 0}}, interval{})->t == 2.5f);
    CHECK(intersect(pancake, ray{{3, 0, 0}, {-1, 0, 0}}, interval{})->t == 1);
    CHECK(bounds(pancake).max.x >= 2);
    CHECK(intersect(instance(sphere{}), ray{{0, 0, 3}, {0, 0, -1}}, interval{})->t == 2);  // no transform at all
}

TEST_CASE("an ellipsoid is hit right to half an ulp, with its true normal") {
    dice d{GENERATE(1u, 2u, 3u)};
    const bool needle = GENERATE(false, true);  // stretched by 1e-3 along one axis
    double t_error = 0, normal_error = 0, beyond = 0;
    int wrong = 0, hits = 0;
    for (int i = 0; i < count; ++i) {
        const glm::mat4 m = needle ? affine({1e-3f, 0, 0}, {0, 1, 0}, {0, 0, 1}, d.in_cube(3)) : random_affine(d);
        if (std::abs(glm::determinant(glm::mat3(m))) < 1e-4f) continue;
        const true_ellipsoid truth(m);
        const instance s(sphere{}, m);
        const glm::vec3 o = d.in_cube(8);
        const glm::vec3 target(m * glm::vec4(1.1f * d.in_cube(), 1));
        const ray r{o, target - o};
        const wide3 f = truth.local(widened(o) - truth.translation), v = truth.local(widened(r.direction));
        const wide a = dot(v, v), b = -dot(f, v), k = dot(f, f) - 1, discriminant = b * b - a * k;
        if (magnitude(discriminant) < wide(1e-9) * b * b || magnitude(k) < wide(1e-6)) continue;
        const wide root = square_root(magnitude(discriminant)), q = b >= 0 ? b + root : b - root;
        const wide t0 = b >= 0 ? k / q : q / a, t1 = b >= 0 ? q / a : k / q, t = t0 > 0 ? t0 : t1;
        const bool met = discriminant >= 0 && t > 0;
        const auto h = intersect(s, r, interval{});
        wrong += h.has_value() != met;
        if (!h || !met) continue;
        ++hits;
        t_error = std::max(t_error, error_in_ulp(h->t, t));
        const wide3 on = f + t * v;
        const wide3 n = on[0] * truth.rows[0] + on[1] * truth.rows[1] + on[2] * truth.rows[2];
        normal_error = std::max(normal_error, largest_difference(h->normal, (1 / length(n)) * n));
        // The distance from the ellipsoid to first order: (|local| - 1) / |gradient|.
        const wide3 p = truth.local(widened(h->point) - truth.translation);
        const glm::vec3 size = glm::abs(h->point);
        beyond = std::max(beyond, double(magnitude(length(p) - 1) / length(n) /
                                         wide(h->error + 0.87f * lantern::ulp(std::max({size.x, size.y, size.z})))));
    }
    CHECK(hits > count / 4);
    CHECK(wrong == 0);
    CHECK(t_error <= 0.501);
    CHECK(normal_error <= 6.5e-8);
    CHECK(beyond <= 1);
}

TEST_CASE("outward normals stay outward, mirrored or not") {
    dice d{4};
    for (int i = 0; i < count; ++i) {
        const glm::mat4 m = random_affine(d);
        if (std::abs(glm::determinant(glm::mat3(m))) < 1e-4f) continue;
        const instance s(sphere{}, m);
        const glm::vec3 center(m[3]), from = center + 10.0f * glm::vec3(d.on_sphere());
        const auto h = intersect(s, ray{from, center - from}, interval{});
        REQUIRE(h);
        CHECK(glm::dot(h->normal, center - from) < 0);
        CHECK(glm::dot(intersect(s, ray{center, center - from}, interval{})->normal, center - from) > 0);
    }
}

TEST_CASE("an instance of a triangle is the triangle of the transformed vertices") {
    dice d{5};
    int hits = 0;
    for (int i = 0; i < count; ++i) {
        // Powers of two, permuted axes and coarse vertices, so that no rounding comes between.
        const glm::mat4 m = affine({0, 4, 0}, {0, 0, -0.5f}, {2, 0, 0}, {8, -16, 32});
        const auto coarse = [&] { return glm::vec3(glm::ivec3(d.in_cube(1000))) / 512.0f; };
        const triangle s{coarse(), coarse(), coarse()};
        const auto placed = [&](glm::vec3 p) { return glm::vec3(m * glm::vec4(p, 1)); };
        const triangle world{placed(s.a), placed(s.b), placed(s.c)};
        const glm::vec3 o = 20.0f * d.in_cube();
        const ray r{o, world.a + d.between(0, 0.6) * (world.b - world.a) + d.between(0, 0.6) * (world.c - world.a) - o};
        const auto h = intersect(instance(s, m), r, interval{}), same = intersect(world, r, interval{});
        REQUIRE(h.has_value() == same.has_value());
        if (!h) continue;
        ++hits;
        REQUIRE(h->t == same->t);
        REQUIRE(glm::length(h->point - same->point) <= 4e-6f);
        REQUIRE(std::abs(glm::dot(h->normal, same->normal)) >= 0.999999f);
    }
    CHECK(hits > count / 3);
}

TEST_CASE("the bounds contain the transformed corners for certain") {
    dice d{6};
    for (int i = 0; i < count; ++i) {
        const glm::mat4 m = random_affine(d);
        const triangle t{d.in_cube(), d.in_cube(), d.in_cube()};
        const instance s(t, m);
        const lantern::aabb box = bounds(s), local = bounds(t);
        for (int corner = 0; corner < 8; ++corner) {
            wide3 p = widened(glm::vec3(m[3]));
            for (int k = 0; k < 3; ++k)
                p = p + wide((corner >> k & 1) != 0 ? local.max[k] : local.min[k]) * widened(glm::vec3(m[k]));
            for (int k = 0; k < 3; ++k) REQUIRE((wide(box.min[k]) <= p[std::size_t(k)] && wide(box.max[k]) >= p[std::size_t(k)]));
        }
    }
    const lantern::aabb unit = bounds(instance(sphere{}));
    CHECK(unit.min.x >= -1 - 2 * lantern::ulp(1));
    CHECK(unit.max.y <= 1 + 2 * lantern::ulp(1));
}

TEST_CASE("a transform that cannot be undone is refused, in words") {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = lantern::infinity;
    const auto placed = [](const glm::mat4& m) { return instance(sphere{}, m); };
    CHECK_THROWS_WITH(placed(affine({1, 0, 0}, {0, 0, 0}, {0, 0, 1}, {0, 0, 0})), containing("instance: the determinant of to_world is 0"));
    CHECK_THROWS_WITH(placed(affine({1, 2, 3}, {2, 4, 6}, {0, 0, 1}, {0, 0, 0})), containing("different from zero"));
    CHECK_THROWS_WITH(placed(affine({1, nan, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0})), containing("instance: a column of to_world is (1, nan, 0), but must be finite"));
    CHECK_THROWS_WITH(placed(affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, inf, 0})), containing("finite"));
    glm::mat4 perspective(1);
    perspective[2][3] = -1;
    CHECK_THROWS_WITH(placed(perspective), containing("0 0 0 1"));
    CHECK_NOTHROW(placed(affine({1e-6f, 0, 0}, {0, 1, 0}, {0, 0, 1e6f}, {0, 0, 0})));
    CHECK_NOTHROW(placed(affine(glm::vec3(1e-20f, 0, 0), {0, 1e-20f, 0}, {0, 0, 1e-20f}, {0, 0, 0})));
    CHECK_THROWS_WITH(validate(instance(sphere{{0, 0, 0}, nan})), containing("sphere: radius"));
}

TEST_CASE("a ray that leaves an instance neither meets it again nor loses touch") {
    dice d{7};
    int left = 0;
    for (int i = 0; i < count; ++i) {
        const float scale = d.magnitude_between(-5, 5);
        const glm::mat4 m = affine(scale * d.in_cube(), scale * d.in_cube(), scale * d.in_cube(), scale * d.in_cube(3));
        const glm::mat3 linear(m);
        if (std::abs(glm::determinant(linear)) < 0.05f * glm::length(linear[0]) * glm::length(linear[1]) * glm::length(linear[2])) continue;
        const instance s(sphere{}, m);
        const glm::vec3 from = scale * 9.0f * glm::vec3(d.on_sphere());
        const auto h = intersect(s, ray{from, glm::vec3(m * glm::vec4(0.5f * d.in_cube(), 1)) - from}, interval{});
        REQUIRE(h);
        ++left;
        glm::vec3 away(d.on_sphere());
        if (glm::dot(away, h->normal) < 0) away = -away;
        REQUIRE_FALSE(intersect(s, ray{leave(*h, away), away}, interval{}));
        REQUIRE(intersect(s, ray{leave(*h, -away), -away}, interval{}));
    }
    CHECK(left > count / 2);
}
