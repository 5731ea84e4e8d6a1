// SPDX-License-Identifier: MIT
#include <lantern/path.hpp>

#include <lantern/any_of.hpp>
#include <lantern/blinn_phong.hpp>
#include <lantern/bvh.hpp>
#include <lantern/camera.hpp>
#include <lantern/coated.hpp>
#include <lantern/diffuse.hpp>
#include <lantern/disk_light.hpp>
#include <lantern/distribution.hpp>
#include <lantern/emissive.hpp>
#include <lantern/exact_light.hpp>
#include <lantern/glass.hpp>
#include <lantern/glossy.hpp>
#include <lantern/mirror.hpp>
#include <lantern/moving.hpp>
#include <lantern/moving_light.hpp>
#include <lantern/object.hpp>
#include <lantern/plane.hpp>
#include <lantern/rectangle.hpp>
#include <lantern/rectangle_light.hpp>
#include <lantern/sphere.hpp>
#include <lantern/sphere_light.hpp>

#include "catch.hpp"
#include "counting_source.hpp"
#include "exact_scenes.hpp"
#include "hemisphere.hpp"
#include "oracle.hpp"
#include "recording_source.hpp"
#include "statistics.hpp"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <variant>
#include <vector>

// Statistical tests: |z| < 4 fails a right answer once in 16,000 times; the seeds are fixed, so what passes once passes
// always.

using lantern::blinn_phong;
using lantern::coated;
using lantern::darkness;
using lantern::diffuse;
using lantern::emissive;
using lantern::every;
using lantern::glass;
using lantern::glossy;
using lantern::independent;
using lantern::mirror;
using lantern::path_options;
using lantern::plane;
using lantern::point_light;
using lantern::purpose;
using lantern::ray;
using lantern::rectangle;
using lantern::rectangle_light;
using lantern::sphere;
using lantern::sphere_light;
using lantern::strategy;

namespace {

constexpr double pi = std::numbers::pi;

/// A matt surface with any pattern of albedo and emission: functions of the place.
struct pattern {
    double (*albedo)(glm::dvec3);
    double (*emission)(glm::dvec3);
};
glm::vec3 evaluate(const pattern& m, glm::vec3 in, const lantern::hit& h, glm::vec3 out) {
    return evaluate(diffuse{glm::vec3(float(m.albedo(glm::dvec3(h.point))))}, in, h, out);
}
glm::vec3 emitted(const pattern& m, glm::vec3, const lantern::hit& h) {
    return glm::vec3(float(m.emission(glm::dvec3(h.point))));
}

/// As bright as white paper and a mirror at once.
struct twice_white {};
glm::vec3 evaluate(twice_white, glm::vec3 in, const lantern::hit& h, glm::vec3 out) { return evaluate(diffuse{glm::vec3(1)}, in, h, out); }
lantern::bounces scatter(twice_white, glm::vec3 in, const lantern::hit& h) { return scatter(mirror{glm::vec3(1)}, in, h); }

/// Two rays, the first of them black.
struct only_second {};
lantern::bounces scatter(only_second, glm::vec3 in, const lantern::hit& h) {
    return {{lantern::mirrored(in, h.normal), glm::vec3(0)}, {in, glm::vec3(0.5f)}};
}

/// Draws directions of which it says that it never draws them: as at the border of a lobe, by rounding.
struct forgetful {};
glm::vec3 evaluate(forgetful, glm::vec3 in, const lantern::hit& h, glm::vec3 out) { return evaluate(diffuse{}, in, h, out); }
glm::vec3 draw(forgetful, glm::vec3 in, const lantern::hit& h, glm::vec2 xi) { return lantern::draw_by_cosine(in, h, xi); }
double density(forgetful, glm::vec3, const lantern::hit&, glm::vec3) { return 0; }

/// Counts how often it is asked for its answer to light.
struct questioned {
    int* times;
};
glm::vec3 evaluate(const questioned& m, glm::vec3 in, const lantern::hit& h, glm::vec3 out) {
    ++*m.times;
    return evaluate(diffuse{}, in, h, out);
}

/// Counts the rays that it is asked about.
struct counting : every {
    mutable int rays = 0;
    void traverse(const ray& r, lantern::interval range, auto&& offer, auto&&... counter) const {
        ++rays;
        every::traverse(r, range, offer, counter...);
    }
};

// Everything that the library has, in one scene's types.
using shape = lantern::any_of<sphere, plane, rectangle, lantern::disk, lantern::moving<sphere>, lantern::moving<rectangle>>;
using material = std::variant<diffuse, blinn_phong, mirror, glass, glossy, lantern::frosted, emissive, coated<diffuse, mirror>,
                              coated<blinn_phong, glossy>, coated<diffuse, lantern::frosted>, pattern>;
using lamp = std::variant<point_light, rectangle_light, sphere_light, lantern::disk_light, lantern::moving<sphere_light>>;
using thing = lantern::object<shape, material>;

const lantern::sky white{.horizon = glm::vec3(1), .zenith = glm::vec3(1)};
const std::vector<lamp> no_lights;
const std::array all_strategies{strategy::both, strategy::lights, strategy::materials};

template <class Thing = thing, class Background = darkness>
statistics::mean mean_of(const std::vector<Thing>& things, const std::vector<lamp>& lights, const ray& r, std::uint32_t count,
                         const path_options& options = {}, const Background& background = {}) {
    const every all{std::uint32_t(things.size())};
    const lantern::path tracer{all, things, lights, background, options};
    statistics::mean m;
    const independent numbers{.samples = count, .seed = 7};
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto source = numbers.at({0, 0}, i);
        m.add(double(tracer(lantern::timed_ray{r, source.draw1(purpose::time)}, source).x));
    }
    return m;
}

/// The same for each colour by itself.
std::array<statistics::mean, 3> colours_of(const std::vector<thing>& things, const std::vector<lamp>& lights, const ray& r, std::uint32_t count) {
    const every all{std::uint32_t(things.size())};
    const lantern::path tracer{all, things, lights};
    std::array<statistics::mean, 3> m;
    const independent numbers{.samples = count, .seed = 8};
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::vec3 seen = tracer(lantern::timed_ray{r, 0}, numbers.at({0, 0}, i));
        for (int k = 0; k < 3; ++k) m[std::size_t(k)].add(double(seen[k]));
    }
    return m;
}

