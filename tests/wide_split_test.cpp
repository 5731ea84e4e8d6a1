// SPDX-License-Identifier: MIT
#include <lantern/wide_split.hpp>

#include <lantern/aabb.hpp>
#include <lantern/triangle.hpp>
#include <lantern/wide_build.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

using lantern::aabb;
using lantern::triangle;

namespace {

/// In the box, but for the rounding of the point itself.
bool holds(const aabb& box, const glm::dvec3& p) {
    for (int i = 0; i < 3; ++i) {
        const double slack = 0x1p-51 * std::abs(p[i]);
        if (!(double(box.min[i]) <= p[i] + slack && p[i] - slack <= double(box.max[i]))) return false;
    }
    return true;
}

lantern::wide::item_list items_of(const std::vector<triangle>& all, lantern::wide::needles& thin) {
    lantern::wide::item_list items;
    for (std::uint32_t i = 0; i < all.size(); ++i) {
        const aabb box = bounds(all[i]);
        items.push_back({box.min, i, box.max, 0});
        thin.add(all[i], items.back());
    }
    return items;
}

triangle needle(dice& d) {
    const glm::vec3 a = d.in_cube(), along = d.in_cube();
    return {a, a + along, a + 0.4f * along + 1e-3f * d.in_cube()};
}

}  // namespace

TEST_CASE("no point of a triangle is lost when it is cut, nor when its parts are cut again") {
    dice d{.state = 1};
    int cuts = 0;
    for (int i = 0; i < 4000; ++i) {
        const float scale = d.magnitude_between(-30, 17);
        triangle t = i % 2 == 0 ? triangle{d.in_cube(), d.in_cube(), d.in_cube()} : needle(d);
        const glm::vec3 away = i % 3 == 0 ? 1000.0f * d.in_cube() : glm::vec3(0);
        for (glm::vec3* v : {&t.a, &t.b, &t.c}) *v = scale * (*v + away);
        if (i % 5 == 0) t.b[int(d.below(3))] = t.a[int(d.below(3))];
        std::vector<aabb> parts{bounds(t)};
        for (int k = 0; k < 5; ++k) {
            const std::size_t which = d.below(static_cast<std::uint32_t>(parts.size()));
            const auto [low, high] = lantern::wide::cut_in_two(t, parts[which]);
            if (empty(low)) continue;
            for (const aabb& part : {low, high})
                REQUIRE((contains(parts[which], part.min) && contains(parts[which], part.max)));
            parts[which] = low;
            parts.push_back(high);
            ++cuts;
        }
        for (int k = 0; k < 40; ++k) {
            double v = d.unit(), w = d.unit() * (1 - v);
            if (k % 4 == 0) w = 0;  // on an edge
            if (k % 4 == 1) w = 1 - v;
            const glm::dvec3 a(t.a), p = a + v * (glm::dvec3(t.b) - a) + w * (glm::dvec3(t.c) - a);
            bool found = false;
            for (const aabb& part : parts) found = found || holds(part, p);
            REQUIRE(found);
        }
    }
    CHECK(cuts > 10'000);
}

TEST_CASE("a box that has no inside along its longest side is not cut") {
    const triangle point{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
    CHECK(empty(lantern::wide::cut_in_two(point, bounds(point)).low));
    const float next = std::nextafter(1.0f, 2.0f);
    const triangle tiny{{1, 1, 1}, {next, 1, 1}, {1, next, 1}};
    CHECK(empty(lantern::wide::cut_in_two(tiny, bounds(tiny)).high));
}

TEST_CASE("a cut halves a needle's boxes") {
    const triangle t{{0, 0, 0}, {1, 1, 1}, {0.5f, 0.501f, 0.5f}};
    const auto [low, high] = lantern::wide::cut_in_two(t, bounds(t));
    CHECK(surface_area(low) == Approx(1.5).epsilon(0.01));
    CHECK(surface_area(high) == Approx(1.5).epsilon(0.01));
}

TEST_CASE("needles count where they matter, and only those are cut") {
    dice d{.state = 2};
    std::vector<triangle> all;
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 at = d.in_cube();
        all.push_back({at, at + glm::vec3(0.01f, 0, 0), at + glm::vec3(0, 0.01f, 0)});
    }
    lantern::wide::needles none;
    auto items = items_of(all, none);
    CHECK(none.count(items) == 0);

    for (int i = 0; i < 10; ++i) all.push_back(needle(d));
    lantern::wide::needles some;
    items = items_of(all, some);
    const std::size_t thin = some.count(items);
    CHECK((5 <= thin && thin <= 10));  // some lie along an axis
    some.cut(items, [&](std::uint32_t i) { return all[i]; }, 200);
    CHECK((1010 < items.size() && items.size() <= 1210));
    for (std::size_t i = 0; i < 1000; ++i) REQUIRE((items[i].lower == bounds(all[i]).min && items[i].upper == bounds(all[i]).max));
    for (std::size_t i = 1010; i < items.size(); ++i) REQUIRE(items[i].index >= 1000);

    auto again = items_of(all, some = {});
    (void)some.count(again);
    some.cut(again, [&](std::uint32_t i) { return all[i]; }, 200);
    CHECK(again.size() == items.size());  // the same, always
}

TEST_CASE("long boxes that have the same shape as their triangle are none") {
    std::vector<triangle> all;
    for (int i = 0; i < 100; ++i) all.push_back({{0, float(i), 0}, {100, float(i), 0}, {50, float(i) + 0.01f, 0}});
    lantern::wide::needles thin;
    const auto items = items_of(all, thin);
    CHECK(thin.count(items) == 0);
}
