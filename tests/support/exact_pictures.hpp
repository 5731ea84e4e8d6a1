// SPDX-License-Identifier: MIT
#pragma once
// Pictures of one effect each, and one of two, of which every pixel is known in closed form: to measure how fast rendering comes there.

#include "exact_scenes.hpp"
#include "replayed.hpp"

#include <lantern/convergence.hpp>
#include <lantern/exact.hpp>
#include <lantern/exact_light.hpp>
#include <lantern/halton.hpp>
#include <lantern/image.hpp>
#include <lantern/sobol.hpp>
#include <lantern/validate.hpp>
#include <lantern/warp.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace exact_pictures {

namespace exact = lantern::exact;
using lantern::image;

// ---- by which samples -------------------------------------------------------------------------------------------------

inline constexpr std::array<std::string_view, 7> samplers{"random",    "N-rooks", "jittered", "multi-jittered", "correlated multi-jittered",
                                                          "Halton",    "Sobol"};

/// Calls use(sampler) with the one that is named: `count` samples a pixel. Refuses other names.
template <class Use>
auto with_sampler(std::string_view name, std::uint32_t count, std::uint64_t seed, const Use& use) {
    if (name == "random") return use(lantern::independent{count, seed});
    if (name == "N-rooks") return use(lantern::n_rooks{count, seed});
    if (name == "jittered") return use(lantern::jittered::of(count, seed));
    if (name == "multi-jittered") return use(lantern::multi_jittered::of(count, seed));
    if (name == "correlated multi-jittered") return use(lantern::correlated_multi_jittered{count, seed});
    if (name == "Halton") return use(lantern::halton{count, seed});
    if (name == "Sobol") return use(lantern::sobol{.samples = count, .seed = seed});
    lantern::refuse("sampler", "'" + std::string(name) + "'", "random, N-rooks, jittered, multi-jittered, correlated multi-jittered, Halton or Sobol");
}

// ---- what is known of a pixel -----------------------------------------------------------------------------------------

/// Its value; the variance of one sample; and the mean square error of side² jittered samples.
struct pixel {
    double value = 0, variance = 0;
    std::function<double(std::uint32_t side)> jittered;
};

/// A pixel that a sample finds white or black: white in the fraction p of all, and in p of cell (i, j) of a side × side grid.
[[nodiscard]] inline pixel black_and_white(std::function<double(std::uint32_t side, std::uint32_t i, std::uint32_t j)> p) {
    const double all = p(1, 0, 0);
    return {all, all * (1 - all), [p](std::uint32_t side) {
                const double error = exact::jittered_rmse(side, [&](std::uint32_t i, std::uint32_t j) { return p(side, i, j); });
                return error * error;
            }};
}

/// By one of our samplers, and with points that are there already.
struct renderings {
    std::function<image(std::string_view sampler, std::uint32_t count, std::uint64_t seed, unsigned threads)> by_name;
    std::function<image(const point_table&, unsigned threads)> by_table;
};

struct picture {
    std::string name;    ///< the effect
    std::string tells;   ///< what there is to see
    std::vector<lantern::purpose> purposes;  ///< what its samples draw numbers for
    std::uint32_t dimensions = 2;            ///< how many numbers that are
    double theory_jittered = -0.75;  ///< the slope of RMSE that jittered samples must come to
    glm::uvec2 size{1};
    std::vector<pixel> pixels;
    renderings render;

    [[nodiscard]] image exactly() const {
        image all(size);
        for (std::size_t i = 0; i < pixels.size(); ++i) all.pixels()[i] = glm::vec3(float(pixels[i].value));
        return all;
    }

    /// The RMSE that theory gives, over the whole picture; nothing for samplers that it does not know.
    [[nodiscard]] std::optional<double> predicted(std::string_view sampler, std::uint32_t count) const {
        const auto side = static_cast<std::uint32_t>(std::lround(std::sqrt(count)));
        const bool jittered = sampler == "jittered" && side * side == count;
        if (!jittered && sampler != "random") return {};
        double sum = 0;
        for (const pixel& p : pixels) sum += jittered ? p.jittered(side) : p.variance / count;
        return std::sqrt(sum / double(pixels.size()));
    }
};

