// SPDX-License-Identifier: MIT
#pragma once
// From the unit square to a sphere or a rectangle, evenly over the solid angle at which a point sees it.

#include <lantern/basis.hpp>
#include <lantern/warp.hpp>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace lantern {

/// A point of a light, and the probability per solid angle with which its direction was drawn.
struct seen_point {
    glm::dvec3 position{0};
    double density = 0;
};

/// A sphere as a point outside it sees it: all of the cone that it fills, and nothing of its far side.
struct seen_sphere {
    glm::dvec3 center{0};
    double radius = 0, distance = 0;
    cone directions{};  ///< about the line to the centre; height = s²/(1 + √(1 - s²)) with s = radius / distance
    basis frame{};      ///< w towards the centre
};

/// Nothing when the point is within the sphere or on it.
[[nodiscard]] inline std::optional<seen_sphere> sphere_seen_from(glm::vec3 point, glm::vec3 center, float radius) {
    const glm::dvec3 to_center = glm::dvec3(center) - glm::dvec3(point);
    const double r = std::abs(radius), d = glm::length(to_center), s = r / d;
    if (!(d > r)) return std::nullopt;
    const double cosine = std::sqrt((d - r) * (d + r)) / d;
    return seen_sphere{glm::dvec3(center), r, d, {s * s / (1 + cosine)}, basis_from(glm::vec3(to_center / d))};
}

[[nodiscard]] inline double solid_angle(const seen_sphere& s) { return solid_angle(s.directions); }

/// The sphere's outward unit normal at a point drawn uniformly by solid angle. In the triangle of viewer, centre and point
/// the law of sines gives the angle at the point, hence the one at the centre, without the difference of two nearly equal
/// distances.
[[nodiscard]] inline glm::dvec3 seen_normal(const seen_sphere& s, glm::vec2 xi) {
    const glm::dvec3 local = to_cone(s.directions, xi);
    const double sine = std::sqrt(local.x * local.x + local.y * local.y), cosine = local.z;
    const double q = std::min(1.0, sine * s.distance / s.radius), p = std::sqrt((1 - q) * (1 + q));
    const double outward = q * cosine - p * sine, towards = p * cosine + q * sine;
    const double scale = sine > 0 ? outward / sine : 0;
    return local.x * scale * glm::dvec3(s.frame.u) + local.y * scale * glm::dvec3(s.frame.v) -
           towards * glm::dvec3(s.frame.w);
}

/// The point with that normal.
[[nodiscard]] inline seen_point to_seen(const seen_sphere& s, glm::vec2 xi) {
    return {s.center + s.radius * seen_normal(s, xi), cone_density(s.directions)};
}

/// A rectangle as a point sees it, after Ureña, Fajardo and King, "An area-preserving parametrization for spherical
/// rectangles" (2013). With the viewer at the origin, the rectangle spans [x0, x1] × [y0, y1] at the height h. Its part up to
/// x has the solid angle G(x) - G(x0), G(x) = asin(b1 c) - asin(b0 c), where b = y/√(y² + h²) and c = x/√(x² + h²).
/// Below `smallest`, where rounding would be seen, and for edges that are not perpendicular, points are drawn by area
/// instead: the density then varies over the rectangle, and is as exact.
class seen_rectangle {
public:
    static constexpr double smallest = 1e-9;  // steradians

    seen_rectangle(glm::vec3 point, glm::vec3 corner, glm::vec3 edge_u, glm::vec3 edge_v)
        : viewer_(point), corner_(corner), u_(edge_u), v_(edge_v) {
        const double width = glm::length(u_), height = glm::length(v_);
        const glm::dvec3 cross = glm::cross(u_, v_), to_corner = corner_ - viewer_;
        area_ = glm::length(cross);
        x_axis_ = u_ / width;
        y_axis_ = v_ / height;
        x0_ = glm::dot(to_corner, x_axis_);
        y0_ = glm::dot(to_corner, y_axis_);
        x1_ = x0_ + width;
        y1_ = y0_ + height;
        h_ = std::abs(glm::dot(to_corner, cross)) / area_;
        const bool right_angled = std::abs(glm::dot(x_axis_, y_axis_)) < 1e-6;
        solid_angle_ =
            triangle(corner_, corner_ + u_, corner_ + u_ + v_) + triangle(corner_, corner_ + v_, corner_ + u_ + v_);
        by_area_ = !(right_angled && solid_angle_ > smallest);
    }

