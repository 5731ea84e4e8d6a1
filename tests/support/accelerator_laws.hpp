// SPDX-License-Identifier: MIT
#pragma once
// What every acceleration structure must keep, whatever it is made of. A failure prints the scene, the ray, the hit that was
// expected, what was found, and, where the structure can be looked into, the first node that was culled wrongly.

#include <lantern/aabb.hpp>
#include <lantern/any_of.hpp>
#include <lantern/closest.hpp>
#include <lantern/moving.hpp>
#include <lantern/rectangle.hpp>
#include <lantern/sphere.hpp>
#include <lantern/triangle.hpp>
#include <lantern/validate.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace accelerator_laws {

using lantern::aabb;
using lantern::interval;
using lantern::ray;
using lantern::sphere;
using lantern::to_text;
using shape = lantern::any_of<sphere, lantern::triangle, lantern::rectangle>;

struct scene {
    std::string name;
    std::vector<shape> surfaces;
};

template <class Surfaces>
std::vector<aabb> boxes(const Surfaces& surfaces) {
    std::vector<aabb> all;
    for (const auto& s : surfaces) all.push_back(bounds(s));
    return all;
}

/// What is easy, what coincides, what is flat, what is crowded, what is huge or tiny, and what is hardly there.
inline std::vector<scene> scenes() {
    dice d{.state = 11};
    const auto mixture = [&](std::uint32_t count, float size, float scale = 1, float far = 0) {
        std::vector<shape> all;
        for (std::uint32_t i = 0; i < count; ++i) {
            const glm::vec3 p = scale * (d.in_cube() + glm::vec3(far)), a = scale * d.in_cube(size), b = scale * d.in_cube(size);
            if (i % 3 == 0) all.emplace_back(sphere{p, 0.3f * size * scale});
            if (i % 3 == 1) all.emplace_back(lantern::triangle{p, p + a, p + b});
            if (i % 3 == 2) all.emplace_back(lantern::rectangle{p, a, b});
        }
        return all;
    };
    std::vector<shape> walls, terrain, row, stadium = mixture(150, 1e-4f, 1e-3f), duplicates, onion, points, powers;
    for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 5; ++j)
            for (int axis = 0; axis < 3; ++axis) {
                lantern::rectangle w{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
                w.corner[axis] = float(i), w.corner[(axis + 1) % 3] = float(j), w.u[(axis + 1) % 3] = 1, w.v[(axis + 2) % 3] = 5;
                walls.emplace_back(w);
            }
    for (int i = 0; i < 10; ++i)
        for (int j = 0; j < 10; ++j) {
            const float x = float(i), z = float(j);
            terrain.emplace_back(lantern::triangle{{x, 0, z}, {x + 1, 0, z}, {x, 0, z + 1}});
            terrain.emplace_back(lantern::triangle{{x + 1, 0, z}, {x + 1, 0, z + 1}, {x, 0, z + 1}});
        }
    for (int i = 0; i < 150; ++i) {
        row.emplace_back(sphere{{float(i), 0, 0}, 0.5f});
        duplicates.emplace_back(sphere{{1, 2, 3}, 0.25f});
        onion.emplace_back(sphere{{1, 2, 3}, float(i + 1)});
        points.emplace_back(sphere{{float(d.below(16)), float(d.below(16)), float(d.below(16))}, 0});  // in corners of cells
        powers.emplace_back(sphere{d.magnitude_between(-18, 9) * d.in_cube(), d.magnitude_between(-18, 8)});
    }
    stadium.emplace_back(lantern::rectangle{{-100, -1, -100}, {200, 0, 0}, {0, 0, 200}});
    stadium.emplace_back(sphere{{100, 50, 100}, 30});
    return {{"small things", mixture(200, 0.05f)},   {"large things", mixture(200, 0.8f)},
            {"walls", walls},                        {"flat terrain", terrain},
            {"a row of touching spheres", row},      {"a teapot in a stadium", stadium},
            {"duplicates", duplicates},              {"an onion", onion},
            {"points", points},                      {"all powers of ten", powers},
            {"tiny", mixture(120, 0.2f, 1e-15f)},    {"huge", mixture(120, 0.2f, 1e12f)},
            {"far away", mixture(120, 0.2f, 1, 1e4f)}, {"one", mixture(1, 0.5f)},
            {"two", mixture(2, 0.5f)},               {"nothing", {}}};
}

