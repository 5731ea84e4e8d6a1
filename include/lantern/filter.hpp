// SPDX-License-Identifier: MIT
#pragma once
// Pixel filters: how much a point of the picture counts, by its distance from the middle of the pixel.

#include <lantern/validate.hpp>
#include <lantern/warp.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <numbers>

namespace lantern {

/// A place drawn from a filter, from the middle of the pixel, in pixels; and what the sample counts for. Samples are drawn
/// where the filter is large, so the weight is 1 for filters that are nowhere negative; its mean is 1 for all.
struct filter_sample {
    glm::vec2 offset{0};
    float weight = 1;
};

/// `value(f, offset)` is the filter itself, with the integral 1. `sample(f, xi)` draws from it.
template <class F>
concept pixel_filter = requires(const F& f, glm::vec2 point) {
    { value(f, point) } -> std::same_as<float>;
    { sample(f, point) } -> std::same_as<filter_sample>;
};

/// The mean over a square of side 2 · radius: 1/2 is the pixel itself.
struct box_filter {
    float radius = 0.5f;
};

inline void validate(const box_filter& f) { require_positive(f.radius, "box_filter: radius"); }

[[nodiscard]] inline float value(const box_filter& f, glm::vec2 p) {
    return std::max(std::abs(p.x), std::abs(p.y)) <= f.radius ? 1 / (4 * f.radius * f.radius) : 0;
}
[[nodiscard]] inline filter_sample sample(const box_filter& f, glm::vec2 xi) {
    return {(2.0f * xi - 1.0f) * f.radius, 1};
}

/// A pyramid of this radius, in each direction linear. Radius 1 interpolates between pixels.
struct tent_filter {
    float radius = 1;
};

inline void validate(const tent_filter& f) { require_positive(f.radius, "tent_filter: radius"); }

[[nodiscard]] inline float value(const tent_filter& f, glm::vec2 p) {
    const glm::vec2 height = glm::max(glm::vec2(0), 1.0f - glm::abs(p) / f.radius) / f.radius;
    return height.x * height.y;
}
[[nodiscard]] inline filter_sample sample(const tent_filter& f, glm::vec2 xi) {
    const auto inverse = [](float u) { return u < 0.5f ? std::sqrt(2 * u) - 1 : 1 - std::sqrt(2 * (1 - u)); };
    return {glm::vec2(inverse(xi.x), inverse(xi.y)) * f.radius, 1};
}

/// A bell of standard deviation sigma, round, cut off at `radius` and scaled up for what was cut.
struct gaussian_filter {
    float sigma = 0.5f;
    float radius = 1.5f;
};

inline void validate(const gaussian_filter& f) {
    require_positive(f.sigma, "gaussian_filter: sigma");
    require_positive(f.radius, "gaussian_filter: radius");
}

/// The part of the bell within its radius: 1 - exp(-R²/2σ²).
[[nodiscard]] inline double kept(const gaussian_filter& f) {
    const double reach = double{f.radius} / f.sigma;
    return -std::expm1(-reach * reach / 2);
}
[[nodiscard]] inline float value(const gaussian_filter& f, glm::vec2 p) {
    const double s2 = double{f.sigma} * f.sigma, r2 = double{p.x} * p.x + double{p.y} * p.y;
    if (r2 > double{f.radius} * f.radius) return 0;
    return static_cast<float>(std::exp(-r2 / (2 * s2)) / (2 * std::numbers::pi * s2 * kept(f)));
}
/// A point of the disk, moved outward until the bell holds as much as the disk did: r = σ√(-2 ln(1 - ρ² kept)).
[[nodiscard]] inline filter_sample sample(const gaussian_filter& f, glm::vec2 xi) {
    const glm::dvec2 p(to_disk(xi));
    const double rho2 = std::min(1.0, glm::dot(p, p));
    if (rho2 == 0) return {glm::vec2(0), 1};
    const double r = std::min(double{f.radius}, f.sigma * std::sqrt(-2 * std::log1p(-rho2 * kept(f))));
    return {glm::vec2(p * (r / std::sqrt(rho2))), 1};
}

/// Mitchell and Netravali, "Reconstruction filters in computer graphics" (1988), in each direction. It sharpens: from
/// (2B+6C)/(B+6C) half radii outward it is negative, and samples there have a negative weight. B and C in [0, 1].
struct mitchell_filter {
    float b = 1.0f / 3;
    float c = 1.0f / 3;
    float radius = 2;
};

inline void validate(const mitchell_filter& f) {
    if (!(f.b >= 0 && f.b <= 1)) refuse("mitchell_filter: b", to_text(f.b), "0 to 1");
    if (!(f.c >= 0 && f.c <= 1)) refuse("mitchell_filter: c", to_text(f.c), "0 to 1");
    require_positive(f.radius, "mitchell_filter: radius");
}

/// The cubic pieces in one direction, x in half radii. Beyond 1 the cubic of the paper has a double zero at 2, and is
/// (B + 6C)/6 (2 - x)² (z - x) with z the zero named above; with B = C = 0 it vanishes.
class mitchell_profile {
public:
    explicit mitchell_profile(const mitchell_filter& f)
        : b_(f.b),
          k_((b_ + 6 * double{f.c}) / 6),
          zero_(k_ > 0 ? (2 * b_ + 6 * double{f.c}) / (6 * k_) : 2.0),
          p3_((12 - 9 * b_ - 6 * double{f.c}) / 6),
          p2_((-18 + 12 * b_ + 6 * double{f.c}) / 6) {}

