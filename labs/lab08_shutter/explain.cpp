// SPDX-License-Identifier: MIT
// Lab 08's pictures, explained: ./lab explain 08, ./lab heat 08.

#include "../support/explain.hpp"
#include "pictures.hpp"

#include <lantern/render.hpp>

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {

constexpr glm::uvec2 size{720, 300};

support::figure figure_of(const lab08::moving_sphere& s) {
    return {"moving", {s.center.x, s.center.y, s.center.z, s.radius, s.velocity.x, s.velocity.y, s.velocity.z}};
}

/// The ray that was made as a shadow ray last, on this thread: it leads to the light at t = 1, and its time is the student's affair.
thread_local std::optional<lantern::ray> last_shadow;

/// The student's functions, heard.
stage::parts heard(stage::parts of) {
    of.shadow = [make = of.shadow](const lab08::timed_ray& r, glm::vec3 point, glm::vec3 light) {
        const lab08::timed_ray shadow = make(r, point, light);
        last_shadow = lantern::ray{shadow.origin, shadow.direction};
        return shadow;
    };
    of.intersect = [meet = of.intersect](const lab08::moving_sphere& s, const lab08::timed_ray& r) -> std::optional<float> {
        support::recorder* const to = support::recorder::listener();
        if (!to) return meet(s, r);
        const lantern::ray ray{r.origin, r.direction};
        const bool shadow = last_shadow && last_shadow->origin == r.origin && last_shadow->direction == r.direction;
        if (to->trick_on(ray) == support::recorder::trick::card) return shadow ? std::optional(0.5f) : std::nullopt;
        const auto h = support::tell(figure_of(s), ray, {0, shadow ? 1 : std::numeric_limits<float>::infinity()}, [&]() -> std::optional<lantern::hit> {
            const auto t = meet(s, r);
            if (!t) return std::nullopt;
            const glm::vec3 point = r.origin + *t * r.direction;
            return lantern::hit{.t = *t, .point = point, .normal = (point - s.center - r.time * s.velocity) / s.radius};
        }, r.time);
        return h ? std::optional(h->t) : std::nullopt;
    };
    return of;
}

/// Answers for the one ray that has a card in its way.
struct card {
    float light = 0;

    template <class Look>
    glm::vec3 operator()(const lab08::timed_ray& r, const Look& look) const {
        const support::recorder* const to = support::recorder::listener();
        const bool held = to && to->trick_on({r.origin, r.direction}) == support::recorder::trick::card;
        return held ? glm::vec3(light) : look();
    }
};

support::world world_of(const std::vector<stage::ball>& balls) {
    support::world w{.eye = {0, 1.9f, 9}, .lamps = {{support::ball_at(stage::lamp, 0), "the lamp"}}, .floor = 0.0f};
    static constexpr const char* names[]{"the red ball", "the blue ball", "the green ball", "the yellow ball", "the glass ball"};
    for (std::size_t i = 0; i < balls.size(); ++i)
        w.things.push_back({figure_of(balls[i].shape), names[i], balls[i].glass ? "glass" : balls[i].shape.velocity == glm::vec3(0) ? "polished" : "polished, moving", balls[i].color});
    w.things.push_back({support::level_at(0), "the floor", "polished, in squares", glm::vec3(0.3f)});
    return w;
}

support::subject subject(std::string name, std::uint32_t side, bool alone) {
    const stage::parts parts = heard({.alone = alone});
    const auto camera = std::make_shared<const lantern::camera<>>(stage::camera());
    const lantern::multi_jittered sampler{.side = side};
    const auto shade = std::make_shared<const stage::exposed<stage::nobody>>(stage::exposed<stage::nobody>{stage::eye<>(parts)});
    return {.name = std::move(name),
            .size = size,
            .samples = sampler.count(),
            .pixel = [=](glm::uvec2 at) { return lantern::render_pixel(at, size, *camera, sampler, *shade).mean(); },
            .sample = [=](glm::uvec2 at, std::uint32_t i) { return lantern::render_sample(at, size, *camera, sampler, i, *shade).color; },
            .with_card = [=](glm::uvec2 at, std::uint32_t i, float light) {
                return lantern::render_sample(at, size, *camera, sampler, i, stage::exposed<card>{stage::eye<card>(parts, card{light})}).color;
            },
            .world = world_of(stage::balls())};
}

std::vector<support::subject> subjects() { return {subject("lab08_4_whole.png", 6, false), subject("lab08_2_moving.png", 4, true)}; }

}  // namespace

int main(int argc, char** argv) { return support::explain(argc, argv, subjects); }
