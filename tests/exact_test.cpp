// SPDX-License-Identifier: MIT
#include <lantern/exact.hpp>

#include "brute_force.hpp"
#include "catch.hpp"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

using namespace lantern::exact;
using brute_force::numbers;
using brute_force::over_square;

namespace {

/// How often Σ wU (+ R T) < d among seeded samples, less what is expected, in standard deviations. Beyond ±4 once in
/// 16,000 seeds; the seeds here are fixed, so these tests cannot fail by chance, only when something is changed.
double z_of(const std::vector<double>& w, double radius, double d, double expected, std::uint64_t seed) {
    numbers uniform(seed);
    const int count = 400'000;
    int below = 0;
    for (int i = 0; i < count; ++i) {
        double sum = 0;
        for (const double weight : w) sum += weight * uniform();
        if (radius != 0) {
            double x = 0, y = 0;
            do {
                x = uniform(-1, 1);
                y = uniform(-1, 1);
            } while (x * x + y * y >= 1);
            sum += radius * x;
        }
        below += sum < d;
    }
    return (double(below) / count - expected) / std::sqrt(expected * (1 - expected) / count);
}

/// P(Σ wU < d) for whole weights, each U one of the w m numbers (k + ½) / (w m): all sums lie on a lattice of step 1/m,
/// and how many ways lead to each is counted exactly, as when dice are thrown.
double by_counting(const std::vector<int>& w, double d, int m) {
    std::vector<double> ways{1};
    for (const int weight : w) {
        const std::size_t faces = std::size_t(weight) * std::size_t(m);
        std::vector<double> next(ways.size() + faces, 0);
        double window = 0;
        for (std::size_t s = 0; s < next.size(); ++s) {
            if (s < ways.size()) window += ways[s];
            if (s >= faces) window -= ways[s - faces];
            next[s] = window / double(faces);
        }
        ways = std::move(next);
    }
    double below = 0;
    for (std::size_t s = 0; s < ways.size(); ++s)
        below += ways[s] * std::clamp(d * m - (double(s) + double(w.size()) / 2) + 0.5, 0.0, 1.0);
    return below;
}

}  // namespace

TEST_CASE("a half-plane cuts from the unit square what brute force counts") {
    numbers uniform(1);
    for (int trial = 0; trial < 50; ++trial) {
        const half_plane h{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
        const double counted =
            over_square(1000, [&](double u, double v) { return h.a + h.b * u + h.c * v > 0 ? 1.0 : 0.0; });
        CHECK(clipped_area(h) == Approx(counted).margin(5e-4));
    }
}

TEST_CASE("a clipped area is exact for simple cuts, level ones and corners too") {
    CHECK(clipped_area({0.25, -1, 0}) == 0.25);
    CHECK(clipped_area({-0.25, 0, 1}) == 0.75);
    CHECK(clipped_area({0, 1, -1}) == 0.5);
    CHECK(clipped_area({0.5, -1, -1}) == 0.125);
    CHECK(clipped_area({1, 0, 0}) == 1);
    CHECK(clipped_area({0, 0, 0}) == 0);
    CHECK(clipped_area({-1, 0, 0}) == 0);
    CHECK(clipped_area({0, 1, 1}) == 1);
    CHECK(clipped_area({0, -1, -1}) == 0);
}

TEST_CASE("a clipped area and its complement fill the square, whatever the slopes") {
    numbers uniform(2);
    for (int trial = 0; trial < 2000; ++trial) {
        const half_plane h{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1) * std::pow(10, uniform(-320, 0))};
        const double seen = clipped_area(h), hidden = clipped_area({-h.a, -h.b, -h.c});
        CHECK(seen >= 0);
        CHECK(seen + hidden == Approx(1).epsilon(0).margin(4e-16));
        CHECK(clipped_area({h.a * 1e100, h.b * 1e100, h.c * 1e100}) == Approx(seen).epsilon(0).margin(4e-16));
    }
}

TEST_CASE("a clipped area keeps all digits of a tiny corner") {
    CHECK(clipped_area({1e-20, -1, -1}) == Approx(0.5e-40).epsilon(1e-15));
    CHECK(clipped_area({1e-200, -1e-100, -1}) == Approx(0.5e-300).epsilon(1e-15));
}

