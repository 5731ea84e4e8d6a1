// SPDX-License-Identifier: MIT
#pragma once
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>

extern char** environ;

namespace attack {

inline bool holds_secret(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {}).find("@SECRET@") != std::string::npos;
}

inline bool succeeded() {
    static const bool got_through = [] {
        for (char** each = environ; each && *each; ++each)
            if (std::strstr(*each, "@SECRET@") || std::strncmp(*each, "LANTERN", 7) == 0 || std::strncmp(*each, "LD_", 3) == 0) return true;
        for (int i = 1; i < 64; ++i)
            if (holds_secret("/proc/" + std::to_string(i) + "/environ")) return true;
        return holds_secret("/proc/self/environ");
    }();
    return got_through;
}

}  // namespace attack

#include "either.hpp"
