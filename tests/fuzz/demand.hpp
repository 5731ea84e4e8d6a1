// SPDX-License-Identifier: MIT
#pragma once
// For fuzz targets: what must hold, or the run ends here and the input is kept.

#include <cstdio>
#include <cstdlib>

inline void demand(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "broken: %s\n", what);
    std::abort();
}
