// SPDX-License-Identifier: MIT
#pragma once
// Lab 15's pictures: the program shows them with the student's code, the handout with ours.

#include "../support/test_card.hpp"
#include "parts.hpp"
#include "scene.hpp"

#include <lab15_tracer/tracer.hpp>

#include <lantern/aabb.hpp>
#include <lantern/any_of.hpp>
#include <lantern/boxes_of.hpp>
#include <lantern/camera.hpp>
#include <lantern/closest.hpp>
#include <lantern/coated.hpp>
#include <lantern/convergence.hpp>
#include <lantern/diffuse.hpp>
#include <lantern/emissive.hpp>
#include <lantern/glossy.hpp>
#include <lantern/image.hpp>
#include <lantern/material.hpp>
#include <lantern/mirror.hpp>
#include <lantern/object.hpp>
#include <lantern/rectangle_light.hpp>
#include <lantern/render.hpp>
#include <lantern/samples.hpp>
#include <lantern/save.hpp>
#include <lantern/sobol.hpp>
#include <lantern/sphere.hpp>
#include <lantern/surface.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pictures {

using glm::vec2;
using glm::vec3;
using my = parts::yours;

inline const vec3 paper(0.9f), ink(0.02f), blue(0.03f, 0.2f, 0.65f), red(0.7f, 0.05f, 0.03f);

/// Puts a picture into another one.
inline void paste(lantern::image& page, const lantern::image& part, glm::uvec2 corner) {
    for (unsigned y = 0; y < part.size().y; ++y) std::ranges::copy(part.row(y), page.row(corner.y + y).begin() + corner.x);
}

/// A row of balls on squares, in the library's shapes, as it looks along a ray: for what needs no ray tracer yet.
struct row_of_balls {
    std::vector<lantern::sphere> balls{{{-1.6f, 0.5f, 1}, 0.5f}, {{-0.4f, 0.5f, -1}, 0.5f}, {{0.8f, 0.5f, -3}, 0.5f}, {{2.0f, 0.5f, -5}, 0.5f}};

    [[nodiscard]] vec3 operator()(const lantern::ray& r) const {
        static constexpr std::array<vec3, 4> colors{vec3{0.8f, 0.1f, 0.06f}, {0.85f, 0.6f, 0.1f}, {0.15f, 0.5f, 0.15f}, {0.1f, 0.25f, 0.75f}};
        const vec3 up = glm::normalize(vec3(-1, 2, 1.5f));
        if (const auto h = lantern::closest(lantern::every{4}, balls, r)) return colors[h->index] * (0.25f + 0.75f * std::max(0.0f, glm::dot(h->normal, up)));
        if (!(r.direction.y < 0)) return {0.55f, 0.65f, 0.8f};
        const vec3 p = at(r, -r.origin.y / r.direction.y);
        return vec3((std::lround(std::floor(p.x)) + std::lround(std::floor(p.z))) % 2 == 0 ? 0.7f : 0.3f);
    }
};

// ---- Step 1: your camera -------------------------------------------------------------------------------------------

/// The row without a lens, and with one.
inline lantern::image cameras(glm::uvec2 size = {310, 200}, std::uint32_t samples = 64) {
    const auto seat = mine::camera_at<my>({.eye = {-1, 1.6f, 6}, .target = {0.2f, 0.4f, -1.5f}, .vertical_fov = 0.55f, .aspect = float(size.x) / float(size.y)}, {0.18f, 7.0f}, {});
    const auto shade = [row = row_of_balls{}](const lantern::ray& r, const auto&) { return row(r); };
    lantern::image page({2 * size.x + 8, size.y}, paper);
    paste(page, lantern::render(size, lab15::with<lab15::pinhole, lab15::instant>(seat), lantern::sobol{.samples = samples}, shade), {0, 0});
    paste(page, lantern::render(size, lab15::with<lab15::lens, lab15::instant>(seat), lantern::sobol{.samples = samples}, shade), {size.x + 8, 0});
    return page;
}

// ---- Step 2: your samples ------------------------------------------------------------------------------------------

