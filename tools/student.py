# SPDX-License-Identifier: MIT
"""Building with a student's header, and what can go wrong before the first test runs, in words for a student."""

import argparse
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
from typing import Callable

import labs
import machine
import process
import project
import verdict
from labs import ROOT, Lab


def takes_a_lab(parser: argparse.ArgumentParser, *, optional: bool = False) -> None:
    """The argument NN; parsed, `lab` is the Lab, or None where it may be left out and was."""
    parser.add_argument("lab", metavar="NN", type=lab_named, nargs="?" if optional else None,
                        help="the lab's number, such as 03" + (" (default: the one in hand)" if optional else ""))


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
    if solution and not lab.solution_file.exists():
        raise NotYet(no_solution(lab))
    file = lab.solution_file if solution else lab.student_file
    shown = process.shorten(file)
    if not file.exists():
        raise NotYet(f"{shown} is not there. To get it back:\n  git restore {shown}  brings the last committed version back\n"
                     f"  ./lab reset {lab.number}  writes the empty starter again")
    tree = set_up()
    target = lab.name + ("_solution" if solution else "") + kind
    good, output = build(tree, target)
    if not good:
        raise NotYet(explain_build_failure(lab, file, output))
    return program(tree, target)


def no_solution(lab: Lab) -> str:
    return f"This copy of Lantern has no solution of lab {lab.number}: your course keeps them."


def by_itself(lab: Lab, tree: pathlib.Path) -> Callable[[], str]:
    """Begins to compile the student's header with nothing before it; call the result for what the compiler has against that. The
    tests' binding brings headers along, so that a forgotten #include shows only later, in the lab's program or at a grader's."""
    try:
        commands = json.loads((tree / "compile_commands.json").read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return lambda: ""
    bound = next((each["command"] for each in commands if f"/{lab.name}_check_bind.dir/" in each["command"]), None)
    if bound is None:
        return lambda: ""
    words, kept = iter(shlex.split(bound)), []
    for word in words:
        if word in ("-include", "-Xclang", "-o", "-c"):  # the precompiled header, by GCC and by Clang; the output; the input
            next(words)
        else:
            kept.append(word)
    child = subprocess.Popen([*kept, "-w", "-fsyntax-only", "-x", "c++", str(lab.student_file)], stdin=subprocess.DEVNULL,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")

    def told() -> str:
        output, _ = child.communicate()
        if child.returncode == 0:
            return ""
        return (f"{process.shorten(lab.student_file)} lacks an #include: the tests bring it along, others do not. By itself the file does not compile:\n"
                + "\n".join("  " + line for line in first_error(output).splitlines()))

    return told


def ended(status: int) -> str:
    """How a program ended that did not end well."""
    return f"crashed ({verdict.signal_name(-status)})" if status < 0 else f"ended with exit code {status}"


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


def tree_of(built_program: pathlib.Path) -> pathlib.Path:
    return built_program.parents[2]


def build(tree: pathlib.Path, *targets: str) -> tuple[bool, str]:
    """Builds in silence; whether that went well, and what would have been printed."""
    command = ["cmake", "--build", str(tree), "--target", *targets]
    if program(tree, targets[0]).exists():
        code, output = process.capture(command)
        return code == 0, output
    print(f"building {targets[0]}; the first time takes a minute or two ...", file=sys.stderr, flush=True)

    def progress(line: str) -> None:
        step = re.match(r"\[(\d+)/(\d+)\]", line)
        if step and sys.stderr.isatty():
            print(f"\r{step[1]} of {step[2]} ", end="", file=sys.stderr, flush=True)

    code, output = process.followed(command, progress)
    if sys.stderr.isatty():
        print("\r\033[K", end="", file=sys.stderr, flush=True)
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
    shown, handout = file.relative_to(ROOT), lab.handout.relative_to(ROOT)  # the grading says it too: not as seen from here
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
    mine = failed is None or any(part in failed[1] for part in ("bind", "main.cpp", "explain.cpp"))
    words = [f"{shown} does not compile yet. The first error:" if mine else
             "Something other than your header does not build. Is all of Lantern as it was? (git status) The first error:", "",
             *("  " + line for line in error.splitlines()), ""]
    missing = re.search(r"lantern/(\w+)\.hpp: No such file|'lantern/(\w+)\.hpp' file not found", error)
    if missing and (ROOT / "include" / "lantern" / f"{missing[1] or missing[2]}.hpp").exists():
        words.append(f"This lab may include these headers of the library, and what they include: {', '.join(lab.headers)}.")
    return "\n".join(words).rstrip()
