# SPDX-License-Identifier: MIT
"""The rays of a pixel as a page that needs no other file: a tree beside a view to turn, and three views for those without scripts."""

import base64
import html
import json
import pathlib

import pictures
from explaining import sides, text
from explaining.program import srgb
from labs import Lab

HERE = pathlib.Path(__file__).parent

KINDS = {"camera": "camera ray", "shadow": "shadow ray that reaches the light", "stopped": "shadow ray that is stopped", "reflected": "reflected",
         "bounced": "bounced", "refracted": "refracted"}


def made(data: dict, title: str, lab: Lab, sample: int | None) -> str:
    many = len(data["samples"])
    safe = json.dumps({**data, "first": sample or 0}, separators=(",", ":")).replace("<", "\\u003c")
    seen = {text.kind(ray) for one in data["samples"] for ray in one["rays"]}
    legend = "".join(f'<span><i style="border-color: var(--{kind})"></i>{word}</span>' for kind, word in KINDS.items() if kind in seen)
    choice = (f'<div class="bar"><label for="sample" id="which">sample 1 of {many}</label><input type="range" id="sample" min="1" max="{many}" value="1">'
              f'<label><input type="checkbox" id="others"> the others too</label></div>') if many > 1 else ""
    first = data["samples"][sample or 0]
    rows = html.escape("\n".join(text.tree(data, first)))
    return (f'<!doctype html><html lang="en"><head><meta charset="utf-8"><title>{html.escape(title)}</title>'
            f'<meta name="viewport" content="width=device-width, initial-scale=1"><style>{(HERE / "view.css").read_text(encoding="utf-8")}</style></head><body>'
            f'<h1>Why does this pixel look so?</h1>{head(data, title, lab)}'
            f'<div class="both"><div class="stage"><canvas id="view" tabindex="0" role="img" aria-label="the rays in the scene, to turn with the arrow keys"></canvas>'
            f'<div class="bar"><button id="home">from aside</button><button id="eye">from the eye</button><button id="nearer">nearer</button>'
            f'<button id="farther">farther</button></div><div class="legend">{legend}</div><div class="detail" id="detail"></div>'
            f'<p class="faint">Drag to turn, wheel or pinch to come nearer, shift and drag to shift. Keys: arrows, <kbd>+</kbd> <kbd>-</kbd>, <kbd>0</kbd> from aside, '
            f'<kbd>e</kbd> from the eye, <kbd>[</kbd> <kbd>]</kbd> another sample, <kbd>Esc</kbd> none.</p></div>'
            f'<div>{choice}<div class="tree" id="tree"><noscript><pre>{rows}</pre></noscript></div></div></div>'
            f'<h2>From three sides</h2><p class="faint">{"The rays of sample " + str((sample or 0) + 1) if many > 1 else "The rays"}, drawn without a script.</p>'
            f'<div class="sides">{sides.views(data, first)}</div>'
            f'<script type="application/json" id="data">{safe}</script><script>{(HERE / "view.js").read_text(encoding="utf-8")}</script></body></html>\n')


def head(data: dict, title: str, lab: Lab) -> str:
    lines = text.heading(data, title)
    warning = f'<p class="bad">{html.escape(" ".join(lines[2:]))}</p>' if len(lines) > 1 else ""
    around = f'<img alt="the pixel among its neighbours" src="data:image/png;base64,{neighbours(data["around"])}">' if data.get("around") else ""
    more = any(ray["why"] != "camera" for sample in data["samples"] for ray in sample["rays"])
    words = ("A ray's weight says how much of what it sees goes into the sample; what it brings is what would be missing if a black card were held in its way. "
             "Both were measured: the sample was taken again, with a card in that ray's way." if more else
             "They all come from the camera, and what each of them sees is the sample.")
    return (f'<div class="top">{around}<div><p><span class="swatch" style="background: {text.screen(data["color"])}"></span> {html.escape(lines[0])}</p>{warning}'
            f'<p class="faint">Every ray that the code of lab {lab.number} ({html.escape(lab.title)}) sends for this pixel. {html.escape(words)}</p></div></div>')


def neighbours(around: dict) -> str:
    """The pixels around, enlarged, with a frame around the one that is meant."""
    size, zoom = around["size"], 8
    width, height = size[0] * zoom, size[1] * zoom
    pixels = bytearray()
    for y in range(height):
        for x in range(width):
            column, row = x // zoom, y // zoom
            color = around["colors"][row * size[0] + column]
            meant = [column, row] == around["at"]
            edge = meant and (x % zoom in (0, zoom - 1) or y % zoom in (0, zoom - 1))
            pixels += bytes((255, 60, 0)) if edge else bytes(srgb(c) for c in color)
    return base64.b64encode(pictures.png(pictures.Picture(width, height, bytes(pixels)))).decode()
