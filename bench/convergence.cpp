// SPDX-License-Identifier: MIT
// How fast pictures of one effect each come to what they must be: error against samples and against time, for every sampler.
//     convergence [--effect NAME] [--sampler NAME] [--width N] [--height N] [--trials N] [--first N] [--most N]
//                 [--threads N] [--pictures DIR] [--json] [--check]

#include "exact_pictures.hpp"

#include "command_line.hpp"

#include <lantern/convergence.hpp>
#include <lantern/hash.hpp>
#include <lantern/image.hpp>
#include <lantern/png.hpp>
#include <lantern/validate.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace {

using exact_pictures::picture;
using lantern::image;

struct options : bench::output {
    std::string effect, sampler;
    glm::uvec2 size{24, 16};
    std::uint32_t trials = 16, most = 1024;
    std::uint64_t first = 0;
    unsigned threads = 0;
    std::string pictures;
};

/// One effect with one sampler.
struct outcome {
    const picture* what;
    std::string_view sampler;
    lantern::convergence measured;
    lantern::estimate slope;
    std::optional<double> predicted_slope;
    double seconds = 0;  ///< of one sample, all its rays with it
};

/// 4, 16, 64 … as far as `most`: squares, for jittered samples, and powers of two, for Sobol's.
std::vector<std::uint32_t> counts(std::uint32_t most) {
    std::vector<std::uint32_t> all;
    for (std::uint64_t n = 4; n <= most; n *= 4) all.push_back(static_cast<std::uint32_t>(n));
    return all;
}

constexpr std::uint32_t fitted_from = 16;

/// The processor's time, of one thread that does nothing else; the median of five.
double seconds_per_sample(const picture& what, std::string_view sampler) {
    constexpr std::uint32_t samples = 64;
    std::vector<double> times;
    for (std::uint64_t run = 0; run < 5; ++run) {
        std::uint32_t repeats = 0;
        const std::clock_t begin = std::clock();
        do {
            static_cast<void>(what.render(sampler, samples, lantern::hash(run, repeats++), 1));
        } while (std::clock() - begin < CLOCKS_PER_SEC / 25);
        const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
        times.push_back(seconds / (double(repeats) * samples * double(what.pixels.size())));
    }
    std::ranges::sort(times);
    return times[times.size() / 2];
}

outcome measure(const picture& what, std::string_view sampler, const options& wish) {
    const image exact = what.exactly();
    outcome all{&what, sampler, {}, {}, {}, 0};
    all.measured = lantern::measure_convergence(
        [&](std::uint32_t samples, std::uint64_t seed) {
            return lantern::difference(what.render(sampler, samples, seed, 1), exact);
        },
        {.samples = counts(wish.most), .trials = wish.trials, .first_seed = wish.first, .threads = wish.threads});
    all.slope = lantern::slope(all.measured, fitted_from);
    std::vector<double> samples, errors;
    for (const std::uint32_t n : all.measured.samples)
        if (const auto error = what.predicted(sampler, n); error && n >= fitted_from) {
            samples.push_back(n);
            errors.push_back(*error);
        }
    if (samples.size() > 1) all.predicted_slope = lantern::fitted_slope(samples, errors);
    all.seconds = seconds_per_sample(what, sampler);
    return all;
}

// ---- pictures ---------------------------------------------------------------------------------------------------------

/// Red where too bright, blue where too dark, white where right; `most` is the error that has the full colour.
image signed_error(const image& picture, const image& exact, float most) {
    image shown(exact.size());
    for (std::size_t i = 0; i < shown.pixels().size(); ++i) {
        const float off = (picture.pixels()[i].x - exact.pixels()[i].x) / most, rest = 1 - std::min(std::abs(off), 1.0f);
        shown.pixels()[i] = off > 0 ? glm::vec3(1, rest, rest) : glm::vec3(rest, rest, 1);
    }
    return shown;
}

