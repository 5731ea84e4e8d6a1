# SPDX-License-Identifier: MIT
"""Counting instructions: callgrind, a tool of valgrind, runs a program and counts. Load and speed of the machine are no matter to it."""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from typing import Sequence

NOWHERE = "/dev/null"  # for a profile that nobody reads


@dataclass
class Count:
    printed: str       # by the program itself
    instructions: int  # of all that was counted
    called: dict[str, int]  # with what they call in turn, by function; only where a profile was asked for


class Failed(Exception):
    """The program could not be run, or counted nothing: valgrind does not know each processor's instructions. Says what it said."""


def is_here() -> bool:
    return shutil.which("valgrind") is not None


def works() -> bool:
    """Whether it counts on this machine. Takes a second."""
    try:
        return is_here() and count([sys.executable, "--version"]).instructions > 0
    except Failed:
        return False


def command(argv: Sequence[str], *, within: str = "", profile: str = NOWHERE) -> list[str]:
    """What to run for `argv` to be counted: all of it, or what happens `within` functions whose names fit this pattern."""
    return ["valgrind", "--tool=callgrind", *([f"--toggle-collect={within}"] if within else []), f"--callgrind-out-file={profile}", *argv]


def total(said: str) -> int:
    """The figure that callgrind ends with, on the error stream."""
    found = re.search(r"Collected : (\d+)", said)
    if found is None:
        raise Failed("callgrind counted nothing; it said:\n" + said[-2000:])
    return int(found[1])


def count(argv: Sequence[str], *, within: str = "", by_function: bool = False) -> Count:
    """Runs and counts; `by_function` reads the profile, too."""
    with tempfile.TemporaryDirectory() as folder:
        profile = pathlib.Path(folder) / "callgrind.out"
        try:
            done = subprocess.run(command(argv, within=within, profile=str(profile) if by_function else NOWHERE),
                                  stdin=subprocess.DEVNULL, capture_output=True, text=True, errors="replace", check=False)
        except OSError as problem:
            raise Failed(f"valgrind cannot be run: {problem.strerror}") from problem
        if done.returncode != 0:
            raise Failed(f"under callgrind this ended with exit code {done.returncode}: {' '.join(argv)}\n{done.stderr[-2000:]}")
        return Count(done.stdout, total(done.stderr), calls(profile.read_text(encoding="utf-8")) if by_function else {})


def calls(profile: str) -> dict[str, int]:
    """Inclusive costs of the functions called, from a profile: `cfn=` names one, and below `calls=` stands its cost."""
    names: dict[str, str] = {}
    costs: dict[str, int] = {}
    callee, expected = "", False
    for line in profile.splitlines():
        if match := re.match(r"c?fn=\((\d+)\)(?: (.*))?$", line):
            name = names.setdefault(match[1], match[2] or "")
            if line.startswith("cfn="):
                callee = name
        elif line.startswith("calls="):
            expected = True
        elif expected:
            costs[callee] = costs.get(callee, 0) + int(line.split()[1])
            expected = False
    return costs
