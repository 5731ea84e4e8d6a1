// SPDX-License-Identifier: MIT
#pragma once
// Scenes whose pixel is known in closed form, rendered by the library's own camera, sampler, surfaces and integrator.

#include <lantern/any_of.hpp>
#include <lantern/basis.hpp>
#include <lantern/camera.hpp>
#include <lantern/closest.hpp>
#include <lantern/diffuse.hpp>
#include <lantern/distribution.hpp>
#include <lantern/emissive.hpp>
#include <lantern/exact.hpp>
#include <lantern/exact_error.hpp>
#include <lantern/exact_light.hpp>
#include <lantern/filter.hpp>
#include <lantern/glossy.hpp>
#include <lantern/light.hpp>
#include <lantern/mirror.hpp>
#include <lantern/moving.hpp>
#include <lantern/object.hpp>
#include <lantern/rectangle.hpp>
#include <lantern/rectangle_light.hpp>
#include <lantern/render.hpp>
#include <lantern/samples.hpp>
#include <lantern/sphere.hpp>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace exact_scenes {

namespace exact = lantern::exact;

// ---- a pixel, rendered again and again ------------------------------------------------------------------------------

/// What the pixel is and what error `jittered{side}` must have, and what came of rendering it many times.
struct outcome {
    std::string name;
    double mean = 0, rmse = 0;                    ///< the closed form, and the predicted error
    double rendered_mean = 0, rendered_rmse = 0;  ///< over all renderings
    double z = 0;                                 ///< rendered mean - mean, in standard deviations of the former
};

/// Every rendering takes side² samples of the pixel, with a seed of its own.
struct effort {
    std::uint32_t side = 4;
    std::uint32_t renderings = 8000;
};

/// What is known of a scene before it is rendered.
struct known {
    std::string name;
    double mean = 0, rmse = 0;
};

/// Antialiasing left out: every sample is taken in the middle of the pixel.
struct point_filter {};
[[nodiscard]] inline float value(const point_filter&, glm::vec2 p) { return p == glm::vec2(0) ? 1.0f : 0.0f; }
[[nodiscard]] inline lantern::filter_sample sample(const point_filter&, glm::vec2) { return {}; }

/// A square aperture, filled linearly, so that its strata are squares too. A lens of one's own, as any program may have.
struct square_lens {
    float side = 0;
    float focus_distance = 1;
};
inline void validate(const square_lens&) {}
[[nodiscard]] inline glm::vec2 on_aperture(const square_lens& l, glm::vec2 xi) { return l.side * (xi - 0.5f); }

template <class Camera, class Tracer, class Filter>
[[nodiscard]] outcome render_often(const known& exactly, const Camera& cam, const Tracer& tracer, const Filter& filter,
                                   effort how) {
    double sum = 0, squares = 0;
    for (std::uint32_t seed = 0; seed < how.renderings; ++seed) {
        const lantern::jittered sampler{.side = how.side, .seed = seed};
        const double pixel = lantern::render_pixel({0, 0}, {1, 1}, cam, sampler, tracer, filter).mean().x;
        sum += pixel - exactly.mean;
        squares += (pixel - exactly.mean) * (pixel - exactly.mean);
    }
    const double count = how.renderings, off = sum / count, rmse = std::sqrt(squares / count);
    const double deviation = std::sqrt((squares / count - off * off) / count);
    return {exactly.name, exactly.mean, exactly.rmse, exactly.mean + off, rmse, off / deviation};
}

// ---- all effects at once, or any of them: parallel planes -----------------------------------------------------------

// A camera at height 200 looks straight down on a mirror at height 0, which shows it a white ceiling at height 500. A light
// at height 0, beside the mirror, lights the ceiling past the edge of a board at height 250. What each effect does is
// to move the point where the shadow ray passes the board, by a part of a unit:
//     antialiasing  the pixel covers about one unit of the ceiling;
//     gloss         the mirror is a little rough;
//     lens          the ceiling is out of focus;
//     motion        the board moves;
//     soft shadow   the light is about one unit wide.
// All angles are below 1/60, so the sum of the five moves is linear to about 1e-5, and where the light is not hidden
// the ceiling's radiance is 1 within 1e-4, without any influence on the mean beyond 1e-5.

struct effects {
    bool film = false, shadow = false, gloss = false, lens = false, time = false;
    bool round_lens = false;  ///< a disc instead of a square

