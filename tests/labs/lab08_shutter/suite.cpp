// SPDX-License-Identifier: MIT
// Lab 08: an open shutter. Random numbers and permutations are given, so every law holds exactly, but for the rounding of float.

#include "contract.hpp"

#include <catch.hpp>
#include <hint.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace contract::lab08;

namespace {

/// The same numbers on every machine.
class numbers {
public:
    explicit numbers(std::uint32_t seed) : engine_(seed) {}
    float one() { return float((engine_() >> 9) * 2 + 1) * 0x1p-24f; }
    float between(float low, float high) { return low + one() * (high - low); }
    glm::vec3 in_cube(float half_side) {
        const float x = between(-half_side, half_side), y = between(-half_side, half_side);
        return {x, y, between(-half_side, half_side)};
    }
    std::vector<std::uint32_t> order(std::uint32_t count) {
        std::vector<std::uint32_t> result(count);
        std::iota(result.begin(), result.end(), 0u);
        for (std::size_t i = count; i > 1; --i) std::swap(result[i - 1], result[engine_() % i]);
        return result;
    }
    std::vector<float> several(std::size_t count) {
        std::vector<float> result(count);
        for (float& x : result) x = one();
        return result;
    }

private:
    std::mt19937 engine_;
};

glm::dvec3 position(const ball& s, double time) { return glm::dvec3(s.center) + time * glm::dvec3(s.velocity); }

/// How far the point at t lies outside of the sphere as it stands at that time.
double outside(const ball& s, const ray_then& r, double t) {
    return glm::length(glm::dvec3(r.origin) + t * glm::dvec3(r.direction) - position(s, double(r.time))) - double(s.radius);
}

bool same(glm::vec3 a, glm::vec3 b) { return glm::length(a - b) <= 1e-5f * (1 + glm::length(b)); }

/// The largest distance from 0 among the three components; not below any bound when there is a NaN.
double largest(glm::dvec3 d) {
    const glm::dvec3 size = glm::abs(d);
    return size.x + size.y + size.z >= 0 ? std::max({size.x, size.y, size.z}) : INFINITY;
}

}  // namespace

// ---- Step 1: a moment of the exposure ------------------------------------------------------------------------------

TEST_CASE("0 is the opening of the shutter and 1 its closing", "[step1]") {
    INFO(hint("the blur is too long, too short, or shifted along the path", "T = T0 + ξ (T1 - T0)", "§1 The formula"));
    for (const auto& [open, close] : {std::pair{0.0f, 1.0f}, {2.0f, 5.0f}, {-3.0f, -1.0f}, {0.25f, 0.5f}}) {
        CAPTURE(open, close);
        CHECK(moment(open, close, 0) == Approx(open).margin(1e-6));
        CHECK(moment(open, close, 1) == Approx(close).margin(1e-6));
        CHECK(moment(open, close, 0.25f) == Approx(0.75f * open + 0.25f * close).margin(1e-6));
    }
}

TEST_CASE("no moment lies before the opening or behind the closing", "[step1]") {
    INFO(hint("a moving thing leaves its bounding box", "with all the roundings, stay between open and close", "§1 The formula"));
    numbers random(1);
    for (int i = 0; i < 1000; ++i) {
        const float open = random.between(-10, 10), close = open + random.one();
        const float t = moment(open, close, random.one());
        CAPTURE(open, close, t);
        REQUIRE((t >= std::nextafter(open, -100.0f) && t <= std::nextafter(close, 100.0f)));
    }
}

TEST_CASE("a shutter that closes at once knows one moment", "[step1]") {
    INFO(hint("blur, or NaN, where the shutter stands still", "with T1 = T0 every ξ gives T0", "§1 The formula"));
    for (const float xi : {0.0f, 0.3f, 1.0f}) CHECK(moment(0.7f, 0.7f, xi) == 0.7f);
}

// ---- Step 2: a moving sphere ---------------------------------------------------------------------------------------

TEST_CASE("a ray meets the sphere where it is at the ray's time", "[step2]") {
    INFO(hint("nothing moves, or it moves the wrong way", "at the time T the centre is center + T * velocity", "§2 At the ray's time"));
    numbers random(2);
    for (int i = 0; i < 500; ++i) {
        const ball s{random.in_cube(2), random.in_cube(2), random.between(0.5f, 1)};
        const float time = random.between(-2, 3);
        // From outside, aimed at a point within the sphere at that time.
        const glm::vec3 aim = glm::vec3(position(s, double(time))) + random.in_cube(0.5f) * s.radius;
        const glm::vec3 origin = aim + 12.0f * glm::normalize(random.in_cube(1) + glm::vec3(0, 0, 2));
        const ray_then r{origin, aim - origin, time};
        const auto t = intersect(s, r);
        CAPTURE(s.center, s.velocity, s.radius, r.origin, r.direction, r.time);
        REQUIRE(t.has_value());
        REQUIRE(*t > 0);
        REQUIRE(std::abs(outside(s, r, double(*t))) < 1e-4);
        REQUIRE(outside(s, r, 0.99 * double(*t)) > 0);  // and nowhere before
    }
}

