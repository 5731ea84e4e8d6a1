// SPDX-License-Identifier: MIT
#pragma once
// The formulas of the textbooks, in float, as they are printed. Each is right on paper. Do not copy from here.

#include "adapter.hpp"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace naive {

using stress::hit;
using stress::ray;
using answer = std::optional<hit>;

inline constexpr float epsilon = 1e-3f;  // "to avoid acne"
inline constexpr float infinity = std::numeric_limits<float>::infinity();
inline constexpr float pi = std::numbers::pi_v<float>;

inline glm::vec3 at(const ray& r, float t) { return r.origin + t * r.direction; }

/// "Ray Tracing in One Weekend": (-b ± √(b² - ac)) / a, both roots from the same formula.
inline answer sphere(glm::vec3 center, float radius, const ray& r, float from = 0, float to = infinity) {
    const glm::vec3 oc = center - r.origin;
    const float a = glm::dot(r.direction, r.direction), h = glm::dot(r.direction, oc), c = glm::dot(oc, oc) - radius * radius;
    const float discriminant = h * h - a * c;
    if (discriminant < 0) return std::nullopt;
    const float root = std::sqrt(discriminant);
    float t = (h - root) / a;
    if (!(t > from && t < to)) {
        t = (h + root) / a;
        if (!(t > from && t < to)) return std::nullopt;
    }
    const glm::vec3 p = at(r, t);
    return hit{t, p, (p - center) / radius};
}

/// n·p = D with D computed beforehand, and "nearly parallel is a miss".
inline answer plane(glm::vec3 point, glm::vec3 normal, const ray& r, float from = 0, float to = infinity) {
    const glm::vec3 n = glm::normalize(normal);
    const float offset = glm::dot(n, point), speed = glm::dot(n, r.direction);
    if (std::abs(speed) < 1e-8f) return std::nullopt;
    const float t = (offset - glm::dot(n, r.origin)) / speed;
    if (!(t > from && t < to)) return std::nullopt;
    return hit{t, at(r, t), n};
}

/// Möller and Trumbore 1997, with the epsilon that it is always copied with.
template <class Vector = glm::vec3>
answer triangle(glm::vec3 a_, glm::vec3 b_, glm::vec3 c_, const ray& r, typename Vector::value_type smallest = 1e-8f, float from = 0, float to = infinity) {
    const Vector a(a_), e1 = Vector(b_) - a, e2 = Vector(c_) - a, d(r.direction), p = glm::cross(d, e2);
    const auto determinant = glm::dot(e1, p);
    if (std::abs(determinant) <= smallest) return std::nullopt;
    const auto inverse = 1 / determinant;
    const Vector s = Vector(r.origin) - a;
    const auto u = inverse * glm::dot(s, p);
    if (u < 0 || u > 1) return std::nullopt;
    const Vector q = glm::cross(s, e1);
    const auto v = inverse * glm::dot(d, q);
    if (v < 0 || u + v > 1) return std::nullopt;
    const auto t = static_cast<float>(inverse * glm::dot(e2, q));
    if (!(t > from && t < to)) return std::nullopt;
    return hit{t, at(r, t), glm::vec3(glm::normalize(glm::cross(e1, e2)))};
}

/// As in "The Next Week": the plane's D, then coordinates along u and v.
inline answer rectangle(glm::vec3 corner, glm::vec3 u, glm::vec3 v, const ray& r) {
    const glm::vec3 n = glm::cross(u, v), w = n / glm::dot(n, n);
    const auto h = plane(corner, n, r);
    if (!h) return h;
    const glm::vec3 p = h->point - corner;
    const float alpha = glm::dot(w, glm::cross(p, v)), beta = glm::dot(w, glm::cross(u, p));
    return alpha >= 0 && alpha <= 1 && beta >= 0 && beta <= 1 ? h : std::nullopt;
}

inline answer disk(glm::vec3 center, glm::vec3 normal, float radius, const ray& r) {
    const auto h = plane(center, normal, r);
    return h && glm::length(h->point - center) <= radius ? h : std::nullopt;
}

