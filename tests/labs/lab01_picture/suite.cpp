// SPDX-License-Identifier: MIT
// Lab 01: from a pixel to a ray, and from colours to a file.

#include "contract.hpp"

#include <catch.hpp>
#include <hint.hpp>

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

using namespace contract::lab01;

namespace {

constexpr float right_angle = std::numbers::pi_v<float> / 2;

/// The angle between two directions, in radians; accurate for small angles too.
float angle(glm::vec3 a, glm::vec3 b) {
    const glm::dvec3 x(a), y(b);
    return float(std::atan2(glm::length(glm::cross(x, y)), glm::dot(x, y)));
}

unsigned char byte(const std::string& file, std::size_t index) {
    return index < file.size() ? static_cast<unsigned char>(file[index]) : 0;
}

}  // namespace

// ---- Step 1: from a pixel to a ray ---------------------------------------------------------------------------------

TEST_CASE("the middle of the picture lies straight ahead", "[step1]") {
    INFO(hint("the picture is shifted", "the ray goes through a corner of its pixel instead of the centre: add half a pixel",
              "§1 The centre of a pixel"));
    const glm::vec3 d = direction({50, 50}, {101, 101}, right_angle);
    CHECK(angle(d, {0, 0, -1}) <= 1e-6f);
}

TEST_CASE("a picture of a single pixel looks straight ahead", "[step1]") {
    INFO(hint("a division by zero, or a ray into a corner", "the pixels are counted as if there were size - 1 of them",
              "§1 The centre of a pixel"));
    const glm::vec3 d = direction({0, 0}, {1, 1}, right_angle);
    CHECK(angle(d, {0, 0, -1}) <= 1e-6f);
}

TEST_CASE("x grows to the right and y upwards", "[step1]") {
    INFO(hint("the picture is upside down, or seen in a mirror",
              "rows are counted from the top, but y grows upwards: one of the two must be turned round", "§1 Which way is up"));
    const glm::vec3 top_left = direction({0, 0}, {8, 6}, 1);
    const glm::vec3 bottom_right = direction({7, 5}, {8, 6}, 1);
    CHECK(top_left.x < 0);
    CHECK(top_left.y > 0);
    CHECK(bottom_right.x > 0);
    CHECK(bottom_right.y < 0);
}

TEST_CASE("the ray goes away from the eye, towards -z", "[step1]") {
    INFO(hint("everything that stands before the eye is missing", "the picture stands at z = +1, behind the eye",
              "§1 The picture in space"));
    CHECK(direction({3, 2}, {8, 6}, 1).z < 0);
}

TEST_CASE("the angle of view lies between the upper and the lower border", "[step1]") {
    INFO(hint("things look too near, or too far away",
              "half the height is the tangent of half the angle; the angle must be in radians", "§1 The angle of view"));
    // In a column of 1000 pixels the centres of the first and the last are 999/1000 of the height apart.
    const float fov = GENERATE(0.2f, 0.7f, 1.5f, 2.8f);
    CAPTURE(fov);
    const glm::vec3 first = direction({0, 0}, {1, 1000}, fov);
    const glm::vec3 last = direction({0, 999}, {1, 1000}, fov);
    CHECK(angle(first, last) == Approx(2 * std::atan(0.999f * std::tan(fov / 2))).epsilon(1e-4));
}

TEST_CASE("pixels are square in a wide and in a high picture", "[step1]") {
    INFO(hint("circles look like eggs", "the width of the picture in space is its height times width / height, in float",
              "§1 The picture in space"));
    const glm::uvec2 size = GENERATE(glm::uvec2(640, 480), glm::uvec2(30, 90), glm::uvec2(500, 500));
    CAPTURE(size.x, size.y);
    const glm::uvec2 middle = size / 2u;
    // Where two rays cross the plane z = -1.
    const auto on_plane = [&](unsigned x, unsigned y) {
        const glm::vec3 d = direction({x, y}, size, 1);
        return glm::vec2(d.x, d.y) / -d.z;
    };
    const float pixel_width = on_plane(middle.x + 1, middle.y).x - on_plane(middle.x, middle.y).x;
    const float pixel_height = on_plane(middle.x, middle.y).y - on_plane(middle.x, middle.y + 1).y;
    CHECK(pixel_width == Approx(pixel_height).epsilon(1e-3));
}

