# SPDX-License-Identifier: MIT
"""The verdict on a lab, step by step."""

import json
import sys
import textwrap

import labs
import macros
import process
import progress
import student
import verdict

SUMMARY = "build and test your answer to a lab, step by step"
USAGE = "check NN [--solution] [--seconds S] [--json]"
EXAMPLES = """./lab check 03
./lab check 03 --seconds 60    on a slow or busy machine"""


def run(arguments: list[str]) -> int:
    parser = process.arguments(USAGE, SUMMARY, EXAMPLES)
    student.takes_a_lab(parser)
    parser.add_argument("--solution", action="store_true", help="test our header instead of yours, where your copy has it")
    parser.add_argument("--seconds", type=process.seconds, help=f"the limit for each step (default: {verdict.SECONDS_PER_STEP:g}, "
                        "or what LANTERN_STEP_SECONDS says)")
    parser.add_argument("--json", action="store_true", help='{"lab", "steps": [{"name", "passed"}]}')
    wish = parser.parse_args(arguments)

    lab = wish.lab
    try:
        program = student.built(lab, "_check", wish.solution)
    except student.NotYet as problem:
        if wish.json:
            print(json.dumps({"lab": lab.number, "steps": [{"name": step, "passed": False} for step in lab.steps], "error": str(problem)}))
        print(problem, file=sys.stderr)
        return 1

    complaint = student.by_itself(lab, student.tree_of(program)) if not wish.solution else str
    steps = verdict.judge(program, lab, wish.seconds)
    alone = complaint()
    if not wish.solution:
        progress.remember(lab, [step.passed for step in steps])
    passed = all(step.passed for step in steps)
    if wish.json:
        print(json.dumps({"lab": lab.number, "steps": [as_json(step) for step in steps]}))
    else:
        tell(lab, steps, wish.solution)
        if alone:
            print(f"\n{alone}")
        left = macros.left_behind(lab.student_file.read_text(encoding="utf-8", errors="replace")) if not wish.solution else []
        if left:
            print(f"\nYour header leaves macros behind ({', '.join(left[:5])}), which change every file that includes it. Courses that grade refuse it:\n"
                  "take constexpr values and functions instead, or #undef them at the end. An include guard may stay.")
    return 0 if passed else 1


def as_json(step: verdict.Step) -> dict:
    answer = {"name": step.name, "passed": step.passed, "tests": [{"name": test.name, "passed": test.passed} for test in step.tests]}
    if step.trouble:
        answer["trouble"] = step.trouble
    return answer


def tell(lab: labs.Lab, steps: list[verdict.Step], solution: bool) -> None:
    color = Colors(sys.stdout.isatty())
    print(color.bold(f"Lab {lab.number}: {lab.title}") + (" (the solution)" if solution else ""))
    for i, step in enumerate(steps, 1):
        if step.passed:
            print(color.green(f"  ✓ step {i}  {step.name}"))
        elif step.gap:
            own = step.gap.startswith(f"{lab.name} step {i}:")
            print(f"  · step {i}  {step.name}: " + ("still to do" if own else f"waits for {step.gap.removeprefix(lab.name + ' ')}"))
        else:
            print(color.red(f"  ✗ step {i}  {step.name}") + ": " + summary(step))
            for line in details(step):
                print("      " + line)
        if step.printed and step.printed not in (other.printed for other in steps[:i - 1]):
            print("      Your code printed:")
            print(textwrap.indent("\n".join(step.printed.splitlines()[:8]), "        | "))

    left = [i for i, step in enumerate(steps, 1) if not step.passed]
    print()
    if not left:
        print(color.green("All steps pass.") + f" The picture: ./lab run {lab.number}" + (" --solution" if solution else ""))
    else:
        print(f"Next: step {left[0]}, {steps[left[0] - 1].name}. "
              f"The handout is {process.shorten(lab.handout)}, your file {process.shorten(lab.student_file)}")


def summary(step: verdict.Step) -> str:
    if step.trouble:
        return step.trouble
    return f"{len(step.failures)} of {len(step.tests)} tests fail"


def details(step: verdict.Step) -> list[str]:
    """What the first failing test says, and the names of the others."""
    failures = [test for test in step.failures if not test.gap] or step.failures
    if not failures:
        return []
    test, *others = failures
    lines = [f"“{test.name}”" + (f" does not hold ({test.where})" if test.where else " was being tried" if not test.finished else "")]
    lines += ["  " + line for line in verdict.explained(test)]
    lines += [f"“{other.name}” fails too" for other in others[:6]]
    if len(others) > 6:
        lines.append(f"... and {len(others) - 6} more")
    return lines


class Colors:
    def __init__(self, wanted: bool):
        self.wanted = wanted

    def paint(self, code: str, text: str) -> str:
        return f"\033[{code}m{text}\033[0m" if self.wanted else text

    def bold(self, text: str) -> str:
        return self.paint("1", text)

    def green(self, text: str) -> str:
        return self.paint("32", text)

    def red(self, text: str) -> str:
        return self.paint("31", text)
