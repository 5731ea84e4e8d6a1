// SPDX-License-Identifier: MIT
#pragma once
// On which side a ray passes an edge: decided exactly, for the rare cases in which rounding would decide.

#include <lantern/double_double.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <cstddef>

namespace lantern {

/// A sum of doubles without any rounding: parts that do not overlap, the largest one last (Shewchuk, "Adaptive precision
/// floating-point arithmetic and fast robust geometric predicates", 1997, Grow-Expansion). Room for `Most` numbers.
template <std::size_t Most>
class expansion {
public:
    void add(double x) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            const double_double s = two_sum(x, parts_[i]);
            if (s.low != 0) parts_[kept++] = s.low;
            x = s.high;
        }
        if (x != 0) parts_[kept++] = x;
        count_ = kept;
    }
    void add_product(double x, double y, double z) {
        const double_double xy = two_product(x, y);
        for (const double part : {xy.high, xy.low}) {
            const double_double p = two_product(part, z);
            add(p.high);
            add(p.low);
        }
    }

    /// Of the sum's sign, and within an ulp of it.
    [[nodiscard]] double largest() const { return count_ > 0 ? parts_[count_ - 1] : 0; }

private:
    std::array<double, Most> parts_{};
    std::size_t count_ = 0;
};

/// d · ((a - o) × (b - o)), of the right sign: 0 when the line from o along d meets the line through a and b, and the opposite when
/// a and b are exchanged. In double-double, and exactly where that is not enough, as long as nothing over- or underflows: of
/// floats nothing does. NaN when something is not finite.
[[nodiscard, gnu::noinline]] inline double triple_product(const glm::dvec3& d, const glm::dvec3& o, const glm::dvec3& a,
                                                          const glm::dvec3& b) {
    std::array<double_double, 3> p, q;
    for (int i = 0; i < 3; ++i) {
        p[std::size_t(i)] = two_sum(a[i], -o[i]);
        q[std::size_t(i)] = two_sum(b[i], -o[i]);
    }
    double_double sum;
    double size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        const double_double x = p[j] * q[k], y = p[k] * q[j], di{d[int(i)]};
        sum = sum + di * (x - y);
        size += std::abs(di.high) * (std::abs(x.high) + std::abs(y.high));
    }
    if (std::abs(sum.high) > 0x1p-90 * size || !std::isfinite(size)) return std::isfinite(size) ? sum.high : size - size;

    expansion<97> exact;  // 6 products of 2 by 2 parts, 4 numbers each
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        for (const double s : {p[j].high, p[j].low})
            for (const double t : {q[k].high, q[k].low}) exact.add_product(s, t, d[int(i)]);
        for (const double s : {p[k].high, p[k].low})
            for (const double t : {q[j].high, q[j].low}) exact.add_product(s, t, -d[int(i)]);
    }
    return exact.largest();
}

}  // namespace lantern
