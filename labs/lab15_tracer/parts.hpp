// SPDX-License-Identifier: MIT
#pragma once
// The parts that lab 15 assembles: yours of labs 01 to 13 where there are any, the library's where one is missing. Whether a file is there
// the compiler sees; whether a function in it is written, it must be asked, once.

#include <lantern/aabb.hpp>
#include <lantern/bvh.hpp>
#include <lantern/convergence.hpp>
#include <lantern/glass.hpp>
#include <lantern/glossy.hpp>
#include <lantern/hash.hpp>
#include <lantern/image.hpp>
#include <lantern/interval.hpp>
#include <lantern/light.hpp>
#include <lantern/moving.hpp>
#include <lantern/ppm.hpp>
#include <lantern/ray.hpp>
#include <lantern/rectangle.hpp>
#include <lantern/sphere.hpp>
#include <lantern/surface.hpp>
#include <lantern/todo.hpp>
#include <lantern/warp.hpp>

#if __has_include(<lab01_picture/picture.hpp>)
#include <lab01_picture/picture.hpp>
#endif
#if __has_include(<lab03_whitted/whitted.hpp>)
#include <lab03_whitted/whitted.hpp>
#endif
#if __has_include(<lab04_sampling/sampling.hpp>)
#include <lab04_sampling/sampling.hpp>
#endif
#if __has_include(<lab05_soft_shadows/soft_shadows.hpp>)
#include <lab05_soft_shadows/soft_shadows.hpp>
#endif
#if __has_include(<lab06_glossy/glossy.hpp>)
#include <lab06_glossy/glossy.hpp>
#endif
#if __has_include(<lab07_lens/lens.hpp>)
#include <lab07_lens/lens.hpp>
#endif
#if __has_include(<lab08_shutter/shutter.hpp>)
#include <lab08_shutter/shutter.hpp>
#endif
#if __has_include(<lab10_hierarchy/hierarchy.hpp>)
#include <lab10_hierarchy/hierarchy.hpp>
#endif
#if __has_include(<lab13_error/error.hpp>)
#include <lab13_error/error.hpp>
#endif

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace parts {

/// The library's part for each. Also what says that none is yours.
struct library {
    static bool lab01() { return false; }
    static bool lab03() { return false; }
    static bool lab04() { return false; }
    static bool lab05() { return false; }
    static bool lab06() { return false; }
    static bool lab07() { return false; }
    static bool lab08() { return false; }
    static bool lab10() { return false; }
    static bool lab13() { return false; }

    /// Beyond the boundary: the direction, and the part of the light that is reflected. Nothing where all of it is.
    static std::optional<std::pair<glm::vec3, float>> refracted(glm::vec3 in, glm::vec3 normal, float ratio) {
        const auto bent = lantern::refracted(in, normal, double(ratio));
        return bent ? std::optional(std::pair(bent->direction, bent->reflectance)) : std::nullopt;
    }
    /// The bytes of a file.
    static std::string ppm(const lantern::image& picture) {
        std::ostringstream file;
        lantern::write_ppm(file, picture);
        return file.str();
    }
    static glm::vec2 jittered(std::uint32_t i, std::uint32_t side, glm::vec2 xi) {
        return glm::min((glm::vec2(i % side, i / side) + xi) / float(side), glm::vec2(0x1.fffffep-1f));
    }
    static glm::vec3 point_on(const lantern::rectangle& lamp, glm::vec2 xi) { return lamp.corner + xi.x * lamp.u + xi.y * lamp.v; }
    static glm::vec3 irradiance(const lantern::rectangle& lamp, glm::vec3 radiance, glm::vec3 on_lamp, glm::vec3 position, glm::vec3 normal) {
        const auto [from, facing] = lantern::illuminate_from(on_lamp, glm::cross(glm::dvec3(lamp.u), glm::dvec3(lamp.v)), radiance, position);
        return std::max(0.0f, glm::dot(normal, lantern::unit(from - position))) * facing;
    }
    static glm::vec3 reflected(glm::vec3 in, glm::vec3 normal, float width, glm::vec2 xi) {
        return lantern::folded(lantern::perturbed(lantern::mirrored(in, normal), width, xi), normal);
    }
    static lantern::ray through_lens(glm::vec3 eye, const glm::mat3& axes, glm::vec2 film, float radius, float focus, glm::vec2 xi) {
        const glm::vec2 on_lens = radius * lantern::to_disk(xi);
        const glm::vec3 offset = on_lens.x * axes[0] + on_lens.y * axes[1];
        return {eye + offset, lantern::unit(axes * glm::vec3(film, 1) - offset / focus)};
    }
    static float moment(float open, float close, float xi) { return std::lerp(open, close, xi); }
    static std::optional<float> meet(glm::vec3 center, glm::vec3 velocity, float radius, glm::vec3 origin, glm::vec3 direction, float time) {
        const auto h = intersect(lantern::moving{lantern::sphere{center, radius}, velocity}, lantern::timed_ray{{origin, direction}, time}, {});
        return h ? std::optional(h->t) : std::nullopt;
    }
    static std::pair<glm::vec3, glm::vec3> bounds(glm::vec3 center, glm::vec3 velocity, float radius, float open, float close) {
        const auto box = lantern::bounds(lantern::moving{lantern::sphere{center + open * velocity, radius}, (close - open) * velocity});
        return {box.min, box.max};
    }
    static std::uint32_t stratum(std::uint32_t i, std::uint32_t count, std::uint32_t purpose, glm::uvec2 pixel) {
        const std::uint64_t order = lantern::hash(pixel.x, pixel.y, purpose);
        return lantern::permute(i, count, order);
    }
    static double slope(std::span<const std::uint32_t> samples, std::span<const double> errors) {
        const std::vector<double> counts(samples.begin(), samples.end());
        return lantern::fitted_slope(counts, errors);
    }

    struct node {
        lantern::aabb box;
        std::uint32_t left = 0, right = 0, first = 0, count = 0;  // as in lab 10
    };
    struct tree {
        std::vector<node> nodes;
        std::vector<std::uint32_t> order;
    };
    template <class Tree = tree>
    static Tree build(std::span<const lantern::aabb> boxes) {
        const lantern::bvh<> made(boxes);
        Tree t;
        t.order.assign(made.indices().begin(), made.indices().end());
        for (const auto& n : made.nodes()) {
            if (n.size > 0) t.nodes.push_back({.box = n.volume, .first = n.first, .count = n.size});
            else t.nodes.push_back({.box = n.volume, .left = n.first, .right = n.first + 1});
        }
        return t;
    }
    static lantern::aabb box(const auto& t, std::uint32_t node) { return t.nodes[node].box; }
    static void traverse(const auto& t, lantern::interval range, auto&& enter, auto&& offer) {
        std::array<std::pair<float, std::uint32_t>, 80> waiting;  // no deeper than lantern::bvh ever is
        std::size_t size = 0;
        const auto ask = [&](std::uint32_t at) {
            if (const auto entry = enter(at)) waiting[size++] = {*entry, at};
        };
        if (!t.nodes.empty()) ask(0);
        while (size > 0) {
            const auto [entry, at] = waiting[--size];
            if (entry > range.max) continue;
            const auto& n = t.nodes[at];
            for (std::uint32_t k = n.first; k < n.first + n.count; ++k) {
                range = offer(t.order[k], range);
                if (empty(range)) return;
            }
            if (n.count > 0) continue;
            const std::size_t before = size;
            ask(n.left);
            ask(n.right);
            if (size == before + 2 && waiting[before].first < waiting[before + 1].first) std::swap(waiting[before], waiting[before + 1]);
        }
    }
};

/// Whether what `call` calls is written. It is called once.
template <class Call>
bool written(Call call) {
    static const bool answer = [&] {
        try {
            call();
            return true;
        } catch (const lantern::unfinished&) {
            return false;
        }
    }();
    return answer;
}

/// Yours, and the library's for the rest. A part of the library that you would rather have: `struct mix : yours { using library::reflected; };`
struct yours : library {
#if __has_include(<lab01_picture/picture.hpp>)
    static bool lab01() { return written([] { (void)lab01::ppm({1, 1}, std::array{glm::vec3(0)}); }); }
    static std::string ppm(const lantern::image& picture) { return lab01() ? lab01::ppm(picture.size(), picture.pixels()) : library::ppm(picture); }
#endif

#if __has_include(<lab03_whitted/whitted.hpp>)
    static bool lab03() { return written([] { (void)lab03::refracted({0, -1, 0}, {0, 1, 0}, 1), (void)lab03::reflectance(1, 0.5f); }); }
    static std::optional<std::pair<glm::vec3, float>> refracted(glm::vec3 in, glm::vec3 normal, float ratio) {
        if (!lab03()) return library::refracted(in, normal, ratio);
        const auto bent = lab03::refracted(in, normal, ratio);
        return bent ? std::optional(std::pair(*bent, lab03::reflectance(-glm::dot(in, normal), ratio))) : std::nullopt;
    }
#endif

#if __has_include(<lab04_sampling/sampling.hpp>)
    static bool lab04() { return written([] { (void)lab04::jittered(0, 1, {}); }); }
    static glm::vec2 jittered(std::uint32_t i, std::uint32_t side, glm::vec2 xi) { return lab04() ? lab04::jittered(i, side, xi) : library::jittered(i, side, xi); }
#endif

#if __has_include(<lab05_soft_shadows/soft_shadows.hpp>)
    static bool lab05() { return written([] { (void)lab05::point_on({}, {}), (void)lab05::irradiance({}, {}, {1, 1, 1}, {0, 1, 0}); }); }
    static glm::vec3 point_on(const lantern::rectangle& lamp, glm::vec2 xi) {
        return lab05() ? lab05::point_on({lamp.corner, lamp.u, lamp.v, {}}, xi) : library::point_on(lamp, xi);
    }
    static glm::vec3 irradiance(const lantern::rectangle& lamp, glm::vec3 radiance, glm::vec3 on_lamp, glm::vec3 position, glm::vec3 normal) {
        return lab05() ? lab05::irradiance({lamp.corner, lamp.u, lamp.v, radiance}, on_lamp, position, normal)
                       : library::irradiance(lamp, radiance, on_lamp, position, normal);
    }
#endif

#if __has_include(<lab06_glossy/glossy.hpp>)
    static bool lab06() { return written([] { (void)lab06::reflected({0, -1, 0}, {0, 1, 0}, 0.1f, {}); }); }
    static glm::vec3 reflected(glm::vec3 in, glm::vec3 normal, float width, glm::vec2 xi) {
        return lab06() ? lab06::reflected(in, normal, width, xi) : library::reflected(in, normal, width, xi);
    }
#endif

#if __has_include(<lab07_lens/lens.hpp>)
    static bool lab07() { return written([] { (void)lab07::through_lens({}, glm::mat3(1), {}, 1, 1, {}); }); }
    static lantern::ray through_lens(glm::vec3 eye, const glm::mat3& axes, glm::vec2 film, float radius, float focus, glm::vec2 xi) {
        return lab07() ? lab07::through_lens(eye, axes, film, radius, focus, xi) : library::through_lens(eye, axes, film, radius, focus, xi);
    }
#endif

#if __has_include(<lab08_shutter/shutter.hpp>)
    static bool lab08() {
        return written([] { (void)lab08::moment(0, 1, 0), (void)lab08::intersect({{}, {}, 1}, {{0, 0, 2}, {0, 0, -1}, 0}), (void)lab08::bounds({{}, {}, 1}, 0, 1); });
    }
    static float moment(float open, float close, float xi) { return lab08() ? lab08::moment(open, close, xi) : library::moment(open, close, xi); }
    static std::optional<float> meet(glm::vec3 center, glm::vec3 velocity, float radius, glm::vec3 origin, glm::vec3 direction, float time) {
        return lab08() ? lab08::intersect({center, velocity, radius}, {origin, direction, time}) : library::meet(center, velocity, radius, origin, direction, time);
    }
    static std::pair<glm::vec3, glm::vec3> bounds(glm::vec3 center, glm::vec3 velocity, float radius, float open, float close) {
        return lab08() ? lab08::bounds({center, velocity, radius}, open, close) : library::bounds(center, velocity, radius, open, close);
    }
#endif

#if __has_include(<lab10_hierarchy/hierarchy.hpp>)
    using tree = lab10::tree;
    static bool lab10() {
        return written([] {
            const std::array boxes{lantern::aabb{{0, 0, 0}, {1, 1, 1}}, lantern::aabb{{2, 0, 0}, {3, 1, 1}}};
            traverse_mine(built_by_me(boxes), {}, [](std::uint32_t) { return std::optional(0.0f); }, [](std::uint32_t, lantern::interval rest) { return rest; });
        });
    }
    static tree build(std::span<const lantern::aabb> boxes) { return lab10() ? built_by_me(boxes) : library::build<tree>(boxes); }
    static void traverse(const tree& t, lantern::interval range, auto&& enter, auto&& offer) {
        if (lab10()) traverse_mine(t, range, enter, offer);
        else library::traverse(t, range, enter, offer);
    }
    static tree built_by_me(std::span<const lantern::aabb> boxes) {
        return lab10::build(boxes, [&](std::span<const std::uint32_t> group) { return lab10::at_least_cost(boxes, group); }, 1);
    }
    static void traverse_mine(const tree& t, lantern::interval range, auto&& enter, auto&& offer) {
        lab10::traverse(t, range, std::ref(enter), std::ref(offer));  // by reference: std::function has nothing to allocate
    }
#endif

#if __has_include(<lab13_error/error.hpp>)
    static bool lab13() { return written([] { (void)lab13::stratum(0, 1, 0, {}); }); }
    static std::uint32_t stratum(std::uint32_t i, std::uint32_t count, std::uint32_t purpose, glm::uvec2 pixel) {
        return lab13() ? lab13::stratum(i, count, purpose, pixel) : library::stratum(i, count, purpose, pixel);
    }
    static double slope(std::span<const std::uint32_t> samples, std::span<const double> errors) {  // for the picture of the error alone
        const std::array<std::uint32_t, 2> counts{1, 4};
        const std::array<double, 2> halved{1, 0.5};
        return written([&] { (void)lab13::slope(counts, halved); }) ? lab13::slope(samples, errors) : library::slope(samples, errors);
    }
#endif
};

}  // namespace parts
