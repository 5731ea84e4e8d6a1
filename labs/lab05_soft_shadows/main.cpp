// SPDX-License-Identifier: MIT
// Lab 05: a table under a lamp. Left: one ray to the lamp's middle; right: sixteen points of the lamp, once everything is
// written. A second picture, of a round lamp, comes with the last steps.

#include "../support/gaps.hpp"

#include <lab05_soft_shadows/soft_shadows.hpp>

#include <lantern/camera.hpp>
#include <lantern/image.hpp>
#include <lantern/ppm.hpp>
#include <lantern/render.hpp>
#include <lantern/samples.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>
#include <vector>

namespace {

constexpr glm::uvec2 size{320, 320};
constexpr glm::vec3 lamp_middle{-0.9f, 3.2f, 0.6f};

const lab05::lamp lamp{lamp_middle + glm::vec3(0.6f, 0, -0.6f), {0, 0, 1.2f}, {-1.2f, 0, 0}, glm::vec3(12, 11.5f, 10)};

const lab05::scene table{{{{0.1f, 0.5f, 0}, 0.5f}, {{-0.95f, 0.25f, 0.75f}, 0.25f}, {{1.15f, 0.2f, 0.55f}, 0.2f}},
                         {{{-6, 0, 6}, {12, 0, 0}, {0, 0, -12}}, {{0.75f, 0, -0.6f}, {0.5f, 0, 0.35f}, {0, 1.3f, 0}}}};

const std::vector<glm::vec3> colors{{0.75f, 0.3f, 0.2f}, {0.25f, 0.45f, 0.7f}, {0.8f, 0.65f, 0.25f}, {0.62f, 0.6f, 0.57f}, {0.5f, 0.6f, 0.4f}};

support::gaps gaps;

struct seen {
    lantern::hit hit;
    glm::vec3 color;
};

std::optional<seen> nearest(const lantern::ray& r) {
    std::optional<seen> best;
    std::size_t i = 0;
    const auto meet = [&](const auto& surface) {
        const auto h = intersect(surface, r, {0, best ? best->hit.t : lantern::infinity});
        if (h) best = seen{*h, colors[i]};
        ++i;
    };
    for (const auto& ball : table.balls) meet(ball);
    for (const auto& wall : table.walls) meet(wall);
    if (best && glm::dot(best->hit.normal, r.direction) > 0) best->hit.normal = -best->hit.normal;
    return best;
}

/// Every pixel by `light(hit, source)`; or, while a step is missing, the test card. `render` hands on what a thread throws.
template <class Light>
lantern::image picture(const Light& light) {
    const lantern::camera cam{lantern::view{.eye = {0, 2.1f, 4.2f}, .target = {0, 0.35f, 0}, .vertical_fov = 0.62f}};
    const auto shade = [&](const lantern::ray& r, const auto& source) {
        const auto found = nearest(r);
        if (!found) return glm::vec3(0.02f);
        return found->color / 3.14159265f * light(found->hit, source) + 0.02f * found->color;
    };
    try {
        return lantern::render(size, cam, lantern::jittered{.side = 4}, shade);
    } catch (const lantern::unfinished& gap) {
        gaps.note(gap);
        lantern::image card(size);
        support::paint_test_card(card, {0, 0}, size, support::step_number(gap.what()));
        return card;
    }
}

/// One ray to the middle of the lamp: a hard shadow.
glm::vec3 hard(const lantern::hit& h, const auto&) {
    const glm::vec3 middle = lab05::point_on(lamp, {0.5f, 0.5f});
    const glm::vec3 light = lab05::irradiance(lamp, middle, h.point, h.normal);
    return lab05::visible(h, middle, table) ? light : glm::vec3(0);
}

/// One point of the lamp for each of the pixel's sixteen samples: the mean over the pixel is the mean over the lamp too.
glm::vec3 soft(const lantern::hit& h, const auto& source) {
    const glm::vec2 point = source.draw2(lantern::purpose::light);
    return lab05::soft_light(lamp, h, table, {&point, 1});
}

/// A ball of light instead, as bright from the front.
glm::vec3 round(const lantern::hit& h, const auto& source) {
    const float radius = 0.35f;
    const glm::vec3 d = lab05::towards_ball(lamp_middle, radius, h.point, source.draw2(lantern::purpose::light));
    const float cosine = glm::dot(d, h.normal), distance = glm::length(lamp_middle - h.point);
    if (!(cosine > 0)) return glm::vec3(0);
    const glm::vec3 light = glm::vec3(40) * (lab05::solid_angle(lamp_middle, radius, h.point) * cosine);
    return lab05::visible(h, h.point + (distance - radius) * d, table) ? light : glm::vec3(0);
}

void save(const std::filesystem::path& path, const lantern::image& picture) {
    lantern::write_ppm(path, picture);
    std::cout << path.string() << '\n';
}

}  // namespace

int main(int argc, char** argv) try {
    const std::filesystem::path folder = argc > 1 ? argv[1] : "out";
    lantern::image both({2 * size.x, size.y});
    const lantern::image left = picture([](const auto& h, const auto& s) { return hard(h, s); });
    const lantern::image right = picture([](const auto& h, const auto& s) { return soft(h, s); });
    for (unsigned y = 0; y < size.y; ++y) {
        std::ranges::copy(left.row(y), both.row(y).begin());
        std::ranges::copy(right.row(y), both.row(y).begin() + size.x);
    }
    save(folder / "lab05.ppm", both);
    if (gaps.none()) save(folder / "lab05_round.ppm", picture([](const auto& h, const auto& s) { return round(h, s); }));
    gaps.tell();
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
