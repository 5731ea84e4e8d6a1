// SPDX-License-Identifier: MIT
// How fast the error of each sampler falls: RMSE against the exact integral, over many seeds.
//     samplers [--seeds N] [--first N] [--threads N] [--csv | --json] [--check]

#include "command_line.hpp"

#include <lantern/halton.hpp>
#include <lantern/render.hpp>
#include <lantern/samples.hpp>
#include <lantern/sobol.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace {

constexpr std::array<std::uint32_t, 5> counts{16, 64, 256, 1024, 4096};

// ---- what is integrated ---------------------------------------------------------------------------------------------

constexpr double golden = .61803398875;

bool edge(glm::dvec2 p) { return p.x + golden * p.y < .7; }
bool disc(glm::dvec2 p) { return (p.x - .4) * (p.x - .4) + (p.y - .45) * (p.y - .45) < .35 * .35; }
double smooth(glm::dvec2 p) { return std::exp(-p.x * p.x - p.y * p.y); }
bool pen4(glm::dvec2 p, glm::dvec2 q) { return p.x + .6 * p.y + .8 * q.x + .5 * q.y < 1.3; }

const double exact_edge = .7 - golden / 2;                                                 // .390983005625
const double exact_disc = std::numbers::pi * .35 * .35;                                    // .384845100065
const double exact_smooth = std::pow(std::sqrt(std::numbers::pi) / 2 * std::erf(1.0), 2);  // .557746285351

/// P(Σ wᵢUᵢ < d) = 1/(n! Πwᵢ) Σ over subsets S of (-1)^|S| max(0, d - Σ of S)ⁿ: .371076388889.
double exact_pen4() {
    constexpr std::array weights{1.0, .6, .8, .5};
    double sum = 0;
    for (unsigned subset = 0; subset < 16; ++subset) {
        double left = 1.3, sign = 1;
        for (unsigned i = 0; i < 4; ++i)
            if ((subset >> i) & 1) left -= weights[i], sign = -sign;
        sum += sign * std::pow(std::max(0.0, left), 4);
    }
    return sum / (24 * weights[0] * weights[1] * weights[2] * weights[3]);
}

// ---- what integrates it ---------------------------------------------------------------------------------------------

using errors = std::array<double, 3>;  // of edge, disc and smooth; or of pen4 alone
using experiment = std::function<errors(std::uint32_t count, std::uint64_t seed)>;

/// One pixel, as a renderer would take it.
template <class Make>
experiment in_the_square(Make make) {
    return [make](std::uint32_t count, std::uint64_t seed) {
        const lantern::sampler auto set = make(count, seed);
        std::array<double, 3> sum{};
        for (std::uint32_t i = 0; i < set.count(); ++i) {
            const glm::dvec2 p(set.at({0, 0}, i).draw2(lantern::purpose::film));
            sum[0] += edge(p), sum[1] += disc(p), sum[2] += smooth(p);
        }
        return errors{sum[0] / set.count() - exact_edge, sum[1] / set.count() - exact_disc,
                      sum[2] / set.count() - exact_smooth};
    };
}

template <class Make>
experiment in_four_dimensions(Make make) {
    return [make, exact = exact_pen4()](std::uint32_t count, std::uint64_t seed) {
        const lantern::sampler auto set = make(count, seed);
        double sum = 0;
        for (std::uint32_t i = 0; i < set.count(); ++i) {
            const auto source = set.at({0, 0}, i);
            sum += pen4(glm::dvec2(source.draw2(lantern::purpose::film)),
                        glm::dvec2(source.draw2(lantern::purpose::lens)));
        }
        return errors{sum / set.count() - exact};
    };
}

const auto make_independent = [](std::uint32_t n, std::uint64_t seed) { return lantern::independent{n, seed}; };
const auto make_jittered = [](std::uint32_t n, std::uint64_t seed) { return lantern::jittered::of(n, seed); };
const auto make_sobol = [](std::uint32_t n, std::uint64_t seed) { return lantern::sobol{.samples = n, .seed = seed}; };
const auto make_padded = [](std::uint32_t n, std::uint64_t seed) {
    return lantern::sobol{.samples = n, .packed = {}, .seed = seed};
};

struct contender {
    std::string_view name;
    bool four_dimensions;
    experiment run;
};

