// SPDX-License-Identifier: MIT
// Lab 15: your ray tracer. The parts that are plugged in are the tests' own, and note what they are asked; so are the numbers that are drawn.

#include "contract.hpp"

#include <catch.hpp>
#include <hint.hpp>
#include <numbers.hpp>

#include <lantern/samples.hpp>
#include <lantern/sphere.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <set>
#include <utility>
#include <vector>

using namespace contract::lab15;
using lantern::purpose;

namespace {

/// Not below any bound when there is a NaN.
double apart(glm::dvec3 a, glm::dvec3 b) {
    const double d = glm::length(a - b);
    return d >= 0 ? d : INFINITY;
}
bool same(glm::vec3 a, glm::vec3 b) { return apart(a, b) <= 2e-5 * (1 + glm::length(glm::dvec3(b))); }

/// Equal bits: no rounding in between.
bool identical(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
    return std::ranges::equal(a, b, [](glm::vec3 p, glm::vec3 q) {
        return std::bit_cast<std::array<std::uint32_t, 3>>(p) == std::bit_cast<std::array<std::uint32_t, 3>>(q);
    });
}

/// What was drawn, and the answers.
struct notes {
    std::vector<question> asked;
    glm::vec2 answer{0.25f, 0.75f};

    [[nodiscard]] draw source() {
        return [this](std::uint32_t dimensions, std::uint32_t p, std::uint32_t which, std::span<const std::uint32_t> path) {
            asked.push_back({dimensions, p, which, {path.begin(), path.end()}});
            return answer;
        };
    }
    [[nodiscard]] std::ptrdiff_t of(purpose p) const {
        return std::ranges::count_if(asked, [&](const question& q) { return q.purpose == std::uint32_t(p); });
    }
};

// ---- Step 1 ----

/// A lens that notes what it is asked, and answers something that is no ray of any lens.
struct noted_lens {
    int calls = 0;
    glm::vec3 eye{0};
    glm::mat3 axes{0};
    glm::vec2 film{0};
    float radius = -1, focus = -1;
    glm::vec2 xi{-1};

    static constexpr glm::vec3 origin{3, 1, 4}, direction{0.6f, 0, 0.8f};
    [[nodiscard]] lens_part part() {
        return [this](glm::vec3 e, glm::mat3 a, glm::vec2 f, float r, float d, glm::vec2 x) {
            ++calls, eye = e, axes = a, film = f, radius = r, focus = d, xi = x;
            return lantern::ray{origin, direction};
        };
    }
};
float a_moment(float, float, float) { return 0.625f; }

const viewer seat{.eye = {1, 2, 3}, .axes = glm::mat3{{0, 0, -1}, {0, 1, 0}, {1, 0, 0}}, .half = {0.8f, 0.5f}};
viewer with(viewer v, std::optional<glm::vec2> lens, std::optional<glm::vec2> exposure) {
    v.lens = lens;
    v.exposure = exposure;
    return v;
}

}  // namespace

TEST_CASE("the corners of the picture are the corners of the film, and upwards is upwards", "[step1]") {
    INFO(hint("the picture is upside down, mirrored, or too narrow", "film (0, 0) is the top left corner; lab 07 counts from the middle, to the right and upwards", "§1 A camera"));
    const viewer v = with(seat, glm::vec2(0.1f, 4), std::nullopt);
    for (const auto& [film, place] : {std::pair{glm::vec2(0, 0), glm::vec2(-0.8f, 0.5f)}, {{1, 0}, {0.8f, 0.5f}}, {{0, 1}, {-0.8f, -0.5f}},
                                      {{0.5f, 0.5f}, {0, 0}}, {{0.75f, 0.5f}, {0.4f, 0}}, {{0.5f, 0.25f}, {0, 0.25f}}}) {
        noted_lens lens;
        notes drawn_here;
        CAPTURE(film);
        shoot(v, film, lens.part(), a_moment, drawn_here.source());
        REQUIRE(lens.calls == 1);
        CHECK(glm::length(lens.film - place) < 1e-6f);
    }
}

TEST_CASE("your lens is asked with what the camera has, and its ray is the ray", "[step1]") {
    INFO(hint("another focus or aperture than asked for", "P::through_lens(eye, axes, film, radius, focus, ξ)", "§1 A camera"));
    noted_lens lens;
    notes drawn_here{.answer = {0.125f, 0.875f}};
    const shot got = shoot(with(seat, glm::vec2(0.3f, 7), std::nullopt), {0.5f, 0.5f}, lens.part(), a_moment, drawn_here.source());
    CHECK(lens.eye == seat.eye);
    CHECK(lens.axes == seat.axes);
    CHECK(lens.radius == 0.3f);
    CHECK(lens.focus == 7);
    CHECK(lens.xi == glm::vec2(0.125f, 0.875f));
    CHECK(got.ray.origin == noted_lens::origin);
    CHECK(got.ray.direction == noted_lens::direction);
    CHECK_FALSE(got.time.has_value());
}

TEST_CASE("a camera draws for what it has, and nothing for what it has not", "[step1]") {
    INFO(hint("a pinhole draws numbers for a lens that is not there", "if constexpr: a type without a lens has no line that draws for it", "§1 A camera"));
    for (const bool optics : {false, true})
        for (const bool shutter : {false, true}) {
            CAPTURE(optics, shutter);
            noted_lens lens;
            notes drawn_here;
            const viewer v = with(seat, optics ? std::optional(glm::vec2(0.1f, 4)) : std::nullopt, shutter ? std::optional(glm::vec2(0, 1)) : std::nullopt);
            const shot got = shoot(v, {0.3f, 0.4f}, lens.part(), a_moment, drawn_here.source());
            CHECK(drawn_here.of(purpose::lens) == (optics ? 1 : 0));
            CHECK(drawn_here.of(purpose::time) == (shutter ? 1 : 0));
            CHECK(drawn_here.asked.size() == std::size_t(optics) + std::size_t(shutter));
            for (const question& q : drawn_here.asked) CHECK(q.dimensions == (q.purpose == std::uint32_t(purpose::lens) ? 2u : 1u));
            CHECK(got.time.has_value() == shutter);
        }
}

TEST_CASE("a pinhole is a lens of radius 0", "[step1]") {
    INFO(hint("NaN, or a blur without a lens", "radius 0, at any focus above 0", "§1 A camera"));
    noted_lens lens;
    notes drawn_here;
    const shot got = shoot(seat, {0.5f, 0.5f}, lens.part(), a_moment, drawn_here.source());
    REQUIRE(lens.calls == 1);
    CHECK(lens.radius == 0);
    CHECK(lens.focus > 0);
    CHECK((lens.xi.x >= 0 && lens.xi.x <= 1 && lens.xi.y >= 0 && lens.xi.y <= 1));
    CHECK(got.ray.direction == noted_lens::direction);
}

TEST_CASE("the time is your moment of the exposure", "[step1]") {
    INFO(hint("nothing is blurred, or all of it too long", "P::moment(open, close, ξ)", "§1 A camera"));
    noted_lens lens;
    notes drawn_here{.answer = {0.375f, 0.9f}};
    std::vector<glm::vec3> asked;
    const auto moment = [&](float open, float close, float xi) {
        asked.push_back({open, close, xi});
        return 0.4375f;
    };
    const shot got = shoot(with(seat, std::nullopt, glm::vec2(0.25f, 0.75f)), {0.5f, 0.5f}, lens.part(), moment, drawn_here.source());
    REQUIRE(asked.size() == 1);
    CHECK(asked[0] == glm::vec3(0.25f, 0.75f, 0.375f));
    CHECK(got.time == 0.4375f);
}

