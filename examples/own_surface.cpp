// SPDX-License-Identifier: MIT
// A surface of your own, in your own namespace: an `intersect` beside it is all that lantern asks for.
//     own_surface [PATH.png] [SIDE]

#include <lantern/blinn_phong.hpp>
#include <lantern/camera.hpp>
#include <lantern/closest.hpp>
#include <lantern/light.hpp>
#include <lantern/object.hpp>
#include <lantern/render.hpp>
#include <lantern/whitted.hpp>

#include "picture.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace mine {

/// A ring around the y axis.
struct torus {
    float ring = 1, tube = 0.4f;  ///< the radii of the circle in the middle, and of the tube around it
};

float distance(const torus& t, glm::vec3 p) {
    return std::hypot(std::hypot(p.x, p.z) - t.ring, p.y) - t.tube;
}

/// From the nearest point of the circle in the middle, outwards.
glm::vec3 normal(const torus& t, glm::vec3 p) {
    const glm::vec3 middle = t.ring * glm::normalize(glm::vec3(p.x, 0, p.z));
    return glm::normalize(p - middle);
}

/// Sphere tracing (Hart 1996): as far as the surface is away, a ray may go without meeting it.
std::optional<lantern::hit> intersect(const torus& t, const lantern::ray& r, lantern::interval range) {
    const float speed = glm::length(r.direction), close = 1e-5f * (t.ring + t.tube);  // what float leaves of a distance
    const float side = distance(t, r.origin) < 0 ? -1.0f : 1.0f;                       // starts inside, or outside
    const float end = std::min(range.max, (glm::length(r.origin) + t.ring + t.tube) / speed);
    for (float s = range.min; s <= end;) {
        const glm::vec3 p = at(r, s);
        const float d = side * distance(t, p);
        if (d < close && s > range.min) return lantern::hit{s, p, normal(t, p), 2 * close};
        s += std::max(d, close) / speed;
    }
    return std::nullopt;
}

static_assert(lantern::surface<torus>);

}  // namespace mine

int main(int argc, char** argv) {
    return picture::main(argc, argv, "own_surface", 4, [](const std::string& path, std::uint32_t side) {
        const std::vector things{
            lantern::object{mine::torus{}, lantern::blinn_phong{{0.8f, 0.35f, 0.1f}, glm::vec3(0.1f), 80}}};
        const std::vector lights{lantern::point_light{{3, 6, 4}, glm::vec3(160)}};
        const lantern::every all{1};
        const lantern::whitted tracer{all, things, lights, lantern::sky{.horizon = {0.75f, 0.82f, 0.9f}}, {.ambient = glm::vec3(0.15f)}};
        const lantern::camera cam{lantern::view{.eye = {0, 2.6f, 4}, .target = {0, 0, 0}, .vertical_fov = 0.6f}};
        picture::write(path, lantern::render({400, 400}, cam, lantern::jittered{.side = side}, tracer,
                                             {.progress = picture::bar("own_surface")}));
    });
}