/// 64 samples of a pixel: where on the lens; where on the lamp; and the one against the other, which must show no pattern.
inline lantern::image samples() {
    constexpr unsigned side = 200, gap = 10;
    lantern::image page({3 * side + 4 * gap, side + 2 * gap}, paper);
    const lab15::sampler<my> numbers{8, 1};
    for (unsigned plot = 0; plot < 3; ++plot)
        for (unsigned y = 0; y < side; ++y)
            for (unsigned x = 0; x < side; ++x) page(gap + plot * (side + gap) + x, gap + y) = vec3(x % 25 == 0 || y % 25 == 0 ? 0.75f : 1.0f);
    const auto dot = [&](unsigned plot, vec2 at, vec3 color) {
        for (int y = -2; y <= 2; ++y)
            for (int x = -2; x <= 2; ++x) {
                const glm::ivec2 p = glm::clamp(glm::ivec2(at * float(side)) + glm::ivec2(x, y), glm::ivec2(0), glm::ivec2(side - 1));
                page(gap + plot * (side + gap) + unsigned(p.x), gap + unsigned(p.y)) = color;
            }
    };
    for (std::uint32_t i = 0; i < numbers.count(); ++i) {
        const auto source = numbers.at({3, 4}, i);
        const vec2 lens = source.draw2(lantern::purpose::lens), light = source.draw2(lantern::purpose::light);
        dot(0, lens, blue);
        dot(1, light, red);
        dot(2, {lens.x, light.x}, ink);
    }
    return page;
}

// ---- Step 3: your lamp ---------------------------------------------------------------------------------------------

/// The ground under a lamp, with a ball and a stick between, from above.
inline lantern::image lamp(glm::uvec2 size = {480, 240}, std::uint32_t count = 64) {
    const lab15::lamp<my> above{{{-0.4f, 2, -0.4f}, {0.8f, 0, 0}, {0, 0, 0.8f}}, vec3(12)};
    const std::vector<lantern::sphere> balls{{{-0.9f, 0.6f, 0}, 0.35f}, {{0.5f, 0.15f, 0.2f}, 0.15f}, {{1.0f, 0.9f, -0.3f}, 0.2f}};
    lantern::image page(size);
    const lantern::sobol samples{.samples = count};
    lantern::in_parallel(size.y, 0, [&](std::size_t y) {
        for (unsigned x = 0; x < size.x; ++x) {
            const vec2 film = (vec2(x, y) + 0.5f) / vec2(size);
            const lantern::hit floor{.t = 1, .point = {4 * film.x - 2, 0, 2 * film.y - 1}, .normal = {0, 1, 0}};
            vec3 sum(0);
            for (std::uint32_t i = 0; i < count; ++i) {
                const auto light = illuminate(above, floor.point, samples.at({x, y}, i).draw2(lantern::purpose::light));
                const vec3 way = light.position - floor.point, from = lantern::leave(floor, way);
                if (!lantern::occluded(lantern::every{3}, balls, lantern::ray{from, light.position - from}, {0, 1})) sum += glm::normalize(way).y * light.irradiance;
            }
            page(x, unsigned(y)) = vec3(0.45f, 0.42f, 0.36f) * (sum / float(count) / 3.14159f + 0.05f);
        }
    });
    return page;
}

// ---- Step 4: your gloss --------------------------------------------------------------------------------------------

/// Four balls, sharp and wider and wider, in a room of stripes.
inline lantern::image gloss(glm::uvec2 size = {640, 160}, std::uint32_t count = 64) {
    const auto room = [](vec3 d) {
        if (d.y > 0.75f) return vec3(2.2f, 2.1f, 1.9f);
        const bool stripe = std::lround(std::floor(std::atan2(d.x, d.z) * 4)) % 2 == 0;
        return (d.y < -0.3f ? vec3(0.25f, 0.2f, 0.15f) : vec3(0.35f, 0.45f, 0.6f)) * (stripe ? 1.6f : 0.5f);
    };
    lantern::image page(size, vec3(0.1f));
    const lantern::sobol samples{.samples = count};
    lantern::in_parallel(size.y, 0, [&](std::size_t y) {
        for (unsigned x = 0; x < size.x; ++x) {
            const unsigned k = x * 4 / size.x;
            vec3 sum(0);
            for (std::uint32_t i = 0; i < count; ++i) {
                const auto source = samples.at({x, y}, i);
                const vec2 p = ((vec2(x, y) + source.draw2(lantern::purpose::film)) / float(size.y) - vec2(0.5f + float(k), 0.5f)) * vec2(2.2f, -2.2f);
                const float depth = 1 - glm::dot(p, p);
                if (!(depth > 0)) {
                    sum += vec3(0.1f);
                    continue;
                }
                const lantern::hit h{.t = 1, .point = {p, std::sqrt(depth)}, .normal = glm::normalize(vec3(p, std::sqrt(depth)))};
                const vec3 in(0, 0, -1);
                const lantern::bounces sent = k == 0 ? scatter(lab15::gloss<my>{vec3(0.9f, 0.8f, 0.6f)}, in, h)
                                                     : scatter(lab15::gloss<my, lab15::blurred>{vec3(0.9f, 0.8f, 0.6f), {0.2f * float(k * k)}}, in, h, source.draw2(lantern::purpose::gloss));
                sum += sent[0].weight * room(sent[0].direction);
            }
            page(x, unsigned(y)) = sum / float(count);
        }
    });
    return page;
}