namespace detail {

template <class Shape, class Paint, class Light, class Camera, class Filter>
[[nodiscard]] auto renderer(glm::uvec2 size, std::vector<lantern::object<Shape, Paint>> things, std::vector<Light> lights, Camera cam,
                            Filter filter) {
    const auto with = [=](const auto& samples, unsigned threads) {
        const lantern::every structure{std::uint32_t(things.size())};
        const lantern::distribution tracer{structure, things, lights};
        return lantern::render(size, cam, samples, tracer, {.threads = threads}, filter);
    };
    return renderings{[=](std::string_view sampler, std::uint32_t count, std::uint64_t seed, unsigned threads) {
                          return with_sampler(sampler, count, seed, [&](const auto& samples) { return with(samples, threads); });
                      },
                      [=](const point_table& table, unsigned threads) { return with(replayed{&table}, threads); }};
}

/// A row of white stripes on black, in one plane: from edges[0] to edges[1], from edges[2] to edges[3] and so on, all of
/// `length` to either side.
struct stripes {
    glm::dvec3 origin, across, along;
    double length = 60;
    std::vector<double> edges;

    [[nodiscard]] exact::edge edge(std::size_t k, glm::dvec3 apex) const {
        const glm::dvec3 at = origin + edges[k] * across;
        return exact_scenes::detail::towards({at, along}, apex, at + across);
    }
    /// Σ ± what is seen past each edge.
    [[nodiscard]] double sum(const auto& past) const {
        double total = 0;
        for (std::size_t k = 0; k < edges.size(); ++k) total += k % 2 == 0 ? past(k) : -past(k);
        return total;
    }
    [[nodiscard]] std::vector<lantern::rectangle> rectangles() const {
        std::vector<lantern::rectangle> all;
        for (std::size_t k = 0; k + 1 < edges.size(); k += 2)
            all.push_back({glm::vec3(origin + edges[k] * across - length * along), glm::vec3((edges[k + 1] - edges[k]) * across),
                           glm::vec3(2 * length * along)});
        return all;
    }
};

/// The fraction of the cell (i, j) that lies in the half-plane.
[[nodiscard]] inline double in_cell(exact::half_plane h, std::uint32_t side, std::uint32_t i, std::uint32_t j) {
    return exact::clipped_area({h.a + (i * h.b + j * h.c) / side, h.b / side, h.c / side});
}

/// The stripes through a parallelogram, seen from an apex.
[[nodiscard]] inline pixel through(const stripes& s, glm::dvec3 apex, const exact::parallelogram& sampled) {
    std::vector<exact::half_plane> past;
    for (std::size_t k = 0; k < s.edges.size(); ++k) past.push_back(exact::seen(apex, s.edge(k, apex), sampled));
    return black_and_white([s, past](std::uint32_t side, std::uint32_t i, std::uint32_t j) {
        return s.sum([&](std::size_t k) { return in_cell(past[k], side, i, j); });
    });
}

/// Calls make(middle of the pixel on the film, its corners' offset to it) for each pixel of a picture.
[[nodiscard]] inline std::vector<pixel> each_pixel(glm::uvec2 size, const auto& make) {
    std::vector<pixel> all;
    for (std::uint32_t y = 0; y < size.y; ++y)
        for (std::uint32_t x = 0; x < size.x; ++x) all.push_back(make((glm::vec2(x, y) + 0.5f) / glm::vec2(size)));
    return all;
}

[[nodiscard]] inline lantern::view looking(glm::vec3 eye, glm::vec3 target, glm::uvec2 size, float degrees) {
    return {.eye = eye, .target = target, .up = {0, 1, 0}, .vertical_fov = degrees * std::numbers::pi_v<float> / 180,
            .aspect = float(size.x) / float(size.y)};
}

inline const stripes floor_stripes{.origin = {0, 0, 0}, .across = {1, 0, 0}, .along = {0, 0, 1},
                                   .edges = {-2.9, -2.3, -1.8, -1.3, -0.85, -0.35, 0.1, 0.45, 1.1, 1.6, 2.1, 2.7, 3.3, 4.1}};

[[nodiscard]] inline std::vector<lantern::object<lantern::rectangle, lantern::emissive>> shining(const stripes& s) {
    std::vector<lantern::object<lantern::rectangle, lantern::emissive>> things;
    for (const lantern::rectangle& r : s.rectangles()) things.push_back({r, exact_scenes::detail::white});
    return things;
}

}  // namespace detail

