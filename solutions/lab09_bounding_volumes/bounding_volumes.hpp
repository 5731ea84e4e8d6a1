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
    // BEGIN SOLUTION
    box b;
    for (const glm::vec3& p : points) b = {glm::min(b.min, p), glm::max(b.max, p)};
    return b;
    // END SOLUTION
    // STARTER: return lantern::todo("lab09 step 1: the box around points");
}

/// The smallest box that holds the sphere, for certain: its faces are rounded outwards. Empty around an empty sphere.
[[nodiscard]] inline box box_around(const sphere& s) {
    // BEGIN SOLUTION
    if (!(s.radius >= 0)) return {};
    const glm::dvec3 lower = glm::dvec3(s.center) - double(s.radius), upper = glm::dvec3(s.center) + double(s.radius);
    return {{-round_up(-lower.x), -round_up(-lower.y), -round_up(-lower.z)}, {round_up(upper.x), round_up(upper.y), round_up(upper.z)}};
    // END SOLUTION
    // STARTER: return lantern::todo("lab09 step 1: the box around a sphere");
}

/// The smallest box that holds both.
[[nodiscard]] inline box enclose(const box& a, const box& b) {
    // BEGIN SOLUTION
    return {glm::min(a.min, b.min), glm::max(a.max, b.max)};
    // END SOLUTION
    // STARTER: return lantern::todo("lab09 step 1: the box around two boxes");
}

/// The area of all six sides, in double. Nothing has the area 0; what is flat has two sides.
[[nodiscard]] inline double surface_area(const box& b) {
    // BEGIN SOLUTION
    if (!(b.min.x <= b.max.x && b.min.y <= b.max.y && b.min.z <= b.max.z)) return 0;
    const glm::dvec3 e = glm::dvec3(b.max) - glm::dvec3(b.min);
    return 2 * (e.x * e.y + e.y * e.z + e.z * e.x);
    // END SOLUTION
    // STARTER: return lantern::todo("lab09 step 1: the area of a box");
}

// ---- Step 2: a ray and a box ---------------------------------------------------------------------------------------

// `overlaps` says whether the ray meets the volume, which is solid, at some t of the range. Touching counts. It may say yes to a
// ray that passes by very closely (by a millionth of what it sees), and never no to one that meets the volume. Directions may
// have any length but zero; their components may be 0 and -0.

// BEGIN SOLUTION
/// Three slabs (Kay and Kajiya 1986), each the stretch of the ray between two parallel planes. Where the ray is parallel to them
/// there is nothing to divide by: it is between them or not. Each t is right to 2^-52 of itself, so what touches is not lost.
[[nodiscard]] inline bool meets_slabs(const glm::dvec3& lower, const glm::dvec3& upper, const glm::dvec3& origin,
                                      const glm::dvec3& direction, lantern::interval range) {
    stretch inside(range);
    for (int i = 0; i < 3; ++i) {
        if (direction[i] == 0) {
            if (origin[i] < lower[i] || origin[i] > upper[i]) return false;
            continue;
        }
        const double a = (lower[i] - origin[i]) / direction[i], b = (upper[i] - origin[i]) / direction[i];
        inside.min = std::max(inside.min, std::min(a, b));
        inside.max = std::min(inside.max, std::max(a, b));
    }
    return inside.min <= inside.max + 0x1p-40 * std::abs(inside.max);
}

// END SOLUTION
[[nodiscard]] inline bool overlaps(const box& b, const lantern::ray& r, lantern::interval range) {
    // BEGIN SOLUTION
    if (!(b.min.x <= b.max.x && b.min.y <= b.max.y && b.min.z <= b.max.z)) return false;
    return meets_slabs(b.min, b.max, r.origin, r.direction, range);
    // END SOLUTION
    // STARTER: return lantern::todo("lab09 step 2: a ray and a box");
}

// ---- Step 3: a sphere around points --------------------------------------------------------------------------------

