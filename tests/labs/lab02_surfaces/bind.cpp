// SPDX-License-Identifier: MIT
// Lab 02's functions, bound to the student's.

#include "contract.hpp"

#include <lab02_surfaces/surfaces.hpp>

#include <span>
#include <vector>

namespace lab02 {

namespace {

using lantern::interval;
using lantern::ray;

/// A surface whose answers come from the suite.
struct asked {
    const contract::lab02::surfaces* answer;
    std::uint32_t index;
};

[[maybe_unused]] std::optional<lantern::hit> intersect(const asked& s, const ray&, interval range) { return (*s.answer)(s.index, range); }

std::optional<contract::lab02::nearest> closest_of(std::uint32_t count, const contract::lab02::surfaces& answer, interval range) {
    std::vector<asked> all;
    for (std::uint32_t i = 0; i < count; ++i) all.push_back({&answer, i});
    const auto found = closest(std::span<const asked>(all), ray{}, range);
    if (!found) return std::nullopt;
    return contract::lab02::nearest{found->at, found->index};
}

}  // namespace

const contract::table lab{
    contract::bind<contract::lab02::intersect_sphere>(
        [](glm::vec3 center, float radius, const ray& r, interval range) { return intersect(sphere{center, radius}, r, range); }),
    contract::bind<contract::lab02::intersect_plane>(
        [](glm::vec3 point, glm::vec3 normal, const ray& r, interval range) { return intersect(plane{point, normal}, r, range); }),
    contract::bind<contract::lab02::intersect_triangle>([](glm::vec3 a, glm::vec3 b, glm::vec3 c, const ray& r, interval range) {
        return intersect(triangle{a, b, c}, r, range);
    }),
    contract::bind<contract::lab02::closest>(closest_of),
};

}  // namespace lab02
