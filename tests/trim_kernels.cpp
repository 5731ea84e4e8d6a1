// SPDX-License-Identifier: MIT
// One picture by one kernel, for tests/checks/trim_cost.py, which counts instructions:
//     trim_kernels SCENE KERNEL SIDE
// SCENE is static, lens, motion, gloss, shadow or all. KERNEL is
//     trimmed      what lantern::trim makes of types that hold everything;
//     stripped     written out by hand for this one scene: no templates, no variants, no visitor, no effect that is not there;
//     everything   the types that hold everything, as they are.
// Prints a hash of all pixels, so that it can be seen that they are the same.

#include "trim_scene.hpp"

#include <lantern/closest.hpp>
#include <lantern/distribution.hpp>
#include <lantern/hash.hpp>
#include <lantern/samples.hpp>
#include <lantern/sky.hpp>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

using lantern::hit;
using lantern::interval;
using lantern::purpose;
using lantern::ray;
using lantern::sphere;
using lantern::timed_ray;
using source_type = lantern::pattern_source<lantern::independent>;

namespace {

constexpr lantern::sky evening{};
constexpr lantern::independent numbers{.samples = 4};

/// Runs one sample after the other. This function's instructions, and those of what it calls, are counted.
template <class Sample>
[[gnu::noinline, gnu::flatten]] std::uint64_t measured(std::uint32_t side, const Sample& sample) {
    std::uint64_t seen = 0;
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x)
            for (std::uint32_t i = 0; i < numbers.samples; ++i) {
                const source_type source = numbers.at({x, y}, i);
                const glm::vec2 film = (glm::vec2(x, y) + source.draw2(purpose::film)) / float(side);
                const glm::vec3 color = sample(film, source);
                seen = seen * 31 + std::bit_cast<std::uint32_t>(color.x) + std::bit_cast<std::uint32_t>(color.y) +
                       std::bit_cast<std::uint32_t>(color.z);
            }
    return seen;
}

template <class Structure, class Things, class Lights, class Camera>
std::uint64_t by_library(std::uint32_t side, const Structure& structure, const Things& things, const Lights& lights,
                         const Camera& cam) {
    const lantern::distribution tracer{structure, things, lights, evening, {.depth = trim_scene::depth}};
    return measured(side, [&](glm::vec2 film, const source_type& source) { return tracer(shoot(cam, film, source), source); });
}

// ---- by hand ----------------------------------------------------------------------------------------------------------

struct ball {
    sphere shape;
    glm::vec3 color{1};
    bool matt = true;
    float width = 0;
};
std::optional<hit> intersect(const ball& b, const ray& r, interval range) { return intersect(b.shape, r, range); }

struct rolling_ball : ball {
    glm::vec3 way{0};
};
std::optional<hit> intersect(const rolling_ball& b, const timed_ray& r, interval range) {
    if (b.way == glm::vec3(0)) return intersect(b.shape, r, range);
    return intersect(lantern::moving{b.shape, b.way}, r, range);
}

/// What a person writes who knows which effects the scene has; how many balls and lamps, what ambient light, how wide the aperture and
/// when the shutter is open, is no effect, and read at run time by all kernels. Each `if constexpr` is a line that is there or is not, in one of six programs.
template <bool Lens, bool Motion, bool Gloss, bool Soft>
struct stripped {
    using ray_type = std::conditional_t<Motion, timed_ray, ray>;
    using ball_type = std::conditional_t<Motion, rolling_ball, ball>;
    using lamp_type = std::conditional_t<Soft, lantern::sphere_light, lantern::point_light>;

    std::vector<ball_type> balls;
    std::vector<lamp_type> lamps;
    lantern::every all;
    glm::vec3 ambient{0};
    lantern::camera_frame frame;
    float aperture = 0, focus = 1;
    lantern::shutter exposure{};

    glm::vec3 lit(const ball& b, const ray_type& r, glm::vec3 in, const hit& h, const lantern::illumination& light) const {
        if (light.irradiance == glm::vec3(0)) return glm::vec3(0);
        const glm::vec3 out = lantern::unit(light.position - h.point);
        const glm::vec3 answer = evaluate(lantern::diffuse{b.color}, in, h, out) * light.irradiance;
        if (answer == glm::vec3(0)) return glm::vec3(0);
        const glm::vec3 origin = leave(h, out);
        return occluded(all, balls, continued(r, origin, light.position - origin), {0, 1}) ? glm::vec3(0) : answer;
    }

