// SPDX-License-Identifier: MIT
#include <lantern/bvh.hpp>

#include <lantern/aabb.hpp>
#include <lantern/any_of.hpp>
#include <lantern/bounding_sphere.hpp>
#include <lantern/box.hpp>
#include <lantern/closest.hpp>
#include <lantern/moving.hpp>
#include <lantern/obb.hpp>
#include <lantern/rectangle.hpp>
#include <lantern/sphere.hpp>
#include <lantern/triangle.hpp>

#include "accelerator_laws.hpp"
#include "catch.hpp"
#include "oracle.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using lantern::aabb;
using lantern::bvh;
using lantern::bvh_options;
using lantern::every;
using lantern::interval;
using lantern::ray;
using lantern::split;
using lantern::sphere;

using shape = lantern::any_of<sphere, lantern::triangle, lantern::rectangle>;

namespace mine {

/// A user's own structure, from the design: three arguments, no probe.
class flat {
public:
    explicit flat(std::vector<aabb> boxes) : boxes_(std::move(boxes)) {}
    template <class Offer>
    void traverse(const ray& r, interval range, Offer&& offer) const {
        for (std::uint32_t i = 0; i < boxes_.size() && !empty(range); ++i)
            if (overlaps(boxes_[i], r, range)) range = offer(i, range);
    }

private:
    std::vector<aabb> boxes_;
};
static_assert(lantern::accelerator<flat>);

}  // namespace mine

namespace {

std::vector<bvh_options> variants() {
    std::vector<bvh_options> all;
    for (const split rule : {split::middle, split::median, split::surface_area, split::bottom_up})
        for (const std::uint32_t leaf : {1u, 4u}) all.push_back({.rule = rule, .leaf_size = leaf});
    all.push_back({.max_depth = 3});
    all.push_back({.max_depth = 0});
    return all;
}

std::string name(const bvh_options& o) {
    return "rule " + std::to_string(static_cast<int>(o.rule)) + ", leaf " + std::to_string(o.leaf_size) + ", depth " +
           std::to_string(o.max_depth);
}

std::vector<shape> mixture(dice& d, std::uint32_t count, float reach, float size) {
    std::vector<shape> shapes;
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::vec3 p = d.in_cube(reach), a = d.in_cube(size), b = d.in_cube(size);
        if (i % 3 == 0) shapes.emplace_back(sphere{p, 0.3f * size});
        if (i % 3 == 1) shapes.emplace_back(lantern::triangle{p, p + a, p + b});
        if (i % 3 == 2) shapes.emplace_back(lantern::rectangle{p, a, b});
    }
    return shapes;
}

/// Rays that a structure may get wrong: along axes, with -0, from far away, from a box's corner, of any length.
ray adversarial(dice& d, const aabb& scene) {
    ray r{d.in_cube(2), d.in_cube()};
    for (int k = 0; k < 3; ++k) {
        const std::uint32_t kind = d.below(8);
        if (kind == 0) r.direction[k] = 0;
        if (kind == 1) r.direction[k] = -0.0f;
        if (kind == 2) r.origin[k] = scene.min[k];
        if (kind == 3) r.origin[k] = scene.max[k];
        if (kind == 4) r.direction[k] *= 1e-20f;
    }
    if (d.below(4) == 0) r.direction *= d.magnitude_between(-15, 15);
    if (d.below(4) == 0) r.origin *= d.magnitude_between(0, 6);
    return r;
}

struct summary {
    std::uint32_t depth = 0, largest_leaf = 0, leaves = 0;
};

/// Walks the tree by its nodes; every child's box must lie within its parent's.
summary inspect(const bvh<>& tree) {
    summary s;
    const auto nodes = tree.nodes();
    std::function<void(std::uint32_t, std::uint32_t)> visit = [&](std::uint32_t i, std::uint32_t depth) {
        REQUIRE(i < nodes.size());
        s.depth = std::max(s.depth, depth);
        const auto& n = nodes[i];
        if (n.size > 0) {
            ++s.leaves;
            s.largest_leaf = std::max(s.largest_leaf, std::uint32_t{n.size});
            REQUIRE(n.first + n.size <= tree.indices().size());
            return;
        }
        for (const std::uint32_t child : {n.first, n.first + 1}) {
            REQUIRE(contains(n.volume, nodes[child].volume.min));
            REQUIRE(contains(n.volume, nodes[child].volume.max));
            visit(child, depth + 1);
        }
    };
    if (!nodes.empty()) visit(0, 0);
    return s;
}