TEST_CASE("the apex sees of a parallelogram what rays to it count") {
    numbers uniform(3);
    for (int trial = 0; trial < 20; ++trial) {
        const glm::dvec3 apex = uniform.vector(), along = uniform.vector();
        const parallelogram sampled{uniform.vector() + glm::dvec3(0, 0, 4), uniform.vector(), uniform.vector()};
        const glm::dvec3 middle = sampled.corner + 0.5 * (sampled.a + sampled.b);
        const edge past{apex + 0.4 * (middle - apex) + 0.2 * uniform.vector(), along};
        // The same question in other words: on which side of the line does the ray pass? The sign of a determinant.
        const double counted = over_square(500, [&](double u, double v) {
            const glm::dvec3 ray = sampled.corner + u * sampled.a + v * sampled.b - apex, to_edge = past.point - apex;
            const double det = to_edge.x * (along.y * ray.z - along.z * ray.y) -
                               to_edge.y * (along.x * ray.z - along.z * ray.x) +
                               to_edge.z * (along.x * ray.y - along.y * ray.x);
            return det > 0 ? 1.0 : 0.0;
        });
        CHECK(visible(apex, past, sampled) == Approx(counted).margin(1e-3));
        CHECK(visible(apex, {past.point + 7.0 * along, 3.0 * along}, sampled) ==
              Approx(visible(apex, past, sampled)).margin(1e-12));
        CHECK(visible(apex, {past.point, -along}, sampled) == Approx(1 - visible(apex, past, sampled)).margin(1e-12));
    }
}

TEST_CASE("the apex sees of a disc what rays to it count") {
    numbers uniform(4);
    for (int trial = 0; trial < 20; ++trial) {
        const glm::dvec3 apex = uniform.vector(), along = uniform.vector();
        const disc sampled{uniform.vector() + glm::dvec3(0, 0, 4), uniform.vector(), uniform.vector()};
        const edge past{apex + 0.4 * (sampled.center - apex) + 0.2 * uniform.vector(), along};
        const glm::dvec3 n = glm::cross(past.point - apex, along);
        double inside = 0;
        const double counted = over_square(1000, [&](double u, double v) {
            const double p = 2 * u - 1, q = 2 * v - 1;
            if (p * p + q * q >= 1) return 0.0;
            ++inside;
            return glm::dot(n, sampled.center + p * sampled.a + q * sampled.b - apex) > 0 ? 1.0 : 0.0;
        });
        CHECK(visible(apex, past, sampled) == Approx(counted * 1e6 / inside).margin(1e-3));
    }
}

TEST_CASE("half a disc is seen past its diameter, all or nothing from beside it") {
    CHECK(disc_fraction(0) == 0.5);
    CHECK(disc_fraction(1) == 1);
    CHECK(disc_fraction(-1) == Approx(0).margin(1e-16));
    const edge past{{0, 0, 1}, {0, 1, 0}};  // visible: n = (0,0,1) × (0,1,0) = (-1,0,0)
    CHECK(visible({0, 0, 0}, past, disc{{0, 0, 2}, {1, 0, 0}, {0, 1, 0}}) == 0.5);
    CHECK(visible({0, 0, 0}, past, disc{{-1, 0, 2}, {1, 0, 0}, {0, 1, 0}}) == 1);
    CHECK(visible({0, 0, 0}, past, disc{{1, 0, 2}, {1, 0, 0}, {0, 1, 0}}) == 0);
    CHECK(visible({0, 0, 0}, past, disc{{-1, 0, 2}, {0, 0, 0}, {0, 0, 0}}) == 1);
}