/// "The Next Week": divide, swap, shrink; and `<=` ends it.
inline bool slabs(glm::vec3 lo, glm::vec3 hi, const ray& r, float& near, float& far) {
    for (int i = 0; i < 3; ++i) {
        const float inverse = 1 / r.direction[i];
        float t0 = (lo[i] - r.origin[i]) * inverse, t1 = (hi[i] - r.origin[i]) * inverse;
        if (t0 > t1) std::swap(t0, t1);
        near = std::max(near, t0);
        far = std::min(far, t1);
        if (far <= near) return false;
    }
    return true;
}

inline bool meets_box(stress::box b, const ray& r) {
    float near = 0, far = infinity;
    return slabs(b.min, b.max, r, near, far);
}

inline answer box_surface(stress::box b, const ray& r) {
    float near = -infinity, far = infinity;
    if (!slabs(b.min, b.max, r, near, far)) return std::nullopt;
    const float t = near > 0 ? near : far;
    if (!(t > 0)) return std::nullopt;
    hit h{t, at(r, t), glm::vec3(0)};
    for (int i = 0; i < 3; ++i)
        for (const float side : {-1.0f, 1.0f})
            if (std::abs(h.point[i] - (side < 0 ? b.min : b.max)[i]) < 1e-4f) h.normal = glm::vec3(0), h.normal[i] = side;
    return h;
}

inline answer cylinder(glm::vec3 from, glm::vec3 to, float radius, const ray& r) {
    const glm::vec3 axis = glm::normalize(to - from), f = r.origin - from;
    const float height = glm::length(to - from);
    const glm::vec3 d = r.direction - glm::dot(r.direction, axis) * axis, o = f - glm::dot(f, axis) * axis;
    const float a = glm::dot(d, d), b = glm::dot(o, d), c = glm::dot(o, o) - radius * radius, discriminant = b * b - a * c;
    answer best;
    const auto consider = [&](float t, glm::vec3 normal) {
        if (t > 0 && (!best || t < best->t)) best = hit{t, at(r, t), normal};
    };
    if (discriminant >= 0)
        for (const float root : {-std::sqrt(discriminant), std::sqrt(discriminant)}) {
            const float t = (-b + root) / a, y = glm::dot(f + t * r.direction, axis);
            if (y >= 0 && y <= height) consider(t, (o + t * d) / radius);
        }
    for (const float lid : {0.0f, height}) {
        const float t = (lid - glm::dot(f, axis)) / glm::dot(r.direction, axis);
        if (glm::length(o + t * d) <= radius) consider(t, lid > 0 ? axis : -axis);
    }
    return best;
}

/// Carried to the object's space in float, with a direction of unit length there; the normal by the matrix itself.
inline answer placed_sphere(stress::affine m, glm::vec3 center, float radius, const ray& r, bool unit_direction = true, bool inverse_normal = false) {
    const glm::vec3 x = m.columns[0], y = m.columns[1], z = m.columns[2];
    const float determinant = glm::dot(x, glm::cross(y, z));
    const glm::vec3 rx = glm::cross(y, z) / determinant, ry = glm::cross(z, x) / determinant, rz = glm::cross(x, y) / determinant;
    const auto back = [&](glm::vec3 v) { return glm::vec3(glm::dot(rx, v), glm::dot(ry, v), glm::dot(rz, v)); };
    const auto there = [&](glm::vec3 v) { return v.x * x + v.y * y + v.z * z; };
    const ray local{back(r.origin - m.translation), unit_direction ? glm::normalize(back(r.direction)) : back(r.direction)};
    const auto h = sphere(center, radius, local);
    if (!h) return h;
    const glm::vec3 n = inverse_normal ? h->normal.x * rx + h->normal.y * ry + h->normal.z * rz : there(h->normal);
    const glm::vec3 p = there(h->point) + m.translation;
    return hit{unit_direction ? glm::length(p - r.origin) / glm::length(r.direction) : h->t, p, glm::normalize(n)};
}

inline stress::box box_around_sphere(stress::ball b) { return {b.center - b.radius, b.center + b.radius}; }

