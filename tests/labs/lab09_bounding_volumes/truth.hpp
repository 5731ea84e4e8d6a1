// SPDX-License-Identifier: MIT
#pragma once
// What is true of volumes, points and rays, for lab 09's suite: rays of whole numbers, about which everything is known exactly, and
// the smallest sphere by trying all.

#include "contract.hpp"

#include <numbers.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace truth {

using namespace contract::lab09;

inline constexpr float inf = lantern::infinity;
using cloud = std::vector<glm::vec3>;
using whole = glm::vec<3, std::int64_t>;
using box = contract::lab09::upright;
using ball = contract::lab09::round;

/// What double may get wrong on the way; far below the rounding of float.
inline constexpr double slack = 1e-12;

class dice : public numbers {
public:
    using numbers::numbers;
    std::int64_t whole_between(std::int64_t low, std::int64_t high) { return low + std::int64_t(unit() * float(high - low + 1)); }
    whole whole_in_cube(std::int64_t half) {
        const std::int64_t x = whole_between(-half, half), y = whole_between(-half, half);
        return {x, y, whole_between(-half, half)};
    }
    bool one_in(int n) { return whole_between(1, n) == 1; }
    cloud points(int count, float half_side, glm::vec3 around = glm::vec3(0)) {
        cloud result;
        for (int i = 0; i < count; ++i) result.push_back(around + half_side * vector());
        return result;
    }
    /// Three perpendicular directions of length 1.
    glm::dmat3 turn() {
        const glm::dvec3 u = glm::normalize(glm::dvec3(direction()));
        const glm::dvec3 v = glm::normalize(glm::cross(u, glm::dvec3(direction())));
        return {u, v, glm::cross(u, v)};
    }
    /// A line as it comes from anywhere, all alike, through the ball of radius R around the center (a point of its surface, and a
    /// direction inwards distributed as the cosine). It meets a convex body in that ball with the probability area / (4πR²).
    ray line(glm::vec3 center, float radius) {
        const glm::vec3 up = direction();
        for (;;) {
            const glm::vec3 inwards = direction() - up;
            if (glm::length(inwards) > 0.01f) return {center + radius * up, inwards};
        }
    }
};

inline glm::vec3 real(const whole& v) { return {float(v.x), float(v.y), float(v.z)}; }

inline double at_most(double x) { return x >= 0 ? x : std::numeric_limits<double>::infinity(); }  // NaN is below no bound

inline double radius_needed(const cloud& points, glm::vec3 center) {
    double reach = 0;
    for (const glm::dvec3 p : points) reach = std::max(reach, at_most(glm::distance(p, glm::dvec3(center))));
    return reach;
}

inline double half_needed(const cloud& points, const tilted& b, std::size_t axis) {
    double reach = 0;
    for (const glm::dvec3 p : points) reach = std::max(reach, at_most(std::abs(glm::dot(glm::dvec3(b.axes[axis]), p - glm::dvec3(b.center)))));
    return reach;
}

inline cloud corners(glm::dvec3 center, const glm::dmat3& axes, glm::dvec3 half) {
    cloud result;
    for (int i = 0; i < 8; ++i)
        result.push_back(glm::vec3(center + axes * (half * glm::dvec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1))));
    return result;
}

inline bool nothing(const box& b) { return !(b.min.x <= b.max.x && b.min.y <= b.max.y && b.min.z <= b.max.z); }

// ---- Rays of whole numbers -----------------------------------------------------------------------------------------

struct whole_ray {
    whole origin{0}, direction{0};
    std::int64_t from = 0, to = 1 << 20;  ///< the range (from, to]; the default stands for one without an end
};

/// num / den with den > 0.
struct fraction {
    std::int64_t num, den;
    friend bool operator<(const fraction& a, const fraction& b) { return a.num * b.den < b.num * a.den; }
};

/// Whether the ray meets the box at some t with from < t <= to.
inline bool truly_meets(const whole& lower, const whole& upper, const whole_ray& r) {
    fraction enter{r.from, 1}, leave{r.to, 1};
    bool open = true;  // enter itself does not count
    for (int i = 0; i < 3; ++i) {
        const std::int64_t d = r.direction[i], o = r.origin[i];
        if (d == 0) {
            if (o < lower[i] || o > upper[i]) return false;
            continue;
        }
        const fraction a{d > 0 ? lower[i] - o : o - upper[i], std::abs(d)}, b{d > 0 ? upper[i] - o : o - lower[i], std::abs(d)};
        if (enter < a) enter = a, open = false;
        if (b < leave) leave = b;
    }
    return open ? enter < leave : !(leave < enter);
}

