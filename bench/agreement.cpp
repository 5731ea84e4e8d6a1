// SPDX-License-Identifier: MIT
// Does every structure find what brute force finds? Random and adversarial rays, a million for each family of scenes, still ones
// and moving ones. The tests ask the same of the same scenes with fewer rays.
//     agreement [--rays N] [--threads N] [--seed N] [--scene NAME] [--csv | --json] [--check]

#include "accelerator_scenes.hpp"
#include "meshes.hpp"

#include "command_line.hpp"

#include <lantern/aabb.hpp>
#include <lantern/bounding_sphere.hpp>
#include <lantern/bvh.hpp>
#include <lantern/closest.hpp>
#include <lantern/grid.hpp>
#include <lantern/kd_tree.hpp>
#include <lantern/moving_aabb.hpp>
#include <lantern/obb.hpp>
#include <lantern/octree.hpp>
#include <lantern/ray.hpp>
#include <lantern/render.hpp>
#include <lantern/triangle.hpp>
#include <lantern/validate.hpp>
#include <lantern/wide_bvh.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

using accelerator_laws::adversarial;
using lantern::aabb;
using lantern::bvh;
using lantern::interval;

struct options : bench::output {
    std::uint64_t rays = 1'000'000;
    std::uint64_t seed = 1;
    unsigned threads = 0;
    std::string scene;  ///< only this one
};

struct outcome {
    std::string scene;
    std::size_t surfaces = 0;
    std::uint64_t rays = 0, hits = 0;
    std::vector<std::pair<std::string, std::uint64_t>> wrong;  ///< of each structure
    std::string first;                                         ///< that was wrong: what the tests would print
};

/// A structure: what is wrong with its answer to a ray, given the right one; nothing where nothing is.
template <class Ray>
struct witness {
    std::string name;
    std::function<std::string(const Ray&, interval, const std::optional<lantern::nearest>&)> ask;
};

template <class Ray, class Surfaces>
witness<Ray> witness_of(const std::string& scene, std::string name, const Surfaces& surfaces, auto structure) {
    return {std::move(name), [&scene, &surfaces, structure = std::move(structure)](const Ray& r, interval range, const auto& expected) {
                return accelerator_laws::disagreement(scene, structure, surfaces, r, range, expected);
            }};
}

/// Those that take any surfaces.
template <class Ray, class Surfaces>
std::vector<witness<Ray>> witnesses(const std::string& scene, const Surfaces& s) {
    using lantern::split;
    std::vector<witness<Ray>> all;
    const std::vector<std::pair<std::string, split>> rules{{"bvh", split::surface_area}, {"bvh middle", split::middle},
                                                           {"bvh median", split::median}, {"bvh bottom_up", split::bottom_up}};
    for (const auto& [name, rule] : rules) all.push_back(witness_of<Ray>(scene, name, s, bvh<>(s, {.rule = rule})));
    all.push_back(witness_of<Ray>(scene, "bvh of spheres", s, bvh<lantern::bounding_sphere>(s)));
    all.push_back(witness_of<Ray>(scene, "bvh of obb", s, bvh<lantern::obb>(s)));
    all.push_back(witness_of<Ray>(scene, "grid", s, lantern::grid(s)));
    all.push_back(witness_of<Ray>(scene, "octree", s, lantern::octree(s)));
    all.push_back(witness_of<Ray>(scene, "kd_tree", s, lantern::kd_tree(s)));
    return all;
}

template <class Ray, class Surfaces>
outcome examine(const std::string& scene, const Surfaces& surfaces, const std::vector<witness<Ray>>& all, bool only_ahead, const options& wish) {
    outcome o{scene, surfaces.size(), wish.rays, 0, {}, {}};
    for (const auto& w : all) o.wrong.push_back({w.name, 0});
    const std::vector<aabb> parts = accelerator_laws::boxes(surfaces);
    aabb around;
    for (const aabb& box : parts) around = enclose(around, box);
    const lantern::every every{static_cast<std::uint32_t>(surfaces.size())};
    dice d{.state = wish.seed};
    for (const char c : scene) d.state = d.bits() ^ static_cast<std::uint64_t>(c);  // each scene its own rays
    const glm::vec3 size = empty(around) ? glm::vec3(1) : around.max - around.min, middle = empty(around) ? glm::vec3(0) : center(around);
    for (std::uint64_t i = 0; i < wish.rays; ++i) {
        Ray r;
        static_cast<lantern::ray&>(r) = adversarial(d, parts, around);
        if (i % 2 == 0) r.origin = middle + size * d.in_cube(2), r.direction = middle + size * d.in_cube(0.5) - r.origin;
        if constexpr (requires { r.time; }) r.time = d.below(8) == 0 ? float(d.below(2)) : d.between(0, 1);
        const float t = d.magnitude_between(-3, 1);
        const interval range = i % 5 == 0 ? interval{t, 3 * t} : i % 5 == 1 ? interval{0, 1} : i % 5 == 2 && !only_ahead ? interval{-t, t} : interval{};
        const auto expected = closest(every, surfaces, r, range);
        o.hits += expected.has_value();
        for (std::size_t k = 0; k < all.size(); ++k) {
            const std::string problem = all[k].ask(r, range, expected);
            if (problem.empty()) continue;
            ++o.wrong[k].second;
            if (o.first.empty()) o.first = all[k].name + "\n" + problem;
        }
    }
    return o;
}

