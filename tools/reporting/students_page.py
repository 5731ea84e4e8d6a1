# SPDX-License-Identifier: MIT
"""The page's sections about samplers that students wrote."""

import pathlib

from reporting.markup import duration, escape, figure, slug, svg, table

LABELS = {"gap": "to do"}
COLOURS = {"better": "good", "sound": "good", "gap": "gap"}  # all others are bad


def kind(name: str, text: str) -> str:
    return f'<span class="{COLOURS.get(name, "bad")}">{escape(text)}</span>'


def own(report: dict, folder: pathlib.Path) -> str:
    text = ('<p>Your header makes the points, and nothing else; the pictures, the rays and the measuring are ours. Beside it stands that sampler of ours which it '
            'ought to be like. z is how many standard errors a bias is away from 0, of the mean over the picture or of its pixels, whichever is more; what is called a bias is no noise.</p>')
    for entry in report["own"]:
        text += f'<h3>Lab {entry["lab"]}: {escape(entry["title"])}</h3><p class="faint">{escape(entry["header"])}</p>'
        if entry["message"]:
            text += f'<div class="card bad"><p>It could not be measured.</p><pre>{escape(entry["message"])}</pre></div>'
            continue
        text += f'<p class="card {COLOURS.get(entry["worst"], "bad")}">{escape(entry["headline"])}</p>'
        if not any(one["rows"] for one in entry["curves"]):  # nothing to draw
            text += "".join(f"<p>{kind(one['kind'], one['sentence'])}</p>" for one in {each["sentence"]: each for each in entry["curves"]}.values())
            continue
        text += curves_table(entry)
        for one in entry["curves"]:
            text += f'<h4>{escape(title(entry, one))}</h4><p class="sentence">{kind(one["kind"], one["sentence"])}</p>'
            if one["rows"]:
                name = figure_name(entry, one)
                text += f'<div class="plots">{svg(name + "_time", folder) if one["seconds_per_sample"] else ""}{svg(name + "_samples", folder)}</div>'
    return text


def title(entry: dict, one: dict) -> str:
    effect = one["effect"].capitalize()
    return effect if len({each["pattern"] for each in entry["curves"]}) == 1 else f'{effect}, {one["pattern"]}'


def figure_name(entry: dict, one: dict) -> str:
    return f'own_{entry["lab"]}_{slug(one["pattern"])}_{slug(one["effect"])}'


def curves_table(entry: dict) -> str:
    rows = []
    for one in entry["curves"]:
        slope = f'{figure(one["slope"], "{:.3f}")} ({figure(one["slope_low"], "{:.3f}")} to {figure(one["slope_high"], "{:.3f}")})' if one["slope"] is not None else "–"
        rows.append([escape(title(entry, one)), kind(one["kind"], LABELS.get(one["kind"], one["kind"])), slope, figure(one["theory"], "{:.2f}"), z(one["largest_z"] if one["rows"] else None),
                     figure(one["rmse_beside_ours"], "{:.2f} ×"), duration(one["seconds_per_sample"]), figure(one["time_beside_ours"], "{:.2f} ×")])
    return table(["", "", "slope, 95 %", "theory", "largest z", "error beside ours", "a sample", "time beside ours"], rows)


def z(x: float | None) -> str:
    """The program's own limit is 999: an infinite one would be no number in JSON."""
    return "–" if x is None else "over 999" if x >= 999 else figure(x, "{:.1f}" if x < 100 else "{:.0f}")


def submissions(report: dict, folder: pathlib.Path) -> str:
    entries = report["submissions"]
    measured = [entry for entry in entries if entry["curves"]]
    odd = [entry for entry in entries if entry["outlier"]]
    text = (f'<p>{len(entries)} submissions of lab {entries[0]["lab"]}, {escape(entries[0]["title"])}; {len(entries) - len(odd)} of them sound in every picture. Each ran in '
            f'a sandbox that hands out points and nothing else: what is plotted was measured outside. Marked are those that are not sound, and those whose error is '
            f'more than 15 % away from the median of all; thin lines are the others.</p>')
    if measured:
        plots = "".join(svg(f"all_{slug(pattern)}_{slug(effect)}", folder) for pattern, effect in pictures_of(entries))
        text += f'<div class="plots">{plots}</div>'
    rows = []
    for entry in sorted(entries, key=lambda each: (not each["outlier"], each["name"].lower())):
        ratios = [one["rmse_beside_ours"] for one in entry["curves"] if one["rmse_beside_ours"]]
        times = sorted(one["time_beside_ours"] for one in entry["curves"] if one["time_beside_ours"])
        rows.append([("● " if entry["outlier"] else "") + escape(entry["name"]), "~" + kind(entry["worst"], entry["headline"]),
                     z(max((one["largest_z"] for one in entry["curves"] if one["rows"]), default=None)),
                     f'{figure(min(ratios), "{:.2f}")} to {figure(max(ratios), "{:.2f}")}' if ratios else "–",
                     figure(times[len(times) // 2], "{:.2f} ×") if times else "–"])
    text += table(["submission", "~what it shows", "largest z", "error beside ours", "time beside ours"], rows)
    for entry in entries:
        if entry["message"]:
            inner = f'<pre>{escape(entry["message"])}</pre>'
        else:
            inner = curves_table(entry) + "".join(f'<p>{escape(title(entry, one))}: {kind(one["kind"], one["sentence"])}</p>' for one in entry["curves"])
        text += f'<details><summary>{escape(entry["name"])}</summary>{inner}</details>'
    return text


def pictures_of(entries: list[dict]) -> list[tuple[str, str]]:
    """Pattern and effect, of each that somebody has a curve of."""
    return list(dict.fromkeys((one["pattern"], one["effect"]) for entry in entries for one in entry["curves"] if one["rows"]))
