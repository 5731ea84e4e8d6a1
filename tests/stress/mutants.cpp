// SPDX-License-Identifier: MIT
// The library with one formula of the textbooks in it: what the suite must find.

#include "naive.hpp"
#include "scorecard.hpp"

#include <glm/vec3.hpp>

namespace stress {

namespace {

/// In double, with both roots from (-b ± √) / a: only the cancellation is left.
surface_answer sphere_in_double(glm::vec3 center, float radius, ray r) {
    const glm::dvec3 oc = glm::dvec3(center) - glm::dvec3(r.origin), d(r.direction);
    const double a = glm::dot(d, d), h = glm::dot(d, oc), c = glm::dot(oc, oc) - double(radius) * double(radius), discriminant = h * h - a * c;
    if (discriminant < 0) return std::nullopt;
    const double root = std::sqrt(discriminant);
    for (const double t : {(h - root) / a, (h + root) / a})
        if (static_cast<float>(t) > 0 && static_cast<float>(t) < naive::infinity) {
            const glm::dvec3 p = glm::dvec3(r.origin) + t * d;
            return hit{static_cast<float>(t), glm::vec3(p), glm::vec3((p - glm::dvec3(center)) / double(radius))};
        }
    return std::nullopt;
}

}  // namespace

std::vector<mutant> mutants() {
    return {
        {"sphere in float", "Ray Tracing in One Weekend's formula, in float",
         {"sphere/far", "sphere/ground-1e6", "sphere/ground-1e12", "sphere/hover", "sphere/times-1e20", "self-intersection/sphere-scale-1e6"},
         [](answers& a) { a.sphere = [](glm::vec3 c, float radius, ray r) { return naive::sphere(c, radius, r); }; }},
        {"sphere by (-b ± √) / a", "the same in double, as its books ship it",
         {"sphere/ground-1e6", "sphere/ground-1e12", "sphere/slope-1e12"}, [](answers& a) { a.sphere = sphere_in_double; }},
        {"plane by n·p = D", "every other course: D is computed beforehand, nearly parallel is a miss",
         {"plane/nearly-parallel", "plane/far-from-the-origin", "plane/touching", "plane/any-direction-length"},
         [](answers& a) { a.plane = [](glm::vec3 q, glm::vec3 n, ray r) { return naive::plane(q, n, r); }; }},
        {"triangle with an epsilon", "Möller and Trumbore's, with |det| < 1e-8",
         {"triangle/size-1e-3", "triangle/size-3e-5", "triangle/sliver", "watertightness/edges-scale-1e-4"},
         [](answers& a) { a.triangle = [](glm::vec3 p, glm::vec3 q, glm::vec3 s, ray r) { return naive::triangle(p, q, s, r); }; }},
        {"triangle by Möller and Trumbore in double", "who thinks that double is enough",
         {"watertightness/edges", "watertightness/vertices", "watertightness/slivers"},
         [](answers& a) {
             a.triangle = [](glm::vec3 p, glm::vec3 q, glm::vec3 s, ray r) { return naive::triangle<glm::dvec3>(p, q, s, r, 0.0); };
         }},
        {"slabs in float", "The Next Week's box: divide, swap, <=",
         {"boxes/aimed-at-an-edge", "boxes/just-touching", "boxes/zero-times-infinity", "boxes/flat", "boxes/a-point"},
         [](answers& a) { a.meets_box = [](box b, ray r) { return naive::meets_box(b, r); }; }},
        {"a thousandth", "every other course: start 1e-3 farther on",
         {"self-intersection/sphere-scale-1e-3", "self-intersection/sphere-scale-1e6", "self-intersection/gap-scale-1"},
         [](answers& a) { a.leave = [](hit h, glm::vec3 d) { return naive::leave(h, d); }; }},
        {"basis by Frisvad", "a vector believed to have unit length, 1 + z with z near -1",
         {"basis/nearly-unit", "basis/at-the-poles", "basis/any-length", "basis/right-handed"},
         [](answers& a) { a.basis = [](glm::vec3 w) { return naive::frisvad(w); }; }},
        {"sin² = 1 - cos²", "Ray Tracing in One Weekend's refraction, with Fresnel's law",
         {"refraction/near-critical", "refraction/near-normal", "refraction/everywhere"},
         [](answers& a) { a.refracted = [](glm::vec3 in, glm::vec3 n, float ratio) { return naive::refracted(in, n, ratio, false); }; }},
        {"normals by the matrix", "who transforms normals as if they were points",
         {"transforms/flat", "transforms/needle", "transforms/sheared"},
         [](answers& a) {
             a.placed_sphere = [](affine m, glm::vec3 c, float radius, ray r) { return naive::placed_sphere(m, c, radius, r, false, false); };
         }},
        {"directions made unit", "who normalises in the object's space, too",
         {"transforms/scaled-1e-6", "transforms/needle"},
         [](answers& a) {
             a.placed_sphere = [](affine m, glm::vec3 c, float radius, ray r) { return naive::placed_sphere(m, c, radius, r, true, true); };
         }},
        {"a sum in float", "every first ray tracer",
         {"image/mean-of-1e8", "image/mean-of-equals", "image/mean-without-nan"},
         [](answers& a) { a.mean = [](const std::vector<glm::vec3>& v, std::uint64_t n) { return naive::mean(v, n); }; }},
        {"a square root and a cast", "-1e-9 becomes -2147483648",
         {"image/bytes"}, [](answers& a) { a.to_byte = naive::to_byte; }},
        {"the disk's middle forgotten", "Shirley and Chiu's map as printed: 0 / 0",
         {"warps/disk", "warps/disk-middle"}, [](answers& a) { a.to_disk = naive::to_disk; }},
        {"bits over 2^32", "float(u) · 2^-32 is 1",
         {"warps/unit-number"}, [](answers& a) { a.unit_number = naive::unit_number; }},
        {"a point in focus", "o + f·d, and from the lens towards it, in float",
         {"camera/focus-far", "camera/tiny-aperture"}, [](answers& a) { a.shoot = naive::shoot; }},
        {"the ends of a turn", "the box around both ends of an arc",
         {"camera/box-of-what-turns"}, [](answers& a) { a.box_around_turning = naive::box_around_turning; }},
        {"1 - cos of a lamp", "its solid angle as 2π(1 - cos)",
         {"light/tiny-sphere", "light/tiny-lamp"},
         [](answers& a) {
             a.sphere_solid_angle = naive::sphere_solid_angle;
             a.sphere_light = naive::sphere_light;
         }},
        {"gloss that depends on length", "r + u U + v V with r as it comes",
         {"light/near-mirror"}, [](answers& a) { a.perturbed = naive::perturbed; }},
        {"fifty bounces", "a path that ends after fifty of them",
         {"light/furnace"}, [](answers& a) { a.furnace = [](float albedo, std::uint32_t n, std::uint64_t seed) { return naive::furnace(albedo, n, seed); }; }},
    };
}

}  // namespace stress
