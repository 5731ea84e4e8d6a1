// SPDX-License-Identifier: MIT
// Random numbers, warps and moments keep within their borders, whatever the bits.

#include "laws.hpp"

#include <algorithm>
#include <numbers>

namespace stress {

namespace {

/// In the closed unit square, often on its border or in its middle.
glm::vec2 square(dice& d) {
    constexpr std::array<float, 8> special{0, 1, 0.5f, 0x1p-24f, 1 - 0x1p-24f, 0x1p-149f, 0.25f, 0.75f};
    const auto number = [&] { return d.below(3) == 0 ? special[d.below(8)] : d.between(0, 1); };
    const float x = number(), y = number();
    return {x, y};
}

}  // namespace

void add_sampling(std::vector<test_case>& cases) {
    const std::string margin = "none: borders are borders";
    add(cases, "warps/unit-number", "from 32 bits to [0, 1): all ones, too", "float(u) · 2^-32 is 1 once in 2^25 (GCC bug 63176)", margin,
        [](const answers& a) { return a.unit_number; }, [](const answers& a, score& s, std::uint32_t i) {
            dice d = dice_of(i, 500);
            for (const std::uint32_t bits : {0xffffffffu - i, i, 0x7fffff80u + i, static_cast<std::uint32_t>(d.bits())}) {
                const float x = a.unit_number(bits);
                s.check(x >= 0 && x < 1, "outside: " + std::to_string(x) + " of " + std::to_string(bits));
                s.check(std::abs(double(x) - bits * 0x1p-32) <= 0x1p-22, "far from its bits: " + std::to_string(bits));
            }
        });
    add(cases, "warps/triangle", "barycentric coordinates: none negative, and their sum is 1", "1 - u - v of rounded u and v", margin,
        [](const answers& a) { return a.to_triangle; }, [](const answers& a, score& s, std::uint32_t i) {
            dice d = dice_of(i, 501);
            for (int k = 0; k < 16; ++k) {
                const glm::vec2 xi = square(d);
                const glm::vec3 b = a.to_triangle(xi);
                const double sum = double(b.x) + double(b.y) + double(b.z);
                s.check(b.x >= 0 && b.y >= 0 && b.z >= 0 && std::abs(sum - 1) <= 0x1p-23, "outside the triangle:" + shown({b}));
            }
        });
    add(cases, "warps/unit-length", "points of disk, sphere and hemisphere, from the whole closed square", "√max(0, ·)", margin,
        [](const answers& a) { return a.to_disk && a.to_sphere && a.to_cosine_hemisphere; }, [](const answers& a, score& s, std::uint32_t i) {
            dice d = dice_of(i, 502);
            for (int k = 0; k < 16; ++k) {
                const glm::vec2 xi = square(d), p = a.to_disk(xi);
                const glm::dvec3 q(a.to_sphere(xi)), h(a.to_cosine_hemisphere(xi));
                s.check(std::hypot(double(p.x), double(p.y)) <= 1 + 0x1p-23, "outside the disk");
                s.check(std::abs(glm::length(q) - 1) <= 0x1p-22, "off the sphere");
                s.check(std::abs(glm::length(h) - 1) <= 0x1p-22 && h.z >= 0, "off the hemisphere");
            }
        });
    add(cases, "warps/narrow-cone", "directions in a cone of half angle 1e-12 to 1: within it, and spread over it", "1 - cos of small angles", margin,
        [](const answers& a) { return a.to_cone; }, [](const answers& a, score& s, std::uint32_t i) {
            dice d = dice_of(i, 503);
            const double angle = std::pow(10, -12 * d.unit());
            double mean = 0;
            for (int x = 0; x < 8; ++x)
                for (int y = 0; y < 8; ++y) {
                    const glm::dvec3 v(a.to_cone(angle, {(static_cast<float>(x) + 0.5f) / 8, (static_cast<float>(y) + 0.5f) / 8}));
                    const double off = std::atan2(std::hypot(v.x, v.y), v.z) / angle;
                    mean += off * off / 64;
                    s.check(off <= 1 + 1e-6, "outside the cone of " + std::to_string(angle));
                }
            // By area, the mean square of the angle is half of the largest one's, nearly: .5 to .52 up to one radian.
            s.check(mean > 0.45 && mean < 0.56, "not spread over the cone: mean square " + std::to_string(mean));
        });
    add(cases, "camera/moment-within", "no moment before the shutter opens, nor after it closes", "lerp hits t1 with u < 1, or overshoots", margin,
        [](const answers& a) { return a.moment; }, [](const answers& a, score& s, std::uint32_t i) {
            dice d = dice_of(i, 504);
            float opens = d.between(0, 1), closes = d.between(0, 1);
            if (opens > closes) std::swap(opens, closes);
            if (i % 4 == 0) closes = opens;
            float before = opens;
            for (const float xi : {0.0f, 0x1p-24f, 0.25f, 0.5f, 0.75f, 1 - 0x1p-24f}) {
                const float t = a.moment(opens, closes, xi);
                s.check(t >= before && t <= closes, "out of order, or outside:" + shown({{opens, t, closes}}));
                before = t;
            }
        });
    add(cases, "basis/right-handed", "u, v, w are perpendicular, of unit length, and u × v = w, to 1.5e-7", "Duff et al., JCGT 6(1), 2017", "none",
        [](const answers& a) { return a.basis; }, [](const answers& a, score& s, std::uint32_t i) {
            dice d = dice_of(i, 505);
            for (int k = 0; k < 16; ++k) {
                glm::vec3 w(d.on_sphere());
                if (k % 4 == 1) w *= 1 + d.between(-1e-3, 1e-3);
                if (k % 4 == 2) w = d.magnitude_between(-37, 37) * w;
                if (k % 4 == 3) w = {d.magnitude_between(-30, -1), d.magnitude_between(-30, -1), d.below(2) == 0 ? 1.0f : -1.0f};
                const frame f = a.basis(w);
                const glm::dvec3 u(f.u), v(f.v), n(f.w);
                const double off = std::max({std::abs(glm::dot(u, v)), std::abs(glm::dot(v, n)), std::abs(glm::dot(n, u)), std::abs(glm::length(u) - 1),
                                             std::abs(glm::length(v) - 1), std::abs(glm::length(n) - 1), glm::length(glm::cross(u, v) - n)});
                s.check(off <= 1.5e-7, "off by " + std::to_string(off * 1e7) + "e-7, of" + shown({w}));
            }
        });
}

}  // namespace stress
