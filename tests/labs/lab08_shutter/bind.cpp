// SPDX-License-Identifier: MIT
// Lab 08's functions, bound to the student's. Its own types are made out of the contract's here, and the other way round.

#include "contract.hpp"

#include <lab08_shutter/shutter.hpp>

using namespace contract::lab08;  // found only where the student's header lacks the name

namespace lab08 {

namespace {

timed_ray own(const ray_then& r) { return {r.origin, r.direction, r.time}; }
moving_sphere own(const ball& s) { return {s.center, s.velocity, s.radius}; }
ray_then shown(const timed_ray& r) { return {r.origin, r.direction, r.time}; }

}  // namespace

const contract::table lab{
    contract::bind<contract::lab08::moment>(moment),
    contract::bind<contract::lab08::intersect>([](ball s, ray_then r) { return intersect(own(s), own(r)); }),
    contract::bind<contract::lab08::bounds>([](ball s, float open, float close) { return bounds(own(s), open, close); }),
    contract::bind<contract::lab08::shadow_ray>([](ray_then r, glm::vec3 point, glm::vec3 light) { return shown(shadow_ray(own(r), point, light)); }),
    contract::bind<contract::lab08::reflected_ray>([](ray_then r, glm::vec3 point, glm::vec3 normal) { return shown(reflected_ray(own(r), point, normal)); }),
    contract::bind<contract::lab08::refracted_ray>([](ray_then r, glm::vec3 point, glm::vec3 normal, float eta) {
        const auto on = refracted_ray(own(r), point, normal, eta);
        return on ? std::optional(shown(*on)) : std::nullopt;
    }),
    contract::bind<contract::lab08::times>(times),
    contract::bind<contract::lab08::covered>(covered),
};

}  // namespace lab08