// ---- Step 2 --------------------------------------------------------------------------------------------------------

namespace {

constexpr auto a_lens = std::uint32_t(purpose::lens), a_light = std::uint32_t(purpose::light), a_gloss = std::uint32_t(purpose::gloss), a_time = std::uint32_t(purpose::time);

const std::vector<question> questions{{2, a_lens, 0}, {2, a_light, 0}, {2, a_light, 1}, {2, a_gloss, 0}, {2, a_gloss, 0, {0}}, {2, a_gloss, 0, {1}}, {2, a_gloss, 0, {0, 1}}};

/// The correlation of two lists: for n pairs that have nothing to do with each other its standard error is 1/√n.
double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    double ma = 0, mb = 0, aa = 0, bb = 0, ab = 0;
    const auto n = double(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) ma += a[i] / n, mb += b[i] / n;
    for (std::size_t i = 0; i < a.size(); ++i) aa += (a[i] - ma) * (a[i] - ma), bb += (b[i] - mb) * (b[i] - mb), ab += (a[i] - ma) * (b[i] - mb);
    return ab / std::sqrt(aa * bb);
}

struct kind_of_numbers {
    question asked;
    glm::uvec2 shift{0};     ///< of the pixel
    std::uint64_t seed = 1;
};

/// The largest correlation of a coordinate of one with a coordinate of the other, over 40 pixels of 64 samples: of the cells, and of the
/// places within the cells. In 8 of these with standard errors of .02, one is above .12 by chance in less than 1 of 10⁷ cases.
double largest_correlation(const kind_of_numbers& one, const kind_of_numbers& other) {
    std::array<std::vector<double>, 4> a, b;
    const auto append = [](std::array<std::vector<double>, 4>& to, const kind_of_numbers& k, unsigned pixel) {
        for (const glm::vec2 p : drawn(8, k.seed, glm::uvec2(pixel, 3) + k.shift, k.asked)) {
            const double cells = k.asked.dimensions == 1 ? 64 : 8;
            to[0].push_back(std::floor(p.x * cells));
            to[1].push_back(std::floor(p.y * cells));
            to[2].push_back(p.x * cells - std::floor(p.x * cells));
            to[3].push_back(p.y * cells - std::floor(p.y * cells));
        }
    };
    for (unsigned pixel = 0; pixel < 40; ++pixel) append(a, one, pixel), append(b, other, pixel);
    double most = 0;
    for (const auto& [i, j] : {std::pair{0, 0}, {0, 1}, {1, 0}, {1, 1}, {2, 2}, {2, 3}, {3, 2}, {3, 3}}) {
        if (one.asked.dimensions == 1 && i % 2 == 1) continue;  // it has no y
        if (other.asked.dimensions == 1 && j % 2 == 1) continue;
        const double r = std::abs(correlation(a[std::size_t(i)], b[std::size_t(j)]));
        most = r >= 0 ? std::max(most, r) : INFINITY;
    }
    return most;
}

}  // namespace

TEST_CASE("each purpose has a sample in each cell of its grid", "[step2]") {
    INFO(hint("more noise than with lab 04's points", "each of the side² strata is taken once: the cell is P::stratum(sample, side², …)", "§2 The samples"));
    for (const std::uint32_t side : {1u, 2u, 5u, 8u})
        for (const question& q : questions) {
            CAPTURE(side, q.purpose, q.which, q.path.size());
            std::set<std::pair<int, int>> cells;
            for (const glm::vec2 p : drawn(side, 7, {12, 34}, q)) {
                REQUIRE((p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1));
                cells.insert({int(p.x * float(side)), int(p.y * float(side))});
            }
            CHECK(cells.size() == side * side);
        }
}

TEST_CASE("a single number has a sample in each of as many stretches as there are samples", "[step2]") {
    INFO(hint("motion blur comes in steps, or is noisier than it need be", "for one number there are side² stretches, not side", "§2 The samples"));
    for (const std::uint32_t side : {1u, 3u, 8u}) {
        std::set<int> stretches;
        for (const glm::vec2 p : drawn(side, 7, {12, 34}, {1, a_time, 0})) {
            REQUIRE((p.x >= 0 && p.x < 1));
            stretches.insert(int(p.x * float(side * side)));
        }
        CHECK(stretches.size() == side * side);
    }
}

TEST_CASE("no purpose knows of another", "[step2]") {
    INFO(hint("swirls instead of noise: one point of the lens sees one point of the lamp only", "the order and the places are chosen by the key of purpose, which and path", "§2 The samples"));
    for (std::size_t i = 0; i < questions.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) {
            CAPTURE(questions[i].purpose, questions[i].which, questions[i].path, questions[k].purpose, questions[k].which, questions[k].path);
            CHECK(largest_correlation({questions[i]}, {questions[k]}) < 0.12);
        }
}

TEST_CASE("one number and two of the same purpose have nothing in common", "[step2]") {
    INFO(hint("the time of a sample follows from its place", "draw1 is not draw2's x: its order is of another key", "§2 The samples"));
    for (const std::uint32_t p : {a_time, a_lens, a_gloss}) CHECK(largest_correlation({{1, p, 0}}, {{2, p, 0}}) < 0.12);
    CHECK(largest_correlation({{1, a_time, 0}}, {{1, a_time, 1}}) < 0.12);
}

TEST_CASE("no pixel is like its neighbour, and no seed like another", "[step2]") {
    INFO(hint("a pattern that repeats in each pixel", "the order depends on the pixel, and so do the places in the cells", "§2 The samples"));
    for (const question& q : {question{2, a_lens, 0}, question{1, a_time, 0}}) {
        CHECK(largest_correlation({q}, {.asked = q, .shift = {1, 0}}) < 0.12);
        CHECK(largest_correlation({q}, {.asked = q, .shift = {0, 1}}) < 0.12);
        CHECK(largest_correlation({q}, {.asked = q, .seed = 2}) < 0.12);
    }
}

TEST_CASE("asked again, the same purpose gives the same numbers", "[step2]") {
    INFO(hint("a picture that depends on who asks first", "numbers are asked for by purpose, not by turn", "§2 The samples"));
    for (const question& q : questions) CHECK(drawn(4, 5, {6, 7}, q) == drawn(4, 5, {6, 7}, q));
}

