// SPDX-License-Identifier: MIT
#pragma once
// Lab 10's traversals: their questions are answered, checked and counted here, in trees of any shape and among balls.

#include "trees.hpp"

#include <catch.hpp>
#include <numbers.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace lab10_suite {

// ---- A traversal, interviewed --------------------------------------------------------------------------------------

/// A tree, and what a ray meets in it: where it enters the nodes' boxes and where it hits the surfaces.
struct situation {
    tree t;
    std::vector<std::optional<float>> entry, hit;
};

/// Answers a traversal's questions and notes what it should not have asked: the first time only, in words.
class interview {
public:
    interview(const situation& s, interval range) : s_(s), remaining_(range), parent_(s.t.nodes.size(), 0), leaf_(s.t.order.size(), 0),
                                                    asked_(s.t.nodes.size(), false), opened_(s.t.nodes.size(), false),
                                                    offered_(s.t.order.size(), false) {
        for (std::uint32_t i = 0; i < s.t.nodes.size(); ++i) {
            const node& n = s.t.nodes[i];
            if (n.count == 0) parent_[n.left] = parent_[n.right] = i;
            for (std::uint32_t k = n.first; k < n.first + n.count; ++k) leaf_[s.t.order[k]] = i;
        }
    }

    std::optional<float> enter(std::uint32_t at) {
        ++questions;
        count();
        if (at >= s_.t.nodes.size()) throw std::runtime_error("there is no node " + std::to_string(at));
        const std::string name = "node " + std::to_string(at);
        if (asked_[at]) say(twice, name + " is asked about twice");
        if (ended_) say(late, name + " is asked about after the end");
        if (at > 0) open(parent_[at], name);
        asked_[at] = true;
        return s_.entry[at];
    }

    interval offer(std::uint32_t surface, interval range) {
        const std::string name = "surface " + std::to_string(surface);
        consider(surface, name);
        if (!(range.min == remaining_.min && range.max == remaining_.max)) say(stale, name + " is offered a range that is not what remains");
        const auto t = s_.hit[surface];
        if (t && contains(remaining_, *t)) {
            if (!closest || *t < *closest || (*t == *closest && surface < which)) closest = t, which = surface;
            remaining_.max = *t;
            if (stops_at_first) remaining_ = {0, 0}, ended_ = true;
        }
        return remaining_;
    }

    bool blocks(std::uint32_t surface) {
        consider(surface, "surface " + std::to_string(surface));
        const auto t = s_.hit[surface];
        const bool blocked = t && contains(remaining_, *t);
        ended_ = ended_ || blocked;
        return blocked;
    }

    bool stops_at_first = false;
    std::string twice, missed, beyond, wrong_order, stale, late;
    std::uint64_t questions = 0, offers = 0;
    std::optional<float> closest;
    std::uint32_t which = 0;

private:
    static void say(std::string& where, const std::string& what) {
        if (where.empty()) where = what;
    }

    void count() const {
        if (questions + offers > 20 * s_.t.nodes.size() + 100) throw std::runtime_error("the traversal does not come to an end");
    }

    void consider(std::uint32_t surface, const std::string& name) {
        ++offers;
        count();
        if (surface >= offered_.size()) throw std::runtime_error("there is no " + name);
        if (offered_[surface]) say(twice, name + " is offered twice");
        if (ended_) say(late, name + " is offered after the end");
        open(leaf_[surface], name);
        offered_[surface] = true;
    }

    /// Somebody looks into a node.
    void open(std::uint32_t at, const std::string& name) {
        const std::string where = name + ", in node " + std::to_string(at);
        if (!asked_[at]) say(missed, where + ", which was not asked about");
        else if (!s_.entry[at]) say(missed, where + ", whose box the ray misses");
        else if (!ended_ && *s_.entry[at] > remaining_.max) say(beyond, where + ", whose box is entered beyond what remains");
        if (!opened_[at] && at > 0) {
            const node& p = s_.t.nodes[parent_[at]];
            const std::uint32_t other = p.left == at ? p.right : p.left;
            if (s_.entry[at] && s_.entry[other] && *s_.entry[other] < *s_.entry[at] && !opened_[other])
                say(wrong_order, "node " + std::to_string(at) + " is opened before node " + std::to_string(other) + ", which the ray enters first");
        }
        opened_[at] = true;
    }

    const situation& s_;
    interval remaining_;
    std::vector<std::uint32_t> parent_, leaf_;
    std::vector<bool> asked_, opened_, offered_;
    bool ended_ = false;
};

inline interview traversed(const situation& s, interval range = {}, bool stops_at_first = false) {
    interview seen(s, range);
    seen.stops_at_first = stops_at_first;
    traverse(s.t, range, [&](std::uint32_t at) { return seen.enter(at); },
             [&](std::uint32_t surface, interval rest) { return seen.offer(surface, rest); });
    return seen;
}

struct shadow {
    bool dark;
    interview seen;
};

inline shadow shadowed(const situation& s, interval range = {}) {
    interview seen(s, range);
    const bool dark = occluded(s.t, range, [&](std::uint32_t at) { return seen.enter(at); },
                               [&](std::uint32_t surface) { return seen.blocks(surface); });
    return {dark, seen};
}

/// Of all surfaces the one that is hit first, and of those at the same t the first in their order.
inline std::optional<std::uint32_t> first_of_all(const situation& s, interval range = {}) {
    std::optional<std::uint32_t> best;
    for (std::uint32_t i = 0; i < s.hit.size(); ++i)
        if (s.hit[i] && contains(range, *s.hit[i]) && (!best || *s.hit[i] < *s.hit[*best])) best = i;
    return best;
}