std::vector<outcome> examine_all(const options& wish) {
    std::vector<std::function<outcome()>> tasks;
    const auto wished = [&](const std::string& name) { return wish.scene.empty() || wish.scene == name; };
    for (const auto& s : accelerator_laws::scenes())
        if (wished(s.name)) tasks.push_back([=] { return examine<lantern::ray>(s.name, s.surfaces, witnesses<lantern::ray>(s.name, s.surfaces), false, wish); });
    for (const auto& s : accelerator_laws::moving_scenes())
        if (wished(s.name)) tasks.push_back([=] {
            auto all = witnesses<lantern::timed_ray>(s.name, s.surfaces);
            all.push_back(witness_of<lantern::timed_ray>(s.name, "bvh of moving boxes", s.surfaces, bvh<lantern::moving_aabb>(s.surfaces)));
            return examine<lantern::timed_ray>(s.name, s.surfaces, all, false, wish);
        });
    const std::array<std::pair<std::string, lantern::mesh>, 5> meshes{{{"mesh: sphere", meshes::sphere(6, 0.01f)},
                                                                       {"mesh: terrain", meshes::terrain(12)},
                                                                       {"mesh: soup", meshes::soup(300, 0.3)},
                                                                       {"mesh: slivers", meshes::slivers(150)},
                                                                       {"mesh: tiny sphere", meshes::placed(meshes::sphere(6), 1e-15f)}}};
    for (const auto& [name, m] : meshes)
        if (wished(name)) tasks.push_back([=, name = name, m = m] {
            auto all = witnesses<lantern::ray>(name, m);
            all.push_back(witness_of<lantern::ray>(name, "wide_bvh", m, lantern::wide_bvh(m, {.threads = 1})));
            return examine<lantern::ray>(name, m, all, true, wish);  // wide_bvh looks only ahead
        });
    if (tasks.empty()) lantern::refuse("--scene", "'" + wish.scene + "'", "the name of a family of scenes");
    std::vector<outcome> all(tasks.size());
    lantern::in_parallel(tasks.size(), wish.threads, [&](std::size_t i) { all[i] = tasks[i](); });
    return all;
}

std::uint64_t count_wrong(const outcome& o) {
    std::uint64_t sum = 0;
    for (const auto& w : o.wrong) sum += w.second;
    return sum;
}

void print_table(const std::vector<outcome>& all) {
    std::printf("%-32s%10s%12s%12s%12s%8s\n", "", "surfaces", "rays", "hits", "structures", "wrong");
    for (const outcome& o : all) {
        std::printf("%-32s%10zu%12llu%12llu%12zu%8llu\n", o.scene.c_str(), o.surfaces, static_cast<unsigned long long>(o.rays),
                    static_cast<unsigned long long>(o.hits), o.wrong.size(), static_cast<unsigned long long>(count_wrong(o)));
        for (const auto& [name, wrong] : o.wrong)
            if (wrong > 0) std::printf("    %s: %llu\n", name.c_str(), static_cast<unsigned long long>(wrong));
        if (!o.first.empty()) std::printf("    the first:\n%s\n", o.first.c_str());
    }
}

void print_csv(const std::vector<outcome>& all) {
    std::printf("scene,surfaces,rays,hits,structure,wrong\n");
    for (const outcome& o : all)
        for (const auto& [name, wrong] : o.wrong)
            std::printf("\"%s\",%zu,%llu,%llu,%s,%llu\n", o.scene.c_str(), o.surfaces, static_cast<unsigned long long>(o.rays),
                        static_cast<unsigned long long>(o.hits), name.c_str(), static_cast<unsigned long long>(wrong));
}

void print_json(const std::vector<outcome>& all) {
    const char* comma = "";
    std::printf("{\"rows\":[");
    for (const outcome& o : all)
        for (const auto& [name, wrong] : o.wrong) {
            std::printf("%s\n{\"scene\":\"%s\",\"surfaces\":%zu,\"rays\":%llu,\"hits\":%llu,\"structure\":\"%s\",\"wrong\":%llu}", comma,
                        o.scene.c_str(), o.surfaces, static_cast<unsigned long long>(o.rays), static_cast<unsigned long long>(o.hits),
                        name.c_str(), static_cast<unsigned long long>(wrong));
            comma = ",";
        }
    std::printf("]}\n");
}

bool passes(const std::vector<outcome>& all) {
    std::uint64_t wrong = 0, rays = 0;
    for (const outcome& o : all) {
        wrong += count_wrong(o);
        rays += o.rays;
        if (count_wrong(o) > 0) std::fprintf(stderr, "FAILED  %s\n%s\n", o.scene.c_str(), o.first.c_str());
    }
    if (wrong == 0) std::fprintf(stderr, "passed: %zu families, %llu rays, every structure as brute force\n", all.size(), static_cast<unsigned long long>(rays));
    return wrong == 0;
}

options parse(int argc, char** argv) {
    return bench::parse<options>(argc, argv, "--rays N, --threads N, --seed N, --scene NAME", [](options& o, std::string_view word, auto next) {
        if (word == "--rays") o.rays = bench::number<std::uint64_t>(word, next(), 1);
        else if (word == "--threads") o.threads = bench::number<unsigned>(word, next(), 1);
        else if (word == "--scene") o.scene = next();
        else if (word == "--seed") o.seed = bench::number<std::uint64_t>(word, next(), 0);
        else return false;
        return true;
    });
}

}  // namespace

int main(int argc, char** argv) {
    return bench::run("agreement", [&] {
        const options wish = parse(argc, argv);
        const std::vector<outcome> all = examine_all(wish);
        if (wish.json) print_json(all);
        else if (wish.csv) print_csv(all);
        else print_table(all);
        return !wish.check || passes(all);
    });
}
