// SPDX-License-Identifier: MIT
#pragma once
// A contract of all kinds of values, for the tests of judge and worker.

#include <contract.hpp>

#include <lantern/ray.hpp>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

namespace contract::lab00 {

enum class color : std::uint8_t { red, green, blue };

struct leaf {
    float size = 0;
};
struct tree {
    std::variant<leaf, std::string> content;
    std::vector<tree> below;
    bool operator==(const tree&) const = default;
};
inline bool operator==(const leaf& a, const leaf& b) { return a.size == b.size; }

struct everything {
    bool flag;
    color tint;
    glm::vec3 vector;
    glm::mat3 matrix;
    glm::bvec2 bits;
    std::optional<double> maybe;
    std::pair<int, std::string> both;
    std::tuple<char, std::uint64_t> several;
    std::array<std::uint16_t, 3> three;
    std::vector<std::vector<glm::vec2>> sets;
    std::vector<bool> flags;
    tree root;
};

inline constexpr function<"same", everything(everything)> same;
inline constexpr function<"sum", float(std::span<const float> values)> sum;
inline constexpr function<"length", std::size_t(std::string_view text)> length;
inline constexpr function<"later", lantern::timed_ray(lantern::timed_ray r, float by)> later;
inline constexpr function<"nothing", void()> nothing;
inline constexpr function<"calls", int()> calls;
inline constexpr function<"apply", int(std::function<int(int)> f, int times, int x)> apply;
inline constexpr function<"fail", int(int how)> fail;
inline constexpr function<"misbehave", bool(std::string how)> misbehave;

}  // namespace contract::lab00