/// A sphere that holds all the points, at most 1.3 times as large as the smallest one. Empty when there are none; around one point
/// exactly that point.
[[nodiscard]] inline sphere sphere_around(std::span<const glm::vec3> points) {
    // BEGIN SOLUTION
    if (points.empty()) return {};
    const auto farthest_from = [&](const glm::dvec3& from) {
        return glm::dvec3(*std::max_element(points.begin(), points.end(), [&](const glm::vec3& a, const glm::vec3& b) {
            return glm::distance(glm::dvec3(a), from) < glm::distance(glm::dvec3(b), from);
        }));
    };
    const glm::dvec3 a = farthest_from(points.front()), b = farthest_from(a);
    glm::dvec3 center = 0.5 * (a + b);
    double radius = 0.5 * glm::distance(a, b);
    for (const glm::dvec3 p : points) {
        const double distance = glm::distance(p, center);
        if (distance <= radius) continue;
        const double larger = 0.5 * (radius + distance);  // from the sphere's far side to p
        center += (larger - radius) / distance * (p - center);
        radius = larger;
    }
    const glm::vec3 stored(center);  // not quite the center, so measure again
    double reach = 0;
    for (const glm::dvec3 p : points) reach = std::max(reach, glm::distance(p, glm::dvec3(stored)));
    return {stored, round_up(reach)};
    // END SOLUTION
    // STARTER: return lantern::todo("lab09 step 3: a sphere around points");
}

[[nodiscard]] inline double surface_area(const sphere& s) {
    // BEGIN SOLUTION
    return s.radius >= 0 ? 4 * std::numbers::pi * double(s.radius) * double(s.radius) : 0;
    // END SOLUTION
    // STARTER: return lantern::todo("lab09 step 3: the area of a sphere");
}

// ---- Step 4: a ray and a sphere ------------------------------------------------------------------------------------

[[nodiscard]] inline bool overlaps(const sphere& s, const lantern::ray& r, lantern::interval range) {
    // BEGIN SOLUTION
    if (!(s.radius >= 0)) return false;
    const glm::dvec3 direction(r.direction), to_center = glm::dvec3(s.center) - glm::dvec3(r.origin);
    const stretch on(range);
    if (!(on.min <= on.max)) return false;
    const double nearest = std::clamp(glm::dot(to_center, direction) / glm::dot(direction, direction), on.min, on.max);
    const double rounding = 0x1p-40 * (glm::length(to_center) + double(s.radius));
    return glm::length(to_center - nearest * direction) <= double(s.radius) + rounding;
    // END SOLUTION
    // STARTER: return lantern::todo("lab09 step 4: a ray and a sphere");
}

// ---- Step 5: an oriented box around points -------------------------------------------------------------------------

/// The smallest box that holds all the points and has their principal axes, the eigenvectors of their covariance. Empty when
/// there are none.
[[nodiscard]] inline oriented_box oriented_box_around(std::span<const glm::vec3> points) {
    // BEGIN SOLUTION
    if (points.empty()) return {};
    glm::dvec3 mean(0);
    for (const glm::dvec3 p : points) mean += p / double(points.size());
    glm::dmat3 covariance(0);
    for (const glm::dvec3 p : points) covariance += glm::outerProduct(p - mean, p - mean);

    oriented_box result;
    glm::dvec3 center = mean;
    const eigenvectors principal(covariance);
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 axis = principal.vector[i];
        double lower = lantern::infinity, upper = -lantern::infinity;
        for (const glm::dvec3 p : points) {
            lower = std::min(lower, glm::dot(axis, p - mean));
            upper = std::max(upper, glm::dot(axis, p - mean));
        }
        center += 0.5 * (lower + upper) * axis;
        result.axes[i] = glm::vec3(axis);
    }
    result.center = glm::vec3(center);
    for (std::size_t i = 0; i < 3; ++i) {  // with center and axes as they are stored
        double reach = 0;
        for (const glm::dvec3 p : points)
            reach = std::max(reach, std::abs(glm::dot(glm::dvec3(result.axes[i]), p - glm::dvec3(result.center))));
        result.half[int(i)] = round_up(reach);
    }
    return result;
    // END SOLUTION
    // STARTER: return lantern::todo("lab09 step 5: an oriented box around points");
}

[[nodiscard]] inline double surface_area(const oriented_box& b) {
    // BEGIN SOLUTION
    if (!(b.half.x >= 0 && b.half.y >= 0 && b.half.z >= 0)) return 0;
    const glm::dvec3 h(b.half);
    return 8 * (h.x * h.y + h.y * h.z + h.z * h.x);
    // END SOLUTION
    // STARTER: return lantern::todo("lab09 step 5: the area of an oriented box");
}

// ---- Step 6: a ray and an oriented box -----------------------------------------------------------------------------