TEST_CASE("directions have length 1", "[step1]") {
    INFO(hint("the colours are too bright towards the corners", "the direction is not normalised", "§1 A direction"));
    const glm::uvec2 pixel = GENERATE(glm::uvec2(0, 0), glm::uvec2(320, 240), glm::uvec2(639, 479), glm::uvec2(17, 400));
    CHECK(glm::length(direction(pixel, {640, 480}, 2)) == Approx(1).epsilon(1e-6));
}

TEST_CASE("neighbouring pixels are equally far apart on the picture, from border to border", "[step1]") {
    INFO(hint("the picture is curved, or its last column is repeated",
              "pixels divide the width evenly: size.x of them, not size.x - 1", "§1 The centre of a pixel"));
    const auto x_on_plane = [](unsigned x) {
        const glm::vec3 d = direction({x, 0}, {4, 4}, right_angle);
        return d.x / -d.z;
    };
    CHECK(x_on_plane(0) == Approx(-0.75f).epsilon(1e-5));
    CHECK(x_on_plane(1) == Approx(-0.25f).epsilon(1e-5));
    CHECK(x_on_plane(2) == Approx(+0.25f).epsilon(1e-5));
    CHECK(x_on_plane(3) == Approx(+0.75f).epsilon(1e-5));
}

// ---- Step 2: the sRGB curve ----------------------------------------------------------------------------------------

TEST_CASE("black stays black and white stays white", "[step2]") {
    INFO(hint("a grey veil, or white that is not white", "the curve must join (0, 0) to (1, 1)", "§2 The curve"));
    CHECK(encode(0) == 0);
    CHECK(encode(1) == Approx(1).epsilon(1e-6));  // in float 1.055 - 0.055 is just below 1
}

TEST_CASE("half the light is told to the screen as about 0.735", "[step2]") {
    INFO(hint("the picture is too dark, or too bright",
              "encoding takes the power 1/2.4 (it brightens); decoding takes the power 2.4; and 1/2.4 in whole numbers is 0",
              "§2 The curve"));
    CHECK(encode(0.5f) == Approx(0.735357).epsilon(1e-4));
    CHECK(encode(0.18f) == Approx(0.461356).epsilon(1e-4));
    CHECK(encode(0.01f) == Approx(0.0998528).epsilon(1e-4));
}

TEST_CASE("the darkest tones lie on a straight line", "[step2]") {
    INFO(hint("dark tones are too bright", "below 0.0031308 the curve is 12.92 times the brightness, not a power", "§2 The curve"));
    CHECK(encode(0.001f) == Approx(0.01292).epsilon(1e-4));
    CHECK(encode(0.003f) == Approx(0.03876).epsilon(1e-4));
}

TEST_CASE("the curve has no step and never falls", "[step2]") {
    INFO(hint("a band in a smooth gradient", "the two pieces of the curve must meet at 0.0031308", "§2 The curve"));
    float before = encode(0);
    for (int i = 1; i <= 10000; ++i) {
        const float now = encode(float(i) / 10000);
        if (!(now >= before && now - before < 0.0015f)) {
            CAPTURE(i, before, now);
            FAIL_CHECK("the curve jumps or falls between " << i - 1 << "/10000 and " << i << "/10000");
            break;
        }
        before = now;
    }
}

TEST_CASE("brightness outside 0 to 1 gives the nearest end", "[step2]") {
    INFO(hint("black or coloured dots where the light is too strong, or a little below zero",
              "a power of a negative number is NaN: clamp before the power, not after it", "§2 Too dark, too bright"));
    CHECK(encode(-1e-9f) == 0);
    CHECK(encode(-5) == 0);
    CHECK(encode(1.5f) == Approx(1).epsilon(1e-6));
    CHECK(encode(std::numeric_limits<float>::infinity()) == Approx(1).epsilon(1e-6));
    CHECK(encode(-std::numeric_limits<float>::infinity()) == 0);
}

// ---- Step 3: from a number to a byte -------------------------------------------------------------------------------

TEST_CASE("0 becomes 0 and 1 becomes 255", "[step3]") {
    INFO(hint("white pixels come out black", "256 does not fit into a byte and wraps round to 0", "§3 Rounding"));
    CHECK(int(quantise(0)) == 0);
    CHECK(int(quantise(1)) == 255);
}

