// SPDX-License-Identifier: MIT
// Metamorphic twins, which need no truth: a scene scaled by a power of two, mirrored, with its axes exchanged, or its triangles
// wound the other way round is the same scene.

#include "laws.hpp"

#include <functional>

namespace stress {

namespace {

/// A surface of one kind and a ray: all of its lengths and directions in the open.
struct posed {
    std::vector<glm::vec3> points;      // scale and move with the scene
    std::vector<glm::vec3> directions;  // normals and edges: they turn with it; edges scale, too
    float radius = 1;
    ray r;
};

struct kind_of_twin {
    std::string group, name;
    std::function<bool(const answers&)> there;
    std::function<surface_answer(const answers&, const posed&)> ask;
    std::function<posed(dice&)> draw;
};

glm::vec3 towards(glm::vec3 p, glm::vec3 o) { return glm::vec3(glm::dvec3(p) - glm::dvec3(o)); }

std::vector<kind_of_twin> kinds() {
    std::vector<kind_of_twin> all;
    all.push_back({"sphere", "", [](const answers& a) { return bool(a.sphere); },
                   [](const answers& a, const posed& p) { return a.sphere(p.points[0], p.radius, p.r); }, [](dice& d) {
                       posed p{{d.in_cube(10)}, {}, d.magnitude_between(-1, 1), {d.in_cube(10), {}}};
                       p.r.direction = towards(p.points[0] + 1.1f * p.radius * d.in_cube(), p.r.origin);
                       return p;
                   }});
    all.push_back({"plane", "", [](const answers& a) { return bool(a.plane); },
                   [](const answers& a, const posed& p) { return a.plane(p.points[0], p.directions[0], p.r); },
                   [](dice& d) { return posed{{d.in_cube(10)}, {d.in_cube()}, 1, {d.in_cube(10), d.in_cube()}}; }});
    all.push_back({"triangle", "", [](const answers& a) { return bool(a.triangle); },
                   [](const answers& a, const posed& p) { return a.triangle(p.points[0], p.points[1], p.points[2], p.r); }, [](dice& d) {
                       const glm::vec3 c = d.in_cube(5);
                       posed p{{c + d.in_cube(), c + d.in_cube(), c + d.in_cube()}, {}, 1, {d.in_cube(10), {}}};
                       const float u = d.between(0, 1), v = d.between(0, 1 - double(u));
                       p.r.direction = towards(p.points[0] + u * (p.points[1] - p.points[0]) + v * (p.points[2] - p.points[0]), p.r.origin);
                       return p;
                   }});
    all.push_back({"quadrics", "disk-", [](const answers& a) { return bool(a.disk); },
                   [](const answers& a, const posed& p) { return a.disk(p.points[0], p.directions[0], p.radius, p.r); }, [](dice& d) {
                       posed p{{d.in_cube(5)}, {d.in_cube()}, d.between(0.5, 2), {d.in_cube(10), {}}};
                       p.r.direction = towards(p.points[0] + 0.8f * p.radius * d.in_cube(), p.r.origin);
                       return p;
                   }});
    all.push_back({"quadrics", "cylinder-", [](const answers& a) { return bool(a.cylinder); },
                   [](const answers& a, const posed& p) { return a.cylinder(p.points[0], p.points[1], p.radius, p.r); }, [](dice& d) {
                       posed p{{d.in_cube(5), d.in_cube(5)}, {}, d.between(0.5, 2), {d.in_cube(10), {}}};
                       p.r.direction = towards(0.5f * (p.points[0] + p.points[1]) + 0.8f * p.radius * d.in_cube(), p.r.origin);
                       return p;
                   }});
    all.push_back({"quadrics", "box-", [](const answers& a) { return bool(a.box_surface); },
                   [](const answers& a, const posed& p) {
                       return a.box_surface({glm::min(p.points[0], p.points[1]), glm::max(p.points[0], p.points[1])}, p.r);
                   },
                   [](dice& d) {
                       posed p{{d.in_cube(5), d.in_cube(5)}, {}, 1, {d.in_cube(10), {}}};
                       p.r.direction = towards(0.5f * (p.points[0] + p.points[1]) + 0.5f * d.in_cube(), p.r.origin);
                       return p;
                   }});
    return all;
}

posed mapped(const posed& p, auto&& map) {
    posed q = p;
    for (glm::vec3& v : q.points) v = map(v);
    for (glm::vec3& v : q.directions) v = map(v);
    q.r = {map(p.r.origin), map(p.r.direction)};
    return q;
}

/// The same decision, and t, point and normal as they must be.
void compare(score& s, const posed& p, const surface_answer& h, const surface_answer& twin, float expected_t, glm::vec3 expected_normal) {
    if (h.has_value() != twin.has_value()) return s.wrong("only one of the twins hits: from" + shown({p.r.origin, p.r.direction}));
    s.right();
    if (!h) return;
    s.error(places(twin->t, expected_t), "t of the twin: from" + shown({p.r.origin, p.r.direction}));
    for (int k = 0; k < 3; ++k)
        if (!(std::abs(twin->normal[k] - expected_normal[k]) <= 0x1p-23f)) return s.wrong("the normal of the twin:" + shown({expected_normal, twin->normal}));
}

}  // namespace

void add_twins(std::vector<test_case>& cases) {
    std::uint64_t salt = 100;
    for (const kind_of_twin& k : kinds()) {
        const auto twin = [&](const std::string& name, const std::string& about, double allowed, auto body) {
            add(cases, k.group + "/twin-" + k.name + name, about, "metamorphic: needs no truth", "random scenes, none of them on an edge", k.there,
                [k, body, salt = salt++](const answers& a, score& s, std::uint32_t i) {
                    dice d = dice_of(i, salt);
                    const posed p = k.draw(d);
                    body(k, a, s, p, d);
                });
            cases.back().bound = 2;
            cases.back().gold = allowed;
        };
        twin("scaled", "the scene times 2^-80 to 2^80: t is that many times as large, to the last bit", 0,
             [](const kind_of_twin& kind, const answers& a, score& s, const posed& p, dice& d) {
                 const float scale = std::ldexp(1.0f, static_cast<int>(d.below(161)) - 80);
                 posed q = p;
                 for (glm::vec3& v : q.points) v *= scale;
                 q.radius *= scale;
                 q.r.origin *= scale;
                 const auto h = kind.ask(a, p), other = kind.ask(a, q);
                 compare(s, p, h, other, h ? scale * h->t : 0, h ? h->normal : glm::vec3(0));
             });
        twin("longer-direction", "a direction of 2^-60 to 2^60 times the length: t is that many times as small, to the last bit", 0,
             [](const kind_of_twin& kind, const answers& a, score& s, const posed& p, dice& d) {
                 const int exponent = static_cast<int>(d.below(121)) - 60;
                 posed q = p;
                 q.r.direction *= std::ldexp(1.0f, exponent);
                 const auto h = kind.ask(a, p), other = kind.ask(a, q);
                 compare(s, p, h, other, h ? std::ldexp(h->t, -exponent) : 0, h ? h->normal : glm::vec3(0));
             });
        twin("mirrored", "in a mirror, or three: the same t, to the last bit", 0,
             [](const kind_of_twin& kind, const answers& a, score& s, const posed& p, dice& d) {
                 const std::uint32_t which = 1 + d.below(7);
                 const auto mirror = [&](glm::vec3 v) {
                     return glm::vec3((which & 1) ? -v.x : v.x, (which & 2) ? -v.y : v.y, (which & 4) ? -v.z : v.z);
                 };
                 posed q = mapped(p, mirror);
                 // An odd number of mirrors turns a triangle's winding round.
                 if (kind.group == "triangle" && (which == 1 || which == 2 || which == 4 || which == 7)) std::swap(q.points[1], q.points[2]);
                 const auto h = kind.ask(a, p), other = kind.ask(a, q);
                 compare(s, p, h, other, h ? h->t : 0, h ? mirror(h->normal) : glm::vec3(0));
             });
        twin("axes-exchanged", "x, y, z become y, z, x: the same but for a last bit", 1,
             [](const kind_of_twin& kind, const answers& a, score& s, const posed& p, dice&) {
                 const auto turn = [](glm::vec3 v) { return glm::vec3(v.y, v.z, v.x); };
                 const auto h = kind.ask(a, p), other = kind.ask(a, mapped(p, turn));
                 compare(s, p, h, other, h ? h->t : 0, h ? turn(h->normal) : glm::vec3(0));
             });
        if (k.group == "triangle")
            twin("winding-reversed", "a, c, b: the normal turns round, and nothing else", 1,
                 [](const kind_of_twin& kind, const answers& a, score& s, const posed& p, dice&) {
                     posed q = p;
                     std::swap(q.points[1], q.points[2]);
                     const auto h = kind.ask(a, p), other = kind.ask(a, q);
                     compare(s, p, h, other, h ? h->t : 0, h ? -h->normal : glm::vec3(0));
                 });
    }
}

}  // namespace stress
