// SPDX-License-Identifier: MIT
#include <lantern/camera.hpp>

#include "catch.hpp"
#include "counting_source.hpp"

#include <glm/geometric.hpp>

#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>
#include <vector>

using lantern::camera;
using lantern::instant;
using lantern::pinhole;
using lantern::shutter;
using lantern::thin_lens;
using lantern::view;

namespace {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr float pi = std::numbers::pi_v<float>;

const std::vector<view> views{
    {},
    {.eye = {0, 0, 4}, .target = {0, 0, 0}},
    {.eye = {1, 2, 3}, .target = {-4, 0.1f, 7}, .up = {0.3f, 1, -0.2f}, .vertical_fov = 1.5f, .aspect = 1.7f},
    {.eye = {1e6f, 1e6f, 1e6f}, .target = {1e6f, 1e6f + 1, 1e6f + 3}, .vertical_fov = 0.01f, .aspect = 0.3f},
    {.eye = {-1e-20f, 0, 2e-20f}, .target = {1e-20f, 1e-20f, 0}, .vertical_fov = 3.1f},
    {.eye = {1e20f, 0, 0}, .target = {0, 2e20f, 0}, .up = {0, 1e30f, 0}},
};

/// Calls use(film, xi) for many points of the film and the unit square.
template <class Use>
void for_many_points(Use&& use) {
    for (std::uint32_t i = 0; i < 500; ++i) {
        const auto unit = [i](std::uint32_t k) { return lantern::to_unit(lantern::low(lantern::hash(i, k))); };
        use(glm::vec2(unit(0), unit(1)), glm::vec2(unit(2), unit(3)));
    }
}

/// A source that answers with what it is told.
struct told {
    glm::vec2 two{0.5f};
    float one = 0.5f;
    [[nodiscard]] float draw1(lantern::purpose, std::uint32_t = 0) const { return one; }
    [[nodiscard]] glm::vec2 draw2(lantern::purpose, std::uint32_t = 0) const { return two; }
    [[nodiscard]] told branch(std::uint32_t) const { return *this; }
};

}  // namespace

// ---- the view -------------------------------------------------------------------------------------------------------

TEST_CASE("the middle of the film looks at the target") {
    for (const view& v : views) {
        const auto r = shoot(camera{v}, {0.5f, 0.5f});
        const glm::dvec3 to_target = glm::normalize(glm::dvec3(v.target) - glm::dvec3(v.eye));
        CHECK(r.origin == v.eye);
        CHECK(r.direction == glm::vec3(to_target));
    }
}

TEST_CASE("the film's corners: (0, 0) is left above, (1, 1) right below") {
    const camera cam{view{.eye = {0, 0, 4}, .target = {0, 0, 0}, .vertical_fov = pi / 2, .aspect = 2}};
    const auto towards = [&](glm::vec2 film) {
        const glm::vec3 d = shoot(cam, film).direction;
        return glm::vec2(d.x, d.y) / -d.z;
    };
    CHECK(glm::length(towards({0, 0}) - glm::vec2(-2, 1)) < 1e-6f);
    CHECK(glm::length(towards({1, 0}) - glm::vec2(2, 1)) < 1e-6f);
    CHECK(glm::length(towards({0, 1}) - glm::vec2(-2, -1)) < 1e-6f);
    CHECK(glm::length(towards({1, 1}) - glm::vec2(2, -1)) < 1e-6f);
    CHECK(glm::length(towards({0.75f, 0.5f}) - glm::vec2(1, 0)) < 1e-6f);
}

TEST_CASE("vertical_fov is the angle between the top and the bottom of the film") {
    for (const view& v : views) {
        const camera cam{v};
        const glm::dvec3 top(shoot(cam, {0.5f, 0}).direction), bottom(shoot(cam, {0.5f, 1}).direction);
        CHECK(std::atan2(glm::length(glm::cross(top, bottom)), glm::dot(top, bottom)) ==
              Approx(v.vertical_fov).epsilon(1e-5).margin(2e-7));
    }
}

