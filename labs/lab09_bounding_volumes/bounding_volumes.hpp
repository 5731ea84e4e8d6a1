// SPDX-License-Identifier: MIT
#pragma once
// Lab 09: something simple around something complex: spheres, boxes, and boxes that are turned. The handout is README.md in
// this folder.

#include <lantern/interval.hpp>
#include <lantern/ray.hpp>
#include <lantern/surface.hpp>
#include <lantern/todo.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <random>
#include <span>
#include <utility>
#include <vector>

namespace lab09 {

// Three volumes. What is in them is decided in double, with the numbers as they are stored. By default each is empty.

/// All points p with min <= p <= max, along each axis. Where some min > max it is empty; where min = max it is flat, and not empty.
struct box {
    glm::vec3 min{lantern::infinity};
    glm::vec3 max{-lantern::infinity};
};

/// All points no farther than `radius` from the center: it is solid. With a negative radius it is empty, with 0 it is a point.
struct sphere {
    glm::vec3 center{0};
    float radius = -1;
};

/// All points p with |axes[i] · (p - center)| <= half[i] for i = 0, 1, 2. The axes have length 1 and are perpendicular to each
/// other, as well as float can say it. Where some half is negative it is empty; 0 makes it flat.
struct oriented_box {
    glm::vec3 center{0};
    std::array<glm::vec3, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    glm::vec3 half{-1};
};

/// Given. The smallest float that is not below x; so -round_up(-x) is the largest that is not above it.
[[nodiscard]] inline float round_up(double x) {
    const float nearest = float(x);
    return double(nearest) < x ? std::nextafter(nearest, lantern::infinity) : nearest;
}

/// Given. A range in double that is a little wider at both ends: a surface's t is rounded to float before it is compared with the
/// range, so a volume that is not to lose it must reach a little farther.
struct stretch {
    double min, max;
    explicit stretch(lantern::interval range)
        : min(range.min - 0x1p-22 * std::abs(double(range.min))), max(range.max + 0x1p-22 * std::abs(double(range.max))) {}
};

/// Given. The eigenvectors of a symmetric matrix, perpendicular and of length 1, each with its eigenvalue; in no order.
/// Jacobi's method (1846): turn in the plane of two axes until the entry for these two is 0, and again.
struct eigenvectors {
    std::array<glm::dvec3, 3> vector;
    std::array<double, 3> value;

