// SPDX-License-Identifier: MIT
#include <lantern/distribution.hpp>

#include <lantern/any_of.hpp>
#include <lantern/blinn_phong.hpp>
#include <lantern/bvh.hpp>
#include <lantern/camera.hpp>
#include <lantern/coated.hpp>
#include <lantern/diffuse.hpp>
#include <lantern/disk_light.hpp>
#include <lantern/emissive.hpp>
#include <lantern/glass.hpp>
#include <lantern/glossy.hpp>
#include <lantern/mirror.hpp>
#include <lantern/moving.hpp>
#include <lantern/moving_light.hpp>
#include <lantern/object.hpp>
#include <lantern/plane.hpp>
#include <lantern/rectangle.hpp>
#include <lantern/rectangle_light.hpp>
#include <lantern/render.hpp>
#include <lantern/samples.hpp>
#include <lantern/sphere.hpp>
#include <lantern/sphere_light.hpp>
#include <lantern/whitted.hpp>

#include "catch.hpp"
#include "counting_source.hpp"
#include "oracle.hpp"
#include "recording_source.hpp"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

using lantern::diffuse;
using lantern::distribution;
using lantern::every;
using lantern::glass;
using lantern::glossy;
using lantern::independent;
using lantern::mirror;
using lantern::object;
using lantern::plane;
using lantern::point_light;
using lantern::purpose;
using lantern::ray;
using lantern::sphere;

namespace {

const std::vector<point_light> no_lights;
const lantern::sky white{.horizon = glm::vec3(1), .zenith = glm::vec3(1)};
const plane floor_plane{{0, 0, 0}, {0, 1, 0}};
const ray down{{0, 1, 0}, {0, -1, 0}};

/// Mean, and standard error of the mean, of a tracer's samples.
struct estimate {
    double mean = 0, error = 0;
};
template <class Tracer, class Ray>
estimate mean_of(const Tracer& tracer, const Ray& r, std::uint32_t count, std::uint64_t seed = 1) {
    double sum = 0, squares = 0;
    const independent numbers{.samples = count, .seed = seed};
    for (std::uint32_t i = 0; i < count; ++i) {
        const double x = tracer(r, numbers.at({0, 0}, i)).x;
        sum += x;
        squares += x * x;
    }
    const double mean = sum / count;
    return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean) / count)};
}

/// Sends two rays on, of any weights: up, and down through itself.
struct two_ways {
    glm::vec3 up{1}, on{1};
};
lantern::bounces scatter(const two_ways& m, glm::vec3 in, const lantern::hit& h) {
    return {{lantern::mirrored(in, h.normal), m.up}, {in, m.on}};
}

/// Counts the rays that it is asked about.
struct counting : every {
    mutable int rays = 0;
    void traverse(const ray& r, lantern::interval range, auto&& offer, auto&&... counter) const {
        ++rays;
        every::traverse(r, range, offer, counter...);
    }
};

template <class Tracer, class Ray>
draws drawn(const Tracer& tracer, const Ray& r) {
    draws counted;
    (void)tracer(r, counting_source{&counted});
    return counted;
}

}  // namespace

