// SPDX-License-Identifier: MIT
// Lab 01's hidden tests: the solution's answers, for inputs drawn anew for each grading.

#include "contract.hpp"

#include <catch.hpp>
#include <hidden.hpp>

#include <lab01_picture/picture.hpp>

using namespace contract::lab01;

TEST_CASE("any pixel of any picture", "[step1]") {
    numbers random = hidden::drawn(1);
    for (int i = 0; i < 200; ++i) {
        const glm::uvec2 size{1 + hidden::below(random, 2000), 1 + hidden::below(random, 2000)};
        const glm::uvec2 pixel{hidden::below(random, size.x), hidden::below(random, size.y)};
        const float fov = random.between(0.1f, 2.5f);
        CHECK(hidden::apart(direction(pixel, size, fov), lab01::direction(pixel, size, fov)) < 1e-5);
    }
}

TEST_CASE("any brightness", "[step2]") {
    numbers random = hidden::drawn(2);
    for (int i = 0; i < 500; ++i) {
        const float linear = random.between(-0.5f, 1.5f), dark = hidden::magnitude(random, 1e-7f, 1);
        CHECK(hidden::apart(encode(linear), lab01::encode(linear)) < 1e-5);
        CHECK(hidden::apart(encode(dark), lab01::encode(dark)) < 1e-5);
    }
}

TEST_CASE("any value becomes a byte", "[step3]") {
    numbers random = hidden::drawn(3);
    for (int i = 0; i < 500; ++i) {
        const float value = random.between(-0.2f, 1.2f);
        CHECK(std::abs(255 * std::clamp(value, 0.0f, 1.0f) - float(quantise(value))) <= 0.5f + 1e-3f);
    }
}

TEST_CASE("any picture", "[step4]") {
    numbers random = hidden::drawn(4);
    for (int i = 0; i < 20; ++i) {
        const glm::uvec2 size{1 + hidden::below(random, 12), 1 + hidden::below(random, 12)};
        std::vector<glm::vec3> pixels(std::size_t{size.x} * size.y);
        for (glm::vec3& each : pixels) each = 0.5f + 0.8f * random.vector();
        const std::string file = ppm(size, pixels), ours = lab01::ppm(size, pixels);
        const std::size_t header = ours.size() - 3 * pixels.size();
        REQUIRE(file.size() == ours.size());
        CHECK(file.substr(0, header) == ours.substr(0, header));
        for (std::size_t k = header; k < file.size(); ++k) CHECK(std::abs(int(std::uint8_t(file[k])) - int(std::uint8_t(ours[k]))) <= 1);
        pixels.push_back({});
        CHECK_THROWS_AS(ppm(size, pixels), std::invalid_argument);
    }
}
