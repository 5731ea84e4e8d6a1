// SPDX-License-Identifier: MIT
// What `trim` leaves out, and that the picture does not change by it. How few instructions remain is counted by
// tests/checks/trim_cost.py.
#include <lantern/trim.hpp>

#include <lantern/bvh.hpp>
#include <lantern/distribution.hpp>
#include <lantern/plane.hpp>
#include <lantern/render.hpp>
#include <lantern/sky.hpp>

#include "catch.hpp"
#include "counting_source.hpp"
#include "trim_scene.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

using lantern::purpose;
using trim_scene::effects;

namespace {

constexpr lantern::sky evening{};

/// One compilation of each kernel serves all tests: what was visited, drawn and seen.
struct outcome {
    std::size_t thing = 0, camera = 0;  // sizes, bytes
    bool tree = false, one_shape = false, one_light = false, pinhole = false, still = false, mirrors = false;
    draws drawn;
    lantern::image picture{{1, 1}};

    [[nodiscard]] bool operator==(const outcome& other) const { return picture == other.picture; }
};

const auto look = [](const auto& structure, const auto& things, const auto& lights, const auto& cam) {
    using structure_type = std::remove_cvref_t<decltype(structure)>;
    using thing = typename std::remove_cvref_t<decltype(things)>::value_type;
    using light = typename std::remove_cvref_t<decltype(lights)>::value_type;
    const lantern::distribution tracer{structure, things, lights, evening, {.depth = trim_scene::depth}};
    outcome o;
    o.thing = sizeof(thing);
    o.camera = sizeof(cam);
    o.tree = !std::same_as<structure_type, lantern::every>;
    o.one_shape = std::same_as<decltype(thing::shape), lantern::sphere>;
    o.one_light = lantern::light<light>;
    o.still = std::same_as<decltype(shoot(cam, glm::vec2(0), counting_source{&o.drawn})), lantern::ray>;
    o.mirrors = std::same_as<decltype(thing::material), std::variant<lantern::diffuse, lantern::mirror>>;
    o.pinhole = std::same_as<std::remove_cvref_t<decltype(cam)>, lantern::camera<lantern::pinhole>> ||
                std::same_as<std::remove_cvref_t<decltype(cam)>, lantern::camera<lantern::pinhole, lantern::shutter>>;
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) {
            const counting_source source{&o.drawn};
            (void)tracer(shoot(cam, (glm::vec2(x, y) + 0.5f) / 8.0f, source), source);
        }
    o.picture = lantern::render({24, 24}, cam, lantern::jittered{.side = 2}, tracer, {.threads = 1});
    return o;
};

outcome trimmed(const effects& on) { return trim(trim_scene::of(on), look); }

outcome untrimmed(const effects& on) {
    const auto s = trim_scene::of(on);
    return look(lantern::every{4}, s.things, s.lights, lantern::camera{s.from, s.lens, s.exposure});
}

std::vector<effects> all_sets() {
    std::vector<effects> sets;
    for (unsigned bits = 0; bits < 16; ++bits)
        sets.push_back({.lens = (bits & 1) != 0, .motion = (bits & 2) != 0, .gloss = (bits & 4) != 0, .soft = (bits & 8) != 0});
    return sets;
}

const lantern::finding& about(const std::vector<lantern::finding>& found, const std::string& what) {
    const auto it = std::ranges::find(found, what, &lantern::finding::what);
    REQUIRE(it != found.end());
    return *it;
}

}  // namespace

TEST_CASE("the picture is the same, to the last bit, whatever is left out") {
    for (const effects& on : all_sets()) {
        INFO("lens " << on.lens << ", motion " << on.motion << ", gloss " << on.gloss << ", soft " << on.soft);
        const bool same = trimmed(on) == untrimmed(on);
        CHECK(same);
    }
    const bool something = trimmed({}) == trimmed({.lens = true}) || trimmed({}) == trimmed({.motion = true}) ||
                           trimmed({}) == trimmed({.gloss = true}) || trimmed({}) == trimmed({.soft = true});
    CHECK_FALSE(something);  // and each effect is one that is seen
}

TEST_CASE("what is absent draws exactly nothing, what is there draws its own numbers") {
    for (const effects& on : all_sets()) {
        const draws drawn = trimmed(on).drawn;
        INFO("lens " << on.lens << ", motion " << on.motion << ", gloss " << on.gloss << ", soft " << on.soft);
        CHECK(drawn.of(purpose::lens) == (on.lens ? 2 * 64 : 0));
        CHECK(drawn.of(purpose::time) == (on.motion ? 64 : 0));
        CHECK((drawn.of(purpose::gloss) > 0) == on.gloss);
        CHECK((drawn.of(purpose::light) > 0) == on.soft);
        CHECK(drawn.total() == drawn.of(purpose::lens) + drawn.of(purpose::time) + drawn.of(purpose::gloss) + drawn.of(purpose::light));
    }
    CHECK(trimmed({}).drawn.total() == 0);
    CHECK(untrimmed({}).drawn.total() > 64 * 3);  // types that hold everything draw for what has no influence
}

