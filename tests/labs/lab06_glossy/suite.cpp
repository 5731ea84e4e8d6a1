// SPDX-License-Identifier: MIT
// Lab 06: glossy reflection and transmission. Nothing here is left to chance: with xi given, every law holds exactly,
// but for the rounding of float. The one estimate (step 4) is compared within a bound that no stratified set can exceed.

#include "contract.hpp"

#include <catch.hpp>
#include <hint.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

using namespace contract::lab06;

namespace {

/// Numbers in (0, 1), the same on every machine.
class numbers {
public:
    explicit numbers(std::uint32_t seed) : engine_(seed) {}
    float one() { return float((engine_() >> 9) * 2 + 1) * 0x1p-24f; }
    glm::vec2 two() {
        const float x = one();
        return {x, one()};
    }
    /// A direction of length 1, none of whose components is small or equal to another: no axis, and no tie.
    glm::vec3 direction() {
        for (;;) {
            const glm::vec3 p{2 * one() - 1, 2 * one() - 1, 2 * one() - 1};
            const glm::vec3 size = glm::abs(p);
            if (glm::length(p) < 1 && std::min({size.x, size.y, size.z}) > 0.1f && std::abs(size.x - size.y) > 0.05f &&
                std::abs(size.y - size.z) > 0.05f && std::abs(size.z - size.x) > 0.05f)
                return glm::normalize(p);
        }
    }

private:
    std::mt19937 engine_;
};

/// side × side points, one somewhere within each cell of the unit square, but not upon its border.
std::vector<glm::vec2> jittered(int side, std::uint32_t seed) {
    numbers random(seed);
    std::vector<glm::vec2> points;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) points.push_back((glm::vec2(x, y) + 0.05f + 0.9f * random.two()) / float(side));
    return points;
}

/// The greatest difference of two vectors in any component; not below any bound when there is a NaN.
double apart(glm::dvec3 a, glm::dvec3 b) {
    const glm::dvec3 d = glm::abs(a - b);
    return d.x + d.y + d.z >= 0 ? std::max({d.x, d.y, d.z}) : INFINITY;
}

/// Where a ray of direction d meets the plane that stands perpendicular to r, one unit away; seen from the middle.
glm::dvec3 in_square(glm::dvec3 d, glm::dvec3 r) {
    const glm::dvec3 w = glm::normalize(r);
    return d / glm::dot(d, w) - w;
}

/// The largest |length - 1| and |cosine| among three axes.
double flaw(const glm::mat3& b) {
    double worst = 0;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k <= i; ++k) {
            const double value = std::abs(glm::dot(glm::dvec3(b[i]), glm::dvec3(b[k])) - (i == k ? 1 : 0));
            worst = value >= 0 ? std::max(worst, value) : INFINITY;
        }
    return worst;
}

constexpr double rounding = 2e-6;

/// A ray that falls on the surface at an angle of incidence, in degrees; the normal is not along an axis.
struct incidence {
    glm::vec3 normal, in;
    explicit incidence(double degrees, std::uint32_t seed = 1) {
        numbers random(seed);
        const glm::dvec3 n = glm::normalize(glm::dvec3(random.direction()));
        const glm::dvec3 side = glm::normalize(glm::cross(n, glm::dvec3(random.direction())));
        const double angle = degrees * 3.14159265358979323846 / 180;
        normal = glm::vec3(n);
        in = glm::vec3(std::sin(angle) * side - std::cos(angle) * n);
    }
    [[nodiscard]] glm::vec3 mirrored() const {
        const glm::dvec3 n(normal), d(in);
        return glm::vec3(d - 2 * glm::dot(n, d) * n);
    }
};

glm::vec3 folded(glm::vec3 d, glm::vec3 normal) {
    const float height = glm::dot(d, normal);
    return height < 0 ? d - 2 * height * normal : d;
}

}  // namespace

// ---- Step 1: a basis around r --------------------------------------------------------------------------------------

