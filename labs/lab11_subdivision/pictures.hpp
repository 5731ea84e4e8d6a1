// SPDX-License-Identifier: MIT
#pragma once
// Lab 11's pictures: the program shows them with the student's code, the handout with ours.

#include "measure.hpp"
#include "scene.hpp"

#include "../support/gaps.hpp"
#include "../support/test_card.hpp"

#include <lab11_subdivision/subdivision.hpp>

#include <lantern/aabb.hpp>
#include <lantern/image.hpp>
#include <lantern/interval.hpp>
#include <lantern/ray.hpp>
#include <lantern/sphere.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace pictures {

using lab11::interval;

// ---- Cells ---------------------------------------------------------------------------------------------------------

/// In which cell a point is: the numbers that the walks use.
inline std::uint32_t cell_at(const lab11::grid& g, glm::vec3 p) {
    glm::ivec3 cell;
    for (int axis = 0; axis < 3; ++axis) {
        const float extent = g.box.max[axis] - g.box.min[axis];
        cell[axis] = extent > 0 ? std::clamp(int((p[axis] - g.box.min[axis]) / extent * float(g.count[axis])), 0, g.count[axis] - 1) : 0;
    }
    return number_of(g, cell);
}
inline std::uint32_t cell_at(const lab11::octree& tree, glm::vec3 p) {
    std::uint32_t at = 0;
    lantern::aabb cell = tree.cell;
    while (tree.nodes[at].children > 0) {
        const glm::vec3 middle = center(cell);
        const std::uint32_t octant = std::uint32_t(p.x >= middle.x) | std::uint32_t(p.y >= middle.y) << 1 | std::uint32_t(p.z >= middle.z) << 2;
        at = tree.nodes[at].children + octant;
        cell = lab11::octant_of(cell, octant);
    }
    return at;
}
inline std::uint32_t cell_at(const lab11::kd_tree& tree, glm::vec3 p) {
    std::uint32_t at = 0;
    while (tree.nodes[at].axis < 3) at = tree.nodes[at].first + (p[int(tree.nodes[at].axis)] >= tree.nodes[at].at);
    return at;
}
inline lantern::aabb box_of(const lab11::grid& g) { return g.box; }
inline lantern::aabb box_of(const lab11::octree& tree) { return tree.cell; }
inline lantern::aabb box_of(const lab11::kd_tree& tree) { return tree.box; }

/// Part of a plane across the z axis.
struct window {
    glm::vec2 low, high;
    float z;
    [[nodiscard]] glm::vec3 at(glm::vec2 film) const { return {glm::mix(low.x, high.x, film.x), glm::mix(high.y, low.y, film.y), z}; }
};

/// The cells that the window cuts: the more surfaces are in one, the darker it is.
template <class Structure>
lantern::image cells(const Structure& s, const window& w, glm::uvec2 size) {
    lantern::image page(size, glm::vec3(0.04f));
    const lantern::aabb box = box_of(s);
    const auto point = [&](unsigned x, unsigned y) { return w.at((glm::vec2(x, y) + 0.5f) / glm::vec2(size)); };
    for (unsigned y = 0; y < size.y; ++y)
        for (unsigned x = 0; x < size.x; ++x) {
            const glm::vec3 p = point(x, y);
            if (!contains(box, p)) continue;
            const std::uint32_t here = cell_at(s, p);
            const float inside = float(surfaces_in(s, here).size());
            page(x, y) = glm::mix(glm::vec3(0.9f, 0.9f, 0.86f), glm::vec3(0.75f, 0.3f, 0.06f), inside / (inside + 4));
            const auto border = [&](const glm::vec3& other) { return contains(box, other) && cell_at(s, other) != here; };
            if (border(point(x + 1, y)) || border(point(x, y + 1))) page(x, y) = glm::vec3(0.16f);
        }
    return page;
}

// ---- A flat world, and a ray in it ---------------------------------------------------------------------------------

/// Balls with their centres in the plane z = 0: seen there, discs.
inline std::vector<lantern::sphere> discs() {
    std::vector<lantern::sphere> all{{{3.1f, 7.0f, 0}, 0.9f}, {{10.4f, 6.4f, 0}, 0.5f}};
    for (std::uint32_t i = 0; i < 14; ++i) all.push_back({{12 * stage::number(i, 20), 8 * stage::number(i, 21), 0}, 0.12f + 0.12f * stage::number(i, 22)});
    for (std::uint32_t i = 0; i < 34; ++i) {
        const glm::vec2 way = 2.0f * glm::vec2(stage::number(i, 23), stage::number(i, 24)) - 1.0f;
        all.push_back({{8.6f + 1.1f * way.x, 2.3f + 1.0f * way.y, 0}, 0.05f + 0.06f * stage::number(i, 25)});
    }
    return all;
}
inline constexpr window flat_world{{-0.3f, 0.85f}, {11.1f, 8.25f}, 0.011f};
inline constexpr lantern::ray flat_ray{{-0.1f, 7.3f, 0.011f}, {1, -0.5605f, 0}};

