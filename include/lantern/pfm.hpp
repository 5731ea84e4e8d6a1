// SPDX-License-Identifier: MIT
#pragma once
// Pictures as PFM: linear light in float, nothing lost. For comparing pictures, and for what comes after rendering.

#include <lantern/image.hpp>
#include <lantern/load.hpp>
#include <lantern/save.hpp>

#include <glm/vec3.hpp>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <istream>
#include <locale>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace lantern {

namespace pfm {

/// "PF", width and height, then -1 for "little endian, unit scale", then three floats a pixel, the *bottom* row first.
/// (pauldebevec.com/Research/HDR/PFM)
inline std::uint64_t encode(std::ostream& out, const image& picture) {
    const std::uint32_t width = picture.size().x, height = picture.size().y;
    const std::string header = "PF\n" + std::to_string(width) + " " + std::to_string(height) + "\n-1.0\n";
    out.write(header.data(), static_cast<std::streamsize>(header.size()));
    std::vector<char> bytes(std::size_t{12} * width);
    std::uint64_t not_finite = 0;
    for (std::uint32_t y = height; y-- > 0 && out;) {
        auto to = bytes.begin();
        for (const glm::vec3& pixel : picture.row(y)) {
            not_finite += !is_finite(pixel);
            for (const float value : {pixel.x, pixel.y, pixel.z})
                for (const unsigned shift : {0u, 8u, 16u, 24u})
                    *to++ = static_cast<char>(std::bit_cast<std::uint32_t>(value) >> shift);
        }
        out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    }
    return not_finite;
}

}  // namespace pfm

/// Returns the number of pixels that are not finite. They are written as they are: this is the format to look for them
/// in. Throws std::runtime_error when it cannot write; see save.hpp for what then becomes of the file.
inline std::uint64_t write_pfm(std::ostream& out, const image& picture) {
    return save(out, [&](std::ostream& to) { return pfm::encode(to, picture); });
}
inline std::uint64_t write_pfm(const std::filesystem::path& path, const image& picture) {
    return save(path, [&](std::ostream& to) { return pfm::encode(to, picture); });
}

/// Reads colour ("PF") and grey ("Pf") files of either byte order; the scale is taken for the byte order alone, as most
/// programs do. Throws std::runtime_error saying what is wrong and where, whatever the bytes are.
[[nodiscard]] inline image read_pfm(std::istream& in) {
    byte_reader from(in, "pfm");
    const auto magic = from.word(2);
    if (magic != "PF" && magic != "Pf") from.fail("\"" + from.printable(magic) + "\" stands for \"PF\" or \"Pf\"");
    const glm::uvec2 size{from.number(image::longest_side, "width"), from.number(image::longest_side, "height")};
    if (std::uint64_t{size.x} * size.y > image::most_pixels) from.fail("more than 2^28 pixels are announced");

    const std::string scale_text = from.word();
    std::istringstream scale_stream(scale_text);
    scale_stream.imbue(std::locale::classic());
    double scale = 0;
    if (!(scale_stream >> scale) || !scale_stream.eof() || !std::isfinite(scale) || scale == 0)
        from.fail("the scale is \"" + from.printable(scale_text) + "\", but must be a number other than 0");

    const std::size_t channels = magic == "PF" ? 3 : 1;
    const auto bytes = from.bytes(4 * channels * size.x * size.y);
    const auto value = [&](std::size_t i) {
        const auto byte = [&](std::size_t k) {
            return std::uint32_t{bytes[4 * i + (scale < 0 ? k : 3 - k)]} << (8 * k);
        };
        return std::bit_cast<float>(byte(0) | byte(1) | byte(2) | byte(3));
    };
    image picture(size);
    std::size_t i = 0;
    for (std::uint32_t y = size.y; y-- > 0;) {
        for (glm::vec3& pixel : picture.row(y)) {
            pixel = channels == 3 ? glm::vec3{value(i), value(i + 1), value(i + 2)} : glm::vec3{value(i)};
            i += channels;
        }
    }
    return picture;
}
[[nodiscard]] inline image read_pfm(const std::filesystem::path& path) {
    return load(path, [](std::istream& in) { return read_pfm(in); });
}

}  // namespace lantern
