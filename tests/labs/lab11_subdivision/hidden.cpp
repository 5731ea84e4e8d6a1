// SPDX-License-Identifier: MIT
// Lab 11's hidden tests, for scenes and rays drawn anew for each grading. The truth is brute force over all cells, all cuts, all
// surfaces. A cell that a ray passes for less than a millionth of its way may be left out or not: there rounding decides.

#include "contract.hpp"
#include "truth.hpp"

#include <catch.hpp>
#include <hidden.hpp>

#include <lab11_subdivision/subdivision.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

using namespace contract::lab11;
using truth::cell_box, truth::cost_of, truth::least_cost, truth::wide;

namespace {

struct visit {
    std::uint32_t cell;
    stretch part;
};

/// The ray's stretch in a box that is larger by `more` on all sides; it ends before it begins where there is none.
stretch stretch_in(const cell_box& box, const ray& r, interval range, double more = 0) {
    stretch part{range.min, range.max};
    for (int k = 0; k < 3; ++k) {
        const double o = r.origin[k], d = r.direction[k], a = (box.min[k] - more - o) / d, b = (box.max[k] + more - o) / d;
        part = {std::max(part.enter, std::min(a, b)), std::min(part.leave, std::max(a, b))};
    }
    return part;
}

/// What is wrong with the visits of a ray, in words: each of the cells that it passes before `end` must be there once, in order, with its
/// stretch. `range` is the ray's.
std::string flaw(const std::vector<visit>& seen, const std::vector<cell_box>& cells, const cell_box& whole, const ray& r, interval range,
                 double end = INFINITY) {
    const stretch all = stretch_in(whole, r, range);
    const double way = std::max({std::abs(all.enter), std::abs(all.leave), 1e-30}), slack = 4e-6 * way;
    const double size = std::max({whole.max.x - whole.min.x, whole.max.y - whole.min.y, whole.max.z - whole.min.z});
    std::vector<std::pair<double, std::uint32_t>> expected;
    for (std::uint32_t k = 0; k < cells.size() && all.enter <= all.leave; ++k)
        if (const stretch part = stretch_in(cells[k], r, range); part.leave - part.enter > slack && part.enter < end - slack)
            expected.push_back({part.enter, k});
    std::sort(expected.begin(), expected.end());
    std::size_t next = 0;
    std::vector<bool> visited(cells.size());
    for (const auto& [cell, part] : seen) {
        if (cell >= cells.size()) return "there is no cell " + std::to_string(cell);
        if (visited[cell]) return "visited twice";
        visited[cell] = true;
        const stretch right = stretch_in(cells[cell], r, range), around = stretch_in(cells[cell], r, range, 1e-5 * size);
        if (!(around.enter <= around.leave)) return "visited, though the ray misses it";
        if (!(part.enter <= end + slack)) return "visited, though it lies behind the end";
        if (!(part.enter <= part.leave + slack)) return "left before it is entered";
        if (next < expected.size() && expected[next].second == cell) {
            if (!(std::abs(part.enter - right.enter) <= slack && std::abs(part.leave - right.leave) <= slack)) return "another stretch";
            ++next;
        } else if (right.leave - right.enter > slack && right.enter < end - slack)
            return "out of order";
    }
    return next == expected.size() ? "" : "not visited";
}

glm::vec3 point_in(numbers& random, const aabb& box) {
    const float x = random.between(box.min.x, box.max.x), y = random.between(box.min.y, box.max.y);
    return {x, y, random.between(box.min.z, box.max.z)};
}

aabb any_box(numbers& random) {
    const glm::vec3 low = 5.0f * random.vector();
    const float x = random.between(1, 8), y = random.between(1, 8);
    return {low, low + glm::vec3(x, y, random.between(1, 8))};
}

aabb box_in(numbers& random, const aabb& cell, float size) {
    const glm::vec3 a = point_in(random, cell), b = glm::mix(a, point_in(random, cell), size * random.unit());
    return {glm::min(a, b), glm::max(a, b)};
}

std::vector<ray> towards(numbers& random, const aabb& box, int count) {
    std::vector<ray> rays;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 origin = i % 3 == 0 ? point_in(random, box) : center(box) + 1.5f * (box.max - box.min) * random.vector();
        rays.push_back({origin, random.between(0.1f, 4) * (point_in(random, box) - origin)});
    }
    return rays;
}

interval any_range(numbers& random) {
    const float from = random.between(0, 0.4f);
    return random.unit() < 0.5f ? interval{} : interval{from, from + random.between(0.2f, 1)};
}

