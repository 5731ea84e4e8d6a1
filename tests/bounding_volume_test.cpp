// SPDX-License-Identifier: MIT
#include <lantern/bounding_volume.hpp>

#include <lantern/any_of.hpp>
#include <lantern/bounding_sphere.hpp>
#include <lantern/cylinder.hpp>
#include <lantern/disk.hpp>
#include <lantern/instance.hpp>
#include <lantern/moving.hpp>
#include <lantern/obb.hpp>
#include <lantern/plane.hpp>
#include <lantern/rectangle.hpp>
#include <lantern/rotating.hpp>
#include <lantern/sphere.hpp>
#include <lantern/triangle.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <cmath>
#include <vector>

using lantern::aabb;
using lantern::bounding_sphere;
using lantern::bounding_volume;
using lantern::interval;
using lantern::obb;
using lantern::ray;
using lantern::sphere;
using lantern::timed_ray;
using lantern::triangle;
using lantern::volume_of;
using lantern::volume_of_all;

static_assert(bounding_volume<aabb> && bounding_volume<bounding_sphere> && bounding_volume<obb>);
static_assert(!bounding_volume<sphere> && !bounding_volume<lantern::plane>);

namespace {
using shape = lantern::any_of<sphere, triangle, lantern::rectangle, lantern::disk, lantern::cylinder>;

shape random_shape(dice& d, float size) {
    const glm::vec3 p = d.in_cube(), u = d.in_cube(size), v = d.in_cube(size);
    switch (d.below(5)) {
        case 0: return sphere{p, size * d.between(0, 1)};
        case 1: return triangle{p, p + u, p + v};
        case 2: return lantern::rectangle{p, u, v};
        case 3: return lantern::disk{p, u, size * d.between(0, 1)};
        default: return lantern::cylinder{p, p + u, size * d.between(0, 1)};
    }
}

glm::mat4 random_affine(dice& d) {
    glm::mat4 m(1);
    do
        m = {glm::vec4(d.in_cube(), 0), glm::vec4(d.in_cube(), 0), glm::vec4(d.in_cube(), 0), glm::vec4(d.in_cube(5), 1)};
    while (std::abs(glm::determinant(glm::mat3(m))) < 0.01f);
    return m;
}

/// Wherever the surface is hit, the volume is met: in the whole range, up to the hit, and from just before it.
template <class Volume, class Surface, class Ray>
bool keeps_its_promise(const Volume& v, const Surface& s, const Ray& r) {
    const auto h = intersect(s, r, interval{});
    if (!h) return false;
    REQUIRE(overlaps(v, r, interval{}));
    REQUIRE(overlaps(v, r, interval{0, h->t}));
    REQUIRE(overlaps(v, r, interval{std::nextafter(h->t, 0.0f), h->t}));
    REQUIRE(overlaps(v, lantern::precise::widen(r), interval{0, h->t}));
    return true;
}

template <class Volume>
void no_ray_slips_through() {
    dice d{.state = 3};
    int hits = 0;
    for (int i = 0; i < 6000; ++i) {
        const float size = d.magnitude_between(-5, 0), scale = d.magnitude_between(-12, 9);
        const shape s = random_shape(d, size);
        const Volume v = volume_of<Volume>(s);
        const glm::vec3 target = center(bounds(s)) + d.in_cube(size), from = d.in_cube(3);
        hits += keeps_its_promise(v, s, ray{from, (target - from) * scale});

        const lantern::instance placed(s, random_affine(d));
        const glm::vec3 there = center(bounds(placed)) + d.in_cube(size), away = d.in_cube(9);
        hits += keeps_its_promise(volume_of<Volume>(placed), placed, ray{away, there - away});

        const lantern::moving flying{s, d.in_cube()};
        const float time = d.between(0, 1);
        hits += keeps_its_promise(volume_of<Volume>(flying), flying,
                                  timed_ray{{from, target + time * flying.displacement - from}, time});
    }
    CHECK(hits > 2500);
}

template <class Volume>
void any_scale_will_do() {
    dice d{.state = 4};
    for (const float scale : {1e-18f, 1e-6f, 1e6f, 1e17f})
        for (const float far : {0.0f, 100.0f})
            for (int i = 0; i < 300; ++i) {
                const glm::vec3 p = scale * (glm::vec3(far) + d.in_cube()), from = scale * (glm::vec3(far) + d.in_cube(4));
                const sphere s{p, scale * d.magnitude_between(-4, 0)};
                const triangle t{p, p + scale * d.in_cube(0.1), p + scale * d.in_cube(0.1)};
                const glm::dvec3 side = double(s.radius) * glm::cross(glm::normalize(glm::dvec3(p - from)), d.on_sphere());
                (void)keeps_its_promise(volume_of<Volume>(s), s, ray{from, p + glm::vec3(side) - from});  // grazing
                (void)keeps_its_promise(volume_of<Volume>(t), t, ray{from, (t.a + t.b) / 2.0f - from});
            }
}

template <class Volume>
void groups_hold_their_members() {
    dice d{.state = 5};
    for (int i = 0; i < 60; ++i) {
        std::vector<shape> group;
        for (std::uint32_t k = d.below(20) + 1; k > 0; --k) group.push_back(random_shape(d, 0.3f));
        const Volume all = volume_of_all<Volume>(group);
        for (const shape& s : group)
            for (int k = 0; k < 10; ++k) {
                const glm::vec3 from = d.in_cube(3);
                (void)keeps_its_promise(all, s, ray{from, center(bounds(s)) + d.in_cube(0.1) - from});
            }
        const Volume two = enclose(volume_of<Volume>(group[0]), volume_of<Volume>(group.back()));
        const glm::vec3 from = d.in_cube(3);
        (void)keeps_its_promise(two, group[0], ray{from, center(bounds(group[0])) - from});
    }
}

template <class Volume>
void nothing_holds_nothing() {
    CHECK(empty(Volume{}));
    CHECK(surface_area(Volume{}) == 0);
    CHECK_FALSE(overlaps(Volume{}, ray{}, interval{}));
    CHECK(empty(volume_of_all<Volume>(std::vector<sphere>{})));
    CHECK(empty(enclose(Volume{}, lantern::hull{})));
    const Volume some = volume_of<Volume>(sphere{{0, 0, -3}, 1});
    CHECK(surface_area(enclose(Volume{}, some)) == Approx(surface_area(some)));
    CHECK(surface_area(enclose(some, lantern::hull{})) == Approx(surface_area(some)));
    CHECK(overlaps(some, ray{}, interval{}));
    CHECK_FALSE(overlaps(some, ray{}, interval{4.1f, 9}));
    CHECK_FALSE(overlaps(some, ray{}, interval{0, 1.9f}));
    CHECK(overlaps(some, ray{{0, 0, -3}, {1, 0, 0}}, interval{}));                    // from inside
    CHECK_FALSE(overlaps(some, ray{{0, 0, 0}, {0, 0, 1}}, interval{}));               // behind
    CHECK_FALSE(overlaps(some, ray{{1.5f, 1.5f, 0}, {0, -0.0f, -1}}, interval{}));    // beside, with -0
}

template <class Volume>
void a_point_can_be_hit() {
    const Volume v = enclose(Volume{}, lantern::hull{{glm::dvec3(1, 2, 3)}, 0});
    CHECK_FALSE(empty(v));
    CHECK(overlaps(v, ray{{0, 2, 3}, {1, 0, -0.0f}}, interval{}));
    CHECK(overlaps(v, ray{{1, 2, 3}, {0, 1, 0}}, interval{}));
    CHECK_FALSE(overlaps(v, ray{{0, 2.001f, 3}, {1, 0, 0}}, interval{}));
}

}  // namespace

