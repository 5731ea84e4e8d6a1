// SPDX-License-Identifier: MIT
// Lab 07: a lens. Most laws hold exactly, but for the rounding of float. Where points are counted, 64 x 64 jittered ones with
// fixed seeds are; a right answer, whichever it is, would fail less than once in a million choices of the seed: the bounds are those
// of independent points, and jittered ones are far more even.

#include "contract.hpp"

#include <catch.hpp>
#include <hint.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace contract::lab07;

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr float infinity = std::numeric_limits<float>::infinity();

/// side × side points, one somewhere within each cell of the unit square; in any order, the same on every machine.
std::vector<glm::vec2> jittered(int side, std::uint32_t seed) {
    std::mt19937 engine(seed);
    const auto one = [&] { return float((engine() >> 9) * 2 + 1) * 0x1p-24f; };
    std::vector<glm::vec2> points;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const float jitter = one();
            points.push_back((glm::vec2(x, y) + glm::vec2(jitter, one())) / float(side));
        }
    for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[engine() % i]);
    return points;
}

/// A camera that looks along none of the world's axes.
struct place {
    glm::vec3 eye{3, -2, 5};
    glm::mat3 axes;
    place() {
        const glm::dvec3 forward = glm::normalize(glm::dvec3(-2, 1, -3)), right = glm::normalize(glm::cross(forward, glm::dvec3(0.2, 1, 0)));
        axes = {glm::vec3(right), glm::vec3(glm::cross(right, forward)), glm::vec3(forward)};
    }
    [[nodiscard]] glm::dvec3 towards(glm::vec2 film) const {
        return glm::dvec3(axes[2]) + double(film.x) * glm::dvec3(axes[0]) + double(film.y) * glm::dvec3(axes[1]);
    }
    /// How far to the right, upwards and forward of the eye.
    [[nodiscard]] glm::dvec3 seen(glm::dvec3 p) const {
        const glm::dvec3 d = p - glm::dvec3(eye);
        return {glm::dot(d, glm::dvec3(axes[0])), glm::dot(d, glm::dvec3(axes[1])), glm::dot(d, glm::dvec3(axes[2]))};
    }
    /// Where a ray crosses the plane at that depth, seen from the point of the plane right before the eye.
    [[nodiscard]] glm::dvec2 at_depth(const lantern::ray& r, double depth) const {
        const glm::dvec3 o = seen(r.origin), d = seen(glm::dvec3(r.direction) + glm::dvec3(eye));
        const glm::dvec3 p = o + (depth - o.z) / d.z * d;
        return {p.x, p.y};
    }
};

const std::vector<glm::vec2> film_points{{0, 0}, {0.4f, 0.3f}, {-0.7f, 0.5f}, {0.2f, -0.6f}, {-0.9f, -0.9f}};

/// The sum of (count - expected)² / expected.
double chi_square(const std::vector<int>& counts, double expected) {
    double sum = 0;
    for (const int count : counts) sum += (count - expected) * (count - expected) / expected;
    return sum;
}

std::string listed(const std::vector<int>& counts) {
    std::string text;
    for (const int count : counts) text += std::to_string(count) + ' ';
    return text;
}

/// How many of the points fall into each of rings × sectors parts of the disc of radius 1, all of the same area; -1 for a
/// point outside.
std::vector<int> counted(int rings, int sectors, float radius, auto&& place_point) {
    std::vector<int> counts(std::size_t(rings * sectors));
    for (const glm::vec2 xi : jittered(64, 1)) {
        const glm::dvec2 p = glm::dvec2(place_point(xi, radius)) / double(radius);
        const double ring = std::floor(glm::dot(p, p) * rings), sector = std::floor((std::atan2(p.y, p.x) / (2 * pi) + 0.5) * sectors);
        CAPTURE(xi, radius, p.x, p.y);
        REQUIRE(ring >= 0);  // NaN is not
        ++counts[std::size_t(std::min(int(ring), rings - 1) * sectors + std::min(int(sector), sectors - 1))];
    }
    return counts;
}

const auto lens_point = [](glm::vec2 xi, float radius) { return on_lens(xi, radius); };

}  // namespace

