// SPDX-License-Identifier: MIT
// Lab 10: boxes in boxes. Trees are looked at and not believed (trees.hpp): every walk over a returned tree ends, whatever it looks like.
// What a traversal asks is answered, checked and counted here (interview.hpp). But for one test, which says so, nothing is left to chance.

#include "interview.hpp"
#include "trees.hpp"

#include <catch.hpp>
#include <hint.hpp>
#include <numbers.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace lab10_suite;

// ---- Step 1: the box around a group --------------------------------------------------------------------------------

TEST_CASE("the box holds every box of the group", "[step1]") {
    INFO(hint("things are cut off, or vanish",
              "the least of all lower corners and the greatest of all upper ones, each coordinate by itself", "§1 The smallest box"));
    numbers random(1);
    const boxes all = cloud(random, 60, 0.3f);
    for (std::uint32_t first = 0; first < 60; ++first) {
        group some;
        for (std::uint32_t k = 0; k <= first % 7; ++k) some.push_back((first + 11 * k) % 60);
        const aabb box = box_around(all, some), right = around(all, some);
        CAPTURE(some, box.min, box.max);
        for (int k = 0; k < 3; ++k) REQUIRE((box.min[k] <= right.min[k] && box.max[k] >= right.max[k]));
    }
}

TEST_CASE("the box is no larger than it must be", "[step1]") {
    INFO(hint("rays look into boxes in which there is nothing for them",
              "only the group counts, not all boxes, and not the origin either", "§1 The smallest box"));
    numbers random(2);
    boxes all = cloud(random, 60, 0.3f);
    for (std::uint32_t first = 0; first < 60; ++first) {
        group some;
        for (std::uint32_t k = 0; k <= first % 4; ++k) some.push_back((first + 11 * k) % 60);
        const aabb box = box_around(all, some), right = around(all, some);
        CAPTURE(some, box.min, box.max);
        for (int k = 0; k < 3; ++k) REQUIRE((box.min[k] >= right.min[k] && box.max[k] <= right.max[k]));
    }
}

TEST_CASE("the box of one is that box, and of none the empty one", "[step1]") {
    INFO(hint("a box around nothing is found by rays, or a point's box has a size",
              "begin with the empty box, lantern::aabb{}", "§1 The empty box"));
    const boxes all{{{1, 2, 3}, {4, 5, 6}}, {{-4, -5, -6}, {-1, -2, -6}}, {{7, 7, 7}, {7, 7, 7}}};
    for (std::uint32_t i = 0; i < 3; ++i) CHECK(same(box_around(all, group{i}), all[i]));
    const aabb none = box_around(all, group{});
    CAPTURE(none.min, none.max);
    CHECK(same(none, aabb{}));
}

// ---- Step 2: dividing a group --------------------------------------------------------------------------------------

TEST_CASE("each surface is in one half, and in one only", "[step2]") {
    INFO(hint("things are missing, or there twice",
              "of the group, and of nothing but the group, everything goes left or right", "§2 Two halves"));
    for (const family& f : families()) {
        if (f.all.size() < 2) continue;
        group some = all_of(f.all.size());
        if (some.size() > 10) some.erase(some.begin() + 3, some.begin() + 6);
        for (const auto& [left, right] : {at_median(f.all, some), at_middle(f.all, some)}) {
            CAPTURE(f.name, some.size(), left.size(), right.size());
            group both = left;
            both.insert(both.end(), right.begin(), right.end());
            REQUIRE(sorted(both) == some);
        }
    }
}

TEST_CASE("the median sends half of them to the left", "[step2]") {
    INFO(hint("one half grows and grows", "the smaller half, size / 2, goes left", "§2 The median"));
    numbers random(3);
    for (const std::uint32_t count : {2u, 3u, 4u, 7u, 50u, 101u}) {
        const auto [left, right] = at_median(cloud(random, count, 0.2f), all_of(count));
        CAPTURE(count);
        CHECK(left.size() == count / 2);
        CHECK(right.size() == count - count / 2);
    }
}

TEST_CASE("at the median nothing on the left lies above anything on the right", "[step2]") {
    INFO(hint("the boxes of both halves overlap everywhere", "sort by the centres (or std::nth_element) before you cut", "§2 The median"));
    numbers random(4);
    for (int i = 0; i < 30; ++i) {
        const boxes all = cloud(random, 40, 0.2f);
        const int axis = widest(all, all_of(40));
        const auto [left, right] = at_median(all, all_of(40));
        float highest = -2, lowest = 2;
        for (const std::uint32_t k : left) highest = std::max(highest, center(all.at(k))[axis]);
        for (const std::uint32_t k : right) lowest = std::min(lowest, center(all.at(k))[axis]);
        CAPTURE(i, axis, highest, lowest);
        REQUIRE(highest <= lowest);
    }
}