TEST_CASE("no ray that hits a surface misses its volume: primitives, transformed ones, moving ones") {
    no_ray_slips_through<aabb>();
    no_ray_slips_through<bounding_sphere>();
    no_ray_slips_through<obb>();
}

TEST_CASE("at any scale, far from the origin and grazing") {
    any_scale_will_do<aabb>();
    any_scale_will_do<bounding_sphere>();
    any_scale_will_do<obb>();
}

TEST_CASE("groups hold their members") {
    groups_hold_their_members<aabb>();
    groups_hold_their_members<bounding_sphere>();
    groups_hold_their_members<obb>();
}

TEST_CASE("an empty volume is met by no ray and adds nothing") {
    nothing_holds_nothing<aabb>();
    nothing_holds_nothing<bounding_sphere>();
    nothing_holds_nothing<obb>();
}

TEST_CASE("a point is a volume, too") {
    a_point_can_be_hit<aabb>();
    a_point_can_be_hit<bounding_sphere>();
    a_point_can_be_hit<obb>();
}

TEST_CASE("each volume suits something") {
    const sphere ball{{5, 5, 5}, 1};
    CHECK(surface_area(volume_of<bounding_sphere>(ball)) < surface_area(volume_of<aabb>(ball)));
    const triangle slanting{{0, 0, 0}, {10, 10, 10}, {10, 10, 10.5f}};
    CHECK(surface_area(volume_of<obb>(slanting)) < 0.1 * surface_area(volume_of<aabb>(slanting)));
    CHECK(surface_area(volume_of<obb>(slanting)) < 0.1 * surface_area(volume_of<bounding_sphere>(slanting)));
}
