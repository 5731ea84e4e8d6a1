// SPDX-License-Identifier: MIT
#include <lantern/png.hpp>

#if defined(INCLUDE_STB_IMAGE_WRITE_H) || defined(STB_IMAGE_WRITE_IMPLEMENTATION) ||                                 \
    defined(STB_IMAGE_WRITE_STATIC) || defined(STBI_WRITE_NO_STDIO) || defined(STBIWDEF) || defined(STBIW_ASSERT) || \
    defined(STBIW_MALLOC) || defined(STBIW_UCHAR) || defined(stbiw__max) || defined(stbiw__sbpush) ||                \
    defined(stbiw__wptag)
#error "png.hpp lets macros of stb escape"
#endif

#include "catch.hpp"
#include "scratch.hpp"

#include <array>
#include <limits>
#include <sstream>
#include <string_view>

// The program's own copy of stb, after ours: to read the files back, and to see that the two do not meet.
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#if __has_include(<stb_image_write.h>)
#include <stb_image.h>
#include <stb_image_write.h>
#else
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>
#endif
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

using lantern::image;
using lantern::write_png;

namespace {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

struct decoded {
    int width = 0, height = 0, channels = 0;
    std::vector<std::uint8_t> bytes;
};

decoded decode(const std::string& file) {
    decoded result;
    const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
        stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(file.data()), static_cast<int>(file.size()),
                              &result.width, &result.height, &result.channels, 0),
        &stbi_image_free);
    REQUIRE(pixels);
    result.bytes.assign(pixels.get(), pixels.get() + result.width * result.height * result.channels);
    return result;
}

std::string png_of(const image& picture) {
    std::ostringstream out;
    write_png(out, picture);
    return out.str();
}

/// The checksum at the end of each chunk (PNG specification, annex D).
std::uint32_t crc(std::string_view bytes) {
    std::uint32_t c = ~std::uint32_t{0};
    for (const char byte : bytes) {
        c ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) c = (c & 1) ? 0xedb88320u ^ (c >> 1) : c >> 1;
    }
    return ~c;
}

}  // namespace

TEST_CASE("a picture reads back with the bytes of the sRGB encoding, the top row first") {
    image picture({37, 23});
    for (std::size_t i = 0; i < picture.pixels().size(); ++i)
        picture.pixels()[i] = glm::vec3(float(i % 37) / 37, float(i) / 900, float(i % 5));
    std::vector<std::uint8_t> expected(3 * picture.pixels().size());
    lantern::encode_srgb(picture.pixels(), expected);

    const decoded back = decode(png_of(picture));
    CHECK(back.width == 37);
    CHECK(back.height == 23);
    CHECK(back.channels == 3);
    CHECK(back.bytes == expected);
}

TEST_CASE("the smallest, a flat and a long picture read back") {
    for (const glm::uvec2 size :
         {glm::uvec2(1, 1), glm::uvec2(300, 200), glm::uvec2(65'536, 1), glm::uvec2(1, 65'536)}) {
        const decoded back = decode(png_of(image(size, glm::vec3(0.5f))));
        CHECK(back.width == int(size.x));
        CHECK(back.height == int(size.y));
        CHECK(back.bytes == std::vector<std::uint8_t>(std::size_t{3} * size.x * size.y, 188));
    }
}

TEST_CASE("every chunk's checksum is right") {
    const std::string file = png_of(image({50, 40}, glm::vec3(0.3f, 0.2f, 0.1f)));
    REQUIRE(file.starts_with("\x89PNG\r\n\x1a\n"));
    const auto number = [&](std::size_t at) {
        std::uint32_t n = 0;
        for (std::size_t i = 0; i < 4; ++i) n = n << 8 | static_cast<unsigned char>(file[at + i]);
        return n;
    };
    std::string chunks;
    std::size_t at = 8;
    for (; at + 12 <= file.size(); at += number(at) + 12) {
        chunks += file.substr(at + 4, 4) + " ";
        CHECK(crc(std::string_view(file).substr(at + 4, number(at) + 4)) == number(at + 8 + number(at)));
    }
    CHECK(at == file.size());
    CHECK(chunks == "IHDR IDAT IEND ");
}

TEST_CASE("a NaN pixel is counted and written as black, never undefined") {
    image picture({2, 1}, glm::vec3(0.5f));
    picture(1, 0) = {not_a_number, inf, -inf};
    std::ostringstream out;
    CHECK(write_png(out, picture) == 1);
    CHECK(decode(out.str()).bytes == std::vector<std::uint8_t>{188, 188, 188, 0, 255, 0});
}

TEST_CASE("paths and streams that cannot be written are errors, and leave nothing behind") {
    const scratch_folder folder;
    const image picture({20, 10}, glm::vec3(0.5f));
    CHECK(write_png(folder / "a/b.png", picture) == 0);
    CHECK(text_of(folder / "a/b.png") == png_of(picture));
    CHECK_THROWS_WITH(write_png(folder / "a/b.png/c.png", picture), containing("c.png: Not a directory"));
    CHECK_THROWS_WITH(write_png(folder / "a", picture), containing("directory"));
    CHECK(folder.entries() == 2);

    if (!std::filesystem::exists("/dev/full")) return;
    std::ofstream full("/dev/full");
    CHECK_THROWS_WITH(write_png(full, picture), containing("No space left"));
}
