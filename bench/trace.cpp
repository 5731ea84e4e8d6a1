// SPDX-License-Identifier: MIT
// How fast a ray finds its triangle, and how often it finds the wrong one: the library's structures, and Embree where
// it is installed, over the same meshes and rays, on one thread, in turns.
//     trace [--triangles N] [--rays N] [--rounds N] [--threads N] [--scene NAME] [--obj FILE] [--csv | --json] [--check]

#include "meshes.hpp"

#include "command_line.hpp"

#include <lantern/basis.hpp>
#include <lantern/bvh.hpp>
#include <lantern/closest.hpp>
#include <lantern/mesh.hpp>
#include <lantern/ray.hpp>
#include <lantern/surface.hpp>
#include <lantern/validate.hpp>
#include <lantern/wide_bvh.hpp>

#if defined(LANTERN_HAS_EMBREE)
#include <embree3/rtcore.h>
#endif
#if defined(LANTERN_HAS_OBJ)
#include <lantern/obj.hpp>
#endif

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

using lantern::interval;
using lantern::mesh;
using lantern::ray;

struct options : bench::output {
    std::uint32_t triangles = 200'000, rays = 200'000, rounds = 5;
    unsigned threads = 1;
    std::string scene, obj;
};

/// What a structure says of a ray: t of the closest hit, infinity for a miss. Shadow rays: 0 for a hit.
using answers = std::vector<float>;

class rival {
public:
    rival() = default;
    rival(const rival&) = delete;
    rival& operator=(const rival&) = delete;
    virtual ~rival() = default;
    virtual void closest(const std::vector<ray>& rays, answers& out) const = 0;
    virtual void occluded(const std::vector<ray>& rays, answers& out) const = 0;
    [[nodiscard]] virtual double bytes() const = 0;
};

constexpr interval whole_shadow{0, 0.999f};  // the rays end on the light

template <class Structure>
class ours : public rival {
public:
    ours(const mesh& m, auto&&... how) : mesh_(m), structure_(m, how...) {}
    void closest(const std::vector<ray>& rays, answers& out) const override {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const auto h = lantern::closest(structure_, mesh_, rays[i], interval{});
            out[i] = h ? h->t : lantern::infinity;
        }
    }
    void occluded(const std::vector<ray>& rays, answers& out) const override {
        for (std::size_t i = 0; i < rays.size(); ++i)
            out[i] = lantern::occluded(structure_, mesh_, rays[i], whole_shadow) ? 0 : lantern::infinity;
    }
    [[nodiscard]] double bytes() const override {
        if constexpr (requires { structure_.bytes(); })
            return static_cast<double>(structure_.bytes());
        else
            return static_cast<double>(structure_.nodes().size_bytes() + structure_.indices().size_bytes());
    }

    [[nodiscard]] const Structure& structure() const { return structure_; }

private:
    const mesh& mesh_;
    Structure structure_;
};

/// wide_bvh with all rays handed in at once.
class span_of_rays : public ours<lantern::wide_bvh> {
public:
    using ours::ours;
    void closest(const std::vector<ray>& rays, answers& out) const override {
        std::vector<std::optional<lantern::nearest>> hits(rays.size());
        lantern::closest(structure(), rays, hits);
        for (std::size_t i = 0; i < rays.size(); ++i) out[i] = hits[i] ? hits[i]->t : lantern::infinity;
    }
};

#if defined(LANTERN_HAS_EMBREE)
class embree : public rival {
public:
    embree(const mesh& m, bool robust, unsigned threads) {
        device_ = rtcNewDevice(("threads=" + std::to_string(threads)).c_str());
        if (device_ == nullptr) throw std::runtime_error("Embree: no device");
        rtcSetDeviceMemoryMonitorFunction(
            device_, [](void* of, ssize_t more, bool) { static_cast<embree*>(of)->bytes_ += more; return true; }, this);
        scene_ = rtcNewScene(device_);
        rtcSetSceneFlags(scene_, robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        void* const v = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, m.vertices().size());
        std::copy(m.vertices().begin(), m.vertices().end(), static_cast<glm::vec3*>(v));
        void* const t = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, m.size());
        std::copy(m.triangles().begin(), m.triangles().end(), static_cast<glm::uvec3*>(t));
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
        bytes_ -= static_cast<std::int64_t>(12 * (m.vertices().size() + m.size()));  // nobody's mesh is counted
    }
    ~embree() override {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    void closest(const std::vector<ray>& rays, answers& out) const override {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            RTCRayHit h;
            h.ray = prepared(rays[i], lantern::infinity);
            h.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            h.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(scene_, &context, &h);
            out[i] = h.hit.geomID == RTC_INVALID_GEOMETRY_ID ? lantern::infinity : h.ray.tfar;
        }
    }
    void occluded(const std::vector<ray>& rays, answers& out) const override {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            RTCRay r = prepared(rays[i], whole_shadow.max);
            rtcOccluded1(scene_, &context, &r);
            out[i] = r.tfar < 0 ? 0 : lantern::infinity;
        }
    }
    [[nodiscard]] double bytes() const override { return static_cast<double>(bytes_.load()); }

