// SPDX-License-Identifier: MIT
#pragma once
// What the benchmarks share: their command line, and what becomes of an error.

#include <lantern/validate.hpp>

#include <charconv>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace bench {

/// What every benchmark can be asked for; its own options derive from this.
struct output {
    bool csv = false;
    bool json = false;
    bool check = false;  ///< exit code 1 when the figures are not what they must be
};

/// The value of an option; refused when it is no whole number, or below `least`.
template <std::integral Number>
[[nodiscard]] Number number(std::string_view option, std::string_view text, Number least) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || value < least)
        lantern::refuse(std::string(option), "'" + std::string(text) + "'", "a whole number, at least " + std::to_string(least));
    return value;
}

/// Whole numbers with commas between them, each larger than the one before, from 1 on.
[[nodiscard]] inline std::vector<std::uint32_t> ascending(std::string_view option, std::string_view text) {
    std::vector<std::uint32_t> all;
    while (true) {
        const std::size_t comma = text.find(',');
        all.push_back(number<std::uint32_t>(option, text.substr(0, comma), all.empty() ? 1 : all.back() + 1));
        if (comma == std::string_view::npos) return all;
        text.remove_prefix(comma + 1);
    }
}

/// Reads --csv, --json and --check, and whatever take(options, word, next) knows besides and returns true for; next() is the
/// word that follows. `own` names those for the message about any other word.
template <std::derived_from<output> Options>
[[nodiscard]] Options parse(int argc, char** argv, const std::string& own, auto&& take) {
    Options wish;
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        const auto next = [&]() -> std::string_view { return ++i < argc ? argv[i] : ""; };
        if (word == "--csv") wish.csv = true;
        else if (word == "--json") wish.json = true;
        else if (word == "--check") wish.check = true;
        else if (!take(wish, word, next))
            lantern::refuse("argument", "'" + std::string(word) + "'", "one of " + own + ", --csv, --json, --check");
    }
    return wish;
}

/// The whole of `main`: 0 or 1 as `work` says, 2 for a command line that is refused, 1 for any other error.
[[nodiscard]] int run(const char* name, auto&& work) {
    try {
        const bool good = work();
        std::fflush(stdout);
        return good ? 0 : 1;
    } catch (const std::invalid_argument& problem) {
        std::fprintf(stderr, "%s: %s\n", name, problem.what());
        return 2;
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "%s: %s\n", name, problem.what());
        return 1;
    }
}

}  // namespace bench
