// SPDX-License-Identifier: MIT
#pragma once
// Lab 10's pictures: the program shows them with the student's code, the handout with ours.

#include "page.hpp"
#include "scene.hpp"

#include <lantern/box.hpp>
#include <lantern/hash.hpp>
#include <lantern/image.hpp>
#include <lantern/moving.hpp>
#include <lantern/render.hpp>
#include <lantern/samples.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace pictures {

using lantern::aabb;
using stage::balls;
using group = std::vector<std::uint32_t>;
/// How a group is divided: at_median, at_middle or at_least_cost.
using divider = std::function<lab10::halves(std::span<const aabb>, std::span<const std::uint32_t>)>;

inline group all_of(std::size_t count) {
    group g(count);
    std::iota(g.begin(), g.end(), 0u);
    return g;
}

/// The colours of a flake's nine parts, of so many balls each; the ball in the middle is grey.
inline glm::vec3 color_of_part(std::uint32_t i, std::uint32_t balls_each) { return i == 0 ? glm::vec3(0.5f) : color_of((i - 1) / balls_each); }

/// Surfaces on their floor, surface i in the colour paint(i), found by the library; and frames around them.
template <class Surface, class Paint>
lantern::image seen(const std::vector<Surface>& all, float floor, const lantern::camera<>& cam, glm::uvec2 size, Paint paint,
                    const std::vector<frame>& frames = {}, std::uint32_t side = 2) {
    const lantern::bvh<> tree(all);
    return lantern::render(size, cam, lantern::multi_jittered{.side = side}, [&](const lantern::ray& r, const auto&) {
        const auto h = closest(tree, all, r);
        const auto ground = h ? std::nullopt : stage::on_floor(r, floor);
        const float t = h ? h->t : ground ? ground->t : lantern::infinity;
        if (const auto edge = on_edge(frames, r, t)) return *edge;
        if (!h && !ground) return stage::sky(r);
        const lantern::hit& point = h ? *h : *ground;
        const bool dark = occluded(tree, all, stage::to_lamp(point), lantern::interval{0, 1});
        return stage::lit(point, h ? paint(h->index) : glm::vec3(0.45f), dark);
    });
}

/// The four ways to build a tree, as the library calls them, and their colours in plots.
struct kind {
    lantern::split rule;
    glm::vec3 color;
};
inline std::vector<kind> kinds() {
    return {{lantern::split::median, {0.75f, 0.1f, 0.08f}}, {lantern::split::middle, {0.85f, 0.55f, 0.05f}},
            {lantern::split::surface_area, {0.08f, 0.3f, 0.75f}}, {lantern::split::bottom_up, {0.1f, 0.5f, 0.15f}}};
}

// ---- Step 1 --------------------------------------------------------------------------------------------------------

/// The flake in its box, and the nine smaller ones of which it is made in theirs.
inline lantern::image groups(glm::uvec2 size) {
    const balls all = stage::flake(3);
    const std::vector<aabb> boxes = lantern::boxes_of(all);
    std::vector<frame> frames{{lab10::box_around(boxes, all_of(all.size())), glm::vec3(1)}};
    for (std::uint32_t i = 0; i < 9; ++i) {
        group g(91);
        std::iota(g.begin(), g.end(), 1 + 91 * i);  // as add_flake numbers them
        frames.push_back({lab10::box_around(boxes, g), 1.3f * color_of(i) + 0.1f});
    }
    const auto paint = [](std::uint32_t i) { return color_of_part(i, 91); };
    return seen(all, stage::floor_height, stage::camera(size), size, paint, frames);
}

// ---- Steps 2 and 4 -------------------------------------------------------------------------------------------------

/// The galaxy, divided so many times: each of the groups in its own colour, in its own frame.
inline lantern::image divided(glm::uvec2 size, const divider& divide, unsigned times) {
    const balls all = stage::galaxy();
    const std::vector<aabb> boxes = lantern::boxes_of(all);
    std::vector<group> groups{all_of(all.size())};
    for (unsigned i = 0; i < times; ++i) {
        std::vector<group> next;
        for (const group& g : groups) {
            if (g.size() < 2) {
                next.push_back(g);
                continue;
            }
            lab10::halves parts = divide(boxes, g);
            next.push_back(std::move(parts.left));
            next.push_back(std::move(parts.right));
        }
        groups = std::move(next);
    }
    std::vector<std::size_t> group_of(all.size());
    std::vector<frame> frames;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        aabb box;
        for (const std::uint32_t k : groups[i]) group_of[k] = i, box = enclose(box, boxes[k]);
        frames.push_back({box, 1.2f * color_of(i) + 0.15f});
    }
    return seen(all, stage::galaxy_floor, stage::from_above(size), size, [&](std::uint32_t i) { return color_of(group_of[i]); }, frames);
}

