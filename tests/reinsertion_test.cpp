// SPDX-License-Identifier: MIT
#include <lantern/reinsertion.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

using lantern::aabb;
using lantern::cluster;
using lantern::reinsertion;

namespace {

using tree = std::vector<cluster>;

// Joined in a bad order: each with whatever comes next.
tree joined_blindly(const std::vector<aabb>& boxes) {
    tree t;
    std::vector<std::uint32_t> open, next;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        t.push_back({boxes[i], i});
        open.push_back(i);
    }
    while (open.size() > 1) {
        next.clear();
        for (std::size_t i = 0; i + 1 < open.size(); i += 2) {
            next.push_back(static_cast<std::uint32_t>(t.size()));
            t.push_back(joined(t, open[i], open[i + 1]));
        }
        if (open.size() % 2 == 1) next.push_back(open.back());
        open = next;
    }
    // The last box may have been left over until late; the root is the last all the same.
    return t;
}

std::vector<aabb> random_boxes(dice& d, std::uint32_t count, float size) {
    std::vector<aabb> boxes;
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::vec3 p = d.in_cube(), e = glm::abs(d.in_cube()) * size;
        boxes.push_back({p, p + e});
    }
    return boxes;
}

double surface_of_inner(const tree& t) {
    double sum = 0;
    for (const cluster& c : t) sum += c.height > 0 ? surface_area(c.box) : 0;
    return sum;
}

// From the root: every box once, and what each cluster says of itself is true.
void require_valid(const tree& t, const std::vector<aabb>& boxes) {
    REQUIRE(t.size() == 2 * boxes.size() - 1);
    std::vector<int> seen(boxes.size());
    std::vector<std::uint32_t> waiting{static_cast<std::uint32_t>(t.size() - 1)};
    std::size_t visited = 0;
    while (!waiting.empty()) {
        const cluster& c = t[waiting.back()];
        waiting.pop_back();
        ++visited;
        if (c.height == 0) {
            REQUIRE(c.size == 1);
            REQUIRE(++seen[c.left] == 1);
            REQUIRE(c.box.min == boxes[c.left].min);
            continue;
        }
        const cluster same = joined(t, c.left, c.right);
        REQUIRE((c.box.min == same.box.min && c.box.max == same.box.max && c.size == same.size && c.height == same.height));
        waiting.push_back(c.left);
        waiting.push_back(c.right);
    }
    REQUIRE(visited == t.size());
}

// The oracle's tree: nested, made anew by each change.
struct nested {
    aabb box;
    std::vector<nested> parts;  // two, or none
};
nested nest(const tree& t, std::uint32_t i) {
    if (t[i].height == 0) return {t[i].box, {}};
    return {t[i].box, {nest(t, t[i].left), nest(t, t[i].right)}};
}
double fitted_cost(nested& n) {
    if (n.parts.empty()) return 0;
    const double below = fitted_cost(n.parts[0]) + fitted_cost(n.parts[1]);
    n.box = enclose(n.parts[0].box, n.parts[1].box);
    return below + surface_area(n.box);
}
void collect_all(nested& n, std::vector<nested*>& all) {
    all.push_back(&n);
    for (nested& p : n.parts) collect_all(p, all);
}

// What is saved at most by moving the `which`-th of the tree in preorder, by trying every place.
double best_saving(const nested& whole, std::size_t which, bool& movable) {
    nested copy = whole;
    const double before = fitted_cost(copy);
    std::vector<nested*> all;
    collect_all(copy, all);
    movable = which > 0 && all[which] != &copy.parts[0] && all[which] != &copy.parts[1];
    if (!movable) return 0;
    const auto parent = static_cast<std::size_t>(std::find_if(all.begin(), all.end(), [&](nested* n) {
        return !n->parts.empty() && (&n->parts[0] == all[which] || &n->parts[1] == all[which]);
    }) - all.begin());
    const nested moved = *all[which], sibling = all[parent]->parts[&all[parent]->parts[0] == all[which] ? 1 : 0];
    *all[parent] = sibling;
    all.clear();
    collect_all(copy, all);
    double best = before;
    for (std::size_t i = 1; i < all.size(); ++i) {  // not above the root: it would be a new one
        nested tried = copy;
        std::vector<nested*> there;
        collect_all(tried, there);
        *there[i] = nested{{}, {*there[i], moved}};
        best = std::min(best, fitted_cost(tried));
    }
    return before - best;
}

void preorder(const tree& t, std::uint32_t i, std::vector<std::uint32_t>& order) {
    order.push_back(i);
    if (t[i].height == 0) return;
    preorder(t, t[i].left, order);
    preorder(t, t[i].right, order);
}

}  // namespace

