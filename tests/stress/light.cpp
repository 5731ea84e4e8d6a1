// SPDX-License-Identifier: MIT
// Stiff light transport: lamps of hardly any size, gloss that is nearly a mirror, deep glass, walls that absorb nearly nothing.

#include "laws.hpp"

#include <numbers>

namespace stress {

namespace {

/// A lamp straight above: π (R/d)² arrives, however small it is.
void lamp(const answers& a, score& s, std::uint32_t i) {
    dice d = dice_of(i, 700);
    const glm::vec3 point = d.in_cube();
    const glm::dvec3 normal = d.on_sphere(), up = glm::normalize(normal + 0.7 * d.on_sphere());
    const float distance = d.between(1, 20);
    const ball b{point + glm::vec3(double(distance) * up), distance * d.magnitude_between(-9, -1)};
    const glm::dvec3 to = glm::dvec3(b.center) - glm::dvec3(point);
    const double distance2 = glm::dot(to, to), cosine = glm::dot(to, normal) / std::sqrt(distance2), size2 = double(b.radius) * double(b.radius) / distance2;
    if (cosine < 1.1 * std::sqrt(size2)) return s.right();  // partly below the horizon
    double sum = 0;
    bool on_it = true;
    for (int x = 0; x < 16; ++x)
        for (int y = 0; y < 16; ++y) {
            const auto [from, irradiance] = a.sphere_light(b, point, {(static_cast<float>(x) + 0.5f) / 16, (static_cast<float>(y) + 0.5f) / 16});
            const glm::dvec3 way = glm::dvec3(from) - glm::dvec3(point);
            sum += double(irradiance) * glm::dot(way, normal) / glm::length(way) / 256;
            const double rounding = 8 * 0x1p-23 * (glm::length(glm::dvec3(b.center)) + glm::length(glm::dvec3(point)));
            on_it = on_it && std::abs(glm::length(glm::dvec3(from) - glm::dvec3(b.center)) - double(b.radius)) <= rounding + 1e-6 * double(b.radius);
        }
    s.check(on_it, "light comes from where the lamp is not:" + shown({b.center, glm::vec3(b.radius)}));
    // Sixteen by sixteen midpoints of a cosine over the cone: wrong by about size2 / 500, and by roundings of the places.
    const double truth = std::numbers::pi * size2 * cosine, error = std::abs(sum / truth - 1);
    s.check(error <= 1e-2 * size2 + 2e-6 / cosine, "irradiance " + std::to_string(sum / truth) + " times the truth, radius / distance " + std::to_string(std::sqrt(size2)));
}

/// tan of the angle to the mirrored direction is the length of (u, v).
void gloss(const answers& a, score& s, std::uint32_t i) {
    dice d = dice_of(i, 701);
    const glm::vec3 r(double(d.magnitude_between(-5, 5)) * d.on_sphere());
    const float width = i % 16 == 0 ? 0 : d.magnitude_between(-7, 0.5);
    const glm::vec2 xi(d.between(0, 1), d.between(0, 1));
    const glm::vec3 got = a.perturbed(r, width, xi);
    if (width == 0) {
        const glm::dvec3 w = glm::normalize(glm::dvec3(r));
        return s.check(glm::length(glm::normalize(glm::dvec3(got)) - w) <= 1.2e-7, "width 0 turns the ray:" + shown({r, got}));
    }
    const glm::dvec3 w = glm::normalize(glm::dvec3(r)), g(got);
    const double u = double(width) * (double(xi.x) - 0.5), v = double(width) * (double(xi.y) - 0.5);
    const double off = glm::length(glm::cross(w, g)) / glm::dot(w, g);
    // Whatever the basis: only the length of (u, v) can be told. Rounding the direction costs an ulp of 1, along either way.
    s.check(std::abs(off - std::hypot(u, v)) <= 2.5e-7 * (1 + off * off) && std::abs(glm::length(g) - 1) <= 2e-7,
            "blurred by " + std::to_string(off) + " for " + std::to_string(std::hypot(u, v)) + ", of" + shown({r, glm::vec3(width)}));
}

/// Into a slab and out of it, sixty-four times: the ray goes on as it came.
void deep_glass(const answers& a, score& s, std::uint32_t i) {
    dice d = dice_of(i, 702);
    const glm::dvec3 n = d.on_sphere(), along = glm::normalize(glm::cross(n, d.on_sphere()));
    const double slope = d.magnitude_between(-3, 0.5);
    const glm::vec3 in(glm::normalize(slope * along - n)), normal(n);
    const float index = d.between(1.1, 2.5);
    glm::vec3 way = in;
    double passed = 1;
    for (int k = 0; k < 64; ++k)
        for (const float ratio : {1 / index, index}) {
            const auto b = a.refracted(way, normal, ratio);
            if (!b) return s.wrong("total reflection within a slab:" + shown({in, normal, glm::vec3(index)}));
            way = b->direction;
            passed *= 1 - double(b->reflectance);
        }
    // Each of 128 boundaries rounds the direction once: a walk of √128 half ulps, stretched a little where it leaves at a slant.
    const double off = glm::length(glm::dvec3(way) - glm::dvec3(in));
    s.check(off <= 3e-6 * (1 + slope * slope) && passed >= 0 && passed <= 1, "turned by " + std::to_string(off * 1e6) + "e-6:" + shown({in, way}));
    // Fresnel's law gives both boundaries of a slab the same reflectance.
    const auto enter = a.refracted(in, normal, 1 / index);
    if (!enter) return s.wrong("total reflection outside");
    const auto exit = a.refracted(enter->direction, normal, index);
    s.check(exit && std::abs(exit->reflectance - enter->reflectance) <= 1e-5f * (1 + static_cast<float>(slope)) * enter->reflectance + 1e-7f,
            "another reflectance on the way out:" + shown({in, normal}));
}

}  // namespace

void add_light(std::vector<test_case>& cases) {
    add(cases, "light/tiny-lamp", "a sphere of 1e-9 to 1e-1 of its distance: π (R/d)² cos θ arrives, from places on it", "Shirley, Wang and Zimmerman 1996",
        "rounding of the places", [](const answers& a) { return a.sphere_light; }, lamp);
    add(cases, "light/near-mirror", "gloss of width 1e-7 to 3, and 0; reflected rays of any length", "Cook, Porter and Carpenter 1984", "one rounding of the direction",
        [](const answers& a) { return a.perturbed; }, gloss);
    add(cases, "light/deep-glass", "64 slabs: the ray leaves as it came, and both sides of each reflect alike", "Stokes 1849: the same reflectance from within", "128 roundings",
        [](const answers& a) { return a.refracted; }, deep_glass);
    cases.push_back({"light/furnace", "closed walls of albedo .999, each emitting 1: the mean of 1 / (1 - albedo)", "a depth cap of 50 loses 95 %",
                     "four standard errors of the mean: one right answer in 16 000 fails", 2, 0.501, [](const answers& a) { return bool(a.furnace); },
                     [](const answers& a, bool, score& s) {
                         constexpr float albedo = 0.999f;
                         const double truth = 1 / (1 - double(albedo));
                         double sum = 0, sum2 = 0;
                         for (std::uint32_t i = 0; i < variants; ++i) {
                             const double x = a.furnace(albedo, 4, i) / truth;
                             sum += x, sum2 += x * x;
                             s.check(std::isfinite(x) && x >= 0, "not finite");
                         }
                         const double mean = sum / variants, variance = std::max(0.0, sum2 / variants - mean * mean) / (variants - 1);
                         s.check(std::abs(mean - 1) <= 4 * std::sqrt(variance) + 1e-6, "the mean is " + std::to_string(mean) + " of the truth");
                         s.check(variance < 0.01, "hardly converges");
                     }});
}

}  // namespace stress
