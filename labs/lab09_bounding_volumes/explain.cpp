// SPDX-License-Identifier: MIT
// Lab 09's shelf, explained: ./lab explain 09, ./lab heat 09.

#include "../support/explain.hpp"
#include "pictures.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

using pictures::saved_height, pictures::saved_size;

constexpr unsigned side = 2;

/// Where the ray enters a box, to be shown; whether it does is the student's answer.
float entry(const lab09::box& b, const lantern::ray& r) {
    float near = 0;
    for (int k = 0; k < 3; ++k) {
        const float there = ((r.direction[k] > 0 ? b.min : b.max)[k] - r.origin[k]) / r.direction[k];
        if (there > near) near = there;
    }
    return near;
}

/// A box that tells who asks it.
struct told_box : lab09::box {};
bool overlaps(const told_box& b, const lantern::ray& r, lantern::interval range) {
    const bool met = lab09::overlaps(static_cast<const lab09::box&>(b), r, range);
    if (support::recorder* const to = support::recorder::listener()) to->box({b.min, b.max, 0, 0, met ? std::optional(entry(b, r)) : std::nullopt});
    return met;
}

/// A thing is known by its first triangle.
support::figure figure_of(const shelf::thing& s) {
    const shelf::triangle& t = s.triangles.front();
    return {"mesh", {t.a.x, t.a.y, t.a.z, t.b.x, t.b.y, t.b.z, t.c.x, t.c.y, t.c.z}};
}

struct told_thing : pictures::counted {};
std::optional<lantern::hit> intersect(const told_thing& s, const lantern::ray& r, lantern::interval range) {
    const auto h = intersect(static_cast<const pictures::counted&>(s), r, range);
    if (support::recorder* const to = support::recorder::listener()) to->test(figure_of(*s.what), h, range, std::uint32_t(s.what->triangles.size()));
    return h;
}

support::world world_of(const pictures::whole_shelf& all) {
    support::world w{.beyond = "the paper"};
    for (const shelf::thing& s : all.things()) {
        w.things.push_back({figure_of(s), "the " + s.name, std::to_string(s.triangles.size()) + " triangles", s.color});
        for (const shelf::triangle& t : s.triangles)
            w.things.push_back({{"triangle", {t.a.x, t.a.y, t.a.z, t.b.x, t.b.y, t.b.z, t.c.x, t.c.y, t.c.z}}, "a triangle", "", s.color});
    }
    return w;
}

/// The shelf without boxes and what it costs, the shelf with boxes and what that costs.
support::subject saved() {
    const auto all = std::make_shared<const pictures::whole_shelf>();
    const auto most = float(all->look({0, 0}, false).second);
    const auto color = [=](glm::uvec2 at, glm::vec2 p) {
        if (support::recorder* const to = support::recorder::listener()) to->begin(pictures::eye_ray(p), {});
        const unsigned panel = at.x / (saved_size.x + 2);
        const auto [seen, tests] = all->look<told_box, told_thing>(p, panel >= 2);
        return panel % 2 == 0 ? seen : pictures::heat(float(tests) / most);
    };
    const auto inside = [](glm::uvec2 at) { return glm::uvec2(at.x % (saved_size.x + 2), at.y); };
    const auto is_gap = [=](glm::uvec2 at) { return inside(at).x >= saved_size.x; };
    const auto side_at = [=](glm::uvec2 at) { return is_gap(at) || at.x / (saved_size.x + 2) % 2 == 1 ? 1u : side; };
    return {.name = "lab09_8_saved.png",
            .size = {4 * (saved_size.x + 2) - 2, saved_size.y},
            .samples = side * side,
            .samples_at = [=](glm::uvec2 at) { return side_at(at) * side_at(at); },
            .pixel = [=](glm::uvec2 at) {
                return is_gap(at) ? glm::vec3(1) : pictures::drawn(saved_size, side_at(at), saved_height, inside(at), [&](glm::vec2 p) { return color(at, p); });
            },
            .sample = [=](glm::uvec2 at, std::uint32_t i) {
                return is_gap(at) ? glm::vec3(1) : color(at, pictures::point_of(saved_size, side_at(at), saved_height, inside(at), i));
            },
            .world_at = [=](glm::uvec2 at) {
                support::world w = world_of(*all);
                w.eye = pictures::eye_ray(pictures::point_of(saved_size, 1, saved_height, inside(at), 0)).origin;  // far away, and all rays parallel
                return w;
            }};
}

std::vector<support::subject> subjects() { return {saved()}; }

}  // namespace

int main(int argc, char** argv) { return support::explain(argc, argv, subjects); }
