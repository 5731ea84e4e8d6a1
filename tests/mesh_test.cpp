// SPDX-License-Identifier: MIT
#include <lantern/mesh.hpp>

#include <lantern/bvh.hpp>
#include <lantern/closest.hpp>

#include "catch.hpp"
#include "meshes.hpp"
#include "oracle.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <ranges>
#include <utility>
#include <vector>

using lantern::mesh;
using lantern::ray;
using lantern::triangle;

namespace {

const std::vector<glm::vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
const std::vector<glm::uvec3> halves{{0, 1, 2}, {0, 2, 3}};

/// Every edge is used once in each direction: no hole, and all triangles look outwards.
bool closed(const mesh& m) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const glm::uvec3& t : m.triangles())
        for (int i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
    for (const auto& [edge, count] : edges) {
        const auto back = edges.find({edge.second, edge.first});
        if (count != 1 || back == edges.end() || back->second != 1) return false;
    }
    return true;
}

}  // namespace

TEST_CASE("a mesh is a random-access range of bounded surfaces") {
    STATIC_REQUIRE(std::random_access_iterator<mesh::iterator>);
    STATIC_REQUIRE(std::ranges::random_access_range<const mesh>);
    STATIC_REQUIRE(std::ranges::sized_range<const mesh>);
    STATIC_REQUIRE(std::same_as<std::ranges::range_value_t<const mesh>, triangle>);
    STATIC_REQUIRE(lantern::bounded<mesh>);
    const mesh m(square, halves);
    REQUIRE(m.size() == 2);
    REQUIRE(m.end() - m.begin() == 2);
    CHECK(m.begin()[1].c == glm::vec3(0, 1, 0));
    CHECK((*std::ranges::prev(m.end())).b == glm::vec3(1, 1, 0));
    std::size_t i = 0;
    for (const triangle& t : m) CHECK(t.b == m[i++].b);
    CHECK(i == 2);
}

TEST_CASE("closest says which triangle, through a tree and without") {
    const mesh m = meshes::sphere(6, 0.2f);
    const lantern::bvh tree{m};
    dice d{.state = 1};
    for (int i = 0; i < 2000; ++i) {
        const ray r{d.in_cube(1.5), glm::vec3(d.on_sphere())};
        const auto a = closest(tree, m, r), b = closest(lantern::every{std::uint32_t(m.size())}, m, r);
        REQUIRE(a.has_value() == b.has_value());
        if (a) REQUIRE((a->index == b->index && a->t == b->t));
    }
}

TEST_CASE("bounds touch the outermost vertices that are used") {
    const mesh m({{0, 0, 0}, {1, 2, 3}, {-1, 5, 0}, {100, 100, 100}}, {{0, 1, 2}});
    CHECK(bounds(m).min == glm::vec3(-1, 0, 0));
    CHECK(bounds(m).max == glm::vec3(1, 5, 3));
    CHECK(empty(bounds(mesh({}, {}))));
}

TEST_CASE("what is broken is refused, and the message says where and why") {
    constexpr float bad = std::numeric_limits<float>::quiet_NaN();
    CHECK_THROWS_AS(mesh(square, {{0, 1, 2}, {0, 2, 4}}), std::invalid_argument);
    CHECK_THROWS_WITH(mesh(square, {{0, 1, 2}, {0, 2, 4}}), containing("mesh: triangles[1] is (0, 2, 4), but must be three indices below 4"));
    CHECK_THROWS_WITH(mesh({}, {{0, 0, 0}}), containing("below 0"));
    CHECK_THROWS_WITH(mesh({{0, 0, 0}, {0, bad, 0}}, {}), containing("mesh: vertices[1] is (0, nan, 0), but must be finite"));
    CHECK_THROWS_WITH(mesh({{lantern::infinity, 0, 0}}, {}), containing("vertices[0]"));
    CHECK_THROWS_WITH(mesh(square, halves, {{0, 0, 1}}), containing("number of normals is 1, but must be 0, or that of the vertices, 4"));
    CHECK_THROWS_WITH(mesh(square, halves, {{0, 0, 1}, {0, 0, 1}, {0, 0, bad}, {0, 0, 1}}), containing("normals[2]"));
}

TEST_CASE("triangles of no area are allowed and harmless") {
    const mesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5f, 0, 0}}, {{0, 0, 0}, {0, 1, 3}, {0, 1, 2}, {1, 1, 2}});
    const auto h = closest(lantern::bvh{m}, m, ray{{0.25f, 0.25f, 1}, {0, 0, -1}});
    REQUIRE(h);
    CHECK(h->index == 2);
    const auto normals = vertex_normals(m);
    CHECK(normals[0] == glm::vec3(0, 0, 1));
    CHECK(normals[3] == glm::vec3(0));
    CHECK(smooth_normal(mesh(m.vertices(), m.triangles(), normals), *h) == glm::vec3(0, 0, 1));
}

