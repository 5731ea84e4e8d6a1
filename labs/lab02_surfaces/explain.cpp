// SPDX-License-Identifier: MIT
// Lab 02's picture, explained: ./lab explain 02, ./lab heat 02.

#include "../support/explain.hpp"
#include "pictures.hpp"

#include <lantern/render.hpp>

#include <memory>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace {

support::figure figure_of(const lab02::sphere& s) { return support::ball_at(s.center, s.radius); }
support::figure figure_of(const lab02::plane& p) { return {"plane", {p.point.x, p.point.y, p.point.z, p.normal.x, p.normal.y, p.normal.z}}; }
support::figure figure_of(const lab02::triangle& t) { return {"triangle", {t.a.x, t.a.y, t.a.z, t.b.x, t.b.y, t.b.z, t.c.x, t.c.y, t.c.z}}; }

/// A thing that tells who asks it: the shapes are the student's own.
struct told {
    pictures::thing what;
    support::figure shape;

    explicit told(const pictures::thing& t) : what(t), shape(std::visit([](const auto& s) { return figure_of(s); }, t.shape)) {}
};
std::optional<lantern::hit> intersect(const told& one, const lantern::ray& r, lantern::interval range) {
    return support::tell(one.shape, r, range, [&] { return intersect(one.what, r, range); });
}

std::vector<support::subject> subjects() {
    support::gaps gaps;
    const std::vector<pictures::thing> things = pictures::world(gaps);
    pictures::shade<told> shade{{}, pictures::in_order(gaps)};
    if (things.empty()) lantern::todo("lab02 step 1: where a ray meets a sphere");
    support::world w{.eye = pictures::eye};
    int balls = 0, faces = 0;
    for (const pictures::thing& t : things) {
        shade.things.emplace_back(t);
        const std::string name = std::holds_alternative<lab02::plane>(t.shape)    ? "the ground"
                                 : std::holds_alternative<lab02::sphere>(t.shape) ? "ball " + std::to_string(++balls)
                                                                                  : "face " + std::to_string(++faces) + " of the pyramid";
        w.things.push_back({shade.things.back().shape, name, "", balls > 0 && faces == 0 ? glm::vec3(0.5f, 0.6f, 0.8f) : glm::vec3(0.8f, 0.6f, 0.4f)});
    }
    const auto camera = std::make_shared<const lantern::camera<>>(pictures::camera());
    return {{.name = "lab02.png",
             .size = pictures::size,
             .samples = pictures::samples.count(),
             .pixel = [=](glm::uvec2 at) { return lantern::render_pixel(at, pictures::size, *camera, pictures::samples, shade).mean(); },
             .sample = [=](glm::uvec2 at, std::uint32_t i) { return lantern::render_sample(at, pictures::size, *camera, pictures::samples, i, shade).color; },
             .world = w}};
}

}  // namespace

int main(int argc, char** argv) { return support::explain(argc, argv, subjects); }
