# SPDX-License-Identifier: MIT
"""Where you are: ./lab alone."""

import sys

import labs
import process
import progress
from commands.check import Colors

SUMMARY = "where you are, and what is next (./lab alone)"
USAGE = "status"


def run(arguments: list[str]) -> int:
    process.arguments(USAGE, SUMMARY).parse_args(arguments)
    known = progress.load()
    everything = labs.all_labs()
    color = Colors(sys.stdout.isatty())
    done = total = 0
    lines = []
    widest = max((len(lab.title) for lab in everything), default=0)
    here = progress.current(known)
    for lab in everything:
        steps = progress.passed(lab, known)
        done += sum(steps)
        total += len(steps)
        bar = "".join(color.green("■") if step else "□" for step in steps)
        remark = ""
        if progress.changed_since(lab, known):
            remark = "  changed since the last verdict" if known.get(lab.number, {}).get("header") else "  begun"
        mark = color.bold("→") if here is not None and lab.number == here.number else color.green("✓") if all(steps) else " "
        lines.append(f" {mark} {lab.number}  {lab.title:<{widest}}  {bar}{remark}")
    width = 40
    filled = round(width * done / total) if total else 0
    print(color.bold("Lantern") + f"  [{color.green('#' * filled)}{'.' * (width - filled)}]  {done} of {total} steps\n")
    print("\n".join(lines) + "\n")
    if here is None:
        print(color.green("All labs are done."))
        return 0
    steps = progress.passed(here, known)
    step = steps.index(False)
    print(f"Next: lab {here.number}, step {step + 1}: {here.steps[step]}")
    print(f"  read   {process.shorten(here.handout)}\n  write  {process.shorten(here.student_file)}")
    print(f"  then   ./lab watch {here.number}   tells you after every save how far you are\n"
          f"         ./lab hint {here.number}    when you are stuck\n         ./lab help       everything else")
    return 0
