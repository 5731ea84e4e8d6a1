// SPDX-License-Identifier: MIT
// Lab 15's functions, bound to the student's. What the lab plugs in are here the suite's functions, or plain ones.

#include "contract.hpp"

#include <lab15_tracer/tracer.hpp>

#include <numbers>
#include <type_traits>

using namespace contract::lab15;  // found only where the student's header lacks the name

namespace lab15 {

namespace {

namespace asked = contract::lab15;

// ---- The parts -----------------------------------------------------------------------------------------------------

/// Right answers, in a few lines each.
namespace plain {

glm::vec2 jittered(std::uint32_t i, std::uint32_t side, glm::vec2 xi) {
    return glm::min((glm::vec2(i % side, i / side) + xi) / float(side), glm::vec2(0x1.fffffep-1f));
}
std::uint32_t stratum(std::uint32_t i, std::uint32_t count, std::uint32_t purpose, glm::uvec2 pixel) {
    const std::uint64_t order = lantern::hash(pixel.x, pixel.y, purpose);
    return lantern::permute(i, count, order);
}
glm::vec3 reflected(glm::vec3 in, glm::vec3 normal, float width, glm::vec2 xi) {
    const glm::vec3 r = glm::normalize(glm::reflect(in, normal));
    const glm::vec3 u = glm::normalize(glm::cross(r, std::abs(r.x) < 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0)));
    const glm::vec3 out = glm::normalize(r + (xi.x - 0.5f) * width * u + (xi.y - 0.5f) * width * glm::cross(r, u));
    const float height = glm::dot(out, normal);
    return height < 0 ? out - 2 * height * normal : out;
}
lantern::ray through_lens(glm::vec3 eye, const glm::mat3& axes, glm::vec2 film, float radius, float focus, glm::vec2 xi) {
    const float angle = 2 * std::numbers::pi_v<float> * xi.x, distance = radius * std::sqrt(xi.y);
    const glm::vec3 offset = distance * (std::cos(angle) * axes[0] + std::sin(angle) * axes[1]);
    return {eye + offset, glm::normalize(axes * glm::vec3(film, 1) - offset / focus)};
}
std::optional<float> meet(glm::vec3 center, glm::vec3 velocity, float radius, glm::vec3 origin, glm::vec3 direction, float time) {
    const glm::dvec3 d(direction), from = glm::dvec3(origin) - glm::dvec3(center) - double(time) * glm::dvec3(velocity);
    const double a = glm::dot(d, d), b = glm::dot(from, d), root = std::sqrt(b * b - a * (glm::dot(from, from) - double(radius) * radius));
    if (-b - root > 0) return float((-b - root) / a);
    if (-b + root > 0) return float((-b + root) / a);
    return std::nullopt;  // also of NaN
}

}  // namespace plain

/// A tree that stands for all: node 0 has the box of all, and node i + 1 that of surface i.
struct flat_tree {
    std::vector<lantern::aabb> boxes;
};

/// What is plugged in. The suite's functions stand in the slots while its call lasts.
struct slots {
    static inline lens_part lens;
    static inline moment_part moment_;
    static inline jitter_part jitter;
    static inline stratum_part order;
    static inline place_part place;
    static inline irradiance_part brings;
    static inline gloss_part gloss_;
    static inline meet_part meets;
    static inline bounds_part box_;
    static inline std::function<void(const flat_tree&, lantern::interval, const asked::enter&, const asked::offer&)> walk_;

