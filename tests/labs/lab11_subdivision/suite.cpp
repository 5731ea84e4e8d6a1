// SPDX-License-Identifier: MIT
// Lab 11: space cut into cells. The truth is brute force over all cells, all planes, all surfaces; every structure that a step is given was
// made here, and everything that a student's code visits or offers is counted here.

#include "contract.hpp"
#include "truth.hpp"

#include <catch.hpp>
#include <hint.hpp>
#include <numbers.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

using namespace contract::lab11;
using truth::cell_box, truth::cost_of, truth::least_cost, truth::wide;

namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

// ---- Cells, in double ----------------------------------------------------------------------------------------------

std::uint32_t cells_in(const lattice& g) { return std::uint32_t(g.count.x) * std::uint32_t(g.count.y) * std::uint32_t(g.count.z); }

cell_box cell_of(const lattice& g, std::uint32_t number) {
    const int k = int(number);
    const glm::dvec3 at(k % g.count.x, k / g.count.x % g.count.y, k / g.count.x / g.count.y), low(g.box.min), extent = glm::dvec3(g.box.max) - low;
    return {low + extent * at / glm::dvec3(g.count), low + extent * (at + 1.0) / glm::dvec3(g.count)};
}

/// The stretch of the ray in the closed box, within the range.
std::optional<stretch> stretch_in(const cell_box& box, const ray& r, interval range) {
    double enter = range.min, leave = range.max;
    for (int axis = 0; axis < 3; ++axis) {
        const double o = r.origin[axis], d = r.direction[axis];
        if (d == 0) {
            if (o < box.min[axis] || o > box.max[axis]) return std::nullopt;
            continue;
        }
        const double a = (box.min[axis] - o) / d, b = (box.max[axis] - o) / d;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    if (!(enter <= leave)) return std::nullopt;
    return stretch{enter, leave};
}

/// The largest distance of a point from the box, along one axis, in units of the whole's size. Not below any bound for NaN.
double outside(const cell_box& box, const cell_box& whole, const glm::dvec3& p) {
    double most = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double size = std::max({whole.max.x - whole.min.x, whole.max.y - whole.min.y, whole.max.z - whole.min.z});
        const double beyond = std::max(box.min[axis] - p[axis], p[axis] - box.max[axis]) / size;
        most = std::isnan(beyond) ? INFINITY : std::max(most, beyond);
    }
    return most;
}

// ---- What a walk did -----------------------------------------------------------------------------------------------

struct visit {
    std::uint32_t cell;
    stretch part;
};

/// Writes down what is visited. A walk that does not end is stopped, and found out by its length.
class recorder {
public:
    explicit recorder(std::size_t rays, std::size_t most = 5000) : visits_(rays), most_(most) {}

    /// `answer` says what remains of the range.
    template <class Answer>
    [[nodiscard]] visitor listening(interval range, Answer answer) {
        remaining_.assign(visits_.size(), range);
        return [this, answer](std::uint32_t r, std::uint32_t cell, stretch part) -> interval {
            auto& seen = visits_.at(r);
            if (seen.size() >= most_) return {0, 0};
            seen.push_back({cell, part});
            return remaining_[r] = answer(r, cell, part, remaining_[r]);
        };
    }
    [[nodiscard]] visitor listening(interval range) {
        return listening(range, [](std::uint32_t, std::uint32_t, stretch, interval remaining) { return remaining; });
    }
    [[nodiscard]] const std::vector<visit>& operator[](std::size_t r) const { return visits_[r]; }

private:
    std::vector<std::vector<visit>> visits_;
    std::vector<interval> remaining_;
    std::size_t most_;
};

/// What is wrong with a chain of visits along a ray, in words; nothing when it covers the ray's whole stretch in the box without a gap, each
/// part within its cell. `cell` tells a cell's box; float may have rounded.
template <class Cell>
std::string flaw(const std::vector<visit>& seen, std::uint32_t cells, Cell cell, const cell_box& whole, const ray& r, interval range) {
    const auto expected = stretch_in(whole, r, range);
    if (!expected) return seen.empty() ? "" : "cells were visited though the ray misses the box";
    // A ray that touches the box in a point may be held for one that misses it.
    const double t_size = std::max(std::abs(expected->enter), std::abs(expected->leave)), slack = 2e-6 * t_size;
    if (seen.empty()) return expected->leave - expected->enter > slack ? "no cell was visited" : "";
    const auto apart = [&](double a, double b) { return !(std::abs(a - b) <= slack); };
    if (apart(seen.front().part.enter, expected->enter))
        return "the first cell is entered at t = " + std::to_string(seen.front().part.enter) + " instead of " + std::to_string(expected->enter);
    if (apart(seen.back().part.leave, expected->leave))
        return "the last cell is left at t = " + std::to_string(seen.back().part.leave) + " instead of " + std::to_string(expected->leave);
    std::vector<std::uint32_t> numbers;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const auto& [number, part] = seen[i];
        const std::string which = "visit " + std::to_string(i) + ", of cell " + std::to_string(number) + ": ";
        if (number >= cells) return which + "there is no such cell";
        if (!(part.enter <= part.leave + slack)) return which + "it is left before it is entered";
        if (i > 0 && apart(part.enter, seen[i - 1].part.leave)) return which + "it is entered where the one before was not left";
        const glm::dvec3 middle = glm::dvec3(r.origin) + 0.5 * (part.enter + part.leave) * glm::dvec3(r.direction);
        if (!(outside(cell(number), whole, middle) <= 2e-6)) return which + "the ray is not in it there";
        numbers.push_back(number);
    }
    std::ranges::sort(numbers);
    if (std::ranges::adjacent_find(numbers) != numbers.end())
        return "cell " + std::to_string(*std::ranges::adjacent_find(numbers)) + " was visited twice";
    return "";
}

// ---- Spheres, and the closest of them ------------------------------------------------------------------------------

struct ball {
    glm::vec3 center;
    float radius;
};

aabb box_of(const ball& b) { return {b.center - b.radius, b.center + b.radius}; }

std::vector<aabb> boxes_of(const std::vector<ball>& balls) {
    std::vector<aabb> boxes;
    for (const ball& b : balls) boxes.push_back(box_of(b));
    return boxes;
}

/// What remains of the range when the ray has been tested against the sphere.
interval tested(const ball& b, const ray& r, interval range) {
    const glm::dvec3 d(r.direction), o = glm::dvec3(r.origin) - glm::dvec3(b.center);
    const double a = glm::dot(d, d), half = glm::dot(o, d), c = glm::dot(o, o) - double(b.radius) * double(b.radius), disc = half * half - a * c;
    if (!(disc >= 0)) return range;
    for (const double t : {(-half - std::sqrt(disc)) / a, (-half + std::sqrt(disc)) / a})
        if (contains(range, float(t))) return {range.min, float(t)};
    return range;
}

float closest_of_all(const std::vector<ball>& balls, const ray& r, interval range = {}) {
    for (const ball& b : balls) range = tested(b, r, range);
    return range.max;
}

bool same_t(float a, float b) { return a == b || std::abs(a - b) <= 1e-5f * std::abs(b); }

std::vector<ball> cloud(numbers& random, int count, float reach, float least, float most) {
    std::vector<ball> balls;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 center = reach * random.vector();
        balls.push_back({center, random.between(least, most)});
    }
    return balls;
}

aabb around(const std::vector<aabb>& boxes) {
    aabb all;
    for (const aabb& box : boxes) all = enclose(all, box);
    return all;
}

// ---- Rays ----------------------------------------------------------------------------------------------------------

glm::vec3 point_in(numbers& random, const aabb& box) {
    const float x = random.between(box.min.x, box.max.x), y = random.between(box.min.y, box.max.y);
    return {x, y, random.between(box.min.z, box.max.z)};
}

/// From inside and outside, to a point inside; directions of any length.
std::vector<ray> towards(numbers& random, const aabb& box, int count) {
    std::vector<ray> rays;
    const glm::vec3 middle = center(box), half = 0.5f * (box.max - box.min);
    for (int i = 0; i < count; ++i) {
        const glm::vec3 origin = i % 3 == 0 ? point_in(random, box) : middle + 3.0f * half * random.vector();
        rays.push_back({origin, random.between(0.1f, 4) * (point_in(random, box) - origin)});
    }
    return rays;
}

