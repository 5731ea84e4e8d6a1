// SPDX-License-Identifier: MIT
// Whatever the scene, every structure answers what brute force answers, and leaves out what is not finite.

#include "laws.hpp"

#include <algorithm>
#include <limits>

namespace stress {

namespace {

std::array<glm::vec3, 3> triangle_at(glm::vec3 p, float size, dice& d) { return {p, p + size * d.in_cube(), p + size * d.in_cube()}; }

/// Every center of a box at one place: no split tells them apart.
scene equal_centroids() {
    dice d{.state = 400};
    scene s;
    for (int i = 1; i <= 200; ++i) {
        s.spheres.push_back({{1, 2, 3}, static_cast<float>(i)});
        const glm::vec3 u = static_cast<float>(i) * d.in_cube(), v = glm::vec3(-u.y, u.x, u.z);
        s.triangles.push_back({glm::vec3(1, 2, 3) + u, glm::vec3(1, 2, 3) - u, glm::vec3(1, 2, 3) + 0.5f * v});
    }
    return s;
}

scene one_huge_among_tiny() {
    dice d{.state = 401};
    scene s;
    for (int i = 0; i < 300; ++i) {
        if (i % 2 == 0) s.spheres.push_back({d.in_cube(), 1e-3f});
        else s.triangles.push_back(triangle_at(d.in_cube(), 1e-2f, d));
    }
    s.spheres.push_back({{0, -1e6f, 0}, 999998});
    s.triangles.push_back({glm::vec3(-1e6f, -3, -1e6f), glm::vec3(1e6f, -3, -1e6f), glm::vec3(0, -3, 1e6f)});
    return s;
}

scene teapot_in_a_stadium() {
    dice d{.state = 402};
    scene s;
    for (int i = 0; i < 300; ++i) s.triangles.push_back(triangle_at(1e-3f * d.in_cube(), 2e-4f, d));
    for (int i = 0; i < 40; ++i) {
        s.triangles.push_back(triangle_at(d.in_cube(100), 30, d));
        s.spheres.push_back({d.in_cube(100), d.between(1, 10)});
    }
    return s;
}

/// From 2^-100 to 2^58: so far triangles may reach in a structure that computes in float.
scene sizes_spread() {
    dice d{.state = 403};
    scene s;
    for (int i = 0; i < 300; ++i) {
        const float size = std::ldexp(1.0f, static_cast<int>(d.below(158)) - 100), place = std::ldexp(1.0f, static_cast<int>(d.below(158)) - 100);
        if (i % 2 == 0) s.spheres.push_back({place * d.in_cube(), size});
        else s.triangles.push_back(triangle_at(place * d.in_cube(), size, d));
    }
    for (int i = 59; i <= 100; ++i) s.spheres.push_back({std::ldexp(1.0f, i) * d.in_cube(), std::ldexp(1.0f, i - 1)});
    return s;
}

/// Each one half as far away as the one before: halving space, or sharing out by cost, peels off one a level.
scene deep() {
    scene s;
    for (int i = -120; i < 100; ++i) {
        const float x = std::ldexp(1.0f, i);
        s.spheres.push_back({{x, x, -x}, x / 8});
        if (i < 58) s.triangles.push_back({glm::vec3(x, x, x), glm::vec3(1.25f * x, x, x), glm::vec3(x, 1.25f * x, 1.5f * x)});
    }
    return s;
}

scene not_finite() {
    dice d{.state = 404};
    constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    scene s;
    for (int i = 0; i < 100; ++i) {
        s.spheres.push_back({d.in_cube(), d.between(0.01, 0.2)});
        s.triangles.push_back(triangle_at(d.in_cube(), 0.3f, d));
    }
    for (const float bad : {nan, inf, -inf}) {
        s.spheres.push_back({{0, bad, 0}, 1});
        s.spheres.push_back({{0, 0, 0}, bad});
        s.triangles.push_back({glm::vec3(0, 0, bad), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)});
        s.triangles.push_back({glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(bad)});
    }
    std::swap(s.spheres[3], s.spheres.back());  // not only at the end
    std::swap(s.triangles[7], s.triangles.back());
    return s;
}

/// Walls and points on a lattice: every coordinate is a split, every ray may run within one.
scene lattice() {
    scene s;
    for (int x = -3; x <= 3; ++x)
        for (int y = -3; y <= 3; ++y)
            for (int z = -3; z <= 3; ++z) {
                const glm::vec3 p(x, y, z);
                s.spheres.push_back({p, (x + y + z) % 2 == 0 ? 0.0f : 0.25f});
                if ((x * y + z) % 3 == 0) s.triangles.push_back({p, p + glm::vec3(1, 0, 0), p + glm::vec3(0, 1, 0)});
                if ((x + y * z) % 3 == 0) s.triangles.push_back({p, p + glm::vec3(0, 1, 0), p + glm::vec3(0, 0, 1)});
            }
    return s;
}

ray towards(dice& d, const scene& s) {
    const std::uint32_t spheres = static_cast<std::uint32_t>(s.spheres.size()), triangles = static_cast<std::uint32_t>(s.triangles.size());
    for (;;) {
        const std::uint32_t i = d.below(spheres + triangles);
        glm::vec3 target = i < spheres ? s.spheres[i].center + s.spheres[i].radius * d.in_cube(0.7) : glm::vec3(0);
        float reach = i < spheres ? std::abs(s.spheres[i].radius) : 1;
        if (i >= spheres) {
            const auto& t = s.triangles[i - spheres];
            const float u = d.below(4) == 0 ? 0 : d.between(0, 1), v = d.between(0, 1 - double(u));
            target = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
            reach = std::max(glm::length(t[1] - t[0]), 1e-30f);
        }
        const glm::vec3 origin = d.below(8) == 0 ? target : target + d.magnitude_between(-1, 4) * std::max(reach, 1e-35f) * d.in_cube();
        ray r{origin, d.below(3) == 0 ? d.in_cube() : target - origin};
        if (d.below(4) == 0) r.direction[static_cast<int>(d.below(3))] = d.below(2) == 0 ? 0.0f : -0.0f;
        if (d.below(4) == 0) r.origin[static_cast<int>(d.below(3))] = std::round(r.origin.x);
        if (is_finite(r.origin) && is_finite(r.direction) && r.direction != glm::vec3(0)) return r;
    }
}

/// The smallest t, and of two the smaller index, over what is asked for.
std::optional<found> brute_force(const answers& a, const scene& s, const ray& r, bool spheres) {
    std::optional<found> best;
    const auto offer = [&](std::uint32_t index, const surface_answer& h) {
        if (h && (!best || h->t < best->t)) best = found{index, h->t};
    };
    std::uint32_t index = 0;
    for (const ball& b : s.spheres) {
        if (spheres) offer(index, a.sphere(b.center, b.radius, r));
        ++index;
    }
    for (const auto& t : s.triangles) offer(index++, a.triangle(t[0], t[1], t[2], r));
    return best;
}

std::string told(const std::optional<found>& f) { return f ? "surface " + std::to_string(f->index) + " at " + std::to_string(f->t) : "nothing"; }

void compare(const answers& a, const scene& s, std::uint32_t odd_spheres, std::uint32_t odd_triangles, score& counted, std::uint64_t salt) {
    dice d{.state = salt};
    std::vector<ray> rays;
    for (std::uint32_t i = 0; i < variants; ++i) rays.push_back(towards(d, s));
    for (const bool with_spheres : {true, false}) {
        std::vector<std::optional<found>> expected;
        for (const ray& r : rays) expected.push_back(brute_force(a, s, r, with_spheres));
        for (const std::string& structure : a.structures()) {
            const bool triangles_only = structure.find("wide") != std::string::npos;  // it is a structure of triangles
            if (triangles_only == with_spheres) continue;
            const traced got = a.trace(structure, s, rays);
            counted.check(got.hits.size() == rays.size(), structure + ": not an answer for each ray");
            counted.check(got.left_out == (triangles_only ? 0 : odd_spheres) + odd_triangles, structure + ": " + std::to_string(got.left_out) + " left out");
            for (std::size_t i = 0; i < rays.size() && i < got.hits.size(); ++i)
                counted.check(got.hits[i] == expected[i], structure + ": " + told(got.hits[i]) + " for " + told(expected[i]) + ", ray" +
                                                              shown({rays[i].origin, rays[i].direction}));
        }
    }
}

}  // namespace

