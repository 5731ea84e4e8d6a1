// SPDX-License-Identifier: MIT
// The figures of lab 09's handout.

#include "../../labs/lab09_bounding_volumes/pictures.hpp"

#include <lantern/png.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <utility>
#include <vector>

namespace {

using pictures::in_vain;
using pictures::ink;
using pictures::lost;
using pictures::paper;
constexpr glm::vec3 red{0.85f, 0.08f, 0.05f}, blue{0.05f, 0.2f, 0.85f}, grey{0.6f};

/// Pictures of equal width, one below the other.
lantern::image above(const std::vector<lantern::image>& parts) {
    unsigned height = 0;
    for (const lantern::image& one : parts) height += one.size().y + 2;
    lantern::image page({parts.front().size().x, height - 2}, glm::vec3(1));
    unsigned y = 0;
    for (const lantern::image& one : parts) {
        for (unsigned k = 0; k < one.size().y; ++k) std::ranges::copy(one.row(k), page.row(y + k).begin());
        y += one.size().y + 2;
    }
    return page;
}

/// Rays in the plane, and the stretches of them within the slabs: of x red, of y blue, of both black.
lantern::image slabs() {
    const glm::vec2 lower{-0.8f, -0.5f}, upper{0.9f, 0.6f};
    const std::array<std::pair<glm::vec2, glm::vec2>, 4> rays{{{{-2.6f, -1.0f}, {1, 0.42f}}, {{-2.6f, 0.15f}, {1, 0.34f}}, {{-2.6f, 0.0f}, {1, 0}}, {{1.5f, 1.35f}, {-0.12f, -1}}}};
    return pictures::drawing({560, 290}, 4, 2.9f, [&](glm::vec2 p) {
        const bool in_x = p.x > lower.x && p.x < upper.x, in_y = p.y > lower.y && p.y < upper.y;
        for (const auto& [origin, way] : rays) {
            const glm::vec2 d = glm::normalize(way);
            const float along = glm::dot(p - origin, d), aside = glm::length(p - origin - along * d);
            if (glm::length(p - origin) < 0.035f) return ink;
            if (along > 0 && aside < (in_x && in_y ? 0.016f : 0.01f)) return in_x && in_y ? ink : in_x ? red : in_y ? blue : grey;
        }
        if (in_x && in_y) return glm::vec3(0.72f, 0.62f, 0.82f);
        return in_x ? glm::vec3(0.97f, 0.84f, 0.82f) : in_y ? glm::vec3(0.83f, 0.86f, 0.98f) : paper;
    });
}

/// Ritter's sphere as it grows: the sphere of the two points far apart, and each larger one.
lantern::image ritter() {
    const std::vector<glm::vec2> points{{-0.95f, 0.15f}, {1.0f, -0.1f}, {0.25f, 1.05f}, {-0.3f, -0.4f}, {0.35f, -1.1f}, {0.5f, 0.3f}, {-0.5f, 0.6f}};
    struct circle {
        glm::vec2 center;
        float radius;
    };
    std::vector<std::pair<circle, std::size_t>> grown{{{0.5f * (points[0] + points[1]), 0.5f * glm::distance(points[0], points[1])}, 0}};
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto [center, radius] = grown.back().first;
        const float distance = glm::distance(points[i], center);
        if (distance <= radius * 1.0001f) continue;
        const float larger = 0.5f * (radius + distance);
        grown.push_back({{center + (larger - radius) / distance * (points[i] - center), larger}, i});
    }
    std::vector<lantern::image> cells;
    for (std::size_t k = 0; k < grown.size(); ++k)
        cells.push_back(pictures::drawing({200, 200}, 4, 3.0f, [&](glm::vec2 p) {
            for (std::size_t i = 0; i < points.size(); ++i)
                if (glm::distance(p, points[i]) < 0.04f) return (k == 0 ? i < 2 : i == grown[k].second) ? red : ink;
            const auto in = [&](const circle& c) { return glm::distance(p, c.center) <= c.radius; };
            if (std::abs(glm::distance(p, grown[k].first.center) - grown[k].first.radius) < 0.012f) return ink;
            return k > 0 && in(grown[k - 1].first) ? in_vain : in(grown[k].first) ? glm::mix(in_vain, paper, k == 0 ? 0.0f : 0.6f) : paper;
        }));
    return pictures::beside(cells);
}