    [[nodiscard]] std::string name() const {
        std::string text;
        for (const auto& [on, word] : {std::pair{film, "antialiasing"},
                                       {shadow, "soft shadow"},
                                       {gloss, "gloss"},
                                       {lens, round_lens ? "round lens" : "square lens"},
                                       {time, "motion"}})
            if (on) text += (text.empty() ? "" : " + ") + std::string(word);
        return text;
    }
};

struct stage {
    static constexpr double eye = 200, ceiling = 500, board = 250, focus = 1400, lens_side = 1.6, lens_radius = 0.9;
    static constexpr float fov = 0.0014f, gloss_width = 0.002f;
    glm::dvec3 n{std::cos(0.5), std::sin(0.5), 0},
        along{-std::sin(0.5), std::cos(0.5), 0};  ///< across the edge, along it
    glm::dvec3 light_center = 8.0 * along, light_a{1, 0.3, 0}, light_b{-0.2, 0.9, 0};
    glm::dvec3 path = 0.5 * n + 0.2 * along;  ///< what the board travels
    double edge = 0.05;                       ///< hidden where n · x > edge, in the middle of the exposure
};

/// The closed form: all numbers that are drawn, with their weights in the plane of the board.
[[nodiscard]] inline known predict(const stage& s, const effects& on, std::uint32_t side) {
    using exact::drawn;
    const double nearer = 1 - (s.ceiling - s.board) / s.ceiling;  // all that moves the lit point counts this much
    const auto scaled = [&](std::array<double, 2> w) { return std::array{nearer * w[0], nearer * w[1]}; };
    const double length = s.eye + s.ceiling, pixel = 2 * std::tan(double(s.fov) / 2);
    const glm::dvec3 right(1, 0, 0), up(0, 1, 0);
    const lantern::basis mirrored = lantern::basis_from({0, 0, 1});

    std::vector<drawn> purposes;
    double radius = 0;
    if (on.film) purposes.push_back({scaled(exact::pixel_weights(s.n, length, pixel * right, -pixel * up))});
    if (on.shadow)
        purposes.push_back({exact::shadow_weights(s.n, s.ceiling - s.board, s.ceiling, s.light_a, s.light_b)});
    if (on.gloss)
        purposes.push_back({scaled(exact::gloss_weights(s.n, s.ceiling, double(s.gloss_width), glm::dvec3(mirrored.u),
                                                        glm::dvec3(mirrored.v)))});
    if (on.lens) {
        const double size = on.round_lens ? s.lens_radius : s.lens_side;
        purposes.push_back({scaled(exact::lens_weights(s.n, length, s.focus, size * right, size * up)),
                            on.round_lens ? drawn::shape::disc : drawn::shape::square});
    }
    if (on.time) purposes.push_back({{exact::motion_weight(s.n, s.path), 0}, drawn::shape::line});

    // With every number in the middle of its range the shadow ray passes n · x = 0.
    double d = s.edge;
    std::vector<double> weights;
    for (const drawn& p : purposes) {
        if (p.from == drawn::shape::disc) {
            radius = std::hypot(p.weights[0], p.weights[1]);
            continue;
        }
        weights.insert(weights.end(), p.weights.begin(), p.weights.end());
        d += (p.weights[0] + p.weights[1]) / 2;
    }
    return {on.name(), exact::fraction_below(weights, radius, d), exact::jittered_rmse(side, purposes, d)};
}