/// Walks all rays, the first half of them to the end, the others until a hit that their first cell tells; what is wrong with them.
template <class Walk>
std::string flaw_of_walks(numbers& random, const Walk& walk, const std::vector<cell_box>& cells, const aabb& box) {
    const std::vector<ray> rays = towards(random, box, 60);
    const interval range = any_range(random);
    std::vector<double> ends(rays.size(), INFINITY);
    for (std::size_t k = rays.size() / 2; k < rays.size(); ++k) {
        const stretch whole = stretch_in(wide(box), rays[k], range);
        if (whole.enter < whole.leave) ends[k] = float(glm::mix(whole.enter, whole.leave, double(random.between(0.05f, 0.95f))));
    }
    std::vector<std::vector<visit>> seen(rays.size());
    walk(rays, range, [&](std::uint32_t r, std::uint32_t cell, stretch part) -> interval {
        auto& visits = seen.at(r);
        if (visits.size() > 2000) return {0, 0};
        visits.push_back({cell, part});
        return {range.min, std::min(range.max, float(ends[r]))};
    });
    for (std::size_t k = 0; k < rays.size(); ++k)
        if (const std::string wrong = flaw(seen[k], cells, wide(box), rays[k], range, ends[k]); !wrong.empty()) return wrong;
    return "";
}

// ---- Balls ---------------------------------------------------------------------------------------------------------

struct ball {
    glm::vec3 center;
    float radius;
};

/// What remains of the range when the ray has been tested against the ball.
interval tested(const ball& b, const ray& r, interval range) {
    const glm::dvec3 d(r.direction), o = glm::dvec3(r.origin) - glm::dvec3(b.center);
    const double a = glm::dot(d, d), half = glm::dot(o, d), disc = half * half - a * (glm::dot(o, o) - double(b.radius) * double(b.radius));
    if (!(disc >= 0)) return range;
    for (const double t : {(-half - std::sqrt(disc)) / a, (-half + std::sqrt(disc)) / a})
        if (contains(range, float(t))) return {range.min, float(t)};
    return range;
}

// ---- Trees ---------------------------------------------------------------------------------------------------------

/// Whether a node, and all that is below it, is as the solution's, wherever it stands in the list.
bool same_node(const octree& theirs, std::uint32_t at, const lab11::octree& ours, std::uint32_t right) {
    if (at >= theirs.nodes.size()) return false;
    const octree_node& a = theirs.nodes[at];
    const lab11::octree_node& b = ours.nodes[right];
    if ((a.children == 0) != (b.children == 0)) return false;
    if (b.children == 0) {
        if (a.size != b.size || std::size_t(a.first) + a.size > theirs.entries.size()) return false;
        return std::is_permutation(ours.entries.begin() + b.first, ours.entries.begin() + b.first + b.size, theirs.entries.begin() + a.first);
    }
    for (std::uint32_t k = 0; k < 8; ++k)
        if (!same_node(theirs, a.children + k, ours, b.children + k)) return false;
    return true;
}

}  // namespace

TEST_CASE("any number of cells", "[step1]") {
    numbers random = hidden::drawn(1);
    const auto cells = [](glm::ivec3 count) { return double(count.x) * double(count.y) * double(count.z); };
    for (int i = 0; i < 100; ++i) {
        const aabb box = any_box(random);
        const auto surfaces = 100 + hidden::below(random, 20000);
        const float each = random.between(1, 10);
        const double wanted = double(surfaces) * double(each);
        const glm::ivec3 count = resolution(box, surfaces, each);
        CHECK((count.x >= 1 && count.y >= 1 && count.z >= 1));
        CHECK((cells(count) <= 1.0001 * wanted && cells(count) >= 0.1249 * wanted));
        const glm::vec3 side = (box.max - box.min) / glm::vec3(count);
        // Of n cells and a part the part is shared out: with four or more on each side none is longer than 5/4 of the others.
        if (count.x >= 4 && count.y >= 4 && count.z >= 4) CHECK(std::max({side.x, side.y, side.z}) <= 1.26f * std::min({side.x, side.y, side.z}));

        aabb thin = box;
        const int axis = int(hidden::below(random, 3));
        thin.max = thin.min + glm::vec3(random.between(32, 64));
        thin.max[axis] = thin.min[axis] + random.between(0, 0.1f);
        const glm::ivec3 flat = resolution(thin, 1000, 8);
        CHECK(flat[axis] == 1);
        CHECK((cells(flat) <= 8001 && cells(flat) >= 999));
    }
}

