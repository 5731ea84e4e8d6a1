// SPDX-License-Identifier: MIT
#include <lantern/render.hpp>

#include "catch.hpp"
#include "counting_source.hpp"

#include <atomic>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using lantern::camera;
using lantern::image;
using lantern::ray;
using lantern::render;
using lantern::view;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

const camera ahead{view{.eye = {0, 0, 0}, .target = {0, 0, -1}}};

/// A picture with detail everywhere that draws numbers of its own.
const auto busy = [](const ray& r, const auto& source) {
    const glm::vec3 d = r.direction;
    return glm::vec3(std::sin(40 * d.x), std::cos(30 * d.y + d.x), source.draw1(lantern::purpose::user));
};

}  // namespace

TEST_CASE("the image is the same to the last bit for any number of threads and any tile size") {
    const auto with = [](unsigned threads, std::uint32_t tile) {
        return render({67, 41}, ahead, lantern::jittered{.side = 3, .seed = 5}, busy,
                      {.threads = threads, .tile = tile});
    };
    const image one = with(1, 16);
    for (const unsigned threads : {0u, 1u, 2u, 7u, 100u})
        for (const std::uint32_t tile : {1u, 5u, 16u, 64u, 100'000u, ~0u}) CHECK(with(threads, tile) == one);
}

TEST_CASE("the same seed gives the same image, another seed another") {
    const auto with = [](std::uint64_t seed) { return render({20, 20}, ahead, lantern::independent{4, seed}, busy); };
    CHECK(with(1) == with(1));
    CHECK_FALSE(with(1) == with(2));
}

TEST_CASE("each pixel sees its own part of the view: left is left, the top row is the top") {
    const auto directions = [](const ray& r, const auto&) { return r.direction; };
    const image picture = render({30, 20}, ahead, lantern::jittered{.side = 2}, directions);
    for (std::uint32_t y = 1; y < 20; ++y)
        for (std::uint32_t x = 1; x < 30; ++x) {
            CHECK(picture(x, y).x > picture(x - 1, y).x);
            CHECK(picture(x, y).y < picture(x, y - 1).y);
        }
    CHECK(picture(0, 0).x < 0);
    CHECK(picture(0, 0).y > 0);
}

TEST_CASE("a pixel takes samples from the filter's support around it, and from nowhere else") {
    // One row of ten pixels over directions whose x / -z runs from -1 to 1.
    const camera wide{view{.eye = {0, 0, 0}, .target = {0, 0, -1}, .vertical_fov = 1.5707963f}};
    const auto where = [](const ray& r, const auto&) {
        return glm::vec3(5 * (r.direction.x / -r.direction.z + 1), 0, 0);
    };
    const image picture = render({10, 10}, wide, lantern::jittered{.side = 16}, where);
    for (std::uint32_t x = 0; x < 10; ++x) CHECK(picture(x, 3).x == Approx(x + 0.5).margin(0.01));
}

TEST_CASE("a wider filter blurs: an edge is spread over its radius") {
    const camera wide{view{.eye = {0, 0, 0}, .target = {0, 0, -1}, .vertical_fov = 1.5707963f}};
    const auto edge = [](const ray& r, const auto&) { return glm::vec3(r.direction.x > 0 ? 1 : 0); };
    const auto row = [&](const auto& filter) {
        const image picture = render({10, 1}, wide, lantern::jittered{.side = 32}, edge, {}, filter);
        return std::vector{picture(3, 0).x, picture(4, 0).x, picture(5, 0).x, picture(6, 0).x};
    };
    CHECK(row(lantern::box_filter{}) == std::vector<float>{0, 0, 1, 1});
    const std::vector tent = row(lantern::tent_filter{.radius = 1});
    CHECK(tent[0] == 0);
    CHECK(tent[1] == Approx(0.125).margin(0.005));  // the tent beyond half its radius: ½ · ½²
    CHECK(tent[2] == Approx(0.875).margin(0.005));
    CHECK(tent[3] == 1);
}

TEST_CASE("every sample of every pixel is shaded once") {
    std::atomic<int> calls = 0;
    const auto count = [&](const ray&, const auto&) {
        ++calls;
        return glm::vec3(0);
    };
    (void)render({33, 17}, ahead, lantern::independent{.samples = 5}, count, {.threads = 3, .tile = 4});
    CHECK(calls == 33 * 17 * 5);
}

TEST_CASE("a constant scene stays exactly constant, at any sample count and with any filter") {
    const glm::vec3 color{0.1f, 0.7f, 1.f / 3};
    const auto constant = [&](const ray&, const auto&) { return color; };
    const auto check = [&](std::uint32_t samples, const auto& filter) {
        const image picture = render({9, 9}, ahead, lantern::independent{.samples = samples}, constant, {}, filter);
        CHECK(picture == image({9, 9}, color));
    };
    for (const std::uint32_t samples : {1u, 2u, 3u, 7u, 10u, 100u, 1001u}) {
        check(samples, lantern::box_filter{});
        check(samples, lantern::box_filter{.radius = 2});
        check(samples, lantern::tent_filter{});
        check(samples, lantern::gaussian_filter{});
        check(samples, lantern::mitchell_filter{});  // negative weights
    }
}

TEST_CASE("samples that are not finite are left out and reported") {
    const auto sometimes = [](const ray& r, const auto&) {
        return glm::vec3(r.direction.x < 0 ? not_a_number : 0.25f);
    };
    const image picture = render({10, 10}, ahead, lantern::jittered{.side = 2}, sometimes, {.threads = 2, .tile = 3});
    CHECK(picture.rejected() == 5 * 10 * 4);
    for (std::uint32_t y = 0; y < 10; ++y) {
        CHECK(picture(4, y) == glm::vec3(0));
        CHECK(picture(5, y) == glm::vec3(0.25f));
    }
}

TEST_CASE("one NaN costs one sample, not the pixel") {
    std::atomic<int> calls = 0;
    const auto first_is_bad = [&](const ray&, const auto&) { return glm::vec3(calls++ == 0 ? not_a_number : 0.5f); };
    const image picture = render({1, 1}, ahead, lantern::independent{.samples = 10}, first_is_bad);
    CHECK(picture(0, 0) == glm::vec3(0.5f));
    CHECK(picture.rejected() == 1);
}

// ---- progress -------------------------------------------------------------------------------------------------------

TEST_CASE("progress grows with every tile, ends at 1, and is told by one thread at a time") {
    for (const unsigned threads : {1u, 4u}) {
        std::vector<double> told;
        std::atomic<int> inside = 0;
        const auto progress = [&](double fraction) {
            CHECK(++inside == 1);
            told.push_back(fraction);
            --inside;
        };
        (void)render({40, 24}, ahead, lantern::jittered{.side = 1}, busy,
                     {.threads = threads, .tile = 8, .progress = progress});
        REQUIRE(told.size() == 15);
        for (std::size_t i = 0; i < told.size(); ++i) CHECK(told[i] == static_cast<double>(i + 1) / 15);
    }
}

TEST_CASE("a progress callback that throws stops the render, which throws the same") {
    for (const unsigned threads : {1u, 3u}) {
        std::atomic<int> shaded = 0;
        const auto shade = [&](const ray&, const auto&) {
            ++shaded;
            return glm::vec3(0);
        };
        const auto cancel = [](double) { throw std::domain_error("enough"); };
        CHECK_THROWS_AS(render({400, 400}, ahead, lantern::jittered{.side = 1}, shade,
                               {.threads = threads, .tile = 4, .progress = cancel}),
                        std::domain_error);
        CHECK(shaded < 400 * 400);
    }
}

// ---- failure --------------------------------------------------------------------------------------------------------

TEST_CASE("what a shade throws is thrown by render, when no thread is at work any more") {
    for (const unsigned threads : {1u, 2u, 7u}) {
        std::atomic<int> inside = 0;
        const auto shade = [&](const ray& r, const auto&) {
            ++inside;
            std::this_thread::yield();
            --inside;
            if (r.direction.x > 0.1f) throw std::out_of_range("there");
            return glm::vec3(0);
        };
        CHECK_THROWS_AS(render({64, 64}, ahead, lantern::jittered{.side = 1}, shade, {.threads = threads}),
                        std::out_of_range);
        CHECK(inside == 0);
    }
}

TEST_CASE("an image, sampler or tile without contents is refused, by value and rule") {
    const lantern::jittered sampler;
    CHECK_THROWS_WITH(render({0, 0}, ahead, sampler, busy), containing("image: size is 0 x 0"));
    CHECK_THROWS_AS(render({0, 7}, ahead, sampler, busy), std::invalid_argument);
    CHECK_THROWS_WITH(render({4, 4}, ahead, sampler, busy, {.tile = 0}),
                      containing("tile is 0, but must be at least 1"));
    CHECK_THROWS_WITH(render({4, 4}, ahead, sampler, busy, {.threads = ~0u}), containing("threads is 4294967295"));
    CHECK_THROWS_AS(render({4, 4}, ahead, lantern::independent{.samples = 0}, busy), std::invalid_argument);

    CHECK_THROWS_WITH(render({4, 4}, ahead, sampler, busy, {}, lantern::tent_filter{.radius = -1}),
                      containing("tent_filter: radius is -1"));

    struct idle {
        static std::uint32_t count() { return 0; }
        static auto at(glm::uvec2 pixel, std::uint32_t i) { return lantern::independent{}.at(pixel, i); }
    };
    CHECK_THROWS_WITH(render({4, 4}, ahead, idle{}, busy), containing("sampler: count is 0"));
}

// ---- leaving out ----------------------------------------------------------------------------------------------------

namespace {

/// Hands out counting sources; for one thread.
struct counting_sampler {
    draws* counted;
    static std::uint32_t count() { return 3; }
    [[nodiscard]] counting_source at(glm::uvec2, std::uint32_t) const { return {counted}; }
};

}  // namespace

TEST_CASE("a sample draws two numbers for the film, and those that camera and shade ask for") {
    const auto drawn = [](const auto& cam, const auto& shade) {
        draws counted;
        (void)render({2, 2}, cam, counting_sampler{&counted}, shade, {.threads = 1});
        return counted;
    };
    const auto nothing = [](const ray&, const auto&) { return glm::vec3(0); };
    CHECK(drawn(ahead, nothing).total() == 12 * 2);
    CHECK(drawn(ahead, nothing).of(lantern::purpose::film) == 12 * 2);
    CHECK(drawn(ahead, busy).of(lantern::purpose::user) == 12);
    CHECK(drawn(camera{view{}, lantern::thin_lens{}, lantern::shutter{}}, nothing).total() == 12 * 5);
}

TEST_CASE("rays of a camera with a shutter reach the shade with their time") {
    const camera exposed{view{}, lantern::pinhole{}, lantern::shutter{.open = 0.25f, .close = 0.5f}};
    const auto time = [](const lantern::timed_ray& r, const auto&) { return glm::vec3(r.time); };
    const image picture = render({8, 8}, exposed, lantern::jittered{.side = 8}, time);
    for (const glm::vec3& pixel : picture.pixels()) CHECK(pixel.x == Approx(0.375).margin(0.001));
}

// ---- in_parallel ----------------------------------------------------------------------------------------------------

TEST_CASE("work is done once for every index, by as many threads as asked for and no more") {
    for (const unsigned threads : {0u, 1u, 2u, 7u, 1'000'000'000u}) {
        std::vector<std::atomic<int>> done(50);
        std::mutex lock;
        std::set<std::thread::id> seen;
        lantern::in_parallel(done.size(), threads, [&](std::size_t i) {
            ++done[i];
            const std::lock_guard held(lock);
            seen.insert(std::this_thread::get_id());
        });
        for (const auto& times : done) CHECK(times == 1);
        if (threads != 0) CHECK(seen.size() <= threads);
        if (threads == 1) CHECK(seen.contains(std::this_thread::get_id()));
    }
    lantern::in_parallel(0, 4, [](std::size_t) { FAIL("there is no work"); });
}