    using tree = flat_tree;
    static glm::vec2 jittered(std::uint32_t i, std::uint32_t side, glm::vec2 xi) { return jitter(i, side, xi); }
    static std::uint32_t stratum(std::uint32_t i, std::uint32_t count, std::uint32_t purpose, glm::uvec2 pixel) { return order(i, count, purpose, pixel); }
    static glm::vec3 point_on(const lantern::rectangle& lamp, glm::vec2 xi) { return place(lamp, xi); }
    static glm::vec3 irradiance(const lantern::rectangle& lamp, glm::vec3 radiance, glm::vec3 on_lamp, glm::vec3 position, glm::vec3 normal) {
        return brings(lamp, radiance, on_lamp, position, normal);
    }
    static glm::vec3 reflected(glm::vec3 in, glm::vec3 normal, float width, glm::vec2 xi) { return gloss_(in, normal, width, xi); }
    static lantern::ray through_lens(glm::vec3 eye, const glm::mat3& axes, glm::vec2 film, float radius, float focus, glm::vec2 xi) {
        return lens(eye, axes, film, radius, focus, xi);
    }
    static float moment(float open, float close, float xi) { return moment_(open, close, xi); }
    static std::optional<float> meet(glm::vec3 center, glm::vec3 velocity, float radius, glm::vec3 origin, glm::vec3 direction, float time) {
        return meets(center, velocity, radius, origin, direction, time);
    }
    static std::pair<glm::vec3, glm::vec3> bounds(glm::vec3 center, glm::vec3 velocity, float radius, float open, float close) {
        return box_(center, velocity, radius, open, close);
    }
    static tree build(std::span<const lantern::aabb> boxes) {
        tree t{{lantern::aabb{}}};
        for (const lantern::aabb& b : boxes) t.boxes[0] = enclose(t.boxes[0], b), t.boxes.push_back(b);
        return t;
    }
    static lantern::aabb box(const tree& t, std::uint32_t node) { return t.boxes[node]; }
    template <class Enter, class Offer>
    static void traverse(const tree& t, lantern::interval range, const Enter& enter, Offer&& offer) {
        walk_(t, range, enter, offer);
    }
};

/// Offers what is entered within what remains, the first one first.
void walk_in_order(const flat_tree& t, lantern::interval range, const asked::enter& enter, const asked::offer& offer) {
    if (t.boxes.size() < 2 || !enter(0)) return;
    std::vector<std::pair<float, std::uint32_t>> entered;
    for (std::uint32_t i = 1; i < t.boxes.size(); ++i)
        if (const auto at = enter(i)) entered.emplace_back(*at, i - 1);
    std::ranges::sort(entered);
    for (const auto& [at, surface] : entered) {
        if (empty(range) || at > range.max) return;
        range = offer(surface, range);
    }
}

/// Asks the suite, and says where it stands.
struct asking {
    const draw* answer;
    std::vector<std::uint32_t> path{};

    [[nodiscard]] float draw1(lantern::purpose p, std::uint32_t which = 0) const { return (*answer)(1, std::uint32_t(p), which, path).x; }
    [[nodiscard]] glm::vec2 draw2(lantern::purpose p, std::uint32_t which = 0) const { return (*answer)(2, std::uint32_t(p), which, path); }
    [[nodiscard]] asking branch(std::uint32_t k) const {
        asking next = *this;
        next.path.push_back(k);
        return next;
    }
};

glm::vec2 answer_of(numbers<slots> source, const question& q) {
    for (const std::uint32_t k : q.path) source = source.branch(k);
    const auto purpose = static_cast<lantern::purpose>(q.purpose);
    return q.dimensions == 1 ? glm::vec2(source.draw1(purpose, q.which), 0) : source.draw2(purpose, q.which);
}

template <class Lens, class Shutter>
shot shot_by(const viewer& v, Lens lens_, Shutter shutter, glm::vec2 film, const draw& draw_) {
    const auto r = shoot(camera<slots, Lens, Shutter>{v.eye, v.axes, v.half, lens_, shutter}, film, asking{&draw_});
    static_assert(std::same_as<std::remove_const_t<decltype(r)>, ray_through<Shutter>>);
    if constexpr (std::same_as<Shutter, instant>) return {r, std::nullopt};
    else return {r, r.time};
}

std::vector<sent> listed(const lantern::bounces& rays) {
    std::vector<sent> result;
    for (const auto& [direction, weight] : rays) result.push_back({direction, weight});
    return result;
}

}  // namespace

// ---- A room for step 6, in which nothing is the student's but the tracer -------------------------------------------

