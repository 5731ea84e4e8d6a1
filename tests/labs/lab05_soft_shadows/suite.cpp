// SPDX-License-Identifier: MIT
// Lab 05: lights with area, and the shadows that they cast.

#include "contract.hpp"

#include <catch.hpp>
#include <hint.hpp>

#include <lantern/exact.hpp>
#include <lantern/exact_light.hpp>
#include <lantern/samples.hpp>

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>
#include <vector>

using namespace contract::lab05;

namespace {

constexpr float pi = std::numbers::pi_v<float>;

/// One and a half by one, three above the floor, facing down.
const lamp ceiling{{-0.75f, 3, -0.5f}, {0, 0, 1}, {-1.5f, 0, 0}, {10, 20, 40}};

lantern::hit floor_at(glm::vec3 point) { return {1, point, {0, 1, 0}, 0}; }

/// side² points, one in each cell of a grid. The suite owns them, so every run sees the same.
std::vector<glm::vec2> points(std::uint32_t side, std::uint64_t seed = 5) {
    const lantern::jittered grid{.side = side, .seed = seed};
    std::vector<glm::vec2> result;
    for (std::uint32_t i = 0; i < grid.count(); ++i) result.push_back(grid.at({0, 0}, i).draw2(lantern::purpose::light));
    return result;
}

lantern::exact::parallelogram exactly(const lamp& l) {
    return {glm::dvec3(l.corner), glm::dvec3(l.edge_u), glm::dvec3(l.edge_v)};
}

}  // namespace

// ---- Step 1: a point on the lamp -----------------------------------------------------------------------------------

TEST_CASE("the corners of the square become the corners of the lamp", "[step1]") {
    INFO(hint("the lamp stands in the wrong place, or is too small", "xi runs from 0 to 1: corner + ξ edge_u + ξ' edge_v", "§1 A point on the lamp"));
    const glm::vec3 a = ceiling.corner, u = ceiling.edge_u, v = ceiling.edge_v;
    CHECK(glm::length(point_on(ceiling, {0, 0}) - a) <= 1e-6f);
    CHECK(glm::length(point_on(ceiling, {1, 0}) - (a + u)) <= 1e-6f);
    CHECK(glm::length(point_on(ceiling, {0, 1}) - (a + v)) <= 1e-6f);
    CHECK(glm::length(point_on(ceiling, {1, 1}) - (a + u + v)) <= 1e-6f);
}

TEST_CASE("the two numbers move the point along two edges", "[step1]") {
    INFO(hint("only a diagonal of the lamp shines", "one of the two numbers is used twice", "§1 A point on the lamp"));
    const glm::vec3 p = point_on(ceiling, {0.25f, 0.75f}), expected{-0.75f - 1.125f, 3, -0.25f};
    CHECK(glm::length(p - expected) <= 1e-6f);
}

// ---- Step 2: what one point of the lamp stands for -----------------------------------------------------------------

TEST_CASE("a small lamp straight above gives L A / d²", "[step2]") {
    INFO(hint("too bright or too dark, and wrong when the lamp is moved", "radiance times area over the distance squared; the area is |edge_u × edge_v|",
              "§2 What one point stands for"));
    const lamp small{{-0.01f, 2, -0.02f}, {0, 0, 0.04f}, {0.02f, 0, 0}, {3, 5, 7}};
    const lamp down{{0.01f, 2, -0.02f}, {0, 0, 0.04f}, {-0.02f, 0, 0}, {3, 5, 7}};
    const glm::vec3 up_there{0, 2, 0};
    CHECK(irradiance(down, up_there, {0, 0, 0}, {0, 1, 0}).y == Approx(5 * 0.0008 / 4).epsilon(1e-5));
    CHECK(irradiance(down, {0, 2, 0}, {0, -2, 0}, {0, 1, 0}).z == Approx(7 * 0.0008 / 16).epsilon(1e-5));
    CHECK(irradiance(small, {0, 2, 0}, {0, 4, 0}, {0, -1, 0}).x == Approx(3 * 0.0008 / 4).epsilon(1e-5));
}