/// Everyone's first idea: only two corners are turned.
lab09::box two_corners(const glm::mat3& m, const lab09::box& b) {
    const glm::vec3 one = m * b.min, other = m * b.max;
    return {glm::min(one, other), glm::max(one, other)};
}

/// The ray with its origin, but not its direction, carried into the frame.
bool direction_not_turned(const lab09::oriented_box& b, const lantern::ray& r) {
    glm::vec3 origin;
    for (std::size_t i = 0; i < 3; ++i) origin[int(i)] = glm::dot(b.axes[i], r.origin - b.center);
    return overlaps(lab09::box{-b.half, b.half}, lantern::ray{origin, r.direction}, {});
}

/// The slab test without branches, and with the arguments of min and max the wrong way round.
bool nan_spreads(const lab09::box& b, const lantern::ray& r) {
    float near = 0, far = lantern::infinity;
    for (int i = 0; i < 3; ++i) {
        const float reciprocal = 1 / r.direction[i], one = (b.min[i] - r.origin[i]) * reciprocal, other = (b.max[i] - r.origin[i]) * reciprocal;
        near = std::max(std::min(one, other), near);
        far = std::min(std::max(one, other), far);
    }
    return near <= far;
}

template <class Test>
lantern::image plate_in(const Test& test) {
    const shelf::thing plate = shelf::things()[2];
    const lab09::oriented_box volume = lab09::oriented_box_around(plate.points());
    const pictures::edges around = pictures::edges_of(volume);
    return pictures::drawing({178, 178}, 4, 2.8f, [&](glm::vec2 p) {
        if (pictures::on_edge(around, p, 0.008f)) return ink;
        const lantern::ray r = pictures::eye_ray(p);
        const auto h = seen(plate, r);
        if (!test(volume, r)) return h ? lost : paper;
        return h ? pictures::shaded(*h, plate.color) : in_vain;
    });
}

/// Three boxes that share faces, seen along an axis with 26 × 26 rays, some of which run within the faces.
template <class Test>
lantern::image wall_seen_by(const Test& test) {
    const std::array<lab09::box, 3> wall{{{{3, 6, 0}, {9, 20, 5}}, {{9, 6, 0}, {17, 20, 5}}, {{17, 6, 0}, {23, 12, 5}}}};
    const std::array<glm::vec3, 3> colors{{{0.1f, 0.35f, 0.08f}, {0.75f, 0.1f, 0.06f}, {0.06f, 0.16f, 0.6f}}};
    lantern::image picture({178, 178}, paper);
    for (unsigned y = 0; y < 178; ++y)
        for (unsigned x = 0; x < 178; ++x) {
            const lantern::ray r{glm::vec3(x * 26 / 178, 25 - y * 26 / 178, 9), {0, 0, -1}};
            bool inside = false, met = false;
            for (std::size_t i = 0; i < 3; ++i) {
                inside = inside || overlaps(wall[i], r, {});
                if (!met && test(wall[i], r)) picture(x, y) = colors[i], met = true;
            }
            if (inside && !met) picture(x, y) = lost;
        }
    return picture;
}

}  // namespace

int main(int argc, char** argv) {
    const std::filesystem::path folder = argc > 1 ? argv[1] : "labs/lab09_bounding_volumes/figures";
    lantern::write_png(folder / "volumes.png", above({pictures::boxes(4), pictures::spheres(4), pictures::oriented_boxes(4)}));
    lantern::write_png(folder / "slabs.png", slabs());
    lantern::write_png(folder / "ritter.png", ritter());
    lantern::write_png(folder / "turned.png", above({pictures::turned(4), pictures::turned(4, two_corners)}));
    lantern::write_png(folder / "saved.png", pictures::saved(4));
    lantern::write_png(folder / "smallest.png", pictures::smallest(4));
    const auto right = [](const auto& volume, const lantern::ray& r) { return overlaps(volume, r, {}); };
    lantern::write_png(folder / "mistakes.png", pictures::beside({plate_in(right), plate_in(direction_not_turned), wall_seen_by(right), wall_seen_by(nan_spreads)}));
}
