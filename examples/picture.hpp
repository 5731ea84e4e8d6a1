// SPDX-License-Identifier: MIT
#pragma once
// What the picture examples share: their command line, a progress bar, and writing the result as PNG and PPM.

#include <lantern/image.hpp>
#include <lantern/png.hpp>
#include <lantern/ppm.hpp>

#include <charconv>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace picture {

/// A bar on stderr, if that is a terminal; otherwise a line at the end.
inline auto bar(std::string name) {
#ifdef _WIN32
    const bool terminal = _isatty(_fileno(stderr)) != 0;
#else
    const bool terminal = isatty(STDERR_FILENO) != 0;
#endif
    return [name = std::move(name), terminal, shown = -1](double fraction) mutable {
        const int percent = static_cast<int>(fraction * 100);
        if (!terminal || percent == shown) return;
        shown = percent;
        const std::string done(static_cast<std::size_t>(percent / 4), '#');
        std::fprintf(stderr, "\r%-14s [%-25s] %3d %%%s", name.c_str(), done.c_str(), percent, percent == 100 ? "\n" : "");
    };
}

/// Writes PATH.png and PATH.ppm beside it, and says what was wrong with the picture, if anything.
inline void write(const std::filesystem::path& path, const lantern::image& result) {
    lantern::write_png(path, result);
    lantern::write_ppm(std::filesystem::path(path).replace_extension(".ppm"), result);
    std::printf("wrote %s\n", path.string().c_str());
    if (result.rejected() > 0)
        std::fprintf(stderr, "%s: %llu samples were not finite and were left out\n", path.string().c_str(),
                     static_cast<unsigned long long>(result.rejected()));
}

/// `NAME [PATH.png] [COUNT]`: draw(path, count), with errors as messages and exit codes.
template <class Draw>
int main(int argc, char** argv, const std::string& name, std::uint32_t count, Draw&& draw) {
    try {
        const std::string path = argc > 1 ? argv[1] : "out/" + name + ".png";
        if (argc > 2) {
            const std::string text = argv[2];
            const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
            if (error != std::errc{} || end != text.data() + text.size())
                throw std::invalid_argument("the second argument is " + text + ", but must be a whole number");
        }
        draw(path, count);
        return 0;
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "%s: %s\n", name.c_str(), problem.what());
        return 1;
    }
}

}  // namespace picture