TEST_CASE("light that falls in askew is spread over more surface", "[step2]") {
    INFO(hint("a ball looks flat", "the cosine between the surface's normal and the direction to the lamp is missing, or the direction is not of unit length",
              "§2 Two cosines"));
    const glm::vec3 on_lamp{-1, 3, 0}, straight = glm::normalize(on_lamp);
    const float full = irradiance(ceiling, on_lamp, {0, 0, 0}, straight).x;
    REQUIRE(full > 0);
    for (const float angle : {0.3f, 0.8f, 1.4f}) {
        CAPTURE(angle);
        const glm::vec3 across = glm::normalize(glm::cross(straight, glm::vec3(0, 0, 1)));
        const glm::vec3 normal = std::cos(angle) * straight + std::sin(angle) * across;
        CHECK(irradiance(ceiling, on_lamp, {0, 0, 0}, normal).x == Approx(full * std::cos(angle)).epsilon(1e-4));
    }
}

TEST_CASE("a lamp seen askew shows less of itself", "[step2]") {
    INFO(hint("the floor is too bright far from the lamp", "the cosine between the lamp's normal and the direction to the surface is missing",
              "§2 Two cosines"));
    // A surface that always faces the point of the lamp: only the lamp's cosine and the distance are left.
    const glm::vec3 on_lamp{0, 3, 0};
    for (const float x : {0.0f, 2.0f, 5.0f, 20.0f}) {
        CAPTURE(x);
        const glm::vec3 position{x, 0, 0}, normal = glm::normalize(on_lamp - position);
        const float d2 = x * x + 9, cosine = 3 / std::sqrt(d2);
        CHECK(irradiance(ceiling, on_lamp, position, normal).x == Approx(10 * 1.5f * cosine / d2).epsilon(1e-4));
    }
}

TEST_CASE("nothing shines through the back of a surface or of the lamp", "[step2]") {
    INFO(hint("light where there should be none, or light that is negative and eats other light", "a cosine below 0 means 0; neither abs nor a bare product",
              "§2 Two cosines"));
    CHECK(irradiance(ceiling, {-1, 3, 0}, {0, 0, 0}, {0, -1, 0}) == glm::vec3(0));  // the floor's lower side
    CHECK(irradiance(ceiling, {-1, 3, 0}, {0, 5, 0}, {0, -1, 0}) == glm::vec3(0));  // above the lamp
    CHECK(irradiance(ceiling, {-1, 3, 0}, {0, 5, 0}, {0, 1, 0}) == glm::vec3(0));   // both at once: minus by minus
}

TEST_CASE("the mean over the lamp is Lambert's formula", "[step2]") {
    INFO(hint("the light is off by a factor", "compare with L A cos θ cos θ' / d², point by point", "§2 What one point stands for"));
    // The oracle is exact for a polygon (Lambert 1760); a grid of 64 × 64 midpoints is within 1e-4 of the integral here.
    const glm::vec3 position{0.4f, 0, 0.2f}, normal = glm::normalize(glm::vec3(0.2f, 1, -0.1f));
    double sum = 0;
    for (int i = 0; i < 64; ++i)
        for (int j = 0; j < 64; ++j) {
            const glm::vec2 xi{(float(i) + 0.5f) / 64, (float(j) + 0.5f) / 64};
            const glm::vec3 on_lamp = ceiling.corner + xi.x * ceiling.edge_u + xi.y * ceiling.edge_v;
            sum += double(irradiance(ceiling, on_lamp, position, normal).x) / 4096;
        }
    const auto shape = lantern::exact::corners(exactly(ceiling));
    const double exact = 10 * lantern::exact::irradiance(glm::dvec3(position), glm::dvec3(normal), shape);
    CHECK(sum == Approx(exact).epsilon(1e-3));
}

// ---- Step 3: the shadow ray ----------------------------------------------------------------------------------------

