# SPDX-License-Identifier: MIT
"""What each pixel costs: false colours, a legend, where it is hottest; and the levels of a hierarchy."""

import base64
import functools
import html
import json
import math
import pathlib
from dataclasses import dataclass

import pictures
from explaining import text
from explaining.program import Picture

HERE = pathlib.Path(__file__).parent

# From cold to hot, as they are on the screen.
COLORS = ((0, 0, 0), (40, 12, 110), (130, 20, 130), (200, 50, 90), (240, 110, 40), (255, 200, 60), (255, 255, 235))
WORDS = {"rays": "rays sent", "boxes": "boxes asked", "tests": "surfaces asked"}


@dataclass
class Map:
    """One number for each pixel, row by row."""
    name: str
    picture: Picture
    values: list[int]

    @functools.cached_property
    def mean(self) -> float:
        return sum(self.values) / len(self.values)

    @functools.cached_property
    def most(self) -> int:
        return max(self.values)

    @functools.cached_property
    def least(self) -> int:
        return min(self.values)

    @functools.cached_property
    def steep(self) -> bool:
        """Whether few pixels cost so much more than the rest that only logarithms show both."""
        return self.most > 20 * self.mean

    def part(self, value: float) -> float:
        """Where a value is on the scale, from 0 to 1."""
        if self.steep:
            return math.log1p(value) / math.log1p(self.most)
        return value / max(self.most, 1)

    def value(self, part: float) -> float:
        return math.expm1(part * math.log1p(self.most)) if self.steep else part * self.most

    @functools.cached_property
    def where(self) -> tuple[int, int]:
        at = self.values.index(self.most)
        return at % self.picture.width, at // self.picture.width

    def drawn(self) -> pictures.Picture:
        table = {v: bytes(color(self.part(v))) for v in set(self.values)}
        return pictures.Picture(self.picture.width, self.picture.height, b"".join(table[v] for v in self.values))


def color(part: float) -> tuple[int, int, int]:
    at = min(max(part, 0), 1) * (len(COLORS) - 1)
    i = min(int(at), len(COLORS) - 2)
    return tuple(round(a + (at - i) * (b - a)) for a, b in zip(COLORS[i], COLORS[i + 1]))


def maps(data: dict, picture: Picture) -> list[Map]:
    """Those in which anything happens."""
    return [each for name in WORDS if (each := Map(name, picture, data[name])).most > 0]


def table(all_maps: list[Map]) -> str:
    rows = [f"{'':16}{'mean':>10}{'least':>10}{'most':>10}   at"]
    for each in all_maps:
        x, y = each.where
        rows.append(f"{WORDS[each.name]:16}{each.mean:>10.1f}{each.least:>10}{each.most:>10}   {x},{y}")
    rays = next((each for each in all_maps if each.name == "rays"), None)
    for each in all_maps:
        if rays and each is not rays:
            rows.append(f"{WORDS[each.name] + ' a ray':24}{sum(each.values) / sum(rays.values):.1f}")
    return "\n".join(rows)


# ---- levels -----------------------------------------------------------------------------------------------------------


def levels(tree: dict) -> list[tuple[str, str]]:
    """For each level of a tree a caption, and its boxes as the camera sees them, in SVG; leaves above it stay."""
    nodes, view = tree["nodes"], tree["view"]
    drawn = []
    for depth in range(1 + max(node["depth"] for node in nodes)):
        here = [node for node in nodes if node["depth"] == depth or (node["depth"] < depth and node["count"] > 0)]
        inner = sum(node["depth"] == depth for node in here)
        leaves = sum(node["depth"] == depth and node["count"] > 0 for node in here)
        words = f"level {depth}: {inner} box{'es' if inner != 1 else ''}" + (f", {leaves} of them leaves" if leaves else "")
        drawn.append((words, svg(here, depth, view)))
    return drawn


def svg(nodes: list[dict], depth: int, view: dict) -> str:
    width, height = 720, round(720 / view["aspect"])
    lines = []
    for node in nodes:
        shown = [projected([node["max" if i >> k & 1 else "min"][k] for k in range(3)], view, width, height) for i in range(8)]
        if any(p is None for p in shown):
            continue  # behind the eye
        path = "".join(f"M{shown[i][0]:.1f} {shown[i][1]:.1f}L{shown[i | bit][0]:.1f} {shown[i | bit][1]:.1f}" for i in range(8) for bit in (1, 2, 4) if not i & bit)
        hue = 47 * node["number"] % 360
        fade = ' stroke-opacity=".35"' if node["depth"] < depth else ""
        lines.append(f'<path d="{path}" stroke="hsl({hue},60%,50%)"{fade}/>')
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" role="img" aria-label="the boxes of level {depth}" fill="none" '
            f'stroke-width="1">{"".join(lines)}</svg>')