TEST_CASE("the points are your lab 04's, in the order of your lab 13", "[step2]") {
    INFO(hint("your own parts are not asked", "P::jittered(P::stratum(…), side, places)", "§2 The samples"));
    std::vector<std::pair<std::uint32_t, std::uint32_t>> cells, strata;
    const auto jitter = [&](std::uint32_t i, std::uint32_t side, glm::vec2 xi) {
        cells.emplace_back(i, side);
        CHECK((xi.x > 0 && xi.x < 1 && xi.y > 0 && xi.y < 1 && xi.x != xi.y));
        return glm::vec2(0.4375f, 0.8125f);
    };
    const auto order = [&](std::uint32_t i, std::uint32_t count, std::uint32_t, glm::uvec2 pixel) {
        strata.emplace_back(i, count);
        CHECK(pixel == glm::uvec2(8, 9));
        return 17u;
    };
    CHECK(drawn_with(6, 1, {8, 9}, 22, {2, a_light, 0}, jitter, order) == glm::vec2(0.4375f, 0.8125f));
    CHECK(cells == std::vector{std::pair{17u, 6u}});
    CHECK(strata == std::vector{std::pair{22u, 36u}});
    strata.clear();
    const float one = drawn_with(6, 1, {8, 9}, 22, {1, a_time, 0}, jitter, order).x;
    CHECK(strata == std::vector{std::pair{22u, 36u}});
    CHECK((one >= 17.0f / 36 && one < 18.0f / 36));
}

TEST_CASE("a number is below 1 even in the last of a million stretches", "[step2]") {
    INFO(hint("a ray at a time when the shutter is closed", "(999999 + 0.99) / 1000000 is 1 in float: take the largest float below 1 then", "§2 The samples"));
    const auto last = [](std::uint32_t, std::uint32_t count, std::uint32_t, glm::uvec2) { return count - 1; };
    const auto jitter = [](std::uint32_t, std::uint32_t, glm::vec2 xi) { return xi; };
    for (unsigned x = 0; x < 400; ++x) REQUIRE(drawn_with(1000, 3, {x, 0}, 5, {1, a_time, 0}, jitter, last).x < 1);
}

// ---- Step 3 --------------------------------------------------------------------------------------------------------

namespace {

/// At the height 2, one unit wide and long, and shining downwards.
const lantern::rectangle ceiling_lamp{{-0.5f, 2, -0.5f}, {1, 0, 0}, {0, 0, 1}};

glm::vec3 a_place(const lantern::rectangle& lamp, glm::vec2 xi) { return lamp.corner + xi.x * lamp.u + xi.y * lamp.v; }

/// As in lab 05: L A cos θ cos θ' / d².
glm::vec3 arriving(const lantern::rectangle& lamp, glm::vec3 radiance_, glm::vec3 on_lamp, glm::vec3 position, glm::vec3 normal) {
    const glm::vec3 to_lamp = on_lamp - position, area_normal = glm::cross(lamp.u, lamp.v);
    const float d = glm::length(to_lamp), cosine = glm::dot(normal, to_lamp) / d, area_cosine = -glm::dot(area_normal, to_lamp) / d;
    return cosine > 0 && area_cosine > 0 ? radiance_ * (cosine * area_cosine / (d * d)) : glm::vec3(0);
}

}  // namespace

TEST_CASE("light comes from the point that your lab 05 gives", "[step3]") {
    INFO(hint("shadows in the wrong place, or hard", "P::point_on(shape, ξ), and all that follows from this point", "§3 A lamp"));
    std::vector<glm::vec2> asked;
    std::vector<glm::vec3> on_lamp;
    const auto place = [&](const lantern::rectangle& lamp, glm::vec2 xi) {
        CHECK(lamp.corner == ceiling_lamp.corner);
        asked.push_back(xi);
        return glm::vec3(0.375f, 2, -0.25f);
    };
    const auto brings = [&](const lantern::rectangle& lamp, glm::vec3 radiance_, glm::vec3 on, glm::vec3 position, glm::vec3) {
        CHECK(lamp.u == ceiling_lamp.u);
        CHECK(radiance_ == glm::vec3(3, 2, 1));
        CHECK(position == glm::vec3(1, 0, 1));
        on_lamp.push_back(on);
        return glm::vec3(0.5f, 0.25f, 0.125f);
    };
    const auto got = illuminate(ceiling_lamp, {3, 2, 1}, {1, 0, 1}, {0.2f, 0.7f}, place, brings);
    CHECK(asked == std::vector{glm::vec2(0.2f, 0.7f)});
    REQUIRE(on_lamp.size() == 1);
    CHECK(on_lamp[0] == glm::vec3(0.375f, 2, -0.25f));
    CHECK(apart(got.position, {0.375, 2, -0.25}) < 1e-5);
    CHECK(got.irradiance == glm::vec3(0.5f, 0.25f, 0.125f));
}

TEST_CASE("the irradiance is that of a surface which faces the lamp's point", "[step3]") {
    INFO(hint("the floor far from the lamp is too dark",
              "the library's materials count the cosine at the surface: ask your lab 05 for a surface that faces the point, whose cosine is 1", "§3 A lamp"));
    numbers random(3);
    for (int i = 0; i < 100; ++i) {
        const glm::vec3 point{random.between(-4, 4), random.between(-2, 1.5f), random.between(-4, 4)};
        const glm::vec2 xi{random.unit(), random.unit()};
        const glm::dvec3 way = glm::dvec3(a_place(ceiling_lamp, xi)) - glm::dvec3(point);
        const double d2 = glm::dot(way, way), expected = way.y / std::sqrt(d2) / d2;  // L = A = 1
        CAPTURE(point, xi);
        const auto got = illuminate(ceiling_lamp, glm::vec3(1), point, xi, a_place, arriving);
        REQUIRE(apart(got.irradiance, glm::dvec3(expected)) < 1e-5 * expected);
    }
}

TEST_CASE("behind the lamp it is dark", "[step3]") {
    INFO(hint("a lamp that shines to both sides", "the light's irradiance is your lab 05's: 0 behind the lamp", "§3 A lamp"));
    CHECK(illuminate(ceiling_lamp, glm::vec3(1), {0.25f, 3, 0}, {0.5f, 0.5f}, a_place, arriving).irradiance == glm::vec3(0));
    CHECK(illuminate(ceiling_lamp, glm::vec3(1), {0.25f, -3, 0}, {0.5f, 0.5f}, a_place, arriving).irradiance.x > 0);
}

TEST_CASE("a lamp that can be seen does not stand in its own light", "[step3]") {
    INFO(hint("a lamp that is a thing of the scene too lights nothing, or half of the points",
              "the shadow ray ends just before the lamp: lantern::just_off, with a normal of length 1 on the lit side", "§3 A lamp"));
    numbers random(4);
    for (const float scale : {1e-3f, 1.0f, 300.0f, 1e5f})
        for (int i = 0; i < 100; ++i) {
            const glm::vec3 u = scale * random.between(0.1f, 3) * random.direction(), v = scale * random.between(0.1f, 3) * random.direction();
            const lantern::rectangle shape{scale * 3.0f * random.vector(), u, v};
            const glm::vec3 normal = glm::normalize(glm::cross(u, v));
            glm::vec3 away = random.direction();
            if (glm::dot(away, normal) < 0.2f) away = glm::normalize(away + (0.7f - glm::dot(away, normal)) * normal);
            const glm::vec2 xi{random.between(0.05f, 0.95f), random.between(0.05f, 0.95f)};
            const glm::vec3 place = a_place(shape, xi), point = place + 5 * scale * away;
            const auto got = illuminate(shape, glm::vec3(1), point, xi, a_place, arriving);
            CAPTURE(scale, shape.corner, u, v, point, got.position);
            REQUIRE_FALSE(lantern::intersect(shape, lantern::ray{point, got.position - point}, {0, 1}).has_value());
            REQUIRE(glm::length(got.position - place) < 1e-5f * (glm::length(place) + glm::length(point)));
        }
}

