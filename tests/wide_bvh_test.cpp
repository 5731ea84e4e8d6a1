// SPDX-License-Identifier: MIT
#include <lantern/wide_bvh.hpp>

#include <lantern/closest.hpp>
#include <lantern/mesh.hpp>
#include <lantern/ray.hpp>
#include <lantern/surface.hpp>

#include "catch.hpp"
#include "meshes.hpp"
#include "oracle.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using lantern::interval;
using lantern::mesh;
using lantern::nearest;
using lantern::ray;
using lantern::triangle;
using lantern::wide_bvh;

namespace {

lantern::every all_of(const mesh& m) { return {static_cast<std::uint32_t>(m.size())}; }

std::string shown(const std::optional<nearest>& h) {
    return h ? "triangle " + std::to_string(h->index) + " at " + lantern::to_text(h->t) : std::string("nothing");
}

/// Everything that can be asked of the tree, against brute force. True when something was hit.
bool check_same(const wide_bvh& tree, const mesh& m, const ray& r, interval range = {}) {
    const auto expected = closest(all_of(m), m, r, range), got = closest(tree, r, range);
    INFO("ray from " << lantern::to_text(r.origin) << " towards " << lantern::to_text(r.direction) << ", range "
                     << lantern::to_text(range.min) << " to " << lantern::to_text(range.max));
    INFO("expected " << shown(expected) << ", got " << shown(got));
    REQUIRE(got.has_value() == expected.has_value());
    REQUIRE(occluded(tree, r, range) == expected.has_value());
    if (!expected) return false;
    REQUIRE(got->t == expected->t);
    REQUIRE(got->index == expected->index);
    REQUIRE(got->point == expected->point);
    REQUIRE(got->normal == expected->normal);
    REQUIRE(got->error == expected->error);
    return true;
}

/// Rays that look for trouble: through vertices, edges, and the planes of boxes; along axes; from within planes.
ray adversarial(dice& d, const mesh& m, float size, glm::vec3 at) {
    const auto vertex = [&] { return m.vertices()[d.below(static_cast<std::uint32_t>(m.vertices().size()))]; };
    const glm::uvec3 t = m.triangles()[d.below(static_cast<std::uint32_t>(m.size()))];
    const glm::vec3 a = m.vertices()[t.x], b = m.vertices()[t.y];
    const glm::vec3 outside = at + size * d.in_cube(2);
    const auto axis = [&] {
        glm::vec3 way(0);
        way[static_cast<int>(d.below(3))] = d.below(2) == 0 ? 1.0f : -1.0f;
        if (d.below(2) == 0) way *= -1.0f;  // zeros of both signs
        return way;
    };
    switch (d.below(9)) {
        case 0: return {outside, a - outside};                                    // to a vertex
        case 1: return {outside, 0.5f * (a + b) - outside};                       // to the middle of an edge
        case 2: return {outside, a + d.between(0, 1) * (b - a) - outside};        // to somewhere on an edge
        case 3: return {vertex(), axis()};                                        // from a vertex, along an axis
        case 4: return {a - size * 3.0f * axis(), axis()};                        // within planes of boxes
        case 5: return {a, b - a};                                                // along an edge
        case 6: return {a - (b - a), b - a};                                      // along an edge, from outside
        case 7: {                                                                 // in one plane with a face of a box
            glm::vec3 from = outside, way = vertex() - outside;
            const int i = static_cast<int>(d.below(3));
            from[i] = a[i];
            way[i] = d.below(2) == 0 ? 0.0f : -0.0f;
            return {from, way};
        }
        default: return {outside, d.in_cube()};
    }
}

std::vector<mesh> families() {
    return {meshes::sphere(8, 0.2f), meshes::terrain(20), meshes::slivers(400), meshes::soup(500, 0.1), meshes::sphere(9), meshes::hall(800)};
}

}  // namespace