// ---- Step 1: a point of the lens -----------------------------------------------------------------------------------

TEST_CASE("every point lies on the lens, and the lens is used up to its rim", "[step1]") {
    INFO(hint("blur discs too large or too small, or square", "the points fill a disc of that *radius*: no square, and no disc of that diameter",
              "§1 A disc"));
    const float radius = GENERATE(1.0f, 0.05f);
    double farthest = 0;
    for (const glm::vec2 xi : jittered(64, 2)) {
        const glm::vec2 p = on_lens(xi, radius);
        CAPTURE(xi, p, radius);
        REQUIRE(glm::length(p) <= radius * 1.00001f);
        farthest = std::max(farthest, double(glm::length(p)));
    }
    CHECK(farthest > 0.97 * double(radius));
}

TEST_CASE("rings of equal area get equally many points", "[step1]") {
    INFO(hint("blur discs are bright in the middle, like a Gaussian filter", "the area inside r grows as r², so r is the square root of a uniform number",
              "§1 The square root"));
    const std::vector<int> counts = counted(8, 1, 1, lens_point);
    INFO("points in eight rings of equal area, from the middle to the rim; 512 each would be even: " << listed(counts));
    CHECK(chi_square(counts, 512) < 50);  // 7 degrees of freedom: 1.4e-8
}

TEST_CASE("all sectors of the lens get equally many points", "[step1]") {
    INFO(hint("blur discs are half discs, or lopsided", "the angle runs through the whole circle, 2π, and every angle is equally likely", "§1 A disc"));
    const std::vector<int> counts = counted(1, 8, 1, lens_point);
    INFO("points in eight sectors; 512 each would be even: " << listed(counts));
    CHECK(chi_square(counts, 512) < 50);
}

TEST_CASE("every part of the lens gets its share", "[step1]") {
    INFO(hint("blur discs are spirals or rings", "radius and angle need numbers of their own: xi.x for one, xi.y for the other", "§1 Two numbers"));
    const std::vector<int> counts = counted(8, 8, 1, lens_point);
    INFO("points in 8 rings x 8 sectors; 64 each would be even: " << listed(counts));
    CHECK(chi_square(counts, 64) < 150);  // 63 degrees of freedom: 4e-9
}

TEST_CASE("the middle and the borders of the unit square give points of the lens", "[step1]") {
    INFO(hint("black dots: NaN", "the concentric map divides by zero at (1/2, 1/2): treat that point by itself", "§1 The concentric map"));
    for (const float x : {0.0f, 0.25f, 0.5f, 0.75f, 1.0f})
        for (const float y : {0.0f, 0.25f, 0.5f, 0.75f, 1.0f}) {
            const glm::vec2 p = on_lens({x, y}, 2);
            CAPTURE(x, y, p);
            CHECK(glm::length(p) <= 2.0001f);
        }
}

// ---- Step 2: the point in focus ------------------------------------------------------------------------------------

TEST_CASE("the point in focus lies on the ray through the film", "[step2]") {
    INFO(hint("the picture is shifted or stretched where it is in focus", "from the eye go along right·x + up·y + forward: axes * (film, 1)",
              "§2 The plane of focus"));
    const place camera;
    for (const glm::vec2 film : film_points) {
        const glm::dvec3 p = camera.seen(point_in_focus(camera.eye, camera.axes, film, 4));
        CAPTURE(film, p.x, p.y, p.z);
        CHECK(p.x / p.z == Approx(double(film.x)).margin(1e-5));
        CHECK(p.y / p.z == Approx(double(film.y)).margin(1e-5));
        CHECK(p.z > 0);
    }
}

TEST_CASE("what is in focus forms a plane, not a sphere", "[step2]") {
    INFO(hint("sharp in the middle, blurred towards the corners",
              "the distance is measured along the line of sight: do not normalise the direction before multiplying it by `focus`", "§2 The plane of focus"));
    const place camera;
    for (const float focus : {0.5f, 4.0f, 300.0f})
        for (const glm::vec2 film : film_points) {
            const glm::dvec3 p = camera.seen(point_in_focus(camera.eye, camera.axes, film, focus));
            CAPTURE(focus, film, p.x, p.y, p.z);
            CHECK(p.z == Approx(double(focus)).epsilon(1e-5));
        }
}

