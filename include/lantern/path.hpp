// SPDX-License-Identifier: MIT
#pragma once
// Path tracing (Kajiya 1986): the full ray tracer. Every surface is lit by all others, and every path is one ray wide.

#include <lantern/alternative.hpp>
#include <lantern/closest.hpp>
#include <lantern/direct.hpp>
#include <lantern/emitters.hpp>
#include <lantern/light.hpp>
#include <lantern/lobe.hpp>
#include <lantern/material.hpp>
#include <lantern/ray.hpp>
#include <lantern/samples.hpp>
#include <lantern/sky.hpp>
#include <lantern/surface.hpp>
#include <lantern/validate_scene.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <ranges>
#include <span>

namespace lantern {

/// How the light of a lamp is looked for that shadow rays and scattered rays can both find. All three have the same mean.
enum class strategy {
    both,       ///< in both ways, each weighed by how well it does (Veach 1997): the one to use
    lights,     ///< by shadow rays alone: noise where a lamp is close, or a lobe narrow
    materials,  ///< by scattered rays alone: noise where a lamp is small
};

struct path_options {
    std::uint32_t depth = std::numeric_limits<std::uint32_t>::max();  ///< how often light may be scattered on its way: 0 shows what shines, 1 direct light
    std::uint32_t roulette = 3;  ///< after so many bounces chance decides whether a path goes on
    strategy light_search = strategy::both;
};

/// The share of a strategy of density `mine` where another one could have drawn the same with density `other`:
/// mine² / (mine² + other²), the power heuristic (Veach 1997, section 9.2.4). The shares of both add up to 1. An infinite
/// density, as a point light has it, takes all.
[[nodiscard]] inline double power_heuristic(double mine, double other) {
    if (!(mine > 0)) return 0;
    const double ratio = other / mine;
    return 1 / (1 + ratio * ratio);
}

/// One path for every sample. At a hit every lamp gets a shadow ray as long as the path came straight from the eye or by way of
/// mirrors, and one lamp by chance later on; then one ray goes on, chosen among what the material scatters to. After some bounces
/// a path goes on with a probability equal to what it still carries, and is divided by it: so it carries no more than 1 (but for 2^-14
/// a bounce where nothing is absorbed), it ends, and no light is lost. Purposes: `light`, `gloss`, `branch` as in `distribution`;
/// `scatter`, `light_choice`, `roulette`. It looks at an acceleration structure, things, lights and a background; it owns none, and they
/// must outlive it.
template <class Accelerator, class Thing, class Light, background Background = darkness>
class path {
public:
    path(const Accelerator& structure, std::span<const Thing> things, std::span<const Light> lights,
         const Background& background = {}, const path_options& options = {})
        : structure_(&structure), things_(things), lights_(lights), background_(background), options_(options),
          emitters_(things, lights) {
        validate_scene(structure, things, lights, background);
    }
    path(const Accelerator&&, std::span<const Thing>, std::span<const Light>, const Background& = {},
         const path_options& = {}) = delete;  // a temporary would be gone before the first ray

    /// The radiance along the ray: one sample of it. `numbers` is the sample's source.
    template <std::derived_from<ray> Ray, sample_source Source>
    [[nodiscard]] glm::vec3 operator()(const Ray& r, const Source& numbers) const {
        glm::vec3 sum{0};
        stretch<Ray> now{r};
        Source source = numbers;
        for (std::uint32_t depth = 0;; ++depth) {
            const auto h = closest(*structure_, things_, now.r);
            const glm::vec3 in = unit(now.r.direction);
            if (!h) return sum + now.carried * radiance(background_, in);
            const auto next = with_alternative(things_[h->index].material, [&](const auto& m) {
                return meet(m, now, in, *h, source, depth, sum);
            });
            if (!next) return sum;
            now = *next;
            source = source.branch(now.which);
        }
    }

private:
    /// A path's last stretch, and what the next vertex must know of how it came about.
    template <class Ray>
    struct stretch {
        Ray r;
        glm::vec3 carried{1};  // what the eye gets of the radiance along r
        glm::vec3 from{0};     // the vertex that it left
        double density = 0;    // of its direction there; 0 when it came from the camera or a sharp reflection
        float light_chance = 1;  // of a light to be asked there
        std::uint32_t which = 0;
    };

