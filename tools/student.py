# SPDX-License-Identifier: MIT
"""Building with a student's header, and what can go wrong before the first test runs, in words for a student."""

import os
import pathlib
import re
import sys

import labs
import machine
import process
import project
from labs import ROOT, Lab, Problem


def lab_named(word: str) -> Lab:
    lab = labs.find(word)
    if lab is None:
        known = "\n".join(f"  {each.number}  {each.title}" for each in labs.all_labs())
        raise process.Misuse(f"there is no lab '{word}'; these are the labs:\n{known}")
    return lab


def require_header(lab: Lab, solution: bool = False) -> pathlib.Path:
    """The header to build with; a Problem with the way to restore it when it is not there."""
    file = lab.solution_file if solution else lab.student_file
    shown = file.relative_to(ROOT)
    if not file.exists():
        again = "" if solution else f"\n  ./lab starters {lab.number}  writes the empty starter again"
        raise Problem(f"{shown} is not there. To get it back:\n  git restore {shown}  brings the last committed version back{again}")
    return file


def set_up() -> pathlib.Path:
    """The build tree, configured. What that prints goes to the error stream: the output is the verdict's."""
    sys.stdout.flush()
    output = os.dup(1)
    os.dup2(2, 1)
    try:
        machine.ensure("test")
        return project.configure("release", tests=True)
    finally:
        sys.stdout.flush()
        os.dup2(output, 1)
        os.close(output)


def program(tree: pathlib.Path, target: str) -> pathlib.Path:
    return tree / "labs" / "bin" / target


def build(tree: pathlib.Path, *targets: str) -> tuple[bool, str]:
    """Builds in silence; whether that went well, and what would have been printed."""
    if not program(tree, targets[0]).exists():
        print(f"building {targets[0]}; the first time takes a while ...", file=sys.stderr, flush=True)
    code, output = process.capture(["cmake", "--build", str(tree), "--target", *targets])
    return code == 0, output


def first_error(output: str) -> str:
    """The compiler's first error with the lines that belong to it; the end of the output where there is none."""
    lines = re.sub(r"\x1b\[[0-9;]*[mK]", "", output).replace(str(ROOT) + "/", "").splitlines()
    for i, line in enumerate(lines):
        if re.search(r"\berror: |undefined reference|multiple definition", line):
            next_message = re.compile(r"\S+:\d+:(\d+:)? |\S+: In |In file included|ninja: |compilation terminated|make|collect2")
            rest = lines[i + 1:i + 9]
            end = next((j for j, text in enumerate(rest) if next_message.match(text)), len(rest))
            return "\n".join([line, *rest[:end]])
    return "\n".join(lines[-30:])


def explain_build_failure(lab: Lab, file: pathlib.Path, output: str) -> str:
    error = first_error(output)
    handout = f"labs/{lab.folder}/README.md"
    failed = re.search(r"^FAILED: (\S+)", output, re.MULTILINE)
    mine = failed is None or "bind" in failed[1] or "main.cpp" in failed[1]
    words = [f"{file.relative_to(ROOT)} does not compile yet. The first error:" if mine else
             "Something other than your header does not build. Is all of Lantern as it was? (git status) The first error:", "",
             *("  " + line for line in error.splitlines()), ""]
    missing = re.search(r"lantern/(\w+)\.hpp: No such file|'lantern/(\w+)\.hpp' file not found", error)
    if missing and (ROOT / "include" / "lantern" / f"{missing[1] or missing[2]}.hpp").exists():
        words.append(f"This lab may include these headers of the library, and what they include: {', '.join(lab.headers)}.")
    elif "YOUR HEADER LACKS" in error or "YOUR FUNCTION HAS" in error:
        asked = re.search(r"bind<contract::\w+::(\w+)>\((\w+)\)", output)
        if asked:
            words.append(f"It is about the function '{asked[1]}'.")
        words.append(f"Compare your declarations with those in {handout}, \"What you write\".")
    return "\n".join(words).rstrip()
