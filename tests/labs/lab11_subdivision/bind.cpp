// SPDX-License-Identifier: MIT
// Lab 11's functions, bound to the student's. Its own types are made out of the contract's here, and the other way round.

#include "contract.hpp"

#include <lab11_subdivision/subdivision.hpp>

using namespace contract::lab11;  // found only where the student's header lacks the name

namespace lab11 {

namespace {

lattice own(const contract::lab11::lattice& g) { return {g.box, g.count}; }
kd_tree own(const contract::lab11::kd_tree& tree) {
    kd_tree made{tree.box, {}, {}};
    for (const auto& n : tree.nodes) made.nodes.push_back({n.axis, n.at, n.first, n.size});
    return made;
}
contract::lab11::octree shown(const octree& tree) {
    contract::lab11::octree made{tree.cell, {}, tree.entries};
    for (const auto& n : tree.nodes) made.nodes.push_back({n.children, n.first, n.size});
    return made;
}

template <class Structure>
bool walk_each(const Structure& s, std::span<const ray> rays, interval range, const contract::lab11::visitor& visit) {
    for (std::uint32_t k = 0; k < rays.size(); ++k)
        walk(s, rays[k], range, [&](std::uint32_t cell, stretch part) { return visit(k, cell, {part.enter, part.leave}); });
    return true;
}

template <class Structure>
bool traverse_each(const Structure& s, std::span<const ray> rays, const contract::lab11::offer_to_ray& to) {
    for (std::uint32_t k = 0; k < rays.size(); ++k)
        traverse(s, rays[k], {}, [&](std::uint32_t i, interval range) { return to(k, i, range); });
    return true;
}

std::vector<interval> offer_cells(const std::vector<std::vector<std::uint32_t>>& cells, interval range, const offer& to) {
    mailbox recent;
    std::vector<interval> remaining;
    for (const auto& cell : cells) remaining.push_back(range = offer_all(cell, range, recent, to));
    return remaining;
}

std::vector<contract::lab11::octant_part> octants(const aabb& cell, const ray& r, contract::lab11::stretch part) {
    std::vector<contract::lab11::octant_part> result;
    for (const auto& met : octants_met(cell, r, {part.enter, part.leave})) result.push_back({met.octant, {met.part.enter, met.part.leave}});
    return result;
}

bool build_and_traverse(contract::lab11::structure which, std::span<const aabb> boxes, std::span<const ray> rays, const contract::lab11::offer_to_ray& to) {
    using enum contract::lab11::structure;
    if (which == grid) return traverse_each(build_grid(boxes, 8), rays, to);
    if (which == octree) return traverse_each(build_octree(boxes, 8, 16), rays, to);
    return traverse_each(build_kd_tree(boxes, {}), rays, to);
}

}  // namespace

const contract::table lab{
    contract::bind<contract::lab11::resolution>(resolution),
    contract::bind<contract::lab11::cells_of>([](const contract::lab11::lattice& g, const aabb& box) {
        const auto cells = cells_of(own(g), box);
        return contract::lab11::cell_range{cells.first, cells.last};
    }),
    contract::bind<contract::lab11::walk_grid>([](const contract::lab11::lattice& g, std::span<const ray> rays, interval range,
                                                  const contract::lab11::visitor& visit) { return walk_each(own(g), rays, range, visit); }),
    contract::bind<contract::lab11::walk_kd_tree>([](const contract::lab11::kd_tree& tree, std::span<const ray> rays, interval range,
                                                     const contract::lab11::visitor& visit) { return walk_each(own(tree), rays, range, visit); }),
    contract::bind<contract::lab11::offer_all>(offer_cells),
    contract::bind<contract::lab11::octant_of>(octant_of),
    contract::bind<contract::lab11::build_octree>([](std::span<const aabb> boxes, std::uint32_t leaf_size, std::uint32_t max_depth) {
        return shown(build_octree(boxes, leaf_size, max_depth));
    }),
    contract::bind<contract::lab11::octants_met>(octants),
    contract::bind<contract::lab11::best_cut>([](const aabb& cell, std::span<const aabb> boxes, contract::lab11::costs c) {
        const auto best = best_cut(cell, boxes, {c.step, c.test, c.empty_bonus});
        return best ? std::optional(contract::lab11::cut{best->axis, best->at}) : std::nullopt;
    }),
    contract::bind<contract::lab11::predictions>([] {
        std::array<contract::lab11::structure, 5> result{};
        const auto made = predictions();
        for (std::size_t i = 0; i < 5; ++i) result[i] = contract::lab11::structure(made[i]);
        return result;
    }),
    contract::bind<contract::lab11::traverse>(build_and_traverse),
};

}  // namespace lab11