def projected(p: list[float], view: dict, width: int, height: int) -> tuple[float, float] | None:
    """A point as the camera sees it: the view's y axis is up."""
    forward = unit([t - e for t, e in zip(view["target"], view["eye"])])
    right = unit(cross(forward, [0, 1, 0]))
    up = cross(right, forward)
    to = [a - b for a, b in zip(p, view["eye"])]
    depth = dot(to, forward)
    if depth <= 1e-6:
        return None
    half = math.tan(view["vertical_fov"] / 2) * depth
    return width / 2 * (1 + dot(to, right) / (half * view["aspect"])), height / 2 * (1 - dot(to, up) / half)


def dot(a: list[float], b: list[float]) -> float:
    return sum(x * y for x, y in zip(a, b))


def cross(a: list[float], b: list[float]) -> list[float]:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a: list[float]) -> list[float]:
    size = math.sqrt(dot(a, a))
    return [x / size for x in a]


# ---- the page ---------------------------------------------------------------------------------------------------------


def packed(values: list[int]) -> str:
    """Four bytes each, the low one first."""
    return base64.b64encode(b"".join(v.to_bytes(4, "little") for v in values)).decode()


def page(title: str, explains: str, whose: str, all_maps: list[Map], samples: int, drawn: list[tuple[str, str]]) -> str:
    sections = "".join(section(each) for each in all_maps)
    tree = ""
    if drawn:
        figures = "".join(f'<figure class="level"{"" if i == 0 else " hidden"}>{svg_text}<figcaption>{html.escape(words)}</figcaption></figure>'
                          for i, (words, svg_text) in enumerate(drawn))
        tree = (f'<h2>The hierarchy, level by level</h2><p>The boxes as the camera sees them. A leaf that stands higher up in the tree is paler.</p>'
                f'<div class="bar"><button id="up">up</button><input type="range" id="level" min="0" max="{len(drawn) - 1}" value="0" aria-label="level">'
                f'<button id="down">down</button></div><div class="levels">{figures}</div>')
    numbers = json.dumps({each.name: {"width": each.picture.width, "height": each.picture.height, "data": packed(each.values)} for each in all_maps})
    return (f'<!doctype html><html lang="en"><head><meta charset="utf-8"><title>{html.escape(title)}: what each pixel costs</title>'
            f'<meta name="viewport" content="width=device-width, initial-scale=1"><style>{(HERE / "view.css").read_text(encoding="utf-8")}'
            f'{(HERE / "heat.css").read_text(encoding="utf-8")}</style></head><body><h1>What each pixel costs</h1>'
            f'<p>{html.escape(title)}, {samples} sample{"s" if samples != 1 else ""} a pixel, with {whose} code. Point at a pixel to read its number; '
            f'<code>{html.escape(explains)}</code> says where it comes from.</p>'
            f'<pre>{html.escape(table(all_maps))}</pre>{sections}{tree}'
            f'<script type="application/json" id="data">{numbers}</script><script>{(HERE / "heat.js").read_text(encoding="utf-8")}</script></body></html>\n')


def section(each: Map) -> str:
    if each.least == each.most:
        return f"<section><h2>{WORDS[each.name].capitalize()}</h2><p>{each.most} in every pixel.</p></section>"
    picture = base64.b64encode(pictures.png(each.drawn())).decode()
    stops = ",".join(f"rgb{c}" for c in COLORS)
    x, y = each.where
    ticks = "".join(f"<span>{text.number(each.value(k / 4))}</span>" for k in range(5))
    scale = " The scale is logarithmic." if each.steep else ""
    return (f'<section><h2>{WORDS[each.name].capitalize()}</h2><div class="heat" data-name="{each.name}"><img alt="{WORDS[each.name]}, pixel by pixel" '
            f'src="data:image/png;base64,{picture}"><i class="hottest" style="left: {100 * (x + .5) / each.picture.width:.2f}%; '
            f'top: {100 * (y + .5) / each.picture.height:.2f}%" title="the most"></i></div>'
            f'<div class="scale" style="background: linear-gradient(to right, {stops})"></div><div class="ticks">{ticks}</div>'
            f'<p class="faint">mean {each.mean:.1f}, most {each.most} at {x},{y} (the ring).{scale} <output></output></p></section>')