TEST_CASE("a wide tree is an accelerator") {
    STATIC_REQUIRE(lantern::accelerator<wide_bvh>);
    const mesh m = meshes::sphere(6, 0.1f);
    const wide_bvh tree{m};
    CHECK(tree.size() == m.size());
    dice d{.state = 1};
    for (int i = 0; i < 1000; ++i) {
        const ray r{d.in_cube(1.5), d.in_cube()};
        std::vector<triangle> copy(m.begin(), m.end());  // not a mesh: the triangles are asked
        const auto a = closest(tree, copy, r), b = closest(tree, m, r), c = closest(tree, r);
        REQUIRE(a.has_value() == c.has_value());
        REQUIRE(b.has_value() == c.has_value());
        if (c) REQUIRE((a->index == c->index && a->t == c->t && b->index == c->index && b->t == c->t));
    }
}

TEST_CASE("the wide tree answers what brute force answers, to the last bit") {
    dice d{.state = 2};
    for (const mesh& m : families()) {
        const wide_bvh tree{m};
        int hits = 0;
        for (int i = 0; i < 4000; ++i) {
            const ray r = adversarial(d, m, 1, glm::vec3(0));
            hits += check_same(tree, m, r, i % 4 == 0 ? interval{d.between(0, 1), d.between(0, 3)} : interval{});
        }
        CHECK(hits > 400);
    }
}

TEST_CASE("at any scale, and far from the origin") {
    dice d{.state = 3};
    for (const float scale : {1e-30f, 1e-15f, 1e-6f, 1e6f, 1e12f, 1e17f})
        for (const float away : {0.0f, 3.0f, 1000.0f}) {
            if (scale * away > 1e18f) continue;
            const glm::vec3 at = scale * glm::vec3(away, -away, 0.3f * away);
            const mesh m = meshes::placed(meshes::sphere(5, 0.2f), scale, at);
            const wide_bvh tree{m};
            for (int i = 0; i < 1500; ++i) check_same(tree, m, adversarial(d, m, scale, at));
        }
}

TEST_CASE("needles that were cut up are hit where they were, at any scale and far from the origin") {
    dice d{.state = 12};
    const mesh original = meshes::hall(600);
    for (const float scale : {1e-30f, 1e-6f, 1.0f, 1e6f, 1e17f})
        for (const float away : {0.0f, 3.0f, 1000.0f}) {
            if (scale * away > 1e18f) continue;
            const glm::vec3 at = scale * glm::vec3(away, -away, 0.3f * away);
            const mesh m = meshes::placed(original, scale, at);
            const wide_bvh tree{m};
            for (int i = 0; i < 400; ++i) {
                const triangle t = m[600 + d.below(6)];  // a needle
                const float s = d.between(0, 1), k = s * d.between(0, 1);
                const glm::vec3 o = at + scale * d.in_cube(2), to = t.a + s * (t.b - t.a) + k * (t.c - t.b) - o;
                check_same(tree, m, {o, to});
                check_same(tree, m, {t.a + s * (t.b - t.a), to});  // from the needle itself
            }
        }
}

TEST_CASE("directions of any length, and t counts in units of it") {
    dice d{.state = 4};
    const mesh m = meshes::sphere(5, 0.2f);
    const wide_bvh tree{m};
    int hits = 0;
    for (int i = 0; i < 4000; ++i) {
        const ray r = adversarial(d, m, 1, glm::vec3(0));
        const float length = d.magnitude_between(-36, 36);
        hits += check_same(tree, m, {r.origin, length * r.direction});
        const glm::vec3 tilt(d.magnitude_between(-40, 0), d.magnitude_between(-40, 0), d.magnitude_between(-40, 0));
        hits += check_same(tree, m, {r.origin, tilt * r.direction});  // nearly along an axis
    }
    CHECK(hits > 1000);
}

TEST_CASE("no ray leaves a closed mesh through its edges or vertices") {
    for (const float scale : {1e-15f, 1e-4f, 1.0f, 1e6f, 1e12f}) {
        const mesh m = meshes::placed(meshes::sphere(40, 0.01f), scale);
        const wide_bvh tree{m};
        dice d{.state = 5};
        int leaks = 0;
        for (int i = 0; i < 20'000; ++i) {
            const glm::uvec3 t = m.triangles()[d.below(static_cast<std::uint32_t>(m.size()))];
            const glm::vec3 a = m.vertices()[t.x], b = m.vertices()[t.y], o = scale * d.in_cube(0.5);
            const glm::vec3 to = i % 2 == 0 ? a : a + d.between(0, 1) * (b - a);
            leaks += !closest(tree, ray{o, to - o}).has_value();
            leaks += !occluded(tree, ray{o, lantern::unit(to - o)}, {});
        }
        CHECK(leaks == 0);
    }
}

