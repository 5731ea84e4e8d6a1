// SPDX-License-Identifier: MIT
#include <lantern/srgb.hpp>

#include "catch.hpp"

#include <array>
#include <bit>
#include <limits>

using lantern::from_srgb;
using lantern::to_byte;
using lantern::to_srgb;

namespace {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

}  // namespace

TEST_CASE("the curve passes through the standard's points") {
    CHECK(to_srgb(0) == 0);
    CHECK(to_srgb(1) == 1);
    CHECK(to_srgb(0.0031308f) == Approx(0.04045).epsilon(1e-5));
    CHECK(to_srgb(0.001f) == Approx(0.01292));
    CHECK(to_srgb(0.5f) == Approx(0.735356983));  // computed with 40 digits
    CHECK(to_srgb(0.18f) == Approx(0.461356129));
    CHECK(int{to_byte(0.18f)} == 118);  // the photographer's grey card
    CHECK(int{to_byte(0.5f)} == 188);
}

TEST_CASE("what is not in [0, 1] is clamped, and NaN is black") {
    for (const float dark : {not_a_number, -not_a_number, -inf, -1.f, -1e-9f, -0.f, 0.f, 1e-45f}) {
        CHECK(int{to_byte(dark)} == 0);
        CHECK(to_srgb(dark) <= 2e-44f);
        CHECK_FALSE(std::signbit(to_srgb(dark)));
        CHECK(from_srgb(dark) <= 1e-45f);
    }
    for (const float bright : {1.f, 1.0001f, 3e38f, inf}) {
        CHECK(int{to_byte(bright)} == 255);
        CHECK(to_srgb(bright) == 1);
        CHECK(from_srgb(bright) == 1);
    }
}

TEST_CASE("more light never gives a smaller number") {
    float before = 0;
    int byte_before = 0;
    const auto one = std::bit_cast<std::uint32_t>(1.f);
    for (std::uint32_t bits = 0; bits < one; bits += 1009) {
        const auto linear = std::bit_cast<float>(bits);
        const float now = to_srgb(linear);
        const int byte_now = to_byte(linear);
        if (now < before || byte_now < byte_before) FAIL("the curve falls at " << linear);
        before = now;
        byte_before = byte_now;
    }
    CHECK(byte_before == 255);

    // float by float where the straight line meets the power
    before = to_srgb(0.00313f);
    for (float x = 0.00313f; x < 0.0031316f; x = std::nextafter(x, 1.f)) {
        if (to_srgb(x) < before) FAIL("the curve falls at " << x);
        before = to_srgb(x);
    }
}

TEST_CASE("a byte is the nearest of the 256 levels") {
    for (int i = 0; i <= 100'000; ++i) {
        const float linear = static_cast<float>(i) / 100'000;
        const double level = double{to_srgb(linear)} * 255;
        if (std::abs(level - to_byte(linear)) > 0.5) FAIL(linear << " is nearer to another level");
    }
}

TEST_CASE("from_srgb undoes to_srgb, and brings every byte back") {
    for (int byte = 0; byte < 256; ++byte) CHECK(int{to_byte(from_srgb(static_cast<float>(byte) / 255))} == byte);
    for (int i = 0; i <= 1000; ++i) {
        const float linear = static_cast<float>(i) / 1000;
        CHECK(from_srgb(to_srgb(linear)) == Approx(linear).epsilon(3e-6));
    }
}

TEST_CASE("a row of pixels is encoded, and pixels that are not finite are counted once each") {
    const std::array pixels{glm::vec3{0, 0.5f, 1}, glm::vec3{not_a_number, inf, -inf}, glm::vec3{-1, 2, not_a_number}};
    std::array<std::uint8_t, 9> bytes{};
    CHECK(lantern::encode_srgb(pixels, bytes) == 2);
    CHECK(bytes == std::array<std::uint8_t, 9>{0, 188, 255, 0, 255, 0, 0, 255, 0});
}
