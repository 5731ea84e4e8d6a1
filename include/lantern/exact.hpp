// SPDX-License-Identifier: MIT
#pragma once
// Pixel values in closed form: what a picture must converge to, to compare it with. All in double.
// The derivations, in words, are in docs/headers/exact.md.

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace lantern::exact {

// ---- one effect: an edge, seen from an apex through a sampled parallelogram or disc ----------------------------------

/// The points (u, v) of a plane where a + b u + c v > 0.
struct half_plane {
    double a = 0, b = 0, c = 0;
};

/// The area that a half-plane cuts out of the unit square: the probability that a uniform point lies in it. Exact for
/// every slope, horizontal and vertical ones too; without any slope it is 1 where a > 0, else 0.
[[nodiscard]] inline double clipped_area(half_plane h) {
    // How far the highest corner of the square lies above zero, and the lowest below.
    const double above = h.a + std::max(h.b, 0.0) + std::max(h.c, 0.0);
    const double below = -(h.a + std::min(h.b, 0.0) + std::min(h.c, 0.0));
    if (!(above > 0)) return 0;
    if (!(below > 0)) return 1;
    // Of the two parts the smaller is a triangle at its corner, or a trapezium across the square: no large numbers
    // cancel.
    const double steep = std::max(std::abs(h.b), std::abs(h.c)), flat = std::min(std::abs(h.b), std::abs(h.c));
    const double d = std::min(above, below);
    const double part = d < flat ? d / steep * (d / flat) / 2 : std::min((d - flat / 2) / steep, 0.5);
    return above < below ? part : 1 - part;
}

/// A straight edge through `point`, endless in both directions. Seen from an apex P, the visible side is where
/// ((point - P) × along) · (X - P) > 0: turn `along` round for the other side.
struct edge {
    glm::dvec3 point{0}, along{1, 0, 0};
};

/// The points corner + u a + v b, u and v in [0, 1): a pixel, a rectangular light, the square of directions of the
/// glossy lobe, a square lens. What is sampled must be sampled uniformly in u and v.
struct parallelogram {
    glm::dvec3 corner{0}, a{1, 0, 0}, b{0, 1, 0};
};

/// The points center + p a + q b, p² + q² < 1: a disc of radius r where a and b are perpendicular and r long.
struct disc {
    glm::dvec3 center{0}, a{1, 0, 0}, b{0, 1, 0};
};

/// Which part of the parallelogram is seen past the edge, in the parallelogram's own u and v.
[[nodiscard]] inline half_plane seen(glm::dvec3 apex, const edge& past, const parallelogram& sampled) {
    const glm::dvec3 n = glm::cross(past.point - apex, past.along);
    return {glm::dot(n, sampled.corner - apex), glm::dot(n, sampled.a), glm::dot(n, sampled.b)};
}

/// The fraction of the parallelogram that the apex sees past the edge.
[[nodiscard]] inline double visible(glm::dvec3 apex, const edge& past, const parallelogram& sampled) {
    return clipped_area(seen(apex, past, sampled));
}

/// The part of the unit disc within t of its centre, measured along one direction: 0 at t = -1, 1 at t = 1.
[[nodiscard]] inline double disc_fraction(double t) {
    t = std::clamp(t, -1.0, 1.0);
    return 0.5 + (t * std::sqrt((1 - t) * (1 + t)) + std::asin(t)) / std::numbers::pi;
}

/// The fraction of the disc that the apex sees past the edge.
[[nodiscard]] inline double visible(glm::dvec3 apex, const edge& past, const disc& sampled) {
    const glm::dvec3 n = glm::cross(past.point - apex, past.along);
    const double height = glm::dot(n, sampled.center - apex);
    const double slope = std::hypot(glm::dot(n, sampled.a), glm::dot(n, sampled.b));
    if (!(slope > std::abs(height))) return height > 0 ? 1 : 0;
    return disc_fraction(height / slope);
}

/// The lecture's glossy square: directions r + u U + v W, u and v in [-width/2, width/2), as points seen from the
/// mirror point. U and W complete r to an orthonormal basis.
[[nodiscard]] inline parallelogram glossy_square(glm::dvec3 point, glm::dvec3 r, glm::dvec3 U, glm::dvec3 W,
                                                 double width) {
    return {point + r - width / 2 * (U + W), width * U, width * W};
}

/// A square lens of half-width `radius`. The apex is the point in focus: rays through it, traced back to the lens.
[[nodiscard]] inline parallelogram square_lens(glm::dvec3 eye, glm::dvec3 right, glm::dvec3 up, double radius) {
    return {eye - radius * (right + up), 2 * radius * right, 2 * radius * up};
}

// ---- any combination: parallel planes make every effect a weighted uniform number -----------------------------------

/// Gauss–Legendre nodes and weights on [0, 1], exact for polynomials up to degree 2 count - 1 (Newton's method on the
/// Legendre polynomial; Press et al., Numerical Recipes, section 4.6).
[[nodiscard]] inline std::vector<std::array<double, 2>> gauss_legendre(int count) {
    std::vector<std::array<double, 2>> nodes;
    for (int i = 0; i < count; ++i) {
        double x = std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5)), slope = 1;
        for (int step = 0; step < 8; ++step) {
            double p = 1, before = 0;
            for (int k = 1; k <= count; ++k) before = std::exchange(p, ((2 * k - 1) * x * p - (k - 1) * before) / k);
            slope = count * (x * p - before) / (x * x - 1);
            x -= p / slope;
        }
        nodes.push_back({(1 - x) / 2, 1 / ((1 - x * x) * slope * slope)});
    }
    return nodes;
}

