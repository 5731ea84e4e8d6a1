# SPDX-License-Identifier: MIT
"""The labs' starters, made out of the solutions."""

import labs
import process
import student
import whole

SUMMARY = "write the labs' starters, generated from the solutions"
USAGE = "starters [NN...] [--check] [--force]"
EXAMPLES = """./lab starters           all that nobody has worked on
./lab starters --check   say which are not current"""


def run(arguments: list[str]) -> int:
    parser = process.arguments(USAGE, SUMMARY, EXAMPLES)
    parser.add_argument("labs", nargs="*", metavar="NN", type=student.lab_named, help="labs' numbers (default: all)")
    parser.add_argument("--check", action="store_true", help="write nothing; say which are not what the solutions generate")
    parser.add_argument("--force", action="store_true", help="write over files with uncommitted changes, too")
    wish = parser.parse_args(arguments)

    kept = 0
    for lab in wish.labs or labs.all_labs():
        file = lab.student_file
        shown = file.relative_to(labs.ROOT)
        made = lab.starter()
        if file.exists() and file.read_text(encoding="utf-8") == made:
            continue
        if wish.check:
            print(f"{shown} is not what the solution generates")
            kept += 1
        elif file.exists() and not wish.force and labs.differs_from_commit(file):
            print(f"{shown} has been worked on since the last commit, and stays as it is; --force writes over it")
            kept += 1
        else:
            whole.write(file, made)
            print(f"{shown} written")
    return 1 if kept else 0
