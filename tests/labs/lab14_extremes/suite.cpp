// SPDX-License-Identifier: MIT
// Lab 14: hard cases, whose answers whole numbers know exactly.

#include "contract.hpp"

#include "../../../labs/lab14_extremes/cases.hpp"

#include <catch.hpp>
#include <hint.hpp>

#include <cmath>
#include <limits>
#include <vector>

using namespace contract::lab14;
using glm::dvec3;
using glm::vec3;

namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr double one_ulp = 1;  // rounded once, an answer is wrong by half of one

void check(const char* name, const extremes::score& s) {
    INFO(name << ": " << s.wrong << " of " << s.asked << " answers are wrong, the others by up to " << s.ulp << " ulp");
    CHECK(s.wrong == 0);
    CHECK(s.ulp <= one_ulp);
}
void check_sphere(int which) { check(extremes::sphere_names[std::size_t(which)], extremes::judge_spheres(which, hit_sphere)); }
void check_triangle(int which) { check(extremes::triangle_names[std::size_t(which)], extremes::judge_triangles(which, hit_triangle)); }
void check_box(int which) { check(extremes::box_names[std::size_t(which)], extremes::judge_boxes(which, meets_box)); }
void check_basis(int which) { check(extremes::basis_names[std::size_t(which)], extremes::judge_bases(which, basis_around)); }

const std::vector<float> sizes{1e-6f, 1e-3f, 1, 1e3f, 1e6f};

}  // namespace

// ---- step 1 ----------------------------------------------------------------------------------------------------------

TEST_CASE("an everyday sphere is hit where it is", "[step1]") {
    INFO(hint("no sphere, or another one", "the smaller root that is above 0, else the larger one", "§1 A ray and a sphere"));
    check_sphere(0);
}

TEST_CASE("a distant sphere has a sharp rim", "[step1]") {
    INFO(hint("a small sphere far away has holes, and dots around it", "b² and a k are nearly equal: float cannot tell which is larger",
              "§1 A ray and a sphere"));
    check_sphere(1);
}

TEST_CASE("a ground of radius 10^6 is where it should be, and one of 10^9", "[step1]") {
    INFO(hint("the ground is rough, or gone", "R² has twice as many digits as R, and b - root cancels", "§1 A ray and a sphere"));
    check_sphere(2);
    check_sphere(3);
}

TEST_CASE("a ground of radius 10^12 is, too", "[step1]") {
    INFO(hint("the ground is rough, or gone, when the radius is as large as that", "double has 53 bits; this takes 80: two_sum, two_product",
              "§1 A ray and a sphere"));
    check_sphere(4);
}

TEST_CASE("a ray that starts on the sphere does not meet it there", "[step1]") {
    INFO(hint("spots of shadow all over it", "t = 0 is no hit: |f|² - R² must be exactly 0", "§1 A ray and a sphere"));
    check_sphere(5);
}

TEST_CASE("no scene is too large or too small for spheres", "[step1]") {
    INFO(hint("a scene in other units is empty", "squares leave the range of float; nothing may be compared with a number like 1e-8", "§1 A ray and a sphere"));
    check_sphere(6);
    check_sphere(7);
}

TEST_CASE("the direction has any length for spheres", "[step1]") {
    INFO(hint("transformed spheres are gone", "t counts in units of the direction: a is not 1, and no t > 0 is too small", "§1 A ray and a sphere"));
    check_sphere(8);
    check_sphere(9);
}

TEST_CASE("a ray that is not a number meets no sphere", "[step1]") {
    INFO(hint("NaN spreads over the picture", "comparisons with NaN are false: ask so that false means a miss", "§1 A ray and a sphere"));
    CHECK_FALSE(hit_sphere({0, 0, -3}, 1, {{0, 0, 0}, {0, not_a_number, -1}}).has_value());
    CHECK_FALSE(hit_sphere({0, 0, -3}, 1, {{infinite, 0, 0}, {0, 0, -1}}).has_value());
    CHECK_FALSE(hit_sphere({0, 0, -3}, 1, {{0, 0, 0}, {0, 0, 0}}).has_value());
}