namespace detail {

using still_or_moving = lantern::any_of<lantern::rectangle, lantern::moving<lantern::rectangle>>;
using paint = std::variant<lantern::mirror, lantern::glossy, lantern::diffuse>;

/// Renders with a lens and a shutter of these types, the smallest that the effects need.
template <class Shape, class Lens, class Shutter>
[[nodiscard]] outcome render_stage(const stage& s, const effects& on, const Lens& lens, const Shutter& shutter,
                                   effort how, const known& exactly) {
    const glm::vec3 n(s.n), along(s.along);
    const auto square = [](float size, float height) {
        return lantern::rectangle{{-size, -size, height}, {2 * size, 0, 0}, {0, 2 * size, 0}};
    };
    const lantern::rectangle board{glm::vec3(s.edge * s.n + 2.2 * s.along + glm::dvec3(0, 0, s.board)), 100.0f * n,
                                   100.0f * along};
    const paint metal =
        on.gloss ? paint(lantern::glossy{.color = glm::vec3(1), .width = s.gloss_width}) : lantern::mirror{};

    using thing = lantern::object<Shape, paint>;
    std::vector<thing> things{{square(4, 0), metal}, {square(20, float(s.ceiling)), lantern::diffuse{glm::vec3(1)}}};
    if constexpr (std::same_as<Shape, lantern::rectangle>) {
        things.push_back({board, lantern::diffuse{}});
    } else {
        const lantern::rectangle start{board.corner - glm::vec3(0.5 * s.path), board.u, board.v};
        things.push_back({lantern::moving{start, glm::vec3(s.path)}, lantern::diffuse{}});
    }

    // So bright that the ceiling's radiance is 1 above the light's middle.
    const double distance = std::hypot(s.ceiling, glm::length(s.light_center)), pi = std::numbers::pi;
    const double area = glm::length(glm::cross(s.light_a, s.light_b));
    std::vector<std::variant<lantern::point_light, lantern::rectangle_light>> lights;
    if (on.shadow)
        lights.push_back(lantern::rectangle_light{
            glm::vec3(s.light_center - 0.5 * (s.light_a + s.light_b)), glm::vec3(s.light_a), glm::vec3(s.light_b),
            glm::vec3(float(pi * std::pow(distance, 4) / (area * s.ceiling * s.ceiling)))});
    else
        lights.push_back(
            lantern::point_light{glm::vec3(s.light_center), glm::vec3(float(pi * std::pow(distance, 3) / s.ceiling))});

    const lantern::every structure{std::uint32_t(things.size())};
    const lantern::distribution tracer{structure, things, lights};
    const lantern::camera cam{
        lantern::view{.eye = {0, 0, float(s.eye)}, .target = {0, 0, 0}, .up = {0, 1, 0}, .vertical_fov = s.fov}, lens,
        shutter};
    return on.film ? render_often(exactly, cam, tracer, lantern::box_filter{}, how)
                   : render_often(exactly, cam, tracer, point_filter{}, how);
}

template <class Lens>
[[nodiscard]] outcome render_stage(const stage& s, const effects& on, const Lens& lens, effort how, const known& exactly) {
    return on.time ? render_stage<still_or_moving>(s, on, lens, lantern::shutter{}, how, exactly)
                   : render_stage<lantern::rectangle>(s, on, lens, lantern::instant{}, how, exactly);
}

}  // namespace detail

/// Renders, and compares with what is known already.
[[nodiscard]] inline outcome render(const effects& on, effort how, const known& exactly, const stage& s = {}) {
    if (!on.lens) return detail::render_stage(s, on, lantern::pinhole{}, how, exactly);
    if (on.round_lens)
        return detail::render_stage(s, on, lantern::thin_lens{float(s.lens_radius), float(s.focus)}, how, exactly);
    return detail::render_stage(s, on, square_lens{float(s.lens_side), float(s.focus)}, how, exactly);
}
[[nodiscard]] inline outcome render(const effects& on, effort how, const stage& s = {}) {
    return render(on, how, predict(s, on, how.side), s);
}

// ---- one effect at a time, at angles that are not small -------------------------------------------------------------

/// The error of jittered samples of any function of the unit square, by brute force within each cell.
template <class Function>
[[nodiscard]] double rmse_by_cells(std::uint32_t side, Function f, std::uint32_t points = 64) {
    double sum = 0;
    for (std::uint32_t j = 0; j < side; ++j)
        for (std::uint32_t i = 0; i < side; ++i) {
            double mean = 0, squares = 0;
            for (std::uint32_t y = 0; y < points; ++y)
                for (std::uint32_t x = 0; x < points; ++x) {
                    const double value = f((i + (x + 0.5) / points) / side, (j + (y + 0.5) / points) / side);
                    mean += value / (points * points);
                    squares += value * value / (points * points);
                }
            sum += squares - mean * mean;
        }
    return std::sqrt(sum) / (side * side);
}

namespace detail {

/// A white half-plane through an edge, on the side that `into` points to, against black: a rectangle, large enough.
[[nodiscard]] inline lantern::rectangle half_plane(const exact::edge& edge, glm::dvec3 into) {
    const glm::dvec3 along = glm::normalize(edge.along);
    return {glm::vec3(edge.point - 500.0 * along), glm::vec3(1000.0 * along), glm::vec3(500.0 * into)};
}

/// The edge, turned so that what is visible past it is on the side of x.
[[nodiscard]] inline exact::edge towards(const exact::edge& e, glm::dvec3 apex, glm::dvec3 x) {
    return glm::dot(glm::cross(e.point - apex, e.along), x - apex) > 0 ? e : exact::edge{e.point, -e.along};
}

inline const lantern::emissive white{glm::vec3(1), glm::vec3(1)};

template <class Camera, class Filter>
[[nodiscard]] outcome render_white(const known& exactly, const lantern::rectangle& shape, const Camera& cam,
                                   const Filter& filter, effort how) {
    const std::vector<lantern::object<lantern::rectangle, lantern::emissive>> things{{shape, white}};
    const std::vector<lantern::point_light> none;
    const lantern::every structure{1};
    const lantern::distribution tracer{structure, things, none};
    return render_often(exactly, cam, tracer, filter, how);
}

}  // namespace detail