    /// Adds what is seen at a vertex, by itself and lit by lights; the next stretch, or nothing at the end of the path.
    template <class Material, class Ray, class Source>
    std::optional<stretch<Ray>> meet(const Material& m, const stretch<Ray>& now, glm::vec3 in, const nearest& h,
                                     const Source& source, std::uint32_t depth, glm::vec3& sum) const {
        if constexpr (emits<Material>) sum += now.carried * share_found(now, h) * emitted(m, in, h);
        if constexpr (reflects_light<Material> || scatters<Material>) {
            if (depth >= options_.depth) return std::nullopt;
            bounces rays;
            if constexpr (scatters<Material>) rays = scattered(m, in, h, source);
            const float coat = chance_to_scatter<Material>(rays);
            const std::uint32_t count = static_cast<std::uint32_t>(lights_.size());
            const bool all = now.density == 0 || count < 2;
            if constexpr (reflects_light<Material> || has_lobe<Material>) {
                if (all) {
                    for (std::uint32_t i = 0; i < count; ++i) sum += now.carried * lit(m, now.r, in, h, coat, i, 1, source);
                } else {
                    const auto i = static_cast<std::uint32_t>(double(source.draw1(purpose::light_choice)) * count);
                    sum += now.carried * lit(m, now.r, in, h, coat, i, 1 / float(count), source);
                }
            }
            auto next = gone_on(m, now, in, h, rays, coat, source);
            if (!next) return std::nullopt;
            next->light_chance = all ? 1 : 1 / float(count);
            if (depth + 1 >= options_.roulette) {
                const float survival = std::min(largest(next->carried), most_likely);
                if (!(source.draw1(purpose::roulette) < survival)) return std::nullopt;
                next->carried /= survival;
            }
            return next;
        } else {
            return std::nullopt;
        }
    }

    /// Of light that a ray has found: its share, when a shadow ray might have found it as well.
    template <class Ray>
    float share_found(const stretch<Ray>& now, const nearest& h) const {
        if constexpr (may_have_body<Light>) {
            if (now.density == 0) return 1;
            const auto light = emitters_.light_of(h.index);
            if (!light) return 1;
            const double drawn = double(now.light_chance) * with_alternative(lights_[*light], [&](const auto& kind) {
                return density_of(kind, now.r, now.from, h.point);
            });
            switch (options_.light_search) {
                case strategy::lights: return drawn > 0 ? 0 : 1;
                case strategy::materials: return 1;
                case strategy::both: break;
            }
            return static_cast<float>(power_heuristic(now.density, drawn));
        } else {
            return 1;
        }
    }

    /// What light i adds, asked with the given chance. Its share is weighed for the body of the material and for its lobe,
    /// each against the density with which its own rays find this light.
    template <class Material, class Ray, class Source>
    glm::vec3 lit(const Material& m, const Ray& r, glm::vec3 in, const hit& h, float coat, std::uint32_t i, float chance,
                  const Source& source) const {
        return with_alternative(lights_[i], [&](const auto& kind) {
            const illumination light = illumination_from(kind, i, r, h.point, source);
            if (light.irradiance == glm::vec3(0)) return glm::vec3(0);
            const glm::vec3 out = unit(light.position - h.point);
            const bool two_ways = emitters_.has_body(i);
            const double drawn = two_ways ? double(chance) * density_of(kind, r, h.point, light.position) : 0;
            const auto share = [&](double other) -> double {
                if (!two_ways || options_.light_search == strategy::lights) return 1;
                return options_.light_search == strategy::both ? power_heuristic(drawn, other) : 0;
            };
            glm::dvec3 answer{0};
            if constexpr (reflects_light<Material>)
                answer += share(double(1 - coat) * direction_density(m, in, h, out)) * glm::dvec3(evaluate(m, in, h, out));
            if constexpr (has_lobe<Material>) {
                const response to = lobe(m, in, h, out);
                answer += share(double(coat) * to.density) * glm::dvec3(to.value);
            }
            const glm::vec3 arrived(answer * glm::dvec3(light.irradiance) / double(chance));
            if (arrived == glm::vec3(0) || shadowed(*structure_, things_, r, h, out, light.position)) return glm::vec3(0);
            return arrived;
        });
    }