void write_pictures(const picture& what, const options& wish) {
    const std::filesystem::path folder = wish.pictures;
    std::string name = what.name;
    std::ranges::replace(name, ' ', '_');
    const image exact = what.exactly();
    const std::string sampler = wish.sampler.empty() ? "jittered" : wish.sampler;
    lantern::write_png(folder / (name + "_exact.png"), exact);
    const std::vector<std::uint32_t> numbers = counts(wish.most);  // shown: 16, the last, and the one in between
    for (const std::uint32_t n : {numbers[1], numbers[(numbers.size()) / 2], numbers.back()}) {
        const image rendered = what.render(sampler, n, wish.first, wish.threads);
        lantern::write_png(folder / (name + "_" + std::to_string(n) + ".png"), rendered);
        // The same colours for all: a quarter of white at 16 samples, and what shrinks as fast as the error should after that.
        const float most = 0.25f * std::pow(float(n) / 16, float(what.theory_jittered));
        lantern::write_png(folder / (name + "_" + std::to_string(n) + "_error.png"), signed_error(rendered, exact, most));
    }
}

// ---- what is printed --------------------------------------------------------------------------------------------------

void print_table(const outcome& o) {
    std::printf("%s, %.*s: slope %.3f (%.3f to %.3f), %.0f ns a sample\n%10s%12s%12s%12s%8s%12s\n", o.what->name.c_str(),
                int(o.sampler.size()), o.sampler.data(), o.slope.value, o.slope.low, o.slope.high, 1e9 * o.seconds, "samples", "RMSE",
                "predicted", "bias", "z", "not finite");
    for (std::size_t i = 0; i < o.measured.samples.size(); ++i) {
        const auto& trials = o.measured.trials[i];
        const lantern::bias off = lantern::bias_of(trials);
        std::uint64_t not_finite = 0;
        for (const auto& t : trials) not_finite += t.not_finite;
        const auto predicted = o.what->predicted(o.sampler, o.measured.samples[i]);
        std::printf("%10u%12.3e%12s%+12.1e%8.2f%12llu\n", o.measured.samples[i], lantern::rmse(trials),
                    predicted ? std::to_string(*predicted).c_str() : "", off.value, off.z, static_cast<unsigned long long>(not_finite));
    }
}

std::string number_or_null(std::optional<double> x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6e", x.value_or(0));
    return x ? text : "null";
}

void print_json(const std::vector<outcome>& all, const options& wish) {
    std::printf("{\"trials\":%u,\"first_seed\":%llu,\"width\":%u,\"height\":%u,\"fitted_from\":%u,\"curves\":[", wish.trials,
                static_cast<unsigned long long>(wish.first), wish.size.x, wish.size.y, fitted_from);
    const char* comma = "";
    for (const outcome& o : all) {
        std::printf("%s\n{\"effect\":\"%s\",\"tells\":\"%s\",\"dimensions\":%u,\"sampler\":\"%.*s\",\"seconds_per_sample\":%.6e,"
                    "\"slope\":%.5f,\"slope_low\":%.5f,\"slope_high\":%.5f,\"predicted_slope\":%s,\"rows\":[",
                    comma, o.what->name.c_str(), o.what->tells.c_str(), o.what->dimensions, int(o.sampler.size()), o.sampler.data(),
                    o.seconds, o.slope.value, o.slope.low, o.slope.high, number_or_null(o.predicted_slope).c_str());
        const char* inner = "";
        for (std::size_t i = 0; i < o.measured.samples.size(); ++i) {
            const auto& trials = o.measured.trials[i];
            lantern::convergence one{{o.measured.samples[i]}, {trials}};
            const lantern::estimate error =
                lantern::bootstrap(one, [](const lantern::convergence& c) { return lantern::rmse(c.trials[0]); });
            const lantern::bias off = lantern::bias_of(trials);
            std::uint64_t not_finite = 0;
            for (const auto& t : trials) not_finite += t.not_finite;
            std::printf("%s{\"samples\":%u,\"rmse\":%.6e,\"rmse_low\":%.6e,\"rmse_high\":%.6e,\"predicted\":%s,\"bias\":%.6e,"
                        "\"z\":%.4f,\"not_finite\":%llu}",
                        inner, o.measured.samples[i], error.value, error.low, error.high,
                        number_or_null(o.what->predicted(o.sampler, o.measured.samples[i])).c_str(), off.value,
                        std::clamp(off.z, -999.0, 999.0),  // JSON knows no infinity
                        static_cast<unsigned long long>(not_finite));
            inner = ",";
        }
        std::printf("]}");
        comma = ",";
    }
    std::printf("]}\n");
}

