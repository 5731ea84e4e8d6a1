// SPDX-License-Identifier: MIT
// How fast pictures of one effect each come to what they must be: error against samples and against time, for every sampler.
//     convergence [--effect NAME] [--sampler NAME] [--width N] [--height N] [--trials N] [--first N] [--most N | --counts N,N...]
//                 [--threads N] [--pictures DIR | --list | --points] [--json] [--check]
// With --list it tells of each effect what a sample draws numbers for. With --points it reads, instead of calling a sampler, the
// points that another program makes (points/write.hpp); --sampler then is but a name.

#include "exact_pictures.hpp"

#include "command_line.hpp"
#include "pixel_bias.hpp"
#include "points/read.hpp"

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
    std::vector<std::uint32_t> counts;  // none: 4, 16, 64 … as far as `most`
    bool list = false, points = false;
};

/// One effect with one sampler.
struct outcome {
    const picture* what;
    std::string sampler;
    lantern::convergence measured;
    std::vector<bench::pixel_bias> pixels;  ///< for each number of samples
    lantern::estimate slope;
    std::vector<std::optional<double>> predicted;  ///< RMSE by theory, for each number of samples
    std::optional<double> predicted_slope;
    double seconds = 0;  ///< of one sample, all its rays with it; without the making of its points where these were read
    std::uint64_t points = 0, outside = 0;  ///< that were read; of them outside the unit square
    std::optional<double> making;  ///< seconds that the making of a point took, as its program says
    bool begun = true;   ///< false where what was to be read did not begin as it must
};

/// As wished, or squares, for jittered samples, that are powers of two, for Sobol's.
std::vector<std::uint32_t> counts(const options& wish) {
    std::vector<std::uint32_t> all = wish.counts;
    if (all.empty())
        for (std::uint64_t n = 4; n <= wish.most; n *= 4) all.push_back(static_cast<std::uint32_t>(n));
    return all;
}

constexpr std::uint32_t fitted_from = 16;

/// The processor's time, of one thread that does nothing else; the median of five. `render(seed)` takes `samples` a pixel.
double seconds_per_sample(const picture& what, std::uint32_t samples, const auto& render) {
    std::vector<double> times;
    for (std::uint64_t run = 0; run < 5; ++run) {
        std::uint32_t repeats = 0;
        const std::clock_t begin = std::clock();
        do {
            static_cast<void>(render(lantern::hash(run, repeats++)));
        } while (std::clock() - begin < CLOCKS_PER_SEC / 25);
        const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
        times.push_back(seconds / (double(repeats) * samples * double(what.pixels.size())));
    }
    std::ranges::sort(times);
    return times[times.size() / 2];
}

