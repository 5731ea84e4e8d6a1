// SPDX-License-Identifier: MIT
// How fast a ray finds what it hits, and how often it finds the wrong thing: the library's structures, and Embree where it is
// installed, over the same surfaces and rays, in turns.
//     trace [--triangles N,... | --sweep] [--scene NAME,...] [--structure NAME,...] [--rays N] [--rounds N] [--threads N,...]
//           [--budget MS] [--models FOLDER] [--obj FILE] [--csv | --json] [--save FILE] [--check]

#include "command_line.hpp"
#include "trace/contenders.hpp"
#include "trace/measure.hpp"
#include "trace/report.hpp"
#include "trace/scenes.hpp"

#include <lantern/mesh.hpp>
#include <lantern/validate.hpp>

#if defined(LANTERN_HAS_OBJ)
#include <lantern/obj.hpp>
#endif

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace {

struct options : bench::output {
    std::vector<std::uint32_t> sizes{200'000};
    std::vector<std::string> scenes, structures;  // none: all
    std::string models, obj, save;
    trace::effort how;
};

std::vector<std::string> words(std::string_view text) {
    std::vector<std::string> all;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(','), text.size());
        all.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return all;
}

/// Those whose names are wished for; refused where a wish is for none of them, and not for one of the `others`.
template <class Named>
std::vector<Named> wished(std::vector<Named> all, const std::vector<std::string>& names, const char* option, const std::vector<std::string>& others) {
    const auto has = [&](const std::string& name) { return std::any_of(all.begin(), all.end(), [&](const Named& n) { return n.name == name; }); };
    for (const std::string& name : names) {
        if (has(name) || std::find(others.begin(), others.end(), name) != others.end()) continue;
        std::string known;
        for (const Named& n : all) known.append(known.empty() ? "" : ", ").append(n.name);
        for (const std::string& n : others) known.append(", ").append(n);
        lantern::refuse(option, "'" + name + "'", "one of: " + known);
    }
    if (!names.empty()) std::erase_if(all, [&](const Named& n) { return std::find(names.begin(), names.end(), n.name) == names.end(); });
    return all;
}

std::vector<trace::row> measure(const options& wish) {
    std::vector<trace::scene<lantern::mesh>> meshes = trace::made_scenes();
    if (!wish.scenes.empty()) std::ranges::move(trace::other_scenes(), std::back_inserter(meshes));
    if (!wish.models.empty()) meshes.insert(meshes.begin(), trace::dragon(wish.models));
#if defined(LANTERN_HAS_OBJ)
    if (!wish.obj.empty()) meshes = {{wish.obj, [&](std::uint32_t) { return lantern::read_obj(wish.obj); }}};
#endif
    meshes = wished(std::move(meshes), wish.scenes, "--scene", {"field"});
    const auto for_triangles = wished(trace::for_triangles(), wish.structures, "--structure", {});
    std::vector<std::string> names;
    for (const auto& c : trace::for_triangles()) names.push_back(c.name);
    const auto for_spheres = wished(trace::for_any_surfaces<std::vector<lantern::sphere>>(), wish.structures, "--structure", names);
    const bool with_field = wish.obj.empty() && (wish.scenes.empty() || std::find(wish.scenes.begin(), wish.scenes.end(), "field") != wish.scenes.end());
    std::vector<trace::row> rows;
    for (const std::uint32_t size : wish.sizes) {
        const auto say = [&](const std::string& name) { std::fprintf(stderr, "%s, %u\n", name.c_str(), size); };
        for (const auto& s : meshes) say(s.name), trace::measure(s, size, for_triangles, wish.how, rows);
        if (with_field) say("field"), trace::measure(trace::field(), size, for_spheres, wish.how, rows);
    }
    return rows;
}

/// Ours are never wrong, and wide_bvh stays within its bytes.
bool passes(const std::vector<trace::row>& rows) {
    bool good = true;
    std::uint64_t checked = 0;
    for (const trace::row& r : rows) {
        checked += r.structure.starts_with("embree") ? 0 : r.checked;
        if (!r.structure.starts_with("embree") && (r.wrong > 0 || (r.structure == "wide_bvh" && r.bytes_per_triangle > 70))) {
            std::fprintf(stderr, "FAILED  %s, %s, %s: %.0f wrong, %.1f bytes a triangle\n", r.scene.c_str(), r.rays.c_str(),
                         r.structure.c_str(), r.wrong, r.bytes_per_triangle);
            good = false;
        }
    }
    if (good) std::fprintf(stderr, "passed: no wrong answer among %llu that were checked\n", static_cast<unsigned long long>(checked));
    return good;
}

options parse(int argc, char** argv) {
    const std::string own = "--triangles N,..., --sweep, --scene NAME,..., --structure NAME,..., --rays N, --rounds N, --threads N,..., --budget MS, --models FOLDER, --save FILE, "
                            "--obj FILE (with tinyobjloader)";
    return bench::parse<options>(argc, argv, own, [](options& o, std::string_view word, auto next) {
        const auto numbers = [&](auto& list) {
            list.clear();
            for (const std::string& n : words(next())) list.push_back(bench::number<std::uint32_t>(word, n, 1));
            if (list.empty()) lantern::refuse(std::string(word), "''", "one number or several");
        };
        if (word == "--triangles") numbers(o.sizes);
        else if (word == "--sweep") o.sizes = {1'000, 10'000, 100'000, 1'000'000};
        else if (word == "--scene") o.scenes = words(next());
        else if (word == "--structure") o.structures = words(next());
        else if (word == "--rays") o.how.rays = bench::number<std::uint32_t>(word, next(), 1);
        else if (word == "--rounds") o.how.rounds = bench::number<std::uint32_t>(word, next(), 1);
        else if (word == "--budget") {  // of a round for one kind of rays; brute force, at 10 ns a test, has as much
            const auto ms = bench::number<std::uint32_t>(word, next(), 1);
            o.how.seconds = ms / 1000.0, o.how.tests = ms * 1e5;
        }
        else if (word == "--threads") numbers(o.how.threads);
        else if (word == "--models") o.models = next();
        else if (word == "--save") o.save = next();
#if defined(LANTERN_HAS_OBJ)
        else if (word == "--obj") o.obj = next();
#endif
        else return false;
        return true;
    });
}

}  // namespace

int main(int argc, char** argv) {
    return bench::run("trace", [&] {
        const options wish = parse(argc, argv);
        const std::vector<trace::row> rows = measure(wish);
        if (wish.json) trace::print_json(rows);
        else if (wish.csv) trace::print_csv(rows);
        else trace::print_table(rows);
        if (!wish.save.empty()) trace::save_json(rows, wish.save);
        return !wish.check || passes(rows);
    });
}