// ---- Step 5: your balls --------------------------------------------------------------------------------------------

/// Balls in flight, each with its box of the whole exposure.
inline lantern::image balls(glm::uvec2 size = {480, 240}, std::uint32_t count = 64) {
    using moving = lab15::ball<my, lab15::drift>;
    const std::vector<moving> all{{{-1.4f, 0.3f, 0}, 0.4f, {{0, 0, 0}}}, {{-0.2f, -0.5f, 0}, 0.3f, {{0.3f, 0.9f, 0}}}, {{1.7f, -0.4f, 0}, 0.25f, {{-1.1f, 0.2f, 0}}}};
    const std::vector<lantern::aabb> boxes = lantern::boxes_of(all);
    lantern::image page(size);
    const lantern::sobol samples{.samples = count};
    lantern::in_parallel(size.y, 0, [&](std::size_t y) {
        for (unsigned x = 0; x < size.x; ++x) {
            vec3 sum(0);
            vec2 p(0);
            for (std::uint32_t i = 0; i < count; ++i) {
                const auto source = samples.at({x, y}, i);
                p = ((vec2(x, y) + source.draw2(lantern::purpose::film)) / float(size.y) - vec2(1, 0.5f)) * vec2(2.2f, -2.2f);
                const auto h = lantern::closest(lantern::every{3}, all, lantern::timed_ray{{vec3(p, 5), vec3(0, 0, -1)}, source.draw1(lantern::purpose::time)});
                sum += h ? vec3(0.15f, 0.35f, 0.8f) * (0.2f + 0.8f * std::max(0.0f, glm::dot(h->normal, vec3(-0.4f, 0.7f, 0.6f)))) : vec3(0.8f);
            }
            page(x, unsigned(y)) = sum / float(count);
            for (const lantern::aabb& box : boxes) {
                const vec2 out = glm::max(vec2(box.min) - p, p - vec2(box.max));
                if (std::abs(std::max(out.x, out.y)) < 1.1f / float(size.y)) page(x, unsigned(y)) = red;
            }
        }
    });
    return page;
}

// ---- Step 6: your ray tracer ---------------------------------------------------------------------------------------

/// Glass by your lab 03.
struct clear {
    float index = 1.5f;
};
[[nodiscard]] inline lantern::bounces scatter(const clear& m, vec3 in, const lantern::hit& h) {
    const vec3 front = lantern::facing(h.normal, in);
    const lantern::bounce mirrored{lantern::mirrored(in, front), vec3(1)};
    const auto bent = my::refracted(in, front, glm::dot(in, h.normal) < 0 ? 1 / m.index : m.index);
    if (!bent) return mirrored;
    return {lantern::bounce{mirrored.direction, vec3(bent->second)}, lantern::bounce{bent->first, vec3(1 - bent->second)}};
}

