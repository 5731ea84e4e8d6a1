// SPDX-License-Identifier: MIT
#pragma once
// Bytes as the coordinates of wild scenes.

#include <glm/vec3.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

/// Most bytes are a coordinate of a coarse lattice, on which things coincide; the others announce two bytes more, the upper half
/// of a float: every size, both zeros, infinity, NaN. After the end there are zeros.
class scene_bytes {
public:
    scene_bytes(const std::uint8_t* data, std::size_t size) : rest_(data, size) {}

    [[nodiscard]] bool empty() const { return rest_.empty(); }

    std::uint8_t byte() {
        if (rest_.empty()) return 0;
        const std::uint8_t b = rest_.front();
        rest_ = rest_.subspan(1);
        return b;
    }
    float number() {
        const int b = byte();
        if (b < 208) return static_cast<float>(b - 104) / 8;
        const std::uint32_t high = byte(), low = byte();
        return std::bit_cast<float>(high << 24 | low << 16);
    }
    glm::vec3 vector() {
        const float x = number(), y = number(), z = number();
        return {x, y, z};
    }

private:
    std::span<const std::uint8_t> rest_;
};
