// SPDX-License-Identifier: MIT
#pragma once
// What every light with area owes: the exact irradiance on average, and a shadow ray that its own surface does not block.

#include <lantern/light.hpp>
#include <lantern/ray.hpp>
#include <lantern/surface.hpp>

#include "catch.hpp"
#include "oracle.hpp"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cstdint>

/// The irradiance at a point with this normal: the mean of irradiance × cosine over the midpoints of side × side cells.
template <class Light>
double mean_irradiance(const Light& light, glm::vec3 point, glm::dvec3 normal, int side = 64) {
    double sum = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const glm::vec2 xi = (glm::vec2(x, y) + 0.5f) / float(side);
            const lantern::illumination i = illuminate(light, point, xi);
            const glm::dvec3 out = glm::normalize(glm::dvec3(i.position) - glm::dvec3(point));
            sum += std::max(0.0, glm::dot(normal, out)) * double(i.irradiance.x);
        }
    return sum / (double(side) * side);
}

/// Of shadow rays from random points of surfaces of size `reach` to the light, how many are blocked by the light's own surface.
template <class Light>
int blocked_by_itself(const Light& light, dice& d, float reach, int count) {
    int blocked = 0;
    for (int i = 0; i < count; ++i) {
        const lantern::hit h{1, d.in_cube(reach), glm::vec3(d.on_sphere()), 0};
        const glm::vec2 xi(d.unit(), d.unit());
        const lantern::illumination lit = illuminate(light, h.point, xi);
        if (lit.irradiance == glm::vec3(0)) continue;
        const glm::vec3 origin = leave(h, lantern::unit(lit.position - h.point));
        blocked += intersect(surface_of(light), lantern::ray{origin, lit.position - origin}, {0, 1}).has_value();
    }
    return blocked;
}
