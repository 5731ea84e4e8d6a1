// SPDX-License-Identifier: MIT
// Puts the parts of a picture together: the result has the very bits of a picture rendered in one go.
//     lantern_merge PICTURE.png|.ppm|.pfm|MERGED.shard PART.shard... [--partial]
// A picture is written when no sample is missing; with --partial from what is there.

#include <lantern/pfm.hpp>
#include <lantern/png.hpp>
#include <lantern/ppm.hpp>
#include <lantern/shard.hpp>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

std::string missing(const lantern::shard& s) {
    std::string text;
    std::uint32_t next = 0;
    const auto gap = [&](std::uint32_t until) {
        if (next < until) text += (text.empty() ? "" : ", ") + std::to_string(next) + ":" + std::to_string(until);
    };
    for (const lantern::sample_range& r : s.ranges) {
        gap(r.first);
        next = r.last;
    }
    gap(s.samples);
    return text;
}

void merge(const std::filesystem::path& to, const std::vector<std::string>& parts, bool partial) {
    std::optional<lantern::shard> all;
    for (const std::string& part : parts) {
        const lantern::shard one = lantern::read_shard(part);
        all = all ? lantern::merged(*all, one) : one;
    }
    const auto kind = to.extension();
    if (kind == ".shard") return lantern::write_shard(to, *all);
    if (!all->complete() && !partial)
        throw std::runtime_error("samples " + missing(*all) + " of " + std::to_string(all->samples) + " are in none of the parts; render them, or say --partial");
    const lantern::image picture = lantern::picture_of(*all);
    if (kind == ".png") lantern::write_png(to, picture);
    else if (kind == ".ppm") lantern::write_ppm(to, picture);
    else if (kind == ".pfm") lantern::write_pfm(to, picture);
    else lantern::refuse("lantern_merge: the picture's name", to.string(), "one that ends in .png, .ppm, .pfm or .shard");
    if (picture.rejected() > 0)
        std::fprintf(stderr, "lantern_merge: %llu samples were not finite, and left out\n", static_cast<unsigned long long>(picture.rejected()));
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<std::string> names;
    bool partial = false;
    for (int i = 1; i < argc; ++i) {
        if (std::string(argv[i]) == "--partial") partial = true;
        else names.push_back(argv[i]);
    }
    if (names.size() < 2 || names[0].starts_with("-")) {
        std::fprintf(stderr, "usage: lantern_merge PICTURE.png|.ppm|.pfm|MERGED.shard PART.shard... [--partial]\n");
        return 2;
    }
    try {
        merge(names[0], {names.begin() + 1, names.end()}, partial);
        return 0;
    } catch (const std::invalid_argument& problem) {
        std::fprintf(stderr, "lantern_merge: %s\n", problem.what());
        return 2;
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "lantern_merge: %s\n", problem.what());
        return 1;
    }
}