TEST_CASE("two pairs that were mixed up find each other") {
    const auto cube = [](float x) { return aabb{{x, 0, 0}, {x + 1, 1, 1}}; };
    const std::vector<aabb> boxes{cube(0), cube(100), cube(1), cube(101)};
    tree t = joined_blindly(boxes);
    reinsertion r(t, 1);
    CHECK(r.cost() == 406 + 406 + 410);  // each cuboid of n x 1 x 1 has a surface of 4 n + 2
    while (r.round(1, 64)) {
    }
    require_valid(t, boxes);
    CHECK(r.cost() == 410 + 10 + 10);
}

TEST_CASE("the place that is found is the best of all places") {
    dice d{.state = 5};
    std::uint32_t moved = 0;
    for (int k = 0; k < 60; ++k) {
        const auto boxes = random_boxes(d, 3 + static_cast<std::uint32_t>(k) % 12, k % 3 == 0 ? 0.0f : 1.0f);
        const tree before = joined_blindly(boxes);
        const auto root = static_cast<std::uint32_t>(before.size() - 1);
        const nested whole = nest(before, root);
        std::vector<std::uint32_t> order;
        preorder(before, root, order);
        for (std::size_t which = 0; which < order.size(); ++which) {
            tree t = before;
            reinsertion r(t, 1);
            bool movable = false;
            const double best = best_saving(whole, which, movable), saved = r.reinsert(order[which]);
            CAPTURE(k, which, movable);
            CHECK(saved == Approx(best).margin(1e-8 * surface_of_inner(before)));
            CHECK(r.cost() == Approx(surface_of_inner(t)).epsilon(1e-12));
            require_valid(t, boxes);
            moved += saved > 0;
        }
    }
    CHECK(moved > 200);
}

TEST_CASE("a round never makes it worse, and what is not a leaf's whole stays together") {
    dice d{.state = 6};
    const auto boxes = random_boxes(d, 1000, 0.3f);
    for (const std::uint32_t leaf_size : {1u, 4u}) {
        tree t = joined_blindly(boxes);
        reinsertion r(t, leaf_size);
        double cost = r.cost();
        const double first = cost;
        while (r.round(1, 64)) {
            CHECK(r.cost() < cost);
            cost = r.cost();
        }
        CHECK(cost < (leaf_size == 1 ? 0.5 : 0.75) * first);
        require_valid(t, boxes);
        if (leaf_size == 4)  // boxes were joined four by four, and no four of them were torn apart
            for (std::uint32_t i = 0; i < 1000; i += 4)
                CHECK(std::any_of(t.begin(), t.end(), [&](const cluster& c) {
                    std::vector<std::uint32_t> members;
                    if (c.size == 4) collect(t, c, members);
                    std::sort(members.begin(), members.end());
                    return members == std::vector<std::uint32_t>{i, i + 1, i + 2, i + 3};
                }));
    }
}

TEST_CASE("it ends soon, and within its height, where boxes do not help") {
    const std::uint32_t count = 20'000;
    std::vector<std::vector<aabb>> hard(5);
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto f = static_cast<float>(i);
        hard[0].push_back({glm::vec3(0), glm::vec3(1)});                // all the same
        hard[1].push_back({glm::vec3(-f), glm::vec3(f)});               // an onion: the best tree of all is a chain
        hard[2].push_back({glm::vec3(f, 0, 0), glm::vec3(f, 0, 0)});    // points on a line: no surface anywhere
        hard[3].push_back({glm::vec3(-3e38f), glm::vec3(3e38f)});       // surfaces beyond float
        hard[4].push_back({glm::vec3(0), std::ldexp(1.0f, static_cast<int>(i % 250) - 125) * glm::vec3(1)});  // of all sizes
    }
    for (const auto& boxes : hard) {
        tree t = joined_blindly(boxes);
        const double before = surface_of_inner(t);
        lantern::reinsert_where_it_pays(t, 4, 40, 10);
        require_valid(t, boxes);
        CHECK(surface_of_inner(t) <= before * (1 + 1e-12));
        CHECK(t.back().height < 80);  // the last one may have put a high one low
    }
}

TEST_CASE("a tree that is good already is only looked at") {
    std::vector<aabb> boxes;  // neighbours on the curve are neighbours in space
    for (std::uint32_t i = 0; i < 4096; ++i) {
        glm::vec3 p(0);
        for (int bit = 0; bit < 12; ++bit) p[bit % 3] += static_cast<float>((i >> bit & 1) << (bit / 3));
        boxes.push_back({p, p + 1.0f});
    }
    tree t = joined_blindly(boxes);
    const double before = surface_of_inner(t);
    lantern::reinsert_where_it_pays(t, 4, 64, 10);
    CHECK(surface_of_inner(t) == before);
}

TEST_CASE("one box, and two, stay as they are") {
    for (const std::uint32_t count : {1u, 2u, 3u}) {
        dice d{.state = 7};
        const auto boxes = random_boxes(d, count, 1);
        tree t = joined_blindly(boxes);
        lantern::reinsert_where_it_pays(t, 1, 64, 3);
        require_valid(t, boxes);
    }
}
