// SPDX-License-Identifier: MIT
#include <lantern/triangle.hpp>

#include <lantern/surface.hpp>

#include "catch.hpp"
#include "closed_mesh.hpp"
#include "oracle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

using lantern::interval;
using lantern::ray;
using lantern::triangle;

namespace {

struct truth {
    wide t;
    wide3 point, normal;
};

/// `sure` is false where the ray passes an edge nearer than double can see from the origin.
std::optional<truth> true_hit(const triangle& s, const ray& r, bool& sure) {
    const wide3 o = widened(r.origin), d = widened(r.direction);
    const wide3 a = widened(s.a) - o, b = widened(s.b) - o, c = widened(s.c) - o;
    const wide u = dot(d, cross(c, b)), v = dot(d, cross(a, c)), w = dot(d, cross(b, a));
    const wide reach = std::max({length(a), length(b), length(c)}) * length(d) * static_cast<wide>(1e-15);
    sure = magnitude(u) > reach * length(c - b) && magnitude(v) > reach * length(a - c) && magnitude(w) > reach * length(b - a);
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return std::nullopt;
    const wide3 n = cross(b - a, c - a);
    const wide t = dot(n, a) / dot(n, d);
    if (!(t > 0)) return std::nullopt;
    return truth{t, o + t * d, (1 / length(n)) * n};
}

struct score {
    int rays = 0, hits = 0, wrong = 0;
    double t = 0, normal = 0, beyond = 0;
};

void judge(score& all, const triangle& s, const ray& r) {
    bool sure = true;
    const auto expected = true_hit(s, r, sure);
    if (!sure) return;
    const auto h = intersect(s, r, interval{});
    ++all.rays;
    if (h.has_value() != expected.has_value()) {
        ++all.wrong;
        return;
    }
    if (!h) return;
    ++all.hits;
    all.t = std::max(all.t, error_in_ulp(h->t, expected->t));
    all.normal = std::max(all.normal, largest_difference(h->normal, expected->normal));
    const wide away = magnitude(dot(expected->normal, widened(h->point) - widened(s.a)));
    const glm::vec3 p = glm::abs(h->point);
    const float rounding = 0.87f * lantern::ulp(std::max({p.x, p.y, p.z}));
    all.beyond = std::max(all.beyond, static_cast<double>(away / static_cast<wide>(h->error + rounding)));
}

void check(const score& all) {
    INFO(all.rays << " rays, " << all.hits << " hits");
    CHECK(all.wrong == 0);
    CHECK(all.hits > all.rays / 10);
    CHECK(all.t <= 0.501);
    CHECK(all.normal <= 6e-8);
    CHECK(all.beyond <= 1);
}

/// The triangle's points and, as often, points just beyond its edges.
glm::dvec3 about(dice& d, const triangle& s) {
    const double u = d.unit() * 1.2 - 0.1, v = d.unit() * (1.1 - u);
    return glm::dvec3(s.a) + u * (glm::dvec3(s.b) - glm::dvec3(s.a)) + v * (glm::dvec3(s.c) - glm::dvec3(s.a));
}

ray aimed(dice& d, const triangle& s, const glm::dvec3& origin) {
    const glm::vec3 o(origin);
    return {o, glm::vec3(glm::normalize(about(d, s) - glm::dvec3(o)))};
}

triangle random_triangle(dice& d, const glm::dvec3& center, double size) {
    const auto vertex = [&] { return glm::vec3(center + size * d.on_sphere()); };
    return {vertex(), vertex(), vertex()};
}

std::vector<triangle> closed(dice& d, int divisions, float scale) {
    std::vector<triangle> mesh;
    for (const auto& [a, b, c] : closed_mesh(d, divisions, scale)) mesh.push_back({a, b, c});
    return mesh;
}

bool leaks(const std::vector<triangle>& mesh, const ray& r) {
    return std::none_of(mesh.begin(), mesh.end(), [&](const triangle& s) { return intersect(s, r, interval{}).has_value(); });
}

constexpr int count = 4000;

}  // namespace

