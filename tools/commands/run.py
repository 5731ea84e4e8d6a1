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


def run(arguments: list[str]) -> int:
    parser = process.arguments(USAGE, SUMMARY)
    parser.add_argument("lab", metavar="NN", help="the lab's number, such as 03")
    parser.add_argument("--solution", action="store_true", help="with our header instead of yours")
    wish = parser.parse_args(arguments)

    lab = student.lab_named(wish.lab)
    try:
        path = student.built(lab, "", wish.solution)
    except student.NotYet as problem:
        print(problem, file=sys.stderr)
        return 1

    sys.stdout.flush()
    program = subprocess.Popen([str(path), "out"], cwd=ROOT, stdin=subprocess.DEVNULL,
                               stdout=subprocess.PIPE, text=True, errors="replace")
    for line in program.stdout:
        print(line, end="", flush=True)
        picture = ROOT / line.strip()
        if picture.suffix == ".ppm" and picture.is_file():
            converted = ppm_to_png.convert(picture)
            if converted:
                print(f"{converted.relative_to(ROOT)} (the same)")
            else:
                print(f"  ... which is no valid PPM file: ./lab check {lab.number} says more")
    status = program.wait()
    if status != 0:
        ended = f"crashed (signal {-status})" if status < 0 else f"ended with exit code {status}"
        print(f"The program {ended}. ./lab check {lab.number} looks at each step by itself.", file=sys.stderr)
        return 1
    return 0