TEST_CASE("the middle divides those below from those above", "[step2]") {
    INFO(hint("the groups do not fall apart where there is a gap",
              "the middle is halfway between the lowest and the highest centre: no mean, no median", "§2 The middle"));
    numbers random(5);
    for (int i = 0; i < 30; ++i) {
        boxes all = cloud(random, 40, 0.2f);
        for (std::size_t k = 0; k < 30; ++k) all[k] = {all[k].min * 0.2f - 0.5f, all[k].max * 0.2f - 0.5f};  // a crowd, off the middle
        const int axis = widest(all, all_of(40));
        float lowest = 2, highest = -2;
        for (const aabb& box : all) lowest = std::min(lowest, center(box)[axis]), highest = std::max(highest, center(box)[axis]);
        const float middle = (lowest + highest) / 2;
        const auto [left, right] = at_middle(all, all_of(40));
        CAPTURE(i, axis, middle);
        for (const std::uint32_t k : left) REQUIRE(center(all.at(k))[axis] <= middle + 1e-6f);
        for (const std::uint32_t k : right) REQUIRE(center(all.at(k))[axis] >= middle - 1e-6f);
    }
}

TEST_CASE("the axis is the one on which the centres spread the farthest", "[step2]") {
    INFO(hint("long thin boxes are stacked instead of being laid in a row",
              "the spread of the centres counts, not the size of the boxes, nor the axis's turn", "§2 The axis"));
    for (int axis = 0; axis < 3; ++axis) {
        boxes sticks;  // each is long on another axis than the one on which they follow one another
        for (int i = 0; i < 8; ++i) {
            glm::vec3 p(0), e(0.1f);
            p[axis] = float((i * 3) % 8);
            p[(axis + 1) % 3] = 0.01f * float(i);
            e[(axis + 1) % 3] = 50;
            sticks.push_back({p - e, p + e});
        }
        CAPTURE(axis);
        for (const auto& [left, right] : {at_median(sticks, all_of(8)), at_middle(sticks, all_of(8))}) {
            CAPTURE(left, right);
            CHECK(sorted(left) == group{0, 1, 3, 6});  // at 0, 3, 1 and 2
        }
    }
}

TEST_CASE("neither half is empty, even where all centres are equal", "[step2]") {
    INFO(hint("the build hangs, or the stack overflows",
              "where at_middle finds nothing on one side it must do as at_median does", "§2 Nothing on one side"));
    const boxes duplicates(9, aabb{{1, 1, 1}, {2, 2, 2}});
    boxes onion, neighbours;
    for (int i = 0; i < 9; ++i) {
        onion.push_back({glm::vec3(-float(i)), glm::vec3(float(i))});
        const float x = i < 8 ? 1 : std::nextafter(1.0f, 2.0f);
        neighbours.push_back({{x, 0, 0}, {x, 0, 0}});
    }
    for (const boxes& all : {duplicates, onion}) {
        CHECK(at_middle(all, all_of(9)).left.size() == 4);
        CHECK(at_median(all, all_of(9)).left.size() == 4);
    }
    const auto [left, right] = at_middle(neighbours, all_of(9));
    CHECK((!left.empty() && !right.empty()));
    for (const auto& [one, other] : {at_middle(duplicates, group{5, 2}), at_median(duplicates, group{5, 2})})
        CHECK((one.size() == 1 && other.size() == 1));
}

// ---- Step 3: a tree from the top down ------------------------------------------------------------------------------

TEST_CASE("every surface is in exactly one leaf", "[step3]") {
    INFO(hint("things are missing, or the program does not end",
              "each leaf has its own stretch of `order`; each inner node two children of its own, behind it, and count 0",
              "§3 From the top down"));
    for (const family& f : families())
        for (const std::uint32_t leaf_size : {1u, 3u, 4u}) {
            const tree t = build(f.all, [&](group_in some) { return halved(f.all, {some.begin(), some.end()}); }, leaf_size, 24);
            CAPTURE(f.name, leaf_size);
            REQUIRE(walk_through(t, f.all.size()).broken == "");
        }
}

TEST_CASE("each node's box is the smallest around all that is below it", "[step3]") {
    INFO(hint("things are cut off at the edges of boxes, or rays ask too much",
              "a node's box is that of its whole group: of both its children, not of one", "§3 From the top down"));
    for (const family& f : families()) {
        const tree t = build(f.all, [&](group_in some) { return halved(f.all, {some.begin(), some.end()}); }, 2, 24);
        const walk seen = walk_through(t, f.all.size());
        CAPTURE(f.name);
        REQUIRE(seen.broken == "");
        REQUIRE(wrong_box(t, seen, f.all) == "");
    }
}

TEST_CASE("the tree divides its groups as the split says", "[step3]") {
    INFO(hint("a better split makes no better tree",
              "the split's left half goes to the left child, its right half to the right one", "§3 From the top down"));
    numbers random(6);
    const boxes all = cloud(random, 100, 0.1f);
    std::vector<std::pair<group, halves>> said;
    const tree t = build(all, [&](group_in some) {
        halves parts = halved(all, {some.begin(), some.end()});
        if (some.size() > 12) parts = cut({some.begin(), some.end()}, 3);
        said.push_back({sorted({some.begin(), some.end()}), parts});
        return parts;
    }, 4, 48);
    const walk seen = walk_through(t, all.size());
    REQUIRE(seen.broken == "");
    for (std::size_t i = 0; i < t.nodes.size(); ++i) {
        if (t.nodes[i].count > 0) continue;
        const auto when = std::find_if(said.begin(), said.end(), [&](const auto& one) { return one.first == seen.below[i]; });
        CAPTURE(i, seen.below[i].size());
        REQUIRE(when != said.end());
        REQUIRE(seen.below[t.nodes[i].left] == sorted(when->second.left));
        REQUIRE(seen.below[t.nodes[i].right] == sorted(when->second.right));
    }
}