TEST_CASE("a triangle is hit from both sides, and its normal does not care") {
    const triangle s{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const auto front = intersect(s, ray{{0.25f, 0.25f, 2}, {0, 0, -2}}, interval{});
    REQUIRE(front);
    CHECK(front->t == 1);
    CHECK(front->point == glm::vec3(0.25f, 0.25f, 0));
    CHECK(front->normal == glm::vec3(0, 0, 1));
    const auto back = intersect(s, ray{{0.25f, 0.25f, -2}, {0, 0, 1}}, interval{});
    REQUIRE(back);
    CHECK(back->normal == glm::vec3(0, 0, 1));
    CHECK_FALSE(intersect(s, ray{{0.75f, 0.75f, 2}, {0, 0, -1}}, interval{}));
    CHECK_FALSE(intersect(s, ray{{0.25f, 0.25f, 2}, {0, 0, 1}}, interval{}));
    CHECK_FALSE(intersect(s, ray{{0.25f, 0.25f, 2}, {0, 0, -1}}, interval{0, 1.9999999f}));
    CHECK(intersect(s, ray{{0.25f, 0.25f, 2}, {0, 0, -1}}, interval{0, 2}));
    CHECK_FALSE(intersect(s, ray{{0.25f, 0.25f, 2}, {0, 0, -1}}, interval{2, 3}));
}

TEST_CASE("tiny, thin, slanting or huge, a triangle is hit right to half an ulp") {
    dice d{GENERATE(1u, 2u)};
    score all;
    SECTION("of any size") {
        const double size = GENERATE(1.0, 1e-3, 3e-5);
        for (int i = 0; i < count; ++i) {
            const triangle s = random_triangle(d, {0, 0, 0}, size);
            judge(all, s, aimed(d, s, 2.0 * d.on_sphere()));
        }
    }
    SECTION("of any size, away from the origin") {
        const double size = GENERATE(1.0, 1e-2);
        for (int i = 0; i < count; ++i) {
            const triangle s = random_triangle(d, glm::dvec3(d.in_cube(10)), size);
            judge(all, s, aimed(d, s, glm::dvec3(d.in_cube(10))));
        }
    }
    SECTION("with sides in the ratio 1 to 1e-6") {
        for (int i = 0; i < count; ++i) {
            const glm::dvec3 a(d.in_cube()), long_side = d.on_sphere(), b = a + long_side;
            // A needle has two long sides, a cap three.
            const glm::dvec3 c = a + 1e-6 * d.on_sphere() + (i % 2 == 0 ? 0.0 : d.unit()) * long_side;
            const triangle s{glm::vec3(a), glm::vec3(b), glm::vec3(c)};
            judge(all, s, aimed(d, s, 2.0 * d.on_sphere()));
        }
    }
    SECTION("seen at 1e-5 of its plane") {
        for (int i = 0; i < count; ++i) {
            const triangle s = random_triangle(d, {0, 0, 0}, 1);
            const glm::dvec3 a(s.a), n = glm::normalize(glm::cross(glm::dvec3(s.b) - a, glm::dvec3(s.c) - a));
            const glm::dvec3 p = about(d, s);
            const glm::dvec3 along = glm::normalize(glm::cross(n, d.on_sphere())) + 1e-5 * n;
            judge(all, s, {glm::vec3(p - 3.0 * along), glm::vec3(along)});
        }
    }
    SECTION("from a point next to it") {
        for (int i = 0; i < count; ++i) {
            const triangle s = random_triangle(d, {0, 0, 0}, 1);
            judge(all, s, {glm::vec3(about(d, s) + double(d.magnitude_between(-7, -2)) * d.on_sphere()), glm::vec3(d.on_sphere())});
        }
    }
    SECTION("thin, slanting and near at once") {
        for (int i = 0; i < count; ++i) {
            const glm::dvec3 a(d.in_cube()), side = d.on_sphere();
            const triangle s{glm::vec3(a), glm::vec3(a + side), glm::vec3(a + 1e-4 * d.on_sphere() + d.unit() * side)};
            const glm::dvec3 n = glm::normalize(glm::cross(glm::dvec3(s.b) - glm::dvec3(s.a), glm::dvec3(s.c) - glm::dvec3(s.a)));
            judge(all, s, {glm::vec3(about(d, s) - double(d.magnitude_between(-3, 0)) * (side + 1e-3 * n)), glm::vec3(side + 1e-3 * n)});
        }
    }
    SECTION("huge, and met near the origin") {
        const double size = GENERATE(1e6, 1e12);
        for (int i = 0; i < count; ++i) {
            const glm::dvec3 a = d.on_sphere(), b = glm::normalize(glm::cross(a, d.on_sphere())), c = -a - b;
            const triangle s{glm::vec3(size * a), glm::vec3(size * b), glm::vec3(size * c)};
            judge(all, s, {glm::vec3(d.on_sphere()), glm::vec3(d.on_sphere())});
        }
    }
    check(all);
}

TEST_CASE("the same triangle at another scale is the same triangle") {
    const float scale = GENERATE(0x1p66f, 0x1p-66f, 0x1p100f, 0x1p-80f);
    dice d{3};
    int hits = 0;
    for (int i = 0; i < count; ++i) {
        const triangle s = random_triangle(d, {0, 0, 0}, 1), big{scale * s.a, scale * s.b, scale * s.c};
        const ray r = aimed(d, s, 2.0 * d.on_sphere());
        const auto h = intersect(s, r, interval{}), scaled = intersect(big, ray{scale * r.origin, r.direction}, interval{});
        REQUIRE(h.has_value() == scaled.has_value());
        if (!h) continue;
        ++hits;
        REQUIRE(scaled->t == scale * h->t);
        REQUIRE(scaled->point == scale * h->point);
        REQUIRE(scaled->normal == h->normal);
    }
    CHECK(hits > count / 2);
}

TEST_CASE("turning the vertices round turns the normal round and changes nothing else") {
    dice d{4};
    for (int i = 0; i < count; ++i) {
        const triangle s = random_triangle(d, {0, 0, 0}, 1);
        const ray r = aimed(d, s, 2.0 * d.on_sphere());
        const auto h = intersect(s, r, interval{}), next = intersect(triangle{s.b, s.c, s.a}, r, interval{}),
                   turned = intersect(triangle{s.a, s.c, s.b}, r, interval{});
        REQUIRE(h.has_value() == next.has_value());
        REQUIRE(h.has_value() == turned.has_value());
        if (!h) continue;
        CHECK(error_in_ulp(next->t, h->t) <= 1);
        CHECK(error_in_ulp(turned->t, h->t) <= 1);
        CHECK(turned->normal == -h->normal);
    }
}

TEST_CASE("nothing leaks out of a closed mesh, neither through its edges nor through its vertices") {
    const float scale = GENERATE(1.0f, 1e-4f, 1e5f);
    dice d{GENERATE(5u, 6u)};
    int leaked = 0;
    for (int k = 0; k < 6; ++k) {
        const auto mesh = closed(d, 2, scale);  // 128 triangles
        for (int i = 0; i < 300; ++i) {
            const triangle& s = mesh[d.below(static_cast<std::uint32_t>(mesh.size()))];
            const std::array<glm::vec3, 3> v{s.a, s.b, s.c};
            const glm::vec3 origin = i % 5 == 0 ? glm::vec3(0) : 0.2f * scale * d.in_cube();
            const std::uint32_t corner = d.below(3);
            const glm::dvec3 p(v[corner]), q(v[(corner + 1) % 3]);
            const double along = i % 2 == 0 ? 0 : i % 4 == 1 ? d.unit() : 0.5;
            leaked += leaks(mesh, {origin, glm::vec3(p + along * (q - p) - glm::dvec3(origin))});
        }
    }
    CHECK(leaked == 0);
}

TEST_CASE("nothing leaks along the axes through a mesh whose edges lie on them") {
    const std::vector<triangle> square{{{-1, -1, 0}, {1, -1, 0}, {0, 0, 0}}, {{1, -1, 0}, {1, 1, 0}, {0, 0, 0}},
                                       {{1, 1, 0}, {-1, 1, 0}, {0, 0, 0}},   {{-1, 1, 0}, {-1, -1, 0}, {0, 0, 0}}};
    for (const float x : {-1.0f, -0.3f, -0.0f, 0.0f, 0.7f, 1.0f})
        for (const float y : {-x, x})
            for (const float z : {-0.0f, 0.0f}) CHECK_FALSE(leaks(square, {{x, y, 3}, {z, z, -1}}));
}

TEST_CASE("only a ray within the plane, or a triangle of no area, is missed for its determinant") {
    const triangle s{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    CHECK_FALSE(intersect(s, ray{{-1, 0.25f, 0}, {1, 0, 0}}, interval{}));
    CHECK(intersect(s, ray{{-1, 0.25f, 1e-20f}, {1, 0, -0.9e-20f}}, interval{}));
    const triangle line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, point{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    for (const triangle& none : {line, point}) {
        CHECK_FALSE(intersect(none, ray{{0, 0, 1}, {0, 0, -1}}, interval{}));
        CHECK_FALSE(intersect(none, ray{{0.5f, 0, 1}, {0, 0, -1}}, interval{}));
    }
}

TEST_CASE("a triangle of no area never gives a normal that is none") {
    dice d{8};
    for (int i = 0; i < count; ++i) {
        const glm::vec3 a = d.in_cube(), step = d.in_cube();
        const triangle s{a, a + step, a + 0.25f * step};
        const auto h = intersect(s, ray{{3, 2, 1}, a + d.between(0, 1) * step - glm::vec3(3, 2, 1)}, interval{});
        if (h) REQUIRE(std::abs(glm::length(h->normal) - 1) < 1e-6f);
    }
}

TEST_CASE("numbers that are none, and rays without a direction, hit no triangle") {
    const triangle s{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = lantern::infinity;
    for (const float bad : {nan, inf, -inf}) {
        for (int k = 0; k < 3; ++k) {
            triangle t = s;
            (k == 0 ? t.a : k == 1 ? t.b : t.c).x = bad;
            CHECK_FALSE(intersect(t, ray{{0, 0, 5}, {0, 0, -1}}, interval{}));
            CHECK_THROWS_WITH(validate(t), containing("triangle: "));
            ray o{{0, 0, 5}, {0, 0, -1}}, v = o;
            o.origin[k] = bad;
            v.direction[k] = bad;
            CHECK_FALSE(intersect(s, o, interval{}));
            CHECK_FALSE(intersect(s, v, interval{}));
        }
    }
    CHECK_FALSE(intersect(s, ray{{0, 0, 5}, {0, 0, 0}}, interval{}));
    CHECK_NOTHROW(validate(s));
}

TEST_CASE("a ray that leaves a triangle does not meet it again, and one that comes through does, at any scale") {
    const float scale = GENERATE(1e-6f, 1e-3f, 1.0f, 1e3f, 1e6f);
    dice d{9};
    int again = 0, lost = 0, left = 0;
    for (int i = 0; i < count; ++i) {
        const bool huge = i % 4 == 0;  // with far vertices, met near the origin
        const triangle unit = random_triangle(d, glm::dvec3(d.in_cube(2)), huge ? 1e4 : 1);
        const triangle s{scale * unit.a, scale * unit.b, scale * unit.c};
        const double u = 0.05 + 0.9 * d.unit(), v = d.unit() * (0.95 - u);
        const glm::dvec3 a(s.a), inside = a + u * (glm::dvec3(s.b) - a) + v * (glm::dvec3(s.c) - a);
        const glm::dvec3 from = huge ? glm::dvec3(scale * d.in_cube()) : double(scale) * 5.0 * d.on_sphere();
        const auto h = intersect(s, ray{glm::vec3(from), huge ? glm::vec3(d.on_sphere()) : glm::vec3(glm::normalize(inside - from))}, interval{});
        if (!h) continue;
        ++left;
        const glm::vec3 away(d.on_sphere()), back = glm::dot(away, h->normal) < 0 ? h->normal : -h->normal;
        again += intersect(s, ray{leave(*h, away), away}, interval{}).has_value();
        lost += !huge && v > 0.05 && !intersect(s, ray{leave(*h, away), back}, interval{}).has_value();
    }
    CHECK(left > count / 3);
    CHECK(again == 0);
    CHECK(lost == 0);
}

TEST_CASE("a tiny triangle is not met by a ray that passes far beside it, however far away") {
    dice d{.state = 31};
    for (int i = 0; i < 200'000; ++i) {
        const glm::vec3 p = 1e-3f * d.in_cube();
        const lantern::triangle s{p, p + d.in_cube(1e-7), p + d.in_cube(1e-7)};
        lantern::ray r{d.magnitude_between(5, 8) * d.in_cube(), {}};
        r.direction[int(d.below(3))] = 1;
        const glm::vec3 away = glm::abs(glm::cross(r.direction, r.origin - p));
        if (std::max({away.x, away.y, away.z}) < 1) continue;
        REQUIRE_FALSE(intersect(s, r, {-lantern::infinity, lantern::infinity}));
    }
}
