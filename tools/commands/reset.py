# SPDX-License-Identifier: MIT
"""The empty starter again; what was written is kept beside it."""

import labs
import process
import student
from labs import ROOT, Problem

SUMMARY = "begin a lab anew; your old file is kept"
USAGE = "reset NN"


def run(arguments: list[str]) -> int:
    parser = process.arguments(USAGE, SUMMARY)
    parser.add_argument("lab", metavar="NN", help="the lab's number, such as 06")
    lab = student.lab_named(parser.parse_args(arguments).lab)
    file = lab.student_file
    starter = empty(lab)
    if file.exists() and file.read_text(encoding="utf-8", errors="replace") == starter:
        print(f"{file.relative_to(ROOT)} is the empty starter already.")
        return 0
    if file.exists():
        kept = free_name(file)
        file.rename(kept)
        print(f"Your file is now {kept.relative_to(ROOT)}")
    file.write_text(starter, encoding="utf-8")
    print(f"{file.relative_to(ROOT)} is the empty starter again.")
    return 0


def empty(lab: labs.Lab) -> str:
    """The starter: out of the solution, or, where a course has none, as it was committed first."""
    if lab.solution_file.exists():
        return labs.starter_of(lab.solution_file.read_text(encoding="utf-8"), str(lab.solution_file))
    shown = lab.student_file.relative_to(ROOT).as_posix()
    code, first = process.capture(["git", "-C", str(ROOT), "log", "--diff-filter=A", "--format=%H", "--", shown])
    commits = first.split()
    if code == 0 and commits:
        code, text = process.capture(["git", "-C", str(ROOT), "show", f"{commits[-1]}:{shown}"])
        if code == 0:
            return text
    raise Problem(f"neither a solution nor the first version of {shown} in git is here to make the starter of")


def free_name(file):
    """glossy.hpp.1, or the next number that is free."""
    number = 1
    while (kept := file.with_name(f"{file.name}.{number}")).exists():
        number += 1
    return kept
