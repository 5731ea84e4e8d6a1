// SPDX-License-Identifier: MIT
#pragma once
// Lab 15: your ray tracer. Parts of all labs, fitted to the library's concepts, and left out where a scene does not need them.
// The handout is README.md in this folder.

#include <lantern/aabb.hpp>
#include <lantern/alternative.hpp>
#include <lantern/any_of.hpp>
#include <lantern/closest.hpp>
#include <lantern/coated.hpp>
#include <lantern/diffuse.hpp>
#include <lantern/emissive.hpp>
#include <lantern/hash.hpp>
#include <lantern/interval.hpp>
#include <lantern/light.hpp>
#include <lantern/material.hpp>
#include <lantern/object.hpp>
#include <lantern/ray.hpp>
#include <lantern/rectangle.hpp>
#include <lantern/samples.hpp>
#include <lantern/sky.hpp>
#include <lantern/surface.hpp>
#include <lantern/todo.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace lab15 {

/// The parts that you bring: static functions of one type, so that the compiler knows which are meant, and builds in nothing else.
/// parts.hpp in this folder holds yours of labs 04 to 13, and the library's where one is missing.
template <class P>
concept parts = requires(std::uint32_t n, float x, glm::vec2 xi, glm::vec3 v, glm::mat3 axes, const lantern::rectangle& flat, const typename P::tree& tree,
                         std::optional<float> (*enter)(std::uint32_t), lantern::interval (*offer)(std::uint32_t, lantern::interval)) {
    { P::jittered(n, n, xi) } -> std::same_as<glm::vec2>;                           // lab 04: i, side, xi
    { P::point_on(flat, xi) } -> std::same_as<glm::vec3>;                           // lab 05: lamp, xi
    { P::irradiance(flat, v, v, v, v) } -> std::same_as<glm::vec3>;                 // lab 05: lamp, radiance, point on it, position, normal
    { P::reflected(v, v, x, xi) } -> std::same_as<glm::vec3>;                       // lab 06: in, normal, width, xi
    { P::through_lens(v, axes, xi, x, x, xi) } -> std::same_as<lantern::ray>;       // lab 07: eye, axes, film, radius, focus, xi
    { P::moment(x, x, x) } -> std::same_as<float>;                                  // lab 08: open, close, xi
    { P::meet(v, v, x, v, v, x) } -> std::same_as<std::optional<float>>;            // lab 08: center, velocity, radius; origin, direction, time
    { P::bounds(v, v, x, x, x) } -> std::same_as<std::pair<glm::vec3, glm::vec3>>;  // lab 08: center, velocity, radius; open, close
    { P::build(std::span<const lantern::aabb>{}) } -> std::same_as<typename P::tree>;  // lab 10
    { P::box(tree, n) } -> std::same_as<lantern::aabb>;                             // lab 10: of a node
    P::traverse(tree, lantern::interval{}, enter, offer);                           // lab 10
    { P::stratum(n, n, n, glm::uvec2{}) } -> std::same_as<std::uint32_t>;           // lab 13: i, count, purpose, pixel
};

// ---- Step 1: a camera ----------------------------------------------------------------------------------------------

// What a camera may have, or not. What it has not is a type without members: it takes no room, and no time.
struct pinhole {};
struct lens {
    float radius = 0;
    float focus = 1;  ///< the distance of the plane of focus, along the line of sight
};
struct instant {};
struct exposure {
    float open = 0, close = 1;
};

/// A ray knows a time only where a shutter gives it one.
template <class Shutter>
using ray_through = std::conditional_t<std::same_as<Shutter, instant>, lantern::ray, lantern::timed_ray>;

template <parts P, class Lens = pinhole, class Shutter = instant>
struct camera {
    glm::vec3 eye{0};
    glm::mat3 axes{1};     ///< columns: to the right, upwards, forward; of length 1
    glm::vec2 half{0.5f};  ///< half the film's width and height; it stands at distance 1
    [[no_unique_address]] Lens optics{};
    [[no_unique_address]] Shutter shutter{};
};

