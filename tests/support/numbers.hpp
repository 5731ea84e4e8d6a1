// SPDX-License-Identifier: MIT
#pragma once
// Numbers for the labs' tests: the same ones each time, on every machine.

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cstdint>

/// SplitMix64 (Steele, Lea and Flood 2014), seeded by the test.
class numbers {
public:
    explicit numbers(std::uint64_t seed) : state_(seed) {}

    /// In [0, 1).
    float unit() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
        z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
        z = (z ^ z >> 27) * 0x94d049bb133111eb;
        return float((z ^ z >> 31) >> 40) * 0x1p-24f;
    }

    float between(float low, float high) { return low + (high - low) * unit(); }

    /// In the cube from -1 to 1.
    glm::vec3 vector() {
        const float x = between(-1, 1), y = between(-1, 1), z = between(-1, 1);
        return {x, y, z};
    }

    /// Of length 1, all directions alike.
    glm::vec3 direction() {
        for (;;) {
            const glm::vec3 v = vector();
            const float length = glm::length(v);
            if (length > 0.1f && length <= 1) return v / length;
        }
    }

private:
    std::uint64_t state_;
};