// ---- step 2 ----------------------------------------------------------------------------------------------------------

TEST_CASE("an everyday triangle is hit where it is, from both sides", "[step2]") {
    INFO(hint("holes, or a triangle that is too large", "all three signs are equal, be they plus or minus", "§2 A ray and a triangle"));
    check_triangle(0);
    check_triangle(6);
}

TEST_CASE("a small triangle is a triangle", "[step2]") {
    INFO(hint("fine meshes, and scenes in kilometres, are gone", "a determinant has the size of an area: no number is too small for it but 0",
              "§2 A ray and a triangle"));
    check_triangle(1);
    check_triangle(2);
    check_triangle(3);
}

TEST_CASE("a sliver is neither missing nor displaced", "[step2]") {
    INFO(hint("gaps in thin things", "the weights of a sliver are nearly all rounding: take t from its plane", "§2 A ray and a triangle"));
    check_triangle(4);
}

TEST_CASE("a ray along the surface meets it at the right place", "[step2]") {
    INFO(hint("a floor that dissolves towards the horizon", "the determinant is a small difference of large products: double", "§2 A ray and a triangle"));
    check_triangle(5);
}

TEST_CASE("no ray passes between two triangles that share an edge", "[step2]") {
    INFO(hint("dots of background on a closed surface", "both triangles must ask the same question about their edge, and get the same answer",
              "§2 A ray and a triangle"));
    for (const int scale : {0, -13, -50}) check("rays through edges", extremes::judge_leaks(false, scale, hit_triangle));
}

TEST_CASE("no ray passes among the triangles around a vertex", "[step2]") {
    INFO(hint("dots of background at the corners of triangles", "a vertex is seen in one place, whichever triangle asks; and 0 is inside",
              "§2 A ray and a triangle"));
    for (const int scale : {0, -13, -50}) check("rays through vertices", extremes::judge_leaks(true, scale, hit_triangle));
}

TEST_CASE("a triangle without an area is missed", "[step2]") {
    INFO(hint("NaN spreads over the picture", "a determinant of 0 is a miss", "§2 A ray and a triangle"));
    const lantern::ray down{{0.25f, 0.25f, 1}, {0, 0, -1}};
    CHECK(hit_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, down).has_value());
    CHECK_FALSE(hit_triangle({0, 0, 0}, {1, 1, 0}, {0.5f, 0.5f, 0}, down).has_value());
    CHECK_FALSE(hit_triangle({0.25f, 0.25f, 0}, {0.25f, 0.25f, 0}, {0.25f, 0.25f, 0}, down).has_value());
    CHECK_FALSE(hit_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {{0.25f, 0.25f, 1}, {0, not_a_number, -1}}).has_value());
}

// ---- step 3 ----------------------------------------------------------------------------------------------------------

TEST_CASE("an everyday box is met, and one beside the ray is not", "[step3]") {
    INFO(hint("boxes are missed, or nothing is gained by them", "the latest way in, the earliest way out", "§3 A ray and a box"));
    check_box(0);
    check_box(6);
}

TEST_CASE("a ray that touches an edge or a corner meets the box", "[step3]") {
    INFO(hint("dark lines where boxes meet", "way in and way out are the same t; both are rounded", "§3 A ray and a box"));
    check_box(1);
    check_box(2);
}

TEST_CASE("a flat box is a box", "[step3]") {
    INFO(hint("floors and walls are gone", "near == far is a hit", "§3 A ray and a box"));
    check_box(3);
}

TEST_CASE("a ray that runs in a face meets the box, whatever the sign of its zeros", "[step3]") {
    INFO(hint("every other row of axis-parallel rays is missing", "0 · ∞ is NaN, and std::max keeps it or not, as its arguments stand", "§3 A ray and a box"));
    check_box(4);
    check_box(5);
}

TEST_CASE("a short direction is a direction for boxes", "[step3]") {
    INFO(hint("transformed boxes are met always, or never", "parallel is a direction of exactly 0", "§3 A ray and a box"));
    for (const int which : {0, 1, 6})
        for (extremes::box_question q : extremes::boxes(which, 64)) {
            q.ray.direction *= 0x1p-100f;
            REQUIRE(meets_box(q.low, q.high, q.ray) == q.truth);
        }
}