TEST_CASE("a leaf holds no more than it may, and a group that fits is not divided", "[step3]") {
    INFO(hint("leaves with hundreds of surfaces, or a tree twice as large as need be",
              "a group of at most leaf_size surfaces is a leaf; a larger one is divided", "§3 Leaves"));
    numbers random(7);
    for (const std::uint32_t leaf_size : {1u, 2u, 4u, 10u})
        for (const std::uint32_t count : {1u, 2u, 3u, 4u, 5u, 9u, 64u, 100u}) {
            const boxes all = cloud(random, count, 0.1f);
            std::size_t smallest_divided = 1000;
            const tree t = build(all, [&](group_in some) {
                smallest_divided = std::min(smallest_divided, some.size());
                return halved(all, {some.begin(), some.end()});
            }, leaf_size, 24);
            const walk seen = walk_through(t, count);
            CAPTURE(leaf_size, count, seen.largest, smallest_divided);
            REQUIRE(seen.broken == "");
            REQUIRE(seen.largest <= leaf_size);
            REQUIRE(smallest_divided > leaf_size);
        }
}

TEST_CASE("no node is deeper than the cap, and the leaves there take what is left", "[step3]") {
    INFO(hint("trees as deep as there are surfaces; a stack of fixed size overflows",
              "the root's depth is 0; at max_depth a group is a leaf, however large it is", "§3 The depth cap"));
    numbers random(8);
    const boxes all = cloud(random, 100, 0.1f);
    // One at a time: the worst that a split can do.
    const auto one_by_one = [](group_in some) { return cut({some.begin(), some.end()}, 1); };
    for (const std::uint32_t cap : {0u, 1u, 5u, 24u, 99u}) {
        const tree t = build(all, one_by_one, 1, cap);
        const walk seen = walk_through(t, all.size());
        CAPTURE(cap, seen.deepest, seen.largest);
        REQUIRE(seen.broken == "");
        CHECK(seen.deepest == cap);
        CHECK(seen.largest == 100 - cap);
    }
}

TEST_CASE("a split that leaves one half empty does no harm", "[step3]") {
    INFO(hint("the build hangs, or the stack overflows",
              "cut the group's list in the middle when the split leaves one half empty", "§3 A split that is none"));
    numbers random(9);
    const boxes all = cloud(random, 70, 0.1f);
    for (const bool to_the_left : {true, false}) {
        int times = 0;
        const tree t = build(all, [&](group_in some) {
            if (++times > 1000) throw std::runtime_error("the split was asked more than 1000 times about 70 surfaces");
            group whole(some.begin(), some.end());
            return to_the_left ? halves{whole, {}} : halves{{}, whole};
        }, 2, 24);
        const walk seen = walk_through(t, all.size());
        CAPTURE(to_the_left, seen.deepest, seen.largest);
        REQUIRE(seen.broken == "");
        REQUIRE(wrong_box(t, seen, all) == "");
        CHECK(seen.deepest <= 7);  // halves of halves: 70 = 2^6.1
        CHECK(seen.largest <= 2);
    }
}

TEST_CASE("one surface is one leaf, and nothing has no nodes", "[step3]") {
    INFO(hint("an empty scene crashes", "no boxes, no nodes; and the root may be a leaf", "§3 Leaves"));
    const auto never = [](group_in) -> halves { throw std::runtime_error("there was nothing to divide"); };
    CHECK(build(boxes{}, never, 4, 24).nodes.empty());
    const tree t = build(boxes{{{1, 2, 3}, {4, 5, 6}}}, never, 4, 24);
    REQUIRE(t.nodes.size() == 1);
    CHECK(t.nodes[0].count == 1);
    CHECK(same(t.nodes[0].box, {{1, 2, 3}, {4, 5, 6}}));
}

TEST_CASE("a leaf size of 0 is refused", "[step3]") {
    INFO(hint("the build never ends, or leaves are empty",
              "throw std::invalid_argument: with leaf_size 0 no group would ever be small enough", "§3 Leaves"));
    numbers random(11);
    const boxes all = cloud(random, 20, 0.1f);
    int times = 0;
    CHECK_THROWS_AS(build(all, [&](group_in some) {
        if (++times > 1000) throw std::runtime_error("the split was asked more than 1000 times about 20 surfaces");
        return cut({some.begin(), some.end()}, some.size() / 2);
    }, 0, 24), std::invalid_argument);
}

// ---- Step 4: what a tree costs -------------------------------------------------------------------------------------