TEST_CASE("where nothing is distributed it is the basic ray tracer, to the last bit") {
    using shape = lantern::any_of<sphere, plane>;
    using material = std::variant<diffuse, lantern::blinn_phong, mirror, glass, lantern::emissive, lantern::coated<diffuse, mirror>>;
    const std::vector<object<shape, material>> things{
        {plane{{0, -1, 0}, {0, 1, 0}}, lantern::coated{diffuse{}, mirror{}, 0.2f}},
        {sphere{{-1.5f, 0, -5}, 1}, lantern::blinn_phong{}},
        {sphere{{0.8f, 0, -4}, 1}, glass{.color = {0.9f, 1, 0.8f}}},
        {sphere{{0, 2, -7}, 1.2f}, mirror{glm::vec3(0.8f)}},
        {sphere{{2, 1.5f, -6}, 0.4f}, lantern::emissive{}},
    };
    const std::vector lights{point_light{{4, 6, 0}, glm::vec3(60)}, point_light{{-4, 3, 2}, glm::vec3(20)}};
    const every all{5};
    const lantern::sky blue;
    const lantern::whitted basic{all, things, lights, blue, {.ambient = glm::vec3(0.1f), .depth = 6, .cutoff = 0}};
    const distribution all_effects{all, things, lights, blue, {.ambient = glm::vec3(0.1f), .depth = 6, .split_depth = 6}};
    const lantern::camera cam{lantern::view{.eye = {0, 0.5f, 2}, .target = {0, 0.3f, -4}}};
    const auto a = lantern::render({48, 48}, cam, lantern::jittered{.side = 2}, basic);
    const auto b = lantern::render({48, 48}, cam, lantern::jittered{.side = 2}, all_effects);
#ifdef LANTERN_ALLOW_FP_CONTRACT
    constexpr float tolerance = 1e-4f;  // the compiler may fuse one tracer's code in other places than the other's
#else
    constexpr float tolerance = 0;
#endif
    for (std::uint32_t y = 0; y < 48; ++y)
        for (std::uint32_t x = 0; x < 48; ++x) REQUIRE(glm::distance(a(x, y), b(x, y)) <= tolerance);
}

TEST_CASE("a scene in which everything is sharp draws nothing at all") {
    using material = std::variant<diffuse, mirror, lantern::emissive>;
    const std::vector<object<plane, material>> things{{floor_plane, diffuse{}}, {plane{{0, 9, 0}, {0, -1, 0}}, mirror{}}};
    const std::vector lights{point_light{{3, 3, 0}}, point_light{{-3, 3, 0}}};
    const every all{2};
    const distribution tracer{all, things, lights};
    CHECK(drawn(tracer, down).total() == 0);
    CHECK(drawn(tracer, ray{{0, 1, 0}, {0.1f, 1, 0}}).total() == 0);
    // With the camera: a pinhole and an instant draw nothing either, and what remains is the place in the pixel.
    draws counted;
    const lantern::camera cam{lantern::view{.eye = {0, 2, 5}, .target = {0, 0, 0}}};
    (void)tracer(shoot(cam, glm::vec2(0.5f), counting_source{&counted}), counting_source{&counted});
    CHECK(counted.total() == 0);
}

TEST_CASE("each effect draws its own numbers and no others") {
    using light = std::variant<point_light, lantern::rectangle_light, lantern::moving<point_light>>;
    const std::vector<light> area{lantern::rectangle_light{{-1, 3, -1}, {2, 0, 0}, {0, 0, 2}}, point_light{{0, 3, 0}}};
    const every one{1};
    const std::vector matt{object{floor_plane, diffuse{}}};
    const lantern::timed_ray timed{down, 0.5f};
    const draws soft = drawn(distribution{one, matt, area}, timed);
    CHECK(soft.of(purpose::light) == 2);
    CHECK(soft.total() == 2);

    const std::vector<light> wandering{lantern::moving{point_light{{0, 3, 0}}, {1, 0, 0}}};
    CHECK(drawn(distribution{one, matt, wandering}, timed).total() == 0);

    const std::vector metal{object{floor_plane, glossy{}}};
    const draws gloss = drawn(distribution{one, metal, area}, timed);
    CHECK(gloss.of(purpose::gloss) == 2);
    CHECK(gloss.total() == 2);  // a glossy surface answers no light: none is sampled

    const std::vector ice{object{floor_plane, lantern::frosted{}}};
    CHECK(drawn(distribution{one, ice, no_lights}, down).of(purpose::gloss) == 4);
    CHECK(drawn(distribution{one, ice, no_lights}, down).total() == 4);

    const std::vector pane{object{floor_plane, glass{}}};
    CHECK(drawn(distribution{one, pane, no_lights}, down).total() == 0);
    const draws chosen = drawn(distribution{one, pane, no_lights, lantern::darkness{}, {.split_depth = 0}}, down);
    CHECK(chosen.of(purpose::branch) == 1);
    CHECK(chosen.total() == 1);
    const std::vector nothing{object{floor_plane, glass{.index = 1}}};
    CHECK(drawn(distribution{one, nothing, no_lights, lantern::darkness{}, {.split_depth = 0}}, down).total() == 0);
}

