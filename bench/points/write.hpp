// SPDX-License-Identifier: MIT
#pragma once
// The half of a measurement that runs a student's code: it makes points and writes them down, and measures nothing. The other half
// (read.hpp, in a process of its own) believes none of it.
//     NAME --pattern NAME --counts 4,16,64 --trials N --width N --height N --purposes 0,1 --numbers 1|2 [--first N]

#include <lantern/hash.hpp>
#include <lantern/todo.hpp>

#include <glm/vec2.hpp>

#include <unistd.h>

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <exception>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace points {

/// What the stream begins with: whoever prints something else there has printed it before `main`.
inline constexpr std::string_view beginning = "lantern points 1\n";

/// Which points are asked for. The pixel is numbered within a large film: another rendering is another part of it.
struct wanted {
    std::uint32_t purpose;
    std::uint32_t numbers;  ///< 1: x alone counts
    glm::uvec2 pixel;
    std::uint64_t key;      ///< of the random numbers that the code is given
};

/// Independent numbers in (0, 1), as many as asked for.
[[nodiscard]] inline std::vector<float> random_numbers(std::size_t count, std::uint64_t key) {
    std::vector<float> all(count);
    for (std::size_t i = 0; i < count; ++i) all[i] = lantern::to_unit(lantern::low(lantern::hash(key, i)));
    return all;
}
[[nodiscard]] inline std::vector<glm::vec2> random_points(std::size_t count, std::uint64_t key) {
    std::vector<glm::vec2> all(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint64_t h = lantern::hash(key, i);
        all[i] = {lantern::to_unit(lantern::low(h)), lantern::to_unit(lantern::high(h))};
    }
    return all;
}

/// Fills the span with the points of one pixel and purpose.
struct pattern {
    std::string_view name;
    void (*make)(const wanted&, std::span<glm::vec2>);
};

namespace detail {

struct order {
    std::string_view pattern;
    std::vector<std::uint32_t> counts, purposes;
    std::uint32_t trials = 2, numbers = 2;
    glm::uvec2 size{1};
    std::uint64_t first = 0;
};

template <class Number>
[[nodiscard]] std::vector<Number> numbers(std::string_view text) {
    std::vector<Number> all;
    for (const char *at = text.data(), *end = at + text.size(); at < end; ++at) {
        Number n{};
        const auto [after, error] = std::from_chars(at, end, n);
        if (error != std::errc{} || (after != end && *after != ',')) throw std::invalid_argument("no whole numbers: " + std::string(text));
        all.push_back(n);
        at = after;
    }
    if (all.empty()) throw std::invalid_argument("a number is missing");
    return all;
}

[[nodiscard]] inline order parse(int argc, char** argv) {
    order o;
    for (int i = 1; i + 1 < argc; i += 2) {
        const std::string_view word = argv[i], value = argv[i + 1];
        if (word == "--pattern") o.pattern = value;
        else if (word == "--counts") o.counts = numbers<std::uint32_t>(value);
        else if (word == "--purposes") o.purposes = numbers<std::uint32_t>(value);
        else if (word == "--numbers") o.numbers = numbers<std::uint32_t>(value)[0];
        else if (word == "--trials") o.trials = numbers<std::uint32_t>(value)[0];
        else if (word == "--width") o.size.x = numbers<std::uint32_t>(value)[0];
        else if (word == "--height") o.size.y = numbers<std::uint32_t>(value)[0];
        else if (word == "--first") o.first = numbers<std::uint64_t>(value)[0];
        else throw std::invalid_argument("unknown option " + std::string(word));
    }
    return o;
}

/// For each number of samples, each trial, each purpose and each pixel, row by row: the points. Then the seconds of the processor that
/// all of it took.
inline void write(const order& o, const pattern& p, std::FILE* out) {
    std::fwrite(beginning.data(), 1, beginning.size(), out);
    std::vector<glm::vec2> set;
    for (const std::uint32_t count : o.counts) {
        set.resize(count);
        for (std::uint32_t trial = 0; trial < o.trials; ++trial) {
            const std::uint64_t seed = lantern::hash(o.first, count, trial);
            const glm::uvec2 corner(lantern::low(seed) % 4096, lantern::high(seed) % 4096);
            for (const std::uint32_t purpose : o.purposes)
                for (std::uint32_t y = 0; y < o.size.y; ++y)
                    for (std::uint32_t x = 0; x < o.size.x; ++x) {
                        p.make({purpose, o.numbers, corner + glm::uvec2(x, y), lantern::hash(seed, x, y, purpose)}, set);
                        std::fwrite(set.data(), sizeof(glm::vec2), set.size(), out);
                    }
            if (std::fflush(out) != 0) return;  // nobody reads any more
        }
    }
    const double seconds = double(std::clock()) / CLOCKS_PER_SEC;
    std::fwrite(&seconds, sizeof seconds, 1, out);
    std::fflush(out);
}

}  // namespace detail

/// The whole of `main`. What the code prints goes to the error stream. 3: it threw, 4: it is not written yet.
[[nodiscard]] inline int write(int argc, char** argv, std::span<const pattern> patterns) {
    std::FILE* out = fdopen(dup(STDOUT_FILENO), "wb");
    dup2(STDERR_FILENO, STDOUT_FILENO);
    try {
        const detail::order o = detail::parse(argc, argv);
        for (const pattern& p : patterns)
            if (p.name == o.pattern) {
                detail::write(o, p, out);
                return 0;
            }
        throw std::invalid_argument("unknown pattern " + std::string(o.pattern));
    } catch (const lantern::unfinished& gap) {
        std::fprintf(stderr, "%s\n", gap.what().c_str());
        return 4;
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "%s\n", problem.what());
        return 3;
    }
}

}  // namespace points