namespace furniture {

struct moving_wall {
    lantern::rectangle shape;
    glm::vec3 velocity;
};
[[nodiscard]] inline std::optional<lantern::hit> intersect(const moving_wall& w, const lantern::timed_ray& r, lantern::interval range) {
    return intersect(lantern::rectangle{w.shape.corner + r.time * w.velocity, w.shape.u, w.shape.v}, static_cast<const lantern::ray&>(r), range);
}
struct polished {
    glm::vec3 color;
};
[[nodiscard]] inline lantern::bounces scatter(const polished& m, glm::vec3 in, const lantern::hit& h) { return lantern::bounce{glm::reflect(in, h.normal), m.color}; }
struct rough {
    glm::vec3 color;
};
[[nodiscard]] inline lantern::bounces scatter(const rough& m, glm::vec3 in, const lantern::hit& h, glm::vec2 xi) {
    return lantern::bounce{plain::reflected(in, lantern::facing(h.normal, in), 0.3f, xi), m.color};
}
struct pane {
    glm::vec3 color;
};
[[nodiscard]] inline lantern::bounces scatter(const pane& m, glm::vec3 in, const lantern::hit& h) {
    return {lantern::bounce{in, m.color}, lantern::bounce{glm::reflect(in, h.normal), glm::vec3(0.5f)}};
}

template <class Shape>
using wall_of = lantern::object<Shape, std::variant<lantern::diffuse, lantern::emissive, polished, rough, pane>>;

struct square_lamp {
    lantern::rectangle shape;
};
[[nodiscard]] inline lantern::illumination illuminate(const square_lamp& l, glm::vec3 point, glm::vec2 xi) {
    const glm::vec3 position = l.shape.corner + xi.x * l.shape.u + xi.y * l.shape.v;
    return lantern::illuminate_from(position, glm::cross(glm::dvec3(l.shape.u), glm::dvec3(l.shape.v)), glm::vec3(1), point);
}

}  // namespace furniture

namespace {

using namespace furniture;

/// Every surface; and the suite is told of the ray.
struct watched {
    std::uint32_t count;
    const told* tell;