// ---- Step 3: a ray through the lens --------------------------------------------------------------------------------

TEST_CASE("every ray of a point of the film passes through its point in focus", "[step3]") {
    INFO(hint("only what is far away is sharp, or nothing at all", "the direction must change with the origin: it goes from the point of the lens to the point in focus", "§3 Through the lens"));
    const place camera;
    for (const glm::vec2 film : film_points)
        for (const glm::vec2 xi : jittered(6, 3)) {
            const lantern::ray r = through_lens(camera.eye, camera.axes, film, 0.3f, 4, xi);
            const glm::dvec2 p = camera.at_depth(r, 4);
            CAPTURE(film, xi, r.origin, r.direction, p.x, p.y);
            REQUIRE(p.x == Approx(4 * double(film.x)).margin(1e-4));
            REQUIRE(p.y == Approx(4 * double(film.y)).margin(1e-4));
            REQUIRE(camera.seen(glm::dvec3(r.direction) + glm::dvec3(camera.eye)).z > 0);
        }
}

TEST_CASE("rays start on the lens, which is parallel to the film", "[step3]") {
    INFO(hint("the blur is right while the camera looks along -z only", "the point of the lens counts along the camera's right and up, not along the world's x and y",
              "§3 Through the lens"));
    const place camera;
    for (const glm::vec2 xi : jittered(6, 4)) {
        const lantern::ray r = through_lens(camera.eye, camera.axes, {0.4f, 0.3f}, 0.5f, 4, xi);
        const glm::dvec3 o = camera.seen(r.origin);
        const glm::vec2 expected = on_lens(xi, 0.5f);
        CAPTURE(xi, o.x, o.y, o.z, expected);
        REQUIRE(std::abs(o.z) < 1e-5);
        REQUIRE(std::abs(o.x - double(expected.x)) < 1e-5);
        REQUIRE(std::abs(o.y - double(expected.y)) < 1e-5);
    }
}

TEST_CASE("directions have length 1", "[step3]") {
    INFO(hint("distances come out wrong in later labs", "normalise the direction, at the very end", "§3 Through the lens"));
    const place camera;
    for (const glm::vec2 film : film_points)
        CHECK(glm::length(through_lens(camera.eye, camera.axes, film, 0.3f, 2, {0.9f, 0.2f}).direction) == Approx(1).epsilon(1e-5));
}

TEST_CASE("a lens of radius 0 is a pinhole", "[step3]") {
    INFO(hint("blur where there should be none", "with radius 0 every ray starts at the eye and goes through its point of the film", "§3 The pinhole"));
    const place camera;
    for (const float focus : {0.3f, 4.0f, infinity})
        for (const glm::vec2 film : film_points) {
            const lantern::ray r = through_lens(camera.eye, camera.axes, film, 0, focus, {0.8f, 0.1f});
            CAPTURE(focus, film, r.origin, r.direction);
            CHECK(r.origin == camera.eye);
            CHECK(glm::length(glm::dvec3(r.direction) - glm::normalize(camera.towards(film))) < 1e-6);
        }
}

TEST_CASE("focused at infinity, the rays of a point of the film are parallel", "[step3]") {
    INFO(hint("NaN, or stars that are blurred", "∞ - ∞ is not a number, and 1e30 - 1 is 1e30: divide f·d - l by f", "§3 Infinity"));
    const place camera;
    for (const float focus : {1e20f, 1e30f, 3e38f, infinity})
        for (const glm::vec2 film : film_points) {
            const lantern::ray r = through_lens(camera.eye, camera.axes, film, 0.5f, focus, {0.8f, 0.1f});
            CAPTURE(focus, film, r.origin, r.direction);
            CHECK(glm::length(glm::dvec3(r.direction) - glm::normalize(camera.towards(film))) < 1e-6);
        }
}

// ---- Step 4: the circle of confusion -------------------------------------------------------------------------------

