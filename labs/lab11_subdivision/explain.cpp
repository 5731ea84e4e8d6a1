// SPDX-License-Identifier: MIT
// Lab 11's contest, explained: ./lab explain 11, ./lab heat 11.

#include "../support/explain.hpp"
#include "pictures.hpp"

#include <lantern/boxes_of.hpp>

#include <array>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace {

using pictures::pane;

support::figure figure_of(const lantern::sphere& s) { return support::ball_at(s.center, s.radius); }
support::figure figure_of(const lantern::triangle& t) { return {"triangle", {t.a.x, t.a.y, t.a.z, t.b.x, t.b.y, t.b.z, t.c.x, t.c.y, t.c.z}}; }
support::figure figure_of(const lantern::cylinder& c) { return {"cylinder", {c.from.x, c.from.y, c.from.z, c.to.x, c.to.y, c.to.z, c.radius}}; }

/// A shape that tells who asks it.
struct told {
    const stage::shape* what;
    support::figure figure;
};
std::optional<lantern::hit> intersect(const told& one, const lantern::ray& r, lantern::interval range) {
    const auto h = intersect(*one.what, r, range);
    if (support::recorder* const to = support::recorder::listener()) to->test(one.figure, h, range);
    return h;
}

/// A cell of a grid, or a node of a tree.
struct cell {
    lantern::aabb box;
    std::uint32_t depth = 0;
};

std::vector<cell> cells_of(const lab11::grid& g) {
    std::vector<cell> all(g.cells.size());
    const glm::vec3 size = (g.box.max - g.box.min) / glm::vec3(g.count);
    for (int z = 0; z < g.count.z; ++z)
        for (int y = 0; y < g.count.y; ++y)
            for (int x = 0; x < g.count.x; ++x) {
                const glm::vec3 low = g.box.min + glm::vec3(x, y, z) * size;
                all.at(number_of(g, {x, y, z})) = {{low, low + size}};
            }
    return all;
}
std::vector<cell> cells_of(const lab11::octree& tree) {
    std::vector<cell> all(tree.nodes.size());
    if (!all.empty()) all[0] = {tree.cell};
    for (std::uint32_t i = 0; i < all.size(); ++i)
        for (std::uint32_t k = 0; k < 8 && tree.nodes[i].children > i; ++k) all.at(tree.nodes[i].children + k) = {lab11::octant_of(all[i].box, k), all[i].depth + 1};
    return all;
}
std::vector<cell> cells_of(const lab11::kd_tree& tree) {
    std::vector<cell> all(tree.nodes.size());
    if (!all.empty()) all[0] = {tree.box};
    for (std::uint32_t i = 0; i < all.size(); ++i) {
        const lab11::kd_node& n = tree.nodes[i];
        if (n.axis > 2 || n.first <= i) continue;
        cell below{all[i].box, all[i].depth + 1}, above = below;
        below.box.max[int(n.axis)] = above.box.min[int(n.axis)] = n.at;
        all.at(n.first) = below;
        all.at(n.first + 1) = above;
    }
    return all;
}

/// Counts, and tells the recorder. Of the library's tree it knows the number of nodes alone.
struct told_probe : lantern::probe {
    const std::vector<cell>& cells;
    support::recorder* to = support::recorder::listener();

    explicit told_probe(const std::vector<cell>& c) : cells(c) {}
    void node() {
        ++nodes;
        if (to) to->box();
    }
    void node(std::uint32_t which) {
        ++nodes;
        const cell& here = cells.at(which);
        if (to) to->box({here.box.min, here.box.max, which, here.depth, 0.0f});  // a walk visits what it passes, and asks nothing else
    }
};

/// A scene, and its structures, each built when it is asked for.
class row {
public:
    explicit row(stage::scene s) : scene_(std::move(s)) {
        for (const stage::shape& each : scene_.shapes) shapes_.push_back({&each, std::visit([](const auto& which) { return figure_of(which); }, each.value)});
    }
    row(const row&) = delete;
    row& operator=(const row&) = delete;

    [[nodiscard]] const stage::scene& scene() const { return scene_; }

    /// The first hit, by structure 0, 1, 2, 3 as they stand in the picture; and what it takes.
    std::optional<lantern::nearest> find(std::uint32_t which, const lantern::ray& r, lantern::probe& count) const {
        std::call_once(built_.at(which), [&] { structures_[which] = build(which); });
        if (support::recorder* const to = support::recorder::listener()) to->begin(r, {});
        return structures_[which](r, count);
    }

    [[nodiscard]] support::world world() const {
        support::world w{.eye = scene_.view.eye, .beyond = "the dark"};
        const glm::vec3 color(0.6f, 0.55f, 0.45f);
        for (std::size_t i = 0; i < shapes_.size(); ++i) w.things.push_back({shapes_[i].figure, std::string(shapes_[i].figure.kind) + ' ' + std::to_string(i), "", color});
        return w;
    }

