// SPDX-License-Identifier: MIT
// Lab 09's functions, bound to the student's. Its own types are made out of the contract's here, and the other way round.

#include "contract.hpp"

#include <lab09_bounding_volumes/bounding_volumes.hpp>

namespace lab09 {

namespace {

using namespace contract::lab09;
using lantern::interval;
using lantern::ray;

box own(const upright& b) { return {b.min, b.max}; }
sphere own(const contract::lab09::round& s) { return {s.center, s.radius}; }
oriented_box own(const tilted& b) { return {b.center, b.axes, b.half}; }
upright shown(const box& b) { return {b.min, b.max}; }
contract::lab09::round shown(const sphere& s) { return {s.center, s.radius}; }
tilted shown(const oriented_box& b) { return {b.center, b.axes, b.half}; }

/// A volume and a surface whose answers come from the suite.
struct asked_volume {
    const volume_says* answer;
    std::uint32_t index;
};
[[maybe_unused]] bool overlaps(const asked_volume& v, const ray& r, interval range) { return (*v.answer)(v.index, r, range); }

struct asked_surface {
    const surface_says* answer;
};
[[maybe_unused]] std::optional<lantern::hit> intersect(const asked_surface& s, const ray& r, interval range) { return (*s.answer)(r, range); }

}  // namespace

const contract::table lab{
    contract::bind<box_of_points>([](points p) { return shown(box_around(p)); }),
    contract::bind<box_of_sphere>([](contract::lab09::round s) { return shown(box_around(own(s))); }),
    contract::bind<box_of_boxes>([](upright a, upright b) { return shown(enclose(own(a), own(b))); }),
    contract::bind<area>([](volume v) { return std::visit([](const auto& one) -> double { return surface_area(own(one)); }, v); }),
    contract::bind<meets>([](std::span<const question> all) {
        std::vector<bool> answers;
        for (const question& q : all)
            answers.push_back(std::visit([&](const auto& one) -> bool { return overlaps(own(one), q.along, q.range); }, q.asked));
        return answers;
    }),
    contract::bind<sphere_of_points>([](points p) { return shown(sphere_around(p)); }),
    contract::bind<oriented_box_of_points>([](points p) { return shown(oriented_box_around(p)); }),
    contract::bind<transformed_box>([](glm::mat3 m, glm::vec3 shift, upright b) { return shown(transformed(m, shift, own(b))); }),
    contract::bind<transformed_sphere>([](glm::mat3 m, glm::vec3 shift, contract::lab09::round s) { return shown(transformed(m, shift, own(s))); }),
    contract::bind<smallest_sphere_of_points>([](points p) { return shown(smallest_sphere(p)); }),
    contract::bind<behind_one>([](const volume_says& v, const surface_says& s, ray r, interval range) {
        return intersect(bounded<asked_volume, asked_surface>{{&v, 0}, {&s}}, r, range);
    }),
    contract::bind<behind_two>([](const volume_says& v, const surface_says& s, ray r, interval range) {
        using inner = bounded<asked_volume, asked_surface>;
        return intersect(bounded<asked_volume, inner>{{&v, 0}, {{&v, 1}, {&s}}}, r, range);
    }),
};

}  // namespace lab09