/// Stripes that run away to the distance; each pixel is a mean over its area.
[[nodiscard]] inline picture antialiasing(glm::uvec2 size) {
    const lantern::view v = detail::looking({0.3f, 1, 0}, {0.6f, 0, -1.5f}, size, 38);
    const lantern::camera_frame frame(v);
    const glm::dvec3 a = 2 * frame.half_width / size.x * frame.right, b = -2 * frame.half_height / size.y * frame.up;
    return {"antialiasing", "Stripes on a floor, seen through pixels that have an area.", {lantern::purpose::film}, 2, -0.75, size,
            detail::each_pixel(size, [&](glm::vec2 film) {
                return detail::through(detail::floor_stripes, frame.eye, {frame.eye + frame.towards(film) - 0.5 * (a + b), a, b});
            }),
            detail::renderer(size, detail::shining(detail::floor_stripes), std::vector<lantern::point_light>{}, lantern::camera{v},
                             lantern::box_filter{})};
}

/// The same stripes, through a lens that is focused on the middle of them.
[[nodiscard]] inline picture depth_of_field(glm::uvec2 size) {
    const lantern::view v = detail::looking({0.3f, 1, 0}, {0.6f, 0, -1.5f}, size, 38);
    const lantern::camera_frame frame(v);
    const lantern::thin_lens lens{.radius = 0.12f, .focus_distance = 1.9f};
    const detail::stripes& s = detail::floor_stripes;
    const auto make = [&](glm::vec2 film) {
        const glm::dvec3 in_focus = frame.eye + double(lens.focus_distance) * frame.towards(film);
        const glm::dvec3 a = double(lens.radius) * frame.right, b = double(lens.radius) * frame.up;
        // Rays cross in the point in focus, if the floor lies behind it: then right is left.
        const bool crossed = in_focus.y > 0;
        const auto seen = [=](std::size_t k, const auto& aperture) {
            const double part = exact::visible(in_focus, s.edge(k, in_focus), aperture);
            return crossed ? 1 - part : part;
        };
        pixel p;
        p.value = s.sum([&](std::size_t k) { return seen(k, exact::disc{frame.eye, a, b}); });
        p.variance = p.value * (1 - p.value);
        p.jittered = [=](std::uint32_t side) {  // cells of the square, each made a piece of the disc
            const double error = exact_scenes::rmse_by_cells(side, [&](double x, double y) {
                const glm::dvec2 at = lantern::to_disk(glm::vec2(x, y));
                const glm::dvec3 from = frame.eye + at.x * a + at.y * b, way = in_focus - from;
                const double across = glm::dot(from + from.y / -way.y * way - s.origin, s.across);
                return s.sum([&](std::size_t k) { return across > s.edges[k] ? 1.0 : 0.0; });
            }, std::max(4u, 256 / side));
            return error * error;
        };
        return p;
    };
    return {"depth of field", "The same stripes through a lens: sharp where they cross the plane of focus.", {lantern::purpose::lens}, 2, -0.75, size,
            detail::each_pixel(size, make),
            detail::renderer(size, detail::shining(s), std::vector<lantern::point_light>{}, lantern::camera{v, lens},
                             exact_scenes::point_filter{})};
}

/// Stripes on a ceiling, seen in a floor that is a rough mirror.
[[nodiscard]] inline picture gloss(glm::uvec2 size) {
    const lantern::view v = detail::looking({0.2f, 1, 0.4f}, {0.4f, 0, -0.6f}, size, 30);
    const lantern::camera_frame frame(v);
    const float width = 0.3f;
    const detail::stripes s{.origin = {0, 1.5, 0}, .across = {0.8, 0, 0.6}, .along = {-0.6, 0, 0.8},
                            .edges = {-7, -5.5, -4.6, -3.9, -3.3, -2.7, -2.2, -1.7, -1.25, -0.85, -0.4, 0, 0.5, 1, 1.6, 2.3}};
    const auto make = [&](glm::vec2 film) {
        const glm::dvec3 way = frame.towards(film), at = frame.eye + frame.eye.y / -way.y * way;
        const lantern::basis b = lantern::basis_from(glm::vec3(glm::normalize(glm::dvec3(way.x, -way.y, way.z))));
        return detail::through(s, at, exact::glossy_square(at, glm::dvec3(b.w), glm::dvec3(b.u), glm::dvec3(b.v), double(width)));
    };
    using paint = std::variant<lantern::glossy, lantern::emissive>;
    std::vector<lantern::object<lantern::rectangle, paint>> things{
        {lantern::rectangle{{-9, 0, 9}, {18, 0, 0}, {0, 0, -18}}, lantern::glossy{.color = glm::vec3(1), .width = width}}};
    for (const lantern::rectangle& r : s.rectangles()) things.push_back({r, exact_scenes::detail::white});
    return {"gloss", "Stripes on a ceiling, in a floor that is a rough mirror.", {lantern::purpose::gloss}, 2, -0.75, size,
            detail::each_pixel(size, make),
            detail::renderer(size, things, std::vector<lantern::point_light>{}, lantern::camera{v}, exact_scenes::point_filter{})};
}

