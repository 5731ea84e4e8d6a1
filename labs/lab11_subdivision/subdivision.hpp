// SPDX-License-Identifier: MIT
#pragma once
// Lab 11: space cut into cells, in three ways: a uniform grid, an octree, a kd-tree. The handout is README.md in this folder.

#include <lantern/aabb.hpp>
#include <lantern/interval.hpp>
#include <lantern/ray.hpp>
#include <lantern/todo.hpp>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace lab11 {

using lantern::aabb;
using lantern::interval;
using lantern::ray;

// A structure knows of each surface its number and its box, and nothing else. Whoever calls it knows how to intersect.

/// Intersects surface number i with the ray within the range, and answers with what remains of the range: it ends at the hit, if
/// there was one. An empty range means: stop.
using offer = std::function<interval(std::uint32_t i, interval range)>;

/// The part of a ray that lies in a cell, from t = enter to t = leave.
struct stretch {
    double enter, leave;
};

/// Is called by a walk for each cell that the ray passes, the first one first: with the cell's number, and the ray's stretch in it. The
/// answer is what remains of the range.
using visitor = std::function<interval(std::uint32_t cell, stretch part)>;

/// Given. The ray's stretch in the box, as far as it lies in the range, or nothing. Touching counts. Where the ray touches a corner,
/// rounding may let it leave before it enters; hence the 2^-40.
[[nodiscard]] inline std::optional<stretch> clip(const aabb& box, const ray& r, interval range) {
    stretch part{range.min, range.max};
    for (int axis = 0; axis < 3; ++axis) {
        const double o = r.origin[axis], d = r.direction[axis];
        if (d == 0 && (o < box.min[axis] || o > box.max[axis])) return std::nullopt;
        if (d == 0) continue;
        const double first = ((d > 0 ? box.min : box.max)[axis] - o) / d, last = ((d > 0 ? box.max : box.min)[axis] - o) / d;
        part = {std::max(part.enter, first), std::min(part.leave, last)};
    }
    if (!(part.enter <= part.leave + 0x1p-40 * std::abs(part.leave))) return std::nullopt;
    return stretch{part.enter, std::max(part.enter, part.leave)};
}

/// Given. Whether two boxes have a point in common. Touching counts.
[[nodiscard]] inline bool touch(const aabb& a, const aabb& b) {
    for (int axis = 0; axis < 3; ++axis)
        if (!(a.min[axis] <= b.max[axis] && b.min[axis] <= a.max[axis])) return false;
    return true;
}

/// Given. The smallest box around all of them.
[[nodiscard]] inline aabb around(std::span<const aabb> boxes) {
    aabb all;
    for (const aabb& box : boxes) all = enclose(all, box);
    return all;
}

// ---- The uniform grid ----------------------------------------------------------------------------------------------

/// A box that is cut into count.x * count.y * count.z equal cells. Cell (0, 0, 0) is at box.min.
struct lattice {
    aabb box;
    glm::ivec3 count{1};
};

/// Given. The number of a cell: x runs fastest.
[[nodiscard]] inline std::uint32_t number_of(const lattice& g, glm::ivec3 cell) {
    return (std::uint32_t(cell.z) * std::uint32_t(g.count.y) + std::uint32_t(cell.y)) * std::uint32_t(g.count.x) + std::uint32_t(cell.x);
}

/// Step 1. Into how many cells each side of the box is divided: at least one, and all together at most `cells_per_surface` for each
/// surface, but not less than an eighth of that. Cells are cubes, as nearly as whole numbers allow. Along an axis where the box is thinner than
/// a cell there is one, and the others share the rest. A box that is a point, or holds nothing, is one cell.
[[nodiscard]] inline glm::ivec3 resolution(const aabb& box, std::uint32_t surfaces, float cells_per_surface) {
    return lantern::todo("lab11 step 1: how many cells");
}

/// All the cells with first <= cell <= last, along each axis.
struct cell_range {
    glm::ivec3 first, last;
};

