// SPDX-License-Identifier: MIT
// Lab 10's hidden tests: the laws of the public suite, for boxes, trees and rays drawn anew for each grading. Returned trees are looked
// at and not believed, and what a traversal asks is counted here. Nothing is left to chance: no two centres are nearer than rounding.

#include "interview.hpp"
#include "trees.hpp"

#include <catch.hpp>
#include <hidden.hpp>

#include <array>

using namespace lab10_suite;

namespace {

boxes any_boxes(numbers& random, std::uint32_t least, std::uint32_t most) {
    const std::uint32_t count = least + hidden::below(random, most - least + 1);
    return cloud(random, count, random.between(0.02f, 0.5f));
}

group any_group(numbers& random, std::size_t of, std::size_t least) {
    group some = all_of(of);
    for (std::size_t i = of; i > 1; --i) std::swap(some[i - 1], some[hidden::below(random, std::uint32_t(i))]);
    some.resize(least + hidden::below(random, std::uint32_t(of - least + 1)));
    return some;
}

group together(const halves& parts) {
    group both = parts.left;
    both.insert(both.end(), parts.right.begin(), parts.right.end());
    return sorted(both);
}

double price(const boxes& all, const halves& parts) {
    return area(around(all, parts.left)) * double(parts.left.size()) + area(around(all, parts.right)) * double(parts.right.size());
}

/// The lowest and the highest centre along an axis.
std::pair<float, float> reach(const boxes& all, const group& some, int axis) {
    float lowest = lantern::infinity, highest = -lantern::infinity;
    for (const std::uint32_t i : some) lowest = std::min(lowest, center(all.at(i))[axis]), highest = std::max(highest, center(all.at(i))[axis]);
    return {lowest, highest};
}

/// How much farther the centres spread along the axis on which they spread the most than along the next one.
bool clearly_widest(const boxes& all, const group& some) {
    std::array<float, 3> spread{};
    for (int k = 0; k < 3; ++k) spread[std::size_t(k)] = reach(all, some, k).second - reach(all, some, k).first;
    std::sort(spread.begin(), spread.end());
    return spread[2] > 1.0001f * spread[1];
}

template <class Check>
void for_any_situation(std::uint64_t test, Check check) {
    numbers random = hidden::drawn(test);
    for (int i = 0; i < 60; ++i) check(made_up(random, 1 + hidden::below(random, 40)), random);
}

}  // namespace

TEST_CASE("the box around any group", "[step1]") {
    numbers random = hidden::drawn(1);
    for (int i = 0; i < 60; ++i) {
        const boxes all = any_boxes(random, 1, 60);
        const group some = any_group(random, all.size(), 1);
        CHECK(same(box_around(all, some), around(all, some)));
    }
}

TEST_CASE("any group, divided", "[step2]") {
    numbers random = hidden::drawn(2);
    for (int i = 0; i < 60; ++i) {
        const boxes all = any_boxes(random, 2, 60);
        const group some = any_group(random, all.size(), 2);
        const halves median = at_median(all, some), middle = at_middle(all, some);
        CHECK(together(median) == sorted(some));
        CHECK(together(middle) == sorted(some));
        CHECK(median.left.size() == some.size() / 2);
        CHECK((!middle.left.empty() && !middle.right.empty()));
        if (!clearly_widest(all, some)) continue;
        const int axis = widest(all, some);
        CHECK(reach(all, median.left, axis).second <= reach(all, median.right, axis).first + 1e-6f);
        const auto [lowest, highest] = reach(all, some, axis);
        CHECK(reach(all, middle.left, axis).second <= (lowest + highest) / 2 + 1e-6f);
        CHECK(reach(all, middle.right, axis).first >= (lowest + highest) / 2 - 1e-6f);
    }
}

TEST_CASE("a tree from the top down over any boxes, by any split", "[step3]") {
    numbers random = hidden::drawn(3);
    for (int i = 0; i < 20; ++i) {
        const boxes all = any_boxes(random, 1, 80);
        const std::uint32_t leaf_size = 1 + hidden::below(random, 5), cap = hidden::below(random, 40);
        std::vector<std::pair<group, halves>> said;
        const tree t = build(all, [&](group_in some) {
            if (said.size() > 1000) throw std::runtime_error("the split was asked more than 1000 times");
            const group whole(some.begin(), some.end());
            const halves parts = cut(whole, 1 + hidden::below(random, std::uint32_t(std::max<std::size_t>(whole.size(), 2) - 1)));
            said.push_back({sorted(whole), parts});
            return parts;
        }, leaf_size, cap);
        const walk seen = walk_through(t, all.size());
        REQUIRE(seen.broken == "");
        CHECK(wrong_box(t, seen, all) == "");
        CHECK(seen.deepest <= cap);
        for (std::size_t k = 0; k < t.nodes.size(); ++k) {
            const group& inside = seen.below[k];
            CHECK((t.nodes[k].count > 0) == (inside.size() <= leaf_size || seen.depth[k] == cap));
            if (t.nodes[k].count > 0) continue;
            const auto when = std::find_if(said.begin(), said.end(), [&](const auto& one) { return one.first == inside; });
            REQUIRE(when != said.end());
            CHECK(seen.below[t.nodes[k].left] == sorted(when->second.left));
            CHECK(seen.below[t.nodes[k].right] == sorted(when->second.right));
        }
    }
}