TEST_CASE("up is up, whatever its length and slant") {
    const view straight{.eye = {0, 0, 4}, .target = {0, 0, 0}};
    view slanted = straight;
    slanted.up = {0, 1e-30f, 5e-31f};
    for_many_points([&](glm::vec2 film, glm::vec2) {
        const glm::vec3 a = shoot(camera{straight}, film).direction, b = shoot(camera{slanted}, film).direction;
        CHECK(glm::length(a - b) < 1e-7f);
    });
    for (const view& v : views) {
        const glm::vec3 top = shoot(camera{v}, {0.5f, 0}).direction, bottom = shoot(camera{v}, {0.5f, 1}).direction;
        CHECK(glm::dot(glm::dvec3(top - bottom), glm::dvec3(v.up)) > 0);
    }
}

TEST_CASE("directions have unit length, as exactly as float allows") {
    for (const view& v : views) {
        const camera cam{v, thin_lens{.radius = 0.1f, .focus_distance = 3}};
        for_many_points([&](glm::vec2 film, glm::vec2 xi) {
            CHECK(std::abs(glm::length(glm::dvec3(shoot(cam, film, told{xi}).direction)) - 1) < 1.1e-7);
        });
    }
}

TEST_CASE("a scene scaled by a power of two is seen by the same rays") {
    const view v = views[2];
    for (const float scale : {0x1p-60f, 0x1p-10f, 0x1p60f}) {
        view scaled = v;
        scaled.eye *= scale;
        scaled.target *= scale;
        const camera a{v, thin_lens{.radius = 0.5f, .focus_distance = 3}};
        const camera b{scaled, thin_lens{.radius = 0.5f * scale, .focus_distance = 3 * scale}};
        for_many_points([&](glm::vec2 film, glm::vec2 xi) {
            CHECK(shoot(a, film, told{xi}).direction == shoot(b, film, told{xi}).direction);
            CHECK(shoot(a, film, told{xi}).origin * scale == shoot(b, film, told{xi}).origin);
        });
    }
}

// ---- the lens -------------------------------------------------------------------------------------------------------

TEST_CASE("a lens of radius 0 shoots exactly the pinhole's rays") {
    for (const view& v : views) {
        for (const float focus : {1e-30f, 0.1f, 7.f, 1e30f, inf}) {
            const camera sharp{v};
            const camera round{v, thin_lens{.radius = 0, .focus_distance = focus}};
            const camera bladed{v, lantern::bladed_lens{.radius = 0, .focus_distance = focus}};
            for_many_points([&](glm::vec2 film, glm::vec2 xi) {
                const auto expected = shoot(sharp, film);
                for (const auto& r : {shoot(round, film, told{xi}), shoot(bladed, film, told{xi})}) {
                    CHECK(r.origin == expected.origin);
                    CHECK(r.direction == expected.direction);
                }
            });
        }
    }
}

TEST_CASE("rays through all of the lens meet where the pinhole's ray crosses the plane in focus") {
    const view v = views[2];
    const float focus = 6;
    const camera sharp{v};
    const camera lens{v, thin_lens{.radius = 0.5f, .focus_distance = focus}};
    const glm::dvec3 forward = glm::normalize(glm::dvec3(v.target) - glm::dvec3(v.eye));
    for_many_points([&](glm::vec2 film, glm::vec2 xi) {
        const glm::dvec3 d(shoot(sharp, film).direction);
        const glm::dvec3 meeting = glm::dvec3(v.eye) + d * (focus / glm::dot(d, forward));
        const auto r = shoot(lens, film, told{xi});
        const glm::dvec3 to_meeting = meeting - glm::dvec3(r.origin);
        CHECK(glm::length(glm::cross(to_meeting, glm::dvec3(r.direction))) < 3e-6);
    });
}