namespace detail {

/// Σ_S (-1)^|S| max(0, d - Σ_S w)^n / (n! Πw) over all subsets S, and the sum of the terms' magnitudes: the rounding
/// error of `value` is about `magnitude` × 1e-15.
struct alternating {
    double value = 0, magnitude = 0;
};

/// `rates` holds 1 / (i wᵢ), i from 1: their product is 1 / (n! Πw).
inline void add_subsets(std::span<const double> w, std::span<const double> rates, std::size_t first, double rest,
                        double sign, alternating& sum) {
    if (!(rest > 0)) return;
    if (first == w.size()) {
        double term = 1;
        for (const double rate : rates) term *= rest * rate;
        sum.value += sign * term;
        sum.magnitude += term;
        return;
    }
    add_subsets(w, rates, first + 1, rest, sign, sum);
    add_subsets(w, rates, first + 1, rest - w[first], -sign, sum);
}

/// The sums of all subsets of the weights that lie strictly between two limits, ascending: where P(Σ wᵢUᵢ < d) changes
/// from one polynomial in d to the next.
[[nodiscard]] inline std::vector<double> knots(std::span<const double> w, double low, double high) {
    std::vector<double> sums{0};
    for (const double weight : w) {
        const std::size_t count = sums.size();
        for (std::size_t i = 0; i < count; ++i) sums.push_back(sums[i] + weight);
    }
    std::erase_if(sums, [&](double s) { return !(low < s && s < high); });
    std::ranges::sort(sums);
    return sums;
}

/// The same question with all weights positive and in descending order: w U = w + |w| (1 - U) where w < 0, and 1 - U is
/// uniform too.
struct risen {
    std::vector<double> weights;
    double d = 0;
};

[[nodiscard]] inline risen raise(std::span<const double> weights, double d) {
    risen r{{}, d};
    for (const double w : weights) {
        if (w < 0) r.d -= w;
        if (w != 0) r.weights.push_back(std::abs(w));
    }
    std::ranges::sort(r.weights, std::ranges::greater{});
    return r;
}

/// Weights positive, in descending order.
[[nodiscard]] inline double fraction_below_sorted(std::span<const double> w, double d) {
    double total = 0;
    for (const double weight : w) total += weight;
    if (!(d > 0)) return 0;
    if (!(d < total)) return 1;
    if (w.size() == 1) return d / total;
    if (d > total / 2) return 1 - fraction_below_sorted(w, total - d);

    std::vector<double> rates;
    for (const double weight : w) rates.push_back(1 / (weight * double(rates.size() + 1)));
    alternating sum;
    add_subsets(w, rates, 0, d, 1, sum);
    if (sum.magnitude < 512) return sum.value;

    // The terms cancel too well: a weight is small beside d. The definition without its smallest weight, averaged over
    // that weight, is a polynomial between knots; Gauss's rule averages it exactly, with positive terms only.
    const std::span<const double> larger = w.first(w.size() - 1);
    const double smallest = w.back(), low = d - smallest;
    std::vector<double> ends = knots(larger, low, d);
    ends.push_back(d);
    const auto rule = gauss_legendre(int(w.size() + 1) / 2);
    double average = 0, begin = low;
    for (const double end : ends) {
        for (const auto& [x, weight] : rule)
            average += weight * (end - begin) * fraction_below_sorted(larger, begin + x * (end - begin));
        begin = end;
    }
    return d > low ? average / (d - low) : fraction_below_sorted(larger, d);
}

}  // namespace detail

/// P(Σ wᵢUᵢ < d), the Uᵢ uniform in [0, 1) and independent: the part of the unit cube on one side of a plane. Weights
/// of any sign and size, zeros too. The work grows like 2ⁿ; the error stays below 1e-12 (Barrow and Smith 1979 for the
/// sum).
[[nodiscard]] inline double fraction_below(std::span<const double> weights, double d) {
    const detail::risen r = detail::raise(weights, d);
    if (r.weights.empty()) return r.d > 0 ? 1 : 0;
    return detail::fraction_below_sorted(r.weights, r.d);
}