/// The middle of the box, and the farthest point.
inline stress::ball ball_around(const std::vector<glm::vec3>& points) {
    glm::vec3 lo(infinity), hi(-infinity);
    for (const glm::vec3 p : points) lo = glm::min(lo, p), hi = glm::max(hi, p);
    const glm::vec3 middle = (lo + hi) / 2.0f;
    float radius = 0;
    for (const glm::vec3 p : points) radius = std::max(radius, glm::length(p - middle));
    return {middle, radius};
}

/// A vector that is not parallel, and two cross products.
inline stress::frame basis(glm::vec3 w) {
    const glm::vec3 n = glm::normalize(w), other = std::abs(n.x) > 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 v = glm::normalize(glm::cross(n, other));
    return {glm::cross(v, n), v, n};
}

/// Frisvad 2012, for a vector that is believed to have unit length.
inline stress::frame frisvad(glm::vec3 n) {
    if (n.z < -0.9999999f) return {{0, -1, 0}, {-1, 0, 0}, n};
    const float a = 1 / (1 + n.z), b = -n.x * n.y * a;
    return {{1 - n.x * n.x * a, b, -n.x}, {b, 1 - n.y * n.y * a, -n.y}, n};
}

inline glm::vec3 leave(hit h, glm::vec3 direction) { return h.point + epsilon * direction; }

inline glm::vec3 mirrored(glm::vec3 in, glm::vec3 normal) { return glm::normalize(in - 2 * glm::dot(in, normal) * normal); }

/// sin² = 1 - cos², and Schlick's curve.
inline std::optional<stress::bent> refracted(glm::vec3 in, glm::vec3 normal, float ratio, bool schlick = true) {
    const glm::vec3 d = glm::normalize(in), n = glm::normalize(normal);
    const float cosine = std::min(-glm::dot(d, n), 1.0f), sine = std::sqrt(1 - cosine * cosine);
    if (ratio * sine > 1) return std::nullopt;
    const glm::vec3 across = ratio * (d + cosine * n), along = -std::sqrt(std::abs(1 - glm::dot(across, across))) * n;
    const float cos_out = std::sqrt(std::abs(1 - glm::dot(across, across)));
    float r0 = (1 - ratio) / (1 + ratio);
    r0 *= r0;
    const float p = (cosine - ratio * cos_out) / (cosine + ratio * cos_out), s = (ratio * cosine - cos_out) / (ratio * cosine + cos_out);
    return stress::bent{across + along, schlick ? r0 + (1 - r0) * std::pow(1 - cosine, 5.0f) : (p * p + s * s) / 2};
}

inline float unit_number(std::uint32_t bits) { return static_cast<float>(bits) * 0x1p-32f; }

inline glm::vec2 to_disk(glm::vec2 xi) {  // concentric, without the question whether it is the middle
    const float a = 2 * xi.x - 1, b = 2 * xi.y - 1;
    const float r = std::abs(a) > std::abs(b) ? a : b, angle = std::abs(a) > std::abs(b) ? pi / 4 * (b / a) : pi / 2 - pi / 4 * (a / b);
    return {r * std::cos(angle), r * std::sin(angle)};
}
inline glm::vec3 to_sphere(glm::vec2 xi) {
    const float z = 1 - 2 * xi.x, r = std::sqrt(1 - z * z), angle = 2 * pi * xi.y;
    return {r * std::cos(angle), r * std::sin(angle), z};
}
inline glm::vec3 to_cosine_hemisphere(glm::vec2 xi) {
    const glm::vec2 p = to_disk(xi);
    return {p.x, p.y, std::sqrt(1 - p.x * p.x - p.y * p.y)};
}
inline glm::vec3 to_triangle(glm::vec2 xi) {
    const float root = std::sqrt(xi.x), u = 1 - root, v = xi.y * root;
    return {u, v, 1 - u - v};
}
inline double cone_solid_angle(double half_angle) { return 2 * pi * (1 - std::cos(static_cast<float>(half_angle))); }
inline glm::vec3 to_cone(double half_angle, glm::vec2 xi) {
    const float z = 1 + xi.x * (std::cos(static_cast<float>(half_angle)) - 1), r = std::sqrt(1 - z * z), angle = 2 * pi * xi.y;
    return {r * std::cos(angle), r * std::sin(angle), z};
}

