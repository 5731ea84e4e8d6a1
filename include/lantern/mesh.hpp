// SPDX-License-Identifier: MIT
#pragma once
// Many triangles that share their vertices: a range of surfaces, which any acceleration structure takes.

#include <lantern/aabb.hpp>
#include <lantern/closest.hpp>
#include <lantern/triangle.hpp>
#include <lantern/validate.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace lantern {

/// Vertices, and three indices of them for each triangle, counter-clockwise as seen from where its normal points. The
/// mesh is a random-access range whose elements are of type `triangle`, put together when asked for: `bvh tree{bunny}`,
/// then `closest(tree, bunny, ray)->index` says which triangle. Triangles of no area are allowed and never hit.
class mesh {
public:
    /// `normals`: none, or one for each vertex, of any length, to be interpolated by `smooth_normal`. Throws
    /// std::invalid_argument where a number is not finite or an index points beyond the vertices.
    mesh(std::vector<glm::vec3> vertices, std::vector<glm::uvec3> triangles, std::vector<glm::vec3> normals = {})
        : vertices_(std::move(vertices)), triangles_(std::move(triangles)), normals_(std::move(normals)) {
        constexpr std::size_t limit = std::size_t{1} << 31;
        if (triangles_.size() >= limit)
            refuse("mesh: the number of triangles", std::to_string(triangles_.size()), "below 2^31");
        if (!normals_.empty() && normals_.size() != vertices_.size())
            refuse("mesh: the number of normals", std::to_string(normals_.size()),
                   "0, or that of the vertices, " + std::to_string(vertices_.size()));
        require_finite_each(vertices_, "mesh: vertices");
        require_finite_each(normals_, "mesh: normals");
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            const glm::uvec3 t = triangles_[i];
            if (std::max({t.x, t.y, t.z}) >= vertices_.size())
                refuse(numbered("mesh: triangles", i),
                       std::string("(").append(std::to_string(t.x)).append(", ").append(std::to_string(t.y)).append(", ").append(
                           std::to_string(t.z)).append(")"),
                       "three indices below " + std::to_string(vertices_.size()));
        }
    }

    [[nodiscard]] const std::vector<glm::vec3>& vertices() const { return vertices_; }
    [[nodiscard]] const std::vector<glm::uvec3>& triangles() const { return triangles_; }
    [[nodiscard]] const std::vector<glm::vec3>& normals() const { return normals_; }

    /// How many triangles.
    [[nodiscard]] std::size_t size() const { return triangles_.size(); }

    [[nodiscard]] triangle operator[](std::size_t i) const {
        const glm::uvec3 t = triangles_[i];
        return {vertices_[t.x], vertices_[t.y], vertices_[t.z]};
    }

    /// Steps from triangle to triangle. Good as long as the mesh stays where it is.
    class iterator {
    public:
        using iterator_concept = std::random_access_iterator_tag;
        using iterator_category = std::input_iterator_tag;  // by the old rules: what * returns is no reference
        using value_type = triangle;
        using difference_type = std::ptrdiff_t;
        using reference = triangle;
        using pointer = void;

        iterator() = default;
        iterator(const mesh& of, difference_type at) : of_(&of), at_(at) {}

        triangle operator*() const { return (*of_)[static_cast<std::size_t>(at_)]; }
        triangle operator[](difference_type n) const { return *(*this + n); }

        iterator& operator+=(difference_type n) { at_ += n; return *this; }
        iterator& operator-=(difference_type n) { return *this += -n; }
        iterator& operator++() { return *this += 1; }
        iterator& operator--() { return *this += -1; }
        iterator operator++(int) { return std::exchange(*this, *this + 1); }
        iterator operator--(int) { return std::exchange(*this, *this - 1); }

        friend iterator operator+(iterator i, difference_type n) { return i += n; }
        friend iterator operator+(difference_type n, iterator i) { return i += n; }
        friend iterator operator-(iterator i, difference_type n) { return i -= n; }
        friend difference_type operator-(const iterator& a, const iterator& b) { return a.at_ - b.at_; }
        friend bool operator==(const iterator& a, const iterator& b) { return a.at_ == b.at_; }
        friend auto operator<=>(const iterator& a, const iterator& b) { return a.at_ <=> b.at_; }

    private:
        const mesh* of_ = nullptr;
        difference_type at_ = 0;
    };
    [[nodiscard]] iterator begin() const { return {*this, 0}; }
    [[nodiscard]] iterator end() const { return {*this, static_cast<std::ptrdiff_t>(size())}; }

