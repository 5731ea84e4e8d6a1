// SPDX-License-Identifier: MIT
#pragma once
// What is true of cells and cuts, for lab 11's suites: boxes in double, and the stated cost of every cut, counted box by box.

#include "contract.hpp"

#include <glm/vec3.hpp>

#include <algorithm>
#include <limits>
#include <vector>

namespace truth {

using namespace contract::lab11;

struct cell_box {
    glm::dvec3 min, max;
};

inline cell_box wide(const aabb& box) { return {glm::dvec3(box.min), glm::dvec3(box.max)}; }

inline double area_of(const glm::dvec3& e) { return 2 * (e.x * e.y + e.y * e.z + e.z * e.x); }

/// The stated cost of a cut.
inline double cost_of(const aabb& cell, const std::vector<aabb>& boxes, const costs& c, int axis, float at) {
    double below = 0, above = 0;
    for (const aabb& box : boxes) {
        below += box.min[axis] < at || box.max[axis] <= at;
        above += box.max[axis] > at;
    }
    const glm::dvec3 whole = glm::dvec3(cell.max) - glm::dvec3(cell.min);
    glm::dvec3 lower = whole, upper = whole;
    lower[axis] = double(at) - double(cell.min[axis]);
    upper[axis] = double(cell.max[axis]) - double(at);
    const double b = below == 0 || above == 0 ? 1 - double(c.empty_bonus) : 1;
    return double(c.step) + b * double(c.test) * (area_of(lower) * below + area_of(upper) * above) / area_of(whole);
}

/// The least cost of all cuts at ends of boxes; infinite when there is none.
inline double least_cost(const aabb& cell, const std::vector<aabb>& boxes, const costs& c) {
    double least = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
        for (const aabb& box : boxes)
            for (const float at : {box.min[axis], box.max[axis]})
                if (at > cell.min[axis] && at < cell.max[axis]) least = std::min(least, cost_of(cell, boxes, c, axis, at));
    return least;
}

}  // namespace truth
