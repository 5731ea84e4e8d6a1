// SPDX-License-Identifier: MIT
// What a robust formula costs beside the textbook's: both on the same everyday inputs, of which half are hits. Each is a function of
// its own, for callgrind to count (tools/commands/stress.py); run alone it prints nanoseconds.

#include <lantern/aabb.hpp>
#include <lantern/basis.hpp>
#include <lantern/glass.hpp>
#include <lantern/image.hpp>
#include <lantern/plane.hpp>
#include <lantern/sphere.hpp>
#include <lantern/surface.hpp>
#include <lantern/triangle.hpp>
#include <lantern/warp.hpp>

#include "naive.hpp"
#include "oracle.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <optional>
#include <vector>

namespace {

constexpr std::size_t count = 4096;

struct inputs {
    stress::ray r;
    lantern::ray our_ray;
    lantern::interval range;
    lantern::sphere sphere;
    lantern::triangle triangle;
    lantern::plane plane;
    glm::vec3 center, normal, direction;
    float radius;
    stress::box box;
    glm::vec2 xi;
    stress::hit hit;
};

/// Rays from ten units around to a place at the middle of things of size one; every other one passes beside it.
std::vector<inputs> make() {
    dice d{.state = 1};
    std::vector<inputs> all(count);
    for (std::size_t i = 0; i < count; ++i) {
        inputs& x = all[i];
        const bool passes = i % 2 == 1;
        x.center = d.in_cube(10);
        x.radius = d.between(0.2, 2);
        const glm::vec3 o = d.in_cube(10) + glm::vec3(0, 0, 15);
        const glm::dvec3 to = glm::dvec3(x.center) - glm::dvec3(o), side = glm::normalize(glm::cross(to, d.on_sphere()));
        const double offset = passes ? 1.1 + 3 * d.unit() : 0.95 * std::sqrt(d.unit());
        x.r = {o, glm::vec3(glm::normalize(to + offset * double(x.radius) * side))};
        // The triangle and the box around the same place, in the ray's way or not.
        const glm::dvec3 at = glm::dvec3(o) + 0.99 * glm::length(to) * glm::dvec3(x.r.direction), aside = passes ? 3.0 * side : glm::dvec3(0);
        double u = d.unit(), v = d.unit();
        if (u + v > 1) u = 1 - u, v = 1 - v;
        const glm::dvec3 e1(d.in_cube()), e2(d.in_cube()), corner = at + aside - u * e1 - v * e2;
        x.sphere = {x.center, x.radius};
        x.triangle = {glm::vec3(corner), glm::vec3(corner + e1), glm::vec3(corner + e2)};
        x.our_ray = {x.r.origin, x.r.direction};
        const glm::vec3 middle(at + aside), half = glm::vec3(0.8f) + 0.5f * d.in_cube();
        x.box = {middle - half, middle + half};
        x.normal = glm::vec3(d.on_sphere());
        x.plane = {x.center, x.normal};
        x.direction = glm::vec3(d.on_sphere());
        if (glm::dot(x.direction, x.normal) > 0) x.direction = -x.direction;
        x.xi = {d.between(0, 1), d.between(0, 1)};
        x.hit = {1, x.center, x.normal, 1e-7f};
    }
    return all;
}

float sum(glm::vec3 v) { return v.x + v.y + v.z; }
float sum(const auto& h) { return h ? h->t + sum(h->point) + sum(h->normal) : 0; }

float total(const std::vector<inputs>& all, auto&& of) {
    float s = 0;
    for (const inputs& x : all) s += of(x);
    return s;
}

}  // namespace

using list = std::vector<inputs>;

// Surfaces are asked as the library asks them: a function, with a range.
[[gnu::noinline]] static naive::answer textbook_sphere(const lantern::sphere& s, const stress::ray& r, lantern::interval range) {
    return naive::sphere(s.center, s.radius, r, range.min, range.max);
}
[[gnu::noinline]] static std::optional<lantern::hit> our_sphere(const lantern::sphere& s, const lantern::ray& r, lantern::interval range) {
    return intersect(s, r, range);
}
[[gnu::noinline]] static naive::answer textbook_triangle(const lantern::triangle& s, const stress::ray& r, lantern::interval range) {
    return naive::triangle(s.a, s.b, s.c, r, 1e-8f, range.min, range.max);
}
[[gnu::noinline]] static std::optional<lantern::hit> our_triangle(const lantern::triangle& s, const lantern::ray& r, lantern::interval range) {
    return intersect(s, r, range);
}
[[gnu::noinline]] static naive::answer textbook_plane(const lantern::plane& s, const stress::ray& r, lantern::interval range) {
    return naive::plane(s.point, s.normal, r, range.min, range.max);
}
[[gnu::noinline]] static std::optional<lantern::hit> our_plane(const lantern::plane& s, const lantern::ray& r, lantern::interval range) {
    return intersect(s, r, range);
}