TEST_CASE("what is black is neither followed nor chosen, and what is black in one colour is not black") {
    const auto rays = [](const auto& m, std::uint32_t split) {
        const std::vector things{object{floor_plane, m}};
        const counting all{{1}};
        draws counted;
        const glm::vec3 seen = distribution{all, things, no_lights, white, {.split_depth = split}}(down, counting_source{&counted});
        return std::tuple{all.rays, counted.total(), seen};
    };
    const glm::vec3 black(0), cyan(0, 1, 1), half(0.5f);
    CHECK(rays(mirror{black}, 0) == std::tuple{1, 0, black});
    CHECK(rays(mirror{cyan}, 0) == std::tuple{2, 0, cyan});
    for (const std::uint32_t split : {0u, 1u}) {
        CHECK(rays(two_ways{black, black}, split) == std::tuple{1, 0, black});
        CHECK(rays(two_ways{black, cyan}, split) == std::tuple{2, 0, cyan});
        CHECK(rays(two_ways{cyan, black}, split) == std::tuple{2, 0, cyan});
    }
    CHECK(rays(two_ways{half, half}, 0) == std::tuple{2, 1, glm::vec3(1)});  // one of them, weighed for both
    CHECK(rays(two_ways{cyan, cyan}, 0) == std::tuple{2, 1, 2.0f * cyan});
    CHECK(rays(two_ways{half, half}, 1) == std::tuple{3, 0, glm::vec3(1)});
}

TEST_CASE("what is seen does not depend on the length of a ray's direction") {
    using material = std::variant<diffuse, lantern::blinn_phong, mirror, glossy, glass>;
    const std::vector lights{point_light{{3, 3, 0}, glm::vec3(20)}};
    const every one{1};
    const auto source = independent{}.at({0, 0}, 0);
    for (const material& m : {material(diffuse{}), material(lantern::blinn_phong{}), material(mirror{}), material(glossy{}), material(glass{})}) {
        const std::vector things{object{floor_plane, m}};
        const distribution tracer{one, things, lights, lantern::sky{}};
        for (const glm::vec3 direction : {glm::vec3(0.6f, -0.8f, 0), glm::vec3(0.6f, 0.8f, 0)}) {
            const ray once{{0, 1, 0}, direction}, thrice{{0, 1, 0}, 4.0f * direction};
            CHECK(glm::distance(tracer(once, source), tracer(thrice, source)) < 1e-6f);
        }
    }
}

TEST_CASE("every ray and every light has numbers of its own") {
    using material = std::variant<diffuse, glossy, glass>;
    const std::vector<object<plane, material>> things{
        {plane{{0, 2, 0}, {0, 1, 0}}, glass{}}, {plane{{0, 0, 0}, {0, 1, 0}}, glossy{}}, {plane{{0, 5, 0}, {0, -1, 0}}, diffuse{}}};
    const lantern::rectangle_light lamp{{-1, 4, -1}, {2, 0, 0}, {0, 0, 2}};
    const std::vector lights{lamp, lamp};
    const every all{3};
    recording asked;
    (void)distribution{all, things, lights, white, {.depth = 3}}(ray{{0, 3, 0}, {0, -1, 0}}, recording_source{independent{}.at({0, 0}, 0), &asked});
    // Reflected to the ceiling; and through the glass to the gloss, and from there back through the glass to the ceiling.
    std::string names;
    for (const auto& [name, number] : asked) names += name + "\n";
    INFO(names);
    const auto light = std::to_string(static_cast<std::uint32_t>(purpose::light)), gloss = std::to_string(static_cast<std::uint32_t>(purpose::gloss));
    for (const std::string& name : {"0/ purpose " + light + ", which 0", "0/ purpose " + light + ", which 1", "1/ purpose " + gloss + ", which 0",
                                   "1/0/1/ purpose " + light + ", which 0", "1/0/1/ purpose " + light + ", which 1"})
        CHECK(asked.count(name) == 1);
    CHECK(asked.count("1/0/ purpose " + light + ", which 0") == 0);
}

