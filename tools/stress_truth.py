#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the truths of the stress suite, tests/stress/data/*.txt, computed with 700 bits.

Needs mpmath (pip install mpmath), which those who only run the suite do not.
usage: tools/stress_truth.py [--check] [GROUP...]    --check: compares every sixteenth variant with what is there
"""

import math
import pathlib
import random
import struct
import sys

try:
    from mpmath import atan2, cos, mp, mpf, nstr, pi, sin, sqrt, tan
except ImportError:
    print("mpmath is not installed: pip install mpmath")
    sys.exit(77)

mp.prec = 700
DATA = pathlib.Path(__file__).resolve().parent.parent / "tests" / "stress" / "data"
VARIANTS = 256

# ---- floats ----------------------------------------------------------------------------------------------------------


def f32(x):
    """The nearest float; what is beyond the largest one is an error here."""
    return struct.unpack("<f", struct.pack("<f", float(x)))[0]


def bits(x):
    return struct.unpack("<i", struct.pack("<f", x))[0]


def step(x, by):
    """The float `by` places away: the neighbours of 0 are the smallest ones."""
    order = bits(x) if bits(x) >= 0 else -(bits(x) & 0x7FFFFFFF)
    order += by
    return struct.unpack("<f", struct.pack("<i", order if order >= 0 else -0x80000000 + -order))[0]


def hexed(x):
    """As C++'s from_chars reads hexadecimal floats: without 0x, zeros or plus."""
    if x == 0:
        return "-0" if math.copysign(1, x) < 0 else "0"
    mantissa, exponent = x.hex().split("p")
    mantissa = mantissa.replace("0x", "")
    if "." in mantissa:
        mantissa = mantissa.rstrip("0").rstrip(".")
    return f"{mantissa}p{int(exponent)}"


# ---- vectors: tuples of three ----------------------------------------------------------------------------------------


def add(a, b): return tuple(x + y for x, y in zip(a, b))
def sub(a, b): return tuple(x - y for x, y in zip(a, b))
def mul(s, a): return tuple(s * x for x in a)
def dot(a, b): return sum((x * y for x, y in zip(a, b)), mpf(0) if isinstance(a[0], mpf) else 0)
def length(a): return sqrt(dot(a, a)) if isinstance(a[0], mpf) else math.sqrt(dot(a, a))
def unit(a): return mul(1 / length(a), a)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


# ---- truths: from exact inputs to a list of numbers, or None for a miss ----------------------------------------------

MISS = None
SMALLEST, LARGEST = mpf(2) ** -149 / 2, mpf(2) ** 128 * (1 - mpf(2) ** -25)


def ahead(t):
    """Whether a hit at t is one: rounded to float it must lie ahead, and be finite."""
    return SMALLEST < t < LARGEST


def first_ahead(*ts):
    return next((t for t in ts if ahead(t)), None)


def sphere_t(c, r, o, d):
    f = sub(o, c)
    a, b, k = dot(d, d), -dot(f, d), dot(f, f) - r * r
    discriminant = b * b - a * k
    if discriminant < 0 or a == 0:
        return MISS
    root = sqrt(discriminant)
    return first_ahead((b - root) / a, (b + root) / a)


def sphere(x):
    t = sphere_t(x[0:3], x[3], x[4:7], x[7:10])
    return MISS if t is None else [t]


def sphere_normal(x):
    t = sphere_t(x[0:3], x[3], x[4:7], x[7:10])
    return MISS if t is None else [t, *mul(1 / x[3], sub(add(x[4:7], mul(t, x[7:10])), x[0:3]))]


def plane_t(q, n, o, d):
    speed = dot(n, d)
    if speed == 0:
        return MISS
    return first_ahead(dot(n, sub(q, o)) / speed)


def plane(x):
    t = plane_t(x[0:3], x[3:6], x[6:9], x[9:12])
    return MISS if t is None else [t]


def triangle_t(x):
    a, b, c, o, d = x[0:3], x[3:6], x[6:9], x[9:12], x[12:15]
    A, B, C = sub(a, o), sub(b, o), sub(c, o)
    u, v, w = dot(d, cross(C, B)), dot(d, cross(A, C)), dot(d, cross(B, A))
    if min(u, v, w) < 0 and max(u, v, w) > 0 or u + v + w == 0:
        return MISS
    return plane_t(a, cross(sub(b, a), sub(c, a)), o, d)


def triangle(x):
    t = triangle_t(x)
    return MISS if t is None else [t]


def triangle_normal(x):
    t = triangle_t(x)
    return MISS if t is None else [t, *unit(cross(sub(x[3:6], x[0:3]), sub(x[6:9], x[0:3])))]


def rectangle(x):
    corner, u, v, o, d = x[0:3], x[3:6], x[6:9], x[9:12], x[12:15]
    n = cross(u, v)
    t = plane_t(corner, n, o, d)
    if t is None:
        return MISS
    p, nn = sub(add(o, mul(t, d)), corner), dot(n, n)
    alpha, beta = dot(cross(p, v), n) / nn, dot(cross(u, p), n) / nn
    return [t] if 0 <= alpha <= 1 and 0 <= beta <= 1 else MISS


def disk(x):
    c, n, r, o, d = x[0:3], x[3:6], x[6], x[7:10], x[10:13]
    t = plane_t(c, n, o, d)
    if t is None:
        return MISS
    p = sub(add(o, mul(t, d)), c)
    return [t] if dot(p, p) <= r * r else MISS


def slabs(lo, hi, o, d):
    """The stretch of the line within the box, or None."""
    near, far = -mpf("inf"), mpf("inf")
    for i in range(len(lo)):
        if d[i] == 0:
            if not lo[i] <= o[i] <= hi[i]:
                return None
            continue
        ends = sorted(((lo[i] - o[i]) / d[i], (hi[i] - o[i]) / d[i]))
        near, far = max(near, ends[0]), min(far, ends[1])
    return (near, far) if near <= far else None


def box(x):
    stretch = slabs(x[0:3], x[3:6], x[6:9], x[9:12])
    t = stretch and first_ahead(*stretch)
    return MISS if t is None else [t]


def cylinder(x):
    base, to, r, o, d = x[0:3], x[3:6], x[6], x[7:10], x[10:13]
    axis, f = sub(to, base), sub(o, base)
    m, k, axis2 = cross(f, axis), cross(d, axis), dot(axis, axis)
    a, b, c = dot(k, k), -dot(m, k), dot(m, m) - r * r * axis2
    near, far = -mpf("inf"), mpf("inf")
    if a == 0:
        if c > 0:
            return MISS
    else:
        if b * b - a * c < 0:
            return MISS
        root = sqrt(b * b - a * c)
        near, far = (b - root) / a, (b + root) / a
    lids = slabs((mpf(0),), (axis2,), (dot(f, axis),), (dot(d, axis),))
    if lids is None:
        return MISS
    near, far = max(near, lids[0]), min(far, lids[1])
    t = first_ahead(near, far) if near <= far else None
    return MISS if t is None else [t]


