// SPDX-License-Identifier: MIT
#pragma once
// Materials: how a surface answers light, and where rays go on from it.

#include <lantern/samples.hpp>
#include <lantern/surface.hpp>
#include <lantern/validate.hpp>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <concepts>
#include <cstdint>

namespace lantern {

/// A ray that goes on from a surface: its unit direction, and what its radiance is multiplied by.
struct bounce {
    glm::vec3 direction{0};
    glm::vec3 weight{0};
};

/// None (absorbed), one (mirror) or two (glass) rays that go on.
class bounces {
public:
    bounces() = default;
    bounces(const bounce& only) : rays_{only}, size_(1) {}
    bounces(const bounce& first, const bounce& second) : rays_{first, second}, size_(2) {}
    [[nodiscard]] const bounce* begin() const { return rays_.data(); }
    [[nodiscard]] const bounce* end() const { return rays_.data() + size_; }
    [[nodiscard]] std::uint32_t size() const { return size_; }
    /// i < size().
    [[nodiscard]] const bounce& operator[](std::uint32_t i) const {
        assert(i < size_);
        return rays_[i];
    }
    [[nodiscard]] bool empty() const { return size_ == 0; }
    [[nodiscard]] friend bounces operator*(float factor, bounces rays) {
        for (bounce& b : rays.rays_) b.weight *= factor;
        return rays;
    }

private:
    std::array<bounce, 2> rays_{};
    std::uint32_t size_ = 0;
};

// What a material may offer. All directions are unit vectors; `in` points towards the surface, `out` away from it.
// A material offers what it has, and an integrator asks for what it needs; a function that is absent costs nothing.

/// Answers light that arrives from `out`: the BRDF times the cosine at the surface.
template <class M>
concept reflects_light = requires(const M& m, glm::vec3 in, const hit& h, glm::vec3 out) {
    { evaluate(m, in, h, out) } -> std::same_as<glm::vec3>;
};

/// Sends rays on without a choice: a mirror, glass.
template <class M>
concept specular = requires(const M& m, glm::vec3 in, const hit& h) {
    { scatter(m, in, h) } -> std::same_as<bounces>;
};

/// Sends rays on into a lobe, and needs a point of the unit square to choose: glossy.
template <class M>
concept scatters_by_sample = requires(const M& m, glm::vec3 in, const hit& h, glm::vec2 xi) {
    { scatter(m, in, h, xi) } -> std::same_as<bounces>;
};

/// Two rays, a point for each: frosted glass.
template <class M>
concept scatters_by_two_samples = requires(const M& m, glm::vec3 in, const hit& h, glm::vec2 xi, glm::vec2 xi2) {
    { scatter(m, in, h, xi, xi2) } -> std::same_as<bounces>;
};

/// Sends rays on, with however many points of the unit square.
template <class M>
concept scatters = specular<M> || scatters_by_sample<M> || scatters_by_two_samples<M>;

/// Answers light that comes evenly from everywhere: the fraction it sends back.
template <class M>
concept reflects_ambient = requires(const M& m, const hit& h) {
    { albedo(m, h) } -> std::same_as<glm::vec3>;
};

/// Shines by itself.
template <class M>
concept emits = requires(const M& m, glm::vec3 in, const hit& h) {
    { emitted(m, in, h) } -> std::same_as<glm::vec3>;
};

template <class M>
concept material = reflects_light<M> || scatters<M> || reflects_ambient<M> || emits<M>;

/// The rays that a material sends on. It draws the points that the material asks for, and nothing for one that needs none.
/// (Inlined always: only then is it known how many rays there are, and the place for a second one is left out.)
template <scatters M, sample_source Source>
[[nodiscard, gnu::always_inline]] inline bounces scattered(const M& m, glm::vec3 in, const hit& h, const Source& source) {
    if constexpr (specular<M>) {
        return scatter(m, in, h);
    } else if constexpr (scatters_by_sample<M>) {
        return scatter(m, in, h, source.draw2(purpose::gloss));
    } else {
        return scatter(m, in, h, source.draw2(purpose::gloss, 0), source.draw2(purpose::gloss, 1));
    }
}

[[nodiscard]] inline float largest(glm::vec3 weight) { return std::max({weight.x, weight.y, weight.z}); }

/// When one of the rays is followed for all: how likely it is the first. In proportion to what they carry; what is black
/// is not followed.
[[nodiscard]] inline float chance_of_first(const bounces& rays) {
    const float first = rays.size() > 0 ? largest(rays[0].weight) : 0;
    const float second = rays.size() > 1 ? largest(rays[1].weight) : 0;
    return first > 0 ? first / (first + second) : 0;
}

/// The normal on the side that a ray came from.
[[nodiscard]] inline glm::vec3 facing(glm::vec3 normal, glm::vec3 in) {
    return glm::dot(in, normal) > 0 ? -normal : normal;
}

/// For reflectances and transmittances.
inline void require_albedo(glm::vec3 value, const char* what) {
    if (!(glm::all(glm::lessThanEqual(value, glm::vec3(1))) && glm::all(glm::greaterThanEqual(value, glm::vec3(0)))))
        refuse(what, to_text(value), "between 0 and 1");
}

}  // namespace lantern