inline bool truly_meets(const whole& center, std::int64_t radius, const whole_ray& r) {
    const whole f = r.origin - center, d = r.direction;
    const auto dot = [](const whole& a, const whole& b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
    const std::int64_t a = dot(d, d), b = dot(f, d), c = dot(f, f) - radius * radius;
    const auto inside = [&](std::int64_t t) { return a * t * t + 2 * b * t + c <= 0; };
    if (-b > r.from * a && -b <= r.to * a) return b * b - a * c >= 0;
    return -b <= r.from * a ? a * r.from * r.from + 2 * b * r.from + c < 0 : inside(r.to);
}

/// The ray in float, exactly, with zeros of either sign; scene and direction scaled by powers of two.
struct cast {
    ray r;
    interval range;
};
inline cast cast_of(const whole_ray& w, dice& random, float scene = 1, float length = 1) {
    glm::vec3 direction = length * real(w.direction);
    for (int i = 0; i < 3; ++i)
        if (direction[i] == 0 && random.one_in(2)) direction[i] = -0.0f;
    const float unit = scene / length;
    return {{scene * real(w.origin), direction}, {unit * float(w.from), w.to == 1 << 20 ? inf : unit * float(w.to)}};
}

/// A ray that goes through the point `target` exactly, or passes it by a step; it comes from where `kind` says.
inline whole_ray towards(dice& random, whole target) {
    whole d = random.whole_in_cube(random.one_in(2) ? 3 : 17);
    for (int i = 0; i < 3; ++i)
        if (random.one_in(4)) d[i] = 0;
    if (d == whole(0)) d.x = 1;
    whole_ray r{target - random.whole_between(-2, 12) * d, d};
    if (random.one_in(3)) r.origin[int(random.whole_between(0, 2))] += random.whole_between(-2, 2);
    if (random.one_in(4)) {
        r.from = random.whole_between(0, 6);
        r.to = r.from + random.whole_between(1, 8);
    }
    return r;
}

/// A box, sometimes flat in one way or more, and a corner, a point of an edge, of a face, or of its inside.
struct aim {
    whole lower, upper, target;
};
inline aim aim_at_box(dice& random) {
    aim a{random.whole_in_cube(20), {}, {}};
    for (int i = 0; i < 3; ++i) {
        a.upper[i] = a.lower[i] + (random.one_in(4) ? 0 : random.whole_between(1, 30));
        const int kind = int(random.whole_between(0, 2));
        a.target[i] = kind == 0 ? a.lower[i] : kind == 1 ? a.upper[i] : random.whole_between(a.lower[i], a.upper[i]);
    }
    return a;
}

/// A volume, a ray, and whether `overlaps` must say yes, and whether it may: when the ray meets the volume, and when it meets one that is
/// larger by one on all sides.
struct whole_question {
    volume asked;
    whole_ray ray;
    bool must, may;
};

inline whole_question box_question(const aim& a, const whole_ray& w) {
    return {upright{real(a.lower), real(a.upper)}, w, truly_meets(a.lower, a.upper, w), truly_meets(a.lower - std::int64_t(1), a.upper + std::int64_t(1), w)};
}

inline whole_question any_box(dice& random) {
    const aim a = aim_at_box(random);
    return box_question(a, towards(random, a.target));
}

/// A box whose axes are the world's in another order, and some of them reversed: everything is exact, as it is for boxes.
inline whole_question any_tilted(dice& random) {
    aim a = aim_at_box(random);
    for (int k = 0; k < 3; ++k)
        if ((a.upper[k] - a.lower[k]) % 2 != 0) ++a.upper[k];  // so that its middle is a whole number
    whole_question q = box_question(a, towards(random, a.target));
    tilted b{0.5f * real(a.lower + a.upper), {}, {}};
    std::array<int, 3> order{0, 1, 2};
    std::rotate(order.begin(), order.begin() + random.whole_between(0, 2), order.end());
    if (random.one_in(2)) std::swap(order[0], order[1]);
    for (std::size_t k = 0; k < 3; ++k) {
        b.axes[k] = glm::vec3(0);
        b.axes[k][order[k]] = random.one_in(2) ? 1.0f : -1.0f;
        b.half[int(k)] = 0.5f * float(a.upper[order[k]] - a.lower[order[k]]);
    }
    q.asked = b;
    return q;
}

/// A ray that touches the sphere exactly, passes it by, or goes through it. The normals are whole and have whole lengths.
inline whole_question any_sphere(dice& random) {
    static const std::array<std::pair<whole, std::int64_t>, 8> normals{{{{1, 2, 2}, 3}, {{3, 4, 0}, 5}, {{2, 3, 6}, 7}, {{1, 4, 8}, 9},
                                                                        {{4, 4, 7}, 9}, {{2, 6, 9}, 11}, {{6, 6, 7}, 11}, {{0, 0, 1}, 1}}};
    auto [n, length] = normals[std::size_t(random.whole_between(0, 7))];
    const whole unturned = n;
    const std::int64_t turn = random.whole_between(0, 2);
    for (int k = 0; k < 3; ++k) n[k] = unturned[int((k + turn) % 3)] * (random.one_in(2) ? 1 : -1);
    const std::int64_t times = random.one_in(6) ? 0 : random.whole_between(1, 6), radius = times * length;
    const whole center = random.whole_in_cube(20), touched = center + times * n, other = random.whole_in_cube(3);
    whole d{n.y * other.z - n.z * other.y, n.z * other.x - n.x * other.z, n.x * other.y - n.y * other.x};
    if (random.one_in(3)) d += random.whole_in_cube(1);
    if (d == whole(0)) d = {1, 0, 0};
    whole_ray w{touched - random.whole_between(-2, 8) * d, d};
    if (random.one_in(4)) w.origin += random.whole_in_cube(2);
    if (random.one_in(3)) {
        w.from = random.whole_between(0, 6);
        w.to = w.from + random.whole_between(1, 5);
    }
    return {contract::lab09::round{real(center), float(radius)}, w, truly_meets(center, radius, w), truly_meets(center, radius + 1, w)};
}

inline volume scaled(volume v, float by) {
    if (auto* b = std::get_if<upright>(&v)) b->min *= by, b->max *= by;
    if (auto* s = std::get_if<contract::lab09::round>(&v)) s->center *= by, s->radius *= by;
    if (auto* b = std::get_if<tilted>(&v)) b->center *= by, b->half *= by;
    return v;
}

inline std::string text(glm::vec3 v) {
    const auto of = [](float x) { return std::to_string(x).substr(0, std::to_string(x).find('.') + 2); };
    return std::string("(").append(of(v.x)).append(", ").append(of(v.y)).append(", ").append(of(v.z)).append(")");
}
inline std::string text(const whole_question& q) {
    std::string shown;
    if (const auto* b = std::get_if<upright>(&q.asked)) shown = "box from " + text(b->min) + " to " + text(b->max);
    if (const auto* s = std::get_if<contract::lab09::round>(&q.asked)) shown = "sphere around " + text(s->center) + " of radius " + std::to_string(int(s->radius));
    if (const auto* b = std::get_if<tilted>(&q.asked))
        shown = "box around " + text(b->center) + ", axes " + text(b->axes[0]) + text(b->axes[1]) + text(b->axes[2]) + ", half " + text(b->half);
    return shown + "; ray from " + text(real(q.ray.origin)) + " along " + text(real(q.ray.direction)) + ", range (" + std::to_string(q.ray.from) + ", " +
           (q.ray.to == 1 << 20 ? "infinity" : std::to_string(q.ray.to)) + "]";
}

/// How often the answer is wrong: rays lost that meet the volume, rays kept that pass it by. The first mistake is shown.
struct mistakes {
    int lost = 0, kept = 0;
    std::string shown{};
};
template <class Make>
mistakes mistakes_in(std::uint64_t seed, int count, const Make& make, float scene = 1, float length = 1) {
    dice random(seed);
    std::vector<whole_question> known;
    std::vector<question> asked;
    for (int i = 0; i < count; ++i) {
        known.push_back(make(random));
        const auto [r, range] = cast_of(known.back().ray, random, scene, length);
        asked.push_back({scaled(known.back().asked, scene), r, range});
    }
    const std::vector<bool> said = meets(asked);
    mistakes m;
    for (std::size_t i = 0; i < known.size(); ++i) {
        m.lost += known[i].must && !said.at(i);
        m.kept += !known[i].may && said.at(i);
        if (m.lost + m.kept == 1 && m.shown.empty()) m.shown = text(known[i]) + (said.at(i) ? ": kept" : ": lost");
    }
    return m;
}

// ---- Clouds of points ----------------------------------------------------------------------------------------------

/// The ball through 1 to 4 points with its center in their plane; nothing where they span none. By Cramer's rule.
inline std::optional<std::pair<glm::dvec3, double>> circumscribed(const std::vector<glm::dvec3>& p) {
    if (p.size() == 1) return std::pair(p[0], 0.0);
    const glm::dvec3 a = p[1] - p[0];
    if (p.size() == 2) return std::pair(p[0] + 0.5 * a, 0.5 * glm::length(a));
    const glm::dvec3 b = p[2] - p[0], n = glm::cross(a, b);
    const glm::dvec3 last = p.size() == 4 ? p[3] - p[0] : n;
    const glm::dmat3 rows = glm::transpose(glm::dmat3(a, b, last));
    const double size = glm::length(a) * glm::length(b) * glm::length(last), volume = glm::determinant(rows);
    if (!(std::abs(volume) > 1e-10 * size)) return std::nullopt;
    const glm::dvec3 way = glm::inverse(rows) * glm::dvec3(0.5 * glm::dot(a, a), 0.5 * glm::dot(b, b), p.size() == 4 ? 0.5 * glm::dot(last, last) : 0);
    return std::pair(p[0] + way, glm::length(way));
}

/// The radius of the smallest sphere, by trying all that go through two, three or four of the points.
inline double smallest_radius(const cloud& points) {
    const std::vector<glm::dvec3> p(points.begin(), points.end());
    if (p.size() < 2) return 0;
    double best = std::numeric_limits<double>::infinity();
    const auto consider = [&](const std::vector<glm::dvec3>& on) {
        const auto through = circumscribed(on);
        if (!through || through->second >= best) return;
        for (const glm::dvec3& q : p)
            if (glm::distance(q, through->first) > through->second * (1 + 1e-9)) return;
        best = through->second;
    };
    if (std::all_of(p.begin(), p.end(), [&](const glm::dvec3& q) { return q == p[0]; })) return 0;
    for (std::size_t i = 0; i < p.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            consider({p[i], p[j]});
            for (std::size_t k = 0; k < j; ++k) {
                consider({p[i], p[j], p[k]});
                for (std::size_t l = 0; l < k; ++l) consider({p[i], p[j], p[k], p[l]});
            }
        }
    return best;
}

/// Clouds that a sphere may be put around wrongly: random ones, flat ones, crowded ones, in line, in one place, on a sphere.
inline std::vector<cloud> clouds() {
    dice random(15);
    std::vector<cloud> all{{{1, 2, 3}},
                           {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}},
                           {{0, 0, 0}, {4, 0, 0}},
                           {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {7, 0, 0}},
                           {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                           {{0, 0, 0}, {1, 0, 0}, {0.5f, 0.8660254f, 0}},
                           corners({5, 6, 7}, glm::dmat3(1), {1, 2, 3}),
                           {{2, 0, 0}, {-2, 0, 0}, {0, 2, 0}, {0, -2, 0}, {0, 0, 2}, {0, 0, -2}, {0, 0, 0}}};
    for (int i = 0; i < 30; ++i) {
        cloud points = random.points(2 + i % 9, 1, 3.0f * random.vector());
        if (i % 5 == 1)
            for (glm::vec3& p : points) p.y = 2;
        if (i % 5 == 2)
            for (glm::vec3& p : points) p *= glm::vec3(100, 1, 0.01f);
        if (i % 5 == 3)
            for (glm::vec3& p : points) p = glm::vec3(1, 2, 3) + 2.0f * random.direction();
        all.push_back(points);
    }
    return all;
}

}  // namespace truth
