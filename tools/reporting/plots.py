# SPDX-License-Identifier: MIT
"""The report's plots, as SVG. A program of its own: plots.py REPORT.json FOLDER. Needs matplotlib, and nothing of ours.

Text and axes take the colour of the page that they stand in, so that one picture serves a light page and a dark one."""

import io
import json
import pathlib
import re
import sys

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend is chosen first)

INK, GRID = "#010203", "#040506"  # replaced in the SVG by what the page says
COLOURS = {"random": "#8c8c8c", "N-rooks": "#e69f00", "jittered": "#2f86d6", "multi-jittered": "#00a077",
           "correlated multi-jittered": "#cc79a7", "Halton": "#e0602c", "Sobol": "#8f6be0"}
BELOW = {"loc": "upper center", "bbox_to_anchor": (0.5, -0.17), "ncol": 2}  # a legend under its plot
MARKERS = {"random": "o", "N-rooks": "s", "jittered": "^", "multi-jittered": "D", "correlated multi-jittered": "v", "Halton": "P",
           "Sobol": "X"}

plt.rcParams.update({
    "svg.fonttype": "none", "font.family": "sans-serif", "font.size": 10, "figure.figsize": (5.2, 3.6), "figure.dpi": 100,
    "text.color": INK, "axes.edgecolor": INK, "axes.labelcolor": INK, "xtick.color": INK, "ytick.color": INK, "grid.color": GRID,
    "axes.grid": True, "grid.linewidth": 0.6, "axes.spines.top": False, "axes.spines.right": False, "legend.frameon": False,
    "legend.fontsize": 8.5, "savefig.transparent": True, "lines.linewidth": 1.5, "lines.markersize": 4.5,
})


def save(figure, name: str, title: str, folder: pathlib.Path) -> None:
    """As an SVG element to stand in a page: no size of its own, colours by the page, names that clash with no other's."""
    text = io.StringIO()
    with matplotlib.rc_context({"svg.hashsalt": name}):
        figure.savefig(text, format="svg", bbox_inches="tight", metadata={"Date": None, "Creator": None})
    plt.close(figure)
    svg = text.getvalue()
    svg = svg[svg.index("<svg"):]
    svg = svg.replace(INK, "currentColor").replace(GRID, "var(--grid)")
    svg = re.sub(r'(<svg[^>]*?) (?:width|height)="[^"]*"', r"\1", re.sub(r'(<svg[^>]*?) (?:width|height)="[^"]*"', r"\1", svg, count=1), count=1)
    svg = re.sub(r"<metadata>.*?</metadata>", "", svg, flags=re.S)
    svg = re.sub(r'id="', f'id="{name}-', svg)
    svg = re.sub(r'href="#', f'href="#{name}-', re.sub(r"url\(#", f"url(#{name}-", svg))
    svg = svg.replace("<svg ", f'<svg role="img" aria-label="{title}" ', 1)
    beside = folder / f"{name}.svg.part"
    beside.write_text(svg, encoding="utf-8")
    beside.replace(folder / f"{name}.svg")


def slug(text: str) -> str:
    return text.replace(" ", "_")


def label_slope(one: dict, kind: str) -> str:
    """Its slope, for the legend of a plot against samples; no hyphen for a minus."""
    return f": {one['slope']:.2f}".replace("-", "−") if kind == "samples" and one["slope"] is not None else ""


def against_time(effect: dict, name: str, folder: pathlib.Path) -> None:
    figure, axes = plt.subplots()
    for one in effect["curves"]:
        seconds = [row["seconds"] for row in one["rows"]]
        axes.loglog(seconds, [row["rmse"] for row in one["rows"]], color=COLOURS[one["sampler"]], marker=MARKERS[one["sampler"]],
                    label=one["sampler"])
        axes.fill_between(seconds, [row["rmse_low"] for row in one["rows"]], [row["rmse_high"] for row in one["rows"]],
                          color=COLOURS[one["sampler"]], alpha=0.2, linewidth=0)
    axes.set_xlabel("seconds for the picture, one thread")
    axes.set_ylabel("RMSE")
    axes.legend(**BELOW)
    save(figure, name, f"{effect['name']}: RMSE against seconds", folder)


