// SPDX-License-Identifier: MIT
#pragma once
// How `trace` measures: all contenders over the same surfaces and the same rays, in turns; and who is wrong.

#include "contenders.hpp"
#include "report.hpp"
#include "scenes.hpp"

#include <lantern/closest.hpp>
#include <lantern/interval.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace trace {

struct effort {
    std::uint32_t rays = 100'000;            ///< of a kind
    std::uint32_t rounds = 3;                ///< in which everyone runs once; the median counts
    std::vector<unsigned> threads{1, 2};     ///< of the builds
    double seconds = 1;                      ///< that one may take for one kind of rays in one round: who is slow traces some of them
    double tests = 1e8;                      ///< of a surface, by brute force, for one kind of rays
};

[[nodiscard]] double seconds(auto&& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Of this process alone: others may have the processor meanwhile.
[[nodiscard]] double processor_seconds(auto&& work) {
    const std::clock_t begin = std::clock();
    work();
    return std::max(1.0, static_cast<double>(std::clock() - begin)) / static_cast<double>(CLOCKS_PER_SEC);
}

[[nodiscard]] inline double median(std::vector<double> times) {
    std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
    return times[times.size() / 2];
}

/// About `count` of them, evenly spread.
[[nodiscard]] inline std::vector<ray> some(const std::vector<ray>& rays, std::size_t count, std::size_t& step) {
    step = std::max<std::size_t>(1, rays.size() / std::max<std::size_t>(1, count));
    std::vector<ray> chosen;
    for (std::size_t i = 0; i < rays.size(); i += step) chosen.push_back(rays[i]);
    return chosen;
}

/// A hit for a miss, a miss for a hit, or another place altogether. What was not traced (NaN) is never wrong.
[[nodiscard]] inline bool differ(float a, float b) { return a != b && std::abs(a - b) > 1e-3f * std::min(a, b); }

struct verdict {
    std::vector<double> wrong;  ///< of each contender
    std::vector<std::uint64_t> checked;
};

/// Where two disagree, brute force decides, in double precision; and it looks at some other rays as well. Where that would take
/// all day, it looks at an even share of them, and each counts for as many as it stands for.
template <class Surfaces>
[[nodiscard]] verdict judge(const Surfaces& surfaces, const ray_set& set, const std::vector<std::vector<float>>& said, double tests) {
    const lantern::every all{static_cast<std::uint32_t>(surfaces.size())};
    std::vector<std::size_t> disputed, agreed;
    for (std::size_t i = 0; i < set.rays.size(); ++i) {
        float first = std::numeric_limits<float>::quiet_NaN();
        bool same = true;
        for (const auto& answers : said) {
            if (std::isnan(first)) first = answers[i];
            same = same && !differ(answers[i], first);
        }
        (same ? agreed : disputed).push_back(i);
    }
    verdict v{std::vector<double>(said.size()), std::vector<std::uint64_t>(said.size())};
    const auto limit = static_cast<std::size_t>(std::max(20.0, tests / 2 / static_cast<double>(surfaces.size() + 1)));
    for (const auto* kind : {&disputed, &agreed}) {
        const std::size_t step = (kind->size() + limit - 1) / limit;
        for (std::size_t k = 0; k < kind->size(); k += step) {
            const std::size_t i = (*kind)[k];
            float right = lantern::infinity;
            if (set.any) right = lantern::occluded(all, surfaces, set.rays[i], whole_shadow) ? 0 : lantern::infinity;
            else if (const auto h = lantern::closest(all, surfaces, set.rays[i])) right = h->t;
            for (std::size_t c = 0; c < said.size(); ++c) {
                v.wrong[c] += differ(said[c][i], right) ? double(step) : 0;
                v.checked[c] += !std::isnan(said[c][i]);
            }
        }
    }
    return v;
}

/// Appends a row for each contender and each kind of rays; for one that several threads can build, for each number of them.
template <class Surfaces>
void measure(const scene<Surfaces>& s, std::uint32_t size, const std::vector<contender<Surfaces>>& all, const effort& how, std::vector<row>& rows) {
    const Surfaces surfaces = s.make(size);
    const auto count = static_cast<std::uint32_t>(surfaces.size());
    struct runner {
        std::string name;
        std::unique_ptr<rival> who;
        std::vector<std::pair<unsigned, double>> builds;  ///< threads and milliseconds
    };
    std::vector<runner> runners;
    for (const contender<Surfaces>& c : all) {
        if (count > c.most) continue;
        runner r{c.name, nullptr, {}};
        for (const unsigned threads : how.threads) {
            if (!c.threaded && !r.builds.empty()) break;
            std::vector<double> times;
            for (int i = 0; i < 3 && (times.empty() || times[0] < 1); ++i) {
                r.who.reset();
                times.push_back(seconds([&] { r.who = c.build(surfaces, threads); }));
            }
            r.builds.push_back({c.threaded ? threads : 1, 1000 * median(times)});
        }
        runners.push_back(std::move(r));
    }
    for (const ray_set& set : ray_sets(s, surfaces, how.rays)) {
        if (set.rays.empty()) continue;
        std::vector<std::vector<ray>> rays(runners.size());
        std::vector<std::vector<float>> answers(runners.size());
        std::vector<std::size_t> steps(runners.size(), 1);
        std::vector<std::vector<double>> times(runners.size());
        std::vector<lantern::probe> counts(runners.size());
        std::vector<double> counted(runners.size());
        for (std::size_t c = 0; c < runners.size(); ++c) {
            std::size_t step = 1;
            std::vector<float> out(set.rays.size());
            double pilot = 0, traced = 0;
            for (std::size_t n = 8; pilot < 0.02 * how.seconds && n <= set.rays.size(); n *= 8) {
                const auto few = some(set.rays, n, step);
                runners[c].who->answer(set, few, out);  // what is touched for the first time is slow once, and says nothing
                pilot = processor_seconds([&] { runners[c].who->answer(set, few, out); });
                traced = static_cast<double>(few.size());
            }
            rays[c] = some(set.rays, static_cast<std::size_t>(std::max(8.0, how.seconds * traced / std::max(pilot, 1e-6))), steps[c]);
            answers[c].resize(rays[c].size());
            const auto few = some(rays[c], 2000, step);
            if (runners[c].name != "every" || count < 100'000) runners[c].who->count(few, set.any, counts[c]);
            else counts[c].offers = few.size() * count;
            counted[c] = static_cast<double>(few.size());
        }
        for (std::uint32_t round = 0; round < how.rounds; ++round)
            for (std::size_t c = 0; c < runners.size(); ++c)
                times[c].push_back(processor_seconds([&] { runners[c].who->answer(set, rays[c], answers[c]); }));
        std::vector<std::vector<float>> said(runners.size(), std::vector<float>(set.rays.size(), std::numeric_limits<float>::quiet_NaN()));
        for (std::size_t c = 0; c < runners.size(); ++c)
            for (std::size_t i = 0; i < answers[c].size(); ++i) said[c][i * steps[c]] = answers[c][i];
        const verdict v = judge(surfaces, set, said, how.tests);
        for (std::size_t c = 0; c < runners.size(); ++c)
            for (const auto& [threads, ms] : runners[c].builds)
                rows.push_back({s.name, count, runners[c].name, set.name, static_cast<double>(rays[c].size()) / median(times[c]) / 1e6,
                                v.wrong[c], rays[c].size(), v.checked[c], static_cast<double>(counts[c].nodes) / counted[c],
                                static_cast<double>(counts[c].offers) / counted[c],
                                static_cast<double>(runners[c].who->bytes()) / count, ms, threads});
    }
}

}  // namespace trace