TEST_CASE("the axes have length 1 and stand at right angles", "[step1]") {
    INFO(hint("the highlight is a rhombus, or its size changes over the surface",
              "a cross product of two vectors has length 1 only if they have, and stand at right angles: normalise U", "§1 Three axes"));
    numbers random(1);
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 r = random.direction();
        const glm::mat3 b = basis(r);
        CAPTURE(r, b[0], b[1], b[2]);
        REQUIRE(flaw(b) < rounding);
    }
}

TEST_CASE("the third axis points along r", "[step1]") {
    INFO(hint("the reflections look into a wrong direction", "W is r divided by its length, and W is the last column", "§1 Three axes"));
    numbers random(2);
    for (const float length : {1.0f, 0.01f, 250.0f}) {
        const glm::vec3 r = random.direction();
        CAPTURE(r, length);
        CHECK(apart(basis(length * r)[2], r) < rounding);
    }
}

TEST_CASE("the basis is right-handed", "[step1]") {
    INFO(hint("patterns of samples appear mirrored", "cross(U, V) must be W, not -W: V = cross(W, U), for instance", "§1 Right and left"));
    numbers random(3);
    for (int i = 0; i < 1000; ++i) {
        const glm::mat3 b = basis(random.direction());
        CAPTURE(b[0], b[1], b[2]);
        REQUIRE(apart(glm::cross(glm::dvec3(b[0]), glm::dvec3(b[1])), b[2]) < rounding);
    }
}

TEST_CASE("the basis holds at the poles and along every axis", "[step1]") {
    INFO(hint("black or speckled spots where the surface reflects straight up or down",
              "the cross product of r with a helper parallel to it is zero: choose the helper by looking at r", "§1 The pole"));
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z) {
                if (x == 0 && y == 0 && z == 0) continue;
                for (const float slant : {0.0f, -0.0f, 1e-20f, 3e-4f}) {
                    const glm::vec3 r{x == 0 ? slant : float(x), y == 0 ? slant : float(y), z == 0 ? -slant : float(z)};
                    const glm::mat3 b = basis(r);
                    CAPTURE(r, b[0], b[1], b[2]);
                    REQUIRE(flaw(b) < rounding);
                    REQUIRE(apart(b[2], glm::normalize(glm::dvec3(r))) < rounding);
                }
            }
}

TEST_CASE("very short and very long r give a basis too", "[step1]") {
    INFO(hint("NaN in scenes that are very small or very large",
              "in float the square of 1e-25 is 0 and that of 1e25 is infinite: normalise in double", "§1 Three axes"));
    numbers random(4);
    for (const float length : {1e-25f, 1e-10f, 1e10f, 1e25f}) {
        const glm::vec3 r = random.direction();
        const glm::mat3 b = basis(length * r);
        INFO("length := " << length);  // CAPTURE would show 1e-25 as 0
        CAPTURE(r, b[0], b[1], b[2]);
        CHECK(flaw(b) < rounding);
        CHECK(apart(b[2], r) < rounding);
    }
}

// ---- Step 2: the perturbed ray -------------------------------------------------------------------------------------

TEST_CASE("the middle of the square is r itself", "[step2]") {
    INFO(hint("all reflections are shifted to one side", "u and v run from -a/2 to a/2, not from 0 to a", "§2 The square"));
    numbers random(5);
    for (const float width : {0.1f, 0.5f, 2.0f}) {
        const glm::vec3 r = random.direction();
        CAPTURE(r, width);
        CHECK(apart(perturb(r, width, {0.5f, 0.5f}), r) < rounding);
    }
}

TEST_CASE("a width of 0 leaves r as it is", "[step2]") {
    INFO(hint("the mirror is blurred", "every perturbation is to be multiplied by the width", "§2 The square"));
    numbers random(6);
    for (int i = 0; i < 50; ++i) {
        const glm::vec3 r = random.direction();
        CAPTURE(r);
        REQUIRE(apart(perturb(r, 0, random.two()), r) < rounding);
    }
}

TEST_CASE("the perturbed ray has length 1", "[step2]") {
    INFO(hint("distances and later reflections are wrong", "r + uU + vV is longer than 1 away from the middle: normalise it",
              "§2 Length"));
    numbers random(7);
    for (const float width : {0.0f, 0.2f, 1.0f, 3.0f}) {
        const glm::vec3 d = perturb(random.direction(), width, random.two());
        CAPTURE(width, d);
        CHECK(std::abs(glm::length(glm::dvec3(d)) - 1) < rounding);
    }
}