TEST_CASE("every byte comes back from its own value", "[step3]") {
    INFO(hint("the picture is a shade too dark", "a conversion to an integer cuts off: round to the nearest instead", "§3 Rounding"));
    for (int i = 0; i <= 255; ++i) {
        CAPTURE(i);
        REQUIRE(int(quantise(float(i) / 255)) == i);
    }
}

TEST_CASE("a value is never more than half a step from its byte", "[step3]") {
    INFO(hint("the picture is a shade too dark, or too bright", "a conversion to an integer cuts off: round to the nearest instead",
              "§3 Rounding"));
    for (int i = 0; i <= 3000; ++i) {
        const float value = float(i) / 3000;
        CAPTURE(value);
        REQUIRE(std::abs(255 * value - float(quantise(value))) <= 0.5f + 1e-4f);
    }
}

TEST_CASE("a value outside 0 to 1 gives the nearest end", "[step3]") {
    INFO(hint("bright places turn black or change their colour", "the value is not limited to 0 to 255 before it becomes a byte",
              "§3 Rounding"));
    CHECK(int(quantise(1.01f)) == 255);
    CHECK(int(quantise(40)) == 255);
    CHECK(int(quantise(std::numeric_limits<float>::infinity())) == 255);
    CHECK(int(quantise(-0.01f)) == 0);
    CHECK(int(quantise(-40)) == 0);
}

TEST_CASE("what is not a number becomes 0", "[step3]") {
    INFO(hint("different bytes on different machines", "NaN fails every comparison, so `x < 0` does not catch it: `!(x > 0)` does",
              "§3 Not a number"));
    CHECK(int(quantise(std::numeric_limits<float>::quiet_NaN())) == 0);
}

// ---- Step 4: the PPM file ------------------------------------------------------------------------------------------

TEST_CASE("the header is P6, width, height and 255", "[step4]") {
    INFO(hint("the viewer refuses the file", "the header is \"P6\\n3 2\\n255\\n\": width first, and one single white space after 255",
              "§4 The header"));
    const std::vector<glm::vec3> pixels(6);
    const std::string file = ppm({3, 2}, pixels);
    CHECK(file.substr(0, 11) == "P6\n3 2\n255\n");
}

TEST_CASE("each pixel takes three bytes and nothing follows them", "[step4]") {
    INFO(hint("the picture is slanted, or cut off", "the file holds a header and then exactly 3 * width * height bytes: no spaces, no line ends",
              "§4 The pixels"));
    const std::vector<glm::vec3> pixels(20, glm::vec3{0.2f, 0.5f, 0.7f});
    CHECK(ppm({5, 4}, pixels).size() == std::string("P6\n5 4\n255\n").size() + 60);
}

TEST_CASE("pixels stand in rows, red before green before blue", "[step4]") {
    INFO(hint("the picture is turned on its side, or its colours are swapped",
              "write the pixels in the order in which they come; red, green, blue for each", "§4 The pixels"));
    // Saturated colours: neither the curve nor the rounding matters here.
    const std::vector<glm::vec3> pixels{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 1, 1}, {1, 1, 1}};
    const std::string file = ppm({3, 2}, pixels);
    const std::size_t header = 11;
    for (std::size_t i = 0; i < pixels.size(); ++i)
        for (int channel = 0; channel < 3; ++channel) {
            CAPTURE(i, channel);
            REQUIRE(int(byte(file, header + 3 * i + std::size_t(channel))) == int(255 * pixels[i][channel]));
        }
}

TEST_CASE("the bytes are encoded colours", "[step4]") {
    INFO(hint("the picture is too dark", "the linear colour goes to the file without step 2", "§4 The pixels"));
    const std::vector<glm::vec3> pixels{{0.5f, 0.18f, 0.01f}};
    const std::string file = ppm({1, 1}, pixels);
    CHECK(int(byte(file, 11)) == 188);
    CHECK(int(byte(file, 12)) == 118);
    CHECK(int(byte(file, 13)) == 25);
}

TEST_CASE("a picture with a pixel too few is refused", "[step4]") {
    INFO(hint("the end of the picture is garbage, or the program dies", "compare pixels.size() with size.x * size.y and throw std::invalid_argument",
              "§4 Refuse what is wrong"));
    const std::vector<glm::vec3> pixels(5);
    CHECK_THROWS_AS(ppm({3, 2}, pixels), std::invalid_argument);
    CHECK_THROWS_AS(ppm({2, 2}, pixels), std::invalid_argument);
}
