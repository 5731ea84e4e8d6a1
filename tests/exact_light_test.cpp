// SPDX-License-Identifier: MIT
#include <lantern/exact_light.hpp>

#include "brute_force.hpp"
#include "catch.hpp"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

using namespace lantern::exact;
using brute_force::numbers;
using brute_force::over_square;
using std::numbers::pi;

namespace {

/// cos θ cos θ' / d² for one point of a light: what all closed forms here are integrals of.
double kernel(glm::dvec3 point, glm::dvec3 normal, glm::dvec3 on_light, glm::dvec3 light_normal) {
    const glm::dvec3 w = on_light - point;
    const double d2 = glm::dot(w, w);
    return std::max(0.0, glm::dot(normal, w)) * std::abs(glm::dot(light_normal, w)) / (d2 * d2);
}

double area(const parallelogram& p) { return glm::length(glm::cross(p.a, p.b)); }

}  // namespace

TEST_CASE("clipping keeps the part of a polygon on one side") {
    const polygon square = corners({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    CHECK(clipped(square, {0.25, 0, 0}, {1, 0, 0}).size() == 4);
    CHECK(clipped(square, {-1, 0, 0}, {1, 0, 0}) == square);
    CHECK(clipped(square, {2, 0, 0}, {1, 0, 0}).empty());
    CHECK(clipped(square, {0.5, 0, 0}, {1, 1, 0}).size() == 5);
    for (const glm::dvec3 corner : clipped(square, {0.25, 0, 0}, {1, 0, 0})) CHECK(corner.x >= 0.25);
}

TEST_CASE("a rectangle's solid angle is what its points add up to, and the angles of its spherical polygon") {
    numbers uniform(1);
    for (int trial = 0; trial < 20; ++trial) {
        const glm::dvec3 a = uniform.vector(), b = glm::cross(a, uniform.vector());  // a rectangle
        const parallelogram light{uniform.vector() + glm::dvec3(0, 0, 3), a, b};
        const glm::dvec3 point = uniform.vector(), n = glm::normalize(glm::cross(a, b));
        const double summed = area(light) * over_square(300, [&](double u, double v) {
                                  const glm::dvec3 w = light.corner + u * light.a + v * light.b - point;
                                  return std::abs(glm::dot(n, w)) / std::pow(glm::dot(w, w), 1.5);
                              });
        const double omega = solid_angle(point, corners(light));
        CHECK(omega == Approx(summed).epsilon(1e-4));

        const polygon p = corners(light);  // Girard: the angles between the planes through neighbouring sides, less 2π
        double angles = -2 * pi;
        for (std::size_t i = 0; i < 4; ++i) {
            const glm::dvec3 before = glm::cross(p[(i + 3) % 4] - point, p[i] - point);
            const glm::dvec3 after = glm::cross(p[i] - point, p[(i + 1) % 4] - point);
            angles += pi - std::acos(glm::dot(glm::normalize(before), glm::normalize(after)));
        }
        CHECK(omega == Approx(angles).epsilon(1e-9));
    }
}

TEST_CASE("solid angles of known shapes, from the whole sphere to a speck") {
    // The face of a cube, seen from its centre; from a corner's point of view; a face met at its own middle.
    const parallelogram face{{-1, -1, 1}, {2, 0, 0}, {0, 2, 0}};
    CHECK(solid_angle({0, 0, 0}, corners(face)) == Approx(4 * pi / 6));
    CHECK(solid_angle({0, 0, 1 - 1e-12}, corners(face)) == Approx(2 * pi));
    CHECK(solid_angle({0, 0, 5}, corners({{0, 0, 0}, {0, 0, 0}, {0, 1, 0}})) == 0);
    // A speck keeps its digits: area / d², cos = 1.
    for (double size = 1e-3; size > 1e-100; size *= 1e-5)
        CHECK(solid_angle({0, 0, 0}, corners({{-size / 2, -size / 2, 2}, {size, 0, 0}, {0, size, 0}})) ==
              Approx(size * size / 4).epsilon(size * size + 1e-14));
}

TEST_CASE("Lambert's formula is the integral of both cosines over d², cut at the horizon") {
    numbers uniform(2);
    int cut = 0;
    for (int trial = 0; trial < 40; ++trial) {
        const parallelogram light{uniform.vector() + glm::dvec3(0, 0, 2.5), 1.5 * uniform.vector(),
                                  1.5 * uniform.vector()};
        const glm::dvec3 normal = glm::normalize(uniform.vector()),
                         light_normal = glm::normalize(glm::cross(light.a, light.b));
        const glm::dvec3 point = 0.5 * uniform.vector();
        const double summed = area(light) * over_square(400, [&](double u, double v) {
                                  return kernel(point, normal, light.corner + u * light.a + v * light.b, light_normal);
                              });
        const std::size_t above = clipped(corners(light), point, normal).size();
        cut += above != 0 && clipped(corners(light), point, -normal).size() != 0;
        CHECK(irradiance(point, normal, corners(light)) == Approx(summed).epsilon(2e-3).margin(1e-5));
    }
    CHECK(cut > 5);
}

TEST_CASE("a sky of one polygon is π, a speck is cosines over d²") {
    CHECK(irradiance({0, 0, 0}, {0, 0, 1}, corners({{-1e9, -1e9, 1}, {2e9, 0, 0}, {0, 2e9, 0}})) == Approx(pi));
    for (double size = 1e-1; size > 1e-7; size /= 10)
        CHECK(irradiance({0, 0, 0}, {0, 0.6, 0.8}, corners({{-size / 2, -size / 2, 2}, {size, 0, 0}, {0, size, 0}})) ==
              Approx(0.8 * size * size / 4).epsilon(size * size + 1e-15 / size));
}

TEST_CASE("a penumbra is what the unhidden points of the light add up to") {
    numbers uniform(3);
    for (int trial = 0; trial < 30; ++trial) {
        const glm::dvec3 point(uniform(-0.3, 0.3), uniform(-0.3, 0.3), 0), normal(0, 0, 1);
        const parallelogram light{{-0.5, -0.5, 2}, {1, 0.2, 0.3}, {-0.1, 1, 0.2}};
        const edge past{{uniform(-0.3, 0.3), uniform(-0.3, 0.3), 1}, {uniform(-1, 1), uniform(-1, 1), 0.3}};
        const glm::dvec3 light_normal = glm::normalize(glm::cross(light.a, light.b));
        const glm::dvec3 side = glm::cross(past.point - point, past.along);
        const double summed = area(light) * over_square(500, [&](double u, double v) {
                                  const glm::dvec3 x = light.corner + u * light.a + v * light.b;
                                  return glm::dot(side, x - point) > 0 ? kernel(point, normal, x, light_normal) : 0.0;
                              });
        const double whole = irradiance(point, normal, corners(light));
        CHECK(penumbra(point, normal, past, light) == Approx(summed).margin(2e-3 * whole));
        const edge other{past.point, -past.along};
        CHECK(penumbra(point, normal, past, light) + penumbra(point, normal, other, light) ==
              Approx(whole).epsilon(1e-12));
    }
}

TEST_CASE("far away the penumbra is the fraction of the light that is seen") {
    const parallelogram light{{-0.5, -0.5, 1000}, {1, 0, 0}, {0, 1, 0}};
    const edge past{{0.1, 0, 500}, {0.3, 1, 0}};
    const double whole = irradiance({0, 0, 0}, {0, 0, 1}, corners(light));
    CHECK(penumbra({0, 0, 0}, {0, 0, 1}, past, light) / whole == Approx(visible({0, 0, 0}, past, light)).epsilon(1e-6));
}

TEST_CASE("a parallel disc lights a point as its points add up") {
    for (const double height : {0.2, 1.0, 5.0})
        for (const double offset : {0.0, 0.5, 1.0, 3.0}) {
            const double radius = 1;
            const double summed =
                pi * radius * radius * over_square(600, [&](double u, double v) {
                    const double r = radius * std::sqrt(u), angle = 2 * pi * v;
                    return kernel({0, 0, 0}, {0, 0, 1}, {offset + r * std::cos(angle), r * std::sin(angle), height},
                                  {0, 0, 1});
                });
            CHECK(disc_irradiance(height, offset, radius) == Approx(summed).epsilon(5e-4));
        }
    CHECK(disc_irradiance(2, 0, 1) == Approx(pi / 5));
    CHECK(disc_irradiance(1e-12, 0.5, 1) == Approx(pi));
    CHECK(disc_irradiance(1, 0, 1e-100) == Approx(pi * 1e-200));
    CHECK(disc_irradiance(1e-9, 2, 1) == Approx(1e-18 * pi / 9).epsilon(1e-9));
}

TEST_CASE("a sphere lights a point as its directions add up, above the horizon and across it") {
    for (const double distance : {1.2, 2.0, 10.0})
        for (double cosine = -0.95; cosine <= 1; cosine += 0.15) {
            const double edge_cosine = std::sqrt(1 - 1 / (distance * distance)), sine = std::sqrt(1 - cosine * cosine);
            const double summed = 2 * pi * (1 - edge_cosine) * over_square(800, [&](double u, double v) {
                                      const double z = 1 - u * (1 - edge_cosine), r = std::sqrt(1 - z * z);
                                      return std::max(0.0, cosine * z + sine * r * std::cos(2 * pi * v));
                                  });
            CAPTURE(distance, cosine);
            CHECK(sphere_irradiance(distance, 1, cosine) == Approx(summed).epsilon(1e-4).margin(1e-6));
        }
    CHECK(sphere_irradiance(10, 1, 0.5) == Approx(pi * 0.01 * 0.5));
}
