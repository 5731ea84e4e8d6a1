// SPDX-License-Identifier: MIT
#include <lantern/box_quartet.hpp>

#include <lantern/aabb.hpp>
#include <lantern/box_ray.hpp>
#include <lantern/boxes_of.hpp>

#include "box_laws.hpp"
#include "catch.hpp"
#include "oracle.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

using lantern::aabb;
using lantern::box_quartet;
using lantern::box_quartet_ray;
using lantern::interval;
using lantern::quad;
using lantern::ray;
using namespace box_laws;

TEST_CASE("box_quartet: no ray that meets a box is told that it does not, whichever slot it is in") {
    std::size_t slot = 0;
    no_ray_is_lost([&](const aabb& box, const ray& r, interval range) {
        slot = (slot + 1) % 4;
        box_quartet four;
        four.set(slot, box);
        quad entry;
        return box_quartet_ray(r, range, lantern::reach_of(box)).meets(four, entry) == 1u << slot;
    });
}

TEST_CASE("box_quartet: four boxes at once are answered as each of them alone, before and after a hit") {
    dice d{3};
    int met = 0;
    for (int i = 0; i < count; ++i) {
        std::array<aabb, 4> boxes;
        box_quartet four;
        double reach = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            boxes[k] = random_box(d, 3);
            four.set(k, boxes[k]);
            reach = std::max(reach, lantern::reach_of(boxes[k]));
            REQUIRE((four[k].min == boxes[k].min && four[k].max == boxes[k].max));
        }
        const ray r{d.in_cube(3), (d.below(4) == 0 ? d.magnitude_between(-30, 30) : 1) * d.in_cube()};
        const interval range = i % 3 == 0 ? interval{-1, d.between(0, 3)} : i % 3 == 1 ? interval{d.between(0, 3), 4} : interval{};
        lantern::box_ray one(r, range, reach);
        box_quartet_ray all(r, range, reach);
        for (int turn = 0; turn < 2; ++turn) {
            quad entries;
            const std::uint32_t bits = all.meets(four, entries);
            for (std::size_t k = 0; k < 4; ++k) {
                float entry;
                const bool alone = one.meets(boxes[k], entry);
                REQUIRE((bits >> k & 1) == alone);
                if (alone) REQUIRE(entries[k] == entry);
                met += alone;
            }
            one.shorten(1);
            all.shorten(1);
        }
    }
    CHECK(met > count / 4);
}

TEST_CASE("box_quartet: no ray meets a slot that is not used, from wherever it comes") {
    dice d{4};
    const float inf = lantern::infinity, largest = std::numeric_limits<float>::max();
    box_quartet four;
    four.set(2, {{-1, -1, -1}, {1, 1, 1}});
    for (int i = 0; i < count; ++i) {
        ray r{d.magnitude_between(-40, 38) * d.in_cube(), d.magnitude_between(-40, 38) * d.in_cube()};
        if (d.below(4) == 0) r.direction[int(d.below(3))] = 0;
        if (d.below(9) == 0) r.origin = glm::vec3(-largest);
        const interval range = d.below(2) == 0 ? interval{} : interval{-inf, inf};
        quad entry;
        REQUIRE((box_quartet_ray(r, range, 1).meets(four, entry) & ~4u) == 0);
    }
}
