// SPDX-License-Identifier: MIT
// Input that defeats a structure's idea of dividing: it neither hangs, nor overflows, nor costs a ray all surfaces without need.

#include <lantern/aabb.hpp>
#include <lantern/bvh.hpp>
#include <lantern/closest.hpp>
#include <lantern/grid.hpp>
#include <lantern/interval.hpp>
#include <lantern/kd_tree.hpp>
#include <lantern/octree.hpp>
#include <lantern/ray.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

using lantern::aabb;
using lantern::interval;
using lantern::probe;
using lantern::ray;

namespace {

/// What one ray costs in a structure that has been built; nothing is hit, but the first `stop` offers end the walk.
using cost = std::function<probe(const ray&, std::uint64_t stop)>;

constexpr std::uint64_t never = ~std::uint64_t{0};

template <class Structure>
cost walk_of(Structure structure) {
    return [structure = std::move(structure)](const ray& r, std::uint64_t stop) {
        probe counter;
        std::uint64_t offered = 0;
        structure.traverse(r, interval{}, [&](std::uint32_t, interval range) { return ++offered < stop ? range : interval{0, 0}; }, counter);
        return counter;
    };
}

/// Each structure over the boxes, one after the other.
void for_each_structure(const std::vector<aabb>& boxes, const std::function<void(const std::string&, const cost&)>& look) {
    using lantern::split;
    const std::vector<std::pair<std::string, split>> rules{
        {"middle", split::middle}, {"median", split::median}, {"surface area", split::surface_area}, {"bottom up", split::bottom_up}};
    for (const auto& [name, rule] : rules) look("bvh, " + name, walk_of(lantern::bvh<>(boxes, {.rule = rule})));
    look("grid", walk_of(lantern::grid(boxes)));
    look("octree", walk_of(lantern::octree(boxes)));
    look("kd_tree", walk_of(lantern::kd_tree(boxes)));
}

}  // namespace

TEST_CASE("a million duplicates: all are offered to a ray that meets them, one is enough for a shadow, none to a ray beside them") {
    constexpr std::uint32_t count = 1'000'000;
    const std::vector<aabb> boxes(count, aabb{{1, 2, 3}, {2, 3, 4}});
    for_each_structure(boxes, [&](const std::string& name, const cost& walk) {
        INFO(name);
        const std::uint64_t all = walk(ray{{1.5f, 2.5f, 0}, {0, 0, 1}}, never).offers;
        CHECK(all >= count);
        CHECK(all <= (name == "grid" ? 4 : 1) * count);  // which divides the space around them, and cannot know that it is in vain
        const probe one = walk(ray{{1.5f, 2.5f, 0}, {0, 0, 1}}, 1), none = walk(ray{{0, 0, 0}, {0, 0, 1}}, never);
        CHECK(one.offers == 1);
        CHECK(one.nodes < 60);
        CHECK(none.offers == 0);
        CHECK(none.nodes <= 3);
    });
}

TEST_CASE("one point, many times, and once; nothing at all") {
    for (const std::uint32_t count : {0u, 1u, 50'000u})
        for_each_structure(std::vector<aabb>(count, aabb{{1, 2, 3}, {1, 2, 3}}), [&](const std::string& name, const cost& walk) {
            INFO(name);
            CHECK(walk(ray{{1, 2, 0}, {0, 0, 1}}, never).offers == count);
            CHECK(walk(ray{{1, 2.001f, 0}, {0, 0, 1}}, never).offers == 0);
        });
}

TEST_CASE("equal centres: a ray that passes through the outer shells only does not look at the inner ones") {
    constexpr std::uint32_t count = 50'000;
    std::vector<aabb> onion;
    for (std::uint32_t i = 0; i < count; ++i) onion.push_back({glm::vec3(-1 - float(i)), glm::vec3(1 + float(i))});
    for_each_structure(onion, [&](const std::string& name, const cost& walk) {
        const float outside = float(count) - 99.5f;  // of all but the last hundred
        const probe p = walk(ray{{-2e5f, outside, 0}, {1, 0, 0}}, never);
        INFO(name << ": " << p.offers << " offers, " << p.nodes << " nodes");
        CHECK(p.offers >= 100);
        if (name.starts_with("bvh, s") || name.starts_with("bvh, b")) CHECK(p.offers + p.nodes < 1000);  // those that look at size
        CHECK(p.nodes < 10'000);
    });
}

TEST_CASE("a teapot in a stadium: who divides where it is crowded finds a spout among a hundred thousand in few steps") {
    dice d{.state = 3};
    std::vector<aabb> boxes{{{-100, -1, -100}, {100, -1, 100}}, {{90, 0, 90}, {100, 50, 100}}};
    for (int i = 0; i < 100'000; ++i) {
        const glm::vec3 p = 0.1f * glm::vec3(d.on_sphere());
        boxes.push_back({p - 0.0005f, p + 0.0005f});
    }
    for_each_structure(boxes, [&](const std::string& name, const cost& walk) {
        if (name == "grid") return;  // all of the teapot is in one of its cells
        probe sum;
        for (int i = 0; i < 100; ++i) {
            const glm::vec3 from = 50.0f * glm::vec3(d.on_sphere()), aim = 0.1f * glm::vec3(d.on_sphere());
            const probe p = walk(ray{from, aim - from}, never);
            sum.nodes += p.nodes, sum.offers += p.offers;
        }
        INFO(name << ": " << double(sum.offers) / 100 << " offers, " << double(sum.nodes) / 100 << " nodes a ray");
        CHECK(sum.offers < 100 * 200);
        CHECK(sum.nodes < 100 * 400);
    });
}
