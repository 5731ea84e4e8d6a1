// SPDX-License-Identifier: MIT
#pragma once
// Lab 10's boxes and trees: what trees are built over, a walk through a returned tree, and trees of the suite's own.

#include "contract.hpp"

#include <numbers.hpp>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace lab10_suite {

using namespace contract::lab10;
using lantern::aabb;
using lantern::interval;

using group = std::vector<std::uint32_t>;
using boxes = std::vector<aabb>;

inline group all_of(std::size_t count) {
    group g(count);
    std::iota(g.begin(), g.end(), 0u);
    return g;
}

inline group sorted(group g) {
    std::sort(g.begin(), g.end());
    return g;
}

inline bool same(const aabb& a, const aabb& b) { return a.min == b.min && a.max == b.max; }

/// The smallest box around some, by its definition.
inline aabb around(const boxes& all, const group& some) {
    aabb box;
    for (const std::uint32_t i : some)
        for (int k = 0; k < 3; ++k) {
            box.min[k] = std::min(box.min[k], all.at(i).min[k]);
            box.max[k] = std::max(box.max[k], all.at(i).max[k]);
        }
    return box;
}

inline double area(const aabb& box) {
    const glm::dvec3 e = glm::dvec3(box.max) - glm::dvec3(box.min);
    return 2 * (e.x * e.y + e.y * e.z + e.z * e.x);
}

// ---- What trees are built over -------------------------------------------------------------------------------------

/// Boxes of all sizes up to `size`, anywhere in a cube; some of them flat, some of them points.
inline boxes cloud(numbers& random, std::size_t count, float size) {
    boxes all;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec3 p = random.vector();
        glm::vec3 e = size * glm::abs(random.vector());
        if (i % 5 == 1) e[int(i % 3)] = 0;
        if (i % 20 == 2) e = {0, 0, 0};
        all.push_back({p - e, p + e});
    }
    return all;
}

struct family {
    std::string name;
    boxes all;
};

/// What is easy, what coincides, what is flat and what is crowded.
inline std::vector<family> families() {
    numbers random(10);
    boxes duplicates(50, aabb{{1, 2, 3}, {2, 3, 4}}), onion, grid, row, points;
    boxes crowd = cloud(random, 100, 0.01f);
    for (aabb& box : crowd) box = {0.01f * box.min + glm::vec3(30, 0, 0), 0.01f * box.max + glm::vec3(30, 0, 0)};
    crowd.push_back({{-100, -1, -100}, {100, -1, 100}});
    crowd.push_back({{-90, 0, -90}, {-60, 30, -60}});
    for (int i = 0; i < 50; ++i) {
        onion.push_back({glm::vec3(-float(i)), glm::vec3(float(i))});
        row.push_back({{float(i), 0, 0}, {float(i + 1), 0, 0}});
        points.push_back({glm::vec3(float(i * 7 % 50)), glm::vec3(float(i * 7 % 50))});
    }
    for (int i = 0; i < 125; ++i) {
        const glm::vec3 p(i % 5, i / 5 % 5, i / 25);
        grid.push_back({p, p + 1.0f});  // neighbours touch
    }
    return {{"a cloud", cloud(random, 200, 0.1f)}, {"large boxes", cloud(random, 60, 1)}, {"duplicates", duplicates},
            {"an onion", onion},                   {"a grid of touching boxes", grid},    {"a flat row", row},
            {"points on a line", points},          {"a teapot in a stadium", crowd},      {"two", cloud(random, 2, 0.1f)},
            {"one", cloud(random, 1, 0.1f)}};
}

// ---- Trees, looked at ----------------------------------------------------------------------------------------------

/// What the suite finds out by walking through a tree. `broken` says in words what is not as it must be; while it says anything the rest
/// is not to be trusted.
struct walk {
    std::string broken;
    std::vector<std::uint32_t> depth;   ///< of each node
    std::vector<group> below;           ///< the surfaces below each node, sorted
    std::uint32_t deepest = 0, largest = 0, leaves = 0;
};

