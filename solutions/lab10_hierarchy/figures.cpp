// SPDX-License-Identifier: MIT
// The figures of lab 10's handout.

#include "../../labs/lab10_hierarchy/pictures.hpp"

#include <lantern/png.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

namespace {

/// What a traversal does, and what the handout's mistakes leave out.
struct habits {
    bool prunes = true;         ///< skips what is entered beyond the nearest hit so far
    bool nearer_first = true;   ///< opens the nearer child first, and not the left one
    bool goes_on = true;        ///< after a leaf with a hit
    bool both_children = true;  ///< opens the farther child too
};

pictures::search with(habits h) {
    return [h](const lab10::tree& t, const stage::balls& all, const lantern::ray& r, stage::count& asked) {
        std::optional<lantern::nearest> best;
        const auto open = [&](const auto& self, std::uint32_t at) -> bool {  // whether it goes on
            const lab10::node& n = t.nodes[at];
            const auto before = best;
            for (std::uint32_t k = n.first; k < n.first + n.count; ++k) {
                ++asked.offers;
                const auto hit = intersect(all[t.order[k]], r, lantern::interval{0, best ? best->t : lantern::infinity});
                if (hit) best = lantern::nearest{*hit, t.order[k]};
            }
            if (n.count > 0) return h.goes_on || best.has_value() == before.has_value();
            std::pair one{n.left, stage::entry(t.nodes[n.left].box, r)}, other{n.right, stage::entry(t.nodes[n.right].box, r)};
            asked.questions += 2;
            if (h.nearer_first && one.second && other.second && *other.second < *one.second) std::swap(one, other);
            if (!h.both_children && one.second) other.second = std::nullopt;
            for (const auto& [child, entry] : {one, other})
                if (entry && !(h.prunes && best && *entry > best->t) && !self(self, child)) return false;
            return true;
        };
        ++asked.questions;
        if (stage::entry(t.nodes[0].box, r)) open(open, 0);
        return best;
    };
}

/// Above: what rays ask; right, left child first, not pruned. Below: what one sees when the first hit ends it, when the farther child is
/// skipped, and when the box of a node is that of its left child.
lantern::image mistakes() {
    const glm::uvec2 size{300, 260};
    const stage::balls all = stage::flake(3);
    const lab10::tree t = stage::library_tree(all, lantern::split::surface_area);
    lab10::tree half = t;
    for (lab10::node& n : half.nodes)
        if (n.count == 0) n.box = t.nodes[n.left].box;
    return pictures::with_scale(pictures::table({
        pictures::heat_of(size, t, all, with({})), pictures::heat_of(size, t, all, with({.nearer_first = false})),
        pictures::heat_of(size, t, all, with({.prunes = false})), pictures::found(size, t, all, with({.goes_on = false})),
        pictures::found(size, t, all, with({.both_children = false})), pictures::found(size, half, all, with({}))}, 3));
}

/// Shadow rays that look for the closest hit, and those that stop at any.
lantern::image shadows() {
    const glm::uvec2 size{300, 260};
    const auto closest = [](const lab10::tree& t, const stage::balls& all, const lantern::ray& r, stage::count& asked) {
        const auto h = stage::closest(t, all, r, asked);
        return h && h->t <= 1;
    };
    std::vector<lantern::image> parts = pictures::in_the_light(size, stage::dark<stage::count>);
    parts.insert(parts.begin() + 1, pictures::in_the_light(size, closest)[1]);
    return pictures::with_scale(pictures::table(parts, 3));
}

}  // namespace

int main(int argc, char** argv) {
    const std::filesystem::path folder = argc > 1 ? argv[1] : "labs/lab10_hierarchy/figures";
    const glm::uvec2 half{359, 280}, third{300, 260};
    lantern::write_png(folder / "groups.png", pictures::groups({720, 480}));
    lantern::write_png(folder / "halves.png", pictures::median_and_middle(half));
    lantern::write_png(folder / "levels.png", pictures::levels(third));
    lantern::write_png(folder / "costs.png", pictures::costs());
    lantern::write_png(folder / "cheapest.png", pictures::divided_thrice(third, lab10::at_least_cost));
    lantern::write_png(folder / "joined.png", pictures::joined(third));
    lantern::write_png(folder / "cost.png", pictures::cost_map(third));
    lantern::write_png(folder / "growth.png", pictures::plot(pictures::growth(6)));
    lantern::write_png(folder / "mistakes.png", mistakes());
    lantern::write_png(folder / "shadows.png", shadows());
    lantern::write_png(folder / "moving.png", pictures::moving(half, 8));
}