/// Step 1. The ray through a point of the film: (0, 0) is the top left corner of the picture, (1, 1) the bottom right one. Of a camera with
/// a shutter it is a lantern::timed_ray, of any other a lantern::ray. `source` is asked for what the camera needs and for nothing else:
/// source.draw2(lantern::purpose::lens), source.draw1(lantern::purpose::time). A pinhole is a lens of radius 0, at any focus and ξ.
template <parts P, class Lens, class Shutter, lantern::sample_source Source>
[[nodiscard]] ray_through<Shutter> shoot(const camera<P, Lens, Shutter>& c, glm::vec2 film, const Source& source) {
    // BEGIN SOLUTION
    const glm::vec2 place = glm::vec2(2 * film.x - 1, 1 - 2 * film.y) * c.half;
    lantern::ray r;
    if constexpr (std::same_as<Lens, pinhole>) r = P::through_lens(c.eye, c.axes, place, 0, 1, glm::vec2(0.5f));
    else r = P::through_lens(c.eye, c.axes, place, c.optics.radius, c.optics.focus, source.draw2(lantern::purpose::lens));
    if constexpr (std::same_as<Shutter, instant>) return r;
    else return {r, P::moment(c.shutter.open, c.shutter.close, source.draw1(lantern::purpose::time))};
    // END SOLUTION
    // STARTER: return lantern::todo("lab15 step 1: a camera");
}

// ---- Step 2: the samples -------------------------------------------------------------------------------------------

/// The numbers of one sample of one pixel, one set for each purpose. A lantern::sample_source.
template <parts P>
class numbers {
public:
    numbers(std::uint64_t seed, glm::uvec2 pixel, std::uint32_t sample, std::uint32_t side)
        : path_(seed), pixel_(pixel), sample_(sample), side_(side) {}

    /// Step 2. A point of the unit square, for a purpose. The side² samples of a pixel fill a grid of side × side cells, one each; which
    /// sample is in which cell is another matter for each purpose, `which`, path and pixel. So is the place within the cell.
    [[nodiscard]] glm::vec2 draw2(lantern::purpose p, std::uint32_t which = 0) const {
        // BEGIN SOLUTION
        const std::uint64_t k = key(p, which, 2);
        return P::jittered(P::stratum(sample_, side_ * side_, lantern::low(k), pixel_), side_, chance(k));
        // END SOLUTION
        // STARTER: return lantern::todo("lab15 step 2: a point for each purpose");
    }

    /// Step 2. A number from 0 to 1, for a purpose: the side² samples of a pixel fill side² equal stretches, one each, in an order that
    /// is another one for each purpose, `which`, path and pixel, and has nothing to do with draw2's. Below 1.
    [[nodiscard]] float draw1(lantern::purpose p, std::uint32_t which = 0) const {
        // BEGIN SOLUTION
        const std::uint64_t k = key(p, which, 1);
        const auto count = float(side_ * side_), stretch = float(P::stratum(sample_, side_ * side_, lantern::low(k), pixel_));
        return std::min((stretch + chance(k).x) / count, 0x1.fffffep-1f);
        // END SOLUTION
        // STARTER: return lantern::todo("lab15 step 2: a number for each purpose");
    }

    /// Given. The numbers of the k-th ray that goes on from here: another path, so that no two hits share a number.
    [[nodiscard]] numbers branch(std::uint32_t k) const {
        numbers next = *this;
        next.path_ = lantern::hash(path_, k);
        return next;
    }

private:
    std::uint64_t path_;  // of the seed, and of the bounces so far
    glm::uvec2 pixel_;
    std::uint32_t sample_, side_;