def against_samples(effect: dict, name: str, folder: pathlib.Path) -> None:
    figure, axes = plt.subplots()
    for one in effect["curves"]:
        samples = [row["samples"] for row in one["rows"]]
        colour = COLOURS[one["sampler"]]
        axes.loglog(samples, [row["rmse"] for row in one["rows"]], color=colour, marker=MARKERS[one["sampler"]],
                    label=one["sampler"] + label_slope(one, "samples"), linestyle="none" if one["predicted_slope"] else "-")
        axes.fill_between(samples, [row["rmse_low"] for row in one["rows"]], [row["rmse_high"] for row in one["rows"]], color=colour,
                          alpha=0.2, linewidth=0)
        if one["predicted_slope"]:
            axes.loglog(samples, [row["predicted"] for row in one["rows"]], color=colour, linewidth=1)
    first = effect["curves"][0]["rows"]
    start, end = first[0]["samples"], first[-1]["samples"]
    top = max(row["rmse"] for one in effect["curves"] for row in one["rows"][:1])
    for slope, text in ((-0.5, "−1/2"), (-0.75, "−3/4"), (-1.0, "−1")):
        y = 1.6 * top
        axes.loglog([start, end], [y, y * (end / start) ** slope], color=INK, linewidth=0.8, linestyle=":", alpha=0.6)
        axes.annotate(text, (end, y * (end / start) ** slope), xytext=(3, 0), textcoords="offset points", va="center", fontsize=8.5)
    axes.set_xlabel("samples a pixel (below: slopes)")
    axes.set_ylabel("RMSE")
    axes.legend(**BELOW)
    save(figure, name, f"{effect['name']}: RMSE against samples, with what theory predicts", folder)


def ladder(report: dict, folder: pathlib.Path) -> None:
    rungs = report["ladder"]["rungs"]
    figure, axes = plt.subplots(figsize=(5.2, 3.2))
    names = [("+ " if i else "") + rung["adds"] for i, rung in enumerate(rungs)]
    counted = all(rung["instructions"] for rung in rungs)
    values = [rung["instructions"] if counted else 1e9 * rung["seconds_per_sample"] for rung in rungs]
    axes.barh(names, values, color=COLOURS["jittered"], height=0.6)
    for i, (value, rung) in enumerate(zip(values, rungs)):
        axes.annotate(f"{value:.0f}, {rung['dimensions']} numbers", (value, i), xytext=(4, 0), textcoords="offset points", va="center",
                      fontsize=8.5)
    axes.invert_yaxis()
    axes.grid(axis="y", visible=False)
    axes.set_axisbelow(True)
    axes.set_xlim(0, 1.35 * max(values))
    axes.set_xlabel("instructions a sample" if counted else "nanoseconds a sample")
    save(figure, "ladder", "What each effect costs", folder)


# ---- what students wrote ----------------------------------------------------------------------------------------------

OWN = "#d6336c"
ODD = ["#d6336c", "#e69f00", "#8f6be0", "#00a077", "#c2491d", "#56b4e9", "#a05a2c", "#7a8f00"]  # one after the other, with other marks in the next round
MARKS = "osD^vPX*"


def own(entry: dict, one: dict, effect: dict, folder: pathlib.Path) -> None:
    """One curve of a student's, against time and against samples, before all of ours."""
    for kind, key, text in (("time", "seconds", "seconds for the picture, one thread"), ("samples", "samples", "samples a pixel (below: slopes)")):
        if not all(row[key] for row in one["rows"]):
            continue
        figure, axes = plt.subplots()
        for model in effect["curves"]:
            near = model["sampler"] == one["beside"]
            axes.loglog([row[key] for row in model["rows"]], [row["rmse"] for row in model["rows"]], color=COLOURS[model["sampler"]] if near else INK,
                        marker=MARKERS[model["sampler"]] if near else None, linewidth=1.5 if near else 0.8, alpha=1 if near else 0.3,
                        label=f"ours, {model['sampler']}" + label_slope(model, kind) if near else "our other samplers" if model is other(effect, one) else None)
        axes.loglog([row[key] for row in one["rows"]], [row["rmse"] for row in one["rows"]], color=OWN, marker="o", linewidth=2,
                    label=f"yours, {one['pattern']}" + label_slope(one, kind))
        axes.fill_between([row[key] for row in one["rows"]], [row["rmse_low"] for row in one["rows"]], [row["rmse_high"] for row in one["rows"]],
                          color=OWN, alpha=0.2, linewidth=0)
        hidden = [(row[key], row["pixel_bias"]) for row in one["rows"] if row["pixel_z"] >= 6]
        if hidden:
            axes.loglog(*zip(*hidden), color=OWN, linestyle=":", marker="x", linewidth=1.2, label="yours: the bias in it")
        axes.set_xlabel(text)
        axes.set_ylabel("RMSE")
        axes.legend(**BELOW)
        save(figure, f"own_{entry['lab']}_{slug(one['pattern'])}_{slug(one['effect'])}_{kind}",
             f"{one['effect']}, your sampler {one['pattern']}: RMSE against {'seconds' if kind == 'time' else 'samples'}", folder)


