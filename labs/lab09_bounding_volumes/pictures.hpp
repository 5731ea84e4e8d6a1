// SPDX-License-Identifier: MIT
#pragma once
// Lab 09's pictures and its table: the program shows them with the student's code, the handout with ours.

#include "../support/pixels.hpp"
#include "../support/test_card.hpp"
#include "scene.hpp"

#include <lab09_bounding_volumes/bounding_volumes.hpp>

#include <lantern/image.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iomanip>
#include <numbers>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace pictures {

constexpr glm::vec3 paper{0.92f, 0.92f, 0.9f}, ink{0.02f}, in_vain{1, 0.5f, 0.12f}, lost{1, 0, 1};

// The eye is far away, so all its rays are parallel. A point of the picture is counted from its middle, up is positive.
inline const glm::vec3 forward = glm::normalize(glm::vec3(-0.45f, -0.4f, -1));
inline const glm::vec3 right = glm::normalize(glm::cross(forward, glm::vec3(0, 1, 0))), up = glm::cross(right, forward);
inline lantern::ray eye_ray(glm::vec2 p) { return {p.x * right + p.y * up - 8.0f * forward, forward}; }
inline glm::vec2 seen_at(glm::vec3 p) { return {glm::dot(p, right), glm::dot(p, up)}; }

/// Sample i of side × side of a pixel: the point of a picture that is `height` high.
inline glm::vec2 point_of(glm::uvec2 size, unsigned side, float height, glm::uvec2 pixel, unsigned i) {
    const glm::vec2 in_pixel = (glm::vec2(i % side, i / side) + 0.5f) / float(side);
    const glm::vec2 p = (glm::vec2(pixel) + in_pixel - glm::vec2(size) / 2.0f) * (height / float(size.y));
    return {p.x, -p.y};
}

/// The mean of what `color` says about the points.
template <class Color>
glm::vec3 drawn(glm::uvec2 size, unsigned side, float height, glm::uvec2 pixel, const Color& color) {
    glm::vec3 sum(0);
    for (unsigned i = 0; i < side * side; ++i) sum += color(point_of(size, side, height, pixel, i));
    return sum / float(side * side);
}

inline lantern::image drawing(glm::uvec2 size, unsigned side, float height, const std::function<glm::vec3(glm::vec2)>& color) {
    return support::picture_of(size, [&](glm::uvec2 pixel) { return drawn(size, side, height, pixel, color); });
}

using edges = std::vector<std::pair<glm::vec3, glm::vec3>>;

/// The twelve edges of a box whose corner i is to_corner(±1, ±1, ±1).
inline edges edges_of(const std::function<glm::vec3(glm::vec3)>& to_corner) {
    edges all;
    for (int axis = 0; axis < 3; ++axis)
        for (int i = 0; i < 4; ++i) {
            glm::vec3 from(i & 1 ? 1.0f : -1.0f);
            from[axis] = -1;
            from[(axis + 2) % 3] = i & 2 ? 1.0f : -1.0f;
            glm::vec3 to = from;
            to[axis] = 1;
            all.push_back({to_corner(from), to_corner(to)});
        }
    return all;
}
inline edges edges_of(const lab09::box& b) {
    return edges_of([&](glm::vec3 c) { return 0.5f * (b.min + b.max) + 0.5f * c * (b.max - b.min); });
}
inline edges edges_of(const lab09::oriented_box& b) {
    return edges_of([&](glm::vec3 c) { return b.center + c.x * b.half.x * b.axes[0] + c.y * b.half.y * b.axes[1] + c.z * b.half.z * b.axes[2]; });
}
inline edges edges_of(const lab09::sphere&) { return {}; }

inline bool on_edge(const edges& all, glm::vec2 p, float width) {
    return std::ranges::any_of(all, [&](const auto& edge) {
        const glm::vec2 a = seen_at(edge.first), way = seen_at(edge.second) - a;
        const float t = glm::clamp(glm::dot(p - a, way) / std::max(glm::dot(way, way), 1e-12f), 0.0f, 1.0f);
        return glm::length(p - a - t * way) < width;
    });
}

