// SPDX-License-Identifier: MIT
#pragma once
// What a structure costs, in counts: the cells and nodes that a ray visits, and the surfaces that it is tested against.

#include "../support/gaps.hpp"
#include "scene.hpp"

#include <lab11_subdivision/subdivision.hpp>

#include <lantern/aabb.hpp>
#include <lantern/boxes_of.hpp>
#include <lantern/bvh.hpp>
#include <lantern/camera.hpp>
#include <lantern/closest.hpp>
#include <lantern/hash.hpp>
#include <lantern/interval.hpp>
#include <lantern/ray.hpp>
#include <lantern/render.hpp>
#include <lantern/todo.hpp>
#include <lantern/warp.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace stage {

/// A cell of the grid has no parent; a node of a tree has one, but for the root.
inline std::vector<std::uint32_t> parents_of(const lab11::grid&) { return {}; }
inline std::vector<std::uint32_t> parents_of(const lab11::octree& tree) {
    std::vector<std::uint32_t> parents(tree.nodes.size(), 0);
    for (std::uint32_t i = 0; i < tree.nodes.size(); ++i)
        for (std::uint32_t k = 0; k < 8 && tree.nodes[i].children > 0; ++k) parents[tree.nodes[i].children + k] = i;
    return parents;
}
inline std::vector<std::uint32_t> parents_of(const lab11::kd_tree& tree) {
    std::vector<std::uint32_t> parents(tree.nodes.size(), 0);
    for (std::uint32_t i = 0; i < tree.nodes.size(); ++i)
        for (std::uint32_t k = 0; k < 2 && tree.nodes[i].axis < 3; ++k) parents[tree.nodes[i].first + k] = i;
    return parents;
}

/// How large a structure is.
struct size_of_it {
    double cells = 0, entries = 0, bytes = 0;
};
inline size_of_it size_of(const lab11::grid& g) {
    double entries = 0;
    for (const auto& cell : g.cells) entries += double(cell.size());
    return {double(g.cells.size()), entries, double(g.cells.size() * sizeof g.cells[0]) + 4 * entries};
}
template <class Tree>
size_of_it size_of(const Tree& tree) {
    return {double(tree.nodes.size()), double(tree.entries.size()), double(tree.nodes.size() * sizeof tree.nodes[0]) + 4 * double(tree.entries.size())};
}
inline size_of_it size_of(const lantern::bvh<>& tree) {
    return {double(tree.nodes().size()), double(tree.size()), double(tree.bytes())};
}

/// A probe may want to know which node, or cell, it is.
template <class Probe>
void note(Probe& counter, std::uint32_t node) {
    if constexpr (requires { counter.node(node); }) counter.node(node);
    else counter.node();
}

/// The student's structure as an accelerator of the library's: its walk, its mailbox (until that is written: none), our counting. A
/// step is a cell of the grid, or a node of a tree that was not on the way to the leaf before.
template <class Structure>
class counted {
public:
    counted(Structure s, bool with_mailbox) : structure_(std::move(s)), parents_(parents_of(structure_)), with_mailbox_(with_mailbox) {}

    template <class Offer, class Probe = lantern::no_probe>
    void traverse(const lantern::ray& r, lantern::interval range, Offer&& offer, Probe&& counter = {}) const {
        lab11::mailbox recent;
        const lab11::offer to = [&](std::uint32_t i, lantern::interval remaining) {
            counter.offer();
            return offer(i, remaining);
        };
        std::vector<std::uint32_t> before, way;
        walk(structure_, r, range, [&](std::uint32_t cell, lab11::stretch) {
            way.assign(1, cell);
            while (!parents_.empty() && way.back() != 0) way.push_back(parents_[way.back()]);
            const auto parted = std::mismatch(way.rbegin(), way.rend(), before.rbegin(), before.rend()).first;  // both ways end at the root
            for (auto node = parted; node != way.rend(); ++node) note(counter, *node);
            std::swap(before, way);
            if (with_mailbox_) return range = lab11::offer_all(surfaces_in(structure_, cell), range, recent, to);
            for (const std::uint32_t i : surfaces_in(structure_, cell)) range = to(i, range);
            return range;
        });
    }

    [[nodiscard]] const Structure& structure() const { return structure_; }

private:
    Structure structure_;
    std::vector<std::uint32_t> parents_;
    bool with_mailbox_;
};

/// Steps and tests of one ray, or the mean over many.
struct work {
    double steps = 0, tests = 0;
    [[nodiscard]] double cost() const { return steps + 4 * tests; }  // as the kd-tree's builder reckons
};

using closest_hit = std::function<std::optional<lantern::nearest>(const lantern::ray&, lantern::probe&)>;

