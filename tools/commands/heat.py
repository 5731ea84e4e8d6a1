# SPDX-License-Identifier: MIT
"""What each pixel of a lab's picture costs, with the student's code; and the levels of its hierarchy."""

import pathlib
import sys

import pictures
import process
import student
import whole
from explaining import heat, program
from labs import ROOT

SUMMARY = "what each pixel costs: rays, boxes and surfaces asked, as a picture: out/heat/"
USAGE = "heat NN [--picture NAME] [--solution]"

PATIENCE = 12  # times the limit of a step: it is the whole picture


def run(arguments: list[str]) -> int:
    parser = process.arguments(USAGE, SUMMARY)
    student.takes_a_lab(parser)
    parser.add_argument("--picture", metavar="NAME", help="which of the lab's pictures, or a part of its name (default: the main one)")
    parser.add_argument("--solution", action="store_true", help="our header instead of yours")
    wish = parser.parse_args(arguments)
    lab = wish.lab
    try:
        explainer = program.Explainer(lab, wish.solution)
        picture = explainer.picture(wish.picture)
        data = explainer.ask("heat", picture.name, patience=PATIENCE)
    except student.NotYet as problem:
        print(problem, file=sys.stderr)
        return 1
    title = f"Lab {lab.number}, {picture.name}"
    maps = heat.maps(data, picture)
    if not maps:
        print(f"{title}: no pixel sends a ray")
        return 0
    print(f"{title}: {picture.width} × {picture.height} pixels, {data['samples']} sample{'s' if data['samples'] != 1 else ''} each\n{heat.table(maps)}")

    folder, default = ROOT / "out" / "heat", picture is explainer.pictures[0]
    stem = lab.name if default else pathlib.Path(picture.name).stem
    folder.mkdir(parents=True, exist_ok=True)
    files = []
    for each in maps:
        files.append(folder / f"{stem}_{each.name}.png")
        whole.write_bytes(files[-1], pictures.png(each.drawn()))
    drawn = heat.levels(data["levels"]) if data["levels"] else []
    for old in folder.glob(f"{stem}_level_*.svg"):
        old.unlink()
    for i, (_, svg) in enumerate(drawn):
        whole.write(folder / f"{stem}_level_{i:02}.svg", svg)
    x, y = maps[-1].where
    explains = f"./lab explain {lab.number} --pixel {x},{y}" + ("" if default else f" --picture {picture.name}") + (" --solution" if wish.solution else "")
    page = folder / f"{stem}.html"
    whole.write(page, heat.page(title, explains, "our" if wish.solution else "your", maps, data["samples"], drawn))
    more = f", and {len(drawn)} levels, {stem}_level_00.svg to {stem}_level_{len(drawn) - 1:02}.svg" if drawn else ""
    print(f"\n{', '.join(process.shorten(str(file)) for file in files)}{more}\nThe page: {process.shorten(str(page))}\nWhy the hottest is so hot: {explains}")
    return 0