/// Rays that meet the planes at x, y, z = 0, 1, 2 ... of a box from (0, 0, 0) to `high` in all the awkward ways.
std::vector<ray> awkward(glm::vec3 high) {
    const float nought = -0.0f;
    return {
        // Along one axis, both ways, through the middle of cells; the other components 0 and -0.
        {{-1, 0.5f, 0.5f}, {1, 0, 0}}, {{-1, 0.5f, 0.5f}, {1, nought, nought}}, {{high.x + 2, 1.5f, 0.5f}, {-1, 0, nought}},
        {{0.5f, -3, 1.5f}, {0, 2, 0}}, {{1.5f, high.y + 1, 0.5f}, {nought, -0.25f, nought}}, {{0.5f, 0.5f, -1}, {nought, 0, 1}},
        {{1.5f, 1.5f, high.z + 1}, {0, nought, -1}},
        // Within the planes between cells, and within the edges.
        {{-1, 1, 0.5f}, {1, 0, 0}}, {{-1, 1, 0.5f}, {1, nought, 0}}, {{high.x + 1, 1, 1}, {-1, nought, nought}}, {{1, -1, 1}, {0, 1, 0}},
        {{1, high.y + 1, 1}, {nought, -1, nought}}, {{1, 1, -1}, {0, 0, 1}}, {{1, -0.5f, 0.25f}, {0, 1, 0.5f}}, {{1, -0.5f, 0.25f}, {nought, 1, 0.5f}},
        // Within the outermost planes.
        {{-1, 0, 0.5f}, {1, 0, 0}}, {{-1, 0, 0.5f}, {1, nought, nought}}, {{-1, high.y, 0.5f}, {1, 0, 0}}, {{-1, high.y, 0.5f}, {1, nought, 0}},
        {{-1, 0, 0}, {1, 0, 0}}, {{-1, 0, 0}, {1, nought, nought}}, {{0, -1, 0.5f}, {nought, 1, 0}}, {{high.x, high.y + 1, high.z}, {0, -1, nought}},
        // Through corners, on diagonals.
        {{-1, -1, -1}, {1, 1, 1}}, {{3, 3, 3}, {-1, -1, -1}}, {{-1, -1, 0.5f}, {1, 1, 0}}, {{-1, -1, 0.5f}, {0.5f, 0.5f, nought}}, {{-1, 3, 0.5f}, {1, -1, 0}},
        {{3, 0.5f, -1}, {-1, nought, 1}}, {{0.5f, -1, -1}, {0, 1, 1}}, {{-1, 3, -1}, {1, -1, 1}}, {{-2, -1, 0.5f}, {2, 1, 0}}, {{-2, -1, -2}, {2, 1, 2}},
        {{4, 2, 0.25f}, {-2, -1, 0}}, {{0.5f, 3, 3}, {nought, -1, -1}},
        // From points on planes, edges and corners, and from within a cell.
        {{0, 0, 0}, {1, 1, 1}}, {{0, 0, 0}, {1, 0.25f, 0.125f}}, {high, -high}, {{1, 1, 1}, {1, 0, 0}}, {{1, 1, 1}, {-1, 0.5f, 0}}, {{1, 1, 1}, {-1, -1, -1}}, {{1, 0.5f, 0.5f}, {1, 0, 0}},
        {{1, 0.5f, 0.5f}, {-1, 0, 0}}, {{0, 0.5f, 0.5f}, {1, 0.125f, 0}}, {{high.x, 0.5f, 0.5f}, {-1, 0.125f, 0}}, {{1.25f, 0.75f, 0.5f}, {1, 1, 0.25f}},
        {{1.25f, 0.75f, 0.5f}, {-1, -1, -0.25f}}, {{1.25f, 0.75f, 0.5f}, {0, nought, -1}},
        // Past the box, and away from it.
        {{-1, -1, 0.5f}, {1, 0, 0}}, {{-1, 0.5f, 0.5f}, {-1, 0, 0}}, {{-1, high.y + 1, 0.5f}, {1, 0.5f, 0}}, {{0.5f, high.y + 0.5f, 0.5f}, {0, 0, 1}},
    };
}

/// Many rays, one question each: where it fails, the first ray is shown.
template <class Flaw>
void check_rays(const std::vector<ray>& rays, Flaw flaw_of) {
    for (std::size_t k = 0; k < rays.size(); ++k) {
        const std::string wrong = flaw_of(k);
        CAPTURE(k, rays[k].origin, rays[k].direction, wrong);
        REQUIRE(wrong.empty());
    }
}

}  // namespace

// ---- Step 1: how many cells ----------------------------------------------------------------------------------------

namespace {

double cells_of_all(glm::ivec3 count) { return double(count.x) * double(count.y) * double(count.z); }

}  // namespace

TEST_CASE("there are nearly as many cells as asked for, and not more", "[step1]") {
    INFO(hint("the grid eats all memory, or is one large cell",
              "choose the side s of a cell so that the box holds `wanted` cubes of it; then divide, and round down", "§1 The side of a cell"));
    numbers random(1);
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 low = 10.0f * random.vector(), extent{random.between(1, 9), random.between(1, 9), random.between(1, 9)};
        const auto surfaces = std::uint32_t(random.between(100, 20000));
        const float each = random.between(1, 10);
        const glm::ivec3 count = resolution({low, low + extent}, surfaces, each);
        const double wanted = double(surfaces) * double(each);
        CAPTURE(extent, surfaces, each, count);
        REQUIRE((count.x >= 1 && count.y >= 1 && count.z >= 1));
        REQUIRE(cells_of_all(count) <= wanted * 1.0001);
        REQUIRE(cells_of_all(count) >= wanted / 8 * 0.9999);
    }
}

TEST_CASE("cells are as nearly cubes as whole numbers allow", "[step1]") {
    INFO(hint("rays along the short side of the scene pass through far too many cells",
              "the same side s for all three axes, not the same number of cells", "§1 The side of a cell"));
    numbers random(2);
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 extent{random.between(1, 4), random.between(1, 4), random.between(1, 4)};
        const glm::ivec3 count = resolution({-extent, extent}, 5000, 8);
        const glm::vec3 side = extent / glm::vec3(count);
        CAPTURE(extent, count, side);
        // With four cells or more on each side, rounding down makes none of them longer than 5/4 of s.
        REQUIRE((count.x >= 4 && count.y >= 4 && count.z >= 4));
        REQUIRE(std::max({side.x, side.y, side.z}) <= 1.26f * std::min({side.x, side.y, side.z}));
    }
}

TEST_CASE("where the scene is thinner than a cell, the other axes share the cells", "[step1]") {
    INFO(hint("a terrain gets a handful of cells, or billions",
              "an axis with extent <= s gets one cell, and s is computed again from the other axes alone", "§1 Thin scenes"));
    const auto check = [](glm::vec3 extent, glm::bvec3 thick) {
        const glm::ivec3 count = resolution({glm::vec3(-1), extent - 1.0f}, 1000, 8);
        CAPTURE(extent, count);
        CHECK(cells_of_all(count) <= 8001);
        CHECK(cells_of_all(count) >= 999);
        for (int axis = 0; axis < 3; ++axis) {
            if (thick[axis]) CHECK(count[axis] > 30);
            else CHECK(count[axis] == 1);
        }
    };
    check({64, 64, 0.25f}, {true, true, false});
    check({0, 64, 32}, {false, true, true});
    check({64, 0, 0.003f}, {true, false, false});
    check({0, 0, 64}, {false, false, true});
    check({64, 0.001f, 0.0001f}, {true, false, false});
}

TEST_CASE("a point, or nothing at all, is one cell", "[step1]") {
    INFO(hint("a crash, or endless building, with a scene of one point or none",
              "the volume is 0, and nothing may be divided by it", "§1 Thin scenes"));
    CHECK(resolution({{1, 2, 3}, {1, 2, 3}}, 1000, 8) == glm::ivec3(1));
    CHECK(resolution({{0, 0, 0}, {1, 1, 1}}, 0, 8) == glm::ivec3(1));
    CHECK(resolution({}, 0, 8) == glm::ivec3(1));
}

TEST_CASE("scenes may be as small as an atom or as large as the sky", "[step1]") {
    INFO(hint("large scenes get one cell, small ones too many",
              "the product of three extents is no float: compute in double", "§1 The side of a cell"));
    for (const float scale : {1e-15f, 1.0f, 1e15f}) {
        INFO("scale := " << scale);
        CHECK(resolution({glm::vec3(0), scale * glm::vec3(2.05f, 1.05f, 3.05f)}, 750, 8) == glm::ivec3(19, 10, 29));
    }
}

// ---- Step 2: the cells of a box ------------------------------------------------------------------------------------

TEST_CASE("a box is in every cell that it overlaps, and in no other", "[step2]") {
    INFO(hint("pieces of surfaces are missing, cut off along straight lines",
              "from the cell of the box's lower corner to the cell of its upper corner", "§2 From corner to corner"));
    numbers random(3);
    const lattice g{{{-3, 1, 20}, {4, 2.5f, 26}}, {9, 4, 7}};
    for (int i = 0; i < 400; ++i) {
        const glm::vec3 a = point_in(random, g.box), b = glm::mix(a, point_in(random, g.box), random.between(0, 1));
        const aabb box{glm::min(a, b), glm::max(a, b)};
        const auto [first, last] = cells_of(g, box);
        CAPTURE(i, box.min, box.max, first, last);
        for (std::uint32_t k = 0; k < cells_in(g); ++k) {
            const cell_box cell = cell_of(g, k);
            const int at = int(k);
            const glm::ivec3 c{at % 9, at / 9 % 4, at / 36};
            const bool in = glm::all(glm::lessThanEqual(first, c)) && glm::all(glm::lessThanEqual(c, last));
            const glm::dvec3 gap = glm::max(cell.min - glm::dvec3(box.max), glm::dvec3(box.min) - cell.max);
            const double distance = std::max({gap.x, gap.y, gap.z});  // negative where they overlap
            if (std::abs(distance) < 1e-5) continue;                  // touches, but for rounding
            CAPTURE(c);
            REQUIRE(in == (distance < 0));
        }
    }
}