void add_accelerators(std::vector<test_case>& cases) {
    const auto asked = [](const answers& a) { return a.trace && a.sphere && a.triangle; };
    const auto add_scene = [&](const std::string& name, const std::string& about, const std::string& source, auto build, std::uint32_t odd_spheres,
                               std::uint32_t odd_triangles, std::uint64_t salt) {
        cases.push_back({"accelerators/" + name, about + "; every structure against brute force", source, "none: the same surface, the same t", 2, 0.501, asked,
                         [=](const answers& a, bool, score& s) { compare(a, build(), odd_spheres, odd_triangles, s, salt); }});
    };
    add_scene("equal-centroids", "400 surfaces around one point", "no plane divides them: split by number", equal_centroids, 0, 0, 410);
    add_scene("one-huge-among-tiny", "300 tiny surfaces, a ground of radius 1e6 and a wall of 2e6", "the extent of the scene says nothing", one_huge_among_tiny, 0, 0, 411);
    add_scene("teapot-in-a-stadium", "300 triangles within 1e-3, 80 surfaces within 100", "the grid's one cell (Haines, Ray Tracing News)", teapot_in_a_stadium, 0, 0, 412);
    add_scene("sizes-spread", "sizes and places from 2^-100 to 2^100", "areas overflow, or vanish, in float", sizes_spread, 0, 0, 413);
    add_scene("deep", "each surface half as far away as the one before, 220 times", "depth beyond any fixed stack", deep, 0, 0, 414);
    add_scene("not-finite", "NaN and infinite surfaces among 200 good ones: reported, left out, never traced", "a NaN poisons minimum and maximum", not_finite, 6, 6, 415);
    add_scene("lattice", "points, balls and walls on a lattice, rays within its planes", "0 · ∞, and splits through everything", lattice, 0, 0, 416);

    cases.push_back({"accelerators/a-million-duplicates", "a million equal triangles: built in good time, found, and the first of them named", "no split tells them apart",
                     "none: the same surface, the same t", 2, 0.501, asked, [](const answers& a, bool, score& s) {
                         const std::array<glm::vec3, 3> one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
                         const std::vector<ray> rays{{{0.25f, 0.25f, 1}, {0, 0, -1}}, {{2, 2, 1}, {0, 0, -1}}};
                         for (const std::string& structure : a.structures()) {
                             scene all;  // of oriented boxes fewer: one is fitted, 21 times, to all that is below each node
                             all.triangles.assign(structure.find("oriented") != std::string::npos ? 50'000 : 1'000'000, one);
                             const traced got = a.trace(structure, all, rays);
                             s.check(got.hits.size() == 2 && got.hits[0] == found{0, 1} && !got.hits[1], structure);
                         }
                     }});
}

}  // namespace stress
