// SPDX-License-Identifier: MIT
// wide_bvh answers what brute force answers, to the last bit, on any triangles and for any ray ahead of its origin.

#include <lantern/closest.hpp>
#include <lantern/triangle.hpp>
#include <lantern/wide_bvh.hpp>

#include "demand.hpp"
#include "scene_bytes.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size > 4096) return 0;
    scene_bytes bytes(data, size);
    const std::uint8_t kind = bytes.byte();
    std::vector<lantern::ray> rays(1 + kind / 64);
    for (lantern::ray& r : rays) r = {bytes.vector(), bytes.vector()};
    lantern::interval range{};
    if ((kind & 32) != 0) range.min = std::max(0.0f, bytes.number()), range.max = bytes.number();
    std::vector<lantern::triangle> mesh;
    while (!bytes.empty()) {
        const std::uint8_t what = bytes.byte();
        lantern::triangle t{bytes.vector(), {}, {}};
        t.b = mesh.empty() || what % 4 != 1 ? bytes.vector() : mesh.back().b;  // neighbours share an edge
        t.c = mesh.empty() || what % 4 != 1 ? bytes.vector() : mesh.back().c;
        mesh.push_back(t);
        for (int copies = what / 86; copies > 0; --copies) mesh.push_back(t);
    }
    const lantern::every all{static_cast<std::uint32_t>(mesh.size())};
    try {
        const lantern::wide_bvh tree(mesh, {.threads = 1});
        demand(tree.size() == mesh.size(), "every triangle is counted");
        for (const lantern::ray& r : rays) {
            const auto expected = closest(all, mesh, r, range), got = closest(tree, r, range);
            demand(expected.has_value() == got.has_value(), "hit where brute force hits");
            if (expected)
                demand(expected->index == got->index && expected->t == got->t && expected->point == got->point &&
                           expected->normal == got->normal, "the same hit");
            demand(occluded(tree, r, range) == expected.has_value(), "occluded where there is a hit");
        }
    } catch (const std::invalid_argument&) {  // a coordinate of 2^60 or more
    }
    return 0;
}