TEST_CASE("beyond the depth nothing is drawn") {
    const std::vector metal{object{floor_plane, glossy{}}};
    const every one{1};
    CHECK(drawn(distribution{one, metal, no_lights, white, {.depth = 0}}, down).total() == 0);
}

TEST_CASE("leaving an effect out changes no other number, and nothing where the effect has no influence") {
    using shape = lantern::any_of<sphere, plane>;
    using material = std::variant<diffuse, glossy, mirror, glass>;
    using light = std::variant<point_light, lantern::rectangle_light>;
    const lantern::rectangle_light lamp{{-1, 5, -3}, {2, 0, 0}, {0, 0, 2}, glm::vec3(10)};
    const point_light spark{{0, 5, -2}, glm::vec3(40)};
    const auto recorded = [&](material ball, light first, bool lens) {
        const std::vector<object<shape, material>> things{{plane{{0, -1, 0}, {0, 1, 0}}, diffuse{}},
                                                          {sphere{{-1, 0, -4}, 1}, ball},
                                                          {sphere{{1.2f, 0, -4}, 1}, glossy{.width = 0.3f}}};
        const std::vector<light> lights{first, lamp};
        const every all{3};
        const distribution tracer{all, things, lights, white};
        const lantern::view v{.eye = {0, 0, 2}, .target = {0, 0, -4}};
        recording all_numbers;
        std::vector<glm::vec3> pixels;
        for (std::uint32_t y = 0; y < 12; ++y)
            for (std::uint32_t x = 0; x < 12; ++x) {
                recording here;
                const recording_source source{independent{}.at({x, y}, 0), &here};
                const glm::vec2 film = glm::vec2(x, y) / 12.0f;
                pixels.push_back(lens ? tracer(shoot(lantern::camera{v, lantern::thin_lens{0.0f, 6}}, film, source), source)
                                      : tracer(shoot(lantern::camera{v}, film, source), source));
                for (const auto& [name, number] : here)
                    all_numbers[std::to_string(x) + "," + std::to_string(y) + ": " + name] = number;
            }
        return std::pair{all_numbers, pixels};
    };
    const auto [everything, picture] = recorded(glossy{.width = 0.2f}, lamp, true);
    for (const auto& [fewer, other] : {recorded(mirror{}, lamp, true), recorded(glossy{.width = 0.2f}, spark, true),
                                       recorded(glossy{.width = 0.2f}, lamp, false), recorded(mirror{}, spark, false)}) {
        int same = 0, absent = 0;
        for (const auto& [name, number] : everything) {
            const auto found = fewer.find(name);
            absent += found == fewer.end();
            if (found != fewer.end()) {
                REQUIRE(found->second == number);
                ++same;
            }
        }
        CHECK(same > 50);
        CHECK(absent > 5);
    }
    const auto without_lens = recorded(glossy{.width = 0.2f}, lamp, false).second;  // an aperture of 0 has no influence
    for (std::size_t i = 0; i < picture.size(); ++i) REQUIRE(glm::distance(picture[i], without_lens[i]) < 1e-5f);
    const auto with_mirror = recorded(mirror{}, lamp, true).second;
    int equal = 0;
    for (std::size_t i = 0; i < picture.size(); ++i) equal += picture[i] == with_mirror[i];
    CHECK(equal > 100);  // all but those that see the ball
}

