// SPDX-License-Identifier: MIT
// Any bytes are a picture or a std::runtime_error; a picture that was read is read again from what is written of it.

#include <lantern/image.hpp>
#include <lantern/pfm.hpp>

#include "demand.hpp"

#include <cstddef>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::istringstream in(std::string(data, data + size));
    try {
        const lantern::image picture = lantern::read_pfm(in);
        std::ostringstream first, second;
        (void)write_pfm(first, picture);
        std::istringstream again(first.str());
        (void)write_pfm(second, lantern::read_pfm(again));
        demand(first.str() == second.str(), "what was written and read is written alike");
    } catch (const std::runtime_error&) {
    }
    return 0;
}