/// A structure over a scene, whichever it is; or the number of the step that it waits for.
struct contestant {
    lab11::structure which{};
    std::string name;
    int waits_for = 0;
    size_of_it size;
    double build_ms = 0;
    closest_hit closest;
};

/// `build` makes it of boxes, `adapt` makes an accelerator of that. The scene must outlive it.
template <class Build, class Adapt>
contestant enter(lab11::structure which, std::string name, const scene& s, Build build, Adapt adapt) {
    const std::vector<lantern::aabb> boxes = lantern::boxes_of(s.shapes);
    const std::clock_t start = std::clock();
    auto made = build(boxes);
    const double took = 1000 * double(std::clock() - start) / CLOCKS_PER_SEC;
    const size_of_it size = size_of(made);
    return {which, std::move(name), 0, size, took,
            [&s, accelerator = adapt(std::move(made))](const lantern::ray& r, lantern::probe& p) { return closest(accelerator, s.shapes, r, {}, p); }};
}

inline constexpr float cells_per_surface = 8;
inline constexpr std::uint32_t leaf_size = 8, max_depth = 16;

inline bool mailbox_is_written(support::gaps& missing) {
    return missing.is_written([] {
        lab11::mailbox recent;
        return lab11::offer_all({}, {}, recent, {});
    });
}

/// The four of them.
inline std::vector<contestant> contestants(const scene& s, support::gaps& missing) {
    using boxes = std::vector<lantern::aabb>;
    const bool with_mailbox = mailbox_is_written(missing);
    std::vector<contestant> all;
    const auto add = [&](lab11::structure which, const char* name, auto build) {
        try {
            contestant one = enter(which, name, s, build, [&](auto made) { return counted(std::move(made), with_mailbox); });
            lantern::probe ignored;  // what is built may be without a walk yet
            (void)one.closest(lantern::ray{s.view.eye, s.view.target - s.view.eye}, ignored);
            all.push_back(std::move(one));
        } catch (const lantern::unfinished& gap) {
            missing.note(gap);
            all.push_back({which, name, support::step_number(gap.what()), {}, 0, {}});
        }
    };
    add(lab11::structure::grid, "grid", [](const boxes& b) { return lab11::build_grid(b, cells_per_surface); });
    add(lab11::structure::octree, "octree", [](const boxes& b) { return lab11::build_octree(b, leaf_size, max_depth); });
    add(lab11::structure::kd_tree, "kd-tree", [](const boxes& b) { return lab11::build_kd_tree(b); });
    all.push_back(enter(lab11::structure::bvh, "bvh", s, [](const boxes& b) { return lantern::bvh<>(std::span<const lantern::aabb>(b)); }, std::identity{}));
    return all;
}

/// What a contestant did for the rays of a picture: one through the middle of each pixel, and from where it hits one more, in
/// some direction away from the surface.
struct record {
    std::vector<work> pixels;  ///< of the first rays, row by row
    work mean;                 ///< of all rays
    double rays = 0;
};

inline record race(const contestant& one, const scene& s, glm::uvec2 size) {
    record result;
    result.pixels.resize(std::size_t(size.x) * size.y);
    std::vector<work> later(result.pixels.size());
    std::vector<char> bounced(result.pixels.size());
    const lantern::camera camera{s.view};
    lantern::in_parallel(size.y, 0, [&](std::size_t row) {
        for (std::uint32_t x = 0; x < size.x; ++x) {
            const std::size_t at = row * size.x + x;
            lantern::probe first, second;
            const lantern::ray r = shoot(camera, (glm::vec2(x, row) + 0.5f) / glm::vec2(size));
            const auto h = one.closest(r, first);
            result.pixels[at] = {double(first.nodes), double(first.offers)};
            if (!h) continue;
            const std::uint64_t key = lantern::hash(3, x, row);
            const glm::vec3 normal = glm::dot(h->normal, r.direction) < 0 ? h->normal : -h->normal;
            const glm::vec3 way = glm::normalize(normal + 0.98f * lantern::to_sphere({lantern::to_unit(lantern::low(key)), lantern::to_unit(lantern::high(key))}));
            (void)one.closest({leave(*h, way), way}, second);
            later[at] = {double(second.nodes), double(second.offers)};
            bounced[at] = 1;
        }
    });
    for (std::size_t i = 0; i < later.size(); ++i) {
        result.mean.steps += result.pixels[i].steps + later[i].steps;
        result.mean.tests += result.pixels[i].tests + later[i].tests;
        result.rays += 1 + bounced[i];
    }
    result.mean.steps /= result.rays;
    result.mean.tests /= result.rays;
    return result;
}

}  // namespace stage
