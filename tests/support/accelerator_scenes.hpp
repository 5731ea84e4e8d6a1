// SPDX-License-Identifier: MIT
#pragma once
// Scenes and rays that acceleration structures may get wrong, and what they got wrong: the scene, the ray, the hit that was
// expected, what was found, and, where the structure can be looked into, the first node that was culled wrongly.

#include <lantern/aabb.hpp>
#include <lantern/any_of.hpp>
#include <lantern/bounding_volume.hpp>
#include <lantern/box_ray.hpp>
#include <lantern/boxes_of.hpp>
#include <lantern/closest.hpp>
#include <lantern/moving.hpp>
#include <lantern/rectangle.hpp>
#include <lantern/rotating.hpp>
#include <lantern/sphere.hpp>
#include <lantern/triangle.hpp>
#include <lantern/validate.hpp>

#include "oracle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
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

/// What moves: all alike, each its own way, in circles, or both at once; some far, some hardly, some not at all.
using moving_shape = lantern::any_of<lantern::moving<sphere>, lantern::moving<lantern::triangle>, lantern::rotating<sphere>,
                                     lantern::moving<lantern::rotating<sphere>>, sphere>;

struct moving_scene {
    std::string name;
    std::vector<moving_shape> surfaces;
};

inline std::vector<moving_scene> moving_scenes() {
    dice d{.state = 14};
    const auto mixture = [&](float way, float scale = 1, float far = 0, glm::vec3 wind = {}) {
        std::vector<moving_shape> all;
        for (int i = 0; i < 150; ++i) {
            const glm::vec3 p = scale * (d.in_cube() + glm::vec3(far)), by = scale * (way * d.in_cube() + wind), axis(d.on_sphere());
            const sphere ball{p, scale * d.between(0.01, 0.1)};
            const lantern::rotating turning{ball, p + scale * d.in_cube(0.3), axis, way * d.between(-4, 4)};
            if (i % 5 == 0) all.emplace_back(lantern::moving{ball, by});
            if (i % 5 == 1) all.emplace_back(lantern::moving{lantern::triangle{p, p + scale * d.in_cube(0.2), p + scale * d.in_cube(0.2)}, by});
            if (i % 5 == 2) all.emplace_back(turning);
            if (i % 5 == 3) all.emplace_back(lantern::moving{turning, by});
            if (i % 5 == 4) all.emplace_back(ball);
        }
        return all;
    };
    std::vector<moving_shape> drift, crossing;
    for (int i = 0; i < 150; ++i) {
        drift.emplace_back(lantern::moving{sphere{d.in_cube(), 0.05f}, glm::vec3(3, 0.5f, 0)});
        const float x = float(i % 2);  // half of them go where the other half come from, in the end exactly
        crossing.emplace_back(lantern::moving{sphere{{x, float(i / 2), 0}, 0.25f}, glm::vec3(1 - 2 * x, 0, 0)});
    }
    return {{"a drift", drift},
            {"two rows that change places", crossing},
            {"hardly moving", mixture(0.01f)},
            {"moving", mixture(0.7f)},
            {"moving far", mixture(20)},
            {"moving, tiny", mixture(0.7f, 1e-15f)},
            {"moving, huge", mixture(0.7f, 1e12f)},
            {"moving, far away", mixture(0.7f, 1, 1e4f)}};
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
template <class Structure, class Ray>
std::string wrongly_culled(const Structure& s, std::uint32_t index, const Ray& r, interval range) {
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
            if constexpr (requires { n.volume; }) {
                using volume = std::remove_cvref_t<decltype(n.volume)>;
                float entry;
                here = !culled && !lantern::volume_ray<volume>(r, range, s.nodes()[0].volume).meets(n.volume, entry);
            } else if constexpr (requires { n.octants; }) {
                float entry;
                here = !culled && !lantern::box_ray(r, range, lantern::reach_of(s.nodes()[0].box)).meets(n.box, entry);
            }
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

inline std::string text_of(const std::optional<lantern::nearest>& h) {
    return h ? "surface " + std::to_string(h->index) + " at t = " + to_text(h->t) : "nothing";
}

/// What is wrong with the structure's answer, given what `every` says; nothing where nothing is.
template <class Structure, class Surfaces, class Ray>
std::string disagreement(const std::string& name, const Structure& s, const Surfaces& surfaces, const Ray& r, interval range,
                         const std::optional<lantern::nearest>& expected) {
    const auto got = closest(s, surfaces, r, range);
    const bool same = expected.has_value() == got.has_value() &&
                      (!expected || (expected->index == got->index && expected->t == got->t && expected->point == got->point &&
                                     expected->normal == got->normal));
    if (same && occluded(s, surfaces, r, range) == expected.has_value()) return {};
    std::string time;
    if constexpr (requires { r.time; }) time = ", time " + to_text(r.time);
    return "scene: " + name + "\nray: from " + to_text(r.origin) + " along " + to_text(r.direction) + time + ", range (" +
           to_text(range.min) + ", " + to_text(range.max) + "]\nexpected: " + text_of(expected) + "\nfound: " + text_of(got) +
           (same ? ", but occluded says otherwise" : "") + "\nwrongly culled: " +
           (expected ? wrongly_culled(s, expected->index, r, {range.min, expected->t}) : "nothing");
}

}  // namespace accelerator_laws