const std::vector<contender> contenders{
    {"random", false, in_the_square(make_independent)},
    {"N-rooks", false, in_the_square([](std::uint32_t n, std::uint64_t seed) {
         return lantern::n_rooks{n, seed};
     })},
    {"jittered", false, in_the_square(make_jittered)},
    {"multi-jittered", false,
     in_the_square([](std::uint32_t n, std::uint64_t seed) { return lantern::multi_jittered::of(n, seed); })},
    {"correlated multi-jittered", false, in_the_square([](std::uint32_t n, std::uint64_t seed) {
         return lantern::correlated_multi_jittered{n, seed};
     })},
    {"Halton, rotated", false, in_the_square([](std::uint32_t n, std::uint64_t seed) {
         return lantern::halton{n, seed};
     })},
    {"Owen-scrambled Sobol", false, in_the_square(make_sobol)},
    {"random", true, in_four_dimensions(make_independent)},
    {"jittered, 2D + 2D", true, in_four_dimensions(make_jittered)},
    {"Owen Sobol, padded pairs", true, in_four_dimensions(make_padded)},
    {"Owen Sobol, four dimensions", true, in_four_dimensions(make_sobol)},
};

// ---- what is expected -----------------------------------------------------------------------------------------------

struct expectation {
    std::string_view integrand, sampler;
    std::array<double, 5> rmse;
    double slope;
};

/// 4000 seeds of another program, ±1.1 % a cell, slope ±.005.
constexpr std::array expected{
    expectation{"edge", "random", {1.24e-1, 6.15e-2, 3.09e-2, 1.52e-2, 7.54e-3}, -.50},
    expectation{"edge", "N-rooks", {6.92e-2, 3.41e-2, 1.70e-2, 8.36e-3, 4.09e-3}, -.51},
    expectation{"edge", "jittered", {5.73e-2, 1.97e-2, 6.93e-3, 2.42e-3, 8.68e-4}, -.76},
    expectation{"edge", "multi-jittered", {5.54e-2, 1.94e-2, 6.75e-3, 2.42e-3, 8.72e-4}, -.75},
    expectation{"edge", "correlated multi-jittered", {4.26e-2, 1.46e-2, 5.14e-3, 1.80e-3, 6.41e-4}, -.76},
    expectation{"edge", "Halton, rotated", {5.44e-2, 2.21e-2, 6.78e-3, 2.17e-3, 9.13e-4}, -.76},
    expectation{"edge", "Owen-scrambled Sobol", {5.62e-2, 1.82e-2, 6.42e-3, 2.32e-3, 8.34e-4}, -.76},
    expectation{"disc", "random", {1.21e-1, 6.05e-2, 2.99e-2, 1.52e-2, 7.52e-3}, -.50},
    expectation{"disc", "jittered", {7.41e-2, 2.62e-2, 9.27e-3, 3.41e-3, 1.19e-3}, -.74},
    expectation{"disc", "correlated multi-jittered", {5.51e-2, 1.96e-2, 6.26e-3, 2.28e-3, 8.07e-4}, -.76},
    expectation{"disc", "Owen-scrambled Sobol", {6.56e-2, 2.20e-2, 7.71e-3, 2.82e-3, 9.83e-4}, -.75},
    expectation{"smooth", "random", {5.38e-2, 2.69e-2, 1.34e-2, 6.62e-3, 3.35e-3}, -.50},
    expectation{"smooth", "jittered", {1.33e-2, 3.44e-3, 8.44e-4, 2.09e-4, 5.30e-5}, -1.00},
    expectation{"smooth", "multi-jittered", {5.08e-3, 1.01e-3, 2.26e-4, 5.51e-5, 1.37e-5}, -1.06},
    expectation{"smooth", "Halton, rotated", {1.78e-2, 5.11e-3, 1.42e-3, 4.28e-4, 1.21e-4}, -.90},
    expectation{"smooth", "Owen-scrambled Sobol", {4.23e-3, 5.89e-4, 7.91e-5, 1.06e-5, 1.43e-6}, -1.44},
    expectation{"pen4", "random", {1.21e-1, 6.06e-2, 3.05e-2, 1.47e-2, 7.44e-3}, -.50},
    expectation{"pen4", "jittered, 2D + 2D", {7.63e-2, 3.63e-2, 1.78e-2, 8.75e-3, 4.44e-3}, -.51},
    expectation{"pen4", "Owen Sobol, padded pairs", {7.54e-2, 3.71e-2, 1.85e-2, 9.10e-3, 4.60e-3}, -.50},
    expectation{"pen4", "Owen Sobol, four dimensions", {6.80e-2, 2.87e-2, 1.38e-2, 5.27e-3, 2.25e-3}, -.61},
};