private:
    static std::string numbered(const char* what, std::size_t i) {
        return std::string(what).append("[").append(std::to_string(i)).append("]");
    }
    static void require_finite_each(const std::vector<glm::vec3>& values, const char* what) {
        for (std::size_t i = 0; i < values.size(); ++i)
            if (!is_finite(values[i])) refuse(numbered(what, i), to_text(values[i]), "finite");
    }

    std::vector<glm::vec3> vertices_;
    std::vector<glm::uvec3> triangles_;
    std::vector<glm::vec3> normals_;
};

/// Of all triangles; empty where there are none. Exact.
[[nodiscard]] inline aabb bounds(const mesh& m) {
    aabb all;
    for (const triangle& t : m) all = enclose(all, bounds(t));
    return all;
}

/// For shading only: the vertices' normals, interpolated to the hit's point, of unit length and on the same side as the
/// hit's own normal. That one stays geometric, and `leave` goes by it. Where the mesh has no normals, or they cancel,
/// the geometric one is returned.
[[nodiscard]] inline glm::vec3 smooth_normal(const mesh& m, const nearest& h) {
    if (m.normals().empty()) return h.normal;
    const glm::uvec3 of = m.triangles()[h.index];
    const triangle s = m[h.index];
    const glm::dvec3 a(s.a), b(s.b), c(s.c), p(h.point), face = glm::cross(b - a, c - a);
    // Each vertex weighs as much as the triangle between the point and the opposite side (Möbius 1827).
    const double wa = glm::dot(face, glm::cross(b - p, c - p)), wb = glm::dot(face, glm::cross(c - p, a - p)),
                 wc = glm::dot(face, glm::cross(a - p, b - p)), all = glm::dot(face, face);
    const auto weight = [&](double w) { return std::clamp(w / all, 0.0, 1.0); };
    const auto normal = [&](std::uint32_t vertex) { return glm::dvec3(m.normals()[vertex]); };
    const glm::dvec3 n = weight(wa) * normal(of.x) + weight(wb) * normal(of.y) + weight(wc) * normal(of.z);
    const double length = glm::length(n);
    if (!(length > 0 && std::isfinite(length))) return h.normal;
    const glm::vec3 result(n / length);
    return glm::dot(result, h.normal) < 0 ? -result : result;
}

/// A normal for each vertex: those of its triangles, each weighted by its angle there (Thürmer and Wüthrich 1998), so
/// that it does not matter how a flat face is cut up. Zero for a vertex that belongs to no triangle with an area.
[[nodiscard]] inline std::vector<glm::vec3> vertex_normals(const mesh& m) {
    std::vector<glm::dvec3> sums(m.vertices().size(), glm::dvec3(0));
    for (const glm::uvec3& t : m.triangles()) {
        for (int corner = 0; corner < 3; ++corner) {
            const glm::dvec3 p(m.vertices()[t[corner]]), q(m.vertices()[t[(corner + 1) % 3]]),
                r(m.vertices()[t[(corner + 2) % 3]]);
            const glm::dvec3 face = glm::cross(q - p, r - p);
            const double twice_area = glm::length(face);
            if (twice_area > 0) sums[t[corner]] += std::atan2(twice_area, glm::dot(q - p, r - p)) / twice_area * face;
        }
    }
    std::vector<glm::vec3> normals;
    normals.reserve(sums.size());
    for (const glm::dvec3& n : sums) {
        const double length = glm::length(n);
        normals.emplace_back(length > 0 ? n / length : glm::dvec3(0));
    }
    return normals;
}

}  // namespace lantern