TEST_CASE("the cost of a small tree is as reckoned by hand", "[step4]") {
    INFO(hint("trees cannot be compared",
              "sum up area / area of the root, times 2 for an inner node and times count for a leaf", "§4 What a ray expects"));
    const aabb unit{{0, 0, 0}, {1, 1, 1}}, next{{1, 0, 0}, {2, 1, 1}}, both{{0, 0, 0}, {2, 1, 1}}, flat{{0, 0, 0}, {2, 1, 0}};
    // One leaf.
    CHECK(cost({{{unit, 0, 0, 0, 3}}, {0, 1, 2}}) == Approx(3));
    // Areas 10, 6 and 6: 2 + (1 + 3) * 6 / 10.
    CHECK(cost({{{both, 1, 2, 0, 0}, {unit, 0, 0, 0, 1}, {next, 0, 0, 1, 3}}, {0, 1, 2, 3}}) == Approx(4.4));
    // One of the leaves is flat, with an area of 4, for a rectangle has two sides: 2 + (1 * 6 + 2 * 4) / 10.
    CHECK(cost({{{both, 1, 2, 0, 0}, {next, 0, 0, 0, 1}, {flat, 0, 0, 1, 2}}, {0, 1, 2}}) == Approx(3.4));
}

TEST_CASE("the cost is what rays ask on average", "[step4]") {
    INFO(hint("a tree that is said to be cheap is not",
              "of the rays that cross the root's box, the part area / area of the root crosses a node's", "§4 What a ray expects"));
    // Lines that cross a box evenly begin evenly on its surface, with directions that go by the cosine (Crofton). 20000 of them; a right
    // answer would be refused once in 1.7 million seeds (5 standard deviations).
    numbers random(12);
    const boxes all = cloud(random, 80, 0.15f);
    const tree t = balanced(all);
    const aabb root = t.nodes[0].box;
    const glm::dvec3 size = glm::dvec3(root.max) - glm::dvec3(root.min);
    double sum = 0, squares = 0;
    constexpr int lines = 20000;
    for (int i = 0; i < lines; ++i) {
        const glm::dvec3 face{size.y * size.z, size.z * size.x, size.x * size.y};
        const double chosen = double(random.unit()) * (face.x + face.y + face.z);
        const int axis = chosen < face.x ? 0 : chosen < face.x + face.y ? 1 : 2;
        const bool upper = random.unit() < 0.5f;
        glm::dvec3 p, d;
        for (int k = 0; k < 3; ++k) p[k] = double(root.min[k]) + double(random.unit()) * size[k];
        p[axis] = double(upper ? root.max[axis] : root.min[axis]);
        const double radius = std::sqrt(double(random.unit())), turn = 2 * 3.14159265358979323846 * double(random.unit());
        d[(axis + 1) % 3] = radius * std::cos(turn), d[(axis + 2) % 3] = radius * std::sin(turn);
        d[axis] = (upper ? -1 : 1) * std::sqrt(1 - radius * radius);
        double asked = 0;
        for (const node& n : t.nodes)
            if (entry(n.box, {p, d})) asked += n.count > 0 ? n.count : 2;
        sum += asked, squares += asked * asked;
    }
    const double mean = sum / lines, deviation = std::sqrt((squares / lines - mean * mean) / lines);
    const double said = cost(t);
    CAPTURE(mean, deviation, said);
    CHECK(std::abs(said - mean) <= 5 * deviation);
}

TEST_CASE("a tree without area costs nothing, and so does an empty one", "[step4]") {
    INFO(hint("NaN instead of a cost", "0 / 0: no ray crosses a box without area", "§4 What a ray expects"));
    CHECK(cost({}) == 0);
    CHECK(cost({{{{{0, 0, 0}, {1, 0, 0}}, 0, 0, 0, 2}}, {0, 1}}) == 0);
}

TEST_CASE("no other cut costs less", "[step4]") {
    INFO(hint("the tree is hardly better than with the median",
              "try every place on all three axes; area times number, of both sides, with the boxes' own extent", "§4 The cheapest cut"));
    numbers random(13);
    for (int i = 0; i < 40; ++i) {
        boxes all = cloud(random, 24, i % 2 == 0 ? 0.1f : 0.8f);
        for (std::size_t k = 0; k < 12; ++k) all[k] = {all[k].min * 0.1f + 0.6f, all[k].max * 0.1f + 0.6f};  // a crowd in a corner
        all[20] = {glm::vec3(-3), glm::vec3(3)};
        const auto price = [&](const group& left, const group& right) {
            return area(around(all, left)) * double(left.size()) + area(around(all, right)) * double(right.size());
        };
        double least = std::numeric_limits<double>::infinity();
        for (int axis = 0; axis < 3; ++axis) {
            group some = all_of(24);
            std::sort(some.begin(), some.end(), [&](std::uint32_t a, std::uint32_t b) { return center(all[a])[axis] < center(all[b])[axis]; });
            for (std::size_t n = 1; n < 24; ++n) {
                const auto [left, right] = cut(some, n);
                least = std::min(least, price(left, right));
            }
        }
        const auto [left, right] = at_least_cost(all, all_of(24));
        CAPTURE(i, left, right, least);
        REQUIRE((!left.empty() && !right.empty()));
        REQUIRE(price(left, right) <= least * (1 + 1e-6));
    }
}

