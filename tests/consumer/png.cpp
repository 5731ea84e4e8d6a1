// SPDX-License-Identifier: MIT
// The same for lantern::png: the header is found, and stb with it.

#include <lantern/image.hpp>
#include <lantern/png.hpp>

#include <cstdlib>
#include <sstream>

int main() {
    std::ostringstream out;
    lantern::write_png(out, lantern::image({2, 2}));
    return out.str().starts_with("\x89PNG") ? EXIT_SUCCESS : EXIT_FAILURE;
}
