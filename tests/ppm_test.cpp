// SPDX-License-Identifier: MIT
#include <lantern/ppm.hpp>

#include "broken.hpp"
#include "catch.hpp"
#include "scratch.hpp"

#include <limits>
#include <locale>
#include <sstream>

using lantern::image;
using lantern::read_ppm;
using lantern::write_ppm;

using namespace std::string_literals;

namespace {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

std::string ppm_of(const image& picture) {
    std::ostringstream out;
    write_ppm(out, picture);
    return out.str();
}

image decoded(const std::string& text) {
    std::istringstream in(text);
    return read_ppm(in);
}

image colourful() {
    image picture({7, 5});
    for (float value = 0; auto& pixel : picture.pixels()) {
        pixel = {lantern::from_srgb(value / 255), lantern::from_srgb((value + 1) / 255),
                 lantern::from_srgb((value + 2) / 255)};
        value += 7;
    }
    return picture;
}

}  // namespace

TEST_CASE("a file is its header and three bytes a pixel, the top row first") {
    image picture({2, 2});
    picture(0, 0) = {1, 0, 0};
    picture(1, 0) = {0, 0.5f, 0};
    picture(1, 1) = {0, 0, 2};
    CHECK(ppm_of(picture) == "P6\n2 2\n255\n\xff\0\0\0\xbc\0\0\0\0\0\0\xff"s);
}

TEST_CASE("bytes survive reading and writing") {
    const std::string written = ppm_of(colourful());
    CHECK(ppm_of(decoded(written)) == written);
    CHECK(decoded(written).size() == glm::uvec2(7, 5));
}

TEST_CASE("every level comes back as itself") {
    image picture({256, 1});
    for (std::uint32_t i = 0; i < 256; ++i) picture(i, 0) = glm::vec3(lantern::from_srgb(static_cast<float>(i) / 255));
    CHECK(decoded(ppm_of(picture)) == picture);
}

TEST_CASE("a NaN pixel is counted and written as black, never undefined") {
    image picture({2, 2}, glm::vec3(0.5f));
    picture(1, 0) = {not_a_number, 0.5f, inf};
    picture(0, 1) = {-inf, -1e-9f, 2};
    std::ostringstream out;
    CHECK(write_ppm(out, picture) == 2);
    CHECK(out.str() == "P6\n2 2\n255\n\xbc\xbc\xbc\0\xbc\xff\0\0\xff\xbc\xbc\xbc"s);
}

TEST_CASE("the header does not follow the locale, width or base of the stream") {
    struct grouping : std::numpunct<char> {
        char do_thousands_sep() const override { return ','; }
        std::string do_grouping() const override { return "\3"; }
    };
    std::ostringstream out;
    out.imbue(std::locale(out.getloc(), new grouping));
    out << std::hex;
    out.width(20);
    write_ppm(out, image({2000, 1}));
    CHECK(out.str().starts_with("P6\n2000 1\n255\n"));
}

TEST_CASE("comments, any white space and two-byte values are read") {
    const image picture = decoded("P6 # made by hand\n#\n2\t1\r\n# 65535\n65535\n\xff\xff\0\0\x80\0\0\0\0\0\xff\xff"s);
    CHECK(picture.size() == glm::uvec2(2, 1));
    CHECK(picture(0, 0).x == 1);
    CHECK(picture(0, 0).y == 0);
    CHECK(picture(0, 0).z == lantern::from_srgb(32768.f / 65535));
    CHECK(picture(1, 0) == glm::vec3(0, 0, 1));
}

TEST_CASE("reading stops behind the last pixel, so that pictures can follow each other") {
    std::istringstream in(ppm_of(image({1, 1})) + ppm_of(image({2, 1})));
    CHECK(read_ppm(in).size() == glm::uvec2(1, 1));
    CHECK(read_ppm(in).size() == glm::uvec2(2, 1));
}

TEST_CASE("a header that promises too much, or nonsense, is refused with the rule and the place") {
    CHECK_THROWS_WITH(decoded(""), containing("ppm: the file ends early at byte 0"));
    CHECK_THROWS_WITH(decoded("P5 1 1 255\n1"), containing("\"P5\" stands for \"P6\""));
    CHECK_THROWS_WITH(decoded("P6 0 1 255\n"), containing("width is 0"));
    CHECK_THROWS_WITH(decoded("P6 1 0 255\n"), containing("height is 0"));
    CHECK_THROWS_WITH(decoded("P6 1 -1 255\n"), containing("height is \"-1\""));
    CHECK_THROWS_WITH(decoded("P6 1 1 65536\n"), containing("largest value is 65536"));
    CHECK_THROWS_WITH(decoded("P6 1 1 0\n"), containing("largest value is 0"));
    CHECK_THROWS_WITH(decoded("P6 65537 1 255\n"), containing("width is 65537"));
    CHECK_THROWS_WITH(decoded("P6 65536 65536 255\n"), containing("2^28"));
    CHECK_THROWS_WITH(decoded("P6 16384 16384 65535\nxyz"), containing("ends early"));
    CHECK_THROWS_WITH(decoded("\x89PNG\r\n"), containing("longer than 2"));
}

TEST_CASE("a stored value above the announced largest is white") {
    CHECK(decoded("P6 1 1 10\n\xff\xff\xff")(0, 0) == glm::vec3(1));
}

TEST_CASE("files that are cut short or changed throw or read, and do nothing else") {
    const std::string good = ppm_of(colourful());
    CHECK(accepted_when_cut(good, decoded) == 0);
    CHECK(read_when_mutated(good, 2000, decoded) > 100);
}

TEST_CASE("paths and streams that cannot be written are errors, and leave nothing behind") {
    const scratch_folder folder;
    const image picture = colourful();
    CHECK(write_ppm(folder / "a/b.ppm", picture) == 0);
    CHECK(text_of(folder / "a/b.ppm") == ppm_of(picture));
    CHECK(ppm_of(read_ppm(folder / "a/b.ppm")) == ppm_of(picture));

    CHECK_THROWS_WITH(write_ppm(folder / "a/b.ppm/c.ppm", picture), containing("c.ppm: Not a directory"));
    CHECK_THROWS_WITH(write_ppm(folder / "a", picture), containing("directory"));
    CHECK_THROWS_WITH(read_ppm(folder / "missing.ppm"), containing("missing.ppm: No such file"));
    CHECK_THROWS_WITH(read_ppm(folder / "a"), containing("directory"));
    CHECK(folder.entries() == 2);

    put_text(folder / "cut.ppm", "P6 2 2 255\nxx");
    CHECK_THROWS_WITH(read_ppm(folder / "cut.ppm"), containing("cut.ppm: ppm: the file ends early"));

    if (!std::filesystem::exists("/dev/full")) return;
    std::ofstream full("/dev/full");
    CHECK_THROWS_WITH(write_ppm(full, image({100, 100})), containing("No space left"));
}