/// The discs, and what the ray does in the structure: the cells that it visits, early ones yellow, late ones red; and its hit.
template <class Structure>
lantern::image flat(const Structure& s, support::gaps& missing) {
    constexpr glm::uvec2 size{741, 481};
    const std::vector<lantern::sphere> all = discs();
    lantern::image page = cells(s, flat_world, size);

    std::map<std::uint32_t, int> visited;
    std::optional<float> hit;
    (void)missing.is_written([&] {
        walk(s, flat_ray, {}, [&, range = interval{}](std::uint32_t cell, lab11::stretch) mutable {
            visited.emplace(cell, int(visited.size()));
            for (const std::uint32_t i : surfaces_in(s, cell))
                if (const auto h = intersect(all[i], flat_ray, range)) hit = range.max = h->t;
            return visited.size() < 1000 ? range : interval{0, 0};
        });
    });
    const float unit = float(size.x) / (flat_world.high.x - flat_world.low.x);
    for (unsigned y = 0; y < size.y; ++y)
        for (unsigned x = 0; x < size.x; ++x) {
            glm::vec3& pixel = page(x, y);
            const glm::vec3 p = flat_world.at((glm::vec2(x, y) + 0.5f) / glm::vec2(size));
            const auto turn = contains(box_of(s), p) ? visited.find(cell_at(s, p)) : visited.end();
            if (turn != visited.end())
                pixel *= glm::mix(glm::vec3(1, 0.95f, 0.2f), glm::vec3(1, 0.15f, 0.1f), float(turn->second) / float(std::max<std::size_t>(visited.size() - 1, 1)));
            for (const lantern::sphere& d : all) {
                const float inside = (d.radius - glm::length(glm::vec2(p - d.center))) * unit;
                if (inside > 0) pixel = glm::mix(pixel, glm::vec3(0.05f, 0.16f, 0.42f), inside < 1.5f ? 1.0f : 0.6f);
            }
            if (visited.empty()) continue;
            const glm::vec2 to = glm::vec2(p) - glm::vec2(flat_ray.origin), d(flat_ray.direction);
            const float t = glm::dot(to, d) / glm::dot(d, d);
            if (t >= 0 && t <= hit.value_or(20) && glm::length(to - t * d) * unit < 1) pixel = glm::vec3(0);
            if (hit && glm::length(to - *hit * d) * unit < 5) pixel = glm::vec3(0.8f, 0, 0.1f);
        }
    return page;
}

inline std::vector<lantern::aabb> boxes_of_discs() { return lantern::boxes_of(discs()); }

/// Steps 1 to 3. The lattice alone, as long as nothing says what is in its cells.
inline lantern::image flat_grid(support::gaps& missing) {
    const std::vector<lantern::aabb> boxes = boxes_of_discs();
    lab11::grid g;
    if (!missing.is_written([&] { return g = lab11::build_grid(boxes, 5); })) {
        g.box = lab11::around(boxes);
        g.count = lab11::resolution(g.box, std::uint32_t(boxes.size()), 5);
        g.cells.resize(std::size_t(g.count.x) * std::size_t(g.count.y) * std::size_t(g.count.z));
    }
    return flat(g, missing);
}
/// Steps 5 and 6.
inline lantern::image flat_octree(support::gaps& missing) { return flat(lab11::build_octree(boxes_of_discs(), 3, 7), missing); }
/// Steps 7 and 8.
inline lantern::image flat_kd_tree(support::gaps& missing) { return flat(lab11::build_kd_tree(boxes_of_discs()), missing); }

// ---- The contest ---------------------------------------------------------------------------------------------------

/// Black, blue, red, yellow, white: from 8 to 4096 steps and tests, doubled again and again.
inline glm::vec3 heat(double cost) {
    static constexpr std::array<glm::vec3, 5> colors{{{0, 0, 0.02f}, {0.03f, 0.05f, 0.5f}, {0.75f, 0.05f, 0.15f}, {1, 0.65f, 0.05f}, {1, 1, 1}}};
    const float x = glm::clamp(float(std::log2(cost / 8)) / 9, 0.0f, 0.999f) * 4;
    return glm::mix(colors[std::size_t(x)], colors[std::size_t(x) + 1], x - std::floor(x));
}