inline glm::vec3 shaded(const lantern::hit& h, glm::vec3 color) {
    const glm::vec3 normal = glm::dot(h.normal, forward) < 0 ? h.normal : -h.normal;
    return color * (0.35f + 0.9f * std::max(glm::dot(normal, glm::normalize(glm::vec3(-0.3f, 0.9f, 0.6f))), 0.0f));
}

/// Writes the number, two digits at most, below the middle of a picture.
inline void write_number(lantern::image& picture, int number) {
    const std::string digits = std::to_string(number);
    const glm::vec2 corner(float(picture.size().x) / 2 - 9 * float(digits.size()), float(picture.size().y) - 30);
    for (std::size_t k = 0; k < digits.size(); ++k)
        for (unsigned y = 0; y < 22; ++y)
            for (unsigned x = 0; x < 11; ++x)
                if (support::on_digit((glm::vec2(x, y) + 0.5f) / 11.0f, digits[k] - '0'))
                    picture(unsigned(corner.x) + unsigned(k) * 18 + 3 + x, unsigned(corner.y) + y) = ink;
}

/// How many of the lines from everywhere meet the thing, and how many the volume.
constexpr std::uint32_t lines = 40000;
template <class Volume>
std::uint32_t lines_that_meet(const Volume& volume) {
    std::uint32_t met = 0;
    for (std::uint32_t i = 0; i < lines; ++i) met += overlaps(volume, shelf::line(i, shelf::lines_radius), {});
    return met;
}
inline std::uint32_t lines_that_hit(const shelf::thing& s) {
    std::uint32_t met = 0;
    for (std::uint32_t i = 0; i < lines; ++i) met += seen(s, shelf::line(i, shelf::lines_radius)).has_value();
    return met;
}

/// Puts pictures of equal size next to each other.
inline lantern::image beside(const std::vector<lantern::image>& parts) {
    const glm::uvec2 size = parts.front().size();
    lantern::image page({unsigned(parts.size()) * (size.x + 2) - 2, size.y}, glm::vec3(1));
    for (unsigned i = 0; i < parts.size(); ++i)
        for (unsigned y = 0; y < size.y; ++y) std::ranges::copy(parts[i].row(y), page.row(y).begin() + i * (size.x + 2));
    return page;
}

/// The four things in the volumes that `wrap` makes of their points. What a ray would meet in vain is orange; the number says how many
/// lines of a hundred, from everywhere, meet the volume in vain.
template <class Wrap>
lantern::image row(unsigned side, const Wrap& wrap) {
    std::vector<lantern::image> cells;
    for (const shelf::thing& s : shelf::things()) {
        const auto volume = wrap(s.points());
        const edges around = edges_of(volume);
        const double met = lines_that_meet(volume), hits = lines_that_hit(s);
        cells.push_back(drawing({178, 210}, side, 3.5f, [&](glm::vec2 p) {
            p.y -= 0.2f;  // room for the number
            if (on_edge(around, p, 0.009f)) return ink;
            const lantern::ray r = eye_ray(p);
            const auto h = seen(s, r);
            if (!overlaps(volume, r, {})) return h ? lost : paper;
            return h ? shaded(*h, s.color) : in_vain;
        }));
        write_number(cells.back(), met == 0 ? 0 : int(std::lround(100 * (1 - hits / met))));
    }
    return beside(cells);
}

/// Steps 1 and 2; 3 and 4; 5 and 6.
inline lantern::image boxes(unsigned side) { return row(side, [](const auto& points) { return lab09::box_around(points); }); }
inline lantern::image spheres(unsigned side) { return row(side, [](const auto& points) { return lab09::sphere_around(points); }); }
inline lantern::image oriented_boxes(unsigned side) { return row(side, [](const auto& points) { return lab09::oriented_box_around(points); }); }

inline glm::mat3 turned_by(float angle) {
    const float c = std::cos(angle), s = std::sin(angle);
    return {c, s, 0, -s, c, 0, 0, 0, 1};
}