TEST_CASE("the cells of any box", "[step2]") {
    numbers random = hidden::drawn(2);
    const auto same = [](const cell_range& a, const lab11::cell_range& b) { return a.first == b.first && a.last == b.last; };
    hidden::agreement all;
    for (int i = 0; i < 200; ++i) {
        const glm::ivec3 count(1 + int(hidden::below(random, 9)), 1 + int(hidden::below(random, 9)), 1 + int(hidden::below(random, 9)));
        const aabb whole = any_box(random), some = box_in(random, whole, 1);
        all.count(same(cells_of({whole, count}, some), lab11::cells_of({whole, count}, some)));
        // Whole numbers, and halves of cells: many ends are at a face exactly.
        const int side = 1 + int(hidden::below(random, 8));
        const glm::vec3 high(count * side);
        const auto half = [&](int axis) { return 0.5f * float(side) * float(hidden::below(random, std::uint32_t(2 * count[axis] + 1))); };
        const glm::vec3 a(half(0), half(1), half(2)), b(half(0), half(1), half(2));
        const aabb box{glm::min(a, b), glm::max(a, b)};
        CHECK(same(cells_of({{glm::vec3(0), high}, count}, box), lab11::cells_of({{glm::vec3(0), high}, count}, box)));
    }
    CHECK(all.holds());
}

TEST_CASE("any walk through any grid", "[step3]") {
    numbers random = hidden::drawn(3);
    for (int i = 0; i < 4; ++i) {
        const aabb box = any_box(random);
        const glm::ivec3 count(1 + int(hidden::below(random, 9)), 1 + int(hidden::below(random, 9)), 1 + int(hidden::below(random, 9)));
        std::vector<cell_box> cells;
        const glm::dvec3 low(box.min), extent = glm::dvec3(box.max) - low;
        for (int z = 0; z < count.z; ++z)
            for (int y = 0; y < count.y; ++y)
                for (int x = 0; x < count.x; ++x)
                    cells.push_back({low + extent * glm::dvec3(x, y, z) / glm::dvec3(count), low + extent * glm::dvec3(x + 1, y + 1, z + 1) / glm::dvec3(count)});
        CHECK(flaw_of_walks(random, [&](const std::vector<ray>& rays, interval range, const visitor& v) { walk_grid({box, count}, rays, range, v); },
                            cells, box) == "");
    }
}

TEST_CASE("any surfaces in many cells", "[step4]") {
    numbers random = hidden::drawn(4);
    for (int i = 0; i < 30; ++i) {
        std::vector<std::vector<std::uint32_t>> cells(1 + hidden::below(random, 40));
        std::vector<std::uint32_t> wanted, order;
        const std::uint32_t surfaces = 1 + hidden::below(random, 30), stops = random.unit() < 0.5f ? hidden::below(random, 60) : surfaces;
        for (auto& cell : cells)
            for (std::uint32_t k = hidden::below(random, 6); k > 0; --k) cell.push_back(hidden::below(random, surfaces));
        for (const auto& cell : cells) wanted.insert(wanted.end(), cell.begin(), cell.end());
        interval left{0.5f, random.between(10, 100)};
        bool as_left = true;
        const auto remaining = offer_all(cells, left, [&](std::uint32_t k, interval range) {
            as_left = as_left && range.min == left.min && range.max == left.max && !empty(left);
            if (order.size() < 1000) order.push_back(k);
            left = k == stops ? interval{0, 0} : interval{range.min, range.max - 0.01f * float(k)};
            return left;
        });
        CHECK(as_left);
        REQUIRE(remaining.size() == cells.size());
        CHECK((remaining.back().min == left.min && remaining.back().max == left.max));
        // In the order of the lists; who is left out was offered before; who was among the last eight is left out.
        std::size_t next = 0;
        bool right = true;
        for (const std::uint32_t k : wanted) {
            if (next > 0 && order[next - 1] == stops) break;
            const auto before = order.begin() + std::ptrdiff_t(next), last_eight = before - std::ptrdiff_t(std::min<std::size_t>(next, 8));
            if (next < order.size() && order[next] == k && std::find(last_eight, before, k) == before) ++next;
            else right = right && std::find(order.begin(), before, k) != before;
        }
        CHECK(right);
        CHECK(next == order.size());
    }
}

TEST_CASE("any octree", "[step5]") {
    numbers random = hidden::drawn(5);
    for (int i = 0; i < 20; ++i) {
        const aabb cell = any_box(random);
        const std::uint32_t number = hidden::below(random, 8);
        const aabb part = octant_of(cell, number), right = lab11::octant_of(cell, number);
        CHECK((hidden::apart(part.min, right.min) < 1e-6 && hidden::apart(part.max, right.max) < 1e-6));
        std::vector<aabb> boxes(1 + hidden::below(random, 150));
        for (aabb& box : boxes) box = box_in(random, cell, 0.3f);
        const std::uint32_t leaf_size = 1 + hidden::below(random, 8), depth = hidden::below(random, 6);
        CHECK(same_node(build_octree(boxes, leaf_size, depth), 0, lab11::build_octree(boxes, leaf_size, depth), 0));
    }
}