/// A tree of any shape, with t in whole numbers, so that ties abound: entries equal to hits, to each other, to the parents'.
inline situation made_up(numbers& random, std::uint32_t count) {
    situation s;
    const auto below = [&](std::uint32_t n) { return std::min(std::uint32_t(random.unit() * float(n)), n - 1); };
    const std::size_t leaf_size = 1 + below(3);
    s.t = grown(boxes(count), [&](const group& some) {
        halves parts = cut(some, 1 + below(std::uint32_t(some.size()) - 1));
        if (below(2) == 0) std::swap(parts.left, parts.right);
        return parts;
    }, leaf_size);
    s.hit.resize(count);
    for (auto& t : s.hit)
        if (below(3) == 0) t = float(3 + below(9));
    s.entry.resize(s.t.nodes.size());
    for (std::size_t i = s.t.nodes.size(); i-- > 0;) {
        const node& n = s.t.nodes[i];
        std::optional<float> nearest;
        const auto consider = [&](std::optional<float> t) {
            if (t && !(nearest && *nearest <= *t)) nearest = t;
        };
        for (std::uint32_t k = n.first; k < n.first + n.count; ++k) consider(s.hit[s.t.order[k]]);
        if (n.count == 0) consider(s.entry[n.left]), consider(s.entry[n.right]);
        if (nearest) s.entry[i] = std::max(*nearest - float(below(3)), 0.0f);
        else if (below(2) == 0) s.entry[i] = float(below(12));
    }
    return s;
}

/// Calls `check(situation)` for trees of any shape.
template <class Check>
inline void for_made_up(std::uint64_t seed, Check check) {
    numbers random(seed);
    for (std::uint32_t i = 0; i < 150; ++i) {
        const situation s = made_up(random, 1 + i % 40);
        INFO("a tree of " << s.t.nodes.size() << " nodes over " << s.hit.size() << " surfaces, number " << i);
        check(s);
    }
}

/// A chain: in every inner node one leaf, which the ray enters last, and the rest.
inline situation chain(std::uint32_t count) {
    situation s;
    s.t = grown(boxes(count), [&](const group& some) { return cut(some, some.size() - 1); }, 1);
    for (const node& n : s.t.nodes) s.entry.push_back(n.count > 0 ? 10.0f : 1.0f);
    s.hit.assign(count, 20.0f);
    return s;
}

// ---- Balls and rays ------------------------------------------------------------------------------------------------

struct ball {
    glm::vec3 center;
    float radius;
};

struct ray {
    glm::dvec3 origin, direction;
};

inline aabb bounds(const ball& b) {
    aabb box;
    for (int k = 0; k < 3; ++k) {
        box.min[k] = std::nextafter(b.center[k] - b.radius, -lantern::infinity);
        box.max[k] = std::nextafter(b.center[k] + b.radius, lantern::infinity);
    }
    return box;
}

inline std::optional<float> hit(const ball& b, const ray& r) {
    const glm::dvec3 from_center = r.origin - glm::dvec3(b.center);
    const double a = glm::dot(r.direction, r.direction), half_b = glm::dot(from_center, r.direction);
    const double discriminant = half_b * half_b - a * (glm::dot(from_center, from_center) - double(b.radius) * double(b.radius));
    if (!(discriminant >= 0)) return std::nullopt;
    for (const double t : {(-half_b - std::sqrt(discriminant)) / a, (-half_b + std::sqrt(discriminant)) / a})
        if (t > 0) return float(t);
    return std::nullopt;
}

/// Lab 09's slabs, in double, and a little early, so that no hit lies before the entry.
inline std::optional<float> entry(const aabb& box, const ray& r) {
    double near = 0, far = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
        const double d = r.direction[k], a = double(box.min[k]) - r.origin[k], b = double(box.max[k]) - r.origin[k];
        if (d == 0) {
            if (a > 0 || b < 0) return std::nullopt;
            continue;
        }
        near = std::max(near, std::min(a / d, b / d));
        far = std::min(far, std::max(a / d, b / d));
    }
    if (!(near <= far * (1 + 1e-12))) return std::nullopt;
    return float(near * (1 - 1e-6));
}

inline situation seen_along(const ray& r, const tree& t, const std::vector<ball>& balls) {
    situation s{t, {}, {}};
    for (const node& n : t.nodes) s.entry.push_back(entry(n.box, r));
    for (const ball& b : balls) s.hit.push_back(hit(b, r));
    return s;
}

/// `count` balls in the cube from -1 to 1, as large as to fill a twelfth of it.
inline std::vector<ball> ball_cloud(std::uint32_t count) {
    numbers random(1000);
    std::vector<ball> balls;
    for (std::uint32_t i = 0; i < count; ++i) balls.push_back({random.vector(), 0.54f / std::cbrt(float(count))});
    return balls;
}

inline boxes bounds(const std::vector<ball>& balls) {
    boxes all;
    for (const ball& b : balls) all.push_back(bounds(b));
    return all;
}

/// From a distance of 4 to a point in the cube.
inline ray into_the_cloud(numbers& random) {
    const glm::dvec3 origin = 4.0f * random.direction();
    return {origin, glm::dvec3(random.vector()) - origin};
}

}  // namespace lab10_suite