def other(effect: dict, one: dict) -> dict:
    """The first of our curves that is not the one beside it: all others share its label."""
    return next(model for model in effect["curves"] if model["sampler"] != one["beside"])


def everyone(report: dict, pattern: str, effect: dict, folder: pathlib.Path) -> None:
    """All submissions in one figure: those to be looked at in colours and by name, the others thin."""
    figure, axes = plt.subplots()
    entries = [(entry, one) for entry in report["submissions"] for one in entry["curves"]
               if one["pattern"] == pattern and one["effect"] == effect["name"] and one["rows"]]
    few = len(report["submissions"]) <= len(ODD)  # then everybody has a colour
    named = [entry["name"] for entry in report["submissions"] if few or entry["outlier"]]  # the same colour in all figures
    beside = entries[0][1]["beside"]
    for model in effect["curves"]:
        if model["sampler"] in ("random", beside):
            axes.loglog([row["samples"] for row in model["rows"]], [row["rmse"] for row in model["rows"]], color=COLOURS[model["sampler"]], linewidth=3,
                        alpha=0.5, label=f"ours, {model['sampler']}" + label_slope(model, "samples"))
    thin = 0
    for entry, one in sorted(entries, key=lambda each: each[1]["outlier"]):
        samples, errors = [row["samples"] for row in one["rows"]], [row["rmse"] for row in one["rows"]]
        if few or one["outlier"]:
            place = named.index(entry["name"])
            colour, mark = ODD[place % len(ODD)], MARKS[place // len(ODD) % len(MARKS)]
            axes.loglog(samples, errors, color=colour, marker=mark if one["outlier"] else None, linewidth=1.5 if one["outlier"] else 0.9,
                        label=shown(entry["name"]) + label_slope(one, "samples") + ("  ●" if few and one["outlier"] else ""))
        else:
            thin += 1
            axes.loglog(samples, errors, color=INK, linewidth=0.7, alpha=0.5, label="the others" if thin == 1 else None)
    axes.set_title(effect["name"] + ("" if pattern_is_only(report) else f", {pattern}"), fontsize=10)
    axes.set_xlabel("samples a pixel (below: slopes)")
    axes.set_ylabel("RMSE")
    axes.legend(**BELOW)
    save(figure, f"all_{slug(pattern)}_{slug(effect['name'])}", f"{effect['name']}, all submissions: RMSE against samples", folder)


def pattern_is_only(report: dict) -> bool:
    return len({one["pattern"] for entry in report["submissions"] for one in entry["curves"]}) == 1


def shown(name: str) -> str:
    """A name as a label: matplotlib reads dollars as mathematics and leaves out what begins with an underscore."""
    return ("\u200b" + name[:24] + ("…" if len(name) > 24 else "")).replace("$", "\\$")


def main() -> None:
    report = json.loads(pathlib.Path(sys.argv[1]).read_text(encoding="utf-8"))
    folder = pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    effects = {effect["name"]: effect for effect in report["effects"]}
    for name, effect in effects.items():
        against_time(effect, f"{slug(name)}_time", folder)
        against_samples(effect, f"{slug(name)}_samples", folder)
    ladder(report, folder)
    for entry in report["own"]:
        for one in entry["curves"]:
            if one["rows"]:
                own(entry, one, effects[one["effect"]], folder)
    for pattern, name in dict.fromkeys((one["pattern"], one["effect"]) for entry in report["submissions"] for one in entry["curves"] if one["rows"]):
        everyone(report, pattern, effects[name], folder)


if __name__ == "__main__":
    main()
