// SPDX-License-Identifier: MIT
// Any bytes are a mesh or a std::runtime_error; of a mesh every triangle can be looked at and traced.

#include <lantern/closest.hpp>
#include <lantern/mesh.hpp>
#include <lantern/obj.hpp>

#include "demand.hpp"

#include <cstddef>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::istringstream in(std::string(data, data + size));
    try {
        const lantern::mesh m = lantern::read_obj(in);
        demand(m.size() > 0, "a file without faces is refused");
        const auto all = bounds(m);
        demand(!empty(all), "the bounds of a mesh with faces hold something");
        (void)closest(lantern::every{static_cast<std::uint32_t>(m.size())}, m,
                      lantern::ray{{0.5f, 0.25f, 3}, {0.01f, 0.02f, -1}});
    } catch (const std::runtime_error&) {
    }
    return 0;
}
