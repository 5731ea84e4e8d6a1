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
#include <string>

namespace lantern {

namespace detail {

/// Column k is what bit k of the index contributes to a coordinate, mirrored: its lowest bit is worth one half.
using sobol_matrix = std::array<std::uint32_t, 32>;

/// A primitive polynomial over two elements (degree, inner coefficients) and initial numbers, as Sobol's construction
/// takes them: Bratley and Fox, "Algorithm 659" (1988).
struct sobol_seed {
    std::uint32_t degree, coefficients;
    std::array<std::uint32_t, 6> m;
};

[[nodiscard]] constexpr sobol_matrix make_sobol_matrix(const sobol_seed& seed) {
    const auto& [degree, coefficients, m] = seed;
    sobol_matrix v{};
    for (std::uint32_t k = 0; k < 32; ++k) {
        if (k < degree) {
            v[k] = m[k] << (31 - k);
            continue;
        }
        v[k] = v[k - degree] ^ (v[k - degree] >> degree);
        for (std::uint32_t j = 1; j < degree; ++j)
            if ((coefficients >> (degree - 1 - j)) & 1) v[k] ^= v[k - j];
    }
    for (std::uint32_t& column : v) column = radical_inverse<2>(column);
    return v;
}

/// The second dimension of Sobol's sequence. The first is the index itself, mirrored.
inline constexpr sobol_matrix sobol_second = make_sobol_matrix({1, 0, {1}});

/// How the index of a point is carried over to the index of its pair in slot 1, 2, …; slot 0 keeps it. These numbers are
/// our own. Of 30,872 candidates, one slot after the other, those were taken that leave the least dependence between
/// their dimensions and those of the slots before, at 4 to 4096 samples, and of these the one with the least error in
/// penumbras of three and four dimensions. The last two are only meant for packings of almost everything.
inline constexpr std::array<sobol_matrix, 9> sobol_slots{
    make_sobol_matrix({6, 25, {1, 1, 3, 11, 7, 25}}), make_sobol_matrix({6, 1, {1, 1, 5, 13, 13, 37}}),
    make_sobol_matrix({5, 11, {1, 1, 5, 3, 11}}),     make_sobol_matrix({5, 2, {1, 1, 7, 9, 29}}),
    make_sobol_matrix({6, 22, {1, 1, 5, 5, 29, 47}}), make_sobol_matrix({5, 14, {1, 3, 1, 11, 15}}),
    make_sobol_matrix({5, 13, {1, 1, 1, 5, 19}}),     make_sobol_matrix({5, 7, {1, 3, 7, 15, 7}}),
    make_sobol_matrix({5, 11, {1, 1, 1, 7, 29}}),
};

[[nodiscard]] constexpr std::uint32_t times(const sobol_matrix& matrix, std::uint32_t i) {
    std::uint32_t x = 0;
    for (const std::uint32_t* column = matrix.data(); i != 0; i >>= 1, ++column) x ^= (i & 1) ? *column : 0;
    return x;
}

/// Owen's nested uniform scramble (1995) of a mirrored number: each bit is flipped or not by a hash of the bits below it,
/// a coin for each node of a tree. Laine and Karras 2011 have the idea, Burley 2020 the use, Vegdahl 2021 these constants
/// (psychopath.io/post/2021_01_30_building_a_better_lk_hash). The coins are fair and any two are independent, which is all
/// that means and variances depend on; three and more are not.
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

/// Purposes that share one Sobol vector, and so are well spread *together* and not only each by itself. The first ones
/// named spread best. Naming only what a scene has gives it better slots, and changes its numbers; leaving an effect out
/// of the scene alone changes none. A purpose named twice is refused.
class packing {
public:
    static constexpr std::uint32_t absent = 255;

    constexpr packing(std::initializer_list<purpose> order) {
        slots_.fill(absent);
        std::uint8_t next = 0;
        for (const purpose p : order) {
            const auto i = static_cast<std::uint32_t>(p);
            if (i >= slots_.size()) refuse("packing: purpose", std::to_string(i), "one that lantern names");
            if (slots_[i] != absent) refuse("packing: purpose", std::to_string(i), "named once");
            slots_[i] = next++;
        }
    }