// ---- Step 4 --------------------------------------------------------------------------------------------------------

namespace {

struct noted_gloss {
    int calls = 0;
    glm::vec3 in{0}, normal{0};
    float width = -1;
    glm::vec2 xi{-1};

    static constexpr glm::vec3 direction{0.28f, 0.96f, 0};
    [[nodiscard]] gloss_part part() {
        return [this](glm::vec3 i, glm::vec3 n, float w, glm::vec2 x) {
            ++calls, in = i, normal = n, width = w, xi = x;
            return direction;
        };
    }
};

const glm::vec3 downwards{0.6f, -0.8f, 0};
const lantern::hit on_the_floor{2, {1, 0, 0}, {0, 1, 0}, 0};

}  // namespace

TEST_CASE("one ray goes on: your reflection, and the colour as its weight", "[step4]") {
    INFO(hint("no colour, or a reflection that is not yours", "bounce{P::reflected(…), color}", "§4 Gloss"));
    noted_gloss part;
    const auto rays = scatter({0.9f, 0.5f, 0.1f}, 0.3f, downwards, on_the_floor, {0.2f, 0.7f}, part.part());
    REQUIRE(rays.size() == 1);
    CHECK(rays[0].direction == noted_gloss::direction);
    CHECK(rays[0].weight == glm::vec3(0.9f, 0.5f, 0.1f));
    CHECK(part.in == downwards);
    CHECK(part.width == 0.3f);
    CHECK(part.xi == glm::vec2(0.2f, 0.7f));
}

TEST_CASE("your reflection is given the normal on the side that the ray comes from", "[step4]") {
    INFO(hint("reflections go into the surface when it is seen from inside or from behind", "hit.normal points out of the thing; lab 06 wants the side of the ray: lantern::facing", "§4 Gloss"));
    for (const bool blurred : {true, false})
        for (const float side : {1.0f, -1.0f}) {
            CAPTURE(blurred, side);
            noted_gloss part;
            const lantern::hit h{2, {1, 0, 0}, {0, side, 0}, 0};
            if (blurred) scatter(glm::vec3(1), 0.2f, downwards, h, {0.5f, 0.5f}, part.part());
            else scatter_sharp(glm::vec3(1), downwards, h, part.part());
            CHECK(part.calls == 1);
            CHECK(part.normal == glm::vec3(0, 1, 0));
        }
}

TEST_CASE("sharp gloss is gloss of width 0, and needs no point", "[step4]") {
    INFO(hint("a mirror that is blurred, or has lost its colour", "P::reflected(in, normal, 0, any ξ): nothing is drawn for it", "§4 Gloss"));
    noted_gloss part;
    const auto rays = scatter_sharp({0.9f, 0.5f, 0.1f}, downwards, on_the_floor, part.part());
    REQUIRE(rays.size() == 1);
    CHECK(part.width == 0);
    CHECK((part.xi.x >= 0 && part.xi.x <= 1 && part.xi.y >= 0 && part.xi.y <= 1));
    CHECK(part.in == downwards);
    CHECK(rays[0].direction == noted_gloss::direction);
    CHECK(rays[0].weight == glm::vec3(0.9f, 0.5f, 0.1f));
}

// ---- Step 5 --------------------------------------------------------------------------------------------------------

namespace {

/// As in lab 08: the smallest t > 0.
std::optional<float> meeting(glm::vec3 center, glm::vec3 velocity, float radius, glm::vec3 origin, glm::vec3 direction, float time) {
    const glm::dvec3 d(direction), from = glm::dvec3(origin) - glm::dvec3(center) - double(time) * glm::dvec3(velocity);
    const double a = glm::dot(d, d), b = glm::dot(from, d), root = std::sqrt(b * b - a * (glm::dot(from, from) - double(radius) * radius));
    if (-b - root > 0) return float((-b - root) / a);
    if (-b + root > 0) return float((-b + root) / a);
    return std::nullopt;
}

/// As in lab 08, to the nearest float.
std::pair<glm::vec3, glm::vec3> box_of(glm::vec3 center, glm::vec3 velocity, float radius, float open, float close) {
    const glm::vec3 first = center + open * velocity, last = center + close * velocity;
    return {glm::min(first, last) - radius, glm::max(first, last) + radius};
}

}  // namespace

TEST_CASE("your lab 08 is asked about the ball, the ray and its time", "[step5]") {
    INFO(hint("nothing moves", "P::meet(center, velocity, radius, origin, direction, time): the time is the ray's", "§5 Balls"));
    int calls = 0;
    const auto part = [&](glm::vec3 center, glm::vec3 velocity, float radius, glm::vec3 origin, glm::vec3 direction, float time) -> std::optional<float> {
        ++calls;
        CHECK(center == glm::vec3(1, 2, 3));
        CHECK(velocity == glm::vec3(0, 4, 0));
        CHECK(radius == 0.5f);
        CHECK(origin == glm::vec3(1, 3, 9));
        CHECK(direction == glm::vec3(0, 0, -2));
        CHECK(time == 0.25f);
        return 2.75f;
    };
    const auto h = intersect({{1, 2, 3}, 0.5f, glm::vec3(0, 4, 0)}, {{1, 3, 9}, {0, 0, -2}}, 0.25f, {}, part);
    CHECK(calls == 1);
    REQUIRE(h.has_value());
    CHECK(h->t == 2.75f);
    CHECK(same(h->point, {1, 3, 3.5f}));
    CHECK(same(h->normal, {0, 0, 1}));
}

TEST_CASE("the hit is on the ball where it is at that time", "[step5]") {
    INFO(hint("acne, or shadows beside the ball", "the middle is center + time velocity; from there the point is as far as the radius, in double and rounded once", "§5 Balls"));
    numbers random(5);
    for (int i = 0; i < 300; ++i) {
        const body b{5.0f * random.vector(), random.between(0.2f, 2), 3.0f * random.vector()};
        const float time = random.unit();
        const glm::dvec3 middle = glm::dvec3(b.center) + double(time) * glm::dvec3(*b.velocity);
        const glm::vec3 aim = glm::vec3(middle) + 0.5f * b.radius * random.direction(), origin = aim + 20.0f * random.direction();
        const lantern::ray r{origin, random.between(0.1f, 3) * (aim - origin)};
        const auto h = intersect(b, r, time, {}, meeting);
        CAPTURE(b.center, b.radius, *b.velocity, time, r.origin, r.direction);
        REQUIRE(h.has_value());
        const glm::dvec3 out = glm::dvec3(h->point) - middle;
        REQUIRE(std::abs(glm::length(out) - double(b.radius)) < 1.5e-6);
        REQUIRE(apart(h->normal, out / double(b.radius)) < 1e-5);
        REQUIRE(std::abs(glm::length(glm::dvec3(h->normal)) - 1) < 2e-7);
        REQUIRE(apart(h->point, glm::dvec3(r.origin) + double(h->t) * glm::dvec3(r.direction)) < 1e-4);
    }
}