TEST_CASE("a ray that passes where the sphere is at another time misses", "[step2]") {
    INFO(hint("a solid sausage instead of a blur", "one ray knows one time: the sphere stands still for it", "§2 At the ray's time"));
    const ball s{{-5, 0, 0}, {10, 0, 0}, 1};
    for (const float time : {0.0f, 0.25f, 0.5f, 0.75f, 1.0f})
        for (const float x : {-5.0f, -2.5f, 0.0f, 2.5f, 5.0f}) {
            CAPTURE(time, x);
            CHECK(intersect(s, {{x, 0, 10}, {0, 0, -1}, time}).has_value() == (std::abs(-5 + 10 * time - x) < 1));
        }
}

TEST_CASE("the sphere does not move while the ray is under way", "[step2]") {
    INFO(hint("moving spheres are stretched towards the camera", "t measures the way along the ray, not the time: light is infinitely fast here", "§2 At the ray's time"));
    const ball s{{0, 0, 0}, {0, 0, 3}, 1};
    const auto t = intersect(s, {{0, 0, 10}, {0, 0, -1}, 1});
    REQUIRE(t.has_value());
    CHECK(*t == Approx(6));
}

TEST_CASE("t counts in units of the direction, and is positive", "[step2]") {
    INFO(hint("things behind the camera are seen, or the inside of a sphere is empty",
              "divide by d·d; take the nearer root unless it is not positive, then the farther one", "§2 The roots"));
    const ball s{{2, 0, 0}, {-2, 0, 0}, 1};
    const auto scaled = intersect(s, {{0, 0, 10}, {0, 0, -4}, 1}), inside = intersect(s, {{0, 0, 0}, {0, 0, -4}, 1});
    REQUIRE(scaled.has_value());
    CHECK(*scaled == Approx(2.25));
    REQUIRE(inside.has_value());
    CHECK(*inside == Approx(0.25));
    CHECK_FALSE(intersect(s, {{0, 0, 10}, {0, 0, 4}, 1}).has_value());
}

// ---- Step 3: bounds over the whole exposure ------------------------------------------------------------------------

TEST_CASE("the box holds the sphere at every moment of the exposure", "[step3]") {
    INFO(hint("moving things are cut off, as soon as an acceleration structure is used",
              "both ends of the exposure count, and the sphere's radius on every side", "§3 All the places"));
    numbers random(3);
    for (int i = 0; i < 200; ++i) {
        const ball s{random.in_cube(5), random.in_cube(5), random.between(0.1f, 1)};
        const float open = random.between(-1, 1), close = open + random.one();
        const auto [lower, upper] = bounds(s, open, close);
        for (int k = 0; k <= 16; ++k) {
            const double time = double(open) + (double(close) - double(open)) * k / 16;
            const glm::dvec3 p = position(s, time), room(double(s.radius) - 1e-5);
            CAPTURE(s.center, s.velocity, s.radius, open, close, time, lower, upper);
            REQUIRE(largest(glm::max(glm::dvec3(lower) - (p - room), 0.0)) == 0);
            REQUIRE(largest(glm::max(p + room - glm::dvec3(upper), 0.0)) == 0);
        }
    }
}

TEST_CASE("the box is no larger than it must be", "[step3]") {
    INFO(hint("the acceleration structure is slow where things move", "each side touches the sphere at the opening or at the closing of the shutter, no earlier and no later",
              "§3 All the places"));
    numbers random(4);
    for (int i = 0; i < 200; ++i) {
        const ball s{random.in_cube(5), random.in_cube(5), random.between(0.1f, 1)};
        const float open = random.between(-1, 1), close = open + random.one();
        const auto [lower, upper] = bounds(s, open, close);
        const glm::dvec3 first = position(s, double(open)), last = position(s, double(close));
        CAPTURE(s.center, s.velocity, s.radius, open, close, lower, upper);
        REQUIRE(largest(glm::dvec3(lower) - (glm::min(first, last) - double(s.radius))) < 1e-4);
        REQUIRE(largest(glm::dvec3(upper) - (glm::max(first, last) + double(s.radius))) < 1e-4);
    }
}

TEST_CASE("the box of a sphere at rest is that of the sphere", "[step3]") {
    INFO(hint("things at rest have too large boxes", "without a velocity both ends of the path are the same", "§3 All the places"));
    const auto [lower, upper] = bounds({{1, 2, 3}, {0, 0, 0}, 0.5f}, 0, 1);
    CHECK(same(lower, {0.5f, 1.5f, 2.5f}));
    CHECK(same(upper, {1.5f, 2.5f, 3.5f}));
}

