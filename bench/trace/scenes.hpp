// SPDX-License-Identifier: MIT
#pragma once
// What `trace` looks at: meshes and spheres, as many as one likes, and the rays that a picture of them needs.

#include "meshes.hpp"
#include "oracle.hpp"

#include <lantern/aabb.hpp>
#include <lantern/basis.hpp>
#include <lantern/bvh.hpp>
#include <lantern/closest.hpp>
#include <lantern/mesh.hpp>
#include <lantern/ray.hpp>
#include <lantern/sphere.hpp>
#include <lantern/surface.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace trace {

using lantern::mesh;
using lantern::ray;
using lantern::sphere;

template <class Surfaces>
struct scene {
    std::string name;
    std::function<Surfaces(std::uint32_t count)> make;  ///< of about so many surfaces
    glm::vec3 eye{0}, target{0};                        ///< where they are the same: from beyond a corner of the box around all
};

/// A mesh of triangles in the form of the Stanford models: PLY, ASCII, vertices that begin with x, y, z.
inline mesh read_ply(const std::string& path) {
    std::ifstream file(path);
    const auto refuse_unless = [&](bool good, const char* what) {
        if (!good) throw std::runtime_error(path + ": " + what);
    };
    refuse_unless(file.good(), "cannot be opened");
    std::size_t vertices = 0, faces = 0;
    std::string word;
    for (bool first = true; file >> word && word != "end_header"; first = false) {
        refuse_unless(!first || word == "ply", "is no PLY file");
        if (word == "format") refuse_unless(bool(file >> word) && word == "ascii", "is not in ASCII");
        if (word == "vertex") file >> vertices;
        if (word == "face") file >> faces;
    }
    std::getline(file, word);
    std::vector<glm::vec3> points;
    for (std::size_t i = 0; i < vertices && std::getline(file, word); ++i) {
        glm::vec3 p;
        refuse_unless(std::sscanf(word.c_str(), "%f %f %f", &p.x, &p.y, &p.z) == 3, "a vertex is not three numbers");
        points.push_back(p);
    }
    std::vector<glm::uvec3> triangles;
    for (std::size_t i = 0; i < faces && std::getline(file, word); ++i) {
        glm::uvec3 t;
        refuse_unless(std::sscanf(word.c_str(), "3 %u %u %u", &t.x, &t.y, &t.z) == 3, "a face is not a triangle");
        triangles.push_back(t);
    }
    refuse_unless(points.size() == vertices && triangles.size() == faces && faces > 0, "ends too early");
    return mesh(std::move(points), std::move(triangles));
}

/// The scenes that need no file. The dragon comes with `--dragon`, in four sizes.
inline std::vector<scene<mesh>> made_scenes() {
    const auto side = [](std::uint32_t n, double per_square) {
        return static_cast<std::uint32_t>(std::max(1.0, std::sqrt(n / per_square)));
    };
    return {
        {"sphere", [=](std::uint32_t n) { return meshes::sphere(side(n, 8), 0.002f); }, {0, 0.5f, 2.5f}, {0, 0, 0}},
        {"terrain", [=](std::uint32_t n) { return meshes::terrain(side(n, 2)); }, {-0.2f, 0.5f, -0.3f}, {0.5f, 0, 0.5f}},
        {"soup", [](std::uint32_t n) { return meshes::soup(n, 2 / std::cbrt(double(n))); }, {0, 0.5f, 3}, {0, 0, 0}},
        {"slivers", [](std::uint32_t n) { return meshes::slivers(std::max(1u, n / 10)); }, {0, 0.5f, 3}, {0, 0, 0}},
    };
}

/// Those that are traced if they are asked for by name.
inline std::vector<scene<mesh>> other_scenes() {
    return {{"hall", [](std::uint32_t n) { return meshes::hall(n); }, {0, 0.5f, 3}, {0, 0, 0}}};
}

/// The Stanford dragon: of its four sizes in the folder, the one nearest to what is wished.
inline scene<mesh> dragon(const std::string& folder) {
    const auto read = [folder](std::uint32_t n) {
        const double of[] = {871'414, 202'520, 47'794, 11'102};
        std::size_t best = 0;
        for (std::size_t i = 0; i < 4; ++i)
            if (std::abs(std::log(of[i] / n)) < std::abs(std::log(of[best] / n))) best = i;
        return read_ply(folder + "/dragon_vrip" + (best == 0 ? "" : "_res" + std::to_string(best + 1)) + ".ply");
    };
    return {"dragon", read, {-0.03f, 0.19f, 0.25f}, {-0.005f, 0.12f, 0}};
}

/// So many spheres strewn over the cube from -1 to 1, smaller the more they are: a ray passes about as many on its way.
inline scene<std::vector<sphere>> field() {
    const auto strew = [](std::uint32_t n) {
        dice d{.state = 80};
        const auto radius = static_cast<float>(0.3 / std::cbrt(double(n)));
        std::vector<sphere> all;
        for (std::uint32_t i = 0; i < n; ++i) all.push_back({d.in_cube(), radius * d.between(0.5, 1)});
        return all;
    };
    return {"field", strew, {0, 0.5f, 3}, {0, 0, 0}};
}

struct ray_set {
    std::string name;
    std::vector<ray> rays;
    bool any = false;  ///< whether anything is hit, is the question
};

inline constexpr lantern::interval whole_shadow{0, 0.999f};  // the rays end on the light

/// Rays that a picture needs: through its pixels, onwards from there in all directions, to a light; and the second kind in
/// disorder. About `count` of the first kind.
template <class Surfaces>
std::vector<ray_set> ray_sets(const scene<Surfaces>& s, const Surfaces& surfaces, std::uint32_t count) {
    const lantern::bvh tree(surfaces);
    const lantern::aabb box = tree.nodes()[0].volume;
    glm::vec3 eye = s.eye, target = s.target;
    if (eye == target) target = center(box), eye = target + 0.8f * (box.max - box.min);
    ray_set primary{"primary", {}}, bounce{"bounce", {}}, shadow{"shadow", {}, true};
    const auto side = static_cast<std::uint32_t>(std::max(1.0, std::sqrt(double(count))));
    const lantern::basis axes = lantern::basis_from(target - eye);
    dice d{.state = 11};
    const glm::vec3 light = center(box) + 2.0f * (box.max - box.min);
    for (std::uint32_t j = 0; j < side; ++j)
        for (std::uint32_t i = 0; i < side; ++i) {
            const float x = ((float(i) + 0.5f) / float(side) - 0.5f) * 0.7f, y = ((float(j) + 0.5f) / float(side) - 0.5f) * 0.7f;
            primary.rays.push_back({eye, lantern::unit(axes.w + x * axes.u + y * axes.v)});
        }
    for (const ray& r : primary.rays)
        if (const auto h = closest(tree, surfaces, r)) {
            const glm::vec3 n = glm::dot(h->normal, r.direction) < 0 ? h->normal : -h->normal;
            const glm::vec3 way = lantern::unit(n + 0.999f * glm::vec3(d.on_sphere()));
            bounce.rays.push_back({leave(*h, way), way});
            const glm::vec3 to = light + 0.1f * glm::length(box.max - box.min) * d.in_cube(), from = leave(*h, to - h->point);
            shadow.rays.push_back({from, to - from});
        }
    ray_set shuffled{"shuffled", bounce.rays};
    for (std::size_t i = shuffled.rays.size(); i > 1; --i)
        std::swap(shuffled.rays[i - 1], shuffled.rays[d.below(static_cast<std::uint32_t>(i))]);
    return {primary, bounce, shadow, shuffled};
}

}  // namespace trace
