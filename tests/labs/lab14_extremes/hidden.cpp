// SPDX-License-Identifier: MIT
// Lab 14's hidden tests: the hard cases of the public suite, drawn anew for each grading. Whole numbers know the answers, so nothing is
// left to chance. An answer may be off by one ulp, or by two where the solution is within one.

#include "contract.hpp"

#include "../../../labs/lab14_extremes/cases.hpp"

#include <catch.hpp>
#include <hidden.hpp>

#include <cmath>
#include <limits>
#include <vector>

using namespace contract::lab14;
using glm::dvec3;
using glm::vec3;

namespace {

void check(const extremes::score& s, double ulp) {
    CHECK(s.asked > 0);
    CHECK(s.wrong == 0);
    CHECK(s.ulp <= ulp);
}

const std::vector<float> sizes{1e-6f, 1e-3f, 1, 1e3f, 1e6f};

}  // namespace

TEST_CASE("any sphere, however hard", "[step1]") {
    for (int which = 0; which < int(extremes::sphere_names.size()); ++which) check(extremes::judge_spheres(which, hit_sphere, hidden::seed(1)), 1);
}

TEST_CASE("any triangle, however hard", "[step2]") {
    for (int which = 0; which < int(extremes::triangle_names.size()); ++which) check(extremes::judge_triangles(which, hit_triangle, hidden::seed(2)), 1);
}

TEST_CASE("no ray passes through any cloth", "[step2]") {
    for (const bool vertices : {false, true})
        for (const int scale : {0, -13, -50}) check(extremes::judge_leaks(vertices, scale, hit_triangle, 100, hidden::seed(3)), 0);
}

TEST_CASE("any box, however it is touched", "[step3]") {
    for (int which = 0; which < int(extremes::box_names.size()); ++which) check(extremes::judge_boxes(which, meets_box, hidden::seed(4)), 0);
}

TEST_CASE("leaving any surface, at any scale", "[step4]") {
    for (const float size : sizes) {
        const auto spheres = extremes::leave_spheres(size, on_sphere, leave, 200, hidden::seed(5));
        const auto triangles = extremes::leave_triangles(size, on_triangle, leave, 200, hidden::seed(5));
        CHECK((spheres.acne == 0 && spheres.lost == 0));
        CHECK((triangles.acne == 0 && triangles.lost == 0));
    }
}

TEST_CASE("any point is brought back onto its sphere", "[step4]") {
    numbers random = hidden::drawn(6);
    for (const float size : sizes)
        for (int i = 0; i < 50; ++i) {
            const vec3 c = size * 3.0f * random.direction(), n = random.direction();
            const float radius = size * random.between(0.1f, 1.1f), distance = 1000 * size * random.unit();
            const lantern::ray r{c + (radius + distance) * n, -n};
            const dvec3 met = dvec3(r.origin) + double(distance) * dvec3(r.direction), p(on_sphere(c, radius, r, distance));
            CHECK(std::abs(glm::length(p - dvec3(c)) - double(radius)) <= extremes::ulp_of(double(extremes::largest(vec3(p)))));
            CHECK(glm::length(p - met) <= 4e-4 * double(size));
        }
}

TEST_CASE("a frame around any vector", "[step5]") {
    for (int which = 0; which < int(extremes::basis_names.size()); ++which) check(extremes::judge_bases(which, basis_around, hidden::seed(7)), 2);
}

TEST_CASE("the mean of any samples", "[step6]") {
    numbers random = hidden::drawn(8);
    for (int i = 0; i < 40; ++i) {
        std::vector<float> samples;
        double sum = 0;
        std::uint64_t good = 0, bad = 0;
        const std::uint64_t times = 1 + hidden::below(random, i < 4 ? 300'000 : 100);
        for (std::uint32_t k = hidden::below(random, 40); k > 0; --k) {
            const float kind = random.unit(), sample = hidden::magnitude(random, 1e-3f, 1e4f);
            const bool finite = kind < 0.8f;
            samples.push_back(finite ? sample : kind < 0.9f ? std::numeric_limits<float>::quiet_NaN() : std::copysign(INFINITY, kind - 0.95f));
            if (finite) sum += double(sample);
            ++(finite ? good : bad);
        }
        const mean_then m = mean_of(samples, times);
        const double truth = good > 0 ? sum / double(good) : 0;
        CHECK(std::abs(double(m.mean) - truth) <= extremes::ulp_of(truth));
        CHECK(m.rejected == bad * times);
    }
}

TEST_CASE("total reflection, wherever it begins", "[step7]") { check(extremes::judge_refractions(refracted, hidden::seed(9)), 2); }

TEST_CASE("any light is bent by Snell's law", "[step7]") {
    numbers random = hidden::drawn(10);
    for (int i = 0; i < 300; ++i) {
        const vec3 n = hidden::magnitude(random, 1e-3f, 1e3f) * random.direction(), d = hidden::magnitude(random, 1e-3f, 1e3f) * random.direction();
        const float ratio = random.between(0.5f, 1.5f);
        const double sine = double(ratio) * glm::length(glm::cross(glm::normalize(dvec3(n)), glm::normalize(dvec3(d))));
        if (glm::dot(glm::normalize(n), glm::normalize(d)) > -0.01f || std::abs(sine - 1) < 0.01) continue;
        const auto out = refracted(d, n, ratio);
        REQUIRE(out.has_value() == (sine < 1));
        if (out) CHECK(extremes::snell_error(d, n, ratio, *out) <= 0x1p-22);
    }
}