def inverse(m):
    """Of the matrix with columns m[0], m[1], m[2]: its rows."""
    determinant = dot(m[0], cross(m[1], m[2]))
    if determinant == 0:
        return None
    return [mul(1 / determinant, cross(m[1], m[2])), mul(1 / determinant, cross(m[2], m[0])),
            mul(1 / determinant, cross(m[0], m[1]))]


def instance(x):
    m, translation, c, r, o, d = [x[0:3], x[3:6], x[6:9]], x[9:12], x[12:15], x[15], x[16:19], x[19:22]
    rows = inverse(m)
    if rows is None:
        return MISS
    local_o = tuple(dot(row, sub(o, translation)) for row in rows)
    local_d = tuple(dot(row, d) for row in rows)
    t = sphere_t(c, r, local_o, local_d)
    if t is None:
        return MISS
    n = sub(add(local_o, mul(t, local_d)), c)
    return [t, *unit(add(add(mul(n[0], rows[0]), mul(n[1], rows[1])), mul(n[2], rows[2])))]


def meets_box(x, grow=0):
    lo, hi, o, d = x[0:3], x[3:6], x[6:9], x[9:12]
    by = grow * max(abs(v) for v in (*lo, *hi, *o))
    stretch = slabs(tuple(v - by for v in lo), tuple(v + by for v in hi), o, d)
    return [] if stretch and stretch[1] >= 0 else MISS


def meets_oriented_box(x, grow=0):
    c, axes, half, o, d = x[0:3], (x[3:6], x[6:9], x[9:12]), x[12:15], x[15:18], x[18:21]
    by = grow * max(abs(v) for v in (*c, *half, *o))
    from_c = sub(o, c)
    local_o, local_d = tuple(dot(a, from_c) for a in axes), tuple(dot(a, d) for a in axes)
    stretch = slabs(tuple(-h - by for h in half), tuple(h + by for h in half), local_o, local_d)
    return [] if stretch and stretch[1] >= 0 else MISS


def meets_ball(x, grow=0):
    c, r, o, d = x[0:3], x[3], x[4:7], x[7:10]
    r = r + grow * max(abs(v) for v in (*c, r, *o))
    f = sub(o, c)
    nearest = max(mpf(0), -dot(f, d) / dot(d, d))
    p = add(f, mul(nearest, d))
    return [] if dot(p, p) <= r * r else MISS


def basis(x):
    return list(unit(x[0:3]))


def mirrored(x):
    d, n = x[0:3], x[3:6]
    return list(unit(sub(d, mul(2 * dot(n, d) / dot(n, n), n))))


def refracted(x):
    d, n, ratio = unit(x[0:3]), unit(x[3:6]), x[6]
    if ratio == 1:
        return [*d, mpf(0)]
    across = mul(ratio, cross(n, d))
    sine2 = dot(across, across)
    if sine2 >= 1:
        return MISS
    cos_in, cos_out = -dot(n, d), sqrt(1 - sine2)
    parallel = (cos_in - ratio * cos_out) / (cos_in + ratio * cos_out)
    perpendicular = (ratio * cos_in - cos_out) / (ratio * cos_in + cos_out)
    bent = sub(mul(ratio, add(d, mul(cos_in, n))), mul(cos_out, n))
    return [*bent, (parallel**2 + perpendicular**2) / 2]


def disk_point(u, v):
    a, b = 2 * u - 1, 2 * v - 1
    if a == 0 and b == 0:
        return (mpf(0), mpf(0))
    r, angle = (a, pi / 4 * (b / a)) if abs(a) > abs(b) else (b, pi / 2 - pi / 4 * (a / b))
    return (r * cos(angle), r * sin(angle))


def to_disk(x):
    return list(disk_point(x[0], x[1]))


def to_cosine_hemisphere(x):
    p = disk_point(x[0], x[1])
    return [p[0], p[1], sqrt(max(mpf(0), 1 - p[0]**2 - p[1]**2))]


def to_sphere(x):
    u, angle = x[0], 2 * pi * x[1]
    r = 2 * sqrt(u * (1 - u))
    return [r * cos(angle), r * sin(angle), 1 - 2 * u]


def cone_heights(x):
    """The solid angle of a cone, from its half angle."""
    return [4 * pi * sin(x[0] / 2)**2]


def shoot(x):
    eye, target, up, fov, aspect, radius, focus, film, xi = (x[0:3], x[3:6], x[6:9], x[9], x[10], x[11], x[12], x[13:15],
                                                             x[15:17])
    forward = unit(sub(target, eye))
    right = unit(cross(forward, up))
    above = cross(right, forward)
    half = tan(fov / 2)
    d = add(forward, add(mul((2 * film[0] - 1) * half * aspect, right), mul((1 - 2 * film[1]) * half, above)))
    p = disk_point(xi[0], xi[1])
    lens = add(mul(radius * p[0], right), mul(radius * p[1], above))
    return [*add(eye, lens), *unit(sub(d, mul(1 / focus, lens)))]


def moment(x):
    return [x[0] + x[2] * (x[1] - x[0])]


def sphere_solid_angle(x):
    to = sub(x[3:6], x[0:3])
    s2 = x[6]**2 / dot(to, to)
    return MISS if s2 >= 1 else [2 * pi * s2 / (1 + sqrt(1 - s2))]


def rectangle_solid_angle(x):
    o, corner, u, v = x[0:3], x[3:6], x[6:9], x[9:12]
    whole = mpf(0)
    p = [corner, add(corner, u), add(add(corner, u), v), add(corner, v)]
    for i, j, k in ((0, 1, 2), (0, 2, 3)):
        a, b, c = (sub(p[n], o) for n in (i, j, k))
        la, lb, lc = length(a), length(b), length(c)
        whole += 2 * atan2(abs(dot(a, cross(b, c))), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb)
    return [whole]


def point_irradiance(x):
    to = sub(x[0:3], x[4:7])
    return [x[3] / dot(to, to)]


def to_srgb(x):
    if x[0] <= 0:
        return [mpf(0)]
    if x[0] >= 1:
        return [mpf(1)]
    seam = mpf("0.0031308")
    low = mpf("12.92") * min(x[0], seam)
    return [low if x[0] <= seam else max(low, mpf("1.055") * x[0]**(1 / mpf("2.4")) - mpf("0.055"))]


# kind: the truth, what it gives (name and number of components), whether it is only hit or miss
KINDS = {
    "sphere": (sphere, "t:1"), "sphere_normal": (sphere_normal, "t:1 normal:3"), "plane": (plane, "t:1"),
    "triangle": (triangle, "t:1"), "triangle_normal": (triangle_normal, "t:1 normal:3"), "rectangle": (rectangle, "t:1"),
    "disk": (disk, "t:1"), "box": (box, "t:1"), "cylinder": (cylinder, "t:1"), "instance": (instance, "t:1 normal:3"),
    "meets_box": (meets_box, ""), "meets_oriented_box": (meets_oriented_box, ""), "meets_ball": (meets_ball, ""),
    "basis": (basis, "w:3"), "mirrored": (mirrored, "direction:3"), "refracted": (refracted, "direction:3 reflectance:1"),
    "to_disk": (to_disk, "point:2"), "to_cosine_hemisphere": (to_cosine_hemisphere, "direction:3"),
    "to_sphere": (to_sphere, "direction:3"), "cone_solid_angle": (cone_heights, "angle:1"),
    "shoot": (shoot, "origin:3 direction:3"), "moment": (moment, "time:1"),
    "sphere_solid_angle": (sphere_solid_angle, "angle:1"), "rectangle_solid_angle": (rectangle_solid_angle, "angle:1"),
    "point_irradiance": (point_irradiance, "irradiance:1"), "to_srgb": (to_srgb, "value:1"),
}
DECIDED = {"sphere", "sphere_normal", "plane", "triangle", "triangle_normal", "rectangle", "disk", "box", "cylinder", "instance",
           "refracted"}  # hit or miss, with a margin