template <class Tracer>
draws drawn(const Tracer& tracer, const ray& r) {
    draws counted;
    (void)tracer(lantern::timed_ray{r, 0}, counting_source{&counted});
    return counted;
}

const rectangle ground{{-1000, 0, 1000}, {2000, 0, 0}, {0, 0, -2000}};  // faces up
const ray down{{0, 1, 0}, {0, -1, 0}};

}  // namespace

TEST_CASE("a closed sphere with any pattern: L(x) = Le(x) + rho(x) <Le> / (1 - <rho>)") {
    // Seen from any point of a sphere, all of it is equally bright to a matt surface: an area dA brings dA / 4πR² of its
    // radiance. Means are over heights, of which equal ones have equal areas (Archimedes).
    const pattern walls{[](glm::dvec3 p) { return 0.5 + 0.4 * p.z; }, [](glm::dvec3 p) { return p.x > 0 ? 1 + p.z : 0.25; }};
    const double mean_albedo = 0.5, mean_emission = (1 + 0.25) / 2;
    const std::vector<thing> things{{sphere{{0, 0, 0}, 1}, walls}};
    for (const glm::dvec3 at : {glm::dvec3(0, 0, 1), glm::dvec3(0.6, 0, -0.8), glm::dvec3(-0.48, 0.64, 0.6), glm::dvec3(0.96, -0.28, 0)}) {
        const double exact = walls.emission(at) + walls.albedo(at) * mean_emission / (1 - mean_albedo);
        const auto seen = mean_of(things, no_lights, {{0.1f, 0, 0}, glm::vec3(at) - glm::vec3(0.1f, 0, 0)}, 200'000);
        INFO(seen.value() << " +- " << seen.standard_error() << ", exact " << exact);
        CHECK(std::abs(seen.z(exact)) < 4);
        CHECK(seen.standard_error() < 3e-3 * exact);
    }
}

TEST_CASE("no light is lost at an albedo of .999, nor at .9999") {
    // 1000 bounces and more. A depth of 50 would lose 95 %, one of 5000 still 0.7 %.
    const auto half_shines = [](glm::dvec3 p) { return p.y > 0 ? 2.0 : 0; };
    const auto check = [&](double albedo, const pattern& walls, std::uint32_t count, double error) {
        const std::vector things{lantern::object{sphere{{0, 0, 0}, 1}, walls}};
        const double rho = double(float(albedo)), exact = rho / (1 - rho);
        const auto seen = mean_of(things, no_lights, {{0, 0, 0}, {0, -1, 0}}, count);
        INFO("albedo " << albedo << ": " << seen.value() << " +- " << seen.standard_error() << ", exact " << exact);
        CHECK(std::abs(seen.z(exact)) < 4);
        CHECK(seen.standard_error() < error * exact);
    };
    check(0.999, {[](glm::dvec3) { return 0.999; }, half_shines}, 5000, 0.015);
    check(0.9999, {[](glm::dvec3) { return 0.9999; }, half_shines}, 200, 0.08);
}

TEST_CASE("a lamp in the middle of a closed sphere: all strategies agree with the closed form") {
    // The wall sees the black lamp under (r/R)² of its cosines, and itself for the rest: E = E0 / (1 - ρ (1 - (r/R)²)).
    const sphere_light bulb{{0, 0, 0}, 0.25f, glm::vec3(3)};
    const std::vector<lamp> lights{bulb};
    for (const float albedo : {0.5f, 0.95f}) {
        const std::vector<thing> things{{sphere{{0, 0, 0}, 1}, diffuse{glm::vec3(albedo)}}, {surface_of(bulb), emissive{bulb.radiance}}};
        const double factor = 1.0 / 16, exact = double(albedo) * 3 * factor / (1 - double(albedo) * (1 - factor));
        for (const strategy how : all_strategies) {
            const auto seen = mean_of(things, lights, {{0, 0.5f, 0}, {0.3f, 0.5f, 0.2f}}, 100'000, {.light_search = how});
            INFO("strategy " << int(how) << ": " << seen.value() << " +- " << seen.standard_error() << ", exact " << exact);
            CHECK(std::abs(seen.z(exact)) < 4);
        }
    }
}

TEST_CASE("colours are carried each by itself: what one loses is no loss to another") {
    // The bulb in the sphere once more, with walls that swallow all blue light, and reflect the less of green the more of red.
    const sphere_light bulb{{0, 0, 0}, 0.25f, {1, 2, 3}};
    const glm::vec3 albedo(0.95f, 0.4f, 0);
    const std::vector<thing> things{{sphere{{0, 0, 0}, 1}, diffuse{albedo}}, {surface_of(bulb), emissive{bulb.radiance}}};
    const auto seen = colours_of(things, {bulb}, {{0, 0.5f, 0}, {0.3f, 0.5f, 0.2f}}, 100'000);
    for (int k = 0; k < 3; ++k) {
        const double rho = double(albedo[k]), factor = 1.0 / 16, exact = rho * double(bulb.radiance[k]) * factor / (1 - rho * (1 - factor));
        const auto& mean = seen[std::size_t(k)];
        INFO("colour " << k << ": " << mean.value() << " +- " << mean.standard_error() << ", exact " << exact);
        CHECK(std::abs(mean.z(exact)) < 4);
        CHECK(mean.standard_error() <= 0.01 * exact);
    }
}

TEST_CASE("two endless plates light each other: a geometric series") {
    // The lower one shines by itself, too: L1 = 1 + ρ1 L2, L2 = ρ2 L1.
    const std::vector<thing> things{
        {plane{{0, 0, 0}, {0, 1, 0}}, pattern{[](glm::dvec3) { return 0.8; }, [](glm::dvec3) { return 1.0; }}},
        {plane{{0, 3, 0}, {0, -1, 0}}, pattern{[](glm::dvec3) { return 0.5; }, [](glm::dvec3) { return 0.0; }}}};
    const double lower = 1 / (1 - 0.8 * 0.5);
    CHECK(std::abs(mean_of(things, no_lights, down, 100'000).z(lower)) < 4);
    CHECK(std::abs(mean_of(things, no_lights, {{0, 1, 0}, {0.2f, 1, 0}}, 100'000).z(0.5 * lower)) < 4);
}

TEST_CASE("form factors of unit squares: opposite ones .1998, and neighbours .2000") {
    // Howell's catalogue, C-11, at a distance of 1: F = 2/π [½ ln 4/3 + 2 √2 atan 1/√2 - π/2]; and as the walls of a cube are
    // all that its floor sees, 1 = F + 4 F of a neighbour.
    const double opposite = 2 / pi * (0.5 * std::log(4.0 / 3) + 2 * std::numbers::sqrt2 * std::atan(1 / std::numbers::sqrt2) - pi / 2);
    const double neighbour = (1 - opposite) / 4;
    REQUIRE(opposite == Approx(0.19982).epsilon(1e-4));
    const rectangle floor_square{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}};
    const auto mean_on_floor = [&](const rectangle& shining) {
        const std::vector<thing> things{{floor_square, diffuse{glm::vec3(1)}}, {shining, emissive{.radiance = glm::vec3(1), .back = glm::vec3(1)}}};
        const every all{2};
        const lantern::path tracer{all, things, no_lights};
        statistics::mean m;
        const independent numbers{.samples = 200'000};
        for (std::uint32_t i = 0; i < numbers.samples; ++i) {
            const auto source = numbers.at({0, 0}, i);
            const glm::vec2 p = source.draw2(purpose::user);
            m.add(double(tracer(lantern::timed_ray{{{p.x, 0.5f, p.y}, {0, -1, 0}}, 0}, source).x));
        }
        return m;
    };
    CHECK(std::abs(mean_on_floor({{0, 1, 0}, {1, 0, 0}, {0, 0, 1}}).z(opposite)) < 4);
    CHECK(std::abs(mean_on_floor({{0, 0, 0}, {0, 1, 0}, {0, 0, 1}}).z(neighbour)) < 4);
}

TEST_CASE("the irradiance of lamps is the closed form, whichever way they are found, with and without a body") {
    const rectangle_light window{{-1, 2, -0.5f}, {2, 0, 0.5f}, {0, -0.5f, 1.5f}, glm::vec3(3)};
    const sphere_light bulb{{0.75f, 1.5f, 0}, 0.5f, glm::vec3(2)};
    const lantern::disk_light dish{{0.5f, 1.25f, 0.25f}, {0, -1, 0}, 0.75f, glm::vec3(2)};
    namespace exact = lantern::exact;
    const exact::polygon corners = exact::corners({glm::dvec3(window.corner), glm::dvec3(window.edge_u), glm::dvec3(window.edge_v)});
    const double distance = glm::length(glm::dvec3(bulb.center));
    struct known {
        lamp light;
        shape body;
        double irradiance;
        glm::vec3 radiance;
    };
    const std::array lamps{
        known{window, surface_of(window), 3 * exact::irradiance({0, 0, 0}, {0, 1, 0}, corners), window.radiance},
        known{bulb, surface_of(bulb), 2 * exact::sphere_irradiance(distance, 0.5, 1.5 / distance), bulb.radiance},
        known{dish, surface_of(dish), 2 * exact::disc_irradiance(1.25, std::hypot(0.5, 0.25), 0.75), dish.radiance},
    };
    const ray aside{{-0.5f, 0.5f, 1}, {0.5f, -0.5f, -1}};  // to (0, 0, 0), past all lamps
    for (const known& k : lamps) {
        const double exact = 0.6 / pi * k.irradiance;
        const std::vector<thing> without{{ground, diffuse{glm::vec3(0.6f)}}};
        std::vector<thing> with = without;
        with.push_back({k.body, emissive{k.radiance}});
        for (const strategy how : all_strategies) {
            const path_options direct{.depth = 1, .light_search = how};
            const auto seen = mean_of(with, {k.light}, aside, 100'000, direct);
            INFO("strategy " << int(how) << ": " << seen.value() << " +- " << seen.standard_error() << ", exact " << exact);
            CHECK(std::abs(seen.z(exact)) < 4);
            CHECK(std::abs(mean_of(without, {k.light}, aside, 100'000, direct).z(exact)) < 4);
            CHECK(std::abs(mean_of(with, no_lights, aside, 100'000, direct).z(exact)) < 4);  // what shines needs be no lamp
        }
    }
}

TEST_CASE("what a lamp shows and does not light with is found by rays alone, whatever the strategy") {
    // A dish that lights upwards, and glows on its back, which no shadow ray asks for.
    const lantern::disk_light dish{{0.5f, 1.25f, 0.25f}, {0, 1, 0}, 0.75f, glm::vec3(3)};
    const std::vector<thing> things{{ground, diffuse{glm::vec3(0.6f)}}, {surface_of(dish), emissive{.radiance = dish.radiance, .back = glm::vec3(2)}}};
    const double exact = 0.6 / pi * 2 * lantern::exact::disc_irradiance(1.25, std::hypot(0.5, 0.25), 0.75);
    for (const strategy how : all_strategies) {
        const auto seen = mean_of(things, {dish}, {{-0.5f, 0.5f, 1}, {0.5f, -0.5f, -1}}, 50'000, {.depth = 1, .light_search = how});
        INFO("strategy " << int(how) << ": " << seen.value() << " +- " << seen.standard_error() << ", exact " << exact);
        CHECK(std::abs(seen.z(exact)) < 4);
    }
}

TEST_CASE("many lamps are asked one by one after a bounce, and none is forgotten or counted twice") {
    // In a closed box of albedo 1/2, with lamps of which some are seen and others not: all strategies agree.
    std::vector<thing> things{{sphere{{0, 0, 0}, 2}, diffuse{glm::vec3(0.5f)}}};
    std::vector<lamp> lights{point_light{{0.5f, 0.5f, 0}, glm::vec3(0.3f)},
                             rectangle_light{{-1, 1, -1}, {2, 0, 0}, {0, 0, 2}, glm::vec3(0.3f)}};
    for (const float x : {-1.0f, 0.0f, 1.0f}) {
        const sphere_light bulb{{x, 0, 1}, 0.25f, glm::vec3(1 + x / 2)};
        lights.push_back(bulb);
        things.push_back({surface_of(bulb), emissive{bulb.radiance}});
    }
    const auto seen = [&](strategy how) { return mean_of(things, lights, {{0, 0, 0}, {0, -1, -1}}, 200'000, {.light_search = how}); };
    const auto both = seen(strategy::both);
    for (const strategy how : {strategy::lights, strategy::materials}) {
        const auto other = seen(how);
        const double difference = both.value() - other.value(), error = std::hypot(both.standard_error(), other.standard_error());
        INFO(both.value() << " and " << other.value() << " +- " << other.standard_error());
        CHECK(std::abs(difference / error) < 4);
        CHECK(both.standard_error() < other.standard_error());
        CHECK(error < 0.01 * both.value());
    }
}

TEST_CASE("an even white world: every material sends back what it must and no more") {
    const double angle = 0.9;  // of incidence
    const glm::vec3 in = -tilted(angle);
    const lantern::hit up{.normal = {0, 0, 1}};
    const blinn_phong shiny{glm::vec3(0.3f), glm::vec3(0.6f), 30};
    const double shiny_albedo = over_hemisphere([&](glm::vec3 out) { return double(evaluate(shiny, in, up, out).x); });
    struct known {
        material m;
        double albedo;
    };
    const std::vector<known> materials{
        {diffuse{glm::vec3(0.7f)}, 0.7},
        {shiny, shiny_albedo},
        {blinn_phong{glm::vec3(0), glm::vec3(0.6f), 30}, shiny_albedo - 0.3},
        {mirror{glm::vec3(0.8f)}, 0.8},
        {glass{}, 1},
        {glossy{.color = glm::vec3(0.9f), .width = 1.5f}, 0.9},
        {glossy{.color = glm::vec3(0.9f), .width = 1e-6f}, 0.9},
        {lantern::frosted{.width = 0.4f}, 1},
        {coated{diffuse{glm::vec3(0.5f)}, mirror{}, 0.25f}, 0.25 + 0.75 * 0.5},
        {coated{diffuse{glm::vec3(0.5f)}, mirror{}, 0.0f}, 0.5},
        {coated{diffuse{glm::vec3(0.5f)}, mirror{}, 1.0f}, 1},
        {coated{shiny, glossy{.width = 0.7f}, 0.3f}, 0.3 + 0.7 * shiny_albedo},
        {coated{diffuse{glm::vec3(0.5f)}, lantern::frosted{.width = 0.2f}, 0.5f}, 0.75},
    };
    const rectangle plate{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}};
    for (const known& k : materials) {
        const auto seen = mean_of(std::vector<thing>{{plate, k.m}}, no_lights, {-2.0f * in, in}, 100'000, {}, white);
        INFO("material " << k.m.index() << ": " << seen.value() << " +- " << seen.standard_error() << ", exact " << k.albedo);
        // Where nothing is left to chance, the error is that of float arithmetic.
        CHECK((std::abs(seen.z(k.albedo)) < 4 || std::abs(seen.value() - k.albedo) < 1e-6));
        CHECK(seen.standard_error() < 0.01);
    }
}

TEST_CASE("in an even white world nothing that is white can be seen, however often light is sent on in it") {
    for (const material& m : {material(glass{}), material(lantern::frosted{.width = 0.5f}), material(diffuse{glm::vec3(1)}),
                              material(coated{blinn_phong{glm::vec3(1), glm::vec3(0)}, glossy{.width = 0.5f}, 0.4f})}) {
        // A hollow shell: a sphere within a sphere, and rays that go through or between both.
        const std::vector<thing> things{{sphere{{0, 0, -3}, 1}, m}, {sphere{{0.3f, 0, -3}, 0.5f}, m}};
        const auto seen = mean_of(things, no_lights, {{0, 0, 0}, {0.1f, 0.05f, -1}}, 50'000, {}, white);
        INFO("material " << m.index() << ": " << seen.value() << " +- " << seen.standard_error());
        CHECK((std::abs(seen.z(1)) < 4 || std::abs(seen.value() - 1) < 1e-5));
    }
}

TEST_CASE("a path never carries more than 1, whatever it meets, and ends even where nothing is absorbed") {
    const every three{3};
    const std::vector<thing> things{{sphere{{0, 0, -3}, 1}, blinn_phong{{0.9f, 0.6f, 0.3f}, glm::vec3(0)}},
                                    {sphere{{0, -2, -3}, 1.2f}, coated{diffuse{glm::vec3(0.1f)}, mirror{glm::vec3(0.2f)}, 0.3f}},
                                    {sphere{{0, 2, -3}, 1.2f}, coated{diffuse{{0.3f, 0.8f, 0.5f}}, lantern::frosted{{.color = {0.2f, 0.5f, 0.9f}}, 0.2f}, 0.4f}}};
    const lantern::path tracer{three, things, no_lights, white, {.roulette = 0}};
    dice d{.state = 1};
    float most = 0;
    for (std::uint32_t i = 0; i < 100'000; ++i) {
        const ray r{{0, 0, 0}, {d.between(-0.4, 0.4), d.between(-0.8, 0.4), -1}};
        most = std::max(most, lantern::largest(tracer(lantern::timed_ray{r, 0}, independent{}.at({i, 0}, 0))));
    }
    CHECK(most < 1.001f);  // the chance to go on is at most 1 - 2^-14, and each white reflection within the frosted ball adds as much
    const std::vector<thing> hall{{plane{{0, 0, 0}, {0, 1, 0}}, mirror{}}, {plane{{0, 2, 0}, {0, -1, 0}}, mirror{}}};
    CHECK(mean_of(hall, no_lights, down, 20).value() == 0);
}

TEST_CASE("all of lamps and lobes: wide and narrow gloss, near and small lights; no strategy is biased") {
    // A glossy floor lit by a lamp that is seen in it: (clipped lobe) / a² of its light, by the closed form.
    for (const float width : {0.8f, 0.05f, 0.002f}) {
        const rectangle_light window{{0, 2, -3 * width}, {6 * width, 0, 0}, {0, 0, 6 * width}, glm::vec3(2)};
        const glossy metal{.color = glm::vec3(0.7f), .width = width};
        const std::vector<thing> things{{ground, metal}, {surface_of(window), emissive{window.radiance}}};
        // Straight up the square is 2a wide where it meets the lamp, and a quarter of it is past the lamp's edge.
        const float x = -0.5f * width;
        const double exact = 0.7 * 2 * 0.25;
        for (const strategy how : all_strategies) {
            const auto seen = mean_of(things, {window}, {{x, 1, 0}, {0, -1, 0}}, how == strategy::lights ? 400'000u : 50'000u,
                                      {.depth = 1, .light_search = how});
            INFO("width " << width << ", strategy " << int(how) << ": " << seen.value() << " +- " << seen.standard_error());
            CHECK(std::abs(seen.z(exact)) < 4);
        }
    }
}

TEST_CASE("all of a lamp over a coated floor: body and coat are each weighed by what chance they have") {
    // The floor and the lamp above, a body under the coat: what a coat of gloss shows of the lamp, and the irradiance of it.
    const float width = 0.8f, x = -0.4f;
    const rectangle_light window{{0, 2, -2.4f}, {4.8f, 0, 0}, {0, 0, 4.8f}, glm::vec3(2)};
    const double irradiance = 2 * lantern::exact::irradiance({x, 0, 0}, {0, 1, 0}, lantern::exact::corners({glm::dvec3(window.corner), glm::dvec3(window.edge_u), glm::dvec3(window.edge_v)}));
    for (const float share : {0.1f, 0.6f}) {
        const coated floor{blinn_phong{glm::vec3(0.5f), glm::vec3(0)}, glossy{.color = glm::vec3(0.7f), .width = width}, share};
        const std::vector<thing> things{{ground, floor}, {surface_of(window), emissive{window.radiance}}};
        const double exact = double(share) * 0.7 * 2 * 0.25 + double(1 - share) * 0.5 / pi * irradiance;
        for (const strategy how : all_strategies) {
            const auto seen = mean_of(things, {window}, {{x, 1, 0}, {0, -1, 0}}, 200'000, {.depth = 1, .light_search = how});
            INFO("share " << share << ", strategy " << int(how) << ": " << seen.value() << " +- " << seen.standard_error() << ", exact " << exact);
            CHECK(std::abs(seen.z(exact)) < 4);
            CHECK(seen.standard_error() < 0.01 * exact);
        }
    }
}

TEST_CASE("all of a lamp over a polished floor: what is drawn towards the highlight is weighed by its own density") {
    const rectangle_light window{{-1, 1, -1}, {2, 0, 0}, {0, 0, 2}, glm::vec3(2)};
    const std::vector<thing> things{{ground, blinn_phong{glm::vec3(0.2f), glm::vec3(0.7f), 50}}, {surface_of(window), emissive{window.radiance}}};
    std::array<statistics::mean, 3> seen;
    for (const strategy how : all_strategies)
        seen[std::size_t(how)] = mean_of(things, {window}, {{0.3f, 0.5f, 0}, {0.1f, -0.5f, 0}}, 200'000, {.depth = 1, .light_search = how});
    for (const auto& other : {seen[1], seen[2]}) {
        const double error = std::hypot(seen[0].standard_error(), other.standard_error());
        INFO(seen[0].value() << " and " << other.value() << " +- " << error);
        CHECK(std::abs(seen[0].value() - other.value()) < 4 * error);
        CHECK(error < 0.01 * other.value());
    }
}

TEST_CASE("a coat of glass: which of its rays goes on has nothing to do with whether one does") {
    // Below the plate is light, above is none: what is seen passes through. (Body and coat are chosen first, then one of two rays.)
    const coated pane{diffuse{glm::vec3(0)}, lantern::frosted{.body = {.index = 3}, .width = 0}, 0.4f};
    const std::vector<thing> things{{ground, pane}, {plane{{0, -2, 0}, {0, 1, 0}}, emissive{}}};
    const auto both = scatter(glass{.index = 3}, down.direction, lantern::hit{.normal = {0, 1, 0}});
    const auto seen = mean_of(things, no_lights, down, 100'000);
    CHECK(std::abs(seen.z(0.4 * double(both[1].weight.x))) < 4);
    CHECK(seen.standard_error() < 0.01);
}

TEST_CASE("a coat and a body that both send back all that comes are not refused: twice the light") {
    // No real material does. But an integrator that trusts the coat to carry less than all would never look at the body.
    const std::vector things{lantern::object{ground, twice_white{}}};
    const auto seen = mean_of(things, no_lights, down, 100'000, {.depth = 1}, white);
    CHECK(std::abs(seen.z(2)) < 4);
    CHECK(seen.standard_error() < 0.05);
}

TEST_CASE("a lamp may be tiny and as bright as it likes") {
    // Power and distance fixed, the radius from 1e-1 to 1e-12: E = π L (r/d)² cos θ.
    for (const double radius : {1e-1, 1e-3, 1e-6, 1e-9, 1e-12}) {
        const sphere_light spark{{1, 2, 0}, float(radius), glm::vec3(float(1 / (radius * radius)))};
        const std::vector<thing> things{{ground, diffuse{glm::vec3(1)}}, {surface_of(spark), emissive{spark.radiance}}};
        const double d2 = 5, exact = double(spark.radiance.x) * double(spark.radius) * double(spark.radius) / d2 * (2 / std::sqrt(d2));
        const auto seen = mean_of(things, {spark}, down, 2000, {.depth = 1});
        INFO("radius " << radius << ": " << seen.value() << " +- " << seen.standard_error() << ", exact " << exact);
        CHECK((std::abs(seen.z(exact)) < 4 || std::abs(seen.value() / exact - 1) < 1e-6));
        const rectangle_light speck{{1, 2, 0}, {float(radius), 0, 0}, {0, 0, float(radius)}, glm::vec3(float(1 / (radius * radius)))};
        const std::vector<thing> lit{{ground, diffuse{glm::vec3(1)}}, {surface_of(speck), emissive{speck.radiance}}};
        const double below = double(speck.radiance.x) * double(float(radius)) * double(float(radius)) * 4 / (d2 * d2) / pi;
        const auto square = mean_of(lit, {speck}, down, 2000, {.depth = 1});
        CHECK(square.value() == Approx(below).epsilon(std::max(1e-4, 2 * radius)));
    }
}

TEST_CASE("no NaN and no infinity: stiff lights, stiff gloss, every material, corners and grazing rays") {
    dice d{.state = 9};
    std::uint64_t samples = 0, broken = 0;
    for (int scene = 0; scene < 60; ++scene) {
        const float size = d.magnitude_between(-4, 4);
        const float tiny = d.magnitude_between(-12, 0), gloss = d.magnitude_between(-12, 2);
        std::vector<thing> things;
        std::vector<lamp> lights;
        const auto any = [&]() -> material {
            switch (d.below(9)) {
                case 0: return diffuse{glm::vec3(0.999f)};
                case 1: return blinn_phong{glm::vec3(0.2f), glm::vec3(0.8f), d.magnitude_between(-2, 9)};
                case 2: return mirror{};
                case 3: return glass{.index = d.between(0.5, 2)};
                case 4: return glossy{.width = gloss};
                case 5: return lantern::frosted{.width = gloss};
                case 6: return coated{diffuse{}, mirror{}, d.between(0, 1)};
                case 7: return coated{blinn_phong{.exponent = d.magnitude_between(0, 7)}, glossy{.width = gloss}, d.between(0, 1)};
                default: return coated{diffuse{}, lantern::frosted{.width = gloss}, 0.5f};
            }
        };
        for (int i = 0; i < 4; ++i) things.push_back({sphere{size * d.in_cube(), size * d.between(0.1, 0.6)}, any()});
        things.push_back({rectangle{size * d.in_cube(), size * d.in_cube(), size * d.in_cube()}, any()});
        things.push_back({lantern::moving{sphere{size * d.in_cube(), size * 0.3f}, size * d.in_cube()}, any()});
        const glm::vec3 bright(1 / (tiny * tiny));
        const rectangle_light window{size * d.in_cube(), size * tiny * d.in_cube(), size * tiny * d.in_cube(), bright};
        const sphere_light bulb{size * d.in_cube(), size * tiny, bright};
        const lantern::moving<sphere_light> comet{{size * d.in_cube(), size * tiny, bright}, size * d.in_cube()};
        things.push_back({surface_of(window), emissive{bright}});
        things.push_back({surface_of(bulb), emissive{bright}});
        things.push_back({surface_of(comet), emissive{bright}});
        lights = {point_light{size * d.in_cube(), glm::vec3(size * size)}, window, bulb, comet};
        const every all{std::uint32_t(things.size())};
        const lantern::path tracer{all, things, lights, white};
        for (std::uint32_t i = 0; i < 800; ++i, ++samples) {
            const lantern::timed_ray r{{2 * size * d.in_cube(), d.in_cube()}, d.between(0, 1)};
            const glm::vec3 seen = tracer(r, independent{.seed = std::uint64_t(scene)}.at({i, 0}, 0));
            broken += !lantern::is_finite(seen) || std::min({seen.x, seen.y, seen.z}) < 0;
        }
    }
    CHECK(broken == 0);
    CHECK(samples == 48'000);
}

TEST_CASE("what both can see, path tracing and distribution ray tracing see alike") {
    // Up to the first matt surface their light is the same: a path of one bounce more than there are mirrors.
    const rectangle_light window{{-1, 4, -1}, {2, 0, 0}, {0, 0, 2}, glm::vec3(5)};
    const lantern::moving<sphere_light> comet{{{-3, 3, 0}, 0.25f, glm::vec3(30)}, {6, 0, 0}};
    const lantern::camera cam{lantern::view{.eye = {0, 2.5f, 7}, .target = {0, 1, 0}},
                              lantern::thin_lens{.radius = 0.3f, .focus_distance = 5}, lantern::shutter{}};
    for (const material& ball : {material(mirror{glm::vec3(0.8f)}), material(glossy{.color = glm::vec3(0.9f), .width = 0.3f})}) {
        const std::vector<thing> things{
            {ground, diffuse{glm::vec3(0.6f)}},
            {sphere{{0, 1, 0}, 1}, ball},
            {lantern::moving{rectangle{{-2, 1.5f, -2}, {2, 0, 0}, {0, 1, 0}}, {2, 0, 0}}, lantern::blinn_phong{}},
            {surface_of(window), emissive{window.radiance}},
            {surface_of(comet), emissive{comet.surface.radiance}}};
        const std::vector<lamp> lights{window, comet};
        const every all{std::uint32_t(things.size())};
        const lantern::distribution before{all, things, lights, darkness{}, {.depth = 1}};
        const lantern::path one{all, things, lights, darkness{}, {.depth = 1}}, two{all, things, lights, darkness{}, {.depth = 2}};
        std::array<statistics::mean, 3> difference, light;  // by what the eye sees
        const independent numbers{.samples = 60'000};
        for (std::uint32_t i = 0; i < numbers.samples; ++i) {
            const auto source = numbers.at({0, 0}, i);
            const auto r = shoot(cam, source.draw2(purpose::film), source);
            const auto h = closest(all, things, r);
            if (!h || h->index > 2) continue;
            const double seen = double(before(r, source).x);
            light[h->index].add(seen);
            difference[h->index].add(double((h->index == 1 ? two(r, source) : one(r, source)).x) - seen);
        }
        for (std::size_t k = 0; k < 3; ++k) {
            INFO("ball " << ball.index() << ", thing " << k << ": " << difference[k].value() << " +- "
                         << difference[k].standard_error() << " of " << light[k].value());
            CHECK(light[k].value() > 0.01);
            CHECK(std::abs(difference[k].z(0)) < 4);
            CHECK(difference[k].standard_error() < 0.05 * light[k].value());
        }
    }
}

TEST_CASE("antialiasing, soft shadow, gloss, lens and motion at once have the mean and the error that are known for them") {
    // The stage of exact_scenes.hpp, of which distribution ray tracing has been shown: all seven numbers are drawn alike.
    const exact_scenes::stage s;
    const exact_scenes::effects on{.film = true, .shadow = true, .gloss = true, .lens = true, .time = true, .round_lens = true};
    const exact_scenes::effort how{.renderings = 4000};
    const auto square = [](float size, double height) {
        return rectangle{{-size, -size, float(height)}, {2 * size, 0, 0}, {0, 2 * size, 0}};
    };
    const rectangle board{glm::vec3((s.edge - 0.5 * glm::dot(s.path, s.n)) * s.n + 2.0 * s.along + glm::dvec3(0, 0, s.board)),
                          100.0f * glm::vec3(s.n), 100.0f * glm::vec3(s.along)};
    const std::vector<thing> things{{square(4, 0), glossy{.color = glm::vec3(1), .width = s.gloss_width}},
                                    {square(20, s.ceiling), diffuse{glm::vec3(1)}},
                                    {lantern::moving{board, glm::vec3(s.path)}, diffuse{}}};
    // So bright that the ceiling's radiance is 1 above the light's middle.
    const double distance = std::hypot(s.ceiling, glm::length(s.light_center));
    const double area = glm::length(glm::cross(s.light_a, s.light_b));
    const std::vector<lamp> lights{
        rectangle_light{glm::vec3(s.light_center - 0.5 * (s.light_a + s.light_b)), glm::vec3(s.light_a), glm::vec3(s.light_b),
                        glm::vec3(float(pi * std::pow(distance, 4) / (area * s.ceiling * s.ceiling)))}};
    const every all{3};
    const lantern::camera cam{
        lantern::view{.eye = {0, 0, float(s.eye)}, .target = {0, 0, 0}, .up = {0, 1, 0}, .vertical_fov = s.fov},
        lantern::thin_lens{float(s.lens_radius), float(s.focus)}, lantern::shutter{}};
    const lantern::path tracer{all, things, lights, darkness{}, {.depth = 2}};
    const auto o = render_often(predict(s, on, how.side), cam, tracer, lantern::box_filter{}, how);
    INFO(o.rendered_mean << ", exact " << o.mean << "; error " << o.rendered_rmse << ", predicted " << o.rmse);
    CHECK(std::abs(o.z) < 4);
    CHECK(o.rendered_rmse / o.rmse == Approx(1).margin(0.045));  // four standard deviations
}

TEST_CASE("the time goes through the whole path, and to the densities of lamps that move") {
    // E(t) of a lamp that passes: both strategies, and with a body that moves along.
    const lantern::moving<sphere_light> comet{{{-2, 3, 0}, 0.5f, glm::vec3(4)}, {4, 0, 0}};
    const std::vector<thing> things{{ground, diffuse{glm::vec3(1)}}, {surface_of(comet), emissive{comet.surface.radiance}}};
    const double exact = 4 * 0.25 * 3 * (2.0 / (9 * std::sqrt(13.0))) / 2;  // L R² h ∫dt / d³, as in distribution's test
    for (const strategy how : all_strategies) {
        const auto seen = mean_of(things, {comet}, down, 200'000, {.depth = 1, .light_search = how});
        INFO("strategy " << int(how) << ": " << seen.value() << " +- " << seen.standard_error() << ", exact " << exact);
        CHECK(std::abs(seen.z(exact)) < 4);
    }
}

TEST_CASE("each path draws for what it meets and for nothing else") {
    const every one{1}, two{2};
    const std::vector<lamp> spark{point_light{{0, 3, 0}}};
    const rectangle_light window{{-1, 3, -1}, {2, 0, 0}, {0, 0, 2}};
    const path_options direct{.depth = 1};
    const std::vector<thing> sharp{{ground, mirror{}}, {plane{{0, 2, 0}, {0, -1, 0}}, emissive{}}};
    CHECK(drawn(lantern::path{two, sharp, spark}, down).total() == 0);
    const std::vector<thing> matt{{ground, diffuse{}}};
    const draws in_the_dark = drawn(lantern::path{one, matt, no_lights}, down);
    CHECK(in_the_dark.of(purpose::scatter) == 2);
    CHECK(in_the_dark.total() == 2);
    CHECK(drawn(lantern::path{one, matt, spark, darkness{}, direct}, down).total() == 2);
    const std::vector<lamp> soft{window};
    const draws lit = drawn(lantern::path{one, matt, soft, darkness{}, direct}, down);
    CHECK(lit.of(purpose::light) == 2);
    CHECK(lit.total() == 4);
    CHECK(drawn(lantern::path{one, matt, soft, darkness{}, {.depth = 0}}, down).total() == 0);
    const std::vector<thing> pane{{ground, glass{}}};
    const draws chosen = drawn(lantern::path{one, pane, no_lights}, down);
    CHECK(chosen.of(purpose::branch) == 1);
    CHECK(chosen.total() == 1);
    const std::vector half_black{lantern::object{ground, only_second{}}};
    CHECK(drawn(lantern::path{one, half_black, no_lights}, down).total() == 0);
    CHECK(mean_of(half_black, no_lights, down, 1, {}, white).value() == 0.5);
    const std::vector<thing> bare{{ground, coated{diffuse{}, mirror{}, 0.0f}}};
    CHECK(drawn(lantern::path{one, bare, no_lights}, down).total() == 2);  // a coat that is not there is not chosen
    const std::vector<thing> room{{sphere{{0, 0, 0}, 5}, diffuse{}}};
    const std::vector<lamp> both{point_light{{0, 3, 0}}, window};
    const draws deep = drawn(lantern::path{one, room, both, darkness{}, {.depth = 3}}, down);
    CHECK(deep.of(purpose::light_choice) == 2);  // not at the first hit
    CHECK(deep.of(purpose::roulette) == 1);
}

TEST_CASE("no ray is shot where there is nothing to see") {
    const auto rays = [](const material& m, const lamp& light) {
        const std::vector<thing> things{{ground, m}};
        const std::vector<lamp> lights{light};
        const counting all{{1}};
        (void)lantern::path{all, things, lights}(lantern::timed_ray{down, 0}, independent{}.at({0, 0}, 0));
        return all.rays;
    };
    const point_light above{{0, 3, 0}}, below{{0, -3, 0}}, black{{0, 3, 0}, glm::vec3(0)};
    CHECK(rays(diffuse{}, above) == 3);  // the eye's, the shadow's, and one that goes on
    CHECK(rays(diffuse{}, below) == 2);
    CHECK(rays(diffuse{}, black) == 2);
    CHECK(rays(diffuse{glm::vec3(0)}, above) == 1);
    CHECK(rays(mirror{}, above) == 2);
    CHECK(rays(mirror{glm::vec3(0)}, above) == 1);
    // Nor is the material asked about light that does not come.
    int asked = 0;
    const std::vector things{lantern::object{ground, questioned{&asked}}};
    const std::vector<lamp> lights{black};
    const every one{1};
    (void)lantern::path{one, things, lights}(lantern::timed_ray{down, 0}, independent{}.at({0, 0}, 0));
    CHECK(asked == 1);  // for the ray that goes on
}

TEST_CASE("a light in the surface itself gives no NaN") {
    const std::vector<thing> things{{ground, diffuse{}}};
    CHECK(mean_of(things, {point_light{{0, 0, 0}}}, down, 10).value() == 0);
}

TEST_CASE("a direction of density 0 is not followed: it would bring infinity") {
    CHECK(mean_of(std::vector{lantern::object{ground, forgetful{}}}, no_lights, down, 10, {}, white).value() == 0);
}

TEST_CASE("one of two rays draws on as it does in distribution ray tracing") {
    // Through glass, the second of its rays, to a lamp with area and a glossy floor: all numbers by which both go on are the same.
    const std::vector<thing> things{{rectangle{{-9, 1, 9}, {18, 0, 0}, {0, 0, -18}}, glass{}}, {ground, glossy{}}, {plane{{0, 5, 0}, {0, -1, 0}}, diffuse{}}};
    const std::vector<lamp> lights{rectangle_light{{-1, 4, -1}, {2, 0, 0}, {0, 0, 2}}};
    const every all{3};
    const lantern::distribution before{all, things, lights, darkness{}, {.depth = 3, .split_depth = 0}};
    const lantern::path now{all, things, lights, darkness{}, {.depth = 4, .roulette = 4}};  // one more: to be lit counts
    int deep = 0;
    for (std::uint32_t i = 0; i < 20; ++i) {
        const auto source = independent{}.at({i, 0}, 0);
        recording a, b;
        (void)before(lantern::timed_ray{{{0, 2, 0}, {0.2f, -1, 0}}, 0}, recording_source{source, &a});
        (void)now(lantern::timed_ray{{{0, 2, 0}, {0.2f, -1, 0}}, 0}, recording_source{source, &b});
        for (const auto& [name, number] : a) {
            REQUIRE(b.count(name) == 1);
            REQUIRE(b[name] == number);
            deep += name.starts_with("1/0/");
        }
    }
    CHECK(deep > 10);
}

TEST_CASE("the same path for any accelerator, to the last bit") {
    dice d{.state = 3};
    std::vector<lantern::object<lantern::any_of<sphere, lantern::moving<sphere>>, material>> things;
    for (int i = 0; i < 100; ++i) {
        const sphere ball{d.in_cube(3), d.between(0.1, 0.5)};
        const material m = i % 3 == 0 ? material(diffuse{}) : i % 3 == 1 ? material(glossy{}) : material(glass{});
        if (i % 2 == 0) things.push_back({ball, m});
        else things.push_back({lantern::moving{ball, d.in_cube(0.5)}, m});
    }
    const std::vector lights{sphere_light{{4, 4, 4}, 1, glm::vec3(20)}};
    const every all{100};
    const lantern::bvh tree{things};
    const lantern::path slow{all, things, lights, white};
    const lantern::path fast{tree, things, lights, white};
    for (std::uint32_t i = 0; i < 1000; ++i) {
        const lantern::timed_ray r{{d.in_cube(5), d.in_cube()}, d.between(0, 1)};
        const auto source = independent{}.at({i, 0}, 0);
        REQUIRE(slow(r, source) == fast(r, source));
    }
}

TEST_CASE("shares of two strategies add up to 1, from 1e-150 to 1e150, and an infinite density takes all") {
    dice d{.state = 4};
    for (int i = 0; i < 1000; ++i) {
        const double a = std::pow(10, d.between(-150, 150)), b = std::pow(10, d.between(-150, 150));
        REQUIRE(lantern::power_heuristic(a, b) + lantern::power_heuristic(b, a) == Approx(1).epsilon(1e-12));
    }
    CHECK(lantern::power_heuristic(3, 1) == Approx(0.9));
    CHECK(lantern::power_heuristic(0, 0) == 0);
    CHECK(lantern::power_heuristic(std::numeric_limits<double>::infinity(), 5) == 1);
}

TEST_CASE("what cannot be is refused when the tracer is made") {
    const every one{1};
    const rectangle_light window{{-1, 3, -1}, {2, 0, 0}, {0, 0, 2}, glm::vec3(2)};
    const std::vector<lamp> lights{window};
    const std::vector<thing> other{{surface_of(window), emissive{glm::vec3(1)}}};
    CHECK_THROWS_WITH((lantern::path{one, other, lights}), containing("things[0]: radiance is (1, 1, 1), but must be that of lights[0]"));
    const std::vector<thing> bent{{ground, glossy{.width = -1}}};
    CHECK_THROWS_WITH((lantern::path{one, bent, lights}), containing("things[0]: glossy: width"));
}