TEST_CASE("a ball in between hides the lamp, one aside does not", "[step3]") {
    INFO(hint("no shadows, or nothing but shadow", "ask `blocked` for the ray from the hit to the point of the lamp", "§3 The shadow ray"));
    CHECK(visible(floor_at({0, 0, 0}), {0, 3, 0}, {}));
    CHECK(visible(floor_at({0, 0, 0}), {0, 3, 0}, {{lantern::sphere{{2, 1.5f, 0}, 0.5f}}, {}}));
    CHECK_FALSE(visible(floor_at({0, 0, 0}), {0, 3, 0}, {{lantern::sphere{{0, 0.6f, 0}, 0.5f}}, {}}));
    CHECK_FALSE(visible(floor_at({0, 0, 0}), {0, 3, 0}, {{lantern::sphere{{0, 2.2f, 0}, 0.5f}}, {}}));
    CHECK_FALSE(visible(floor_at({0, 0, 0}), {0, 3, 0}, {{}, {lantern::rectangle{{-1, 1, -1}, {2, 0, 0}, {0, 0, 2}}}}));
}

TEST_CASE("what stands behind the lamp casts no shadow", "[step3]") {
    INFO(hint("dark spots, though nothing is in between", "the shadow ray must end at the lamp: t up to 1 when the direction is the whole way, up to the distance when it has unit length",
              "§3 Where it ends"));
    const scene ceiling_above{{}, {lantern::rectangle{{-9, 3.5f, -9}, {18, 0, 0}, {0, 0, 18}}}};
    CHECK(visible(floor_at({0, 0, 0}), {0, 3, 0}, ceiling_above));
    CHECK(visible(floor_at({0, 0, 0}), {0, 3, 0}, {{lantern::sphere{{0, 5, 0}, 1}}, {}}));
    // And what stands close before it does.
    CHECK_FALSE(visible(floor_at({0, 0, 0}), {0, 3, 0}, {{}, {lantern::rectangle{{-9, 2.9f, -9}, {18, 0, 0}, {0, 0, 18}}}}));
    CHECK_FALSE(visible(floor_at({0, 0, 0}), {0, 0.3f, 0}, {{}, {lantern::rectangle{{-9, 0.2f, -9}, {18, 0, 0}, {0, 0, 18}}}}));
}

TEST_CASE("what stands behind the surface casts no shadow", "[step3]") {
    INFO(hint("everything is dark", "the ray looks in the wrong direction, or backwards (negative t)", "§3 The shadow ray"));
    CHECK(visible(floor_at({0, 0, 0}), {0, 3, 0}, {{lantern::sphere{{0, -2, 0}, 1}}, {}}));
}

TEST_CASE("a surface does not shade itself, at any scale", "[step3]") {
    INFO(hint("dark speckles on lit surfaces (acne)", "the shadow ray starts on the surface, and rounding puts it below: start at lantern::leave(hit, direction)",
              "§3 Where it starts"));
    for (const float scale : {1e-3f, 1.0f, 1e6f})
        for (int i = 0; i < 500; ++i) {
            const glm::vec3 center = scale * glm::vec3(3, 1, -2), on_lamp = scale * glm::vec3(9, 40, 17);
            const lantern::sphere ball{center, scale};
            const float turn = 0.7f * float(i), up = 1 - float(i) / 501;
            const glm::vec3 out{std::sqrt(1 - up * up) * std::cos(turn), up, std::sqrt(1 - up * up) * std::sin(turn)};
            const lantern::ray from_outside{center + 7 * scale * out, -out};
            const auto h = intersect(ball, from_outside, lantern::interval{});
            REQUIRE(h.has_value());
            if (glm::dot(h->normal, on_lamp - h->point) <= 0.01f * scale) continue;
            CAPTURE(scale, i);
            REQUIRE(visible(*h, on_lamp, {{ball}, {}}));
        }
}

TEST_CASE("a thing that touches the surface casts its shadow up to the point of contact", "[step3]") {
    INFO(hint("things seem to float: a light rim between a thing and its shadow",
              "the shadow ray starts too far away: no constant such as 0.001 fits every scene, lantern::leave does", "§3 Where it starts"));
    for (const float scale : {1e-4f, 1.0f, 1e5f}) {
        CAPTURE(scale);
        // A thin board that stands on the floor at z = 0; the lamp is low behind it.
        const scene board{{}, {lantern::rectangle{scale * glm::vec3(-1, 0, 0), scale * glm::vec3(2, 0, 0), scale * glm::vec3(0, 1, 0)}}};
        CHECK_FALSE(visible(floor_at(scale * glm::vec3(0, 0, 1e-4f)), scale * glm::vec3(0, 0.5f, -1), board));
    }
}

