// SPDX-License-Identifier: MIT
// Lab 08's hidden tests: the solution's answers, for motions and exposures drawn anew for each grading.

#include "contract.hpp"

#include <catch.hpp>
#include <hidden.hpp>

#include <lab08_shutter/shutter.hpp>

using namespace contract::lab08;

namespace {

struct exposure {
    float open, close;
    explicit exposure(numbers& random) : open(random.between(-2, 2)), close(open + random.between(0.01f, 3)) {}
};

ray_then drawn_ray(numbers& random) { return {5.0f * random.vector(), hidden::magnitude(random, 0.1f, 10) * random.direction(), random.between(-2, 2)}; }
lab08::timed_ray own(const ray_then& r) { return {r.origin, r.direction, r.time}; }

double apart(const ray_then& a, const lab08::timed_ray& b) {
    return std::max({hidden::apart(a.origin, b.origin), hidden::apart(a.direction, b.direction), hidden::apart(a.time, b.time)});
}

}  // namespace

TEST_CASE("any moment of any exposure", "[step1]") {
    numbers random = hidden::drawn(1);
    for (int i = 0; i < 300; ++i) {
        const exposure e(random);
        const float xi = random.unit();
        CHECK(hidden::apart(moment(e.open, e.close, xi), lab08::moment(e.open, e.close, xi)) < 1e-5);
    }
}

TEST_CASE("any moving sphere", "[step2]") {
    numbers random = hidden::drawn(2);
    hidden::agreement all;
    for (int i = 0; i < 300; ++i) {
        const ball s{2.0f * random.vector(), 2.0f * random.vector(), random.between(0.3f, 2)};
        ray_then r = drawn_ray(random);
        if (random.unit() < 0.7f) r.direction = s.center + r.time * s.velocity + s.radius * random.vector() - r.origin;
        const auto theirs = intersect(s, r), ours = lab08::intersect({s.center, s.velocity, s.radius}, own(r));
        all.count(theirs.has_value() == ours.has_value() && (!ours || std::abs(*theirs - *ours) <= 1e-3f * std::max(0.01f, *ours)));
    }
    CHECK(all.holds());
}

TEST_CASE("any bounds", "[step3]") {
    numbers random = hidden::drawn(3);
    for (int i = 0; i < 300; ++i) {
        const exposure e(random);
        const ball s{3.0f * random.vector(), 3.0f * random.vector(), random.between(0.1f, 2)};
        const auto theirs = bounds(s, e.open, e.close), ours = lab08::bounds({s.center, s.velocity, s.radius}, e.open, e.close);
        CHECK(hidden::apart(theirs.first, ours.first) < 1e-5);
        CHECK(hidden::apart(theirs.second, ours.second) < 1e-5);
    }
}

TEST_CASE("any ray that goes on", "[step4]") {
    numbers random = hidden::drawn(4);
    for (int i = 0; i < 200; ++i) {
        ray_then r = drawn_ray(random);
        const glm::vec3 point = random.vector(), light = 4.0f * random.vector();
        glm::vec3 normal = random.direction();
        if (glm::dot(normal, r.direction) > 0) normal = -normal;
        CHECK(apart(shadow_ray(r, point, light), lab08::shadow_ray(own(r), point, light)) < 1e-5);
        CHECK(apart(reflected_ray(r, point, normal), lab08::reflected_ray(own(r), point, normal)) < 1e-5);
        const float eta = random.between(0.4f, 2.5f);
        const double cosine = glm::dot(glm::normalize(glm::dvec3(r.direction)), glm::dvec3(normal));
        if (std::abs(1 - double(eta) * double(eta) * (1 - cosine * cosine)) < 1e-2) continue;  // at the critical angle rounding decides
        const auto theirs = refracted_ray(r, point, normal, eta);
        const auto ours = lab08::refracted_ray(own(r), point, normal, eta);
        REQUIRE(theirs.has_value() == ours.has_value());
        if (ours) CHECK(apart(*theirs, *ours) < 1e-4);
    }
}

TEST_CASE("any moments of a pixel", "[step5]") {
    numbers random = hidden::drawn(5);
    for (int i = 0; i < 50; ++i) {
        const exposure e(random);
        std::vector<std::uint32_t> order(1 + hidden::below(random, 40));
        std::vector<float> xi(order.size());
        for (std::uint32_t k = 0; k < order.size(); ++k) order[k] = k;
        for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[hidden::below(random, std::uint32_t(k))]);
        for (float& each : xi) each = random.unit();
        const std::vector<float> theirs = times(e.open, e.close, order, xi), ours = lab08::times(e.open, e.close, order, xi);
        REQUIRE(theirs.size() == ours.size());
        for (std::size_t k = 0; k < ours.size(); ++k) CHECK(hidden::apart(theirs[k], ours[k]) < 1e-5);
    }
}

TEST_CASE("any moving disc", "[step6]") {
    numbers random = hidden::drawn(6);
    hidden::agreement all;
    for (int i = 0; i < 300; ++i) {
        const exposure e(random);
        const glm::vec2 center(random.vector()), velocity(2.0f * random.vector());
        const float radius = random.between(0.2f, 1.5f);
        const glm::vec2 point = center + random.between(e.open, e.close) * velocity + 1.2f * radius * glm::vec2(random.vector());
        const float theirs = covered(point, center, velocity, radius, e.open, e.close), ours = lab08::covered(point, center, velocity, radius, e.open, e.close);
        all.count(hidden::apart(theirs, ours) < 1e-3);
    }
    CHECK(all.holds());
}
