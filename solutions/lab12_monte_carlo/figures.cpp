// SPDX-License-Identifier: MIT
// The figures of lab 12's handout.

#include "../../labs/lab12_monte_carlo/pictures.hpp"

#include <lantern/png.hpp>

#include <filesystem>

namespace {

using namespace lab12;

/// The path of step 8, and what mistakes make of it.
enum class mistake { none, depth, twice, undivided, dense };

glm::vec3 seen(const scene& s, lantern::ray r, numbers& random, mistake which) {
    glm::vec3 sum{0}, throughput{1}, from{0};
    float density = 0;
    for (int bounce = 0;; ++bounce) {
        const auto f = find(s, r);
        if (!f || (which == mistake::depth && bounce == 2)) return sum;
        const bool two_ways = f->is_lamp && bounce > 0 && which != mistake::twice;
        sum += throughput * (two_ways ? share(density, lamp_density(s.walls[*s.lamp].shape, f->at.point, from)) : 1) * f->what.emission;
        const lit straight = from_lamp(s, *f, random.two());
        const float part = which == mistake::twice ? 1 : share(straight.density, cosine_density(f->at.normal, straight.direction));
        sum += throughput * part * straight.light;
        const glm::vec3 direction = cosine_direction(f->at.normal, random.two());
        density = cosine_density(f->at.normal, direction);
        throughput = bounced(throughput, f->what.albedo, f->at.normal, direction, density);
        if (which == mistake::dense) throughput *= 0.5f;  // by a density of 2 cos θ / π
        if (throughput == glm::vec3(0)) return sum;
        if (bounce >= (which == mistake::undivided ? 0 : 3)) {
            const auto kept = roulette(throughput, random.one());
            if (!kept) return sum;
            if (which != mistake::undivided) throughput = *kept;
        }
        from = f->at.point;
        r = {lantern::leave(f->at, direction), direction};
    }
}

lantern::image mistakes() {
    const scene s = pictures::cornell();
    std::vector<lantern::image> panels;
    for (const mistake which : {mistake::none, mistake::depth, mistake::twice, mistake::undivided, mistake::dense})
        panels.push_back(pictures::picture({150, 150}, pictures::before_the_box(), 128, [&](const lantern::ray& r, numbers& random) { return seen(s, r, random, which); }));
    return pictures::beside(panels);
}

}  // namespace

int main(int argc, char** argv) {
    const std::filesystem::path folder = argc > 1 ? argv[1] : "labs/lab12_monte_carlo/figures";
    lantern::write_png(folder / "estimates.png", pictures::estimates());
    lantern::write_png(folder / "directions.png", pictures::directions());
    lantern::write_png(folder / "cosine.png", pictures::cosine());
    lantern::write_png(folder / "box.png", pictures::beside({pictures::direct(128), pictures::box(256)}));
    lantern::write_png(folder / "noise.png", pictures::beside({pictures::box(4, 200), pictures::box(16, 200), pictures::box(64, 200), pictures::box(256, 200)}));
    lantern::write_png(folder / "two_ways.png", pictures::two_ways());
    lantern::write_png(folder / "survivors.png", pictures::survivors());
    lantern::write_png(folder / "mistakes.png", mistakes());
}
