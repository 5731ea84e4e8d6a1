// SPDX-License-Identifier: MIT
#pragma once
// The Halton sequence, rotated: low-discrepancy points for any number of samples.

#include <lantern/hash.hpp>
#include <lantern/samples.hpp>

#include <glm/vec2.hpp>

#include <cstdint>

namespace lantern {

/// The digits of i in a prime base, mirrored at the point, as a fraction of 2^32 rounded down (van der Corput 1935).
/// Exact for i below the largest power of the base that 32 bits hold, which is at least 2^31 for bases 2 and 3.
template <std::uint32_t Base>
[[nodiscard]] constexpr std::uint32_t radical_inverse(std::uint32_t i) {
    std::uint64_t mirrored = 0, power = 1;
    while (power * Base <= (std::uint64_t{1} << 32)) {
        mirrored = mirrored * Base + i % Base;
        i /= Base;
        power *= Base;
    }
    return static_cast<std::uint32_t>((mirrored << 32) / power);
}

template <>
[[nodiscard]] constexpr std::uint32_t radical_inverse<2>(std::uint32_t i) {
    i = (i << 16) | (i >> 16);
    i = ((i & 0x00ff00ffu) << 8) | ((i & 0xff00ff00u) >> 8);
    i = ((i & 0x0f0f0f0fu) << 4) | ((i & 0xf0f0f0f0u) >> 4);
    i = ((i & 0x33333333u) << 2) | ((i & 0xccccccccu) >> 2);
    return ((i & 0x55555555u) << 1) | ((i & 0xaaaaaaaau) >> 1);
}

/// The first points of the Halton sequence in bases 2 and 3 (Halton 1960), rotated as a whole on the torus by a random
/// vector for each purpose (Cranley and Patterson 1976), which makes every point uniform; their order is shuffled for
/// each purpose, so that two purposes are unrelated. Any number of samples, none better than another.
struct halton {
    std::uint32_t samples = 16;
    std::uint64_t seed = 0;

    [[nodiscard]] std::uint32_t count() const {
        if (samples > (1u << 31)) refuse("halton: samples", std::to_string(samples), "at most 2147483648");
        return checked_count("halton", samples);
    }
    [[nodiscard]] auto at(glm::uvec2 pixel, std::uint32_t i) const { return source_of(*this, pixel, i); }

    [[nodiscard]] std::uint32_t place1(std::uint32_t i, std::uint64_t key) const {
        return radical_inverse<2>(permute(i, samples, hash(key, 1u))) + low(key);
    }
    [[nodiscard]] glm::uvec2 place2(std::uint32_t i, std::uint64_t key) const {
        const std::uint32_t j = permute(i, samples, hash(key, 1u));
        return {radical_inverse<2>(j) + low(key), radical_inverse<3>(j) + high(key)};
    }
};

}  // namespace lantern
