// SPDX-License-Identifier: MIT
// Lab 02's hidden tests: the solution's hits, for rays and surfaces drawn anew for each grading.

#include "contract.hpp"

#include <catch.hpp>
#include <hidden.hpp>

#include <lab02_surfaces/surfaces.hpp>

using namespace contract::lab02;

namespace {

struct drawn_ray {
    lantern::ray ray;
    lantern::interval range;
    /// From somewhere, towards `aim` or near it.
    drawn_ray(numbers& random, glm::vec3 aim) {
        ray.origin = 5.0f * random.vector();
        ray.direction = hidden::magnitude(random, 0.1f, 1e5f) * (aim + 0.7f * random.vector() - ray.origin);
        if (random.unit() < 0.2f) range = {random.between(0, 0.2f), random.between(0.2f, 2)};
    }
    /// The same, so many times larger: it arrives at the same t.
    void grow(float times) {
        ray.origin *= times;
        ray.direction *= times;
    }
};

/// In a scene that is `size` times as large as one of a few units.
bool same(const found& theirs, const found& ours, float size = 1) {
    if (theirs.has_value() != ours.has_value()) return false;
    return !ours || (std::abs(theirs->t - ours->t) <= 1e-4f * ours->t && hidden::apart(theirs->point / size, ours->point / size) < 1e-4 &&
                     hidden::apart(theirs->normal, ours->normal) < 1e-4);
}

}  // namespace

TEST_CASE("any sphere", "[step1]") {
    numbers random = hidden::drawn(1);
    hidden::agreement all;
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 center = 3.0f * random.vector();
        const float radius = hidden::magnitude(random, 0.2f, 4);
        drawn_ray d(random, center);
        if (i % 3 == 0) d.ray.origin = center + 0.8f * random.unit() * radius * random.direction();  // inside
        all.count(same(intersect_sphere(center, radius, d.ray, d.range), intersect(lab02::sphere{center, radius}, d.ray, d.range)));
    }
    CHECK(all.holds());
}

TEST_CASE("any plane", "[step2]") {
    numbers random = hidden::drawn(2);
    hidden::agreement all;
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 point = 3.0f * random.vector(), normal = hidden::magnitude(random, 0.01f, 100) * random.direction();
        const drawn_ray d(random, point);
        if (std::abs(glm::dot(glm::normalize(normal), glm::normalize(d.ray.direction))) < 0.05f) continue;
        all.count(same(intersect_plane(point, normal, d.ray, d.range), intersect(lab02::plane{point, normal}, d.ray, d.range)));
    }
    CHECK(all.holds());
}

TEST_CASE("any triangle", "[step3]") {
    numbers random = hidden::drawn(3);
    hidden::agreement all;
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 a = 2.0f * random.vector(), b = 2.0f * random.vector(), c = 2.0f * random.vector();
        const glm::vec3 across = glm::cross(b - a, c - a);
        drawn_ray d(random, (a + b + c) / 3.0f);
        if (glm::length(across) < 0.5f || std::abs(glm::dot(glm::normalize(across), glm::normalize(d.ray.direction))) < 0.05f) continue;
        const float size = hidden::magnitude(random, 1e-4f, 1e4f);
        d.grow(size);
        all.count(same(intersect_triangle(size * a, size * b, size * c, d.ray, d.range), intersect(lab02::triangle{size * a, size * b, size * c}, d.ray, d.range), size));
    }
    CHECK(all.holds());
}

TEST_CASE("the closest of any surfaces", "[step4]") {
    numbers random = hidden::drawn(4);
    for (int i = 0; i < 100; ++i) {
        const std::uint32_t count = hidden::below(random, 20);
        std::vector<float> hits(count);
        for (float& t : hits) t = std::floor(random.between(-3, 12));  // some behind the ray, some alike
        const lantern::interval range{0, random.between(2, 15)};
        float nearest_yet = range.max;
        const auto answer = closest(count, [&](std::uint32_t k, lantern::interval within) -> found {
            CHECK(within.max <= nearest_yet);
            if (k < count && contains(within, hits[k])) nearest_yet = std::min(nearest_yet, hits[k]);
            if (k >= count || !contains(within, hits[k])) return std::nullopt;
            return lantern::hit{.t = hits[k]};
        }, range);
        std::optional<std::uint32_t> first;
        for (std::uint32_t k = 0; k < count; ++k)
            if (contains(range, hits[k]) && (!first || hits[k] < hits[*first])) first = k;
        REQUIRE(answer.has_value() == first.has_value());
        if (first) CHECK(answer->index == *first);
        if (first) CHECK(answer->at.t == hits[*first]);
    }
}