TEST_CASE("lights with area: the mean over samples is the exact irradiance times albedo / pi") {
    using light = std::variant<lantern::sphere_light, lantern::disk_light>;
    const std::vector things{object{floor_plane, diffuse{glm::vec3(0.6f)}}};
    const every one{1};
    const std::vector<light> ball{lantern::sphere_light{{3, 4, 0}, 1, glm::vec3(2)}};
    const estimate seen = mean_of(distribution{one, things, ball}, down, 200000);
    const double exact = 0.6 / std::numbers::pi * std::numbers::pi * 2 * (1.0 / 25) * 0.8;
    CHECK(std::abs(seen.mean - exact) < 4.9 * seen.error);  // false alarm: once in a million
    CHECK(seen.error < 1e-3 * exact);
    const std::vector<light> dish{lantern::disk_light{{0, 2, 0}, {0, -1, 0}, 1, glm::vec3(2)}};
    const estimate under = mean_of(distribution{one, things, dish}, down, 200000);
    CHECK(std::abs(under.mean - 0.6 * 2 * (1.0 / 5)) < 4.9 * under.error);  // E = πL R²/(R² + h²)
}

TEST_CASE("half of a light hidden is half of its light, and a light that is seen is not counted twice") {
    using shape = lantern::any_of<plane, lantern::rectangle>;
    using material = std::variant<diffuse, lantern::emissive>;
    const lantern::rectangle_light lamp{{-1, 4, -1}, {2, 0, 0}, {0, 0, 2}, glm::vec3(5)};
    const std::vector<object<shape, material>> open{{floor_plane, diffuse{}}, {surface_of(lamp), lantern::emissive{lamp.radiance}}};
    auto screened = open;
    screened.push_back({lantern::rectangle{{0, 2, -9}, {9, 0, 0}, {0, 0, 18}}, diffuse{glm::vec3(0)}});
    const std::vector lights{lamp};
    const every two{2}, three{3};
    const estimate whole = mean_of(distribution{two, open, lights}, down, 100000);
    const estimate half = mean_of(distribution{three, screened, lights}, ray{{-0.001f, 1, 0}, {0.001f, -1, 0}}, 100000);
    CHECK(std::abs(half.mean - whole.mean / 2) < 4.9 * std::hypot(half.error, whole.error / 2));
    CHECK(distribution{two, open, lights}(ray{{0, 1, 0}, {0, 1, 0}}, independent{}.at({0, 0}, 0)) == lamp.radiance);
}

TEST_CASE("one of two rays by chance is as good as both, on average") {
    using material = std::variant<diffuse, glass, lantern::emissive>;
    using shape = lantern::any_of<sphere, plane>;
    const std::vector<object<shape, material>> things{{sphere{{0, 0, -3}, 1}, glass{.color = {0.9f, 0.9f, 0.9f}}},
                                                      {plane{{0, -1, 0}, {0, 1, 0}}, diffuse{}}};
    const std::vector lights{point_light{{2, 5, 0}, glm::vec3(50)}};
    const every all{2};
    const lantern::sky blue;
    const ray r{{0.8f, 0.2f, 0}, {0, 0, -1}};
    const auto tracer = [&](std::uint32_t split) {
        return distribution{all, things, lights, blue, {.depth = 7, .split_depth = split}};
    };
    const double both = tracer(7)(r, independent{}.at({0, 0}, 0)).x;
    for (const std::uint32_t split : {0u, 1u, 3u}) {
        const estimate one = mean_of(tracer(split), r, 100000);
        INFO("split depth " << split << ": " << one.mean << " +- " << one.error << ", both: " << both);
        CHECK(std::abs(one.mean - both) < 4.9 * one.error + 1e-6);
        CHECK(one.error > 0);
    }
}