TEST_CASE("a hit outside of the range is none", "[step5]") {
    INFO(hint("things behind the lamp cast shadows; hits that are farther than others win", "lab 08 knows no range: only t > range.min and t <= range.max counts", "§5 Balls"));
    const body b{{0, 0, -5}, 1, glm::vec3(0)};
    const lantern::ray r{{0, 0, 0}, {0, 0, -1}};  // in at 4, out at 6
    CHECK(intersect(b, r, 0.0f, {0, 4}, meeting).has_value());
    CHECK_FALSE(intersect(b, r, 0.0f, {0, 3.999f}, meeting).has_value());
    CHECK_FALSE(intersect(b, r, 0.0f, {6.001f, lantern::infinity}, meeting).has_value());
    CHECK_FALSE(intersect(b, r, 0.0f, {4.5f, 5.5f}, meeting).has_value());
}

TEST_CASE("where the range begins behind the first hit, the second one counts", "[step5]") {
    INFO(hint("a ball that is cut open has no back", "ask from the beginning of the range on: from at(r, range.min), and count on from there", "§5 Balls"));
    const body b{{0, 0, -5}, 1, glm::vec3(0)};
    for (const float length : {1.0f, 0.25f, 8.0f}) {
        CAPTURE(length);
        const auto h = intersect(b, {{0, 0, 0}, {0, 0, -length}}, 0.0f, {4.5f / length, lantern::infinity}, meeting);
        REQUIRE(h.has_value());
        CHECK(h->t == Approx(6 / length));
        CHECK(same(h->point, {0, 0, -6}));
        CHECK(same(h->normal, {0, 0, -1}));
    }
}

TEST_CASE("a ball that stands still knows no time", "[step5]") {
    INFO(hint("a still ball that costs as much as a moving one", "by its type it has no velocity: 0, at time 0, for any ray", "§5 Balls"));
    for (const auto time : {std::optional<float>(), std::optional(0.75f)}) {
        int calls = 0;
        const auto part = [&](glm::vec3, glm::vec3 velocity, float, glm::vec3, glm::vec3, float at) -> std::optional<float> {
            ++calls;
            CHECK(velocity == glm::vec3(0));
            CHECK(at == 0);
            return 4.0f;
        };
        const auto h = intersect({{0, 0, -5}, 1, std::nullopt}, {{0, 0, 0}, {0, 0, -1}}, time, {}, part);
        CHECK(calls == 1);
        REQUIRE(h.has_value());
        CHECK(same(h->point, {0, 0, -4}));
    }
}

TEST_CASE("a box holds the ball at all times, for certain, and not much else", "[step5]") {
    INFO(hint("balls with holes, or cut off, once there is a tree", "lab 08's box of the exposure from 0 to 1, grown by 4 ulp of its largest coordinate", "§5 Balls"));
    numbers random(6);
    for (const float far : {0.0f, 1.0f, 1000.0f, 1e6f})
        for (int i = 0; i < 200; ++i) {
            const bool moves = i % 4 != 0;
            const body b{far * random.vector() + random.vector(), random.between(0.1f, 2), moves ? std::optional(5.0f * random.vector()) : std::nullopt};
            const auto box = bounds(b, box_of);
            CAPTURE(b.center, b.radius, b.velocity.value_or(glm::vec3(0)), box.min, box.max);
            for (int axis = 0; axis < 3; ++axis) {
                const double c = b.center[axis], v = moves ? double((*b.velocity)[axis]) : 0, low = std::min(c, c + v) - double(b.radius), high = std::max(c, c + v) + double(b.radius);
                const glm::vec3 size = glm::max(glm::abs(box.min), glm::abs(box.max));
                const double little = 8 * double(lantern::ulp(std::max({size.x, size.y, size.z})));
                REQUIRE(double(box.min[axis]) <= low);
                REQUIRE(double(box.max[axis]) >= high);
                REQUIRE(double(box.min[axis]) >= low - little);
                REQUIRE(double(box.max[axis]) <= high + little);
            }
        }
}

// ---- Step 6 --------------------------------------------------------------------------------------------------------

namespace {

constexpr float pi = std::numbers::pi_v<float>;

/// Ten by ten around the origin, seen from above.
const lantern::rectangle ground{{-5, 0, 5}, {10, 0, 0}, {0, 0, -10}};
/// The same at another height, seen from below.
lantern::rectangle sheet(float height, float half) { return {{-half, height, -half}, {2 * half, 0, 0}, {0, 0, 2 * half}}; }

/// What the tracer shoots.
struct seen_ray {
    lantern::ray r;
    std::optional<float> time;
    lantern::interval range;
};
struct log_of_rays {
    std::vector<seen_ray> all;
    [[nodiscard]] told listener() {
        return [this](const lantern::ray& r, std::optional<float> time, lantern::interval range) { all.push_back({r, time, range}); };
    }
};

struct look {
    glm::vec3 light{0};
    notes drawn_here;
    log_of_rays rays;
};
look into(const room& r, const lantern::ray& along, std::uint32_t depth = 5, std::optional<float> time = std::nullopt) {
    look l;
    l.light = radiance(r, along, time, depth, l.drawn_here.source(), l.rays.listener());
    return l;
}

const lantern::ray from_above{{0.5f, 1, 2}, {-0.5f, -1, -2}};  // meets the ground at the origin, at t = 1

/// What the ceiling lamp brings to the origin, at ξ = (1/4, 3/4): from (-1/4, 2, 1/4).
const float at_the_origin = 4 / (4.125f * 4.125f);

}  // namespace

TEST_CASE("what meets nothing sees the sky", "[step6]") {
    INFO(hint("a black background", "radiance(w.sky, direction) for a direction of length 1", "§6 The ray tracer"));
    const room r{.walls = {}, .horizon = {1, 0, 0}, .zenith = {0, 0, 1}};
    CHECK(same(into(r, {{0, 0, 0}, {0, 5, 0}}).light, {0, 0, 1}));
    CHECK(same(into(r, {{0, 0, 0}, {3, 4, 0}}).light, {0.2f, 0, 0.8f}));
}

TEST_CASE("a matt floor under a lamp: colour / π times what arrives", "[step6]") {
    INFO(hint("too bright or too dark by a factor", "evaluate(material, in, hit, out) times the irradiance; out is the unit direction to the light", "§6 The ray tracer"));
    const room r{.walls = {{.shape = ground, .color = {0.8f, 0.4f, 0.2f}}}, .lamps = {ceiling_lamp}};
    const look l = into(r, from_above);
    CHECK(same(l.light, glm::vec3(0.8f, 0.4f, 0.2f) / pi * at_the_origin));
    REQUIRE(l.rays.all.size() == 2);
    CHECK(l.drawn_here.asked.size() == 1);
    CHECK(l.drawn_here.of(purpose::light) == 1);
}

TEST_CASE("every lamp counts, each by numbers of its own", "[step6]") {
    INFO(hint("all lamps but one are out, or their shadows go together", "draw2(purpose::light, i): which lamp it is for", "§6 The ray tracer"));
    const room r{.walls = {{.shape = ground}}, .lamps = {ceiling_lamp, ceiling_lamp, ceiling_lamp}};
    const look l = into(r, from_above);
    CHECK(same(l.light, glm::vec3(3 / pi * at_the_origin)));
    std::set<std::uint32_t> which;
    for (const question& q : l.drawn_here.asked) which.insert(q.which);
    CHECK(which.size() == 3);
}