    explicit eigenvectors(glm::dmat3 a) {
        glm::dmat3 v(1);
        for (int sweep = 0; sweep < 12; ++sweep)
            for (int p = 0; p < 2; ++p)
                for (int q = p + 1; q < 3; ++q) {
                    if (std::abs(a[p][q]) <= 0x1p-60 * (a[p][p] + a[q][q])) continue;
                    const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
                    const double t = std::copysign(1 / (std::abs(theta) + std::sqrt(theta * theta + 1)), theta);
                    const double c = 1 / std::sqrt(t * t + 1), s = t * c;
                    glm::dmat3 turn(1);
                    turn[p][p] = turn[q][q] = c;
                    turn[q][p] = s;
                    turn[p][q] = -s;
                    a = glm::transpose(turn) * a * turn;
                    v = v * turn;
                }
        vector = {v[0], v[1], v[2]};
        value = {a[0][0], a[1][1], a[2][2]};
    }
};

// ---- Step 1: boxes around things -----------------------------------------------------------------------------------

/// The smallest box that holds all the points; empty when there are none.
[[nodiscard]] inline box box_around(std::span<const glm::vec3> points) {
    return lantern::todo("lab09 step 1: the box around points");
}

/// The smallest box that holds the sphere, for certain: its faces are rounded outwards. Empty around an empty sphere.
[[nodiscard]] inline box box_around(const sphere& s) {
    return lantern::todo("lab09 step 1: the box around a sphere");
}

/// The smallest box that holds both.
[[nodiscard]] inline box enclose(const box& a, const box& b) {
    return lantern::todo("lab09 step 1: the box around two boxes");
}

/// The area of all six sides, in double. Nothing has the area 0; what is flat has two sides.
[[nodiscard]] inline double surface_area(const box& b) {
    return lantern::todo("lab09 step 1: the area of a box");
}

// ---- Step 2: a ray and a box ---------------------------------------------------------------------------------------

// `overlaps` says whether the ray meets the volume, which is solid, at some t of the range. Touching counts. It may say yes to a
// ray that passes by very closely (by a millionth of what it sees), and never no to one that meets the volume. Directions may
// have any length but zero; their components may be 0 and -0.

[[nodiscard]] inline bool overlaps(const box& b, const lantern::ray& r, lantern::interval range) {
    return lantern::todo("lab09 step 2: a ray and a box");
}

// ---- Step 3: a sphere around points --------------------------------------------------------------------------------

/// A sphere that holds all the points, at most 1.3 times as large as the smallest one. Empty when there are none; around one point
/// exactly that point.
[[nodiscard]] inline sphere sphere_around(std::span<const glm::vec3> points) {
    return lantern::todo("lab09 step 3: a sphere around points");
}

[[nodiscard]] inline double surface_area(const sphere& s) {
    return lantern::todo("lab09 step 3: the area of a sphere");
}

// ---- Step 4: a ray and a sphere ------------------------------------------------------------------------------------

[[nodiscard]] inline bool overlaps(const sphere& s, const lantern::ray& r, lantern::interval range) {
    return lantern::todo("lab09 step 4: a ray and a sphere");
}

// ---- Step 5: an oriented box around points -------------------------------------------------------------------------

/// The smallest box that holds all the points and has their principal axes, the eigenvectors of their covariance. Empty when
/// there are none.
[[nodiscard]] inline oriented_box oriented_box_around(std::span<const glm::vec3> points) {
    return lantern::todo("lab09 step 5: an oriented box around points");
}

[[nodiscard]] inline double surface_area(const oriented_box& b) {
    return lantern::todo("lab09 step 5: the area of an oriented box");
}

// ---- Step 6: a ray and an oriented box -----------------------------------------------------------------------------

[[nodiscard]] inline bool overlaps(const oriented_box& b, const lantern::ray& r, lantern::interval range) {
    return lantern::todo("lab09 step 6: a ray and an oriented box");
}

// ---- Step 7: volumes around what is transformed --------------------------------------------------------------------

/// The smallest box around all the points m p + shift with p in the box, rounded outwards. Empty when the box is.
[[nodiscard]] inline box transformed(const glm::mat3& m, glm::vec3 shift, const box& b) {
    return lantern::todo("lab09 step 7: the box of a transformed box");
}

/// A sphere around all the points m p + shift with p in the sphere: its radius is multiplied by the most that m stretches anything.
/// Empty when the sphere is.
[[nodiscard]] inline sphere transformed(const glm::mat3& m, glm::vec3 shift, const sphere& s) {
    return lantern::todo("lab09 step 7: the sphere of a transformed sphere");
}

// ---- Step 8: the bounded surface -----------------------------------------------------------------------------------

/// A surface behind a volume that holds it. It is a surface itself, so it may stand wherever the surface stood.
template <class Volume, lantern::surface Surface>
struct bounded {
    Volume volume;
    Surface surface;
};

/// What the surface answers; but the surface is only asked when the ray meets the volume, within the range.
template <class Volume, lantern::surface Surface>
[[nodiscard]] std::optional<lantern::hit> intersect(const bounded<Volume, Surface>& s, const lantern::ray& r, lantern::interval range) {
    lantern::todo("lab09 step 8: the bounded surface");
}

// ---- Step 9: the smallest sphere -----------------------------------------------------------------------------------

/// Given. The smallest sphere that has all of one to four points on its surface; its radius is negative for no points, and where
/// there is no such sphere, as for three points in line.
struct ball {
    glm::dvec3 center{0};
    double radius = -1;
};
[[nodiscard]] inline ball ball_through(std::span<const glm::dvec3> on) {
    if (on.empty()) return {};
    // The center is on[0] + x0 e0 + x1 e1 + x2 e2 with e_i = on[i + 1] - on[0]. It is as far from on[0] as from on[i + 1] when
    // 2 e_i · (x0 e0 + x1 e1 + x2 e2) = e_i · e_i: that many linear equations.
    const std::size_t n = on.size() - 1;
    std::array<std::array<double, 4>, 3> rows{};
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k < n; ++k) rows[i][k] = 2 * glm::dot(on[i + 1] - on[0], on[k + 1] - on[0]);
        rows[i][3] = rows[i][i] / 2;
    }
    for (std::size_t i = 0; i < n; ++i) {
        const double pivot = rows[i][i];
        if (!(pivot > 0x1p-40 * glm::dot(on[i + 1] - on[0], on[i + 1] - on[0]))) return {};
        for (std::size_t k = 0; k < n; ++k) {
            const double factor = k == i ? 0 : rows[k][i] / pivot;
            for (std::size_t c = 0; c < 4; ++c) rows[k][c] -= factor * rows[i][c];
        }
    }
    glm::dvec3 way(0);
    for (std::size_t i = 0; i < n; ++i) way += rows[i][3] / rows[i][i] * (on[i + 1] - on[0]);
    return {on[0] + way, glm::length(way)};
}

/// The smallest sphere that holds all the points, but for rounding. Empty when there are none.
[[nodiscard]] inline sphere smallest_sphere(std::span<const glm::vec3> points) {
    return lantern::todo("lab09 step 9: the smallest sphere");
}

}  // namespace lab09