    /// Given. Stands for a purpose, `which` and the path; `dimensions` keeps draw1 and draw2 apart.
    [[nodiscard]] std::uint64_t key(lantern::purpose p, std::uint32_t which, std::uint32_t dimensions) const {
        return lantern::hash(path_, static_cast<std::uint32_t>(p), which, dimensions);
    }
    /// Given. Two independent numbers of this sample and pixel, in (0, 1), for a key.
    [[nodiscard]] glm::vec2 chance(std::uint64_t key) const {
        const std::uint64_t h = lantern::hash(key, pixel_.x, pixel_.y, sample_);
        return {lantern::to_unit(lantern::low(h)), lantern::to_unit(lantern::high(h))};
    }
};

/// Given. A lantern::sampler: the numbers of every sample of every pixel.
template <parts P>
struct sampler {
    std::uint32_t side = 4;
    std::uint64_t seed = 0;

    [[nodiscard]] std::uint32_t count() const { return side * side; }
    [[nodiscard]] numbers<P> at(glm::uvec2 pixel, std::uint32_t i) const { return {lantern::hash(seed, i / count()), pixel, i % count(), side}; }
};

// ---- Step 3: a lamp ------------------------------------------------------------------------------------------------

/// It shines to the side of shape.u × shape.v.
template <parts P>
struct lamp {
    lantern::rectangle shape{};
    glm::vec3 radiance{1};
};

/// Step 3. What the point of the lamp that ξ is carried to brings to `point`. The library's irradiance is that of a surface which faces the
/// lamp's point: the material counts the cosine at the surface. The shadow ray ends at `position`: lantern::just_off(place, normal, point)
/// puts it just before the lamp, on its lit side, since the lamp itself may be a thing of the scene; its normal has length 1.
template <parts P>
[[nodiscard]] lantern::illumination illuminate(const lamp<P>& l, glm::vec3 point, glm::vec2 xi) {
    // BEGIN SOLUTION
    const glm::vec3 place = P::point_on(l.shape, xi);
    const glm::dvec3 normal = glm::normalize(glm::cross(glm::dvec3(l.shape.u), glm::dvec3(l.shape.v)));
    return {lantern::just_off(place, normal, point), P::irradiance(l.shape, l.radiance, place, point, lantern::unit(place - point))};
    // END SOLUTION
    // STARTER: return lantern::todo("lab15 step 3: a lamp");
}

// ---- Step 4: gloss -------------------------------------------------------------------------------------------------

struct sharp {};
struct blurred {
    float width = 0.2f;  ///< the side a of the square
};

template <parts P, class Blur = sharp>
struct gloss {
    glm::vec3 color{1};
    [[no_unique_address]] Blur blur{};
};

/// Step 4. The one ray that goes on: its direction, and the colour as its weight. `in` has length 1 and points to the surface; h.normal
/// points out of the thing, whichever side was hit; lantern::facing(normal, in) turns it.
template <parts P>
[[nodiscard]] lantern::bounces scatter(const gloss<P, blurred>& m, glm::vec3 in, const lantern::hit& h, glm::vec2 xi) {
    // BEGIN SOLUTION
    return lantern::bounce{P::reflected(in, lantern::facing(h.normal, in), m.blur.width, xi), m.color};
    // END SOLUTION
    // STARTER: return lantern::todo("lab15 step 4: gloss");
}

/// Step 4. The same for what is not blurred: gloss of width 0, which needs no ξ, and so asks for none.
template <parts P>
[[nodiscard]] lantern::bounces scatter(const gloss<P, sharp>& m, glm::vec3 in, const lantern::hit& h) {
    // BEGIN SOLUTION
    return lantern::bounce{P::reflected(in, lantern::facing(h.normal, in), 0, glm::vec2(0.5f)), m.color};
    // END SOLUTION
    // STARTER: return lantern::todo("lab15 step 4: gloss of no width");
}

// ---- Step 5: balls -------------------------------------------------------------------------------------------------

struct still {};
struct drift {
    glm::vec3 velocity{0};
};