/// No bias, nothing that is not finite, and where theory knows the error, that error. With 16 trials of 384 pixels an RMSE is
/// known within about 2 %: 10 % is far off. z has Student's distribution with 15 degrees of freedom: beyond 6 once in 40,000.
bool passes(const std::vector<outcome>& all) {
    bool good = true;
    const auto fail = [&](const outcome& o, std::uint32_t samples, const char* what, double figure) {
        std::fprintf(stderr, "FAILED  %s, %.*s, %u samples: %s %.4g\n", o.what->name.c_str(), int(o.sampler.size()), o.sampler.data(),
                     samples, what, figure);
        good = false;
    };
    for (const outcome& o : all)
        for (std::size_t i = 0; i < o.measured.samples.size(); ++i) {
            const std::uint32_t n = o.measured.samples[i];
            const auto& trials = o.measured.trials[i];
            if (const double z = lantern::bias_of(trials).z; !(std::abs(z) < 6)) fail(o, n, "the bias has z =", z);
            for (const auto& t : trials)
                if (t.not_finite > 0) fail(o, n, "values that are not finite:", double(t.not_finite));
            if (const auto predicted = o.what->predicted(o.sampler, n))
                if (const double ratio = lantern::rmse(trials) / *predicted; !(std::abs(ratio - 1) < 0.1))
                    fail(o, n, "RMSE over the predicted one:", ratio);
        }
    if (good) std::fprintf(stderr, "passed: %zu curves, no bias, RMSE within 10 %% of theory\n", all.size());
    return good;
}

options parse(int argc, char** argv) {
    return bench::parse<options>(
        argc, argv, "--effect NAME, --sampler NAME, --width N, --height N, --trials N, --first N, --most N, --threads N, --pictures DIR",
        [](options& o, std::string_view word, auto next) {
            if (word == "--effect") o.effect = next();
            else if (word == "--sampler") o.sampler = next();
            else if (word == "--width") o.size.x = bench::number<std::uint32_t>(word, next(), 1);
            else if (word == "--height") o.size.y = bench::number<std::uint32_t>(word, next(), 1);
            else if (word == "--trials") o.trials = bench::number<std::uint32_t>(word, next(), 2);
            else if (word == "--first") o.first = bench::number<std::uint64_t>(word, next(), 0);
            else if (word == "--most") o.most = bench::number<std::uint32_t>(word, next(), 256);
            else if (word == "--threads") o.threads = bench::number<unsigned>(word, next(), 1);
            else if (word == "--pictures") o.pictures = next();
            else return false;
            return true;
        });
}

}  // namespace

int main(int argc, char** argv) {
    return bench::run("convergence", [&] {
        const options wish = parse(argc, argv);
        std::vector<picture> pictures;
        for (const auto& [name, make] : exact_pictures::all)
            if (wish.effect.empty() || wish.effect == name) pictures.push_back(make(wish.size));
        if (pictures.empty())
            lantern::refuse("--effect", "'" + wish.effect + "'", "antialiasing, soft shadow, gloss, depth of field or motion blur");
        if (!wish.sampler.empty()) exact_pictures::with_sampler(wish.sampler, 4, 0, [](const auto&) {});
        if (!wish.pictures.empty()) {
            for (const picture& p : pictures) write_pictures(p, wish);
            return true;
        }
        std::vector<outcome> all;
        for (const picture& p : pictures)
            for (const std::string_view sampler : exact_pictures::samplers)
                if (wish.sampler.empty() || wish.sampler == sampler) {
                    all.push_back(measure(p, sampler, wish));
                    if (!wish.json) print_table(all.back());
                }
        if (wish.json) print_json(all, wish);
        return !wish.check || passes(all);
    });
}
