// SPDX-License-Identifier: MIT
#pragma once
// Long thin triangles are cut up before wide_bvh is built: their boxes hold next to nothing but air.

#include <lantern/aabb.hpp>
#include <lantern/triangle.hpp>
#include <lantern/wide_build.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lantern::wide {

/// The parts of a triangle at either side of a plane, as boxes.
struct halves {
    aabb low, high;
};

/// Cuts the part of a triangle that lies in a box across the middle of the box's longest side. Every point of that part is in one
/// of the two boxes: where an edge meets the plane is computed in double, wrong by less than 2^-49 of its ends' coordinates, and
/// moved outwards by that much before it is rounded outwards. Both are empty where nothing can be cut.
[[nodiscard]] inline halves cut_in_two(const triangle& t, const aabb& box) {
    const int axis = static_cast<int>(longest_axis(box));
    const float plane = 0.5f * box.min[axis] + 0.5f * box.max[axis];
    if (!(box.min[axis] < plane && plane < box.max[axis])) return {};
    halves h;
    const glm::vec3 corner[] = {t.a, t.b, t.c, t.a};
    for (int i = 0; i < 3; ++i) {
        const glm::vec3 &p = corner[i], &q = corner[i + 1];
        if (p[axis] <= plane) h.low = enclose(h.low, p);
        if (p[axis] >= plane) h.high = enclose(h.high, p);
        if ((p[axis] < plane) == (q[axis] < plane)) continue;
        const glm::dvec3 from(p), to(q);
        const double s = (double(plane) - from[axis]) / (to[axis] - from[axis]);
        const glm::dvec3 at = from + s * (to - from), margin = 0x1p-49 * (glm::abs(from) + glm::abs(to));
        aabb crossing = enclosing(at - margin, at + margin);
        crossing.min[axis] = crossing.max[axis] = plane;
        h.low = enclose(h.low, crossing);
        h.high = enclose(h.high, crossing);
    }
    for (aabb* part : {&h.low, &h.high}) *part = {glm::max(part->min, box.min), glm::min(part->max, box.max)};
    if (empty(h.low) || empty(h.high)) return {};
    return h;
}

/// The long thin triangles among those that a tree is built over.
class needles {
public:
    /// `i` is the next item: the box of a whole triangle.
    void add(const triangle& t, const item& i) {
        const double area = half_area(i);
        area_ += area;
        // Twice the area of a triangle of good shape is at least an eighth of this. A needle's is next to nothing, unless it lies along an axis;
        // then its box fits, too.
        const glm::dvec3 n = glm::cross(glm::dvec3(t.b) - glm::dvec3(t.a), glm::dvec3(t.c) - glm::dvec3(t.a));
        if (area * area > 64 * glm::dot(n, n)) found_.push_back(count_);
        ++count_;
    }

    /// Adds all that was added to `later`, as if it came next.
    void append(const needles& later) {
        for (const std::uint32_t i : later.found_) found_.push_back(count_ + i);
        area_ += later.area_;
        count_ += later.count_;
    }

    /// To be called when all are added: forgets those with small boxes. Returns how many are left, or 0 where they have less than a
    /// tenth of the surface of all boxes: then they do not matter.
    [[nodiscard]] std::size_t count(const item_list& items) {
        double sum = 0;
        std::erase_if(found_, [&](std::uint32_t i) {
            const double area = half_area(items[i]);
            if (area < 0.2 * mean()) return true;
            sum += area;
            return false;
        });
        if (sum < 0.1 * area_) found_.clear();
        return found_.size();
    }

    /// Cuts where that takes most away from the surface of all boxes, again and again, at most `most` times (early split clipping,
    /// Ernst and Greiner 2007; in an order like that of Karras and Aila 2013). A cut item keeps the lower part, and a new one, at the end,
    /// gets the upper. The items are those that were added; `triangle_of(index)` is their triangle.
    void cut(item_list& items, const auto& triangle_of, std::size_t most) const {
        items.reserve(items.size() + most);
        std::vector<plan> plans;
        std::vector<halves> cuts;  // beside the heap, which moves its entries about
        // Planned only if the parts have much less surface than the whole: needles' have half of it, and what has a good shape keeps
        // three quarters. What is won must be a tenth of an average box, too.
        const auto consider = [&](std::size_t which) {
            const item& i = items[which];
            const double area = half_area(i), least = std::max(0.3 * area, 0.1 * mean());
            if (!(area > least)) return false;
            const halves parts = cut_in_two(triangle_of(i.index), {i.lower, i.upper});
            const double gain = area - 0.5 * (surface_area(parts.low) + surface_area(parts.high));
            if (empty(parts.low) || !(gain > least)) return false;
            plans.push_back({gain, static_cast<std::uint32_t>(which), static_cast<std::uint32_t>(cuts.size())});
            cuts.push_back(parts);
            return true;
        };
        for (const std::uint32_t i : found_) (void)consider(i);
        std::ranges::make_heap(plans, later);
        for (; most > 0 && !plans.empty(); --most) {
            std::ranges::pop_heap(plans, later);
            const plan p = plans.back();
            plans.pop_back();
            const std::uint32_t index = items[p.which].index;
            const auto [low, high] = cuts[p.cut];
            items[p.which] = {low.min, index, low.max, 0};
            items.push_back({high.min, index, high.max, 0});
            for (const std::size_t i : {std::size_t{p.which}, items.size() - 1})
                if (consider(i)) std::ranges::push_heap(plans, later);
        }
    }

private:
    struct plan {
        double gain;
        std::uint32_t which, cut;
    };

    // The largest gain first; of equal ones the first item, so that the order is always the same.
    static bool later(const plan& p, const plan& q) { return p.gain < q.gain || (p.gain == q.gain && p.which > q.which); }

    // Half the surface. In double, for squares of floats overflow.
    static double half_area(const item& i) { return 0.5 * surface_area(aabb{i.lower, i.upper}); }

    [[nodiscard]] double mean() const { return area_ / count_; }

    double area_ = 0;
    std::uint32_t count_ = 0;
    std::vector<std::uint32_t> found_;
};

}  // namespace lantern::wide
