// SPDX-License-Identifier: MIT
#pragma once
// Who runs in `trace`: every structure of the library, and over triangles Embree, too, where it is installed.

#include "scenes.hpp"

#include <lantern/bounding_sphere.hpp>
#include <lantern/bvh.hpp>
#include <lantern/closest.hpp>
#include <lantern/grid.hpp>
#include <lantern/interval.hpp>
#include <lantern/kd_tree.hpp>
#include <lantern/mesh.hpp>
#include <lantern/obb.hpp>
#include <lantern/octree.hpp>
#include <lantern/ray.hpp>
#include <lantern/wide_bvh.hpp>

#if defined(LANTERN_HAS_EMBREE)
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <atomic>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <ranges>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace trace {

/// A structure over surfaces. What it says of a ray: t of the closest hit, infinity for a miss; of a shadow ray 0 for a hit.
class rival {
public:
    rival() = default;
    rival(const rival&) = delete;
    rival& operator=(const rival&) = delete;
    virtual ~rival() = default;
    virtual void closest(std::span<const ray> rays, std::span<float> out) const = 0;
    virtual void occluded(std::span<const ray> rays, std::span<float> out) const = 0;
    virtual void count(std::span<const ray> rays, bool any, lantern::probe&) const = 0;
    [[nodiscard]] virtual std::size_t bytes() const = 0;

    void answer(const ray_set& set, std::span<const ray> rays, std::span<float> out) const {
        if (set.any) occluded(rays, out);
        else closest(rays, out);
    }
};

/// All that a structure keeps, besides itself.
template <class Structure>
[[nodiscard]] std::size_t bytes_of(const Structure& s) {
    if constexpr (std::same_as<Structure, lantern::every>) return 0;
    else if constexpr (requires { s.bytes(); }) return s.bytes();
    else if constexpr (requires { s.nodes(); }) return s.nodes().size_bytes() + s.indices().size_bytes();
    else return s.entries().size_bytes() + 4 * std::size_t(s.cells().x) * std::size_t(s.cells().y) * std::size_t(s.cells().z);
}

/// A structure of the library, and the surfaces as it is handed them.
template <class Structure, class Surfaces>
class ours : public rival {
public:
    ours(const Surfaces& surfaces, Structure structure) : surfaces_(surfaces), structure_(std::move(structure)) {}
    void closest(std::span<const ray> rays, std::span<float> out) const override {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const auto h = lantern::closest(structure_, surfaces_, rays[i], lantern::interval{});
            out[i] = h ? h->t : lantern::infinity;
        }
    }
    void occluded(std::span<const ray> rays, std::span<float> out) const override {
        for (std::size_t i = 0; i < rays.size(); ++i)
            out[i] = lantern::occluded(structure_, surfaces_, rays[i], whole_shadow) ? 0 : lantern::infinity;
    }
    void count(std::span<const ray> rays, bool any, lantern::probe& counter) const override {
        for (const ray& r : rays) {
            if (any) (void)lantern::occluded(structure_, surfaces_, r, whole_shadow, counter);
            else (void)lantern::closest(structure_, surfaces_, r, lantern::interval{}, counter);
        }
    }
    [[nodiscard]] std::size_t bytes() const override { return bytes_of(structure_); }

protected:
    const Surfaces& surfaces_;
    Structure structure_;
};

/// wide_bvh with all rays handed in at once.
class span_of_rays : public ours<lantern::wide_bvh, mesh> {
public:
    span_of_rays(const mesh& m, lantern::wide_bvh tree) : ours(m, std::move(tree)) {}
    void closest(std::span<const ray> rays, std::span<float> out) const override {
        std::vector<std::optional<lantern::nearest>> hits(rays.size());
        lantern::closest(structure_, rays, hits);
        for (std::size_t i = 0; i < rays.size(); ++i) out[i] = hits[i] ? hits[i]->t : lantern::infinity;
    }
};