TEST_CASE("the cheapest cut leaves nothing out and no half empty", "[step4]") {
    INFO(hint("things vanish where the boxes have no area, or all the same centre",
              "a cost of 0 is a cost too: compare with infinity at first; and never cut before the first", "§4 The cheapest cut"));
    for (const family& f : families()) {
        if (f.all.size() < 2) continue;
        group some = all_of(f.all.size());
        if (some.size() > 10) some.erase(some.begin() + 3, some.begin() + 6);
        const auto [left, right] = at_least_cost(f.all, some);
        CAPTURE(f.name, left.size(), right.size());
        group both = left;
        both.insert(both.end(), right.begin(), right.end());
        REQUIRE((!left.empty() && !right.empty()));
        REQUIRE(sorted(both) == some);
    }
}

TEST_CASE("a tree of such cuts is cheap enough", "[step4]") {
    INFO(hint("rays ask more than the handout's table says",
              "the bound is in the handout; what does your split do with a crowd beside a few large boxes?", "§4 How cheap?"));
    struct scene {
        std::string name;
        boxes all;
        double bound;
    };
    numbers random(100);
    boxes cubes, clumps{{{-1, -1, -1}, {1, -1, 1}}};
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 p = random.vector();
        cubes.push_back({p - 0.05f, p + 0.05f});
    }
    for (int i = 0; i < 10; ++i) {
        const glm::vec3 middle = random.vector();
        const float size = random.between(0.02f, 0.12f);
        for (int k = 0; k < 100; ++k) {
            const glm::vec3 p = middle + size * random.vector();
            clumps.push_back({p - 0.05f * size, p + 0.05f * size});
        }
    }
    // The cheapest cuts lead to 56.9 and 6.52; cuts in the middle to 61.6 and 8.01.
    for (const scene& s : {scene{"a cloud", cubes, 59}, scene{"ten clumps above a floor", clumps, 7}}) {
        const double middle = cost_of(grown(s.all, [&](const group& some) { return in_the_middle(s.all, some); }, 4));
        const double yours = cost_of(grown(s.all, [&](const group& some) {
            halves parts = at_least_cost(s.all, some);
            if (parts.left.empty() || parts.right.empty() || parts.left.size() + parts.right.size() != some.size())
                throw std::runtime_error("the halves of " + std::to_string(some.size()) + " surfaces are of " + std::to_string(parts.left.size()) +
                                         " and " + std::to_string(parts.right.size()));
            return parts;
        }, 4));
        CAPTURE(s.name, middle, yours);
        CHECK(yours <= s.bound);
    }
}

// ---- Step 5: a tree from the bottom up -----------------------------------------------------------------------------

TEST_CASE("every surface has a leaf of its own", "[step5]") {
    INFO(hint("things are missing, or the program does not end",
              "n leaves of one surface and n - 1 joints; the root is nodes[0], and children stand behind their parents",
              "§5 Room for the tree"));
    for (const family& f : families()) {
        const tree t = bottom_up(f.all);
        const walk seen = walk_through(t, f.all.size());
        CAPTURE(f.name);
        REQUIRE(seen.broken == "");
        REQUIRE(seen.leaves == f.all.size());
    }
}

TEST_CASE("a joint's box is the smallest around both that are joined", "[step5]") {
    INFO(hint("things are cut off, or rays ask too much", "enclose both, and nothing else", "§5 From the bottom up"));
    for (const family& f : families()) {
        const tree t = bottom_up(f.all);
        const walk seen = walk_through(t, f.all.size());
        CAPTURE(f.name);
        REQUIRE(seen.broken == "");
        REQUIRE(wrong_box(t, seen, f.all) == "");
    }
}

TEST_CASE("what lies together is joined first", "[step5]") {
    INFO(hint("couples are torn apart",
              "the partner is the one with the smallest common box, wherever it stands in the list", "§5 From the bottom up"));
    numbers random(14);
    boxes all(32);
    for (std::uint32_t i = 0; i < 16; ++i) {  // couples, 16 + (5 i mod 16) is the partner of i
        const glm::vec3 p(float(i % 4), float(i / 4), 0);
        all[i] = {p, p + 0.05f};
        all[16 + 5 * i % 16] = {p + 0.06f, p + 0.1f};
    }
    const tree t = bottom_up(all);
    const walk seen = walk_through(t, 32);
    REQUIRE(seen.broken == "");
    for (std::uint32_t i = 0; i < 16; ++i) {
        const group couple{i, 16 + 5 * i % 16};
        CAPTURE(couple);
        CHECK(std::find(seen.below.begin(), seen.below.end(), couple) != seen.below.end());
    }
}