// ---- Step 4: rays that go on keep the time -------------------------------------------------------------------------

TEST_CASE("a shadow ray keeps the time", "[step4]") {
    INFO(hint("a moving ball has a sharp shadow, or its shadow stays behind", "the light is looked for at the moment at which the ray was shot", "§4 One time for all"));
    for (const float time : {0.0f, 0.4f, 1.0f, -7.0f}) {
        const ray_then on = shadow_ray({{0, 5, 0}, {0, -1, 0}, time}, {0, 1, 0}, {4, 5, -2});
        CAPTURE(time, on.origin, on.direction, on.time);
        CHECK(on.time == time);
        CHECK(same(on.origin, {0, 1, 0}));
        CHECK(same(on.direction, {4, 4, -2}));
    }
}

TEST_CASE("a reflected ray keeps the time", "[step4]") {
    INFO(hint("mirror images of moving things stand still", "the reflected ray belongs to the same moment as the ray that caused it", "§4 One time for all"));
    for (const float time : {0.0f, 0.4f, 1.0f, -7.0f}) {
        const ray_then on = reflected_ray({{0, 5, 0}, {3, -4, 1}, time}, {1, 1, 0}, {0, 1, 0});
        CAPTURE(time, on.origin, on.direction, on.time);
        CHECK(on.time == time);
        CHECK(same(on.origin, {1, 1, 0}));
        CHECK(same(on.direction, {3, 4, 1}));
    }
}

TEST_CASE("a refracted ray keeps the time", "[step4]") {
    INFO(hint("moving things stand still when seen through glass", "the refracted ray belongs to the same moment as the ray that caused it", "§4 One time for all"));
    for (const float time : {0.0f, 0.4f, 1.0f, -7.0f}) {
        // 3 : 4 : 5 in air; the sine .6 becomes .4, the cosine √(1 - .16).
        const auto on = refracted_ray({{0, 5, 0}, {3, -4, 0}, time}, {1, 1, 0}, {0, 1, 0}, 1 / 1.5f);
        CAPTURE(time);
        REQUIRE(on.has_value());
        CHECK(on->time == time);
        CHECK(same(on->origin, {1, 1, 0}));
        CHECK(same(on->direction, {2, -5 * std::sqrt(0.84f), 0}));
    }
    CHECK_FALSE(refracted_ray({{0, 5, 0}, {4, -3, 0}, 0.5f}, {1, 1, 0}, {0, 1, 0}, 1.5f).has_value());
}

// ---- Step 5: stratified, shuffled moments --------------------------------------------------------------------------

TEST_CASE("each stretch of the exposure gets one sample", "[step5]") {
    INFO(hint("motion blur is noisier than it need be", "with N samples the exposure has N stretches: (order[i] + xi[i]) / N", "§5 Strata"));
    numbers random(5);
    for (const std::uint32_t count : {1u, 7u, 64u}) {
        const std::vector<std::uint32_t> order = random.order(count);
        const std::vector<float> xi = random.several(count);
        const std::vector<float> ts = times(2, 5, order, xi);
        REQUIRE(ts.size() == count);
        std::vector<int> samples_in(count);
        for (const float t : ts) {
            CAPTURE(count, t);
            REQUIRE((t >= 2 && t <= 5));
            ++samples_in[std::min(std::size_t((t - 2) / 3 * float(count) + 1e-4f), std::size_t(count - 1))];
        }
        // A moment within rounding of a border may count for its neighbour; the seed leaves none so near.
        CHECK(std::count(samples_in.begin(), samples_in.end(), 1) == count);
    }
}

TEST_CASE("sample i is in stretch order[i], where xi[i] says", "[step5]") {
    INFO(hint("swirls where things move out of focus; or the same moments in every pixel",
              "the order of the stretches is the permutation's, not 0, 1, 2 ...; and each stretch has a number of its own", "§5 Shuffle"));
    numbers random(6);
    const std::vector<std::uint32_t> order = random.order(16);
    const std::vector<float> xi = random.several(16);
    const std::vector<float> ts = times(-1, 3, order, xi);
    REQUIRE(ts.size() == 16);
    for (std::size_t i = 0; i < 16; ++i) {
        CAPTURE(i, order[i], xi[i]);
        CHECK(double(ts[i]) == Approx(-1 + 4 * (double(order[i]) + double(xi[i])) / 16).margin(1e-5));
    }
}