    template <class Ray, class Offer>
    void traverse(const Ray& r, lantern::interval range, Offer&& offer) const {
        if constexpr (std::same_as<Ray, lantern::timed_ray>) (*tell)(r, r.time, range);
        else (*tell)(r, std::nullopt, range);
        for (std::uint32_t i = 0; i < count && !empty(range); ++i) range = offer(i, range);
    }
};

template <class Shape, class Lamp, class Ray>
glm::vec3 radiance_in(const room& whole, std::span<const Lamp> lamps, const Ray& r, std::uint32_t depth, const draw& draw_, const told& tell) {
    std::vector<wall_of<Shape>> walls;
    for (const wall& w : whole.walls) {
        wall_of<Shape> made;
        if constexpr (std::same_as<Shape, moving_wall>) made.shape = {w.shape, w.velocity};
        else made.shape = w.shape;
        switch (w.made_of) {
        case substance::matt: made.material = lantern::diffuse{w.color}; break;
        case substance::shining: made.material = lantern::emissive{w.color}; break;
        case substance::mirror: made.material = polished{w.color}; break;
        case substance::frosted: made.material = rough{w.color}; break;
        case substance::glass: made.material = pane{w.color}; break;
        }
        walls.push_back(made);
    }
    const watched structure{std::uint32_t(walls.size()), &tell};
    const world<watched, wall_of<Shape>, Lamp> w{&structure, walls, lamps, {whole.horizon, whole.zenith}, whole.ambient};
    return radiance(w, r, asking{&draw_}, depth);
}

// ---- A stage for step 8 --------------------------------------------------------------------------------------------

scene<slots> made_of(const stage& s) {
    scene<slots> result;
    for (const marble& m : s.marbles) {
        const ball<slots, drift> round{m.center, m.radius, {m.velocity}};
        if (m.shines) result.things.push_back({round, lantern::emissive{m.color}});
        else result.things.push_back({round, lantern::coated<lantern::diffuse, gloss<slots, blurred>>{{m.color}, {m.color, {m.width}}, 0.5f}});
    }
    const glm::vec2 optics = s.from.lens.value_or(glm::vec2(0, 1)), times = s.from.exposure.value_or(glm::vec2(0, 1));
    result.from = {s.from.eye, s.from.axes, s.from.half, {optics.x, optics.y}, {times.x, times.y}};
    return result;
}

// What is seen depends on the camera's types or on the things', not on both at once: so there is less to compile.

template <class Lens, class Shutter>
std::vector<ray_through<Shutter>> shots_of(const camera<slots, Lens, Shutter>& cam, glm::uvec2 size, const asking& source) {
    std::vector<ray_through<Shutter>> rays;
    for (unsigned y = 0; y < size.y; ++y)
        for (unsigned x = 0; x < size.x; ++x) rays.push_back(shoot(cam, (glm::vec2(x, y) + source.draw2(lantern::purpose::film)) / glm::vec2(size), source));
    return rays;
}

template <class Motion, class Blur, class Ray>
std::vector<glm::vec3> seen_along(const std::vector<Ray>& rays, const std::vector<thing<slots, Motion, Blur>>& things, const asking& source) {
    std::vector<glm::vec3> seen;
    const lantern::every all{std::uint32_t(things.size())};
    for (const Ray& r : rays) {
        const auto h = lantern::closest(all, things, r);
        lantern::bounce sent{r.direction, r.direction};
        if (h) {
            if (const auto* coat = std::get_if<0>(&things[h->index].material)) sent = lantern::scattered(*coat, lantern::unit(r.direction), *h, source)[0];
            else sent = {glm::vec3(0), std::get<lantern::emissive>(things[h->index].material).radiance};
        }
        seen.insert(seen.end(), {h ? glm::vec3(h->t) : r.origin, sent.direction, sent.weight});
    }
    return seen;
}

template <class Motion, class Blur, class Lens, class Shutter>
visited seen_by(const std::vector<thing<slots, Motion, Blur>>& things, const camera<slots, Lens, Shutter>& cam, glm::uvec2 size, const draw& draw_) {
    const asking source{&draw_};
    return {std::same_as<Lens, lens>, std::same_as<Shutter, exposure>, std::same_as<Motion, drift>, std::same_as<Blur, blurred>,
            sizeof(thing<slots, Motion, Blur>), sizeof cam, seen_along(shots_of(cam, size, source), things, source)};
}

}  // namespace

