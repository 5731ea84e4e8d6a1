// SPDX-License-Identifier: MIT
// Lab 10's pictures, explained: ./lab explain 10, ./lab heat 10. The first is not among the program's: the flake in the student's own tree.

#include "../support/explain.hpp"
#include "pictures.hpp"

#include <lantern/boxes_of.hpp>
#include <lantern/render.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace {

constexpr glm::uvec2 size{300, 260};

/// The depth of every node; a tree is not to be trusted with its own numbers.
std::vector<std::uint32_t> depths_of(const lab10::tree& t) {
    std::vector<std::uint32_t> depths(t.nodes.size(), 0);
    for (std::size_t i = 0; i < t.nodes.size(); ++i)
        for (const std::uint32_t child : {t.nodes[i].left, t.nodes[i].right})
            if (t.nodes[i].count == 0 && child > i && child < depths.size()) depths[child] = depths[i] + 1;
    return depths;
}

/// The flake, and a tree over it.
struct grown {
    stage::balls all = stage::flake(3);
    lab10::tree tree{};
    std::vector<std::uint32_t> depths{};

    void plant(lab10::tree t) {
        tree = std::move(t);
        depths = depths_of(tree);
    }
};

/// Counts, and tells the recorder.
struct told : stage::count {
    const grown& in;
    support::recorder* to = support::recorder::listener();

    told(const grown& g, const lantern::ray& r, lantern::interval range = {}) : in(g) {
        if (to) to->begin(r, range);
    }
    void question(std::uint32_t at, const std::optional<float>& entered) {
        count::question(at, entered);
        const lantern::aabb& box = in.tree.nodes[at].box;
        if (to) to->box({box.min, box.max, at, in.depths[at], entered});
    }
    void offer(std::uint32_t surface, const std::optional<lantern::hit>& h, lantern::interval range) {
        count::offer(surface, h, range);
        if (to) to->test(support::ball_at(in.all[surface].center, in.all[surface].radius), h, range);
    }
};

pictures::search telling(const std::shared_ptr<const grown>& in) {
    return [in](const lab10::tree& t, const stage::balls& all, const lantern::ray& r, stage::count& asked) {
        told heard(*in, r);
        const auto h = stage::closest(t, all, r, heard);
        asked = heard;
        return h;
    };
}

/// Whether a shadow ray is stopped, by the student's search.
auto telling_dark(const std::shared_ptr<const grown>& in) {
    return [in](const lab10::tree& t, const stage::balls& all, const lantern::ray& r, stage::count& asked) {
        using trick = support::recorder::trick;
        const support::recorder* const to = support::recorder::listener();
        if (to && to->trick_on(r) != trick::none) return to->trick_on(r) == trick::card;
        told heard(*in, r, {0, 1});
        const bool found = stage::dark(t, all, r, heard);
        asked = heard;
        return found;
    };
}
using dark = decltype(telling_dark({}));

/// The library finds what the eye sees, and tells nobody on the way; what it finds is told here.
template <class Lit>
struct announced {
    Lit lit;

    glm::vec3 operator()(const lantern::ray& r, const auto&...) const {
        if (support::recorder* const to = support::recorder::listener()) {
            to->begin(r, {});
            if (const auto h = lantern::closest(lit.own, lit.all, r)) {
                const lantern::sphere& ball = lit.all[h->index];
                to->test(support::ball_at(ball.center, ball.radius), lantern::hit(*h), {});
            }
        }
        return lit(r);
    }
};

support::world world_of(const stage::balls& all) {
    support::world w{.eye = {1, 2.6f, 8.6f}};
    for (std::uint32_t i = 0; i < all.size(); ++i)
        w.things.push_back({support::ball_at(all[i].center, all[i].radius), "ball " + std::to_string(i), "", pictures::color_of_part(i, 91)});
    return w;
}

std::string levels_of(const grown& g) {
    namespace json = support::json;
    std::vector<std::string> nodes;
    for (std::size_t i = 0; i < g.tree.nodes.size(); ++i) {
        const lab10::node& n = g.tree.nodes[i];
        nodes.push_back(json::object({{"number", std::to_string(i)}, {"depth", std::to_string(g.depths[i])}, {"count", std::to_string(n.count)},
                                      {"min", json::of(n.box.min)}, {"max", json::of(n.box.max)}}));
    }
    const std::string view = json::object({{"eye", json::of(glm::vec3(1, 2.6f, 8.6f))}, {"target", json::of(glm::vec3(0, 0.15f, 0))}, {"vertical_fov", json::of(0.5)},
                                           {"aspect", json::of(double(size.x) / double(size.y))}});
    return json::object({{"nodes", json::list(nodes, [](const std::string& one) { return one; })}, {"view", view}});
}