[[nodiscard]] inline bool overlaps(const oriented_box& b, const lantern::ray& r, lantern::interval range) {
    // BEGIN SOLUTION
    if (!(b.half.x >= 0 && b.half.y >= 0 && b.half.z >= 0)) return false;
    const glm::dvec3 from_center = glm::dvec3(r.origin) - glm::dvec3(b.center), d(r.direction);
    glm::dvec3 origin, direction;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 axis(b.axes[i]);
        origin[int(i)] = glm::dot(axis, from_center);
        direction[int(i)] = glm::dot(axis, d);
    }
    const glm::dvec3 reach = glm::dvec3(b.half) + 0x1p-40 * (glm::length(from_center) + glm::length(glm::dvec3(b.half)));
    return meets_slabs(-reach, reach, origin, direction, range);
    // END SOLUTION
    // STARTER: return lantern::todo("lab09 step 6: a ray and an oriented box");
}

// ---- Step 7: volumes around what is transformed --------------------------------------------------------------------

/// The smallest box around all the points m p + shift with p in the box, rounded outwards. Empty when the box is.
[[nodiscard]] inline box transformed(const glm::mat3& m, glm::vec3 shift, const box& b) {
    // BEGIN SOLUTION
    if (!(b.min.x <= b.max.x && b.min.y <= b.max.y && b.min.z <= b.max.z)) return {};
    box result;
    for (int row = 0; row < 3; ++row) {
        double lower = shift[row], upper = shift[row];
        for (int column = 0; column < 3; ++column) {
            const double one = double(m[column][row]) * double(b.min[column]), other = double(m[column][row]) * double(b.max[column]);
            lower += std::min(one, other);
            upper += std::max(one, other);
        }
        result.min[row] = -round_up(-lower);
        result.max[row] = round_up(upper);
    }
    return result;
    // END SOLUTION
    // STARTER: return lantern::todo("lab09 step 7: the box of a transformed box");
}

/// A sphere around all the points m p + shift with p in the sphere: its radius is multiplied by the most that m stretches anything.
/// Empty when the sphere is.
[[nodiscard]] inline sphere transformed(const glm::mat3& m, glm::vec3 shift, const sphere& s) {
    // BEGIN SOLUTION
    if (!(s.radius >= 0)) return {};
    const glm::dmat3 wide(m);
    const std::array<double, 3> squares = eigenvectors(glm::transpose(wide) * wide).value;
    const double stretched = std::sqrt(std::max({squares[0], squares[1], squares[2], 0.0})) * double(s.radius);
    const glm::dvec3 center = wide * glm::dvec3(s.center) + glm::dvec3(shift);
    const glm::vec3 stored(center);  // not quite the center
    return {stored, round_up(stretched * (1 + 0x1p-40) + glm::distance(center, glm::dvec3(stored)))};
    // END SOLUTION
    // STARTER: return lantern::todo("lab09 step 7: the sphere of a transformed sphere");
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
    // BEGIN SOLUTION
    if (!overlaps(s.volume, r, range)) return std::nullopt;
    return intersect(s.surface, r, range);
    // END SOLUTION
    // STARTER: lantern::todo("lab09 step 8: the bounded surface");
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

// BEGIN SOLUTION
/// The smallest ball that holds the points and has those of `on`, four at most, on its surface.
[[nodiscard]] inline ball smallest_ball(std::span<const glm::dvec3> points, std::vector<glm::dvec3>& on) {
    ball best = ball_through(on);
    if (on.size() == 4) return best;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (glm::distance(points[i], best.center) <= best.radius * (1 + 0x1p-36)) continue;
        on.push_back(points[i]);  // it is outside, so it is on the surface of the next one
        best = smallest_ball(points.first(i), on);
        on.pop_back();
    }
    return best;
}

// END SOLUTION
/// The smallest sphere that holds all the points, but for rounding. Empty when there are none.
[[nodiscard]] inline sphere smallest_sphere(std::span<const glm::vec3> points) {
    // BEGIN SOLUTION
    if (points.empty()) return {};
    std::vector<glm::dvec3> shuffled(points.begin(), points.end()), on;
    std::mt19937 random(1);
    for (std::size_t i = shuffled.size(); i > 1; --i) std::swap(shuffled[i - 1], shuffled[random() % i]);
    const glm::vec3 center(smallest_ball(shuffled, on).center);
    double reach = 0;
    for (const glm::dvec3 p : points) reach = std::max(reach, glm::distance(p, glm::dvec3(center)));
    return {center, round_up(reach)};
    // END SOLUTION
    // STARTER: return lantern::todo("lab09 step 9: the smallest sphere");
}

}  // namespace lab09
