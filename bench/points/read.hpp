// SPDX-License-Identifier: MIT
#pragma once
// The half of a measurement that reads points which somebody else's program makes (write.hpp), and believes none of it.

#include "replayed.hpp"

#include <array>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string_view>

namespace points {

/// Reads table after table from a stream, as long as there are any.
class reader {
public:
    explicit reader(std::FILE* from) : from_(from) {}

    /// The points of the next rendering; false where the stream ends before the last of them, or does not begin as it must.
    [[nodiscard]] bool read(point_table& table) {
        if (!begun_ && !(begun_ = begins())) return false;
        table.points.resize(table.purposes.size() * table.size.x * table.size.y * table.samples);
        if (std::fread(table.points.data(), sizeof(glm::vec2), table.points.size(), from_) != table.points.size()) return false;
        for (const glm::vec2 p : table.points) outside_ += !(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1);
        points_ += table.points.size();
        return true;
    }
    /// What the program says that it took, all in all, after the last point; nothing where it says nothing that can be.
    [[nodiscard]] std::optional<double> seconds() {
        double said = 0;
        if (std::fread(&said, sizeof said, 1, from_) != 1 || !(said >= 0 && said < 1e9)) return {};
        return said;
    }
    [[nodiscard]] bool begun() const { return begun_; }              ///< whether the stream began as it must
    [[nodiscard]] std::uint64_t points() const { return points_; }   ///< so far
    [[nodiscard]] std::uint64_t outside() const { return outside_; } ///< of them outside the unit square, NaN among them

private:
    [[nodiscard]] bool begins() {
        constexpr std::string_view expected = "lantern points 1\n";
        std::array<char, expected.size()> found{};
        return std::fread(found.data(), 1, found.size(), from_) == found.size() && std::string_view(found.data(), found.size()) == expected;
    }

    std::FILE* from_;
    bool begun_ = false;
    std::uint64_t points_ = 0, outside_ = 0;
};

}  // namespace points