VOLUMES = {"meets_box", "meets_oriented_box", "meets_ball"}


def is_close(kind, inputs):
    """Whether the answer is within the margin: one input moved by one ulp turns hit to miss or miss to hit. Of a bounding
    volume: a miss of less than 2^-18 of the coordinates, which may be padding; a hit is never too close."""
    truth = KINDS[kind][0]
    exact = [mpf(v) for v in inputs]
    decided = truth(exact) is MISS
    if kind in VOLUMES:
        return decided and truth(exact, mpf(2)**-18) is not MISS
    if kind not in DECIDED:
        return False
    for i, value in enumerate(inputs):
        for by in (-1, 1):
            moved = list(exact)
            moved[i] = mpf(step(value, by))
            if (truth(moved) is MISS) != decided:
                return True
    return False


# ---- dice ------------------------------------------------------------------------------------------------------------


class Dice(random.Random):
    def between(self, lo, hi): return lo + self.random() * (hi - lo)
    def power(self, lo, hi): return 10**self.between(lo, hi)
    def cube(self, half=1): return tuple(self.between(-half, half) for _ in range(3))
    def sign(self): return 1 if self.random() < 0.5 else -1

    def way(self):
        z, angle = self.between(-1, 1), self.between(0, 2 * math.pi)
        r = math.sqrt(1 - z * z)
        return (r * math.cos(angle), r * math.sin(angle), z)

    def across(self, v): return unit(cross(v, self.way()))


def rounded(*parts):
    """Numbers and vectors as one list of floats."""
    return [f32(v) for part in parts for v in (part if isinstance(part, (tuple, list)) else (part,))]


def short(*parts):
    """The same, with twelve bits each: for numbers whose last bits stress nothing, since they make the files long."""
    def cut(v):
        if v == 0:
            return v
        unit_of_it = 2.0**(math.frexp(v)[1] - 12)
        return round(v / unit_of_it) * unit_of_it
    return [f32(cut(v)) for v in rounded(*parts)]


def aimed_at_sphere(d, c, r, o, offset):
    """From o, a direction that passes c at `offset` radii: 1 is tangential however near o is."""
    o = tuple(rounded(o))
    to = sub(rounded(c), o)
    distance = length(to)
    sine = min(1, offset * abs(r) / distance)
    return rounded(c, r, o, add(mul(math.sqrt(1 - sine * sine) / distance, to), mul(sine, d.across(to))))


def about_triangle(d, a, b, c):
    u = d.between(-0.1, 1.1)
    v = d.random() * (1.1 - u)
    return add(a, add(mul(u, sub(b, a)), mul(v, sub(c, a))))


def aimed(d, corners, o, scale=1):
    a, b, c = (tuple(rounded(v)) for v in corners)
    o = tuple(rounded(o))
    return rounded(a, b, c, o, mul(scale, unit(sub(about_triangle(d, a, b, c), o))))


def on_sphere_triangle(d, center, size):
    return [add(center, mul(size, d.way())) for _ in range(3)]


# ---- the cases -------------------------------------------------------------------------------------------------------

CASES = {}


def case(name, kind, about, source, bound=2, gold=None):
    """Registers a generator of inputs: draw(dice, number of the variant) -> floats."""
    def register(draw):
        CASES[name] = (kind, about, source, bound, gold, draw)
        return draw
    return register


HAINES = "Haines et al., Ray Tracing Gems (2019), chapter 7"
WOOP = "Woop, Benthin and Wald, JCGT 2(1), 2013"
IZE = "Ize, JCGT 2(2), 2013"

# sphere


@case("sphere/everywhere", "sphere", "radius 1e-3 to 10, seen from anywhere", "Higham 2002, section 1.8")
def _(d, i): return aimed_at_sphere(d, d.cube(10), d.power(-3, 1), d.cube(10), d.between(0, 1.3))


@case("sphere/far", "sphere", "from 1e5 radii away", HAINES)
def _(d, i): return aimed_at_sphere(d, d.cube(), 1, mul(1e5, d.way()), d.between(0, 1.3))


@case("sphere/farther", "sphere", "from 1e6 to 1e9 radii away: beyond double", HAINES)
def _(d, i): return aimed_at_sphere(d, (0, 0, 0), d.power(-9, -6), d.way(), d.between(0, 1.3))


@case("sphere/ground-1e6", "sphere", "a ground of radius 1e6, from 1e-7 to 1e5 above it", "o - c has lost the height in float: 40k ulp")
def _(d, i): return ground(d, i, 1e6)


@case("sphere/ground-1e12", "sphere", "a ground of radius 1e12, from 1e-7 to 1e5 above it", "beyond double: R/height > 1e8")
def _(d, i): return ground(d, i, 1e12)


def ground(d, i, radius):
    start = (d.between(-10, 10), d.power(-7, 5), d.between(-10, 10))
    spread = d.power(-4, 1)
    to = (d.between(-spread, spread), 0, d.between(-spread, spread))
    return rounded((0, -radius, 0), radius, start, sub(to, start) if i % 2 == 0 else d.way())


@case("sphere/slope-1e12", "sphere", "a slope of radius 1.4e12 through the origin", "no axis helps")
def _(d, i):
    fifth = 2.0**38
    to = mul(d.power(-4, 1) * d.between(-1, 1), (4, -3, 5))
    start = add(to, mul(d.power(-7, 11), add(d.cube(), (1.1, 1.2, 0))))
    return rounded((-3 * fifth, -4 * fifth, 0), 5 * fifth, start, sub(to, start))


@case("sphere/hover", "sphere", "origin 1e-4 radii above the surface", "2000 ulp in float: |f|² - R² cancels")
def _(d, i):
    c, r = d.cube(), d.power(-2, 2)
    return rounded(c, r, add(rounded(c), mul(r * (1 + 1e-4), d.way())), d.way())


@case("sphere/at-the-surface", "sphere", "origin from 1e-12 to 1e-1 radii above or below the surface", "k = (|f| - R)(|f| + R) cancels")
def _(d, i):
    c, r = d.cube(), d.power(-2, 2)
    return rounded(c, r, add(rounded(c), mul(r * (1 + d.sign() * d.power(-12, -1)), d.way())), d.way())


@case("sphere/inside", "sphere", "from inside: the far side is the first", "the second root")
def _(d, i): return rounded(d.cube(), 3, d.cube(), d.way())


@case("sphere/grazing", "sphere", "tangential but for 1e-16 to 1e-5 of the radius", "b² - a k cancels; " + HAINES)
def _(d, i): return aimed_at_sphere(d, d.cube(), 1, mul(d.between(0.5, 4), d.way()), 1 + d.sign() * d.power(-16, -5))


