// SPDX-License-Identifier: MIT
// The figures of lab 08's handout.

#include "../../labs/lab08_shutter/pictures.hpp"

#include <lantern/png.hpp>

#include <algorithm>
#include <filesystem>
#include <vector>

namespace {

/// Four pictures of the same size, two and two.
lantern::image four(const std::vector<lantern::image>& parts) {
    const glm::uvec2 size = parts.front().size();
    lantern::image page(2u * size + 2u, glm::vec3(1));
    for (unsigned i = 0; i < 4; ++i)
        for (unsigned y = 0; y < size.y; ++y)
            std::ranges::copy(parts[i].row(y), page.row((i / 2) * (size.y + 2) + y).begin() + (i % 2) * (size.x + 2));
    return page;
}

lantern::image mistakes() {
    const auto at_0 = [](stage::timed_ray r) {
        r.time = 0;
        return r;
    };
    stage::parts shadow, mirror, cut;
    shadow.shadow = [=](const auto& r, glm::vec3 point, glm::vec3 light) { return at_0(lab08::shadow_ray(r, point, light)); };
    mirror.reflected = [=](const auto& r, glm::vec3 point, glm::vec3 normal) { return at_0(lab08::reflected_ray(r, point, normal)); };
    cut.intersect = [](const stage::moving_sphere& s, const stage::timed_ray& r) -> std::optional<float> {
        const auto [lower, upper] = lab08::bounds(s, 0, 0);  // at the opening only
        const glm::vec3 a = (lower - r.origin) / r.direction, b = (upper - r.origin) / r.direction;
        const glm::vec3 in = glm::min(a, b), out = glm::max(a, b);
        if (std::max({in.x, in.y, in.z}) > std::min({out.x, out.y, out.z})) return std::nullopt;
        return lab08::intersect(s, r);
    };
    const auto take = [](const stage::parts& what) { return stage::taken({359, 150}, 14, what); };
    return four({take({}), take(shadow), take(mirror), take(cut)});
}

}  // namespace

int main(int argc, char** argv) {
    const std::filesystem::path folder = argc > 1 ? argv[1] : "labs/lab08_shutter/figures";
    lantern::write_png(folder / "whole.png", stage::taken({720, 300}, 16, {}));
    lantern::write_png(folder / "exposures.png", four({stage::taken({359, 150}, 14, {}, 0, 0), stage::taken({359, 150}, 14, {}, 0, 0.3f),
                                                       stage::taken({359, 150}, 14, {}, 0, 1), stage::taken({359, 150}, 14, {}, 0.7f, 1)}));
    lantern::write_png(folder / "boxes.png", pictures::boxes({720, 300}, 10));
    lantern::write_png(folder / "lamps.png", pictures::lamps());
    lantern::write_png(folder / "profiles.png", pictures::profiles());
    lantern::write_png(folder / "mistakes.png", mistakes());
}
