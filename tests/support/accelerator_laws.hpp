// SPDX-License-Identifier: MIT
#pragma once
// What every acceleration structure must keep, whatever it is made of.

#include <lantern/aabb.hpp>
#include <lantern/closest.hpp>
#include <lantern/sphere.hpp>

#include "accelerator_scenes.hpp"
#include "catch.hpp"
#include "oracle.hpp"

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace accelerator_laws {

template <class Structure, class Surfaces, class Ray>
void check_ray(const std::string& name, const Structure& s, const Surfaces& surfaces, const Ray& r, interval range) {
    const lantern::every all{static_cast<std::uint32_t>(surfaces.size())};
    const std::string wrong = disagreement(name, s, surfaces, r, range, closest(all, surfaces, r, range));
    if (!wrong.empty()) FAIL(wrong);
    SUCCEED();
}

/// Every surface that the ray meets is offered, if nothing shortens the range.
template <class Structure, class Surfaces, class Ray>
void check_offers(const std::string& name, const Structure& s, const Surfaces& surfaces, const Ray& r, interval range) {
    std::vector<bool> offered(surfaces.size());
    s.traverse(r, range, [&](std::uint32_t i, interval remaining) -> interval {
        REQUIRE(i < surfaces.size());
        offered[i] = true;
        return remaining;
    });
    for (std::uint32_t i = 0; i < surfaces.size(); ++i)
        if (!offered[i] && intersect(surfaces[i], r, range))
            FAIL("scene: " << name << "\nray: from " << to_text(r.origin) << " along " << to_text(r.direction)
                           << "\nnot offered: surface " << i << "\nwrongly culled: " << wrongly_culled(s, i, r, range));
    SUCCEED();
}

/// `build` makes a structure of a std::vector<aabb>.
template <class Build>
void agrees_with_every(Build build, int rays = 1500) {
    dice d{.state = 12};
    for (const scene& s : scenes()) {
        const auto parts = boxes(s.surfaces);
        aabb all;
        for (const aabb& box : parts) all = enclose(all, box);
        const auto structure = build(parts);
        REQUIRE(structure.size() == parts.size());
        REQUIRE(structure.left_out() == 0);
        for (int i = 0; i < rays; ++i) {
            const ray r = adversarial(d, parts, all);
            const float t = d.magnitude_between(-3, 1);
            const interval range = i % 5 == 0 ? interval{t, 3 * t} : i % 5 == 1 ? interval{0, 1} : i % 5 == 2 ? interval{-t, t} : interval{};
            check_ray(s.name, structure, s.surfaces, r, range);
            if (i % 4 == 0) check_offers(s.name, structure, s.surfaces, r, range);
        }
    }
}

/// `build` takes boxes, or the surfaces themselves.
template <class Build>
void finds_what_moves(Build build, int rays = 800) {
    dice d{.state = 13};
    for (const moving_scene& s : moving_scenes()) {
        const auto parts = boxes(s.surfaces);
        aabb all;
        for (const aabb& box : parts) all = enclose(all, box);
        const auto structure = [&] {
            if constexpr (std::invocable<Build, const std::vector<aabb>&>) return build(parts);
            else return build(s.surfaces);
        }();
        for (int i = 0; i < rays; ++i) {
            const interval range = i % 5 == 0 ? interval{-1, 1} : interval{};
            check_ray(s.name, structure, s.surfaces, lantern::timed_ray{adversarial(d, parts, all), d.between(0, 1)}, range);
        }
    }
}

/// A hundred thousand at one place, concentric, in line: built in good time, and everything is still found.
template <class Build>
void survives_degenerate_input(Build build) {
    constexpr std::uint32_t count = 100000;
    std::vector<aabb> same(count, aabb{{0, 0, 0}, {1, 1, 1}}), point(count, aabb{{1, 2, 3}, {1, 2, 3}}), concentric, line;
    for (std::uint32_t i = 0; i < count; ++i) {
        concentric.push_back({glm::vec3(-float(i)), glm::vec3(float(i))});
        line.push_back({{float(i), 0, 0}, {float(i), 0, 0}});
    }
    for (const auto& parts : {same, point, concentric, line}) {
        const auto structure = build(parts);
        CHECK(structure.size() == count);
        const ray r{center(parts[77]) - glm::vec3(0, 0, 2e5f), {0, 0, 1}};
        std::vector<bool> offered(count);
        structure.traverse(r, interval{}, [&](std::uint32_t i, interval range) {
            offered[i] = true;
            return range;
        });
        for (std::uint32_t i = 0; i < count; ++i)
            if (!offered[i] && contains(parts[i], center(parts[77]))) FAIL("not offered: " << i);
    }
    // Points in line are told apart: a ray across the line meets few.
    lantern::probe counter;
    build(line).traverse(ray{{777, 0, 5}, {0, 0, -1}}, interval{}, [](std::uint32_t, interval range) { return range; }, counter);
    CHECK(counter.offers >= 1);
    CHECK(counter.offers < 200);
}

template <class Build>
void leaves_out_and_counts(Build build) {
    constexpr float bad = std::numeric_limits<float>::quiet_NaN(), inf = lantern::infinity;
    const std::vector<aabb> parts{{{0, 0, 0}, {1, 1, 1}},    {{bad, 0, 0}, {1, 1, 1}}, {{0, 0, 0}, {bad, 1, 1}},
                                  {{-inf, 0, 0}, {1, 1, 1}}, {{0, 0, 0}, {1, inf, 1}}, {},
                                  {{2, 2, 2}, {3, 3, 3}}};
    const auto structure = build(parts);
    CHECK(structure.left_out() == 5);
    CHECK(structure.size() == 7);
    std::vector<std::uint32_t> offered;
    structure.traverse(ray{{-1, -1, -1}, {1, 1, 1}}, interval{}, [&](std::uint32_t i, interval range) {
        offered.push_back(i);
        return range;
    });
    std::sort(offered.begin(), offered.end());
    offered.erase(std::unique(offered.begin(), offered.end()), offered.end());
    CHECK(offered == std::vector<std::uint32_t>{0, 6});
    const auto hollow = build(std::vector<aabb>(3));
    CHECK(hollow.left_out() == 3);
    hollow.traverse(ray{}, interval{}, [](std::uint32_t, interval range) { FAIL("offered"); return range; });
}

/// Few of many spheres are offered; what lies behind a hit is not looked at; and an empty range ends the walk.
template <class Build>
void looks_at_few(Build build, std::uint64_t offers_a_ray, std::uint64_t nodes_a_ray) {
    dice d{.state = 15};
    std::vector<sphere> spheres;
    for (int i = 0; i < 1000; ++i) spheres.push_back({d.in_cube(10), 0.3f});
    const auto structure = build(boxes(spheres));
    lantern::probe counter;
    for (int i = 0; i < 2000; ++i) (void)closest(structure, spheres, ray{d.in_cube(20), d.in_cube()}, {}, counter);
    INFO("a ray: " << double(counter.offers) / 2000 << " offers, " << double(counter.nodes) / 2000 << " nodes");
    CHECK(counter.offers < offers_a_ray * 2000);
    CHECK(counter.nodes < nodes_a_ray * 2000);

    std::vector<sphere> row;
    for (int i = 0; i < 1024; ++i) row.push_back({{0, 0, -2.0f * float(i + 1)}, 0.5f});
    const auto in_line = build(boxes(row));
    lantern::probe near, far, shadow;
    CHECK(closest(in_line, row, ray{{0, 0, 0}, {0, 0, -1}}, {}, near)->index == 0);
    CHECK(closest(in_line, row, ray{{0, 0, -3000}, {0, 0, 1}}, {}, far)->index == 1023);
    CHECK(near.offers <= 12);
    CHECK(far.offers <= 12);
    CHECK(near.nodes <= 60);
    CHECK(far.nodes <= 60);
    CHECK(occluded(in_line, row, ray{{0, 0, -1000}, {0, 0, -1}}, {}, shadow));
    CHECK(shadow.offers <= 12);

    int offered = 0;
    structure.traverse(ray{{-20, 0, 0}, {1, 0, 0}}, interval{3, 2}, [&](std::uint32_t, interval range) { ++offered; return range; });
    CHECK(offered == 0);
    structure.traverse(ray{spheres[0].center, {1, 0, 0}}, interval{}, [&](std::uint32_t, interval) { ++offered; return interval{0, 0}; });
    CHECK(offered == 1);
}

/// Rays of NaN, of no direction, of infinite origin: whatever is answered, the walk ends.
template <class Build>
void ends_with_any_ray(Build build) {
    dice d{.state = 16};
    std::vector<aabb> parts;
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 p = d.in_cube();
        parts.push_back({p, p + 0.1f});
    }
    const auto structure = build(parts);
    constexpr float bad = std::numeric_limits<float>::quiet_NaN(), inf = lantern::infinity;
    const std::array<float, 8> values{0, -0.0f, 1, -1, bad, inf, -inf, 1e38f};
    for (int i = 0; i < 3000; ++i) {
        ray r;
        for (int k = 0; k < 3; ++k) r.origin[k] = values[d.below(8)], r.direction[k] = values[d.below(8)];
        structure.traverse(r, interval{}, [](std::uint32_t, interval range) { return range; });
    }
    SUCCEED();
}

}  // namespace accelerator_laws
