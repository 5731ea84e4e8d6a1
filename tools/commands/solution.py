# SPDX-License-Identifier: MIT
"""Our answer to a lab, once you have one of your own."""

import difflib
import json
import sys

import labs
import process
import progress
import student
from commands.check import Colors
from labs import ROOT

SUMMARY = "our answer beside yours, once yours passes (or where the course allows it)"
USAGE = "solution NN [--whole]"
EXAMPLES = """./lab solution 03            what differs from yours
./lab solution 03 --whole    our file as it is"""

RULES = ("after passing", "always", "never")


def run(arguments: list[str]) -> int:
    parser = process.arguments(USAGE, SUMMARY, EXAMPLES)
    student.takes_a_lab(parser)
    parser.add_argument("--whole", action="store_true", help="our file as it is, instead of the differences from yours")
    wish = parser.parse_args(arguments)
    lab = wish.lab
    if not lab.solution_file.exists():
        print(student.no_solution(lab))
        return 1
    allowed = rule()
    known = progress.load()
    done = all(progress.passed(lab, known)) and not progress.changed_since(lab, known)
    if allowed == "never" or (allowed == "after passing" and not done):
        why = "your course does not show solutions" if allowed == "never" else f"it is shown when yours passes: ./lab check {lab.number} first"
        print(f"Not yet: {why}. Until then: ./lab hint {lab.number}")
        return 1
    ours = lab.solution_file.read_text(encoding="utf-8").splitlines()
    ours = [line for line in ours if line.strip() not in (labs.BEGIN, labs.END) and not line.strip().startswith(labs.STARTER)]
    if wish.whole or not lab.student_file.exists():
        print("\n".join(ours))
        return 0
    yours = lab.student_file.read_text(encoding="utf-8", errors="replace").splitlines()
    color = Colors(sys.stdout.isatty())
    paint = {"+": color.green, "-": color.red, "@": color.bold}
    shown = lab.student_file.relative_to(ROOT).as_posix()
    for line in difflib.unified_diff(yours, ours, f"yours: {shown}", "ours", lineterm=""):
        print(paint.get(line[:1], str)(line))
    return 0


def rule() -> str:
    """What course.json in the root says under "solutions"; "after passing" where it says nothing."""
    path = ROOT / "course.json"
    if not path.is_file():
        return RULES[0]
    try:
        said = json.loads(path.read_text(encoding="utf-8")).get("solutions", RULES[0])
    except (ValueError, AttributeError) as error:
        raise labs.Problem(f"course.json cannot be read: {error}") from error
    if said not in RULES:
        raise labs.Problem(f'course.json: "solutions" is "{said}", but must be one of: {", ".join(RULES)}')
    return said