TEST_CASE("what stands between is in the way, and what stands behind is not", "[step6]") {
    INFO(hint("no shadows, or shadows of what is behind the lamp", "the shadow ray reaches from the hit to the light, and not beyond", "§6 The ray tracer"));
    for (const auto& [height, dark] : {std::pair{1.0f, true}, {2.5f, false}, {-0.5f, false}}) {
        CAPTURE(height);
        const room r{.walls = {{.shape = ground}, {.shape = sheet(height, 0.4f)}}, .lamps = {ceiling_lamp}};
        const look l = into(r, {{3, 0.5f, 3}, {-3, -0.5f, -3}});
        CHECK(same(l.light, dark ? glm::vec3(0) : glm::vec3(at_the_origin / pi)));
        REQUIRE(l.rays.all.size() == 2);
        const seen_ray& shadow = l.rays.all[1];
        CHECK(apart(shadow.r.origin + shadow.range.max * shadow.r.direction, {-0.25, 2, 0.25}) < 1e-4);
    }
}

TEST_CASE("no surface is in its own shadow", "[step6]") {
    INFO(hint("acne: dark dots", "a ray that goes on begins at lantern::leave(hit, its direction)", "§6 The ray tracer"));
    numbers random(7);
    for (int i = 0; i < 200; ++i) {
        const float far = i % 2 == 0 ? 1.0f : 1000.0f;
        const glm::vec3 middle = far * random.vector(), normal = random.direction();
        const glm::vec3 u = glm::normalize(glm::cross(normal, glm::vec3(0.3f, 0.5f, 0.8f))), v = glm::cross(normal, u);
        const lantern::rectangle slope{middle - 3.0f * (u + v), 6.0f * u, 6.0f * v};
        const lantern::rectangle lamp{middle + 4.0f * normal - 0.5f * (u + v), v, u};  // the other way round: it looks down
        const glm::vec3 eye = middle + 3.0f * normal + random.vector();
        CAPTURE(middle, normal);
        REQUIRE(into({.walls = {{.shape = slope}}, .lamps = {lamp}}, {eye, middle + 0.5f * random.vector() - eye}).light.x > 0);
    }
}

TEST_CASE("light that comes from everywhere, and light that is given", "[step6]") {
    INFO(hint("what shines is dark, or the shadows are black", "emitted(m, in, hit), and albedo(m, hit) times the ambient light: as far as the material has them", "§6 The ray tracer"));
    const room shining{.walls = {{.shape = ground, .made_of = substance::shining, .color = {3, 2, 1}}}, .lamps = {ceiling_lamp}, .ambient = glm::vec3(1)};
    CHECK(into(shining, from_above).light == glm::vec3(3, 2, 1));
    const room grey{.walls = {{.shape = ground, .color = {0.5f, 0.25f, 0.125f}}}, .ambient = {1, 2, 4}};
    CHECK(same(into(grey, from_above).light, glm::vec3(0.5f)));
}

TEST_CASE("a mirror shows what its ray meets, in its colour", "[step6]") {
    INFO(hint("mirrors are black, white, or show the wrong side", "the weight times the radiance along the direction that scattered(…) gives", "§6 The ray tracer"));
    const room r{.walls = {{.shape = ground, .made_of = substance::mirror, .color = {0.9f, 0.6f, 0.3f}}, {.shape = sheet(3, 20), .made_of = substance::shining, .color = {1, 2, 3}}}};
    const look l = into(r, from_above);
    CHECK(same(l.light, {0.9f, 1.2f, 0.9f}));
    REQUIRE(l.rays.all.size() == 2);
    CHECK(same(glm::normalize(l.rays.all[1].r.direction), glm::normalize(glm::vec3(-0.5f, 1, -2))));
    CHECK(l.drawn_here.asked.empty());
}

TEST_CASE("a ray is followed as often as depth says", "[step6]") {
    INFO(hint("an endless loop between two mirrors, or one reflection too few", "depth - 1 at each; with depth 0 nothing is followed, and nothing drawn for it", "§6 The ray tracer"));
    const room mirrors{.walls = {{.shape = ground, .made_of = substance::mirror}, {.shape = sheet(3, 20), .made_of = substance::mirror}}, .horizon = glm::vec3(1), .zenith = glm::vec3(1)};
    for (const std::uint32_t depth : {0u, 1u, 4u, 17u}) {
        CAPTURE(depth);
        const look l = into(mirrors, {{0, 1, 0}, {0, -1, 0.0f}}, depth);
        CHECK(l.light == glm::vec3(0));
        CHECK(l.rays.all.size() == depth + 1);
    }
    const room frosted{.walls = {{.shape = ground, .made_of = substance::frosted}}, .horizon = glm::vec3(1), .zenith = glm::vec3(1)};
    CHECK(into(frosted, from_above, 0).drawn_here.asked.empty());
    CHECK(same(into(frosted, from_above, 1).light, glm::vec3(1)));
}

TEST_CASE("each ray that goes on has numbers of its own", "[step6]") {
    INFO(hint("reflections that are blurred in the same way as what they reflect", "source.branch(k) for the k-th ray, not the source itself", "§6 The ray tracer"));
    const room r{.walls = {{.shape = ground, .made_of = substance::frosted},                      // behind the pane
                           {.shape = sheet(1, 20), .made_of = substance::glass},
                           {.shape = sheet(5, 20), .made_of = substance::frosted}}};              // before it
    const look l = into(r, {{0, 3, 0}, {0.1f, -1, 0}}, 2);
    std::vector<std::vector<std::uint32_t>> paths;
    for (const question& q : l.drawn_here.asked)
        if (q.purpose == a_gloss) paths.push_back(q.path);
    std::ranges::sort(paths);
    // In at (0), out at (1); with depth 2 the frosted walls' own rays are the last.
    CHECK(paths == std::vector<std::vector<std::uint32_t>>{{0}, {1}});
}

TEST_CASE("both rays of glass are followed, each with its weight", "[step6]") {
    INFO(hint("glass without reflections, or without what is behind it", "a material may send on more than one ray: take them all", "§6 The ray tracer"));
    const room r{.walls = {{.shape = ground, .made_of = substance::shining, .color = {1, 0, 0}},
                           {.shape = sheet(1, 20), .made_of = substance::glass, .color = glm::vec3(0.25f)},
                           {.shape = sheet(5, 20), .made_of = substance::shining, .color = {0, 1, 0}}}};
    CHECK(same(into(r, {{0, 3, 0}, {0.1f, -1, 0}}).light, {0.25f, 0.5f, 0}));
}

TEST_CASE("shadow rays and rays that go on keep the time", "[step6]") {
    INFO(hint("what moves casts a sharp shadow, or is sharp in a mirror", "continued(r, origin, direction): a ray that goes on from r is at the time of r", "§6 The ray tracer"));
    for (const float time : {0.0f, 0.75f, 1.0f}) {
        CAPTURE(time);
        // A sheet that comes between floor and lamp at time 1.
        const room shade{.walls = {{.shape = ground}, {.shape = sheet(1, 0.4f), .velocity = {4, 0, 0}}}, .lamps = {ceiling_lamp}};
        room coming = shade;
        coming.walls[1].shape.corner.x -= 4;
        const look l = into(coming, {{3, 0.5f, 3}, {-3, -0.5f, -3}}, 5, time);
        CHECK(same(l.light, time == 1 ? glm::vec3(0) : glm::vec3(at_the_origin / pi)));
        for (const seen_ray& each : l.rays.all) CHECK(each.time == time);
        const room mirror{.walls = {{.shape = ground, .made_of = substance::mirror}}, .zenith = glm::vec3(1)};
        const look m = into(mirror, from_above, 5, time);
        REQUIRE(m.rays.all.size() == 2);
        CHECK(m.rays.all[1].time == time);
    }
}