TEST_CASE("many rays at once get the answers that they get one by one") {
    dice d{.state = 9};
    for (const mesh& m : families()) {
        const wide_bvh tree{m};
        for (const std::size_t count : {0u, 1u, 15u, 16u, 17u, 2000u}) {
            std::vector<ray> rays;
            for (std::size_t i = 0; i < count; ++i) rays.push_back(adversarial(d, m, 1, glm::vec3(0)));
            if (count > 20) {  // some go nowhere
                rays[3].direction = glm::vec3(0);
                rays[count - 1].origin.x = std::numeric_limits<float>::quiet_NaN();
            }
            const interval range = count == 15 ? interval{0.1f, 2} : interval{};
            std::vector<std::optional<nearest>> hits(count, nearest{});
            closest(tree, rays, hits, range);
            for (std::size_t i = 0; i < count; ++i) {
                const auto expected = closest(tree, rays[i], range);
                INFO("ray " << i << ": expected " << shown(expected) << ", got " << shown(hits[i]));
                REQUIRE(hits[i].has_value() == expected.has_value());
                if (!expected) continue;
                REQUIRE((hits[i]->t == expected->t && hits[i]->index == expected->index));
                REQUIRE((hits[i]->point == expected->point && hits[i]->normal == expected->normal));
            }
        }
    }
    const wide_bvh nothing{std::vector<triangle>()};
    std::vector<std::optional<nearest>> hits(2, nearest{});
    closest(nothing, std::vector<ray>(2), hits);
    CHECK((!hits[0] && !hits[1]));
    CHECK_THROWS_WITH(closest(nothing, std::vector<ray>(3), hits), containing("the number of hits is 2, but must be that of the rays, 3"));
}

TEST_CASE("a tree is asked through its own functions, by whatever name") {
    const mesh m = meshes::sphere(20);
    const wide_bvh tree{m};
    const ray r{{0, 0, 3}, {0.01f, 0.02f, -1}};
    lantern::probe qualified, plain;
    (void)lantern::closest(tree, m, r, interval{}, qualified);  // no mesh is looked at
    (void)closest(tree, r, interval{}, plain);
    CHECK((qualified.nodes == plain.nodes && qualified.offers == plain.offers));
}

TEST_CASE("rays that have just left a triangle do not meet it again") {
    dice d{.state = 10};
    for (const mesh& m : families()) {
        const wide_bvh tree{m};
        for (int i = 0; i < 2000; ++i) {
            const auto h = closest(tree, adversarial(d, m, 1, glm::vec3(0)));
            if (!h) continue;
            const glm::vec3 way = d.in_cube();
            check_same(tree, m, {leave(*h, way), way});
        }
    }
}

TEST_CASE("a copy of a tree, or what was moved from one, finds the same") {
    const mesh m = meshes::terrain(60);
    wide_bvh tree{m};
    const wide_bvh copy = tree, moved = std::move(tree);
    dice d{.state = 11};
    for (int i = 0; i < 300; ++i) {
        const ray r{{d.between(0, 1), 1, d.between(0, 1)}, d.in_cube()};
        check_same(copy, m, r);
        check_same(moved, m, r);
    }
}

TEST_CASE("of triangles at the same place the first is taken") {
    const mesh one = meshes::soup(1, 0.5);
    const mesh m(one.vertices(), std::vector<glm::uvec3>(1000, glm::uvec3(0, 1, 2)));
    const wide_bvh tree{m};
    const glm::vec3 middle = (m[0].a + m[0].b + m[0].c) / 3.0f;
    const auto h = closest(tree, ray{middle + glm::vec3(1, 2, 3), -glm::vec3(1, 2, 3)});
    REQUIRE(h);
    CHECK(h->index == 0);
}

TEST_CASE("nothing, and any small number of triangles") {
    for (std::uint32_t n = 0; n < 40; ++n) {
        const mesh m = meshes::soup(n, 0.8);
        const wide_bvh tree{m};
        CHECK(tree.size() == n);
        if (n == 0) CHECK(tree.bytes() == 0);
        dice d{.state = n};
        for (int i = 0; i < 200; ++i) check_same(tree, m, {d.in_cube(2), d.in_cube()});
    }
}

