# SPDX-License-Identifier: MIT
"""A hint for the step in hand: a nudge at first, then more."""

import textwrap

import hints
import labs
import process
import progress
import student

SUMMARY = "a hint for your next step: a nudge first, then the idea, then nearly the code"
USAGE = "hint [NN] [--step K] [--again]"
EXAMPLES = """./lab hint                   one more, for the step in hand
./lab hint 03 --step 2 --again    those that you had for step 2 of lab 03"""


def run(arguments: list[str]) -> int:
    parser = process.arguments(USAGE, SUMMARY, EXAMPLES)
    student.takes_a_lab(parser, optional=True)
    parser.add_argument("--step", metavar="K", type=process.count, help="the step (default: the first that does not pass yet)")
    parser.add_argument("--again", action="store_true", help="the hints that you had for it already, and no new one")
    wish = parser.parse_args(arguments)
    lab = wish.lab or in_hand()
    if wish.step is not None and not 1 <= wish.step <= len(lab.steps):
        raise process.Misuse(f"lab {lab.number} has the steps 1 to {len(lab.steps)}, and no step {wish.step}")
    known = progress.load()
    steps = progress.passed(lab, known)
    step = wish.step or (steps.index(False) + 1 if False in steps else 0)
    if step == 0:
        print(f"Every step of lab {lab.number} passes. For a look back: ./lab hint {lab.number} --step K")
        return 0
    print(told(lab, step, wish.again))
    return 0


def in_hand() -> labs.Lab:
    lab = progress.current(progress.load())
    if lab is None:
        raise process.Misuse("every lab is done: say which one you mean")
    return lab


def told(lab: labs.Lab, step: int, again: bool = False) -> str:
    """The next hint for a step, with those before it."""
    texts = hints.of(lab)
    if not texts:
        return f"Lab {lab.number} has no hints of its own. The handout: {process.shorten(lab.handout)}"
    levels = len(hints.LEVELS)
    if again:
        level = progress.load().get(lab.number, {}).get("hints", {}).get(str(step), 0)
        if level == 0:
            return f"You had no hint for lab {lab.number}, step {step} yet."
    else:
        level = progress.next_hint(lab, step, levels)
    lines = [f"Lab {lab.number}, step {step}: {lab.steps[step - 1]}", ""]
    for i in range(level):
        lines.append(f"{i + 1}. {hints.LEVELS[i]}")
        for paragraph in texts[step - 1][i].split("\n"):
            # Code keeps its lines; prose is folded.
            lines += [f"   {paragraph}"] if paragraph.startswith("    ") or not paragraph else textwrap.wrap(paragraph, 96, initial_indent="   ", subsequent_indent="   ")
        lines.append("")
    lines.append(f"That was all. The handout: {process.shorten(lab.handout)}" if level == levels else f"./lab hint {lab.number}  once more says more.")
    return "\n".join(lines)