    /// One ray for all that the material scatters: by chance one of `rays`, or a direction for what `evaluate` answers.
    template <class Material, class Ray, class Source>
    static std::optional<stretch<Ray>> gone_on(const Material& m, const stretch<Ray>& now, glm::vec3 in, const hit& h,
                                               const bounces& rays, float coat, const Source& source) {
        glm::vec3 direction{0}, weight{0};
        double density = 0;
        std::uint32_t which = 0;
        bool body = !scatters<Material>;
        if constexpr (reflects_light<Material> && scatters<Material>)
            body = coat == 0 || !(source.draw1(purpose::branch, 1) < coat);
        if constexpr (reflects_light<Material>) {
            if (body) {
                direction = drawn_direction(m, in, h, source.draw2(purpose::scatter));
                density = direction_density(m, in, h, direction);
                if (!(density > 0)) return std::nullopt;
                density *= double(1 - coat);
                weight = glm::vec3(glm::dvec3(evaluate(m, in, h, direction)) / density);
            }
        }
        if constexpr (scatters<Material>) {
            if (!body) {
                const float first = chance_of_first(rays);
                if (first == 0 && rays.size() < 2) return std::nullopt;
                which = first == 1 || (first > 0 && source.draw1(purpose::branch) < first) ? 0 : 1;
                direction = rays[which].direction;
                weight = rays[which].weight / (coat * (which == 0 ? first : 1 - first));
                if constexpr (has_lobe<Material>) density = double(coat) * lobe(m, in, h, direction).density;
            }
        }
        const glm::vec3 carried = now.carried * weight;
        if (!(largest(carried) > 0)) return std::nullopt;  // what is black is not followed
        return stretch<Ray>{continued(now.r, leave(h, direction), direction), carried, h.point, density, 1, which};
    }

    /// The chance that a ray of `scatter` is followed and none for `evaluate`: what those rays carry, but never all.
    template <class Material>
    static float chance_to_scatter(const bounces& rays) {
        if constexpr (!scatters<Material>) return 0;
        else if constexpr (!reflects_light<Material>) return 1;
        float carried = 0;
        for (const bounce& b : rays) carried += largest(b.weight);
        return std::min(carried, 15.0f / 16);
    }

    template <class Kind, class Ray>
    static double density_of(const Kind& light, const Ray& r, glm::vec3 from, glm::vec3 position) {
        if constexpr (requires { density(light, from, position, r.time); }) return density(light, from, position, r.time);
        else if constexpr (requires { density(light, from, position); }) return density(light, from, position);
        else return 0;
    }

    static constexpr float most_likely = 1 - 0x1p-14f;  // so that a path ends where nothing is ever absorbed

    const Accelerator* structure_;
    std::span<const Thing> things_;
    std::span<const Light> lights_;
    [[no_unique_address]] Background background_;
    path_options options_;
    emitters emitters_;
};

template <class A, lasting_range Things, lasting_range Lights>
path(const A&, Things&&, Lights&&) -> path<A, std::ranges::range_value_t<Things>, std::ranges::range_value_t<Lights>>;

template <class A, lasting_range Things, lasting_range Lights, background B>
path(const A&, Things&&, Lights&&, const B&, const path_options& = {})
    -> path<A, std::ranges::range_value_t<Things>, std::ranges::range_value_t<Lights>, B>;

}  // namespace lantern