/// Rays that a structure may get wrong: through corners and within faces of boxes, along axes, with -0, from inside, from
/// far away, of any length.
inline ray adversarial(dice& d, const std::vector<aabb>& boxes, const aabb& all) {
    const glm::vec3 extent = empty(all) ? glm::vec3(1) : all.max - all.min;
    const float size = std::max({extent.x, extent.y, extent.z, 1e-30f});
    const auto point_of = [&](const aabb& box) {
        glm::vec3 p = center(box);
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t kind = d.below(4);
            p[k] = kind == 0 ? box.min[k] : kind == 1 ? box.max[k] : kind == 2 ? p[k] : d.between(box.min[k], box.max[k]);
        }
        return p;
    };
    const aabb some = boxes.empty() ? aabb{{0, 0, 0}, {1, 1, 1}} : boxes[d.below(static_cast<std::uint32_t>(boxes.size()))];
    const glm::vec3 target = point_of(some);
    ray r;
    switch (d.below(4)) {
        case 0: r.origin = center(some) + d.in_cube(size); break;
        case 1: r.origin = point_of(empty(all) ? some : all); break;
        case 2: r.origin = point_of(boxes.empty() ? some : boxes[d.below(static_cast<std::uint32_t>(boxes.size()))]); break;
        default: r.origin = center(some) + d.magnitude_between(-3, 5) * d.in_cube(size);
    }
    r.direction = d.below(3) == 0 ? size * d.in_cube() : target - r.origin;
    for (int k = 0; k < 3; ++k) {
        const std::uint32_t kind = d.below(10);
        if (kind == 0) r.direction[k] = 0;
        if (kind == 1) r.direction[k] = -0.0f;
        if (kind == 2) r.direction[k] *= 1e-20f;
        if (kind == 3) r.origin[k] = target[k];
    }
    if (d.below(4) == 0) r.direction *= d.magnitude_between(-12, 12);
    return r;
}

inline aabb bounds_of(const aabb& box) { return box; }
template <class Volume>
aabb bounds_of(const Volume& volume) {
    return bounds(volume);
}