/// A point in focus, eye + f·d, and from the lens towards it.
inline ray shoot(stress::view v, glm::vec2 film, glm::vec2 lens) {
    const glm::vec3 forward = glm::normalize(v.target - v.eye), right = glm::normalize(glm::cross(forward, v.up)), up = glm::cross(right, forward);
    const float half = std::tan(v.vertical_fov / 2);
    const glm::vec3 d = forward + (2 * film.x - 1) * half * v.aspect * right + (1 - 2 * film.y) * half * up;
    const glm::vec3 in_focus = v.eye + v.focus_distance * d;
    const glm::vec2 p = to_disk(lens);
    const glm::vec3 origin = v.eye + v.lens_radius * p.x * right + v.lens_radius * p.y * up;
    return {origin, glm::normalize(in_focus - origin)};
}
inline float moment(float opens, float closes, float xi) { return (1 - xi) * opens + xi * closes; }
inline stress::box box_around_moving(stress::ball b, glm::vec3 displacement) {
    const auto first = box_around_sphere(b), last = box_around_sphere({b.center + displacement, b.radius});
    return {glm::min(first.min, last.min), glm::max(first.max, last.max)};
}
/// The boxes at both ends.
inline stress::box box_around_turning(stress::ball b, glm::vec3 axis, float angle) {
    const glm::vec3 k = glm::normalize(axis), p = b.center;
    const glm::vec3 turned = std::cos(angle) * p + std::sin(angle) * glm::cross(k, p) + (1 - std::cos(angle)) * glm::dot(k, p) * k;
    return box_around_moving(b, turned - p);
}

inline stress::total mean(const std::vector<glm::vec3>& samples, std::uint64_t times) {
    glm::vec3 sum(0);
    for (std::uint64_t i = 0; i < times; ++i)
        for (const glm::vec3& s : samples) sum += s;
    return {sum / (static_cast<float>(samples.size()) * static_cast<float>(times)), 0};
}
inline float to_srgb(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}
/// √ for the curve, a cast for the byte; the cast of NaN, which is undefined, is done here as processors do it.
inline int to_byte(float linear) {
    const float value = 255.999f * std::sqrt(linear);
    return std::abs(value) < 2e9f ? static_cast<int>(value) : std::numeric_limits<int>::min();
}

inline double sphere_solid_angle(glm::vec3 point, stress::ball b) {
    const glm::vec3 to = b.center - point;
    return 2 * pi * (1 - std::sqrt(1 - b.radius * b.radius / glm::dot(to, to)));
}
inline float point_irradiance(glm::vec3 position, float intensity, glm::vec3 point) {
    const glm::vec3 to = position - point;
    return intensity / glm::dot(to, to);
}
inline std::pair<glm::vec3, float> sphere_light(stress::ball lamp, glm::vec3 point, glm::vec2 xi) {
    const glm::vec3 to = lamp.center - point, direction = to_cone(std::asin(lamp.radius / glm::length(to)), xi);
    const stress::frame f = basis(to);
    const glm::vec3 d = direction.x * f.u + direction.y * f.v + direction.z * f.w;
    const auto h = sphere(lamp.center, lamp.radius, {point, d});
    return {h ? h->point : lamp.center, static_cast<float>(sphere_solid_angle(point, lamp))};
}
inline glm::vec3 perturbed(glm::vec3 reflected, float width, glm::vec2 xi) {
    const stress::frame f = basis(reflected);
    const float u = -width / 2 + xi.x * width, v = -width / 2 + xi.y * width;
    return glm::normalize(reflected + u * f.u + v * f.v);  // not of unit length: the blur depends on it
}

/// A path of albedo after albedo, until it is 50 long.
inline double furnace(float albedo, std::uint32_t, std::uint64_t, int depth = 50) {
    double sum = 0, weight = 1;
    for (int i = 0; i < depth; ++i, weight *= double(albedo)) sum += weight;
    return sum;
}

}  // namespace naive