private:
    static RTCRay prepared(const ray& r, float far) {
        RTCRay out{};
        out.org_x = r.origin.x;
        out.org_y = r.origin.y;
        out.org_z = r.origin.z;
        out.dir_x = r.direction.x;
        out.dir_y = r.direction.y;
        out.dir_z = r.direction.z;
        out.tfar = far;
        out.mask = 0xffffffff;
        return out;
    }
    RTCDevice device_ = nullptr;
    RTCScene scene_ = nullptr;
    std::atomic<std::int64_t> bytes_ = 0;
};
#endif

struct contender {
    std::string name;
    std::function<std::unique_ptr<rival>(const mesh&)> build;
};

std::vector<contender> contenders(const options& wish) {
    const unsigned threads = wish.threads;
    std::vector<contender> all{
        {"bvh", [](const mesh& m) { return std::make_unique<ours<lantern::bvh<>>>(m); }},
        {"wide_bvh", [=](const mesh& m) {
             return std::make_unique<ours<lantern::wide_bvh>>(m, lantern::wide_bvh_options{.threads = threads});
         }},
        {"wide_bvh span", [=](const mesh& m) { return std::make_unique<span_of_rays>(m, lantern::wide_bvh_options{.threads = threads}); }},
    };
#if defined(LANTERN_HAS_EMBREE)
    all.push_back({"embree", [=](const mesh& m) { return std::make_unique<embree>(m, false, threads); }});
    all.push_back({"embree robust", [=](const mesh& m) { return std::make_unique<embree>(m, true, threads); }});
#endif
    return all;
}

struct scene {
    std::string name;
    std::function<mesh()> make;
    glm::vec3 eye, target;
};

std::vector<scene> scenes(const options& wish) {
    const double n = wish.triangles;
    const auto side = [=](double per_square) { return static_cast<std::uint32_t>(std::max(1.0, std::sqrt(n / per_square))); };
    std::vector<scene> all{
        {"sphere", [=] { return meshes::sphere(side(8), 0.002f); }, {0, 0.5f, 2.5f}, {0, 0, 0}},
        {"terrain", [=] { return meshes::terrain(side(2)); }, {-0.2f, 0.5f, -0.3f}, {0.5f, 0, 0.5f}},
        {"soup", [=] { return meshes::soup(wish.triangles, 2 / std::cbrt(n)); }, {0, 0.5f, 3}, {0, 0, 0}},
        {"slivers", [=] { return meshes::slivers(wish.triangles / 10); }, {0, 0.5f, 3}, {0, 0, 0}},
    };
#if defined(LANTERN_HAS_OBJ)
    if (!wish.obj.empty()) {
        const auto m = std::make_shared<mesh>(lantern::read_obj(wish.obj));
        const lantern::aabb box = bounds(*m);
        all = {{wish.obj, [=] { return *m; }, center(box) + 0.8f * (box.max - box.min), center(box)}};
    }
#endif
    if (wish.scene.empty()) return all;
    std::erase_if(all, [&](const scene& s) { return s.name != wish.scene; });
    if (all.empty()) lantern::refuse("--scene", "'" + wish.scene + "'", "sphere, terrain, soup or slivers");
    return all;
}

struct ray_set {
    std::string name;
    std::vector<ray> rays;
    bool any = false;
};

