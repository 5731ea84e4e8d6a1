// SPDX-License-Identifier: MIT
#pragma once
// The other way to know a number: count, average, sample. Slow, simple, and independent of the closed forms it checks.

#include <glm/vec3.hpp>

#include <cstdint>
#include <random>

namespace brute_force {

/// Uniform numbers that are the same with every standard library.
struct numbers {
    std::mt19937_64 bits;
    explicit numbers(std::uint64_t seed) : bits(seed) {}
    double operator()(double low = 0, double high = 1) {
        return low + static_cast<double>(bits() >> 11) * 0x1p-53 * (high - low);
    }
    glm::dvec3 vector(double low = -1, double high = 1) {
        const double x = (*this)(low, high), y = (*this)(low, high), z = (*this)(low, high);
        return {x, y, z};
    }
};

/// The mean over the midpoints of count × count cells of the unit square. An edge through them is found within 1 /
/// count.
template <class Function>
[[nodiscard]] double over_square(int count, Function f) {
    double sum = 0;
    for (int j = 0; j < count; ++j)
        for (int i = 0; i < count; ++i) sum += f((i + 0.5) / count, (j + 0.5) / count);
    return sum / (double(count) * count);
}

}  // namespace brute_force
