// SPDX-License-Identifier: MIT
// Lab 11: three ways to cut up space, seen from above; and which of them wins, in which scene.

#include "../support/gaps.hpp"
#include "../support/test_card.hpp"
#include "pictures.hpp"

#include <lantern/image.hpp>
#include <lantern/png.hpp>
#include <lantern/todo.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace {

support::gaps gaps;

const char* name_of(lab11::structure s) {
    switch (s) {
        case lab11::structure::grid: return "grid";
        case lab11::structure::octree: return "octree";
        case lab11::structure::kd_tree: return "kd-tree";
        case lab11::structure::bvh: return "bvh";
        default: return "nothing";
    }
}

/// A table for each scene: means for a ray; the cost is steps + 4 tests; `copies` is in how many cells a surface is, on average.
void print(const stage::scene& s, const std::vector<pictures::standing>& all, lab11::structure predicted) {
    std::printf("\n%-22s    steps    tests     cost |    cells   copies   memory    build\n", (s.name + ", " + std::to_string(s.shapes.size()) + " surfaces").c_str());
    const pictures::standing* best = pictures::winner(all);
    for (const auto& one : all) {
        const auto& [who, did] = one;
        if (who.waits_for > 0)
            std::printf("    %-18s waits for step %d\n", who.name.c_str(), who.waits_for);
        else
            std::printf("  %c %-18s %8.1f %8.1f %8.1f | %8.0f %8.1f %5.0f kB %5.0f ms\n", &one == best ? '*' : ' ', who.name.c_str(), did.mean.steps,
                        did.mean.tests, one.cost(), who.size.cells, who.size.entries / double(s.shapes.size()), who.size.bytes / 1024, who.build_ms);
    }
    const auto yours = std::ranges::find(all, predicted, [](const pictures::standing& one) { return one.who.which; });
    const bool right = best && yours != all.end() && yours->cost() <= 1.05 * best->cost();  // so close is as good
    std::printf("    you said %s: %s\n", name_of(predicted), !best ? "we shall see" : right ? "right" : "not this time");
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) try {
    const std::filesystem::path folder = argc > 1 ? argv[1] : "out";
    const std::vector<std::pair<std::string, std::function<lantern::image()>>> pages{
        {"lab11_1_grid.png", [] { return pictures::flat_grid(gaps); }},
        {"lab11_5_octree.png", [] { return pictures::flat_octree(gaps); }},
        {"lab11_7_kd_tree.png", [] { return pictures::flat_kd_tree(gaps); }},
        {"lab11_9_wins.png", [] { return pictures::contest(gaps, print); }},
    };
    for (const auto& [name, picture] : pages) {
        lantern::image page({741, 481});
        try {
            page = picture();
        } catch (const lantern::unfinished& gap) {
            gaps.note(gap);
            support::paint_test_card(page, {0, 0}, page.size(), support::step_number(gap.what()));
        }
        lantern::write_png(folder / name, page);
        std::cout << (folder / name).string() << std::endl;
    }
    gaps.tell();
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