/// A still life of the library's parts, but for the tracer and the glass.
inline lantern::image still_life(glm::uvec2 size = {480, 300}, std::uint32_t samples = 36) {
    using namespace lantern;
    using thing = object<any_of<sphere, rectangle>, std::variant<coated<diffuse, glossy>, clear, emissive>>;
    const rectangle_light above{{-1.5f, 5, -1}, {2, 0, 0}, {0, 0, 2}, vec3(11, 10, 9)};
    const auto matt = [](vec3 color, float width, float share) { return coated{diffuse{color}, glossy{vec3(1), width}, share}; };
    const std::vector<thing> things{
        {rectangle{{-30, 0, 30}, {60, 0, 0}, {0, 0, -60}}, matt({0.4f, 0.36f, 0.3f}, 0.2f, 0.25f)},
        {sphere{{-1.1f, 0.8f, -0.6f}, 0.8f}, matt({0.7f, 0.08f, 0.05f}, 0, 0.1f)},
        {sphere{{0.9f, 0.7f, 0}, 0.7f}, clear{}},
        {sphere{{0.1f, 0.35f, 1.1f}, 0.35f}, matt({0.2f, 0.4f, 0.7f}, 0.3f, 0.3f)},
        {sphere{{2.2f, 0.5f, -1.6f}, 0.5f}, matt({0.8f, 0.6f, 0.1f}, 0, 0.15f)},
        {surface_of(above), emissive{above.radiance}},
    };
    const std::vector<rectangle_light> lamps{above};
    const every all{std::uint32_t(things.size())};
    const lab15::world<every, thing, rectangle_light> w{&all, things, lamps, {.horizon = {0.5f, 0.55f, 0.65f}, .zenith = {0.1f, 0.2f, 0.4f}}, vec3(0.1f)};
    const camera cam{view{.eye = {0, 2, 7.5f}, .target = {0.2f, 0.7f, 0}, .vertical_fov = 0.5f, .aspect = float(size.x) / float(size.y)}};
    return render(size, cam, sobol{.samples = samples}, [&](const ray& r, const auto& source) { return radiance(w, r, source, 8); });
}

// ---- Step 7: your tree ---------------------------------------------------------------------------------------------

/// How many of the scene's things a ray is offered with your tree: black is none, white eight and more. Pink: brute force finds another hit.
inline lantern::image questions(glm::uvec2 size = mine::size) {
    const auto s = mine::lanterns<my>();
    const auto still = lab15::with<lab15::still, lab15::sharp>(s.things);
    const auto cam = lab15::with<lab15::pinhole, lab15::instant>(s.from);
    const std::vector<lantern::aabb> boxes = lantern::boxes_of(s.things);
    const lab15::hierarchy<my> tree(boxes);
    const lantern::every all{std::uint32_t(still.size())};
    lantern::image page(size);
    std::uint64_t offers = 0;
    for (unsigned y = 0; y < size.y; ++y)
        for (unsigned x = 0; x < size.x; ++x) {
            const lantern::ray r = shoot(cam, (vec2(x, y) + 0.5f) / vec2(size), lantern::sobol{}.at({x, y}, 0));
            lantern::probe asked;
            const auto one = lantern::closest(all, still, r), other = lantern::closest(tree, still, r, {}, asked);
            const bool same = one.has_value() == other.has_value() && (!one || (one->index == other->index && one->t == other->t));
            page(x, y) = same ? vec3(float(asked.offers) / 8) : vec3(1, 0, 1);
            offers += asked.offers;
        }
    std::printf("a ray is offered %zu things without a tree, %.2f with yours\n", still.size(), double(offers) / (double(size.x) * double(size.y)));
    return page;
}

// ---- Step 8: your scene --------------------------------------------------------------------------------------------

/// A source that counts what is drawn through it.
template <class Source>
struct counting {
    Source source;
    std::uint64_t* numbers;

    [[nodiscard]] float draw1(lantern::purpose p, std::uint32_t which = 0) const { return *numbers += 1, source.draw1(p, which); }
    [[nodiscard]] vec2 draw2(lantern::purpose p, std::uint32_t which = 0) const { return *numbers += 2, source.draw2(p, which); }
    [[nodiscard]] counting branch(std::uint32_t k) const { return {source.branch(k), numbers}; }
};

/// A picture, and what it took.
struct taken {
    lantern::image picture{{1, 1}};
    std::size_t bytes = 0;  ///< of the things
    double numbers = 0;     ///< drawn for a sample
    double seconds = 0;     ///< of the processor
};

