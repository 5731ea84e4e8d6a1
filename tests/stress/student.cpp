// SPDX-License-Identifier: MIT
// A student's lab 14 under stress: what it has is judged, the rest is n/a. ./lab stress --student runs it.

#include "scorecard.hpp"

#include <lab14_extremes/extremes.hpp>

#include <lantern/todo.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <optional>
#include <string_view>
#include <vector>

namespace {

using namespace stress;

lantern::ray plain(const ray& r) { return {r.origin, r.direction}; }

/// A point that is brought back onto its surface, or, as long as that is not written, left where the ray met it.
template <class On>
glm::vec3 point(const ray& r, float t, const On& on) {
    try {
        return on();
    } catch (const lantern::unfinished&) {
        return lantern::at(plain(r), t);
    }
}

bool is_finite(glm::vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// What the lab does not ask for is added here: the normal, that against the ray where there is none; a point beyond the largest float is a miss.
surface_answer complete(const ray& r, float t, glm::vec3 p, const glm::dvec3& normal) {
    const double length = glm::length(normal);
    const glm::dvec3 n = length > 0 ? normal / length : -glm::normalize(glm::dvec3(r.direction));
    if (!is_finite(p)) return std::nullopt;
    return hit{t, p, glm::vec3(n), 0};
}

struct lab14_adapter {
    static surface_answer sphere(glm::vec3 center, float radius, ray r) {
        const auto t = lab14::hit_sphere(center, radius, plain(r));
        if (!t) return std::nullopt;
        const glm::vec3 p = point(r, *t, [&] { return lab14::on_sphere(center, radius, plain(r), *t); });
        const glm::dvec3 d(r.direction), from = glm::dvec3(r.origin) - glm::dvec3(center);
        glm::dvec3 out = from + double(*t) * d;
        for (int i = 0; i < 3; ++i) {  // Newton's steps: t before it was rounded
            const double step = (glm::dot(out, out) - double(radius) * double(radius)) / (2 * glm::dot(out, d));
            if (std::abs(step) <= 0x1p-23 * double(*t)) out -= step * d;
        }
        return complete(r, *t, p, radius < 0 ? -out : out);
    }
    static surface_answer triangle(glm::vec3 a, glm::vec3 b, glm::vec3 c, ray r) {
        const auto t = lab14::hit_triangle(a, b, c, plain(r));
        if (!t) return std::nullopt;
        const glm::dvec3 n = glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
        return complete(r, *t, point(r, *t, [&] { return lab14::on_triangle(a, b, c, plain(r), *t); }), n);
    }
    static bool meets_box(box b, ray r) { return lab14::meets_box(b.min, b.max, plain(r)); }
    static glm::vec3 leave(hit h, glm::vec3 direction) { return lab14::leave(h.point, h.normal, direction); }
    static frame basis(glm::vec3 w) {
        const auto f = lab14::basis_around(w);
        return {f.u, f.v, f.w};
    }
    static total mean(const std::vector<glm::vec3>& samples, std::uint64_t times) {
        std::array<lab14::accumulator, 3> sums;
        for (std::uint64_t i = 0; i < times; ++i)
            for (const glm::vec3& s : samples)  // a colour is left out as a whole
                for (int c = 0; c < 3; ++c) add(sums[std::size_t(c)], is_finite(s) ? s[c] : std::nanf(""));
        return {{lab14::mean(sums[0]), lab14::mean(sums[1]), lab14::mean(sums[2])}, sums[0].rejected};
    }
    /// The reflectance is Fresnel's, from the student's direction: tan and sin of the difference and of the sum of the angles.
    static std::optional<bent> refracted(glm::vec3 in, glm::vec3 normal, float ratio) {
        const auto out = lab14::refracted(in, normal, ratio);
        if (!out) return std::nullopt;
        const glm::dvec3 d = glm::normalize(glm::dvec3(in)), n = glm::normalize(glm::dvec3(normal));
        const double sine = double(ratio) * glm::length(glm::cross(n, d));
        const double a = -glm::dot(n, d), b = std::sqrt(std::max(0.0, (1 - sine) * (1 + sine))), r = double(ratio);
        const double s = (r * a - b) / (r * a + b), p = (a - r * b) / (a + r * b);
        return bent{*out, static_cast<float>((s * s + p * p) / 2)};
    }
};

}  // namespace

int main(int argc, char** argv) try {
    const bool json = argc > 1 && std::string_view(argv[1]) == "--json";
    const answers student = answers_of("lab 14", lab14_adapter{});
    const std::vector<test_case> cases = all_cases(LANTERN_STRESS_DATA);
    std::vector<result> results;
    for (const test_case& c : cases) results.push_back(run(c, student, false));
    std::fputs((json ? json_of(results) : table_of(results)).c_str(), stdout);
    return std::none_of(results.begin(), results.end(), [](const result& r) { return r.said == verdict::fail; }) ? 0 : 1;
} catch (const std::exception& problem) {
    std::fprintf(stderr, "stress: %s\n", problem.what());
    return 1;
}