TEST_CASE("what touches a cell is in it", "[step2]") {
    INFO(hint("a wall that lies between two cells is seen from one side only",
              "touching counts: first = ceil(x) - 1, last = floor(x), where x counts in cells", "§2 Touching"));
    const lattice g{{{0, 0, 0}, {8, 4, 2}}, {8, 4, 2}};
    const auto check = [&](const aabb& box, glm::ivec3 first, glm::ivec3 last) {
        const cell_range cells = cells_of(g, box);
        CAPTURE(box.min, box.max);
        CHECK(cells.first == first);
        CHECK(cells.last == last);
    };
    check({{3, 1.5f, 0.5f}, {3, 1.5f, 0.5f}}, {2, 1, 0}, {3, 1, 0});  // a point on a face
    check({{3, 1, 1}, {3, 1, 1}}, {2, 0, 0}, {3, 1, 1});              // on a corner of eight cells
    check({{3, 0.25f, 0.25f}, {3, 3.75f, 1.75f}}, {2, 0, 0}, {3, 3, 1});  // a wall
    check({{2, 1, 0}, {5, 3, 1}}, {1, 0, 0}, {5, 3, 1});
    check({{0.5f, 0.5f, 0.5f}, {2, 3.5f, 1.5f}}, {0, 0, 0}, {2, 3, 1});
}

TEST_CASE("what lies at the end of the grid is in its last cell", "[step2]") {
    INFO(hint("a crash, or surfaces missing at the edge of the scene", "there is no cell -1 and no cell `count`: clamp", "§2 Touching"));
    const lattice g{{{0, 0, 0}, {8, 4, 2}}, {8, 4, 2}};
    for (const aabb& box : {aabb{{8, 4, 2}, {8, 4, 2}}, {{7.5f, 3.5f, 1.5f}, {8, 4, 2}}, {{8, 3.5f, 1.5f}, {8, 3.75f, 2}}}) {
        CAPTURE(box.min, box.max);
        CHECK(cells_of(g, box).first == glm::ivec3(7, 3, 1));
        CHECK(cells_of(g, box).last == glm::ivec3(7, 3, 1));
    }
    CHECK(cells_of(g, {{0, 0, 0}, {0, 0, 0}}).first == glm::ivec3(0));
    CHECK(cells_of(g, {{0, 0, 0}, {0, 0, 0}}).last == glm::ivec3(0));
    CHECK(cells_of(g, g.box).first == glm::ivec3(0));
    CHECK(cells_of(g, g.box).last == glm::ivec3(7, 3, 1));
    // A flat lattice has one cell along that axis.
    CHECK(cells_of({{{0, 5, 0}, {8, 5, 8}}, {8, 1, 8}}, {{1.5f, 5, 2.5f}, {3.5f, 5, 2.75f}}).last == glm::ivec3(3, 0, 2));
}

TEST_CASE("a face is where it is, however many there are", "[step2]") {
    INFO(hint("a single surface is missing, in large grids only",
              "1 / side is rounded; in double, (x - min) * count / extent gives a whole number where x is at a face", "§2 Multiply, then divide"));
    numbers random(4);
    for (int i = 0; i < 2000; ++i) {
        // A lattice from 0 to a * b in a * c cells: face number j * c is at j * b, for whole numbers all.
        const int a = 1 + int(random.between(0, 20)), b = 1 + int(random.between(0, 30)), c = 1 + int(random.between(0, 30));
        const int j = int(random.between(0, float(a)));
        const lattice g{{{0, 0, 0}, {float(a * b), 1, 1}}, {a * c, 1, 1}};
        const glm::vec3 p{float(j * b), 0.5f, 0.5f};
        const auto [first, last] = cells_of(g, {p, p});
        CAPTURE(g.box.max.x, g.count.x, p.x, first, last);
        REQUIRE(first.x == std::max(j * c - 1, 0));
        REQUIRE(last.x == j * c);
    }
}

// ---- Step 3: a walk through the grid -------------------------------------------------------------------------------

namespace {

/// Walks, and checks every ray's chain of cells.
void check_walks(const lattice& g, const std::vector<ray>& rays, interval range) {
    recorder seen(rays.size());
    walk_grid(g, rays, range, seen.listening(range));
    check_rays(rays, [&](std::size_t k) {
        return flaw(seen[k], cells_in(g), [&](std::uint32_t number) { return cell_of(g, number); }, wide(g.box), rays[k], range);
    });
}

/// Of each cell the balls whose boxes touch it, by brute force.
std::vector<std::vector<std::uint32_t>> sorted_into(const lattice& g, const std::vector<ball>& balls) {
    std::vector<std::vector<std::uint32_t>> cells(cells_in(g));
    for (std::uint32_t k = 0; k < cells.size(); ++k) {
        const cell_box cell = cell_of(g, k);
        for (std::uint32_t i = 0; i < balls.size(); ++i) {
            const cell_box box = wide(box_of(balls[i]));
            const glm::dvec3 gap = glm::max(cell.min - box.max, box.min - cell.max);
            if (std::max({gap.x, gap.y, gap.z}) <= 1e-9) cells[k].push_back(i);
        }
    }
    return cells;
}

}  // namespace

TEST_CASE("a walk passes the cells that the ray passes, each once, in order", "[step3]") {
    INFO(hint("holes in the picture, or the wrong surface in front",
              "leave the cell through the face whose t is the smallest of the three, and step along that axis", "§3 The next face"));
    numbers random(5);
    const lattice g{{{-3, 1, 20}, {4, 2.5f, 26}}, {9, 4, 7}};
    check_walks(g, towards(random, g.box, 300), {});
    check_walks({{{-1, -1, -1}, {1, 1, 1}}, {1, 1, 1}}, towards(random, {{-1, -1, -1}, {1, 1, 1}}, 30), {});
}

TEST_CASE("a walk goes backwards as well as forwards", "[step3]") {
    INFO(hint("half of the picture is missing, as if looked at through a corner",
              "a ray with d < 0 leaves through the lower face, and its next cell is the one below", "§3 Backwards"));
    const lattice g{{{0, 0, 0}, {4, 4, 4}}, {4, 4, 4}};
    std::vector<ray> rays;
    for (const float x : {-1.0f, 1.0f})
        for (const float y : {-1.0f, 1.0f})
            for (const float z : {-1.0f, 1.0f}) {
                const glm::vec3 d{x, 0.7f * y, 0.4f * z};
                rays.push_back({glm::vec3(2.1f, 1.9f, 2.2f) - 5.0f * d, d});
                rays.push_back({{2.1f, 1.9f, 2.2f}, d});
            }
    check_walks(g, rays, {});
}

TEST_CASE("along planes, through edges and corners the walk stays with the ray", "[step3]") {
    INFO(hint("specks and lines are missing, where the camera looks along an axis or a diagonal",
              "d = 0, of either sign, never leaves by that axis: 0 / 0 is not a number; of equal ts any may be taken, but one of the smallest", "§3 Along an axis"));
    const lattice g{{{0, 0, 0}, {4, 3, 2}}, {4, 3, 2}};
    const auto rays = awkward({4, 3, 2});
    check_walks(g, rays, {});
}

TEST_CASE("the walk keeps within the range", "[step3]") {
    INFO(hint("surfaces behind the eye are tested, and shadow rays go on behind the lamp",
              "begin where the ray is at the later of range.min and the box, and end at range.max", "§3 Where it begins"));
    numbers random(6);
    const lattice g{{{-3, 1, 20}, {4, 2.5f, 26}}, {9, 4, 7}};
    for (const interval range : {interval{0, 0.5f}, {0.25f, 0.6f}, {0.4f, infinite}, {0, 1e-3f}}) check_walks(g, towards(random, g.box, 60), range);
}

TEST_CASE("four thousand cells on, the walk is still where the ray is", "[step3]") {
    INFO(hint("far away the surfaces come apart",
              "adding the t of a cell up, thousands of times, adds up its rounding; compute each from the number of the face", "§3 Never add up"));
    const lattice g{{{0, 0, 0}, {5000, 11, 11}}, {5000, 11, 11}};
    const std::vector<ray> rays{{{-1, 0.3f, 0.7f}, {1, 0.00211f, 0.00199f}}, {{5003, 0.3f, 10.7f}, {-3.1f, 0.0063f, -0.006f}}, {{0.1f, 10.9f, 0.2f}, {0.7f, -0.0015f, 0.0014f}}};
    recorder seen(rays.size(), 20000);
    walk_grid(g, rays, {}, seen.listening({}));
    check_rays(rays, [&](std::size_t k) {
        return flaw(seen[k], cells_in(g), [&](std::uint32_t number) { return cell_of(g, number); }, wide(g.box), rays[k], {});
    });
}

