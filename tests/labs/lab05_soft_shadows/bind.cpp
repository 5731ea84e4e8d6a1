// SPDX-License-Identifier: MIT
// Lab 05's functions, bound to the student's; the student's own types are made here of the contract's.

#include "contract.hpp"

#include <lab05_soft_shadows/soft_shadows.hpp>

#include <utility>

namespace lab05 {

namespace asked = contract::lab05;

static lamp made_of(const asked::lamp& l) { return {l.corner, l.edge_u, l.edge_v, l.radiance}; }
static scene made_of(asked::scene s) { return {std::move(s.balls), std::move(s.walls)}; }

const contract::table lab{
    contract::bind<asked::point_on>([](asked::lamp l, glm::vec2 xi) { return point_on(made_of(l), xi); }),
    contract::bind<asked::irradiance>([](asked::lamp l, glm::vec3 on_lamp, glm::vec3 position, glm::vec3 normal) {
        return irradiance(made_of(l), on_lamp, position, normal);
    }),
    contract::bind<asked::visible>([](lantern::hit from, glm::vec3 on_lamp, asked::scene s) {
        return visible(from, on_lamp, made_of(std::move(s)));
    }),
    contract::bind<asked::soft_light>(
        [](asked::lamp l, lantern::hit at, asked::scene s, std::span<const glm::vec2> points) {
            return soft_light(made_of(l), at, made_of(std::move(s)), points);
        }),
    contract::bind<asked::solid_angle>(solid_angle),
    contract::bind<asked::towards_ball>(towards_ball),
};

}  // namespace lab05