TEST_CASE("what is behind the ray, and what is empty, is not met", "[step3]") {
    INFO(hint("everything is tested twice", "t begins at 0; a box with low > high holds nothing", "§3 A ray and a box"));
    CHECK_FALSE(meets_box({-1, -1, 2}, {1, 1, 3}, {{0, 0, 0}, {0, 0, -1}}));
    CHECK_FALSE(meets_box(vec3(infinite), vec3(-infinite), {{0, 0, 0}, {0.1f, 0.2f, -1}}));
    CHECK(meets_box(vec3(-infinite), vec3(infinite), {{0, 0, 0}, {0.1f, 0.2f, -1}}));
    CHECK(meets_box({-1, -1, -1}, {1, 1, 1}, {{0, 0, 0}, {0.1f, 0.2f, -1}}));
}

// ---- step 4 ----------------------------------------------------------------------------------------------------------

TEST_CASE("a hit is brought back onto the sphere", "[step4]") {
    INFO(hint("acne where the ray came from afar", "t is rounded, and so is what t is multiplied with: move the point along the normal", "§4 Leaving a surface"));
    extremes::dice random(21);
    for (const float size : sizes)
        for (int i = 0; i < 200; ++i) {
            const vec3 c = size * 3.0f * random.direction(), n = random.direction();
            const float radius = size * (0.1f + random.unit()), distance = 1000 * size * random.unit();
            const lantern::ray r{c + (radius + distance) * n, -n};
            const dvec3 met = dvec3(r.origin) + double(distance) * dvec3(r.direction);
            const dvec3 p(on_sphere(c, radius, r, distance));
            const double ulp = extremes::ulp_of(double(extremes::largest(vec3(p))));
            REQUIRE(std::abs(glm::length(p - dvec3(c)) - double(radius)) <= ulp);
            REQUIRE(glm::length(p - met) <= 4e-4 * double(size));  // ulp of what is 1000 sizes away, a few times
        }
}

TEST_CASE("a hit is brought back onto the triangle", "[step4]") {
    INFO(hint("acne where the ray came from afar", "t is rounded, and so is what t is multiplied with: move the point along the normal", "§4 Leaving a surface"));
    extremes::dice random(22);
    for (const float size : sizes)
        for (int i = 0; i < 200; ++i) {
            const vec3 a = size * 3.0f * random.direction(), b = a + size * random.direction(), c = a + size * random.direction(), n = random.direction();
            const dvec3 normal = glm::cross(dvec3(b) - dvec3(a), dvec3(c) - dvec3(a));
            if (glm::length(normal) < 0.1 * double(size) * double(size)) continue;
            const float distance = 1000 * size * random.unit();
            const lantern::ray r{(a + b + c) / 3.0f + distance * n, -n};
            const dvec3 met = dvec3(r.origin) + double(distance) * dvec3(r.direction);
            const dvec3 p(on_triangle(a, b, c, r, distance));
            const double ulp = extremes::ulp_of(double(extremes::largest(vec3(p))));
            REQUIRE(std::abs(glm::dot(p - dvec3(a), normal) / glm::length(normal)) <= ulp);
            REQUIRE(glm::length(p - met) <= 4e-4 * double(size));
        }
}

TEST_CASE("a ray that leaves begins on its side of the surface, at any scale", "[step4]") {
    INFO(hint("acne: a surface in its own shadow", "the distance to the next float grows with the coordinates, and so must the step; the direction says which way",
              "§4 Leaving a surface"));
    for (const float size : sizes) {
        INFO("in a scene of size " << size);
        CHECK(extremes::leave_spheres(size, on_sphere, leave).acne == 0);
        CHECK(extremes::leave_triangles(size, on_triangle, leave).acne == 0);
    }
}

TEST_CASE("a ray that leaves does not lose contact, at any scale", "[step4]") {
    INFO(hint("shadows that do not reach what throws them; light leaks through thin walls", "a thousandth of what? Steps are counted in ulp", "§4 Leaving a surface"));
    for (const float size : sizes) {
        INFO("in a scene of size " << size);
        CHECK(extremes::leave_spheres(size, on_sphere, leave).lost == 0);
        CHECK(extremes::leave_triangles(size, on_triangle, leave).lost == 0);
    }
}