/// P(R T + Σ wᵢUᵢ < d), where T is one coordinate of a uniform point of the unit disc: a combination with a round lens
/// (or a round light). The density of T is 2/π √(1-t²); with t = sin φ the integral is smooth between knots.
[[nodiscard]] inline double fraction_below(std::span<const double> weights, double radius, double d) {
    const detail::risen r = detail::raise(weights, d);
    const double R = std::abs(radius);
    if (r.weights.empty()) return R > std::abs(r.d) ? disc_fraction(r.d / R) : r.d > 0 ? 1 : 0;

    std::vector<double> ends{0, std::numbers::pi / 2};
    for (const double knot : detail::knots(r.weights, r.d - R, r.d + R))
        ends.push_back(std::asin(std::clamp((r.d - knot) / R, -1.0, 1.0)));
    std::ranges::sort(ends);
    const auto rule = gauss_legendre(16);
    double sum = 0, begin = -std::numbers::pi / 2;
    for (const double end : ends) {
        for (const auto& [x, weight] : rule) {
            const double angle = begin + x * (end - begin), cosine = std::cos(angle);
            sum += weight * (end - begin) * cosine * cosine *
                   detail::fraction_below_sorted(r.weights, r.d - R * std::sin(angle));
        }
        begin = end;
    }
    return sum * 2 / std::numbers::pi;
}

// The weight of each effect: how far the ray moves across the edge, in the plane of the edge, when its number goes from
// 0 to 1. `n` is the unit vector in that plane, perpendicular to the edge, pointing to what is hidden.

/// `right` and `down` are the pixel's sides at unit distance from the eye; the edge is at `distance`.
[[nodiscard]] inline std::array<double, 2> pixel_weights(glm::dvec3 n, double distance, glm::dvec3 right,
                                                         glm::dvec3 down) {
    return {distance * glm::dot(n, right), distance * glm::dot(n, down)};
}

/// `a` and `b` are the sides of the lens, or, for a round one, two perpendicular radii (the radius of the weighted disc
/// is then the length of the pair).
[[nodiscard]] inline std::array<double, 2> lens_weights(glm::dvec3 n, double distance, double focus_distance,
                                                        glm::dvec3 a, glm::dvec3 b) {
    const double blur = 1 - distance / focus_distance;
    return {blur * glm::dot(n, a), blur * glm::dot(n, b)};
}

/// `path` is what the edge travels during the exposure, velocity × time.
[[nodiscard]] inline double motion_weight(glm::dvec3 n, glm::dvec3 path) { return -glm::dot(n, path); }

/// `a` and `b` are the sides of the light; the edge is at height `h` above the lit plane, the light at height `H`.
/// All that moves the lit point (pixel, lens, gloss) counts 1 - h/H of its weight.
[[nodiscard]] inline std::array<double, 2> shadow_weights(glm::dvec3 n, double h, double H, glm::dvec3 a,
                                                          glm::dvec3 b) {
    return {h / H * glm::dot(n, a), h / H * glm::dot(n, b)};
}

/// A glossy lobe of width `width` around a direction perpendicular to the planes; the edge is at `distance`.
[[nodiscard]] inline std::array<double, 2> gloss_weights(glm::dvec3 n, double distance, double width, glm::dvec3 U,
                                                         glm::dvec3 W) {
    return {distance * width * glm::dot(n, U), distance * width * glm::dot(n, W)};
}

// ---- motion, and light inside a closed sphere -----------------------------------------------------------------------

/// A stretch of the exposure; empty when end <= begin.
struct stretch {
    double begin = 0, end = 0;
};

/// When, within an exposure from `open` to `close`, a fixed ray meets a moving disc: |q - v t|² < r², where q is the
/// vector from the disc's centre at t = 0 to the ray, and v the disc's velocity, both measured in the plane in which
/// the disc is one (for a sphere: the plane perpendicular to the ray).
[[nodiscard]] inline stretch crossing(glm::dvec3 q, glm::dvec3 velocity, double radius, double open, double close) {
    const double speed = glm::length(velocity), gap = glm::length(q);
    if (speed == 0) return gap < radius ? stretch{open, close} : stretch{open, open};
    const glm::dvec3 heading = velocity / speed;
    const double along = glm::dot(q, heading), aside = glm::length(q - along * heading);
    if (!(aside < radius)) return {open, open};
    const double half_chord = std::sqrt((radius - aside) * (radius + aside));
    const double begin = std::clamp((along - half_chord) / speed, open, close);
    const double end = std::clamp((along + half_chord) / speed, open, close);
    return {begin, end};
}

/// Radiance at a point of a closed sphere whose inside emits and reflects diffusely in any pattern: the emission and
/// albedo there, and their means over the sphere. Every point of a sphere sees every other by the same measure, so the
/// irradiance is the same everywhere.
[[nodiscard]] inline double closed_sphere(double emission, double albedo, double mean_emission, double mean_albedo) {
    return emission + albedo * mean_emission / (1 - mean_albedo);
}

}  // namespace lantern::exact
