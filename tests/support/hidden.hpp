// SPDX-License-Identifier: MIT
#pragma once
// For hidden tests: inputs that nobody can know beforehand, and that can be drawn again from the seed in the grader's log.

#include <numbers.hpp>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <vector>

namespace hidden {

/// The seed of one test, told apart by `test`. LANTERN_SEED holds the seed of this grading.
inline std::uint64_t seed(std::uint64_t test) {
    const char* said = std::getenv("LANTERN_SEED");
    return (said ? std::strtoull(said, nullptr, 10) : 1) * 0x9e3779b97f4a7c15 + test;
}

/// The numbers of one test.
inline numbers drawn(std::uint64_t test) { return numbers(seed(test)); }

inline glm::vec2 point(numbers& random) {
    const float x = random.unit();
    return {x, random.unit()};
}

inline std::vector<glm::vec2> points(numbers& random, std::size_t count) {
    std::vector<glm::vec2> all(count);
    for (glm::vec2& each : all) each = point(random);
    return all;
}

/// From low to high, all orders of magnitude alike.
inline float magnitude(numbers& random, float low, float high) {
    return float(std::exp(std::log(double(low)) + double(random.unit()) * std::log(double(high) / double(low))));
}

/// From 0 to n - 1.
inline std::uint32_t below(numbers& random, std::uint32_t n) { return std::min(std::uint32_t(random.unit() * float(n)), n - 1); }

/// n × n points, one in each cell of the unit square.
inline std::vector<glm::vec2> jittered(numbers& random, int n) {
    std::vector<glm::vec2> all;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) all.push_back((glm::vec2(x, y) + 0.999f * point(random)) / float(n));
    return all;
}

/// Of answers that jump, such as hit or miss, two right ones may differ where rounding decides. 97 of 100 must agree.
class agreement {
public:
    void count(bool same) {
        ++all_;
        same_ += same ? 1 : 0;
    }
    [[nodiscard]] bool holds() const { return all_ > 0 && same_ * 100 >= 97 * all_; }

private:
    int all_ = 0, same_ = 0;
};

/// How far an answer is from the solution's, against 1 or the solution's size, whichever is more. Infinite for NaN,
/// unless the solution says NaN too; the same infinity is no distance.
inline double apart(double a, double b) {
    if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
    const double d = std::abs(a - b) / std::max(1.0, std::abs(b));
    return d >= 0 ? d : INFINITY;
}
template <glm::length_t L, class T, glm::qualifier Q>
double apart(const glm::vec<L, T, Q>& a, const glm::vec<L, T, Q>& b) {
    double size = 1, worst = 0;
    for (glm::length_t i = 0; i < L; ++i) size = std::max(size, std::abs(double(b[i])));
    for (glm::length_t i = 0; i < L; ++i) {
        if (a[i] == b[i]) continue;
        const double d = std::abs(double(a[i]) - double(b[i])) / size;
        worst = d >= 0 ? std::max(worst, d) : INFINITY;
    }
    return worst;
}
template <class T>
double apart(const std::optional<T>& a, const std::optional<T>& b) {
    if (a.has_value() != b.has_value()) return INFINITY;
    return a ? apart(*a, *b) : 0;
}

}  // namespace hidden