    [[nodiscard]] double operator()(double x) const {
        x = std::abs(x);
        if (x >= 2) return 0;
        return x < 1 ? (p3_ * x + p2_) * x * x + (6 - 2 * b_) / 6 : k_ * (2 - x) * (2 - x) * (zero_ - x);
    }

    /// The integral of the absolute value over all x.
    [[nodiscard]] double total() const { return 2 * absolute(2); }

    /// Where a fraction of that integral lies to the left. Bisection: the answer is bracketed, and exact to a float.
    [[nodiscard]] double inverse(double fraction) const {
        const double wanted = std::abs(2 * fraction - 1) * absolute(2);
        double left = 0, right = 2;
        for (int i = 0; i < 32; ++i) {
            const double middle = (left + right) / 2;
            (absolute(middle) < wanted ? left : right) = middle;
        }
        return fraction < 0.5 ? -left : left;
    }

private:
    double b_, k_, zero_, p3_, p2_;

    /// The integral of the absolute value from 0 to x, 0 <= x <= 2.
    [[nodiscard]] double absolute(double x) const {
        const double y = std::min(x, 1.0);
        const double inner = ((p3_ / 4 * y + p2_ / 3) * y * y + (6 - 2 * b_) / 6) * y;
        if (x <= 1) return inner;
        if (x <= zero_) return inner + outer(1) - outer(x);
        return inner + outer(1) - outer(zero_) + outer(x) - outer(zero_);
    }
    /// An antiderivative of the outer piece, with the sign turned: d/dx = -k (2 - x)² (z - x), and zero at 2.
    [[nodiscard]] double outer(double x) const {
        const double t = 2 - x, w = zero_ - 2;
        return k_ * t * t * t * (t / 4 + w / 3);
    }
};

[[nodiscard]] inline float value(const mitchell_filter& f, glm::vec2 p) {
    const mitchell_profile profile(f);
    const double scale = 2 / double{f.radius};
    return static_cast<float>(profile(p.x * scale) * profile(p.y * scale) * scale * scale);
}
[[nodiscard]] inline filter_sample sample(const mitchell_filter& f, glm::vec2 xi) {
    const mitchell_profile profile(f);
    const double x = profile.inverse(xi.x), y = profile.inverse(xi.y), total = profile.total();
    const double weight = std::copysign(total * total, profile(x) * profile(y));
    return {glm::vec2(glm::dvec2(x, y) * double{f.radius} / 2.0), static_cast<float>(weight)};
}

}  // namespace lantern