/// Where the search for surface `index` was cut off; what the structure shows of itself decides how much can be said.
template <class Structure>
std::string wrongly_culled(const Structure& s, std::uint32_t index, const ray& r, interval range) {
    const auto text = [](const aabb& box) { return to_text(box.min) + " to " + to_text(box.max); };
    std::string found = "(the structure does not show its nodes)";
    if constexpr (requires { s.nodes(); s.indices(); }) {
        found = "no node: it lies behind a nearer hit, or no leaf that the ray meets has it";
        const auto visit = [&](const auto& self, std::uint32_t at, aabb cell, bool culled) -> bool {
            const auto n = s.nodes()[at];
            std::vector<std::pair<std::uint32_t, aabb>> children;
            bool leaf = true;
            if constexpr (requires { n.octants; }) {
                cell = n.box, leaf = n.octants == 0;
                for (std::uint32_t i = 0, rest = n.octants; rest != 0; rest &= rest - 1, ++i) children.push_back({n.first + i, {}});
            } else if constexpr (requires { n.cut; }) {
                leaf = n.axis == 3;
                if (!leaf) {
                    aabb below = cell, above = cell;
                    below.max[int(n.axis)] = above.min[int(n.axis)] = n.cut;
                    children = {{n.first, below}, {n.first + 1, above}};
                }
            } else {
                leaf = n.size > 0;
                cell = bounds_of(n.volume);
                if (!leaf) children = {{n.first, {}}, {n.first + 1, {}}};
            }
            bool here = !culled && !overlaps(cell, r, range);
            if constexpr (requires { n.volume; }) here = !culled && !overlaps(n.volume, r, range);
            bool holds = false;
            if (leaf)
                for (std::uint32_t i = n.first; i < n.first + n.size; ++i) holds = holds || s.indices()[i] == index;
            for (const auto& [child, box] : children) holds = holds || self(self, child, box, culled || here);
            if (holds && here) found = "node " + std::to_string(at) + ", " + text(cell);
            return holds;
        };
        aabb root;
        if constexpr (requires { s.box(); }) root = s.box();
        if (!s.nodes().empty()) visit(visit, 0, root, false);
    } else if constexpr (requires { s.cells(); s.entries(); }) {
        for (int z = 0; z < s.cells().z; ++z)
            for (int y = 0; y < s.cells().y; ++y)
                for (int x = 0; x < s.cells().x; ++x) {
                    const auto in = s.entries(glm::ivec3(x, y, z));
                    const glm::vec3 size = (s.box().max - s.box().min) / glm::vec3(s.cells());
                    const glm::vec3 low = s.box().min + glm::vec3(x, y, z) * size;
                    if (std::find(in.begin(), in.end(), index) != in.end() && overlaps(aabb{low, low + size}, r, range))
                        return "cell " + to_text(glm::vec3(x, y, z)) + " has it and is on the ray";
                }
    }
    return found;
}

template <class Hit>
std::string text_of(const Hit& h) {
    return h ? "surface " + std::to_string(h->index) + " at t = " + to_text(h->t) : "nothing";
}

template <class Structure, class Surfaces, class Ray>
void check_ray(const std::string& name, const Structure& s, const Surfaces& surfaces, const Ray& r, interval range) {
    const lantern::every all{static_cast<std::uint32_t>(surfaces.size())};
    const auto expected = closest(all, surfaces, r, range), got = closest(s, surfaces, r, range);
    const bool same = expected.has_value() == got.has_value() &&
                      (!expected || (expected->index == got->index && expected->t == got->t && expected->point == got->point &&
                                     expected->normal == got->normal));
    if (same && occluded(s, surfaces, r, range) == expected.has_value()) {
        SUCCEED();
        return;
    }
    FAIL("scene: " << name << "\nray: from " << to_text(r.origin) << " along " << to_text(r.direction) << ", range ("
                   << to_text(range.min) << ", " << to_text(range.max) << "]\nexpected: " << text_of(expected)
                   << "\nfound: " << text_of(got) << (same ? ", but occluded says otherwise" : "") << "\nwrongly culled: "
                   << (expected ? wrongly_culled(s, expected->index, r, {range.min, expected->t}) : "nothing"));
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
            const interval range = i % 5 == 0 ? interval{t, 3 * t} : i % 5 == 1 ? interval{0, 1} : interval{};
            check_ray(s.name, structure, s.surfaces, r, range);
            if (i % 4 == 0) check_offers(s.name, structure, s.surfaces, r, range);
        }
    }
}

template <class Build>
void finds_what_moves(Build build) {
    dice d{.state = 13};
    std::vector<lantern::moving<sphere>> balls;
    for (int i = 0; i < 150; ++i) balls.push_back({{d.in_cube(), d.between(0.01, 0.2)}, d.in_cube(0.7)});
    const auto parts = boxes(balls);
    aabb all;
    for (const aabb& box : parts) all = enclose(all, box);
    const auto structure = build(parts);
    for (int i = 0; i < 3000; ++i)
        check_ray("moving spheres", structure, balls, lantern::timed_ray{adversarial(d, parts, all), d.between(0, 1)}, {});
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
