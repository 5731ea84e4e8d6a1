# SPDX-License-Identifier: MIT
"""The rays of a pixel as lines of text."""

from explaining.program import srgb

LINES = 48  # so many are printed when no sample is asked for


def mend(data: dict) -> dict:
    """Where a ray's place or direction is not finite (null, in JSON) it is drawn at 0, and the ray is marked as broken."""
    for sample in data["samples"]:
        for ray in sample["rays"]:
            for holder, name in ((ray, "origin"), (ray, "direction"), (ray.get("met", {}), "point"), (ray.get("met", {}), "normal")):
                if None in holder.get(name, []):
                    holder[name] = [x or 0 for x in holder[name]]
                    ray["broken"] = True
            ray["gap"] = ray["gap"] or 0
    return data


def number(x: float | None) -> str:
    if x is None:
        return "not finite"
    return f"{x:.0f}" if 1000 <= abs(x) < 1e7 else f"{x:.3g}"


def triple(v: list[float]) -> str:
    return "(" + ", ".join(number(x) for x in v) + ")"


def amount(v: list[float]) -> str:
    """Three numbers, or one where they are the same. What is below a millionth is the rounding of what it was measured by."""
    if None not in v and all(abs(x) < 1e-6 for x in v):
        return "≈ 0" if any(v) else "0"
    texts = [number(x) for x in v]
    return texts[0] if len(set(texts)) == 1 else triple(v)


def screen(color: list[float]) -> str:
    return "#" + "".join(f"{srgb(x):02x}" for x in color)


def surface(data: dict, index: int) -> str:
    one = data["surfaces"][index]
    return one["name"] + (f" ({one['material']})" if one["material"] else "")


def gap_matters(ray: dict, rays: list[dict]) -> bool:
    """Whether a ray starts visibly off the surface that it leaves: by more than a hundredth of a thousandth of the way to it."""
    if ray["parent"] < 0:
        return False
    before = rays[ray["parent"]]
    way = sum((a - b) ** 2 for a, b in zip(before["met"]["point"], before["origin"])) ** 0.5
    return ray["gap"] > 1e-5 * max(way, *map(abs, before["met"]["point"]))


def passes(ray: dict) -> bool:
    """Whether a shadow ray that meets something brings light all the same: glass may weaken it instead of stopping it."""
    return ray["why"] == "shadow" and "met" in ray and any(abs(x or 0) > 1e-6 for x in ray.get("brings", []))


def kind(ray: dict) -> str:
    return "stopped" if ray["why"] == "shadow" and "met" in ray and not passes(ray) else ray["why"]


def fate(data: dict, ray: dict) -> str:
    """What a ray meets, or reaches."""
    if ray["why"] == "shadow":
        if "met" not in ray:
            return "reaches the light"
        return f"{'passes through' if passes(ray) else 'is stopped by'} {surface(data, ray['met']['surface'])}"
    if "met" not in ray:
        return f"meets nothing: {data['beyond']}"
    return f"meets {surface(data, ray['met']['surface'])} at {triple(ray['met']['point'])}, t = {number(ray['met']['t'])}"


def line(data: dict, ray: dict, rays: list[dict]) -> str:
    parts = [f"{ray['why']} ray " + fate(data, ray)]
    if ray.get("broken"):
        parts.append("its origin or direction is not a number")
    if "time" in ray:
        parts.append(f"time {number(ray['time'])}")
    if "weight" in ray and ray["why"] != "camera":
        parts.append(f"weight {amount(ray['weight'])}")
    if "brings" in ray and kind(ray) != "stopped":
        parts.append(f"brings {amount(ray['brings'])}")
    if "keeps" in ray:
        parts.append(f"keeps away {amount(ray['keeps'])}")
    asked = sum(count for _, _, count in ray["tests"])
    boxes = f"{len(ray['boxes'])} boxes and " if "boxes" in ray else ""
    parts.append(f"{boxes}{asked} surface{'s' if asked != 1 else ''} asked")
    if gap_matters(ray, rays):
        parts.append(f"starts {number(ray['gap'])} from where the ray before it ended")
    elif ray["parent"] < 0 and ray["why"] != "camera":
        parts.append("starts where no ray ended")
    return "; ".join(parts)


ORDER = {"shadow": 0, "reflected": 1, "bounced": 1, "refracted": 2}


def children(rays: list[dict], parent: int) -> list[int]:
    return sorted((i for i, ray in enumerate(rays) if ray["parent"] == parent), key=lambda i: (ORDER.get(rays[i]["why"], 0), i))


def behind(rays: list[dict], i: int) -> int:
    """How many rays go on from this one, and from those."""
    return sum(1 + behind(rays, child) for child in children(rays, i))


def tree(data: dict, sample: dict, whole: bool = True) -> list[str]:
    """All rays; or, when not the whole is wanted, none behind one that brings less than a ten-thousandth."""
    rays, lines = sample["rays"], []

    def draw(i: int, first: str, rest: str) -> None:
        lines.append(first + line(data, rays[i], rays))
        below = children(rays, i)
        if not whole and len(below) > 1 and rays[i]["parent"] >= 0 and all(abs(x or 0) < 1e-4 for x in rays[i].get("brings", [1])):
            lines.append(rest + f"└─ ... {behind(rays, i)} rays, which bring no more than that together")
            return
        for k, child in enumerate(below):
            last = k + 1 == len(below)
            draw(child, rest + ("└─ " if last else "├─ "), rest + ("   " if last else "│  "))

    for root in children(rays, -1):
        draw(root, "", "")
    return lines or ["no ray is sent: what is here was drawn"]


def census(data: dict) -> str:
    kinds: dict[str, int] = {}
    for sample in data["samples"]:
        for ray in sample["rays"]:
            kinds[ray["why"]] = kinds.get(ray["why"], 0) + 1
    total = sum(kinds.values())
    return f"{total} ray{'s' if total != 1 else ''}: " + ", ".join(f"{count} {why}" for why, count in kinds.items()) if total else "no rays"


def same_again(data: dict) -> bool:
    return data["color"] == data["again"]


def heading(data: dict, title: str) -> list[str]:
    many = len(data["samples"])
    mean = f"the mean of {many} samples, " if many > 1 else ""
    lines = [f"{title}: {mean}{triple(data['color'])}, on the screen {screen(data['color'])}; {census(data)}"]
    if not same_again(data):
        lines += ["", f"Taken again, the same pixel is {triple(data['again'])}: your code remembers something from call to call (a static variable? rand()?).",
                  "A pixel depends on what the function is given, and on nothing else; until it does, the weights below say nothing."]
    return lines


def told(data: dict, title: str, only: int | None) -> str:
    """As many samples as fit on a screen, or the one that is asked for."""
    lines, samples = heading(data, title), data["samples"]
    shown = 0
    for i, sample in enumerate(samples):
        if only is not None and i != only:
            continue
        rows = tree(data, sample, whole=only is not None)
        if only is None and shown > 0 and len(lines) + len(rows) > LINES:
            break
        lines += ["", f"sample {i + 1} of {len(samples)}: {triple(sample['color'])}"] if len(samples) > 1 else [""]
        if only is None and len(rows) > LINES:
            rows = rows[:LINES] + [f"... and {len(rows) - LINES} rays more"]
        lines += rows
        shown += 1
    left = len(samples) - shown
    if only is None and left > 0:
        lines += ["", f"... and {left} samples more, all of them on the page; --sample K shows one here"]
    return "\n".join(lines)