@case("sphere/times-1e20", "sphere", "everything times 1e20: squares overflow in float", "float ends at 3.4e38")
def _(d, i):
    x = aimed_at_sphere(d, d.cube(10), d.power(-1, 1), d.cube(10), d.between(0, 1.3))
    return rounded([1e20 * v for v in x[:7]], x[7:])


@case("sphere/times-1e-20", "sphere", "everything times 1e-20: squares vanish in float", "float begins at 1.2e-38")
def _(d, i):
    x = aimed_at_sphere(d, d.cube(10), d.power(-1, 1), d.cube(10), d.between(0, 1.3))
    return rounded([1e-20 * v for v in x[:7]], x[7:])


@case("sphere/any-direction-length", "sphere", "directions of length 1e-18 to 1e18", "divide by d·d")
def _(d, i):
    x = aimed_at_sphere(d, d.cube(10), d.power(-3, 1), d.cube(10), d.between(0, 1.3))
    return rounded(x[:7], mul(d.power(-18, 18), tuple(x[7:])))


@case("sphere/behind", "sphere", "moving away from it, from near and far", "both roots below 0")
def _(d, i):
    c, r, away = d.cube(), d.power(-2, 0), d.way()
    o = add(rounded(c), mul(r * (1 + d.power(-3, 3)), away))
    return rounded(c, r, o, add(away, mul(0.9, d.way())))


@case("sphere/normal", "sphere_normal", "the normal, from far and near, to one ulp", "(p - c)/R with p in double")
def _(d, i): return aimed_at_sphere(d, d.cube(100), d.power(-2, 2), d.cube(100), d.between(0, 1.01))


# plane


@case("plane/everywhere", "plane", "any plane from anywhere", "n·(q - o)/n·d")
def _(d, i): return rounded(d.cube(10), d.cube(), d.cube(10), d.way())


@case("plane/nearly-parallel", "plane", "rays within 1e-8 to 1e-4 of the plane", "n·d cancels; reject only n·d = 0")
def _(d, i):
    n = rounded(d.way())
    return rounded(d.cube(), n, add(mul(1e-2, n), d.cube()), add(d.across(n), mul(d.sign() * d.power(-8, -4), n)))


@case("plane/far-from-the-origin", "plane", "a plane and a ray 1e4 to 1e7 away from the origin, near each other", "never precompute n·q")
def _(d, i):
    q = mul(d.power(4, 7), d.way())
    return rounded(q, d.way(), add(q, mul(d.power(1, 3), d.way())), d.way())


@case("plane/touching", "plane", "origin from 1e-7 to 1e-3 off the plane", "n·(q - o) cancels")
def _(d, i):
    q, n = d.cube(10), d.way()
    return rounded(q, n, add(add(q, mul(d.between(-5, 5), d.across(n))), mul(d.power(-7, -3), n)), d.way())


@case("plane/any-direction-length", "plane", "directions and normals of length 1e-15 to 1e15", "nothing needs to be of unit length")
def _(d, i): return rounded(d.cube(10), mul(d.power(-15, 15), d.way()), d.cube(10), mul(d.power(-15, 15), d.way()))


@case("plane/times-1e20", "plane", "everything times 1e20", "n·(q - o) overflows in float")
def _(d, i): return rounded(mul(1e20, d.cube(10)), mul(1e20, d.cube()), mul(1e20, d.cube(10)), d.way())


# other quadrics and flat shapes


@case("quadrics/cylinder-everywhere", "cylinder", "any cylinder from anywhere", "q-form; lids as slabs")
def _(d, i):
    base = tuple(short(d.cube(5)))
    to, r = tuple(short(add(base, mul(d.power(-1, 1), d.way())))), short(d.power(-1, 0.5))[0]
    o = d.cube(10)
    return rounded(base, to, r, o, sub(add(add(base, mul(d.random(), sub(to, base))), mul(1.2 * r, d.cube())), o))


@case("quadrics/cylinder-along-its-axis", "cylinder", "rays within 1e-9 to 1e-3 of the axis' direction", "a tends to 0: c/q")
def _(d, i):
    base, axis = d.cube(), rounded(d.way())
    to, r = add(base, mul(d.between(1, 4), axis)), d.between(0.5, 1)
    o = add(sub(base, mul(d.between(1, 5), axis)), mul(0.9 * r, d.cube()))
    return rounded(base, to, r, o, add(axis, mul(d.power(-9, -3), d.way())))


@case("quadrics/cylinder-parallel", "cylinder", "rays parallel to the axis, exactly", "a = 0")
def _(d, i):
    axis = (0, 0, 0)
    k = i % 3
    base, r = d.cube(), d.between(0.5, 1)
    axis = tuple(d.sign() * 1.0 if j == k else 0.0 for j in range(3))
    to = list(rounded(base))
    to[k] += 2.0 * axis[k]
    o = list(add(base, mul(1.1 * r, d.cube())))
    o[k] = base[k] - 5 * axis[k]
    return rounded(base, to, r, o, axis)


@case("quadrics/cylinder-grazing", "cylinder", "tangential but for 1e-7 to 1e-4 of the radius", "the discriminant from the distance")
def _(d, i):
    base, axis, r = d.cube(), d.way(), 1.0
    to = add(base, mul(4, axis))
    o = add(base, add(mul(2, axis), mul(5, d.across(axis))))
    side = unit(cross(sub(base, o), axis))
    return rounded(base, to, r, o, sub(add(add(base, mul(d.between(1, 3), axis)), mul(1 + d.sign() * d.power(-7, -4), side)), o))


@case("quadrics/cylinder-thin-and-far", "cylinder", "a wire of radius 1e-3 to 1e-2 from 100 away", "a cancels against nothing only in double")
def _(d, i):
    base, axis, r = d.cube(), d.way(), d.power(-3, -2)
    to = add(base, mul(4, axis))
    o = mul(100, d.way())
    return rounded(base, to, r, o, unit(sub(add(add(base, mul(4 * d.random(), axis)), mul(1.3 * r, d.cube())), o)))


@case("quadrics/disk-everywhere", "disk", "any disk from anywhere", "the plane, then the distance from the center")
def _(d, i):
    c, n, r, o = short(d.cube(5)), short(d.way()), short(d.power(-1, 0.5))[0], d.cube(10)
    return rounded(c, n, r, o, unit(sub(add(c, mul(1.3 * r * math.sqrt(d.random()), d.across(n))), o)))


@case("quadrics/disk-at-its-edge", "disk", "within 1e-7 to 1e-4 of the edge", "the comparison of squares in double")
def _(d, i):
    c, n, r, o = d.cube(), d.way(), d.between(0.5, 2), mul(5, d.way())
    return rounded(c, n, r, o, sub(add(c, mul(r * (1 + d.sign() * d.power(-7, -4)), d.across(n))), o))


@case("quadrics/disk-on-edge", "disk", "seen within 1e-6 to 1e-3 of its plane", "n·d cancels")
def _(d, i):
    c, n, r = d.cube(), d.way(), d.between(0.5, 2)
    along = add(d.across(n), mul(d.sign() * d.power(-6, -3), n))
    return rounded(c, n, r, sub(add(c, mul(0.8 * r, d.across(n))), mul(3, along)), along)