TEST_CASE("what any tree costs, and its cheapest cut", "[step4]") {
    numbers random = hidden::drawn(4);
    for (int i = 0; i < 40; ++i) {
        const boxes all = any_boxes(random, 2, 40);
        const tree t = balanced(all, 1 + hidden::below(random, 4));
        const double right = cost_of(t);
        CHECK(std::abs(cost(t) - right) <= 1e-5 * right);

        const group some = any_group(random, all.size(), 2);
        double least = std::numeric_limits<double>::infinity();
        for (int axis = 0; axis < 3; ++axis) {
            group row = some;
            std::sort(row.begin(), row.end(), [&](std::uint32_t a, std::uint32_t b) { return center(all[a])[axis] < center(all[b])[axis]; });
            for (std::size_t n = 1; n < row.size(); ++n) least = std::min(least, price(all, cut(row, n)));
        }
        const halves parts = at_least_cost(all, some);
        CHECK((!parts.left.empty() && !parts.right.empty()));
        REQUIRE(together(parts) == sorted(some));
        CHECK(price(all, parts) <= least * (1 + 1e-6));
    }
}

TEST_CASE("a tree from the bottom up over any boxes", "[step5]") {
    numbers random = hidden::drawn(5);
    for (int i = 0; i < 12; ++i) {
        const boxes all = any_boxes(random, 1, 40);
        const tree t = bottom_up(all);
        const walk seen = walk_through(t, all.size());
        REQUIRE(seen.broken == "");
        REQUIRE(seen.leaves == all.size());
        REQUIRE(wrong_box(t, seen, all) == "");
        // Of all joints that can be made now, the tree's smallest is the smallest there is.
        std::vector<std::uint32_t> active;
        for (std::uint32_t k = 0; k < t.nodes.size(); ++k)
            if (t.nodes[k].count > 0) active.push_back(k);
        while (active.size() > 1) {
            double least = std::numeric_limits<double>::infinity(), joined = least;
            std::uint32_t next = 0;
            for (const std::uint32_t a : active)
                for (const std::uint32_t b : active)
                    if (a < b) least = std::min(least, area(enclose(t.nodes[a].box, t.nodes[b].box)));
            const auto is_active = [&](std::uint32_t k) { return std::find(active.begin(), active.end(), k) != active.end(); };
            for (std::uint32_t k = 0; k < t.nodes.size(); ++k)
                if (t.nodes[k].count == 0 && is_active(t.nodes[k].left) && is_active(t.nodes[k].right) && area(t.nodes[k].box) < joined)
                    joined = area(t.nodes[k].box), next = k;
            REQUIRE(joined <= least * (1 + 1e-6));
            std::erase(active, t.nodes[next].left);
            std::erase(active, t.nodes[next].right);
            active.push_back(next);
        }
    }
}

TEST_CASE("the closest hit in any tree", "[step6]") {
    for_any_situation(6, [](const situation& s, numbers& random) {
        const interval range = random.unit() < 0.5f ? interval{} : interval{1, random.between(4, 11)};
        const auto right = first_of_all(s, range);
        const interview seen = traversed(s, range);
        REQUIRE(seen.closest.has_value() == right.has_value());
        if (right) CHECK((*seen.closest == *s.hit[*right] && seen.which == *right));
    });
}

TEST_CASE("no needless question in any tree", "[step6]") {
    for_any_situation(7, [](const situation& s, numbers& random) {
        const interview seen = traversed(s, {}, random.unit() < 0.3f);
        CHECK(seen.missed == "");
        CHECK(seen.twice == "");
        CHECK(seen.beyond == "");
        CHECK(seen.wrong_order == "");
        CHECK(seen.stale == "");
        CHECK(seen.late == "");
        // All that must be asked was asked: who asks nothing asks nothing needless either.
        CHECK(seen.closest.has_value() == first_of_all(s).has_value());
        CHECK(seen.questions >= 1);
    });
}

TEST_CASE("any shadow in any tree", "[step7]") {
    for_any_situation(8, [](const situation& s, numbers& random) {
        const interval range{0, random.unit() < 0.3f ? lantern::infinity : random.between(1, 11)};
        const auto [dark, seen] = shadowed(s, range);
        CHECK(dark == first_of_all(s, range).has_value());
        CHECK(seen.missed == "");
        CHECK(seen.twice == "");
        CHECK(seen.beyond == "");
        CHECK(seen.late == "");
    });
}

TEST_CASE("any tree over things that move", "[step8]") {
    numbers random = hidden::drawn(9);
    for (int i = 0; i < 30; ++i) {
        const auto count = std::uint32_t(1 + hidden::below(random, 60));
        const boxes once = cloud(random, count, 0.2f), opening = cloud(random, count, 0.2f), closing = cloud(random, count, 0.2f);
        boxes both;
        for (std::size_t k = 0; k < count; ++k) both.push_back(around({opening[k], closing[k]}, {0, 1}));
        const tree before = balanced(once, 1 + hidden::below(random, 4)), after = refit(before, opening, closing);
        REQUIRE(after.nodes.size() == before.nodes.size());
        REQUIRE(after.order == before.order);
        for (std::size_t k = 0; k < before.nodes.size(); ++k) {
            const node &a = before.nodes[k], &b = after.nodes[k];
            REQUIRE((a.left == b.left && a.right == b.right && a.first == b.first && a.count == b.count));
        }
        CHECK(wrong_box(after, walk_through(after, count), both) == "");
    }
}
