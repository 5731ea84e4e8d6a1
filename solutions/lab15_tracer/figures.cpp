// SPDX-License-Identifier: MIT
// The figures of lab 15's handout.

#include "../../labs/lab15_tracer/pictures.hpp"

#include <lantern/png.hpp>

#include <algorithm>
#include <cstdint>
#include <filesystem>

namespace {

/// Sample i takes element i, whatever it is for.
struct swirls : parts::yours {
    static std::uint32_t stratum(std::uint32_t i, std::uint32_t, std::uint32_t, glm::uvec2) { return i; }
};

/// The upper right corner, where lanterns are discs and a ball rolls.
lantern::image corner(const lantern::image& picture, glm::uvec2 size) {
    lantern::image part(size);
    for (unsigned y = 0; y < size.y; ++y) std::ranges::copy(picture.row(y + picture.size().y / 8).subspan(picture.size().x - size.x), part.row(y).begin());
    return part;
}

lantern::image mistakes() {
    constexpr glm::uvec2 size{840, 525}, part{400, 260};
    const auto s = mine::lanterns<pictures::my>();
    lantern::image page({2 * part.x + 8, part.y}, pictures::paper);
    pictures::paste(page, corner(pictures::yours(size, 5), part), {0, 0});
    pictures::paste(page, corner(pictures::seen(s.things, s.from, s, size, lab15::sampler<swirls>{5, 1}).picture, part), {part.x + 8, 0});
    return page;
}

}  // namespace

int main(int argc, char** argv) {
    const std::filesystem::path folder = argc > 1 ? argv[1] : "labs/lab15_tracer/figures";
    lantern::write_png(folder / "camera.png", pictures::cameras());
    lantern::write_png(folder / "samples.png", pictures::samples());
    lantern::write_png(folder / "lamp.png", pictures::lamp());
    lantern::write_png(folder / "gloss.png", pictures::gloss());
    lantern::write_png(folder / "balls.png", pictures::balls());
    lantern::write_png(folder / "tracer.png", pictures::still_life({480, 300}, 144));
    lantern::write_png(folder / "tree.png", pictures::questions());
    lantern::write_png(folder / "mistakes.png", mistakes());
    lantern::write_png(folder / "error.png", pictures::errors({32, 20}, 6));
    lantern::write_png(folder / "yours.png", pictures::yours({720, 450}, 14));
}
