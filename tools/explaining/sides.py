# SPDX-License-Identifier: MIT
"""A sample's rays from three sides, as SVG: what is there without a script, and on paper."""

import html

from explaining import text

VIEWS = (("from the front, against z", 0, 1, 1, -1), ("from above, against y", 0, 2, 1, 1), ("from the right, against x", 2, 1, -1, -1))
SIZE, MARGIN = (320, 240), 14


def end(ray: dict, far: float) -> list[float]:
    if "met" in ray:
        return ray["met"]["point"]
    size = sum(x * x for x in ray["direction"]) ** 0.5 or 1
    t = ray["range"][1] if ray["range"][1] is not None else far / size
    return [o + t * d for o, d in zip(ray["origin"], ray["direction"])]


def views(data: dict, sample: dict) -> str:
    rays = sample["rays"]
    points = [p for ray in rays for p in ([ray["met"]["point"]] if "met" in ray else []) + ([ray["origin"]] if ray["why"] != "camera" else [])]
    balls = [(s["shape"]["numbers"], s) for s in data["surfaces"] if s["shape"]["kind"] in ("sphere", "moving") and 0 < abs(s["shape"]["numbers"][3]) < 50]
    if not points:
        points = [data["eye"]] + [end(ray, 1) for ray in rays]
    low = [min(p[k] for p in points) for k in range(3)]
    high = [max(p[k] for p in points) for k in range(3)]
    reach = max(max(b - a for a, b in zip(low, high)), 1e-6)
    for numbers, _ in balls:  # what is near belongs to it
        if all(low[k] - reach < numbers[k] < high[k] + reach for k in range(3)):
            low = [min(low[k], numbers[k] - abs(numbers[3])) for k in range(3)]
            high = [max(high[k], numbers[k] + abs(numbers[3])) for k in range(3)]
    far = 0.6 * max(b - a for a, b in zip(low, high))
    return "".join(view(data, rays, balls, low, high, far, *one) for one in VIEWS)


def view(data: dict, rays: list[dict], balls: list, low: list[float], high: list[float], far: float, name: str, right: int, down: int, sign_right: int, sign_down: int) -> str:
    width, height = SIZE
    spans = max(high[right] - low[right], 1e-6), max(high[down] - low[down], 1e-6)
    scale = min((width - 2 * MARGIN) / spans[0], (height - 2 * MARGIN) / spans[1])
    middle = (low[right] + high[right]) / 2, (low[down] + high[down]) / 2

    def at(p: list[float]) -> tuple[float, float]:
        return width / 2 + sign_right * scale * (p[right] - middle[0]), height / 2 + sign_down * scale * (p[down] - middle[1])

    parts = []
    if data["floor"] is not None and down == 1:
        y = at([0, data["floor"], 0])[1]
        parts.append(f'<line x1="0" y1="{y:.1f}" x2="{width}" y2="{y:.1f}" style="stroke: var(--line)"/>')
    for numbers, surface in balls:
        x, y = at(numbers[:3])
        parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{abs(numbers[3]) * scale:.1f}" fill="{text.screen(surface["color"])}" fill-opacity=".45" '
                     f'style="stroke: var(--faint)"><title>{html.escape(surface["name"])}</title></circle>')
    for surface in data["surfaces"]:
        if surface["shape"]["kind"] != "rectangle":
            continue
        n = surface["shape"]["numbers"]
        corners = [[n[k] + a * n[3 + k] + b * n[6 + k] for k in range(3)] for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in map(at, corners))
        parts.append(f'<polygon points="{path}" fill="{text.screen(surface["color"])}" fill-opacity=".15" style="stroke: var(--line)"/>')
    for ray in rays:
        (x0, y0), (x1, y1) = at(ray["origin"]), at(end(ray, far))
        kind = text.kind(ray)
        parts.append(f'<line x1="{x0:.1f}" y1="{y0:.1f}" x2="{x1:.1f}" y2="{y1:.1f}" style="stroke: var(--{kind})" stroke-width="1.5">'
                     f'<title>{html.escape(text.line(data, ray, rays))}</title></line>')
        if "met" in ray:
            parts.append(f'<circle cx="{x1:.1f}" cy="{y1:.1f}" r="2.5" style="fill: var(--{kind})"/>')
    return (f'<figure><svg viewBox="0 0 {width} {height}" role="img" aria-label="{name}">{"".join(parts)}</svg><figcaption>{name}</figcaption></figure>')
