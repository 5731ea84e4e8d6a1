// SPDX-License-Identifier: MIT
// Every structure answers what brute force answers, on any scene and for any ray: not finite ones, too.

#include <lantern/any_of.hpp>
#include <lantern/bvh.hpp>
#include <lantern/closest.hpp>
#include <lantern/grid.hpp>
#include <lantern/kd_tree.hpp>
#include <lantern/obb.hpp>
#include <lantern/octree.hpp>
#include <lantern/rectangle.hpp>
#include <lantern/sphere.hpp>
#include <lantern/triangle.hpp>

#include "demand.hpp"
#include "scene_bytes.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace {

using shape = lantern::any_of<lantern::sphere, lantern::triangle, lantern::rectangle>;

void check(const auto& structure, const std::vector<shape>& scene, const std::vector<lantern::ray>& rays,
           lantern::interval range) {
    demand(structure.size() == scene.size() && structure.left_out() <= scene.size(), "every surface is counted");
    for (const lantern::ray& r : rays) {
        const auto expected = closest(lantern::every{static_cast<std::uint32_t>(scene.size())}, scene, r, range);
        const auto got = closest(structure, scene, r, range);
        demand(expected.has_value() == got.has_value(), "hit where brute force hits");
        if (expected) demand(expected->index == got->index && expected->t == got->t, "the same hit");
        demand(occluded(structure, scene, r, range) == expected.has_value(), "occluded where there is a hit");
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size > 4096) return 0;
    scene_bytes bytes(data, size);
    const std::uint8_t kind = bytes.byte();
    std::vector<lantern::ray> rays(1 + kind / 64);
    for (lantern::ray& r : rays) r = {bytes.vector(), bytes.vector()};
    lantern::interval range{};
    if ((kind & 32) != 0) range.min = bytes.number(), range.max = bytes.number();
    std::vector<shape> scene;
    while (!bytes.empty()) {
        const std::uint8_t what = bytes.byte();
        const glm::vec3 a = bytes.vector();
        if (what % 3 == 0) {
            scene.emplace_back(lantern::sphere{a, bytes.number()});
        } else {
            const glm::vec3 b = bytes.vector(), c = bytes.vector();
            if (what % 3 == 1) scene.emplace_back(lantern::triangle{a, b, c});
            else scene.emplace_back(lantern::rectangle{a, b, c});
        }
        for (int copies = what / 86; copies > 0; --copies) scene.push_back(scene.back());
    }
    using lantern::split;
    switch (kind % 8) {
        case 0: check(lantern::bvh<>(scene, {.rule = split::middle}), scene, rays, range); break;
        case 1: check(lantern::bvh<>(scene, {.rule = split::median, .leaf_size = 1}), scene, rays, range); break;
        case 2: check(lantern::bvh<>(scene, {.rule = split::surface_area, .leaf_size = 1}), scene, rays, range); break;
        case 3: check(lantern::bvh<>(scene, {.rule = split::bottom_up}), scene, rays, range); break;
        case 4: check(lantern::grid(scene, {.max_cells = 4096}), scene, rays, range); break;
        case 5: check(lantern::octree(scene, {.leaf_size = 1}), scene, rays, range); break;
        case 6: check(lantern::kd_tree(scene, {.leaf_size = 1}), scene, rays, range); break;
        default: check(lantern::bvh<lantern::obb>(scene, {.leaf_size = 1}), scene, rays, range); break;
    }
    return 0;
}
