// SPDX-License-Identifier: MIT
#include <lantern/pfm.hpp>

#include "broken.hpp"
#include "catch.hpp"
#include "scratch.hpp"

#include <cstring>
#include <limits>
#include <sstream>

using lantern::image;
using lantern::read_pfm;
using lantern::write_pfm;

using namespace std::string_literals;

namespace {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

std::string pfm_of(const image& picture) {
    std::ostringstream out;
    write_pfm(out, picture);
    return out.str();
}

image decoded(const std::string& text) {
    std::istringstream in(text);
    return read_pfm(in);
}

image odd_values() {
    image picture({3, 2});
    picture(0, 0) = {-0.f, 1e-45f, 3e38f};
    picture(1, 0) = {0.1f, -7, 1e-10f};
    picture(2, 1) = {12345.678f, 1, 2};
    return picture;
}

}  // namespace

TEST_CASE("a file is its header and twelve bytes a pixel, little endian, the bottom row first") {
    image picture({1, 2});
    picture(0, 0) = {1, 2, -0.5f};  // 3f800000, 40000000, bf000000
    picture(0, 1) = {0, 0, 1};
    CHECK(pfm_of(picture) ==
          "PF\n1 2\n-1.0\n"
          "\0\0\0\0\0\0\0\0\0\0\x80\x3f"
          "\0\0\x80\x3f\0\0\0\x40\0\0\0\xbf"s);
}

TEST_CASE("every float survives writing and reading, to the last bit") {
    image picture = odd_values();
    picture(1, 1) = {not_a_number, inf, -inf};
    std::ostringstream out;
    CHECK(write_pfm(out, picture) == 1);
    const image back = decoded(out.str());
    REQUIRE(back.size() == picture.size());
    CHECK(std::memcmp(back.pixels().data(), picture.pixels().data(), picture.pixels().size_bytes()) == 0);
}

TEST_CASE("both byte orders and grey pictures are read") {
    CHECK(decoded("PF 1 1 1.0\n\x3f\x80\0\0\x40\0\0\0\xbf\0\0\0"s)(0, 0) == glm::vec3(1, 2, -0.5f));
    CHECK(decoded("Pf\n1 2\n-2.5e-1\n\0\0\x80\x3f\0\0\0\x40"s)(0, 1) == glm::vec3(1));
}

TEST_CASE("a header that promises too much, or nonsense, is refused with the rule and the place") {
    CHECK_THROWS_WITH(decoded(""), containing("pfm: the file ends early at byte 0"));
    CHECK_THROWS_WITH(decoded("P6 1 1 255\n"), containing("\"P6\" stands for \"PF\" or \"Pf\""));
    CHECK_THROWS_WITH(decoded("PF 0 1 -1\n"), containing("width is 0"));
    CHECK_THROWS_WITH(decoded("PF 1 65537 -1\n"), containing("height is 65537"));
    CHECK_THROWS_WITH(decoded("PF 65536 65536 -1\n"), containing("2^28"));
    CHECK_THROWS_WITH(decoded("PF 16384 16384 -1\nxyz"), containing("ends early"));
    for (const char* scale : {"0", "-0.0", "nan", "inf", "x", "1x", "1e999", "--1", "0x"})
        CHECK_THROWS_WITH(decoded("PF 1 1 " + std::string(scale) + "\n123456789012"), containing("the scale is"));
}

TEST_CASE("files that are cut short or changed throw or read, and do nothing else") {
    const std::string good = pfm_of(odd_values());
    CHECK(accepted_when_cut(good, decoded) == 0);
    CHECK(read_when_mutated(good, 2000, decoded) > 100);
}

TEST_CASE("paths and streams that cannot be written are errors, and leave nothing behind") {
    const scratch_folder folder;
    const image picture = odd_values();
    CHECK(write_pfm(folder / "a/b.pfm", picture) == 0);
    CHECK(read_pfm(folder / "a/b.pfm") == picture);
    CHECK_THROWS_WITH(write_pfm(folder / "a/b.pfm/c.pfm", picture), containing("c.pfm: Not a directory"));
    CHECK_THROWS_WITH(read_pfm(folder / "missing.pfm"), containing("missing.pfm: No such file"));
    CHECK(folder.entries() == 2);

    if (!std::filesystem::exists("/dev/full")) return;
    std::ofstream full("/dev/full");
    CHECK_THROWS_WITH(write_pfm(full, image({100, 100})), containing("No space left"));
}