TEST_CASE("the edges of the square lie half a width from its middle", "[step2]") {
    INFO(hint("the blur is too strong, too weak, or no square at all",
              "the square has the side a, so it reaches from -a/2 to a/2 along U and along V, both perpendicular to r", "§2 The square"));
    numbers random(8);
    for (const float width : {0.1f, 0.5f, 2.0f})
        for (const glm::vec2 xi : {glm::vec2(0, 0.5f), glm::vec2(1, 0.5f), glm::vec2(0.5f, 0), glm::vec2(0.5f, 1)}) {
            const glm::vec3 r = random.direction();
            const glm::vec3 d = perturb(r, width, xi);
            CAPTURE(r, width, xi, d);
            CHECK(glm::length(in_square(d, r)) == Approx(width / 2).epsilon(1e-4));
        }
}

TEST_CASE("each number moves the ray along an axis of its own", "[step2]") {
    INFO(hint("highlights are streaks instead of squares", "xi.x belongs to u and xi.y to v: neither is to be used for both",
              "§2 Two numbers"));
    numbers random(9);
    for (int i = 0; i < 200; ++i) {
        const glm::vec3 r = random.direction();
        const float width = 2 * random.one();
        const glm::vec2 xi = random.two();
        const glm::dvec3 along_u = in_square(perturb(r, width, {1, 0.5f}), r);
        const glm::dvec3 along_v = in_square(perturb(r, width, {0.5f, 1}), r);
        const glm::vec3 d = perturb(r, width, xi);
        CAPTURE(r, width, xi, d, along_u, along_v);
        REQUIRE(glm::length(along_v) == Approx(glm::length(along_u)).epsilon(1e-3).margin(1e-5));
        REQUIRE(std::abs(glm::dot(along_u, along_v)) < 1e-5);
        REQUIRE(apart(in_square(d, r), (2 * double(xi.x) - 1) * along_u + (2 * double(xi.y) - 1) * along_v) < 1e-5);
    }
}

TEST_CASE("a point from every cell of the unit square arrives in a cell of its own", "[step2]") {
    INFO(hint("the blur is darker in places, or not a square: samples crowd together there",
              "u and v depend linearly on xi, and on nothing else", "§2 Two numbers"));
    constexpr int side = 8;
    numbers random(10);
    for (const float width : {0.25f, 1.0f}) {
        const glm::vec3 r = random.direction();
        const glm::dvec3 u_axis = glm::normalize(in_square(perturb(r, width, {1, 0.5f}), r));
        const glm::dvec3 v_axis = glm::cross(glm::normalize(glm::dvec3(r)), u_axis);
        std::vector<int> samples_in(side * side);
        for (const glm::vec2 xi : jittered(side, 11)) {
            const glm::dvec3 q = in_square(perturb(r, width, xi), r) / double(width);
            const double x = std::floor((glm::dot(q, u_axis) + 0.5) * side), y = std::floor((glm::dot(q, v_axis) + 0.5) * side);
            CAPTURE(r, width, xi, q);
            REQUIRE((x >= 0 && x < side && y >= 0 && y < side));
            ++samples_in[std::size_t(int(y) * side + int(x))];
        }
        CHECK(std::count(samples_in.begin(), samples_in.end(), 1) == side * side);
    }
}

TEST_CASE("the blur does not depend on the length of r", "[step2]") {
    INFO(hint("the same metal is blurrier where the ray is short", "r is not of length 1 when uU and vV are added to it: add them to W",
              "§2 Length"));
    numbers random(12);
    for (const float length : {0.01f, 0.3f, 7.0f, 400.0f}) {
        const glm::vec3 r = random.direction();
        const glm::vec2 xi = random.two();
        CAPTURE(r, length, xi);
        CHECK(apart(perturb(length * r, 0.5f, xi), perturb(r, 0.5f, xi)) < 5e-6);
    }
}