/// The errors of all pixels, row by row.
std::vector<float> errors_of(const image& rendered, const image& exact) {
    std::vector<float> all(exact.pixels().size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = rendered.pixels()[i].x - exact.pixels()[i].x;
    return all;
}

/// What follows from the trials.
void conclude(outcome& all) {
    all.slope = lantern::slope(all.measured, fitted_from);
    std::vector<double> samples, errors;
    for (const std::uint32_t n : all.measured.samples) {
        all.predicted.push_back(all.what->predicted(all.sampler, n));
        if (all.predicted.back() && n >= fitted_from) {
            samples.push_back(n);
            errors.push_back(*all.predicted.back());
        }
    }
    if (samples.size() > 1) all.predicted_slope = lantern::fitted_slope(samples, errors);
}

/// One of our samplers.
outcome measure(const picture& what, std::string_view sampler, const options& wish) {
    const image exact = what.exactly();
    outcome all{.what = &what, .sampler = std::string(sampler)};
    lantern::convergence& m = all.measured;
    m.samples = counts(wish);
    m.trials.assign(m.samples.size(), std::vector<lantern::trial>(wish.trials));
    std::vector<std::vector<std::vector<float>>> errors(m.samples.size(), std::vector<std::vector<float>>(wish.trials));
    lantern::in_parallel(m.samples.size() * wish.trials, wish.threads, [&](std::size_t i) {
        const std::size_t n = m.samples.size() - 1 - i / wish.trials, k = i % wish.trials;  // the longest first
        const image rendered = what.render.by_name(sampler, m.samples[n], lantern::hash(wish.first, n, k), 1);
        m.trials[n][k] = lantern::difference(rendered, exact);
        errors[n][k] = errors_of(rendered, exact);
    });
    for (const auto& some : errors) all.pixels.push_back(bench::pixel_bias_of(some));
    conclude(all);
    constexpr std::uint32_t samples = 64;
    all.seconds = seconds_per_sample(what, samples, [&](std::uint64_t seed) { return what.render.by_name(sampler, samples, seed, 1); });
    return all;
}

/// Somebody else's, whose points come from the standard input. Where they end too early the curve does.
outcome measure_points(const picture& what, const options& wish) {
    const image exact = what.exactly();
    outcome all{.what = &what, .sampler = wish.sampler};
    points::reader from(stdin);
    point_table table{.purposes = what.purposes, .size = what.size, .samples = 1, .points = {}};
    for (const std::uint32_t n : counts(wish)) {
        table.samples = n;
        std::vector<lantern::trial> trials;
        std::vector<std::vector<float>> errors;
        while (trials.size() < wish.trials && from.read(table)) {
            const image rendered = what.render.by_table(table, wish.threads);
            trials.push_back(lantern::difference(rendered, exact));
            errors.push_back(errors_of(rendered, exact));
        }
        if (trials.size() < wish.trials) break;
        all.measured.samples.push_back(n);
        all.measured.trials.push_back(std::move(trials));
        all.pixels.push_back(bench::pixel_bias_of(errors));
    }
    all.points = from.points(), all.outside = from.outside(), all.begun = from.begun();
    if (const auto seconds = from.seconds(); seconds && all.points > 0) all.making = *seconds / double(all.points);
    conclude(all);

    table.samples = 64;
    table.points.resize(what.purposes.size() * what.pixels.size() * table.samples);
    for (std::size_t i = 0; i < table.points.size(); ++i) {
        const std::uint64_t h = lantern::hash(0, i);
        table.points[i] = {lantern::to_unit(lantern::low(h)), lantern::to_unit(lantern::high(h))};
    }
    all.seconds = seconds_per_sample(what, table.samples, [&](std::uint64_t) { return what.render.by_table(table, 1); });
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
    const std::vector<std::uint32_t> numbers = counts(wish);  // shown: 16, the last, and the one in between
    for (const std::uint32_t n : {numbers[1], numbers[(numbers.size()) / 2], numbers.back()}) {
        const image rendered = what.render.by_name(sampler, n, wish.first, wish.threads);
        lantern::write_png(folder / (name + "_" + std::to_string(n) + ".png"), rendered);
        // The same colours for all: a quarter of white at 16 samples, and what shrinks as fast as the error should after that.
        const float most = 0.25f * std::pow(float(n) / 16, float(what.theory_jittered));
        lantern::write_png(folder / (name + "_" + std::to_string(n) + "_error.png"), signed_error(rendered, exact, most));
    }
}

// ---- what is printed --------------------------------------------------------------------------------------------------

void print_table(const outcome& o) {
    std::printf("%s, %s: slope %.3f (%.3f to %.3f), %.0f ns a sample\n%10s%12s%12s%12s%8s%12s%8s%12s\n", o.what->name.c_str(),
                o.sampler.c_str(), o.slope.value, o.slope.low, o.slope.high, 1e9 * o.seconds, "samples", "RMSE", "predicted", "bias", "z",
                "of pixels", "z", "not finite");
    for (std::size_t i = 0; i < o.measured.samples.size(); ++i) {
        const auto& trials = o.measured.trials[i];
        const lantern::bias off = lantern::bias_of(trials);
        std::uint64_t not_finite = 0;
        for (const auto& t : trials) not_finite += t.not_finite;
        const auto predicted = o.predicted[i];
        std::printf("%10u%12.3e%12s%+12.1e%8.2f%12.1e%8.2f%12llu\n", o.measured.samples[i], lantern::rmse(trials),
                    predicted ? std::to_string(*predicted).c_str() : "", off.value, off.z, o.pixels[i].rms, o.pixels[i].z,
                    static_cast<unsigned long long>(not_finite));
    }
}

std::string number_or_null(std::optional<double> x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6e", x.value_or(0));
    return x && std::isfinite(*x) ? text : "null";  // JSON knows no others
}

/// z, but that JSON knows no infinity.
double bounded(double z) { return std::clamp(z, -999.0, 999.0); }

void print_json(const std::vector<outcome>& all, const options& wish) {
    std::printf("{\"trials\":%u,\"first_seed\":%llu,\"width\":%u,\"height\":%u,\"fitted_from\":%u,\"curves\":[", wish.trials,
                static_cast<unsigned long long>(wish.first), wish.size.x, wish.size.y, fitted_from);
    const char* comma = "";
    for (const outcome& o : all) {
        std::printf("%s\n{\"effect\":\"%s\",\"tells\":\"%s\",\"dimensions\":%u,\"sampler\":\"%s\",\"seconds_per_sample\":%.6e,"
                    "\"slope\":%s,\"slope_low\":%s,\"slope_high\":%s,\"predicted_slope\":%s,\"points\":%llu,\"outside\":%llu,"
                    "\"making_seconds\":%s,\"begun\":%s,\"samples_to_one_percent\":%s,\"rows\":[",
                    comma, o.what->name.c_str(), o.what->tells.c_str(), o.what->dimensions, o.sampler.c_str(), o.seconds,
                    number_or_null(o.slope.value).c_str(), number_or_null(o.slope.low).c_str(), number_or_null(o.slope.high).c_str(),
                    number_or_null(o.predicted_slope).c_str(), static_cast<unsigned long long>(o.points),
                    static_cast<unsigned long long>(o.outside), number_or_null(o.making).c_str(), o.begun ? "true" : "false",
                    number_or_null(o.measured.samples.size() < 2 ? std::nullopt : std::optional(lantern::samples_for(o.measured, 0.01))).c_str());
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
                        "\"z\":%.4f,\"pixel_bias\":%.6e,\"pixel_z\":%.4f,\"not_finite\":%llu}",
                        inner, o.measured.samples[i], error.value, error.low, error.high,
                        number_or_null(o.predicted[i]).c_str(), off.value, bounded(off.z),
                        o.pixels[i].rms, bounded(o.pixels[i].z), static_cast<unsigned long long>(not_finite));
            inner = ",";
        }
        std::printf("]}");
        comma = ",";
    }
    std::printf("]}\n");
}