TEST_CASE("the types are the smallest that hold the scene, and so are their sizes") {
    for (const effects& on : all_sets()) {
        const outcome o = trimmed(on);
        CHECK(o.pinhole != on.lens);
        CHECK(o.still != on.motion);
        CHECK(o.mirrors != on.gloss);
        CHECK(o.one_shape != on.motion);
        CHECK(o.one_light);
        CHECK_FALSE(o.tree);
    }
    CHECK(trimmed({}).thing == sizeof(lantern::object<lantern::sphere, std::variant<lantern::diffuse, lantern::mirror>>));
    CHECK(trimmed({}).thing < untrimmed({}).thing);
    CHECK(trimmed({}).camera == sizeof(lantern::camera_frame));
    CHECK(trimmed({.lens = true}).camera == sizeof(lantern::camera_frame) + sizeof(lantern::thin_lens));
}

TEST_CASE("it says what it left out, and why") {
    const auto plain = look_at(trim_scene::of({}));
    CHECK(about(plain, "lens").left_out);
    CHECK(about(plain, "lens").why == "the radius of its aperture is 0");
    CHECK(about(plain, "shutter").why == "nothing moves");
    CHECK(about(plain, "gloss").why == "no reflection is blurred");
    CHECK(about(plain, "choice of shapes").why == "all are of one kind");
    CHECK(about(plain, "choice of lights").left_out);
    CHECK(about(plain, "acceleration structure").why == "4 things");
    const auto rich = look_at(trim_scene::of({.lens = true, .motion = true, .gloss = true, .soft = true}));
    CHECK(std::ranges::count_if(rich, [](const auto& f) { return f.left_out; }) == 2);  // the tree, and the choice of lights
    CHECK(about(rich, "lens").why == "the radius of its aperture is 0.1");
    CHECK(about(rich, "shutter").why == "1 thing or light moves");
    CHECK(about(rich, "gloss").why == "1 thing is glossy or frosted");
    const auto asked = lantern::look_at<lantern::questions{.motion = false, .gloss = false, .shape = false, .light = false}>(trim_scene::of({}));
    CHECK(asked.size() == 2);
}

TEST_CASE("many things get the tree that is offered, endless ones never; a scene without lamps has no choice of lamps") {
    const auto kind = [](const auto& structure, const auto&, const auto& lights, const auto&) {
        return std::same_as<std::remove_cvref_t<decltype(structure)>, lantern::every>
                   ? std::is_same_v<std::remove_cvref_t<decltype(lights)>, std::vector<lantern::point_light>> ? 1 : 2
                   : 3;
    };
    using lantern::ingredients;
    using ball = lantern::object<lantern::sphere, lantern::diffuse>;
    const std::vector<lantern::sphere_light> lamps(1), dark;
    const std::vector few(lantern::few_things, ball{}), many(lantern::few_things + 1, ball{});
    const lantern::view from;
    const auto tree = [](const auto& things) { return lantern::bvh{things}; };
    CHECK(trim(ingredients{few, lamps, from, lantern::pinhole{}, lantern::instant{}}, kind, tree) == 2);
    CHECK(trim(ingredients{many, lamps, from, lantern::pinhole{}, lantern::instant{}}, kind, tree) == 3);
    CHECK(trim(ingredients{few, dark, from, lantern::pinhole{}, lantern::instant{}}, kind, tree) == 1);
    const std::vector planes(100, lantern::object{lantern::plane{}, lantern::diffuse{}});
    CHECK(trim(ingredients{planes, lamps, from, lantern::pinhole{}, lantern::instant{}}, kind, tree) == 2);
    CHECK(trim(ingredients{many, lamps, from, lantern::pinhole{}, lantern::instant{}}, kind) == 2);  // none is offered
}

TEST_CASE("a lamp that moves keeps the shutter, and one that stands still does not") {
    const auto timed = [](const auto&, const auto&, const auto& lights, const auto& cam) {
        draws none;
        using light = typename std::remove_cvref_t<decltype(lights)>::value_type;
        const bool still = std::same_as<light, lantern::sphere_light>;
        return std::same_as<decltype(shoot(cam, glm::vec2(0), counting_source{&none})), lantern::timed_ray> != still;
    };
    const std::vector ball(1, lantern::object{lantern::sphere{}, lantern::diffuse{}});
    for (const float way : {0.0f, 1.0f}) {
        const std::vector lamps(1, lantern::moving{lantern::sphere_light{}, glm::vec3(way, 0, 0)});
        const lantern::ingredients s{ball, lamps, lantern::view{}, lantern::pinhole{}, lantern::shutter{}};
        CHECK(trim(s, timed));
        CHECK(about(look_at(s), "shutter").left_out == (way == 0));
    }
}

TEST_CASE("what cannot be is refused before it is left out") {
    auto s = trim_scene::of({});
    s.lens.focus_distance = -1;
    CHECK_THROWS_WITH(lantern::trim(s, look), containing("thin_lens: focus_distance"));
    s = trim_scene::of({});
    s.things[1].material = lantern::glossy{.width = -1};
    CHECK_THROWS_WITH(lantern::trim(s, look), containing("things[1]: glossy: width"));
}
