// SPDX-License-Identifier: MIT
#pragma once
// Owen-scrambled Sobol points: the camera and the first hit share one low-discrepancy vector, all else draws pairs.

#include <lantern/halton.hpp>
#include <lantern/hash.hpp>
#include <lantern/samples.hpp>

#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <initializer_list>

namespace lantern {

inline constexpr std::uint32_t sobol_dimensions = 16;

namespace detail {

/// Column k of a dimension is what bit k of the index contributes, mirrored: its lowest bit is worth one half.
using sobol_matrix = std::array<std::uint32_t, 32>;

/// The primitive polynomial (degree, inner coefficients) and the initial numbers of one dimension.
struct sobol_seed {
    std::uint32_t degree, coefficients;
    std::array<std::uint32_t, 6> m;
};

/// Joe and Kuo, "Constructing Sobol sequences with better two-dimensional projections" (2008), new-joe-kuo-6.21201.
inline constexpr std::array<sobol_seed, sobol_dimensions - 1> sobol_seeds{{
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
    {5, 4, {1, 1, 5, 5, 5}},
    {5, 7, {1, 1, 7, 11, 19}},
    {5, 11, {1, 1, 5, 1, 1}},
    {5, 13, {1, 1, 1, 3, 11}},
    {5, 14, {1, 3, 5, 5, 31}},
    {6, 1, {1, 3, 3, 9, 7, 49}},
    {6, 13, {1, 1, 1, 15, 21, 21}},
    {6, 16, {1, 3, 1, 13, 27, 49}},
}};

[[nodiscard]] constexpr std::array<sobol_matrix, sobol_dimensions> make_sobol_matrices() {
    std::array<sobol_matrix, sobol_dimensions> result{};
    for (std::uint32_t k = 0; k < 32; ++k) result[0][k] = std::uint32_t{1} << k;  // the van der Corput sequence
    for (std::uint32_t d = 1; d < sobol_dimensions; ++d) {
        const auto& [degree, coefficients, m] = sobol_seeds[d - 1];
        sobol_matrix v{};  // Bratley and Fox 1988, equation 2
        for (std::uint32_t k = 0; k < 32; ++k) {
            if (k < degree) {
                v[k] = m[k] << (31 - k);
                continue;
            }
            v[k] = v[k - degree] ^ (v[k - degree] >> degree);
            for (std::uint32_t j = 1; j < degree; ++j)
                if ((coefficients >> (degree - 1 - j)) & 1) v[k] ^= v[k - j];
        }
        for (std::uint32_t k = 0; k < 32; ++k) result[d][k] = radical_inverse<2>(v[k]);
    }
    return result;
}

inline constexpr auto sobol_matrices = make_sobol_matrices();

/// Coordinate `dimension` of Sobol point i, mirrored.
[[nodiscard]] constexpr std::uint32_t mirrored_sobol(std::uint32_t i, std::uint32_t dimension) {
    if (dimension == 0) return i;
    std::uint32_t x = 0;
    for (const std::uint32_t* column = sobol_matrices[dimension].data(); i != 0; i >>= 1, ++column)
        x ^= (i & 1) ? *column : 0;
    return x;
}

/// Owen's nested uniform scramble (1995) of a mirrored number: each bit is flipped or not by a hash of the bits below
/// it, which makes it a random walk down a tree of coins. Laine and Karras 2011 have the idea, Burley 2020 the proof of
/// use, Vegdahl 2021 these constants (psychopath.io/post/2021_01_30_building_a_better_lk_hash).
[[nodiscard]] constexpr std::uint32_t mirrored_scramble(std::uint32_t x, std::uint32_t key) {
    x ^= x * 0x3d20adeau;
    x += key;
    x *= (key >> 16) | 1;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

}  // namespace detail

/// How many numbers a purpose takes as a rule: the dimensions that it gets in a packed vector.
[[nodiscard]] constexpr std::uint32_t width(purpose p) {
    return p == purpose::time || p == purpose::light_choice || p == purpose::branch || p == purpose::roulette ? 1 : 2;
}

/// Purposes that share one Sobol vector, and so stay well spread *together*; the first ones named get the best
/// dimensions. Leaving out what a scene does not have gives the rest better ones, and changes their numbers; leaving
/// an effect out of the scene alone changes none. Refused: a purpose named twice, more than 16 dimensions.
class packing {
public:
    constexpr packing(std::initializer_list<purpose> order) {
        first_.fill(absent);
        std::uint32_t next = 0;
        for (const purpose p : order) {
            const auto i = static_cast<std::uint32_t>(p);
            if (i >= first_.size()) refuse("packing: purpose", std::to_string(i), "one of those that lantern names");
            if (first_[i] != absent) refuse("packing: purpose", std::to_string(i), "named once");
            if (next + width(p) > sobol_dimensions)
                refuse("packing: number of dimensions", std::to_string(next + width(p)), "at most 16");
            first_[i] = static_cast<std::uint8_t>(next);
            next += width(p);
        }
    }