/// The shadow of a blind under a rectangular lamp.
[[nodiscard]] inline picture soft_shadow(glm::uvec2 size) {
    const lantern::view v = detail::looking({0.1f, 0.8f, 1.4f}, {0, 0, 0.1f}, size, 44);
    const lantern::camera_frame frame(v);
    const double albedo = 0.75, radiance = 60;
    const exact::parallelogram lamp{{-0.3, 2.4, -0.3}, {0.5, 0, 0.1}, {-0.1, 0.1, 0.5}};
    const detail::stripes slats{.origin = {0, 0.9, 0}, .across = {0.8, 0, 0.6}, .along = {-0.6, 0, 0.8}, .length = 8,
                                .edges = {-1.3, -1, -0.7, -0.5, -0.25, -0.1, 0.15, 0.35, 0.6, 0.9}};
    const glm::dvec3 normal(0, 1, 0), area = glm::cross(lamp.a, lamp.b);
    const double factor = albedo / std::numbers::pi * radiance;
    const auto make = [&](glm::vec2 film) {
        const glm::dvec3 way = frame.towards(film), at = frame.eye + frame.eye.y / -way.y * way;
        const exact::polygon whole = exact::corners(lamp);
        pixel p;
        p.value = factor * (exact::irradiance(at, normal, whole) -
                            slats.sum([&](std::size_t k) { return exact::penumbra(at, normal, slats.edge(k, at), lamp); }));
        const auto sample = [=](double x, double y) {
            const glm::dvec3 w = lamp.corner + x * lamp.a + y * lamp.b - at;
            const double across = glm::dot(at + (slats.origin.y - at.y) / w.y * w - slats.origin, slats.across);
            const double hidden = slats.sum([&](std::size_t k) { return across > slats.edges[k] ? 1.0 : 0.0; });
            const double d2 = glm::dot(w, w);
            return hidden > 0 ? 0 : factor * glm::dot(normal, w) * std::abs(glm::dot(area, w)) / (d2 * d2);
        };
        const double spread = exact_scenes::rmse_by_cells(1, sample, 128);
        p.variance = spread * spread;
        p.jittered = [=](std::uint32_t side) {
            const double error = exact_scenes::rmse_by_cells(side, sample, std::max(4u, 256 / side));
            return error * error;
        };
        return p;
    };
    std::vector<lantern::object<lantern::rectangle, lantern::diffuse>> things{
        {lantern::rectangle{{-8, 0, 8}, {16, 0, 0}, {0, 0, -16}}, lantern::diffuse{glm::vec3(float(albedo))}}};
    for (const lantern::rectangle& r : slats.rectangles()) things.push_back({r, lantern::diffuse{}});
    const std::vector<lantern::rectangle_light> lights{
        {glm::vec3(lamp.corner), glm::vec3(lamp.a), glm::vec3(lamp.b), glm::vec3(float(radiance))}};
    return {"soft shadow", "The shadow of a blind under a rectangular lamp.", {lantern::purpose::light}, 2, -0.75, size,
            detail::each_pixel(size, make),
            detail::renderer(size, things, lights, lantern::camera{v}, exact_scenes::point_filter{})};
}

/// Balls on their way while the shutter is open.
[[nodiscard]] inline picture motion_blur(glm::uvec2 size) {
    using shape = lantern::moving<lantern::sphere>;
    const lantern::view v = detail::looking({0, 0, 4}, {0, 0, 0}, size, 40);
    const lantern::camera_frame frame(v);
    const std::vector<shape> balls{{{{-1.6f, 0.7f, 0}, 0.45f}, {1.9f, 0.25f, 0.3f}},
                                   {{{1.7f, 0.3f, -0.6f}, 0.55f}, {-0.5f, -0.9f, 0}},
                                   {{{-1.3f, -0.8f, 0.4f}, 0.3f}, {0.9f, 0.1f, 0.2f}}};
    const auto make = [&](glm::vec2 film) {
        const glm::dvec3 d = glm::normalize(frame.towards(film));
        std::vector<exact::stretch> seen;  // they may meet: white before white
        for (const shape& ball : balls) {
            const auto aside = [&](glm::dvec3 x) { return x - glm::dot(x, d) * d; };
            seen.push_back(exact::crossing(aside(frame.eye - glm::dvec3(ball.surface.center)), aside(glm::dvec3(ball.displacement)),
                                           double(ball.surface.radius), 0, 1));
        }
        const auto within = [=](double begin, double end) {
            std::vector<exact::stretch> parts = seen;
            std::ranges::sort(parts, {}, &exact::stretch::begin);
            double covered = 0, done = begin;
            for (const exact::stretch& s : parts) {
                const double from = std::max(s.begin, done), to = std::min(s.end, end);
                if (to > from) covered += to - from, done = to;
            }
            return covered / (end - begin);
        };
        return black_and_white([=](std::uint32_t side, std::uint32_t i, std::uint32_t j) {
            const double count = double(side) * side, k = double(j) * side + i;
            return within(k / count, (k + 1) / count);
        });
    };
    std::vector<lantern::object<shape, lantern::emissive>> things;
    for (const shape& ball : balls) things.push_back({ball, exact_scenes::detail::white});
    return {"motion blur", "Balls on their way while the shutter is open.", {lantern::purpose::time}, 1, -1, size, detail::each_pixel(size, make),
            detail::renderer(size, things, std::vector<lantern::point_light>{},
                             lantern::camera{v, lantern::pinhole{}, lantern::shutter{}}, exact_scenes::point_filter{})};
}

