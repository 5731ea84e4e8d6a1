// SPDX-License-Identifier: MIT
#pragma once
// The whole of a program that explains a lab's pictures: ./lab explain and ./lab heat call it, with the student's header inside.

#include "json.hpp"
#include "rays.hpp"
#include "recorder.hpp"

#include <lantern/image.hpp>
#include <lantern/render.hpp>
#include <lantern/todo.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace support {

/// A picture whose pixels can be explained.
struct subject {
    std::string name{};  ///< as the lab's program calls the file
    glm::uvec2 size{0};
    std::uint32_t samples = 1;
    std::function<std::uint32_t(glm::uvec2 pixel)> samples_at{};                       ///< where not all pixels have as many
    std::function<glm::vec3(glm::uvec2 pixel)> pixel;                                  ///< as it is in the picture, to the last bit
    std::function<glm::vec3(glm::uvec2 pixel, std::uint32_t i)> sample;                ///< of which that is the mean
    std::function<glm::vec3(glm::uvec2 pixel, std::uint32_t i, float light)> with_card{};  ///< the same, with a card that gives so much light
    support::world world{};
    std::function<support::world(glm::uvec2 pixel)> world_at{};  ///< where the picture shows several
    std::function<std::string()> levels{};  ///< the boxes of a hierarchy, in JSON, where there is one
    std::function<void()> ready{};          ///< what has to be there first: built, measured
};