TEST_CASE("in an even white world neither glass nor gloss can be seen, whatever is drawn") {
    using material = std::variant<glass, glossy, mirror>;
    dice d{.state = 1};
    for (const material& m : {material(glass{}), material(glossy{.width = 1.5f}), material(glass{.index = 0.7f}), material(mirror{})}) {
        const std::vector things{object{sphere{{0, 0, -3}, 1}, m}};
        const every one{1};
        const distribution tracer{one, things, no_lights, white, {.depth = 200, .split_depth = 0}};
        const independent numbers{.samples = 2000};
        for (std::uint32_t i = 0; i < 2000; ++i) {
            const ray r{{0, 0, 0}, lantern::unit({0.3f * d.between(-1, 1), 0.3f * d.between(-1, 1), -1})};
            REQUIRE(tracer(r, numbers.at({0, 0}, i)).x == Approx(1).epsilon(2e-5));
        }
    }
}

TEST_CASE("frosted glass loses only what is caught along its wall for longer than the depth") {
    const std::vector things{object{sphere{{0, 0, -3}, 1}, lantern::frosted{.width = 0.5f}}};
    const every one{1};
    const distribution tracer{one, things, no_lights, white, {.depth = 200, .split_depth = 0}};
    CHECK(mean_of(tracer, ray{{0.5f, 0, 0}, {0, 0, -1}}, 20000).mean > 0.998);
}

TEST_CASE("a coat of share 0 over anything is not followed and gives no NaN") {
    const std::vector things{object{floor_plane, lantern::coated{diffuse{}, glass{}, 0.0f}}};
    const std::vector lights{point_light{{0, 3, 0}, glm::vec3(9)}};
    const every one{1};
    const std::vector plain{object{floor_plane, diffuse{}}};
    const auto source = independent{}.at({0, 0}, 0);
    for (const std::uint32_t split : {0u, 2u}) {
        const distribution tracer{one, things, lights, white, {.split_depth = split}};
        CHECK(tracer(down, source) == (distribution{one, plain, lights, white}(down, source)));
        CHECK(drawn(tracer, down).total() == 0);
    }
}

TEST_CASE("the time goes through the whole system: a moving light, its shadow, and what a mirror shows of it") {
    using shape = lantern::any_of<plane, lantern::moving<lantern::rectangle>>;
    using material = std::variant<diffuse, mirror>;
    using light = std::variant<point_light, lantern::moving<lantern::sphere_light>>;
    const std::vector<light> lamp{lantern::moving{lantern::sphere_light{{-2, 3, 0}, 0.1f, glm::vec3(100)}, {4, 0, 0}}};
    const every one{1}, two{2};
    const std::vector<object<shape, material>> open{{floor_plane, diffuse{glm::vec3(1)}}};
    // E(t) = π L R² h / d³ with d² = h² + (4 t - 2)²; the mean over t is the integral, h = 3.
    const double exact = 100 * 0.01 * 3 * (2.0 / (9 * std::sqrt(13.0))) / 2;
    double sum = 0;
    const independent numbers{.samples = 100000};
    for (std::uint32_t i = 0; i < 100000; ++i) {
        const auto source = numbers.at({0, 0}, i);
        const lantern::timed_ray r{down, source.draw1(purpose::time)};
        sum += distribution{one, open, lamp}(r, source).x;
    }
    CHECK(sum / 100000 == Approx(exact).epsilon(0.01));

    // A screen that is before the lamp at time 0 and away at time 1: seen straight, and in a mirror.
    const std::vector<light> still{point_light{{0, 3, 0}, glm::vec3(9)}};
    const shape screen = lantern::moving{lantern::rectangle{{-1, 2, -1}, {2, 0, 0}, {0, 0, 2}}, {50, 0, 0}};
    const std::vector<object<shape, material>> shaded{{floor_plane, diffuse{}}, {screen, diffuse{}}};
    const std::vector<object<shape, material>> mirrored{{plane{{0, 0, 4}, {0, 0, -1}}, mirror{}}, {floor_plane, diffuse{}}, {screen, diffuse{}}};
    const every three{3};
    const auto source = independent{}.at({0, 0}, 0);
    for (const float time : {0.0f, 1.0f}) {
        CHECK((distribution{two, shaded, still}(lantern::timed_ray{down, time}, source).x > 0) == (time == 1));
        const ray by_mirror{{0, 1, 2}, {0, -1, 6}};  // to (0, 0, 0) seen in the mirror
        CHECK((distribution{three, mirrored, still}(lantern::timed_ray{by_mirror, time}, source).x > 0) == (time == 1));
    }
}

