// SPDX-License-Identifier: MIT
// The figures of lab 11's handout.

#include "../../labs/lab11_subdivision/pictures.hpp"

#include <lantern/png.hpp>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <vector>

namespace {

/// Pictures of the same size, so many in a row.
lantern::image table(const std::vector<lantern::image>& parts, unsigned columns) {
    const glm::uvec2 size = parts.front().size();
    const auto rows = unsigned(parts.size()) / columns;
    lantern::image page({columns * (size.x + 4) - 4, rows * (size.y + 4) - 4}, glm::vec3(1));
    for (unsigned i = 0; i < parts.size(); ++i)
        for (unsigned y = 0; y < size.y; ++y)
            std::ranges::copy(parts[i].row(y), page.row((i / columns) * (size.y + 4) + y).begin() + (i % columns) * (size.x + 4));
    return page;
}

/// A grid whose walk may end too early.
struct hasty {
    lab11::grid cells;
    bool first_hit_ends_it;

    template <class Offer>
    void traverse(const lantern::ray& r, lantern::interval range, Offer&& offer) const {
        walk(cells, r, range, [&](std::uint32_t cell, lab11::stretch) {
            const lantern::interval before = range;
            for (const std::uint32_t i : cells.cells[cell]) range = offer(i, range);
            return range = first_hit_ends_it && range.max < before.max ? lantern::interval{0, 0} : range;
        });
    }
};

lantern::image seen_through(const hasty& grid, const stage::scene& s) {
    lantern::view view = s.view;
    view.aspect = 240 / 200.0f;
    return lantern::render({240, 200}, lantern::camera{view}, lantern::jittered{.side = 4}, [&](const lantern::ray& r, const auto&) {
        const auto h = closest(grid, s.shapes, r);
        if (!h) return glm::vec3(0.03f, 0.05f, 0.09f);
        const float light = std::max(glm::dot(h->normal, glm::normalize(glm::vec3(-0.3f, 0.8f, 0.5f))), 0.0f);
        return (0.15f + 0.8f * light) * glm::vec3(0.9f, 0.8f, 0.6f);
    });
}

lantern::image mistakes() {
    stage::scene s{"balls", {}, stage::cloud().view};
    for (std::uint32_t i = 0; i < 110; ++i) s.shapes.push_back(lantern::sphere{stage::in_cube(i, 0), 0.12f + 0.2f * stage::number(i, 3)});
    const std::vector<lantern::aabb> boxes = lantern::boxes_of(s.shapes);
    const lab11::grid right = lab11::build_grid(boxes, 8);
    lab11::grid centres = right;
    for (auto& cell : centres.cells) cell.clear();
    for (std::uint32_t i = 0; i < boxes.size(); ++i) centres.cells[pictures::cell_at(right, center(boxes[i]))].push_back(i);
    return table({seen_through({right, false}, s), seen_through({centres, false}, s), seen_through({right, true}, s)}, 3);
}

lantern::image cells() {
    std::vector<lantern::image> parts;
    const auto add = [&](const stage::scene& s, const pictures::window& w) {
        const std::vector<lantern::aabb> boxes = lantern::boxes_of(s.shapes);
        parts.push_back(pictures::cells(lab11::build_grid(boxes, stage::cells_per_surface), w, {300, 225}));
        parts.push_back(pictures::cells(lab11::build_octree(boxes, stage::leaf_size, stage::max_depth), w, {300, 225}));
        parts.push_back(pictures::cells(lab11::build_kd_tree(boxes), w, {300, 225}));
    };
    add(stage::hills(), {{-0.6f, -0.45f}, {0.6f, 0.45f}, 0.213f});
    add(stage::swarms(), {{-1.35f, -1.05f}, {1.25f, 0.9f}, 0.33f});
    return table(parts, 3);
}

}  // namespace

int main(int argc, char** argv) {
    const std::filesystem::path folder = argc > 1 ? argv[1] : "labs/lab11_subdivision/figures";
    support::gaps none;
    lantern::write_png(folder / "grid.png", pictures::flat_grid(none));
    lantern::write_png(folder / "octree.png", pictures::flat_octree(none));
    lantern::write_png(folder / "kd_tree.png", pictures::flat_kd_tree(none));
    lantern::write_png(folder / "mistakes.png", mistakes());
    lantern::write_png(folder / "cells.png", cells());
    lantern::write_png(folder / "wins.png", pictures::contest(none, [](const auto&...) {}));
}