namespace explaining {

inline std::string of(const figure& f) {
    return json::object({{"kind", json::of(f.kind)}, {"numbers", json::list(f.numbers, [](float x) { return json::of(double(x)); })}});
}

/// All figures that are spoken of, each once.
class catalogue {
public:
    explicit catalogue(const world& w) : world_(w) {
        for (const world::thing& t : w.things) (void)number_of(t.shape);
    }
    std::size_t number_of(const figure& f) {
        const auto at = std::ranges::find(seen_, f);
        if (at != seen_.end()) return std::size_t(at - seen_.begin());
        seen_.push_back(f);
        return seen_.size() - 1;
    }
    [[nodiscard]] std::string write() const {
        return json::list(seen_, [&](const figure& f) {
            const auto at = std::ranges::find(world_.things, f, &world::thing::shape);
            const world::thing known = at != world_.things.end() ? *at : world::thing{f, std::string(f.kind), ""};
            return json::object({{"shape", of(f)}, {"name", json::of(known.name)}, {"material", json::of(known.material)}, {"color", json::of(known.color)}});
        });
    }

private:
    const world& world_;
    std::vector<figure> seen_;
};

/// The sample's colour, heard by a recorder.
template <class Look>
glm::vec3 heard(recorder& to, const Look& look) {
    const recorder::session here(to);
    return look();
}

/// One sample: its rays, and what each of them is good for. That is found by experiment, so that it holds for whatever the student
/// wrote: the sample is taken again with a black card in the ray's way, and what is missing then is what the ray brings; with a card
/// that gives light 1, and how much more there is then is the ray's weight; and, where a shadow ray is stopped, with nothing in its way.
inline std::string explained(const subject& s, const world& w, glm::uvec2 pixel, std::uint32_t i, catalogue& figures, glm::vec3& color) {
    recorder first;
    color = heard(first, [&] { return s.sample(pixel, i); });
    std::vector<asked> rays = first.rays();
    for (asked& a : rays) add_floor(a, w);
    const std::vector<place> tree = tree_of(rays, w);

    const auto again = [&](recorder::trick trick, const lantern::ray& r, float light) {
        recorder other;
        other.play(trick, r, w.floor ? 0x1p-20f : 1.0f);  // in front of the floor, too
        return heard(other, [&] { return s.with_card ? s.with_card(pixel, i, light) : s.sample(pixel, i); });
    };
    std::vector<std::string> written;
    for (std::size_t k = 0; k < rays.size(); ++k) {
        const asked& a = rays[k];
        const place& here = tree[k];
        std::vector<std::pair<std::string_view, std::string>> ray{
            {"parent", std::to_string(here.parent)}, {"why", json::of(here.why)}, {"gap", json::of(double(here.gap))}, {"origin", json::of(a.ray.origin)},
            {"direction", json::of(a.ray.direction)}, {"range", '[' + json::of(double(a.range.min)) + ',' + json::of(double(a.range.max)) + ']'}};
        if (a.time) ray.push_back({"time", json::of(double(*a.time))});
        ray.push_back({"tests", json::list(a.tests, [&](const surface_test& t) {
            return '[' + std::to_string(figures.number_of(t.what)) + ',' + (t.t ? json::of(double(*t.t)) : "null") + ',' + std::to_string(t.count) + ']';
        })});
        if (!a.boxes.empty())
            ray.push_back({"boxes", json::list(a.boxes, [](const box_test& b) {
                return json::object({{"node", std::to_string(b.node)}, {"depth", std::to_string(b.depth)}, {"min", json::of(b.min)}, {"max", json::of(b.max)},
                                     {"t", b.t ? json::of(double(*b.t)) : "null"}});
            })});
        if (a.met)
            ray.push_back({"met", json::object({{"t", json::of(double(a.met->t))}, {"point", json::of(a.met->point)}, {"normal", json::of(a.met->normal)},
                                                {"surface", std::to_string(figures.number_of(*a.what))}})});
        if (here.why == "camera" && !s.with_card) {
            ray.push_back({"weight", json::of(glm::vec3(1))});
            ray.push_back({"brings", json::of(color)});
        } else {
            const glm::vec3 black = again(recorder::trick::card, a.ray, 0);
            ray.push_back({"brings", json::of(color - black)});
            if (here.why != "shadow") ray.push_back({"weight", json::of(again(recorder::trick::card, a.ray, 1) - black)});
            else if (a.met) ray.push_back({"keeps", json::of(again(recorder::trick::air, a.ray, 0) - color)});
        }
        written.push_back(json::object(ray));
    }
    return json::object({{"color", json::of(color)}, {"rays", json::list(written, [](const std::string& one) { return one; })}});
}

/// The pixels around one, row by row.
inline std::string neighbours_of(const subject& s, glm::uvec2 pixel) {
    constexpr std::uint32_t reach = 8;
    const glm::uvec2 low{std::max(pixel.x, reach) - reach, std::max(pixel.y, reach) - reach};
    const glm::uvec2 high{std::min(pixel.x + reach + 1, s.size.x), std::min(pixel.y + reach + 1, s.size.y)};
    std::vector<glm::vec3> colors;
    for (std::uint32_t y = low.y; y < high.y; ++y)
        for (std::uint32_t x = low.x; x < high.x; ++x) colors.push_back(s.pixel({x, y}));
    const auto pair = [](glm::uvec2 v) { return '[' + std::to_string(v.x) + ',' + std::to_string(v.y) + ']'; };
    return json::object({{"size", pair(high - low)}, {"at", pair(pixel - low)}, {"colors", json::list(colors, [](glm::vec3 c) { return json::of(c); })}});
}

/// One pixel: all its samples; and whether it is the same when it is looked at again, as it should be.
inline std::string pixel_of(const subject& s, glm::uvec2 pixel) {
    const glm::vec3 color = s.pixel(pixel);
    const world w = s.world_at ? s.world_at(pixel) : s.world;
    catalogue figures(w);
    lantern::accumulator sum;
    std::vector<std::string> samples;
    const std::uint32_t count = s.samples_at ? s.samples_at(pixel) : s.samples;
    for (std::uint32_t i = 0; i < count; ++i) {
        glm::vec3 one(0);
        samples.push_back(explained(s, w, pixel, i, figures, one));
        sum.add(one);
    }
    return json::object({{"color", json::of(color)}, {"again", json::of(sum.mean())}, {"around", neighbours_of(s, pixel)}, {"eye", json::of(w.eye)}, {"beyond", json::of(w.beyond)},
                         {"samples", json::list(samples, [](const std::string& one) { return one; })}, {"surfaces", figures.write()},
                         {"floor", w.floor ? json::of(double(*w.floor)) : "null"},
                         {"lamps", json::list(w.lamps, [](const world::lamp& l) { return json::object({{"shape", of(l.shape)}, {"name", json::of(l.name)}}); })}});
}

/// Every pixel's cost, row by row: rays, boxes, tests.
inline std::string heat_of(const subject& s) {
    std::vector<cost> all(std::size_t{s.size.x} * s.size.y);
    lantern::in_parallel(s.size.y, 0, [&](std::size_t y) {
        for (std::uint32_t x = 0; x < s.size.x; ++x) {
            recorder counts(true);
            (void)heard(counts, [&] { return s.pixel({x, std::uint32_t(y)}); });
            all[y * s.size.x + x] = counts.counted();
        }
    });
    const auto column = [&](std::uint32_t cost::*which) { return json::list(all, [&](const cost& c) { return std::to_string(c.*which); }); };
    return json::object({{"samples", std::to_string(s.samples)}, {"rays", column(&cost::rays)}, {"boxes", column(&cost::boxes)}, {"tests", column(&cost::tests)},
                         {"levels", s.levels ? s.levels() : "null"}});
}

/// Every so many-th pixel's colour, for the tests.
inline std::string colors_of(const subject& s, std::size_t every) {
    std::string text = "[";
    for (std::size_t i = 0; i < std::size_t{s.size.x} * s.size.y; i += every)
        text += (i > 0 ? "," : "") + json::of(s.pixel({std::uint32_t(i % s.size.x), std::uint32_t(i / s.size.x)}));
    return text + ']';
}

inline std::string answer(const std::vector<std::string>& words, const std::vector<subject>& all) {
    if (words.at(0) == "list")
        return json::list(all, [](const subject& s) {
            return json::object({{"name", json::of(s.name)}, {"width", std::to_string(s.size.x)}, {"height", std::to_string(s.size.y)}});
        });
    const auto at = std::ranges::find(all, words.at(1), &subject::name);
    if (at == all.end()) throw std::invalid_argument("no picture " + words[1]);
    if (at->ready) at->ready();
    if (words[0] == "heat") return heat_of(*at);
    const auto number = [&](std::size_t i) { return std::uint32_t(std::stoul(words.at(i))); };
    if (words[0] == "colors") return colors_of(*at, number(2));
    const glm::uvec2 pixel{number(2), number(3)};
    if (pixel.x >= at->size.x || pixel.y >= at->size.y) throw std::invalid_argument("no such pixel");
    return pixel_of(*at, pixel);
}

}  // namespace explaining

/// The whole of `main`: list, pixel NAME X Y, heat NAME, colors NAME EVERY; and, last, the file that the answer is written to. (What is
/// printed may be the student's.) When something is still to be written, the answer says what.
inline int explain(int argc, char** argv, const std::function<std::vector<subject>()>& subjects) try {
    std::vector<std::string> words(argv + 1, argv + argc);
    if (words.size() < 2) throw std::invalid_argument("called by ./lab explain and ./lab heat");
    const std::filesystem::path path = words.back();
    words.pop_back();
    std::string text;
    try {
        text = json::object({{"answer", explaining::answer(words, subjects())}});
    } catch (const lantern::unfinished& gap) {
        text = json::object({{"gap", json::of(gap.what())}});
    }
    std::ofstream out(path, std::ios::binary);
    out << text << std::flush;
    if (!out) throw std::runtime_error("cannot write " + path.string());
    return 0;
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}

}  // namespace support