/// Rays that a picture needs: through its pixels, onwards from there in all directions, to a light, and the second kind
/// in disorder.
std::vector<ray_set> ray_sets(const scene& s, const mesh& m, const lantern::wide_bvh& tree, const options& wish) {
    ray_set primary{"primary", {}}, bounce{"bounce", {}}, shadow{"shadow", {}, true};
    const auto side = static_cast<std::uint32_t>(std::max(1.0, std::sqrt(double(wish.rays))));
    const lantern::basis axes = lantern::basis_from(s.target - s.eye);
    dice d{.state = 11};
    const glm::vec3 light = center(bounds(m)) + 2.0f * (bounds(m).max - bounds(m).min);
    for (std::uint32_t j = 0; j < side; ++j)
        for (std::uint32_t i = 0; i < side; ++i) {
            const float x = ((float(i) + 0.5f) / float(side) - 0.5f) * 0.7f, y = ((float(j) + 0.5f) / float(side) - 0.5f) * 0.7f;
            primary.rays.push_back({s.eye, lantern::unit(axes.w + x * axes.u + y * axes.v)});
        }
    for (const ray& r : primary.rays)
        if (const auto h = closest(tree, r)) {
            const glm::vec3 n = glm::dot(h->normal, r.direction) < 0 ? h->normal : -h->normal;
            const glm::vec3 way = lantern::unit(n + 0.999f * glm::vec3(d.on_sphere()));
            bounce.rays.push_back({leave(*h, way), way});
            const glm::vec3 to = light + 0.2f * d.in_cube(), from = leave(*h, to - h->point);
            shadow.rays.push_back({from, to - from});
        }
    ray_set shuffled{"shuffled", bounce.rays};
    for (std::size_t i = shuffled.rays.size(); i > 1; --i)
        std::swap(shuffled.rays[i - 1], shuffled.rays[d.below(static_cast<std::uint32_t>(i))]);
    return {primary, bounce, shadow, shuffled};
}

