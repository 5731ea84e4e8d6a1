# SPDX-License-Identifier: MIT
"""Which mutants do the hidden tests catch by themselves? hidden_mutants.py [NN...] [--at-least PERCENT] [--seeds COUNT]

Those that they miss are caught by the public tests; a student who knows these by heart, and makes that mistake, would not be found out.
A mutant is caught when a test fails with every seed tried: a student's submission is graded with one."""

import argparse
import os
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import labs  # noqa: E402
import student  # noqa: E402
import verdict  # noqa: E402


def caught(program: pathlib.Path, mutant: labs.Mutant, seed: int) -> bool:
    """The program is ours, and so is the mutant: it needs no sandbox."""
    environment = {**os.environ, "LANTERN_MUTANT": mutant.name, "LANTERN_SEED": str(seed)}
    status, tests, _ = verdict.run_tests(program, "*", 20, environment)
    if status != 0 and not tests:
        raise labs.Problem(f"{program.name} runs no test (exit status {status})")
    return status != 0


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("labs", nargs="*", metavar="NN", type=student.lab_named)
    parser.add_argument("--at-least", type=int, default=0, metavar="PERCENT", help="fail where a lab's hidden tests catch less")
    parser.add_argument("--seeds", type=int, default=1, metavar="COUNT")
    wish = parser.parse_args()
    chosen = [lab for lab in wish.labs or labs.all_labs() if (lab.tests / "hidden.cpp").exists()]
    tree = student.set_up()
    built, output = student.build(tree, *(f"{lab.name}_hidden_mutants" for lab in chosen))
    if not built:
        sys.exit(student.first_error(output))
    few = []
    for lab in chosen:
        mutants = lab.mutants()
        program = student.program(tree, f"{lab.name}_hidden_mutants")
        missed = [mutant.name for mutant in mutants if not all(caught(program, mutant, seed) for seed in range(7, 7 + wish.seeds))]
        count = len(mutants) - len(missed)
        print(f"lab {lab.number}: hidden tests catch {count} of {len(mutants)} mutants ({100 * count // len(mutants)} %); not: {', '.join(missed) or 'none'}", flush=True)
        if 100 * count < wish.at_least * len(mutants):
            few.append(lab.number)
    if few:
        print(f"less than {wish.at_least} %: lab {', '.join(few)}", file=sys.stderr)
    return 1 if few else 0


if __name__ == "__main__":
    sys.exit(main())