TEST_CASE("the walk ends in the cell where the hit is, and not before", "[step3]") {
    INFO(hint("what is behind is seen through what is in front, near the borders of cells",
              "a surface reaches into many cells; the hit found in one of them may lie in another, with something else before it", "§3 A hit elsewhere"));
    numbers random(7);
    const lattice g{{{-3, 1, 20}, {4, 2.5f, 26}}, {9, 4, 7}};
    const auto rays = towards(random, g.box, 200);
    std::vector<float> hits;
    for (const ray& r : rays) {
        const auto whole = stretch_in(wide(g.box), r, {});
        hits.push_back(whole ? float(glm::mix(whole->enter, whole->leave, double(random.between(0.02f, 0.98f)))) : 1);
    }
    // The very first cell says where the hit is.
    recorder seen(rays.size());
    walk_grid(g, rays, {}, seen.listening({}, [&](std::uint32_t r, std::uint32_t, stretch, interval remaining) { return interval{remaining.min, hits[r]}; }));
    check_rays(rays, [&](std::size_t k) -> std::string {
        if (seen[k].empty()) return stretch_in(wide(g.box), rays[k], {}) ? "nothing was visited" : "";
        const stretch last = seen[k].back().part;
        const double slack = 2e-6 * (std::abs(last.leave) + 1);
        if (!(last.leave >= double(hits[k]) - slack))
            return "the walk ends at t = " + std::to_string(last.leave) + ", before the hit at " + std::to_string(hits[k]);
        if (!(last.enter <= double(hits[k]) + slack))
            return "a cell was entered at t = " + std::to_string(last.enter) + ", behind the hit at " + std::to_string(hits[k]);
        return "";
    });
}

TEST_CASE("when nothing remains, no further cell is visited", "[step3]") {
    INFO(hint("shadow rays cost as much as any other", "an empty range means stop", "§3 A hit elsewhere"));
    numbers random(8);
    const lattice g{{{0, 0, 0}, {8, 8, 8}}, {8, 8, 8}};
    const auto rays = towards(random, g.box, 50);
    recorder all(rays.size()), some(rays.size());
    walk_grid(g, rays, {}, all.listening({}));
    walk_grid(g, rays, {}, some.listening({}, [&](std::uint32_t r, std::uint32_t, stretch, interval remaining) {
        return some[r].size() >= 3 ? interval{0, 0} : remaining;
    }));
    for (std::size_t k = 0; k < rays.size(); ++k) CHECK(some[k].size() == std::min<std::size_t>(all[k].size(), 3));
}

TEST_CASE("through the grid, the closest hit is the closest of all", "[step3]") {
    INFO(hint("the picture differs from that of brute force",
              "no cell too few, none in the wrong order, and not the end before the hit lies in the cell", "§3 A hit elsewhere"));
    numbers random(9);
    const aabb box{{-1, -1, -1}, {5, 4, 3}};
    const lattice g{box, {6, 5, 4}};
    std::vector<ball> balls;
    for (int i = 0; i < 40; ++i) balls.push_back({point_in(random, {glm::vec3(0), glm::vec3(4, 3, 2)}), random.between(0.1f, 0.9f)});
    const auto cells = sorted_into(g, balls);
    std::vector<ray> rays = towards(random, box, 300);
    for (const ray& r : awkward({4, 3, 2})) rays.push_back(r);
    std::vector<float> found(rays.size(), infinite);
    recorder seen(rays.size());
    walk_grid(g, rays, {}, seen.listening({}, [&](std::uint32_t r, std::uint32_t cell, stretch, interval remaining) {
        if (cell < cells.size())
            for (const std::uint32_t i : cells[cell]) remaining = tested(balls[i], rays[r], remaining);
        found[r] = remaining.max;
        return remaining;
    }));
    check_rays(rays, [&](std::size_t k) -> std::string {
        const float expected = closest_of_all(balls, rays[k]);
        return same_t(found[k], expected) ? "" : "found t = " + std::to_string(found[k]) + " instead of " + std::to_string(expected);
    });
}

// ---- Step 4: a surface in many cells -------------------------------------------------------------------------------

namespace {

using numbers_of = std::vector<std::uint32_t>;

/// In which order the surfaces of several cells are offered, and what remains. `answer` says what an offer leaves.
template <class Answer>
std::pair<numbers_of, std::vector<interval>> offered(const std::vector<numbers_of>& cells, interval range, Answer answer) {
    numbers_of order;
    const auto remaining = offer_all(cells, range, [&](std::uint32_t i, interval rest) {
        if (order.size() < 10000) order.push_back(i);
        return answer(i, rest);
    });
    return {order, remaining};
}
interval same(std::uint32_t, interval range) { return range; }

}  // namespace

TEST_CASE("every surface is offered, in the order of the cells", "[step4]") {
    INFO(hint("surfaces are missing", "offer each number in the list, but for those that were just offered", "§4 The mailbox"));
    CHECK(offered({{3, 1, 4}, {}, {7, 5}}, {}, same).first == numbers_of{3, 1, 4, 7, 5});
    CHECK(offered({{0}}, {}, same).first == numbers_of{0});
    CHECK(offered({{}, {}}, {}, same).first.empty());
    numbers_of many(1000);
    std::iota(many.begin(), many.end(), 0u);
    CHECK(offered({many}, {}, same).first == many);
}

TEST_CASE("a surface in many cells is offered once", "[step4]") {
    INFO(hint("right, but slow: large surfaces are intersected in each cell",
              "look the number up in `recent.last` before you offer it, and write it there when you do", "§4 The mailbox"));
    CHECK(offered({{5}, {5}, {5, 6}, {6, 5}, {5}}, {}, same).first == numbers_of{5, 6});
    CHECK(offered({{1, 2, 3}, {3, 2, 1, 4}, {4, 1, 8}, {0, 8, 2}}, {}, same).first == numbers_of{1, 2, 3, 4, 8, 0});
    // Nobody is among the last eight twice, whatever the lists.
    numbers random(10);
    std::vector<numbers_of> cells(300);
    for (auto& cell : cells)
        for (int i = 0; i < 5; ++i) cell.push_back(std::uint32_t(random.between(0, 16)));
    const numbers_of order = offered(cells, {}, same).first;
    REQUIRE(order.size() >= 16);
    for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t k = i >= 8 ? i - 8 : 0; k < i; ++k) {
            CAPTURE(i, k);
            REQUIRE(order[k] != order[i]);
        }
}

TEST_CASE("eight numbers fit into the mailbox", "[step4]") {
    INFO(hint("right, but slower than it could be", "the next number goes where the oldest one was: at = (at + 1) % 8", "§4 The mailbox"));
    const numbers_of eight{10, 11, 12, 13, 14, 15, 16, 17};
    CHECK(offered({eight, eight, {17, 10}}, {}, same).first == eight);
    const numbers_of order = offered({eight, {18}, {11, 12, 13, 14, 15, 16, 17, 18}}, {}, same).first;
    CHECK(order == numbers_of{10, 11, 12, 13, 14, 15, 16, 17, 18});
}

TEST_CASE("each ray has a mailbox of its own", "[step4]") {
    INFO(hint("the first pixel is right and all others are empty",
              "nothing that was offered to one ray has been offered to the next: no static, no global", "§4 The mailbox"));
    for (int r = 0; r < 3; ++r) CHECK(offered({{1, 2}, {2, 3}}, {}, same).first == numbers_of{1, 2, 3});
}

TEST_CASE("each offer gets what the one before has left", "[step4]") {
    INFO(hint("what lies behind is seen", "range = to(i, range), and return it", "§4 What remains"));
    std::vector<float> given;
    const auto [order, remaining] = offered({{0, 1}, {}, {2}}, {0.5f, 100}, [&](std::uint32_t i, interval rest) {
        given.push_back(rest.max);
        return i == 1 ? rest : interval{rest.min, rest.max / 2};
    });
    CHECK(order == numbers_of{0, 1, 2});
    CHECK(given == std::vector<float>{100, 50, 50});
    REQUIRE(remaining.size() == 3);
    CHECK(remaining[0].max == 50);
    CHECK(remaining[1].max == 50);
    CHECK(remaining[2].max == 25);
    CHECK(remaining[2].min == 0.5f);
}

TEST_CASE("when nothing remains, nothing is offered", "[step4]") {
    INFO(hint("shadow rays cost as much as any other", "ask empty(range) before each offer", "§4 What remains"));
    const auto [order, remaining] = offered({{4, 5, 6}, {7, 8}}, {}, [](std::uint32_t i, interval rest) { return i == 5 ? interval{0, 0} : rest; });
    CHECK(order == numbers_of{4, 5});
    REQUIRE(remaining.size() == 2);
    CHECK(empty(remaining[1]));
    CHECK(offered({{1, 2}}, {2, 1}, same).first.empty());
}

// ---- Step 5: an octree ---------------------------------------------------------------------------------------------