void print_list(const std::vector<picture>& all) {
    const char* comma = "[";
    for (const picture& p : all) {
        std::printf("%s{\"effect\":\"%s\",\"dimensions\":%u,\"purposes\":[", comma, p.name.c_str(), p.dimensions);
        for (std::size_t i = 0; i < p.purposes.size(); ++i) std::printf("%s%u", i > 0 ? "," : "", static_cast<unsigned>(p.purposes[i]));
        std::printf("]}");
        comma = ",\n";
    }
    std::printf("]\n");
}

/// No bias, nothing that is not finite, and where theory knows the error, that error. With 16 trials of 384 pixels an RMSE is
/// known within about 2 %: 10 % is far off. z has Student's distribution with 15 degrees of freedom: beyond 6 once in 40,000.
bool passes(const std::vector<outcome>& all) {
    bool good = true;
    const auto fail = [&](const outcome& o, std::uint32_t samples, const char* what, double figure) {
        std::fprintf(stderr, "FAILED  %s, %s, %u samples: %s %.4g\n", o.what->name.c_str(), o.sampler.c_str(), samples, what, figure);
        good = false;
    };
    for (const outcome& o : all)
        for (std::size_t i = 0; i < o.measured.samples.size(); ++i) {
            const std::uint32_t n = o.measured.samples[i];
            const auto& trials = o.measured.trials[i];
            if (const double z = lantern::bias_of(trials).z; !(std::abs(z) < 6)) fail(o, n, "the bias has z =", z);
            if (const double z = o.pixels[i].z; !(z < 6)) fail(o, n, "the pixels' biases have z =", z);
            for (const auto& t : trials)
                if (t.not_finite > 0) fail(o, n, "values that are not finite:", double(t.not_finite));
            if (const auto predicted = o.predicted[i])
                if (const double ratio = lantern::rmse(trials) / *predicted; !(std::abs(ratio - 1) < 0.1))
                    fail(o, n, "RMSE over the predicted one:", ratio);
        }
    if (good) std::fprintf(stderr, "passed: %zu curves, no bias, RMSE within 10 %% of theory\n", all.size());
    return good;
}

options parse(int argc, char** argv) {
    return bench::parse<options>(
        argc, argv, "--effect NAME, --sampler NAME, --width N, --height N, --trials N, --first N, --most N, --counts N,N..., --threads N, --pictures DIR, "
        "--list, --points",
        [](options& o, std::string_view word, auto next) {
            if (word == "--effect") o.effect = next();
            else if (word == "--sampler") o.sampler = next();
            else if (word == "--width") o.size.x = bench::number<std::uint32_t>(word, next(), 1);
            else if (word == "--height") o.size.y = bench::number<std::uint32_t>(word, next(), 1);
            else if (word == "--trials") o.trials = bench::number<std::uint32_t>(word, next(), 2);
            else if (word == "--first") o.first = bench::number<std::uint64_t>(word, next(), 0);
            else if (word == "--most") o.most = bench::number<std::uint32_t>(word, next(), 256);
            else if (word == "--threads") o.threads = bench::number<unsigned>(word, next(), 1);
            else if (word == "--counts") o.counts = bench::ascending(word, next());
            else if (word == "--pictures") o.pictures = next();
            else if (word == "--list") o.list = true;
            else if (word == "--points") o.points = true;
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
            lantern::refuse("--effect", "'" + wish.effect + "'", "one of those that --list tells");
        if (wish.list) {
            print_list(pictures);
            return true;
        }
        if (wish.points) {
            if (pictures.size() != 1) lantern::refuse("--points", "all effects at once", "--effect with it");
            print_json({measure_points(pictures[0], wish)}, wish);
            return true;
        }
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