TEST_CASE("the moment has nothing to do with the place in the pixel", "[step5]") {
    INFO(hint("the upper half of every pixel shows the thing earlier than the lower half: slanted, torn, or doubled edges",
              "samples come row by row; without the permutation the first row has the first moments", "§5 Shuffle"));
    // 16 x 16 samples, row by row; each row of the pixel should see the whole exposure. For a random order the mean of 16 moments
    // has a standard deviation of .07; with this seed no row is further off than .08.
    numbers random(28);
    const std::vector<std::uint32_t> order = random.order(256);
    const std::vector<float> ts = times(0, 1, order, random.several(256));
    REQUIRE(ts.size() == 256);
    for (std::size_t row = 0; row < 16; ++row) {
        double mean = 0;
        for (std::size_t i = 0; i < 16; ++i) mean += double(ts[16 * row + i]) / 16;
        CAPTURE(row, mean);
        CHECK(std::abs(mean - 0.5) < 0.2);
    }
}

TEST_CASE("unequal numbers are refused", "[step5]") {
    INFO(hint("memory that is not yours is read", "compare order.size() with xi.size() and throw std::invalid_argument", "§5 Strata"));
    numbers random(8);
    const std::vector<std::uint32_t> three = random.order(3), four = random.order(4);
    CHECK_THROWS_AS(times(0, 1, four, random.several(3)), std::invalid_argument);
    CHECK_THROWS_AS(times(0, 1, three, random.several(4)), std::invalid_argument);
}

// ---- Step 6: the profile of a moving disc --------------------------------------------------------------------------

TEST_CASE("the part of the exposure is the one that many moments give", "[step6]") {
    INFO(hint("the blur's profile is wrong", "the roots of |q - v t|² = R² with q = point - center, clipped to the exposure, divided by its length", "§6 The roots"));
    numbers random(9);
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 p = random.in_cube(2), c = random.in_cube(2), v = random.in_cube(3);
        const float radius = random.between(0.2f, 1.5f), open = random.between(-1, 1), close = open + random.between(0.1f, 2);
        int hits = 0;
        constexpr int moments = 2000;
        for (int k = 0; k < moments; ++k) {
            const double t = double(open) + (double(close) - double(open)) * (k + 0.5) / moments;
            const glm::dvec2 d = glm::dvec2(p.x, p.y) - glm::dvec2(c.x, c.y) - t * glm::dvec2(v.x, v.y);
            hits += glm::length(d) <= double(radius);
        }
        const float part = covered({p.x, p.y}, {c.x, c.y}, {v.x, v.y}, radius, open, close);
        CAPTURE(p, c, v, radius, open, close, part);
        // The disc comes once and goes once, and each of these is half a step off at most.
        REQUIRE(std::abs(double(part) - double(hits) / moments) <= 1.001 / moments);
    }
}

TEST_CASE("the blur is as long as speed times exposure, and the disc itself", "[step6]") {
    INFO(hint("the blur is too long or too short", "the path's length is |v| (T1 - T0); the disc adds its radius at both ends", "§6 The length of the blur"));
    // Radius .5, from (0, 0) to (6, 0) while the shutter is open from 1 to 3.
    const glm::vec2 center{-3, 0}, velocity{3, 0};
    const auto at = [&](float x) { return covered({x, 0}, center, velocity, 0.5f, 1, 3); };
    CHECK(at(-0.51f) == 0);
    CHECK(at(-0.49f) > 0);
    CHECK(at(6.49f) > 0);
    CHECK(at(6.51f) == 0);
    for (const float x : {0.5f, 2.0f, 3.0f, 5.5f}) CHECK(at(x) == Approx(1 / 6.0));  // 2 R / (|v| (T1 - T0))
    CHECK(at(0) == Approx(0.5 / 6));
}

TEST_CASE("a disc at rest covers a point always or never", "[step6]") {
    INFO(hint("NaN where nothing moves", "with v = 0 there are no roots: compare the distance with the radius", "§6 At rest"));
    CHECK(covered({0.3f, 0.4f}, {0, 0}, {0, 0}, 0.6f, 0, 1) == 1);
    CHECK(covered({0.3f, 0.4f}, {0, 0}, {0, 0}, 0.4f, 0, 1) == 0);
    CHECK(covered({5, 0}, {0, 0}, {10, 0}, 1, 0.5f, 0.5f) == 1);
    CHECK(covered({5, 0}, {0, 0}, {10, 0}, 1, 0.7f, 0.7f) == 0);
}

TEST_CASE("the disc passes before the shutter opens, or after it has closed", "[step6]") {
    INFO(hint("negative brightness, or blur where nothing has been", "clip the roots to the exposure; when nothing is left between them the part is 0", "§6 The roots"));
    for (const float x : {-4.0f, 5.0f, 100.0f}) {
        CAPTURE(x);
        CHECK(covered({x, 0}, {0, 0}, {1, 0}, 0.5f, 0, 1) == 0);
    }
    CHECK(covered({0.5f, 0.7f}, {0, 0}, {1, 0}, 0.5f, 0, 1) == 0);  // beside the path
}
