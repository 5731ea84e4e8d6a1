# SPDX-License-Identifier: MIT
"""Draws what `bench trace --json` found: plot_trace.py FILE.json FOLDER. Needs matplotlib."""

import collections
import json
import math
import pathlib
import sys

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402  (needs the line above)

# A colour for each structure, the same in every picture; dashes for what is not ours.
STYLES = {
    "every": ("#000000", "-"), "bvh": ("#d62728", "-"), "bvh in order": ("#8c1c13", "-"), "bvh middle": ("#ff9896", "-"),
    "bvh median": ("#e377c2", "-"), "bvh bottom_up": ("#c49c94", "-"), "bvh of spheres": ("#bcbd22", "-"),
    "bvh of obb": ("#dbdb8d", "-"), "grid": ("#1f77b4", "-"), "octree": ("#17becf", "-"), "kd_tree": ("#2ca02c", "-"),
    "wide_bvh": ("#9467bd", "-"), "wide_bvh span": ("#c5b0d5", "-"), "embree": ("#7f7f7f", "--"),
    "embree robust": ("#7f7f7f", ":"),
}


def style(structure: str) -> dict:
    color, dashes = STYLES.get(structure, ("#ff7f0e", "-"))
    return {"color": color, "linestyle": dashes}


def save(figure, folder: pathlib.Path, name: str) -> None:
    """As SVG and PNG, whole or not at all."""
    for kind in ("svg", "png"):
        path = folder / f"{name}.{kind}"
        beside = path.with_name(f".{name}.{kind}")
        figure.savefig(beside, format=kind, dpi=110, bbox_inches="tight")
        beside.replace(path)
        print(f"wrote {path}")
    plt.close(figure)


def curves(rows: list[dict], value) -> dict[str, list[tuple[int, float]]]:
    """Of each structure, (N, value of its row), sorted; rows without a value are left out."""
    found: dict[str, dict[int, float]] = collections.defaultdict(dict)
    for row in rows:
        y = value(row)
        if y:
            found[row["structure"]][row["triangles"]] = y
    return {name: sorted(points.items()) for name, points in found.items()}


def against_size(data: dict, folder: pathlib.Path) -> bool:
    """Cost and node visits against N, a column for each scene: O(N) beside O(log N)."""
    rows = [row for row in data["rows"] if row["rays"] == "primary"]
    scenes = [s for s in dict.fromkeys(row["scene"] for row in rows)
              if len({row["triangles"] for row in rows if row["scene"] == s}) >= 3]
    if not scenes:
        return False
    figure, axes = plt.subplots(2, len(scenes), figsize=(4.2 * len(scenes), 8), squeeze=False, sharex="col")
    for panel in axes[0][1:]:
        panel.sharey(axes[0][0])
    for column, scene in enumerate(scenes):
        here = [row for row in rows if row["scene"] == scene]
        cost, visits = axes[0][column], axes[1][column]
        for name, points in curves(here, lambda row: 1000 / row["mrays"]).items():
            cost.plot(*zip(*points), marker="o", markersize=3, label=name, **style(name))
        cost.set(title=scene, xscale="log", yscale="log")
        fits = {fit["structure"]: fit for fit in data["fits"] if fit["scene"] == scene}
        for name, points in curves(here, lambda row: row["nodes"]).items():
            visits.plot(*zip(*points), marker="o", markersize=3, linestyle="none", color=style(name)["color"])
            if fit := fits.get(name):
                sizes = [points[0][0], points[-1][0]]
                visits.plot(sizes, [fit["a"] + fit["b"] * math.log2(n) for n in sizes], color=style(name)["color"], linewidth=1,
                            label=f"{name}: {fit['a']:.1f} {fit['b']:+.2f} log$_2$ N, R² = {fit['r2']:.3f}")
        visits.set(xscale="log", xlabel="surfaces N")
        visits.set_ylim(0, 1.8 * max(row["nodes"] for row in here))  # room for the legend
        visits.legend(fontsize=6, loc="upper left")
    axes[0][0].set_ylabel("ns a primary ray, one thread")
    axes[1][0].set_ylabel("nodes a primary ray looks at,\nand the line through log N")
    lines = {label: line for panel in axes[0] for line, label in zip(*panel.get_legend_handles_labels())}
    axes[0][-1].legend(lines.values(), lines.keys(), fontsize=7, loc="center left", bbox_to_anchor=(1, 0.5))
    save(figure, folder, "trace_size")
    return True


def error_against_speed(data: dict, folder: pathlib.Path) -> None:
    """Wrong answers a million rays against speed, a panel for each kind of rays, a point for each scene at its largest size."""
    kinds = list(dict.fromkeys(row["rays"] for row in data["rows"]))
    largest: dict[str, int] = {}
    for row in data["rows"]:
        largest[row["scene"]] = max(largest.get(row["scene"], 0), row["triangles"])
    figure, axes = plt.subplots(1, len(kinds), figsize=(4 * len(kinds), 4.2), squeeze=False, sharey=True)
    markers = dict(zip(largest, "os^Dvp*X"))
    floor = 0.1  # where none is wrong
    for panel, kind in zip(axes[0], kinds):
        for row in data["rows"]:
            if row["rays"] == kind and row["triangles"] == largest[row["scene"]] and row["threads"] == 1:
                wrong = 1e6 * row["wrong"] / row["traced"]
                panel.plot(row["mrays"], max(wrong, floor), marker=markers.get(row["scene"], "o"), linestyle="none",
                           color=style(row["structure"])["color"], fillstyle="none" if row["structure"].startswith("embree") else "full")
        panel.set(title=kind, xscale="log", yscale="log", xlabel="million rays a second, one thread")
        panel.axhline(floor, color="#cccccc", linewidth=0.8, zorder=0)
    axes[0][0].set_ylabel("wrong answers of a million rays")
    axes[0][0].set_ylim(floor / 2, 2e6)
    ticks = [floor] + [10.0**k for k in range(0, 7)]
    axes[0][0].set_yticks(ticks, ["none"] + [f"{t:,.0f}" for t in ticks[1:]])
    names = list(dict.fromkeys(row["structure"] for row in data["rows"]))
    handles = [plt.Line2D([], [], marker="s", linestyle="none", label=n, color=style(n)["color"],
                          fillstyle="none" if n.startswith("embree") else "full") for n in names]
    handles += [plt.Line2D([], [], marker=m, linestyle="none", label=f"{s}, {largest[s]:,}", color="#444444", fillstyle="none")
                for s, m in markers.items()]
    axes[0][-1].legend(handles=handles, fontsize=7, loc="center left", bbox_to_anchor=(1, 0.5))
    save(figure, folder, "trace_error")


def main(source: str, target: str) -> int:
    data = json.loads(pathlib.Path(source).read_text(encoding="utf-8"))
    folder = pathlib.Path(target)
    folder.mkdir(parents=True, exist_ok=True)
    error_against_speed(data, folder)
    if not against_size(data, folder):
        print("no plot against the number of surfaces: it needs three sizes or more, as --sweep measures")
    return 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
