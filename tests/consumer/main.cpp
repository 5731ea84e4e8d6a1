// SPDX-License-Identifier: MIT
// What a user of the installed library writes; the exit code tells whether the picture has its sphere.

#include <lantern/camera.hpp>
#include <lantern/ppm.hpp>
#include <lantern/render.hpp>
#include <lantern/sphere.hpp>

#include <cstdlib>
#include <sstream>

int main() {
    const lantern::sphere ball{.center = {0, 0, 0}, .radius = 1};
    const lantern::camera cam{lantern::view{.eye = {0, 0, 4}, .target = {0, 0, 0}}};
    const auto image = lantern::render({32, 32}, cam, lantern::jittered{.side = 1}, [&](const lantern::ray& r, auto&&) {
        return glm::vec3(intersect(ball, r, lantern::interval{}) ? 1 : 0);
    });
    std::ostringstream out;
    lantern::write_ppm(out, image);
    return image(16, 16).x == 1 && image(0, 0).x == 0 && out.str().starts_with("P6") ? EXIT_SUCCESS : EXIT_FAILURE;
}