    /// The place of a purpose in the order, or `absent`.
    [[nodiscard]] constexpr std::uint32_t slot(purpose p) const {
        const auto i = static_cast<std::uint32_t>(p);
        return i < slots_.size() ? slots_[i] : absent;
    }

private:
    std::array<std::uint8_t, detail::sobol_slots.size() + 1> slots_{};
};

class sobol_source;

/// Owen-scrambled Sobol points (Owen 1995; Burley, "Practical hash-based Owen scrambling", JCGT 2020). The camera and
/// the first hit draw from one vector; later hits, and purposes that are not packed, from sets that are shuffled and
/// scrambled by a key of their own. Unbiased for any number of samples, but powers of two are far better than others.
///
/// In the vector every purpose has the *first two* dimensions of Sobol's sequence, the best pair that there is, at an index
/// carried over by a matrix of its own (Paulin et al., "Cascaded Sobol' sampling", 2021). Of Sobol's own later
/// dimensions, pairs are up to 16 times worse.
struct sobol {
    std::uint32_t samples = 16;
    packing packed{purpose::film, purpose::lens, purpose::time, purpose::light, purpose::gloss, purpose::scatter};
    std::uint64_t seed = 0;

    [[nodiscard]] std::uint32_t count() const { return checked_count("sobol", samples); }
    [[nodiscard]] sobol_source at(glm::uvec2 pixel, std::uint32_t i) const;
};

class sobol_source {
public:
    constexpr sobol_source(const packing& packed, std::uint64_t key, std::uint32_t index, std::uint32_t count)
        : packed_(packed), key_(key), index_(index), count_(count) {}

    [[nodiscard]] float draw1(purpose p, std::uint32_t which = 0) const {
        const std::uint64_t key = hash(key_, static_cast<std::uint32_t>(p), which, 1u);
        return coordinate(width(p) == 1 ? index(p, which, key) : shuffled(key), high(key));
    }

    [[nodiscard]] glm::vec2 draw2(purpose p, std::uint32_t which = 0) const {
        const std::uint64_t key = hash(key_, static_cast<std::uint32_t>(p), which, 2u), keys = mix_bits(key);
        const std::uint32_t i = width(p) == 2 ? index(p, which, key) : shuffled(key);
        return {coordinate(i, low(keys)), coordinate(detail::times(detail::sobol_second, i), high(keys))};
    }

    [[nodiscard]] sobol_source branch(std::uint32_t k) const { return {hash(key_, k), index_, count_}; }

private:
    constexpr sobol_source(std::uint64_t key, std::uint32_t index, std::uint32_t count)
        : packed_{}, key_(key), index_(index), count_(count) {}

    [[nodiscard]] static constexpr float coordinate(std::uint32_t mirrored, std::uint32_t key) {
        return to_unit(radical_inverse<2>(detail::mirrored_scramble(mirrored, key)));
    }
    [[nodiscard]] constexpr std::uint32_t index(purpose p, std::uint32_t which, std::uint64_t key) const {
        const std::uint32_t slot = which == 0 ? packed_.slot(p) : packing::absent;
        if (slot == packing::absent) return shuffled(key);
        return slot == 0 ? index_ : detail::times(detail::sobol_slots[slot - 1], index_);
    }
    /// Another order of the same points, so that sets which are not packed are paired at random.
    [[nodiscard]] constexpr std::uint32_t shuffled(std::uint64_t key) const {
        return permute(index_, count_, mix_bits(~key));
    }

    packing packed_;
    std::uint64_t key_;
    std::uint32_t index_;
    std::uint32_t count_;
};

inline sobol_source sobol::at(glm::uvec2 pixel, std::uint32_t i) const {
    const std::uint32_t n = count();
    return {packed, hash(seed, pixel.x, pixel.y, i / n), i % n, n};
}

}  // namespace lantern