// ---- Step 3: the glossy reflection ---------------------------------------------------------------------------------

TEST_CASE("with a width of 0 it is a mirror", "[step3]") {
    INFO(hint("the polished ball does not show what stands before it", "out = in - 2 (n·in) n", "§3 Reflect, then perturb"));
    for (const double degrees : {0.0, 20.0, 45.0, 70.0, 89.0}) {
        const incidence ray(degrees, std::uint32_t(degrees) + 1);
        CAPTURE(degrees, ray.in, ray.normal);
        CHECK(apart(reflected(ray.in, ray.normal, 0, {0.2f, 0.9f}), ray.mirrored()) < rounding);
    }
}

TEST_CASE("the lobe is a square of side a around the mirrored ray", "[step3]") {
    INFO(hint("the blur is twice as wide as on the handout's pictures, or stretched",
              "the reflected ray is to be perturbed, not the normal: turning the normal turns the ray by twice the angle",
              "§3 Reflect, then perturb"));
    const float width = GENERATE(0.1f, 0.4f);
    const incidence ray(35);
    CHECK(apart(reflected(ray.in, ray.normal, width, {0.5f, 0.5f}), ray.mirrored()) < rounding);
    for (const glm::vec2 xi : {glm::vec2(0, 0.5f), glm::vec2(1, 0.5f), glm::vec2(0.5f, 0), glm::vec2(0.5f, 1)}) {
        const glm::vec3 d = reflected(ray.in, ray.normal, width, xi);
        CAPTURE(width, xi, d);
        CHECK(glm::length(in_square(d, ray.mirrored())) == Approx(width / 2).epsilon(1e-4));
    }
}

TEST_CASE("no reflected ray goes into the surface", "[step3]") {
    INFO(hint("dark rims round glossy balls", "near grazing a part of the square lies below the surface: the ray must be brought back",
              "§3 Below the surface"));
    for (const double degrees : {60.0, 80.0, 89.0})
        for (const float width : {0.2f, 1.0f, 2.0f}) {
            const incidence ray(degrees);
            for (const glm::vec2 xi : jittered(8, 13)) {
                const glm::vec3 d = reflected(ray.in, ray.normal, width, xi);
                CAPTURE(degrees, width, xi, d);
                REQUIRE(glm::dot(glm::dvec3(d), glm::dvec3(ray.normal)) > -rounding);
            }
        }
}

TEST_CASE("what would go below the surface is folded back, and the rest stays as it is", "[step3]") {
    INFO(hint("a bright or dark line along the rims", "turn the sign of the part along the normal: d - 2 (n·d) n where n·d < 0, and nowhere else",
              "§3 Below the surface"));
    for (const double degrees : {40.0, 80.0}) {
        const incidence ray(degrees);
        for (const glm::vec2 xi : jittered(8, 14)) {
            const glm::vec3 d = reflected(ray.in, ray.normal, 1, xi);
            const glm::vec3 expected = folded(perturb(ray.mirrored(), 1, xi), ray.normal);
            CAPTURE(degrees, xi);
            REQUIRE(apart(d, expected) < 1e-5);
        }
    }
}

// ---- Step 4: the mean over the lobe --------------------------------------------------------------------------------

namespace {

/// Where reflected_radiance looks when it is given this one point.
glm::vec3 direction_of(glm::vec2 xi, const incidence& ray, float width) {
    const std::vector<glm::vec2> only{xi};
    glm::vec3 seen{0};
    (void)reflected_radiance(ray.in, ray.normal, width, only, [&](glm::vec3 d) { return seen = d; });
    return seen;
}

}  // namespace

TEST_CASE("under an even sky the surface is as bright as the sky", "[step4]") {
    INFO(hint("glossy things are too dark or too bright, perhaps at their rims only",
              "divide the sum by the number of points; and leave none of them out", "§4 The mean"));
    const glm::vec3 sky{0.25f, 0.5f, 2};
    for (const double degrees : {0.0, 60.0, 85.0})
        for (const int count : {1, 7, 10, 64}) {
            const incidence ray(degrees);
            std::vector<glm::vec2> points = jittered(8, 15);
            points.resize(std::size_t(count));
            const glm::vec3 mean = reflected_radiance(ray.in, ray.normal, 1, points, [&](glm::vec3) { return sky; });
            CAPTURE(degrees, count, mean);
            CHECK(apart(mean, sky) < 1e-5);
        }
}