/// At time T the middle is center + T velocity; the shutter is open at times from 0 to 1.
template <parts P, class Motion = still>
struct ball {
    glm::vec3 center{0};
    float radius = 1;
    [[no_unique_address]] Motion motion{};
};

/// Step 5. The first hit with t > range.min and t <= range.max. Your lab 08 knows no range: it finds the smallest t > 0. `point` is on the
/// ball as it stands at the ray's time, computed in double and rounded once; `normal` has length 1 and points out; `error` stays 0. A ball
/// that stands still is one of velocity 0 at time 0, and meets rays that know no time.
template <parts P, class Motion, std::derived_from<lantern::ray> Ray>
    requires(std::same_as<Motion, still> || std::derived_from<Ray, lantern::timed_ray>)
[[nodiscard]] std::optional<lantern::hit> intersect(const ball<P, Motion>& b, const Ray& r, lantern::interval range) {
    // BEGIN SOLUTION
    glm::vec3 velocity(0);
    float time = 0;
    if constexpr (std::same_as<Motion, drift>) velocity = b.motion.velocity, time = r.time;
    const glm::vec3 start = range.min == 0 ? r.origin : at(r, range.min);  // the smallest t > 0 from here
    const auto rest = P::meet(b.center, velocity, b.radius, start, r.direction, time);
    if (!rest || !contains(range, range.min + *rest)) return std::nullopt;
    const glm::dvec3 middle = glm::dvec3(b.center) + double(time) * glm::dvec3(velocity);
    const glm::dvec3 normal = glm::normalize(glm::dvec3(start) + double(*rest) * glm::dvec3(r.direction) - middle);
    return lantern::hit{range.min + *rest, glm::vec3(middle + double(b.radius) * normal), glm::vec3(normal), 0};
    // END SOLUTION
    // STARTER: lantern::todo("lab15 step 5: a ray and a ball");
}

/// Step 5. A box that holds the ball at all times from 0 to 1, for certain. Your lab 08 rounds to the nearest float, inwards or outwards:
/// lantern::grown(box, by) moves all faces outwards; 4 lantern::ulp of the largest coordinate are enough, and not more.
template <parts P, class Motion>
[[nodiscard]] lantern::aabb bounds(const ball<P, Motion>& b) {
    // BEGIN SOLUTION
    glm::vec3 velocity(0);
    if constexpr (std::same_as<Motion, drift>) velocity = b.motion.velocity;
    const auto [low, high] = P::bounds(b.center, velocity, b.radius, 0, 1);
    const glm::vec3 size = glm::max(glm::abs(low), glm::abs(high));
    return lantern::grown({low, high}, glm::vec3(4 * lantern::ulp(std::max({size.x, size.y, size.z}))));
    // END SOLUTION
    // STARTER: return lantern::todo("lab15 step 5: the box of a ball");
}

// ---- Step 6: the ray tracer ----------------------------------------------------------------------------------------

/// What a ray tracer looks at. It owns nothing. All lamps are of one kind.
template <class Structure, class Thing, class Lamp>
struct world {
    const Structure* structure;     ///< a lantern::accelerator over the things
    std::span<const Thing> things;  ///< surfaces, each with a `material`, which may be a std::variant
    std::span<const Lamp> lamps;
    lantern::sky sky{};
    glm::vec3 ambient{0};  ///< arrives evenly from everywhere
};