/// Every index once, whatever the rule.
void check_complete(const bvh<>& tree, std::uint32_t count) {
    std::vector<std::uint32_t> seen(tree.indices().begin(), tree.indices().end());
    std::sort(seen.begin(), seen.end());
    REQUIRE(seen.size() + tree.left_out() == count);
    REQUIRE(std::adjacent_find(seen.begin(), seen.end()) == seen.end());
}

template <class Surfaces, class Ray>
void check_same(const bvh<>& tree, const Surfaces& surfaces, const Ray& r, interval range = {}) {
    const every all{static_cast<std::uint32_t>(surfaces.size())};
    const auto expected = closest(all, surfaces, r, range), got = closest(tree, surfaces, r, range);
    REQUIRE(expected.has_value() == got.has_value());
    REQUIRE(occluded(tree, surfaces, r, range) == expected.has_value());
    if (!expected) return;
    REQUIRE(expected->index == got->index);
    REQUIRE(expected->t == got->t);
    REQUIRE(expected->point == got->point);
    REQUIRE(expected->normal == got->normal);
}

}  // namespace

TEST_CASE("the tree finds what brute force finds: every rule, random and adversarial rays") {
    for (const bvh_options& options : variants()) {
        INFO(name(options));
        dice d{.state = 2};
        for (const float size : {0.05f, 0.5f}) {
            const auto shapes = mixture(d, 200, 1, size);
            const bvh tree(shapes, options);
            check_complete(tree, 200);
            const aabb scene = tree.nodes()[0].volume;
            for (int i = 0; i < 1000; ++i) {
                const ray r = adversarial(d, scene);
                check_same(tree, shapes, r, i % 3 == 0 ? interval{d.between(0, 1), d.between(0, 3)} : interval{});
            }
        }
    }
}

TEST_CASE("the tree finds what brute force finds at any scale and far from the origin") {
    dice d{.state = 3};
    for (const float scale : {1e-15f, 1e-3f, 1e12f}) {
        for (const float far : {0.0f, 300.0f}) {
            std::vector<shape> shapes;
            for (int i = 0; i < 100; ++i)
                shapes.emplace_back(sphere{scale * (glm::vec3(far) + d.in_cube()), scale * 0.2f * d.between(0, 1)});
            const bvh tree(shapes);
            check_complete(tree, 100);
            for (int i = 0; i < 2000; ++i) {
                const glm::vec3 from = d.in_cube(3);
                check_same(tree, shapes, ray{scale * (glm::vec3(far) + from), d.in_cube() - from});
            }
        }
    }
}

TEST_CASE("moving surfaces are found at any time") {
    dice d{.state = 4};
    std::vector<lantern::moving<sphere>> balls;
    for (int i = 0; i < 150; ++i) balls.push_back({{d.in_cube(), d.between(0.01, 0.2)}, d.in_cube(0.7)});
    for (const split rule : {split::middle, split::median, split::surface_area, split::bottom_up}) {
        const bvh tree(balls, {.rule = rule});
        for (int i = 0; i < 5000; ++i)
            check_same(tree, balls, lantern::timed_ray{{d.in_cube(2), d.in_cube()}, d.between(0, 1)});
    }
}

TEST_CASE("nothing, one surface, two surfaces") {
    for (const bvh_options& options : variants()) {
        for (const std::uint32_t count : {0u, 1u, 2u}) {
            const std::vector<sphere> spheres(count, sphere{{0, 0, -3}, 1});
            const bvh tree(spheres, options);
            CHECK(tree.size() == count);
            CHECK(tree.nodes().empty() == (count == 0));
            const auto h = closest(tree, spheres, ray{});
            CHECK(h.has_value() == (count > 0));
            if (h) CHECK(h->index == 0);
        }
    }
}

TEST_CASE("a hundred thousand duplicates are divided all the same") {
    const std::vector<aabb> boxes(100000, aabb{{0, 0, 0}, {1, 1, 1}});
    for (const split rule : {split::middle, split::median, split::surface_area, split::bottom_up}) {
        const bvh tree(boxes, {.rule = rule});
        const summary s = inspect(tree);
        CHECK(s.largest_leaf <= 4);
        CHECK(s.depth <= 16);
        check_complete(tree, 100000);
    }
}

