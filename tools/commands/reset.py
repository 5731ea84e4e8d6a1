# SPDX-License-Identifier: MIT
"""The empty starter again; what was written is kept beside it."""

import process
import progress
import student
import whole

SUMMARY = "begin a lab anew; your old file is kept"
USAGE = "reset NN"
EXAMPLES = "./lab reset 03"


def run(arguments: list[str]) -> int:
    parser = process.arguments(USAGE, SUMMARY, EXAMPLES)
    student.takes_a_lab(parser)
    lab = parser.parse_args(arguments).lab
    file = lab.student_file
    shown = process.shorten(file)
    starter = lab.starter()
    progress.forget(lab)
    if file.exists() and file.read_text(encoding="utf-8", errors="replace") == starter:
        print(f"{shown} is the empty starter already.")
        return 0
    if file.exists():
        kept = free_name(file)
        file.rename(kept)
        print(f"Your file is kept; to have it back: mv {process.shorten(kept)} {shown}")
    whole.write(file, starter)
    print(f"{shown} is the empty starter again.")
    return 0


def free_name(file):
    """glossy.hpp.1, or the next number that is free."""
    number = 1
    while (kept := file.with_name(f"{file.name}.{number}")).exists():
        number += 1
    return kept