/// Three times, at the median and in the middle.
inline lantern::image median_and_middle(glm::uvec2 size) {
    return table({divided(size, lab10::at_median, 3), divided(size, lab10::at_middle, 3)}, 2);
}

/// Once, twice, three times.
inline lantern::image divided_thrice(glm::uvec2 size, const divider& divide) {
    return table({divided(size, divide, 1), divided(size, divide, 2), divided(size, divide, 3)}, 3);
}

/// What trees cost, as the student's function says: of the library's trees over the flake, the galaxy and a cloud of equal balls, each a group
/// of bars, at the median (red), in the middle (yellow), at the least cost (blue) and from the bottom up (green).
inline lantern::image costs() {
    constexpr unsigned width = 720, bar = 16;
    balls cloud;
    const auto unit = [](std::uint32_t i, std::uint32_t which) { return lantern::to_unit(lantern::low(lantern::hash(i, which))); };
    for (std::uint32_t i = 0; i < 800; ++i) cloud.push_back({2.0f * glm::vec3(unit(i, 0), unit(i, 1), unit(i, 2)) - 1.0f, 0.06f});
    lantern::image page({width, 3 * (4 * bar + 24) + 12}, glm::vec3(1));
    unsigned y = 18;
    for (const balls& all : {stage::flake(3), stage::galaxy(), cloud}) {
        for (const kind& k : kinds()) {
            const double cost = lab10::cost(stage::library_tree(all, k.rule));
            const auto length = std::min(unsigned(8 * cost), width - 80);
            for (unsigned x = 0; x < length; ++x)
                for (unsigned line = 0; line < bar - 2; ++line) page(12 + x, y + line) = k.color;
            write_number(page, {float(length + 20), float(y) + 1}, unsigned(std::lround(cost)), 6, glm::vec3(0));
            y += bar;
        }
        y += 24;
    }
    return page;
}

// ---- Steps 3 and 5 -------------------------------------------------------------------------------------------------

/// Some nodes' boxes, solid.
inline lantern::image solid(glm::uvec2 size, const lab10::tree& t, const std::vector<std::uint32_t>& nodes) {
    std::vector<lantern::box> boxes;
    for (const std::uint32_t i : nodes) {
        const float inset = 5e-4f * float(boxes.size() % 8);  // of two faces in the same place one is to be seen, not a bit of each
        boxes.push_back({t.nodes[i].box.min + inset, t.nodes[i].box.max - inset});
    }
    return seen(boxes, stage::floor_height, stage::camera(size), size, [](std::uint32_t i) { return color_of(i); });
}

/// The nodes at a depth, and the leaves above it.
inline std::vector<std::uint32_t> at_depth(const lab10::tree& t, unsigned depth) {
    std::vector<std::uint32_t> nodes{0};
    for (unsigned i = 0; i < depth; ++i) {
        std::vector<std::uint32_t> next;
        for (const std::uint32_t at : nodes) {
            const lab10::node& n = t.nodes[at];
            if (n.count > 0) next.push_back(at);
            else next.insert(next.end(), {n.left, n.right});
        }
        nodes = std::move(next);
    }
    return nodes;
}

/// So many nodes that hold everything: beginning with the root, the largest is opened each time.
inline std::vector<std::uint32_t> opened(const lab10::tree& t, std::size_t number) {
    std::vector<std::uint32_t> nodes{0};
    while (nodes.size() < number) {
        const auto size = [&](std::uint32_t at) { return t.nodes[at].count > 0 ? -1 : surface_area(t.nodes[at].box); };
        const auto largest = std::max_element(nodes.begin(), nodes.end(), [&](std::uint32_t a, std::uint32_t b) { return size(a) < size(b); });
        const lab10::node& n = t.nodes[*largest];
        if (n.count > 0) break;
        *largest = n.left;
        nodes.push_back(n.right);
    }
    return nodes;
}

/// Six levels of the tree from the top down.
inline lantern::image levels(glm::uvec2 size) {
    const std::vector<aabb> boxes = lantern::boxes_of(stage::flake(3));
    // In the order in which add_flake makes the balls, neighbours in the list are neighbours in space.
    const lab10::tree t = lab10::build(boxes, [](std::span<const std::uint32_t> g) {
        const auto half = g.begin() + std::ptrdiff_t(g.size() / 2);
        return lab10::halves{{g.begin(), half}, {half, g.end()}};
    }, 1);
    std::vector<lantern::image> parts;
    for (const unsigned depth : {0u, 2u, 4u, 6u, 8u, 10u}) parts.push_back(solid(size, t, at_depth(t, depth)));
    return table(parts, 3);
}