const contract::table lab{
    contract::bind<asked::shoot>([](const viewer& v, glm::vec2 film, const lens_part& lens_, const moment_part& moment, const draw& draw_) {
        slots::lens = lens_;
        slots::moment_ = moment;
        const lens optics = v.lens ? lens{v.lens->x, v.lens->y} : lens{};
        const exposure times = v.exposure ? exposure{v.exposure->x, v.exposure->y} : exposure{};
        if (v.lens) return v.exposure ? shot_by(v, optics, times, film, draw_) : shot_by(v, optics, instant{}, film, draw_);
        return v.exposure ? shot_by(v, pinhole{}, times, film, draw_) : shot_by(v, pinhole{}, instant{}, film, draw_);
    }),
    contract::bind<asked::drawn>([](std::uint32_t side, std::uint64_t seed, glm::uvec2 pixel, const question& q) {
        slots::jitter = plain::jittered;
        slots::order = plain::stratum;
        std::vector<glm::vec2> all;
        for (std::uint32_t i = 0; i < side * side; ++i) all.push_back(answer_of(sampler<slots>{side, seed}.at(pixel, i), q));
        return all;
    }),
    contract::bind<asked::drawn_with>([](std::uint32_t side, std::uint64_t seed, glm::uvec2 pixel, std::uint32_t sample, const question& q,
                                         const jitter_part& jitter, const stratum_part& order) {
        slots::jitter = jitter;
        slots::order = order;
        return answer_of(sampler<slots>{side, seed}.at(pixel, sample), q);
    }),
    contract::bind<asked::illuminate>([](const lantern::rectangle& shape, glm::vec3 radiance_, glm::vec3 point, glm::vec2 xi, const place_part& place,
                                         const irradiance_part& brings) {
        slots::place = place;
        slots::brings = brings;
        return illuminate(lamp<slots>{shape, radiance_}, point, xi);
    }),
    contract::bind<asked::scatter>([](glm::vec3 color, float width, glm::vec3 in, const lantern::hit& h, glm::vec2 xi, const gloss_part& part) {
        slots::gloss_ = part;
        return listed(scatter(gloss<slots, blurred>{color, {width}}, in, h, xi));
    }),
    contract::bind<asked::scatter_sharp>([](glm::vec3 color, glm::vec3 in, const lantern::hit& h, const gloss_part& part) {
        slots::gloss_ = part;
        return listed(scatter(gloss<slots>{color}, in, h));
    }),
    contract::bind<asked::intersect>([](const body& b, const lantern::ray& r, std::optional<float> time, lantern::interval range, const meet_part& part) {
        slots::meets = part;
        if (b.velocity) return intersect(ball<slots, drift>{b.center, b.radius, {*b.velocity}}, lantern::timed_ray{r, time.value_or(0.0f)}, range);
        const ball<slots> quiet{b.center, b.radius};
        return time ? intersect(quiet, lantern::timed_ray{r, *time}, range) : intersect(quiet, r, range);
    }),
    contract::bind<asked::bounds>([](const body& b, const bounds_part& part) {
        slots::box_ = part;
        return b.velocity ? bounds(ball<slots, drift>{b.center, b.radius, {*b.velocity}}) : bounds(ball<slots>{b.center, b.radius});
    }),
    contract::bind<asked::radiance>([](const room& whole, const lantern::ray& r, std::optional<float> time, std::uint32_t depth, const draw& draw_,
                                       const told& tell) {
        std::vector<square_lamp> lamps;
        for (const lantern::rectangle& l : whole.lamps) lamps.push_back({l});
        std::vector<lantern::point_light> points;
        for (const glm::vec3 p : whole.points) points.push_back({p, glm::vec3(1)});
        const std::span<const square_lamp> wide(lamps);
        if (time) return radiance_in<moving_wall>(whole, wide, lantern::timed_ray{r, *time}, depth, draw_, tell);
        if (!points.empty()) return radiance_in<lantern::rectangle>(whole, std::span<const lantern::point_light>(points), r, depth, draw_, tell);
        return radiance_in<lantern::rectangle>(whole, wide, r, depth, draw_, tell);
    }),
    contract::bind<asked::entries>([](const std::vector<lantern::aabb>& boxes, const lantern::ray& r, lantern::interval range) {
        std::vector<std::optional<float>> result;
        slots::walk_ = [&](const flat_tree& t, lantern::interval, const asked::enter& enter, const asked::offer&) {
            for (std::uint32_t i = 1; i < t.boxes.size(); ++i) result.push_back(enter(i));
        };
        hierarchy<slots>(boxes).traverse(r, range, [](std::uint32_t, lantern::interval rest) { return rest; });
        return result;
    }),
    contract::bind<asked::traverse>([](const std::vector<lantern::aabb>& boxes, const lantern::ray& r, lantern::interval range, const asked::offer& offer) {
        slots::walk_ = walk_in_order;
        hierarchy<slots>(boxes).traverse(r, range, offer);
    }),
    contract::bind<asked::left_out>([](const stage& s, bool whole, glm::uvec2 size, const draw& draw_) {
        slots::lens = plain::through_lens;
        slots::moment_ = [](float open, float close, float xi) { return open + xi * (close - open); };
        slots::meets = plain::meet;
        slots::gloss_ = plain::reflected;
        const scene<slots> made = made_of(s);
        const auto visit = [&](const auto& things, const auto& cam) { return seen_by(things, cam, size, draw_); };
        return whole ? visit(made.things, made.from) : leave_out(made, visit);
    }),
};

}  // namespace lab15
