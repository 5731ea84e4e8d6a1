# SPDX-License-Identifier: MIT
"""The empty starter again; what was written is kept beside it."""

import process
import progress
import student
import whole
from labs import ROOT

SUMMARY = "begin a lab anew; your old file is kept"
USAGE = "reset NN"


def run(arguments: list[str]) -> int:
    parser = process.arguments(USAGE, SUMMARY)
    parser.add_argument("lab", metavar="NN", help="the lab's number, such as 06")
    lab = student.lab_named(parser.parse_args(arguments).lab)
    file = lab.student_file
    starter = lab.starter()
    progress.forget(lab)
    if file.exists() and file.read_text(encoding="utf-8", errors="replace") == starter:
        print(f"{file.relative_to(ROOT)} is the empty starter already.")
        return 0
    if file.exists():
        kept = free_name(file)
        file.rename(kept)
        print(f"Your file is now {kept.relative_to(ROOT)}; to have it back: mv {kept.relative_to(ROOT)} {file.relative_to(ROOT)}")
    whole.write(file, starter)
    print(f"{file.relative_to(ROOT)} is the empty starter again.")
    return 0


def free_name(file):
    """glossy.hpp.1, or the next number that is free."""
    number = 1
    while (kept := file.with_name(f"{file.name}.{number}")).exists():
        number += 1
    return kept
