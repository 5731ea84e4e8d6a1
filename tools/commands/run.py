# SPDX-License-Identifier: MIT
"""A lab's program with the student's header, and where its pictures are."""

import subprocess
import sys

import ppm_to_png
import process
import student
from process import ROOT

SUMMARY = "build and run a lab's program; the pictures go to out/"
USAGE = "run NN [--solution]"
EXAMPLES = "./lab run 03"


def run(arguments: list[str]) -> int:
    parser = process.arguments(USAGE, SUMMARY, EXAMPLES)
    student.takes_a_lab(parser)
    parser.add_argument("--solution", action="store_true", help="with our header instead of yours, where your copy has it")
    wish = parser.parse_args(arguments)

    lab = wish.lab
    try:
        path = student.built(lab, "", wish.solution)
    except student.NotYet as problem:
        print(problem, file=sys.stderr)
        return 1

    sys.stdout.flush()
    program = subprocess.Popen([str(path), "out"], cwd=ROOT, stdin=subprocess.DEVNULL,
                               stdout=subprocess.PIPE, text=True, errors="replace")
    for line in program.stdout:
        picture = ROOT / line.strip()
        is_picture = picture.suffix in (".ppm", ".png") and picture.is_file()
        print(process.shorten(picture) + "\n" if is_picture else line, end="", flush=True)
        if is_picture and picture.suffix == ".ppm":
            converted = ppm_to_png.convert(picture)
            if converted:
                print(f"{process.shorten(converted)} (the same)")
            else:
                print(f"  ... which is no valid PPM file: ./lab check {lab.number} says more")
    status = program.wait()
    if status != 0:
        print(f"The program {student.ended(status)}. ./lab check {lab.number} looks at each step by itself.", file=sys.stderr)
        return 1
    return 0