TEST_CASE("each time the two with the smallest common box are joined", "[step5]") {
    INFO(hint("the tree is worse than from the top down",
              "look at all pairs of what is not joined yet, joints too; their area, not their distance or their volume", "§5 From the bottom up"));
    numbers random(15);
    for (const std::size_t count : {3u, 10u, 40u}) {
        boxes all = cloud(random, count, 0.3f);
        for (std::size_t i = 0; i < count; i += 3) all[i].max[int(i / 3 % 3)] += 1.5f;  // long ones among them
        const tree t = bottom_up(all);
        const walk seen = walk_through(t, count);
        CAPTURE(count);
        REQUIRE(seen.broken == "");
        // Joins again what the tree says is joined, the smallest first, and looks each time whether there was a smaller one.
        std::vector<std::uint32_t> active;
        for (std::uint32_t i = 0; i < t.nodes.size(); ++i)
            if (t.nodes[i].count > 0) active.push_back(i);
        while (active.size() > 1) {
            double least = std::numeric_limits<double>::infinity(), least_joined = least;
            std::uint32_t next = 0;
            for (const std::uint32_t a : active)
                for (const std::uint32_t b : active)
                    if (a != b) least = std::min(least, area(enclose(t.nodes[a].box, t.nodes[b].box)));
            for (std::uint32_t i = 0; i < t.nodes.size(); ++i) {
                const node& n = t.nodes[i];
                const auto is_active = [&](std::uint32_t k) { return std::find(active.begin(), active.end(), k) != active.end(); };
                if (n.count > 0 || !is_active(n.left) || !is_active(n.right)) continue;
                const double both = area(enclose(t.nodes[n.left].box, t.nodes[n.right].box));
                if (both < least_joined) least_joined = both, next = i;
            }
            CAPTURE(active.size(), next);
            REQUIRE(least_joined <= least * (1 + 1e-6));
            std::erase(active, t.nodes[next].left);
            std::erase(active, t.nodes[next].right);
            active.push_back(next);
        }
    }
}

TEST_CASE("from the bottom up one is one leaf, and nothing has no nodes", "[step5]") {
    INFO(hint("an empty scene crashes", "2 n - 1 nodes are none too few for n = 1 and far too many for n = 0", "§5 Room for the tree"));
    CHECK(bottom_up(boxes{}).nodes.empty());
    const tree t = bottom_up(boxes{{{1, 2, 3}, {4, 5, 6}}});
    REQUIRE(t.nodes.size() == 1);
    CHECK(t.nodes[0].count == 1);
}

// ---- Step 6: the closest hit ---------------------------------------------------------------------------------------

TEST_CASE("the closest hit is the one that asking every surface finds", "[step6]") {
    INFO(hint("things are missing, or those behind are seen through those in front",
              "after a hit the rest of the tree may still hold a nearer one; look into both children", "§6 Two questions"));
    for_made_up(16, [](const situation& s) {
        const auto right = first_of_all(s);
        const interview seen = traversed(s);
        REQUIRE(seen.closest.has_value() == right.has_value());
        if (right) {
            CAPTURE(*right, *s.hit[*right], seen.which, *seen.closest);
            REQUIRE(*seen.closest == *s.hit[*right]);
        }
    });
}

TEST_CASE("of two hits at the same t both are found", "[step6]") {
    INFO(hint("which of two coincident surfaces is seen depends on the tree",
              "a box that is entered exactly where the range ends still counts: skip it only when it is entered beyond", "§6 Pruned"));
    for_made_up(17, [](const situation& s) {
        const auto right = first_of_all(s);
        const interview seen = traversed(s);
        if (right && seen.closest) REQUIRE(seen.which == *right);
    });
}

TEST_CASE("among balls, too, and along the faces of boxes", "[step6]") {
    INFO(hint("holes, or lines through the picture",
              "believe the answers: t = 0 is an entry too, and std::nullopt is none", "§6 Two questions"));
    numbers random(18);
    std::vector<ball> balls = ball_cloud(300);
    for (int i = 0; i < 64; ++i) balls.push_back({glm::vec3(i % 4, i / 4 % 4, i / 16) * 0.5f - 1.0f, 0.25f});  // they touch each other
    for (int i = 0; i < 20; ++i) balls.push_back(balls[std::size_t(i)]);
    const boxes all = bounds(balls);
    for (const std::size_t leaf_size : {1u, 4u}) {
        const tree t = balanced(all, leaf_size);
        for (int i = 0; i < 120; ++i) {
            ray r = into_the_cloud(random);
            const aabb& some = all[std::size_t(random.unit() * float(all.size()))];
            if (i % 4 == 1) r.origin = glm::dvec3(center(some));                     // from inside
            if (i % 4 == 2) r = {glm::dvec3(some.min) - glm::dvec3(0, 0, 3), {0, 0, 1}};  // along an edge
            if (i % 4 == 3) r = {glm::dvec3(some.max), {-0.0, random.unit() < 0.5f ? -1 : 1, -0.0}};
            const situation s = seen_along(r, t, balls);
            const auto right = first_of_all(s);
            const interview seen = traversed(s);
            CAPTURE(leaf_size, i, r.origin, r.direction);
            REQUIRE(seen.closest.has_value() == right.has_value());
            if (right) REQUIRE((*seen.closest == *s.hit[*right] && seen.which == *right));
        }
    }
}