/// A pixel of 60 degrees, cut by an edge that runs away from the camera.
[[nodiscard]] inline outcome wide_antialiasing(effort how) {
    const float fov = 1.0471976f;
    const glm::dvec3 eye(0.5, -0.25, 1), into = glm::normalize(glm::dvec3(-1, 0.25, 0.125));
    const exact::edge edge{{0.625, 0, -3}, {0.3, 1, -0.5}};
    const double half = std::tan(double(fov) / 2);
    const exact::parallelogram film{eye + glm::dvec3(-half, half, -1), {2 * half, 0, 0}, {0, -2 * half, 0}};
    const exact::half_plane seen = exact::seen(eye, detail::towards(edge, eye, edge.point + into), film);
    const lantern::camera cam{lantern::view{
        .eye = glm::vec3(eye), .target = glm::vec3(eye) - glm::vec3(0, 0, 1), .up = {0, 1, 0}, .vertical_fov = fov}};
    return detail::render_white({"a wide pixel", exact::clipped_area(seen), exact::jittered_rmse(how.side, seen)},
                                detail::half_plane(edge, into), cam, lantern::box_filter{}, how);
}

/// A lens near its plane of focus, an edge before it, at a slant.
[[nodiscard]] inline outcome wide_lens(effort how) {
    const double radius = 0.5;
    const glm::dvec3 eye(0, 0, 2), in_focus(0, 0, -1), into = glm::normalize(glm::dvec3(1, 0.2, -0.4));
    const exact::edge edge{{-0.0625, 0.03125, 1}, {-0.3, 1, 0.25}};
    const exact::disc aperture{eye, {radius, 0, 0}, {0, radius, 0}};
    const exact::edge past = detail::towards(edge, in_focus, edge.point + into);
    const glm::dvec3 n = glm::cross(past.point - in_focus, past.along);
    const std::vector<exact::drawn> lens{
        {{-glm::dot(n, aperture.a), -glm::dot(n, aperture.b)}, exact::drawn::shape::disc}};
    const lantern::camera cam{
        lantern::view{.eye = glm::vec3(eye), .target = {0, 0, 0}, .up = {0, 1, 0}},
        lantern::thin_lens{.radius = float(radius), .focus_distance = float(glm::distance(eye, in_focus))}};
    return detail::render_white({"a wide lens", exact::visible(in_focus, past, aperture),
                                 exact::jittered_rmse(how.side, lens, glm::dot(n, eye - in_focus))},
                                detail::half_plane(edge, into), cam, point_filter{}, how);
}

/// A rough mirror at 45 degrees, and an edge in what it shows.
[[nodiscard]] inline outcome wide_gloss(effort how) {
    const float width = 0.75f;
    const glm::dvec3 point(0), into = glm::normalize(glm::dvec3(0.2, 0.3, 1));
    const exact::edge edge{{2, 0.125, -0.25}, {0.2, 1, -0.3}};
    const glm::vec3 normal = glm::normalize(glm::vec3(1, 0, 1));
    const glm::vec3 r = lantern::mirrored({0, 0, -1}, normal);  // along x
    const lantern::basis b = lantern::basis_from(r);
    const exact::parallelogram lobe =
        exact::glossy_square(point, glm::dvec3(b.w), glm::dvec3(b.u), glm::dvec3(b.v), double(width));
    const exact::half_plane seen = exact::seen(point, detail::towards(edge, point, edge.point + into), lobe);

    using paint = std::variant<lantern::glossy, lantern::emissive>;
    const lantern::rectangle metal{{-0.125f, -0.125f, 0.125f}, {0, 0.25f, 0}, {0.25f, 0, -0.25f}};
    const std::vector<lantern::object<lantern::rectangle, paint>> things{
        {metal, lantern::glossy{.color = glm::vec3(1), .width = width}},
        {detail::half_plane(edge, into), detail::white}};
    const std::vector<lantern::point_light> none;
    const lantern::every structure{2};
    const lantern::distribution tracer{structure, things, none};
    const lantern::camera cam{lantern::view{.eye = {0, 0, 1}, .target = {0, 0, 0}, .up = {0, 1, 0}}};
    return render_often({"wide gloss", exact::clipped_area(seen), exact::jittered_rmse(how.side, seen)}, cam, tracer,
                        point_filter{}, how);
}