/// The scene, seen with all of your parts.
template <class Things, class Camera, lantern::sampler Sampler>
taken seen(const Things& things, const Camera& cam, const lab15::scene<my>& s, glm::uvec2 size, const Sampler& samples, unsigned threads = 0) {
    using thing = typename Things::value_type;
    const std::vector<lantern::aabb> boxes = lantern::boxes_of(things);
    const lab15::hierarchy<my> tree(boxes);
    const lab15::world<lab15::hierarchy<my>, thing, lab15::lamp<my>> w{&tree, things, s.lamps, mine::dusk, mine::ambient};
    const auto shade = [&](const auto& r, const auto& source) { return radiance(w, r, source, 6); };
    const std::clock_t start = std::clock();
    taken t{.picture = lantern::render(size, cam, samples, shade, {.threads = threads, .tile = 8, .progress = {}}), .bytes = things.size() * sizeof(thing)};
    t.seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
    return t;
}

/// What is drawn for a sample of it, on average over every fourth pixel.
template <class Things, class Camera>
double numbers_drawn(const Things& things, const Camera& cam, const lab15::scene<my>& s, glm::uvec2 size) {
    const lantern::every all{std::uint32_t(things.size())};
    const lab15::world<lantern::every, typename Things::value_type, lab15::lamp<my>> w{&all, things, s.lamps, mine::dusk, mine::ambient};
    std::uint64_t drawn = 0, pixels = 0;
    for (unsigned y = 0; y < size.y; y += 2)
        for (unsigned x = 0; x < size.x; x += 2, ++pixels) {
            const counting<lab15::numbers<my>> source{{1, {x, y}, 0, 1}, &drawn};
            (void)radiance(w, shoot(cam, (vec2(x, y) + 0.5f) / vec2(size), source), source, 6);
        }
    return double(drawn) / double(pixels);
}

inline lantern::image yours(glm::uvec2 size = mine::size, std::uint32_t side = 5) {
    const auto s = mine::lanterns<my>();
    return lab15::leave_out(s, [&](const auto& things, const auto& cam) { return seen(things, cam, s, size, lab15::sampler<my>{side, 1}).picture; });
}

/// Who made what of it.
inline void tell_parts() {
    const auto tell = [](const char* what, bool own, const char* lab) { std::printf("%-12s %s lab %s%s\n", what, own ? "yours, of" : "the library's, since", lab, own ? "" : " is still to do"); };
    std::printf("the parts of the pictures:\n");
    tell("file", my::lab01(), "01");
    tell("glass", my::lab03(), "03");
    tell("points", my::lab04(), "04");
    tell("order", my::lab13(), "13");
    tell("lamps", my::lab05(), "05");
    tell("gloss", my::lab06(), "06");
    tell("lens", my::lab07(), "07");
    tell("balls, time", my::lab08(), "08");
    tell("tree", my::lab10(), "10");
}

/// The proof: the scene and what becomes of it when effects are taken away, in the largest types and in the smallest.
inline void tell_what_is_left_out() {
    constexpr glm::uvec2 size{64, 40};
    std::printf("\n%-22s %16s %18s %10s  %s\n", "", "numbers a sample", "bytes of the things", "time", "picture");
    for (const char* name : {"as it is", "no lens", "nothing moves", "nothing is blurred", "none of these"}) {
        auto s = mine::lanterns<my>();
        const std::string_view less(name);
        const bool none = less == "none of these";
        if (none || less == "no lens") s.from.optics.radius = 0;
        for (auto& each : s.things) {
            if (auto* b = std::get_if<lab15::ball<my, lab15::drift>>(&each.shape.value); b && (none || less == "nothing moves")) b->motion.velocity = vec3(0);
            if (auto* c = std::get_if<0>(&each.material); c && (none || less == "nothing is blurred")) c->coat.blur.width = 0;
        }
        const auto look = [&](const auto& things, const auto& cam) {
            taken t = seen(things, cam, s, size, lab15::sampler<my>{2, 1}, 1);
            for (int again = 0; again < 4; ++again) t.seconds = std::min(t.seconds, seen(things, cam, s, size, lab15::sampler<my>{2, 1}, 1).seconds);
            t.numbers = numbers_drawn(things, cam, s, size);
            return t;
        };
        const taken whole = look(s.things, s.from), less_of_it = lab15::leave_out(s, look);
        std::printf("%-22s %7.2f -> %5.2f %9zu -> %6zu %9.0f%%  %s\n", name, whole.numbers, less_of_it.numbers, whole.bytes, less_of_it.bytes,
                    100 * less_of_it.seconds / whole.seconds, whole.picture == less_of_it.picture ? "equal to the last bit" : "ANOTHER ONE");
    }
}