TEST_CASE("nothing is asked about what the ray misses", "[step6]") {
    INFO(hint("the tree is hardly faster than no tree",
              "what is in a box that is missed is missed: ask neither about its children nor about its surfaces", "§6 Two questions"));
    for_made_up(19, [](const situation& s) { REQUIRE(traversed(s).missed == ""); });
}

TEST_CASE("nothing is asked twice", "[step6]") {
    INFO(hint("rays ask twice as much as they need to", "remember the answer about a child until its turn comes", "§6 Two questions"));
    for_made_up(20, [](const situation& s) { REQUIRE(traversed(s).twice == ""); });
}

TEST_CASE("nothing is asked about what lies beyond the nearest hit so far", "[step6]") {
    INFO(hint("a hidden crowd costs as much as a visible one",
              "when a node's turn comes, compare its entry with the end of what remains by now, not with what remained when it was asked about",
              "§6 Pruned"));
    for_made_up(21, [](const situation& s) { REQUIRE(traversed(s).beyond == ""); });
}

TEST_CASE("the child that is entered first is opened first", "[step6]") {
    INFO(hint("from one side the scene renders faster than from the other",
              "left and right are names only: compare the two entries", "§6 The nearer first"));
    for_made_up(22, [](const situation& s) { REQUIRE(traversed(s).wrong_order == ""); });
}

TEST_CASE("each surface is offered what remains of the range", "[step6]") {
    INFO(hint("what lies behind is found, and costs time", "the answer to an offer is the range for the next one", "§6 Pruned"));
    for_made_up(23, [](const situation& s) { REQUIRE(traversed(s, {1, 8}).stale == ""); });
}

TEST_CASE("when nothing remains of the range nothing more is asked", "[step6]") {
    INFO(hint("a ray that could stop goes on",
              "stop when the answer to an offer is an empty range; and do not begin with one", "§6 The end"));
    for_made_up(24, [](const situation& s) {
        REQUIRE(traversed(s, {}, true).late == "");
        const interview none = traversed(s, {5, 5});
        REQUIRE(none.questions + none.offers == 0);
    });
    const interview nobody = traversed({});
    CHECK(nobody.questions + nobody.offers == 0);
}

TEST_CASE("the tree may be as deep as it has leaves", "[step6]") {
    INFO(hint("things are missing, or the program crashes, in deep trees",
              "a stack of fixed size is too small for some tree: use a std::vector, or recursion", "§6 A stack"));
    situation s = chain(1000);
    s.hit.assign(1000, std::nullopt);
    s.hit[999] = 20.0f;
    const interview seen = traversed(s);
    CHECK(seen.offers == 1000);
    CHECK(seen.closest.has_value());
}

TEST_CASE("a ray asks no more than the handout's table says", "[step6]") {
    INFO(hint("O(N), or nearly so",
              "the table is in the handout: compare the counts, and find out which of the laws above is broken", "§6 Fast enough"));
    struct line {
        std::uint32_t count;
        double questions, offers;
    };
    // A fifth above what a traversal takes that opens the nearer child first: 9.0 and 6.1, 24.9 and 12.7, 40.2 and 15.7, 50.6 and 16.5.
    for (const line& bound : {line{32, 11, 8}, line{256, 30, 16}, line{2048, 49, 19}, line{16384, 61, 20}}) {
        const std::vector<ball> balls = ball_cloud(bound.count);
        const tree t = balanced(bounds(balls));
        numbers random(25);
        double questions = 0, offers = 0;
        constexpr int rays = 60;
        for (int i = 0; i < rays; ++i) {
            const interview seen = traversed(seen_along(into_the_cloud(random), t, balls));
            questions += double(seen.questions) / rays, offers += double(seen.offers) / rays;
        }
        CAPTURE(bound.count, questions, offers);
        CHECK(questions <= bound.questions);
        CHECK(offers <= bound.offers);
    }
}

// ---- Step 7: is anything in the way? -------------------------------------------------------------------------------

TEST_CASE("the answer is the one that asking every surface gives", "[step7]") {
    INFO(hint("shadows are missing, or everything is dark", "true when any surface blocks; false only when none does", "§7 Any will do"));
    for_made_up(26, [](const situation& s) {
        for (const float light : {2.0f, 5.0f, 9.0f, lantern::infinity}) {
            CAPTURE(light);
            REQUIRE(shadowed(s, {0, light}).dark == first_of_all(s, {0, light}).has_value());
        }
    });
}

TEST_CASE("the first that blocks ends the search", "[step7]") {
    INFO(hint("shadow rays cost as much as the others", "any will do: return at once, from all levels", "§7 Any will do"));
    for_made_up(27, [](const situation& s) { REQUIRE(shadowed(s).seen.late == ""); });
}

TEST_CASE("nothing is asked about what lies beyond the light", "[step7]") {
    INFO(hint("lamps are as slow as the sky", "compare the entry with the end of the range", "§7 Up to the light"));
    for_made_up(28, [](const situation& s) { REQUIRE(shadowed(s, {0, 5}).seen.beyond == ""); });
}

