// SPDX-License-Identifier: MIT
#include <lantern/image.hpp>

#include "catch.hpp"

#include <cmath>
#include <limits>
#include <utility>

using lantern::accumulator;
using lantern::image;

namespace {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

}  // namespace

TEST_CASE("an image has the size it was made with, in the colour it was made with") {
    const image black({3, 2});
    CHECK(black.size() == glm::uvec2(3, 2));
    CHECK(black.pixels().size() == 6);
    for (const glm::vec3& pixel : black.pixels()) CHECK(pixel == glm::vec3(0));
    CHECK(image({2, 2}, glm::vec3(0.5f))(1, 1) == glm::vec3(0.5f));
}

TEST_CASE("pixels lie row after row from the top, each row from the left") {
    image picture({3, 2});
    picture(1, 0) = glm::vec3(1);
    picture(2, 1) = glm::vec3(2);
    CHECK(picture.pixels()[1] == glm::vec3(1));
    CHECK(picture.pixels()[5] == glm::vec3(2));
    CHECK(picture.row(1)[2] == glm::vec3(2));
    CHECK(picture.row(1).size() == 3);
    CHECK(std::as_const(picture)(2, 1) == glm::vec3(2));
}

TEST_CASE("images are equal when size and pixels are") {
    image a({2, 3}), b({2, 3});
    CHECK(a == b);
    CHECK_FALSE(a == image({3, 2}));
    b(1, 2).z = 1;
    CHECK_FALSE(a == b);
}

TEST_CASE("an image without pixels is refused, and one beyond all sense; value and rule are named") {
    CHECK_THROWS_WITH(image({0, 5}), containing("image: size is 0 x 5, but must be 1 to 65536"));
    CHECK_THROWS_AS(image({5, 0}), std::invalid_argument);
    CHECK_THROWS_AS(image({0, 0}), std::invalid_argument);
    CHECK_THROWS_WITH(image({70'000, 1}), containing("70000 x 1"));
    CHECK_THROWS_AS(image({-1, 1}), std::invalid_argument);
    CHECK_THROWS_WITH(image({65'536, 65'536}), containing("65536 x 65536, but must be at most 268435456 pixels"));
    CHECK_THROWS_AS(image({1u << 31, 1u << 31}), std::invalid_argument);
}

TEST_CASE("rejected samples add up") {
    image picture({1, 1});
    CHECK(picture.rejected() == 0);
    picture.add_rejected(3);
    picture.add_rejected(4);
    CHECK(picture.rejected() == 7);
}

TEST_CASE("the mean of nothing is black") { CHECK(accumulator{}.mean() == glm::vec3(0)); }

TEST_CASE("the mean of equal samples is their value, to the last bit, whatever their number and weights") {
    const glm::vec3 color{0.1f, 1e-30f, 3e38f};
    accumulator sum;
    for (int i = 1; i <= 10'000; ++i) {
        sum.add(color, i % 5 == 0 ? -0.05f : 0.1f + 0.01f * static_cast<float>(i % 7));
        if (sum.mean() != color) FAIL("after " << i << " samples the mean is off");
    }
    CHECK(sum.count() == 10'000);
}

TEST_CASE("the mean is weighted, unless the weights sum to nothing or less") {
    accumulator sum;
    sum.add(glm::vec3(1), 3);
    sum.add(glm::vec3(5), 1);
    CHECK(sum.mean() == glm::vec3(2));
    sum.add(glm::vec3(6), -4);
    CHECK(sum.mean() == glm::vec3(4));
    sum.add(glm::vec3(0), -1);
    CHECK(sum.mean() == glm::vec3(3));
}

TEST_CASE("a hundred million samples still give the nearest float or its neighbour") {
    accumulator sum;  // in float the sum would stop growing at 2^24
    for (int i = 0; i < 50'000'000; ++i) {
        sum.add(glm::vec3(0.1f, 1, 1e30f));
        sum.add(glm::vec3(0.7f, 1, 3e30f));
    }
    const auto mean = static_cast<float>((double{0.1f} + double{0.7f}) / 2);
    CHECK(std::abs(sum.mean().x - mean) <= std::nextafter(mean, inf) - mean);
    CHECK(sum.mean().y == 1);
    const auto large = static_cast<float>((double{1e30f} + double{3e30f}) / 2);
    CHECK(std::abs(sum.mean().z - large) <= std::nextafter(large, inf) - large);
    CHECK(sum.count() == 100'000'000);
}

TEST_CASE("samples that are not finite are left out and counted") {
    accumulator sum;
    sum.add(glm::vec3(1));
    for (const float bad : {not_a_number, inf, -inf}) {
        sum.add({bad, 1, 1});
        sum.add({1, bad, 1});
        sum.add({1, 1, bad});
        sum.add(glm::vec3(1), bad);
    }
    CHECK(sum.mean() == glm::vec3(1));
    CHECK(sum.count() == 1);
    CHECK(sum.rejected() == 12);
}

TEST_CASE("samples of any size that a float holds do not overflow") {
    accumulator sum;
    for (int i = 0; i < 100; ++i) sum.add(glm::vec3(std::numeric_limits<float>::max()), 1e3f);
    CHECK(sum.mean() == glm::vec3(std::numeric_limits<float>::max()));
}
