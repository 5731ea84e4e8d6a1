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

    told(const grown& g, const lantern::ray& r) : in(g) {
        if (to) to->begin(r, {});
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

/// Three panels, and a scale below them. The tree is the library's, the traversal the student's.
support::subject cost_map() {
    const auto in = std::make_shared<grown>();
    in->plant(stage::library_tree(in->all, lantern::split::surface_area));
    const support::subject seen = panel<pictures::flake_found>("", in, pictures::found_samples), hot = panel<pictures::flake_asked>("", in, pictures::heat_samples);
    const glm::uvec2 page{3 * (size.x + 2) - 2, size.y + 36};
    const auto scale = std::make_shared<const lantern::image>(pictures::scale(page.x));
    const auto look = [=](glm::uvec2 at, const auto& ask) {
        if (at.y >= size.y) return (*scale)(at.x, at.y - size.y);
        const glm::uvec2 inside{at.x % (size.x + 2), at.y};
        if (inside.x >= size.x) return glm::vec3(1);
        const std::uint32_t which = at.x / (size.x + 2);
        return which == 1 ? pictures::heat(float(in->all.size())) : ask(which == 0 ? seen : hot, inside);
    };
    const auto is_panel = [](glm::uvec2 at, std::uint32_t which) { return at.y < size.y && at.x / (size.x + 2) == which && at.x % (size.x + 2) < size.x; };
    return {.name = "lab10_6_cost.png",
            .size = page,
            .samples = seen.samples,
            .samples_at = [=](glm::uvec2 at) { return is_panel(at, 0) ? seen.samples : is_panel(at, 2) ? hot.samples : 1; },
            .pixel = [=](glm::uvec2 at) { return look(at, [](const support::subject& s, glm::uvec2 p) { return s.pixel(p); }); },
            .sample = [=](glm::uvec2 at, std::uint32_t i) { return look(at, [i](const support::subject& s, glm::uvec2 p) { return s.sample(p, i); }); },
            .world = seen.world,
            .levels = seen.levels};
}

std::vector<support::subject> subjects() { return {own_tree(), cost_map()}; }

}  // namespace

int main(int argc, char** argv) { return support::explain(argc, argv, subjects); }
