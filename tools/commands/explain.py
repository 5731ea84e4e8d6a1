# SPDX-License-Identifier: MIT
"""Why a pixel looks so: all its rays, from the student's own code, as text and as a page to turn."""

import pathlib
import sys

import process
import student
import whole
from explaining import page, program, text
from labs import ROOT

SUMMARY = "why a pixel of your picture looks so: its rays, as text and as a page: out/explain/"
USAGE = "explain NN --pixel X,Y [--picture NAME] [--sample K] [--solution]"


def run(arguments: list[str]) -> int:
    parser = process.arguments(USAGE, SUMMARY)
    student.takes_a_lab(parser)
    parser.add_argument("--pixel", required=True, metavar="X,Y", help="counted from the top left corner, which is 0,0")
    parser.add_argument("--picture", metavar="NAME", help="which of the lab's pictures, or a part of its name (default: the main one)")
    parser.add_argument("--sample", type=int, metavar="K", help="print only the K-th of the pixel's samples; the page has all")
    parser.add_argument("--solution", action="store_true", help="our header instead of yours")
    wish = parser.parse_args(arguments)
    lab = wish.lab
    try:
        explainer = program.Explainer(lab, wish.solution)
        picture = explainer.picture(wish.picture)
        x, y = program.pixel(wish.pixel, picture)
        data = text.mend(explainer.ask("pixel", picture.name, str(x), str(y)))
    except student.NotYet as problem:
        print(problem, file=sys.stderr)
        return 1
    samples = len(data["samples"])
    if wish.sample is not None and not 1 <= wish.sample <= samples:
        raise process.Misuse(f"the pixel has the samples 1 to {samples}, and no sample {wish.sample}")
    title = f"Lab {lab.number}, {picture.name}, pixel {x},{y}"
    print(text.told(data, title, None if wish.sample is None else wish.sample - 1))
    stem = pathlib.Path(picture.name).stem if picture is not explainer.pictures[0] else lab.name
    file = ROOT / "out" / "explain" / f"{stem}_{x}_{y}.html"
    file.parent.mkdir(parents=True, exist_ok=True)
    whole.write(file, page.made(data, title, lab, None if wish.sample is None else wish.sample - 1))
    print(f"\nThe page, to turn and to point at: {process.shorten(str(file))}")
    return 0