TEST_CASE("a point at distance z out of focus is blurred to a disk of radius R |z - f| / f") {
    constexpr float radius = 0.5f, focus = 4;
    const camera lens{view{.eye = {0, 0, 0}, .target = {0, 0, -1}},
                      thin_lens{.radius = radius, .focus_distance = focus}};
    for (const double z : {1.0, 3.0, 8.0, 100.0}) {
        double widest = 0;
        for (int i = 0; i <= 100; ++i) {
            const auto r = shoot(lens, {0.5f, 0.5f}, told{{1, static_cast<float>(i) / 100}});  // the rim
            const glm::dvec3 p = glm::dvec3(r.origin) - glm::dvec3(r.direction) * (z / r.direction.z);
            widest = std::max(widest, glm::length(glm::dvec2(p.x, p.y)));
        }
        CHECK(widest == Approx(radius * std::abs(z - focus) / focus).epsilon(1e-5));
    }
}

TEST_CASE("focused at infinity, rays from one film point are parallel") {
    const camera sharp{views[2]};
    const camera lens{views[2], thin_lens{.radius = 2, .focus_distance = inf}};
    for_many_points([&](glm::vec2 film, glm::vec2 xi) {
        const auto r = shoot(lens, film, told{xi});
        CHECK(r.direction == shoot(sharp, film).direction);
        CHECK(glm::length(r.origin - views[2].eye) <= 2.000001f);
    });
}

TEST_CASE("the aperture is a disk across the line of sight, filled evenly to its rim") {
    const view v = views[2];
    const glm::dvec3 forward = glm::normalize(glm::dvec3(v.target) - glm::dvec3(v.eye));
    const camera lens{v, thin_lens{.radius = 3, .focus_distance = 5}};
    int inner = 0;
    constexpr int side = 64;
    for (int i = 0; i < side * side; ++i) {
        const glm::vec2 xi = (glm::vec2(i % side, i / side) + 0.5f) / float(side);
        const glm::dvec3 offset = glm::dvec3(shoot(lens, {0.3f, 0.8f}, told{xi}).origin) - glm::dvec3(v.eye);
        CHECK(std::abs(glm::dot(offset, forward)) < 1e-6);
        CHECK(glm::length(offset) < 3.000001);
        inner += glm::length(offset) < 1.5;
    }
    // A quarter of the area. A radius of ξ in place of √ξ puts half of the points there.
    CHECK(inner == Approx(side * side / 4).epsilon(0.03));
}

TEST_CASE("blades make the aperture a polygon: nothing beyond its sides, corners on the circle") {
    constexpr std::uint32_t blades = 5;
    constexpr float rotation = 0.3f;
    const view v{.eye = {0, 0, 0}, .target = {0, 0, -1}};
    const camera lens{v,
                      lantern::bladed_lens{.radius = 2, .focus_distance = 5, .blades = blades, .rotation = rotation}};
    double farthest = 0;
    for (int i = 0; i < 100 * 100; ++i) {
        const glm::vec2 xi = (glm::vec2(i % 100, i / 100) + 0.5f) / 100.f;
        const glm::vec3 p = shoot(lens, {0.5f, 0.5f}, told{xi}).origin;
        farthest = std::max(farthest, double(glm::length(p)));
        for (std::uint32_t k = 0; k < blades; ++k) {
            const double middle = rotation + (k + 0.5) * 2 * std::numbers::pi / blades;
            CHECK(p.x * std::cos(middle) + p.y * std::sin(middle) < 2 * std::cos(std::numbers::pi / blades) + 1e-6);
        }
    }
    CHECK(farthest > 1.9);
    CHECK(farthest < 2.000001);
}

namespace elsewhere {

/// A user's lens: a slit.
struct slit {
    float width = 1;
    float focus_distance = 2;
};
glm::vec2 on_aperture(const slit& s, glm::vec2 xi) { return {s.width * (xi.x - 0.5f), 0}; }
void validate(const slit& s) { lantern::require_positive(s.width, "slit: width"); }

}  // namespace elsewhere