@case("quadrics/rectangle-everywhere", "rectangle", "any parallelogram from anywhere", "the plane, then two areas")
def _(d, i):
    corner, u, v, o = tuple(short(d.cube(5))), tuple(short(d.cube(3))), tuple(short(d.cube(3))), d.cube(10)
    return rounded(corner, u, v, o, unit(sub(add(corner, add(mul(d.between(-0.2, 1.2), u), mul(d.between(-0.2, 1.2), v))), o)))


@case("quadrics/rectangle-on-edge", "rectangle", "seen within 1e-6 to 1e-3 of its plane", "n·d cancels")
def _(d, i):
    corner, u = d.cube(), mul(2, d.way())
    v = mul(d.between(0.5, 2), d.across(u))
    n = unit(cross(u, v))
    p = add(corner, add(mul(d.between(0.1, 0.9), u), mul(d.between(0.1, 0.9), v)))
    along = add(unit(add(mul(d.between(-1, 1), u), mul(d.between(-1, 1), v))), mul(d.sign() * d.power(-6, -3), n))
    return rounded(corner, u, v, sub(p, mul(3, along)), along)


@case("quadrics/rectangle-ribbon", "rectangle", "a ribbon with sides in the ratio 1 to 1e-5", "areas that cancel")
def _(d, i):
    corner, u = d.cube(), d.way()
    v, o = mul(1e-5, d.across(u)), mul(3, d.way())
    return rounded(corner, u, v, o, sub(add(corner, add(mul(d.random(), u), mul(d.between(-0.2, 1.2), v))), o))


@case("quadrics/box-everywhere", "box", "any box from anywhere, inside too", "slabs; Kay and Kajiya 1986")
def _(d, i):
    lo = tuple(short(d.cube(3)))
    hi, o = tuple(short(add(lo, tuple(d.power(-1, 0.7) for _ in range(3))))), d.cube(6)
    return rounded(lo, hi, o, sub(tuple(d.between(1.2 * a - 0.2 * b, 1.2 * b - 0.2 * a) for a, b in zip(lo, hi)), o))


@case("quadrics/box-flat", "box", "no thicker than a sheet of paper, or not at all", "min = max is a rectangle")
def _(d, i):
    lo = list(rounded(d.cube()))
    hi = list(rounded(add(lo, (1, 1, 1))))
    k = i % 3
    hi[k] = lo[k] if i % 2 == 0 else f32(lo[k] + 1e-6)
    o = d.cube(4)
    return rounded(lo, hi, o, sub(tuple(d.between(a, b) for a, b in zip(lo, hi)), o))


# triangle


@case("triangle/everywhere", "triangle", "size 1e-2 to 1, anywhere", WOOP)
def _(d, i): return aimed(d, on_sphere_triangle(d, d.cube(10), d.power(-2, 0)), d.cube(10))


@case("triangle/size-1e-3", "triangle", "of size 1e-3: below the usual epsilon for a determinant", "|det| < 1e-8 is a length, not an angle")
def _(d, i): return aimed(d, on_sphere_triangle(d, (0, 0, 0), 1e-3), mul(2, d.way()))


@case("triangle/size-3e-5", "triangle", "of size 3e-5", "|det| < 1e-8 misses every one")
def _(d, i): return aimed(d, on_sphere_triangle(d, (0, 0, 0), 3e-5), mul(2, d.way()))


@case("triangle/sliver", "triangle", "needles and caps with sides in the ratio 1 to 1e-6", "the normal cancels; double-double")
def _(d, i):
    a, long_side = d.cube(), d.way()
    c = add(add(a, mul(1e-6, d.way())), mul(0 if i % 2 == 0 else d.random(), long_side))
    return aimed(d, [a, add(a, long_side), c], mul(2, d.way()))


@case("triangle/on-edge", "triangle", "rays within 1e-5 of the plane", "n·d cancels")
def _(d, i):
    a, b, c = (tuple(rounded(v)) for v in on_sphere_triangle(d, (0, 0, 0), 1))
    n = unit(cross(sub(b, a), sub(c, a)))
    along = add(d.across(n), mul(1e-5, n))
    return rounded(a, b, c, sub(about_triangle(d, a, b, c), mul(3, along)), along)


@case("triangle/next-to-it", "triangle", "origin 1e-7 to 1e-2 off the triangle", "n·(a - o) cancels")
def _(d, i):
    a, b, c = (tuple(rounded(v)) for v in on_sphere_triangle(d, (0, 0, 0), 1))
    return rounded(a, b, c, add(about_triangle(d, a, b, c), mul(d.power(-7, -2), d.way())), d.way())


@case("triangle/thin-slanting-near", "triangle", "thin, slanting and near at once", "all that cancels")
def _(d, i):
    a, side = d.cube(), d.way()
    a, b, c = (tuple(rounded(v)) for v in (a, add(a, side), add(add(a, mul(1e-4, d.way())), mul(d.random(), side))))
    n = unit(cross(sub(b, a), sub(c, a)))
    along = add(side, mul(1e-3, n))
    return rounded(a, b, c, sub(about_triangle(d, a, b, c), mul(d.power(-3, 0), along)), along)


def huge_triangle(d, size):
    a = d.way()
    b = d.across(a)
    return rounded(mul(size, a), mul(size, b), mul(-size, add(a, b)), d.way(), d.way())


@case("triangle/huge-1e6", "triangle", "of size 1e6, met near the origin", "the vertices are far, the hit is not")
def _(d, i): return huge_triangle(d, 1e6)


@case("triangle/huge-1e12", "triangle", "of size 1e12, met near the origin", "the vertices are far, the hit is not")
def _(d, i): return huge_triangle(d, 1e12)


@case("triangle/speck", "triangle", "1e-16 to 1e-14 of the distance in size, at the origin: beyond double's shear",
      "exact signs: Shewchuk 1997; without them, rounded products")
def _(d, i):
    o = tuple(f32(d.sign() * v / 8) for v in (d.randrange(1, 16), d.randrange(1, 16), d.randrange(1, 16)))
    a, b, c = on_sphere_triangle(d, (0, 0, 0), d.power(-16, -14))
    if i % 2 == 0:  # through its middle
        c = mul(-1, add(a, b))
    return rounded(a, b, c, o, mul(-1, o))


@case("triangle/times-1e20", "triangle", "everything times 1e20", "products of three lengths overflow in float")
def _(d, i):
    x = aimed(d, on_sphere_triangle(d, (0, 0, 0), 1), mul(2, d.way()))
    return rounded([1e20 * v for v in x[:12]], x[12:])


@case("triangle/times-1e-20", "triangle", "everything times 1e-20", "products of three lengths vanish in float")
def _(d, i):
    x = aimed(d, on_sphere_triangle(d, (0, 0, 0), 1), mul(2, d.way()))
    return rounded([1e-20 * v for v in x[:12]], x[12:])


