// SPDX-License-Identifier: MIT
// A part of a picture's samples, into a file of its own; lantern_merge puts the parts together.
//     shard FILE.shard [--samples FIRST:LAST | --part K/N] [--of SAMPLES]
// Part K of N: K from 0. Where N machines run this, each takes its own part: in a job array, or under mpirun, K is the number
// that the engine gives to each, such as $OMPI_COMM_WORLD_RANK or $SLURM_ARRAY_TASK_ID (examples/shards.sh).

#include <lantern/any_of.hpp>
#include <lantern/bvh.hpp>
#include <lantern/camera.hpp>
#include <lantern/diffuse.hpp>
#include <lantern/distribution.hpp>
#include <lantern/glass.hpp>
#include <lantern/glossy.hpp>
#include <lantern/moving.hpp>
#include <lantern/object.hpp>
#include <lantern/rectangle_light.hpp>
#include <lantern/shard.hpp>
#include <lantern/sky.hpp>
#include <lantern/sobol.hpp>
#include <lantern/sphere.hpp>

#include <charconv>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace {

struct wish {
    std::string path;
    std::uint32_t of = 64;
    lantern::sample_range range;
};

/// "3:17" or "3/17": two whole numbers with a mark between them.
std::pair<std::uint32_t, std::uint32_t> two_numbers(const std::string& option, std::string_view text, char mark) {
    std::uint32_t a = 0, b = 0;
    const char* const end = text.data() + text.size();
    const auto [middle, problem] = std::from_chars(text.data(), end, a);
    const bool first = problem == std::errc{} && middle != end && *middle == mark;
    const auto [rest, trouble] = first ? std::from_chars(middle + 1, end, b) : std::from_chars_result{middle, std::errc::invalid_argument};
    if (trouble != std::errc{} || rest != end) lantern::refuse(option, "'" + std::string(text) + "'", std::string("two whole numbers, as in 0") + mark + "16");
    return {a, b};
}

wish parse(int argc, char** argv) {
    wish w;
    std::string samples, part;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i], next = i + 1 < argc ? argv[i + 1] : "";
        if (word == "--samples") samples = next, ++i;
        else if (word == "--part") part = next, ++i;
        else if (word == "--of") w.of = two_numbers(word, next + ":0", ':').first, ++i;
        else if (word.starts_with("-") || !w.path.empty()) lantern::refuse("argument", "'" + word + "'", "FILE, --samples FIRST:LAST, --part K/N or --of SAMPLES");
        else w.path = word;
    }
    if (w.path.empty()) lantern::refuse("FILE", "''", "the name of a file to write");
    if (!samples.empty() && !part.empty()) lantern::refuse("--part", part, "left out where --samples is given");
    w.range = {0, w.of};
    if (!samples.empty()) {
        const auto [first, last] = two_numbers("--samples", samples, ':');
        w.range = {first, last};
    }
    if (!part.empty()) {
        const auto [k, n] = two_numbers("--part", part, '/');
        if (k >= n || n > w.of) lantern::refuse("--part", part, "K/N with K below N, and no more parts than samples");
        w.range = {static_cast<std::uint32_t>(std::uint64_t{w.of} * k / n), static_cast<std::uint32_t>(std::uint64_t{w.of} * (k + 1) / n)};
    }
    return w;
}

lantern::shard render(const wish& w) {
    using shape = lantern::any_of<lantern::sphere, lantern::moving<lantern::sphere>>;
    using material = std::variant<lantern::diffuse, lantern::glossy, lantern::glass>;
    const std::vector<lantern::object<shape, material>> things{
        {lantern::sphere{{0, -1000, 0}, 1000}, lantern::diffuse{{0.5f, 0.5f, 0.48f}}},
        {lantern::sphere{{-1.1f, 1, 0}, 1}, lantern::glossy{.color = {0.9f, 0.7f, 0.3f}, .width = 0.25f}},
        {lantern::sphere{{1.1f, 0.7f, 1.2f}, 0.7f}, lantern::glass{}},
        {lantern::moving{lantern::sphere{{1.4f, 0.6f, -1.5f}, 0.6f}, {0.7f, 0, 0}}, lantern::diffuse{{0.8f, 0.25f, 0.2f}}},
    };
    const std::vector lights{lantern::rectangle_light{{-2, 5, 1}, {2, 0, 0}, {0, 0, 2}, glm::vec3(12)}};
    const lantern::bvh tree{things};
    const lantern::distribution tracer{tree, things, lights, lantern::sky{}, {.ambient = glm::vec3(0.3f)}};
    const lantern::camera cam{lantern::view{.eye = {0, 1.6f, 7}, .target = {0.1f, 0.8f, 0}, .vertical_fov = 0.5f, .aspect = 1.5f},
                              lantern::thin_lens{.radius = 0.05f, .focus_distance = 6.5f}, lantern::shutter{}};
    return lantern::render_shard("three balls at noon, seed 0", {240, 160}, cam, lantern::sobol{.samples = w.of}, w.range, tracer);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const wish w = parse(argc, argv);
        lantern::write_shard(w.path, render(w));
        return 0;
    } catch (const std::invalid_argument& problem) {
        std::fprintf(stderr, "shard: %s\n", problem.what());
        return 2;
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "shard: %s\n", problem.what());
        return 1;
    }
}