TEST_CASE("every point sends one ray of its own", "[step4]") {
    INFO(hint("ghosts: several sharp reflections, or one, instead of a blur", "call reflected with each of the points, once",
              "§4 The mean"));
    const incidence ray(50);
    const std::vector<glm::vec2> points = jittered(5, 16);
    std::vector<glm::vec3> directions;
    (void)reflected_radiance(ray.in, ray.normal, 0.5f, points, [&](glm::vec3 d) {
        directions.push_back(d);
        return glm::vec3(1);
    });
    REQUIRE(directions.size() == points.size());
    for (const glm::vec2 xi : points) {
        const glm::vec3 expected = reflected(ray.in, ray.normal, 0.5f, xi);
        CAPTURE(xi, expected);
        CHECK(std::count_if(directions.begin(), directions.end(), [&](glm::vec3 d) { return apart(d, expected) < 1e-6; }) == 1);
    }
}

TEST_CASE("light is averaged, not directions", "[step4]") {
    INFO(hint("reflections stay sharp, however wide the square",
              "follow each ray, then take the mean of what they bring; the mean direction is the mirror's", "§4 The mean"));
    const incidence ray(30);
    const std::vector<glm::vec2> four{{0.1f, 0.3f}, {0.3f, 0.9f}, {0.7f, 0.1f}, {0.9f, 0.7f}};
    // Each of the four rays meets another light.
    const std::vector<float> lights{1, 2, 4, 9};
    std::vector<glm::vec3> towards;
    for (const glm::vec2 xi : four) towards.push_back(direction_of(xi, ray, 0.5f));
    const glm::vec3 mean = reflected_radiance(ray.in, ray.normal, 0.5f, four, [&](glm::vec3 d) {
        for (std::size_t i = 0; i < lights.size(); ++i)
            if (apart(d, towards[i]) < 1e-5) return glm::vec3(lights[i], 0, 1);
        return glm::vec3(0);
    });
    CHECK(apart(mean, {4, 0, 1}) < 1e-5);
}

TEST_CASE("the brightness of a blurred edge is the part of the square beyond it", "[step4]") {
    INFO(hint("blurred edges are too wide, too narrow, or in the wrong place",
              "the points must fill the square evenly: check steps 2 and 3 with the side a", "§4 A blurred edge"));
    // A wall that is white beyond a straight line, at a distance from the middle of the square, at an angle to its axes.
    const incidence ray(25);
    constexpr int side = 48;
    const float width = 0.6f;
    const auto axis = [&](glm::vec2 xi) { return 2 / double(width) * in_square(direction_of(xi, ray, width), ray.mirrored()); };
    const glm::dvec3 u_axis = axis({1, 0.5f}), v_axis = axis({0.5f, 1});
    for (const double angle : {0.0, 0.5, 0.785398, 1.2})
        for (const double distance : {-0.25, -0.1, 0.0, 0.05, 0.2}) {
            const glm::dvec3 across = std::cos(angle) * u_axis + std::sin(angle) * v_axis;
            const glm::vec3 mean = reflected_radiance(ray.in, ray.normal, width, jittered(side, 17), [&](glm::vec3 d) {
                return glm::vec3(glm::dot(in_square(d, ray.mirrored()), across) > distance ? 1 : 0);
            });
            // P(c u + s v > x) for u and v uniform in [-a/2, a/2]: a sum of second powers (the handout derives it).
            const double c = std::cos(angle) * double(width), s = std::sin(angle) * double(width);
            const auto above = [](double x) { return x > 0 ? x : 0; };
            double part;
            if (s < 1e-9) part = std::clamp(0.5 - distance / c, 0.0, 1.0);
            else {
                const double x = distance + (c + s) / 2;  // from the corner of the square
                part = 1 - (std::pow(above(x), 2) - std::pow(above(x - c), 2) - std::pow(above(x - s), 2) + std::pow(above(x - c - s), 2)) / (2 * c * s);
            }
            CAPTURE(angle, distance, part, mean);
            // A straight line crosses at most 2 side - 1 cells, and only their points can be on the wrong side.
            CHECK(std::abs(double(mean.x) - part) < (2.0 * side - 1) / (side * side));
        }
}