// ---- measuring ------------------------------------------------------------------------------------------------------

struct row {
    std::string_view integrand, sampler;
    std::array<double, 5> rmse{}, z{};  // z: the mean error over its own standard error
    double slope = 0;                   // of log RMSE over log N, by least squares
    const expectation* reference = nullptr;
};

struct options : bench::output {
    std::uint32_t seeds = 4000;
    std::uint64_t first = 0;
    unsigned threads = 2;
};

bool is_terminal() {
#ifdef _WIN32
    return _isatty(_fileno(stderr)) != 0;
#else
    return isatty(STDERR_FILENO) != 0;
#endif
}

void complete(row& r) {
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t k = 0; k < counts.size(); ++k) {
        const double x = std::log(counts[k]), y = std::log(r.rmse[k]);
        sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    constexpr auto n = static_cast<double>(counts.size());
    r.slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
    for (const expectation& e : expected)
        if (e.integrand == r.integrand && e.sampler == r.sampler) r.reference = &e;
}

std::vector<row> measure(const options& wish) {
    constexpr std::array<std::string_view, 3> square{"edge", "disc", "smooth"};
    const bool terminal = is_terminal();
    std::vector<row> rows;
    std::size_t done = 0;
    for (const contender& c : contenders) {
        const std::size_t first = rows.size(), width = c.four_dimensions ? 1 : 3;
        for (std::size_t q = 0; q < width; ++q) rows.push_back({c.four_dimensions ? "pen4" : square[q], c.name});
        for (std::size_t k = 0; k < counts.size(); ++k) {
            if (terminal)
                std::fprintf(stderr, "\r%3zu %%  %-28.*s%5u ", 100 * done / (contenders.size() * counts.size()),
                             static_cast<int>(c.name.size()), c.name.data(), counts[k]);
            std::vector<errors> found(wish.seeds);
            lantern::in_parallel(wish.seeds, wish.threads,
                                 [&](std::size_t s) { found[s] = c.run(counts[k], wish.first + s); });
            for (std::size_t q = 0; q < width; ++q) {
                double sum = 0, squares = 0;
                for (const errors& e : found) sum += e[q], squares += e[q] * e[q];
                const double n = wish.seeds, mean = sum / n, variance = (squares - sum * mean) / (n - 1);
                rows[first + q].rmse[k] = std::sqrt(squares / n);
                rows[first + q].z[k] = mean / std::sqrt(variance / n);
            }
            ++done;
        }
        for (std::size_t q = 0; q < width; ++q) complete(rows[first + q]);
    }
    if (terminal) std::fprintf(stderr, "\r%60s\r", "");
    std::vector<row> sorted;
    for (const std::string_view integrand : {"edge", "disc", "smooth", "pen4"})
        for (const row& r : rows)
            if (r.integrand == integrand) sorted.push_back(r);
    return sorted;
}

// ---- telling --------------------------------------------------------------------------------------------------------

int length(std::string_view text) { return static_cast<int>(text.size()); }

void print_table(const std::vector<row>& rows, const options& wish) {
    std::printf("RMSE over %u seeds, and the worst cell against the figures to reach\n\n%-8s%-29s", wish.seeds, "", "");
    for (const std::uint32_t n : counts) std::printf("%9u", n);
    std::printf("%8s%9s%7s\n", "slope", "worst", "|z|");
    std::string_view last;
    for (const row& r : rows) {
        std::printf("%-8s%-29.*s", std::string(r.integrand == last ? "" : r.integrand).c_str(), length(r.sampler),
                    r.sampler.data());
        double worst = -1, z = 0;
        for (std::size_t k = 0; k < counts.size(); ++k) {
            std::printf("%9.2e", r.rmse[k]);
            if (r.reference != nullptr) worst = std::max(worst, r.rmse[k] / r.reference->rmse[k] - 1);
            z = std::max(z, std::abs(r.z[k]));
        }
        std::printf("%8.3f", r.slope);
        if (r.reference != nullptr)
            std::printf("%+8.1f%%", 100 * worst);
        else
            std::printf("%9s", "");
        std::printf("%7.1f\n", z);
        last = r.integrand;
    }
}