    /// Whose pane has the green frame.
    [[nodiscard]] std::optional<lab11::structure> winner() const {
        std::call_once(raced_, [&] {
            support::gaps missing;
            std::vector<pictures::standing> all;
            for (stage::contestant& who : stage::contestants(scene_, missing)) {
                stage::record did = who.waits_for > 0 ? stage::record{} : stage::race(who, scene_, pane);
                all.push_back({std::move(who), std::move(did)});
            }
            if (const pictures::standing* best = pictures::winner(all)) winner_ = best->who.which;
        });
        return winner_;
    }

private:
    using search = std::function<std::optional<lantern::nearest>(const lantern::ray&, lantern::probe&)>;

    template <class Accelerator>
    search along(Accelerator made, std::vector<cell> cells) const {
        return [this, made = std::move(made), cells = std::move(cells)](const lantern::ray& r, lantern::probe& count) {
            told_probe heard(cells);
            const auto h = lantern::closest(made, shapes_, r, lantern::interval{}, heard);
            count = heard;
            return h;
        };
    }
    search build(std::uint32_t which) const {
        const std::vector<lantern::aabb> boxes = lantern::boxes_of(scene_.shapes);
        support::gaps missing;
        const bool mailbox = stage::mailbox_is_written(missing);
        const auto counted = [&](auto made) {
            std::vector<cell> cells = cells_of(made);
            return along(stage::counted(std::move(made), mailbox), std::move(cells));
        };
        switch (which) {
            case 0: return counted(lab11::build_grid(boxes, stage::cells_per_surface));
            case 1: return counted(lab11::build_octree(boxes, stage::leaf_size, stage::max_depth));
            case 2: return counted(lab11::build_kd_tree(boxes));
            default: return along(lantern::bvh<>(std::span<const lantern::aabb>(boxes)), {});
        }
    }

    stage::scene scene_;
    std::vector<told> shapes_;
    mutable std::array<std::once_flag, 4> built_;
    mutable std::array<search, 4> structures_;
    mutable std::once_flag raced_;
    mutable std::optional<lab11::structure> winner_;
};

constexpr std::array structures{lab11::structure::grid, lab11::structure::octree, lab11::structure::kd_tree, lab11::structure::bvh};

/// Where in the page a pixel is; outside the panes there are frames.
struct spot {
    std::uint32_t row, column;
    glm::ivec2 inside;
    [[nodiscard]] bool in_pane() const { return inside.x >= 0 && inside.y >= 0 && inside.x < int(pane.x) && inside.y < int(pane.y); }
};
spot spot_of(glm::uvec2 at) {
    // A pane's frame is 3 wide, and so is that of its neighbour.
    const glm::uvec2 cell = (glm::max(at, glm::uvec2(1)) - 1u) / (pane + 6u);
    const std::uint32_t row = std::min(cell.y, 4u), column = std::min(cell.x, 4u);
    return {row, column, glm::ivec2(at) - glm::ivec2(pictures::corner_of(row, column))};
}

support::subject contest() {
    const auto rows = std::make_shared<std::vector<std::unique_ptr<const row>>>();
    for (stage::scene& s : stage::scenes()) rows->push_back(std::make_unique<const row>(std::move(s)));
    const auto predicted = std::make_shared<std::array<lab11::structure, 5>>();
    const auto color = [=](glm::uvec2 at) {
        const spot here = spot_of(at);
        const row& in = *rows->at(here.row);
        if (!here.in_pane()) {
            const bool framed = here.column > 0 && here.inside.x >= -3 && here.inside.y >= -3 && here.inside.x < int(pane.x) + 3 && here.inside.y < int(pane.y) + 3;
            return framed && in.winner() == structures.at(here.column - 1) ? glm::vec3(0.05f, 0.75f, 0.1f) : glm::vec3(0.2f);
        }
        const lantern::camera<> camera{in.scene().view};
        lantern::probe count;
        if (here.column == 0) return pictures::shown(camera, glm::uvec2(here.inside), [&](const lantern::ray& r) { return in.find(3, r, count); });
        (void)in.find(here.column - 1, shoot(camera, (glm::vec2(here.inside) + 0.5f) / glm::vec2(pane)), count);
        if (structures.at(here.column - 1) == predicted->at(here.row) && pictures::is_corner(glm::uvec2(here.inside))) return glm::vec3(1);
        return pictures::heat(stage::work{double(count.nodes), double(count.offers)}.cost());
    };
    return {.name = "lab11_9_wins.png",
            .size = pictures::page_of_the_contest,
            .samples = 1,
            .pixel = color,
            .sample = [=](glm::uvec2 at, std::uint32_t) { return color(at); },
            .world_at = [=](glm::uvec2 at) { return rows->at(spot_of(at).row)->world(); },
            .ready = [=] { *predicted = lab11::predictions(); }};
}

std::vector<support::subject> subjects() { return {contest()}; }

}  // namespace

int main(int argc, char** argv) { return support::explain(argc, argv, subjects); }
