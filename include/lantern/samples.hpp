// SPDX-License-Identifier: MIT
#pragma once
// Points in the unit interval and the unit square, one set for each purpose: independent and stratified samplers.

#include <lantern/hash.hpp>
#include <lantern/validate.hpp>

#include <glm/vec2.hpp>

#include <cmath>
#include <concepts>
#include <cstdint>
#include <string>

namespace lantern {

/// What a number is for. Numbers are asked for by purpose, not by turn: a lens that is added moves no other number.
enum class purpose : std::uint32_t {
    film,          ///< where in the pixel; two numbers
    lens,          ///< where on the aperture; two
    time,          ///< when in the exposure; one
    light,         ///< where on a light; two, `which` is the light
    light_choice,  ///< which light; one
    gloss,         ///< where in the glossy square; two
    scatter,       ///< which direction a matt surface scatters to; two
    branch,        ///< which of several rays goes on: reflected or refracted; one
    roulette,      ///< whether a path goes on at all; one
    user,          ///< whatever a program wants besides, told apart by `which`
};

/// Numbers for one sample of one pixel, all in (0, 1). They are a pure function of seed, pixel, sample, path, purpose
/// and `which`: the same in whatever order they are drawn, however often. draw1 and draw2 of one purpose are unrelated.
/// `branch(k)` gives the source for the k-th ray that leaves this vertex.
template <class S>
concept sample_source = requires(const S& s, purpose p, std::uint32_t which) {
    { s.draw1(p) } -> std::same_as<float>;
    { s.draw1(p, which) } -> std::same_as<float>;
    { s.draw2(p) } -> std::same_as<glm::vec2>;
    { s.draw2(p, which) } -> std::same_as<glm::vec2>;
    { s.branch(which) } -> std::same_as<S>;
};

/// Hands out a source for each sample of each pixel. `count()` is the number of samples that a pixel takes, and what
/// their sum is to be divided by. It throws std::invalid_argument for a count that cannot be; so does `at`.
template <class T>
concept sampler = requires(const T& t, glm::uvec2 pixel, std::uint32_t i) {
    { t.count() } -> std::same_as<std::uint32_t>;
    { t.at(pixel, i) } -> sample_source;
};

/// A rule that places `count()` points: `place1` the i-th in the unit interval, `place2` the i-th in the unit square, as
/// fractions of 2^32. The key chooses one of many such sets. Each point by itself must be uniformly distributed over
/// the keys (then no subset of them is biased), and equal i under different keys must be unrelated.
template <class P>
concept pattern = requires(const P& p, std::uint32_t i, std::uint64_t key) {
    { p.count() } -> std::same_as<std::uint32_t>;
    { p.place1(i, key) } -> std::same_as<std::uint32_t>;
    { p.place2(i, key) } -> std::same_as<glm::uvec2>;
};

/// The sample_source of every pattern: a set of points for each purpose, chosen by a key of its own.
template <class Pattern>
class pattern_source {
public:
    constexpr pattern_source(const Pattern& p, std::uint64_t key, std::uint32_t index)
        : pattern_(p), key_(key), index_(index) {}

