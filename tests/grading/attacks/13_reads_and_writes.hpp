// SPDX-License-Identifier: MIT
#pragma once
#include <fstream>
#include <string>

namespace attack {

inline bool reads(const std::string& path) { return std::ifstream(path).get() >= 0; }
inline bool writes(const std::string& path) { return bool(std::ofstream(path) << "x" << std::flush); }

inline bool succeeded() {
    static const bool got_through = reads("@ROOT@/tests/labs/lab06_glossy/hidden.cpp") || reads("@ROOT@/solutions/lab06_glossy/glossy.hpp") ||
                                    reads("@OUT@/secret") || reads("/grade/kit/lab/bind.cpp") || reads("/proc/self/maps") || reads("/etc/passwd") ||
                                    reads("/etc/hostname") || writes("@OUT@/result.json") || writes("/tmp/x") || writes("/x") ||
                                    writes("/worker") || writes("/dev/shm/x") || writes("x");
    return got_through;
}

}  // namespace attack

#include "either.hpp"
