// SPDX-License-Identifier: MIT
// The effects added one by one to the same scene: what each costs in numbers drawn, in time and in error.
//     ladder [--renderings N] [--side N] [--rung N] [--json] [--check]
// With --rung it renders that rung alone, and prints nothing: for a profiler that counts instructions.

#include "exact_scenes.hpp"

#include "command_line.hpp"

#include <lantern/exact_error.hpp>
#include <lantern/validate.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace {

using exact_scenes::effects;
using exact_scenes::effort;
using exact_scenes::outcome;

struct options : bench::output {
    effort how{.side = 4, .renderings = 4000};
    std::optional<std::uint32_t> rung;
};

struct rung {
    std::string_view adds;
    effects on;
    std::uint32_t dimensions;
};

/// In the lecture's order. Every rung has what the ones below it have.
constexpr std::array<rung, 6> rungs{{
    {"one sample for everything", {}, 0},
    {"antialiasing", {.film = true}, 2},
    {"soft shadow", {.film = true, .shadow = true}, 4},
    {"gloss", {.film = true, .shadow = true, .gloss = true}, 6},
    {"depth of field", {.film = true, .shadow = true, .gloss = true, .lens = true, .round_lens = true}, 8},
    {"motion blur", {.film = true, .shadow = true, .gloss = true, .lens = true, .time = true, .round_lens = true}, 9},
}};

struct row {
    const rung* what;
    outcome result;
    double seconds;  ///< of one sample
};

std::vector<row> climb(const options& wish) {
    std::vector<row> all;
    for (const rung& r : rungs) {
        const exact_scenes::known exactly = exact_scenes::predict({}, r.on, wish.how.side);
        std::vector<double> times;
        outcome result;
        for (int run = 0; run < 3; ++run) {
            const std::clock_t begin = std::clock();
            result = exact_scenes::render(r.on, wish.how, exactly);
            const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
            times.push_back(seconds / (double(wish.how.renderings) * wish.how.side * wish.how.side));
        }
        std::ranges::sort(times);
        all.push_back({&r, result, times[1]});
    }
    return all;
}

/// Without any effect nothing scatters, and the error of rounding has no standard error to be measured by.
double shown_z(const row& r) { return r.what->dimensions > 0 ? r.result.z : 0; }

void print_table(const std::vector<row>& all, const options& wish) {
    std::printf("%u renderings of %u samples\n\n%-28s%11s%12s%9s%11s%11s%7s\n", wish.how.renderings, wish.how.side * wish.how.side,
                "", "dimensions", "ns a sample", "exact", "predicted", "measured", "z");
    for (const row& r : all)
        std::printf("%-28s%11u%12.0f%9.5f%11.5f%11.5f%7.2f\n", std::string(r.what->adds).c_str(), r.what->dimensions, 1e9 * r.seconds,
                    r.result.mean, r.result.rmse, r.result.rendered_rmse, shown_z(r));
}

void print_json(const std::vector<row>& all, const options& wish) {
    std::printf("{\"samples\":%u,\"renderings\":%u,\"rungs\":[", wish.how.side * wish.how.side, wish.how.renderings);
    const char* comma = "";
    for (const row& r : all) {
        std::printf("%s\n{\"adds\":\"%s\",\"dimensions\":%u,\"seconds_per_sample\":%.6e,\"mean\":%.9f,\"rmse\":%.6e,"
                    "\"predicted\":%.6e,\"z\":%.3f}",
                    comma, std::string(r.what->adds).c_str(), r.what->dimensions, r.seconds, r.result.mean, r.result.rendered_rmse,
                    r.result.rmse, shown_z(r));
        comma = ",";
    }
    std::printf("]}\n");
}

/// As in effects.cpp: |z| < 4, and the error within 3 % and four of its standard errors of the predicted one. Without any
/// effect every sample is the same, and right.
bool passes(const std::vector<row>& all, const options& wish) {
    const double aside = 0.03 + 4 / std::sqrt(2.0 * wish.how.renderings);
    bool good = true;
    for (const row& r : all) {
        const bool sharp = r.what->dimensions == 0;
        const bool right = sharp ? r.result.rendered_rmse < 1e-4
                                 : std::abs(r.result.z) < 4 && std::abs(r.result.rendered_rmse / r.result.rmse - 1) < aside;
        if (right) continue;
        std::fprintf(stderr, "FAILED  %s: z = %.2f, RMSE %.4e against %.4e\n", std::string(r.what->adds).c_str(), r.result.z,
                     r.result.rendered_rmse, r.result.rmse);
        good = false;
    }
    if (good) std::fprintf(stderr, "passed: %zu rungs\n", all.size());
    return good;
}

options parse(int argc, char** argv) {
    return bench::parse<options>(argc, argv, "--renderings N, --side N, --rung N", [](options& o, std::string_view word, auto next) {
        if (word == "--renderings") o.how.renderings = bench::number<std::uint32_t>(word, next(), 2);
        else if (word == "--side") o.how.side = bench::number<std::uint32_t>(word, next(), 2);
        else if (word == "--rung") o.rung = bench::number<std::uint32_t>(word, next(), 0);
        else return false;
        return true;
    });
}

}  // namespace

int main(int argc, char** argv) {
    return bench::run("ladder", [&] {
        const options wish = parse(argc, argv);
        if (wish.rung) {
            if (*wish.rung >= rungs.size())
                lantern::refuse("--rung", std::to_string(*wish.rung), "below " + std::to_string(rungs.size()));
            static_cast<void>(exact_scenes::render(rungs[*wish.rung].on, wish.how, exact_scenes::known{}));
            return true;
        }
        const std::vector<row> all = climb(wish);
        if (wish.json) print_json(all, wish);
        else print_table(all, wish);
        return !wish.check || passes(all, wish);
    });
}