/// The picture, as a PPM too: by your lab 01, if you have one.
inline lantern::image assembled(const std::filesystem::path& folder) {
    lantern::image picture = yours();
    if (my::lab01()) lantern::save(folder / "lab15_8_yours.ppm", [&](std::ostream& out) { out << my::ppm(picture); });
    tell_parts();
    tell_what_is_left_out();
    return picture;
}

// ---- How good it is ------------------------------------------------------------------------------------------------

/// The error against the number of samples: yours blue, random numbers red, and the lines of N^(-1/2) and N^(-3/4). No exact picture is known; but
/// two renderings of other seeds are apart by √2 times their RMSE.
inline lantern::image errors(glm::uvec2 size = {32, 20}, std::uint32_t trials = 3) {
    const auto s = mine::lanterns<my>();
    constexpr std::array<std::uint32_t, 4> sides{2, 4, 8, 16};
    const auto rmse = [&](const auto& sampler_of) {
        std::vector<double> result;
        for (const std::uint32_t side : sides) {
            std::vector<lantern::image> all;
            for (std::uint64_t seed = 1; seed <= trials; ++seed) all.push_back(seen(s.things, s.from, s, size, sampler_of(side, seed)).picture);
            double sum = 0, pairs = 0;
            for (std::size_t i = 0; i < all.size(); ++i)
                for (std::size_t k = 0; k < i; ++k, ++pairs) sum += lantern::difference(all[i], all[k]).mean_square / 2;
            result.push_back(std::sqrt(sum / pairs));
        }
        return result;
    };
    const std::vector<double> own = rmse([](std::uint32_t side, std::uint64_t seed) { return lab15::sampler<my>{side, seed}; });
    const std::vector<double> chance = rmse([](std::uint32_t side, std::uint64_t seed) { return lantern::independent{.samples = side * side, .seed = seed}; });

    lantern::image page({480, 300}, paper);
    const auto place = [&](double samples, double error) {
        return vec2(float((std::log10(samples) - 0.4) / 2.3), float((0.3 - std::log10(error / own[0])) / 2.2)) * vec2(page.size());
    };
    const auto dot = [&](vec2 p, vec3 color, float radius) {
        for (float y = -radius; y <= radius; ++y)
            for (float x = -radius; x <= radius; ++x) {
                const glm::ivec2 q(p + vec2(x, y));
                if (q.x >= 0 && q.y >= 0 && q.x < int(page.size().x) && q.y < int(page.size().y)) page(unsigned(q.x), unsigned(q.y)) = color;
            }
    };
    const auto line = [&](double n0, double e0, double n1, double e1, vec3 color) {
        for (int k = 0; k <= 1000; ++k) dot(glm::mix(place(n0, e0), place(n1, e1), float(k) / 1000), color, 0);
    };
    for (const double n : {4, 16, 64, 256}) line(n, 10 * own[0], n, own[0] / 1000, vec3(0.7f));
    for (const double slope : {-0.5, -0.75}) line(4, own[0], 256, own[0] * std::pow(64, slope), vec3(0.45f));
    std::vector<std::uint32_t> counts;
    std::printf("\n%8s %12s %12s\n", "samples", "RMSE, yours", "random");
    for (std::size_t i = 0; i < sides.size(); ++i) {
        counts.push_back(sides[i] * sides[i]);
        if (i > 0) line(counts[i - 1], own[i - 1], counts[i], own[i], blue), line(counts[i - 1], chance[i - 1], counts[i], chance[i], red);
        dot(place(counts[i], own[i]), blue, 3);
        dot(place(counts[i], chance[i]), red, 3);
        std::printf("%8u %12.5f %12.5f\n", counts[i], own[i], chance[i]);
    }
    std::printf("slope    %12.2f %12.2f   (-0.50: chance, and all that depends on several purposes at once; -0.75: an edge, of one purpose)\n",
                my::slope(counts, own), my::slope(counts, chance));
    return page;
}

}  // namespace pictures