TEST_CASE("a shadow ray asks nothing about what it misses, and nothing twice", "[step7]") {
    INFO(hint("the tree is hardly faster than no tree", "what is in a box that is missed is missed", "§7 Any will do"));
    for_made_up(29, [](const situation& s) {
        const interview seen = shadowed(s).seen;
        REQUIRE(seen.missed == "");
        REQUIRE(seen.twice == "");
    });
}

TEST_CASE("nothing blocks in an empty tree or an empty range", "[step7]") {
    INFO(hint("a crash without surfaces, or shadows on the lamp itself",
              "no nodes, no question; and an empty range holds no hit", "§7 Up to the light"));
    CHECK_FALSE(shadowed({}).dark);
    for_made_up(30, [](const situation& s) {
        const auto [dark, seen] = shadowed(s, {5, 5});
        REQUIRE_FALSE(dark);
        REQUIRE(seen.questions + seen.offers == 0);
    });
}

TEST_CASE("a shadow ray, too, finds its way through a deep tree", "[step7]") {
    INFO(hint("light leaks through, or the program crashes, in deep trees",
              "a stack of fixed size is too small for some tree", "§6 A stack"));
    situation s = chain(1000);
    s.hit.assign(1000, std::nullopt);
    CHECK_FALSE(shadowed(s).dark);
    for (const std::size_t blocker : {0u, 500u, 999u}) {
        s.hit.assign(1000, std::nullopt);
        s.hit[blocker] = 20.0f;
        CAPTURE(blocker);
        CHECK(shadowed(s).dark);
    }
}

// ---- Step 8: things that move --------------------------------------------------------------------------------------

TEST_CASE("every box holds its surfaces during the whole exposure", "[step8]") {
    INFO(hint("moving things are cut off", "both ends of the exposure count, in every leaf and in all nodes above it", "§8 Both ends"));
    numbers random(31);
    for (const std::size_t leaf_size : {1u, 4u})
        for (const std::uint32_t count : {1u, 2u, 50u}) {
            const boxes opening = cloud(random, count, 0.1f);
            boxes closing;
            for (const aabb& box : opening) {
                const glm::vec3 way = random.vector();
                closing.push_back({box.min + way, box.max + way});
            }
            const tree before = balanced(opening, leaf_size), after = refit(before, opening, closing);
            const walk seen = walk_through(after, count);
            CAPTURE(leaf_size, count);
            REQUIRE(seen.broken == "");
            for (std::size_t i = 0; i < after.nodes.size(); ++i)
                for (const std::uint32_t k : seen.below[i])
                    for (const float time : {0.0f, 0.3f, 1.0f})
                        for (int axis = 0; axis < 3; ++axis) {
                            const aabb& box = after.nodes[i].box;
                            CAPTURE(i, k, time, axis);
                            REQUIRE(box.min[axis] <= glm::mix(opening[k].min[axis], closing[k].min[axis], time) + 1e-6f);
                            REQUIRE(box.max[axis] >= glm::mix(opening[k].max[axis], closing[k].max[axis], time) - 1e-6f);
                        }
        }
}

TEST_CASE("no box is larger than the exposure asks for", "[step8]") {
    INFO(hint("with every frame the tree gets slower",
              "begin with the empty box: where things were in the last frame does not matter", "§8 Both ends"));
    numbers random(32);
    const boxes once = cloud(random, 60, 0.1f), opening = cloud(random, 60, 0.1f), closing = cloud(random, 60, 0.1f);
    boxes both;
    for (std::size_t i = 0; i < 60; ++i) both.push_back(around({opening[i], closing[i]}, {0, 1}));
    const tree after = refit(balanced(once), opening, closing);
    const walk seen = walk_through(after, 60);
    REQUIRE(seen.broken == "");
    CHECK(wrong_box(after, seen, both) == "");
}

TEST_CASE("nothing but the boxes changes", "[step8]") {
    INFO(hint("things are mistaken for each other",
              "the tree stays as it is: the same children, the same leaves, the same order", "§8 The same tree"));
    numbers random(33);
    const boxes opening = cloud(random, 40, 0.1f), closing = cloud(random, 40, 0.1f);
    const tree before = balanced(opening), after = refit(before, opening, closing);
    REQUIRE(after.nodes.size() == before.nodes.size());
    CHECK(after.order == before.order);
    for (std::size_t i = 0; i < before.nodes.size(); ++i) {
        const node &a = before.nodes[i], &b = after.nodes[i];
        CAPTURE(i);
        REQUIRE((a.left == b.left && a.right == b.right && a.first == b.first && a.count == b.count));
    }
    CHECK(refit({}, {}, {}).nodes.empty());
}

TEST_CASE("a list of another length is refused", "[step8]") {
    INFO(hint("memory that is not yours is read",
              "compare both lengths with the number of surfaces, and throw std::invalid_argument", "§8 Both ends"));
    numbers random(34);
    const boxes some = cloud(random, 10, 0.1f), fewer(some.begin(), some.end() - 1);
    const tree t = balanced(some);
    CHECK_THROWS_AS(refit(t, fewer, some), std::invalid_argument);
    CHECK_THROWS_AS(refit(t, some, fewer), std::invalid_argument);
}
