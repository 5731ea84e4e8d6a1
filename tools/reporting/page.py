# SPDX-License-Identifier: MIT
"""The report as a page: one HTML file that needs no other, light or dark, wide or narrow."""

import csv
import io
import json
import pathlib
import time

import process
import whole
from labs import Problem
from reporting import digest, judgement, pieces, students_page
from reporting.markup import duration, escape, figure, images, slug, svg, table

STYLE = """
:root { color-scheme: light dark; --ink: #1c1c1e; --paper: #ffffff; --faint: #6b6b70; --line: #d9d9de; --grid: #e4e4e8; --card: #f6f6f8; --good: #1a7f37; --bad: #c22f2f; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e8e8ea; --paper: #161618; --faint: #a0a0a6; --line: #3a3a3e; --grid: #333338; --card: #202024; --good: #4ac26b; --bad: #ff7b72; }
}
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 72rem; padding: 1rem 1.25rem 4rem; font: 16px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper); }
h1 { line-height: 1.2; } h2 { margin-top: 3rem; border-top: 1px solid var(--line); padding-top: 1.5rem; } h3 { margin-top: 2rem; }
p, li { max-width: 46rem; } .faint { color: var(--faint); } .sentence { font-size: 1.1rem; }
nav { display: flex; flex-wrap: wrap; gap: .4rem 1rem; } a { color: inherit; }
.plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 24rem), 1fr)); gap: 1rem; }
.plots svg { width: 100%; max-width: 40rem; height: auto; }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(45%, 14rem), 1fr)); gap: .75rem; margin: 1rem 0; }
figure { margin: 0; } figure img { width: 100%; image-rendering: pixelated; border: 1px solid var(--line); display: block; margin-top: .25rem; } figcaption { font-size: .85rem; color: var(--faint); }
.table { overflow-x: auto; } table { border-collapse: collapse; font-size: .9rem; font-variant-numeric: tabular-nums; }
th, td { padding: .3rem .7rem; border-bottom: 1px solid var(--line); text-align: right; white-space: nowrap; } th:first-child, td:first-child, .text { text-align: left; } td.text { white-space: normal; min-width: 12rem; }
.bad { color: var(--bad); } .good { color: var(--good); }
.gap { color: var(--faint); } pre { overflow-x: auto; font-size: .85rem; } details { margin: .75rem 0; } summary { cursor: pointer; }
.card { background: var(--card); padding: .75rem 1rem; border-radius: .5rem; }
"""


def write(report: dict, folder: pathlib.Path, drawer: str) -> None:
    """report.json, report.csv and index.html, each whole or not at all."""
    whole.write(folder / "report.json", json.dumps(report, indent=1))
    whole.write(folder / "report.csv", as_csv(list(digest.rows(report))))
    whole.write(folder / "prices.csv", as_csv(report["prices"]))
    figures = folder / "figures"
    code, text = process.capture([drawer, str(pathlib.Path(__file__).parent / "plots.py"), str(folder / "report.json"), str(figures)])
    if code != 0:
        raise Problem(f"the plots could not be drawn:\n{text}")
    whole.write(folder / "index.html", page(report, folder))


def as_csv(rows: list[dict]) -> str:
    """All rows have the same columns."""
    text = io.StringIO()
    writer = csv.DictWriter(text, fieldnames=list(rows[0]) if rows else [])
    writer.writeheader()
    writer.writerows(rows)
    return text.getvalue()


NOT_BUILT = "<p>Not measured. With --quick only what is built already is measured here; without it, all.</p>"

# ---- the page ---------------------------------------------------------------------------------------------------------


def page(report: dict, folder: pathlib.Path) -> str:
    sections = [*([("own", "Your sampler", students_page.own)] if report["own"] else []),
                *([("submissions", "All submissions", students_page.submissions)] if report["submissions"] else []),
                ("effects", "Effect by effect", effects), ("ladder", "The ladder of effects", ladder),
                ("accelerators", "Accelerators", accelerators), ("stability", "Stiff and extreme cases", stability),
                ("prices", "What being right costs", price_table), ("leaving-out", "What is left out", leaving_out),
                ("setting", "How it was measured", setting)]
    links = "".join(f'<a href="#{name}">{title}</a>' for name, title, _ in sections)
    body = "".join(f'<section id="{name}"><h2>{title}</h2>{make(report, folder)}</section>' for name, title, make in sections)
    date = time.strftime("%Y-%m-%d")
    return (f'<!doctype html><html lang="en"><head><meta charset="utf-8"><title>Lantern: error against run time</title>'
            f'<meta name="viewport" content="width=device-width, initial-scale=1"><style>{STYLE}</style></head><body>'
            f'<h1>Error against run time</h1><p class="faint">Lantern {escape(report["environment"]["commit"])}, {date}</p>'
            f'<p>Every pixel of the pictures below is known in closed form, so what is plotted is the error itself, not the '
            f'difference from another rendering. All random numbers come from seeds; the figures can be had again.</p>'
            f'{warnings(report)}<nav>{links}</nav>{body}</body></html>')