TEST_CASE("a glossy reflection shows the mean over its square: an edge that cuts it in half") {
    using shape = lantern::any_of<plane, lantern::rectangle>;
    using material = std::variant<glossy, lantern::emissive>;
    // Straight up from the mirror, the half x > 0 of the sky shines.
    const std::vector<object<shape, material>> things{
        {floor_plane, glossy{.color = glm::vec3(1), .width = 0.5f}},
        {lantern::rectangle{{0, 5, -50}, {0, 0, 100}, {50, 0, 0}}, lantern::emissive{.radiance = glm::vec3(2), .back = glm::vec3(2)}}};
    const every all{2};
    const distribution tracer{all, things, no_lights};
    const estimate e = mean_of(tracer, down, 40000);
    CHECK(std::abs(e.mean - 1) < 4.9 * e.error);
    // A quarter of the square when the edge is seen at a quarter of its width: 5 * 0.125 aside.
    const estimate q = mean_of(tracer, ray{{-0.625f, 1, 0}, {0, -1, 0}}, 40000);
    CHECK(std::abs(q.mean - 0.5) < 4.9 * q.error);
}

TEST_CASE("the same picture for any accelerator, to the last bit") {
    using shape = lantern::any_of<sphere, lantern::moving<sphere>>;
    using material = std::variant<diffuse, glossy, glass>;
    dice d{.state = 3};
    std::vector<object<shape, material>> things;
    for (int i = 0; i < 150; ++i) {
        const sphere ball{d.in_cube(3), d.between(0.1, 0.4)};
        const material m = i % 3 == 0 ? material(diffuse{}) : i % 3 == 1 ? material(glossy{}) : material(glass{});
        things.push_back({i % 2 == 0 ? shape(ball) : shape(lantern::moving{ball, d.in_cube(0.5)}), m});
    }
    const std::vector lights{lantern::sphere_light{{4, 4, 4}, 1, glm::vec3(20)}};
    const every all{150};
    const lantern::bvh tree{things};
    const distribution slow{all, things, lights, white};
    const distribution fast{tree, things, lights, white};
    for (std::uint32_t i = 0; i < 1000; ++i) {
        const lantern::timed_ray r{{d.in_cube(5), d.in_cube()}, d.between(0, 1)};
        const auto source = independent{}.at({i, 0}, 0);
        REQUIRE(slow(r, source) == fast(r, source));
    }
}

TEST_CASE("what cannot be is refused when the tracer is made") {
    const every one{1};
    const std::vector things{object{floor_plane, glossy{.width = -1}}};
    CHECK_THROWS_WITH((distribution{one, things, no_lights}), containing("things[0]: glossy: width"));
    const std::vector good{object{floor_plane, glossy{}}};
    const std::vector dot{lantern::disk_light{.radius = 0}};
    CHECK_THROWS_WITH((distribution{one, good, dot}), containing("lights[0]: disk_light: radius"));
    CHECK_THROWS_WITH((distribution{one, good, no_lights, white, {.ambient = glm::vec3(-1)}}), containing("distribution: ambient"));
}