TEST_CASE("no ray is shot for what is black, and no number drawn for a lamp like a point", "[step6]") {
    INFO(hint("time is spent on nothing", "no irradiance, no answer, no weight: no ray. A point_like light takes no ξ", "§6 The ray tracer"));
    const room black{.walls = {{.shape = ground, .color = glm::vec3(0)}}, .lamps = {ceiling_lamp}};
    CHECK(into(black, from_above).rays.all.size() == 1);
    lantern::rectangle turned = ceiling_lamp;
    std::swap(turned.u, turned.v);
    CHECK(into({.walls = {{.shape = ground}}, .lamps = {turned}}, from_above).rays.all.size() == 1);
    CHECK(into({.walls = {{.shape = ground, .made_of = substance::mirror, .color = glm::vec3(0)}}}, from_above).rays.all.size() == 1);
    const look l = into({.walls = {{.shape = ground}}, .points = {{0, 2, 0}}}, from_above);
    CHECK(l.drawn_here.asked.empty());
    CHECK(same(l.light, glm::vec3(1 / pi / 4)));
    CHECK(l.rays.all.size() == 2);
}

// ---- Step 7 --------------------------------------------------------------------------------------------------------

namespace {

/// Where the line enters the box, by slabs; nothing when it misses.
std::optional<double> entry(const lantern::aabb& b, const lantern::ray& r) {
    double near = 0, far = INFINITY;
    for (int i = 0; i < 3; ++i) {
        const double o = r.origin[i], d = r.direction[i];
        if (d == 0) {
            if (o < double(b.min[i]) || o > double(b.max[i])) return std::nullopt;
            continue;
        }
        const double one = (double(b.min[i]) - o) / d, other = (double(b.max[i]) - o) / d;
        near = std::max(near, std::min(one, other));
        far = std::min(far, std::max(one, other));
    }
    return near <= far ? std::optional(near) : std::nullopt;
}

std::optional<float> entered(const lantern::aabb& b, const lantern::ray& r, lantern::interval range = {}) { return entries({b}, r, range)[0]; }

const lantern::aabb cube{{-1, -1, -1}, {1, 1, 1}};

}  // namespace

TEST_CASE("a ray enters a box at its near face", "[step7]") {
    INFO(hint("things vanish behind others, or the tree asks for too much", "the latest of the three entries into the slabs; with a negative direction the upper face comes first", "§7 Your tree"));
    numbers random(8);
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 middle = 5.0f * random.vector(), half{random.between(0.1f, 2), random.between(0.1f, 2), random.between(0.1f, 2)};
        const lantern::aabb b{middle - half, middle + half};
        const glm::vec3 aim = middle + 0.8f * half * random.vector(), origin = middle + 12.0f * random.direction();
        const lantern::ray r{origin, random.between(0.05f, 4) * (aim - origin)};
        const auto t = entered(b, r);
        const auto exact = entry(b, r);
        CAPTURE(b.min, b.max, r.origin, r.direction);
        REQUIRE(exact.has_value());
        REQUIRE(t.has_value());
        REQUIRE(double(*t) <= *exact);
        REQUIRE(double(*t) >= *exact * (1 - 1e-5));
    }
}

TEST_CASE("along an axis the other two slabs have nothing to say", "[step7]") {
    INFO(hint("boxes vanish for rays along an axis", "where the direction's component is 0 the ray does not enter the slab anywhere: 0 times infinity is NaN", "§7 Your tree"));
    for (int axis = 0; axis < 3; ++axis)
        for (const float sign : {1.0f, -1.0f})
            for (const float zero : {0.0f, -0.0f}) {
                glm::vec3 direction(zero), origin(0.25f);
                direction[axis] = 2 * sign;
                origin[axis] = -5 * sign;
                CAPTURE(direction, origin);
                const auto t = entered(cube, {origin, direction});
                REQUIRE(t.has_value());
                CHECK(*t == Approx(2));
                CHECK(*t <= 2);
                origin[(axis + 1) % 3] = 1;  // within a face
                CHECK(entered(cube, {origin, direction}).has_value());
                origin[(axis + 1) % 3] = 3;
                CHECK_FALSE(entered(cube, {origin, direction}).has_value());
            }
}

TEST_CASE("from inside a ray enters at once", "[step7]") {
    INFO(hint("what is around the eye is met too late or not at all", "never earlier than range.min: that is where it begins", "§7 Your tree"));
    for (const glm::vec3 direction : {glm::vec3(1, 0, 0), glm::vec3(-0.3f, 0.5f, 0.2f), glm::vec3(0, 0, -7)}) {
        const auto t = entered(cube, {{0.5f, 0.25f, -0.5f}, direction});
        REQUIRE(t.has_value());
        CHECK(*t == 0);
    }
}

TEST_CASE("a box that is missed, lies behind, or beyond the range is not entered", "[step7]") {
    INFO(hint("every node is opened: the tree is slower than no tree", "lantern::overlaps(box, ray, range) says whether", "§7 Your tree"));
    CHECK_FALSE(entered(cube, {{-5, 1.5f, 0}, {1, 0, 0}}).has_value());
    CHECK_FALSE(entered(cube, {{-5, 0, 0}, {-1, 0, 0}}).has_value());
    CHECK_FALSE(entered(cube, {{-5, 0, 0}, {1, 0, 0}}, {0, 3.5f}).has_value());
    CHECK(entered(cube, {{-5, 0, 0}, {1, 0, 0}}, {0, 4.5f}).has_value());
    CHECK_FALSE(entered({}, {{-5, 0, 0}, {1, 0, 0}}).has_value());
}

TEST_CASE("with your tree the closest hit is the one of brute force", "[step7]") {
    INFO(hint("holes, or things before others", "offer what the tree offers, and hand back what remains", "§7 Your tree"));
    numbers random(9);
    std::vector<lantern::sphere> balls;
    std::vector<lantern::aabb> boxes;
    for (int i = 0; i < 40; ++i) {
        balls.push_back({3.0f * random.vector(), random.between(0.2f, 0.8f)});
        boxes.push_back(lantern::bounds(balls.back()));
    }
    int hits = 0, asked_of_all = 0;
    for (int i = 0; i < 60; ++i) {
        const lantern::ray r{8.0f * random.direction(), {0, 0, 0}};
        const lantern::ray aimed{r.origin, 2.0f * random.vector() - r.origin};
        std::optional<float> expected, found;
        for (const auto& b : balls)
            if (const auto h = lantern::intersect(b, aimed, {0, expected.value_or(lantern::infinity)})) expected = h->t;
        traverse(boxes, aimed, {}, [&](std::uint32_t k, lantern::interval rest) -> lantern::interval {
            ++asked_of_all;
            if (k >= balls.size()) return lantern::interval{0, 0};
            const auto h = lantern::intersect(balls[k], aimed, rest);
            if (!h) return rest;
            found = h->t;
            return lantern::interval{rest.min, h->t};
        });
        CAPTURE(aimed.origin, aimed.direction);
        CHECK(found == expected);
        hits += expected ? 1 : 0;
    }
    CHECK(hits > 30);
    CHECK(asked_of_all < 60 * 8);  // about three of 40 for each ray; brute force asks 2400 times
}