TEST_CASE("a point on the plane of focus stays a point", "[step4]") {
    INFO(hint("nothing is sharp", "the diameter is proportional to the difference of 1/focus and 1/depth", "§4 The circle of confusion"));
    for (const float focus : {0.5f, 4.0f, 1000.0f}) CHECK(circle_of_confusion(0.3f, focus, focus) == Approx(0).margin(1e-6));
}

TEST_CASE("the circle of confusion is the one that the rays draw", "[step4]") {
    INFO(hint("the blur of the formula and that of the picture differ", "2 R |1/f - 1/D|: the diameter, not the radius, and on the film, at distance 1",
              "§4 The circle of confusion"));
    const float radius = 0.2f;
    for (const float focus : {1.0f, 4.0f, 9.0f})
        for (const float depth : {0.5f, 2.0f, 5.0f, 80.0f}) {
            // The two rays from the point through the rim of the lens, on the right and on the left, meet the plane of focus ...
            const double point = 0.3 * double(depth);
            const auto on_focus = [&](double rim) { return rim + double(focus) / double(depth) * (point - rim); };
            // ... at what is imaged at 1 / focus of its size.
            const double expected = std::abs(on_focus(double(radius)) - on_focus(-double(radius))) / double(focus);
            CAPTURE(focus, depth);
            CHECK(circle_of_confusion(radius, focus, depth) == Approx(expected).epsilon(1e-4).margin(1e-6));
        }
}

TEST_CASE("a lens focused at infinity, and a star", "[step4]") {
    INFO(hint("NaN at infinity", "1/∞ is 0 in floating point: take the difference of the reciprocals, not (f - D) / (f D)", "§4 The circle of confusion"));
    CHECK(circle_of_confusion(0.2f, infinity, 8) == Approx(0.05));
    CHECK(circle_of_confusion(0.2f, 8, infinity) == Approx(0.05));
}

// ---- Step 5: the depth of field ------------------------------------------------------------------------------------

TEST_CASE("at both ends of the depth of field the circle has the given diameter", "[step5]") {
    INFO(hint("more is sharp behind the plane of focus than before it, but your range is even",
              "the limits lie evenly round 1/focus, not round focus: 1/near = 1/f + c/(2R), 1/far = 1/f - c/(2R)", "§5 Near and far"));
    for (const float radius : {0.05f, 0.3f})
        for (const float focus : {1.0f, 4.0f})
            for (const float diameter : {0.001f, 0.02f}) {
                const auto [nearest, farthest] = depth_of_field(radius, focus, diameter);
                CAPTURE(radius, focus, diameter, nearest, farthest);
                CHECK((nearest < focus && focus < farthest));
                for (const double depth : {double(nearest), double(farthest)})
                    CHECK(2 * double(radius) * std::abs(1 / double(focus) - 1 / depth) == Approx(double(diameter)).epsilon(1e-3));
            }
}

TEST_CASE("beyond the hyperfocal distance everything to infinity is sharp", "[step5]") {
    INFO(hint("the far limit is negative", "where c/(2R) is at least 1/f no depth is too far: the far limit is infinite", "§5 The hyperfocal distance"));
    const auto [nearest, farthest] = depth_of_field(0.1f, 60, 0.01f);
    CHECK(nearest == Approx(15));
    CHECK(farthest == infinity);
    const auto [from, to] = depth_of_field(0.1f, infinity, 0.01f);
    CHECK(from == Approx(20));
    CHECK(to == infinity);
}

TEST_CASE("a pinhole has everything in focus, and no blur allowed leaves the plane alone", "[step5]") {
    INFO(hint("NaN for a pinhole", "with radius 0 the ratio c/(2R) is infinite: near is 0 then, and far is infinite", "§5 Near and far"));
    const auto [nearest, farthest] = depth_of_field(0, 4, 0.01f);
    CHECK(nearest == 0);
    CHECK(farthest == infinity);
    const auto [from, to] = depth_of_field(0.1f, 4, 0);
    CHECK(from == Approx(4));
    CHECK(to == Approx(4));
}

