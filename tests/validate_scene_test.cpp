// SPDX-License-Identifier: MIT
#include <lantern/validate_scene.hpp>

#include <lantern/any_of.hpp>
#include <lantern/bvh.hpp>
#include <lantern/closest.hpp>
#include <lantern/diffuse.hpp>
#include <lantern/light.hpp>
#include <lantern/mirror.hpp>
#include <lantern/object.hpp>
#include <lantern/sky.hpp>
#include <lantern/sphere.hpp>
#include <lantern/rectangle.hpp>

#include "catch.hpp"

#include <limits>
#include <stdexcept>
#include <variant>
#include <vector>

using lantern::sphere;
using lantern::validate_scene;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
using thing = lantern::object<lantern::any_of<sphere, lantern::rectangle>, std::variant<lantern::diffuse, lantern::mirror>>;
const std::vector<thing> good{{sphere{}, lantern::diffuse{}}, {sphere{{0, 0, 5}, 1}, lantern::mirror{}}};
const std::vector<lantern::point_light> lights{{}, {}};

}  // namespace

TEST_CASE("a sound scene is accepted, with any structure over no more than its things") {
    CHECK_NOTHROW(validate_scene(lantern::every{2}, good, lights, lantern::darkness{}));
    CHECK_NOTHROW(validate_scene(lantern::bvh(good), good, lights, lantern::sky{}));
    CHECK_THROWS_AS(validate_scene(lantern::every{3}, good, lights, lantern::darkness{}), std::invalid_argument);
    CHECK_THROWS_WITH(validate_scene(lantern::bvh(std::vector<sphere>(5)), good, lights, lantern::darkness{}),
                      containing("size is 5, but must be no more than the number of things, 2"));
}

TEST_CASE("the message says which thing or light is wrong, and why") {
    auto things = good;
    things[1].shape = sphere{{0, not_a_number, 0}, 1};
    CHECK_THROWS_WITH(validate_scene(lantern::every{2}, things, lights, lantern::darkness{}),
                      containing("things[1]: sphere: center is (0, nan, 0)"));
    things = good;
    things[0].material = lantern::mirror{glm::vec3(1.5f)};
    CHECK_THROWS_WITH(validate_scene(lantern::every{2}, things, lights, lantern::darkness{}),
                      containing("things[0]: mirror: color"));
    auto lamps = lights;
    lamps[1].intensity.x = -1;
    CHECK_THROWS_WITH(validate_scene(lantern::every{2}, good, lamps, lantern::darkness{}), containing("lights[1]: point_light: intensity"));
    CHECK_THROWS_WITH(validate_scene(lantern::every{2}, good, lights, lantern::sky{.zenith = glm::vec3(-1)}), containing("sky: zenith"));
}