    [[nodiscard]] float draw1(purpose p, std::uint32_t which = 0) const {
        return to_unit(pattern_.place1(index_, hash(key_, static_cast<std::uint32_t>(p), which, 1u)));
    }
    [[nodiscard]] glm::vec2 draw2(purpose p, std::uint32_t which = 0) const {
        const glm::uvec2 point = pattern_.place2(index_, hash(key_, static_cast<std::uint32_t>(p), which, 2u));
        return {to_unit(point.x), to_unit(point.y)};
    }
    [[nodiscard]] pattern_source branch(std::uint32_t k) const { return {pattern_, hash(key_, k), index_}; }

private:
    Pattern pattern_;
    std::uint64_t key_;  // of seed, pixel and path
    std::uint32_t index_;
};

/// The source of sample i of a pixel. After count() samples a new set begins, which has nothing to do with the first.
template <class Pattern>
[[nodiscard]] pattern_source<Pattern> source_of(const Pattern& p, glm::uvec2 pixel, std::uint32_t i) {
    const std::uint32_t count = p.count();
    return {p, hash(p.seed, pixel.x, pixel.y, i / count), i % count};
}

/// (cell + jitter / 2^32) / cells as a fraction of 2^32: a point of one of several equal cells. cell < cells.
[[nodiscard]] constexpr std::uint32_t within_cell(std::uint32_t cell, std::uint32_t jitter, std::uint32_t cells) {
    return static_cast<std::uint32_t>(((std::uint64_t{cell} << 32) | jitter) / cells);
}

/// `samples` as it stands, unless it is zero.
[[nodiscard]] inline std::uint32_t checked_count(const char* what, std::uint32_t samples) {
    if (samples == 0) refuse(std::string(what) + ": samples", "0", "at least 1");
    return samples;
}

/// side², unless it is zero or more than 32 bits hold.
[[nodiscard]] inline std::uint32_t checked_square(const char* what, std::uint32_t side) {
    if (side == 0 || side > 65535) refuse(std::string(what) + ": side", std::to_string(side), "1 to 65535");
    return side * side;
}

/// The side of a square number; a grid of any other number of cells, cut short, would leave a part of the square
/// without samples, which biases the picture. It is therefore refused.
[[nodiscard]] inline std::uint32_t checked_side(const char* what, std::uint32_t samples) {
    const auto side = static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(samples))));
    if (side == 0 || side > 65535 || side * side != samples)
        refuse(std::string(what) + ": samples", std::to_string(samples),
               "a square number such as " + std::to_string(std::uint64_t{side} * side));
    return side;
}

/// Every number independent of every other. Error falls as 1/√N, whatever is sampled.
struct independent {
    std::uint32_t samples = 16;
    std::uint64_t seed = 0;

    [[nodiscard]] std::uint32_t count() const { return checked_count("independent", samples); }
    [[nodiscard]] auto at(glm::uvec2 pixel, std::uint32_t i) const { return source_of(*this, pixel, i); }

    [[nodiscard]] static std::uint32_t place1(std::uint32_t i, std::uint64_t key) { return low(hash(key, i)); }
    [[nodiscard]] static glm::uvec2 place2(std::uint32_t i, std::uint64_t key) {
        const std::uint64_t h = hash(key, i);
        return {low(h), high(h)};
    }
};

/// N-rooks, or Latin hypercube (Shirley 1991): one sample in each of N columns and in each of N rows, as rooks that do
/// not threaten each other. Any N. Good for what depends on x alone or y alone; along a diagonal hardly better than chance.
struct n_rooks {
    std::uint32_t samples = 16;
    std::uint64_t seed = 0;

    [[nodiscard]] std::uint32_t count() const { return checked_count("n_rooks", samples); }
    [[nodiscard]] auto at(glm::uvec2 pixel, std::uint32_t i) const { return source_of(*this, pixel, i); }

    [[nodiscard]] std::uint32_t place1(std::uint32_t i, std::uint64_t key) const {
        return within_cell(permute(i, samples, hash(key, 1u)), low(hash(key, 0u, i)), samples);
    }
    [[nodiscard]] glm::uvec2 place2(std::uint32_t i, std::uint64_t key) const {
        const std::uint64_t jitter = hash(key, 0u, i);
        return {within_cell(permute(i, samples, hash(key, 1u)), low(jitter), samples),
                within_cell(permute(i, samples, hash(key, 2u)), high(jitter), samples)};
    }
};

/// Jittered (Cook, Porter and Carpenter 1984): side × side cells, a sample somewhere in each.
struct jittered {
    std::uint32_t side = 4;
    std::uint64_t seed = 0;

    /// From a number of samples, which must be a square: others are refused.
    [[nodiscard]] static jittered of(std::uint32_t samples, std::uint64_t seed = 0) {
        return {checked_side("jittered", samples), seed};
    }
    [[nodiscard]] std::uint32_t count() const { return checked_square("jittered", side); }
    [[nodiscard]] auto at(glm::uvec2 pixel, std::uint32_t i) const { return source_of(*this, pixel, i); }