@case("triangle/normal", "triangle_normal", "the normal, of slivers too, to one ulp", "e1 × e2 in double, or more")
def _(d, i):
    a, side = d.cube(), d.way()
    return aimed(d, [a, add(a, side), add(add(a, mul(d.power(-4, 0), d.way())), mul(d.random(), side))], mul(3, d.way()))


# transforms


def placed(d, columns, translation, spread=1.2):
    """A sphere in the unit cube, and a ray from outside towards a place near it, as the world sees them."""
    columns = [tuple(short(v)) for v in columns]
    translation, c, r = tuple(short(translation)), tuple(short(mul(0.3, d.cube()))), short(d.between(0.3, 1))[0]
    p = add(c, mul(spread * r, d.cube()))
    reach = max(length(v) for v in columns)
    world = add(translation, add(add(mul(p[0], columns[0]), mul(p[1], columns[1])), mul(p[2], columns[2])))
    o = add(translation, mul(4 * reach, d.way()))
    return rounded(*columns, translation, c, r, o, unit(sub(world, rounded(o))))


def turn(d):
    a = d.way()
    b = d.across(a)
    return [a, b, cross(a, b)]


@case("transforms/turned", "instance", "turned and moved", "carried to the object in double, t is shared")
def _(d, i): return placed(d, turn(d), d.cube(3))


@case("transforms/flat", "instance", "a sphere scaled by (1e-3, 1, 1)", "normals by the inverse transpose")
def _(d, i): return placed(d, [(1e-3, 0, 0), (0, 1, 0), (0, 0, 1)], (0, 0, 0))


@case("transforms/needle", "instance", "turned, scaled by (1, 1e-3, 1e3)", "inverse in double, once")
def _(d, i):
    u, v, w = turn(d)
    return placed(d, [u, mul(1e-3, v), mul(1e3, w)], d.cube(3))


@case("transforms/scaled-1e-6", "instance", "scaled by 1e-6", "no epsilon has a length")
def _(d, i): return placed(d, [mul(2.0**-20, v) for v in turn(d)], mul(1e-6, d.cube(3)))


@case("transforms/scaled-1e6", "instance", "scaled by 1e6", "no epsilon has a length")
def _(d, i): return placed(d, [mul(2.0**20, v) for v in turn(d)], mul(1e6, d.cube(3)))


@case("transforms/mirrored", "instance", "mirrored, hence turned inside out for a cross product", "the inverse transpose keeps outward normals")
def _(d, i):
    u, v, w = turn(d)
    return placed(d, [u, mul(-1, v), w], d.cube(3))


@case("transforms/sheared", "instance", "sheared by up to 10", "no column is perpendicular to another")
def _(d, i): return placed(d, [(1, 0, 0), (d.between(-10, 10), 1, 0), (d.between(-10, 10), d.between(-10, 10), 1)], d.cube(3))


@case("transforms/far-away", "instance", "moved by 1e5", "subtract before the matrix")
def _(d, i): return placed(d, turn(d), mul(1e5, d.way()))


# boxes


def box_points(d, i):
    lo = tuple(rounded(d.cube(10)))
    return lo, tuple(rounded(add(lo, tuple(d.power(-2, 1) for _ in range(3)))))


@case("boxes/everywhere", "meets_box", "any box from anywhere", IZE)
def _(d, i):
    lo, hi = box_points(d, i)
    o = d.cube(20)
    return rounded(lo, hi, o, sub(tuple(d.between(1.5 * a - 0.5 * b, 1.5 * b - 0.5 * a) for a, b in zip(lo, hi)), o))


@case("boxes/aimed-at-an-edge", "meets_box", "through points of edges and corners, exactly where floats can say it", IZE)
def _(d, i):
    cells = 2.0**-8
    lo = tuple(d.randrange(-512, 512) * cells for _ in range(3))
    hi = tuple(v + d.randrange(1, 512) * cells for v in lo)
    p = [d.choice((a, b)) for a, b in zip(lo, hi)]
    if i % 2 == 0:
        k = d.randrange(3)
        p[k] = lo[k] + d.randrange(0, 1 + int((hi[k] - lo[k]) / cells)) * cells
    way = tuple(d.randrange(-512, 513) * cells for _ in range(3))
    times = d.randrange(1, 8)
    o = tuple(v - times * w for v, w in zip(p, way))
    return rounded(lo, hi, o, way) if way != (0, 0, 0) else rounded(lo, hi, o, (cells, 0, 0))


@case("boxes/just-touching", "meets_box", "touches one corner from outside, and nothing else", "<=, not <")
def _(d, i):
    cells = 2.0**-8
    lo = tuple(d.randrange(-512, 512) * cells for _ in range(3))
    hi = tuple(v + d.randrange(1, 512) * cells for v in lo)
    outwards = [d.sign() for _ in range(3)]
    corner = tuple(b if s > 0 else a for a, b, s in zip(lo, hi, outwards))
    k = d.randrange(3)  # leaves the box along one axis while it comes nearer along another
    way = [outwards[j] * d.randrange(1, 256) * cells for j in range(3)]
    way[k] = -way[k]
    times = d.randrange(1, 8)
    return rounded(lo, hi, tuple(v - times * w for v, w in zip(corner, way)), way)


@case("boxes/zero-times-infinity", "meets_box", "along axes, within faces, with zeros of both signs", "0 · ∞ is NaN: Williams et al. 2005")
def _(d, i):
    cells = 2.0**-4
    lo = tuple(d.randrange(-64, 64) * cells for _ in range(3))
    hi = tuple(v + d.randrange(1, 64) * cells for v in lo)
    k = d.randrange(3)
    way = [d.choice((0.0, -0.0)) for _ in range(3)]
    way[k] = d.sign() * d.power(-3, 3)
    o = [d.choice((a, b, (a + b) / 2)) for a, b in zip(lo, hi)]
    o[k] = lo[k] - 1 if way[k] > 0 else hi[k] + 1
    return rounded(lo, hi, o, way)


@case("boxes/flat", "meets_box", "without thickness, met at any angle, along the plane too", "Kay and Kajiya with <=")
def _(d, i):
    lo, hi = (list(v) for v in box_points(d, i))
    k = d.randrange(3)
    hi[k] = lo[k]
    p = tuple(d.between(a, b) for a, b in zip(lo, hi))
    o = list(rounded(d.cube(20)))
    way = list(rounded(sub(p, o)))
    if i % 4 == 0:
        o[k], way[k] = lo[k], 0.0
    return rounded(lo, hi, o, way)


@case("boxes/a-point", "meets_box", "no larger than a point, met exactly", "a degenerate triangle's bounds")
def _(d, i):
    p = tuple(d.randrange(-1024, 1024) / 128 for _ in range(3))
    way = tuple(d.randrange(-1024, 1024) / 128 for _ in range(3))
    times = d.randrange(1, 8)
    return rounded(p, p, tuple(v - times * w for v, w in zip(p, way)), way if way != (0, 0, 0) else (1, 0, 0))


@case("boxes/from-inside", "meets_box", "origin inside, on a face, in a corner", "the interval begins at 0, not where the box does")
def _(d, i):
    lo, hi = box_points(d, i)
    return rounded(lo, hi, [d.choice((a, b, d.between(a, b))) for a, b in zip(lo, hi)], d.way())