extern "C" {
[[gnu::noinline]] float price_sphere_textbook(const list& v) { return total(v, [](auto& x) { return sum(textbook_sphere(x.sphere, x.r, x.range)); }); }
[[gnu::noinline]] float price_sphere_ours(const list& v) { return total(v, [](auto& x) { return sum(our_sphere(x.sphere, x.our_ray, x.range)); }); }
[[gnu::noinline]] float price_triangle_textbook(const list& v) { return total(v, [](auto& x) { return sum(textbook_triangle(x.triangle, x.r, x.range)); }); }
[[gnu::noinline]] float price_triangle_ours(const list& v) { return total(v, [](auto& x) { return sum(our_triangle(x.triangle, x.our_ray, x.range)); }); }
[[gnu::noinline]] float price_plane_textbook(const list& v) { return total(v, [](auto& x) { return sum(textbook_plane(x.plane, x.r, x.range)); }); }
[[gnu::noinline]] float price_plane_ours(const list& v) { return total(v, [](auto& x) { return sum(our_plane(x.plane, x.our_ray, x.range)); }); }
[[gnu::noinline]] float price_box_textbook(const list& v) { return total(v, [](auto& x) { return naive::meets_box(x.box, x.r) ? 1.0f : 0.0f; }); }
[[gnu::noinline]] float price_box_ours(const list& v) {
    return total(v, [](auto& x) {
        return overlaps(lantern::aabb{x.box.min, x.box.max}, x.our_ray, x.range) ? 1.0f : 0.0f;
    });
}
[[gnu::noinline]] float price_basis_textbook(const list& v) {
    return total(v, [](auto& x) { const auto f = naive::basis(x.direction); return sum(f.u) + sum(f.v) + sum(f.w); });
}
[[gnu::noinline]] float price_basis_ours(const list& v) {
    return total(v, [](auto& x) { const auto f = lantern::basis_from(x.direction); return sum(f.u) + sum(f.v) + sum(f.w); });
}
[[gnu::noinline]] float price_refraction_textbook(const list& v) {
    return total(v, [](auto& x) { const auto b = naive::refracted(x.direction, x.normal, 1.5f, false); return b ? sum(b->direction) + b->reflectance : 0; });
}
[[gnu::noinline]] float price_refraction_ours(const list& v) {
    return total(v, [](auto& x) { const auto b = lantern::refracted(x.direction, x.normal, 1.5); return b ? sum(b->direction) + b->reflectance : 0; });
}
[[gnu::noinline]] float price_leave_textbook(const list& v) { return total(v, [](auto& x) { return sum(naive::leave(x.hit, x.direction)); }); }
[[gnu::noinline]] float price_leave_ours(const list& v) {
    return total(v, [](auto& x) { return sum(lantern::leave({x.hit.t, x.hit.point, x.hit.normal, x.hit.error}, x.direction)); });
}
[[gnu::noinline]] float price_mean_textbook(const list& v) {
    glm::vec3 s(0);
    for (const inputs& x : v) s += x.center;
    return sum(s / float(count));
}
[[gnu::noinline]] float price_mean_ours(const list& v) {
    lantern::accumulator s;
    for (const inputs& x : v) s.add(x.center);
    return sum(s.mean());
}
}

namespace {

struct priced {
    const char* name;
    float (*run)(const list&);
};

constexpr priced all_prices[] = {
    {"price_sphere_textbook", price_sphere_textbook}, {"price_sphere_ours", price_sphere_ours},
    {"price_triangle_textbook", price_triangle_textbook}, {"price_triangle_ours", price_triangle_ours},
    {"price_plane_textbook", price_plane_textbook}, {"price_plane_ours", price_plane_ours},
    {"price_box_textbook", price_box_textbook}, {"price_box_ours", price_box_ours},
    {"price_basis_textbook", price_basis_textbook}, {"price_basis_ours", price_basis_ours},
    {"price_refraction_textbook", price_refraction_textbook}, {"price_refraction_ours", price_refraction_ours},
    {"price_leave_textbook", price_leave_textbook}, {"price_leave_ours", price_leave_ours},
    {"price_mean_textbook", price_mean_textbook}, {"price_mean_ours", price_mean_ours},
};

}  // namespace

/// Prints, of each function, nanoseconds a call: the best of `rounds`, by the processor's clock. One round does for counting.
int main(int argc, char**) {
    const list inputs = make();
    const int rounds = argc > 1 ? 1 : 25;
    float checksum = 0;
    for (const priced& p : all_prices) {
        double best = 1e30;
        for (int i = 0; i < rounds; ++i) {
            const std::clock_t began = std::clock();
            checksum += p.run(inputs);
            best = std::min(best, double(std::clock() - began) / CLOCKS_PER_SEC);
        }
        std::printf("%s %.2f\n", p.name, best * 1e9 / double(count));
    }
    std::printf("checksum %g\n", double(checksum));
}