void print_csv(const std::vector<row>& rows) {
    std::printf("integrand,sampler,n,rmse,z,slope\n");
    for (const row& r : rows)
        for (std::size_t k = 0; k < counts.size(); ++k)
            std::printf("%.*s,\"%.*s\",%u,%.6e,%.3f,%.4f\n", length(r.integrand), r.integrand.data(), length(r.sampler),
                        r.sampler.data(), counts[k], r.rmse[k], r.z[k], r.slope);
}

void print_json(const std::vector<row>& rows) {
    std::printf("{\"cells\":[");
    const char* comma = "";
    for (const row& r : rows)
        for (std::size_t k = 0; k < counts.size(); ++k) {
            std::printf("%s\n{\"integrand\":\"%.*s\",\"sampler\":\"%.*s\",\"n\":%u,\"rmse\":%.6e,\"z\":%.3f}", comma,
                        length(r.integrand), r.integrand.data(), length(r.sampler), r.sampler.data(), counts[k],
                        r.rmse[k], r.z[k]);
            comma = ",";
        }
    std::printf("],\n\"slopes\":[");
    comma = "";
    for (const row& r : rows) {
        std::printf("%s\n{\"integrand\":\"%.*s\",\"sampler\":\"%.*s\",\"slope\":%.4f}", comma, length(r.integrand),
                    r.integrand.data(), length(r.sampler), r.sampler.data(), r.slope);
        comma = ",";
    }
    std::printf("]}\n");
}

/// No cell more than 6 % above the figures, slopes within .03, means within four standard errors. With fewer seeds than
/// 2000 the limits are wider by four standard errors of what is measured.
bool passes(const std::vector<row>& rows, const options& wish) {
    const double doubt = wish.seeds < 2000 ? 4 / std::sqrt(2.0 * wish.seeds) : 0;
    const double above = .06 + doubt, aside = .03 + .24 * doubt;  // .24: what the errors of five cells do to the slope
    std::size_t cells = 0, failures = 0;
    const auto fail = [&](const row& r, const std::string& what) {
        std::fprintf(stderr, "FAILED  %.*s, %.*s, %s\n", length(r.integrand), r.integrand.data(), length(r.sampler),
                     r.sampler.data(), what.c_str());
        ++failures;
    };
    const auto shown = [](const char* format, double value) {
        std::array<char, 32> text{};
        std::snprintf(text.data(), text.size(), format, value);
        return std::string(text.data());
    };
    for (const row& r : rows) {
        for (std::size_t k = 0; k < counts.size(); ++k) {
            const std::string at = "N = " + std::to_string(counts[k]) + ": ";
            if (!(std::abs(r.z[k]) < 4))
                fail(r, at + "the mean is off by " + shown("%.2f", r.z[k]) + " standard errors");
            if (r.reference == nullptr) continue;
            ++cells;
            if (!(r.rmse[k] <= (1 + above) * r.reference->rmse[k]))
                fail(r, at + "RMSE " + shown("%.3e", r.rmse[k]) + " against " + shown("%.2e", r.reference->rmse[k]));
        }
        if (r.reference != nullptr && !(std::abs(r.slope - r.reference->slope) <= aside))
            fail(r, "slope " + shown("%.3f", r.slope) + " against " + shown("%.2f", r.reference->slope));
    }
    if (cells != counts.size() * expected.size()) {
        std::fprintf(stderr, "FAILED  only %zu of the %zu cells were measured\n", cells,
                     counts.size() * expected.size());
        ++failures;
    }
    if (failures == 0)
        std::fprintf(stderr, "passed: %zu cells at most %.0f %% above, slopes within %.3f, |z| < 4, %u seeds\n", cells,
                     100 * above, aside, wish.seeds);
    return failures == 0;
}

options parse(int argc, char** argv) {
    return bench::parse<options>(argc, argv, "--seeds N, --first N, --threads N", [](options& o, std::string_view word, auto next) {
        if (word == "--seeds") o.seeds = bench::number<std::uint32_t>(word, next(), 2);
        else if (word == "--first") o.first = bench::number<std::uint64_t>(word, next(), 0);
        else if (word == "--threads") o.threads = bench::number<unsigned>(word, next(), 1);
        else return false;
        return true;
    });
}

}  // namespace

int main(int argc, char** argv) {
    return bench::run("samplers", [&] {
        const options wish = parse(argc, argv);
        const std::vector<row> rows = measure(wish);
        if (wish.json) print_json(rows);
        else if (wish.csv) print_csv(rows);
        else print_table(rows, wish);
        return !wish.check || passes(rows, wish);
    });
}
