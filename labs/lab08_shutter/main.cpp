// SPDX-License-Identifier: MIT
// Lab 08: things that move while the shutter is open.

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
        {"lab08_2_moving.png", [] { return pictures::moving({720, 300}, 4); }},
        {"lab08_3_boxes.png", [] { return pictures::boxes({720, 300}, 4); }},
        {"lab08_4_whole.png", [] { return pictures::whole({720, 300}, 6); }},
        {"lab08_5_lamps.png", pictures::lamps},
        {"lab08_6_profiles.png", pictures::profiles},
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
