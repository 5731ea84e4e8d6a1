// SPDX-License-Identifier: MIT
// NaN, infinity, zeros of both signs, the largest and the smallest floats, anywhere: an answer is finite, or there is none.

#include "laws.hpp"

#include <limits>

namespace stress {

namespace {

float wild(dice& d) {
    constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    constexpr std::array<float, 16> values{0, -0.0f, 1, -1, nan, inf, -inf, 3.4e38f, -3.4e38f, 1e-45f, -1e-45f, 1e-38f, 1e20f, 0.5f, 3, -2};
    return d.below(3) == 0 ? values[d.below(16)] : d.between(-2, 2);
}
glm::vec3 wild3(dice& d) {
    const float x = wild(d), y = wild(d), z = wild(d);
    return {x, y, z};
}
ray wild_ray(dice& d) {
    const glm::vec3 o = wild3(d), v = wild3(d);
    return {o, v};
}

void check(score& s, const surface_answer& h, const ray& r) {
    s.check(!h || (h->t > 0 && std::isfinite(h->t) && is_finite(h->point) && is_finite(h->normal) &&
                   std::abs(glm::length(glm::dvec3(h->normal)) - 1) < 1e-5),
            "a hit that is none: from" + shown({r.origin, r.direction}));
}

}  // namespace

void add_wild_input(std::vector<test_case>& cases) {
    const std::string about = "NaN, infinity, zeros, the largest and smallest floats, anywhere in surface and ray",
                      margin = "none: whatever is answered is finite";
    const auto wilds = [&](const std::string& id, std::uint64_t salt, auto asked, auto ask) {
        add(cases, id, about, "comparisons written so that NaN misses", margin, asked, [=](const answers& a, score& s, std::uint32_t i) {
            dice d = dice_of(i, salt);
            for (int k = 0; k < 64; ++k) ask(a, s, d);
        });
    };
    wilds("sphere/wild-numbers", 200, [](const answers& a) { return a.sphere; }, [](const answers& a, score& s, dice& d) {
        const glm::vec3 c = wild3(d);
        const float radius = wild(d);
        const ray r = wild_ray(d);
        check(s, a.sphere(c, radius, r), r);
    });
    wilds("plane/wild-numbers", 201, [](const answers& a) { return a.plane; }, [](const answers& a, score& s, dice& d) {
        const glm::vec3 q = wild3(d), n = wild3(d);
        const ray r = wild_ray(d);
        check(s, a.plane(q, n, r), r);
    });
    wilds("triangle/wild-numbers", 202, [](const answers& a) { return a.triangle; }, [](const answers& a, score& s, dice& d) {
        const glm::vec3 p = wild3(d), q = wild3(d), t = wild3(d);
        const ray r = wild_ray(d);
        check(s, a.triangle(p, q, t, r), r);
    });
    wilds("triangle/no-area", 203, [](const answers& a) { return a.triangle; }, [](const answers& a, score& s, dice& d) {
        const glm::vec3 p = d.in_cube(), step = d.in_cube(), q = p + step, t = d.below(4) == 0 ? p : p + d.between(-1, 2) * step;
        const glm::vec3 o = d.in_cube(3);
        const ray r{o, p + d.between(0, 1) * step - o};
        check(s, a.triangle(p, q, t, r), r);
    });
    wilds("quadrics/wild-disk", 204, [](const answers& a) { return a.disk; }, [](const answers& a, score& s, dice& d) {
        const glm::vec3 c = wild3(d), n = wild3(d);
        const float radius = wild(d);
        const ray r = wild_ray(d);
        check(s, a.disk(c, n, radius, r), r);
    });
    wilds("quadrics/wild-rectangle", 205, [](const answers& a) { return a.rectangle; }, [](const answers& a, score& s, dice& d) {
        const glm::vec3 c = wild3(d), u = wild3(d), v = wild3(d);
        const ray r = wild_ray(d);
        check(s, a.rectangle(c, u, v, r), r);
    });
    wilds("quadrics/wild-cylinder", 206, [](const answers& a) { return a.cylinder; }, [](const answers& a, score& s, dice& d) {
        const glm::vec3 from = wild3(d), to = wild3(d);
        const float radius = wild(d);
        const ray r = wild_ray(d);
        check(s, a.cylinder(from, to, radius, r), r);
    });
    wilds("quadrics/wild-box", 207, [](const answers& a) { return a.box_surface; }, [](const answers& a, score& s, dice& d) {
        const glm::vec3 lo = wild3(d), hi = wild3(d);
        const ray r = wild_ray(d);
        check(s, a.box_surface({lo, hi}, r), r);
    });
    wilds("basis/wild-numbers", 208, [](const answers& a) { return a.basis; }, [](const answers& a, score& s, dice& d) {
        const glm::vec3 w = wild3(d);
        const frame f = a.basis(w);
        const glm::dvec3 u(f.u), v(f.v), n(f.w);
        const double off = std::abs(glm::dot(u, v)) + std::abs(glm::dot(v, n)) + std::abs(glm::dot(n, u)) + std::abs(glm::length(u) - 1) +
                           std::abs(glm::length(v) - 1) + std::abs(glm::length(n) - 1);
        s.check(off < 1e-6, "no basis, of" + shown({w}));
    });
}

}  // namespace stress