/// Stripes on a wall, out of focus, through pixels that have an area and a square lens: four numbers, weighted and added. Blurs stay
/// narrower than stripes, so no pixel sees two edges.
[[nodiscard]] inline picture two_at_once(glm::uvec2 size) {
    const lantern::view v = detail::looking({0, 0, 2}, {0, 0, 0}, size, 40);
    const lantern::camera_frame frame(v);
    const exact_scenes::square_lens lens{.side = 0.3f, .focus_distance = 3};
    const double distance = 2;
    const detail::stripes s{.origin = {0, 0, 0}, .across = {0.8, 0.6, 0}, .along = {-0.6, 0.8, 0}, .length = 8,
                            .edges = {-1.4, -1.05, -0.68, -0.3, 0.05, 0.4, 0.78, 1.2}};
    const std::vector<exact::drawn> purposes{
        {exact::pixel_weights(s.across, distance, 2 * frame.half_width / size.x * frame.right, -2 * frame.half_height / size.y * frame.up)},
        {exact::lens_weights(s.across, distance, double(lens.focus_distance), double(lens.side) * frame.right,
                             double(lens.side) * frame.up)}};
    std::vector<double> weights;
    double moved = 0;  // by all numbers together, at most
    for (const exact::drawn& p : purposes)
        for (const double w : p.weights) weights.push_back(w), moved += std::abs(w);
    const auto make = [&](glm::vec2 film) {
        const double middle = glm::dot(frame.eye + distance * frame.towards(film) - s.origin, s.across);
        const auto up_to = [=](std::size_t k) {  // the sum of the numbers, with which the edge is reached
            double d = s.edges[k] - middle;
            for (const double w : weights) d += w / 2;
            return d;
        };
        const double p = s.sum([&](std::size_t k) { return 1 - exact::fraction_below(weights, up_to(k)); });
        std::size_t nearest = 0;
        for (std::size_t k = 0; k < s.edges.size(); ++k)
            if (std::abs(s.edges[k] - middle) < std::abs(s.edges[nearest] - middle)) nearest = k;
        const double d = up_to(nearest);
        const bool sharp = std::abs(s.edges[nearest] - middle) >= moved / 2;  // no edge within reach
        return pixel{p, p * (1 - p), [=](std::uint32_t side) {
                         if (sharp) return 0.0;
                         const double mean = std::sqrt(exact::detail::second_moment(purposes, 0, side, d));
                         // What both purposes have to do with each other is of order N^-2: left out where it would take long.
                         return exact::padded_variance(2, side * side, mean, [&](std::uint32_t fixed) {
                             return exact::detail::second_moment(purposes, fixed, side, d);
                         }, side > 8 ? 1 : 2);
                     }};
    };
    return {"two effects at once", "Stripes on a wall that is out of focus, seen through pixels that have an area.",
            {lantern::purpose::film, lantern::purpose::lens}, 4, -0.5, size, detail::each_pixel(size, make),
            detail::renderer(size, detail::shining(s), std::vector<lantern::point_light>{}, lantern::camera{v, lens}, lantern::box_filter{})};
}

inline constexpr std::array<std::pair<std::string_view, picture (*)(glm::uvec2)>, 6> all{{
    {"antialiasing", antialiasing},
    {"soft shadow", soft_shadow},
    {"gloss", gloss},
    {"depth of field", depth_of_field},
    {"motion blur", motion_blur},
    {"two effects at once", two_at_once},
}};

}  // namespace exact_pictures