TEST_CASE("centers that are equal, on a line, or all over the scales do not stop the build") {
    dice d{.state = 6};
    std::vector<aabb> concentric, line, scales;
    for (int i = 1; i <= 3000; ++i) {
        concentric.push_back({glm::vec3(-float(i)), glm::vec3(float(i))});
        line.push_back({{float(i), 0, 0}, {float(i) + 1, 0, 0}});
        const glm::vec3 p(d.magnitude_between(-37, 37));
        scales.push_back({p, p});
    }
    for (const bvh_options& options : variants())
        for (const auto& boxes : {concentric, line, scales}) {
            const bvh tree(boxes, options);
            const summary s = inspect(tree);
            CHECK(s.depth <= options.max_depth);
            if (options.max_depth > 12) CHECK(s.largest_leaf <= options.leaf_size);
            check_complete(tree, 3000);
        }
}

TEST_CASE("the cap on the depth holds, and the leaves stay small as long as halving can make them so") {
    std::vector<aabb> geometric;  // each rule but the median would peel them off one by one
    for (int i = 0; i < 120; ++i) geometric.push_back({glm::vec3(std::ldexp(1.0f, i - 60)), glm::vec3(std::ldexp(1.0f, i - 60))});
    for (const split rule : {split::middle, split::median, split::surface_area, split::bottom_up}) {
        for (std::uint32_t cap = 0; cap <= 64; ++cap) {
            const summary s = inspect(bvh(geometric, {.rule = rule, .leaf_size = 1, .max_depth = cap}));
            REQUIRE(s.depth <= cap);
            if (cap >= 7) REQUIRE(s.largest_leaf == 1);  // 2^7 >= 120
            if (cap < 7) REQUIRE(s.largest_leaf == (120 + (1u << cap) - 1) >> cap);
        }
    }
}

TEST_CASE("surfaces that are not finite are left out and counted, and the others are found") {
    constexpr float bad = std::numeric_limits<float>::quiet_NaN(), inf = lantern::infinity;
    const std::vector<aabb> boxes{{{0, 0, 0}, {1, 1, 1}},   {{bad, 0, 0}, {1, 1, 1}}, {{0, 0, 0}, {bad, 1, 1}},
                                  {{-inf, 0, 0}, {1, 1, 1}}, {{0, 0, 0}, {1, inf, 1}}, {},
                                  {{2, 2, 2}, {3, 3, 3}}};
    const bvh tree(boxes);
    CHECK(tree.left_out() == 5);
    CHECK(tree.size() == 7);
    check_complete(tree, 7);
    const std::vector<sphere> spheres{{{0, 0, bad}, 1}, {{0, 0, -5}, 1}, {{0, bad, -3}, 1}, {{0, 0, -3}, inf}};
    const bvh some(spheres);
    CHECK(some.left_out() == 3);
    CHECK(closest(some, spheres, ray{})->index == 1);
}

TEST_CASE("options that cannot be are refused") {
    const std::vector<aabb> boxes(3);
    CHECK_THROWS_WITH(bvh(boxes, {.leaf_size = 0}), containing("leaf_size"));
    CHECK_THROWS_WITH(bvh(boxes, {.max_depth = 65}), containing("max_depth is 65"));
}

TEST_CASE("a structure of one's own plugs in and agrees") {
    dice d{.state = 7};
    const auto shapes = mixture(d, 90, 1, 0.3f);
    std::vector<aabb> boxes;
    for (const auto& s : shapes) boxes.push_back(bounds(s));
    const mine::flat own(boxes);
    const bvh tree(shapes);
    for (int i = 0; i < 3000; ++i) {
        const ray r = adversarial(d, tree.nodes()[0].volume);
        const auto a = closest(own, shapes, r), b = closest(tree, shapes, r);
        REQUIRE(a.has_value() == b.has_value());
        if (a) REQUIRE((a->index == b->index && a->t == b->t));
    }
}

TEST_CASE("the surface area rule looks at few of a thousand spheres") {
    dice d{.state = 8};
    std::vector<sphere> spheres;
    for (int i = 0; i < 1000; ++i) spheres.push_back({d.in_cube(10), 0.3f});
    std::uint64_t offers[4] = {}, nodes[4] = {};
    int rule = 0;
    for (const split s : {split::middle, split::median, split::surface_area, split::bottom_up}) {
        const bvh tree(spheres, {.rule = s});
        lantern::probe counter;
        dice e{.state = 9};
        for (int i = 0; i < 2000; ++i) (void)closest(tree, spheres, ray{e.in_cube(20), e.in_cube()}, {}, counter);
        offers[rule] = counter.offers;
        nodes[rule++] = counter.nodes;
    }
    const auto a_ray = [](std::uint64_t count) { return static_cast<double>(count) / 2000; };
    INFO("offers a ray: " << a_ray(offers[0]) << " " << a_ray(offers[1]) << " " << a_ray(offers[2]) << " "
                          << a_ray(offers[3]) << "; nodes " << a_ray(nodes[0]) << " " << a_ray(nodes[1]) << " "
                          << a_ray(nodes[2]) << " " << a_ray(nodes[3]));
    CHECK(offers[2] < 10 * 2000);
    CHECK(nodes[2] < 40 * 2000);
    CHECK(offers[2] <= offers[1]);
    CHECK(offers[3] < 10 * 2000);
    CHECK(nodes[3] < 40 * 2000);
}