TEST_CASE("the length of the direction does not matter when one leaves", "[step4]") {
    INFO(hint("glass that depends on the length of a vector", "the step is along the normal; of the direction only the side counts", "§4 Leaving a surface"));
    const vec3 p(3, 4, 5), n(0, 0, 1), d(0.6f, 0, 0.8f);
    CHECK(leave(p, n, 1e10f * d) == leave(p, n, d));
    CHECK(leave(p, n, 1e-10f * d) == leave(p, n, d));
    CHECK(leave(p, n, -1e-10f * d) == leave(p, n, -d));
    CHECK(leave(p, n, d).z > 5);
    CHECK(leave(p, n, -d).z < 5);
}

// ---- step 5 ----------------------------------------------------------------------------------------------------------

TEST_CASE("around a unit vector there is a frame", "[step5]") {
    INFO(hint("glossy reflections are skewed", "perpendicular, of length 1, u × v = w", "§5 A frame"));
    check_basis(0);
}

TEST_CASE("a vector of nearly unit length will do, and of any other", "[step5]") {
    INFO(hint("lobes that are narrower here and wider there", "the formula multiplies an error of the length into u and v: normalise first, in double",
              "§5 A frame"));
    check_basis(1);
    check_basis(2);
}

TEST_CASE("near the poles there are frames, too", "[step5]") {
    INFO(hint("a spot of noise where normals point to -z", "1 + z cancels there: take the pole that is farther away", "§5 A frame"));
    check_basis(3);
    check_basis(4);
    for (const vec3 w : {vec3(0, 0, 1), vec3(0, 0, -1), vec3(1, 0, 0), vec3(0, -1, 0), vec3(1, 0, -0.0f), vec3(1e-30f, 0, -1)}) {
        const frame_then f = basis_around(w);
        CHECK(extremes::frame_error(f.u, f.v, f.w, w) <= 0x1p-22);
    }
}

TEST_CASE("what has no direction gets the frame of the axes", "[step5]") {
    INFO(hint("NaN spreads over the picture", "the zero vector cannot be normalised", "§5 A frame"));
    for (const vec3 w : {vec3(0), vec3(not_a_number, 0, 1)}) {
        const frame_then f = basis_around(w);
        CHECK(f.u == vec3(1, 0, 0));
        CHECK(f.v == vec3(0, 1, 0));
        CHECK(f.w == vec3(0, 0, 1));
    }
}

// ---- step 6 ----------------------------------------------------------------------------------------------------------

TEST_CASE("thirty million samples have a mean", "[step6]") {
    INFO(hint("pictures that become darker the longer they are rendered", "from 2^24 on a float does not grow when 1 is added", "§6 A sum"));
    const std::vector<float> samples{0.1f, 0.7f, 0.25f};
    const double truth = (double(0.1f) + double(0.7f) + 0.25) / 3;
    CHECK(std::abs(double(mean_of(samples, 10'000'000).mean) - truth) <= extremes::ulp_of(truth));
}

TEST_CASE("a few samples have a mean, and none has 0", "[step6]") {
    INFO(hint("a pixel that is NaN", "0 / 0", "§6 A sum"));
    CHECK(mean_of(std::vector<float>{1, 2, 6}, 1).mean == 3);
    CHECK(mean_of(std::vector<float>{-1, 1, 6}, 2).mean == 2);
    CHECK(mean_of({}, 1).mean == 0);
    CHECK(mean_of({}, 1).rejected == 0);
}

TEST_CASE("a faint sample counts beside a bright one", "[step6]") {
    INFO(hint("what lamps shine on is right, the rest is black", "float has 24 bits", "§6 A sum"));
    CHECK(mean_of(std::vector<float>{16'777'216, 1, 1, -16'777'216}, 1).mean == 0.5f);
    CHECK(std::abs(double(mean_of(std::vector<float>{3e38f}, 1000).mean) / double(3e38f) - 1) <= 0x1p-23);
}