// ---- Step 4: the mean over the lamp --------------------------------------------------------------------------------

TEST_CASE("without anything in the way the mean is the whole lamp's light", "[step4]") {
    INFO(hint("brightness changes with the number of samples", "divide by the number of all points", "§4 The mean"));
    const auto shape = lantern::exact::corners(exactly(ceiling));
    const double exact = lantern::exact::irradiance({0.5, 0, 0.5}, {0, 1, 0}, shape);
    for (const std::uint32_t side : {4u, 8u, 16u}) {
        const glm::vec3 light = soft_light(ceiling, floor_at({0.5f, 0, 0.5f}), {}, points(side));
        CAPTURE(side);
        // Jittered on a smooth integrand: the standard error is below 0.3 % at 16 points; 4 % are more than 10 of them.
        CHECK(light.x == Approx(10 * exact).epsilon(0.04));
        CHECK(light.z == Approx(40 * exact).epsilon(0.04));
    }
}

TEST_CASE("the penumbra is what the edge leaves of the lamp", "[step4]") {
    INFO(hint("the shadow's border is hard, or has the wrong width or brightness",
              "for every point of the lamp a shadow ray of its own; a hidden one adds nothing, but counts in the division", "§4 The penumbra"));
    // A board between lamp and floor covers x < 0, as far as anyone can see. Its edge runs along z at height 1.
    const scene board{{}, {lantern::rectangle{{-500, 1, -500}, {500, 0, 0}, {0, 0, 1000}}}};
    const lantern::exact::edge rim{{0, 1, 0}, {0, 0, 1}};
    const auto shape = exactly(ceiling);
    for (const float x : {-0.5f, 0.3f, 0.45f, 0.6f, 0.75f, 0.9f, 1.5f}) {
        CAPTURE(x);
        const glm::dvec3 at{x, 0, 0.2};
        const glm::vec3 light = soft_light(ceiling, floor_at(glm::vec3(at)), board, points(32));
        const double exact = 10 * lantern::exact::penumbra(at, {0, 1, 0}, rim, shape);
        const double all = lantern::exact::irradiance(at, {0, 1, 0}, lantern::exact::corners(shape));
        // 1024 jittered points: at most 32 cells are cut by the edge, a standard error of at most √32/2/1024 = 0.3 % of the
        // whole; 2 % are 7 of them: a false alarm in 1e11.
        CHECK(std::abs(double(light.x) - exact) <= 0.02 * 10 * all + 1e-6);
    }
}

TEST_CASE("in the umbra there is no light at all, and no points give none either", "[step4]") {
    INFO(hint("not a number, or light in the deepest shadow", "hidden points add nothing; check for an empty list before you divide", "§4 The mean"));
    const scene roof{{}, {lantern::rectangle{{-50, 1, -50}, {100, 0, 0}, {0, 0, 100}}}};
    CHECK(soft_light(ceiling, floor_at({0, 0, 0}), roof, points(8)) == glm::vec3(0));
    CHECK(soft_light(ceiling, floor_at({0, 0, 0}), {}, {}) == glm::vec3(0));
}

// ---- Step 5: how large a ball looks --------------------------------------------------------------------------------

TEST_CASE("a ball seen from its surface fills half of all directions", "[step5]") {
    INFO(hint("a factor of 2, or of π", "the cap of a unit sphere has the area 2π (1 - cos θ)", "§5 The solid angle"));
    CHECK(solid_angle({0, 0, 0}, 1, {0, 0, 1.0000001f}) == Approx(2 * pi).epsilon(2e-3));
    CHECK(solid_angle({0, 0, 0}, 1, {0, 0, 2}) == Approx(2 * pi * (1 - std::sqrt(0.75))).epsilon(1e-4));
    CHECK(solid_angle({5, 1, 0}, 2, {5, 1, -4}) == Approx(2 * pi * (1 - std::sqrt(0.75))).epsilon(1e-4));
}

