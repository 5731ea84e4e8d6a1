// SPDX-License-Identifier: MIT
// A ray from inside a closed mesh hits it: through faces, edges and vertices, at any scale.

#include "closed_mesh.hpp"
#include "laws.hpp"

#include <algorithm>

namespace stress {

namespace {

using corners = std::array<glm::vec3, 3>;

bool leaks(const answers& a, const std::vector<corners>& mesh, ray r) {
    return std::none_of(mesh.begin(), mesh.end(), [&](const corners& t) { return a.triangle(t[0], t[1], t[2], r).has_value(); });
}

enum class aim { edges, vertices };

/// Sixteen rays from inside through points of edges, or through vertices.
void shoot_out(const answers& a, score& s, std::uint32_t i, aim what, float scale, std::uint64_t salt) {
    dice d = dice_of(i, salt);
    const auto mesh = closed_mesh(d, 2, scale);
    for (std::uint32_t k = 0; k < 16; ++k) {
        const corners& t = mesh[d.below(static_cast<std::uint32_t>(mesh.size()))];
        const std::uint32_t corner = d.below(3);
        const glm::vec3 origin = k % 4 == 0 ? glm::vec3(0) : 0.2f * scale * d.in_cube();
        const glm::dvec3 p(t[corner]), q(t[(corner + 1) % 3]);
        const double along = what == aim::vertices ? 0 : k % 2 == 0 ? 0.5 : d.unit();
        const ray r{origin, glm::vec3(p + along * (q - p) - glm::dvec3(origin))};
        s.check(!leaks(a, mesh, r), "a leak: ray" + shown({r.origin, r.direction}));
    }
}

/// A fan of triangles around (0, 0, 0), as wide as `thin`, some wound the other way round; closed, so every ray down hits it.
std::vector<corners> fan(dice& d, std::uint32_t blades, float thin) {
    std::vector<glm::vec3> rim;
    for (std::uint32_t k = 0; k < blades; ++k) {
        const double angle = 2 * 3.14159265358979 * (k + 0.9 * d.unit()) / blades;
        rim.emplace_back(std::cos(angle), double(thin) * std::sin(angle), double(thin) * (d.unit() - 0.5));
    }
    std::vector<corners> mesh;
    for (std::uint32_t k = 0; k < blades; ++k) {
        corners t{glm::vec3(0), rim[k], rim[(k + 1) % blades]};
        std::rotate(t.begin(), t.begin() + d.below(3), t.end());
        if (d.below(2) == 0) std::swap(t[0], t[1]);
        mesh.push_back(t);
    }
    return mesh;
}

}  // namespace

void add_watertightness(std::vector<test_case>& cases) {
    const auto asked = [](const answers& a) { return a.triangle; };
    const std::string source = "Woop, Benthin and Wald, JCGT 2(1), 2013", margin = "none: a shared edge belongs to one of its triangles, at least";
    const auto closed = [&](std::string id, std::string about, aim what, float scale, std::uint64_t salt) {
        add(cases, "watertightness/" + id, about, source, margin, asked,
            [=](const answers& a, score& s, std::uint32_t i) { shoot_out(a, s, i, what, scale, salt); });
    };
    closed("edges", "from inside a closed mesh through its edges", aim::edges, 1, 1);
    closed("vertices", "from inside a closed mesh through its vertices", aim::vertices, 1, 2);
    closed("edges-scale-1e-4", "edges of a mesh of size 1e-4", aim::edges, 1e-4f, 3);
    closed("vertices-scale-1e-4", "vertices of a mesh of size 1e-4", aim::vertices, 1e-4f, 4);
    closed("vertices-scale-1e5", "vertices of a mesh of size 1e5", aim::vertices, 1e5f, 5);
    closed("edges-scale-1e-20", "edges of a mesh of size 1e-20", aim::edges, 1e-20f, 6);

    add(cases, "watertightness/axis-aligned", "along axes, through a mesh whose edges and vertices lie on them", source, margin, asked,
        [](const answers& a, score& s, std::uint32_t i) {
            const float size = std::ldexp(1.0f, static_cast<int>(i % 64) - 32), x = static_cast<float>(static_cast<int>(i / 16) - 8) / 8 * size;
            const std::vector<corners> square{{{{-size, -size, 0}, {size, -size, 0}, {0, 0, 0}}}, {{{size, -size, 0}, {size, size, 0}, {0, 0, 0}}},
                                              {{{size, size, 0}, {-size, size, 0}, {0, 0, 0}}}, {{{-size, size, 0}, {-size, -size, 0}, {0, 0, 0}}}};
            for (const float y : {-x, x, 0.0f})
                for (const float zero : {-0.0f, 0.0f})
                    s.check(!leaks(a, square, {{x, y, 3}, {zero, -zero, -1}}), "a leak at" + shown({{x, y, 0}}));
        });
    add(cases, "watertightness/slivers", "through the hub and the spokes of a fan of needles, wound both ways", source, margin, asked,
        [](const answers& a, score& s, std::uint32_t i) {
            dice d = dice_of(i, 7);
            const auto mesh = fan(d, 8 + d.below(24), d.magnitude_between(-6, 0));
            for (int k = 0; k < 16; ++k) {
                const corners& t = mesh[d.below(static_cast<std::uint32_t>(mesh.size()))];
                const glm::dvec3 p(t[d.below(3)]), from(d.in_cube() + glm::vec3(0, 0, 3));
                const glm::vec3 o(from), way(0.9 * d.unit() * p - glm::dvec3(o));
                s.check(k % 4 == 0 ? !leaks(a, mesh, {o, -o}) : !leaks(a, mesh, {o, way}), "a leak: from" + shown({o, way}));
            }
        });
    add(cases, "watertightness/from-far-away", "from 1e4 away, through points of edges from which a step sideways is still over the mesh", source,
        margin, asked, [](const answers& a, score& s, std::uint32_t i) {
            dice d = dice_of(i, 8);
            const auto mesh = closed_mesh(d, 2, 1);
            for (int k = 0; k < 16; ++k) {
                const corners& t = mesh[d.below(static_cast<std::uint32_t>(mesh.size()))];
                const glm::vec3 o(1e4 * d.on_sphere());
                const glm::dvec3 middle = 0.5 * (glm::dvec3(t[0]) + glm::dvec3(t[1])) * 0.3;  // deep inside: the line passes the mesh twice
                s.check(!leaks(a, mesh, {o, glm::vec3(middle - glm::dvec3(o))}), "a leak: from" + shown({o}));
            }
        });
}

}  // namespace stress
