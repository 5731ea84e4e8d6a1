// SPDX-License-Identifier: MIT
#pragma once
#include <cstring>
#include <memory>
#include <new>

namespace attack {

inline bool succeeded() {
    static const bool got_through = [] {
        for (int i = 0; i < 48; ++i) {  // 3 GiB
            char* piece = new (std::nothrow) char[64 << 20];
            if (!piece) return false;
            std::memset(piece, i + 1, 64 << 20);
        }
        return true;
    }();
    return got_through;
}

}  // namespace attack

#include "either.hpp"
