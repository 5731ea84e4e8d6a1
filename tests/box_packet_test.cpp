// SPDX-License-Identifier: MIT
#include <lantern/box_packet.hpp>

#include <lantern/aabb.hpp>
#include <lantern/ray.hpp>
#include <lantern/validate.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

using lantern::aabb;
using lantern::box_packet;
using lantern::box_packet_ray;
using lantern::floats;
using lantern::ray;

namespace {

std::uint32_t met(const box_packet& p, const ray& r, float reach, float max = lantern::infinity) {
    const box_packet_ray prepared(r, reach);
    floats entry;
    return overlaps(p, prepared, 0, max * prepared.per_unit, entry);
}

float axis_part(dice& d) { return d.below(4) == 0 ? (d.below(2) == 0 ? 0.0f : -0.0f) : d.between(-1, 1); }

}  // namespace

TEST_CASE("no ray misses a box that it was aimed at: corners, edges, faces, flat boxes and points") {
    dice d{.state = 1};
    for (int i = 0; i < 30'000; ++i) {
        const float scale = d.magnitude_between(-15, 15);
        box_packet p;
        aabb box[8];
        for (std::size_t k = 0; k < 8; ++k) {
            const glm::vec3 a = scale * d.in_cube(), b = d.below(4) == 0 ? a : scale * d.in_cube();
            box[k] = enclose(aabb{a, a}, b);
            if (d.below(3) == 0) box[k].max[int(k % 3)] = box[k].min[int(k % 3)];
            p.set(k, box[k]);
        }
        const std::size_t k = d.below(8);
        glm::vec3 to;  // in a corner, on an edge, on a face or inside
        for (int axis = 0; axis < 3; ++axis) {
            const float low = box[k].min[axis], high = box[k].max[axis];
            const std::uint32_t side = d.below(3);
            to[axis] = side == 0 ? low : side == 1 ? high : std::clamp(low + d.between(0, 1) * (high - low), low, high);
        }
        // A point of the ray is in the box, to within the rounding of this line.
        const glm::vec3 way{axis_part(d), axis_part(d), axis_part(d)};
        if (way == glm::vec3(0)) continue;
        const float step = std::ldexp(1.0f, static_cast<int>(d.below(6)) - 3) * scale;
        const glm::vec3 from(glm::dvec3(to) - double(step) * glm::dvec3(way));
        const float length = d.magnitude_between(-30, 30);
        const ray r{from, length * way};
        if (r.direction == glm::vec3(0)) continue;
        INFO("from " << lantern::to_text(r.origin) << " along " << lantern::to_text(r.direction) << ", box " << k << ": "
                     << lantern::to_text(box[k].min) << " to " << lantern::to_text(box[k].max));
        REQUIRE((met(p, r, scale) >> k & 1) == 1);
    }
}

TEST_CASE("boxes that the ray passes by, leaves behind, or would meet too late are not met") {
    box_packet p;
    p.set(0, {{1, -1, -1}, {2, 1, 1}});
    p.set(1, {{-2, -1, -1}, {-1, 1, 1}});
    p.set(2, {{1, 1.001f, -1}, {2, 2, 1}});
    p.set(3, {{5, -1, -1}, {6, 1, 1}});
    CHECK(met(p, {{0, 0, 0}, {1, 0, 0}}, 6) == 0b1001);
    CHECK(met(p, {{0, 0, 0}, {1, 0, 0}}, 6, 4.99f) == 0b0001);
    CHECK(met(p, {{0, 0, 0}, {-1, 0, 0}}, 6) == 0b0010);
    CHECK(met(p, {{1.5f, 0, 0}, {0, 1, 0}}, 6) == 0b0101);
    CHECK(met(p, {{1.5f, 0, 0}, {0, 1e-36f, 0}}, 6, 1e36f) == 0b0001);  // t counts in lengths of the direction
}

TEST_CASE("slots that are not used are never met") {
    dice d{.state = 2};
    const box_packet nothing;
    for (int i = 0; i < 5000; ++i) {
        const ray r{d.magnitude_between(-30, 30) * d.in_cube(), d.in_cube()};
        REQUIRE(met(nothing, r, 1) == 0);
    }
}

TEST_CASE("of overlapping boxes the distances are in order") {
    dice d{.state = 3};
    for (int i = 0; i < 2000; ++i) {
        box_packet p;
        for (std::size_t k = 0; k < 8; ++k) p.set(k, {{float(k), -1, -1}, {float(k) + 0.5f, 1, 1}});
        const ray r{{-1 - d.between(0, 5), 0, 0}, {1, 0.01f * d.between(-1, 1), 0}};
        floats entry;
        const box_packet_ray prepared(r, 8);
        REQUIRE(overlaps(p, prepared, 0, lantern::infinity, entry) == 255);
        for (int k = 0; k < 7; ++k) REQUIRE(entry[k] < entry[k + 1]);
    }
}