/// Step 2. The cells that have a point in common with the box. Touching counts: what ends exactly at a face of a cell is in the cell
/// behind it too. The box lies within the lattice's.
[[nodiscard]] inline cell_range cells_of(const lattice& g, const aabb& box) {
    return lantern::todo("lab11 step 2: the cells of a box");
}

/// Step 3. Visits the cells that the ray passes within the range, each once, the first one first. Ends when nothing remains of the range, when it
/// ends within the cell, or where the grid does.
inline void walk(const lattice& g, const ray& r, interval range, const visitor& visit) {
    lantern::todo("lab11 step 3: a walk through the grid");
}

/// The numbers of the last eight surfaces that were offered to a ray; `at` is where the next one goes.
struct mailbox {
    static constexpr std::uint32_t nobody = ~0u;
    std::array<std::uint32_t, 8> last{nobody, nobody, nobody, nobody, nobody, nobody, nobody, nobody};
    std::uint32_t at = 0;
};

/// Step 4. Offers the surfaces of one cell, but for those that are among the last eight to have been offered. Each gets the range that the one
/// before it has left. Ends when nothing remains. Answers with what remains.
inline interval offer_all(std::span<const std::uint32_t> surfaces, interval range, mailbox& recent, const offer& to) {
    return lantern::todo("lab11 step 4: a surface in many cells");
}

/// A lattice, and the numbers of the surfaces that are in each of its cells.
struct grid : lattice {
    std::vector<std::vector<std::uint32_t>> cells;
};

/// Given. Throws std::length_error instead of filling the memory with 2^24 cells or more.
[[nodiscard]] inline grid build_grid(std::span<const aabb> boxes, float cells_per_surface) {
    const aabb all = around(boxes);
    grid g{{all, resolution(all, std::uint32_t(boxes.size()), cells_per_surface)}, {}};
    const double cells = double(g.count.x) * double(g.count.y) * double(g.count.z);
    if (!(cells >= 1 && cells < 0x1p24)) throw std::length_error("build_grid: " + std::to_string(cells) + " cells, from 1 to 2^24 are allowed");
    g.cells.resize(std::size_t(cells));
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        const cell_range c = cells_of(g, boxes[i]);
        for (int z = c.first.z; z <= c.last.z; ++z)
            for (int y = c.first.y; y <= c.last.y; ++y)
                for (int x = c.first.x; x <= c.last.x; ++x) g.cells[number_of(g, {x, y, z})].push_back(i);
    }
    return g;
}

/// Given. The surfaces in a cell that a walk visits.
[[nodiscard]] inline std::span<const std::uint32_t> surfaces_in(const grid& g, std::uint32_t cell) { return g.cells.at(cell); }

// ---- The octree ----------------------------------------------------------------------------------------------------

/// A cell of the octree. When it is divided, its eight octants are the nodes from number `children` on; node 0 is nobody's child, so
/// children = 0 says that it is a leaf. Its surfaces are then entries[first] to entries[first + size - 1].
struct octree_node {
    std::uint32_t children = 0, first = 0, size = 0;
};

/// nodes[0] is the cell itself.
struct octree {
    aabb cell;
    std::vector<octree_node> nodes;
    std::vector<std::uint32_t> entries;
};

/// Given. The octree's cell: a cube with the boxes in it. Its lower corner is that of the boxes; so what is flat lies in a face of all
/// its cells, and not between them.
[[nodiscard]] inline aabb cube_around(std::span<const aabb> boxes) {
    const aabb all = around(boxes);
    const glm::vec3 size = all.max - all.min;
    return {all.min, glm::max(all.max, all.min + std::max({size.x, size.y, size.z}))};
}

/// Step 5. One of the eight octants of a cell, cut at `center(cell)`. The number is x + 2 y + 4 z, where x, y, z are 0 for the lower and 1
/// for the upper half along that axis.
[[nodiscard]] inline aabb octant_of(const aabb& cell, std::uint32_t number) {
    return lantern::todo("lab11 step 5: an octant");
}

