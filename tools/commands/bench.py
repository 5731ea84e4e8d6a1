# SPDX-License-Identifier: MIT
"""Measurements: each is a program in bench/."""

import contextlib
import os
import subprocess
import sys

import machine
import process
import project
from process import ROOT

SUMMARY = "measure the library: " + ", ".join(sorted(file.stem for file in (ROOT / "bench").glob("*.cpp")))
USAGE = "bench NAME [OPTION...]"


def run(arguments: list[str]) -> int:
    known = sorted(file.stem for file in (ROOT / "bench").glob("*.cpp"))
    parser = process.arguments(USAGE, SUMMARY)
    parser.add_argument("name", metavar="NAME", help="one of: " + ", ".join(known))
    parser.add_argument("options", nargs="...", metavar="OPTION", help="handed to the program, such as --json or --check")
    wish = parser.parse_args(arguments)
    if wish.name not in known:
        raise process.Misuse(f"unknown benchmark '{wish.name}'; there is: {', '.join(known)}")

    with everything_on_stderr():  # what the program prints may be read by another
        machine.ensure("build")
        folder = project.configure("release", tests=False)
        project.build(folder, f"bench_{wish.name}")
    return subprocess.run([str(folder / "bench" / wish.name), *wish.options], stdin=subprocess.DEVNULL, check=False).returncode


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