/// Step 6. The radiance along a ray: distribution ray tracing (Cook, Porter and Carpenter 1984). Nothing is met: the sky's radiance.
/// Else, of the material at the first hit, as far as it offers it: what it emits; its albedo times the ambient light; for each lamp what
/// it answers, unless a shadow ray is blocked; and for each ray that it sends on, that ray's weight times the radiance along it, unless depth is 0.
/// A lamp with area is asked with draw2(purpose::light, its number), one like a point with nothing. A ray goes on at the time of r, with
/// depth one less and the numbers of its own branch. No ray is shot for what is black already.
template <class Structure, class Thing, class Lamp, std::derived_from<lantern::ray> Ray, lantern::sample_source Source>
[[nodiscard]] glm::vec3 radiance(const world<Structure, Thing, Lamp>& w, const Ray& r, const Source& source, std::uint32_t depth) {
    // BEGIN SOLUTION
    const auto h = lantern::closest(*w.structure, w.things, r);
    const glm::vec3 in = lantern::unit(r.direction);
    if (!h) return radiance(w.sky, in);
    return lantern::with_alternative(w.things[h->index].material, [&]<class Material>(const Material& m) {
        glm::vec3 sum(0);
        if constexpr (lantern::emits<Material>) sum += emitted(m, in, *h);
        if constexpr (lantern::reflects_ambient<Material>) sum += albedo(m, *h) * w.ambient;
        if constexpr (lantern::reflects_light<Material>) {
            for (std::uint32_t i = 0; i < w.lamps.size(); ++i) {
                const lantern::illumination light = [&] {
                    if constexpr (lantern::point_like<Lamp>) return illuminate(w.lamps[i], h->point);
                    else return illuminate(w.lamps[i], h->point, source.draw2(lantern::purpose::light, i));
                }();
                if (light.irradiance == glm::vec3(0)) continue;
                const glm::vec3 answer = evaluate(m, in, *h, lantern::unit(light.position - h->point)) * light.irradiance;
                if (answer == glm::vec3(0)) continue;
                const glm::vec3 from = lantern::leave(*h, light.position - h->point);
                if (!lantern::occluded(*w.structure, w.things, continued(r, from, light.position - from), {0, 1})) sum += answer;
            }
        }
        if constexpr (lantern::scatters<Material>) {
            if (depth == 0) return sum;
            const lantern::bounces rays = lantern::scattered(m, in, *h, source);
            for (std::uint32_t k = 0; k < rays.size(); ++k) {
                const auto& [direction, weight] = rays[k];
                if (weight == glm::vec3(0)) continue;
                sum += weight * radiance(w, continued(r, lantern::leave(*h, direction), direction), source.branch(k), depth - 1);
            }
        }
        return sum;
    });
    // END SOLUTION
    // STARTER: return lantern::todo("lab15 step 6: the ray tracer");
}

// ---- Step 7: a hierarchy -------------------------------------------------------------------------------------------

/// A tree beside the scene. A lantern::accelerator.
template <parts P>
class hierarchy {
public:
    explicit hierarchy(std::span<const lantern::aabb> boxes) : tree_(P::build(boxes)) {}

    /// Step 7. Offers the surfaces that the ray may meet within what remains of the range; offer(i, what remains) answers what remains then.
    /// P::traverse does it: it wants to know, by a function enter(node), at which t the ray enters P::box(tree, node), or std::nullopt
    /// when it misses it within the range. A ray that starts inside enters at range.min. Where rounding is in doubt it enters, and a little
    /// too early (a millionth of t), never too late.
    template <class Offer>
    void traverse(const lantern::ray& r, lantern::interval range, Offer&& offer) const {
        // BEGIN SOLUTION
        const lantern::slab_ray ready(r);
        const auto enter = [&](std::uint32_t node) -> std::optional<float> {
            const lantern::aabb box = P::box(tree_, node);
            if (!overlaps(box, ready, range)) return std::nullopt;
            double t = range.min;
            for (int i = 0; i < 3; ++i) {
                const double face = r.direction[i] < 0 ? box.max[i] : box.min[i];
                if (r.direction[i] != 0) t = std::max(t, (face - ready.origin[i]) * ready.reciprocal[i]);
            }
            return float(t - 1e-6 * std::abs(t));
        };
        P::traverse(tree_, range, enter, offer);
        // END SOLUTION
        // STARTER: lantern::todo("lab15 step 7: your tree");
    }

private:
    typename P::tree tree_;
};

// ---- Step 8: leaving out -------------------------------------------------------------------------------------------