/// Step 5. An octree over boxes; its cell is cube_around(boxes). A leaf holds the number of every surface whose box touches the leaf's cell, and no
/// other. A cell with n surfaces stays a leaf when n <= leaf_size; when it lies max_depth levels below the root; or when its eight
/// octants together would hold 4 n or more.
[[nodiscard]] inline octree build_octree(std::span<const aabb> boxes, std::uint32_t leaf_size, std::uint32_t max_depth) {
    return lantern::todo("lab11 step 5: an octree");
}

struct octant_part {
    std::uint32_t octant;
    stretch part;
};

/// Step 6. The octants of the cell that the ray passes, the first one first, each with the ray's stretch in it. `part` is the ray's stretch in the whole
/// cell; the octants' stretches join on to each other and make it up. At most four.
[[nodiscard]] inline std::vector<octant_part> octants_met(const aabb& cell, const ray& r, stretch part) {
    return lantern::todo("lab11 step 6: which octants a ray meets");
}

/// Given. Visits the leaves that the ray passes within the range, the first one first, by the numbers of their nodes.
inline void walk(const octree& tree, const ray& r, interval range, const visitor& visit) {
    const auto enter = [&](const auto& self, std::uint32_t at, const aabb& cell, stretch part) -> void {
        const std::uint32_t children = tree.nodes[at].children;
        if (children == 0) {
            range = visit(at, part);
            return;
        }
        for (const octant_part& met : octants_met(cell, r, part)) {
            if (empty(range) || met.part.enter > range.max) return;
            self(self, children + met.octant, octant_of(cell, met.octant), met.part);
        }
    };
    if (const auto whole = clip(tree.cell, r, range)) enter(enter, 0, tree.cell, *whole);
}

/// Given.
[[nodiscard]] inline std::span<const std::uint32_t> surfaces_in(const octree& tree, std::uint32_t leaf) {
    return std::span(tree.entries).subspan(tree.nodes.at(leaf).first, tree.nodes[leaf].size);
}

// ---- The kd-tree ---------------------------------------------------------------------------------------------------

/// A plane across an axis (0 is x, 1 is y, 2 is z) that cuts a cell in two.
struct cut {
    std::uint32_t axis;
    float at;
};

/// Given. On which sides of a plane a box counts. What only touches the plane is on one side only; what lies in it is below.
[[nodiscard]] inline bool is_below(const aabb& box, const cut& c) { return box.min[int(c.axis)] < c.at || box.max[int(c.axis)] <= c.at; }
[[nodiscard]] inline bool is_above(const aabb& box, const cut& c) { return box.max[int(c.axis)] > c.at; }

/// What a step of the walk costs, what it costs to intersect a surface, and the part of the latter that is forgiven to a cut that has
/// no surface on one side.
struct costs {
    float step = 1, test = 4, empty_bonus = 0.5f;
};

/// Step 7. The cheapest of all cuts through the cell at an end of one of the boxes, strictly between two faces of the cell. A cut costs
///     step + b test (A_below n_below + A_above n_above) / A,
/// with n_below and n_above the numbers of boxes on either side, A_below and A_above the surface areas of the two parts of the cell, A that of the
/// cell; b is 1 - empty_bonus when one of the numbers is 0, otherwise 1. Nothing when no cut costs less than `test` for each
/// box, or when the cell has no area. The boxes lie in the cell.
[[nodiscard]] inline std::optional<cut> best_cut(const aabb& cell, std::span<const aabb> boxes, const costs& c) {
    lantern::todo("lab11 step 7: where to cut");
}

/// A cell of the kd-tree. When axis is 0, 1 or 2 it is cut at `at`; its lower part is node number `first`, its upper part the next one.
/// When axis is 3 it is a leaf, and its surfaces are entries[first] to entries[first + size - 1].
struct kd_node {
    std::uint32_t axis = 3;
    float at = 0;
    std::uint32_t first = 0, size = 0;
};