TEST_CASE("a surface that leaves nothing of the range is the last to be offered", "[step7]") {
    INFO(hint("shadow rays that go on after the first hit", "what offer answers is handed to the traversal: return offer(i, rest)", "§7 Your tree"));
    const std::vector<lantern::aabb> row{{{1, -1, -1}, {2, 1, 1}}, {{3, -1, -1}, {4, 1, 1}}, {{5, -1, -1}, {6, 1, 1}}};
    std::vector<std::uint32_t> offered;
    const auto all = [&](std::uint32_t k, lantern::interval rest) {
        offered.push_back(k);
        return rest;
    };
    traverse(row, {{0, 0, 0}, {1, 0, 0}}, {}, all);
    CHECK(offered == std::vector<std::uint32_t>{0, 1, 2});
    offered.clear();
    traverse(row, {{0, 0, 0}, {1, 0, 0}}, {}, [&](std::uint32_t k, lantern::interval) {
        offered.push_back(k);
        return lantern::interval{0, 0};
    });
    CHECK(offered == std::vector<std::uint32_t>{0});
}

// ---- Step 8 --------------------------------------------------------------------------------------------------------

namespace {

stage marbles(bool opened, bool moving, bool blurred) {
    stage s{.marbles = {{.center = {-0.8f, 0, -4}, .radius = 0.7f, .color = {0.9f, 0.2f, 0.1f}},
                        {.center = {0.8f, 0.1f, -5}, .radius = 0.8f, .color = {0.1f, 0.5f, 0.9f}},
                        {.center = {0, 0.9f, -6}, .radius = 0.5f, .shines = true, .color = {4, 3, 2}}},
            .from = {.eye = {0, 0.1f, 0}, .axes = glm::mat3{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}, .half = {0.45f, 0.3f}, .lens = glm::vec2(0, 5), .exposure = glm::vec2(0, 1)}};
    if (opened) s.from.lens = glm::vec2(0.1f, 5);
    if (moving) s.marbles[1].velocity = {0.5f, 0, 0};
    if (blurred) s.marbles[1].width = 0.3f;
    return s;
}

constexpr glm::uvec2 small{9, 6};

/// Numbers that depend on what they are for alone.
draw sure(notes& n) {
    return [&n](std::uint32_t dimensions, std::uint32_t p, std::uint32_t which, std::span<const std::uint32_t> path) {
        n.asked.push_back({dimensions, p, which, {path.begin(), path.end()}});
        return glm::vec2(0.1f + 0.07f * float(p), 0.9f - 0.09f * float(p));
    };
}

/// A pixel's first entry is the distance, three times, or the eye where nothing was met.
int pixels_with_marbles(const visited& v) {
    int count = 0;
    for (std::size_t i = 0; i < v.seen.size(); i += 3) count += v.seen[i].x == v.seen[i].y && v.seen[i].y == v.seen[i].z ? 1 : 0;
    return count;
}

const std::array<glm::bvec3, 8> all_kinds{{{false, false, false}, {true, false, false}, {false, true, false}, {true, true, false},
                                           {false, false, true}, {true, false, true}, {false, true, true}, {true, true, true}}};

}  // namespace

TEST_CASE("what a scene does not need is not in its types", "[step8]") {
    INFO(hint("a scene without a lens is visited with a lens", "radius 0: pinhole; no velocity: still and instant; no width: sharp", "§8 Leaving out"));
    for (const auto& kind : all_kinds) {
        CAPTURE(kind.x, kind.y, kind.z);
        notes n;
        const visited v = left_out(marbles(kind.x, kind.y, kind.z), false, small, sure(n));
        CHECK(v.lens == kind.x);
        CHECK(v.motion == kind.y);
        CHECK(v.shutter == kind.y);
        CHECK(v.blur == kind.z);
    }
}

TEST_CASE("no number is drawn for what was left out", "[step8]") {
    INFO(hint("time and numbers are spent on effects that are not there", "hand the smaller types to visit, not the whole scene", "§8 Leaving out"));
    for (const auto& kind : all_kinds) {
        CAPTURE(kind.x, kind.y, kind.z);
        notes n;
        left_out(marbles(kind.x, kind.y, kind.z), false, small, sure(n));
        CHECK(n.of(purpose::film) == small.x * small.y);
        CHECK(n.of(purpose::lens) == (kind.x ? small.x * small.y : 0));
        CHECK(n.of(purpose::time) == (kind.y ? small.x * small.y : 0));
        CHECK((n.of(purpose::gloss) > 0) == kind.z);
    }
}

TEST_CASE("the picture is the same, to the last bit", "[step8]") {
    INFO(hint("the picture changes with what is left out", "leaving out is no approximation: what is dropped is 0, and the rest is carried over", "§8 Leaving out"));
    for (const auto& kind : all_kinds) {
        CAPTURE(kind.x, kind.y, kind.z);
        notes n, m;
        const stage s = marbles(kind.x, kind.y, kind.z);
        const visited less = left_out(s, false, small, sure(n)), more = left_out(s, true, small, sure(m));
        REQUIRE(less.seen.size() == 3 * small.x * small.y);
        REQUIRE(pixels_with_marbles(more) > 15);
        CHECK(identical(less.seen, more.seen));
    }
}

TEST_CASE("smaller types take less room", "[step8]") {
    INFO(hint("nothing is saved", "still, sharp, pinhole and instant have no members", "§8 Leaving out"));
    notes n;
    const visited least = left_out(marbles(false, false, false), false, small, sure(n)), most = left_out(marbles(true, true, true), false, small, sure(n));
    CHECK(least.thing_size < most.thing_size);
    CHECK(least.camera_size + 4 * sizeof(float) == most.camera_size);
}

TEST_CASE("one thing among many that needs it is enough", "[step8]") {
    INFO(hint("the one ball that moves stands still, wherever it is in the list", "look at all of them; any velocity but 0 counts, backwards too", "§8 Leaving out"));
    for (std::size_t at = 0; at < 2; ++at)
        for (const glm::vec3 velocity : {glm::vec3(-0.5f, 0, 0), glm::vec3(0, 0, 1e-6f)}) {
            CAPTURE(at, velocity);
            stage s = marbles(false, false, false);
            s.marbles[at].velocity = velocity;
            s.marbles[at].width = 0.01f;
            notes n;
            const visited v = left_out(s, false, {1, 1}, sure(n));
            CHECK(v.motion);
            CHECK(v.blur);
        }
    stage lantern_moves = marbles(false, false, false);
    lantern_moves.marbles[2].velocity = {0, 1, 0};  // it shines, and has no coat
    notes n;
    const visited v = left_out(lantern_moves, false, {1, 1}, sure(n));
    CHECK(v.motion);
    CHECK_FALSE(v.blur);
}