@case("boxes/far", "meets_box", "a box of size 1e-3 to 1 from 1e4 to 1e6 away", IZE)
def _(d, i):
    lo = tuple(rounded(d.cube()))
    hi = tuple(rounded(add(lo, mul(d.power(-3, 0), (1, 1, 1)))))
    o = tuple(rounded(mul(d.power(4, 6), d.way())))
    return rounded(lo, hi, o, sub(tuple(d.between(a, b) for a, b in zip(lo, hi)), o))


@case("boxes/oriented", "meets_oriented_box", "turned boxes, from anywhere", "the slabs, along the box' own axes")
def _(d, i):
    c, axes = d.cube(5), turn(d)
    half = tuple(d.power(-1.5, 0.5) for _ in range(3))
    p = c
    for a, h in zip(axes, half):
        p = add(p, mul(d.between(-1.4, 1.4) * h, a))
    o = d.cube(20)
    return rounded(c, *axes, half, o, sub(p, rounded(o)))


@case("boxes/oriented-flat", "meets_oriented_box", "turned boxes without thickness along one or two axes", "zero extent")
def _(d, i):
    c, axes = tuple(rounded(d.cube(5))), turn(d)
    half = [d.power(-1.5, 0.5) for _ in range(3)]
    for k in range(1 + i % 2):
        half[(i + k) % 3] = 0
    o = mul(9, d.way())
    return rounded(c, *axes, half, o, sub(c, rounded(o)) if i % 3 == 0 else sub(add(c, mul(0.3, d.cube())), rounded(o)))


@case("boxes/ball", "meets_ball", "bounding spheres, from anywhere, inside too", "the nearest point of the ray's stretch")
def _(d, i):
    c, r = d.cube(5), d.power(-1.5, 0.7)
    o = d.cube(8)
    return rounded(c, r, o, sub(add(c, mul(1.3 * r, d.cube())), rounded(o)))


@case("boxes/ball-touching", "meets_ball", "bounding spheres, touched from outside, exactly", "<=")
def _(d, i):
    k, j = i % 3, (i + 1 + d.randrange(2)) % 3
    c = [d.randrange(-1024, 1024) / 128 for _ in range(3)]
    r = d.randrange(1, 512) / 128
    o, way = list(c), [0.0, 0.0, 0.0]
    o[k] += d.sign() * r
    way[j] = d.sign() * d.power(-3, 3)
    o[j] -= math.copysign(d.randrange(1, 512) / 128, way[j])
    return rounded(c, r, o, way)


# basis


@case("basis/everywhere", "basis", "any direction", "Duff et al., JCGT 6(1), 2017")
def _(d, i): return rounded(d.way())


@case("basis/nearly-unit", "basis", "w's length off by up to 1e-3", "Duff's formula multiplies that into u and v: normalise first")
def _(d, i): return rounded(mul(1 + d.between(-1e-3, 1e-3), d.way()))


@case("basis/at-the-poles", "basis", "within 1e-12 to 1e-1 of an axis, both ends", "1 + z cancels at z = -1 (Frisvad 2012)")
def _(d, i):
    w = [d.sign() * d.power(-12, -1) for _ in range(3)]
    w[i % 3] = d.sign() * 1.0
    return rounded(w)


@case("basis/on-the-axes", "basis", "along the axes, zeros of both signs", "copysign, not a comparison")
def _(d, i):
    w = [d.choice((0.0, -0.0)) for _ in range(3)]
    w[i % 3] = d.sign() * d.power(-10, 10)
    return rounded(w)


@case("basis/any-length", "basis", "of length 1e-40 to 1e38", "scale by the largest component before squaring")
def _(d, i): return rounded(mul(d.power(-40, 38), d.way()))


# reflection and refraction


def facing_pair(d, lean):
    """A normal, and a direction that comes in at an angle whose tangent is 1/lean."""
    n = rounded(d.way())
    return n, rounded(sub(d.across(n), mul(lean, n)))


@case("refraction/mirrored", "mirrored", "a mirror, normals and directions of any length", "in - 2 (n·in)/(n·n) n")
def _(d, i): return rounded(mul(d.power(-10, 10), d.way()), mul(d.power(-10, 10), d.way()))


@case("refraction/mirrored-grazing", "mirrored", "a mirror at 1e-7 to 1e-2 of its plane", "n·in cancels")
def _(d, i):
    n, way = facing_pair(d, d.power(-7, -2))
    return rounded(way, n)


@case("refraction/everywhere", "refracted", "into and out of glass, at any angle", "Snell and Fresnel")
def _(d, i):
    n, way = facing_pair(d, d.power(-1, 1))
    return rounded(way, n, 1 / 1.5 if i % 2 == 0 else 1.5)


@case("refraction/near-critical", "refracted", "within 1e-12 to 1e-4 of the critical angle", "sin² = |n × d|²; 1 - cos² is wrong about it")
def _(d, i):
    ratio = f32(d.between(1.1, 2.5))
    sine = min(1.0, 1 / ratio * (1 + d.sign() * d.power(-12, -4)))
    n = rounded(d.way())
    return rounded(sub(mul(sine, d.across(n)), mul(math.sqrt(max(0, 1 - sine * sine)), n)), n, ratio)


@case("refraction/near-normal", "refracted", "within 1e-8 to 1e-3 of the normal", "1 - cos² has lost the sine")
def _(d, i):
    n = rounded(d.way())
    return rounded(sub(mul(d.power(-8, -3), d.across(n)), n), n, d.choice((1 / 1.5, 1.5, 1 / 2.4, 2.4)))


@case("refraction/index-near-1", "refracted", "indices within 1e-6 to 1e-3 of 1, and 1", "hardly anything happens, and that exactly")
def _(d, i):
    n, way = facing_pair(d, d.power(-1, 1))
    return rounded(unit(way), n, 1 if i % 8 == 0 else 1 + d.sign() * d.power(-6, -3))


@case("refraction/grazing", "refracted", "into glass at 1e-5 to 1e-2 of the surface: reflectance near 1", "cancellation in Fresnel's quotients")
def _(d, i):
    n, way = facing_pair(d, d.power(-5, -2))
    return rounded(way, n, 1 / 1.5)


# sampling and warps


def square(d, i):
    """Points of the closed unit square, its border and middle among them."""
    special = (0.0, 1.0, 0.5, step(1.0, -1), step(0.5, 1), step(0.0, 1), 2.0**-24)
    return [d.choice(special) if d.random() < 0.3 else f32(d.random()) for _ in range(2)]


@case("warps/disk", "to_disk", "square to disk, border and middle too", "Shirley and Chiu 1997: 0/0 in the middle")
def _(d, i): return square(d, i)


@case("warps/disk-middle", "to_disk", "within 1e-7 of the middle", "2ξ - 1 is exact there, and small")
def _(d, i): return rounded(0.5 + d.sign() * d.randrange(0, 4) * 2.0**-24, 0.5 + d.sign() * d.randrange(0, 4) * 2.0**-24)


@case("warps/cosine-hemisphere", "to_cosine_hemisphere", "square to hemisphere", "√max(0, 1 - x² - y²): Malley")
def _(d, i): return square(d, i)