/// A large light near a floor, partly hidden by an edge: both cosines and the distance vary over the light.
[[nodiscard]] inline outcome wide_penumbra(effort how) {
    const exact::parallelogram lamp{{-1, -0.5, 1.5}, {0.25, 1.5, 0.5}, {1.75, 0, 0.25}};
    const exact::edge edge{{-0.125, 0.0625, 0.75}, {1, 0.4, 0.3}};
    const glm::dvec3 point(0), normal(0, 0, 1), into = glm::normalize(glm::dvec3(-0.3, 1, 0.2));  // of the board
    const exact::edge past = detail::towards(edge, point, edge.point - into);
    const glm::dvec3 side = glm::cross(past.point - point, past.along), area = glm::cross(lamp.a, lamp.b);
    const double albedo = 0.8, radiance = 2;
    const double mean = albedo / std::numbers::pi * radiance * exact::penumbra(point, normal, past, lamp);
    const double rmse = rmse_by_cells(how.side, [&](double u, double v) {
        const glm::dvec3 w = lamp.corner + u * lamp.a + v * lamp.b - point;
        const double d2 = glm::dot(w, w), cosines = glm::dot(normal, w) * std::abs(glm::dot(area, w));
        return glm::dot(side, w) > 0 ? albedo / std::numbers::pi * radiance * cosines / (d2 * d2) : 0;
    });

    const std::vector<lantern::object<lantern::rectangle, lantern::diffuse>> things{
        {lantern::rectangle{{-4, -4, 0}, {8, 0, 0}, {0, 8, 0}}, lantern::diffuse{glm::vec3(float(albedo))}},
        {detail::half_plane(edge, into), lantern::diffuse{}}};
    const std::vector<lantern::rectangle_light> lights{
        {glm::vec3(lamp.corner), glm::vec3(lamp.a), glm::vec3(lamp.b), glm::vec3(float(radiance))}};
    const lantern::every structure{2};
    const lantern::distribution tracer{structure, things, lights};
    const lantern::camera cam{lantern::view{.eye = {0.5f, -2, 0.25f}, .target = {0, 0, 0}, .up = {0, 0, 1}}};
    return render_often({"a wide penumbra", mean, rmse}, cam, tracer, point_filter{}, how);
}

/// A ball that crosses a ray while the shutter is open for a part of the time.
[[nodiscard]] inline outcome crossing_ball(effort how) {
    const glm::dvec3 start(-1.5, 0.25, -4), path(3, 0.25, 1);
    const double radius = 0.5, open = 0.125, close = 0.75;
    // Seen along the ray, -z, the ball is a disc, whatever it does along the ray.
    const exact::stretch seen =
        exact::crossing(glm::dvec3(-start.x, -start.y, 0), {path.x, path.y, 0}, radius, open, close);
    const double begin = (seen.begin - open) / (close - open), end = (seen.end - open) / (close - open);
    const std::uint32_t count = how.side * how.side;
    double variance = 0;
    for (std::uint32_t i = 0; i < count; ++i) {  // the strata of time
        const double p = std::max(0.0, std::min(end * count, i + 1.0) - std::max(begin * count, double(i)));
        variance += p * (1 - p);
    }

    using shape = lantern::moving<lantern::sphere>;
    const std::vector<lantern::object<shape, lantern::emissive>> things{
        {shape{{glm::vec3(start), float(radius)}, glm::vec3(path)}, detail::white}};
    const std::vector<lantern::point_light> none;
    const lantern::every structure{1};
    const lantern::distribution tracer{structure, things, none};
    const lantern::camera cam{lantern::view{.eye = {0, 0, 0}, .target = {0, 0, -1}, .up = {0, 1, 0}},
                              lantern::pinhole{}, lantern::shutter{float(open), float(close)}};
    return render_often({"a crossing ball", end - begin, std::sqrt(variance) / count}, cam, tracer, point_filter{},
                        how);
}

}  // namespace exact_scenes
