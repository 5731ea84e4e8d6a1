# SPDX-License-Identifier: MIT
"""Measurements: each is a program in bench/."""

import argparse
import contextlib
import os
import pathlib
import subprocess
import sys

import machine
import models
import process
import project
from labs import Problem
from process import ROOT

SUMMARY = "measure the library: " + ", ".join(sorted(file.stem for file in (ROOT / "bench").glob("*.cpp")))
USAGE = "bench NAME [OPTION...]"

# What we add to a program's own options.
EXTRAS = """for trace, besides:
  --dragon   the Stanford dragon, too: fetched by npm the first time, 11 MB
  --plot     pictures in out/, drawn by matplotlib: cost against size (with --sweep), and wrong answers against speed
./lab setup --bench brings npm, matplotlib, and Embree to compare with."""


def run(arguments: list[str]) -> int:
    known = sorted(file.stem for file in (ROOT / "bench").glob("*.cpp"))
    parser = process.arguments(USAGE, SUMMARY)
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.epilog = EXTRAS
    parser.add_argument("name", metavar="NAME", help="one of: " + ", ".join(known))
    parser.add_argument("options", nargs="...", metavar="OPTION", help="handed to the program, such as --json or --check")
    wish = parser.parse_args(arguments)
    if wish.name not in known:
        raise process.Misuse(f"unknown benchmark '{wish.name}'; there is: {', '.join(known)}")

    options = list(wish.options)
    plots = None
    with everything_on_stderr():  # what the program prints may be read by another
        if wish.name == "trace":
            options, plots = for_trace(options)
        machine.ensure("build")
        folder = project.configure("release", tests=False)
        project.build(folder, f"bench_{wish.name}")
    code = subprocess.run([str(folder / "bench" / wish.name), *options], stdin=subprocess.DEVNULL, check=False).returncode
    if plots and code == 0:
        with everything_on_stderr():
            process.need([*plots, str(ROOT / "out" / "trace.json"), str(ROOT / "out")])
    return code


def for_trace(options: list[str]) -> tuple[list[str], list[str] | None]:
    """The options for the program itself, and the command that draws, if that is wished for."""
    plots = None
    if "--dragon" in options:
        at = options.index("--dragon")
        options[at:at + 1] = ["--models", str(models.dragon())]
    if "--plot" in options:
        python = machine.plotter()
        if not python:
            raise Problem("--plot needs matplotlib, and that is not here. ./lab setup --bench brings it; or leave --plot out")
        (ROOT / "out").mkdir(exist_ok=True)
        at = options.index("--plot")
        options[at:at + 1] = ["--save", str(ROOT / "out" / "trace.json")]
        plots = [python, "-B", str(pathlib.Path(__file__).parents[1] / "plot_trace.py")]
    if any(finding.missing for finding in machine.look("bench") if finding.name == "embree"):
        print("Embree is not here and is left out; ./lab setup --bench brings it")
    return options, plots


@contextlib.contextmanager
def everything_on_stderr():
    """What we and the programs that we start print meanwhile goes to stderr."""
    sys.stdout.flush()
    kept = os.dup(1)
    os.dup2(2, 1)
    try:
        yield
    finally:
        sys.stdout.flush()
        os.dup2(kept, 1)
        os.close(kept)