template <parts P, class Blur>
using material = std::variant<lantern::coated<lantern::diffuse, gloss<P, Blur>>, lantern::emissive>;

template <parts P, class Motion, class Blur>
using thing = lantern::object<lantern::any_of<lantern::rectangle, ball<P, Motion>>, material<P, Blur>>;

/// A scene in types that can hold all that may be asked for.
template <parts P>
struct scene {
    std::vector<thing<P, drift, blurred>> things;
    std::vector<lamp<P>> lamps;
    camera<P, lens, exposure> from;
};

/// Given. `value` where it is of the wanted type; else what that type is by default, which is nothing.
template <class Wanted, class Value>
[[nodiscard]] Wanted kept(const Value& value) {
    if constexpr (std::same_as<Wanted, Value>) return value;
    else return Wanted{};
}

/// Given. The same thing in smaller types; what they have no room for is dropped.
template <class Motion, class Blur, parts P>
[[nodiscard]] thing<P, Motion, Blur> with(const thing<P, drift, blurred>& whole) {
    thing<P, Motion, Blur> result;
    if (const auto* b = std::get_if<ball<P, drift>>(&whole.shape.value)) result.shape.value = ball<P, Motion>{b->center, b->radius, kept<Motion>(b->motion)};
    else result.shape.value = std::get<lantern::rectangle>(whole.shape.value);
    if (const auto* light = std::get_if<lantern::emissive>(&whole.material)) {
        result.material = *light;
    } else {
        const auto& m = std::get<0>(whole.material);
        result.material = lantern::coated{m.body, gloss<P, Blur>{m.coat.color, kept<Blur>(m.coat.blur)}, m.share};
    }
    return result;
}
template <class Motion, class Blur, parts P>
[[nodiscard]] std::vector<thing<P, Motion, Blur>> with(const std::vector<thing<P, drift, blurred>>& things) {
    std::vector<thing<P, Motion, Blur>> result;
    for (const auto& each : things) result.push_back(with<Motion, Blur>(each));
    return result;
}

/// Given. The same camera in smaller types: `with<pinhole, exposure>(camera)`.
template <class Lens, class Shutter, parts P>
[[nodiscard]] camera<P, Lens, Shutter> with(const camera<P, lens, exposure>& c) {
    return {c.eye, c.axes, c.half, kept<Lens>(c.optics), kept<Shutter>(c.shutter)};
}

/// Step 8. Looks at the values once, and answers visit(things, camera) with the smallest types that hold them: where the lens has radius
/// 0, a pinhole; where no ball has a velocity, balls that stand still and no shutter; where no coat has a width, sharp ones. The
/// picture is the same to the last bit. visit returns the same type for all.
template <parts P, class Visit>
auto leave_out(const scene<P>& s, const Visit& visit) {
    // BEGIN SOLUTION
    const bool moves = std::ranges::any_of(s.things, [](const auto& each) {
        const auto* b = std::get_if<ball<P, drift>>(&each.shape.value);
        return b && b->motion.velocity != glm::vec3(0);
    });
    const bool blurs = std::ranges::any_of(s.things, [](const auto& each) {
        const auto* c = std::get_if<0>(&each.material);
        return c && c->coat.blur.width != 0;
    });
    const auto with_lens = [&]<class Shutter>(const auto& things, Shutter) {
        if (s.from.optics.radius != 0) return visit(things, with<lens, Shutter>(s.from));
        return visit(things, with<pinhole, Shutter>(s.from));
    };
    const auto with_motion = [&]<class Blur>(Blur) {
        if (moves) return with_lens(with<drift, Blur>(s.things), exposure{});
        return with_lens(with<still, Blur>(s.things), instant{});
    };
    if (blurs) return with_motion(blurred{});
    return with_motion(sharp{});
    // END SOLUTION
    // STARTER: lantern::todo("lab15 step 8: leaving out");
    // STARTER: return visit(s.things, s.from);
}

}  // namespace lab15
