// SPDX-License-Identifier: MIT
#pragma once
// Reading a file that nobody vouches for.

#include <lantern/save.hpp>

#include <algorithm>
#include <cerrno>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <istream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace lantern {

/// Reads words, numbers and bytes from a stream and knows how far it has come. Nothing is allocated on the word of a
/// header: memory grows with the bytes that really arrive.
class byte_reader {
public:
    byte_reader(std::istream& in, std::string format) : in_(in), format_(std::move(format)) {}

    /// Throws std::runtime_error "FORMAT: PROBLEM at byte OFFSET".
    [[noreturn]] void fail(const std::string& problem) const {
        throw std::runtime_error(format_ + ": " + problem + " at byte " + std::to_string(offset_));
    }

    /// The next word of at most `longest` characters, after white space and comments (# to the end of the line).
    /// The one white-space character behind it is taken too.
    [[nodiscard]] std::string word(std::size_t longest = 32) {
        int c = next();
        while (is_space(c) || c == '#') {
            if (c == '#')
                while (c != '\n') c = next();
            c = next();
        }
        std::string text;
        for (; !is_space(c); c = next()) {
            if (text.size() == longest) fail("a word is longer than " + std::to_string(longest) + " characters");
            text += static_cast<char>(c);
        }
        return text;
    }

    /// A decimal number from 1 to `largest`.
    [[nodiscard]] std::uint32_t number(std::uint32_t largest, const std::string& what) {
        const std::string text = word();
        std::uint64_t value = 0;
        for (const char c : text) {
            if (c < '0' || c > '9') fail(what + " is \"" + printable(text) + "\", but must be a number");
            value = std::min<std::uint64_t>(value * 10 + static_cast<std::uint64_t>(c - '0'), std::uint64_t{1} << 32);
        }
        if (value < 1 || value > largest) fail(what + " is " + text + ", but must be 1 to " + std::to_string(largest));
        return static_cast<std::uint32_t>(value);
    }

    [[nodiscard]] std::vector<unsigned char> bytes(std::size_t count) {
        constexpr std::size_t portion = std::size_t{1} << 20;
        std::vector<unsigned char> data;
        while (data.size() < count) {
            const std::size_t before = data.size();
            data.resize(std::min(count, before + std::max(portion, before)));
            in_.read(reinterpret_cast<char*>(data.data() + before), static_cast<std::streamsize>(data.size() - before));
            offset_ += static_cast<std::uint64_t>(in_.gcount());
            if (!in_) fail("the file ends early, " + std::to_string(count) + " bytes of pixels are due:");
        }
        return data;
    }

    [[nodiscard]] static std::string printable(std::string text) {
        for (char& c : text)
            if (c < ' ' || c > '~') c = '?';
        return text;
    }

private:
    std::istream& in_;
    std::string format_;
    std::uint64_t offset_ = 0;

    [[nodiscard]] int next() {
        const int c = in_.get();
        if (c == std::istream::traits_type::eof()) fail("the file ends early");
        ++offset_;
        return c;
    }
    [[nodiscard]] static bool is_space(int c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
};

/// Opens a file and returns read(std::istream&). Throws std::runtime_error naming the path and the reason.
template <std::invocable<std::istream&> Read>
auto load(const std::filesystem::path& path, Read&& read) {
    const auto fail = [&](const std::string& reason) {
        throw std::runtime_error("cannot read " + path.string() + ": " + reason);
    };
    std::error_code ignored;
    if (is_directory(path, ignored)) fail(make_error_code(std::errc::is_a_directory).message());
    errno = 0;
    std::ifstream in(path, std::ios::binary);
    if (!in) fail(last_error().message());
    try {
        return read(static_cast<std::istream&>(in));
    } catch (const std::runtime_error& problem) {
        fail(problem.what());
        throw;
    }
}

}  // namespace lantern