namespace {

bool touch(const aabb& a, const aabb& b) {
    return glm::all(glm::lessThanEqual(a.min, b.max)) && glm::all(glm::lessThanEqual(b.min, a.max));
}

aabb octant(const aabb& cell, std::uint32_t number) {
    const glm::vec3 middle = center(cell);
    const glm::bvec3 upper(number & 1, number >> 1 & 1, number >> 2 & 1);
    return {glm::mix(cell.min, middle, upper), glm::mix(middle, cell.max, upper)};
}

/// What is wrong with an octree, in words. It is walked with what the rules say, not with what its nodes do.
struct inspection {
    std::span<const aabb> boxes;
    const octree& tree;
    std::uint32_t leaf_size, max_depth;
    std::string wrong_form{}, wrong_leaf{}, wrong_division{};
    std::size_t nodes = 0, entries = 0;

    void look() {
        if (tree.nodes.empty()) {
            wrong_form = "there is no root";
            return;
        }
        numbers_of all(boxes.size());
        std::iota(all.begin(), all.end(), 0u);
        look(0, tree.cell, all, 0);
    }

private:
    void look(std::uint32_t at, const aabb& cell, const numbers_of& inside, std::uint32_t depth) {
        if (!wrong_form.empty() || ++nodes > tree.nodes.size()) return;
        const auto where = [&] { return "node " + std::to_string(at) + " at depth " + std::to_string(depth) + " with " + std::to_string(inside.size()) + " surfaces: "; };
        const octree_node n = tree.nodes[at];
        std::array<numbers_of, 8> parts;
        std::size_t sum = 0;
        for (std::uint32_t k = 0; k < 8; ++k) {
            for (const std::uint32_t i : inside)
                if (touch(boxes[i], octant(cell, k))) parts[k].push_back(i);
            sum += parts[k].size();
        }
        const bool small = inside.size() <= leaf_size, deep = depth >= max_depth, useless = sum >= 4 * inside.size();
        if (n.children == 0) {
            entries += n.size;
            if (!small && !deep && !useless && wrong_division.empty())
                wrong_division = where() + "a leaf, though its octants would hold " + std::to_string(sum) + " only";
            if (n.size > tree.entries.size() || n.first > tree.entries.size() - n.size) {
                wrong_form = where() + "its entries are not there";
                return;
            }
            numbers_of held(tree.entries.begin() + std::ptrdiff_t(n.first), tree.entries.begin() + std::ptrdiff_t(n.first + n.size));
            std::ranges::sort(held);
            if (held != inside && wrong_leaf.empty())
                wrong_leaf = where() + "it holds " + std::to_string(held.size()) + (held.size() == inside.size() ? ", but others" : "");
            return;
        }
        if ((small || deep || useless) && wrong_division.empty())
            wrong_division = where() + "divided, though " + (small ? "it has no more than a leaf may have" : deep ? "it is as deep as may be" : "its octants hold " + std::to_string(sum));
        if (n.children <= at || n.children > tree.nodes.size() || tree.nodes.size() - n.children < 8) {
            wrong_form = where() + "its children are not there";
            return;
        }
        if (depth > 60) {
            wrong_form = where() + "too deep";
            return;
        }
        for (std::uint32_t k = 0; k < 8; ++k) look(n.children + k, octant(cell, k), parts[k], depth + 1);
    }
};

inspection inspect(const std::vector<aabb>& boxes, std::uint32_t leaf_size, std::uint32_t max_depth, octree& tree) {
    tree = build_octree(boxes, leaf_size, max_depth);
    inspection i{boxes, tree, leaf_size, max_depth};
    i.look();
    return i;
}

std::vector<std::pair<std::string, std::vector<aabb>>> octree_scenes() {
    numbers random(11);
    std::vector<std::pair<std::string, std::vector<aabb>>> scenes;
    scenes.push_back({"a cloud", boxes_of(cloud(random, 300, 1, 0.01f, 0.1f))});
    std::vector<aabb> floor, huge, cubes;
    for (int i = 0; i < 200; ++i) {
        const glm::vec3 p = random.vector() * glm::vec3(1, 0, 1);
        floor.push_back({p, p + glm::vec3(0.05f, 0, 0.08f)});
        const glm::vec3 tiny = 0.25f + 0.01f * random.vector();
        huge.push_back({tiny, tiny + 0.0005f});
    }
    huge.push_back({glm::vec3(-1), glm::vec3(1)});
    for (int i = 0; i < 64; ++i) {
        const glm::vec3 p(i % 4, i / 4 % 4, i / 16);
        cubes.push_back({p, p + 1.0f});  // each touches its neighbours
    }
    scenes.push_back({"a floor", floor});
    scenes.push_back({"huge among tiny", huge});
    scenes.push_back({"cubes side by side", cubes});
    return scenes;
}

}  // namespace

TEST_CASE("eight octants have numbers: x + 2 y + 4 z", "[step5]") {
    INFO(hint("pieces of the scene change places, or are missing",
              "bit 0 of the number says which half along x, bit 1 along y, bit 2 along z", "§5 Eight octants"));
    const aabb cell{{0, 10, 100}, {2, 14, 108}};
    CHECK(octant_of(cell, 0).min == glm::vec3(0, 10, 100));
    CHECK(octant_of(cell, 0).max == glm::vec3(1, 12, 104));
    CHECK(octant_of(cell, 1).min == glm::vec3(1, 10, 100));
    CHECK(octant_of(cell, 1).max == glm::vec3(2, 12, 104));
    CHECK(octant_of(cell, 2).min == glm::vec3(0, 12, 100));
    CHECK(octant_of(cell, 4).min == glm::vec3(0, 10, 104));
    CHECK(octant_of(cell, 6).min == glm::vec3(0, 12, 104));
    CHECK(octant_of(cell, 6).max == glm::vec3(1, 14, 108));
    CHECK(octant_of(cell, 7).min == glm::vec3(1, 12, 104));
    CHECK(octant_of(cell, 7).max == glm::vec3(2, 14, 108));
}

TEST_CASE("a leaf holds the surfaces whose boxes touch its cell, and no others", "[step5]") {
    INFO(hint("pieces of surfaces are missing, cut off along straight lines",
              "hand a surface to every octant that its box touches, not to that of its centre", "§5 Dividing"));
    for (const auto& [name, boxes] : octree_scenes()) {
        octree tree;
        const inspection i = inspect(boxes, 4, 5, tree);
        CAPTURE(name, i.wrong_form, i.wrong_leaf);
        CHECK(i.wrong_form.empty());
        CHECK(i.wrong_leaf.empty());
        CHECK(tree.cell.min == around(boxes).min);
        CHECK(glm::all(glm::lessThanEqual(around(boxes).max, tree.cell.max)));
    }
}

TEST_CASE("a cell is divided when it holds too many and is not too deep, and when that helps", "[step5]") {
    INFO(hint("the tree is too deep, too shallow, or eats all memory",
              "three reasons to stop: n <= leaf_size; max_depth levels below the root; eight octants with 4 n surfaces or more", "§5 When to stop"));
    for (const auto& [name, boxes] : octree_scenes())
        for (const auto& [leaf_size, max_depth] : {std::pair{1u, 4u}, {8u, 6u}, {3u, 0u}, {20u, 3u}, {1000u, 5u}}) {
            octree tree;
            const inspection i = inspect(boxes, leaf_size, max_depth, tree);
            CAPTURE(name, leaf_size, max_depth, i.wrong_form, i.wrong_division);
            REQUIRE(i.wrong_form.empty());
            REQUIRE(i.wrong_division.empty());
        }
}

TEST_CASE("all in one point, the tree ends at its depth cap", "[step5]") {
    INFO(hint("it never ends, or the memory does", "equal points are never told apart: count the levels", "§5 When to stop"));
    for (const glm::vec3 p : {glm::vec3(0), glm::vec3(0.3f), glm::vec3(0.5f, 0, 0.25f)}) {
        std::vector<aabb> boxes(50, aabb{p, p});
        boxes.push_back({glm::vec3(0), glm::vec3(0)});
        boxes.push_back({glm::vec3(1), glm::vec3(1)});
        octree tree;
        const inspection i = inspect(boxes, 4, 12, tree);
        CAPTURE(p, i.wrong_form, i.wrong_leaf, i.wrong_division, tree.nodes.size());
        CHECK(i.wrong_form.empty());
        CHECK(i.wrong_leaf.empty());
        CHECK(i.wrong_division.empty());
    }
    octree tree;
    const inspection i = inspect(std::vector<aabb>(20, aabb{glm::vec3(0), glm::vec3(1)}), 4, 5, tree);
    CHECK(i.wrong_form.empty());
    CHECK(tree.nodes.size() == 1);  // twenty times the same box: nothing is gained by dividing
}