/// Step 7: the pot turned, in the box of its turned box (orange) and in the box around its turned points (black). `transform` makes the
/// first; what sticks out of that is magenta.
inline lantern::image turned(unsigned side, const std::function<lab09::box(const glm::mat3&, const lab09::box&)>& transform) {
    const shelf::thing pot = shelf::things().back();
    const lab09::box straight = lab09::box_around(pot.points());
    std::vector<lantern::image> cells;
    for (const int eighths : {0, 1, 2, 4}) {
        const glm::mat3 turn = turned_by(float(eighths) * std::numbers::pi_v<float> / 8);
        shelf::thing s = pot;
        for (shelf::triangle& t : s.triangles) t = {turn * t.a, turn * t.b, turn * t.c};
        const lab09::box around = transform(turn, straight);
        const edges outer = edges_of(around), inner = edges_of(lab09::box_around(s.points()));
        cells.push_back(drawing({178, 190}, side, 3.2f, [&](glm::vec2 p) {
            if (on_edge(outer, p, 0.016f)) return in_vain;
            if (on_edge(inner, p, 0.009f)) return ink;
            const auto h = seen(s, eye_ray(p));
            if (!h) return paper;
            const glm::vec3 inside = glm::min(h->point - around.min, around.max - h->point);
            return std::min({inside.x, inside.y, inside.z}) < -1e-4f ? lost : shaded(*h, s.color);
        }));
    }
    return beside(cells);
}
inline lantern::image turned(unsigned side) {
    return turned(side, [](const glm::mat3& m, const lab09::box& b) { return lab09::transformed(m, glm::vec3(0), b); });
}

/// A thing that counts how many triangles have been tested.
struct counted {
    const shelf::thing* what;
    std::uint32_t* tests;
};
[[nodiscard]] inline std::optional<lantern::hit> intersect(const counted& s, const lantern::ray& r, lantern::interval range) {
    *s.tests += std::uint32_t(s.what->triangles.size());
    return intersect(*s.what, r, range);
}

/// All four things next to each other, each with its box.
class whole_shelf {
public:
    whole_shelf() {
        const std::array<glm::vec2, 4> places{{{-1.55f, 0.95f}, {1.5f, 0.9f}, {-1.35f, -1.05f}, {1.25f, -1.0f}}};
        for (std::size_t i = 0; i < things_.size(); ++i) {
            for (shelf::triangle& t : things_[i].triangles)
                for (glm::vec3* corner : {&t.a, &t.b, &t.c}) *corner += places[i].x * right + places[i].y * up;
            boxes_.push_back(lab09::box_around(things_[i].points()));
        }
    }
    /// The colour at a point of the picture, and how many triangles were tested for it, with bounded surfaces or without.
    template <class Box = lab09::box, class Thing = counted>
    [[nodiscard]] std::pair<glm::vec3, std::uint32_t> look(glm::vec2 p, bool with_boxes) const {
        std::uint32_t tests = 0;
        glm::vec3 color = paper;
        lantern::interval range;
        for (std::size_t i = 0; i < things_.size(); ++i) {
            const Thing one{&things_[i], &tests};
            const auto h = with_boxes ? intersect(lab09::bounded<Box, Thing>{{boxes_[i]}, one}, eye_ray(p), range) : intersect(one, eye_ray(p), range);
            if (!h) continue;
            range.max = h->t;
            color = shaded(*h, things_[i].color);
        }
        return {color, tests};
    }

    [[nodiscard]] const std::vector<shelf::thing>& things() const { return things_; }

private:
    std::vector<shelf::thing> things_ = shelf::things();
    std::vector<lab09::box> boxes_;
};

/// From black over violet, red and yellow to white.
inline glm::vec3 heat(float x) {
    return glm::clamp(glm::vec3(2.2f * x, 2.2f * x - 0.9f, x < 0.5f ? 0.5f * std::sin(6.28f * x) : 2 * x - 1.1f), 0.0f, 1.0f);
}

