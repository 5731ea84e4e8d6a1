// SPDX-License-Identifier: MIT
#include <lantern/emitters.hpp>

#include <lantern/diffuse.hpp>
#include <lantern/disk_light.hpp>
#include <lantern/emissive.hpp>
#include <lantern/moving_light.hpp>
#include <lantern/object.hpp>
#include <lantern/rectangle_light.hpp>
#include <lantern/sphere_light.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <variant>
#include <vector>

using lantern::emissive;
using lantern::emitters;
using lantern::sphere_light;

namespace {

using shape = lantern::any_of<lantern::sphere, lantern::rectangle, lantern::disk, lantern::moving<lantern::sphere>>;
using material = std::variant<lantern::diffuse, emissive>;
using thing = lantern::object<shape, material>;
using lamp = std::variant<lantern::point_light, lantern::rectangle_light, sphere_light, lantern::disk_light, lantern::moving<sphere_light>>;

emitters of(const std::vector<thing>& things, const std::vector<lamp>& lights) {
    return {std::span(things), std::span(lights)};
}

}  // namespace

TEST_CASE("a thing that shines with a lamp's surface is its body, and no other is") {
    const lantern::rectangle_light window{{0, 3, 0}, {1, 0, 0}, {0, 0, 1}, glm::vec3(2)};
    const lantern::disk_light dish{{0, 4, 0}, {0, -1, 0}, 1, glm::vec3(5)};
    const sphere_light bulb{{1, 2, 3}, 1, glm::vec3(3)};
    const lantern::moving comet{bulb, glm::vec3(1, 0, 0)};
    const std::vector<lamp> lights{lantern::point_light{}, comet, bulb, dish, window};
    const std::vector<thing> things{
        {surface_of(bulb), lantern::diffuse{}},                    // does not shine
        {surface_of(bulb), emissive{bulb.radiance}},               //
        {lantern::sphere{{1, 2, 4}, 1}, emissive{bulb.radiance}},  // shines elsewhere
        {surface_of(comet), emissive{bulb.radiance}},              //
        {surface_of(window), emissive{.radiance = window.radiance, .back = glm::vec3(7)}},
    };
    const emitters e = of(things, lights);
    CHECK(e.light_of(0) == std::nullopt);
    CHECK(e.light_of(1) == 2u);
    CHECK(e.light_of(2) == std::nullopt);
    CHECK(e.light_of(3) == 1u);
    CHECK(e.light_of(4) == 4u);
    CHECK(e.light_of(99) == std::nullopt);
    for (std::uint32_t i = 0; i < 5; ++i) CHECK(e.has_body(i) == (i == 1 || i == 2 || i == 4));
}

TEST_CASE("of two equal lamps one body is one's") {
    const sphere_light bulb{{1, 2, 3}, 1, glm::vec3(3)};
    const emitters e = of({{surface_of(bulb), emissive{bulb.radiance}}}, {bulb, bulb});
    CHECK(e.has_body(0));
    CHECK_FALSE(e.has_body(1));
}

TEST_CASE("a body that does not shine as its lamp does is refused") {
    const sphere_light bulb{{1, 2, 3}, 1, glm::vec3(3)};
    CHECK_THROWS_WITH(of({{surface_of(bulb), emissive{}}}, {bulb}),
                      containing("things[0]: radiance is (1, 1, 1), but must be that of lights[0], whose surface it has: (3, 3, 3)"));
    CHECK_THROWS(of({{surface_of(bulb), emissive{glm::vec3(0), bulb.radiance}}}, {bulb}));  // inside out
    CHECK_THROWS(of({{surface_of(lantern::moving{bulb, glm::vec3(1)}), emissive{}}}, {lantern::moving{bulb, glm::vec3(1)}}));
}

TEST_CASE("a lamp's density is what its irradiance was divided by, near and far, and 0 seen from behind") {
    dice d{.state = 1};
    const auto check = [&](const auto& light, glm::vec3 point) {
        const auto lit = illuminate(light, point, glm::vec2(d.unit(), d.unit()));
        if (lit.irradiance.x == 0) return 0;
        REQUIRE(double(lit.irradiance.x) * density(light, point, lit.position) == Approx(double(light.radiance.x)).epsilon(1e-3));  // the position is stepped off the lamp
        return 1;
    };
    int lit = 0;
    for (int i = 0; i < 2000; ++i) {
        const float size = d.magnitude_between(-8, 0);
        const glm::vec3 bright(d.magnitude_between(-3, 12)), point = d.in_cube(d.magnitude_between(0.5, 3));
        lit += check(lantern::rectangle_light{size * d.in_cube(), size * d.in_cube(), size * d.in_cube(), bright}, point);
        lit += check(lantern::disk_light{size * d.in_cube(), d.in_cube(), size, bright}, point);
        lit += check(sphere_light{size * d.in_cube(), size, bright}, point);
    }
    CHECK(lit > 3000);
    CHECK(density(lantern::disk_light{}, {0, 5, 0}, {0, 0, 0}) == 0);
    CHECK(density(lantern::rectangle_light{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {0, 5, 0}, {0.5f, 0, 0.5f}) == 0);
    CHECK(density(sphere_light{}, {0.5f, 0, 0}, {1, 0, 0}) == 0);
    const lantern::moving comet{sphere_light{{0, 0, 0}, 1}, glm::vec3(10, 0, 0)};
    CHECK(density(comet, {10, 5, 0}, {10, 1, 0}, 1.0f) == density(comet.surface, {0, 5, 0}, {0, 1, 0}));
}