TEST_CASE("smooth normals are the vertices' own at the vertices and in between elsewhere") {
    const glm::vec3 left = glm::normalize(glm::vec3(-1, 0, 1)), right = glm::normalize(glm::vec3(1, 0, 1));
    const mesh m(square, halves, {left, right, right, left});
    const lantern::every all{2};
    const auto at = [&](float x, float y) { return closest(all, m, ray{{x, y, 1}, {0, 0, -1}}); };
    for (const float y : {0.0f, 0.3f, 0.8f, 1.0f}) {
        CHECK(glm::distance(smooth_normal(m, *at(0, y)), left) < 1e-6f);
        CHECK(glm::distance(smooth_normal(m, *at(1, y)), right) < 1e-6f);
        CHECK(glm::distance(smooth_normal(m, *at(0.5f, y)), glm::vec3(0, 0, 1)) < 1e-6f);
    }
    CHECK(at(0.2f, 0.5f)->normal == glm::vec3(0, 0, 1));  // geometric: what `leave` goes by
    CHECK(smooth_normal(mesh(square, halves), *at(0, 0)) == glm::vec3(0, 0, 1));
}

TEST_CASE("a smooth normal never contradicts the side of the face, nor is it ever NaN") {
    const mesh inside_out(square, halves, std::vector<glm::vec3>(4, glm::vec3(0.1f, 0, -5)));
    const mesh nothing(square, halves, std::vector<glm::vec3>(4, glm::vec3(0)));
    const auto h = closest(lantern::every{2}, inside_out, ray{{0.25f, 0.5f, 1}, {0, 0, -1}});
    REQUIRE(h);
    CHECK(smooth_normal(inside_out, *h).z > 0.9f);
    CHECK(smooth_normal(nothing, *h) == h->normal);
    const float huge = std::numeric_limits<float>::max();
    const mesh extreme(square, halves, std::vector<glm::vec3>(4, glm::vec3(huge, 0, huge)));
    CHECK(glm::distance(smooth_normal(extreme, *h), glm::normalize(glm::vec3(1, 0, 1))) < 1e-6f);
    const mesh tiny = meshes::placed(mesh(square, halves, {}), 1e-30f);
    const mesh tiny_smooth(tiny.vertices(), tiny.triangles(), std::vector<glm::vec3>(4, glm::vec3(1, 0, 1)));
    const auto t = closest(lantern::every{2}, tiny_smooth, ray{{0.25e-30f, 0.5e-30f, 1e-30f}, {0, 0, -1}});
    REQUIRE(t);
    CHECK(glm::distance(smooth_normal(tiny_smooth, *t), glm::normalize(glm::vec3(1, 0, 1))) < 1e-6f);
}

TEST_CASE("the normals of a fine sphere's vertices point away from its center") {
    const mesh m = meshes::sphere(40);
    const auto normals = vertex_normals(m);
    for (std::size_t i = 0; i < normals.size(); ++i) REQUIRE(glm::distance(normals[i], m.vertices()[i]) < 0.01f);
}

TEST_CASE("how a flat face is cut up does not matter to its vertices' normals") {
    // A corner of a cube; the top face once as two triangles through the corner, once as two beside it.
    const std::vector<glm::vec3> v{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, -1}, {1, 0, -1}, {0, 1, -1}};
    const std::vector<glm::uvec3> rest{{0, 4, 5}, {0, 5, 1}, {0, 3, 6}, {0, 6, 4}};
    auto through = rest, beside = rest;
    through.insert(through.end(), {{0, 1, 2}, {0, 2, 3}});
    beside.insert(beside.end(), {{0, 1, 3}, {1, 2, 3}});
    const glm::vec3 corner = glm::normalize(glm::vec3(-1, -1, 1));
    CHECK(glm::distance(vertex_normals(mesh(v, through))[0], corner) < 1e-6f);
    CHECK(glm::distance(vertex_normals(mesh(v, beside))[0], corner) < 1e-6f);
}

TEST_CASE("the meshes that tests use are what they say") {
    for (const std::uint32_t n : {1u, 2u, 7u}) {
        const mesh ball = meshes::sphere(n, 0.1f);
        CHECK(ball.size() == 8 * n * n);
        CHECK(closed(ball));
        for (const triangle& t : ball) REQUIRE(glm::dot(glm::cross(t.b - t.a, t.c - t.a), t.a + t.b + t.c) > 0);
        const mesh hills = meshes::terrain(n);
        CHECK(hills.size() == 2 * n * n);
        for (const triangle& t : hills) REQUIRE(glm::cross(t.b - t.a, t.c - t.a).y > 0);
        CHECK(meshes::slivers(n).size() == n);
        CHECK(meshes::soup(n, 0.1).size() == n);
    }
}
