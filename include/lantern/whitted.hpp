// SPDX-License-Identifier: MIT
#pragma once
// The basic ray tracer (Whitted 1980): one sample for everything.

#include <lantern/alternative.hpp>
#include <lantern/closest.hpp>
#include <lantern/direct.hpp>
#include <lantern/light.hpp>
#include <lantern/material.hpp>
#include <lantern/ray.hpp>
#include <lantern/sky.hpp>
#include <lantern/surface.hpp>
#include <lantern/validate.hpp>
#include <lantern/validate_scene.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <ranges>
#include <span>

namespace lantern {

struct whitted_options {
    glm::vec3 ambient{0};         ///< light that comes evenly from everywhere, for what shadow rays cannot find
    std::uint32_t depth = 10;     ///< how many times a ray may be followed on
    float cutoff = 1.0f / 1024;   ///< a ray of which no more than this reaches the eye is not followed (Hall and Greenberg 1983)
};

/// One shadow ray for every point light, one reflection and, if necessary, one refraction ray at every intersection;
/// no random numbers. It looks at an acceleration structure, things (a shape with its `material`), lights and a
/// background; it owns none of them, and they must outlive it. `tracer(ray)` is the radiance along the ray.
template <class Accelerator, class Thing, class Light = point_light, background Background = darkness>
class whitted {
public:
    whitted(const Accelerator& structure, std::span<const Thing> things, std::span<const Light> lights,
            const Background& background = {}, const whitted_options& options = {})
        : structure_(&structure), things_(things), lights_(lights), background_(background), options_(options) {
        validate_scene(structure, things, lights, background);
        require_not_negative(options.ambient, "whitted: ambient");
        require_not_negative(options.cutoff, "whitted: cutoff");
    }
    whitted(const Accelerator&&, std::span<const Thing>, std::span<const Light>, const Background& = {},
            const whitted_options& = {}) = delete;  // a temporary would be gone before the first ray

    /// `render` offers a source of samples as well; the basic ray tracer has no use for it.
    template <std::derived_from<ray> Ray>
    [[nodiscard]] glm::vec3 operator()(const Ray& r, const auto&...) const {
        return radiance_along(r, glm::vec3(1), 0);
    }

private:
    template <class Ray>
    glm::vec3 radiance_along(const Ray& r, glm::vec3 weight, std::uint32_t depth) const {
        const auto h = closest(*structure_, things_, r);
        const glm::vec3 in = unit(r.direction);
        if (!h) return radiance(background_, in);
        return with_alternative(things_[h->index].material,
                                [&](const auto& m) { return shade(m, r, in, *h, weight, depth); });
    }

    template <class Material, class Ray>
    glm::vec3 shade(const Material& m, const Ray& r, glm::vec3 in, const hit& h, glm::vec3 weight,
                    std::uint32_t depth) const {
        static_assert(!scatters_by_sample<Material> && !scatters_by_two_samples<Material>,
                      "whitted draws no samples, and this material needs them; use distribution");
        glm::vec3 sum{0};
        if constexpr (emits<Material>) sum += emitted(m, in, h);
        if constexpr (reflects_ambient<Material>) sum += albedo(m, h) * options_.ambient;
        if constexpr (reflects_light<Material>) {
            for (const Light& l : lights_) {
                const illumination light =
                    with_alternative(l, [&](const auto& kind) { return illumination_from(kind, r, h.point); });
                sum += direct_light(*structure_, things_, r, in, h, m, light);
            }
        }
        if constexpr (specular<Material>) {
            for (const bounce& b : scatter(m, in, h)) {
                const glm::vec3 w = weight * b.weight;
                if (depth >= options_.depth || !(std::max({w.x, w.y, w.z}) > options_.cutoff)) continue;
                sum += b.weight * radiance_along(continued(r, leave(h, b.direction), b.direction), w, depth + 1);
            }
        }
        return sum;
    }

    template <class Kind, class Ray>
    static illumination illumination_from(const Kind& light, const Ray& r, glm::vec3 point) {
        static_assert(point_like<Kind> || moving_point_light<Kind>,
                      "whitted knows lights without extent only; use distribution for lights with area");
        if constexpr (point_like<Kind>) {
            return illuminate(light, point);
        } else {
            static_assert(std::derived_from<Ray, timed_ray>, "a moving light needs a camera with a shutter");
            return illuminate(light, point, r.time);
        }
    }

    const Accelerator* structure_;
    std::span<const Thing> things_;
    std::span<const Light> lights_;
    [[no_unique_address]] Background background_;
    whitted_options options_;
};

template <class A, lasting_range Things, lasting_range Lights>
whitted(const A&, Things&&, Lights&&)
    -> whitted<A, std::ranges::range_value_t<Things>, std::ranges::range_value_t<Lights>>;

template <class A, lasting_range Things, lasting_range Lights, background B>
whitted(const A&, Things&&, Lights&&, const B&, const whitted_options& = {})
    -> whitted<A, std::ranges::range_value_t<Things>, std::ranges::range_value_t<Lights>, B>;

}  // namespace lantern