/// nodes[0] is the box itself.
struct kd_tree {
    aabb box;
    std::vector<kd_node> nodes;
    std::vector<std::uint32_t> entries;
};

/// Given. Cuts as long as step 7 finds that it pays, but not more than 8 + 2 log2 n times on the way to a leaf, and not when leaves would
/// hold each surface 32 times, on average.
[[nodiscard]] inline kd_tree build_kd_tree(std::span<const aabb> boxes, const costs& c = {}) {
    kd_tree tree{around(boxes), {{}}, {}};
    std::size_t room = 31 * boxes.size();
    using numbers = std::vector<std::uint32_t>;
    const auto divide = [&](const auto& self, std::uint32_t at, const aabb& cell, const numbers& inside, int levels) -> void {
        std::vector<aabb> parts;  // of the boxes, as far as they lie in the cell
        for (const std::uint32_t i : inside) parts.push_back({glm::max(boxes[i].min, cell.min), glm::min(boxes[i].max, cell.max)});
        const auto plane = levels > 0 ? best_cut(cell, parts, c) : std::nullopt;
        numbers below, above;
        for (std::size_t k = 0; k < inside.size() && plane; ++k) {
            if (is_below(parts[k], *plane)) below.push_back(inside[k]);
            if (is_above(parts[k], *plane)) above.push_back(inside[k]);
        }
        const std::size_t more = std::max(below.size() + above.size(), inside.size()) - inside.size();
        if (!plane || more > room) {
            tree.nodes[at] = {3, 0, std::uint32_t(tree.entries.size()), std::uint32_t(inside.size())};
            tree.entries.insert(tree.entries.end(), inside.begin(), inside.end());
            return;
        }
        room -= more;
        const auto first = std::uint32_t(tree.nodes.size());
        tree.nodes[at] = {plane->axis, plane->at, first, 0};
        tree.nodes.resize(first + 2);
        aabb lower = cell, upper = cell;
        lower.max[int(plane->axis)] = upper.min[int(plane->axis)] = plane->at;
        self(self, first, lower, below, levels - 1);
        self(self, first + 1, upper, above, levels - 1);
    };
    numbers all(boxes.size());
    std::iota(all.begin(), all.end(), 0u);
    divide(divide, 0, tree.box, all, int(8 + 2 * std::log2(double(boxes.size() + 1))));
    return tree;
}

/// Step 8. Visits the leaves that the ray passes within the range, the first one first, by the numbers of their nodes, each with the ray's stretch in
/// it. A leaf that the ray only touches may be visited; of a ray within the plane of a cut, the leaves on both sides are. Ends when nothing
/// remains of the range, and enters nothing that lies beyond its end.
inline void walk(const kd_tree& tree, const ray& r, interval range, const visitor& visit) {
    lantern::todo("lab11 step 8: a walk through the kd-tree");
}

/// Given.
[[nodiscard]] inline std::span<const std::uint32_t> surfaces_in(const kd_tree& tree, std::uint32_t leaf) {
    return std::span(tree.entries).subspan(tree.nodes.at(leaf).first, tree.nodes[leaf].size);
}

// ---- Which structure wins? -----------------------------------------------------------------------------------------

/// Given. Offers the surfaces along the ray, through any of the three structures.
template <class Structure>
void traverse(const Structure& s, const ray& r, interval range, const offer& to) {
    mailbox recent;
    walk(s, r, range, [&](std::uint32_t cell, stretch) { return range = offer_all(surfaces_in(s, cell), range, recent, to); });
}

enum class structure : std::uint8_t { undecided, grid, octree, kd_tree, bvh };

/// Step 9. Which structure will need the fewest steps and tests, for: the teapot in the stadium, the cloud, the sticks, the hills, the
/// clusters. Say it before you measure.
[[nodiscard]] inline std::array<structure, 5> predictions() {
    return lantern::todo("lab11 step 9: your predictions");
}

}  // namespace lab11