TEST_CASE("a lens of one's own needs only on_aperture, validate and a focus distance") {
    const camera cam{view{.eye = {0, 0, 0}, .target = {0, 0, -1}}, elsewhere::slit{.width = 4}};
    CHECK(shoot(cam, {0.5f, 0.5f}, told{{0.75f, 0.1f}}).origin == glm::vec3(1, 0, 0));
    CHECK_THROWS_WITH((camera{view{}, elsewhere::slit{.width = not_a_number}}), containing("slit: width is nan"));
}

// ---- the shutter ----------------------------------------------------------------------------------------------------

TEST_CASE("a ray's time is T0 + ξ(T1 - T0)") {
    const camera cam{view{}, pinhole{}, shutter{.open = 0.25f, .close = 0.75f}};
    CHECK(shoot(cam, {0, 0}, told{{}, 0.f}).time == 0.25f);
    CHECK(shoot(cam, {0, 0}, told{{}, 0.25f}).time == 0.375f);
    CHECK(shoot(cam, {0, 0}, told{{}, 0.5f}).time == 0.5f);
}

TEST_CASE("no time lies outside the exposure, however short, far or long it is") {
    const float last = 1 - 0x1p-24f;
    const auto check = [&](float open, float close) {
        const camera cam{view{}, pinhole{}, shutter{open, close}};
        for (const float xi : {0.f, 0x1p-24f, 0.3f, 0.5f, 1 - 0x1p-23f, last}) {
            const float time = shoot(cam, {0, 0}, told{{}, xi}).time;
            CHECK(time >= open);
            CHECK(time <= close);
        }
    };
    check(0, 1);
    check(1 - 0x1p-24f, 1);
    check(0.5f, std::nextafter(0.5f, 1.f));
    check(0, 1e-45f);
    check(0.3f, 0.3f);
    check(1, 1);
    for (std::uint32_t i = 0; i < 2000; ++i) {
        const float a = lantern::to_unit(lantern::low(lantern::hash(i))), b = lantern::to_unit(lantern::high(lantern::hash(i)));
        check(std::min(a, b), std::max(a, b));
        check(std::min(a, b), std::nextafter(std::min(a, b), 1.f));
    }
}

TEST_CASE("a shutter changes no direction") {
    const camera still{views[2], thin_lens{.radius = 1, .focus_distance = 4}};
    const camera open{views[2], thin_lens{.radius = 1, .focus_distance = 4}, shutter{}};
    for_many_points([&](glm::vec2 film, glm::vec2 xi) {
        CHECK(shoot(still, film, told{xi}).origin == shoot(open, film, told{xi}).origin);
        CHECK(shoot(still, film, told{xi}).direction == shoot(open, film, told{xi}).direction);
    });
}

// ---- leaving out ----------------------------------------------------------------------------------------------------

TEST_CASE("a pinhole draws nothing, a lens two numbers, a shutter one more") {
    const auto drawn = [](const auto& cam) {
        draws counted;
        (void)shoot(cam, glm::vec2{0.5f}, counting_source{&counted});
        CHECK(counted.total() == counted.of(lantern::purpose::lens) + counted.of(lantern::purpose::time));
        return glm::ivec2(counted.of(lantern::purpose::lens), counted.of(lantern::purpose::time));
    };
    CHECK(drawn(camera{view{}}) == glm::ivec2(0, 0));
    CHECK(drawn(camera{view{}, thin_lens{}}) == glm::ivec2(2, 0));
    CHECK(drawn(camera{view{}, lantern::bladed_lens{}}) == glm::ivec2(2, 0));
    CHECK(drawn(camera{view{}, pinhole{}, shutter{}}) == glm::ivec2(0, 1));
    CHECK(drawn(camera{view{}, thin_lens{}, shutter{}}) == glm::ivec2(2, 1));
}