TEST_CASE("a shadow ray stops at the first surface that the tree offers and it meets") {
    const std::vector<sphere> same(100, sphere{{0, 0, 0}, 1});
    const bvh tree(same);
    lantern::probe counter;
    CHECK(occluded(tree, same, ray{{0, 0, 0.5f}, {0, 0, 1}}, {}, counter));
    CHECK(counter.offers == 1);
}

TEST_CASE("what lies behind a hit is not looked at") {
    std::vector<sphere> row;
    for (int i = 0; i < 1024; ++i) row.push_back({{0, 0, -2.0f * float(i + 1)}, 0.5f});
    for (const split rule : {split::middle, split::median, split::surface_area, split::bottom_up}) {
        const bvh tree(row, {.rule = rule});
        lantern::probe near, far;
        CHECK(closest(tree, row, ray{{0, 0, 0}, {0, 0, -1}}, {}, near)->index == 0);
        CHECK(closest(tree, row, ray{{0, 0, -3000}, {0, 0, 1}}, {}, far)->index == 1023);
        CHECK(near.offers <= 8);
        CHECK(far.offers <= 8);
        CHECK(near.nodes <= 40);
        CHECK(far.nodes <= 40);
    }
}

TEST_CASE("bvh: every law holds for every split") {
    const split rule = GENERATE(split::middle, split::median, split::surface_area, split::bottom_up);
    const auto build = [&](const std::vector<aabb>& boxes) { return bvh(boxes, {.rule = rule}); };
    accelerator_laws::agrees_with_every(build, 500);
    accelerator_laws::finds_what_moves(build);
    accelerator_laws::survives_degenerate_input(build);
    accelerator_laws::leaves_out_and_counts(build);
    accelerator_laws::looks_at_few(build, 12, 60);
    accelerator_laws::ends_with_any_ray(build);
}

TEMPLATE_TEST_CASE("bvh: every law holds for every volume", "", lantern::bounding_sphere, lantern::obb) {
    const auto build = [](const std::vector<aabb>& boxes) {
        std::vector<lantern::box> solids;
        for (const aabb& box : boxes) solids.push_back({box.min, box.max});
        return bvh<TestType>(solids);
    };
    accelerator_laws::agrees_with_every(build, 500);
    accelerator_laws::finds_what_moves(build);
    accelerator_laws::leaves_out_and_counts(build);
    accelerator_laws::looks_at_few(build, 16, 80);
    accelerator_laws::ends_with_any_ray(build);
}

TEST_CASE("a tree of other volumes finds the same, and each suits something") {
    dice d{.state = 21};
    std::vector<lantern::triangle> needles;
    for (int i = 0; i < 500; ++i) {
        const glm::vec3 p = d.in_cube(), along = 0.5f * glm::vec3(d.on_sphere());
        needles.push_back({p, p + along, p + along + d.in_cube(0.002)});
    }
    const bvh boxes(needles, {.leaf_size = 1});
    const bvh<lantern::obb> turned(needles, {.leaf_size = 1});
    const bvh<lantern::bounding_sphere> round(needles, {.leaf_size = 1});
    lantern::probe by_box, by_turned, by_round;
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 from = d.in_cube(3);
        const lantern::triangle& aim = needles[d.below(500)];
        const ray r{from, (aim.a + aim.b + aim.c) / 3.0f - from};
        const auto a = closest(boxes, needles, r, {}, by_box), b = closest(turned, needles, r, {}, by_turned),
                   c = closest(round, needles, r, {}, by_round);
        REQUIRE((a.has_value() == b.has_value() && a.has_value() == c.has_value()));
        if (a) REQUIRE((a->index == b->index && a->t == b->t && a->index == c->index && a->t == c->t));
    }
    INFO("offers: aabb " << by_box.offers << ", obb " << by_turned.offers << ", sphere " << by_round.offers);
    CHECK(by_turned.offers < by_box.offers / 3);
    CHECK(by_round.offers > by_box.offers);
}
