// SPDX-License-Identifier: MIT
// Lab 12's functions, bound to the student's; the student's own types are made here of the contract's.

#include "contract.hpp"

#include <lab12_monte_carlo/monte_carlo.hpp>

#include <vector>

namespace lab12 {

namespace asked = contract::lab12;

static matter made_of(const asked::matter& m) { return {m.albedo, m.emission}; }
static scene made_of(const asked::scene& s) {
    scene result;
    for (const asked::ball& b : s.balls) result.balls.push_back({b.shape, made_of(b.upper), made_of(b.lower)});
    for (const asked::wall& w : s.walls) result.walls.push_back({w.shape, made_of(w.what)});
    result.lamp = s.lamp;
    return result;
}

const contract::table lab{
    contract::bind<asked::estimate>([](std::vector<asked::drawn> samples) {
        std::vector<drawn> all;
        for (const asked::drawn& d : samples) all.push_back({d.value, d.density});
        return estimate(all);
    }),
    contract::bind<asked::cosine_direction>(cosine_direction),
    contract::bind<asked::cosine_density>(cosine_density),
    contract::bind<asked::bounced>(bounced),
    contract::bind<asked::lamp_density>([](lantern::rectangle lamp, glm::vec3 on_lamp, glm::vec3 from) { return lamp_density(lamp, on_lamp, from); }),
    contract::bind<asked::from_lamp>([](asked::scene s, lantern::hit at, glm::vec3 albedo, glm::vec2 xi) {
        const lit l = from_lamp(made_of(s), found{at, matter{albedo, glm::vec3(0)}, false}, xi);
        return asked::lit{l.light, l.direction, l.density};
    }),
    contract::bind<asked::share>(share),
    contract::bind<asked::roulette>(roulette),
    contract::bind<asked::radiance>([](asked::scene s, std::vector<lantern::ray> rays, std::uint32_t count, std::uint64_t seed) {
        const scene all = made_of(s);
        std::vector<glm::vec3> seen;
        for (std::uint32_t i = 0; i < count; ++i) {
            numbers random(seed + i);
            seen.push_back(radiance(all, rays[i % rays.size()], random));
        }
        return seen;
    }),
};

}  // namespace lab12
