// SPDX-License-Identifier: MIT
#pragma once
// A picture in linear light, and the sum that becomes one of its pixels.

#include <lantern/validate.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace lantern {

/// Linear-light pixels (red, green, blue; not encoded, not clamped), row after row, the top row first.
class image {
public:
    static constexpr std::uint32_t longest_side = 65'536;
    static constexpr std::uint64_t most_pixels = std::uint64_t{1} << 28;  // 3.2 GB

    /// Refuses a side of 0 or beyond `longest_side`, and more than `most_pixels`: std::invalid_argument.
    explicit image(glm::uvec2 size, glm::vec3 color = glm::vec3{0})
        : size_(checked(size)), pixels_(area(size), color) {}

    [[nodiscard]] glm::uvec2 size() const { return size_; }
    [[nodiscard]] std::span<glm::vec3> pixels() { return pixels_; }
    [[nodiscard]] std::span<const glm::vec3> pixels() const { return pixels_; }

    /// x from the left, y from the top; within the size.
    [[nodiscard]] glm::vec3& operator()(std::uint32_t x, std::uint32_t y) { return pixels_[index(x, y)]; }
    [[nodiscard]] const glm::vec3& operator()(std::uint32_t x, std::uint32_t y) const { return pixels_[index(x, y)]; }

    /// Row y from the top.
    [[nodiscard]] std::span<glm::vec3> row(std::uint32_t y) { return pixels().subspan(index(0, y), size_.x); }
    [[nodiscard]] std::span<const glm::vec3> row(std::uint32_t y) const {
        return pixels().subspan(index(0, y), size_.x);
    }

    /// How many samples were left out while rendering because they were not finite. Not 0: something is wrong upstream.
    [[nodiscard]] std::uint64_t rejected() const { return rejected_; }
    void add_rejected(std::uint64_t samples) { rejected_ += samples; }

    [[nodiscard]] bool operator==(const image&) const = default;

    /// The size itself, unless it is refused: as the constructor does, but nothing is allocated.
    [[nodiscard]] static glm::uvec2 checked(glm::uvec2 size) {
        // Texts are appended: of "text" + std::string GCC 12 warns without reason (its bug 105329).
        const auto shown = [=] { return std::to_string(size.x) + " x " + std::to_string(size.y); };
        if (size.x == 0 || size.y == 0 || size.x > longest_side || size.y > longest_side)
            refuse("image: size", shown(), std::string("1 to ").append(std::to_string(longest_side)).append(" on each side"));
        if (area(size) > most_pixels)
            refuse("image: size", shown(), std::string("at most ").append(std::to_string(most_pixels)).append(" pixels"));
        return size;
    }

private:
    glm::uvec2 size_;
    std::vector<glm::vec3> pixels_;
    std::uint64_t rejected_ = 0;

    [[nodiscard]] static std::size_t area(glm::uvec2 size) { return std::size_t{size.x} * size.y; }

    [[nodiscard]] std::size_t index(std::uint32_t x, std::uint32_t y) const {
        assert(x < size_.x && y < size_.y);
        return std::size_t{y} * size_.x + x;
    }
};

/// The weighted mean of samples. A sample that is not finite is left out and counted: one NaN must not cost a pixel.
/// The sums are in double: after n samples of one sign the relative error is below n * 2^-53, hence 1e8 samples still
/// give the nearest float or its neighbour, and equal samples give back exactly their value. (A sum in float stops
/// growing after 2^24 equal samples.)
class accumulator {
public:
    void add(glm::vec3 sample, float weight = 1) {
        if (!(is_finite(sample) && is_finite(weight))) {
            ++rejected_;
            return;
        }
        weighted_ += double{weight} * glm::dvec3(sample);
        weight_ += weight;
        plain_ += glm::dvec3(sample);
        ++count_;
    }

    [[nodiscard]] std::uint64_t count() const { return count_; }        ///< samples added, without the rejected ones
    [[nodiscard]] std::uint64_t rejected() const { return rejected_; }  ///< samples left out

    /// Black when there are no samples. A few samples of a filter with negative lobes can have weights that sum to
    /// nothing or less: then the mean without weights, which at least lies between the samples.
    [[nodiscard]] glm::vec3 mean() const {
        if (weight_ > 0) return glm::vec3(weighted_ / weight_);
        return count_ > 0 ? glm::vec3(plain_ / static_cast<double>(count_)) : glm::vec3{0};
    }

private:
    glm::dvec3 weighted_{0};
    double weight_ = 0;
    glm::dvec3 plain_{0};
    std::uint64_t count_ = 0;
    std::uint64_t rejected_ = 0;
};

}  // namespace lantern