TEST_CASE("the octants that any ray meets", "[step6]") {
    numbers random = hidden::drawn(6);
    for (int i = 0; i < 4; ++i) {
        const aabb cell = any_box(random);
        const interval range = any_range(random);
        std::vector<cell_box> octants;
        for (std::uint32_t k = 0; k < 8; ++k) octants.push_back(wide(lab11::octant_of(cell, k)));
        for (const ray& r : towards(random, cell, 60)) {
            const stretch whole = stretch_in(wide(cell), r, range);
            if (!(whole.enter < whole.leave)) continue;
            std::vector<visit> seen;
            for (const auto& met : octants_met(cell, r, whole)) seen.push_back({met.octant, met.part});
            CHECK((seen.size() >= 1 && seen.size() <= 4));
            CHECK(flaw(seen, octants, wide(cell), r, range) == "");
        }
    }
}

TEST_CASE("the cheapest of any cuts", "[step7]") {
    numbers random = hidden::drawn(7);
    for (int i = 0; i < 150; ++i) {
        const aabb cell = any_box(random);
        std::vector<aabb> boxes(1 + hidden::below(random, 20));
        for (aabb& box : boxes) box = box_in(random, cell, 0.5f);
        const costs c{random.between(0.1f, 2), random.between(1, 8), random.between(0, 0.9f)};
        const double least = least_cost(cell, boxes, c);
        const double leaf = double(c.test) * double(boxes.size());
        if (std::abs(least - leaf) < 1e-5 * leaf) continue;  // it pays, or not: rounding decides
        const auto best = best_cut(cell, boxes, c);
        REQUIRE(best.has_value() == (least < leaf));
        if (!best) continue;
        REQUIRE(best->axis < 3);
        const int axis = int(best->axis);
        CHECK((best->at > cell.min[axis] && best->at < cell.max[axis]));
        CHECK(cost_of(cell, boxes, c, axis, best->at) <= least * (1 + 1e-5));
    }
}

TEST_CASE("any walk through any kd-tree", "[step8]") {
    numbers random = hidden::drawn(8);
    for (int i = 0; i < 4; ++i) {
        const aabb box = any_box(random);
        kd_tree tree{box, {{3, 0, 0, 0}}};
        std::vector<aabb> boxes{box};
        const std::size_t nodes = 1 + 2 * hidden::below(random, 70);
        for (std::uint32_t at = 0; tree.nodes.size() < nodes; ++at) {
            const auto axis = hidden::below(random, 3), first = std::uint32_t(tree.nodes.size());
            const float plane = glm::mix(boxes[at].min[int(axis)], boxes[at].max[int(axis)], random.between(0.1f, 0.9f));
            tree.nodes[at] = {axis, plane, first, 0};
            tree.nodes.resize(first + 2, {3, 0, 0, 0});
            boxes.resize(first + 2, boxes[at]);
            boxes[first].max[int(axis)] = boxes[first + 1].min[int(axis)] = plane;
        }
        std::vector<cell_box> cells;
        for (std::size_t k = 0; k < boxes.size(); ++k)  // what is no leaf is nowhere, so no ray passes it
            cells.push_back(tree.nodes[k].axis == 3 ? wide(boxes[k]) : cell_box{glm::dvec3(INFINITY), glm::dvec3(INFINITY)});
        CHECK(flaw_of_walks(random, [&](const std::vector<ray>& rays, interval range, const visitor& v) { walk_kd_tree(tree, rays, range, v); },
                            cells, box) == "");
    }
}

TEST_CASE("in any cloud of balls every structure finds the closest, and tests few", "[step9]") {
    (void)predictions();
    numbers random = hidden::drawn(9);
    std::vector<ball> balls;
    std::vector<aabb> boxes;
    for (int i = 0; i < 400; ++i) {
        const glm::vec3 at = random.vector();
        const ball b{at, random.between(0.02f, 0.08f)};
        balls.push_back(b);
        boxes.push_back({b.center - b.radius, b.center + b.radius});
    }
    const std::vector<ray> rays = towards(random, {glm::vec3(-1), glm::vec3(1)}, 40);
    for (const structure which : {structure::grid, structure::octree, structure::kd_tree}) {
        std::vector<interval> found(rays.size());
        std::size_t offers = 0;
        traverse(which, boxes, rays, [&](std::uint32_t r, std::uint32_t i, interval range) -> interval {
            if (++offers > 100'000 || i >= balls.size() || r >= found.size()) return {0, 0};
            return found[r] = tested(balls[i], rays[r], range);
        });
        hidden::agreement all;
        for (std::size_t k = 0; k < rays.size(); ++k) {
            interval right;
            for (const ball& b : balls) right = tested(b, rays[k], right);
            all.count(found[k].max == right.max || std::abs(found[k].max - right.max) <= 1e-5f * right.max);
        }
        CHECK(all.holds());
        CHECK(offers <= 40 * rays.size());  // about 5 to 15 are needed; without a structure 400
    }
}
