# SPDX-License-Identifier: MIT
"""Begin a lab, or go on with it."""

import process
import progress
import student
import whole

SUMMARY = "begin a lab, or go on with it"
USAGE = "start NN"
EXAMPLES = "./lab start 03"


def run(arguments: list[str]) -> int:
    parser = process.arguments(USAGE, SUMMARY, EXAMPLES)
    student.takes_a_lab(parser)
    lab = parser.parse_args(arguments).lab
    known = progress.load()
    known["current"] = lab.number
    progress.save(known)

    file = lab.student_file
    shown = process.shorten(file)
    if not file.exists():
        whole.write(file, lab.starter())
        print(f"{shown} was not there: here is the empty one again.")
    print(f"Lab {lab.number}: {lab.title}\n\n  read   {process.shorten(lab.handout)}\n  write  {shown}\n")
    for i, (name, passed) in enumerate(zip(lab.steps, progress.passed(lab, known)), 1):
        print(f"  {'✓' if passed else '·'} step {i}  {name}")
    print(f"\n./lab watch {lab.number}   tells you after every save how far you are\n./lab run {lab.number}     draws the picture, as far as it goes")
    return 0