@case("warps/sphere", "to_sphere", "square to sphere, poles too", "2√(u(1 - u)), not √(1 - z²)")
def _(d, i): return rounded(d.choice((d.random(), d.power(-12, -1), 1 - d.power(-7, -1))), d.random())


@case("warps/cone", "cone_solid_angle", "cones of half angle 1e-15 to 3", "2π(1 - cos) is 0 below 1e-4 in float: 4π sin²(a/2)")
def _(d, i): return rounded(d.power(-15, 0.47))


# camera and time


def camera(d, radius, focus):
    eye = d.cube(5)
    return short(eye, add(eye, mul(d.power(-1, 2), d.way())), d.across((1, 2, 3)), d.between(0.2, 2), d.between(0.5, 2), radius, focus,
                 d.random(), d.random(), d.random(), d.random())


@case("camera/pinhole", "shoot", "aperture 0", "nothing divides by the aperture")
def _(d, i): return camera(d, 0, d.power(-1, 2))


@case("camera/lens", "shoot", "a lens of radius 1e-3 to 1", "Cook, Porter and Carpenter 1984", gold=1)
def _(d, i): return camera(d, d.power(-3, 0), d.power(-1, 2))


@case("camera/tiny-aperture", "shoot", "a lens of radius 1e-12 to 1e-6", "o + f·d - (o + l) cancels")
def _(d, i): return camera(d, d.power(-12, -6), d.power(-1, 2))


@case("camera/focus-far", "shoot", "in focus at 1e6 to 1e38", "d - l/f: o + f·d overflows, or forgets o", gold=1)
def _(d, i): return camera(d, d.power(-3, 0), d.power(6, 38))


@case("camera/long-lens", "shoot", "a field of view of 1e-6 to 1e-2 radians", "tan(a/2) of small angles", gold=1)
def _(d, i):
    x = camera(d, d.power(-3, 0), d.power(1, 4))
    x[9] = f32(d.power(-6, -2))
    return x


@case("camera/moment", "moment", "the moment within an exposure, short ones too", "T0 + ξ(T1 - T0), never beyond T1")
def _(d, i):
    opens = d.random()
    closes = opens + (1 - opens) * d.power(-7, 0)
    return rounded(opens, min(1.0, max(f32(closes), f32(opens))), d.choice((d.random(), 0.0, step(1.0, -1))))


# accumulation and image


@case("image/srgb", "to_srgb", "the sRGB curve, around its seam and beyond its ends too", "IEC 61966-2-1", bound=2)
def _(d, i): return rounded(d.choice((d.random(), d.power(-30, 0), 0.0031308 * (1 + d.sign() * d.power(-7, -1)), -d.power(-9, 9), d.power(0, 30))))


# light transport


@case("light/tiny-sphere", "sphere_solid_angle", "a lamp of 1e-9 to 1 radii in the distance", "2π s²/(1 + √(1 - s²)); 1 - cos is 0 below 1e-4")
def _(d, i): return rounded(d.cube(), d.cube(10), d.power(-9, 0))


@case("light/sphere-from-nearby", "sphere_solid_angle", "a lamp seen from 1e-6 to 1 radii above its surface", "√((d - R)(d + R))")
def _(d, i):
    c, r = d.cube(), d.power(-1, 1)
    return rounded(add(rounded(c), mul(f32(r) * (1 + d.power(-6, 0)), d.way())), c, r)


@case("light/tiny-rectangle", "rectangle_solid_angle", "a window of 1e-9 to 1 in the distance", "Van Oosterom and Strackee 1983, not Σγ - 2π")
def _(d, i):
    size, u = d.power(-9, 0), d.way()
    return rounded(d.cube(), d.cube(10), mul(size, u), mul(size * d.between(0.1, 1), d.across(u)))


@case("light/point-at-any-distance", "point_irradiance", "a point light from 1e-15 to 1e15 away", "the square of a distance overflows, or vanishes")
def _(d, i):
    p = d.power(-15, 15)
    return rounded(mul(p, d.way()), d.between(0.1, 10) * max(1.0, p * p * 1e-20) * min(1.0, p * p * 1e20), mul(p, d.way()))


# ---- writing ---------------------------------------------------------------------------------------------------------


def variants(name, only=None):
    """(number, line) of each variant: [~] inputs : truth."""
    kind, *_, draw = CASES[name]
    for i in range(VARIANTS):
        if only and i % only:
            continue
        inputs = draw(Dice(f"{name} {i}"), i)
        assert all(math.isfinite(v) for v in inputs), (name, i)
        truth = KINDS[kind][0]([mpf(v) for v in inputs])
        answer = "miss" if truth is MISS else " ".join(nstr(v, 40) for v in truth) or "hit"
        close = is_close(kind, inputs)
        yield i, close, truth is not MISS, ("~ " if close else "") + " ".join(map(hexed, inputs)) + " : " + answer


def text_of(group):
    out = ["# SPDX-License-Identifier: MIT", "# Generated by tools/stress_truth.py; see tests/stress/README.md for the format.", ""]
    for name, (kind, about, source, bound, gold, _) in CASES.items():
        if not name.startswith(group + "/"):
            continue
        lines = list(variants(name))
        close, hits = sum(c for _, c, _, _ in lines), sum(h for _, _, h, _ in lines)
        margin = "none needed" if kind not in DECIDED | VOLUMES else f"{close} of {VARIANTS} are nearer to the other answer than "
        if kind in DECIDED:
            margin += "one ulp of one input"
        elif kind in VOLUMES:
            margin += "2^-18 of the coordinates, and may be padding"
        out += [f"case {name}", f"kind {kind}", f"gives {KINDS[kind][1]}".rstrip(), f"about {about}", f"source {source}",
                f"margin {margin}", f"bound {bound}", *([f"gold {gold}"] if gold else []), f"hits {hits}", *(line for *_, line in lines), ""]
        print(f"{name:<36} {hits:>4} hits {close:>4} close", flush=True)
    return "\n".join(out)


def check(groups):
    """Every sixteenth variant of what is there is what would be written."""
    wrong = 0
    for group in groups:
        known, name = {}, ""
        for line in (DATA / f"{group}.txt").read_text(encoding="utf-8").splitlines():
            if line.startswith("case "):
                name, known[line[5:]] = line[5:], []
            elif " : " in line:
                known[name].append(line)
        for name in (n for n in CASES if n.startswith(group + "/")):
            lines = known.get(name, [])
            wrong += len(lines) != VARIANTS or any(lines[i] != line for i, _, _, line in variants(name, only=16))
        extra = set(known) - set(CASES)
        wrong += len(extra)
    print(f"{wrong} cases differ" if wrong else "the data are what the generator writes")
    return 1 if wrong else 0


def main(words):
    all_groups = list(dict.fromkeys(name.split("/")[0] for name in CASES))
    groups = [w for w in words if not w.startswith("--")] or all_groups
    if "--check" in words:
        return check(groups)
    DATA.mkdir(parents=True, exist_ok=True)
    for group in groups:
        partial = DATA / f"{group}.txt.part"
        partial.write_text(text_of(group), encoding="utf-8")
        partial.replace(DATA / f"{group}.txt")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