    static constexpr std::uint8_t absent = 255;

    /// The first dimension of a purpose, or `absent`.
    [[nodiscard]] constexpr std::uint32_t first(purpose p) const {
        const auto i = static_cast<std::uint32_t>(p);
        return i < first_.size() ? first_[i] : absent;
    }

private:
    std::array<std::uint8_t, 10> first_{};
};

class sobol_source;

/// Owen-scrambled Sobol points (Owen 1995; Burley, "Practical hash-based Owen scrambling", JCGT 2020). The camera and
/// the first hit draw from one vector; later hits, and purposes that are not packed, from pairs that are shuffled and
/// scrambled by a key of their own. Unbiased for any number of samples, but powers of two are far better than others.
struct sobol {
    std::uint32_t samples = 16;
    packing packed{purpose::film,  purpose::lens,         purpose::time,   purpose::light,
                   purpose::gloss, purpose::light_choice, purpose::branch, purpose::scatter};
    std::uint64_t seed = 0;

    [[nodiscard]] std::uint32_t count() const { return checked_count("sobol", samples); }
    [[nodiscard]] sobol_source at(glm::uvec2 pixel, std::uint32_t i) const;
};

class sobol_source {
public:
    constexpr sobol_source(const packing& packed, std::uint64_t key, std::uint32_t index, std::uint32_t count)
        : packed_(packed), key_(key), index_(index), used_(count < 2 ? 0 : ~0u >> std::countl_zero(count - 1)) {}

    [[nodiscard]] float draw1(purpose p, std::uint32_t which = 0) const {
        const std::uint64_t key = hash(key_, low(std::uint64_t(p)), which, 1u);
        const std::uint32_t d = which == 0 && width(p) == 1 ? packed_.first(p) : packing::absent;
        return d == packing::absent ? point(shuffled(key), 0, high(key)) : point(index_, d, high(key));
    }

    [[nodiscard]] glm::vec2 draw2(purpose p, std::uint32_t which = 0) const {
        const std::uint64_t key = hash(key_, low(std::uint64_t(p)), which, 2u);
        const std::uint64_t keys = mix_bits(key);
        const std::uint32_t d = which == 0 && width(p) == 2 ? packed_.first(p) : packing::absent;
        if (d != packing::absent) return {point(index_, d, low(keys)), point(index_, d + 1, high(keys))};
        const std::uint32_t i = shuffled(key);
        return {point(i, 0, low(keys)), point(i, 1, high(keys))};
    }

    [[nodiscard]] sobol_source branch(std::uint32_t k) const { return {hash(key_, k), index_, used_}; }

private:
    constexpr sobol_source(std::uint64_t key, std::uint32_t index, std::uint32_t used)
        : packed_{}, key_(key), index_(index), used_(used) {}

    [[nodiscard]] static constexpr float point(std::uint32_t i, std::uint32_t dimension, std::uint32_t key) {
        return to_unit(radical_inverse<2>(detail::mirrored_scramble(detail::mirrored_sobol(i, dimension), key)));
    }
    /// The order of the points, scrambled as if it were one of their coordinates: aligned blocks stay together.
    [[nodiscard]] constexpr std::uint32_t shuffled(std::uint64_t key) const {
        return radical_inverse<2>(detail::mirrored_scramble(radical_inverse<2>(index_), low(key))) & used_;
    }

    packing packed_;
    std::uint64_t key_;
    std::uint32_t index_;
    std::uint32_t used_;  // the bits of an index that can be set
};

inline sobol_source sobol::at(glm::uvec2 pixel, std::uint32_t i) const {
    const std::uint32_t n = count();
    return {packed, hash(seed, pixel.x, pixel.y, i / n), i % n, n};
}

}  // namespace lantern