TEST_CASE("there may be one surface, or none", "[step5]") {
    INFO(hint("a crash in an empty scene", "the root is a leaf, with one entry or none", "§5 When to stop"));
    for (const auto& boxes : {std::vector<aabb>{}, {{{1, 2, 3}, {2, 3, 4}}}}) {
        const octree tree = build_octree(boxes, 8, 12);
        REQUIRE(tree.nodes.size() == 1);
        CHECK(tree.nodes[0].children == 0);
        CHECK(tree.nodes[0].size == boxes.size());
        CHECK(tree.entries.size() == boxes.size());
    }
}

// ---- Step 6: which octants a ray meets -----------------------------------------------------------------------------

namespace {

std::string flaw_of_octants(const aabb& cell, const ray& r, interval range) {
    const auto whole = stretch_in(wide(cell), r, range);
    if (!whole) return "";
    std::vector<visit> seen;
    for (const auto& met : octants_met(cell, r, *whole)) seen.push_back({met.octant, met.part});
    if (seen.empty()) return "no octant";
    if (seen.size() > 4) return std::to_string(seen.size()) + " octants";
    return flaw(seen, 8, [&](std::uint32_t k) { return wide(octant(cell, k)); }, wide(cell), r, range);
}

}  // namespace

TEST_CASE("a ray meets at most four octants, in order", "[step6]") {
    INFO(hint("holes, and surfaces that show through others",
              "the three planes through the middle cut the ray's stretch into at most four parts; sort them by t", "§6 Three planes"));
    numbers random(12);
    const aabb cell{{-3, 1, 20}, {4, 2.5f, 26}};
    const auto rays = towards(random, cell, 500);
    check_rays(rays, [&](std::size_t k) { return flaw_of_octants(cell, rays[k], {}); });
}

TEST_CASE("for rays that run backwards the upper octants come first", "[step6]") {
    INFO(hint("right from one side, wrong from the other",
              "the numbers 0 to 7 are in order only for a ray that runs forwards along all three axes", "§6 In order"));
    const aabb cell{{0, 0, 0}, {2, 2, 2}};
    for (std::uint32_t k = 0; k < 8; ++k) {
        const glm::vec3 sign(k & 1 ? -1 : 1, k & 2 ? -1 : 1, k & 4 ? -1 : 1);
        const glm::vec3 d = sign * glm::vec3(1, 0.9f, 0.8f);
        const ray r{glm::vec3(1.05f, 0.95f, 1.0f) - 3.0f * d, d};
        const std::string wrong = flaw_of_octants(cell, r, {});
        CAPTURE(d, wrong);
        CHECK(wrong.empty());
        const auto whole = stretch_in(wide(cell), r, {});
        REQUIRE(whole);
        const auto met = octants_met(cell, r, *whole);
        REQUIRE(met.size() >= 2);
        CHECK(met.front().octant == k);
        CHECK(met.back().octant == (7 ^ k));
    }
}

TEST_CASE("along planes, through edges and corners the octants are right", "[step6]") {
    INFO(hint("specks and lines are missing, where the camera looks along an axis or a diagonal",
              "d = 0, of either sign, passes no plane: which side it is on, its origin says; through an edge, two planes are passed at once", "§6 Along an axis"));
    const aabb cell{{0, 0, 0}, {2, 2, 2}};
    const auto rays = awkward({2, 2, 2});
    check_rays(rays, [&](std::size_t k) { return flaw_of_octants(cell, rays[k], {}); });
}

TEST_CASE("only the given stretch counts", "[step6]") {
    INFO(hint("surfaces behind the eye, or behind the hit, are tested",
              "a plane that is passed before `part.enter` or after `part.leave` cuts nothing", "§6 Three planes"));
    numbers random(13);
    const aabb cell{{-3, 1, 20}, {4, 2.5f, 26}};
    for (const interval range : {interval{0, 0.5f}, {0.25f, 0.6f}, {0.4f, infinite}, {0, 1e-3f}}) {
        const auto rays = towards(random, cell, 100);
        check_rays(rays, [&](std::size_t k) { return flaw_of_octants(cell, rays[k], range); });
    }
    const auto behind = octants_met({{0, 0, 0}, {2, 2, 2}}, {{1.5f, 1.5f, 1.5f}, {1, 0.5f, 0.25f}}, {0, 0.5});
    REQUIRE(behind.size() == 1);
    CHECK(behind[0].octant == 7);
}

// ---- Step 7: where to cut ------------------------------------------------------------------------------------------

namespace {

void check_cut(const aabb& cell, const std::vector<aabb>& boxes, const costs& c) {
    const auto best = best_cut(cell, boxes, c);
    const double least = least_cost(cell, boxes, c), leaf = double(c.test) * double(boxes.size());
    CAPTURE(cell.min, cell.max, boxes.size(), c.step, c.test, c.empty_bonus, least, leaf);
    if (!(least < leaf * (1 + 1e-6))) {
        REQUIRE_FALSE(best.has_value());
        return;
    }
    if (!best) {
        REQUIRE(least > leaf * (1 - 1e-6));
        return;
    }
    CAPTURE(best->axis, best->at);
    REQUIRE(best->axis < 3);
    const int axis = int(best->axis);
    REQUIRE((best->at > cell.min[axis] && best->at < cell.max[axis]));
    CAPTURE(cost_of(cell, boxes, c, axis, best->at));
    REQUIRE(cost_of(cell, boxes, c, axis, best->at) <= least * (1 + 1e-5));
}

}  // namespace

TEST_CASE("no other cut costs less", "[step7]") {
    INFO(hint("the tree is right, but slow",
              "try both ends of every box, along all three axes, and take the one with the least cost", "§7 The cost of a cut"));
    numbers random(14);
    for (int i = 0; i < 300; ++i) {
        const aabb cell{{-1, 2, 0}, {-1 + random.between(1, 4), 2 + random.between(1, 4), random.between(1, 4)}};
        std::vector<aabb> boxes;
        const int count = 1 + int(random.between(0, 24));
        for (int k = 0; k < count; ++k) {
            const glm::vec3 a = point_in(random, cell), b = glm::mix(a, point_in(random, cell), 0.4f * random.unit());
            boxes.push_back({glm::min(a, b), glm::max(a, b)});
        }
        check_cut(cell, boxes, {1, 4, 0.5f});
    }
}

TEST_CASE("boxes that end at the same planes, and flat ones, are counted where they belong", "[step7]") {
    INFO(hint("the tree is right, but slow where surfaces touch each other",
              "is_below and is_above say who counts where: touching is not reaching", "§7 Who is where"));
    numbers random(15);
    const aabb cell{{0, 0, 0}, {4, 4, 4}};
    for (int i = 0; i < 300; ++i) {
        std::vector<aabb> boxes;
        const int count = 1 + int(random.between(0, 16));
        for (int k = 0; k < count; ++k) {
            const glm::vec3 low = glm::floor(point_in(random, cell));
            boxes.push_back({low, glm::min(low + glm::floor(3.0f * (random.vector() * 0.5f + 0.5f)), glm::vec3(4))});
        }
        check_cut(cell, boxes, {1, 8, 0.25f});
    }
    // Cubes side by side: cut between them.
    const auto best = best_cut({{0, 0, 0}, {2, 1, 1}}, std::vector<aabb>{{{0, 0, 0}, {1, 1, 1}}, {{1, 0, 0}, {2, 1, 1}}}, {1, 8, 0.5f});
    REQUIRE(best.has_value());
    CHECK(best->axis == 0);
    CHECK(best->at == 1);
}

TEST_CASE("large parts count more than small ones", "[step7]") {
    INFO(hint("the tree cuts in the middle, or half and half, instead of around what is there",
              "a ray through the cell passes through a part with probability A_part / A: areas, not volumes, not numbers alone",
              "§7 The cost of a cut"));
    // Thirty small boxes at the left end of a long cell, one at the right end. Cut off the crowd.
    std::vector<aabb> boxes;
    for (int i = 0; i < 30; ++i) {
        const glm::vec3 p{0.02f * float(i), 0.1f + 0.2f * float(i % 5), 0.1f + 0.1f * float(i % 7)};
        boxes.push_back({p, p + 0.1f});
    }
    boxes.push_back({{9, 0, 0}, {10, 1, 1}});
    const aabb cell{{0, 0, 0}, {10, 1, 1}};
    const auto best = best_cut(cell, boxes, {1, 4, 0});
    REQUIRE(best.has_value());
    CHECK(best->axis == 0);
    CHECK(best->at == Approx(0.68));
    check_cut(cell, boxes, {1, 4, 0});
}