/// The tree from the bottom up, when 640, 160, 40, 10, 3 of its nodes are left to be joined, and 1.
inline lantern::image joined(glm::uvec2 size) {
    const lab10::tree t = lab10::bottom_up(lantern::boxes_of(stage::flake(3)));
    std::vector<lantern::image> parts;
    for (const std::size_t number : {640u, 160u, 40u, 10u, 3u, 1u}) parts.push_back(solid(size, t, opened(t, number)));
    return table(parts, 3);
}

// ---- Steps 6 and 7 -------------------------------------------------------------------------------------------------

/// How the first hit is found, and what is asked on the way: stage::closest, or with one of the handout's mistakes.
using search = std::function<std::optional<lantern::nearest>(const lab10::tree&, const balls&, const lantern::ray&, stage::count&)>;

/// What a ray sees of the flake, as a search finds it in a tree; and how much it asks for that, as heat.
struct flake_found {
    const lab10::tree& t;
    const balls& all;
    search find = stage::closest<stage::count>;

    glm::vec3 operator()(const lantern::ray& r, const auto&...) const {
        stage::count asked;
        const auto h = find(t, all, r, asked);
        return h ? stage::lit(*h, color_of_part(h->index, 91), false) : stage::sky(r);
    }
};
struct flake_asked {
    const lab10::tree& t;
    const balls& all;
    search find = stage::closest<stage::count>;

    glm::vec3 operator()(const lantern::ray& r, const auto&...) const {
        stage::count asked;
        (void)find(t, all, r, asked);
        return heat(asked.total());
    }
};
inline constexpr lantern::multi_jittered found_samples{.side = 3}, heat_samples{.side = 2};

inline lantern::image found(glm::uvec2 size, const lab10::tree& t, const balls& all, const search& find = stage::closest<stage::count>) {
    return lantern::render(size, stage::camera(size), found_samples, flake_found{t, all, find});
}
inline lantern::image heat_of(glm::uvec2 size, const lab10::tree& t, const balls& all, const search& find = stage::closest<stage::count>) {
    return lantern::render(size, stage::camera(size), heat_samples, flake_asked{t, all, find});
}

/// The flake as the student's traversal finds it; what its rays ask without a tree; and what they ask with one.
inline lantern::image cost_map(glm::uvec2 size) {
    const balls all = stage::flake(3);
    const lab10::tree t = stage::library_tree(all, lantern::split::surface_area);
    const lantern::image brute_force(size, heat(float(all.size())));
    return with_scale(table({found(size, t, all), brute_force, heat_of(size, t, all)}, 3));
}

/// What a ray asks on average, on its way to the closest hit: 64 x 64 rays of the camera.
inline float mean_cost(const lab10::tree& t, const balls& all) {
    const auto cam = stage::camera({1, 1});
    const lantern::independent samples{.samples = 1};
    double sum = 0;
    for (unsigned y = 0; y < 64; ++y)
        for (unsigned x = 0; x < 64; ++x) {
            stage::count asked;
            (void)stage::closest(t, all, shoot(cam, (glm::vec2(x, y) + 0.5f) / 64.0f, samples.at({x, y}, 0)), asked);
            sum += double(asked.total());
        }
    return float(sum / 4096);
}

/// What rays ask in flakes of 1, 10, 91 ... balls: without a tree (black), and in the library's four kinds of trees. It is the student's
/// traversal that asks.
inline std::vector<curve> growth(unsigned depths) {
    std::vector<curve> curves{{glm::vec3(0), {}}};
    for (const kind& k : kinds()) curves.push_back({k.color, {}});
    for (unsigned depth = 0; depth < depths; ++depth) {
        const balls all = stage::flake(depth);
        curves[0].points.push_back(glm::vec2(float(all.size())));
        for (std::size_t i = 0; i < kinds().size(); ++i)
            curves[i + 1].points.push_back({float(all.size()), mean_cost(stage::library_tree(all, kinds()[i].rule), all)});
    }
    return curves;
}

/// The flake with shadows, as a search finds them: dark(tree, balls, ray, count). What the eye sees is the library's affair.
template <class Dark>
struct flake_lit {
    const lantern::bvh<>& own;
    const lab10::tree& t;
    const balls& all;
    Dark dark;

