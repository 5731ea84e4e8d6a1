// SPDX-License-Identifier: MIT
#pragma once
// Pictures as PNG. The only header that needs stb_image_write; programs that do not write PNG do not need stb.

#include <lantern/image.hpp>
#include <lantern/save.hpp>
#include <lantern/srgb.hpp>

#include <cassert>
#include <cstdarg>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <new>
#include <ostream>
#include <vector>

// stb_image_write as a private part of this file: in a namespace of its own, without its warnings, and without a trace
// of its macros, so that a program may use its own copy of stb before or after this header.
#pragma push_macro("INCLUDE_STB_IMAGE_WRITE_H")
#pragma push_macro("STB_IMAGE_WRITE_IMPLEMENTATION")
#pragma push_macro("STB_IMAGE_WRITE_STATIC")
#pragma push_macro("STBI_WRITE_NO_STDIO")
#pragma push_macro("STBIWDEF")
#pragma push_macro("STBIW_ASSERT")
#undef INCLUDE_STB_IMAGE_WRITE_H
#undef STBIWDEF
#undef STBIW_ASSERT
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#define STBIW_ASSERT(x) assert(x)
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#endif
namespace lantern::stb {
#if __has_include(<stb_image_write.h>)
#include <stb_image_write.h>
#else
#include <stb/stb_image_write.h>  // Debian, Fedora
#endif
}  // namespace lantern::stb
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif
#undef STBIW_MALLOC
#undef STBIW_REALLOC
#undef STBIW_REALLOC_SIZED
#undef STBIW_FREE
#undef STBIW_MEMMOVE
#undef STBIW_UCHAR
#undef stbiw__max
#undef stbiw__sbraw
#undef stbiw__sbm
#undef stbiw__sbn
#undef stbiw__sbneedgrow
#undef stbiw__sbmaybegrow
#undef stbiw__sbgrow
#undef stbiw__sbpush
#undef stbiw__sbcount
#undef stbiw__sbfree
#undef stbiw__zlib_flush
#undef stbiw__zlib_add
#undef stbiw__zlib_huffa
#undef stbiw__zlib_huff1
#undef stbiw__zlib_huff2
#undef stbiw__zlib_huff3
#undef stbiw__zlib_huff4
#undef stbiw__zlib_huff
#undef stbiw__zlib_huffb
#undef stbiw__ZHASH
#undef stbiw__wpng4
#undef stbiw__wp32
#undef stbiw__wptag
#pragma pop_macro("STBIW_ASSERT")
#pragma pop_macro("STBIWDEF")
#pragma pop_macro("STBI_WRITE_NO_STDIO")
#pragma pop_macro("STB_IMAGE_WRITE_STATIC")
#pragma pop_macro("STB_IMAGE_WRITE_IMPLEMENTATION")
#pragma pop_macro("INCLUDE_STB_IMAGE_WRITE_H")

namespace lantern {

// `static`, not `inline`: stb's functions are private to each source file, and so must be what calls them.

namespace png {

/// Eight bits a channel, sRGB, the top row first.
[[maybe_unused]] static std::uint64_t encode(std::ostream& out, const image& picture) {
    const int width = static_cast<int>(picture.size().x), height = static_cast<int>(picture.size().y);
    std::vector<std::uint8_t> bytes(3 * picture.pixels().size());
    const std::uint64_t not_finite = encode_srgb(picture.pixels(), bytes);

    int length = 0;
    const std::unique_ptr<unsigned char, decltype(&std::free)> file(
        stb::stbi_write_png_to_mem(bytes.data(), 3 * width, width, height, 3, &length), &std::free);
    if (!file) throw std::bad_alloc();
    out.write(reinterpret_cast<const char*>(file.get()), length);
    return not_finite;
}

}  // namespace png

/// Returns the number of pixels that were not finite: NaN and -infinity are written as 0, +infinity as 255.
/// Throws std::runtime_error when it cannot write; see save.hpp for what then becomes of the file.
[[maybe_unused]] static std::uint64_t write_png(std::ostream& out, const image& picture) {
    return save(out, [&](std::ostream& to) { return png::encode(to, picture); });
}
[[maybe_unused]] static std::uint64_t write_png(const std::filesystem::path& path, const image& picture) {
    return save(path, [&](std::ostream& to) { return png::encode(to, picture); });
}

}  // namespace lantern
