// SPDX-License-Identifier: MIT
#pragma once
// Broken files for readers: every way to cut one short, and a thousand ways to get bytes wrong.

#include <lantern/hash.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

/// Calls read(text) with each beginning of a good file that is shorter than the file; all must throw
/// std::runtime_error. Returns how many did not.
template <class Read>
int accepted_when_cut(const std::string& good, const Read& read) {
    int accepted = 0;
    for (std::size_t length = 0; length < good.size(); ++length) {
        try {
            read(good.substr(0, length));
            ++accepted;
        } catch (const std::runtime_error&) {}
    }
    return accepted;
}

/// Calls read(text) with copies of a good file in which up to four bytes are changed, inserted or removed. They may
/// read or throw std::runtime_error; anything else is for the test, or a sanitizer, to notice. Returns how many could be
/// read.
template <class Read>
int read_when_mutated(const std::string& good, int copies, const Read& read) {
    int accepted = 0;
    for (int copy = 0; copy < copies; ++copy) {
        std::string bad = good;
        const auto key = static_cast<std::uint64_t>(copy);
        for (std::uint64_t change = 0; change <= lantern::hash(key) % 4; ++change) {
            const std::uint64_t h = lantern::hash(key, change);
            const std::size_t at =
                (h >> 16) % (h % 2 ? bad.size() : std::min<std::size_t>(bad.size(), 24));  // headers too
            const auto byte = static_cast<char>(h >> 8);
            if (h % 7 == 0)
                bad.insert(at, 1, byte);
            else if (h % 7 == 1 && bad.size() > 1)
                bad.erase(at, 1);
            else
                bad[at] = byte;
        }
        try {
            read(bad);
            ++accepted;
        } catch (const std::runtime_error&) {}
    }
    return accepted;
}