    /// with(hit, colour, ray to the lamp) is called for what the pixel's ray meets, and sky(ray) when it meets nothing.
    glm::vec3 seen(const lantern::ray& r, auto&& sky, auto&& with) const {
        if (const auto h = lantern::closest(own, all, r)) return with(lantern::hit(*h), color_of_part(h->index, 91));
        if (const auto h = stage::on_floor(r, stage::floor_height)) return with(*h, glm::vec3(0.45f));
        return sky(r);
    }
    glm::vec3 operator()(const lantern::ray& r, const auto&...) const {
        return seen(r, stage::sky, [&](const lantern::hit& h, glm::vec3 color) {
            stage::count asked;
            return stage::lit(h, color, dark(t, all, stage::to_lamp(h), asked));
        });
    }
};

/// What the shadow rays ask for that, as heat.
template <class Dark>
struct flake_lit_asked : flake_lit<Dark> {
    glm::vec3 operator()(const lantern::ray& r, const auto&...) const {
        return this->seen(r, [](const lantern::ray&) { return glm::vec3(0.05f); }, [&](const lantern::hit& h, glm::vec3) {
            stage::count asked;
            (void)this->dark(this->t, this->all, stage::to_lamp(h), asked);
            return heat(asked.total());
        });
    }
};

template <class Dark>
std::vector<lantern::image> in_the_light(glm::uvec2 size, Dark dark) {
    const balls all = stage::flake(3);
    const lantern::bvh<> own(all);
    const lab10::tree t = stage::library_tree(all, lantern::split::surface_area);
    const flake_lit<Dark> lit{own, t, all, dark};
    return {lantern::render(size, stage::camera(size), found_samples, lit), lantern::render(size, stage::camera(size), heat_samples, flake_lit_asked<Dark>{lit})};
}
inline lantern::image shadows(glm::uvec2 size) { return with_scale(table(in_the_light(size, stage::dark<stage::count>), 2)); }

// ---- Step 8 --------------------------------------------------------------------------------------------------------

/// The flake flies apart while the shutter is open; around its nine parts the boxes that they had, and those for the exposure.
inline lantern::image moving(glm::uvec2 size, std::uint32_t side) {
    const balls all = stage::flake(2);
    std::vector<lantern::moving<lantern::sphere>> flying;
    std::vector<aabb> opening, closing;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::size_t part = i == 0 ? 0 : 1 + 10 * ((i - 1) / 10);  // the ball at the middle of the smaller flake that it belongs to
        const glm::vec3 way = 0.4f * all[part].center;
        flying.push_back({all[i], way});
        opening.push_back(bounds(all[i]));
        closing.push_back(bounds(lantern::sphere{all[i].center + way, all[i].radius}));
    }
    // A tree of ten leaves, one for each part, below a chain.
    lab10::tree parts;
    parts.order = all_of(all.size());
    for (std::uint32_t i = 0; i < 10; ++i) {
        const std::uint32_t here = 2 * i;
        if (i < 9) parts.nodes.push_back({.box = {}, .left = here + 1, .right = here + 2});
        parts.nodes.push_back({.box = {}, .first = i == 0 ? 0 : 10 * i - 9, .count = i == 0 ? 1u : 10u});
    }
    const auto frames = [&](const lab10::tree& t, glm::vec3 color) {
        std::vector<frame> leaves;
        for (const lab10::node& n : t.nodes)
            if (n.count > 0) leaves.push_back({n.box, color});
        return leaves;
    };
    const std::vector<frame> before = frames(lab10::refit(parts, opening, opening), glm::vec3(0.9f));
    const std::vector<frame> whole = frames(lab10::refit(parts, opening, closing), {1, 0.8f, 0.1f});
    const lantern::bvh<> tree(flying);
    const float aspect = float(size.x) / float(size.y);
    const lantern::camera view{lantern::view{.eye = {0.6f, 2.4f, 8.2f}, .target = {0, 0, 0}, .vertical_fov = 0.5f, .aspect = aspect},
                               lantern::pinhole{}, lantern::shutter{0, 1}};
    const auto picture = [&](const std::vector<frame>& around) {
        return lantern::render(size, view, lantern::multi_jittered{.side = side}, [&](const lantern::timed_ray& r, const auto&) {
            if (const auto edge = on_edge(around, r, lantern::infinity, 0.01f)) return *edge;
            const auto h = closest(tree, flying, r);
            return h ? stage::lit(*h, color_of_part(h->index, 10), false) : stage::sky(r);
        });
    };
    return table({picture(before), picture(whole)}, 2);
}

}  // namespace pictures