TEST_CASE("samples that are not finite are counted and left out", "[step6]") {
    INFO(hint("a black or white dot that no number of samples mends", "NaN + x is NaN: it must not get into the sum, and must not be kept secret", "§6 A sum"));
    const mean_then m = mean_of(std::vector<float>{1, not_a_number, 2, infinite, 6, -infinite}, 2);
    CHECK(m.mean == 3);
    CHECK(m.rejected == 6);
    CHECK(mean_of(std::vector<float>{not_a_number}, 3).mean == 0);
    CHECK(mean_of(std::vector<float>{not_a_number}, 3).rejected == 3);
}

// ---- step 7 ----------------------------------------------------------------------------------------------------------

TEST_CASE("light is bent by Snell's law", "[step7]") {
    INFO(hint("glass that looks like something else", "n × out = ratio · n × in, for unit vectors; out goes on beyond the surface", "§7 Total reflection"));
    extremes::dice random(23);
    int passed = 0;
    while (passed < 300) {
        const vec3 n = random.direction(), d = random.direction();
        const float ratio = 0.5f + random.unit();
        const dvec3 dn(n), dd(d);
        const double sine = double(ratio) * glm::length(glm::cross(glm::normalize(dn), glm::normalize(dd)));
        if (glm::dot(dn, dd) > -0.01 || std::abs(sine - 1) < 0.01) continue;
        const auto out = refracted(d, n, ratio);
        REQUIRE(out.has_value() == (sine < 1));
        if (!out) continue;
        ++passed;
        REQUIRE(extremes::snell_error(d, n, ratio, *out) <= 0x1p-22);
    }
}

TEST_CASE("total reflection begins exactly where it should", "[step7]") {
    INFO(hint("a noisy ring inside of glass balls", "1 - cos² cancels, and its root is worse: sin² from the cross product", "§7 Total reflection"));
    check("near the critical angle", extremes::judge_refractions(refracted));
}

TEST_CASE("at the critical angle itself light runs along the surface", "[step7]") {
    INFO(hint("a ring that is too wide by nothing", "reflected is what is beyond 1", "§7 Total reflection"));
    const auto out = refracted({4, -3, 0}, {0, 1, 0}, 1.25f);  // sin θ = 4/5
    REQUIRE(out.has_value());
    CHECK(glm::length(dvec3(*out) - dvec3(1, 0, 0)) <= 1e-7);
    CHECK_FALSE(refracted({4, -3, 0}, {0, 1, 0}, std::nextafter(1.25f, 2.0f)).has_value());
}

TEST_CASE("lengths of direction and normal do not matter for refraction", "[step7]") {
    INFO(hint("glass that depends on the scale of the scene", "divide by the lengths, or do not depend on them", "§7 Total reflection"));
    const vec3 d(0.3f, -0.8f, 0.1f), n(0.1f, 1, 0.2f);
    for (const float k : {1e-9f, 0.5f, 3.0f, 1e9f}) {
        const auto a = refracted(k * d, n, 0.7f), b = refracted(d, k * n, 0.7f);
        REQUIRE(a.has_value());
        REQUIRE(b.has_value());
        CHECK(extremes::snell_error(d, n, 0.7f, *a) <= 0x1p-22);
        CHECK(extremes::snell_error(d, n, 0.7f, *b) <= 0x1p-22);
    }
}

TEST_CASE("straight onto glass light goes straight on", "[step7]") {
    INFO(hint("NaN in the middle of a ball", "there is no sideways part to divide by", "§7 Total reflection"));
    for (const float ratio : {0.5f, 1.0f, 1.5f}) {
        const auto out = refracted({0, -2, 0}, {0, 1, 0}, ratio);
        REQUIRE(out.has_value());
        CHECK(glm::length(dvec3(*out) - dvec3(0, -1, 0)) <= 1e-7);
    }
    const vec3 d(0.36f, -0.48f, 0.8f);
    const auto out = refracted(d, {0, 1, 0}, 1);
    REQUIRE(out.has_value());
    CHECK(glm::length(dvec3(*out) - glm::normalize(dvec3(d))) <= 1e-7);
}