TEST_CASE("duplicates, lines, points and every scale at once do not stop the build") {
    dice d{.state = 6};
    std::vector<glm::vec3> points;
    std::vector<glm::uvec3> same, line, scales, peeled;
    for (std::uint32_t i = 0; i < 3000; ++i) {
        const float size = d.magnitude_between(-5, 5);
        for (int k = 0; k < 3; ++k) points.push_back(size * d.in_cube());
        scales.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        same.push_back({0, 1, 2});
        line.push_back({3 * i, 3 * i, 3 * i});
    }
    const auto n = static_cast<std::uint32_t>(points.size());
    for (std::uint32_t i = 0; i < 150; ++i) {  // each twice as far as the one before: any cut peels off one
        const glm::vec3 p(std::ldexp(1.0f, static_cast<int>(i) - 95));
        points.insert(points.end(), {p, p * glm::vec3(1, 1.5f, 1), p * glm::vec3(1, 1, 1.5f)});
        peeled.push_back({n + 3 * i, n + 3 * i + 1, n + 3 * i + 2});
    }
    for (const auto& triangles : {same, line, scales, peeled}) {
        const mesh m(points, triangles);
        const wide_bvh tree{m};
        for (int i = 0; i < 300; ++i) {
            const glm::uvec3 t = triangles[d.below(static_cast<std::uint32_t>(triangles.size()))];
            const glm::vec3 o = d.in_cube() * d.magnitude_between(-4, 4);
            check_same(tree, m, {o, (points[t.x] + points[t.y] + points[t.z]) / 3.0f - o});
        }
    }
    const wide_bvh many{mesh(points, std::vector<glm::uvec3>(200'000, glm::uvec3(0, 1, 2)))};
    CHECK(static_cast<double>(many.bytes()) < 60 * 200'000.0);
}

TEST_CASE("what is not finite is left out; what would overflow is refused") {
    constexpr float bad = std::numeric_limits<float>::quiet_NaN();
    std::vector<triangle> some{{{bad, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                               {{0, 0, -1}, {1, 0, -1}, {0, 1, -1}},
                               {{0, 0, 0}, {lantern::infinity, 0, 0}, {0, 1, 0}}};
    const wide_bvh tree{some};
    CHECK(tree.size() == 3);
    CHECK(tree.left_out() == 2);
    CHECK(closest(tree, ray{{0.25f, 0.25f, 1}, {0, 0, -1}})->index == 1);
    some[0] = {{0, 0, 0}, {2e18f, 0, 0}, {0, 1, 0}};
    CHECK_THROWS_WITH(wide_bvh{some}, containing("a coordinate is 2e+18, but must be less than 2^60"));
}

TEST_CASE("rays that go nowhere or come from nowhere hit nothing, and end") {
    constexpr float bad = std::numeric_limits<float>::quiet_NaN(), inf = lantern::infinity;
    const mesh m = meshes::sphere(5);
    const wide_bvh tree{m};
    for (const ray& r : {ray{{0, 0, 0}, {0, 0, 0}}, ray{{bad, 0, 0}, {0, 0, 1}}, ray{{0, inf, 0}, {0, -1, 0}},
                         ray{{0, 0, 0}, {0, bad, 1}}, ray{{0, 0, 0}, {inf, 0, 0}}}) {
        CHECK_FALSE(closest(tree, r));
        CHECK_FALSE(occluded(tree, r, {}));
    }
    const ray r{{0.1f, 0.2f, 0.3f}, {0, 0, 1}};
    CHECK(closest(tree, r));
    for (const interval range : {interval{0, 0}, interval{2, 1}, interval{bad, 1}, interval{0, bad}, interval{-2, -1}})
        CHECK_FALSE(closest(tree, r, range));
    for (const float far : {1e19f, 1e30f, 3e38f}) check_same(tree, m, {{0, 0, far}, {0, 0, -1}});
}

TEST_CASE("a moment of the exposure changes nothing") {
    const mesh m = meshes::sphere(5);
    const wide_bvh tree{m};
    const lantern::timed_ray r{{{0, 0, 3}, {0.1f, 0, -1}}, 0.5f};
    CHECK(closest(tree, r)->t == closest(tree, m, r)->t);
    CHECK(occluded(tree, m, r, {}));
}

TEST_CASE("any number of threads builds the same tree") {
    const mesh m = meshes::terrain(120);
    const wide_bvh one(m, {.threads = 1}), four(m, {.threads = 4}), many(m, {.threads = 100});
    CHECK(one.bytes() == four.bytes());
    CHECK(one.bytes() == many.bytes());
    dice d{.state = 7};
    for (int i = 0; i < 2000; ++i) {
        const ray r{{d.between(0, 1), 1, d.between(0, 1)}, d.in_cube()};
        lantern::probe a, b;
        const auto h = closest(one, r, {}, a), g = closest(four, r, {}, b);
        REQUIRE(h.has_value() == g.has_value());
        if (h) REQUIRE(h->index == g->index);
        REQUIRE((a.nodes == b.nodes && a.offers == b.offers));
    }
}

TEST_CASE("few nodes are looked at, and hardly more in a mesh of four times the size") {
    std::uint64_t nodes[2] = {};
    int which = 0;
    for (const std::uint32_t side : {60u, 120u}) {
        const mesh m = meshes::terrain(side);
        const wide_bvh tree{m};
        CHECK(static_cast<double>(tree.bytes()) < 70.0 * static_cast<double>(m.size()));
        lantern::probe counter;
        dice d{.state = 8};
        for (int i = 0; i < 1000; ++i)
            (void)closest(tree, ray{{d.between(0, 1), 1, d.between(0, 1)}, {0.2f, -1, 0.1f}}, {}, counter);
        nodes[which++] = counter.nodes;
        CHECK(counter.offers < 3000);
    }
    CHECK(nodes[0] < 14 * 1000);
    CHECK(nodes[1] < nodes[0] + 4 * 1000);
}

TEST_CASE("shadow rays cost the same wherever the light stands") {
    const mesh m = meshes::sphere(60);
    const wide_bvh tree{m};
    std::vector<double> nodes;
    for (const glm::vec3 light : {glm::vec3(4, 5, 6), glm::vec3(-4, -5, -6), glm::vec3(-5, -1, 4), glm::vec3(5, 1, -4)}) {
        lantern::probe counter;
        dice d{.state = 14};
        for (int i = 0; i < 2000; ++i) {
            const auto h = closest(tree, ray{3.0f * glm::vec3(d.on_sphere()), d.in_cube(0.5)});
            const auto seen = h ? h : closest(tree, ray{glm::vec3(0), glm::vec3(d.on_sphere())});
            const glm::vec3 o = leave(*seen, light - seen->point);
            (void)occluded(tree, ray{o, light - o}, interval{0, 0.999f}, counter);
        }
        nodes.push_back(double(counter.nodes) / 2000);
    }
    CHECK(*std::ranges::max_element(nodes) < 1.25 * *std::ranges::min_element(nodes));
}

TEST_CASE("needles cost no more than their share: few are cut up, many are put beside those that lie like them") {
    const auto nodes_and_bytes = [](const mesh& m) {
        const wide_bvh tree{m};
        lantern::probe counter;
        dice d{.state = 13};
        for (int i = 0; i < 500; ++i) (void)closest(tree, ray{d.in_cube(), d.in_cube()}, {}, counter);
        return std::pair(double(counter.nodes) / 500, double(tree.bytes()) / double(m.size()));
    };
    const auto [soup_nodes, soup_bytes] = nodes_and_bytes(meshes::soup(20'000, 2 / std::cbrt(20'000.0)));
    const auto [hall_nodes, hall_bytes] = nodes_and_bytes(meshes::hall(20'000));
    CHECK(hall_nodes < 1.8 * soup_nodes);  // 3.6 times as many, if they are not cut
    CHECK(hall_bytes < 70);
    CHECK(soup_bytes < 50);
    const auto [needle_nodes, needle_bytes] = nodes_and_bytes(meshes::slivers(5000));
    CHECK(needle_nodes < 100);
    CHECK(needle_bytes < 50);
}
