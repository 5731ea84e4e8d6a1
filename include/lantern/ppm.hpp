// SPDX-License-Identifier: MIT
#pragma once
// Pictures as PPM: the format that a student can write, and nearly every viewer read.

#include <lantern/image.hpp>
#include <lantern/load.hpp>
#include <lantern/save.hpp>
#include <lantern/srgb.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <istream>
#include <ostream>
#include <string>
#include <vector>

namespace lantern {

namespace ppm {

/// The binary form, "P6": width, height, the largest value 255, then three sRGB bytes a pixel, the top row first.
/// (netpbm.sourceforge.net/doc/ppm.html; that page names the curve of BT.709, and sRGB as the common practice.)
inline std::uint64_t encode(std::ostream& out, const image& picture) {
    const std::uint32_t width = picture.size().x, height = picture.size().y;
    const std::string header = "P6\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n";
    out.write(header.data(), static_cast<std::streamsize>(header.size()));
    std::vector<std::uint8_t> bytes(std::size_t{3} * width);
    std::uint64_t not_finite = 0;
    for (std::uint32_t y = 0; y < height && out; ++y) {
        not_finite += encode_srgb(picture.row(y), bytes);
        out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    }
    return not_finite;
}

}  // namespace ppm

/// Returns the number of pixels that were not finite: NaN and -infinity are written as 0, +infinity as 255.
/// Throws std::runtime_error when it cannot write; see save.hpp for what then becomes of the file.
inline std::uint64_t write_ppm(std::ostream& out, const image& picture) {
    return save(out, [&](std::ostream& to) { return ppm::encode(to, picture); });
}
inline std::uint64_t write_ppm(const std::filesystem::path& path, const image& picture) {
    return save(path, [&](std::ostream& to) { return ppm::encode(to, picture); });
}

/// Reads the binary form with one or two bytes a value, back to linear light. Throws std::runtime_error saying what is
/// wrong and where, whatever the bytes are. Stops behind the last pixel.
[[nodiscard]] inline image read_ppm(std::istream& in) {
    byte_reader from(in, "ppm");
    if (const auto magic = from.word(2); magic != "P6")
        from.fail("\"" + from.printable(magic) + "\" stands for \"P6\"");
    const glm::uvec2 size{from.number(image::longest_side, "width"), from.number(image::longest_side, "height")};
    const std::uint32_t largest = from.number(65'535, "the largest value");
    const std::size_t value_size = largest < 256 ? 1 : 2;
    if (std::uint64_t{size.x} * size.y > image::most_pixels) from.fail("more than 2^28 pixels are announced");

    const auto bytes = from.bytes(3 * value_size * size.x * size.y);
    const auto value = [&](std::size_t i) {
        const unsigned stored = value_size == 1 ? bytes[i] : bytes[2 * i] * 256u + bytes[2 * i + 1];
        return from_srgb(static_cast<float>(stored) / static_cast<float>(largest));
    };
    image picture(size);
    for (std::size_t i = 0; auto& pixel : picture.pixels()) {
        pixel = {value(i), value(i + 1), value(i + 2)};
        i += 3;
    }
    return picture;
}
[[nodiscard]] inline image read_ppm(const std::filesystem::path& path) {
    return load(path, [](std::istream& in) { return read_ppm(in); });
}

}  // namespace lantern