// ---- Step 6: a pixel, seen through the lens ------------------------------------------------------------------------

TEST_CASE("under an even sky every pixel is as bright as the sky", "[step6]") {
    INFO(hint("blurred pictures are too bright or too dark", "divide by the number of samples that were taken", "§6 The mean"));
    const place camera;
    const glm::vec3 sky{0.25f, 0.5f, 2};
    for (const int count : {1, 7, 10, 36}) {
        std::vector<glm::vec2> film = jittered(6, 5), lens = jittered(6, 6);
        film.resize(std::size_t(count));
        lens.resize(std::size_t(count));
        const glm::vec3 mean = pixel(camera.eye, camera.axes, 0.4f, 4, film, lens, [&](const lantern::ray&) { return sky; });
        CAPTURE(count, mean);
        CHECK(glm::length(mean - sky) < 1e-5f);
    }
}

TEST_CASE("each sample has its own point of the film and its own point of the lens", "[step6]") {
    INFO(hint("ghosts, or a blur that depends on the place in the pixel",
              "sample i takes film[i] and lens[i]: film points are no lens points, and one lens point does not do for all", "§6 Pairs"));
    const place camera;
    const std::vector<glm::vec2> film = jittered(5, 7), lens = jittered(5, 8);
    std::vector<lantern::ray> rays;
    (void)pixel(camera.eye, camera.axes, 0.4f, 4, film, lens, [&](const lantern::ray& r) {
        rays.push_back(r);
        return glm::vec3(1);
    });
    REQUIRE(rays.size() == film.size());
    for (std::size_t i = 0; i < film.size(); ++i) {
        const lantern::ray expected = through_lens(camera.eye, camera.axes, film[i], 0.4f, 4, lens[i]);
        CAPTURE(i, film[i], lens[i]);
        CHECK(std::count_if(rays.begin(), rays.end(), [&](const lantern::ray& r) {
            return glm::length(r.origin - expected.origin) < 1e-5f && glm::length(r.direction - expected.direction) < 1e-5f;
        }) == 1);
    }
}

TEST_CASE("an edge on the plane of focus is as sharp as without a lens", "[step6]") {
    INFO(hint("nothing is quite sharp", "a point of the film sees one point of the plane of focus, through whatever point of the lens", "§6 Pairs"));
    const place camera;
    const std::vector<glm::vec2> film = jittered(12, 9), lens = jittered(12, 10);
    // Points of the film nearer than rounding to the edge would be a matter of luck; there are none.
    const auto beyond = [](glm::dvec2 p) { return p.x + 0.37 * p.y > 0.6; };
    const auto sharp = std::count_if(film.begin(), film.end(), [&](glm::vec2 p) { return beyond(glm::dvec2(p)); });
    const glm::vec3 mean = pixel(camera.eye, camera.axes, 0.4f, 4, film, lens,
                                 [&](const lantern::ray& r) { return glm::vec3(beyond(camera.at_depth(r, 4) / 4.0) ? 1 : 0); });
    CHECK(double(mean.x) == Approx(double(sharp) / double(film.size())).margin(1e-5));
}

TEST_CASE("a blurred edge has the profile of a disc", "[step6]") {
    INFO(hint("blurred edges are too wide, too narrow, or too soft", "the light beyond the edge is the part of the disc beyond it: ½ + (t √(1 - t²) + asin t) / π",
              "§6 A blurred edge"));
    const place camera;
    constexpr float radius = 0.3f, focus = 4, depth = 7;
    const glm::vec2 film{0.2f, -0.1f};
    const std::vector<glm::vec2> same(48 * 48, film), lens = jittered(48, 11);
    // On the plane at that depth the rays of this one point of the film fill a disc.
    const glm::dvec2 middle = double(depth) * glm::dvec2(film);
    const double disc = double(radius) * std::abs(1 - double(depth) / double(focus));
    for (const double angle : {0.3, 2.0})
        for (const double t : {-0.8, -0.3, 0.0, 0.5, 0.9}) {
            const glm::dvec2 across(std::cos(angle), std::sin(angle));
            const glm::vec3 mean = pixel(camera.eye, camera.axes, radius, focus, same, lens, [&](const lantern::ray& r) {
                return glm::vec3(glm::dot(camera.at_depth(r, double(depth)) - middle, across) > -t * disc ? 1 : 0);
            });
            CAPTURE(angle, t, mean);
            // 2304 jittered points have a standard deviation of about .002 here.
            CHECK(double(mean.x) == Approx(0.5 + (t * std::sqrt(1 - t * t) + std::asin(t)) / pi).margin(0.02));
        }
}