def warnings(report: dict) -> str:
    lines = digest.complaints(report)
    if not lines:
        return '<p class="card good">No bias, nothing that is not finite, and no slope that theory does not explain.</p>'
    return '<div class="card bad"><p>Look at this first:</p><ul>' + "".join(f"<li>{escape(line)}</li>" for line in lines) + "</ul></div>"


def effects(report: dict, folder: pathlib.Path) -> str:
    settings = report["settings"]
    fitted = report["effects"][0]["curves"][0]["fitted_from"]
    limit = figure(judgement.limit(settings["trials"]), "{:.1f}")
    text = (f'<p>RMSE is the root mean square error over the pixels of a picture and over {settings["trials"]} renderings with different seeds; the bands hold it with a '
            f'confidence of 95 % (bootstrap over the seeds). Lines without marks are predictions from closed forms, and marks without lines what was measured beside them. '
            f'Red in the error pictures is too bright, blue too dark; the colours of all three are stretched as theory says that the error shrinks.</p>'
            f'<p><em>Slopes</em> are fitted from {fitted} samples on. Intervals from so few renderings hold the truth about nine times in ten, so {digest.SLACK} more is granted. '
            f'Theory is about many samples: a slope outside its interval but within {digest.near(settings["most"])} of theory is called near it.</p>'
            f'<p><em>z</em> tells a bias from noise: how many standard errors it is away from 0, of the mean over the picture or of the pixels by themselves, whichever is '
            f'more. Noise alone passes {limit} in a mean, and {judgement.SURE} in the pixels, once in 40 000 measurements.</p>')
    for effect in report["effects"]:
        name = slug(effect["name"])
        pictures = images([f"{name}_exact"], "exact", folder)
        for n in pieces.shown(settings["most"]):
            pictures += images([f"{name}_{n}", f"{name}_{n}_error"], f"{n} samples, and their error", folder)
        rows = []
        for one in effect["curves"]:
            good = one["verdict"] != "not explained"
            rows.append([f"{escape(one['sampler'])}",
                         f"{figure(one['slope'], '{:.3f}')} ({figure(one['slope_low'], '{:.3f}')} to {figure(one['slope_high'], '{:.3f}')})",
                         f'~<span class="{"good" if good else "bad"}">{escape(one["verdict"])}</span>', figure(one["largest_z"], "{:.1f}"),
                         duration(one["seconds_per_sample"]), figure(one["half_error_costs"], "{:.1f} ×"),
                         duration(one["seconds_to_one_percent"])])
        text += (f'<h3 id="{name}">{escape(effect["name"].capitalize())}</h3><p class="faint">{escape(effect["tells"])}</p>'
                 f'<p class="sentence">{escape(effect["sentence"])}</p><div class="pictures">{pictures}</div>'
                 f'<div class="plots">{svg(name + "_time", folder)}{svg(name + "_samples", folder)}</div>'
                 + table(["samples", "slope, 95 %", "~theory", "largest z", "a sample", "half the error", "to RMSE 1 %"], rows))
    return text


def ladder(report: dict, folder: pathlib.Path) -> str:
    rungs = report["ladder"]["rungs"]
    rows = [[("+ " if i else "") + escape(rung["adds"]), str(rung["dimensions"]), figure(rung["instructions"], "{:.0f}"),
             duration(rung["seconds_per_sample"]), figure(rung["rmse"], "{:.4f}"), figure(rung["predicted"], "{:.4f}"),
             "~" + escape(", ".join(rung["leaves_out"]) or "nothing")] for i, rung in enumerate(rungs)]
    return (f'<p>The same scene, with one effect more on each line; {report["ladder"]["samples"]} jittered samples a pixel. What a line leaves '
            f'out is left out by its types: it draws no numbers for it and holds no code for it.</p>'
            f'<div class="plots">{svg("ladder", folder)}</div>'
            + table(["", "numbers", "instructions", "time", "RMSE", "predicted", "~left out"], rows))


def accelerators(report: dict, folder: pathlib.Path) -> str:
    rows = [[escape(row["structure"]), figure(row["nodes"], "{:.1f}"), figure(row["offers"], "{:.1f}"), duration(1e-6 / row["mrays"]),
             duration(1e-3 * row["build_ms"]) if row["build_ms"] else "–", figure(row["bytes_per_triangle"], "{:.0f}"),
             figure(row["breaks_even"], "{:.0f}"), f"{row['wrong']:.0f} of {row['checked']}"] for row in report["accelerators"]]
    triangles = report["accelerators"][0]["triangles"]
    return (f"<p>A terrain of {triangles} triangles, rays through the pixels of a picture, one thread. A structure breaks even after as many rays as make up "
            f"for its building, against trying every triangle. All must find the same hits: wrong are answers that brute force contradicts, wherever two "
            f"structures disagree and at some other rays.</p>"
            + table(["", "nodes a ray", "tests a ray", "a ray", "building", "bytes a triangle", "breaks even at", "wrong"], rows)
            + '<p class="faint">More scenes, sizes and rays, and Embree: ./lab bench trace.</p>')