inline walk walk_through(const tree& t, std::size_t surfaces) {
    walk seen;
    const auto say = [&](const std::string& what) {
        if (seen.broken.empty()) seen.broken = what;
    };
    const auto size = t.nodes.size();
    if (surfaces == 0 && size > 0) say("a tree over nothing has nodes");
    if (surfaces > 0 && size == 0) say("there are no nodes");
    if (size > 2 * surfaces) say(std::to_string(size) + " nodes for " + std::to_string(surfaces) + " surfaces");
    if (sorted(t.order) != all_of(surfaces)) say("`order` does not hold each surface once");
    if (!seen.broken.empty() || size == 0) return seen;

    seen.depth.assign(size, 0);
    seen.below.assign(size, {});
    std::vector<bool> has_parent(size, false);
    std::vector<bool> taken(surfaces, false);  // places in `order`
    has_parent[0] = true;
    for (std::size_t i = 0; i < size && seen.broken.empty(); ++i) {
        const node& n = t.nodes[i];
        const std::string name = "node " + std::to_string(i);
        if (!has_parent[i]) say("nobody is the parent of " + name);
        seen.deepest = std::max(seen.deepest, seen.depth[i]);
        if (n.count > 0) {
            ++seen.leaves;
            seen.largest = std::max(seen.largest, n.count);
            if (std::uint64_t(n.first) + n.count > surfaces) {
                say(name + ", a leaf, reaches beyond the end of `order`");
                continue;
            }
            for (std::uint32_t k = n.first; k < n.first + n.count; ++k) {
                if (taken[k]) say("order[" + std::to_string(k) + "] is in two leaves");
                taken[k] = true;
                seen.below[i].push_back(t.order[k]);
            }
            continue;
        }
        for (const std::uint32_t child : {n.left, n.right}) {
            if (child >= size) say(name + " has a child that is not there: " + std::to_string(child));
            else if (child <= i) say(name + " is a leaf without surfaces, or its child " + std::to_string(child) + " does not stand behind it");
            else if (has_parent[child]) say("node " + std::to_string(child) + " has two parents");
            else has_parent[child] = true, seen.depth[child] = seen.depth[i] + 1;
        }
    }
    if (std::find(taken.begin(), taken.end(), false) != taken.end()) say("a surface is in no leaf");
    if (!seen.broken.empty()) return seen;
    for (std::size_t i = size; i-- > 0;) {
        const node& n = t.nodes[i];
        if (n.count == 0)
            std::merge(seen.below[n.left].begin(), seen.below[n.left].end(), seen.below[n.right].begin(), seen.below[n.right].end(),
                       std::back_inserter(seen.below[i]));
        else
            std::sort(seen.below[i].begin(), seen.below[i].end());
    }
    return seen;
}

/// The first node whose box is not the smallest around all that is below it, in words.
inline std::string wrong_box(const tree& t, const walk& seen, const boxes& all) {
    for (std::size_t i = 0; i < t.nodes.size(); ++i)
        if (!same(t.nodes[i].box, around(all, seen.below[i])))
            return "node " + std::to_string(i) + (t.nodes[i].count > 0 ? ", a leaf" : ", an inner node");
    return "";
}

inline double cost_of(const tree& t) {
    double sum = 0;
    for (const node& n : t.nodes) sum += area(n.box) / area(t.nodes[0].box) * (n.count > 0 ? n.count : 2);
    return sum;
}

// ---- Trees of the suite's own --------------------------------------------------------------------------------------

inline halves cut(const group& g, std::size_t at) {
    if (at > g.size()) throw std::runtime_error("a group of " + std::to_string(g.size()) + " surfaces is to be divided");
    const auto middle = g.begin() + std::ptrdiff_t(at);
    return {{g.begin(), middle}, {middle, g.end()}};
}

// The groups come from student code, so every number is looked at before it is used.
inline int widest(const boxes& all, const group& some) {
    aabb centers;
    for (const std::uint32_t i : some) centers = enclose(centers, center(all.at(i)));
    const glm::vec3 size = centers.max - centers.min;
    return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

inline halves halved(const boxes& all, group some) {
    const int axis = widest(all, some);
    std::sort(some.begin(), some.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::pair(center(all.at(a))[axis], a) < std::pair(center(all.at(b))[axis], b);
    });
    return cut(some, some.size() / 2);
}

inline halves in_the_middle(const boxes& all, const group& some) {
    const int axis = widest(all, some);
    aabb centers;
    for (const std::uint32_t i : some) centers = enclose(centers, center(all.at(i)));
    halves parts;
    for (const std::uint32_t i : some) (center(all.at(i))[axis] < center(centers)[axis] ? parts.left : parts.right).push_back(i);
    return parts.left.empty() || parts.right.empty() ? halved(all, some) : parts;
}

/// A tree as the split says.
inline tree grown(const boxes& all, const std::function<halves(const group&)>& split, std::size_t leaf_size) {
    tree t;
    if (all.empty()) return t;
    t.nodes.emplace_back();
    std::vector<std::pair<std::uint32_t, group>> waiting{{0, all_of(all.size())}};
    while (!waiting.empty()) {
        const auto [at, some] = std::move(waiting.back());
        waiting.pop_back();
        t.nodes[at].box = around(all, some);
        if (some.size() <= leaf_size) {
            t.nodes[at].first = std::uint32_t(t.order.size());
            t.nodes[at].count = std::uint32_t(some.size());
            t.order.insert(t.order.end(), some.begin(), some.end());
            continue;
        }
        const halves parts = split(some);
        const auto left = std::uint32_t(t.nodes.size());
        t.nodes[at].left = left, t.nodes[at].right = left + 1;
        t.nodes.resize(t.nodes.size() + 2);
        waiting.push_back({left + 1, parts.right});
        waiting.push_back({left, parts.left});
    }
    return t;
}

inline tree balanced(const boxes& all, std::size_t leaf_size = 4) {
    return grown(all, [&](const group& some) { return halved(all, some); }, leaf_size);
}

}  // namespace lab10_suite
