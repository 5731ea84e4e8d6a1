// SPDX-License-Identifier: MIT
#pragma once
// Lab 14's pictures: on the left, or in red, the textbook's formula; on the right, or in blue, the student's. The program shows them with the
// student's code, the handout with ours.

#include "../support/gaps.hpp"
#include "cases.hpp"

#include <lab14_extremes/extremes.hpp>

#include <lantern/image.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

namespace pictures {

using glm::dvec3;
using glm::vec2;
using glm::vec3;
using lantern::image;
using lantern::ray;

inline const vec3 paper(0.9f), ink(0.02f), red(0.8f, 0.02f, 0.02f), blue(0.03f, 0.15f, 0.7f), grey(0.45f);
inline constexpr unsigned margin = 4;

/// A part of a page; when it needs what is not written yet, a test card with the number of the step.
template <class Draw>
void part(image& page, glm::uvec2 corner, glm::uvec2 size, support::gaps& missing, const Draw& draw) {
    try {
        draw();
    } catch (const lantern::unfinished& gap) {
        missing.note(gap);
        support::paint_test_card(page, corner, size, support::step_number(gap.what()));
    }
}

/// Colours every pixel of a part: colour(x, y), from 0 to 1, y downwards.
template <class Colour>
void fill(image& page, glm::uvec2 corner, glm::uvec2 size, const Colour& colour) {
    for (unsigned y = 0; y < size.y; ++y)
        for (unsigned x = 0; x < size.x; ++x)
            page(corner.x + x, corner.y + y) = colour((float(x) + 0.5f) / float(size.x), (float(y) + 0.5f) / float(size.y));
}

/// Two columns, a row for each: draw(row, whether it is the student's, corner of the cell).
template <class Draw>
image two_columns(glm::uvec2 cell, unsigned rows, support::gaps& missing, const Draw& draw) {
    image page({2 * cell.x + margin, rows * (cell.y + margin) - margin}, paper);
    for (unsigned row = 0; row < rows; ++row)
        for (const bool own : {false, true}) {
            const glm::uvec2 corner(own ? cell.x + margin : 0, row * (cell.y + margin));
            part(page, corner, cell, missing, [&] { draw(page, row, own, corner); });
        }
    return page;
}

// ---- step 1: a ground that is a large sphere ---------------------------------------------------------------------------

/// A chequered ground of this radius with two balls on it, as they are seen from a man's height.
template <class Hit>
vec3 ground(float x, float y, float radius, const Hit& hit) {
    const ray r{{0, 1.7f, 0}, {1.6f * (x - 0.5f), 0.35f - 0.9f * y, -1}};
    struct ball {
        vec3 center;
        float radius;
    };
    const std::array<ball, 3> balls{{{{0, -radius, 0}, radius}, {{-1.3f, 1, -6}, 1}, {{1.5f, 0.7f, -4}, 0.7f}}};
    std::optional<float> nearest;
    std::size_t which = 0;
    for (std::size_t i = 0; i < balls.size(); ++i)
        if (const auto t = hit(balls[i].center, balls[i].radius, r); t && (!nearest || *t < *nearest)) nearest = t, which = i;
    const vec3 sky(0.35f, 0.5f, 0.75f);
    if (!nearest) return sky;
    const vec3 p = lantern::at(r, *nearest), sun = glm::normalize(vec3(0.5f, 0.8f, 0.4f));
    if (which > 0) {
        const vec3 colour = which == 1 ? vec3(0.7f, 0.25f, 0.1f) : vec3(0.15f, 0.4f, 0.2f);
        return (0.15f + 0.8f * std::max(0.0f, glm::dot((p - balls[which].center) / balls[which].radius, sun))) * colour;
    }
    const bool dark = (std::int64_t(std::floor(p.x)) + std::int64_t(std::floor(p.z))) % 2 == 0;
    const float haze = std::clamp(*nearest / 40, 0.0f, 1.0f);
    return glm::mix(vec3(dark ? 0.15f : 0.6f), sky, haze);
}

[[nodiscard]] inline image grounds(support::gaps& missing) {
    static constexpr std::array radii{1e6f, 1e7f, 1e12f};
    return two_columns({280, 130}, 3, missing, [](image& page, unsigned row, bool own, glm::uvec2 corner) {
        fill(page, corner, {280, 130}, [&](float x, float y) {
            return own ? ground(x, y, radii[row], lab14::hit_sphere) : ground(x, y, radii[row], lab14::textbook::hit_sphere);
        });
    });
}

// ---- step 2: cloth ---------------------------------------------------------------------------------------------------

/// Rays from above, aimed at the edges of a piece of cloth, are dots where they are aimed: red when they go through it.
template <class Hit>
void holes(image& page, glm::uvec2 corner, unsigned size, int scale, const Hit& hit) {
    const extremes::cloth mesh(6, scale);
    const float unit = std::ldexp(1.0f, scale);
    const auto place = [&](vec3 p) { return glm::uvec2(glm::clamp((vec2(p.x, p.y) / unit - 0.7f) / 5.0f, 0.0f, 0.99f) * float(size)) + corner; };
    fill(page, corner, {size, size}, [](float, float) { return vec3(0.03f); });
    extremes::dice random(33);
    for (int pass = 0; pass < 2; ++pass)  // first the edges, then the holes above them
        for (int y = 1; y < 6; ++y)
            for (int x = 1; x < 6; ++x)
                for (int along = 0; along < 3; ++along)
                    for (int k = 0; k < 32; ++k) {
                        const int x1 = x + (along != 1 ? 1 : 0), y1 = y + (along != 0 ? 1 : 0);
                        if (x1 > 5 || y1 > 5) continue;
                        const vec3 p = mesh(x, y), q = mesh(x1, y1), aim = p + float(k) / 32 * (q - p);
                        const int ox = random.whole(0, 3'145'728), oy = random.whole(0, 3'145'728), oz = random.whole(1'500'000, 3'500'000);
                        const vec3 o = extremes::scaled({ox, oy, oz}, scale - 19);
                        bool found = false;
                        mesh.each([&](vec3 a, vec3 b, vec3 c) { found = found || hit(a, b, c, ray{o, aim - o}); });
                        const glm::uvec2 at = place(aim);
                        if (pass == 0 && found) page(at.x, at.y) = vec3(0.5f);
                        if (pass == 1 && !found)
                            for (unsigned i = 0; i < 9; ++i) page(at.x - 1 + i % 3, at.y - 1 + i / 3) = red;
                    }
}

[[nodiscard]] inline image cloths(support::gaps& missing) {
    return two_columns({260, 260}, 2, missing, [](image& page, unsigned row, bool own, glm::uvec2 corner) {
        const int scale = row == 0 ? 0 : -13;
        if (own) holes(page, corner, 260, scale, lab14::hit_triangle);
        else holes(page, corner, 260, scale, lab14::textbook::hit_triangle);
    });
}

// ---- step 3: a wall --------------------------------------------------------------------------------------------------

/// A wall of bricks, the lower half of them of no thickness, seen straight from the front: red is what no ray meets.
template <class Meets>
vec3 wall(float x, float y, const Meets& meets) {
    const float px = std::floor(x * 96) / 8, py = std::floor(y * 64) / 8;  // twelve by eight units, eight rays to the unit
    const ray r{{px, py, 5}, {0, -0.0f, -1}};
    for (int row = 0; row < 8; ++row)
        for (int i = -1; i < 6; ++i) {
            const float left = float(2 * i + row % 2);
            if (meets(vec3(left, float(row), row < 4 ? -1 : 0), vec3(left + 2, float(row + 1), 0), r))
                return ((i + row) % 2 == 0 ? 1.0f : 0.75f) * vec3(0.55f, 0.4f, 0.3f);
        }
    return red;
}

[[nodiscard]] inline image walls(support::gaps& missing) {
    return two_columns({288, 192}, 1, missing, [](image& page, unsigned, bool own, glm::uvec2 corner) {
        fill(page, corner, {288, 192}, [&](float x, float y) {
            return own ? wall(x, y, lab14::meets_box) : wall(x, y, lab14::textbook::meets_box);
        });
    });
}

// ---- step 4: shadows -------------------------------------------------------------------------------------------------

/// Where rays meet things is here always right, in double: what is shown is how they leave.
[[nodiscard]] inline double meet_ball(dvec3 center, double radius, dvec3 o, dvec3 d) {
    const dvec3 f = center - o;
    const double a = glm::dot(d, d), b = glm::dot(f, d), k = glm::dot(f, f) - radius * radius, discriminant = b * b - a * k;
    if (discriminant < 0) return 0;
    const double q = b + std::copysign(std::sqrt(discriminant), b), t0 = b >= 0 ? k / q : q / a, t1 = b >= 0 ? q / a : k / q;
    return t0 > 0 ? t0 : t1 > 0 ? t1 : 0;
}

/// A ball on a slanting floor under the sun, in a scene of this size.
template <class OnSphere, class OnTriangle, class Leave>
vec3 shadow(float x, float y, float size, const OnSphere& on_sphere, const OnTriangle& on_triangle, const Leave& leave) {
    const vec3 a = size * vec3(-9.1f, 0.3f, 7.7f), b = size * vec3(11.3f, -0.7f, 6.1f), c = size * vec3(0.7f, -0.2f, -17.9f);
    const dvec3 n = glm::normalize(glm::cross(dvec3(b) - dvec3(a), dvec3(c) - dvec3(a)));
    const dvec3 foot = dvec3(a) + 0.36 * (dvec3(b) - dvec3(a)) + 0.36 * (dvec3(c) - dvec3(a));
    const float radius = size;
    const vec3 center(foot + double(radius) * n);
    const ray r{vec3(foot) + size * vec3(0, 2.4f, 6), {0.9f * (x - 0.5f) + 0.05f, 0.05f - 0.65f * y, -1}};
    const double ball = meet_ball(dvec3(center), double(radius), dvec3(r.origin), dvec3(r.direction));
    const double floor = glm::dot(n, dvec3(a) - dvec3(r.origin)) / glm::dot(n, dvec3(r.direction));
    if (ball == 0 && floor <= 0) return vec3(0.35f, 0.5f, 0.75f);
    const bool is_ball = ball > 0 && (floor <= 0 || ball < floor);
    const float t = float(is_ball ? ball : floor);
    const vec3 p = is_ball ? on_sphere(center, radius, r, t) : on_triangle(a, b, c, r, t);
    const vec3 normal = is_ball ? vec3(glm::normalize(dvec3(p) - dvec3(center))) : vec3(n), sun = glm::normalize(vec3(0.6f, 0.7f, 0.3f));
    const float cosine = glm::dot(normal, sun);
    const vec3 colour = is_ball ? vec3(0.7f, 0.25f, 0.1f) : vec3(0.5f);
    if (cosine <= 0) return 0.1f * colour;
    const dvec3 o(leave(p, normal, sun)), s(sun);
    const bool dark = meet_ball(dvec3(center), double(radius), o, s) > 0 || glm::dot(n, dvec3(a) - o) / glm::dot(n, s) > 0;
    return (dark ? 0.1f : 0.1f + 0.9f * cosine) * colour;
}

[[nodiscard]] inline image shadows(support::gaps& missing) {
    static constexpr std::array sizes{3e-4f, 1.0f, 1e5f};
    return two_columns({240, 150}, 3, missing, [](image& page, unsigned row, bool own, glm::uvec2 corner) {
        const auto along_ray = [](const ray& r, float t) { return lantern::at(r, t); };
        fill(page, corner, {240, 150}, [&](float x, float y) {
            if (own) return shadow(x, y, sizes[row], lab14::on_sphere, lab14::on_triangle, lab14::leave);
            return shadow(x, y, sizes[row], [&](vec3, float, const ray& r, float t) { return along_ray(r, t); },
                          [&](vec3, vec3, vec3, const ray& r, float t) { return along_ray(r, t); }, lab14::textbook::leave);
        });
    });
}

// ---- steps 5, 6 and 7: charts ----------------------------------------------------------------------------------------

/// A chart with lines at whole numbers of x and of y.
class chart {
public:
    chart(image& page, vec2 low, vec2 high, float step_x = 1, float step_y = 1) : page_(page), low_(low), high_(high) {
        for (float x = low.x; x <= high.x; x += step_x)
            for (unsigned y = 0; y < page.size().y; ++y) page_(place({x, low.y}).x, y) = 0.75f * paper;
        for (float y = low.y; y <= high.y; y += step_y)
            for (unsigned x = 0; x < page.size().x; ++x) page_(x, place({low.x, y}).y) = 0.75f * paper;
    }
    void dot(float x, float y, vec3 colour, int radius = 1) {
        const glm::ivec2 at(place({x, y}));
        for (int j = -radius; j <= radius; ++j)
            for (int i = -radius; i <= radius; ++i) {
                const glm::ivec2 p = glm::clamp(at + glm::ivec2(i, j), glm::ivec2(0), glm::ivec2(page_.size()) - 1);
                page_(unsigned(p.x), unsigned(p.y)) = colour;
            }
    }
    void line(vec2 a, vec2 b, vec3 colour) {
        for (int k = 0; k <= 400; ++k) {
            const vec2 p = glm::mix(a, b, float(k) / 400);
            dot(p.x, p.y, colour);
        }
    }

private:
    [[nodiscard]] glm::uvec2 place(vec2 p) const {
        const vec2 at = glm::clamp((p - low_) / (high_ - low_), 0.0f, 1.0f);
        return {unsigned(at.x * float(page_.size().x - 1)), unsigned((1 - at.y) * float(page_.size().y - 1))};
    }
    image& page_;
    vec2 low_, high_;
};

/// How wrong frames are, 10^-9 to 10 upwards, against the distance of w from -z, 1 to 10^-12 to the right.
[[nodiscard]] inline image poles(support::gaps& missing) {
    image page({480, 240}, paper);
    chart c(page, {0, -9}, {12, 1});
    for (const bool own : {false, true})
        part(page, {0, 0}, page.size(), missing, [&] {
            extremes::dice random(41);
            for (int i = 0; i < 1500; ++i) {
                const float e = 12 * random.unit(), s = std::pow(10.0f, -e), turn = 6.2831853f * random.unit();
                const dvec3 exact(double(s) * std::cos(double(turn)), double(s) * std::sin(double(turn)), -std::sqrt(1 - double(s) * double(s)));
                const vec3 w(exact);
                double error = 0;
                if (own) {
                    const auto f = lab14::basis_around(w);
                    error = extremes::frame_error(f.u, f.v, f.w, w);
                } else {
                    const auto f = lab14::textbook::basis_around(w);
                    error = extremes::frame_error(f.u, f.v, f.w, w);
                }
                c.dot(e, float(std::log10(std::max(error, 1e-9))), own ? blue : red);
            }
        });
    return page;
}

/// The mean of samples between 0 and 1, against their number, 10^4 to 10^8.
[[nodiscard]] inline image sums(support::gaps& missing) {
    image page({480, 240}, paper);
    chart c(page, {4, 0}, {8, 1}, 1, 0.25f);
    const auto curve = [&](auto sum, vec3 colour) {
        std::uint32_t state = 1;
        float next = 1e4f;
        for (std::uint32_t i = 1; i <= 100'000'000; ++i) {
            state = 1664525 * state + 1013904223;  // Knuth's generator will do: its mean is 1/2
            add(sum, float(state >> 8) * 0x1p-24f);
            if (float(i) < next) continue;
            c.dot(std::log10(float(i)), mean(sum), colour);
            next *= 1.01f;
        }
    };
    part(page, {0, 0}, page.size(), missing, [&] {
        curve(lab14::textbook::accumulator{}, red);
        curve(lab14::accumulator{}, blue);
    });
    return page;
}

/// How many of the rays pass, upwards from 0 to 1, when the ratio is -4 to 4 floats away from the critical one.
[[nodiscard]] inline image critical(support::gaps& missing) {
    image page({480, 240}, paper);
    chart c(page, {-4, -0.02f}, {4, 1.02f}, 1, 0.26f);
    const auto all = extremes::refractions(9000);
    const auto curve = [&](const auto& passes, vec3 colour) {
        std::array<float, 9> asked{}, passed{};
        for (const auto& q : all) ++asked[std::size_t(q.steps + 4)], passed[std::size_t(q.steps + 4)] += passes(q) ? 1.0f : 0.0f;
        for (std::size_t i = 0; i < 8; ++i)
            c.line({float(i) - 4, passed[i] / asked[i]}, {float(i) - 3, passed[i + 1] / asked[i + 1]}, colour);
    };
    part(page, {0, 0}, page.size(), missing, [&] {
        curve([](const auto& q) { return lab14::textbook::refracted(q.in, q.normal, q.ratio).has_value(); }, red);
        curve([](const auto& q) { return lab14::refracted(q.in, q.normal, q.ratio).has_value(); }, blue);
    });
    return page;
}

}  // namespace pictures
