// SPDX-License-Identifier: MIT
// One sphere, coloured by its normals; PPM to standard output: one_sphere > sphere.ppm

#include <lantern/camera.hpp>
#include <lantern/ppm.hpp>
#include <lantern/render.hpp>
#include <lantern/sphere.hpp>

#include <iostream>

int main() {
    const lantern::sphere ball{.center = {0, 0, 0}, .radius = 1};
    const lantern::camera cam{lantern::view{.eye = {0, 0, 4}, .target = {0, 0, 0}}};
    const auto image = lantern::render({320, 320}, cam, lantern::jittered{.side = 2}, [&](const lantern::ray& r, auto&&) {
        const auto h = intersect(ball, r, lantern::interval{});
        return h ? 0.5f * (h->normal + 1.0f) : glm::vec3{0.2f};
    });
    lantern::write_ppm(std::cout, image);
}