TEST_CASE("a small and distant ball is no smaller than it is", "[step5]") {
    INFO(hint("a distant sun gives no light at all, or light in steps", "1 - √(1 - s²) has no digits left for small s: it equals s² / (1 + √(1 - s²))",
              "§5 Without losing digits"));
    for (const float distance : {1e2f, 1e4f, 1e6f, 1e9f}) {
        CAPTURE(distance);
        CHECK(solid_angle({0, distance, 0}, 1, {0, 0, 0}) * distance * distance == Approx(pi).epsilon(1e-3));
    }
}

// ---- Step 6: a direction towards the ball --------------------------------------------------------------------------

TEST_CASE("directions have unit length and reach the ball", "[step6]") {
    INFO(hint("samples are wasted beside the ball, or the light is too weak", "the cone's border is where sin θ = R / d; at xi.x = 0 the direction goes to the centre",
              "§6 The cone"));
    const glm::vec3 center{1, 2, -3}, from{-2, 0.5f, 1};
    const lantern::sphere ball{center, 1.5f};
    for (const glm::vec2 xi : points(20)) {
        const glm::vec3 d = towards_ball(center, 1.5f, from, xi);
        CAPTURE(xi.x, xi.y);
        REQUIRE(glm::length(d) == Approx(1).epsilon(1e-5));
        REQUIRE(intersect(ball, lantern::ray{from, d}, lantern::interval{}).has_value());
    }
    CHECK(glm::length(towards_ball(center, 1.5f, from, {0, 0.3f}) - glm::normalize(center - from)) <= 1e-5f);
}

TEST_CASE("the whole cone is filled, up to the ball's border, evenly", "[step6]") {
    INFO(hint("the light is too strong in the middle of the ball", "in a cone it is cos θ, not θ, that is uniform: 1 - cos θ = ξ (1 - cos θmax)", "§6 The cone"));
    const glm::vec3 center{0, 4, 0}, from{0, 0, 0};
    const float largest = 1 - std::sqrt(1 - 0.25f);  // 1 - cos of the cone's half angle: R/d = 1/2
    for (const float xi : {0.1f, 0.25f, 0.5f, 0.75f, 1.0f}) {
        CAPTURE(xi);
        const glm::vec3 d = towards_ball(center, 2, from, {xi, 0.4f});
        CHECK((1 - d.y) / largest == Approx(xi).epsilon(1e-3));
    }
}

TEST_CASE("the second number goes once round the axis", "[step6]") {
    INFO(hint("one side of the ball gives no light", "the angle round the axis is 2π ξ'", "§6 The cone"));
    const glm::vec3 center{0, 4, 0};
    glm::vec3 sum{0};
    for (int i = 0; i < 8; ++i) sum += towards_ball(center, 2, {0, 0, 0}, {0.8f, float(i) / 8});
    CHECK(std::abs(sum.x) <= 1e-4f);
    CHECK(std::abs(sum.z) <= 1e-4f);
    const glm::vec3 a = towards_ball(center, 2, {0, 0, 0}, {0.8f, 0}), b = towards_ball(center, 2, {0, 0, 0}, {0.8f, 0.25f});
    const glm::vec2 pa{a.x, a.z}, pb{b.x, b.z};
    CHECK(std::abs(glm::dot(pa, pb)) <= 1e-4f);
}

TEST_CASE("the mean of L Ω cos θ over the ball is π L (R/d)² cos θ", "[step6]") {
    INFO(hint("a round lamp is too bright or too dark", "the directions do not cover the cone evenly, or the cone is not the ball's", "§6 The cone"));
    // Exact for a ball above the horizon. Ω is taken from its formula here, not from step 5.
    const glm::vec3 center{1, 3, 0.5f}, normal{0, 1, 0};
    const float radius = 1.2f, d = glm::length(center), s2 = radius * radius / (d * d);
    const double omega = 2 * pi * double(s2) / (1 + std::sqrt(1 - double(s2)));
    double sum = 0;
    const auto grid = points(32);
    for (const glm::vec2 xi : grid) sum += double(glm::dot(normal, towards_ball(center, radius, {0, 0, 0}, xi)));
    const double mean = omega * sum / double(grid.size());
    CHECK(mean == Approx(pi * double(s2) * double(center.y / d)).epsilon(1e-3));  // jittered: standard error below 1e-4
}
