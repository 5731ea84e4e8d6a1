// SPDX-License-Identifier: MIT
#pragma once
// A lab's program that draws one picture for each of several steps.

#include "gaps.hpp"

#include <lantern/image.hpp>
#include <lantern/png.hpp>
#include <lantern/todo.hpp>

#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace support {

using pages = std::vector<std::pair<std::string, std::function<lantern::image()>>>;

/// The whole of `main`: writes every page under its name into the folder argv[1], "out" if there is none. A page that needs
/// what is not written yet becomes a test card.
inline int draw(int argc, char** argv, const pages& all) try {
    const std::filesystem::path folder = argc > 1 ? argv[1] : "out";
    gaps missing;
    for (const auto& [name, picture] : all) {
        lantern::image page({480, 240});
        try {
            page = picture();
        } catch (const lantern::unfinished& gap) {
            missing.note(gap);
            paint_test_card(page, {0, 0}, page.size(), step_number(gap.what()));
        }
        lantern::write_png(folder / name, page);
        std::cout << (folder / name).string() << std::endl;  // flushed: the next page may take a while
    }
    missing.tell();
    return 0;
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}

}  // namespace support
