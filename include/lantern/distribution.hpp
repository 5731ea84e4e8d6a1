// SPDX-License-Identifier: MIT
#pragma once
// Distribution ray tracing (Cook, Porter and Carpenter 1984): the basic ray tracer, with every ray drawn from a set.

#include <lantern/alternative.hpp>
#include <lantern/closest.hpp>
#include <lantern/direct.hpp>
#include <lantern/light.hpp>
#include <lantern/material.hpp>
#include <lantern/ray.hpp>
#include <lantern/samples.hpp>
#include <lantern/sky.hpp>
#include <lantern/surface.hpp>
#include <lantern/validate.hpp>
#include <lantern/validate_scene.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <concepts>
#include <cstdint>
#include <ranges>
#include <span>

namespace lantern {

struct distribution_options {
    glm::vec3 ambient{0};           ///< light that comes evenly from everywhere, for what shadow rays cannot find
    std::uint32_t depth = 16;       ///< how many times a ray may be followed on
    std::uint32_t split_depth = 2;  ///< up to here both rays of glass are followed, deeper one of them, by chance
};

/// One ray for every sample: its place in the pixel, on the lens and in the exposure are the camera's to draw; at a hit
/// a point on every light with area is drawn for its shadow ray, and a point of the glossy square for a reflection
/// that is not sharp. The mean over the samples of a pixel blurs them all at once, at no more rays than antialiasing
/// takes alone. Lights and materials say by the number of their arguments what they need; what is sharp draws nothing.
/// It looks at an acceleration structure, things, lights and a background; it owns none, and they must outlive it.
template <class Accelerator, class Thing, class Light, background Background = darkness>
class distribution {
public:
    distribution(const Accelerator& structure, std::span<const Thing> things, std::span<const Light> lights,
                 const Background& background = {}, const distribution_options& options = {})
        : structure_(&structure), things_(things), lights_(lights), background_(background), options_(options) {
        validate_scene(structure, things, lights, background);
        require_not_negative(options.ambient, "distribution: ambient");
    }
    distribution(const Accelerator&&, std::span<const Thing>, std::span<const Light>, const Background& = {},
                 const distribution_options& = {}) = delete;  // a temporary would be gone before the first ray

    /// The radiance along the ray: one sample of it. `source` is the sample's numbers.
    template <std::derived_from<ray> Ray, sample_source Source>
    [[nodiscard]] glm::vec3 operator()(const Ray& r, const Source& source) const {
        return radiance_along(r, source, 0);
    }

private:
    template <class Ray, class Source>
    glm::vec3 radiance_along(const Ray& r, const Source& source, std::uint32_t depth) const {
        const auto h = closest(*structure_, things_, r);
        const glm::vec3 in = unit(r.direction);
        if (!h) return radiance(background_, in);
        return with_alternative(things_[h->index].material,
                                [&](const auto& m) { return shade(m, r, in, *h, source, depth); });
    }

    template <class Material, class Ray, class Source>
    glm::vec3 shade(const Material& m, const Ray& r, glm::vec3 in, const hit& h, const Source& source,
                    std::uint32_t depth) const {
        glm::vec3 sum{0};
        if constexpr (emits<Material>) sum += emitted(m, in, h);
        if constexpr (reflects_ambient<Material>) sum += albedo(m, h) * options_.ambient;
        if constexpr (reflects_light<Material>) {
            for (std::uint32_t i = 0; i < lights_.size(); ++i) {
                const illumination light = with_alternative(
                    lights_[i], [&](const auto& kind) { return illumination_from(kind, i, r, h.point, source); });
                sum += direct_light(*structure_, things_, r, in, h, m, light);
            }
        }
        if constexpr (scatters<Material>) {
            if (depth < options_.depth) sum += carried_on(scattered(m, in, h, source), r, h, source, depth);
        }
        return sum;
    }

    template <class Ray, class Source>
    glm::vec3 carried_on(const bounces& rays, const Ray& r, const hit& h, const Source& source,
                         std::uint32_t depth) const {
        const auto follow = [&](std::uint32_t k, float chance) {
            const bounce& b = rays[k];
            const Ray next = continued(r, leave(h, b.direction), b.direction);
            return b.weight / chance * radiance_along(next, source.branch(k), depth + 1);
        };
        const float first = rays.size() > 0 ? largest(rays[0].weight) : 0;
        if (rays.size() < 2) return first > 0 ? follow(0, 1) : glm::vec3(0);
        const float second = largest(rays[1].weight);
        if (first > 0 && second > 0 && depth >= options_.split_depth) {
            const float chance = chance_of_first(rays);
            return source.draw1(purpose::branch) < chance ? follow(0, chance) : follow(1, 1 - chance);
        }
        glm::vec3 sum{0};  // what is black is not followed
        if (first > 0) sum += follow(0, 1);
        if (second > 0) sum += follow(1, 1);
        return sum;
    }

    const Accelerator* structure_;
    std::span<const Thing> things_;
    std::span<const Light> lights_;
    [[no_unique_address]] Background background_;
    distribution_options options_;
};

template <class A, lasting_range Things, lasting_range Lights>
distribution(const A&, Things&&, Lights&&)
    -> distribution<A, std::ranges::range_value_t<Things>, std::ranges::range_value_t<Lights>>;

template <class A, lasting_range Things, lasting_range Lights, background B>
distribution(const A&, Things&&, Lights&&, const B&, const distribution_options& = {})
    -> distribution<A, std::ranges::range_value_t<Things>, std::ranges::range_value_t<Lights>, B>;

}  // namespace lantern