struct standing {
    stage::contestant who;
    stage::record did;
    [[nodiscard]] double cost() const { return did.mean.cost(); }
};

/// The cheapest, when all of them have run; otherwise nobody.
inline const standing* winner(const std::vector<standing>& all) {
    if (std::ranges::any_of(all, [](const standing& one) { return one.who.waits_for > 0; })) return nullptr;
    return &*std::ranges::min_element(all, {}, &standing::cost);
}

inline constexpr glm::uvec2 pane{140, 105};
inline glm::uvec2 corner_of(std::uint32_t row, std::uint32_t column) { return {4 + column * (pane.x + 6), 4 + row * (pane.y + 6)}; }
inline constexpr glm::uvec2 page_of_the_contest{8 + 5 * (pane.x + 6) - 6, 8 + 5 * (pane.y + 6) - 6};

/// A pixel of the first column: four rays, lit from where the eye is; look(ray) finds what they meet.
template <class Look>
glm::vec3 shown(const lantern::camera<>& camera, glm::uvec2 at, const Look& look) {
    glm::vec3 color(0);
    for (int k = 0; k < 4; ++k) {
        const lantern::ray r = shoot(camera, (glm::vec2(at) + glm::vec2(k % 2, k / 2) * 0.5f + 0.25f) / glm::vec2(pane));
        const auto h = look(r);
        const float light = h ? std::abs(glm::dot(h->normal, glm::normalize(glm::vec3(-0.3f, 0.8f, 0.5f)))) : 0;
        color += 0.25f * (h ? (0.12f + 0.75f * light) * glm::vec3(0.9f, 0.85f, 0.75f) : glm::vec3(0.03f, 0.05f, 0.09f));
    }
    return color;
}

/// What was predicted has a white corner.
inline bool is_corner(glm::uvec2 at) { return at.x + at.y < 14; }

/// One row: the scene; then for each structure what the rays of the pixels cost. The cheapest is framed in green, what was predicted has a
/// white corner.
inline void paint_row(lantern::image& page, std::uint32_t row, const stage::scene& s, const std::vector<standing>& all, lab11::structure predicted) {
    const auto corner = [&](std::uint32_t column) { return corner_of(row, column); };
    const lantern::camera camera{s.view};
    const stage::closest_hit& look = all.back().who.closest;
    lantern::in_parallel(pane.y, 0, [&](std::size_t y) {
        for (unsigned x = 0; x < pane.x; ++x)
            page(corner(0).x + x, corner(0).y + unsigned(y)) = shown(camera, {x, unsigned(y)}, [&](const lantern::ray& r) {
                lantern::probe ignored;
                return look(r, ignored);
            });
    });
    for (std::uint32_t column = 1; column <= all.size(); ++column) {
        const standing& one = all[column - 1];
        const glm::uvec2 from = corner(column);
        if (one.who.waits_for > 0) {
            support::paint_test_card(page, from, pane, one.who.waits_for);
            continue;
        }
        if (&one == winner(all))
            for (unsigned y = 0; y < pane.y + 6; ++y)
                for (unsigned x = 0; x < pane.x + 6; ++x) page(from.x - 3 + x, from.y - 3 + y) = {0.05f, 0.75f, 0.1f};
        for (unsigned y = 0; y < pane.y; ++y)
            for (unsigned x = 0; x < pane.x; ++x)
                page(from.x + x, from.y + y) = one.who.which == predicted && is_corner({x, y}) ? glm::vec3(1) : heat(one.did.pixels[std::size_t(y) * pane.x + x].cost());
    }
}

/// Step 9. `report` is called for each scene, with what came of it.
template <class Report>
lantern::image contest(support::gaps& missing, Report report) {
    const std::array<lab11::structure, 5> predicted = lab11::predictions();  // first of all
    lantern::image page(page_of_the_contest, glm::vec3(0.2f));
    const std::vector<stage::scene> scenes = stage::scenes();
    for (std::uint32_t row = 0; row < scenes.size(); ++row) {
        std::vector<standing> all;
        for (stage::contestant& who : stage::contestants(scenes[row], missing)) {
            stage::record did = who.waits_for > 0 ? stage::record{} : stage::race(who, scenes[row], pane);
            all.push_back({std::move(who), std::move(did)});
        }
        paint_row(page, row, scenes[row], all, predicted[row]);
        report(scenes[row], all, predicted[row]);
    }
    return page;
}

}  // namespace pictures