// ---- Step 5: through frosted glass ---------------------------------------------------------------------------------

TEST_CASE("with a width of 0 the ray obeys Snell's law", "[step5]") {
    INFO(hint("glass shows a wrong picture of what stands behind it", "sin θt = eta sin θi; the tangential part of the ray is multiplied by eta",
              "§5 Refract, then perturb"));
    for (const float eta : {1.0f, 1 / 1.5f, 1.5f})
        for (const double degrees : {0.0, 15.0, 40.0}) {
            const incidence ray(degrees);
            const auto out = transmitted(ray.in, ray.normal, eta, 0, {0.3f, 0.8f});
            CAPTURE(eta, degrees);
            REQUIRE(out.has_value());
            const glm::dvec3 n(ray.normal), in(ray.in), d(*out);
            CHECK(std::abs(glm::length(d) - 1) < rounding);
            CHECK(glm::dot(d, n) < 0);
            CHECK(apart(d - glm::dot(d, n) * n, double(eta) * (in - glm::dot(in, n) * n)) < rounding);
        }
}

TEST_CASE("beyond the critical angle nothing goes through", "[step5]") {
    INFO(hint("black or noisy rings inside glass balls", "1 - eta² sin² θ is negative there: no refracted ray exists, so there is nothing to perturb",
              "§5 Total reflection"));
    for (const double degrees : {42.5, 60.0, 85.0}) {  // the critical angle of glass is 41.8°
        CAPTURE(degrees);
        const incidence ray(degrees);
        CHECK_FALSE(transmitted(ray.in, ray.normal, 1.5f, 0.2f, {0.3f, 0.8f}).has_value());
        CHECK(transmitted(ray.in, ray.normal, 1 / 1.5f, 0.2f, {0.3f, 0.8f}).has_value());
    }
}

TEST_CASE("the lobe is a square of side a around the refracted ray", "[step5]") {
    INFO(hint("frosted glass is blurred too much from inside and too little from outside",
              "the refracted ray is to be perturbed: what is perturbed before is squeezed or stretched by the refraction", "§5 Refract, then perturb"));
    for (const float eta : {1 / 1.5f, 1.5f}) {
        const incidence ray(25);
        const auto middle = transmitted(ray.in, ray.normal, eta, 0, {0.5f, 0.5f});
        REQUIRE(middle.has_value());
        for (const glm::vec2 xi : {glm::vec2(0, 0.5f), glm::vec2(1, 0.5f), glm::vec2(0.5f, 0), glm::vec2(0.5f, 1)}) {
            const auto out = transmitted(ray.in, ray.normal, eta, 0.3f, xi);
            CAPTURE(eta, xi);
            REQUIRE(out.has_value());
            CHECK(glm::length(in_square(*out, *middle)) == Approx(0.15).epsilon(1e-4));
        }
    }
}

TEST_CASE("no transmitted ray comes back out of the surface", "[step5]") {
    INFO(hint("sparks along the rims of frosted glass", "fold to the lower side here: d - 2 (n·d) n where n·d > 0", "§5 Refract, then perturb"));
    const incidence ray(40);  // leaves at 75 degrees
    const auto middle = transmitted(ray.in, ray.normal, 1.5f, 0, {0.5f, 0.5f});
    REQUIRE(middle.has_value());
    for (const glm::vec2 xi : jittered(8, 18)) {
        const auto out = transmitted(ray.in, ray.normal, 1.5f, 1, xi);
        CAPTURE(xi);
        REQUIRE(out.has_value());
        REQUIRE(glm::dot(glm::dvec3(*out), glm::dvec3(ray.normal)) < rounding);
        REQUIRE(apart(*out, folded(perturb(*middle, 1, xi), -ray.normal)) < 1e-5);
    }
}
