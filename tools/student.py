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


class NotYet(Exception):
    """The student's file has to be mended first; says how."""


def built(lab: Lab, kind: str, solution: bool = False) -> pathlib.Path:
    """The lab's program ("") or suite ("_check"), built with the student's header or with ours."""
    file = lab.solution_file if solution else lab.student_file
    shown = file.relative_to(ROOT)
    if not file.exists():
        again = "" if solution else f"\n  ./lab starters {lab.number}  writes the empty starter again"
        raise NotYet(f"{shown} is not there. To get it back:\n  git restore {shown}  brings the last committed version back{again}")
    tree = set_up()
    target = lab.name + ("_solution" if solution else "") + kind
    good, output = build(tree, target)
    if not good:
        raise NotYet(explain_build_failure(lab, file, output))
    return program(tree, target)


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
    shown, handout = file.relative_to(ROOT), f"labs/{lab.folder}/README.md"
    broken_promise = re.search(r"error: .*(YOUR HEADER LACKS|YOUR FUNCTION HAS)", output)
    if broken_promise:
        # The compiler names the function as name<7>{"encode"} (GCC, new Clangs), or in numbers.
        asked = re.search(r'\bname<\d+>\{\{?"(\w+)"', output)
        name = f"the function '{asked[1]}'" if asked else "one of the functions"
        if "LACKS" in broken_promise[1]:
            return (f"{shown} lacks {name}. It must be declared as in {handout}, \"What you write\",\n"
                    f"by that name and within namespace {lab.name}.")
        return (f"In {shown}, {name} takes other parameters or returns something else than the handout says.\n"
                f"Compare its declaration with the one in {handout}, \"What you write\".")

    error = first_error(output)
    failed = re.search(r"^FAILED: (\S+)", output, re.MULTILINE)
    mine = failed is None or "bind" in failed[1] or "main.cpp" in failed[1]
    words = [f"{shown} does not compile yet. The first error:" if mine else
             "Something other than your header does not build. Is all of Lantern as it was? (git status) The first error:", "",
             *("  " + line for line in error.splitlines()), ""]
    missing = re.search(r"lantern/(\w+)\.hpp: No such file|'lantern/(\w+)\.hpp' file not found", error)
    if missing and (ROOT / "include" / "lantern" / f"{missing[1] or missing[2]}.hpp").exists():
        words.append(f"This lab may include these headers of the library, and what they include: {', '.join(lab.headers)}.")
    return "\n".join(words).rstrip()