/// A panel of one picture: what `shade` sees with a tree.
template <class Shade>
support::subject panel(std::string name, const std::shared_ptr<grown>& in, const lantern::multi_jittered& samples) {
    const auto camera = std::make_shared<const lantern::camera<>>(stage::camera(size));
    const pictures::search find = telling(in);
    return {.name = std::move(name),
            .size = size,
            .samples = samples.count(),
            .pixel = [=](glm::uvec2 at) { return lantern::render_pixel(at, size, *camera, samples, Shade{in->tree, in->all, find}).mean(); },
            .sample = [=](glm::uvec2 at, std::uint32_t i) { return lantern::render_sample(at, size, *camera, samples, i, Shade{in->tree, in->all, find}).color; },
            .world = world_of(in->all),
            .levels = [=] { return levels_of(*in); }};
}

/// The student's build, with the student's best split.
support::subject own_tree() {
    const auto in = std::make_shared<grown>();
    support::subject one = panel<pictures::flake_found>("own_tree", in, pictures::found_samples);
    one.ready = [=] {
        const std::vector<lantern::aabb> boxes = lantern::boxes_of(in->all);
        in->plant(lab10::build(boxes, [&](std::span<const std::uint32_t> group) { return lab10::at_least_cost(boxes, group); }));
        (void)lab10::cost(in->tree);
    };
    return one;
}

/// Panels beside each other, and a scale below them. A panel without samples is all of one colour.
support::subject page_of(std::string name, const std::vector<support::subject>& panels) {
    const glm::uvec2 one = panels[0].size, page{std::uint32_t(panels.size()) * (one.x + 2) - 2, one.y + 36};
    const auto scale = std::make_shared<const lantern::image>(pictures::scale(page.x));
    const auto inside = [=](glm::uvec2 at) { return glm::uvec2(at.x % (one.x + 2), at.y); };
    const auto panel = [=](glm::uvec2 at) { return at.y < one.y && inside(at).x < one.x ? &panels[at.x / (one.x + 2)] : nullptr; };
    const auto drawn = [=](glm::uvec2 at) { return at.y < one.y ? glm::vec3(1) : (*scale)(at.x, at.y - one.y); };
    return {.name = std::move(name),
            .size = page,
            .samples = panels[0].samples,
            .samples_at = [=](glm::uvec2 at) { return panel(at) ? panel(at)->samples : 1; },
            .pixel = [=](glm::uvec2 at) { return panel(at) ? panel(at)->pixel(inside(at)) : drawn(at); },
            .sample = [=](glm::uvec2 at, std::uint32_t i) { return panel(at) ? panel(at)->sample(inside(at), i) : drawn(at); },
            .world = panels[0].world,
            .levels = panels[0].levels};
}

/// The tree is the library's, the traversal the student's. In the middle what it costs without a tree: no ray is sent for that.
support::subject cost_map() {
    const auto in = std::make_shared<grown>();
    in->plant(stage::library_tree(in->all, lantern::split::surface_area));
    const glm::vec3 brute_force = pictures::heat(float(in->all.size()));
    const support::subject middle{.size = size, .samples = 1, .pixel = [=](glm::uvec2) { return brute_force; }, .sample = [=](glm::uvec2, std::uint32_t) { return brute_force; }};
    return page_of("lab10_6_cost.png", {panel<pictures::flake_found>("", in, pictures::found_samples), middle, panel<pictures::flake_asked>("", in, pictures::heat_samples)});
}

/// A panel of the picture with shadows, and of what they cost.
template <class Lit>
support::subject lit_panel(const std::shared_ptr<const grown>& in, const lantern::multi_jittered& samples) {
    const glm::uvec2 half{359, 280};
    const auto own = std::make_shared<const lantern::bvh<>>(in->all);
    const auto camera = std::make_shared<const lantern::camera<>>(stage::camera(half));
    const auto shade = [=] { return announced<Lit>{Lit{pictures::flake_lit<dark>{*own, in->tree, in->all, telling_dark(in)}}}; };
    support::world w = world_of(in->all);
    w.floor = stage::floor_height;
    w.floor_ends = 60;
    w.lamps.push_back({support::ball_at(stage::lamp, 0), "the lamp"});
    w.things.push_back({support::level_at(stage::floor_height), "the floor", "", glm::vec3(0.45f)});
    return {.size = half,
            .samples = samples.count(),
            .pixel = [=](glm::uvec2 at) { return lantern::render_pixel(at, half, *camera, samples, shade()).mean(); },
            .sample = [=](glm::uvec2 at, std::uint32_t i) { return lantern::render_sample(at, half, *camera, samples, i, shade()).color; },
            .world = std::move(w),
            .levels = [=] { return levels_of(*in); }};
}

support::subject shadows() {
    const auto in = std::make_shared<grown>();
    in->plant(stage::library_tree(in->all, lantern::split::surface_area));
    return page_of("lab10_7_shadows.png", {lit_panel<pictures::flake_lit<dark>>(in, pictures::found_samples),
                                           lit_panel<pictures::flake_lit_asked<dark>>(in, pictures::heat_samples)});
}

std::vector<support::subject> subjects() { return {own_tree(), cost_map(), shadows()}; }

}  // namespace

int main(int argc, char** argv) { return support::explain(argc, argv, subjects); }