/// Step 8: the shelf, and how many triangles were tested for each pixel; on the left without boxes, on the right with them.
inline constexpr glm::uvec2 saved_size{178, 130};
inline constexpr float saved_height = 4.3f;
inline lantern::image saved(unsigned side) {
    const whole_shelf all;
    const auto most = float(all.look({0, 0}, false).second);
    std::vector<lantern::image> cells;
    for (const bool with_boxes : {false, true}) {
        cells.push_back(drawing(saved_size, side, saved_height, [&](glm::vec2 p) { return all.look(p, with_boxes).first; }));
        cells.push_back(drawing(saved_size, 1, saved_height, [&](glm::vec2 p) { return heat(float(all.look(p, with_boxes).second) / most); }));
    }
    return beside(cells);
}

/// Step 9: clouds of points that lie in the plane of the picture; the sphere of step 3 is light, the smallest is dark.
inline lantern::image smallest(unsigned side) {
    std::vector<lantern::image> cells;
    for (const auto& [seed, count] : {std::pair{454u, 4u}, {658u, 8u}, {1271u, 16u}, {2u, 40u}}) {
        std::vector<glm::vec3> points;
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint64_t h = lantern::hash(seed, i);
            const glm::vec2 p = 2.1f * glm::vec2(lantern::to_unit(lantern::low(h)), lantern::to_unit(lantern::high(h))) - 1.05f;
            points.push_back(p.x * right + p.y * up);
        }
        const lab09::sphere quick = lab09::sphere_around(points), best = lab09::smallest_sphere(points);
        cells.push_back(drawing({178, 190}, side, 3.9f, [&](glm::vec2 p) {
            for (const glm::vec3& q : points)
                if (glm::distance(p, seen_at(q)) < 0.035f) return ink;
            const auto in = [&](const lab09::sphere& s) { return glm::distance(p, seen_at(s.center)) <= s.radius; };
            return in(best) ? in_vain : in(quick) ? glm::mix(in_vain, paper, 0.6f) : paper;
        }));
    }
    return beside(cells);
}

/// Which volume is tight? For each thing and each volume: of a hundred lines, how many should meet it, by its area; how many do; and how
/// many of those miss the thing. Then what boxes save in the picture of step 8. What is not written yet has no line.
inline void write_table(std::ostream& out) {
    const double all_lines = 4 * std::numbers::pi * double(shelf::lines_radius) * double(shelf::lines_radius);
    out << "of 100 lines from everywhere        by area     counted   in vain\n" << std::fixed;
    for (const shelf::thing& s : shelf::things()) {
        const std::uint32_t hits = lines_that_hit(s);
        const std::vector<glm::vec3> points = s.points();
        out << std::left << std::setw(32) << s.name + ", " + std::to_string(s.triangles.size()) + " triangles" << std::right << std::setprecision(2);
        if (s.convex) out << std::setw(11) << 100 * s.area() / all_lines;
        else out << std::setw(11) << "";
        out << std::setw(12) << 100.0 * hits / lines << '\n';
        const auto line = [&](const char* name, const auto& wrap) {
            try {
                const auto volume = wrap();
                const double area = surface_area(volume);
                const std::uint32_t met = lines_that_meet(volume);
                out << "    " << std::left << std::setw(28) << name << std::right << std::setprecision(2) << std::setw(11) << 100 * area / all_lines
                    << std::setw(12) << 100.0 * met / lines << std::setprecision(0) << std::setw(8) << 100 * (1 - double(hits) / met) << " %\n";
            } catch (const lantern::unfinished&) {
            }
        };
        line("box", [&] { return lab09::box_around(points); });
        line("sphere", [&] { return lab09::sphere_around(points); });
        line("smallest sphere", [&] { return lab09::smallest_sphere(points); });
        line("oriented box", [&] { return lab09::oriented_box_around(points); });
    }
    try {
        const whole_shelf all;
        double with_boxes = 0;
        for (unsigned i = 0; i < 100 * 100; ++i) with_boxes += all.look((glm::vec2(i % 100, i / 100) / 99.0f - 0.5f) * glm::vec2(5.9f, 4.3f), true).second / 1e4;
        out << "the shelf: " << all.look({0, 0}, false).second << " triangles tested for each ray, behind boxes " << std::setprecision(0) << with_boxes << '\n';
    } catch (const lantern::unfinished&) {
    }
}

}  // namespace pictures
