// SPDX-License-Identifier: MIT
// Lab 06's hidden tests: the laws of the suite, and the solution, at inputs drawn anew for each grading. Which axes a basis
// has is the student's choice, so what depends on it is compared by its length: |q| = a |ξ - (1/2, 1/2)| in the square.

#include "contract.hpp"

#include <catch.hpp>
#include <hidden.hpp>

#include <lab06_glossy/glossy.hpp>

using namespace contract::lab06;

namespace {

constexpr double rounding = 4e-6;

double length_in_square(glm::dvec3 d, glm::dvec3 middle) { return glm::length(d / glm::dot(d, middle) - middle); }

/// A ray that falls on a surface, both drawn.
struct incidence {
    glm::vec3 normal, in, mirrored;
    incidence(numbers& random, float steepest) {
        normal = random.direction();
        do in = random.direction();
        while (!(glm::dot(in, normal) < -steepest));
        mirrored = lab06::reflected(in, normal, 0, {0.5f, 0.5f});
    }
};

}  // namespace

TEST_CASE("a basis around any direction, of any length", "[step1]") {
    numbers random = hidden::drawn(1);
    for (int i = 0; i < 200; ++i) {
        const glm::vec3 r = hidden::magnitude(random, 1e-20f, 1e15f) * random.direction();
        const glm::mat3 b = basis(r);
        CHECK(hidden::apart(b[2], lab06::basis(r)[2]) < rounding);
        CHECK(hidden::apart(glm::cross(b[0], b[1]), b[2]) < rounding);
        CHECK(std::abs(glm::length(b[0]) - 1) < rounding);
        CHECK(std::abs(glm::dot(b[0], b[2])) < rounding);
    }
}

TEST_CASE("any point of any square is met", "[step2]") {
    numbers random = hidden::drawn(2);
    for (int i = 0; i < 200; ++i) {
        const glm::vec3 r = random.direction();
        const float width = random.between(0.05f, 2);
        const glm::vec2 xi = hidden::point(random);
        const glm::vec3 d = perturb(hidden::magnitude(random, 1e-3f, 1e3f) * r, width, xi);
        CHECK(std::abs(glm::length(glm::dvec3(d)) - 1) < rounding);
        CHECK(std::abs(length_in_square(d, r) - double(width) * glm::length(glm::dvec2(xi) - 0.5)) < 1e-5);
    }
}

TEST_CASE("any reflected ray lies in its square, above the surface", "[step3]") {
    numbers random = hidden::drawn(3);
    for (int i = 0; i < 200; ++i) {
        const incidence ray(random, 0.7f);  // at 45° a square of side 1 stays above the surface
        const float width = random.between(0, 1);
        const glm::vec2 xi = hidden::point(random);
        const glm::vec3 d = reflected(ray.in, ray.normal, width, xi);
        CHECK(hidden::apart(reflected(ray.in, ray.normal, 0, xi), ray.mirrored) < rounding);
        CHECK(std::abs(length_in_square(d, ray.mirrored) - double(width) * glm::length(glm::dvec2(xi) - 0.5)) < 1e-5);
        const incidence grazing(random, 0);
        CHECK(glm::dot(glm::dvec3(reflected(grazing.in, grazing.normal, 2, xi)), glm::dvec3(grazing.normal)) > -rounding);
    }
}

TEST_CASE("the mean of any light over the lobe", "[step4]") {
    numbers random = hidden::drawn(4);
    for (int i = 0; i < 50; ++i) {
        const incidence ray(random, 0.7f);
        const float width = random.between(0.1f, 1);
        const std::vector<glm::vec2> points = hidden::points(random, 1 + hidden::below(random, 20));
        const glm::vec3 color = random.vector();
        double distance = 0;
        for (const glm::vec2 xi : points) distance += double(width) * glm::length(glm::dvec2(xi) - 0.5) / double(points.size());
        const glm::vec3 mean = reflected_radiance(ray.in, ray.normal, width, points, [&](glm::vec3 d) {
            return color * (1 + float(length_in_square(d, ray.mirrored)));
        });
        CHECK(hidden::apart(mean, color * float(1 + distance)) < 1e-5);
    }
}

TEST_CASE("any ray through any frosted glass", "[step5]") {
    numbers random = hidden::drawn(5);
    for (int i = 0; i < 200; ++i) {
        const incidence ray(random, 0.02f);
        const float eta = random.between(0.4f, 2.5f), width = random.between(0.05f, 0.5f);
        const double cosine = glm::dot(glm::dvec3(ray.in), glm::dvec3(ray.normal)), rest = 1 - double(eta) * double(eta) * (1 - cosine * cosine);
        if (std::abs(rest) < 1e-3) continue;  // at the critical angle rounding decides
        const glm::vec2 xi = hidden::point(random);
        const auto clear = transmitted(ray.in, ray.normal, eta, 0, xi), frosted = transmitted(ray.in, ray.normal, eta, width, xi);
        CHECK(hidden::apart(clear, lab06::transmitted(ray.in, ray.normal, eta, 0, xi)) < 1e-5);
        CHECK(frosted.has_value() == (rest > 0));
        if (clear && frosted && rest > 0.5)  // far enough from the surface
            CHECK(std::abs(length_in_square(*frosted, *clear) - double(width) * glm::length(glm::dvec2(xi) - 0.5)) < 1e-5);
    }
}
