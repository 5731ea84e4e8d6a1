// SPDX-License-Identifier: MIT
#pragma once
// Integrals over the hemisphere about (0, 0, 1), for tests of materials.

#include <glm/vec3.hpp>

#include <cmath>
#include <numbers>

/// The unit vector at an angle from (0, 0, 1), radians.
inline glm::vec3 tilted(double angle, double around = 0) {
    return glm::vec3(glm::dvec3(std::sin(angle) * std::cos(around), std::sin(angle) * std::sin(around), std::cos(angle)));
}

/// The integral of f(direction) over solid angle, by midpoints in both angles.
template <class F>
double over_hemisphere(const F& f, int steps = 600) {
    double sum = 0;
    const double step = std::numbers::pi / 2 / steps;
    for (int i = 0; i < steps; ++i) {
        const double angle = (i + 0.5) * step;
        for (int j = 0; j < 2 * steps; ++j)
            sum += std::sin(angle) * f(tilted(angle, (j + 0.5) * std::numbers::pi / steps));
    }
    return sum * step * std::numbers::pi / steps;
}