TEST_CASE("empty space is cut off", "[step7]") {
    INFO(hint("rays through empty space pass as many cells as others",
              "with no surface on one side the tests cost (1 - empty_bonus) of what they did: less, not more", "§7 Empty space"));
    // All in the right half. Without a bonus it is cheaper to cut among them.
    std::vector<aabb> boxes;
    for (int i = 0; i < 8; ++i) boxes.push_back({{4 + 0.5f * float(i), 0, 0}, {4.5f + 0.5f * float(i), 4, 4}});
    const aabb cell{{0, 0, 0}, {8, 4, 4}};
    const auto with = best_cut(cell, boxes, {1, 4, 0.8f}), without = best_cut(cell, boxes, {1, 4, 0});
    REQUIRE(with.has_value());
    CHECK(with->axis == 0);
    CHECK(with->at == 4);
    REQUIRE(without.has_value());
    CHECK(without->at > 4);
    numbers random(16);
    for (int i = 0; i < 100; ++i) {
        std::vector<aabb> some;
        const aabb part{{random.between(0, 2), random.between(0, 2), random.between(0, 2)}, {random.between(2, 4), random.between(2, 4), random.between(2, 4)}};
        for (int k = 0; k < 6; ++k) {
            const glm::vec3 a = point_in(random, part), b = glm::mix(a, point_in(random, part), 0.5f);
            some.push_back({glm::min(a, b), glm::max(a, b)});
        }
        check_cut({glm::vec3(0), glm::vec3(4)}, some, {1, 4, 0.1f * float(i % 10)});
    }
}

TEST_CASE("no cut is made that does not pay", "[step7]") {
    INFO(hint("the tree is deep, and slower than a shallow one",
              "a leaf costs `test` for each box; when no cut costs less, the answer is nothing", "§7 When to stop"));
    const aabb cell{{0, 0, 0}, {1, 1, 1}};
    const std::vector<aabb> one{{{0.4f, 0.4f, 0.4f}, {0.6f, 0.6f, 0.6f}}}, all(20, cell);
    CHECK_FALSE(best_cut(cell, all, {1, 4, 0.5f}).has_value());
    CHECK_FALSE(best_cut(cell, {}, {1, 4, 0.5f}).has_value());
    CHECK_FALSE(best_cut(cell, one, {10, 4, 0}).has_value());  // a step costs more than the test
    CHECK(best_cut(cell, one, {0.1f, 4, 0.5f}).has_value());
    CHECK_FALSE(best_cut({{0, 0, 0}, {0, 0, 0}}, std::vector<aabb>(5, aabb{{0, 0, 0}, {0, 0, 0}}), {1, 4, 0.5f}).has_value());
    // In one point all, within a cell: cut around the point, never through it for ever.
    const std::vector<aabb> point(10, aabb{{0.5f, 0.5f, 0.5f}, {0.5f, 0.5f, 0.5f}});
    check_cut(cell, point, {1, 4, 0.5f});
}

// ---- Step 8: a walk through the kd-tree ----------------------------------------------------------------------------

namespace {

/// A kd-tree that was cut somehow, and of each node its cell.
struct cut_up {
    kd_tree tree;
    std::vector<aabb> cells;

    [[nodiscard]] bool is_leaf(std::uint32_t at) const { return tree.nodes[at].axis == 3; }

    void divide(std::uint32_t at, std::uint32_t axis, float plane) {
        const auto first = std::uint32_t(tree.nodes.size());
        tree.nodes[at] = {axis, plane, first, 0};
        aabb lower = cells[at], upper = cells[at];
        lower.max[int(axis)] = upper.min[int(axis)] = plane;
        tree.nodes.resize(first + 2, {3, 0, 0, 0});
        cells.push_back(lower);
        cells.push_back(upper);
    }
};

cut_up whole(const aabb& box) { return {{box, {{3, 0, 0, 0}}}, {box}}; }

/// Cut at whole numbers until each cell is a unit cube, in some order.
cut_up into_cubes(glm::vec3 high, numbers& random) {
    cut_up c = whole({glm::vec3(0), high});
    for (std::uint32_t at = 0; at < c.tree.nodes.size(); ++at)
        for (int tries = 0; tries < 20 && c.is_leaf(at); ++tries) {
            const int axis = int(random.between(0, 3));
            const float low = c.cells[at].min[axis], size = c.cells[at].max[axis] - low;
            if (size > 1) c.divide(at, std::uint32_t(axis), low + 1 + std::floor(random.between(0, size - 1)));
        }
    return c;
}

/// Cut at random planes, unevenly.
cut_up at_random(const aabb& box, numbers& random, std::uint32_t nodes) {
    cut_up c = whole(box);
    for (std::uint32_t at = 0; c.tree.nodes.size() < nodes; ++at) {
        const int axis = int(random.between(0, 3));
        c.divide(at, std::uint32_t(axis), glm::mix(c.cells[at].min[axis], c.cells[at].max[axis], random.between(0.1f, 0.9f)));
    }
    return c;
}

/// What is wrong with a walk through the leaves: each that the ray passes must be there once, with its stretch, in order; others may only be touched.
std::string flaw_of_leaves(const cut_up& c, const std::vector<visit>& seen, const ray& r, interval range, double end = INFINITY) {
    const cell_box box = wide(c.tree.box);
    const auto all = stretch_in(box, r, range);
    const double t_size = all ? std::max(std::abs(all->enter), std::abs(all->leave)) : 0, slack = 2e-6 * t_size;
    // Within the plane of a cut the ray is on both sides, and passes the one after the other.
    double sum = 0;
    for (std::uint32_t leaf = 0; leaf < c.tree.nodes.size() && all; ++leaf)
        if (const auto part = stretch_in(wide(c.cells[leaf]), r, range); part && c.is_leaf(leaf)) sum += part->leave - part->enter;
    const bool within_a_plane = all && sum > all->leave - all->enter + slack;
    std::vector<int> times(c.tree.nodes.size());
    double before = -INFINITY;
    for (const auto& [leaf, part] : seen) {
        const std::string which = "leaf " + std::to_string(leaf) + ": ";
        if (leaf >= c.tree.nodes.size() || !c.is_leaf(leaf)) return which + "there is no such leaf";
        if (++times[leaf] > 1) return which + "visited twice";
        if (!all) return which + "visited, though the ray misses the tree";
        if (!(part.enter <= part.leave + slack)) return which + "left before it is entered";
        const glm::dvec3 middle = glm::dvec3(r.origin) + 0.5 * (part.enter + part.leave) * glm::dvec3(r.direction);
        if (!(outside(wide(c.cells[leaf]), box, middle) <= 2e-6))
            return which + "the ray is not in it from t = " + std::to_string(part.enter) + " to " + std::to_string(part.leave);
        if (!within_a_plane && !(part.enter >= before - slack)) return which + "it comes too late";
        if (part.enter > end + slack) return which + "it lies behind the hit";
        before = part.enter;
    }
    for (std::uint32_t leaf = 0; leaf < c.tree.nodes.size(); ++leaf) {
        const auto part = stretch_in(wide(c.cells[leaf]), r, range);
        if (!c.is_leaf(leaf) || !part || part->leave - part->enter <= 2 * slack || part->enter > end - slack) continue;
        const std::string which = "leaf " + std::to_string(leaf) + ": ";
        if (times[leaf] == 0)
            return which + "not visited, though the ray is in it from t = " + std::to_string(part->enter) + " to " + std::to_string(part->leave);
        const auto found = std::ranges::find(seen, leaf, &visit::cell)->part;
        if (!(std::abs(found.enter - part->enter) <= slack && std::abs(found.leave - part->leave) <= slack))
            return which + "its stretch is from " + std::to_string(part->enter) + " to " + std::to_string(part->leave) + ", not from " + std::to_string(found.enter) + " to " + std::to_string(found.leave);
    }
    return "";
}

void check_leaves(const cut_up& c, const std::vector<ray>& rays, interval range) {
    recorder seen(rays.size());
    walk_kd_tree(c.tree, rays, range, seen.listening(range));
    check_rays(rays, [&](std::size_t k) { return flaw_of_leaves(c, seen[k], rays[k], range); });
}

}  // namespace

TEST_CASE("the leaves that the ray passes are visited once, in order, each with its stretch", "[step8]") {
    INFO(hint("holes in the picture, or surfaces that show through others",
              "the plane's t cuts the stretch in two: the near part [enter, t] first, then the far part [t, leave]", "§8 Near and far"));
    numbers random(17);
    const aabb box{{-3, 1, 20}, {4, 2.5f, 26}};
    const cut_up c = at_random(box, random, 151);
    check_leaves(c, towards(random, box, 300), {});
    check_leaves(whole(box), towards(random, box, 20), {});
}

TEST_CASE("near is below for rays that run upwards, and above for rays that run downwards", "[step8]") {
    INFO(hint("right from one side, wrong from the other", "the sign of d along the cut's axis says which child comes first", "§8 Near and far"));
    const cut_up c = [] {
        cut_up made = whole({{0, 0, 0}, {2, 2, 2}});
        made.divide(0, 0, 1);
        made.divide(1, 1, 1);
        made.divide(2, 2, 1);
        return made;
    }();
    std::vector<ray> rays;
    for (std::uint32_t k = 0; k < 8; ++k) {
        const glm::vec3 d = glm::vec3(k & 1 ? -1 : 1, k & 2 ? -1 : 1, k & 4 ? -1 : 1) * glm::vec3(1, 0.9f, 0.8f);
        rays.push_back({glm::vec3(1.05f, 0.95f, 1) - 3.0f * d, d});
        rays.push_back({{1.05f, 0.95f, 1.02f}, d});
    }
    check_leaves(c, rays, {});
}