    /// Of the whole parallelogram, exact for tiny ones too; 0 when the viewer is in its plane.
    [[nodiscard]] friend double solid_angle(const seen_rectangle& r) { return r.solid_angle_; }

    [[nodiscard]] friend seen_point to_seen(const seen_rectangle& r, glm::vec2 xi) {
        return r.by_area_ ? r.drawn_by_area(xi) : r.drawn_by_angle(xi);
    }

private:
    glm::dvec3 viewer_, corner_, u_, v_, x_axis_, y_axis_;
    double x0_, x1_, y0_, y1_, h_, area_, solid_angle_;
    bool by_area_;

    /// Van Oosterom and Strackee, "The solid angle of a plane triangle" (1983).
    [[nodiscard]] double triangle(glm::dvec3 p, glm::dvec3 q, glm::dvec3 r) const {
        const glm::dvec3 a = p - viewer_, b = q - viewer_, c = r - viewer_;
        const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
        const double volume = h_ * area_;  // of a, b, c, without cancellation
        return 2 * std::atan2(volume, la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
    }

    /// asin(b c), by the arc tangent: exact near a right angle too.
    [[nodiscard]] double quarter(double x, double y) const {
        return std::atan2(x * y, h_ * std::sqrt(x * x + y * y + h_ * h_));
    }

    [[nodiscard]] seen_point drawn_by_angle(glm::vec2 xi) const {
        // Solves G(x) = k: by the law of sines c = sin k / √(b0² + b1² - 2 b0 b1 cos k), and x = h c/√(1 - c²), where
        // sin² k is left out of what is below the root by the law of cosines.
        const double k = xi.x * solid_angle_ + quarter(x0_, y1_) - quarter(x0_, y0_);
        const double low = std::atan2(y0_, h_), high = std::atan2(y1_, h_);
        const double width = std::atan2(h_ * (y1_ - y0_), h_ * h_ + y0_ * y1_);
        const double below = 4 * std::sin((width + k) / 2) * std::sin((width - k) / 2) *
                             std::cos((low + high + k) / 2) * std::cos((low + high - k) / 2);
        const double x =
            std::clamp(h_ * std::sin(k) / std::sqrt(std::max(below, std::numeric_limits<double>::min())), x0_, x1_);
        // Along y the density at x is that of a circle's arc: uniform in y/√(x² + y² + h²).
        const double d = std::sqrt(x * x + h_ * h_);
        const double s0 = y0_ / std::sqrt(d * d + y0_ * y0_), s1 = y1_ / std::sqrt(d * d + y1_ * y1_);
        const double s = s0 + xi.y * (s1 - s0);
        const double left = std::max((1 - s) * (1 + s), std::numeric_limits<double>::min());
        const double y = std::clamp(s * d / std::sqrt(left), y0_, y1_);
        return {corner_ + (x - x0_) * x_axis_ + (y - y0_) * y_axis_, 1 / solid_angle_};
    }

    /// r³/(h A): the density by area, seen at the distance r under the cosine h/r. Infinite in the rectangle's plane.
    [[nodiscard]] seen_point drawn_by_area(glm::vec2 xi) const {
        const glm::dvec3 p = corner_ + double{xi.x} * u_ + double{xi.y} * v_;
        const double r = glm::length(p - viewer_);
        return {p, r * r * r / (h_ * area_)};
    }
};

}  // namespace lantern
