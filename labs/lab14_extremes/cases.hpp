// SPDX-License-Identifier: MIT
#pragma once
// Lab 14's hard cases with their exact answers: for the scorecard that the program prints, and for the tests. Coordinates are whole
// numbers times a power of two, so that floats hold them exactly and whole numbers of 128 bits decide without rounding. The same ones
// each time; another `seed` draws others.

#include <lantern/ray.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace extremes {

__extension__ typedef __int128 whole;
using whole3 = std::array<whole, 3>;

[[nodiscard]] inline whole3 operator-(const whole3& a, const whole3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
[[nodiscard]] inline whole dot(const whole3& a, const whole3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
[[nodiscard]] inline whole3 cross(const whole3& a, const whole3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// Times 2^exponent: exact.
[[nodiscard]] inline glm::vec3 scaled(const whole3& p, int exponent) {
    return {std::ldexp(float(p[0]), exponent), std::ldexp(float(p[1]), exponent), std::ldexp(float(p[2]), exponent)};
}

/// SplitMix64 (Steele, Lea and Flood 2014).
class dice {
public:
    explicit dice(std::uint64_t seed) : state_(seed) {}
    std::uint64_t bits() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
        z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
        z = (z ^ z >> 27) * 0x94d049bb133111eb;
        return z ^ z >> 31;
    }
    /// From low to high, both included.
    int whole(int low, int high) { return low + int(bits() % std::uint64_t(high - low + 1)); }
    whole3 point(int most) {
        const int x = whole(-most, most), y = whole(-most, most), z = whole(-most, most);
        return {x, y, z};
    }
    float unit() { return float(bits() >> 40) * 0x1p-24f; }
    glm::vec3 direction() {
        for (;;) {
            const float x = 2 * unit() - 1, y = 2 * unit() - 1, z = 2 * unit() - 1;
            const glm::vec3 v(x, y, z);
            if (glm::dot(v, v) <= 1 && glm::dot(v, v) > 0.01f) return v / glm::length(v);
        }
    }

private:
    std::uint64_t state_;
};

/// How many answers were wrong, and the largest error of the others in units of the last place of a float.
struct score {
    int asked = 0, wrong = 0;
    double ulp = 0;
    void tell(bool right) { ++asked, wrong += right ? 0 : 1; }
};

[[nodiscard]] inline double ulp_of(double x) {
    const float f = std::abs(float(x));
    return double(std::nextafter(f, std::numeric_limits<float>::infinity())) - double(f);
}

inline void tell(score& s, std::optional<float> answer, std::optional<double> truth) {
    const bool right = answer.has_value() == truth.has_value() && !(answer && std::isnan(*answer));
    s.tell(right);
    if (right && truth) s.ulp = std::max(s.ulp, std::abs(double(*answer) - *truth) / ulp_of(*truth));
}

// ---- a ray and a sphere ----------------------------------------------------------------------------------------------

struct sphere_question {
    glm::vec3 center;
    float radius;
    lantern::ray ray;
    std::optional<double> truth;
};

/// Exact up to the last steps, which are in double and let nothing cancel.
[[nodiscard]] inline std::optional<double> first_hit(const whole3& center, whole radius, const whole3& o, const whole3& d) {
    const whole3 f = center - o;
    const whole a = dot(d, d), b = dot(d, f), k = dot(f, f) - radius * radius, discriminant = b * b - a * k;
    if (discriminant < 0) return std::nullopt;
    const double root = std::sqrt(double(discriminant)), q = b >= 0 ? double(b) + root : double(b) - root;
    if (q == 0) return std::nullopt;
    const double t0 = b >= 0 ? double(k) / q : q / double(a), t1 = b >= 0 ? q / double(a) : double(k) / q;
    if (t0 > 0) return t0;
    if (t1 > 0) return t1;
    return std::nullopt;
}

/// The scene is multiplied by 2^scale, the ray's direction by 2^speed besides.
[[nodiscard]] inline sphere_question ask(const whole3& center, whole radius, const whole3& o, const whole3& d, int scale = 0, int speed = 0) {
    auto truth = first_hit(center, radius, o, d);
    if (truth) *truth = std::ldexp(*truth, -speed);
    return {scaled(center, scale), std::ldexp(float(radius), scale), {scaled(o, scale), scaled(d, scale + speed)}, truth};
}

inline constexpr std::array sphere_names{"an everyday sphere", "distance / radius 1e5",  "ground, radius 1e6", "ground, radius 1e9",
                                         "ground, radius 1e12", "starts on the surface", "everything × 1e18", "everything × 1e-25",
                                         "direction × 1e-23",      "direction × 1e12"};

[[nodiscard]] inline std::vector<sphere_question> spheres(int which, int count = 256, std::uint64_t seed = 0) {
    dice random(1400 + std::uint64_t(which) + seed);
    std::vector<sphere_question> all;
    while (int(all.size()) < count) {
        const whole3 o = random.point(1000), c = random.point(500), d = random.point(100), off = random.point(500);
        const whole3 at{c[0] - o[0] + off[0], c[1] - o[1] + off[1], c[2] - o[2] + off[2]};  // towards it, or beside it
        const whole3 down{d[0], -1 - random.whole(0, 20), d[2]};
        const auto ground = [&](float radius) {
            return ask({0, -whole(radius), 0}, whole(radius), {o[0], random.whole(1, 2000), o[2]}, down);
        };
        const int r = random.whole(100, 900);
        switch (which) {
            case 0: all.push_back(ask(c, r, o, at)); break;
            case 1: {
                const whole3 far{random.whole(800'000, 1'000'000), random.whole(0, 300'000), random.whole(0, 300'000)}, beside = random.point(11);
                all.push_back(ask(far, 10, {0, 0, 0}, {far[0] + beside[0], far[1] + beside[1], far[2] + beside[2]}));
                break;
            }
            case 2: all.push_back(ground(1e6f)); break;
            case 3: all.push_back(ground(1e9f)); break;
            case 4: all.push_back(ground(1e12f)); break;
            case 5: {  // 3, 4, 5 and 8, 9, 12, 17: points with whole coordinates on spheres with whole radii
                const int k = random.whole(1, 60'000);
                const bool flat = random.whole(0, 1) == 0;
                const whole3 start{(flat ? 3 : 8) * k, (flat ? -4 : 9) * k, (flat ? 0 : -12) * k};
                all.push_back(ask({0, 0, 0}, whole(flat ? 5 : 17) * k, start, d));
                break;
            }
            case 6: all.push_back(ask(c, r, o, at, 60)); break;
            case 7: all.push_back(ask(c, r, o, at, -84)); break;
            case 8: all.push_back(ask(c, r, o, at, 0, -75)); break;
            case 9: all.push_back(ask(c, r, o, at, 0, 40)); break;
            default: return all;
        }
        if (glm::length(all.back().ray.direction) == 0) all.pop_back();
    }
    return all;
}

template <class Hit>
[[nodiscard]] score judge_spheres(int which, const Hit& hit, std::uint64_t seed = 0) {
    score s;
    for (const sphere_question& q : spheres(which, 256, seed)) tell(s, hit(q.center, q.radius, q.ray), q.truth);
    return s;
}

// ---- a ray and a triangle --------------------------------------------------------------------------------------------

struct triangle_question {
    glm::vec3 a, b, c;
    lantern::ray ray;
    std::optional<double> truth;
};

/// A ray exactly through an edge has no one answer: nothing is asked then.
inline void ask(std::vector<triangle_question>& all, const whole3& a, const whole3& b, const whole3& c, const whole3& o, const whole3& d,
                int scale = 0) {
    const whole3 n = cross(b - a, c - a);
    const whole u = dot(d, cross(c - o, b - o)), v = dot(d, cross(a - o, c - o)), w = dot(d, cross(b - o, a - o));
    const whole above = dot(n, a - o), speed = dot(n, d);
    if (u == 0 || v == 0 || w == 0 || speed == 0) return;
    const double t = double(above) / double(speed);
    const bool inside = (u > 0) == (v > 0) && (v > 0) == (w > 0);
    all.push_back({scaled(a, scale), scaled(b, scale), scaled(c, scale), {scaled(o, scale), scaled(d, scale)},
                   inside && t > 0 ? std::optional(t) : std::nullopt});
}

inline constexpr std::array triangle_names{"an everyday triangle", "of size 1e-3", "of size 3e-5", "of size 1e-12", "a sliver, 1 to 5e6",
                                           "nearly edge-on",       "far away"};

[[nodiscard]] inline std::vector<triangle_question> triangles(int which, int count = 256, std::uint64_t seed = 0) {
    dice random(1430 + std::uint64_t(which) + seed);
    std::vector<triangle_question> all;
    const auto plus = [](const whole3& p, whole k, const whole3& d) { return whole3{p[0] + k * d[0], p[1] + k * d[1], p[2] + k * d[2]}; };
    while (int(all.size()) < count) {
        const int most = 1'000'000;
        const whole3 a = random.point(most), b = random.point(most), c = random.point(most), d = random.point(most / 10), slow = random.point(1'800);
        // A point near the middle: about half of the rays hit.
        whole3 p{(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3, (a[2] + b[2] + c[2]) / 3};
        p = plus(p, 1, random.point(most / 2));
        switch (which) {
            case 0: ask(all, a, b, c, plus(p, -9, d), d, -18); break;
            case 1: ask(all, a, b, c, plus(p, -9, d), d, -30); break;
            case 2: ask(all, a, b, c, plus(p, -9, d), d, -35); break;
            case 3: ask(all, a, b, c, plus(p, -9, d), d, -60); break;
            case 4: {
                const auto slanting = [](whole x, whole y, whole z) { return whole3{x, y + x, z}; };
                const whole3 near = slanting(random.whole(0, 16'000), 2 + random.whole(0, 2), 0);
                const whole3 far = slanting(16'000'000 + random.whole(0, 9'000), random.whole(-2, 2), 0);
                const whole3 aim = slanting(random.whole(10'000, 12'000'000), random.whole(-2, 4), random.whole(-2, 2));
                const whole3 small{random.whole(-100, 100), random.whole(-100, 100), -1 - random.whole(0, 30)};
                ask(all, {0, 0, random.whole(-2, 2)}, near, far, plus(aim, -7, small), small, -24);
                break;
            }
            case 5: {  // the ray sinks by 1 in about 100,000
                const whole3 flat{random.whole(5'000'000, 10'000'000), random.whole(-2'000'000, 2'000'000), -random.whole(50, 100)};
                const whole3 aim{random.whole(-60'000, 60'000), random.whole(-60'000, 60'000), 0};
                ask(all, {-100'003, -90'001, random.whole(0, 9)}, {90'007, -100'009, 0}, {10'009, 100'003, 0}, plus(aim, -1, flat), flat, -15);
                break;
            }
            case 6: ask(all, a, b, c, plus(p, -8'000, slow), slow, -18); break;
            default: return all;
        }
    }
    return all;
}

template <class Hit>
[[nodiscard]] score judge_triangles(int which, const Hit& hit, std::uint64_t seed = 0) {
    score s;
    for (const triangle_question& q : triangles(which, 256, seed)) tell(s, hit(q.a, q.b, q.c, q.ray), q.truth);
    return s;
}

/// A piece of cloth, side × side squares of two triangles, times 2^scale; heights by chance. All coordinates are multiples of
/// 2^(scale - 19): rays can be aimed at its vertices and at the middle of its edges without rounding.
struct cloth {
    int side;
    std::vector<glm::vec3> vertices;
    explicit cloth(int squares, int scale = 0, std::uint64_t seed = 1440) : side(squares) {
        dice random(seed);
        for (int y = 0; y <= side; ++y)
            for (int x = 0; x <= side; ++x) {
                const int px = x * 524'288 + random.whole(0, 150'000), py = y * 524'288 + random.whole(0, 150'000);
                vertices.push_back(scaled({px, py, random.whole(0, 350'000)}, scale - 19));
            }
    }
    [[nodiscard]] glm::vec3 operator()(int x, int y) const { return vertices[std::size_t(y * (side + 1) + x)]; }

    /// The two triangles of each square, `visit(a, b, c)`.
    template <class Visit>
    void each(const Visit& visit) const {
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                visit((*this)(x, y), (*this)(x + 1, y), (*this)(x + 1, y + 1));
                visit((*this)(x + 1, y + 1), (*this)(x, y + 1), (*this)(x, y));
            }
    }
};

/// Rays from above, exactly through the inner vertices of the cloth, or the middle of its inner edges: wrong are those that hit nothing.
template <class Hit>
[[nodiscard]] score judge_leaks(bool vertices, int scale, const Hit& hit, int rays = 1000, std::uint64_t seed = 0) {
    const cloth mesh(6, scale, 1440 + seed);
    dice random(1450 + seed);
    score s;
    for (int i = 0; i < rays; ++i) {
        const int x = random.whole(1, 4), y = random.whole(1, 4), along = random.whole(0, 2);
        const glm::vec3 p = mesh(x, y), q = mesh(x + (along != 1 ? 1 : 0), y + (along != 0 ? 1 : 0)), aim = vertices ? p : 0.5f * (p + q);
        const int ox = random.whole(0, 3'145'728), oy = random.whole(0, 3'145'728), oz = random.whole(1'500'000, 3'500'000);
        const glm::vec3 o = scaled({ox, oy, oz}, scale - 19);
        bool found = false;
        mesh.each([&](glm::vec3 a, glm::vec3 b, glm::vec3 c) { found = found || hit(a, b, c, lantern::ray{o, aim - o}); });
        s.tell(found);
    }
    return s;
}

// ---- a ray and a box -------------------------------------------------------------------------------------------------

struct box_question {
    glm::vec3 low, high;
    lantern::ray ray;
    bool truth;
};

inline constexpr std::array box_names{"an everyday box", "touches an edge", "touches a corner", "flat", "runs in a face", "starts on a face, -0",
                                      "passes at 1e-3"};

[[nodiscard]] inline std::vector<box_question> boxes(int which, int count = 256, std::uint64_t seed = 0) {
    dice random(1460 + std::uint64_t(which) + seed);
    std::vector<box_question> all;
    while (int(all.size()) < count) {
        // The ray meets p, a point of the box, at t = 3. Most of the steps to p have a bit more than a float.
        whole3 low, high, p, d, o;
        for (std::size_t i = 0; i < 3; ++i) {
            low[i] = random.whole(4'000'000, 6'000'000), high[i] = low[i] + random.whole(1'000, 2'000'000);
            p[i] = low[i] + whole(random.unit() * float(high[i] - low[i]));
            d[i] = 2 * random.whole(2'500'000, 3'400'000) + 1;
        }
        bool truth = true;
        const std::size_t i = std::size_t(random.whole(0, 2)), j = (i + 1) % 3, k = (i + 2) % 3;
        const bool above = random.whole(0, 1) == 1;
        float sign = random.whole(0, 1) == 1 ? 1.0f : -1.0f;
        switch (which) {
            case 0: break;
            case 1:  // comes to the plane of one face as it leaves the slab of another
            case 2:
                p[i] = low[i], p[j] = high[j];
                if (which == 2) p[k] = above ? low[k] : high[k];
                break;
            case 3: p[i] = high[i] = low[i]; break;
            case 4:
            case 5:
                p[i] = above ? high[i] : low[i];
                d[i] = 0;
                if (which == 5) d[j] = 0;
                break;
            case 6:  // comes to that plane a thousandth of its way too late
                p[i] = low[i], p[j] = high[j] + d[j] / 300;
                truth = false;
                break;
            default: return all;
        }
        for (std::size_t m = 0; m < 3; ++m) {
            o[m] = p[m] - 3 * d[m];
            if (random.whole(0, 1) == 0) continue;  // mirrored
            o[m] = -o[m], d[m] = -d[m];
            low[m] = -std::exchange(high[m], -low[m]);
        }
        glm::vec3 direction = scaled(d, 0);
        if (which == 4 || which == 5) direction[int(i)] = sign * 0.0f;
        if (which == 5) direction[int(j)] = -sign * 0.0f;
        all.push_back({scaled(low, 0), scaled(high, 0), {scaled(o, 0), direction}, truth});
    }
    return all;
}

template <class Meets>
[[nodiscard]] score judge_boxes(int which, const Meets& meets, std::uint64_t seed = 0) {
    score s;
    for (const box_question& q : boxes(which, 256, seed)) s.tell(meets(q.low, q.high, q.ray) == q.truth);
    return s;
}

// ---- leaving a surface -----------------------------------------------------------------------------------------------

/// What becomes of rays that leave: on the wrong side of the surface (acne), or farther from it than 8 ulp (contact lost).
struct departures {
    int rays = 0, acne = 0, lost = 0;
    void tell(double above, float largest, bool upwards) {
        ++rays;
        acne += (upwards ? above : -above) > 0 ? 0 : 1;
        lost += std::abs(above) <= 8 * ulp_of(double(largest)) ? 0 : 1;
    }
};

[[nodiscard]] inline float largest(glm::vec3 p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}); }

/// In a scene of this size: rays that leave a sphere, `on` being the point and `leave` the step.
template <class On, class Leave>
[[nodiscard]] departures leave_spheres(float size, const On& on, const Leave& leave, int rays = 1000, std::uint64_t seed = 0) {
    dice random(1480 + seed);
    departures all;
    for (int i = 0; i < rays; ++i) {
        const glm::vec3 c = size * (4 * random.unit() * random.direction()), n = random.direction(), d = random.direction();
        const float radius = size * (0.5f + random.unit());
        const lantern::ray r{c + 3.0f * radius * n + 0.5f * radius * d, -n};
        const glm::dvec3 f = glm::dvec3(c) - glm::dvec3(r.origin), v(r.direction);
        const double b = glm::dot(f, v), a = glm::dot(v, v), k = glm::dot(f, f) - double(radius) * double(radius);
        const glm::vec3 p = on(c, radius, r, float(k / (b + std::sqrt(b * b - a * k))));
        const glm::vec3 normal = glm::vec3(glm::normalize(glm::dvec3(p) - glm::dvec3(c)));
        const double above = glm::length(glm::dvec3(leave(p, normal, d)) - glm::dvec3(c)) - double(radius);
        all.tell(above, largest(p), glm::dot(normal, d) > 0);
    }
    return all;
}

/// The same with triangles, seen from up to ten sizes away.
template <class On, class Leave>
[[nodiscard]] departures leave_triangles(float size, const On& on, const Leave& leave, int rays = 1000, std::uint64_t seed = 0) {
    dice random(1490 + seed);
    departures all;
    while (all.rays < rays) {
        const glm::vec3 a = size * random.direction() * 4.0f, b = a + size * random.direction(), c = a + size * random.direction();
        const glm::dvec3 n = glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a)), unit = n / glm::length(n);
        const glm::vec3 d = random.direction(), normal(unit), o = a + 0.3f * (b - a) + 0.3f * (c - a) + 10 * size * random.unit() * random.direction();
        const lantern::ray r{o, a + 0.3f * (b - a) + 0.3f * (c - a) - o};
        const double speed = glm::dot(unit, glm::dvec3(r.direction));
        if (glm::length(n) < 0.1 * double(size) * double(size) || std::abs(speed) < 0.05 * double(size) || std::abs(glm::dot(normal, d)) < 1e-3f) continue;
        const glm::vec3 p = on(a, b, c, r, float(glm::dot(unit, glm::dvec3(a) - glm::dvec3(o)) / speed));
        all.tell(glm::dot(unit, glm::dvec3(leave(p, normal, d)) - glm::dvec3(a)), largest(p), glm::dot(normal, d) > 0);
    }
    return all;
}

// ---- a frame ---------------------------------------------------------------------------------------------------------

inline constexpr std::array basis_names{"unit vectors", "length off by 1e-3", "length 1e-30 to 1e30", "near the pole -z", "near the pole +z"};

[[nodiscard]] inline std::vector<glm::vec3> vectors(int which, int count = 256, std::uint64_t seed = 0) {
    dice random(1500 + std::uint64_t(which) + seed);
    std::vector<glm::vec3> all;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 d = random.direction();
        const float tiny = std::pow(10.0f, -1 - 20 * random.unit());
        switch (which) {
            case 0: all.push_back(d); break;
            case 1: all.push_back((1 + 1e-3f * (2 * random.unit() - 1)) * d); break;
            case 2: all.push_back(std::pow(10.0f, 60 * random.unit() - 30) * d); break;
            case 3: all.push_back(glm::normalize(glm::vec3(tiny * d.x, tiny * d.y, -1))); break;
            default: all.push_back(glm::normalize(glm::vec3(tiny * d.x, tiny * d.y, 1))); break;
        }
    }
    return all;
}

/// How far three vectors are from being a right-handed frame around w: the largest of all that should be 0.
[[nodiscard]] inline double frame_error(glm::vec3 u, glm::vec3 v, glm::vec3 n, glm::vec3 w) {
    const glm::dvec3 x(u), y(v), z(n), along = glm::dvec3(w) / glm::length(glm::dvec3(w));
    const double all = std::max({std::abs(glm::dot(x, y)), std::abs(glm::dot(x, z)), std::abs(glm::dot(y, z)), std::abs(glm::length(x) - 1),
                                 std::abs(glm::length(y) - 1), std::abs(glm::length(z) - 1), glm::length(z - along), glm::length(glm::cross(x, y) - z)});
    return all < std::numeric_limits<double>::infinity() && all == all ? all : std::numeric_limits<double>::infinity();
}

/// Wrong above 2^-22; ulp in units of 2^-23, the distance of floats above 1.
template <class Basis>
[[nodiscard]] score judge_bases(int which, const Basis& basis, std::uint64_t seed = 0) {
    score s;
    for (const glm::vec3 w : vectors(which, 256, seed)) {
        const auto f = basis(w);
        const double error = frame_error(f.u, f.v, f.w, w);
        s.tell(error <= 0x1p-22);
        s.ulp = std::max(s.ulp, error * 0x1p23);
    }
    return s;
}

// ---- total reflection ------------------------------------------------------------------------------------------------

struct refraction_question {
    glm::vec3 in, normal;
    float ratio;
    bool passes;
    int steps;  ///< of the ratio, from the float nearest to the critical one
};

/// Directions whose ratio · sin θ is 1 but for a few ulp of the ratio.
[[nodiscard]] inline std::vector<refraction_question> refractions(int count = 900, std::uint64_t seed = 0) {
    dice random(1520 + seed);
    std::vector<refraction_question> all;
    while (int(all.size()) < count) {
        const whole3 d = random.point(2000), n = random.point(2000), m = cross(n, d);
        const whole mm = dot(m, m), square = dot(n, n) * dot(d, d);
        if (dot(n, d) >= 0 || mm * 4 < square) continue;
        float ratio = float(std::sqrt(double(square) / double(mm)));
        const int steps = random.whole(-4, 4);
        for (int i = 0; i < std::abs(steps); ++i) ratio = std::nextafter(ratio, steps < 0 ? 0.0f : 4.0f);
        const whole q = whole(std::ldexp(double(ratio), 23));  // 1 <= ratio <= 2: whole, and less than 2^25
        all.push_back({scaled(d, -11), scaled(n, -11), ratio, q * q * mm <= (square << 46), steps});
    }
    return all;
}

/// Snell's law in vectors: n × out = ratio n × in, all of unit length. How far an answer is from it, and from unit length.
[[nodiscard]] inline double snell_error(glm::vec3 in, glm::vec3 normal, float ratio, glm::vec3 out) {
    const glm::dvec3 d = glm::normalize(glm::dvec3(in)), n = glm::normalize(glm::dvec3(normal)), o(out);
    return std::max({glm::length(glm::cross(n, o) - double(ratio) * glm::cross(n, d)), std::abs(glm::length(o) - 1), std::max(0.0, glm::dot(n, o))});
}

template <class Refracted>
[[nodiscard]] score judge_refractions(const Refracted& refracted, std::uint64_t seed = 0) {
    score s;
    for (const refraction_question& q : refractions(900, seed)) {
        const auto out = refracted(q.in, q.normal, q.ratio);
        s.tell(out.has_value() == q.passes);
        if (out && q.passes) s.ulp = std::max(s.ulp, snell_error(q.in, q.normal, q.ratio, *out) * 0x1p23);
    }
    return s;
}

}  // namespace extremes