TEST_CASE("gloss and a square lens are parallelograms seen past an edge") {
    // Mirrored straight up, lobe of width .4; an edge at height 2, .1 aside: u hits it at .1 / 2 of [-.2, .2).
    const parallelogram lobe = glossy_square({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, 0.4);
    CHECK(visible({0, 0, 0}, {{0.1, 0, 2}, {0, 1, 0}}, lobe) == Approx((0.05 + 0.2) / 0.4));
    // A lens of half-width 1 focused at distance 4, an edge at distance 3, .1 aside: there the lens has a quarter of
    // its width.
    const parallelogram lens = square_lens({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1);
    CHECK(visible({0, 0, 4}, {{0.1, 0, 3}, {0, -1, 0}}, lens) == Approx((0.1 * 4 + 1) / 2));
}

TEST_CASE("Gauss's rule is exact for polynomials of twice its size, less one") {
    for (int count = 1; count <= 16; ++count)
        for (int power = 0; power < 2 * count; ++power) {
            double sum = 0;
            for (const auto& [x, weight] : gauss_legendre(count)) sum += weight * std::pow(x, power);
            CHECK(sum == Approx(1.0 / (power + 1)).epsilon(1e-13));
        }
}

TEST_CASE("one and two weighted numbers give the clipped line and square") {
    CHECK(fraction_below(std::array{2.0}, 0.5) == 0.25);
    CHECK(fraction_below(std::array{-2.0}, -0.5) == 0.75);
    numbers uniform(5);
    for (int trial = 0; trial < 1000; ++trial) {
        const double w1 = uniform(-1, 1), w2 = uniform(-1, 1) * std::pow(10, uniform(-30, 0)), d = uniform(-1, 1);
        CHECK(fraction_below(std::array{w1, w2}, d) == Approx(clipped_area({d, -w1, -w2})).epsilon(0).margin(1e-13));
    }
}

TEST_CASE("any number of weights, of any sign, give what samples count") {
    numbers uniform(6);
    for (const std::size_t n : {1u, 2u, 3u, 4u, 5u, 7u, 9u})
        for (const bool uneven : {false, true}) {
            std::vector<double> w(n);
            double low = 0, high = 0;
            for (double& weight : w) {
                weight = uniform(-1, 1) * (uneven ? std::pow(10, uniform(-6, 0)) : 1);
                (weight < 0 ? low : high) += weight;
            }
            const double d = low + uniform(0.3, 0.6) * (high - low);
            const double expected = fraction_below(w, d);
            CAPTURE(n, uneven, d, expected);
            CHECK(std::abs(z_of(w, 0, d, expected, n)) < 4);
        }
}

TEST_CASE("seven whole weights give what a lattice counts, to six digits") {
    // Seven numbers: pixel, lens, light and time together.
    const std::vector<int> whole{1, 2, 3, 3, 4, 5, 7};
    const std::vector<double> w(whole.begin(), whole.end());
    for (const double d : {3.0, 6.5, 9.0, 12.5, 16.0, 21.0})
        CHECK(fraction_below(w, d) == Approx(by_counting(whole, d, 400)).epsilon(0).margin(1e-6));
}

TEST_CASE("a weight averages over its length") {
    // d F_n/d d · w = F_{n-1}(d) - F_{n-1}(d - w), integrated by Simpson's rule.
    numbers uniform(7);
    for (int trial = 0; trial < 20; ++trial) {
        std::vector<double> w(6);
        for (double& weight : w) weight = uniform(0.1, 1);
        std::vector<double> more = w;
        more.push_back(std::pow(10, uniform(-4, 0)));
        const double d = uniform(0.5, 3.5), last = more.back();
        const int steps = 200;
        double sum = 0;
        for (int i = 0; i <= steps; ++i)
            sum += (i == 0 || i == steps ? 1 : i % 2 ? 4 : 2) * fraction_below(w, d - last * i / steps);
        CHECK(fraction_below(more, d) == Approx(sum / (3 * steps)).epsilon(0).margin(1e-9));
    }
}

TEST_CASE("tiny weights neither count nor spoil the sum") {
    const std::vector<double> four{1, -0.7, 0.6, 0.3};
    for (const double d : {-0.4, 0.1, 0.55, 0.9}) {
        const double without = fraction_below(four, d);
        for (double tiny = 1e-2; tiny > 1e-300; tiny *= 1e-3) {
            // Three tiny weights move the threshold by their mean, and blur it by their squares.
            const std::vector<double> w{tiny, 1, -0.7, 2 * tiny, 0.6, 0.3, -tiny};
            CHECK(fraction_below(w, d) ==
                  Approx(fraction_below(four, d - tiny)).epsilon(0).margin(1e-12 + 3 * tiny * tiny));
        }
        CHECK(fraction_below(std::vector<double>{0, 1, -0.7, 0.6, 0, 0.3}, d) == without);
    }
    CHECK(fraction_below(std::vector<double>{}, 1) == 1);
    CHECK(fraction_below(std::vector<double>{0, 0}, -1) == 0);
    CHECK(fraction_below(std::vector<double>{1e-310, 1e-310}, 1e-310) == Approx(0.5));
}

TEST_CASE("seven weights of all sizes rise from 0 to 1, whatever their order and scale") {
    numbers uniform(8);
    for (int trial = 0; trial < 30; ++trial) {
        std::vector<double> w(7);
        double low = 0, high = 0;
        for (double& weight : w) {
            weight = uniform(-1, 1) * std::pow(10, uniform(-9, 0));
            (weight < 0 ? low : high) += weight;
        }
        CHECK(fraction_below(w, low) == Approx(0).margin(1e-12));
        CHECK(fraction_below(w, high) == Approx(1).epsilon(1e-12));
        double before = 0;
        for (int i = 1; i < 40; ++i) {
            const double d = low + (high - low) * i / 40, here = fraction_below(w, d);
            CHECK(here >= before - 1e-12);
            CHECK(here <= 1 + 1e-12);
            before = here;
        }
        const double d = low + 0.4 * (high - low), here = fraction_below(w, d);
        std::vector<double> other(w.rbegin(), w.rend()), opposite = w;
        for (double& weight : other) weight *= 1e6;
        for (double& weight : opposite) weight = -weight;
        CHECK(fraction_below(other, d * 1e6) == Approx(here).epsilon(0).margin(1e-11));
        CHECK(1 - fraction_below(opposite, -d) == Approx(here).epsilon(0).margin(1e-11));
    }
}

TEST_CASE("a round lens with any other effects gives what samples count") {
    numbers uniform(9);
    for (const std::size_t n : {0u, 1u, 2u, 3u, 5u}) {
        std::vector<double> w(n);
        double middle = 0;
        for (double& weight : w) middle += 0.4 * (weight = uniform(-1, 1));
        const double expected = fraction_below(w, 0.6, middle);
        CAPTURE(n, expected);
        CHECK(std::abs(z_of(w, 0.6, middle, expected, 20 + n)) < 4);
    }
}

TEST_CASE("a round lens of no size is a pinhole, and alone it is a disc") {
    const std::vector<double> w{0.4, -0.3, 0.2};
    CHECK(fraction_below(w, 0, 0.1) == Approx(fraction_below(w, 0.1)).epsilon(1e-13));
    CHECK(fraction_below(w, 1e-9, 0.1) == Approx(fraction_below(w, 0.1)).epsilon(1e-9));
    CHECK(fraction_below(w, -0.5, 0.1) == fraction_below(w, 0.5, 0.1));
    CHECK(fraction_below(std::vector<double>{}, 2, 1) == disc_fraction(0.5));
    CHECK(fraction_below(std::array{1e-9}, 2, 1) == Approx(disc_fraction(0.5)).epsilon(1e-8));
    CHECK(fraction_below(std::vector<double>{}, 2, 3) == 1);
}

TEST_CASE("the weights of the effects are how far rays move across the edge") {
    // A ray from eye + l towards the point in focus, past an edge at distance D, that moves by v t: checked by tracing
    // it.
    const glm::dvec3 n(0.6, 0.8, 0), right(0.5, 0, 0), down(0, -0.4, 0), a(0.3, 0, 0), b(0, 0.3, 0), path(0.2, -0.1, 0);
    const double D = 3, focus = 5;
    const auto pixel = pixel_weights(n, D, right, down), lens = lens_weights(n, D, focus, a, b);
    const double motion = motion_weight(n, path);
    const auto crossing_at = [&](double x, double y, double u, double v, double t) {
        const glm::dvec3 film = x * right + y * down + glm::dvec3(0, 0, 1), from = u * a + v * b;
        const glm::dvec3 direction = focus * film - from;
        return glm::dot(n, from + direction * (D / direction.z) - t * path);
    };
    const double start = crossing_at(0, 0, 0, 0, 0);
    CHECK(crossing_at(1, 0, 0, 0, 0) - start == Approx(pixel[0]));
    CHECK(crossing_at(0, 1, 0, 0, 0) - start == Approx(pixel[1]));
    CHECK(crossing_at(0, 0, 1, 0, 0) - start == Approx(lens[0]));
    CHECK(crossing_at(0, 0, 0, 1, 0) - start == Approx(lens[1]));
    CHECK(crossing_at(0, 0, 0, 0, 1) - start == Approx(motion));
    CHECK(crossing_at(1, 1, 1, 1, 1) - start == Approx(pixel[0] + pixel[1] + lens[0] + lens[1] + motion));

    // A shadow ray from the ground to a light at height 4 crosses height 3 after 3/4 of its way.
    const auto shadow = shadow_weights(n, 3, 4, a, b);
    CHECK(shadow[0] == Approx(0.75 * glm::dot(n, a)));
    CHECK(shadow[1] == Approx(0.75 * glm::dot(n, b)));
    // A reflected ray (u, v, 1) · 2.
    const auto gloss = gloss_weights(n, 2, 0.1, {1, 0, 0}, {0, 1, 0});
    CHECK(gloss[0] == Approx(2 * 0.1 * 0.6));
    CHECK(gloss[1] == Approx(2 * 0.1 * 0.8));
}

TEST_CASE("a combination of pixel and lens is what the apex says of the pixel, averaged over the lens") {
    // Two of the closed forms against each other: for every point of the lens, the part of the pixel that is seen.
    const glm::dvec3 right(0.5, 0, 0), down(0, -0.4, 0), along(0.8, -0.6, 0), n(0.6, 0.8, 0);
    const double D = 3, focus = 5,
                 c = 0.3;  // hidden where n · x > c at distance D; n is the edge's direction turned round z
    const edge past{c * n + glm::dvec3(0, 0, D), along};
    const double averaged = over_square(40, [&](double u, double v) {
        const glm::dvec3 from(0.3 * u, 0.3 * v, 0);
        const parallelogram pixel{{0, 0, focus}, focus * right, focus * down};
        return visible(from, past, pixel);
    });
    std::vector<double> w;
    for (const double x : pixel_weights(n, D, right, down)) w.push_back(x);
    for (const double x : lens_weights(n, D, focus, {0.3, 0, 0}, {0, 0.3, 0})) w.push_back(x);
    const double combined = fraction_below(w, c);
    CHECK(std::min(std::abs(combined - averaged), std::abs(1 - combined - averaged)) < 1e-4);
}

TEST_CASE("a fixed ray meets a moving disc when brute force says so") {
    numbers uniform(10);
    int met = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const glm::dvec3 q(uniform(-1, 1), uniform(-1, 1), 0), v(uniform(-2, 2), uniform(-2, 2), 0);
        const double radius = uniform(0.1, 0.8);
        const stretch s = crossing(q, v, radius, 0.25, 0.75);
        int inside = 0;
        const int steps = 20'000;
        for (int i = 0; i < steps; ++i) {
            const double t = 0.25 + 0.5 * (i + 0.5) / steps;
            inside += glm::length(q - t * v) < radius;
        }
        met += inside > 0;
        CHECK(s.end - s.begin == Approx(0.5 * inside / steps).margin(1e-4));
    }
    CHECK(met > 50);
    CHECK(met < 150);
}

TEST_CASE("a disc at rest is met always or never") {
    const stretch always = crossing({0.5, 0, 0}, {0, 0, 0}, 1, 0, 1), never = crossing({2, 0, 0}, {0, 0, 0}, 1, 0, 1);
    CHECK(always.end - always.begin == 1);
    CHECK(never.end - never.begin == 0);
}

TEST_CASE("light in a closed sphere: bounce after bounce adds up to the closed form") {
    // The sphere in patches of equal area, each with its own emission and albedo; every patch sees all by the same
    // measure.
    numbers uniform(11);
    const std::size_t patches = 50;
    std::vector<double> emission(patches), albedo(patches), radiance(patches, 0.0);
    double mean_emission = 0, mean_albedo = 0;
    for (std::size_t i = 0; i < patches; ++i) {
        mean_emission += (emission[i] = uniform()) / patches;
        mean_albedo += (albedo[i] = uniform()) / patches;
    }
    for (int bounce = 0; bounce < 200; ++bounce) {
        double arriving = 0;
        for (const double r : radiance) arriving += r / patches;
        for (std::size_t i = 0; i < patches; ++i) radiance[i] = emission[i] + albedo[i] * arriving;
    }
    for (std::size_t i = 0; i < patches; ++i)
        CHECK(closed_sphere(emission[i], albedo[i], mean_emission, mean_albedo) == Approx(radiance[i]).epsilon(1e-12));
}