    [[nodiscard]] std::uint32_t place1(std::uint32_t i, std::uint64_t key) const {
        return within_cell(permute(i, side * side, hash(key, 1u)), low(hash(key, 0u, i)), side * side);
    }
    [[nodiscard]] glm::uvec2 place2(std::uint32_t i, std::uint64_t key) const {
        const std::uint64_t jitter = hash(key, 0u, i);
        const std::uint32_t cell = permute(i, side * side, hash(key, 1u));
        return {within_cell(cell % side, low(jitter), side), within_cell(cell / side, high(jitter), side)};
    }
};

/// Multi-jittered (Chiu, Shirley and Wang 1994): a sample in each of side × side cells, and one in each of side² columns
/// and of side² rows: jittered and N-rooks at once.
struct multi_jittered {
    std::uint32_t side = 4;
    std::uint64_t seed = 0;

    /// From a number of samples, which must be a square: others are refused.
    [[nodiscard]] static multi_jittered of(std::uint32_t samples, std::uint64_t seed = 0) {
        return {checked_side("multi_jittered", samples), seed};
    }
    [[nodiscard]] std::uint32_t count() const { return checked_square("multi_jittered", side); }
    [[nodiscard]] auto at(glm::uvec2 pixel, std::uint32_t i) const { return source_of(*this, pixel, i); }

    [[nodiscard]] std::uint32_t place1(std::uint32_t i, std::uint64_t key) const {
        return within_cell(permute(i, side * side, hash(key, 1u)), low(hash(key, 0u, i)), side * side);
    }
    /// Within its column of cells a sample gets one of `side` fine columns, by a permutation that each column of cells
    /// has of its own; and the same for rows.
    [[nodiscard]] glm::uvec2 place2(std::uint32_t i, std::uint64_t key) const {
        const std::uint64_t jitter = hash(key, 0u, i);
        const std::uint32_t cell = permute(i, side * side, hash(key, 1u));
        const std::uint32_t column = cell % side, row = cell / side;
        const std::uint32_t x = column * side + permute(row, side, hash(key, 2u, column));
        const std::uint32_t y = row * side + permute(column, side, hash(key, 3u, row));
        return {within_cell(x, low(jitter), side * side), within_cell(y, high(jitter), side * side)};
    }
};

/// Correlated multi-jittered (Kensler 2013): all columns of cells share one permutation, and so do all rows, which spaces
/// the samples more evenly. Any number of samples: where it is no product of columns and rows, the cells that stay
/// empty are in columns and fine columns chosen at random, so that nothing is biased.
struct correlated_multi_jittered {
    std::uint32_t samples = 16;
    std::uint64_t seed = 0;

    [[nodiscard]] std::uint32_t count() const { return checked_count("correlated_multi_jittered", samples); }
    [[nodiscard]] auto at(glm::uvec2 pixel, std::uint32_t i) const { return source_of(*this, pixel, i); }

    [[nodiscard]] std::uint32_t place1(std::uint32_t i, std::uint64_t key) const {
        return within_cell(permute(i, samples, hash(key, 1u)), low(hash(key, 0u, i)), samples);
    }
    [[nodiscard]] glm::uvec2 place2(std::uint32_t i, std::uint64_t key) const {
        const auto columns = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(samples)));  // correctly rounded
        const std::uint32_t rows = (samples + columns - 1) / columns;
        const std::uint64_t jitter = hash(key, 0u, i);
        const std::uint32_t y = permute(i, samples, hash(key, 1u));
        const std::uint32_t column = permute(y % columns, columns, hash(key, 2u));
        const std::uint32_t fine = permute(y / columns, rows, hash(key, 3u));
        const std::uint32_t x = within_cell(column, within_cell(fine, low(jitter), rows), columns);
        return {x, within_cell(y, high(jitter), samples)};
    }
};

}  // namespace lantern