TEST_CASE("only a shutter makes rays know their time, and what is absent takes no room") {
    const told source;
    STATIC_REQUIRE(std::is_same_v<decltype(shoot(camera{view{}}, glm::vec2{}, source)), lantern::ray>);
    STATIC_REQUIRE(std::is_same_v<decltype(shoot(camera{view{}, thin_lens{}}, glm::vec2{}, source)), lantern::ray>);
    STATIC_REQUIRE(
        std::is_same_v<decltype(shoot(camera{view{}, pinhole{}, shutter{}}, glm::vec2{}, source)), lantern::timed_ray>);
    STATIC_REQUIRE(sizeof(camera<pinhole, instant>) == sizeof(lantern::camera_frame));
    STATIC_REQUIRE(sizeof(camera<pinhole, instant>) < sizeof(camera<pinhole, shutter>));
    STATIC_REQUIRE(sizeof(camera<pinhole, shutter>) < sizeof(camera<thin_lens, shutter>));
}

// ---- what is refused ------------------------------------------------------------------------------------------------

TEST_CASE("a view that cannot be is refused, by value and rule") {
    const auto refused = [](view v, const std::string& message) { CHECK_THROWS_WITH(camera{v}, containing(message)); };
    for (const float bad : {not_a_number, inf, -inf}) {
        refused({.eye = {0, bad, 1}}, "view: eye is (0, ");
        refused({.target = {bad, 0, 0}}, "view: target is (");
        refused({.up = {0, 1, bad}}, "view: up is (0, 1, ");
        refused({.vertical_fov = bad}, "view: vertical_fov is ");
        refused({.aspect = bad}, "view: aspect is ");
    }
    refused({.eye = {1, 2, 3}, .target = {1, 2, 3}}, "view: target is (1, 2, 3), but must be different from eye");
    refused({.up = {0, 0, 0}}, "view: up is (0, 0, 0)");
    refused({.up = {0, 0, 1}}, "parallel");
    refused({.up = {0, 0, -1e30f}}, "parallel");
    refused({.eye = {3, 3, 3}, .target = {1, 1, 1}, .up = {7, 7, 7}}, "parallel");
    refused({.vertical_fov = 0}, "vertical_fov is 0, but must be between 0 and pi");
    refused({.vertical_fov = -1}, "vertical_fov is -1");
    refused({.vertical_fov = pi}, "vertical_fov is 3.14159");
    refused({.vertical_fov = 40}, "it is in radians");
    refused({.aspect = 0}, "aspect is 0, but must be positive");
    refused({.aspect = -1}, "aspect is -1");
}

TEST_CASE("a lens that cannot be is refused, by value and rule") {
    const auto refused = [](auto lens, const std::string& message) {
        CHECK_THROWS_WITH((camera{view{}, lens}), containing(message));
    };
    for (const float bad : {not_a_number, inf, -1.f, -1e-30f}) {
        refused(thin_lens{.radius = bad}, "thin_lens: radius is ");
        refused(lantern::bladed_lens{.radius = bad}, "bladed_lens: radius is ");
    }
    for (const float bad : {not_a_number, 0.f, -0.f, -1.f, -inf}) {
        refused(thin_lens{.focus_distance = bad}, "thin_lens: focus_distance is ");
        refused(lantern::bladed_lens{.focus_distance = bad}, "bladed_lens: focus_distance is ");
    }
    refused(lantern::bladed_lens{.blades = 2}, "blades is 2, but must be at least 3");
    refused(lantern::bladed_lens{.rotation = not_a_number}, "rotation is nan");
}

TEST_CASE("a shutter that cannot be is refused, by value and rule") {
    const auto refused = [](shutter s, const std::string& message) {
        CHECK_THROWS_WITH((camera{view{}, pinhole{}, s}), containing(message));
    };
    for (const float bad : {not_a_number, inf, -inf, -0.001f, 1.001f}) {  // bounds of what moves end at 0 and 1
        refused({.open = bad}, "shutter: open is ");
        refused({.close = bad}, "shutter: close is ");
    }
    refused({.open = 1, .close = 0.5f}, "shutter: close is 0.5, but must be no earlier than open, 1");
}