def stability(report: dict, folder: pathlib.Path) -> str:
    if not report["stability"]:
        return NOT_BUILT
    rows = [[escape(group["group"]), str(group["cases"]), str(group["wrong"]), figure(group["ulp_max"], "{:.2f}"),
             "~" + (f'<span class="bad">{escape(", ".join(group["failed"]))}</span>' if group["failed"] else '<span class="good">all pass</span>')]
            for group in report["stability"]]
    return ("<p>Cases of 256 variants each, against truths of 40 digits and against laws. An ulp is the distance to the next float; half of one is all "
            "that rounding a right answer costs.</p>" + table(["", "cases", "wrong answers", "largest error, ulp", "~verdict"], rows)
            + '<p class="faint">Case by case: ./lab stress.</p>')


FORMULAS = {"sphere": "a ray and a sphere", "triangle": "a ray and a triangle", "plane": "a ray and a plane", "box": "a ray and a box",
            "basis": "a basis around a vector", "refraction": "a refracted ray", "leave": "leaving a surface", "mean": "the mean of samples"}


def price_table(report: dict, folder: pathlib.Path) -> str:
    if not report["prices"]:
        return NOT_BUILT
    counted = report["settings"]["valgrind"]
    unit = "instructions" if counted else "nanoseconds"
    rows = []
    for row in report["prices"]:
        decides = row["textbook_ulp_max"] == 0 and row["ours_ulp_max"] == 0  # and computes nothing that is rounded
        ulps = [None if decides else row[f"{who}_ulp_max"] for who in ("textbook", "ours")]
        rows.append([escape(FORMULAS.get(row["formula"], row["formula"])), wrong(row["textbook_wrong"]), figure(ulps[0], "{:.2g}"),
                     figure(row["textbook_cost"], "{:.0f}"), wrong(row["ours_wrong"]), figure(ulps[1], "{:.2g}"), figure(row["ours_cost"], "{:.0f}"),
                     figure(row["ratio"], "{:.2f} ×")])
    return (f"<p>Every formula twice: as the textbooks have it, in float, and as the library has it. Wrong are answers of the scorecard's cases, stiff and extreme "
            f"ones, that are decided wrongly or are not finite; an error is that of the others, in ulp; where only yes or no is asked there is none. What a call costs is measured with everyday input, half of it "
            f"hits: {unit}{', counted' if counted else ''}.</p>"
            + table(["", "textbook: wrong", "largest error, ulp", unit, "ours: wrong", "largest error, ulp", unit, "costs"], rows)
            + ("" if counted else '<p class="faint">valgrind is not here to count instructions: these are times, and no two runs agree on them.</p>'))


def wrong(count: int) -> str:
    return f'<span class="bad">{count}</span>' if count else "0"


def leaving_out(report: dict, folder: pathlib.Path) -> str:
    if not report["leaving_out"]:
        return NOT_BUILT if report["settings"]["valgrind"] else "<p>Not measured: that takes valgrind.</p>"
    rows = [[escape(row["scene"]), figure(row["stripped"], "{:.0f}"), figure(row["trimmed"], "{:.0f}"),
             figure(100 * (row["trimmed"] / row["stripped"] - 1), "{:+.1f} %"), figure(row["everything"], "{:.0f}")] for row in report["leaving_out"]]
    return ("<p>Instructions a sample, of four spheres: a kernel written by hand for the scene; the scene, chosen at run time and cut down by "
            "<code>trim</code>; and the types that hold everything. All three make the same picture, bit for bit, and what is absent draws no numbers. A few per cent either way are the compiler's: which "
            "values it keeps in registers.</p>"
            + table(["scene has", "by hand", "trimmed", "", "everything"], rows))


def setting(report: dict, folder: pathlib.Path) -> str:
    environment, settings = report["environment"], report["settings"]
    rows = [[escape(name), "~" + escape(environment[name])] for name in ("processor", "cores", "load", "compiler", "flags", "system", "commit")]
    rows += [["trials", "~" + str(settings["trials"])], ["first seed", "~" + str(settings["seed"])], ["threads", "~1 for times; errors do not depend on them"]]
    return ('<p>Errors and times are measured in separate runs. Times are those of the processor, for one thread, the median of five; '
            'other programs on the same machine still make them longer, the errors never.</p>' + table(["", ""], rows) +
            '<p class="faint">The same figures: report.csv, prices.csv, report.json.</p>')
