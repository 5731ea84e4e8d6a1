# SPDX-License-Identifier: MIT
"""The tests' tests, for CTest: lab_test.py solution|starter|mutants|current LAB [PROGRAM]."""

import os
import pathlib
import sys

import labs
import verdict


def solution(lab: labs.Lab, program: pathlib.Path) -> list[str]:
    """The solution passes every step."""
    return [f"step {i}: {step.trouble or [t.name for t in step.failures]}\n{step.failures}"
            for i, step in enumerate(verdict.judge(program, lab), 1) if not step.passed]


def starter(lab: labs.Lab, program: pathlib.Path) -> list[str]:
    """The starter fails every test of every step, and the failure names that step."""
    wrong = []
    for i, step in enumerate(verdict.judge(program, lab), 1):
        if step.trouble:
            wrong.append(f"step {i} {step.trouble}")
        for test in step.tests:
            if not test.gap.startswith(f"{lab.name} step {i}: "):
                wrong.append(f'step {i}, "{test.name}" says: {test.gap or test.thrown or test.asked or "passed"}')
    return wrong


def mutants(lab: labs.Lab, program: pathlib.Path) -> list[str]:
    """Each mutant fails the tests that it names and none of an earlier step."""
    return [f"{made.name}: {line}" for made in lab.mutants() for line in mutant_verdict(lab, program, made)[1]]


def mutant_verdict(lab: labs.Lab, program: pathlib.Path, made: labs.Mutant) -> tuple[list[str], list[str]]:
    """The names of the tests that failed, and what is wrong with that. The program holds all mutants of the lab."""
    steps = verdict.judge(program, lab, environment={**os.environ, "LANTERN_MUTANT": made.name})
    at = {test.name: i for i, step in enumerate(steps, 1) for test in step.tests}
    failed = [test.name for step in steps for test in step.failures]
    wrong = [f'there is no test "{name}"' for name in made.caught_by if name not in at]
    wrong += [f'"{name}" should have caught it' for name in made.caught_by if name in at and name not in failed]
    first = min((at[name] for name in made.caught_by if name in at), default=0)
    wrong += [f'"{name}" belongs to an earlier step and failed too' for name in failed if at[name] < first]
    wrong += [f"step {i} {step.trouble}" for i, step in enumerate(steps, 1) if step.trouble and not step.tests]
    return failed, wrong


def current(lab: labs.Lab) -> list[str]:
    """labs/ holds what the solution's regions generate. In a student's copy it does not, and need not."""
    made = lab.starter()
    if lab.student_file.exists() and lab.student_file.read_text(encoding="utf-8") == made:
        return []
    if labs.differs_from_commit(lab.student_file):
        print(f"{lab.student_file} has been worked on: skipped")
        sys.exit(77)
    return [f"{lab.student_file} is not what the solution generates: ./lab starters writes it again"]


def main() -> int:
    action, folder, *rest = sys.argv[1:]
    check = {"solution": solution, "starter": starter, "mutants": mutants, "current": current}[action]
    lab = labs.find(folder)
    try:
        wrong = check(lab, *(pathlib.Path(word).resolve() for word in rest))
    except labs.Problem as problem:
        wrong = [str(problem)]
    print("\n".join(wrong) or f"{lab.name} {action}: as it should be")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