    glm::vec3 seen(const ray_type& r, const source_type& source, std::uint32_t bounce) const {
        const glm::vec3 in = lantern::unit(r.direction);
        const auto h = closest(all, balls, r);
        if (!h) return radiance(evening, in);
        const ball& b = balls[h->index];
        if (b.matt) {
            glm::vec3 sum = b.color * ambient;
            for (std::uint32_t i = 0; i < lamps.size(); ++i) {
                if constexpr (Soft) sum += lit(b, r, in, *h, illuminate(lamps[i], h->point, source.draw2(purpose::light, i)));
                else sum += lit(b, r, in, *h, illuminate(lamps[i], h->point));
            }
            return sum;
        }
        if (bounce == trim_scene::depth) return glm::vec3(0);
        glm::vec3 direction = lantern::mirrored(in, h->normal);
        if constexpr (Gloss) {
            if (b.width != 0)
                direction = lantern::folded(lantern::perturbed(direction, b.width, source.draw2(purpose::gloss)),
                                            lantern::facing(h->normal, in));
        }
        return b.color * seen(continued(r, leave(*h, direction), direction), source.branch(0), bounce + 1);
    }

    glm::vec3 operator()(glm::vec2 film, const source_type& source) const {
        glm::dvec3 start = frame.eye, direction = frame.towards(film);
        if constexpr (Lens) {
            const glm::vec2 a = aperture * lantern::to_disk(source.draw2(purpose::lens));
            const glm::dvec3 aside = double(a.x) * frame.right + double(a.y) * frame.up;
            start += aside;
            direction -= aside / double(focus);
        }
        const ray r{glm::vec3(start), glm::vec3(direction / glm::length(direction))};
        if constexpr (Motion) return seen({r, moment(exposure, source)}, source, 0);
        else return seen(r, source, 0);
    }
};

template <bool Lens, bool Motion, bool Gloss, bool Soft>
std::uint64_t by_hand(std::uint32_t side, const trim_scene::everything& s) {
    stripped<Lens, Motion, Gloss, Soft> kernel{.balls = {}, .lamps = {}, .all = {}, .frame = lantern::camera_frame(s.from)};
    for (const auto& o : s.things) {
        typename decltype(kernel)::ball_type b;
        if (const auto* still = std::get_if<sphere>(&o.shape.value)) b.shape = *still;
        if (const auto* moving = std::get_if<lantern::moving<sphere>>(&o.shape.value)) {
            b.shape = moving->surface;
            if constexpr (Motion) b.way = moving->displacement;
        }
        if (const auto* m = std::get_if<lantern::diffuse>(&o.material)) b.color = m->color;
        if (const auto* m = std::get_if<lantern::mirror>(&o.material)) b.color = m->color, b.matt = false;
        if (const auto* m = std::get_if<lantern::glossy>(&o.material)) b.color = m->color, b.matt = false, b.width = m->width;
        kernel.balls.push_back(b);
    }
    kernel.all.count = static_cast<std::uint32_t>(kernel.balls.size());
    for (const auto& l : s.lights) kernel.lamps.push_back(std::get<typename decltype(kernel)::lamp_type>(l));
    kernel.aperture = s.lens.radius;
    kernel.focus = s.lens.focus_distance;
    kernel.exposure = s.exposure;
    return measured(side, kernel);
}

std::uint64_t run(const std::string& scene, const std::string& kernel, std::uint32_t side) {
    const bool all = scene == "all";
    const trim_scene::effects on{.lens = all || scene == "lens", .motion = all || scene == "motion", .gloss = all || scene == "gloss", .soft = all || scene == "shadow"};
    const trim_scene::everything s = trim_scene::of(on);
    if (kernel == "trimmed")
        return trim(s, [&](const auto&... parts) { return by_library(side, parts...); });
    if (kernel == "everything")
        return by_library(side, lantern::every{4}, s.things, s.lights, lantern::camera{s.from, s.lens, s.exposure});
    if (kernel != "stripped") throw std::invalid_argument("there is no kernel " + kernel);
    if (scene == "static") return by_hand<false, false, false, false>(side, s);
    if (scene == "lens") return by_hand<true, false, false, false>(side, s);
    if (scene == "motion") return by_hand<false, true, false, false>(side, s);
    if (scene == "gloss") return by_hand<false, false, true, false>(side, s);
    if (scene == "shadow") return by_hand<false, false, false, true>(side, s);
    if (all) return by_hand<true, true, true, true>(side, s);
    throw std::invalid_argument("there is no scene " + scene);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc != 4) throw std::invalid_argument("trim_kernels SCENE KERNEL SIDE");
        std::printf("%016llx\n", static_cast<unsigned long long>(run(argv[1], argv[2], std::uint32_t(std::strtoul(argv[3], nullptr, 10)))));
        return 0;
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "trim_kernels: %s\n", problem.what());
        return 2;
    }
}