/// The same with surfaces of its own, in the order of the tree.
template <class Surface>
class in_order : public rival {
public:
    explicit in_order(const auto& surfaces) : tree_(surfaces), surfaces_(tree_.put_in_order(surfaces)), same_(surfaces_, tree_) {}
    void closest(std::span<const ray> rays, std::span<float> out) const override { same_.closest(rays, out); }
    void occluded(std::span<const ray> rays, std::span<float> out) const override { same_.occluded(rays, out); }
    void count(std::span<const ray> rays, bool any, lantern::probe& counter) const override { same_.count(rays, any, counter); }
    [[nodiscard]] std::size_t bytes() const override { return bytes_of(tree_) + std::span(surfaces_).size_bytes(); }

private:
    lantern::bvh<> tree_;
    std::vector<Surface> surfaces_;
    ours<lantern::bvh<>, std::vector<Surface>> same_;
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
    void closest(std::span<const ray> rays, std::span<float> out) const override {
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
    void occluded(std::span<const ray> rays, std::span<float> out) const override {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            RTCRay r = prepared(rays[i], whole_shadow.max);
            rtcOccluded1(scene_, &context, &r);
            out[i] = r.tfar < 0 ? 0 : lantern::infinity;
        }
    }
    void count(std::span<const ray>, bool, lantern::probe&) const override {}  // it does not tell
    [[nodiscard]] std::size_t bytes() const override { return static_cast<std::size_t>(bytes_.load()); }

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

template <class Surfaces>
struct contender {
    std::string name;
    std::function<std::unique_ptr<rival>(const Surfaces&, unsigned threads)> build;
    bool threaded = false;            ///< whether it can be built by several threads
    std::uint32_t most = 0xffffffff;  ///< surfaces: with more, its build takes minutes
};

/// One structure of the library, built as `how` says.
template <class Structure, class Surfaces>
[[nodiscard]] contender<Surfaces> structure(std::string name, auto... how) {
    const auto build = [=](const Surfaces& s, unsigned) { return std::make_unique<ours<Structure, Surfaces>>(s, Structure(s, how...)); };
    return {std::move(name), build};
}

/// Those that take any surfaces.
template <class Surfaces>
[[nodiscard]] std::vector<contender<Surfaces>> for_any_surfaces() {
    using lantern::every;
    return {
        {"every", [](const Surfaces& s, unsigned) {
             return std::make_unique<ours<every, Surfaces>>(s, every{static_cast<std::uint32_t>(s.size())});
         }},
        structure<lantern::bvh<>, Surfaces>("bvh"),
        {"bvh in order", [](const Surfaces& s, unsigned) { return std::make_unique<in_order<std::ranges::range_value_t<Surfaces>>>(s); }},
        structure<lantern::grid, Surfaces>("grid"),
        structure<lantern::octree, Surfaces>("octree"),
        structure<lantern::kd_tree, Surfaces>("kd_tree"),
    };
}

[[nodiscard]] inline std::vector<contender<mesh>> for_triangles() {
    using lantern::bvh, lantern::bvh_options, lantern::split, lantern::wide_bvh;
    std::vector<contender<mesh>> all = for_any_surfaces<mesh>();
    all.push_back(structure<bvh<>, mesh>("bvh middle", bvh_options{.rule = split::middle}));
    all.push_back(structure<bvh<>, mesh>("bvh median", bvh_options{.rule = split::median}));
    all.push_back(structure<bvh<>, mesh>("bvh bottom_up", bvh_options{.rule = split::bottom_up}));
    all.push_back(structure<bvh<lantern::bounding_sphere>, mesh>("bvh of spheres"));
    all.back().most = 50'000;
    all.push_back(structure<bvh<lantern::obb>, mesh>("bvh of obb"));
    all.back().most = 50'000;
    all.push_back({"wide_bvh", [](const mesh& m, unsigned threads) {
                       return std::make_unique<ours<wide_bvh, mesh>>(m, wide_bvh(m, lantern::wide_bvh_options{.threads = threads}));
                   }, true});
    all.push_back({"wide_bvh span", [](const mesh& m, unsigned threads) {
                       return std::make_unique<span_of_rays>(m, wide_bvh(m, lantern::wide_bvh_options{.threads = threads}));
                   }, true});
#if defined(LANTERN_HAS_EMBREE)
    all.push_back({"embree", [](const mesh& m, unsigned threads) { return std::make_unique<embree>(m, false, threads); }, true});
    all.push_back({"embree robust", [](const mesh& m, unsigned threads) { return std::make_unique<embree>(m, true, threads); }, true});
#endif
    return all;
}

}  // namespace trace