TEST_CASE("unequal numbers of points are refused", "[step6]") {
    INFO(hint("memory that is not yours is read", "compare film.size() with lens.size() and throw std::invalid_argument", "§6 Pairs"));
    const place camera;
    const std::vector<glm::vec2> four = jittered(2, 12), nine = jittered(3, 13);
    const auto sky = [](const lantern::ray&) { return glm::vec3(1); };
    CHECK_THROWS_AS(pixel(camera.eye, camera.axes, 0.4f, 4, four, nine, sky), std::invalid_argument);
    CHECK_THROWS_AS(pixel(camera.eye, camera.axes, 0.4f, 4, nine, four, sky), std::invalid_argument);
}

// ---- Step 7: an aperture with blades -------------------------------------------------------------------------------

namespace {

/// How far a point lies along the normal of each blade; the blades are at cos(π / n) of the radius. The largest of all.
double reach(glm::dvec2 p, int blades) {
    double largest = -1e9;
    for (int k = 0; k < blades; ++k) {
        const double angle = 2 * pi * (k + 0.5) / blades;
        largest = std::max(largest, p.x * std::cos(angle) + p.y * std::sin(angle));
    }
    return largest / std::cos(pi / blades);
}

}  // namespace

TEST_CASE("every point lies between the blades, and the corners are reached", "[step7]") {
    INFO(hint("blur discs are round, or stars", "each triangle has its corners at the middle and at two neighbouring corners of the polygon; the first is at (radius, 0)",
              "§7 Blades"));
    for (const int blades : {3, 5, 6, 9}) {
        double outermost = 0, at_first_corner = -1;
        for (const glm::vec2 xi : jittered(64, 14)) {
            const glm::dvec2 p = glm::dvec2(on_blades(xi, 0.5f, blades)) / 0.5;
            CAPTURE(blades, xi, p.x, p.y);
            REQUIRE(reach(p, blades) <= 1.00001);
            outermost = std::max(outermost, reach(p, blades));
            at_first_corner = std::max(at_first_corner, p.x);
        }
        CAPTURE(blades, outermost, at_first_corner);
        CHECK(outermost > 0.97);
        CHECK(at_first_corner > 0.92);
    }
}

TEST_CASE("all parts of the polygon get their share", "[step7]") {
    INFO(hint("blurred lights are bright in the middle, or in one triangle", "the point of a triangle is √ξ of the way from the middle to a point of the blade; each triangle is chosen equally often",
              "§7 Blades"));
    for (const int blades : {3, 6}) {
        // By blade, by the ring, and by the half of the blade: parts of equal area.
        constexpr int rings = 5;
        std::vector<int> counts(std::size_t(blades * rings * 2));
        for (const glm::vec2 xi : jittered(60, 15)) {
            const glm::dvec2 p = glm::dvec2(on_blades(xi, 2, blades)) / 2.0;
            const double r = reach(p, blades);
            CAPTURE(blades, xi, p.x, p.y);
            REQUIRE((r >= 0 && r <= 1.00001));
            const double turn = std::atan2(p.y, p.x) / (2 * pi);
            const int half = std::min(int((turn < 0 ? turn + 1 : turn) * 2 * blades), 2 * blades - 1);
            ++counts[std::size_t(half * rings + std::min(int(r * r * rings), rings - 1))];
        }
        INFO("points in " << counts.size() << " parts of equal area; " << 3600 / counts.size() << " each would be even: " << listed(counts));
        // 29 and 59 degrees of freedom: 1e-8
        CHECK(chi_square(counts, 3600 / double(counts.size())) < (blades == 3 ? 95 : 145));
    }
}
