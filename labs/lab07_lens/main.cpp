// SPDX-License-Identifier: MIT
// Lab 07: points of a lens, and what they do to a picture.

#include "../support/test_card.hpp"
#include "pictures.hpp"

#include <lantern/png.hpp>
#include <lantern/todo.hpp>

#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <set>
#include <string>
#include <utility>
#include <vector>

int main(int argc, char** argv) try {
    const std::filesystem::path folder = argc > 1 ? argv[1] : "out";
    const std::vector<std::pair<std::string, std::function<lantern::image()>>> pages{
        {"lab07_1_lens.png", pictures::lens},
        {"lab07_3_focus.png", [] { return pictures::focused({720, 300}, 6, 0.12f, pictures::depth_of(1)); }},
        {"lab07_5_discs.png", pictures::discs},
        {"lab07_6_samples.png", pictures::samples},
        {"lab07_7_blades.png", [] { return pictures::blades({720, 300}, 6, 6); }},
    };
    std::set<std::string> missing;
    for (const auto& [name, draw] : pages) {
        lantern::image page({480, 240});
        try {
            page = draw();
        } catch (const lantern::unfinished& gap) {
            missing.insert(gap.what());
            for (unsigned y = 0; y < 240; ++y)
                for (unsigned x = 0; x < 480; ++x)
                    page(x, y) = support::test_card((glm::vec2(x, y) + 0.5f) / glm::vec2(480, 240), support::step_number(gap.what()));
        }
        lantern::write_png(folder / name, page);
        std::cout << (folder / name).string() << std::endl;
    }
    for (const std::string& gap : missing) std::cout << "still to do: " << gap << '\n';
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