TEST_CASE("within planes, through edges and corners no leaf is lost", "[step8]") {
    INFO(hint("specks and lines are missing, where the camera looks along an axis or a diagonal",
              "d = 0, of either sign: one side only, as the origin says; and both sides when the ray lies within the plane", "§8 Along an axis"));
    numbers random(18);
    for (int i = 0; i < 5; ++i) check_leaves(into_cubes({4, 3, 2}, random), awkward({4, 3, 2}), {});
}

TEST_CASE("the walk through the tree keeps within the range", "[step8]") {
    INFO(hint("surfaces behind the eye are tested, and shadow rays go on behind the lamp",
              "begin with clip(tree.box, r, range); a child with an empty stretch is not entered", "§8 Near and far"));
    numbers random(19);
    const aabb box{{-3, 1, 20}, {4, 2.5f, 26}};
    const cut_up c = at_random(box, random, 101);
    for (const interval range : {interval{0, 0.5f}, {0.25f, 0.6f}, {0.4f, infinite}, {0, 1e-3f}}) check_leaves(c, towards(random, box, 60), range);
}

TEST_CASE("a hit outside the leaf does not end the walk, one within it does", "[step8]") {
    INFO(hint("what is behind is seen through what is in front, near the borders of cells",
              "the hit found in this leaf may lie in a later one, behind something else; go on until the next leaf begins behind the hit", "§8 A hit elsewhere"));
    numbers random(20);
    const aabb box{{-3, 1, 20}, {4, 2.5f, 26}};
    const cut_up c = at_random(box, random, 151);
    const auto rays = towards(random, box, 200);
    std::vector<float> hits;
    for (const ray& r : rays) {
        const auto all = stretch_in(wide(box), r, {});
        hits.push_back(all ? float(glm::mix(all->enter, all->leave, double(random.between(0.02f, 0.98f)))) : 1);
    }
    recorder seen(rays.size());
    walk_kd_tree(c.tree, rays, {}, seen.listening({}, [&](std::uint32_t r, std::uint32_t, stretch, interval remaining) { return interval{remaining.min, hits[r]}; }));
    // The first leaf is visited before the hit is known, and it must end where the ray leaves the tree or the leaf.
    check_rays(rays, [&](std::size_t k) { return flaw_of_leaves(c, seen[k], rays[k], {}, double(hits[k])); });
}

TEST_CASE("when nothing remains, no further leaf is visited", "[step8]") {
    INFO(hint("shadow rays cost as much as any other", "an empty range means stop, on every level of the tree", "§8 A hit elsewhere"));
    numbers random(21);
    const aabb box{{0, 0, 0}, {8, 8, 8}};
    const cut_up c = at_random(box, random, 151);
    const auto rays = towards(random, box, 50);
    recorder all(rays.size()), some(rays.size());
    walk_kd_tree(c.tree, rays, {}, all.listening({}));
    walk_kd_tree(c.tree, rays, {}, some.listening({}, [&](std::uint32_t r, std::uint32_t, stretch, interval remaining) {
        return some[r].size() >= 3 ? interval{0, 0} : remaining;
    }));
    for (std::size_t k = 0; k < rays.size(); ++k) CHECK(some[k].size() == std::min<std::size_t>(all[k].size(), 3));
}

TEST_CASE("through the kd-tree, the closest hit is the closest of all", "[step8]") {
    INFO(hint("the picture differs from that of brute force",
              "no leaf too few, none in the wrong order, and not the end before the hit lies in the leaf", "§8 A hit elsewhere"));
    numbers random(22);
    const aabb box{{-1, -1, -1}, {5, 4, 3}};
    std::vector<ball> balls;
    for (int i = 0; i < 40; ++i) balls.push_back({point_in(random, {glm::vec3(0), glm::vec3(4, 3, 2)}), random.between(0.1f, 0.9f)});
    for (int round = 0; round < 2; ++round) {
        const cut_up c = at_random(box, random, 151);
        std::vector<ray> rays = towards(random, box, 200);
        for (const ray& r : awkward({4, 3, 2})) rays.push_back(r);
        std::vector<float> found(rays.size(), infinite);
        recorder seen(rays.size());
        walk_kd_tree(c.tree, rays, {}, seen.listening({}, [&](std::uint32_t r, std::uint32_t leaf, stretch, interval remaining) {
            if (leaf < c.cells.size())
                for (const ball& b : balls)
                    if (touch(box_of(b), c.cells[leaf])) remaining = tested(b, rays[r], remaining);
            found[r] = remaining.max;
            return remaining;
        }));
        check_rays(rays, [&](std::size_t k) -> std::string {
            const float expected = closest_of_all(balls, rays[k]);
            return same_t(found[k], expected) ? "" : "found t = " + std::to_string(found[k]) + " instead of " + std::to_string(expected);
        });
    }
}

// ---- Step 9: which structure wins? ---------------------------------------------------------------------------------

namespace {

/// The mean number of offers a ray. Fails where the closest hit is not the closest of all.
double offers_a_ray(structure which, const std::vector<ball>& balls, const std::vector<ray>& rays) {
    std::vector<float> found(rays.size(), infinite);
    double offers = 0;
    traverse(which, boxes_of(balls), rays, [&](std::uint32_t r, std::uint32_t i, interval range) -> interval {
        if (++offers > 1e5 || i >= balls.size()) return {0, 0};
        range = tested(balls[i], rays[r], range);
        found[r] = range.max;
        return range;
    });
    check_rays(rays, [&](std::size_t k) -> std::string {
        const float expected = closest_of_all(balls, rays[k]);
        return same_t(found[k], expected) ? "" : "found t = " + std::to_string(found[k]) + " instead of " + std::to_string(expected);
    });
    return offers / double(rays.size());
}

}  // namespace

TEST_CASE("a prediction is made for each scene", "[step9]") {
    INFO(hint("no harm is done, but nothing is learnt either",
              "say what you expect before you measure; right or wrong does not matter here", "§9 Predict"));
    for (const structure s : predictions()) CHECK((s == structure::grid || s == structure::octree || s == structure::kd_tree || s == structure::bvh));
}

TEST_CASE("in a cloud of a thousand balls a ray is tested against few", "[step9]") {
    INFO(hint("right, but slow",
              "the bounds are in the handout: which of the three is above its own? Then look at the steps before", "§9 Fast enough"));
    (void)predictions();
    numbers random(23);
    const auto balls = cloud(random, 1000, 1, 0.02f, 0.06f);
    const auto rays = towards(random, {glm::vec3(-1), glm::vec3(1)}, 150);
    CHECK(offers_a_ray(structure::grid, balls, rays) <= 8);
    CHECK(offers_a_ray(structure::octree, balls, rays) <= 24);
    CHECK(offers_a_ray(structure::kd_tree, balls, rays) <= 4);
}

TEST_CASE("in a crowd within a wide space a tree tests few", "[step9]") {
    INFO(hint("right, but slow",
              "the bounds are in the handout; the grid has none here, for the whole crowd is in one of its cells", "§9 Fast enough"));
    (void)predictions();
    numbers random(24);
    auto balls = cloud(random, 600, 0.01f, 0.0003f, 0.0008f);
    for (const ball& b : cloud(random, 60, 10, 0.5f, 1)) balls.push_back(b);
    std::vector<ray> rays;
    for (int i = 0; i < 150; ++i) {
        const glm::vec3 origin = 0.05f * random.vector();
        rays.push_back({origin, 0.01f * random.vector() - origin});
    }
    CHECK(offers_a_ray(structure::grid, balls, rays) > 100);  // as it must be: question 2
    CHECK(offers_a_ray(structure::octree, balls, rays) <= 30);
    CHECK(offers_a_ray(structure::kd_tree, balls, rays) <= 20);
}

TEST_CASE("empty, single, flat, and equal: every structure finds what there is", "[step9]") {
    INFO(hint("a crash, or nothing to be seen, in a small scene", "degenerate scenes: look at the steps that build", "§9 Fast enough"));
    (void)predictions();
    numbers random(25);
    std::vector<std::vector<ball>> scenes{{}, {{{1, 2, 3}, 0.5f}}, std::vector<ball>(6, ball{{0.5f, 0.5f, 0.5f}, 0.25f}), {}};
    for (int i = 0; i < 100; ++i) scenes.back().push_back({random.vector() * glm::vec3(1, 0, 1), 0.03f});
    scenes.push_back(scenes.back());
    scenes.back().push_back({{0, -1000, 0}, 999.9f});
    for (const auto& balls : scenes) {
        const std::vector<aabb> boxes = boxes_of(balls);
        const auto rays = towards(random, boxes.empty() ? aabb{glm::vec3(0), glm::vec3(1)} : balls.size() > 100 ? box_of({glm::vec3(0), 1}) : around(boxes), 60);
        for (const structure s : {structure::grid, structure::octree, structure::kd_tree}) {
            CAPTURE(balls.size(), int(s));
            (void)offers_a_ray(s, balls, rays);
        }
    }
}