double seconds(auto&& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Of this process alone: others may have the processor meanwhile.
double processor_seconds(auto&& work) {
    const std::clock_t begin = std::clock();
    work();
    return std::max(1.0, static_cast<double>(std::clock() - begin)) / static_cast<double>(CLOCKS_PER_SEC);
}

double median(std::vector<double> times) {
    std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
    return times[times.size() / 2];
}

struct row {
    std::string scene, structure, rays;
    double mrays = 0, wrong = 0, bytes_per_triangle = 0, build_ms = 0;
    unsigned threads = 1;
};

/// The right answer: every triangle, in double precision.
float truth(const mesh& m, const ray& r, bool any) {
    const lantern::every all{static_cast<std::uint32_t>(m.size())};
    if (any) return lantern::occluded(all, m, r, whole_shadow) ? 0 : lantern::infinity;
    const auto h = lantern::closest(all, m, r);
    return h ? h->t : lantern::infinity;
}

/// A hit for a miss, a miss for a hit, or another place altogether.
bool differ(float a, float b) { return a != b && !(std::abs(a - b) <= 1e-3f * std::min(a, b)); }

/// How many of all rays each structure gets wrong. Wherever two structures disagree, brute force decides, and it looks at
/// some other rays as well; where that would take all day, at an even share of them.
std::vector<double> wrong_answers(const mesh& m, const ray_set& set, const std::vector<answers>& all) {
    std::vector<std::size_t> disputed, agreed;
    for (std::size_t i = 0; i < set.rays.size(); ++i) {
        const bool same = std::none_of(all.begin(), all.end(), [&](const answers& a) { return differ(a[i], all[0][i]); });
        (same ? agreed : disputed).push_back(i);
    }
    std::vector<double> wrong(all.size());
    const auto limit = static_cast<std::size_t>(std::max(20.0, 1e8 / static_cast<double>(m.size() + 1)));
    for (const auto* some : {&disputed, &agreed}) {
        const std::size_t step = std::max<std::size_t>(1, some->size() / limit);
        for (std::size_t k = 0; k < some->size(); k += step) {
            const std::size_t i = (*some)[k];
            const float right = truth(m, set.rays[i], set.any);
            for (std::size_t c = 0; c < all.size(); ++c) wrong[c] += differ(all[c][i], right) ? double(step) : 0;
        }
    }
    return wrong;
}

std::vector<row> measure(const options& wish) {
    std::vector<row> rows;
    const std::vector<contender> all = contenders(wish);
    for (const scene& s : scenes(wish)) {
        const mesh m = s.make();
        std::vector<std::unique_ptr<rival>> built;
        std::vector<double> build_ms;
        for (const contender& c : all) {
            std::vector<double> times;
            for (int i = 0; i < 3; ++i) {
                std::unique_ptr<rival> made;
                times.push_back(seconds([&] { made = c.build(m); }));
                if (i == 2) built.push_back(std::move(made));
            }
            build_ms.push_back(1000 * median(times));
        }
        for (const ray_set& set : ray_sets(s, m, lantern::wide_bvh(m, {.threads = 1}), wish)) {
            std::vector<answers> said(all.size(), answers(set.rays.size()));
            std::vector<std::vector<double>> times(all.size());
            for (std::uint32_t round = 0; round < wish.rounds; ++round)
                for (std::size_t c = 0; c < all.size(); ++c)
                    times[c].push_back(processor_seconds([&] {
                        if (set.any)
                            built[c]->occluded(set.rays, said[c]);
                        else
                            built[c]->closest(set.rays, said[c]);
                    }));
            const std::vector<double> wrong = wrong_answers(m, set, said);
            for (std::size_t c = 0; c < all.size(); ++c)
                rows.push_back({s.name, all[c].name, set.name, static_cast<double>(set.rays.size()) / median(times[c]) / 1e6,
                                wrong[c], built[c]->bytes() / static_cast<double>(m.size()), build_ms[c], wish.threads});
        }
    }
    return rows;
}

void print_table(const std::vector<row>& rows, const options& wish) {
    std::printf("%u rays of a kind, median of %u rounds, one thread; build with %u\n\n%-10s%-10s%-15s%9s%9s%9s%10s\n", wish.rays,
                wish.rounds, wish.threads, "scene", "rays", "structure", "Mrays/s", "wrong", "bytes", "build ms");
    for (const row& r : rows)
        std::printf("%-10s%-10s%-15s%9.3f%9.0f%9.1f%10.1f\n", r.scene.c_str(), r.rays.c_str(), r.structure.c_str(), r.mrays,
                    r.wrong, r.bytes_per_triangle, r.build_ms);
}

void print_csv(const std::vector<row>& rows) {
    std::printf("scene,structure,rays,mrays,wrong,bytes_per_triangle,build_ms,threads\n");
    for (const row& r : rows)
        std::printf("%s,%s,%s,%.4f,%.0f,%.2f,%.3f,%u\n", r.scene.c_str(), r.structure.c_str(), r.rays.c_str(), r.mrays, r.wrong,
                    r.bytes_per_triangle, r.build_ms, r.threads);
}

void print_json(const std::vector<row>& rows) {
    std::printf("{\"rows\":[");
    const char* comma = "";
    for (const row& r : rows) {
        std::printf("%s\n{\"scene\":\"%s\",\"structure\":\"%s\",\"rays\":\"%s\",\"mrays\":%.4f,\"wrong\":%.0f,"
                    "\"bytes_per_triangle\":%.2f,\"build_ms\":%.3f,\"threads\":%u}",
                    comma, r.scene.c_str(), r.structure.c_str(), r.rays.c_str(), r.mrays, r.wrong, r.bytes_per_triangle,
                    r.build_ms, r.threads);
        comma = ",";
    }
    std::printf("]}\n");
}

/// Ours are never wrong, and wide_bvh stays within its bytes.
bool passes(const std::vector<row>& rows) {
    bool good = true;
    for (const row& r : rows)
        if (!r.structure.starts_with("embree") && (r.wrong > 0 || (r.structure == "wide_bvh" && r.bytes_per_triangle > 70))) {
            std::fprintf(stderr, "FAILED  %s, %s, %s: %.0f wrong, %.1f bytes a triangle\n", r.scene.c_str(), r.rays.c_str(),
                         r.structure.c_str(), r.wrong, r.bytes_per_triangle);
            good = false;
        }
    if (good) std::fprintf(stderr, "passed: no wrong answers\n");
    return good;
}

options parse(int argc, char** argv) {
    return bench::parse<options>(argc, argv, "--triangles N, --rays N, --rounds N, --threads N, --scene NAME, --obj FILE (with tinyobjloader)", [](options& o, std::string_view word, auto next) {
        if (word == "--triangles") o.triangles = bench::number<std::uint32_t>(word, next(), 1);
        else if (word == "--rays") o.rays = bench::number<std::uint32_t>(word, next(), 1);
        else if (word == "--rounds") o.rounds = bench::number<std::uint32_t>(word, next(), 1);
        else if (word == "--threads") o.threads = bench::number<std::uint32_t>(word, next(), 1);
        else if (word == "--scene") o.scene = next();
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
        const std::vector<row> rows = measure(wish);
        if (wish.json) print_json(rows);
        else if (wish.csv) print_csv(rows);
        else print_table(rows, wish);
        return !wish.check || passes(rows);
    });
}
